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
            /* No dimension is above 3. NOLINTNEXTLINE(clang-analyzer-core.uninitialized.Assign) */
            place[j] += weight * sp_fold_get(fold, system->line.nodes.places, dimension, first + i, j);
    }
}

static double root(double x) { return sp_square_root(sp_splat(x > 0 ? x : 0))[0]; }

/* Where in the reference element of element e the path's parameter x, 0 … 1 within it, lies: graded elements count in square roots. */
static double to_reference(const struct sp_elements *elements, int32_t e, double x) {
    if (e == 0 && elements->singular[0]) return root(x);
    if (e == elements->count - 1 && elements->singular[1]) return 1 - root(1 - x);
    return x;
}

static double from_reference(const struct sp_elements *elements, int32_t e, double x) {
    if (e == 0 && elements->singular[0]) return x * x;
    if (e == elements->count - 1 && elements->singular[1]) return 1 - (1 - x) * (1 - x);
    return x;
}

/* The place at t of elements. */
static void element_place(const struct sp_system *system, double t, double place[3]) {
    const struct sp_elements *elements = &system->elements;
    int32_t dimension = system->line.kind->dimension, p = elements->reference.degree, e = (int32_t)(t * elements->count);
    if (e > elements->count - 1) e = elements->count - 1;
    double values[SP_MAX_DEGREE + 1];
    sp_reference_interpolate(&elements->reference, to_reference(elements, e, t * elements->count - e), values);
    for (int j = 0; j < 3; j++)
        place[j] = 0;
    for (int32_t i = 0; i <= p; i++)
        for (int32_t j = 0; j < dimension; j++)
            /* No dimension is above 3. NOLINTNEXTLINE(clang-analyzer-core.uninitialized.Assign) */
            place[j] += values[i] * sp_fold_get(system->line.fold, system->line.nodes.places, dimension, e * p + i, j);
}

void sp_sample_place(const struct sp_system *system, double t, double place[3]) {
    if (system->elements.reference.degree == 1)
        polyline_place(system, t, place);
    else
        element_place(system, t, place);
}

double sp_sample_parameter(const struct sp_elements *elements, int32_t i) {
    int32_t p = elements->reference.degree, e = i / p;
    return (e + (p > 1 ? from_reference(elements, e, elements->reference.node[i % p]) : 0)) / elements->count;
}

void sp_sample_places(const struct sp_system *from, const struct sp_elements *to, sp_pair *places) {
    int32_t last = to->reference.degree * to->count, dimension = from->line.kind->dimension;
    struct sp_fold fold = sp_fold_of(last - 1);
    for (int32_t i = 0; i <= last; i++) {
        double place[3];
        sp_sample_place(from, sp_sample_parameter(to, i), place);
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

void sp_sample_point(const struct sp_surface *surface, double scale, const double place[3], double *point, double *parameters) {
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

int sp_storage_take(struct sp_storage *storage, int32_t dimension, int32_t inner, struct sp_arena *arena) {
    storage->places = sp_arena_take(arena, (size_t)sp_fold_pairs(sp_fold_of(inner)) * (size_t)dimension, sizeof(sp_pair));
    storage->node = sp_arena_take(arena, SP_MAX_DEGREE + 1, sizeof(double));
    storage->barycentric = sp_arena_take(arena, SP_MAX_DEGREE + 1, sizeof(double));
    return storage->places && storage->node && storage->barycentric;
}

struct sp_system sp_storage_keep(const struct sp_storage *storage, const struct sp_system *system) {
    struct sp_system kept = *system;
    int32_t count = sp_fold_pairs(system->line.fold) * system->line.kind->dimension, degree = system->elements.reference.degree;
    for (int32_t i = 0; i < count; i++)
        storage->places[i] = system->line.nodes.places[i];
    for (int32_t i = 0; degree > 1 && i <= degree; i++) {
        storage->node[i] = system->elements.reference.node[i];
        storage->barycentric[i] = system->elements.reference.barycentric[i];
    }
    kept.line.nodes.places = storage->places;
    kept.elements.reference.node = storage->node, kept.elements.reference.barycentric = storage->barycentric;
    return kept;
}

/* A node: its chart knows where it lies, unless it is a chart of u and v themselves. */
static void write_node(const struct sp_system *system, int32_t i, double *point, double *parameters) {
    const struct sp_polyline *line = &system->line;
    int flat = line->surface->kind == SP_PARAMETRIC && line->surface->metric == SP_TENSOR;
    for (int32_t j = 0; parameters && j < 2; j++)
        parameters[j] = sp_fold_get(line->fold, line->nodes.places, 2, i, j);
    if (!point) return;
    for (int32_t j = 0; !flat && j < 3; j++)
        point[j] = sp_fold_get(line->fold, line->nodes.charts, SP_CHART, i, j);
    if (!flat) return;
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
        double *point = points ? points + 3 * i : NULL, *place = parameters ? parameters + 2 * i : NULL, at[3];
        if (nodes || i == 0 || i == last) {
            write_node(system, nodes ? i : i ? end : 0, point, place);
            continue;
        }
        sp_sample_place(system, (double)i / last, at);
        sp_sample_point(system->line.surface, scale, at, point, place);
    }
}
