/* Implicit surfaces whose length is weighted by a density phi(x,y,z), or measured by a tensor T(x,y,z). MATH.md, "Metrics". */
#include "metric.h"

enum { BLOCK = 8, GRADIENT = 1, HESSIAN = 4 };

/* One component t(x,y,z) along the chart: t_a = grad t . B_a, t_ab = B_a' t'' B_b + grad t . S_ab. */
static void component_along(const sp_pair *chart, const sp_pair *jet, int32_t components, sp_pair *metric) {
    struct sp_vector b1 = sp_load(chart + SP_CHART_1), b2 = sp_load(chart + SP_CHART_2), gradient = sp_load(jet + GRADIENT);
    struct sp_vector second_1 = sp_hessian_times(jet + HESSIAN, b1), second_2 = sp_hessian_times(jet + HESSIAN, b2);
    metric[SP_METRIC_T * components] = jet[0];
    metric[SP_METRIC_T1 * components] = sp_dot(gradient, b1);
    metric[SP_METRIC_T2 * components] = sp_dot(gradient, b2);
    metric[SP_METRIC_T11 * components] = sp_dot(b1, second_1) + sp_dot(gradient, sp_load(chart + SP_CHART_11));
    metric[SP_METRIC_T12 * components] = sp_dot(b2, second_1) + sp_dot(gradient, sp_load(chart + SP_CHART_12));
    metric[SP_METRIC_T22 * components] = sp_dot(b2, second_2) + sp_dot(gradient, sp_load(chart + SP_CHART_22));
}

/* Number j of those that the jet holds side by side, with its derivatives. */
static void gather(const sp_pair *jet, int32_t outputs, int32_t j, sp_pair *gathered) {
    for (int32_t i = 0; i < SP_IMPLICIT_JET; i++)
        gathered[i] = jet[outputs * i + j];
}

static void metric_charts(const struct sp_surface *surface, int32_t pair_count, const sp_pair *places, sp_pair *charts, sp_pair *metrics) {
    int32_t components = sp_kind_of(surface)->components, outputs = components + 1;
    sp_pair jets[SP_IMPLICIT_TENSOR_JET * BLOCK], one[SP_IMPLICIT_JET];
    for (int32_t k = 0; k < pair_count; k++) {
        if (k % BLOCK == 0) surface->jet(pair_count - k < BLOCK ? pair_count - k : BLOCK, places + 3 * k, jets);
        const sp_pair *jet = jets + SP_IMPLICIT_JET * outputs * (k % BLOCK);
        gather(jet, outputs, 0, one);
        sp_implicit_chart(places + 3 * k, one, charts + SP_CHART * k);
        for (int32_t c = 0; c < components; c++) {
            gather(jet, outputs, 1 + c, one);
            component_along(charts + SP_CHART * k, one, components, metrics + SP_METRIC_PARTS * components * k + c);
        }
    }
}

const struct sp_kind sp_implicit_density_kind = {SP_IMPLICIT_INPUTS, 1, metric_charts, sp_implicit_move};
const struct sp_kind sp_implicit_tensor_kind = {SP_IMPLICIT_INPUTS, 6, metric_charts, sp_implicit_move};
