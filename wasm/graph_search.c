/* Ways through a graph between two points: distances from both ends, then the best vertex to go by, again and again. MATH.md, "The globally
 * shortest path". */
#include "graph_search.h"

/* Ways up to a quarter longer than the shortest are looked at; one that keeps within a tenth of it is the same. */
static const double LONGEST = 1.25, APART = 0.1, GROWTH = 1.25, NEAR = 1.5;

enum { MOST_WAYS = 8, PATCH = 4 };

struct search {
    const struct sp_surface *surface;
    const struct sp_graph *graph;
    const double *ends[2];
    struct sp_attachment attached[2];
    struct sp_front front[2], taken; /* distances from the ends, and from the ways already found */
    int32_t *vertices;               /* those of one way */
    double best;
};

/* The place in its period that lies in the rectangle. */
static double reduce(const struct sp_graph *graph, int direction, double x) {
    if (!graph->wraps[direction]) return x;
    double turns = (x - graph->lower[direction]) / (graph->step[direction] * graph->count[direction]);
    return x - sp_round_down(turns) * (graph->step[direction] * graph->count[direction]);
}

/* The length over the middle of a parameter segment; infinite if a curve where the normal vanishes lies between. */
static double middle_length(const struct search *search, const double place[2], const double vertex[2], const double position[3]) {
    double middle[2] = {0.5 * (place[0] + vertex[0]), 0.5 * (place[1] + vertex[1])}, from[3], over[3];
    if (search->graph->singular && sp_graph_crosses(search->surface, place, vertex)) return __builtin_inf();
    sp_graph_position(search->surface, place, from);
    sp_graph_position(search->surface, middle, over);
    return sp_distance3(from, over) + sp_distance3(over, position);
}

/* The cell of the grid that holds a place of the rectangle. */
static int32_t cell_of(const struct sp_graph *graph, int direction, double x) {
    double cell = (x - graph->lower[direction]) / graph->step[direction];
    return !(cell > 0) ? 0 : cell < graph->count[direction] ? (int32_t)cell : graph->count[direction] - 1;
}

/* The 4 x 4 vertices around a place of the rectangle. */
static void attach_parametric(const struct search *search, const double *end, struct sp_attachment *attached) {
    const struct sp_graph *graph = search->graph;
    double place[2] = {reduce(graph, 0, end[0]), reduce(graph, 1, end[1])};
    int32_t corner[2];
    for (int j = 0; j < 2; j++)
        corner[j] = cell_of(graph, j, place[j]) - (PATCH / 2 - 1);
    for (int32_t k = 0; k < PATCH * PATCH; k++) {
        int32_t at[2] = {corner[0] + k / PATCH, corner[1] + k % PATCH}, index[2];
        double vertex[2] = {graph->lower[0] + graph->step[0] * at[0], graph->lower[1] + graph->step[1] * at[1]};
        int inside = 1;
        for (int j = 0; j < 2; j++) {
            index[j] = graph->wraps[j] ? (at[j] + graph->count[j]) % graph->count[j] : at[j];
            inside &= index[j] >= 0 && index[j] < graph->count[j];
        }
        if (!inside) continue;
        int32_t number = index[0] * graph->count[1] + index[1];
        double length = middle_length(search, place, vertex, graph->positions + 3 * (size_t)number);
        if (!sp_is_finite(length)) continue;
        attached->vertex[attached->count] = number, attached->length[attached->count++] = length;
    }
}

/* The vertices within one and a half cell diagonals, on the same sheet. */
static void attach_implicit(const struct search *search, const double *end, struct sp_attachment *attached) {
    const struct sp_graph *graph = search->graph;
    struct sp_block block;
    sp_block_open(&block, SP_IMPLICIT_INPUTS, SP_IMPLICIT_VALUES);
    double normal[3], other[3];
    sp_block_put(&block, end);
    sp_block_evaluate(&block, search->surface->value);
    for (int32_t c = 0; c < 3; c++)
        normal[c] = sp_block_get(&block, 0, 1 + c);
    double size = sp_root(sp_dot3(normal, normal));
    for (int c = 0; c < 3; c++)
        normal[c] /= size;
    for (int32_t i = 0; i < graph->vertex_count && attached->count < SP_MAX_ATTACHED; i++) {
        const double *position = graph->positions + 3 * (size_t)i;
        if (!(sp_distance3(position, end) <= NEAR * graph->spacing)) continue;
        for (int c = 0; c < 3; c++)
            other[c] = (double)graph->normals[3 * (size_t)i + (size_t)c];
        double length = sp_graph_sheet_length(end, normal, position, other);
        if (!sp_is_finite(length)) continue;
        attached->vertex[attached->count] = i, attached->length[attached->count++] = length;
    }
}

static enum sp_status attach(struct search *search) {
    for (int end = 0; end < 2; end++) {
        const double *place = search->ends[end];
        for (int j = 0; j < (search->graph->kind == SP_IMPLICIT ? 3 : 2); j++)
            if (!sp_is_finite(place[j])) return SP_NOT_FINITE;
        if (search->graph->kind == SP_IMPLICIT)
            attach_implicit(search, place, search->attached + end);
        else
            attach_parametric(search, place, search->attached + end);
        if (search->attached[end].count == 0) return SP_OFF_SURFACE;
    }
    return SP_CONVERGED;
}

/* The shortest known way to an end. */
static double reach(const struct sp_front *front, const struct sp_attachment *attached) {
    double best = __builtin_inf();
    for (int32_t i = 0; i < attached->count; i++) {
        double length = front->distance[attached->vertex[i]] + attached->length[i];
        best = length < best ? length : best;
    }
    return best;
}

/* Distances from both ends as far as ways of interest go. */
static enum sp_status measure(struct search *search) {
    for (int end = 0; end < 2; end++)
        for (int32_t i = 0; i < search->attached[end].count; i++)
            sp_front_offer(search->front + end, search->attached[end].vertex[i], -1, search->attached[end].length[i]);
    struct sp_front *front = search->front;
    double limit = 0;
    for (;;) {
        search->best = reach(front, search->attached + 1);
        if (search->best <= limit) break;
        if (front->count == 0) return SP_DISCONNECTED;
        double nearest = front->distance[front->heap[0]];
        limit = GROWTH * (limit > nearest ? limit : nearest) + 1e-300;
        sp_front_advance(front, limit);
    }
    sp_front_advance(front, LONGEST * search->best);
    sp_front_advance(front + 1, LONGEST * search->best);
    return SP_CONVERGED;
}

/* The vertex with the shortest way through it that is not near a way already found; -1: none is short enough. */
static int32_t best_via(const struct search *search) {
    double least = LONGEST * search->best;
    int32_t best = -1;
    for (int32_t i = 0; i < search->graph->vertex_count; i++) {
        double length = search->front[0].distance[i] + search->front[1].distance[i];
        if (!(length < least) || search->taken.distance[i] < APART * search->best) continue;
        least = length, best = i;
    }
    return best;
}

/* The vertices of the way through one, in order. */
static int32_t trace(const struct search *search, int32_t via) {
    int32_t count = 0;
    for (int32_t i = via; i >= 0; i = search->front[0].before[i])
        count++;
    for (int32_t i = via, k = count; i >= 0; i = search->front[0].before[i])
        search->vertices[--k] = i;
    for (int32_t i = search->front[1].before[via]; i >= 0 && count < 2 * search->graph->vertex_count; i = search->front[1].before[i])
        search->vertices[count++] = i;
    return count;
}

static enum sp_status find_ways(struct search *search, struct sp_arena *arena, struct sp_graph_answer *answer) {
    for (int32_t found = 0; found < MOST_WAYS; found++) {
        int32_t via = best_via(search);
        if (via < 0) break;
        struct sp_way way = {search->surface, search->graph, search->ends[0], search->ends[1], search->vertices, trace(search, via)};
        double length = search->front[0].distance[via] + search->front[1].distance[via];
        enum sp_status status = sp_way_write(&way, length, arena, answer);
        if (status != SP_CONVERGED) return status;
        for (int32_t i = 0; i < way.count; i++)
            sp_front_offer(&search->taken, way.vertices[i], -1, 0);
        sp_front_advance(&search->taken, APART * search->best);
    }
    return SP_CONVERGED;
}

static int32_t clamped_points(int32_t point_count) {
    return point_count < 3 ? 3 : point_count > SP_GRAPH_MAX_POINTS ? SP_GRAPH_MAX_POINTS : point_count;
}

double sp_graph_search_bytes(const struct sp_graph *graph, int32_t point_count) {
    double front = graph->vertex_count * (double)(sizeof(double) + 3 * sizeof(int32_t)) + 4 * 16;
    double answer = SP_GRAPH_MAX_CANDIDATES * (3.0 * clamped_points(point_count) + 1) * sizeof(double) + 2 * 16;
    return 3 * front + 2.0 * graph->vertex_count * sizeof(int32_t) + 16 + answer + sp_way_bytes(graph);
}

int32_t sp_graph_search(const struct sp_surface *surface, const struct sp_graph *graph, const double ends[6], int32_t point_count,
                        struct sp_arena *arena, struct sp_graph_answer *answer) {
    struct search search = {.surface = surface, .graph = graph, .ends = {ends, ends + 3}};
    size_t places = (size_t)(SP_GRAPH_MAX_CANDIDATES * clamped_points(point_count));
    arena->used = 0;
    *answer = (struct sp_graph_answer){.distance = __builtin_nan(""), .point_count = clamped_points(point_count)};
    answer->places = sp_graph_take(arena, places, (graph->kind == SP_IMPLICIT ? 3 : 2) * sizeof(double));
    answer->lengths = sp_graph_take(arena, SP_GRAPH_MAX_CANDIDATES, sizeof(double));
    search.vertices = sp_graph_take(arena, 2 * (size_t)graph->vertex_count, sizeof(int32_t));
    int fits = answer->places && answer->lengths && search.vertices;
    for (int end = 0; end < 2; end++)
        fits = fits && sp_front_take(search.front + end, graph, arena);
    if (!fits || !sp_front_take(&search.taken, graph, arena)) return SP_OUT_OF_MEMORY;
    enum sp_status status = attach(&search);
    if (status == SP_CONVERGED) status = measure(&search);
    if (status != SP_CONVERGED) return status;
    answer->distance = search.best;
    return find_ways(&search, arena, answer);
}
