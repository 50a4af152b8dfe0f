/* Lengths of the shortest ways through a graph from one point to many. MATH.md, "The globally shortest path". */
#include "graph_field.h"
#include "graph_search.h"

#include <string.h>

/* Vertices of an implicit graph, sorted by the cube they lie in, as wide as attached vertices are far: those around a place are in 27
 * cubes. Cubes that share a bucket only bring vertices that are too far. */
struct buckets {
    int32_t *first, *vertices, *around;
    double width;
    uint32_t mask;
};

static uint32_t bucket_of(const struct buckets *buckets, const double cube[3]) {
    static const uint32_t PRIMES[3] = {73856093, 19349663, 83492791};
    static const double LARGEST = 4611686018427387904.0; /* 2^62 */
    uint32_t bucket = 0;
    for (int c = 0; c < 3; c++)
        bucket ^= (cube[c] > -LARGEST && cube[c] < LARGEST ? (uint32_t)(int64_t)cube[c] : 0) * PRIMES[c];
    return bucket & buckets->mask;
}

static void cube_of(const struct buckets *buckets, const double place[3], double cube[3]) {
    for (int c = 0; c < 3; c++)
        cube[c] = sp_round_down(place[c] / buckets->width);
}

static uint32_t home(const struct buckets *buckets, const struct sp_graph *graph, int32_t vertex) {
    double cube[3];
    cube_of(buckets, graph->samples + (size_t)graph->width * (size_t)vertex, cube);
    return bucket_of(buckets, cube);
}

static int sort_into_buckets(struct buckets *buckets, const struct sp_graph *graph, struct sp_arena *arena) {
    uint32_t count = 1;
    while (2 * count <= (uint32_t)graph->vertex_count)
        count *= 2;
    buckets->mask = count - 1, buckets->width = SP_ATTACHED_NEAR * graph->spacing;
    buckets->first = sp_arena_take(arena, (size_t)count + 2, sizeof(int32_t));
    buckets->vertices = sp_arena_take(arena, (size_t)graph->vertex_count, sizeof(int32_t));
    buckets->around = sp_arena_take(arena, (size_t)graph->vertex_count, sizeof(int32_t));
    if (!buckets->first || !buckets->vertices || !buckets->around) return 0;
    memset(buckets->first, 0, ((size_t)count + 2) * sizeof(int32_t));
    for (int32_t i = 0; i < graph->vertex_count; i++)
        buckets->first[home(buckets, graph, i) + 2]++;
    for (uint32_t k = 2; k < count + 2; k++)
        buckets->first[k] += buckets->first[k - 1];
    for (int32_t i = 0; i < graph->vertex_count; i++)
        buckets->vertices[buckets->first[home(buckets, graph, i) + 1]++] = i;
    return 1;
}

/* One search for many places. */
struct field {
    const struct sp_surface *surface;
    const struct sp_graph *graph;
    const struct sp_field_request *request;
    struct sp_front front;
    struct buckets buckets;
};

/* The vertices in the cubes around a place. */
static struct sp_candidates gather(const struct field *field, const double place[3]) {
    const struct buckets *buckets = &field->buckets;
    const struct sp_graph *graph = field->graph;
    struct sp_candidates found = {buckets->around, 0, field->front.distance};
    double cube[3], at[3];
    cube_of(buckets, place, cube);
    for (int k = 0; k < 27; k++) {
        at[0] = cube[0] + k % 3 - 1, at[1] = cube[1] + k / 3 % 3 - 1, at[2] = cube[2] + k / 9 - 1;
        uint32_t bucket = bucket_of(buckets, at);
        for (int32_t i = buckets->first[bucket]; i < buckets->first[bucket + 1] && found.count < graph->vertex_count; i++)
            buckets->around[found.count++] = buckets->vertices[i];
    }
    return found;
}

static void measure(const struct field *field) {
    const struct sp_field_request *request = field->request;
    int is_implicit = field->graph->kind == SP_IMPLICIT;
    struct sp_attachment attached;
    for (int32_t i = 0; i < request->count; i++) {
        const double *place = request->places + (is_implicit ? 3 : 2) * (size_t)i;
        struct sp_candidates near = {NULL, 0, NULL};
        if (is_implicit) near = gather(field, place);
        sp_graph_attach(field->surface, field->graph, place, is_implicit ? &near : NULL, &attached);
        double length = sp_front_reach(&field->front, &attached);
        double straight = sp_graph_near_length(field->surface, field->graph, request->from, place);
        request->lengths[i] = straight < length ? straight : length;
    }
}

double sp_graph_field_bytes(const struct sp_graph *graph) {
    double front = sizeof(double) + sizeof(struct sp_queued) + 2 * sizeof(int32_t),
           buckets = graph->kind == SP_IMPLICIT ? 3 * sizeof(int32_t) : 0;
    return graph->vertex_count * (front + buckets) + 2 * sizeof(int32_t) + 8 * 16;
}

int32_t sp_graph_field(const struct sp_surface *surface, const struct sp_graph *graph, const struct sp_field_request *request,
                       struct sp_arena *arena) {
    struct field field = {.surface = surface, .graph = graph, .request = request};
    struct sp_attachment attached;
    arena->used = 0;
    if (!sp_front_take(&field.front, graph, arena)) return SP_OUT_OF_MEMORY;
    if (graph->kind == SP_IMPLICIT && !sort_into_buckets(&field.buckets, graph, arena)) return SP_OUT_OF_MEMORY;
    enum sp_status status = sp_graph_attach(surface, graph, request->from, NULL, &attached);
    if (status != SP_CONVERGED) return status;
    for (int32_t i = 0; i < attached.count; i++)
        sp_front_offer(&field.front, attached.vertex[i], -1, attached.length[i]);
    sp_front_advance(&field.front, __builtin_inf());
    measure(&field);
    return SP_CONVERGED;
}
