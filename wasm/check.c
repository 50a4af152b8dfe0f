/* Chords against the surface: sheets, singular curves, length. Independent of how the path was found. MATH.md, "Checks". */
#include "check.h"
#include "chord.h"
#include "metric_check.h"
#include "scalar.h"

/* Thresholds measured on the surfaces of the paper: MATH.md, "Checks". */
static const double PLAIN_SAGITTA = 0.05, PLAIN_DEPARTURE = 0.25;
enum { BLOCK = 16 };

/* f and its gradient in the middles of `count` pairs of chords from pair `first` on. */
static void look_at_middles(const struct sp_polyline *line, int32_t first, int32_t count, sp_pair *seen) {
    const sp_pair *places = line->nodes.places + 3 * first;
    sp_pair middles[3 * BLOCK];
    for (int32_t j = 0; j < 3 * count; j++)
        middles[j] = 0.5 * (places[j] + places[j + 3]);
    line->surface->value(count, middles, seen);
}

static inline __attribute__((always_inline)) struct sp_vector chord_of(const sp_pair *chart) {
    return sp_subtract(sp_load(chart + SP_CHART + SP_CHART_X), sp_load(chart + SP_CHART_X));
}

/* A pair of chords: its two ends, and their normals. */
struct chord_pair {
    const sp_pair *chart;
    struct sp_vector from, to, chord;
    sp_pair squared; /* |chord|^2 */
};

/* Normals less than SP_CHORD_COSINE apart, and the middle nearer to f = 0 than a small part of the chord, by f over its gradient. */
static inline __attribute__((always_inline)) sp_mask is_plain_implicit(const struct chord_pair *pair, const sp_pair *seen) {
    struct sp_vector gradient = sp_load(seen + 1);
    sp_pair cosine = sp_dot(pair->from, pair->to), squares = sp_dot(pair->from, pair->from) * sp_dot(pair->to, pair->to);
    sp_pair allowed = PLAIN_SAGITTA * PLAIN_SAGITTA * pair->squared * sp_dot(gradient, gradient);
    return (cosine > sp_splat(0.0)) & (cosine * cosine > SP_CHORD_COSINE * SP_CHORD_COSINE * squares) & (seen[0] * seen[0] < allowed);
}

/* |S_u u + S_v v - chord|^2 */
static inline __attribute__((always_inline)) sp_pair departure(const sp_pair *chart, const sp_pair step[2], struct sp_vector chord) {
    struct sp_vector velocity = sp_add(sp_scale(sp_load(chart + SP_CHART_1), step[0]), sp_scale(sp_load(chart + SP_CHART_2), step[1]));
    struct sp_vector aside = sp_subtract(velocity, chord);
    return sp_dot(aside, aside);
}

/* The normal does not turn over, and the parameter segment leaves and arrives as the chord runs. */
static inline __attribute__((always_inline)) sp_mask is_plain_parametric(const struct chord_pair *pair, const sp_pair *place) {
    const sp_pair *next = pair->chart + SP_CHART, step[2] = {place[2] - place[0], place[3] - place[1]};
    struct sp_vector b1 = sp_load(next + SP_CHART_1), b2 = sp_load(next + SP_CHART_2);
    sp_pair allowed = PLAIN_DEPARTURE * PLAIN_DEPARTURE * pair->squared;
    return (sp_dot(pair->to, pair->to) > SP_CHORD_DEGENERATE * sp_dot(b1, b1) * sp_dot(b2, b2)) &
           (sp_dot(pair->from, pair->to) > sp_splat(0.0)) & (departure(pair->chart, step, pair->chord) < allowed) &
           (departure(next, step, pair->chord) < allowed);
}

/* 1/|n|^2; zero where there is no normal. */
static inline __attribute__((always_inline)) sp_pair weight_of(struct sp_vector normal) {
    sp_pair zero = sp_splat(0.0), squared = sp_dot(normal, normal);
    return sp_select(squared > zero, 1.0 / squared, zero);
}

/* (a^2 + b^2)/12 of a chord's length is what the geodesic is longer, a and b the angles at its ends to fourth order: MATH.md. An end where
 * the surface has no finite derivatives counts for nothing. */
static inline __attribute__((always_inline)) void measure(const struct chord_pair *pair, sp_pair weight_from, sp_pair weight_to,
                                                          sp_mask counted, sp_pair *lengths, sp_pair *errors) {
    sp_pair zero = sp_splat(0.0), length = sp_square_root(pair->squared);
    sp_pair a = sp_dot(pair->chord, pair->from), b = sp_dot(pair->chord, pair->to);
    sp_pair error = (sp_larger(zero, a * a * weight_from) + sp_larger(zero, b * b * weight_to)) / length;
    *lengths += sp_select(counted, length, zero), *errors += sp_select(counted & (length > zero), error, zero);
}

/* Chords that are not plainly in order are looked at one by one. */
enum sp_status sp_check_chords(const struct sp_system *system, double scale, struct sp_chord_sums *sums) {
    const struct sp_polyline *line = &system->line;
    enum sp_status worst = SP_CONVERGED;
    int32_t chords = sp_fold_both(line->fold) + 1, implicit = line->surface->kind == SP_IMPLICIT;
    sp_pair seen[SP_IMPLICIT_VALUES * BLOCK], lengths = sp_splat(0.0), errors = lengths, weight_from, weight_to = lengths;
    struct chord_pair pair = {.to = sp_chart_normal(line->nodes.charts)};
    if (sums) weight_to = weight_of(pair.to);
    for (int32_t k = 0; k < chords; k++) {
        const sp_pair *chart = line->nodes.charts + SP_CHART * k;
        struct sp_vector chord = chord_of(chart);
        pair = (struct chord_pair){chart, pair.to, sp_chart_normal(chart + SP_CHART), chord, sp_dot(chord, chord)};
        if (implicit && k % BLOCK == 0) look_at_middles(line, k, chords - k < BLOCK ? chords - k : BLOCK, seen);
        sp_mask plain = implicit ? is_plain_implicit(&pair, seen + SP_IMPLICIT_VALUES * (k % BLOCK))
                                 : is_plain_parametric(&pair, line->nodes.places + 2 * k);
        for (int lane = 0; lane < 2 && sp_any(~plain); lane++) {
            if (plain[lane]) continue;
            enum sp_status status = sp_chord_check(system, lane ? line->fold.inner - k : k, scale);
            if (status < 0) return status;
            if (status > worst) worst = status;
        }
        if (!sums) continue;
        weight_from = weight_to, weight_to = weight_of(pair.to);
        /* For n even the last chord is its own mirror image. */
        measure(&pair, weight_from, weight_to, (sp_mask){-1, k < sp_fold_both(line->fold) || sp_fold_odd(line->fold) ? -1 : 0}, &lengths,
                &errors);
    }
    if (sums) *sums = (struct sp_chord_sums){lengths[0] + lengths[1], (errors[0] + errors[1]) / 12};
    enum sp_status metric = sp_metric_check(line, scale);
    return metric < 0 ? metric : worst;
}

/* A third of what the polyline through every second node is shorter. */
static double halving_error(const struct sp_polyline *line, double length) {
    double sum = 0, before[3], here[3];
    int32_t last = line->fold.inner + 1;
    for (int32_t i = 0; i <= last; i += i + 2 > last && i < last ? 1 : 2) {
        for (int32_t j = 0; j < 3; j++)
            here[j] = sp_fold_get(line->fold, line->nodes.charts, SP_CHART, i, j);
        sum += i ? distance_between(here, before) : 0;
        for (int j = 0; j < 3; j++)
            before[j] = here[j];
    }
    return (length - sum) / 3;
}

double sp_check_rounding(double length, double scale) { return length > 0 ? 4e-15 * length + 2.2e-16 * scale : 0; }

double sp_check_length_error(const struct sp_newton *newton, const struct sp_outcome *outcome, const struct sp_chord_sums *sums) {
    const struct sp_polyline *line = &newton->system.line;
    if (line->kind->components) return sp_metric_length_error(line, newton->size, 1);
    return larger(outcome->active ? halving_error(line, sums->length) : 0, sums->error);
}

double sp_check_unevenness(double energy, double length) { return smaller(energy / length - length, length); }
