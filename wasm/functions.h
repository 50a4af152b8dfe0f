/* The elementary functions, two arguments at a time: the only ones in the project, so that every engine and every native build gives the
 * same bits. Pure, branch-light, no libm, no tables beyond this file's constants. Errors are in units in the last place (ulp) of the
 * result, the largest seen against tests/data/functions.json. Outside its domain a function is NaN (log(0) is -infinity); NaN in, NaN out;
 * infinities and signed zeros as in C's Annex F. */
#ifndef SURFPATH_FUNCTIONS_H
#define SURFPATH_FUNCTIONS_H

#include "pair.h"

sp_pair sp_sin(sp_pair x);
sp_pair sp_cos(sp_pair x);
/* Returns sin x and writes cos x: the bits of sp_sin and sp_cos at the price of one. */
sp_pair sp_sincos(sp_pair x, sp_pair *cosine);
sp_pair sp_tan(sp_pair x);
sp_pair sp_asin(sp_pair x);
sp_pair sp_acos(sp_pair x);
sp_pair sp_atan(sp_pair x);
sp_pair sp_atan2(sp_pair y, sp_pair x);
sp_pair sp_sinh(sp_pair x);
sp_pair sp_cosh(sp_pair x);
sp_pair sp_tanh(sp_pair x);
sp_pair sp_exp(sp_pair x);
sp_pair sp_log(sp_pair x);
sp_pair sp_cbrt(sp_pair x);
sp_pair sp_pow(sp_pair x, sp_pair y);

/* The functions by number, in the order in which web/expression/functions.js lists them. */
enum sp_function {
    SP_SIN,
    SP_COS,
    SP_TAN,
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
    SP_FUNCTION_COUNT
};

/* One function of one (or, atan2 and pow, two) numbers: for folding constants in JavaScript and for tests. The bits of lane 0 of the pair
 * function; NaN for an unknown number. */
double sp_apply_function(int32_t function, double x, double y);

#endif
