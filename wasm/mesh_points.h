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

/* f, or a component of its gradient, 1 … 3, at point i, as evaluated last. */
static inline double sp_mesh_value(const struct sp_mesh_points *points, int32_t i, int number) {
    return points->out[i / 2 * SP_IMPLICIT_VALUES + number][i & 1];
}

/* Evaluates f and its gradient; the lane without a point repeats the last. */
static inline void sp_mesh_evaluate(sp_evaluate value, struct sp_mesh_points *points) {
    for (int32_t i = 0; i < points->count + (points->count & 1); i++)
        for (int axis = 0; axis < 3; axis++)
            points->in[i / 2 * SP_IMPLICIT_INPUTS + axis][i & 1] = points->at[i < points->count ? i : i - 1][axis];
    value((points->count + 1) / 2, points->in, points->out);
}

#endif
