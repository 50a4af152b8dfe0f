/* A path as a list of arcs: free geodesics, and pieces along the edges of the parameter rectangle, joined where they touch. Restores the
 * order that a contact takes from a single Newton solve. MATH.md, "Arcs". */
#ifndef SURFPATH_ARCS_H
#define SURFPATH_ARCS_H

#include "refine.h"

enum { SP_MAX_ARCS = 16 };

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

/* Solves a path that touches the walls. `given`: the projected Newton's, not in newton's own arrays; `arcs` is filled. Where the arcs do
 * not fit together (a corner, a free arc that leaves the rectangle), arcs->count is 0 and newton->system the best that chords can do,
 * SP_TOLERANCE_NOT_MET if that is not enough. */
struct sp_refined sp_contact_run(struct sp_newton *newton, const struct sp_options *options, const struct sp_system *given,
                                 struct sp_arena *arena, struct sp_arcs *arcs);

/* Solves a path through the point to which an edge of the rectangle collapses (a pole, an apex): two free arcs. newton->system.line holds
 * any polyline from end to end. `edge`: 2 * coordinate + side; `beyond`: how far beyond it the point lies, in the coordinate across;
 * `period`: once around, 0 between walls. */
struct sp_refined sp_pole_run(struct sp_newton *newton, const struct sp_options *options, int32_t edge, double beyond, double period,
                              struct sp_arena *arena, struct sp_arcs *arcs);

/* Solves a path close by an edge that is a point, or almost one, a hole, whose middle lies `beyond` it: around the hole where that is in
 * the way; else past it, and arcs->count is 0 and newton->system the path. The end nodes of newton->system.line tell from where to where,
 * and on which side. SP_SINGULAR_METRIC where that fails. */
struct sp_refined sp_hole_run(struct sp_newton *newton, const struct sp_options *options, int32_t edge, double beyond,
                              struct sp_arena *arena, struct sp_arcs *arcs);

/* The angle on the surface at a pole between the lines along which the coordinate around it is `from` and `to`: the directions in between,
 * turned through. `across`, `value`: the coordinate that is constant on its edge. */
double sp_pole_angle(const struct sp_surface *surface, int32_t across, double value, double from, double to);

/* How often the normal turns over along a path on a parametric surface, from one node to the next, the nodes before `first` at either end
 * left out: where it ends on a singular curve it has no normal. Its charts are computed. */
int32_t sp_cusp_turns(const struct sp_polyline *line, int32_t first);

/* Whether a path leads from one side of such a curve to the other (sp_cusp_run), so that no smooth path can be near it. newton->system.line
 * holds the path; its charts are computed. */
int sp_cusp_divides(const struct sp_newton *newton);

/* Whether it is such curves where its normal turns over, and no more of them than sp_cusp_run may cross: a steep surface turns, too. */
int sp_cusp_crosses(const struct sp_system *given);

/* Solves a path across a curve where S_u x S_v vanishes and turns over, or several: arcs that meet in points of them. `given`: a path from
 * end to end that crosses as often, at most six times, not in newton's own arrays; of one crossing several seeds are tried.
 * SP_SINGULAR_METRIC where that fails. */
struct sp_refined sp_cusp_run(struct sp_newton *newton, const struct sp_options *options, const struct sp_system *given,
                              struct sp_arena *arena, struct sp_arcs *arcs);

/* The whole that solved arcs make, the lengths of the pieces of edges by quadrature: converged, of index 0, run through in a unit of time
 * at constant speed, which is what `energy` and `gradient_norm` are those of. `slopes`: sum of the squared derivatives of its length by
 * the joints' coordinates. It is the last entry of the history. */
struct sp_refined sp_arcs_join(struct sp_arcs *arcs, struct sp_newton *newton, double slopes, struct sp_arena *arena);

/* Length of a piece of an edge; NaN if the arena is full. */
double sp_arcs_edge_length(const struct sp_surface *surface, const struct sp_arc *arc, struct sp_arena *arena);

/* Writes K + 2 points (unless NULL) and places at equal steps of length along the arcs, `reversed` from their end on.
 * SP_OUT_OF_MEMORY if the arena is full, SP_NOT_FINITE if some number is not, else SP_CONVERGED. */
enum sp_status sp_arcs_sample(const struct sp_arcs *arcs, const struct sp_surface *surface, double scale, int32_t point_count,
                              int32_t reversed, double *points, double *parameters, struct sp_arena *arena);

/* Bytes of arena that all of these take besides sp_refine_bytes. */
double sp_arcs_bytes(void);

#endif
