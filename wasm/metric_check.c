/* Determinants along a path, and its length through every second node. Independent of how the path was found. MATH.md, "Checks". */
#include "metric_check.h"

static const double VANISHING = 1e-8;

/* The determinant of a form; what is not positive definite counts as -1, what is no number as NaN. */
static sp_pair determinant_of(struct sp_form form) {
    sp_pair determinant = form.e * form.g - form.f * form.f, trace = form.e + form.g;
    sp_pair sum = determinant + trace, checked = sp_select(sp_form_positive(form), determinant, sp_splat(-1.0));
    return sp_select(sum == sum, checked, sum);
}

static struct sp_form form_at(const struct sp_polyline *line, int32_t k) {
    int32_t components = line->kind->components;
    return sp_metric_form(components, line->nodes.charts + SP_CHART * k, line->nodes.metrics + SP_METRIC_PARTS * components * k);
}

/* In the middle between pairs k and k + 1. */
static sp_pair determinant_between(const struct sp_polyline *line, int32_t k, double scale) {
    int32_t dimension = line->kind->dimension;
    sp_pair place[3], chart[SP_CHART], metric[SP_METRIC_LARGEST];
    for (int32_t j = 0; j < dimension; j++)
        place[j] = 0.5 * (line->nodes.places[dimension * k + j] + line->nodes.places[dimension * (k + 1) + j]);
    if (line->surface->kind == SP_IMPLICIT) sp_implicit_settle(line->surface, 1, place, scale);
    line->kind->charts(line->surface, 1, place, chart, metric);
    return determinant_of(sp_metric_form(line->kind->components, chart, metric));
}

/* What a determinant between two others says. */
static enum sp_status judge(sp_pair before, sp_pair here, sp_pair after) {
    if (sp_any(here != here)) return SP_NOT_FINITE;
    if (sp_any(here <= sp_splat(0.0))) return SP_SINGULAR_METRIC;
    return sp_any((here < VANISHING * before) & (here < VANISHING * after)) ? SP_SINGULAR_METRIC : SP_CONVERGED;
}

/* At an end the metric may vanish in one direction, as at a pole, but neither in all nor be negative. */
static enum sp_status judge_end(struct sp_form form) {
    sp_pair determinant = form.e * form.g - form.f * form.f, trace = form.e + form.g;
    if (sp_any((trace != trace) | (determinant != determinant))) return SP_NOT_FINITE;
    return sp_any((determinant < sp_splat(0.0)) | (trace <= sp_splat(0.0))) ? SP_SINGULAR_METRIC : SP_CONVERGED;
}

enum sp_status sp_metric_check(const struct sp_polyline *line, double scale) {
    if (line->kind->components == 0) return SP_CONVERGED;
    int32_t both = line->fold.both;
    struct sp_form end = form_at(line, 0);
    sp_pair here = end.e * end.g - end.f * end.f, before = here;
    enum sp_status worst = judge_end(end);
    for (int32_t k = 0; k <= both; k++) {
        sp_pair middle = determinant_between(line, k, scale), next = determinant_of(form_at(line, k + 1));
        enum sp_status at_node = k ? judge(before, here, middle) : SP_CONVERGED, between = judge(here, middle, next);
        if (at_node < worst) worst = at_node;
        if (between < worst) worst = between;
        before = middle, here = next;
    }
    enum sp_status at_middle = line->fold.odd ? judge(before, here, sp_swap(before)) : SP_CONVERGED;
    return at_middle < worst ? at_middle : worst;
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
    double length = 0, halved = 0;
    int32_t last = line->fold.inner + 1;
    for (int32_t i = 0; i < last; i++)
        length += chord_length(line, i, i + 1);
    for (int32_t i = 0; i < last; i += 2)
        halved += chord_length(line, i, i + 2 < last ? i + 2 : last);
    double error = (length > halved ? length - halved : halved - length) / 3, least = 4e-15 * length;
    return error > least ? error : least;
}
