/* Surfaces written by hand, as the solver wants them (wasm/surface.h): a saddle, a bumpy height field, a torus and a sphere in both forms,
 * a cusp. */
#ifndef SURFPATH_TEST_SURFACES_H
#define SURFPATH_TEST_SURFACES_H

#include "functions.h"
#include "surface.h"

#include <math.h>

/* A height field (u, v, h) from h and its derivatives. */
static void write_height(sp_pair u, sp_pair v, const sp_pair h[6], int values, sp_pair *out) {
    sp_pair zero = sp_splat(0.0), one = sp_splat(1.0);
    sp_pair jet[SP_PARAMETRIC_JET] = {u, v, h[0], one, zero, h[1], zero, one, h[2], zero, zero, h[3], zero, zero, h[4], zero, zero, h[5]};
    for (int j = 0; j < values; j++)
        out[j] = jet[j];
}

static void saddle(int32_t count, const sp_pair *in, sp_pair *out, int values) {
    for (; count > 0; count--, in += 2, out += values) {
        sp_pair u = in[0], v = in[1];
        sp_pair h[6] = {u * u - v * v, 2.0 * u, -2.0 * v, sp_splat(2.0), sp_splat(0.0), sp_splat(-2.0)};
        write_height(u, v, h, values, out);
    }
}

/* z = sin(3u) sin(3v)/2 */
static void bumpy(int32_t count, const sp_pair *in, sp_pair *out, int values) {
    for (; count > 0; count--, in += 2, out += values) {
        sp_pair cu, cv, su = sp_sincos(3.0 * in[0], &cu), sv = sp_sincos(3.0 * in[1], &cv);
        sp_pair h[6] = {0.5 * su * sv, 1.5 * cu * sv, 1.5 * su * cv, -4.5 * su * sv, 4.5 * cu * cv, -4.5 * su * sv};
        write_height(in[0], in[1], h, values, out);
    }
}

/* (x^2 + y^2 + z^2 + R^2 - a^2)^2 - 4 R^2 (x^2 + y^2), R = 4, a = 1.5: the paper's Eq. 46. */
static void torus(int32_t count, const sp_pair *in, sp_pair *out, int values) {
    for (; count > 0; count--, in += 3, out += values) {
        sp_pair x = in[0], y = in[1], z = in[2], s = x * x + y * y + z * z + 13.75;
        sp_pair jet[SP_IMPLICIT_JET] = {s * s - 64.0 * (x * x + y * y),
                                        4.0 * s * x - 128.0 * x,
                                        4.0 * s * y - 128.0 * y,
                                        4.0 * s * z,
                                        8.0 * x * x + 4.0 * s - 128.0,
                                        8.0 * x * y,
                                        8.0 * x * z,
                                        8.0 * y * y + 4.0 * s - 128.0,
                                        8.0 * y * z,
                                        8.0 * z * z + 4.0 * s};
        for (int j = 0; j < values; j++)
            out[j] = jet[j];
    }
}

static void sphere(int32_t count, const sp_pair *in, sp_pair *out, int values) {
    for (; count > 0; count--, in += 3, out += values) {
        sp_pair x = in[0], y = in[1], z = in[2], two = sp_splat(2.0), zero = sp_splat(0.0);
        sp_pair jet[SP_IMPLICIT_JET] = {x * x + y * y + z * z - 1.0, 2.0 * x, 2.0 * y, 2.0 * z, two, zero, zero, two, zero, two};
        for (int j = 0; j < values; j++)
            out[j] = jet[j];
    }
}

/* (cos v cos u, cos v sin u, sin v) */
static void globe(int32_t count, const sp_pair *in, sp_pair *out, int values) {
    for (; count > 0; count--, in += 2, out += values) {
        sp_pair cu, cv, su = sp_sincos(in[0], &cu), sv = sp_sincos(in[1], &cv), zero = sp_splat(0.0);
        sp_pair jet[SP_PARAMETRIC_JET] = {cv * cu,  cv * su,  sv,   -cv * su, cv * cu,  zero, -sv * cu, -sv * su, cv,
                                          -cv * cu, -cv * su, zero, sv * su,  -sv * cu, zero, -cv * cu, -cv * su, -sv};
        for (int j = 0; j < values; j++)
            out[j] = jet[j];
    }
}

/* A cusp along v = 0: (u, v^2, v^3). */
static void cusp(int32_t count, const sp_pair *in, sp_pair *out, int values) {
    for (; count > 0; count--, in += 2, out += values) {
        sp_pair v = in[1], zero = sp_splat(0.0), one = sp_splat(1.0), two = sp_splat(2.0);
        sp_pair jet[SP_PARAMETRIC_JET] = {in[0], v * v, v * v * v, one,  zero, zero, zero, 2.0 * v, 3.0 * v * v,
                                          zero,  zero,  zero,      zero, zero, zero, zero, two,     6.0 * v};
        for (int j = 0; j < values; j++)
            out[j] = jet[j];
    }
}

#define COMPILED(name, jet_size, value_size)                                                                                               \
    static void name##_jet(int32_t count, const sp_pair *in, sp_pair *out) { name(count, in, out, jet_size); }                             \
    static void name##_value(int32_t count, const sp_pair *in, sp_pair *out) { name(count, in, out, value_size); }

COMPILED(saddle, SP_PARAMETRIC_JET, SP_PARAMETRIC_VALUES)
COMPILED(bumpy, SP_PARAMETRIC_JET, SP_PARAMETRIC_VALUES)
COMPILED(globe, SP_PARAMETRIC_JET, SP_PARAMETRIC_VALUES)
COMPILED(cusp, SP_PARAMETRIC_JET, SP_PARAMETRIC_VALUES)
COMPILED(torus, SP_IMPLICIT_JET, SP_IMPLICIT_VALUES)
COMPILED(sphere, SP_IMPLICIT_JET, SP_IMPLICIT_VALUES)

static const struct sp_surface saddle_surface = {saddle_jet, saddle_value, SP_PARAMETRIC, 0, {-1, -1.1}, {1, 1.1}, 0};
static const struct sp_surface bumpy_surface = {bumpy_jet, bumpy_value, SP_PARAMETRIC, 0, {-3.2, -3.2}, {3.2, 3.2}, 0};
static const struct sp_surface globe_surface = {globe_jet, globe_value, SP_PARAMETRIC, 0, {-10, -1.5}, {10, 1.5}, 0};
/* With its poles, and closed in u. */
static const struct sp_surface whole_globe_surface = {
    globe_jet, globe_value, SP_PARAMETRIC, 0, {-HUGE_VAL, -1.57079632679489661923}, {HUGE_VAL, 1.57079632679489661923}, 0};
static const struct sp_surface cusp_surface = {cusp_jet, cusp_value, SP_PARAMETRIC, 0, {-1, -1}, {1, 1}, 0};
static const struct sp_surface torus_surface = {torus_jet, torus_value, SP_IMPLICIT, 0, {0, 0}, {0, 0}, 19.7};
static const struct sp_surface sphere_surface = {sphere_jet, sphere_value, SP_IMPLICIT, 0, {0, 0}, {0, 0}, 3.5};

#endif
