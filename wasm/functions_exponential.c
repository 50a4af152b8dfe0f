/* Exponential, logarithms, power, the hyperbolic functions and their inverses.
 *
 * exp: x = k ln 2 + r, a polynomial in r, scaled by 2^k. log: x = 2^k m with m near 1, a series in (m - 1)/(m + 1). pow: exp(y log x) with
 * a logarithm of about 68 bits, because an error of the exponent is multiplied by up to 745; log2 and log10 use it too, so that powers of 2
 * and 10 come out exact. asinh, acosh, atanh: the logarithm of a wide number, for near 1 its second part is all that counts. */
#include "functions_wide.h"

#define SMALLEST_NORMAL 0x1p-1022

/* Beyond these exp overflows, even halved, or is less than half the smallest subnormal. */
#define EXPONENT_HIGHEST 711.0
#define EXPONENT_LOWEST (-746.0)

/* Above this y log x overflows or underflows for every x but 1, so that y itself may be cut off there. */
#define LARGEST_POWER 0x1p66

/* From here on sqrt(x^2 + 1) is x to 2^-57. */
#define ROOT_IS_X 0x1p28

/* 2^n for integers -1022 <= n <= 1023. */
static inline sp_pair power_of_two(sp_pair n) { return sp_pair_of((sp_word_of(n + SP_ROUNDER) + 1023) << 52); }

/* exp(x) 2^shift for an integer shift of 0 or -1. Scaled in two steps, of which only the second rounds, so subnormal results are gradual.
 */
static inline sp_pair exponential(struct sp_wide x, sp_pair shift) {
    sp_pair clamped = sp_select(x.high > EXPONENT_HIGHEST, sp_splat(EXPONENT_HIGHEST), x.high);
    sp_mask nothing = x.high < EXPONENT_LOWEST; /* not left to the last step: processors take many times as long where that underflows */
    clamped = sp_select(nothing, sp_splat(0.0), clamped);
    sp_pair x_low = sp_select(x.high == clamped, x.low, sp_splat(0.0));

    sp_pair exponent = sp_nearest_integer(clamped * sp_constants.inverse_ln2.high);
    sp_pair head = clamped - exponent * sp_constants.ln2_high, correction = exponent * sp_constants.ln2_low - x_low;
    sp_pair r = head - correction, lost = (head - r) - correction;
    struct sp_wide linear = sp_add_smaller(sp_splat(1.0), r);
    sp_pair value = linear.high + (linear.low + (lost + r * r * sp_polynomial(r, sp_constants.exponential, 11)));

    exponent += shift;
    sp_pair half = sp_nearest_integer(0.5 * exponent);
    return sp_select(nothing, sp_splat(0.0), value * power_of_two(half) * power_of_two(exponent - half));
}

/* exp(x + x_low) 2^shift. Out of line, as five functions share it. */
__attribute__((noinline)) static sp_pair wide_exponential(sp_pair x, sp_pair x_low, sp_pair shift) {
    return exponential((struct sp_wide){x, x_low}, shift);
}

sp_pair sp_exp(sp_pair x) { return wide_exponential(x, sp_splat(0.0), sp_splat(0.0)); }

static inline sp_pair half_exponential(sp_pair x) { return wide_exponential(x, sp_splat(0.0), sp_splat(-1.0)); }

sp_pair sp_cosh(sp_pair x) {
    sp_pair half = half_exponential(sp_absolute(x));
    return half + 0.25 / half;
}

sp_pair sp_sinh(sp_pair x) {
    sp_pair magnitude = sp_absolute(x), half = half_exponential(magnitude);
    sp_pair square = x * x;
    sp_pair small = magnitude + magnitude * (square * sp_polynomial(square, sp_constants.hyperbolic_sine, 8));
    return sp_with_sign_of(sp_select(magnitude < 1.0, small, half - 0.25 / half), x);
}

sp_pair sp_tanh(sp_pair x) {
    sp_pair magnitude = sp_absolute(x), square = x * x;
    sp_pair ratio = sp_polynomial(square, sp_constants.hyperbolic_tangent_numerator, 3) /
                    sp_polynomial(square, sp_constants.hyperbolic_tangent_denominator, 4);
    sp_pair small = magnitude + magnitude * (square * ratio);
    sp_pair large = 1.0 - 1.0 / (half_exponential(2.0 * magnitude) + 0.5);
    return sp_with_sign_of(sp_select(magnitude < 0.625, small, large), x);
}

/* x = 2^exponent mantissa with sqrt(1/2) <= mantissa < sqrt(2), for finite x > 0. */
struct scaled {
    sp_pair exponent, mantissa;
};

static inline struct scaled split(sp_pair x) {
    const uint64_t one = 0x3ff0000000000000, root = 0x3fe6a09e667f3bcd, fraction = 0xfffffffffffff, integer = 0x4330000000000000;
    sp_mask subnormal = x < SMALLEST_NORMAL;
    sp_pair bias = sp_splat(0x1p52 + 1023);
    if (sp_any(subnormal)) x = sp_select(subnormal, x * 0x1p54, x), bias = sp_select(subnormal, bias + 54.0, bias);
    sp_word bits = sp_word_of(x) + (one - root);
    return (struct scaled){sp_pair_of((bits >> 52) | integer) - bias, sp_pair_of((bits & fraction) + root)};
}

/* The logarithm of 2^exponent mantissa, plus a correction that is small beside it or beside ln2_high. */
static inline sp_pair logarithm(struct scaled parts, sp_pair correction) {
    sp_pair f = parts.mantissa - 1.0, s = f / (2.0 + f), square = s * s, half = 0.5 * f * f;
    sp_pair rest = square * sp_polynomial(square, sp_constants.logarithm, 7);
    sp_pair tail = s * (half + rest) + correction;
    return parts.exponent * sp_constants.ln2_high - ((half - tail) - f);
}

/* The value, but where x is not a positive finite number what a logarithm is there. */
static inline sp_pair logarithm_of(sp_pair x, sp_pair value) {
    sp_pair special = sp_select(x < 0.0, sp_splat(SP_NAN), sp_select(x == 0.0, sp_splat(-SP_INFINITY), x));
    return sp_select((x > 0.0) & (x < SP_INFINITY), value, special);
}

sp_pair sp_log(sp_pair x) {
    struct scaled parts = split(x);
    sp_pair value = logarithm(parts, parts.exponent * sp_constants.ln2_low);
    return sp_any(~((x > 0.0) & (x < SP_INFINITY))) ? logarithm_of(x, value) : value;
}

/* log((high + low) 2^doublings) for high >= 1; exact in low, however small the logarithm. Out of line, as three functions share it. */
__attribute__((noinline)) static sp_pair logarithm_beyond_one(sp_pair high, sp_pair low, sp_pair doublings) {
    struct scaled parts = split(high);
    parts.exponent += doublings;
    return logarithm(parts, parts.exponent * sp_constants.ln2_low + low / high);
}

/* log(x + sqrt(x^2 + one)) for x >= 0, one = 1 or -1; NaN where the root is. Out of line, as two functions share it. */
__attribute__((noinline)) static sp_pair inverse_hyperbolic(sp_pair x, double one) {
    struct sp_wide square = sp_multiply_exactly(x, x), sum = sp_add_exactly(square.high, sp_splat(one));
    struct sp_wide root = sp_wide_square_root(sum.high, sum.low + square.low);
    struct sp_wide argument = sp_add_exactly(x, root.high);
    argument.low += root.low;
    sp_mask large = x > ROOT_IS_X;
    argument = sp_wide_select(large, (struct sp_wide){x, sp_splat(0.0)}, argument);
    sp_pair value = logarithm_beyond_one(argument.high, argument.low, sp_select(large, sp_splat(1.0), sp_splat(0.0)));
    return sp_select(x < SP_INFINITY, value, x);
}

sp_pair sp_asinh(sp_pair x) { return sp_with_sign_of(inverse_hyperbolic(sp_absolute(x), 1.0), x); }

sp_pair sp_acosh(sp_pair x) { return sp_select(x >= 1.0, inverse_hyperbolic(x, -1.0), sp_splat(SP_NAN)); }

sp_pair sp_atanh(sp_pair x) {
    sp_pair magnitude = sp_absolute(x), one = sp_splat(1.0);
    struct sp_wide above = sp_add_smaller(one, magnitude), below = sp_add_smaller(one, -magnitude), ratio;
    ratio.high = above.high / below.high;
    struct sp_wide product = sp_multiply_exactly(ratio.high, below.high);
    sp_pair rest = ((above.high - product.high) - product.low) + (above.low - ratio.high * below.low);
    ratio.low = rest / below.high;
    sp_pair value = 0.5 * logarithm_beyond_one(ratio.high, ratio.low, sp_splat(0.0));
    sp_pair special = sp_select(magnitude == 1.0, sp_splat(SP_INFINITY), sp_splat(SP_NAN));
    return sp_with_sign_of(sp_select(magnitude < 1.0, value, special), x);
}

/* log x to about 2^-65 of it, for finite x > 0. Out of line, as three functions share it. */
__attribute__((noinline)) static struct sp_wide wide_logarithm(sp_pair x) {
    struct scaled parts = split(x);
    /* s = f/d, f and d = 2 + f exact. */
    sp_pair f = parts.mantissa - 1.0;
    struct sp_wide d = sp_add_smaller(sp_splat(2.0), f), s;
    s.high = f / d.high;
    struct sp_wide product = sp_multiply_exactly(s.high, d.high);
    s.low = (((f - product.high) - product.low) - s.high * d.low) / d.high;
    /* atanh(s) = s/3 (3 + s^2 + s^4 (...)). */
    struct sp_wide square = sp_wide_multiply(s, s);
    struct sp_wide series = sp_add_smaller(sp_splat(3.0), square.high);
    series.low += square.low + square.high * square.high * sp_polynomial(square.high, sp_constants.wide_logarithm, 8);
    series = sp_add_smaller(series.high, series.low);
    struct sp_wide fraction = sp_wide_multiply(sp_wide_multiply(s, sp_constants.two_thirds), series);
    /* An exponent of 0 adds nothing, any other more than the fraction has. */
    struct sp_wide sum = sp_add_smaller(parts.exponent * sp_constants.ln2_high, fraction.high);
    return sp_add_smaller(sum.high, sum.low + (fraction.low + parts.exponent * sp_constants.ln2_low));
}

/* Out of line, as two functions share it. */
__attribute__((noinline)) static sp_pair scaled_logarithm(sp_pair x, const struct sp_wide *factor) {
    struct sp_wide value = sp_wide_multiply(wide_logarithm(x), *factor);
    return logarithm_of(x, value.high + value.low);
}

sp_pair sp_log2(sp_pair x) { return scaled_logarithm(x, &sp_constants.inverse_ln2); }

sp_pair sp_log10(sp_pair x) { return scaled_logarithm(x, &sp_constants.inverse_ln10); }

static inline sp_mask is_integer(sp_pair x) {
    sp_pair magnitude = sp_absolute(x);
    return (magnitude >= 0x1p52) | ((magnitude + 0x1p52) - 0x1p52 == magnitude);
}

sp_pair sp_pow(sp_pair x, sp_pair y) {
    sp_pair magnitude = sp_absolute(x), infinity = sp_splat(SP_INFINITY);
    sp_pair power = sp_select(y > LARGEST_POWER, sp_splat(LARGEST_POWER), y);
    power = sp_select(y < -LARGEST_POWER, sp_splat(-LARGEST_POWER), power);
    struct sp_wide exponent = wide_logarithm(magnitude);
    struct sp_wide product = sp_multiply_exactly(power, exponent.high);
    product.low += power * exponent.low;
    sp_pair value = wide_exponential(product.high, product.low, sp_splat(0.0));

    sp_mask whole = is_integer(y), odd = whole & ~is_integer(0.5 * y);
    sp_mask extreme = (magnitude == 0.0) | (magnitude == infinity);
    sp_mask grows = (magnitude == infinity) == (y > 0.0);
    value = sp_select(extreme, sp_select(grows, infinity, sp_splat(0.0)), value);
    value = sp_pair_of(sp_word_of(value) | (sp_word_of(x) & (sp_word)odd & (uint64_t)INT64_MIN));
    value = sp_select((x < 0.0) & (x > -SP_INFINITY) & ~whole, sp_splat(SP_NAN), value);
    value = sp_select((x != x) | (y != y), x + y, value);
    return sp_select((x == 1.0) | (y == 0.0), sp_splat(1.0), value);
}
