/* Chords against the surface: sheets, singular curves, length. Independent of how the path was found. MATH.md, "Checks". */
#include "check.h"
#include "energy.h"
#include "metric_check.h"
#include "normal.h"

/* Thresholds measured on the surfaces of the paper: MATH.md, "Checks". */
static const double LEAST_COSINE = 0.2, LARGEST_SAGITTA = 0.35, LARGEST_STRETCH = 2, VANISHING = 1e-8, DEGENERATE = 1e-24;
/* Beyond a crease, and on it, where the derivatives of max and its like are means of both sides. */
static const double NEAR_CREASE = 1e-6, SMOOTH_COSINE = 0.9;
static const double PLAIN_SAGITTA = 0.05, PLAIN_DEPARTURE = 0.25;
enum { BISECTIONS = 60, BLOCK = 16 };

/* Two neighbouring nodes, scalar: their places, positions and normals. */
struct chord {
    double place[2][3], at[2][3], normal[2][3];
};

static double root(double x) { return sp_square_root(sp_splat(x))[0]; }
static double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
static double distance(const double a[3], const double b[3]) {
    double d[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    return root(dot(d, d));
}

static void read_node(const struct sp_polyline *line, int32_t i, struct chord *chord, int end) {
    int32_t pair = sp_fold_pair(line->fold, i);
    int lane = sp_fold_lane(line->fold, i), dimension = line->kind->dimension;
    const sp_pair *chart = line->nodes.charts + SP_CHART * pair;
    struct sp_vector normal = sp_chart_normal(chart);
    for (int j = 0; j < dimension; j++)
        chord->place[end][j] = line->nodes.places[dimension * pair + j][lane];
    for (int j = 0; j < 3; j++)
        chord->at[end][j] = chart[j][lane];
    chord->normal[end][0] = normal.x[lane], chord->normal[end][1] = normal.y[lane], chord->normal[end][2] = normal.z[lane];
}

/* Puts the middle of a chord onto f = 0, its normal with it. */
static int halve(const struct sp_polyline *line, const struct chord *chord, double scale, double at[3], double normal[3]) {
    sp_pair middle[3], seen[SP_IMPLICIT_VALUES];
    for (int j = 0; j < 3; j++)
        middle[j] = sp_splat(0.5 * (chord->at[0][j] + chord->at[1][j]));
    if (!sp_implicit_settle(line->surface, 1, middle, scale)) return 0;
    line->surface->value(1, middle, seen);
    for (int j = 0; j < 3; j++)
        at[j] = middle[j][0], normal[j] = seen[1 + j][0];
    return 1;
}

static double cosine_of(const struct chord *chord) {
    const double *a = chord->normal[0], *b = chord->normal[1];
    return dot(a, b) / root(dot(a, a) * dot(b, b));
}

/* Whether the normals differ however near the two ends come to each other on the surface: a crease between them. On two sheets they stay
 * apart. */
static int spans_crease(const struct sp_polyline *line, struct chord chord, double scale) {
    double near = NEAR_CREASE * distance(chord.at[0], chord.at[1]) + 1e-14 * scale;
    for (int i = 0; i < BISECTIONS; i++) {
        struct chord halves[2] = {chord, chord};
        if (!halve(line, &chord, scale, halves[0].at[1], halves[0].normal[1])) return 0;
        for (int j = 0; j < 3; j++)
            halves[1].at[0][j] = halves[0].at[1][j], halves[1].normal[0][j] = halves[0].normal[1][j];
        chord = halves[cosine_of(halves + 1) < cosine_of(halves)];
        if (!(cosine_of(&chord) < SMOOTH_COSINE)) return 0;
    }
    return distance(chord.at[0], chord.at[1]) <= near;
}

static enum sp_status check_implicit(const struct sp_polyline *line, const struct chord *chord, double scale) {
    double length = distance(chord->at[0], chord->at[1]), half[3], settled[3], normal[3];
    for (int j = 0; j < 3; j++)
        half[j] = 0.5 * (chord->at[0][j] + chord->at[1][j]);
    if (!(cosine_of(chord) >= LEAST_COSINE)) return spans_crease(line, *chord, scale) ? SP_TOLERANCE_NOT_MET : SP_SHEET_JUMP;
    if (!halve(line, chord, scale, settled, normal)) return SP_SHEET_JUMP;
    return distance(half, settled) <= LARGEST_SAGITTA * length + 1e-14 * scale ? SP_CONVERGED : SP_SHEET_JUMP;
}

/* The normal turns over between two nodes: is it zero where it does, or at one of them? */
static enum sp_status check_fold(const struct sp_polyline *line, const struct chord *chord) {
    struct sp_turn turn;
    if (!sp_normal_turn(line->surface, chord->place[0], chord->place[1], BISECTIONS, &turn)) return SP_STALLED;
    for (int end = 0; end < 2; end++) {
        double squared = dot(chord->normal[end], chord->normal[end]);
        if (squared < turn.least) turn.least = squared;
    }
    return root(turn.least) <= VANISHING * root(turn.largest) ? SP_SINGULAR_METRIC : SP_STALLED;
}

/* |S_u u + S_v v|^2 in one lane of a chart. */
static double chart_speed_squared(const sp_pair *chart, int lane, double u, double v) {
    double velocity[3];
    for (int j = 0; j < 3; j++)
        velocity[j] = chart[SP_CHART_1 + j][lane] * u + chart[SP_CHART_2 + j][lane] * v;
    return dot(velocity, velocity);
}

static double speed_squared(const struct sp_polyline *line, int32_t i, double u, double v) {
    return chart_speed_squared(line->nodes.charts + SP_CHART * sp_fold_pair(line->fold, i), sp_fold_lane(line->fold, i), u, v);
}

/* S_u and S_v are parallel, up to rounding, whatever the units of u and v; at the ends of a path (a pole) this is harmless. */
static int is_degenerate(const struct sp_polyline *line, int32_t i, const struct chord *chord) {
    double e = speed_squared(line, i, 1, 0), g = speed_squared(line, i, 0, 1);
    return i > 0 && !(dot(chord->normal[0], chord->normal[0]) > DEGENERATE * e * g);
}

/* The middle of the parameter segment must be near the middle of the chord, and the segment about as long as the chord: else it goes around
 * somewhere. */
static enum sp_status check_parametric(const struct sp_polyline *line, int32_t i, const struct chord *chord, double scale) {
    if (is_degenerate(line, i, chord)) return SP_SINGULAR_METRIC;
    const double(*normal)[3] = chord->normal;
    int at_pole =
        (i == 0 && sp_normal_is_nothing(normal[0], normal[1])) || (i == line->fold.inner && sp_normal_is_nothing(normal[1], normal[0]));
    if (!at_pole && dot(chord->normal[0], chord->normal[1]) < 0) return check_fold(line, chord);
    double u = chord->place[1][0] - chord->place[0][0], v = chord->place[1][1] - chord->place[0][1], half[3], middle[3];
    sp_pair place[2], chart[SP_CHART], metric[SP_METRIC_LARGEST];
    for (int j = 0; j < 2; j++)
        place[j] = sp_splat(0.5 * (chord->place[0][j] + chord->place[1][j]));
    line->kind->charts(line->surface, 1, place, chart, metric);
    for (int j = 0; j < 3; j++)
        half[j] = 0.5 * (chord->at[0][j] + chord->at[1][j]), middle[j] = chart[j][0];
    double length = distance(chord->at[0], chord->at[1]), rounding = 1e-14 * scale;
    /* At the path's ends the speed may be infinite: that of the middle stands for it. */
    double mid = root(chart_speed_squared(chart, 0, u, v)), first = i > 0 ? root(speed_squared(line, i, u, v)) : mid,
           last = i < line->fold.inner ? root(speed_squared(line, i + 1, u, v)) : mid, along = (first + 4 * mid + last) / 6;
    if (!(distance(half, middle) - distance(half, middle) == 0)) return SP_NOT_FINITE;
    if (distance(half, middle) > LARGEST_SAGITTA * length + rounding || along > LARGEST_STRETCH * length + rounding) return SP_STALLED;
    return SP_CONVERGED;
}

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

/* Normals less than LEAST_COSINE apart, and the middle nearer to f = 0 than a small part of the chord, by f over its gradient. */
static inline __attribute__((always_inline)) sp_mask is_plain_implicit(const struct chord_pair *pair, const sp_pair *seen) {
    struct sp_vector gradient = sp_load(seen + 1);
    sp_pair cosine = sp_dot(pair->from, pair->to), squares = sp_dot(pair->from, pair->from) * sp_dot(pair->to, pair->to);
    sp_pair allowed = PLAIN_SAGITTA * PLAIN_SAGITTA * pair->squared * sp_dot(gradient, gradient);
    return (cosine > sp_splat(0.0)) & (cosine * cosine > LEAST_COSINE * LEAST_COSINE * squares) & (seen[0] * seen[0] < allowed);
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
    return (sp_dot(pair->to, pair->to) > DEGENERATE * sp_dot(b1, b1) * sp_dot(b2, b2)) & (sp_dot(pair->from, pair->to) > sp_splat(0.0)) &
           (departure(pair->chart, step, pair->chord) < allowed) & (departure(next, step, pair->chord) < allowed);
}

/* Chord i alone. */
static enum sp_status check_chord(const struct sp_polyline *line, int32_t i, double scale) {
    struct chord chord;
    read_node(line, i, &chord, 0), read_node(line, i + 1, &chord, 1);
    return line->surface->kind == SP_IMPLICIT ? check_implicit(line, &chord, scale) : check_parametric(line, i, &chord, scale);
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
enum sp_status sp_check_chords(const struct sp_polyline *line, double scale, struct sp_chord_sums *sums) {
    enum sp_status worst = SP_CONVERGED;
    int32_t chords = line->fold.both + 1, implicit = line->surface->kind == SP_IMPLICIT;
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
            enum sp_status status = check_chord(line, lane ? line->fold.inner - k : k, scale);
            if (status < 0) return status;
            if (status > worst) worst = status;
        }
        if (!sums) continue;
        weight_from = weight_to, weight_to = weight_of(pair.to);
        /* For n even the last chord is its own mirror image. */
        measure(&pair, weight_from, weight_to, (sp_mask){-1, k < line->fold.both || line->fold.odd ? -1 : 0}, &lengths, &errors);
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
        sum += i ? distance(here, before) : 0;
        for (int j = 0; j < 3; j++)
            before[j] = here[j];
    }
    return (length - sum) / 3;
}

double sp_check_rounding(double length, double scale) { return length > 0 ? 4e-15 * length + 2.2e-16 * scale : 0; }

double sp_check_length_error(const struct sp_polyline *line, double scale, int touches, const struct sp_chord_sums *sums) {
    if (line->kind->components) return sp_metric_length_error(line);
    double error = sums->error, least = sp_check_rounding(sums->length, scale), halved = touches ? halving_error(line, sums->length) : 0;
    if (halved > error) error = halved;
    return error > least ? error : least;
}
