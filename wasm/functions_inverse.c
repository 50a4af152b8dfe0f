/* The inverse trigonometric functions. */
#include "functions_wide.h"

/* Above this an arc tangent is taken relative to atan(1/2): keeps the argument of the polynomial within 1/3. */
#define NEAR_ONE_HALF 0.3125

/* asin of 0 <= x <= 1/2, or of sqrt((1 - |x|)/2) for larger |x| (NaN beyond 1), which is half of acos |x|. */
static inline struct sp_wide partial_arcsine(sp_pair magnitude, sp_mask large) {
    sp_pair square = sp_select(large, (1.0 - magnitude) * 0.5, magnitude * magnitude);
    sp_pair sine = sp_select(large, sp_square_root(square), magnitude);
    sp_pair rest =
        square * sp_polynomial(square, sp_constants.arcsine_numerator, 6) / sp_polynomial(square, sp_constants.arcsine_denominator, 5);
    return (struct sp_wide){sine, sine * rest};
}

sp_pair sp_asin(sp_pair x) {
    sp_pair magnitude = sp_absolute(x);
    sp_mask large = magnitude >= 0.5;
    struct sp_wide part = partial_arcsine(magnitude, large);
    struct sp_wide twice = {2.0 * part.high, 2.0 * part.low};
    struct sp_wide angle = sp_wide_select(large, sp_wide_subtract(sp_constants.half_pi, twice), part);
    return sp_with_sign_of(sp_absolute(angle.high + angle.low), x);
}

sp_pair sp_acos(sp_pair x) {
    sp_pair magnitude = sp_absolute(x);
    sp_mask large = magnitude >= 0.5, negative = x < 0.0;
    struct sp_wide part = partial_arcsine(magnitude, large);
    struct sp_wide twice = {2.0 * part.high, 2.0 * part.low};
    struct sp_wide minuend = sp_wide_select(large, sp_constants.pi, sp_constants.half_pi);
    struct sp_wide signed_part = {sp_select(negative, -part.high, part.high), sp_select(negative, -part.low, part.low)};
    struct sp_wide angle = sp_wide_subtract(minuend, sp_wide_select(large, twice, signed_part));
    angle = sp_wide_select(large & ~negative, twice, angle);
    return angle.high + angle.low;
}

/* atan x for 0 <= x <= 1. */
static inline struct sp_wide partial_arctangent(sp_pair x) {
    sp_mask shifted = x > NEAR_ONE_HALF;
    sp_pair tangent = sp_select(shifted, x - 0.5, x) / sp_select(shifted, 1.0 + 0.5 * x, sp_splat(1.0));
    sp_pair square = tangent * tangent;
    sp_pair rest = tangent * (square * sp_polynomial(square, sp_constants.arctangent, 10));
    struct sp_wide shift = sp_constants.arctangent_half;
    struct sp_wide moved = sp_add_smaller(shift.high, tangent);
    moved.low += shift.low + rest;
    return sp_wide_select(shifted, moved, (struct sp_wide){tangent, rest});
}

sp_pair sp_atan(sp_pair x) {
    sp_pair magnitude = sp_absolute(x);
    sp_mask steep = magnitude > 1.0;
    struct sp_wide angle = partial_arctangent(sp_select(steep, 1.0 / magnitude, magnitude));
    angle = sp_wide_select(steep, sp_wide_subtract(sp_constants.half_pi, angle), angle);
    return sp_with_sign_of(sp_absolute(angle.high + angle.low), x);
}

sp_pair sp_atan2(sp_pair y, sp_pair x) {
    sp_pair height = sp_absolute(y), width = sp_absolute(x);
    sp_mask steep = height > width, leftward = sp_bits(x) >> 63;
    sp_pair small = sp_select(steep, width, height), large = sp_select(steep, height, width);
    /* 0/0 counts as 0 and infinity/infinity as 1. */
    sp_pair ratio = sp_select(small == large, sp_select(large == 0.0, large, sp_splat(1.0)), small / large);
    struct sp_wide angle = partial_arctangent(ratio);
    angle = sp_wide_select(steep, sp_wide_subtract(sp_constants.half_pi, angle), angle);
    angle = sp_wide_select(leftward, sp_wide_subtract(sp_constants.pi, angle), angle);
    return sp_with_sign_of(sp_absolute(angle.high + angle.low), y);
}
