/* Points along a path: between its nodes the elements' polynomials, put back onto the surface; and a path carried from one discretisation
 * to another. */
#ifndef SURFPATH_SAMPLE_H
#define SURFPATH_SAMPLE_H

#include "system.h"

/* Writes K + 2 points (3 numbers; unless NULL) and places (2 numbers, parametric only; unless NULL) at equal steps of the path's parameter,
 * which at rest is its length; of a polyline with K inner nodes the nodes themselves. `reversed`: from the path's end on. Returns 0 if
 * some number is not finite. */
int sp_sample_points(const struct sp_system *system, double scale, int32_t point_count, int32_t reversed, double *points,
                     double *parameters);

/* The place (3 numbers; parametric 2 and a zero) at t in [0, 1] of a path, interpolated, not yet put onto the surface. */
void sp_sample_place(const struct sp_system *system, double t, double place[3]);

/* The path's parameter, 0 … 1, at node i of some elements. */
double sp_sample_parameter(const struct sp_elements *elements, int32_t i);

/* Writes one sample at a place: the point of the surface, and unless NULL its parameters. Returns 0 if some number is not finite. */
int sp_sample_point(const struct sp_surface *surface, double scale, const double place[3], double *point, double *parameters);

/* |X(2t) - 2 X(t) + X(0)| of the points of the surface at t = 0, `step` and twice that of a path, the larger of both its ends: how far the
 * surface bends aside beside them, beyond what a few roundings of u and v move points by. For surfaces with positions. */
double sp_sample_bend(const struct sp_system *system, double scale, double step);

/* Memory for a path that outlives the arrays it was solved in. */
struct sp_storage {
    sp_pair *places;
    double *node, *barycentric, *spread;
};

/* Room for any path of the ladder. Returns 0 if the arena is full. */
int sp_storage_take(struct sp_storage *storage, int32_t dimension, int32_t inner, struct sp_arena *arena);

/* Copies a path, as far as sampling needs it, into `storage`. */
struct sp_system sp_storage_keep(const struct sp_storage *storage, const struct sp_system *system);

/* Fills `places` of the nodes of `to` (degree 1: chords) with the path of `from`. Implicit places still have to be settled. */
void sp_sample_places(const struct sp_system *from, const struct sp_elements *to, sp_pair *places);

#endif
