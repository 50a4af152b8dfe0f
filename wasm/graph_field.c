/* Lengths of the shortest ways through a graph from one point to many. MATH.md, "The globally shortest path". */
#include "graph_field.h"
#include "graph_search.h"
#include "scalar.h"

#include <string.h>

/* Points in space, sorted by the cube they lie in. Cubes may share a bucket. */
struct buckets {
    int32_t *first, *points;
};

/* One search for many places. Vertices of an implicit graph lie in cubes as wide as attached vertices are far: those around a place are in
 * 27 of them. Places are taken cube by cube. */
struct field {
    const struct sp_surface *surface;
    const struct sp_graph *graph;
    const struct sp_field_request *request;
    struct sp_front front;
    struct buckets vertices, places;
    struct sp_reached *around; /* the vertices in and around the cube of the last place, `count` of them */
    double width, cube[3];
    int32_t count;
    uint32_t mask;
};

static uint32_t bucket_of(const struct field *field, const double cube[3]) {
    static const uint32_t PRIMES[3] = {73856093, 19349663, 83492791};
    static const double LARGEST = 4611686018427387904.0; /* 2^62 */
    uint32_t bucket = 0;
    for (int c = 0; c < 3; c++)
        bucket ^= (cube[c] > -LARGEST && cube[c] < LARGEST ? (uint32_t)(int64_t)cube[c] : 0) * PRIMES[c];
    return bucket & field->mask;
}

static void cube_of(const struct field *field, const double place[3], double cube[3]) {
    for (int c = 0; c < 3; c++)
        cube[c] = sp_round_down(place[c] / field->width);
}

static uint32_t home(const struct field *field, const double place[3]) {
    double cube[3];
    cube_of(field, place, cube);
    return bucket_of(field, cube);
}

/* points: `count` of them, each `stride` numbers after the one before. */
static int sort(const struct field *field, const double *points, int32_t stride, int32_t count, struct sp_arena *arena,
                struct buckets *sorted) {
    size_t heads = (size_t)field->mask + 3;
    sorted->first = sp_arena_take(arena, heads, sizeof(int32_t));
    sorted->points = sp_arena_take(arena, (size_t)count, sizeof(int32_t));
    if (!sorted->first || !sorted->points) return 0;
    memset(sorted->first, 0, heads * sizeof(int32_t));
    for (int32_t i = 0; i < count; i++)
        sorted->first[home(field, points + (size_t)stride * (size_t)i) + 2]++;
    for (size_t k = 2; k < heads; k++)
        sorted->first[k] += sorted->first[k - 1];
    for (int32_t i = 0; i < count; i++)
        sorted->points[sorted->first[home(field, points + (size_t)stride * (size_t)i) + 1]++] = i;
    return 1;
}

static int sort_all(struct field *field, struct sp_arena *arena) {
    const struct sp_graph *graph = field->graph;
    uint32_t buckets = 1;
    while (2 * buckets <= (uint32_t)graph->vertex_count)
        buckets *= 2;
    field->mask = buckets - 1, field->width = SP_ATTACHED_NEAR * graph->spacing, field->cube[0] = not_a_number();
    field->around = sp_arena_take(arena, (size_t)graph->vertex_count, sizeof(struct sp_reached));
    return field->around && sort(field, graph->samples, graph->width, graph->vertex_count, arena, &field->vertices) &&
           sort(field, field->request->places, 3, field->request->count, arena, &field->places);
}

/* Adds the vertices of a cube. */
static void add_cube(struct field *field, const double cube[3]) {
    const struct sp_graph *graph = field->graph;
    const struct buckets *vertices = &field->vertices;
    uint32_t bucket = bucket_of(field, cube);
    for (int32_t i = vertices->first[bucket]; i < vertices->first[bucket + 1] && field->count < graph->vertex_count; i++) {
        struct sp_reached *reached = field->around + field->count;
        double own[3];
        reached->vertex = vertices->points[i], reached->distance = field->front.distance[reached->vertex];
        memcpy(reached->place, graph->samples + (size_t)graph->width * (size_t)reached->vertex, sizeof reached->place);
        cube_of(field, reached->place, own);
        field->count += distance_between(own, cube) == 0;
    }
}

/* The length of the shortest way to a place of an implicit surface. */
static double reach_implicit(struct field *field, const double place[3]) {
    double cube[3];
    cube_of(field, place, cube);
    if (distance_between(cube, field->cube) != 0) {
        field->count = 0;
        memcpy(field->cube, cube, sizeof cube);
        for (int k = 0; k < 27; k++) {
            double at[3] = {cube[0] + k % 3 - 1, cube[1] + k / 3 % 3 - 1, cube[2] + k / 9 - 1};
            add_cube(field, at);
        }
    }
    return sp_graph_reach(field->surface, field->graph, place, field->around, field->count);
}

static double reach_parametric(const struct field *field, const double place[2]) {
    struct sp_attachment attached;
    sp_graph_attach(field->surface, field->graph, place, &attached);
    return sp_front_reach(&field->front, &attached);
}

static void measure(struct field *field) {
    const struct sp_field_request *request = field->request;
    int is_implicit = field->graph->kind == SP_IMPLICIT;
    for (int32_t k = 0; k < request->count; k++) {
        int32_t i = is_implicit ? field->places.points[k] : k;
        const double *place = request->places + (is_implicit ? 3 : 2) * (size_t)i;
        double length = is_implicit ? reach_implicit(field, place) : reach_parametric(field, place);
        double straight = sp_graph_near_length(field->surface, field->graph, request->from, place);
        request->lengths[i] = straight < length ? straight : length;
    }
}

double sp_graph_field_bytes(const struct sp_graph *graph, int32_t count) {
    double bytes = graph->vertex_count * (double)SP_FRONT_BYTES + 16 * 16;
    /* At most as many buckets as vertices. */
    if (graph->kind == SP_IMPLICIT)
        bytes += graph->vertex_count * (double)(sizeof(struct sp_reached) + 3 * sizeof(int32_t)) + count * (double)sizeof(int32_t);
    return bytes;
}

int32_t sp_graph_field(const struct sp_surface *surface, const struct sp_graph *graph, const struct sp_field_request *request,
                       struct sp_arena *arena) {
    struct field field = {.surface = surface, .graph = graph, .request = request};
    struct sp_attachment attached;
    arena->used = 0;
    if (!sp_front_take(&field.front, graph, arena)) return SP_OUT_OF_MEMORY;
    if (graph->kind == SP_IMPLICIT && !sort_all(&field, arena)) return SP_OUT_OF_MEMORY;
    enum sp_status status = sp_graph_attach(surface, graph, request->from, &attached);
    if (status != SP_CONVERGED) return status;
    for (int32_t i = 0; i < attached.count; i++)
        sp_front_offer(&field.front, attached.vertex[i], -1, attached.length[i]);
    sp_front_advance(&field.front, __builtin_inf());
    measure(&field);
    return SP_CONVERGED;
}
