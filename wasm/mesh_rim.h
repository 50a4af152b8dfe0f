/* The last part of meshing: where f ends or jumps, so does the surface, between points of the lattice. */
#ifndef SURFPATH_MESH_RIM_H
#define SURFPATH_MESH_RIM_H

#include "mesh.h"

/* Draws the vertices of walls that hang together with the surface onto its rim, and leaves out all triangles that have no other ones.
 *
 * In: a vertex of a wall, which is not on f = 0, has a normal that is NaN, and lies where f < 0, beside where that ends. Out: it is on
 * f = 0, where one goes from a vertex of the surface as far towards it as there is surface, with its normal; or both are NaN, where there
 * is none, or a jump so small that the triangles would bridge it. `near`: scratch, a number a vertex. About two hundred evaluations a
 * vertex of a rim. */
void sp_draw_rims(sp_evaluate value, const double box[6], struct sp_mesh *mesh, int32_t *near);

#endif
