/* First polylines: straight, or resampled from one that is given. MATH.md, "Starts". */
#include "start.h"
#include "metric.h"
#include "scalar.h"

/* Where a place lies; u and v themselves on a surface without positions. */
static void locate_place(const struct sp_surface *surface, const double *point, double at[3]) {
    int32_t dimension = sp_kind_of(surface)->dimension;
    sp_pair place[3] = {{0}}, position[3];
    for (int j = 0; j < dimension; j++)
        place[j] = sp_splat(point[j]);
    if (surface->kind == SP_PARAMETRIC && surface->value)
        sp_positions(surface, 1, place, position);
    else
        sp_store(sp_load(place), position);
    for (int j = 0; j < 3; j++)
        at[j] = position[j][0];
}

/* |X| of a given end. */
static double size_of(const struct sp_surface *surface, const double point[3]) {
    double at[3];
    locate_place(surface, point, at);
    return norm(at);
}

double sp_start_scale(const struct sp_surface *surface, const struct sp_request *request) {
    if (surface->extent > 0) return surface->extent;
    double from = size_of(surface, request->from), to = size_of(surface, request->to);
    return from > to ? from : to;
}

enum sp_status sp_start_end(const struct sp_surface *surface, double scale, double point[3]) {
    int dimension = sp_kind_of(surface)->dimension;
    for (int j = 0; j < dimension; j++)
        if (!(point[j] - point[j] == 0)) return SP_NOT_FINITE;
    if (surface->kind != SP_IMPLICIT) return SP_CONVERGED;
    sp_pair place[3] = {sp_splat(point[0]), sp_splat(point[1]), sp_splat(point[2])}, values[SP_IMPLICIT_VALUES];
    surface->value(1, place, values);
    if (!(values[0][0] - values[0][0] == 0)) return SP_NOT_FINITE;
    if (values[1][0] == 0 && values[2][0] == 0 && values[3][0] == 0) return SP_SINGULAR_METRIC;
    if (!sp_implicit_settle_end(surface, place, scale)) return SP_OFF_SURFACE;
    double moved[3] = {place[0][0] - point[0], place[1][0] - point[1], place[2][0] - point[2]};
    if (!(norm(moved) <= 0.1 * scale)) return SP_OFF_SURFACE;
    for (int j = 0; j < 3; j++)
        point[j] = place[j][0];
    return SP_CONVERGED;
}

/* Twelve steps to a zero of a square divide its gradient by 2^12, to one of a third power by 130^2. */
static const double VANISHED = 1e-3, FAR = 100; /* of what is near: steps that lead farther tell of another place */

int sp_start_is_multiple(const struct sp_surface *surface, const double place[3], double near) {
    for (int corner = 0; corner < 4; corner++) {
        sp_pair beside[3], before[SP_IMPLICIT_VALUES], after[SP_IMPLICIT_VALUES];
        for (int j = 0; j < 3; j++)
            beside[j] = place[j] + (sp_pair){-near, near} * (corner >> j & 1 ? 2 + j : -2 - j);
        surface->value(1, beside, before);
        sp_implicit_settle(surface, 1, beside, near);
        surface->value(1, beside, after);
        double moved = absolute(beside[0][0] - place[0]) + absolute(beside[1][0] - place[1]) + absolute(beside[2][0] - place[2]);
        struct sp_vector from = sp_load(before + 1), to = sp_load(after + 1);
        if (moved > FAR * near || sp_any(~(sp_dot(to, to) < VANISHED * VANISHED * sp_dot(from, from)))) return 0;
    }
    return 1;
}

static void straight_line(const struct sp_polyline *line, const double from[3], const double to[3]) {
    int32_t last = line->fold.inner + 1, dimension = line->kind->dimension;
    sp_pair *place = line->nodes.places;
    for (int32_t k = 0; k <= sp_fold_unknown(line->fold); k++) {
        sp_pair t = (sp_pair){k, last - k} / (double)last;
        for (int j = 0; j < dimension; j++)
            *place++ = from[j] + t * (to[j] - from[j]);
    }
    for (int j = 0; j < dimension; j++)
        line->nodes.places[j][1] = to[j];
}

/* Where a given point lies, both lanes alike, and what length is measured by there, if that is not space. */
static void measure_point(const struct sp_polyline *line, const double *point, sp_pair at[3], sp_pair metric[SP_METRIC_LARGEST]) {
    if (line->kind->components) {
        sp_pair place[3] = {sp_splat(point[0]), sp_splat(point[1]), sp_splat(line->kind->dimension == 3 ? point[2] : 0)}, chart[SP_CHART];
        line->kind->charts(line->surface, 1, place, chart, metric);
        sp_store(sp_load(chart + SP_CHART_X), at);
    } else {
        double position[3];
        locate_place(line->surface, point, position);
        for (int j = 0; j < 3; j++)
            at[j] = sp_splat(position[j]);
    }
}

/* The length of the given polyline up to each `stride`-th point, as length is measured; returns that of all. Nodes that begin evenly spaced
 * in space have far to go along the path where a metric changes much. */
static double measure(const struct sp_polyline *line, const struct sp_request *request, int32_t stride, double *along) {
    int32_t components = line->kind->components, end = request->start_count - 1;
    sp_pair at[2][3] = {{{0}}}, metric[2][SP_METRIC_LARGEST], chord[3];
    double total = 0;
    for (int32_t k = 0, i = 0; k * stride < end + stride; k++, i = k * stride < end ? k * stride : end) {
        int here = k & 1;
        measure_point(line, request->start + line->kind->dimension * i, at[here], metric[here]);
        for (int j = 0; j < 3; j++)
            chord[j] = at[here][j] - at[!here][j];
        double both = 0;
        for (int side = 0; side < 2 && i > 0; side++)
            both += sp_square_root(sp_metric_product(components, metric[side], chord, chord))[0];
        /* Where the metric is none: Newton will say so. */
        if (!is_finite(both)) both = 2 * sp_square_root(sp_metric_product(0, NULL, chord, chord))[0];
        along[i] = total += 0.5 * both;
    }
    return total;
}

/* A smooth start that many chords follow is as long as they, but for this part: it turns by 12 radians in 256. */
static const double THINNED = 1e-4;

int sp_start_is_smooth(const struct sp_polyline *line, const struct sp_request *request, int32_t chords, struct sp_arena *arena) {
    double *along = sp_arena_take(arena, (size_t)request->start_count, sizeof(double));
    double thinned = along ? measure(line, request, (request->start_count + chords - 2) / chords, along) : 0;
    return along && thinned >= (1 - THINNED) * measure(line, request, 1, along);
}

/* Where node i of the new polyline lies on the given one: a segment and a place within it, at i/(n + 1) of the length. With `keep` and as
 * many points as nodes: each node its point. `segment` only grows. */
static double locate(const struct sp_request *request, const double *along, int32_t i, int32_t last, int32_t keep, int32_t *segment) {
    int32_t end = request->start_count - 1;
    if (keep && end == last) {
        *segment = i < last ? i : last - 1;
        return i - *segment;
    }
    double t = (double)i / last, target = t * along[end];
    while (*segment < end - 1 && along[*segment + 1] < target)
        ++*segment;
    double span = along[*segment + 1] - along[*segment];
    return span > 0 ? (target - along[*segment]) / span : t;
}

/* Nodes on the given polyline; the gap at either end is closed by a shift that fades along the path. */
static void resample(const struct sp_polyline *line, const struct sp_request *request, const double *along, const double from[3],
                     const double to[3], int32_t keep) {
    int dimension = line->kind->dimension;
    int32_t last = line->fold.inner + 1, segment = 0, end = request->start_count - 1;
    const double *start = request->start;
    for (int32_t i = 0; i <= last; i++) {
        double t = (double)i / last, local = locate(request, along, i, last, keep, &segment);
        const double *a = start + dimension * segment, *b = a + dimension;
        for (int j = 0; j < dimension; j++) {
            double gap = (1 - t) * (from[j] - start[j]) + t * (to[j] - start[dimension * end + j]);
            double value = i == 0 ? from[j] : i == last ? to[j] : a[j] + local * (b[j] - a[j]) + gap;
            sp_polyline_put(line, i, j, value);
        }
    }
}

enum sp_status sp_start_polyline(struct sp_polyline *line, const struct sp_request *request, const double from[3], const double to[3],
                                 double scale, int32_t keep, struct sp_arena *arena) {
    if (request->start) {
        double *along = sp_arena_take(arena, (size_t)request->start_count, sizeof(double));
        if (!along) return SP_OUT_OF_MEMORY;
        double total = measure(line, request, 1, along);
        if (!is_finite(total)) return SP_NOT_FINITE;
        resample(line, request, along, from, to, keep);
    } else {
        straight_line(line, from, to);
    }
    return sp_polyline_settle(line, scale) ? SP_CONVERGED : SP_SHEET_JUMP;
}
