/* Two vectors of space side by side: the three coordinates of a pair of points. */
#ifndef SURFPATH_VECTOR_H
#define SURFPATH_VECTOR_H

#include "pair.h"

struct sp_vector {
    sp_pair x, y, z;
};

static inline __attribute__((always_inline)) struct sp_vector sp_load(const sp_pair *at) { return (struct sp_vector){at[0], at[1], at[2]}; }

static inline __attribute__((always_inline)) void sp_store(struct sp_vector v, sp_pair *at) { at[0] = v.x, at[1] = v.y, at[2] = v.z; }

static inline __attribute__((always_inline)) struct sp_vector sp_add(struct sp_vector a, struct sp_vector b) {
    return (struct sp_vector){a.x + b.x, a.y + b.y, a.z + b.z};
}

static inline __attribute__((always_inline)) struct sp_vector sp_subtract(struct sp_vector a, struct sp_vector b) {
    return (struct sp_vector){a.x - b.x, a.y - b.y, a.z - b.z};
}

static inline __attribute__((always_inline)) struct sp_vector sp_scale(struct sp_vector a, sp_pair by) {
    return (struct sp_vector){a.x * by, a.y * by, a.z * by};
}

static inline __attribute__((always_inline)) sp_pair sp_dot(struct sp_vector a, struct sp_vector b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline __attribute__((always_inline)) struct sp_vector sp_cross(struct sp_vector a, struct sp_vector b) {
    return (struct sp_vector){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static inline __attribute__((always_inline)) struct sp_vector sp_swap_vector(struct sp_vector a) {
    return (struct sp_vector){sp_swap(a.x), sp_swap(a.y), sp_swap(a.z)};
}

#endif
