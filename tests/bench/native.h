/* The surfaces that the native side of the benchmarks knows: a table, written by native.js beside the surfaces themselves. */
#ifndef SURFPATH_BENCH_NATIVE_H
#define SURFPATH_BENCH_NATIVE_H

#include "surface.h"

struct named_surface {
    const char *name;
    struct sp_surface surface;
};

extern const struct named_surface named_surfaces[];
extern const int named_surface_count;

#endif
