/* Interpolation along a path: elements by their Lagrange polynomials, polylines by cubics through four neighbours. MATH.md, "Elements". */
#include "sample.h"
#include "scalar.h"
#include <string.h>

enum { BLOCK = 32 };
static const double FEW_ROUNDINGS = 2e-15;

/* Not finite. */
static inline __attribute__((always_inline)) sp_mask is_spoilt(sp_pair x) { return x - x != sp_splat(0.0); }

/* sum_i weights_i node_(first + i), and of the mirrored nodes. */
static void combine(const struct sp_system *system, int32_t first, int32_t count, const double *weights, sp_pair place[3]) {
    struct sp_fold fold = system->line.fold;
    int32_t dimension = system->line.kind->dimension;
    sp_pair sum[3] = {{0}, {0}, {0}};
    for (int32_t i = 0; i < count; i++) {
        int mirrored = first + i > sp_fold_both(fold) + 1; /* beyond the middle nodes stand in the other lane */
        const sp_pair *at = system->line.nodes.places + dimension * (mirrored ? fold.inner + 1 - first - i : first + i);
        sp_pair weight = sp_splat(weights[i]);
        sum[0] += weight * (mirrored ? sp_swap(at[0]) : at[0]);
        sum[1] += weight * (mirrored ? sp_swap(at[1]) : at[1]);
        if (dimension == 3) sum[2] += weight * (mirrored ? sp_swap(at[2]) : at[2]);
    }
    place[0] = sum[0], place[1] = sum[1], place[2] = sum[2];
}

/* Weights of four neighbours for the cubic through them, s = 0 … 1 from the second to the third. */
static inline __attribute__((always_inline)) void cubic_weights(double s, double weights[4]) {
    double ahead = 1 - s, both = s * ahead * (1.0 / 6), around = (1 + s) * (2 - s) * 0.5;
    weights[0] = both * (s - 2), weights[1] = ahead * around, weights[2] = s * around, weights[3] = -both * (1 + s);
}

/* The places of a polyline at t and 1 - t: cubic through the four nodes around each; linear where there are fewer. */
static void polyline_place(const struct sp_system *system, double t, sp_pair place[3]) {
    int32_t last = system->line.fold.inner + 1, before = (int32_t)(t * last), most = last < 3 ? last - 1 : last - 2;
    int32_t first = before > most ? most : before;
    if (last < 3) {
        double s = t * last - first, straight[2] = {1 - s, s};
        combine(system, first, 2, straight, place);
        return;
    }
    double weights[4];
    if (first < 1) first = 1;
    cubic_weights(t * last - first, weights);
    combine(system, first - 1, 4, weights, place);
}

/* Where in the reference element of element e the path's parameter x, 0 … 1 within it, lies: graded elements count in square roots. */
static double to_reference(const struct sp_elements *elements, int32_t e, double x) {
    if (e == 0 && elements->singular[0]) return root(larger(x, 0));
    if (e == elements->count - 1 && elements->singular[1]) return 1 - root(larger(1 - x, 0));
    return x;
}

static double from_reference(const struct sp_elements *elements, int32_t e, double x) {
    if (e == 0 && elements->singular[0]) return x * x;
    if (e == elements->count - 1 && elements->singular[1]) return 1 - (1 - x) * (1 - x);
    return x;
}

/* The place of elements at t in lane 0; at 1 - t in lane 1, unless it is graded otherwise there. */
static void element_place(const struct sp_system *system, double t, sp_pair place[3]) {
    const struct sp_elements *elements = &system->elements;
    int32_t p = elements->reference.degree, e = (int32_t)(t * elements->count), step = 1;
    if (e > elements->count - 1) e = elements->count - 1;
    double weights[SP_MAX_DEGREE + 1], x = t * elements->count - e;
    if (elements->spread) {
        for (e = 0; 2 * step < elements->count; step *= 2) {
        }
        for (; step > 0; step /= 2)
            if (e + step < elements->count && sp_elements_border(elements, e + step) <= t) e += step;
        x = (t - sp_elements_border(elements, e)) / (sp_elements_border(elements, e + 1) - sp_elements_border(elements, e));
    }
    sp_reference_interpolate(&elements->reference, to_reference(elements, e, x), weights);
    combine(system, e * p, p + 1, weights, place);
}

/* The places at t and at 1 - t. */
static void place_pair(const struct sp_system *system, double t, sp_pair place[3]) {
    const struct sp_elements *elements = &system->elements;
    if (elements->reference.degree == 1) {
        polyline_place(system, t, place);
        return;
    }
    element_place(system, t, place);
    if (elements->singular[0] == elements->singular[1] && !elements->spread) return;
    sp_pair other[3];
    element_place(system, 1 - t, other);
    for (int j = 0; j < 3; j++)
        place[j][1] = other[j][0];
}

void sp_sample_place(const struct sp_system *system, double t, double place[3]) {
    sp_pair pair[3];
    place_pair(system, t, pair);
    for (int j = 0; j < 3; j++)
        place[j] = pair[j][0];
}

double sp_sample_parameter(const struct sp_elements *elements, int32_t i) {
    int32_t p = elements->reference.degree, e = p > 1 ? i / p : i;
    double within = p > 1 ? from_reference(elements, e, elements->reference.node[i - e * p]) : 0;
    if (!elements->spread) return (e + within) / elements->count;
    double border = sp_elements_border(elements, e);
    return within > 0 ? border + within * (sp_elements_border(elements, e + 1) - border) : border;
}

/* Polyline from polyline as far as the four neighbours stand side by side, as polyline_place. Returns the pair that is next. */
static int32_t resample(const struct sp_system *from, struct sp_fold fold, sp_pair *places) {
    int32_t dimension = from->line.kind->dimension, k = 0, first = 0;
    const sp_pair *at = from->line.nodes.places;
    double chords = (from->line.fold.inner + 1.0) / (fold.inner + 1), s = -1, weights[4];
    for (; k <= sp_fold_both(fold) && first <= sp_fold_both(from->line.fold) - 2; k++) {
        cubic_weights(s, weights);
        for (int32_t j = 0; j < dimension; j++, places++)
            *places = weights[0] * at[j] + weights[1] * at[dimension + j] + weights[2] * at[2 * dimension + j] +
                      weights[3] * at[3 * dimension + j];
        for (s += chords; s >= 1; s--)
            first++, at += dimension;
    }
    return k;
}

void sp_sample_places(const struct sp_system *from, const struct sp_elements *to, sp_pair *places) {
    int32_t dimension = from->line.kind->dimension;
    struct sp_fold fold = (struct sp_fold){to->reference.degree * to->count - 1};
    int alike = to->singular[0] == to->singular[1] && !to->spread;
    int plain = alike && from->elements.reference.degree + to->reference.degree == 2;
    for (int32_t k = plain ? resample(from, fold, places) : 0; k <= sp_fold_unknown(fold); k++) {
        sp_pair place[3];
        double t = sp_sample_parameter(to, k), other = alike ? 1 - t : sp_sample_parameter(to, fold.inner + 1 - k);
        place_pair(from, t, place);
        if (other != 1 - t) {
            sp_pair mirrored[3];
            place_pair(from, other, mirrored);
            for (int32_t j = 0; j < dimension; j++)
                place[j][1] = mirrored[j][0];
        }
        for (int32_t j = 0; j < dimension; j++)
            places[dimension * k + j] = k == 0 ? from->line.nodes.places[j] : k > sp_fold_both(fold) ? sp_splat(place[j][0]) : place[j];
    }
    sp_fold_mirror(fold, places, dimension);
}

int sp_sample_point(const struct sp_surface *surface, double scale, const double place[3], double *point, double *parameters) {
    sp_pair at[3] = {sp_splat(place[0]), sp_splat(place[1]), sp_splat(place[2])}, position[SP_PARAMETRIC_VALUES] = {{0}};
    if (surface->kind == SP_PARAMETRIC) {
        sp_parametric_clip(surface, 1, at);
        if (point) surface->value(1, at, position);
    } else {
        sp_implicit_settle(surface, 1, at, scale);
        sp_store(sp_load(at), position);
    }
    sp_mask spoilt = {0, 0};
    for (int j = 0; point && j < 3; j++)
        point[j] = position[j][0], spoilt |= is_spoilt(position[j]);
    for (int j = 0; parameters && j < 2; j++)
        parameters[j] = at[j][0], spoilt |= is_spoilt(at[j]);
    return !sp_any(spoilt);
}

int sp_storage_take(struct sp_storage *storage, int32_t dimension, int32_t inner, struct sp_arena *arena) {
    storage->places = sp_arena_take(arena, (size_t)sp_fold_pairs((struct sp_fold){inner}) * (size_t)dimension, sizeof(sp_pair));
    storage->node = sp_arena_take(arena, SP_MAX_DEGREE + 1, sizeof(double));
    storage->barycentric = sp_arena_take(arena, SP_MAX_DEGREE + 1, sizeof(double));
    storage->spread = sp_arena_take(arena, SP_SPREAD + 1, sizeof(double));
    return storage->places && storage->node && storage->barycentric && storage->spread;
}

struct sp_system sp_storage_keep(const struct sp_storage *storage, const struct sp_system *system) {
    struct sp_system kept = *system;
    const struct sp_reference *reference = &system->elements.reference;
    size_t count = (size_t)sp_fold_pairs(system->line.fold) * (size_t)system->line.kind->dimension, degree = (size_t)reference->degree;
    memcpy(storage->places, system->line.nodes.places, count * sizeof(sp_pair));
    if (degree > 1) {
        memcpy(storage->node, reference->node, (degree + 1) * sizeof(double));
        memcpy(storage->barycentric, reference->barycentric, (degree + 1) * sizeof(double));
    }
    if (system->elements.spread) kept.elements.spread = memcpy(storage->spread, system->elements.spread, (SP_SPREAD + 1) * sizeof(double));
    kept.line.nodes.places = storage->places;
    kept.elements.reference.node = storage->node, kept.elements.reference.barycentric = storage->barycentric;
    return kept;
}

/* Where samples go: the last one's number, and whether the path is solved from its end. */
struct sheet {
    int32_t last, reversed;
    double *points, *parameters;
    sp_mask spoilt; /* where some number is not finite */
};

/* A number of two samples. */
static inline __attribute__((always_inline)) void write_lanes(double *first, double *second, sp_pair x, sp_mask *spoilt) {
    *first = x[0], *second = x[1];
    *spoilt |= is_spoilt(x);
}

/* Samples i and last - i, which lie in the two lanes. */
static void write_pair(struct sheet *sheet, int32_t i, const sp_pair *position, const sp_pair *place) {
    int32_t first = sheet->reversed ? sheet->last - i : i, second = sheet->last - first;
    sp_mask spoilt = sheet->spoilt;
    if (sheet->points) {
        double *a = sheet->points + 3 * first, *b = sheet->points + 3 * second;
        write_lanes(a, b, position[0], &spoilt);
        write_lanes(a + 1, b + 1, position[1], &spoilt);
        write_lanes(a + 2, b + 2, position[2], &spoilt);
    }
    if (sheet->parameters) {
        double *a = sheet->parameters + 2 * first, *b = sheet->parameters + 2 * second;
        write_lanes(a, b, place[0], &spoilt);
        write_lanes(a + 1, b + 1, place[1], &spoilt);
    }
    sheet->spoilt = spoilt;
}

/* The pair of nodes k: charts know where they lie, unless they are charts of u and v themselves. */
static void write_nodes(const struct sp_system *system, int32_t k, struct sheet *sheet) {
    const struct sp_polyline *line = &system->line;
    const sp_pair *place = line->nodes.places + line->kind->dimension * k, *position = line->nodes.charts + SP_CHART * k;
    sp_pair flat[SP_PARAMETRIC_VALUES];
    if (sheet->points && line->surface->kind == SP_PARAMETRIC && line->kind->components == 3) {
        sp_positions(line->surface, 1, place, flat);
        position = flat;
    }
    write_pair(sheet, k, position, place);
}

/* The places of a path at `first`/last …, `count` of them, and as far from its end, put onto the surface. Returns where they lie:
 * `positions`, unless NULL, or the places themselves. */
static const sp_pair *put_onto(const struct sp_system *system, double scale, double last, int32_t first, int32_t count, sp_pair *places,
                               sp_pair *positions) {
    const struct sp_surface *surface = system->line.surface;
    int32_t dimension = system->line.kind->dimension;
    sp_pair place[3];
    for (int32_t i = 0; i < count; i++) {
        place_pair(system, (first + i) / last, place);
        for (int32_t j = 0; j < dimension; j++)
            places[dimension * i + j] = place[j];
    }
    if (surface->kind == SP_IMPLICIT) {
        sp_implicit_settle(surface, count, places, scale);
        return places;
    }
    sp_parametric_clip(surface, count, places);
    if (positions) sp_positions(surface, count, places, positions);
    return positions;
}

/* Samples of places that are to be put onto the surface: block by block, as surfaces are evaluated. */
static void write_block(const struct sp_system *system, double scale, int32_t first, int32_t count, struct sheet *sheet) {
    sp_pair places[3 * BLOCK], positions[SP_PARAMETRIC_VALUES * BLOCK];
    const sp_pair *written = put_onto(system, scale, sheet->last, first, count, places, sheet->points ? positions : NULL);
    for (int32_t i = 0; i < count; i++)
        write_pair(sheet, first + i, written + 3 * i, places + 2 * i);
}

/* How far positions move where u and v do by a few roundings: far where a derivative is infinite near by. */
static sp_pair blur_of(const struct sp_surface *surface, const sp_pair place[2], struct sp_vector position) {
    sp_pair moved[2] = {place[0] * (1 + FEW_ROUNDINGS), place[1] * (1 + FEW_ROUNDINGS)}, there[3];
    sp_parametric_clip(surface, 1, moved);
    sp_positions(surface, 1, moved, there);
    struct sp_vector away = sp_subtract(sp_load(there), position);
    return sp_square_root(sp_dot(away, away));
}

double sp_sample_bend(const struct sp_system *system, double scale, double step) {
    const struct sp_surface *surface = system->line.surface;
    sp_pair places[9], positions[9];
    const sp_pair *at = put_onto(system, scale, 1 / step, 0, 3, places, positions);
    struct sp_vector middle = sp_load(at + 3), aside = sp_subtract(sp_subtract(sp_load(at + 6), middle), sp_subtract(middle, sp_load(at)));
    sp_pair bend = sp_square_root(sp_dot(aside, aside));
    if (surface->kind == SP_PARAMETRIC) bend -= blur_of(surface, places + 2, middle);
    return bend[0] > bend[1] ? bend[0] : bend[1];
}

int sp_sample_points(const struct sp_system *system, double scale, int32_t point_count, int32_t reversed, double *points,
                     double *parameters) {
    struct sheet sheet = {.last = point_count + 1, .reversed = reversed};
    sheet.points = points, sheet.parameters = parameters;
    int32_t half = sheet.last / 2;
    int nodes = system->elements.reference.degree == 1 && system->line.fold.inner == point_count;
    for (int32_t k = 0; k <= (nodes ? half : 0); k++)
        write_nodes(system, k, &sheet);
    for (int32_t i = 1; !nodes && i <= half; i += BLOCK)
        write_block(system, scale, i, half - i < BLOCK ? half - i + 1 : BLOCK, &sheet);
    return !sp_any(sheet.spoilt);
}
