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

sp_pair sp_metric_determinant(const struct sp_surface *surface, sp_pair *place, double scale) {
    const struct sp_kind *kind = sp_kind_of(surface);
    sp_pair chart[SP_CHART], metric[SP_METRIC_LARGEST];
    if (surface->kind == SP_IMPLICIT) sp_implicit_settle(surface, 1, place, scale);
    kind->charts(surface, 1, place, chart, metric);
    struct sp_form form = sp_metric_form(kind->components, chart, metric);
    return sp_select(form.e + form.g <= sp_splat(0.0), sp_splat(-1.0), form.e * form.g - form.f * form.f);
}
