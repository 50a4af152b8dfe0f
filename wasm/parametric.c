/* Parametric surfaces S(u,v): the compiled surface writes the chart itself. Knows the closed rectangle, not the path. MATH.md, "Charts". */
#include "chart.h"

static void parametric_charts(const struct sp_surface *surface, int32_t pair_count, const sp_pair *places, sp_pair *charts,
                              sp_pair *metrics) {
    (void)metrics;
    surface->jet(pair_count, places, charts);
}

/* Into the range of coordinate j; notes where it touches a wall. */
static inline __attribute__((always_inline)) sp_pair clip(const struct sp_surface *surface, int j, sp_pair x, sp_mask *touching) {
    sp_pair lower = sp_splat(surface->lower[j]), upper = sp_splat(surface->upper[j]);
    *touching |= (x <= lower) | (x >= upper);
    return sp_smaller(sp_larger(x, lower), upper);
}

int sp_parametric_clip(const struct sp_surface *surface, int32_t pair_count, sp_pair *places) {
    sp_mask touching = {0, 0};
    for (int32_t k = 0; k < pair_count; k++, places += 2)
        places[0] = clip(surface, 0, places[0], &touching), places[1] = clip(surface, 1, places[1], &touching);
    return sp_any(touching);
}

/* -Gamma(d, d)/2 of a step d: added to it, the path q + d follows the geodesic to second order; clipped to half of |d| in the metric,
 * beyond which the expansion says nothing. A degenerate metric gives 0. */
static inline __attribute__((always_inline)) void bend(const sp_pair *chart, const sp_pair d[2], sp_pair bent[2]) {
    struct sp_vector s_u = sp_load(chart + SP_CHART_1), s_v = sp_load(chart + SP_CHART_2);
    sp_pair uu = d[0] * d[0], uv = 2.0 * d[0] * d[1], vv = d[1] * d[1];
    struct sp_vector second = sp_add(sp_scale(sp_load(chart + SP_CHART_11), uu), sp_scale(sp_load(chart + SP_CHART_22), vv));
    second = sp_add(second, sp_scale(sp_load(chart + SP_CHART_12), uv));
    sp_pair e = sp_dot(s_u, s_u), f = sp_dot(s_u, s_v), g = sp_dot(s_v, s_v);
    sp_pair along_u = sp_dot(s_u, second), along_v = sp_dot(s_v, second), factor = -0.5 / (e * g - f * f);
    sp_pair u = factor * (g * along_u - f * along_v), v = factor * (e * along_v - f * along_u);
    sp_pair step = e * uu + f * uv + g * vv;
    sp_pair length = -0.5 * (u * along_u + v * along_v); /* of (u, v), squared: the metric times it is -along/2 */
    sp_mask short_enough = 4.0 * length <= step;
    if (sp_any(~short_enough)) {
        sp_pair limit = sp_select(short_enough, sp_splat(1.0), 0.5 * sp_square_root(step / length));
        u *= limit, v *= limit;
        sp_mask sane = u * u + v * v < sp_splat(__builtin_inf());
        u = sp_select(sane, u, sp_splat(0.0)), v = sp_select(sane, v, sp_splat(0.0));
    }
    bent[0] = u, bent[1] = v;
}

int sp_straight_move(const struct sp_surface *surface, int32_t pair_count, const sp_pair *places, const sp_pair *charts,
                     const sp_pair *steps, const sp_mask *straight, double scale, sp_pair *moved) {
    (void)charts, (void)straight;
    for (int32_t j = 0; j < 2 * pair_count; j++)
        moved[j] = places[j] + scale * steps[j];
    return sp_parametric_clip(surface, pair_count, moved) ? 2 : 1;
}

int sp_parametric_move(const struct sp_surface *surface, int32_t pair_count, const sp_pair *places, const sp_pair *charts,
                       const sp_pair *steps, const sp_mask *straight, double scale, sp_pair *moved) {
    sp_mask touching = {0, 0};
    if (!straight) return sp_straight_move(surface, pair_count, places, charts, steps, straight, scale, moved);
    for (int32_t k = 0; k < pair_count; k++, places += 2, moved += 2) {
        sp_pair step[2] = {scale * steps[2 * k], scale * steps[2 * k + 1]}, bent[2];
        bend(charts + SP_CHART * k, step, bent);
        moved[0] = clip(surface, 0, places[0] + sp_select(straight[k], step[0], step[0] + bent[0]), &touching);
        moved[1] = clip(surface, 1, places[1] + sp_select(straight[k], step[1], step[1] + bent[1]), &touching);
    }
    return sp_any(touching) ? 2 : 1;
}

const struct sp_kind sp_parametric_kind = {SP_PARAMETRIC_INPUTS, 0, parametric_charts, sp_parametric_move};
