/* Points along a path: between its nodes the elements' polynomials, put back onto the surface; and a path carried from one discretisation
 * to another. */
#ifndef SURFPATH_SAMPLE_H
#define SURFPATH_SAMPLE_H

#include "system.h"

/* Writes K + 2 points (3 numbers; unless NULL) and places (2 numbers, parametric only; unless NULL) at equal steps of the path's parameter,
 * which at rest is its length; of a polyline with K inner nodes the nodes themselves. */
void sp_sample_points(const struct sp_system *system, double scale, int32_t point_count, double *points, double *parameters);

/* Fills `places` of a path of `count` elements of the degree of `reference` (1: chords) with the path of `from`. Implicit places still have
 * to be settled. */
void sp_sample_places(const struct sp_system *from, const struct sp_reference *reference, int32_t count, sp_pair *places);

#endif
