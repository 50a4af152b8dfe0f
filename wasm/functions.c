/* The cube root, the hypotenuse, and the elementary functions by number. The other functions are in the files functions_*.c. */
#include "functions_wide.h"

/* A third of the upper half of the bits, plus (1023 - 1023/3 - 0.033) 2^20, or 54/3 2^20 less after scaling a subnormal number by 2^54, are
 * the upper bits of the root to 6 %. A polynomial makes that 2^-23, cut to 23 bits so that its square is exact; one step of Halley the
 * rest. */
sp_pair sp_cbrt(sp_pair x) {
    sp_pair magnitude = sp_absolute(x);
    sp_mask subnormal = magnitude < 0x1p-1022;
    sp_pair bias = sp_select(subnormal, sp_splat(696219795.0), sp_splat(715094163.0));
    sp_word bits = sp_word_of(sp_select(subnormal, magnitude * 0x1p54, magnitude));
    sp_pair upper = sp_pair_of((bits >> 32) | 0x4330000000000000) - 0x1p52;
    sp_pair root = sp_pair_of(sp_word_of(upper * (1.0 / 3.0) + bias + 0x1p52) << 32);

    root *= sp_polynomial((root * root) * (root / magnitude), sp_constants.cube_root, 5);
    root = sp_pair_of((sp_word_of(root) + 0x80000000) & 0xffffffffc0000000);
    sp_pair quotient = magnitude / (root * root);
    root += root * ((quotient - root) / (root + root + quotient));
    return sp_select((x == 0.0) | ~(magnitude < SP_INFINITY), x, sp_with_sign_of(root, x));
}

/* Beyond these the squares may overflow, or lose bits to underflow. */
#define SQUARES_OVERFLOW 0x1p500
#define SQUARES_UNDERFLOW 0x1p-500

sp_pair sp_hypot(sp_pair x, sp_pair y) {
    sp_pair a = sp_absolute(x), b = sp_absolute(y), larger = sp_select(a > b, a, b);
    sp_pair scale = sp_select(larger < SQUARES_UNDERFLOW, sp_splat(0x1p600), sp_splat(1.0));
    scale = sp_select(larger > SQUARES_OVERFLOW, sp_splat(0x1p-600), scale);
    a *= scale, b *= scale;
    sp_pair length = sp_square_root(a * a + b * b) / scale, infinity = sp_splat(SP_INFINITY);
    return sp_select((a == infinity) | (b == infinity), infinity, length);
}

double sp_apply_function(int32_t function, double x, double y) {
    sp_pair a = sp_splat(x), b = sp_splat(y);
    switch (function) {
    case SP_SIN:
        return sp_sin(a)[0];
    case SP_COS:
        return sp_cos(a)[0];
    case SP_ASIN:
        return sp_asin(a)[0];
    case SP_ACOS:
        return sp_acos(a)[0];
    case SP_ATAN:
        return sp_atan(a)[0];
    case SP_ATAN2:
        return sp_atan2(a, b)[0];
    case SP_SINH:
        return sp_sinh(a)[0];
    case SP_COSH:
        return sp_cosh(a)[0];
    case SP_TANH:
        return sp_tanh(a)[0];
    case SP_EXP:
        return sp_exp(a)[0];
    case SP_LOG:
        return sp_log(a)[0];
    case SP_CBRT:
        return sp_cbrt(a)[0];
    case SP_POW:
        return sp_pow(a, b)[0];
    case SP_LOG2:
        return sp_log2(a)[0];
    case SP_LOG10:
        return sp_log10(a)[0];
    case SP_ASINH:
        return sp_asinh(a)[0];
    case SP_ACOSH:
        return sp_acosh(a)[0];
    case SP_ATANH:
        return sp_atanh(a)[0];
    case SP_HYPOT:
        return sp_hypot(a, b)[0];
    default:
        return SP_NAN;
    }
}
