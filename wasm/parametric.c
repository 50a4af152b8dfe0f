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

/* Adds -Gamma(d, d)/2 to the step d, so that the path q + d follows the geodesic to second order; clipped to half of |d| in the metric,
 * beyond which the expansion says nothing. A degenerate metric leaves d alone. */
static void bend(const sp_pair *chart, sp_pair *u, sp_pair *v) {
    struct sp_vector s_u = sp_load(chart + SP_CHART_1), s_v = sp_load(chart + SP_CHART_2);
    struct sp_vector second = sp_add(sp_scale(sp_load(chart + SP_CHART_11), *u * *u), sp_scale(sp_load(chart + SP_CHART_22), *v * *v));
    second = sp_add(second, sp_scale(sp_load(chart + SP_CHART_12), 2.0 * *u * *v));
    sp_pair e = sp_dot(s_u, s_u), f = sp_dot(s_u, s_v), g = sp_dot(s_v, s_v);
    sp_pair along_u = sp_dot(s_u, second), along_v = sp_dot(s_v, second), factor = -0.5 / (e * g - f * f);
    sp_pair bend_u = factor * (g * along_u - f * along_v), bend_v = factor * (e * along_v - f * along_u);
    sp_pair step = e * *u * *u + 2.0 * f * *u * *v + g * *v * *v;
    sp_pair bent = e * bend_u * bend_u + 2.0 * f * bend_u * bend_v + g * bend_v * bend_v;
    sp_pair limit = sp_select(4.0 * bent > step, 0.5 * sp_square_root(step / bent), sp_splat(1.0));
    sp_mask sane = limit * (bend_u * bend_u + bend_v * bend_v) < sp_splat(__builtin_inf());
    *u += sp_select(sane, limit * bend_u, sp_splat(0.0));
    *v += sp_select(sane, limit * bend_v, sp_splat(0.0));
}

int sp_parametric_move(const struct sp_surface *surface, int32_t pair_count, const sp_pair *places, const sp_pair *charts,
                       const sp_pair *steps, const sp_mask *straight, double scale, sp_pair *moved) {
    for (int32_t k = 0; k < pair_count; k++) {
        sp_pair straight_u = scale * steps[2 * k], straight_v = scale * steps[2 * k + 1], u = straight_u, v = straight_v;
        bend(charts + SP_CHART * k, &u, &v);
        sp_mask keep = straight ? straight[k] : (sp_mask){0, 0};
        moved[2 * k] = places[2 * k] + sp_select(keep, straight_u, u);
        moved[2 * k + 1] = places[2 * k + 1] + sp_select(keep, straight_v, v);
    }
    sp_parametric_clip(surface, pair_count, moved);
    return 1;
}

const struct sp_kind sp_parametric_kind = {SP_PARAMETRIC_INPUTS, 0, parametric_charts, sp_parametric_move};
