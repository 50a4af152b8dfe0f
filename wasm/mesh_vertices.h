/* The second half of meshing: from lattice edges that cross a surface to points on it. */
#ifndef SURFPATH_MESH_VERTICES_H
#define SURFPATH_MESH_VERTICES_H

#include "mesh.h"

/* Moves the vertices of a mesh onto f = 0 and makes their normals.
 *
 * In: positions holds a point with f < 0 for each vertex, normals the vector from there to a point where f < 0 does not hold. Out: as
 * struct sp_mesh says; where f changes sign without being 0, at a wall, the last point with f < 0, and a normal that is NaN. No vertex ends
 * further than half that vector from where f changes sign on it, so neighbours do not change places. About twelve evaluations a vertex. */
void sp_place_vertices(sp_evaluate value, const double box[6], struct sp_mesh *mesh);

#endif
