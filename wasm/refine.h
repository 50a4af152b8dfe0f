/* A tolerance that is kept: a ladder of discretisations, each started from the one before, until two agree. MATH.md, "The ladder". */
#ifndef SURFPATH_REFINE_H
#define SURFPATH_REFINE_H

#include "newton.h"
#include "sample.h"

/* The rung with the largest matrices; the last one; inner nodes of the first path of chords, and the most chords that one may be begun
 * again with; the most inner nodes of either. */
enum {
    SP_REFINE_DEGREE = 24,
    SP_REFINE_COUNT = 128,
    SP_REFINE_LAST_DEGREE = 16,
    SP_REFINE_LAST_COUNT = 254,
    SP_REFINE_FIRST = 31,
    SP_REFINE_CHORDS = 4096,
    SP_REFINE_INNER = SP_REFINE_CHORDS - 1
};

/* What the ladder found: as sp_newton_run, and the length with its error. */
struct sp_refined {
    struct sp_outcome outcome;
    double length, length_error;
};

/* Solves to `options->tolerance`, unless the path touches the walls: then outcome.active is set, and the path is one of chords (see
 * arcs.h). newton->system.line holds a start of SP_REFINE_FIRST inner nodes or more and
 * its charts; in the end, the path of the last rung. is_fine: the start is nearly right, or has so many nodes that chords between fewer
 * would lose what it knows: elements begin with it. */
struct sp_refined sp_refine_run(struct sp_newton *newton, const struct sp_options *options, int32_t is_fine, struct sp_arena *arena);

/* Solves to the tolerance from a path of elements that is nearly right, of about that length (0: not known), and not in newton's own
 * arrays; newton->system.elements.singular says which of its ends lie on a singular curve. */
struct sp_refined sp_refine_again(struct sp_newton *newton, const struct sp_options *options, const struct sp_system *from, double length,
                                  struct sp_arena *arena);

/* Solves on the elements of a path that is nearly right, its ends moved, say: as accurate as they are, not checked against finer ones. */
struct sp_refined sp_refine_same(struct sp_newton *newton, const struct sp_options *options, const struct sp_system *from,
                                 struct sp_arena *arena);

/* Bytes of arena that sp_refine_run takes. */
double sp_refine_bytes(void);

/* Room for any path that the ladder leads to: SP_REFINE_INNER nodes. Returns 0 if there is none. */
int sp_refine_take(struct sp_storage *storage, const struct sp_newton *newton, struct sp_arena *arena);

#endif
