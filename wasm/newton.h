/* Newton's method on the energy of a polyline: the solver's heart. Knows charts and rows, not kinds of surfaces. MATH.md, "Newton". */
#ifndef SURFPATH_NEWTON_H
#define SURFPATH_NEWTON_H

#include "energy.h"
#include "surfpath.h"

/* Everything Newton works on, in the caller's arena. */
struct sp_newton {
    struct sp_polyline line;    /* the path so far; its places filled by the start */
    struct sp_nodes trial;      /* the path after a step, of the same size */
    struct sp_row *rows;        /* one a pair */
    sp_pair *step;              /* two numbers a pair */
    sp_mask *straight;          /* one a pair: nodes that move along straight lines of the parameters */
    struct sp_iterate *history; /* max_iterations + 1 entries */
    double *record;             /* history_count polylines of 3 (n + 2) numbers, or NULL */
    double scale;               /* size of the coordinates, for rounding */
};

/* How it ended. */
struct sp_outcome {
    int32_t status, iterations, index, active, history_count;
    double squares, gradient_norm;
};

/* Lays out the arrays for n inner nodes. Returns 0 if the arena is full. */
int sp_newton_take(struct sp_newton *newton, const struct sp_surface *surface, const struct sp_options *options, struct sp_arena *arena);

/* Bytes that sp_newton_take takes. */
double sp_newton_bytes(int32_t kind, const struct sp_options *options);

/* Runs until converged or beaten; the path is left in newton->line and never has more energy than the start. */
struct sp_outcome sp_newton_run(struct sp_newton *newton, const struct sp_options *options);

#endif
