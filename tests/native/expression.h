/* What expressions written as C need beyond pair.h: the WebAssembly instructions f64x2.min, f64x2.max and f64x2.floor, and bitwise
 * operators on pairs. Everything but the bits of a NaN is as in WebAssembly. */
#ifndef SURFPATH_TESTS_EXPRESSION_H
#define SURFPATH_TESTS_EXPRESSION_H

#include "pair.h"

static inline sp_pair sp_less(sp_pair x, sp_pair y) { return sp_from_bits((sp_mask)(x < y)); }

static inline sp_pair sp_and(sp_pair x, sp_pair y) { return sp_from_bits(sp_bits(x) & sp_bits(y)); }

static inline sp_pair sp_and_not(sp_pair x, sp_pair y) { return sp_from_bits(sp_bits(x) & ~sp_bits(y)); }

static inline sp_pair sp_or(sp_pair x, sp_pair y) { return sp_from_bits(sp_bits(x) | sp_bits(y)); }

/* The smaller; NaN if either is NaN; -0 is smaller than +0. */
static inline sp_pair sp_minimum(sp_pair x, sp_pair y) {
    sp_pair equal_or_nan = sp_select((sp_mask)(x == y), sp_or(x, y), x + y);
    return sp_select((sp_mask)(x < y), x, sp_select((sp_mask)(y < x), y, equal_or_nan));
}

/* The larger; NaN if either is NaN; +0 is larger than -0. */
static inline sp_pair sp_maximum(sp_pair x, sp_pair y) {
    sp_pair equal_or_nan = sp_select((sp_mask)(x == y), sp_and(x, y), x + y);
    return sp_select((sp_mask)(x < y), y, sp_select((sp_mask)(y < x), x, equal_or_nan));
}

/* Beyond 2^52 every double is an integer, and conversion to int64_t would overflow. */
static inline double sp_floor_number(double x) {
    if (!(x > -0x1p52 && x < 0x1p52)) return x;
    double truncated = (double)(int64_t)x;
    if (truncated > x) return truncated - 1.0;
    return truncated == 0.0 && !(x > 0.0) ? x : truncated;
}

static inline sp_pair sp_floor(sp_pair x) { return (sp_pair){sp_floor_number(x[0]), sp_floor_number(x[1])}; }

#endif
