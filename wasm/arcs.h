/* A path as a list of arcs: free geodesics, and pieces along the edges of the parameter rectangle, joined where they touch. Restores the
 * order that a contact takes from a single Newton solve. MATH.md, "Arcs". */
#ifndef SURFPATH_ARCS_H
#define SURFPATH_ARCS_H

#include "refine.h"

/* An arc along an edge, or a free one; of these only every other is, and the first and the last, where a path touches edges. */
enum { SP_MAX_ARCS = 40, SP_MAX_FREE = SP_MAX_ARCS / 2 + 1 };

struct sp_arc {
    double length, error;
    double energy, gradient_norm; /* a free arc: as sp_outcome's, run through in a unit of time */
    struct sp_system system;      /* a free arc: its elements; places and reference in the arena */
    int32_t reversed;             /* 1: the free arc runs from its system's end to its start */
    int32_t on_edge;              /* 1: along an edge, on which coordinate `across` is `value` and the other runs from ends[0] to ends[1] */
    int32_t across;
    double value, ends[2];
};

struct sp_arcs {
    int32_t count;
    struct sp_arc arc[SP_MAX_ARCS];
};

/* The whole that solved arcs make, the lengths of the pieces of edges by quadrature: converged, of index 0, run through in a unit of time
 * at constant speed, which is what `energy` and `gradient_norm` are those of. `slopes`: sum of the squared derivatives of its length by
 * the joints' coordinates. It is the last entry of the history. */
struct sp_refined sp_arcs_join(struct sp_arcs *arcs, struct sp_newton *newton, double slopes, struct sp_arena *arena);

/* By how much, about, a path is shorter that leaves a piece of an edge where nothing presses it there: on the stretch, from and to, where
 * that is most; 0 where it is pressed all along. A curve that turns by an angle over a length is longer than its chord by angle^2 length
 * / 24. */
double sp_arcs_edge_gain(const struct sp_surface *surface, const struct sp_arc *arc, double stretch[2]);

/* Curvature of an edge at a place of it, in the surface and in the metric in use: positive where it presses a path onto it. `unit`: how
 * long a unit of the coordinate along it is there, and one of that across it. */
double sp_arcs_edge_curvature(const struct sp_surface *surface, const struct sp_arc *arc, double t, double unit[2]);

/* Length of a piece of an edge; NaN if the arena is full. */
double sp_arcs_edge_length(const struct sp_surface *surface, const struct sp_arc *arc, struct sp_arena *arena);

/* Writes K + 2 points (unless NULL) and places at equal steps of length along the arcs, `reversed` from their end on.
 * SP_OUT_OF_MEMORY if the arena is full, SP_NOT_FINITE if some number is not, else SP_CONVERGED. */
enum sp_status sp_arcs_sample(const struct sp_arcs *arcs, const struct sp_surface *surface, double scale, int32_t point_count,
                              int32_t reversed, double *points, double *parameters, struct sp_arena *arena);

/* Bytes of arena that all of these take besides sp_refine_bytes. */
double sp_arcs_bytes(void);

#endif
