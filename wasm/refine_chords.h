/* Paths of chords: the ladder's first one, and polylines. MATH.md, "The ladder". */
#ifndef SURFPATH_REFINE_CHORDS_H
#define SURFPATH_REFINE_CHORDS_H

#include "refine_rung.h"

/* The ladder's first path from the start in newton->system.line, as it was checked, and what its length is wrong by. Where a surface has
 * many waves, or a metric turns quickly, 32 chords are wrong by more than the guard allows (7 % on a field of 25:1 that turns by three
 * radians): then twice as many, until they are not. */
struct sp_climbed sp_chords_first(struct sp_newton *newton, const struct sp_options *options, const struct sp_storage *storage,
                                  double *error);

/* The start in newton->system.line as it is, as if it were a path at rest. */
struct sp_climbed sp_chords_given(struct sp_newton *newton);

/* The path of `count` chords, from another one, which is not in newton's own arrays. */
void sp_chords_climb(struct sp_newton *newton, const struct sp_options *options, int32_t count, const struct sp_system *from,
                     struct sp_arena *arena, struct sp_climbed *chords);

/* A path of `count` chords, even, from another path, which is not in newton's own arrays. */
struct sp_refined sp_refine_chords(struct sp_newton *newton, const struct sp_options *options, int32_t count, const struct sp_system *from,
                                   struct sp_arena *arena);

/* Chords of the polyline from which sp_refine_polyline starts for one of `count`; `count` itself where that is too few to gain by it. */
int32_t sp_refine_coarsest(int32_t count);

/* Brings a polyline of sp_refine_coarsest(count) chords, its charts computed, to `count`, four times as many at a time, each polyline
 * relaxed by a few steps and the start of the next; the last is only started. Returns 0 where that leads nowhere. */
int sp_refine_polyline(struct sp_newton *newton, const struct sp_options *options, int32_t count, struct sp_arena *arena);

/* Bytes of arena that sp_refine_polyline takes. */
double sp_refine_polyline_bytes(int32_t dimension, int32_t count);

#endif
