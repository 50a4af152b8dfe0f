/* The elementary functions, two arguments at a time: the only ones in the project, so that every engine and every native build gives the
 * same bits. Pure, no libm; neither lane depends on the other. Outside its domain a function is NaN; NaN in, NaN out, but for pow;
 * infinities, signed zeros and gradual underflow are as in C's Annex F.
 *
 * Each function states its largest error in units in the last place (ulp) of the result, seen in 3 million random arguments against MPFR or
 * quadruple precision. tests/data/functions.csv (described in make-functions.py beside it) holds 31,000 results to 66 bits, the hard cases
 * among them. */
#ifndef SURFPATH_FUNCTIONS_H
#define SURFPATH_FUNCTIONS_H

#include "pair.h"

/* sin x, 0.77 ulp for every finite x. About 5 ns a lane in WebAssembly, and some 60 ns more for each lane with |x| >= 2^19. */
sp_pair sp_sin(sp_pair x);

/* cos x, 0.78 ulp for every finite x. Costs what sp_sin costs. */
sp_pair sp_cos(sp_pair x);

/* Returns sin x and writes cos x to `cosine` (not NULL): the bits of sp_sin and sp_cos at the price of one. Their quotient is tan x, 2.17
 * ulp for every finite x; never infinite, since no double is an odd multiple of pi/2. */
sp_pair sp_sincos(sp_pair x, sp_pair *cosine);

/* Returns sin x and writes cos x, sin y and cos y to `others`: the bits of sp_sincos for each, in three quarters of the time. */
sp_pair sp_sincos_two(sp_pair x, sp_pair y, sp_pair *others);

/* asin x in [-pi/2, pi/2] for -1 <= x <= 1, 1.16 ulp. */
sp_pair sp_asin(sp_pair x);

/* acos x in [0, pi] for -1 <= x <= 1, 1.13 ulp. */
sp_pair sp_acos(sp_pair x);

/* atan x in [-pi/2, pi/2], 1.16 ulp. */
sp_pair sp_atan(sp_pair x);

/* The angle of the point (x, y) in [-pi, pi], 1.43 ulp; the signs of zeros tell the quadrant, (0, 0) included. */
sp_pair sp_atan2(sp_pair y, sp_pair x);

/* sinh x, 1.59 ulp; infinite from |x| = 710.48 on. */
sp_pair sp_sinh(sp_pair x);

/* cosh x, 1.11 ulp; infinite from |x| = 710.48 on. */
sp_pair sp_cosh(sp_pair x);

/* tanh x, 1.32 ulp. */
sp_pair sp_tanh(sp_pair x);

/* e^x, 0.77 ulp; infinite from x = 709.79 on, subnormal below -708.39, 0 below -745.14. */
sp_pair sp_exp(sp_pair x);

/* The natural logarithm, 0.85 ulp; log 0 = -infinity. */
sp_pair sp_log(sp_pair x);

/* The real cube root, of the sign of x, 0.67 ulp. */
sp_pair sp_cbrt(sp_pair x);

/* x^y, 0.78 ulp. Of x < 0 for integer y only; pow(x, 0) = pow(1, y) = 1 even for NaN. About 28 ns a lane in WebAssembly. */
sp_pair sp_pow(sp_pair x, sp_pair y);

/* The logarithm to base 2, 0.51 ulp, exact for powers of 2; log2 0 = -infinity. Costs what sp_pow costs, less its exponential. */
sp_pair sp_log2(sp_pair x);

/* The logarithm to base 10, 0.51 ulp, exact for powers of 10; log10 0 = -infinity. Costs what sp_log2 costs. */
sp_pair sp_log10(sp_pair x);

/* asinh x, 1.01 ulp. */
sp_pair sp_asinh(sp_pair x);

/* acosh x >= 0 for x >= 1, 0.82 ulp. */
sp_pair sp_acosh(sp_pair x);

/* atanh x for -1 <= x <= 1, 1.01 ulp; infinite at the ends. */
sp_pair sp_atanh(sp_pair x);

/* sqrt(x^2 + y^2) without overflow or underflow on the way, 1.20 ulp; infinite if either is, even beside NaN. */
sp_pair sp_hypot(sp_pair x, sp_pair y);

/* The functions by number, in the order in which web/expression/functions.js lists them. */
enum sp_function {
    SP_SIN,
    SP_COS,
    SP_ASIN,
    SP_ACOS,
    SP_ATAN,
    SP_ATAN2,
    SP_SINH,
    SP_COSH,
    SP_TANH,
    SP_EXP,
    SP_LOG,
    SP_CBRT,
    SP_POW,
    SP_LOG2,
    SP_LOG10,
    SP_ASINH,
    SP_ACOSH,
    SP_ATANH,
    SP_HYPOT,
    SP_FUNCTION_COUNT
};

/* One function of one (or, atan2, pow and hypot, two) numbers: for folding constants in JavaScript and for tests. `x` is the first argument
 * of the pair function, for atan2 the y of the point; `y` the second, else not read. The bits of lane 0; NaN for an unknown number. */
double sp_apply_function(int32_t function, double x, double y);

#endif
