/* Interpolation along a path: elements by their Lagrange polynomials, polylines by cubics through four neighbours. MATH.md, "Elements". */
#include "sample.h"

/* The place at t of a polyline: cubic through the four nodes around it. */
static void polyline_place(const struct sp_system *system, double t, double place[3]) {
    struct sp_fold fold = system->line.fold;
    int32_t dimension = system->line.kind->dimension, last = fold.inner + 1, first = (int32_t)(t * last) - 1,
            count = last < 3 ? last + 1 : 4;
    first = first < 0 ? 0 : first > last + 1 - count ? last + 1 - count : first;
    for (int j = 0; j < 3; j++)
        place[j] = 0;
    for (int32_t i = 0; i < count; i++) {
        double weight = 1, at = t * last - first;
        for (int32_t k = 0; k < count; k++)
            if (k != i) weight *= (at - k) / (i - k);
        for (int32_t j = 0; j < dimension; j++)
            place[j] += weight * sp_fold_get(fold, system->line.nodes.places, dimension, first + i, j);
    }
}

/* The place at t of elements. */
static void element_place(const struct sp_system *system, double t, double place[3]) {
    const struct sp_elements *elements = &system->elements;
    int32_t dimension = system->line.kind->dimension, p = elements->reference.degree, e = (int32_t)(t * elements->count);
    if (e > elements->count - 1) e = elements->count - 1;
    double values[SP_MAX_DEGREE + 1];
    sp_reference_interpolate(&elements->reference, t * elements->count - e, values);
    for (int j = 0; j < 3; j++)
        place[j] = 0;
    for (int32_t i = 0; i <= p; i++)
        for (int32_t j = 0; j < dimension; j++)
            place[j] += values[i] * sp_fold_get(system->line.fold, system->line.nodes.places, dimension, e * p + i, j);
}

static void place_at(const struct sp_system *system, double t, double place[3]) {
    if (system->elements.reference.degree == 1)
        polyline_place(system, t, place);
    else
        element_place(system, t, place);
}

void sp_sample_places(const struct sp_system *from, const struct sp_reference *reference, int32_t count, sp_pair *places) {
    int32_t p = reference->degree, last = p * count, dimension = from->line.kind->dimension;
    struct sp_fold fold = sp_fold_of(last - 1);
    for (int32_t i = 0; i <= last; i++) {
        double place[3], t = (i / p + (p > 1 ? reference->node[i % p] : 0)) / count;
        place_at(from, t, place);
        for (int32_t j = 0; j < dimension; j++) {
            double end = i == 0 || i == last
                             ? sp_fold_get(from->line.fold, from->line.nodes.places, dimension, i ? from->line.fold.inner + 1 : 0, j)
                             : place[j];
            places[dimension * sp_fold_pair(fold, i) + j][sp_fold_lane(fold, i)] = end;
        }
    }
    for (int32_t j = 0; j < dimension && fold.odd; j++)
        places[dimension * (fold.both + 1) + j] = sp_splat(places[dimension * (fold.both + 1) + j][0]);
    sp_fold_mirror(fold, places, dimension);
}

/* One sample, put onto the surface. Where that fails, the interpolated point. */
static void sample(const struct sp_system *system, double scale, double t, double *point, double *parameters) {
    const struct sp_surface *surface = system->line.surface;
    double place[3];
    place_at(system, t, place);
    sp_pair at[3] = {sp_splat(place[0]), sp_splat(place[1]), sp_splat(place[2])}, position[SP_PARAMETRIC_VALUES] = {{0}};
    if (surface->kind == SP_PARAMETRIC) {
        sp_parametric_clip(surface, 1, at);
        if (point) surface->value(1, at, position);
    } else {
        sp_implicit_settle(surface, 1, at, scale);
        sp_store(sp_load(at), position);
    }
    for (int j = 0; point && j < 3; j++)
        point[j] = position[j][0];
    for (int j = 0; parameters && j < 2; j++)
        parameters[j] = at[j][0];
}

/* A node: its chart knows where it lies, unless it is a chart of u and v themselves. */
static void write_node(const struct sp_system *system, int32_t i, double *point, double *parameters) {
    const struct sp_polyline *line = &system->line;
    int flat = line->surface->kind == SP_PARAMETRIC && line->surface->metric == SP_TENSOR;
    for (int32_t j = 0; parameters && j < 2; j++)
        parameters[j] = sp_fold_get(line->fold, line->nodes.places, 2, i, j);
    for (int32_t j = 0; !flat && j < 3; j++)
        point[j] = sp_fold_get(line->fold, line->nodes.charts, SP_CHART, i, j);
    if (!flat || !point) return;
    sp_pair place[2], position[SP_PARAMETRIC_VALUES];
    for (int32_t j = 0; j < 2; j++)
        place[j] = sp_splat(sp_fold_get(line->fold, line->nodes.places, 2, i, j));
    line->surface->value(1, place, position);
    for (int j = 0; j < 3; j++)
        point[j] = position[j][0];
}

void sp_sample_points(const struct sp_system *system, double scale, int32_t point_count, double *points, double *parameters) {
    struct sp_fold fold = system->line.fold;
    int32_t last = point_count + 1, end = fold.inner + 1;
    int nodes = system->elements.reference.degree == 1 && fold.inner == point_count;
    for (int32_t i = 0; i <= last; i++) {
        double *point = points ? points + 3 * i : NULL, *place = parameters ? parameters + 2 * i : NULL;
        if (!nodes && i > 0 && i < last)
            sample(system, scale, (double)i / last, point, place);
        else
            write_node(system, nodes ? i : i ? end : 0, point, place);
    }
}
