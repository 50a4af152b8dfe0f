/* A block of points at which meshing evaluates f together. */
#ifndef SURFPATH_MESH_POINTS_H
#define SURFPATH_MESH_POINTS_H

#include "mesh.h"

enum { SP_MESH_POINTS = 64 };

struct sp_mesh_points {
    int32_t count;
    double at[SP_MESH_POINTS][3];
    sp_pair in[SP_MESH_POINTS / 2 * SP_IMPLICIT_INPUTS], out[SP_MESH_POINTS / 2 * SP_IMPLICIT_VALUES];
};

/* f at point i, as evaluated last. */
static inline double sp_mesh_value(const struct sp_mesh_points *points, int32_t i) {
    return points->out[i / 2 * SP_IMPLICIT_VALUES][i & 1];
}

/* The gradient of f at point i, as evaluated last. */
void sp_mesh_gradient(const struct sp_mesh_points *points, int32_t i, double gradient[3]);

/* Evaluates f and its gradient; the lane without a point repeats the last. */
void sp_mesh_evaluate(sp_evaluate value, struct sp_mesh_points *points);

#endif
