/* How a computation ended: one list for the whole core, the same words as `path.status` in JavaScript. */
#ifndef SURFPATH_STATUS_H
#define SURFPATH_STATUS_H

/* 0: what was asked for. Positive: a path that may be used but promises less. Negative: no path. */
enum sp_status {
    SP_CONVERGED = 0,
    SP_ITERATION_LIMIT = 1,   /* max_iterations steps were not enough */
    SP_STALLED = 2,           /* no step lowers the energy any more, or a chord is too long to tell what the surface does under it */
    SP_TOLERANCE_NOT_MET = 3, /* the finest discretisation was reached */
    SP_ILL_CONDITIONED = 4,   /* stationary, but the ends are almost conjugate: the path is hardly determined, its length is */
    SP_SADDLE = 5,            /* stationary, but a neighbouring path is shorter */
    SP_EDGE_REACHED = 6,      /* tracing only: the edge of the domain came first */
    SP_DISCONNECTED = -1,     /* the ends lie on different pieces of the surface */
    SP_SINGULAR_METRIC = -2,  /* the first fundamental form vanishes on the path; implicit: the gradient of f, at an end, too */
    SP_SHEET_JUMP = -3,       /* implicit: a chord leads from one sheet of the surface to another */
    SP_OFF_SURFACE = -4,      /* implicit: an end could not be projected onto the surface nearby */
    SP_NOT_FINITE = -5,       /* the surface is NaN or infinite where the path must go */
    SP_OUT_OF_MEMORY = -6     /* the arena is too small: try again with a larger one */
};

#endif
