/* What the files of the elementary functions share: their constants, polynomials, and "wide" numbers (sums of two doubles, about 106 bits).
 *
 * Private to wasm/functions*.c. Nothing here uses a fused multiply-add, so the bits are the same on machines with and without one. */
#ifndef SURFPATH_FUNCTIONS_WIDE_H
#define SURFPATH_FUNCTIONS_WIDE_H

#include "functions.h"

/* Bit patterns without a sign, so that shifts are defined and logical. */
typedef uint64_t sp_word __attribute__((vector_size(16)));

/* The unevaluated sum high + low, |low| <= ulp(high)/2, in both lanes. */
struct sp_wide {
    sp_pair high, low;
};

/* Coefficients stand in the order of rising powers; their origin is named in functions_constants.c. */
struct sp_function_constants {
    double two_over_pi;
    double half_pi_parts[3];
    struct sp_wide half_pi, pi, arctangent_half;
    double sine[6], cosine[6];
    double arcsine_numerator[6], arcsine_denominator[5];
    double arctangent[10];
    struct sp_wide inverse_ln2, inverse_ln10;
    double ln2_high, ln2_low;
    double exponential[11];
    double hyperbolic_sine[8];
    double hyperbolic_tangent_numerator[3], hyperbolic_tangent_denominator[4];
    double logarithm[7];
    double wide_logarithm[8];
    struct sp_wide two_thirds;
    double cube_root[5];
    uint64_t two_over_pi_words[21];
};

/* Loaded from memory on purpose: V8 rebuilds vector constants that the compiler sees at every use. */
extern const struct sp_function_constants sp_constants;

/* Adding this to |x| < 2^51 rounds x to the nearest integer, ties to even, and leaves that integer in the low bits. */
#define SP_ROUNDER 0x1.8p52

#define SP_INFINITY __builtin_inf()
#define SP_NAN __builtin_nan("")

/* The loop of a polynomial is always unrolled, also where the build asks for small code: its length is known. Below -O2 clang cannot, and
 * would warn. */
#ifdef __clang__
#pragma clang diagnostic ignored "-Wpass-failed"
#define SP_UNROLL _Pragma("clang loop unroll(full)")
#else
#define SP_UNROLL _Pragma("GCC unroll 16")
#endif

static inline sp_word sp_word_of(sp_pair x) { return (sp_word)x; }

static inline sp_pair sp_pair_of(sp_word bits) { return (sp_pair)bits; }

static inline sp_pair sp_nearest_integer(sp_pair x) { return (x + SP_ROUNDER) - SP_ROUNDER; }

/* `magnitude` >= 0 with the sign of `sign`. */
static inline sp_pair sp_with_sign_of(sp_pair magnitude, sp_pair sign) {
    return sp_pair_of(sp_word_of(magnitude) | (sp_word_of(sign) & (uint64_t)INT64_MIN));
}

/* coefficients[0] + coefficients[1] x + ... up to x^(count - 1), count > 1: even and odd powers by Horner side by side, which halves the
 * wait for one result after the other. */
static inline sp_pair sp_polynomial(sp_pair x, const double *coefficients, int count) {
    sp_pair square = x * x, even = sp_splat(coefficients[(count - 1) & ~1]), odd = sp_splat(coefficients[(count - 2) | 1]);
    SP_UNROLL for (int i = ((count - 1) & ~1) - 2; i >= 0; i -= 2) { even = even * square + coefficients[i]; }
    SP_UNROLL for (int i = ((count - 2) | 1) - 2; i >= 1; i -= 2) { odd = odd * square + coefficients[i]; }
    return even + x * odd;
}

/* a + b exactly, for |a| >= |b| or a = 0. */
static inline struct sp_wide sp_add_smaller(sp_pair a, sp_pair b) {
    sp_pair sum = a + b;
    return (struct sp_wide){sum, (a - sum) + b};
}

/* a + b exactly, whichever is larger. */
static inline struct sp_wide sp_add_exactly(sp_pair a, sp_pair b) {
    sp_pair sum = a + b, b_part = sum - a;
    return (struct sp_wide){sum, (a - (sum - b_part)) + (b - b_part)};
}

/* a b to 2^-105, for products and factors that neither overflow nor are subnormal. Factors are cut to their upper 26 bits instead of by
 * Dekker's multiplication with 2^27 + 1, which overflows for large ones. */
static inline struct sp_wide sp_multiply_exactly(sp_pair a, sp_pair b) {
    const uint64_t upper_half = ~(uint64_t)0x7ffffff;
    sp_pair a_high = sp_pair_of(sp_word_of(a) & upper_half), a_low = a - a_high;
    sp_pair b_high = sp_pair_of(sp_word_of(b) & upper_half), b_low = b - b_high;
    sp_pair product = a * b;
    return (struct sp_wide){product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low};
}

/* a b to about 2^-102. */
static inline struct sp_wide sp_wide_multiply(struct sp_wide a, struct sp_wide b) {
    struct sp_wide product = sp_multiply_exactly(a.high, b.high);
    return sp_add_smaller(product.high, product.low + (a.high * b.low + a.low * b.high));
}

/* sqrt(high + low) for high > 2^-1000 or both 0: with |low| <= 2^-26 high to 2^-56 at least, with |low| <= 2^-53 high to about 2^-104. */
static inline struct sp_wide sp_wide_square_root(sp_pair high, sp_pair low) {
    sp_pair root = sp_square_root(high);
    struct sp_wide square = sp_multiply_exactly(root, root);
    sp_pair rest = ((high - square.high) - square.low) + low;
    return (struct sp_wide){root, sp_select(root == 0.0, root, rest / (2.0 * root))};
}

/* a - b, for |a| >= |b|, to about 2^-104 of a. */
static inline struct sp_wide sp_wide_subtract(struct sp_wide a, struct sp_wide b) {
    struct sp_wide difference = sp_add_smaller(a.high, -b.high);
    return (struct sp_wide){difference.high, difference.low + (a.low - b.low)};
}

static inline struct sp_wide sp_wide_select(sp_mask mask, struct sp_wide yes, struct sp_wide no) {
    return (struct sp_wide){sp_select(mask, yes.high, no.high), sp_select(mask, yes.low, no.low)};
}

#endif
