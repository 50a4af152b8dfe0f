/* Surfaces that misbehave as told: NaN or infinite in places, discontinuous, of absurd size, or another one at every call. */
#ifndef SURFPATH_FUZZ_HOSTILE_H
#define SURFPATH_FUZZ_HOSTILE_H

#include "surface.h"

/* How the numbers of a sound surface are spoilt. */
enum mood {
    SOUND,
    SPOILT_BEYOND, /* `value` instead of every number where the first coordinate exceeds `threshold` */
    SPOILT_SLOPES, /* `value` instead of derivatives there */
    SPOILT_LANE,   /* `value` in the second lane alone */
    CONSTANT,      /* `value` everywhere */
    DISCONTINUOUS, /* multiplied by `value` beyond the threshold */
    SCALED,        /* multiplied by `value` */
    TREMBLING,     /* multiplied by 1 ± `threshold`, differently at every call */
    NOISE,         /* random bits at every call */
    SELDOM_SPOILT, /* `value` at one call of eight */
    MOOD_COUNT
};

struct hostility {
    enum mood mood;
    double value, threshold;
};

/* The surface of this kind and metric that behaves so from now on: the torus implicit, a globe, saddle, bumps by `shape` parametric. The
 * walls are the caller's. */
struct sp_surface hostile_surface(int32_t kind, int32_t metric, uint32_t shape, struct hostility hostility);

#endif
