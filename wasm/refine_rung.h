/* One rung of the ladder: a discretisation, started from the path of another. Knows no ladder. MATH.md, "The ladder". */
#ifndef SURFPATH_REFINE_RUNG_H
#define SURFPATH_REFINE_RUNG_H

#include "refine.h"

struct sp_rung {
    int32_t degree, count;
    const double *spread; /* of its elements */
};

/* A draft is one step from this decrement. */
static const double SP_DRAFT_DECREMENT = 1e-2;

/* A rung from one start: its outcome, its length, and the largest distance that a node has moved. */
struct sp_climbed {
    struct sp_outcome outcome;
    double length, moved;
    const sp_pair *start; /* where the nodes stood before: 3 numbers a pair */
};

/* Nodes of `count` elements on the path of `from`, with their charts. SP_SHEET_JUMP where they do not settle on the surface. */
enum sp_status sp_rung_carry(struct sp_newton *newton, const struct sp_system *from, int32_t count);

/* Sets newton->system up as `rung`, whose reference element is made, from the path of `from`, and runs Newton there. */
void sp_rung_climb(struct sp_newton *newton, const struct sp_options *options, const struct sp_system *from, const struct sp_rung *rung,
                   struct sp_arena *arena, struct sp_climbed *climbed);

/* Runs Newton from the path as it stands and measures where it leads. One that wanders is SP_TOLERANCE_NOT_MET. */
void sp_rung_run(struct sp_newton *newton, const struct sp_options *options, struct sp_climbed *climbed);

/* The answer: the error at least that of rounding, and with what is in doubt. */
struct sp_refined sp_rung_finish(const struct sp_newton *newton, const struct sp_climbed *climbed, double length_error);

#endif
