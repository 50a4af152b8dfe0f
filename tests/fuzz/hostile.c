#include "hostile.h"
#include "../native/surfaces.h"

#include <string.h>

static struct hostility present;
static uint64_t noise;

static uint64_t next_bits(void) {
    noise ^= noise >> 12, noise ^= noise << 25, noise ^= noise >> 27;
    return noise * 0x2545F4914F6CDD1DULL;
}

static double noisy(double number) {
    uint64_t bits = next_bits();
    double random;
    memcpy(&random, &bits, sizeof random);
    if (present.mood == TREMBLING) return number * (1 + present.threshold * ((double)(bits >> 11) / 4503599627370496.0 - 1));
    return random;
}

static double spoil(double number, double where, int is_slope, int lane, int seldom) {
    int beyond = where > present.threshold;
    switch (present.mood) {
    case SPOILT_BEYOND:
        return beyond ? present.value : number;
    case SPOILT_SLOPES:
        return beyond && is_slope ? present.value : number;
    case SPOILT_LANE:
        return lane ? present.value : number;
    case CONSTANT:
        return present.value;
    case DISCONTINUOUS:
        return beyond ? number * present.value : number;
    case SCALED:
        return number * present.value;
    case TREMBLING:
    case NOISE:
        return noisy(number);
    case SELDOM_SPOILT:
        return seldom ? present.value : number;
    default:
        return number;
    }
}

/* Spoils what a sound surface wrote: `values` of its `outputs` numbers are no derivatives. */
static void spoil_all(int32_t count, const sp_pair *in, sp_pair *out, int inputs, int outputs, int values) {
    if (present.mood == SOUND) return;
    int seldom = present.mood == SELDOM_SPOILT && next_bits() % 8 == 0;
    for (int32_t i = 0; i < count; i++)
        for (int j = 0; j < outputs; j++)
            for (int lane = 0; lane < 2; lane++)
                out[outputs * i + j][lane] = spoil(out[outputs * i + j][lane], in[inputs * i][lane], j >= values, lane, seldom);
}

static sp_evaluate sound_jet, sound_value;

static void induced(int32_t count, const sp_pair *in, sp_pair *out) {
    sound_jet(count, in, out);
    spoil_all(count, in, out, 2, SP_PARAMETRIC_JET, 3);
}

static void value(int32_t count, const sp_pair *in, sp_pair *out) {
    sound_value(count, in, out);
    spoil_all(count, in, out, 2, SP_PARAMETRIC_VALUES, 3);
}

/* phi = 1 + u^2/4 beside the positions. */
static void dense(int32_t count, const sp_pair *in, sp_pair *out) {
    for (int32_t i = 0; i < count; i++) {
        sp_pair jet[SP_PARAMETRIC_JET], u = in[2 * i], zero = sp_splat(0.0);
        sp_pair phi[6] = {1.0 + 0.25 * u * u, 0.5 * u, zero, sp_splat(0.5), zero, zero};
        sound_jet(1, in + 2 * i, jet);
        for (int k = 0; k < 6; k++) {
            for (int j = 0; j < 3; j++)
                out[24 * i + 4 * k + j] = jet[3 * k + j];
            out[24 * i + 4 * k + 3] = phi[k];
        }
    }
    spoil_all(count, in, out, 2, SP_PARAMETRIC_DENSITY_JET, 4);
}

/* E = 1 + v^2, F = u v / 4, G = 1. */
static void tensor(int32_t count, const sp_pair *in, sp_pair *out) {
    for (int32_t i = 0; i < count; i++) {
        sp_pair u = in[2 * i], v = in[2 * i + 1], zero = sp_splat(0.0), one = sp_splat(1.0);
        sp_pair jet[SP_PARAMETRIC_TENSOR_JET] = {1.0 + v * v, 0.25 * u * v,   one,  zero,          0.25 * v, zero,
                                                 2.0 * v,     0.25 * u,       zero, zero,          zero,     zero,
                                                 zero,        sp_splat(0.25), zero, sp_splat(2.0), zero,     zero};
        memcpy(out + 18 * i, jet, sizeof jet);
    }
    spoil_all(count, in, out, 2, SP_PARAMETRIC_TENSOR_JET, 3);
}

static void implicit(int32_t count, const sp_pair *in, sp_pair *out) {
    torus_jet(count, in, out);
    spoil_all(count, in, out, 3, SP_IMPLICIT_JET, 1);
}

static void implicit_value(int32_t count, const sp_pair *in, sp_pair *out) {
    torus_value(count, in, out);
    spoil_all(count, in, out, 3, SP_IMPLICIT_VALUES, 1);
}

/* `width` - 1 functions of x beside f, all alike: 1 + x^2/4; those beyond the first only where `mask` says so, else 0. */
static void beside(int32_t count, const sp_pair *in, sp_pair *out, int width, unsigned mask) {
    for (int32_t i = 0; i < count; i++) {
        sp_pair jet[SP_IMPLICIT_JET], x = in[3 * i], zero = sp_splat(0.0);
        torus_jet(1, in + 3 * i, jet);
        for (int k = 0; k < SP_IMPLICIT_JET; k++)
            for (int j = 0; j < width; j++) {
                sp_pair phi = k == 0 ? 1.0 + 0.25 * x * x : k == 1 ? 0.5 * x : k == 4 ? sp_splat(0.5) : zero;
                out[width * (SP_IMPLICIT_JET * i + k) + j] = j == 0 ? jet[k] : mask >> j & 1 ? phi : zero;
            }
    }
    spoil_all(count, in, out, 3, width * SP_IMPLICIT_JET, width);
}

static void implicit_dense(int32_t count, const sp_pair *in, sp_pair *out) { beside(count, in, out, 2, 2); }

/* T_xx, T_yy and T_zz. */
static void implicit_tensor(int32_t count, const sp_pair *in, sp_pair *out) { beside(count, in, out, 7, 1u << 1 | 1u << 3 | 1u << 6); }

struct sp_surface hostile_surface(int32_t kind, int32_t metric, uint32_t shape, struct hostility hostility) {
    static const sp_evaluate jets[2][3] = {{induced, dense, tensor}, {implicit, implicit_dense, implicit_tensor}};
    static const sp_evaluate sound[3][2] = {{globe_jet, globe_value}, {saddle_jet, saddle_value}, {bumpy_jet, bumpy_value}};
    present = hostility, noise = 0x9e3779b97f4a7c15ULL + shape;
    sound_jet = sound[shape % 3][0], sound_value = sound[shape % 3][1];
    return (struct sp_surface){jets[kind][metric],       kind ? implicit_value : value, kind,           metric,
                               {-__builtin_inf(), -1.5}, {__builtin_inf(), 1.5},        kind ? 19.7 : 0};
}
