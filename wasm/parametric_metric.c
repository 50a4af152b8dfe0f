/* Parametric surfaces whose length is weighted by a density, or measured by a tensor E, F, G over u and v, with positions or without.
 * MATH.md, "Metrics". */
#include "metric.h"

enum { BLOCK = 32 };

/* Jets come as x y z phi, derivative by derivative: the order of charts and metrics. */
static void density_charts(const struct sp_surface *surface, int32_t pair_count, const sp_pair *places, sp_pair *charts, sp_pair *metrics) {
    sp_pair jets[SP_PARAMETRIC_DENSITY_JET * BLOCK];
    for (int32_t k = 0; k < pair_count; k += BLOCK) {
        int32_t count = pair_count - k < BLOCK ? pair_count - k : BLOCK;
        surface->jet(count, places + 2 * k, jets);
        for (int32_t i = 0; i < SP_METRIC_PARTS * count; i++) {
            sp_store(sp_load(jets + 4 * i), charts + 3 * (SP_METRIC_PARTS * k + i));
            metrics[SP_METRIC_PARTS * k + i] = jets[4 * i + 3];
        }
    }
}

void sp_flat_charts(int32_t pair_count, const sp_pair *places, sp_pair *charts) {
    for (int32_t k = 0; k < pair_count; k++) {
        sp_pair *chart = charts + SP_CHART * k;
        for (int j = 0; j < SP_CHART; j++)
            chart[j] = sp_splat(0.0);
        chart[SP_CHART_X] = places[2 * k], chart[SP_CHART_X + 1] = places[2 * k + 1];
        chart[SP_CHART_1] = chart[SP_CHART_2 + 1] = sp_splat(1.0);
    }
}

static void tensor_charts(const struct sp_surface *surface, int32_t pair_count, const sp_pair *places, sp_pair *charts, sp_pair *metrics) {
    surface->jet(pair_count, places, metrics);
    sp_flat_charts(pair_count, places, charts);
}

const struct sp_kind sp_parametric_density_kind = {SP_PARAMETRIC_INPUTS, 1, density_charts, sp_parametric_move};
/* Straight in u and v: a field that turns quickly bends a step further than the expansion along its geodesics is worth (on one of 100:1
 * steps along them took a third more iterations). */
const struct sp_kind sp_parametric_tensor_kind = {SP_PARAMETRIC_INPUTS, 3, tensor_charts, sp_straight_move};
