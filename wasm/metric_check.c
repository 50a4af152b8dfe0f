/* Determinants along a path, and its length through every second node. Independent of how the path was found. MATH.md, "Checks". */
#include "metric_check.h"

static const double VANISHING = 1e-8;

/* Determinant of the first fundamental form at half steps along the pairs: of node k at 2k, in the middle between k and k + 1 at 2k + 1. -1
 * where the form is not even semidefinite. */
static sp_pair determinant_at(const struct sp_polyline *line, int32_t step, double scale) {
    int32_t k = step / 2, dimension = line->kind->dimension, components = line->kind->components;
    sp_pair place[3], between[SP_CHART + SP_METRIC_LARGEST];
    const sp_pair *chart = line->nodes.charts + SP_CHART * k, *metric = line->nodes.metrics + SP_METRIC_PARTS * components * k;
    if (step % 2) {
        for (int32_t j = 0; j < dimension; j++)
            place[j] = 0.5 * (line->nodes.places[dimension * k + j] + line->nodes.places[dimension * (k + 1) + j]);
        if (line->surface->kind == SP_IMPLICIT) sp_implicit_settle(line->surface, 1, place, scale);
        line->kind->charts(line->surface, 1, place, between, between + SP_CHART);
        chart = between, metric = between + SP_CHART;
    }
    struct sp_form form = sp_metric_form(components, chart, metric);
    sp_pair determinant = form.e * form.g - form.f * form.f;
    return sp_select(form.e + form.g <= sp_splat(0.0), sp_splat(-1.0), determinant);
}

/* The two halves meet in the middle node, or between the last two: there the step after is the one before, lanes exchanged. */
enum sp_status sp_metric_check(const struct sp_polyline *line, double scale) {
    int32_t last = 2 * line->fold.both + 1 + line->fold.odd;
    sp_pair zero = sp_splat(0.0), here = zero, after = zero;
    for (int32_t step = -1; step <= last && line->kind->components; step++) {
        sp_pair before = here;
        here = after, after = step < last ? determinant_at(line, step + 1, scale) : sp_swap(before);
        if (step < 0) continue;
        if (sp_any(here != here)) return SP_NOT_FINITE;
        /* At an end the metric may vanish in one direction, as at a pole. */
        if (sp_any(step == 0 ? here < zero : here <= zero)) return SP_SINGULAR_METRIC;
        if (step > 0 && sp_any((here < VANISHING * before) & (here < VANISHING * after))) return SP_SINGULAR_METRIC;
    }
    return SP_CONVERGED;
}

/* |B - A| by the trapezoidal rule, as the energy of degree 1 measures it. */
static double chord_length(const struct sp_polyline *line, int32_t from, int32_t to) {
    struct sp_fold fold = line->fold;
    int32_t components = line->kind->components, node[2] = {from, to};
    sp_pair chord[3], metric[SP_METRIC_COMPONENTS];
    double sum = 0;
    for (int32_t j = 0; j < 3; j++)
        chord[j] =
            sp_splat(sp_fold_get(fold, line->nodes.charts, SP_CHART, to, j) - sp_fold_get(fold, line->nodes.charts, SP_CHART, from, j));
    for (int i = 0; i < 2; i++) {
        for (int32_t c = 0; c < components; c++)
            metric[c] = sp_splat(sp_fold_get(fold, line->nodes.metrics, SP_METRIC_PARTS * components, node[i], c));
        sum += 0.5 * sp_square_root(sp_metric_product(components, metric, chord, chord))[0];
    }
    return sum;
}

double sp_metric_length_error(const struct sp_polyline *line) {
    double length[2] = {0, 0};
    int32_t last = line->fold.inner + 1;
    for (int32_t half = 0; half < 2; half++)
        for (int32_t i = 0; i < last; i += 1 + half)
            length[half] += chord_length(line, i, i + half + 1 < last ? i + half + 1 : last);
    double error = (length[0] > length[1] ? length[0] - length[1] : length[1] - length[0]) / 3, least = 4e-15 * length[0];
    return error > least ? error : least;
}
