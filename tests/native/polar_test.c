/* The chart around a pole of a tensor: against the change of coordinates by hand, its derivatives against finite differences, and the
 * plane, in which nothing is left of polar coordinates. */
#include "metric.h"
#include "polar.h"
#include "testing.h"

#include <math.h>

/* Of what differences by STEP leave out of numbers like 3/r^2, by r^-6: STEP^2 5!/6 times 3, and some. */
static const double STEP = 1e-5, TRUNCATION = 3e-8;

/* E, F, G = a + b sin(u + 2 v), none of them smooth at a pole: the chart must not mind. */
static void wave_jet(int32_t count, const sp_pair *in, sp_pair *out) {
    static const double WAVES[3][2] = {{3, 0.8}, {0.4, 0.5}, {2, -0.6}}, PARTS[6] = {0, 1, 2, 1, 2, 4};
    for (; count > 0; count--, in += 2, out += SP_PARAMETRIC_TENSOR_JET)
        for (int lane = 0; lane < 2; lane++)
            for (int c = 0; c < 3; c++)
                for (int part = 0; part < 6; part++) {
                    double phase = in[0][lane] + 2 * in[1][lane], b = WAVES[c][1];
                    double value = part == 0  ? WAVES[c][0] + b * sin(phase)
                                   : part < 3 ? PARTS[part] * b * cos(phase)
                                              : -PARTS[part] * b * sin(phase);
                    out[3 * part + c][lane] = value;
                }
}

/* 1, 0, u^2. */
static void plane_jet(int32_t count, const sp_pair *in, sp_pair *out) {
    for (; count > 0; count--, in += 2, out += SP_PARAMETRIC_TENSOR_JET) {
        for (int i = 0; i < SP_PARAMETRIC_TENSOR_JET; i++)
            out[i] = sp_splat(0.0);
        out[0] = sp_splat(1.0), out[2] = in[0] * in[0], out[5] = 2.0 * in[0], out[11] = sp_splat(2.0);
    }
}

static struct sp_polar polar_at(const struct sp_surface *whole, int32_t across, double edge, double side, double rate) {
    struct sp_polar polar = {*whole, whole, across, edge, side, 0.3, rate, 6.0, 1e-5};
    polar.surface.metric += SP_POLAR;
    return polar;
}

static void metric_at(const struct sp_polar *polar, double p, double q, double metric[18]) {
    sp_pair place[2] = {sp_splat(p), sp_splat(q)}, chart[SP_CHART], numbers[18];
    sp_kind_of(&polar->surface)->charts(&polar->surface, 1, place, chart, numbers);
    CHECK(chart[SP_CHART_X][0] == p && chart[SP_CHART_X + 1][0] == q && chart[SP_CHART_1][0] == 1 && chart[SP_CHART_2 + 1][0] == 1,
          "chart");
    for (int i = 0; i < 18; i++)
        metric[i] = numbers[i][0];
}

/* J' T J, J the derivatives of u and v by p and q. */
static void check_value(const struct sp_polar *polar, double p, double q, const double *metric) {
    double r = hypot(p, q), u[2], v[2];
    double away[2] = {polar->side * p / r, polar->side * q / r}, around[2] = {-q / (r * r * polar->rate), p / (r * r * polar->rate)};
    sp_pair place[2] = {sp_splat(p), sp_splat(q)}, at[2], jet[SP_PARAMETRIC_TENSOR_JET];
    sp_polar_leave(polar, 1, place, at);
    polar->whole->jet(1, at, jet);
    for (int i = 0; i < 2; i++)
        u[i] = polar->across ? around[i] : away[i], v[i] = polar->across ? away[i] : around[i];
    for (int c = 0; c < 3; c++) {
        int i = c / 2, j = (c + 1) / 2;
        double value = jet[0][0] * u[i] * u[j] + jet[1][0] * (u[i] * v[j] + v[i] * u[j]) + jet[2][0] * v[i] * v[j];
        CHECK(fabs(metric[c] - value) <= 1e-12 * (1 + fabs(value) + 1 / (r * r)), "component %d at %g %g: %.17g, not %.17g", c, p, q,
              metric[c], value);
    }
}

static void check_derivatives(const struct sp_polar *polar, double p, double q, const double *metric) {
    double before[2][18], after[2][18], scale = 1 + pow(hypot(p, q), -6); /* of the fourth derivatives */
    for (int i = 0; i < 2; i++) {
        metric_at(polar, p - (i ? 0 : STEP), q - (i ? STEP : 0), before[i]);
        metric_at(polar, p + (i ? 0 : STEP), q + (i ? STEP : 0), after[i]);
    }
    for (int c = 0; c < 3; c++)
        for (int i = 0; i < 2; i++) {
            double slope = (after[i][c] - before[i][c]) / (2 * STEP);
            CHECK(fabs(metric[3 * (1 + i) + c] - slope) <= TRUNCATION * scale, "derivative %d of component %d at %g %g: %g, not %g", i, c,
                  p, q, metric[3 * (1 + i) + c], slope);
            for (int j = i; j < 2; j++) {
                double bend = (after[i][3 * (1 + j) + c] - before[i][3 * (1 + j) + c]) / (2 * STEP), said = metric[3 * (3 + i + j) + c];
                CHECK(fabs(said - bend) <= TRUNCATION * scale, "derivative %d %d of component %d at %g %g: %g, not %g", i, j, c, p, q, said,
                      bend);
            }
        }
}

int main(void) {
    static const struct sp_surface wave = {wave_jet, NULL, SP_PARAMETRIC, SP_TENSOR, {-9, -9}, {9, 9}, 0};
    static const struct sp_surface plane = {plane_jet, NULL, SP_PARAMETRIC, SP_TENSOR, {0, 0}, {2, 6}, 0};
    uint64_t seed = 11;
    for (int i = 0; i < 400; i++) {
        struct sp_polar polar = polar_at(&wave, i & 1, i & 2 ? 1.5 : -0.7, i & 2 ? -1 : 1, i & 4 ? 1 : 0.6);
        double r = 0.3 + random_unit(&seed), angle = 6 * random_unit(&seed), metric[18];
        metric_at(&polar, r * cos(angle), r * sin(angle), metric);
        check_value(&polar, r * cos(angle), r * sin(angle), metric);
        check_derivatives(&polar, r * cos(angle), r * sin(angle), metric);
    }
    for (int i = 0; i < 100; i++) {
        struct sp_polar polar = polar_at(&plane, 0, 0, 1, 1);
        double r = i ? pow(10, -7 * random_unit(&seed)) : 0, angle = 6 * random_unit(&seed), metric[18];
        metric_at(&polar, r * cos(angle), r * sin(angle), metric);
        /* Rounding, once and twice over the least r, 1e-5. */
        for (int k = 0; k < 18; k++)
            CHECK(fabs(metric[k] - (k == 0 || k == 2)) <= 1e-15 * (k < 3   ? 1
                                                                   : k < 9 ? 1e5
                                                                           : 1e10),
                  "the plane at %g: number %d is %g", r, k, metric[k]);
    }
    return checks_failed();
}
