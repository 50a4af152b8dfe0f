/* The constants of the elementary functions, in a file of their own so that no compiler folds them into the code (see functions_wide.h). */
#include "functions_wide.h"

/* For both lanes. */
#define BOTH(x)                                                                                                                            \
    { x, x }

const struct sp_function_constants sp_constants = {
    .two_over_pi = 0x1.45f306dc9c883p-1,
    /* 33 + 33 + 53 bits: the products with integers below 2^20 are exact for the first two. */
    .half_pi_parts = {0x1.921fb54400000p+0, 0x1.0b4611a600000p-34, 0x1.3198a2e037073p-69},
    .half_pi = {BOTH(0x1.921fb54442d18p+0), BOTH(0x1.1a62633145c07p-54)},
    .pi = {BOTH(0x1.921fb54442d18p+1), BOTH(0x1.1a62633145c07p-53)},
    .arctangent_half = {BOTH(0x1.dac670561bb4fp-2), BOTH(0x1.a2b7f222f65e2p-56)},
    /* (sin x - x)/x^3 and (cos x - 1 + x^2/2)/x^4 in x^2, |x| <= pi/4: fdlibm 5.3, k_sin.c and k_cos.c. */
    .sine = {-1.66666666666666324348e-01, 8.33333333332248946124e-03, -1.98412698298579493134e-04, 2.75573137070700676789e-06,
             -2.50507602534068634195e-08, 1.58969099521155010221e-10},
    .cosine = {4.16666666666666019037e-02, -1.38888888888741095749e-03, 2.48015872894767294178e-05, -2.75573143513906633035e-07,
               2.08757232129817482790e-09, -1.13596475577881948265e-11},
    /* (asin x - x)/x^3 in x^2, |x| <= 1/2: fdlibm 5.3, e_asin.c. */
    .arcsine_numerator = {1.66666666666666657415e-01, -3.25565818622400915405e-01, 2.01212532134862925881e-01, -4.00555345006794114027e-02,
                          7.91534994289814532176e-04, 3.47933107596021167570e-05},
    .arcsine_denominator = {1.0, -2.40339491173441421878e+00, 2.02094576023350569471e+00, -6.88283971605453293030e-01,
                            7.70381505559019352791e-02},
    /* (atan x - x)/x^3 in x^2, |x| <= 1/3: interpolated at Chebyshev's points in 300 bits, error 2^-55. */
    .arctangent = {-0x1.5555555555555p-2, 0x1.99999999995eap-3, -0x1.249249244dacep-3, 0x1.c71c71890f6c4p-4, -0x1.745d08fbb0f95p-4,
                   0x1.3b11cb76fb8c9p-4, -0x1.10e98f73b1b4bp-4, 0x1.dddd37f4d10a6p-5, -0x1.8ee5cbe5acf09p-5, 0x1.deefe6a054357p-6},
    .inverse_ln2 = {BOTH(0x1.71547652b82fep+0), BOTH(0x1.777d0ffda0d24p-56)},
    .inverse_ln10 = {BOTH(0x1.bcb7b1526e50ep-2), BOTH(0x1.95355baaafad3p-57)},
    /* 40 bits, so that products with exponents are exact. */
    .ln2_high = 0x1.62e42fefa2000p-1,
    .ln2_low = 0x1.9ef35793c7673p-41,
    /* (exp x - 1 - x)/x^2, |x| <= ln(2)/2: interpolated likewise, error 2^-58. */
    .exponential = {0x1.0000000000000p-1, 0x1.5555555555557p-3, 0x1.5555555555556p-5, 0x1.11111111100d8p-7, 0x1.6c16c16c162d2p-10,
                    0x1.a01a01abea2dap-13, 0x1.a01a01a6d9c97p-16, 0x1.71de022aa7c92p-19, 0x1.27e4db6075799p-22, 0x1.af4df7e870362p-26,
                    0x1.1f730b86989dap-29},
    /* (sinh x - x)/x^3 in x^2, |x| <= 1: interpolated likewise, error 2^-56. */
    .hyperbolic_sine = {0x1.5555555555555p-3, 0x1.1111111111111p-7, 0x1.a01a01a01a001p-13, 0x1.71de3a556f96cp-19, 0x1.ae6456792a77fp-26,
                        0x1.612467ccb2260p-33, 0x1.ae777c36fd5b5p-41, 0x1.99f0806c262e1p-49},
    /* (tanh x - x)/x^3 in x^2, |x| <= 5/8: Cephes 2.8, tanh.c. */
    .hyperbolic_tangent_numerator = {-1.61468768441708447952e3, -9.92877231001918586564e1, -9.64399179425052238628e-1},
    .hyperbolic_tangent_denominator = {4.84406305325125486048e3, 2.23548839060100448583e3, 1.12811678491632931402e2, 1.0},
    /* (log((1 + s)/(1 - s)) - 2 s)/s^3 in s^2, |s| <= 0.1716: fdlibm 5.3, e_log.c. */
    .logarithm = {6.666666666666735130e-01, 3.999999999940941908e-01, 2.857142874366239149e-01, 2.222219843214978396e-01,
                  1.818357216161805012e-01, 1.531383769920937332e-01, 1.479819860511658591e-01},
    /* (3 atanh(s)/s - 3 - s^2)/s^4 in s^2, |s| <= 0.1716: interpolated likewise, error 2^-55. */
    .wide_logarithm = {0x1.3333333333333p-1, 0x1.b6db6db6db7b2p-2, 0x1.555555552ffd2p-2, 0x1.1745d19beca99p-2, 0x1.d89d60be5d3bbp-3,
                       0x1.99a52b2804c4dp-3, 0x1.679da8fbbec48p-3, 0x1.68221483d2465p-3},
    .two_thirds = {BOTH(0x1.5555555555555p-1), BOTH(0x1.5555555555555p-55)},
    /* 1/cbrt(r) for r near 1, to 2^-23: FreeBSD, s_cbrt.c. */
    .cube_root = {1.87595182427177009643, -1.88497979543377169875, 1.621429720105354466140, -0.758397934778766047437,
                  0.145996192886612446982},
    /* 64 zero bits, then the first 1280 binary places of 2/pi. */
    .two_over_pi_words = {0,
                          0xa2f9836e4e441529,
                          0xfc2757d1f534ddc0,
                          0xdb6295993c439041,
                          0xfe5163abdebbc561,
                          0xb7246e3a424dd2e0,
                          0x06492eea09d1921c,
                          0xfe1deb1cb129a73e,
                          0xe88235f52ebb4484,
                          0xe99c7026b45f7e41,
                          0x3991d639835339f4,
                          0x9c845f8bbdf9283b,
                          0x1ff897ffde05980f,
                          0xef2f118b5a0a6d1f,
                          0x6d367ecf27cb09b7,
                          0x4f463f669e5fea2d,
                          0x7527bac7ebe5f17b,
                          0x3d0739f78a5292ea,
                          0x6bfb5fb11f8d5d08,
                          0x56033046fc7b6bab,
                          0xf0cfbc209af4361d},
};
