/* Tensors at a node: first fundamental form and connection of the metric in use. MATH.md, "Metrics". */
#include "metric.h"

struct sp_vector sp_metric_times(int32_t components, const sp_pair *t, struct sp_vector v) {
    if (components == 1) return sp_scale(v, t[0]);
    struct sp_vector flat = {t[0] * v.x + t[1] * v.y, t[1] * v.x + t[2] * v.y, sp_splat(0.0)};
    if (components == 3) return flat;
    return (struct sp_vector){flat.x + t[3] * v.z, flat.y + t[4] * v.z, t[3] * v.x + t[4] * v.y + t[5] * v.z};
}

struct sp_form sp_metric_form(int32_t components, const sp_pair *chart, const sp_pair *metric) {
    struct sp_vector b1 = sp_load(chart + SP_CHART_1), b2 = sp_load(chart + SP_CHART_2), t1 = sp_metric_times(components, metric, b1);
    return (struct sp_form){sp_dot(b1, t1), sp_dot(b2, t1), sp_dot(b2, sp_metric_times(components, metric, b2))};
}

/* Gamma_c,ab = S_ab'T B_c + (B_b'T_a B_c + B_a'T_b B_c - B_a'T_c B_b)/2: differentiate g_ab = B_a'T B_b. */
struct sp_connection sp_metric_connection(int32_t components, const sp_pair *chart, const sp_pair *metric) {
    struct sp_connection at = {.form = sp_metric_form(components, chart, metric)};
    struct sp_form along_1 = sp_metric_form(components, chart, metric + SP_METRIC_T1 * components);
    struct sp_form along_2 = sp_metric_form(components, chart, metric + SP_METRIC_T2 * components);
    sp_pair slopes[2][3] = {{0.5 * along_1.e, 0.5 * along_2.e, along_2.f - 0.5 * along_1.g},
                            {along_1.f - 0.5 * along_2.e, 0.5 * along_1.g, 0.5 * along_2.g}};
    for (int c = 0; c < 2; c++) {
        struct sp_vector lowered = sp_metric_times(components, metric, sp_load(chart + (c ? SP_CHART_2 : SP_CHART_1)));
        for (int ab = 0; ab < 3; ab++)
            at.symbols[c][ab] = sp_dot(lowered, sp_load(chart + SP_CHART_11 + 3 * ab)) + slopes[c][ab];
    }
    return at;
}

void sp_metric_bend(int32_t components, const sp_pair *chart, const sp_pair *metric, sp_pair *u, sp_pair *v) {
    struct sp_connection at = sp_metric_connection(components, chart, metric);
    sp_pair along[2];
    for (int c = 0; c < 2; c++)
        along[c] = at.symbols[c][0] * *u * *u + 2.0 * at.symbols[c][1] * *u * *v + at.symbols[c][2] * *v * *v;
    sp_bend_step((struct sp_bend){at.form.e, at.form.f, at.form.g, along[0], along[1]}, u, v);
}
