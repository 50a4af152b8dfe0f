/* Triangle mesh of an implicit surface f = 0 inside a box: for drawing, and as the ground of a distance field.
 *
 * Marching tetrahedra on a body-centred cubic lattice: no ambiguous cases, so the mesh is always an oriented manifold, closed except where
 * the box cuts the surface (there it ends flat). Its topology is that of the surface when the cells are small against its features: a wall
 * thinner than a cell gets holes, whose triangles may face away from the exact normals of their corners. */
#ifndef SURFPATH_MESH_H
#define SURFPATH_MESH_H

#include "arena.h"
#include "status.h"
#include "surface.h"

enum { SP_MESH_MAX_RESOLUTION = 256 };

/* The arrays lie in the arena that made them. */
struct sp_mesh {
    double *positions;    /* 3 a vertex: x y z */
    double *normals;      /* 3 a vertex: grad f / |grad f|; where f is not differentiable, the direction in which f grows */
    int32_t *indices;     /* 3 a triangle, counter-clockwise seen from the side where f > 0 */
    int32_t vertex_count; /* every vertex that is not NaN is used by a triangle */
    int32_t triangle_count;
};

/* Bytes of arena that sp_mesh_implicit needs to make this many vertices and triangles; with counts of 0, for its scratch alone, which is
 * enough to learn the counts. `box` and `resolution` as there. */
double sp_mesh_bytes(const double box[6], int32_t resolution, int32_t vertex_count, int32_t triangle_count);

/* Meshes f = 0 inside a box.
 *
 * `value`: f, f_x, f_y, f_z at pairs of points (SP_IMPLICIT_VALUES). `box`: xmin xmax ymin ymax zmin zmax, each min < max. `resolution`:
 * cells along the longest side, clamped to 1 … SP_MESH_MAX_RESOLUTION; on the other sides as many as keep the cells cubes as nearly as the
 * box allows, but at least a twelfth. f = 0 and NaN at a lattice point count as outside (f > 0). Vertices
 * satisfy f = 0 to rounding. Where f is negative on one side and NaN on the other, or changes its sign by a jump or over a pole, the
 * surface ends: the mesh is open there, with vertices on the rim to 1e-4 of a cell where f ends straight across the surface. What is on no
 * rim has vertices and normals that are NaN.
 *
 * Takes exactly the arrays of `mesh` from the arena; its scratch, O(resolution^2), is given back. Returns SP_CONVERGED (no surface in the
 * box: both counts 0), SP_NOT_FINITE (the box is empty, or not finite) or SP_OUT_OF_MEMORY: the arrays are then NULL, and the counts those
 * that the mesh would have, or 0 where not even the scratch fits; a second call with sp_mesh_bytes of them succeeds. Cost: one evaluation
 * of f at each of about 2 resolution^3 points of the cube, about twelve a vertex, and two hundred one of a rim. */
int32_t sp_mesh_implicit(sp_evaluate value, const double box[6], int32_t resolution, struct sp_arena *arena, struct sp_mesh *mesh);

#endif
