/* Determinants along a path, and its length through every second node. Independent of how the path was found. MATH.md, "Checks". */
#include "metric_check.h"
#include "check.h"
#include "scalar.h"

static const double VANISHING = 1e-8;
/* A determinant that is nothing is less than this part of what it is so far away, in parts of the chord; one that is only small there is
 * not. */
static const double BESIDE = 1e-3, FALLS = 1e-2;
enum { SEARCH_ROUNDS = 40 };
/* Middles differ by more than this part of the length only where the metric changes between nodes that do not see it: else, as the nodes
 * are at rest, the trapezoidal rule is much better than that. */
static const double HIDDEN = 0.1;

/* The determinant at t of the way from pair k to k + 1. */
static sp_pair determinant_at(const struct sp_polyline *line, int32_t k, sp_pair t, double scale) {
    int32_t dimension = line->kind->dimension;
    const sp_pair *from = line->nodes.places + dimension * k, *to = from + dimension;
    sp_pair place[3];
    for (int32_t j = 0; j < dimension; j++)
        place[j] = from[j] + t * (to[j] - from[j]);
    return sp_metric_determinant(line->surface, place, scale);
}

/* The smallest determinant between pairs k and k + 1, if it has one minimum there; infinite where it is not falling to nothing. */
static sp_pair smallest_between(const struct sp_polyline *line, int32_t k, double scale) {
    sp_pair from = sp_splat(0.0), third = sp_splat(1.0 / 3.0), least = from;
    for (int round = 0; round < SEARCH_ROUNDS; round++, third *= 2.0 / 3.0) {
        sp_pair first = determinant_at(line, k, from + third, scale), second = determinant_at(line, k, from + 2.0 * third, scale);
        least = sp_select(first < second, first, second);
        from = sp_select(first < second, from, from + third);
    }
    sp_pair before = determinant_at(line, k, from - BESIDE, scale), after = determinant_at(line, k, from + BESIDE, scale);
    return sp_select((FALLS * before <= least) | (FALLS * after <= least), sp_splat(__builtin_inf()), least);
}

/* Whether the determinant comes down to nothing around a half step where it is smallest: no node need be near enough to see it. */
static int vanishes(const struct sp_polyline *line, int32_t step, sp_pair before, sp_pair here, sp_pair after, double scale) {
    sp_mask lowest = (here <= before) & (here <= after) & ((here < 0.5 * before) | (here < 0.5 * after));
    for (int32_t k = (step - 1) / 2; k <= step / 2 && k <= sp_fold_both(line->fold) && sp_any(lowest); k++) {
        sp_pair least = smallest_between(line, k, scale);
        if (sp_any(lowest & (least <= VANISHING * before) & (least <= VANISHING * after))) return 1;
    }
    return 0;
}

/* Half steps along the pairs: node k at 2k, the middle between k and k + 1 at 2k + 1. The two halves meet in the middle node, or between
 * the last two: there the step after is the one before, lanes exchanged. */
enum sp_status sp_metric_check(const struct sp_polyline *line, double scale) {
    int32_t last = 2 * sp_fold_both(line->fold) + 1 + sp_fold_odd(line->fold);
    sp_pair zero = sp_splat(0.0), here = zero, after = zero;
    for (int32_t step = -1; step <= last && line->kind->components; step++) {
        int32_t next = step + 1, k = next < last ? next / 2 : (last - 1) / 2;
        sp_pair before = here;
        here = after;
        after = step < last ? determinant_at(line, k, sp_splat(0.5 * (next - 2 * k)), scale) : sp_swap(before);
        if (step < 0) continue;
        if (sp_any(here != here)) return SP_NOT_FINITE;
        /* At an end the metric may vanish in one direction, as at a pole. */
        if (sp_any(step == 0 ? here < zero : here <= zero)) return SP_SINGULAR_METRIC;
        if (step > 0 && vanishes(line, step, before, here, after, scale)) return SP_SINGULAR_METRIC;
    }
    return SP_CONVERGED;
}

/* |B - A| by the trapezoidal rule. */
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

/* |B - A| of all chords, each by the metric in its middle: what nodes on both sides of a wall do not see. */
static double middle_length(const struct sp_polyline *line) {
    int32_t components = line->kind->components, dimension = line->kind->dimension;
    sp_pair sum = sp_splat(0.0), place[3], at[SP_CHART], metric[SP_METRIC_LARGEST], chord[3];
    for (int32_t k = 0; k <= sp_fold_both(line->fold); k++) {
        const sp_pair *chart = line->nodes.charts + SP_CHART * k, *from = line->nodes.places + dimension * k;
        for (int32_t j = 0; j < 3; j++)
            chord[j] = chart[SP_CHART + j] - chart[j], place[j] = j < dimension ? 0.5 * (from[j] + from[dimension + j]) : sum;
        line->kind->charts(line->surface, 1, place, at, metric);
        /* For n even the last chord is its own mirror image. */
        sp_mask counted = {-1, k < sp_fold_both(line->fold) || sp_fold_odd(line->fold) ? -1 : 0};
        sum += sp_select(counted, sp_square_root(sp_metric_product(components, metric, chord, chord)), sp_splat(0.0));
    }
    return sum[0] + sum[1];
}

double sp_metric_length_error(const struct sp_polyline *line, double size, int at_rest) {
    double length[2] = {0, 0}, squares = 0;
    int32_t last = line->fold.inner + 1;
    for (int32_t half = 0; half < 2; half++)
        for (int32_t i = 0; i < last; i += 1 + half) {
            double chord = chord_length(line, i, i + half + 1 < last ? i + half + 1 : last);
            length[half] += chord, squares += half ? 0 : chord * chord;
        }
    double bent = absolute(length[0] - length[1]) / 3, hidden = absolute(length[0] - middle_length(line)) * (2.0 / 3.0),
           error = larger(bent, sp_check_rounding(length[0], size));
    /* Nodes at rest that see the metric are passed at even speed. */
    if (at_rest && length[0] > 0) error = larger(error, last * squares / length[0] - length[0]);
    return hidden > HIDDEN * length[0] ? larger(error, hidden) : error;
}
