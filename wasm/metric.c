/* Tensors at a node: products and the first fundamental form of the metric in use. MATH.md, "Metrics". */
#include "metric.h"

sp_pair sp_metric_product(int32_t components, const sp_pair *t, const sp_pair *a, const sp_pair *b) {
    if (components <= 1) return (components ? t[0] : sp_splat(1.0)) * (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
    sp_pair product = (t[0] * a[0] + t[1] * a[1]) * b[0] + (t[1] * a[0] + t[2] * a[1]) * b[1];
    if (components == 3) return product;
    return product + t[3] * (a[0] * b[2] + a[2] * b[0]) + t[4] * (a[1] * b[2] + a[2] * b[1]) + t[5] * a[2] * b[2];
}

struct sp_form sp_metric_form(int32_t components, const sp_pair *chart, const sp_pair *metric) {
    sp_pair products[3];
    for (int ab = 0; ab < 3; ab++)
        products[ab] =
            sp_metric_product(components, metric, chart + (ab < 2 ? SP_CHART_1 : SP_CHART_2), chart + (ab ? SP_CHART_2 : SP_CHART_1));
    return (struct sp_form){products[0], products[1], products[2]};
}

sp_pair sp_geometry_raise(const struct sp_geometry *geometry, const sp_pair x[2], const sp_pair y[2]) {
    struct sp_form form = geometry->form;
    return ((form.g * x[0] - form.f * x[1]) * y[0] + (form.e * x[1] - form.f * x[0]) * y[1]) / geometry->determinant;
}

static sp_pair tensor_determinant(int32_t components, const sp_pair *t) {
    if (components == 1) return t[0] * t[0] * t[0];
    return t[5] * (t[0] * t[2] - t[1] * t[1]) + t[4] * (t[1] * t[3] - t[0] * t[4]) + t[3] * (t[1] * t[4] - t[2] * t[3]);
}

/* What bending in space adds to the curvature times the determinant: (S_11.N S_22.N - (S_12.N)^2)/(N' T^-1 N), N = B_1 x B_2. Apart from
 * the rest, because beside a pole the tangent parts of S_ab are large and cancel. */
static sp_pair bending(int32_t components, const sp_pair *chart, const sp_pair *t, sp_pair determinant) {
    struct sp_vector normal = sp_chart_normal(chart);
    sp_pair b[3];
    if (components == 3) return sp_splat(0.0);
    for (int ab = 0; ab < 3; ab++)
        b[ab] = sp_dot(normal, sp_load(chart + SP_CHART_11 + 3 * ab));
    return (b[0] * b[2] - b[1] * b[1]) * tensor_determinant(components, t) / determinant;
}

/* Gamma_c,ab = B_c'T S_ab + (B_c'T_a B_b + B_c'T_b B_a - B_a'T_c B_b)/2. What T's slopes add to it and to the curvature is apart; third
 * derivatives of the chart cancel in the curvature. */
static void find_geometry(int32_t components, const sp_pair *chart, const sp_pair *metric, struct sp_geometry *geometry) {
    sp_pair straight[3][2], turn[3][2], sum[3][2];
    const sp_pair *base[2] = {chart + SP_CHART_1, chart + SP_CHART_2}, *second = chart + SP_CHART_11;
    const sp_pair *slope[2] = {metric + components, metric + 2 * components}, *change = metric + SP_METRIC_T11 * components;
    for (int ab = 0; ab < 3; ab++)
        for (int c = 0; c < 2; c++) {
            int a = ab / 2, b = (ab + 1) / 2;
            straight[ab][c] = sp_metric_product(components, metric, base[c], second + 3 * ab);
            turn[ab][c] = 0.5 * (sp_metric_product(components, slope[a], base[c], base[b]) +
                                 sp_metric_product(components, slope[b], base[c], base[a]) -
                                 sp_metric_product(components, slope[c], base[a], base[b]));
            geometry->gamma[ab][c] = sum[ab][c] = straight[ab][c] + turn[ab][c];
        }
    struct sp_form form = geometry->form = sp_metric_form(components, chart, metric);
    sp_pair determinant = geometry->determinant = form.e * form.g - form.f * form.f;
    sp_pair both[2] = {straight[1][0] + sum[1][0], straight[1][1] + sum[1][1]};
    sp_pair curving = bending(components, chart, metric, determinant) + sp_geometry_raise(geometry, turn[1], both) -
                      sp_geometry_raise(geometry, turn[0], sum[2]) - sp_geometry_raise(geometry, straight[0], turn[2]);
    for (int a = 0; a < 2; a++) {
        const sp_pair *own = base[a], *other = base[1 - a];
        curving += sp_metric_product(components, slope[1 - a], second + 6 * a, other) -
                   sp_metric_product(components, slope[1 - a], second + 3, own) -
                   0.5 * sp_metric_product(components, change + 2 * (1 - a) * components, own, own);
    }
    curving += sp_metric_product(components, change + components, base[0], base[1]);
    geometry->curvature = curving / determinant;
}

void sp_metric_point(const struct sp_surface *surface, const sp_pair *place, struct sp_point *point) {
    const struct sp_kind *kind = sp_kind_of(surface);
    for (int part = 0; part < SP_METRIC_PARTS; part++)
        point->metric[part] = sp_splat(part == SP_METRIC_T);
    kind->charts(surface, 1, place, point->chart, point->metric);
    point->components = kind->components ? kind->components : 1;
    find_geometry(point->components, point->chart, point->metric, &point->geometry);
}

sp_pair sp_metric_determinant(const struct sp_surface *surface, sp_pair *place, double scale) {
    const struct sp_kind *kind = sp_kind_of(surface);
    sp_pair chart[SP_CHART], metric[SP_METRIC_LARGEST];
    if (surface->kind == SP_IMPLICIT) sp_implicit_settle(surface, 1, place, scale);
    kind->charts(surface, 1, place, chart, metric);
    struct sp_form form = sp_metric_form(kind->components, chart, metric);
    return sp_select(form.e + form.g <= sp_splat(0.0), sp_splat(-1.0), form.e * form.g - form.f * form.f);
}
