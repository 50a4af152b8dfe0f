/* One chord against the surface: sheets, creases, singular curves, detours. MATH.md, "Checks". */
#include "chord.h"
#include "metric.h"
#include "normal.h"
#include "sample.h"
#include "scalar.h"
#include <string.h>

/* Thresholds measured on the surfaces of the paper: MATH.md, "Checks". */
static const double LARGEST_SAGITTA = 0.35, LARGEST_STRETCH = 2;
/* From a branch point, where the speed is nothing beside that of the middle, a path leads like a power of its parameter: the middle of the
 * parameters lies up to half of the chord aside. */
static const double BRANCH_SAGITTA = 0.5, STILL = 1e-3;
/* Beyond a crease, and on it, where the derivatives of max and its like are means of both sides. */
static const double NEAR_CREASE = 1e-6, SMOOTH_COSINE = 0.9;
/* Where a crease is looked for: not farther than so many halves of the chord. */
static const double MOST_OF_THE_WAY = 0.75, FARTHEST_CREASE = 20;
/* Where a chord over a crossing is parted, and down to which part of it; how small grad f is there, beside what it is on the way. */
static const double UNEVEN = 0.45, SHORTEST_PART = 1e-4, NO_SLOPE = 1e-2;
/* A chord may span two of them, over a thin rim. */
enum { BISECTIONS = 60, PARTS = 8, MOST_CREASES = 2 };

/* Two neighbouring nodes, scalar: their places, positions and normals. */
struct chord {
    double place[2][3], at[2][3], normal[2][3];
};

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

static double cosine_of(const struct chord *chord) {
    const double *a = chord->normal[0], *b = chord->normal[1];
    return dot(a, b) / root(dot(a, a) * dot(b, b));
}

/* From the middle of two ends most of the way to the line in which their tangent planes meet: halves of chords alone come near to a crease
 * the more slowly the sharper it is. Where that line is far away, the middle. */
static void towards_crease(const struct chord *chord, double place[3]) {
    const double *a = chord->normal[0], *b = chord->normal[1];
    double apart[3], offset[3], aa = dot(a, a), bb = dot(b, b), ab = dot(a, b);
    for (int j = 0; j < 3; j++)
        apart[j] = 0.5 * (chord->at[1][j] - chord->at[0][j]);
    double p = dot(a, apart), q = dot(b, apart), part = MOST_OF_THE_WAY / (aa * bb - ab * ab);
    for (int j = 0; j < 3; j++)
        offset[j] = part * ((q * aa + p * ab) * b[j] - (p * bb + q * ab) * a[j]);
    int is_far = !(norm(offset) <= FARTHEST_CREASE * norm(apart));
    for (int j = 0; j < 3; j++)
        place[j] = chord->at[0][j] + apart[j] + (is_far ? 0 : offset[j]);
}

static int spans_creases(const struct sp_surface *surface, const struct chord *whole, double scale) {
    struct chord creased[MOST_CREASES], chord;
    creased[0] = *whole;
    for (int count = 1, k = 0; k < count; k++) {
        chord = creased[k];
        double near = NEAR_CREASE * distance_between(chord.at[0], chord.at[1]) + 1e-14 * scale, place[3];
        for (int i = 0; i < BISECTIONS && !(distance_between(chord.at[0], chord.at[1]) <= near); i++) {
            struct chord halves[2] = {chord, chord};
            towards_crease(&chord, place);
            if (!sp_implicit_halve(surface, place, place, scale, halves[0].at[1], halves[0].normal[1])) return 0;
            for (int j = 0; j < 3; j++)
                halves[1].at[0][j] = halves[0].at[1][j], halves[1].normal[0][j] = halves[0].normal[1][j];
            int second = cosine_of(halves + 1) < cosine_of(halves);
            if (!(cosine_of(halves + !second) >= SP_CHORD_COSINE)) {
                if (count == MOST_CREASES) return 0;
                creased[count++] = halves[!second];
            }
            chord = halves[second];
            if (!(cosine_of(&chord) < SMOOTH_COSINE)) return 0;
        }
        if (!(distance_between(chord.at[0], chord.at[1]) <= near)) return 0;
    }
    return 1;
}

/* Whether a chord passes straight over a curve along which the surface crosses itself: there f changes its sign on both sides of the sheet,
 * so that the normal turns over, but not the sheet. All shorter parts of the chord lie along it, and grad f vanishes there; from face to
 * face of what is thin it does not. Parts are no halves: the middle of what is symmetric may be on the curve, where there is no normal. */
static int passes_crossing(const struct sp_surface *surface, const struct chord *whole, double scale) {
    struct chord chord = *whole;
    double length = distance_between(chord.at[0], chord.at[1]), least = SHORTEST_PART * length + 1e-12 * scale, steepest = 0, slope = 0;
    for (; length > least; length = distance_between(chord.at[0], chord.at[1])) {
        struct chord parts[2] = {chord, chord};
        double place[3], *at = parts[0].at[1], *normal = parts[0].normal[1];
        for (int j = 0; j < 3; j++)
            place[j] = chord.at[0][j] + UNEVEN * (chord.at[1][j] - chord.at[0][j]);
        if (!sp_implicit_halve(surface, place, place, scale, at, normal)) return 0;
        if (!(distance_between(at, place) <= LARGEST_SAGITTA * UNEVEN * length)) return 0;
        for (int j = 0; j < 3; j++)
            parts[1].at[0][j] = at[j], parts[1].normal[0][j] = normal[j];
        int second = cosine_of(parts) >= SP_CHORD_COSINE;
        if (!(cosine_of(parts + !second) >= SP_CHORD_COSINE) || !(cosine_of(parts + second) <= -SP_CHORD_COSINE)) return 0;
        chord = parts[second], slope = norm(normal), steepest = larger(steepest, slope);
    }
    return slope <= NO_SLOPE * steepest;
}

int sp_chord_spans_crease(const struct sp_surface *surface, const double from[3], const double normal[3], const double to[3],
                          const double other[3], double scale) {
    struct chord chord;
    for (int j = 0; j < 3; j++) {
        chord.at[0][j] = from[j], chord.at[1][j] = to[j];
        chord.normal[0][j] = normal[j], chord.normal[1][j] = other[j];
    }
    return spans_creases(surface, &chord, scale);
}

/* At a node, where a path may end, the normal is that of the sheet on which it ends. */
static void mend_normals(const struct sp_polyline *line, double far, struct chord *chord) {
    sp_pair seen[SP_IMPLICIT_VALUES];
    for (int end = 0; end < 2; end++)
        if (sp_implicit_is_node(line->surface, chord->place[end], far, seen))
            memcpy(chord->normal[end], chord->normal[!end], sizeof chord->normal[0]);
}

static enum sp_status check_implicit(const struct sp_polyline *line, struct chord *chord, double scale) {
    double length = distance_between(chord->at[0], chord->at[1]), half[3], settled[3], normal[3];
    for (int j = 0; j < 3; j++)
        half[j] = 0.5 * (chord->at[0][j] + chord->at[1][j]);
    if (!(cosine_of(chord) >= SP_CHORD_COSINE)) mend_normals(line, larger(length, SP_NODE_FAR * scale), chord);
    if (cosine_of(chord) <= -SP_CHORD_COSINE && passes_crossing(line->surface, chord, scale)) return SP_CONVERGED;
    if (!(cosine_of(chord) >= SP_CHORD_COSINE)) return spans_creases(line->surface, chord, scale) ? SP_TOLERANCE_NOT_MET : SP_SHEET_JUMP;
    if (!sp_implicit_halve(line->surface, chord->at[0], chord->at[1], scale, settled, normal)) return SP_SHEET_JUMP;
    return distance_between(half, settled) <= LARGEST_SAGITTA * length + 1e-14 * scale ? SP_CONVERGED : SP_SHEET_JUMP;
}

/* The normal turns over between two nodes: is it zero where it does, or at one of them? */
static enum sp_status check_fold(const struct sp_polyline *line, const struct chord *chord) {
    struct sp_turn turn;
    if (!sp_normal_turn(line->surface, chord->place[0], chord->place[1], BISECTIONS, &turn)) return SP_STALLED;
    return sp_normal_vanishes(&turn) ? SP_SINGULAR_METRIC : SP_STALLED;
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
    return i > 0 && !(dot(chord->normal[0], chord->normal[0]) > SP_CHORD_DEGENERATE * e * g);
}

/* Elements are not straight between their nodes: whether the path itself stays by a chord, which it does not where it jumps, or the surface
 * is torn. Where a coordinate moves like the cube of the length (cbrt) the segment does not say. */
static int follows(const struct sp_system *system, int32_t i, const struct chord *chord, double length, double scale) {
    const struct sp_surface *surface = system->line.surface;
    if (system->elements.reference.degree == 1 || !surface->value) return 0;
    double from = sp_sample_parameter(&system->elements, i), step = (sp_sample_parameter(&system->elements, i + 1) - from) / PARTS;
    double at[3][3], place[3], along = 0;
    memcpy(at[0], chord->at[0], sizeof at[0]);
    for (int k = 1; k <= PARTS; k++) {
        sp_sample_place(system, from + k * step, place);
        if (!sp_sample_point(surface, scale, place, at[2 - k % 2], NULL)) return 0;
        along += distance_between(at[2 - k % 2], at[k % 2 ? 0 : 1]);
        if (k % 2) continue;
        double half[3], part = distance_between(at[0], at[2]);
        for (int j = 0; j < 3; j++)
            half[j] = 0.5 * (at[0][j] + at[2][j]);
        if (!(distance_between(half, at[1]) <= LARGEST_SAGITTA * part + 1e-12 * scale)) return 0;
        memcpy(at[0], at[2], sizeof at[0]);
    }
    return along <= LARGEST_STRETCH * length + 1e-12 * scale;
}

/* The middle of the parameter segment must be near the middle of the chord, and the segment about as long as the chord: else it goes around
 * somewhere. */
static enum sp_status check_parametric(const struct sp_system *system, int32_t i, const struct chord *chord, double scale) {
    const struct sp_polyline *line = &system->line;
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
    /* Beside a branch point elements are so short that nobody asks where exactly their nodes lie. */
    double length = distance_between(chord->at[0], chord->at[1]), rounding = 1e-12 * scale;
    double mid = root(chart_speed_squared(chart, 0, u, v)), first = root(speed_squared(line, i, u, v)),
           last = root(speed_squared(line, i + 1, u, v)), end = i > 0 ? i < line->fold.inner ? mid : last : first,
           sagitta = end < STILL * mid ? BRANCH_SAGITTA : LARGEST_SAGITTA;
    /* At the path's ends the speed may be infinite: that of the middle stands for it. */
    if (i == 0) first = mid;
    if (i == line->fold.inner) last = mid;
    double along = (first + 4 * mid + last) / 6;
    if (!is_finite(distance_between(half, middle))) return SP_NOT_FINITE;
    if (distance_between(half, middle) <= sagitta * length + rounding && along <= LARGEST_STRETCH * length + rounding) return SP_CONVERGED;
    return follows(system, i, chord, length, scale) ? SP_CONVERGED : SP_STALLED;
}

enum sp_status sp_chord_check(const struct sp_system *system, int32_t i, double scale) {
    const struct sp_polyline *line = &system->line;
    struct chord chord;
    read_node(line, i, &chord, 0), read_node(line, i + 1, &chord, 1);
    return line->surface->kind == SP_IMPLICIT ? check_implicit(line, &chord, scale) : check_parametric(system, i, &chord, scale);
}
