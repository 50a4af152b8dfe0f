/* What the solver knows of a surface near a node, whatever its kind: a second-order chart, and how to move along it.
 *
 * The chart of a node is S(a) = X + B_1 a_1 + B_2 a_2 + (S_11 a_1^2 + 2 S_12 a_1 a_2 + S_22 a_2^2)/2 + …: parametric, a = (du, dv);
 * implicit, a = coordinates in an orthonormal tangent frame, S_ab along the normal. `place` is what is stored of a node: u v or x y z.
 * Adding a kind of surface means one more struct sp_kind. */
#ifndef SURFPATH_CHART_H
#define SURFPATH_CHART_H

#include "surface.h"
#include "vector.h"

/* Layout of a chart, in sp_pair: X, B_1, B_2, S_11, S_12, S_22, three each. */
enum { SP_CHART_X = 0, SP_CHART_1 = 3, SP_CHART_2 = 6, SP_CHART_11 = 9, SP_CHART_12 = 12, SP_CHART_22 = 15, SP_CHART = 18 };

struct sp_kind {
    int32_t dimension;  /* numbers of a place */
    int32_t components; /* numbers of a metric tensor (metric.h); 0: length is measured as space does, and there are no metrics */

    /* Writes the charts, and the metrics if there are any, of `pair_count` pairs of places. */
    void (*charts)(const struct sp_surface *surface, int32_t pair_count, const sp_pair *places, sp_pair *charts, sp_pair *metrics);

    /* Moves every place by scale * step (two numbers a pair, in its chart) along the surface, to second order unless its lane of `straight`
     * (one mask a pair; NULL: all are) is set. Returns 0 where that leaves the region in which the chart means anything: `moved` is
     * then not to be used; 2 where some lane of it lies on a wall of the rectangle, else 1. */
    int (*move)(const struct sp_surface *surface, int32_t pair_count, const sp_pair *places, const sp_pair *charts, const sp_pair *steps,
                const sp_mask *straight, double scale, sp_pair *moved);
};

extern const struct sp_kind sp_parametric_kind, sp_parametric_density_kind, sp_parametric_tensor_kind;
extern const struct sp_kind sp_polar_kind, sp_polar_density_kind, sp_polar_tensor_kind;
extern const struct sp_kind sp_implicit_kind, sp_implicit_density_kind, sp_implicit_tensor_kind;

const struct sp_kind *sp_kind_of(const struct sp_surface *surface);

/* B_1 x B_2, normal to the surface. */
static inline struct sp_vector sp_chart_normal(const sp_pair *chart) {
    return sp_cross(sp_load(chart + SP_CHART_1), sp_load(chart + SP_CHART_2));
}

/* Implicit: moves points onto f = 0 by Eq. 37, X <- X - f grad f / |grad f|^2, until the step is lost in rounding, at most 12 times.
 * Returns 0 if some point did not settle. `scale`: a length beside which coordinates are rounded. */
int sp_implicit_settle(const struct sp_surface *surface, int32_t pair_count, sp_pair *places, double scale);

/* The same for an end, also beside an edge that is sharper than a right angle. There steps go to and fro between the faces, shorter by the
 * cosine between these each time; here one after which the gradient has turned by more than a right angle is followed by one within its
 * plane. */
int sp_implicit_settle_end(const struct sp_surface *surface, sp_pair place[3], double scale);

/* Implicit: the middle of a chord put onto f = 0, and the gradient of f there. Returns 0 if it does not settle. */
int sp_implicit_halve(const struct sp_surface *surface, const double from[3], const double to[3], double scale, double at[3],
                      double normal[3]);

/* Implicit: a place on f = 0 beside that part of a chord between two places on it, looked for outwards, along the mean of their unit
 * normals: where f is the same all around the chord nothing else leads there, as inside a rounded edge of `hypot(max(abs(x) - 1, 0), …) -
 * r`. Returns 0 if there is none near by. */
int sp_implicit_between(const struct sp_surface *surface, const double *const ends[2], const double *const normals[2], double part,
                        double scale, double at[3]);

/* Implicit: whether the gradient of f at a place is nothing beside that not farther away than `near`, or no number: sheets meet there, in a
 * node, or one ends in an apex. That of an end is looked at no nearer to it than this part of the size of things. `seen`: f and its
 * gradient, there and beside. */
#define SP_NODE_FAR 5e-3
int sp_implicit_is_node(const struct sp_surface *surface, const double place[3], double near, sp_pair seen[SP_IMPLICIT_VALUES]);

/* `move` of the parametric kinds whose charts lie in space: q + d - Gamma(d, d)/2, in the rectangle. */
int sp_parametric_move(const struct sp_surface *surface, int32_t pair_count, const sp_pair *places, const sp_pair *charts,
                       const sp_pair *steps, const sp_mask *straight, double scale, sp_pair *moved);

/* The same without the last term, whatever `straight` says. */
int sp_straight_move(const struct sp_surface *surface, int32_t pair_count, const sp_pair *places, const sp_pair *charts,
                     const sp_pair *steps, const sp_mask *straight, double scale, sp_pair *moved);

/* Positions of places of a surface that has any: its `value`, over whatever its places are. */
void sp_positions(const struct sp_surface *surface, int32_t pair_count, const sp_pair *places, sp_pair *positions);

/* Parametric: places moved into the closed rectangle. Returns whether some now lie on its walls. */
int sp_parametric_clip(const struct sp_surface *surface, int32_t pair_count, sp_pair *places);

#endif
