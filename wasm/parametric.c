/* Parametric surfaces S(u,v): the compiled surface writes the chart itself. Knows the closed rectangle, not the path. MATH.md, "Charts". */
#include "chart.h"

static void parametric_charts(const struct sp_surface *surface, int32_t pair_count, const sp_pair *places, sp_pair *charts,
                              sp_pair *metrics) {
    (void)metrics;
    surface->jet(pair_count, places, charts);
}

static sp_pair clip(sp_pair x, double lower, double upper) {
    x = sp_select(x < sp_splat(lower), sp_splat(lower), x);
    return sp_select(x > sp_splat(upper), sp_splat(upper), x);
}

void sp_parametric_clip(const struct sp_surface *surface, int32_t pair_count, sp_pair *places) {
    for (int32_t k = 0; k < pair_count; k++)
        for (int j = 0; j < 2; j++)
            places[2 * k + j] = clip(places[2 * k + j], surface->lower[j], surface->upper[j]);
}

/* -Gamma(d, d)/2 of a step d: added to it, the path q + d follows the geodesic to second order; clipped to half of |d| in the metric,
 * beyond which the expansion says nothing. A degenerate metric gives 0. */
static inline __attribute__((always_inline)) void bend(const sp_pair *chart, const sp_pair d[2], sp_pair bent[2]) {
    struct sp_vector s_u = sp_load(chart + SP_CHART_1), s_v = sp_load(chart + SP_CHART_2);
    struct sp_vector second =
        sp_add(sp_scale(sp_load(chart + SP_CHART_11), d[0] * d[0]), sp_scale(sp_load(chart + SP_CHART_22), d[1] * d[1]));
    second = sp_add(second, sp_scale(sp_load(chart + SP_CHART_12), 2.0 * d[0] * d[1]));
    sp_pair e = sp_dot(s_u, s_u), f = sp_dot(s_u, s_v), g = sp_dot(s_v, s_v);
    sp_pair along_u = sp_dot(s_u, second), along_v = sp_dot(s_v, second), factor = -0.5 / (e * g - f * f);
    sp_pair u = factor * (g * along_u - f * along_v), v = factor * (e * along_v - f * along_u);
    sp_pair step = e * d[0] * d[0] + 2.0 * f * d[0] * d[1] + g * d[1] * d[1];
    sp_pair length = e * u * u + 2.0 * f * u * v + g * v * v;
    sp_mask too_long = 4.0 * length > step;
    if (sp_any(too_long)) {
        sp_pair limit = sp_select(too_long, 0.5 * sp_square_root(step / length), sp_splat(1.0));
        u *= limit, v *= limit;
    }
    sp_mask sane = u * u + v * v < sp_splat(__builtin_inf());
    bent[0] = sp_select(sane, u, sp_splat(0.0)), bent[1] = sp_select(sane, v, sp_splat(0.0));
}

int sp_parametric_move(const struct sp_surface *surface, int32_t pair_count, const sp_pair *places, const sp_pair *charts,
                       const sp_pair *steps, const sp_mask *straight, double scale, sp_pair *moved) {
    for (int32_t k = 0; k < pair_count; k++) {
        sp_pair step[2] = {scale * steps[2 * k], scale * steps[2 * k + 1]}, bent[2];
        bend(charts + SP_CHART * k, step, bent);
        sp_mask keep = straight ? straight[k] : (sp_mask){0, 0};
        for (int j = 0; j < 2; j++) {
            sp_pair to = places[2 * k + j] + sp_select(keep, step[j], step[j] + bent[j]);
            moved[2 * k + j] = clip(to, surface->lower[j], surface->upper[j]);
        }
    }
    return 1;
}

const struct sp_kind sp_parametric_kind = {SP_PARAMETRIC_INPUTS, 0, parametric_charts, sp_parametric_move};
