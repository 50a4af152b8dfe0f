/* Places between the vertices of a graph: which vertices are around them, and how far. Knows nothing of ways. */
#include "chart.h"
#include "graph_search.h"
#include "scalar.h"

enum { PATCH = 4 };
/* A place has no normal of its own where those so far to two sides of it, in parts of the spacing, differ. */
static const double BESIDE = 3e-2, SMOOTH = 0.9;

/* The place in its period that lies in the rectangle. */
static double reduce(const struct sp_graph *graph, int direction, double x) {
    double period = sp_graph_period(graph, direction);
    return period > 0 ? x - sp_round_down((x - graph->lines[direction][0]) / period) * period : x;
}

/* The cell of the grid that holds a place of the rectangle. */
static int32_t cell_of(const struct sp_graph *graph, int direction, double x) {
    const double *lines = graph->lines[direction];
    int32_t low = 0, high = graph->count[direction];
    while (high - low > 1) {
        int32_t middle = (low + high) / 2;
        if (lines[middle] <= x)
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* A vertex near a place, on the lift that is near it. */
struct neighbour {
    int32_t number;
    double place[2];
};

/* Those of the 4 x 4 vertices around a place of the rectangle that there are. */
static int32_t find_patch(const struct sp_graph *graph, const double place[2], struct neighbour *patch) {
    int32_t count = 0, corner[2] = {cell_of(graph, 0, place[0]) - (PATCH / 2 - 1), cell_of(graph, 1, place[1]) - (PATCH / 2 - 1)};
    for (int32_t k = 0; k < PATCH * PATCH; k++) {
        int32_t at[2] = {corner[0] + k / PATCH, corner[1] + k % PATCH};
        int inside = 1;
        for (int j = 0; j < 2; j++) {
            int32_t size = graph->count[j], turn = !graph->wraps[j] ? 0 : at[j] < 0 ? -1 : at[j] >= size;
            at[j] -= turn * size;
            if (at[j] < 0 || at[j] >= size) {
                inside = 0;
                break;
            }
            patch[count].place[j] = graph->lines[j][at[j]] + turn * sp_graph_period(graph, j);
        }
        if (inside) patch[count++].number = at[0] * graph->count[1] + at[1];
    }
    return count;
}

/* Samples at a place and in the middles between it and others, evaluated together. */
static void sample_middles(const struct sp_surface *surface, const double place[2], const struct neighbour *others, int32_t count,
                           double samples[][SP_GRAPH_WIDTH]) {
    struct sp_block block;
    sp_block_open(&block, surface, 1);
    sp_block_put(&block, place);
    for (int32_t k = 0; k < count; k++) {
        double middle[2] = {0.5 * (place[0] + others[k].place[0]), 0.5 * (place[1] + others[k].place[1])};
        sp_block_put(&block, middle);
    }
    sp_block_evaluate(&block);
    for (int32_t k = 0; k <= count; k++)
        sp_block_sample(&block, k, samples[k]);
}

static void attach_parametric(const struct sp_surface *surface, const struct sp_graph *graph, const double *end,
                              struct sp_attachment *attached) {
    double place[2] = {reduce(graph, 0, end[0]), reduce(graph, 1, end[1])}, samples[1 + PATCH * PATCH][SP_GRAPH_WIDTH];
    struct neighbour patch[PATCH * PATCH + 1];
    int32_t count = find_patch(graph, place, patch);
    sample_middles(surface, place, patch, count, samples);
    for (int32_t k = 0; k < count; k++) {
        const double *vertex = graph->samples + (size_t)graph->width * (size_t)patch[k].number;
        double by[2] = {patch[k].place[0] - place[0], patch[k].place[1] - place[1]};
        double length = sp_graph_segment(surface, place, samples[0], samples[1 + k], vertex, by);
        if (!is_finite(length)) continue;
        attached->vertex[attached->count] = patch[k].number, attached->length[attached->count++] = length;
    }
}

/* A place of an implicit surface to which vertices are attached. */
struct place {
    const double *at;
    double normal[3], sample[SP_GRAPH_WIDTH], near;
    int has_no_normal; /* beside a node, and where faces meet: no normal tells which sheet it lies on */
};

static void read_place(const struct sp_surface *surface, const struct sp_graph *graph, const double *at, struct place *place) {
    sp_pair seen[2][SP_IMPLICIT_VALUES]; /* here, and beside it: of two faces that meet here one is seen on one side, one on the other */
    double beside = BESIDE * graph->spacing;
    int is_node = sp_implicit_is_node(surface, at, beside, seen[0]) | sp_implicit_is_node(surface, at, -beside, seen[1]);
    struct sp_vector one = sp_load(seen[0] + 1), other = sp_load(seen[1] + 1);
    sp_pair size = sp_square_root(sp_dot(one, one)), cosine = sp_dot(one, other) / (size * sp_square_root(sp_dot(other, other)));
    for (int c = 0; c < 3; c++)
        place->normal[c] = seen[0][1 + c][0] / size[0];
    place->at = at, place->near = SP_ATTACHED_NEAR * graph->spacing, place->has_no_normal = is_node | (cosine[1] < SMOOTH);
    sp_graph_sample(surface, at, place->sample);
}

/* The square of the chord to a vertex; infinite where that is too far. */
static inline __attribute__((always_inline)) double near_chord(const struct place *place, const double *vertex) {
    double x = vertex[0] - place->at[0], y = vertex[1] - place->at[1], z = vertex[2] - place->at[2], squared = x * x + y * y + z * z;
    return squared <= place->near * place->near ? squared : __builtin_inf();
}

/* How far a vertex is; infinite unless on the same sheet. */
static double length_to(const struct sp_surface *surface, const struct sp_graph *graph, const struct place *place, int32_t vertex) {
    double normal[3];
    for (int c = 0; c < 3; c++)
        normal[c] = (double)graph->normals[3 * (size_t)vertex + (size_t)c];
    const double *sample = graph->samples + (size_t)graph->width * (size_t)vertex;
    return sp_graph_sheet_length(surface, place->sample, place->has_no_normal ? normal : place->normal, sample, normal);
}

static void attach_implicit(const struct sp_surface *surface, const struct sp_graph *graph, const double *end,
                            struct sp_attachment *attached) {
    struct place place;
    read_place(surface, graph, end, &place);
    for (int32_t i = 0; i < graph->vertex_count && attached->count < SP_MAX_ATTACHED; i++) {
        if (near_chord(&place, graph->samples + (size_t)graph->width * (size_t)i) == __builtin_inf()) continue;
        double length = length_to(surface, graph, &place, i);
        if (is_finite(length)) attached->vertex[attached->count] = i, attached->length[attached->count++] = length;
    }
}

double sp_graph_reach(const struct sp_surface *surface, const struct sp_graph *graph, const double *place, struct sp_reached *vertices,
                      int32_t count) {
    struct place end;
    double best = __builtin_inf();
    int32_t first = 0;
    read_place(surface, graph, place, &end);
    for (int32_t k = 0; k < count; k++) {
        double room = best - vertices[k].distance;
        if (!(room > 0)) continue;
        double chord = near_chord(&end, vertices[k].place);
        /* In space no way is shorter than its chord. */
        if (chord == __builtin_inf() || (surface->metric == SP_INDUCED && chord > room * room)) continue;
        double length = vertices[k].distance + length_to(surface, graph, &end, vertices[k].vertex);
        if (length < best) best = length, first = k;
    }
    if (count > 0) {
        struct sp_reached found = vertices[first];
        vertices[first] = vertices[0], vertices[0] = found;
    }
    return best;
}

enum sp_status sp_graph_attach(const struct sp_surface *surface, const struct sp_graph *graph, const double *place,
                               struct sp_attachment *attached) {
    attached->count = 0;
    for (int j = 0; j < (graph->kind == SP_IMPLICIT ? 3 : 2); j++)
        if (!is_finite(place[j])) return SP_NOT_FINITE;
    if (graph->kind == SP_IMPLICIT)
        attach_implicit(surface, graph, place, attached);
    else
        attach_parametric(surface, graph, place, attached);
    return attached->count == 0 ? SP_OFF_SURFACE : SP_CONVERGED;
}

static double near_implicit(const struct sp_surface *surface, const struct sp_graph *graph, const double *from, const double *to) {
    struct place places[2];
    read_place(surface, graph, from, &places[0]);
    if (near_chord(&places[0], to) == __builtin_inf()) return __builtin_inf();
    read_place(surface, graph, to, &places[1]);
    /* One that has no normal of its own is on the other's sheet. */
    const struct place *first = &places[places[0].has_no_normal], *second = &places[1 - places[1].has_no_normal];
    return sp_graph_sheet_length(surface, places[0].sample, first->normal, places[1].sample, second->normal);
}

double sp_graph_near_length(const struct sp_surface *surface, const struct sp_graph *graph, const double *from, const double *to) {
    if (graph->kind == SP_IMPLICIT) return near_implicit(surface, graph, from, to);
    struct neighbour near[2];
    double samples[3][SP_GRAPH_WIDTH], by[2];
    for (int j = 0; j < 2; j++) {
        double period = sp_graph_period(graph, j), away = to[j] - from[j];
        if (period > 0) away -= period * sp_round_down(away / period + 0.5);
        const double *lines = graph->lines[j];
        int32_t cell = cell_of(graph, j, reduce(graph, j, from[j])), last = graph->count[j] - !graph->wraps[j];
        double width = lines[cell < last ? cell + 1 : cell] - lines[cell < last ? cell : cell - 1];
        if (!(away * away <= width * width * PATCH * PATCH / 4)) return __builtin_inf();
        near[0].place[j] = from[j] + away, near[1].place[j] = from[j] + 2 * away;
        by[j] = away;
    }
    sample_middles(surface, from, near, 2, samples);
    return sp_graph_segment(surface, from, samples[0], samples[1], samples[2], by);
}
