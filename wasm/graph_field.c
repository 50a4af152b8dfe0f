/* Lengths of the shortest ways through a graph from one point to many. MATH.md, "The globally shortest path". */
#include "graph_field.h"
#include "graph_search.h"

#include <string.h>

/* Vertices of an implicit graph in slabs of x as wide as attached vertices are far: those around a place are in three that follow each
 * other. */
struct slabs {
    int32_t *first, *vertices;
    double lower, width;
    int32_t count;
};

static int32_t slab_of(const struct slabs *slabs, double x) {
    double slab = (x - slabs->lower) / slabs->width;
    return !(slab > 0) ? 0 : slab < slabs->count ? (int32_t)slab : slabs->count - 1;
}

static int sort_into_slabs(struct slabs *slabs, const struct sp_graph *graph, struct sp_arena *arena) {
    double lower = __builtin_inf(), upper = -__builtin_inf();
    for (int32_t i = 0; i < graph->vertex_count; i++) {
        double x = graph->positions[3 * (size_t)i];
        lower = x < lower ? x : lower, upper = x > upper ? x : upper;
    }
    double wide = (upper - lower) / (SP_ATTACHED_NEAR * graph->spacing);
    slabs->count = wide >= 0 && wide < graph->vertex_count ? (int32_t)wide + 1 : graph->vertex_count;
    slabs->lower = lower, slabs->width = SP_ATTACHED_NEAR * graph->spacing;
    slabs->first = sp_graph_take(arena, (size_t)slabs->count + 2, sizeof(int32_t));
    slabs->vertices = sp_graph_take(arena, (size_t)graph->vertex_count, sizeof(int32_t));
    if (!slabs->first || !slabs->vertices) return 0;
    memset(slabs->first, 0, ((size_t)slabs->count + 2) * sizeof(int32_t));
    for (int32_t i = 0; i < graph->vertex_count; i++)
        slabs->first[slab_of(slabs, graph->positions[3 * (size_t)i]) + 2]++;
    for (int32_t k = 2; k < slabs->count + 2; k++)
        slabs->first[k] += slabs->first[k - 1];
    for (int32_t i = 0; i < graph->vertex_count; i++)
        slabs->vertices[slabs->first[slab_of(slabs, graph->positions[3 * (size_t)i]) + 1]++] = i;
    return 1;
}

static struct sp_candidates around(const struct slabs *slabs, double x) {
    int32_t slab = slab_of(slabs, x), begin = slab > 0 ? slab - 1 : 0, end = slab + 2 < slabs->count ? slab + 2 : slabs->count;
    return (struct sp_candidates){slabs->vertices + slabs->first[begin], slabs->first[end] - slabs->first[begin]};
}

/* One search for many places. */
struct field {
    const struct sp_surface *surface;
    const struct sp_graph *graph;
    const struct sp_field_request *request;
    struct sp_front front;
    struct slabs slabs;
};

static void measure(const struct field *field) {
    const struct sp_field_request *request = field->request;
    int is_implicit = field->graph->kind == SP_IMPLICIT;
    struct sp_attachment attached;
    for (int32_t i = 0; i < request->count; i++) {
        const double *place = request->places + (is_implicit ? 3 : 2) * (size_t)i;
        struct sp_candidates near = {NULL, 0};
        if (is_implicit) near = around(&field->slabs, place[0]);
        sp_graph_attach(field->surface, field->graph, place, is_implicit ? &near : NULL, &attached);
        double length = sp_front_reach(&field->front, &attached);
        double straight = sp_graph_near_length(field->surface, field->graph, request->from, place);
        request->lengths[i] = straight < length ? straight : length;
    }
}

double sp_graph_field_bytes(const struct sp_graph *graph) {
    return graph->vertex_count * (double)(sizeof(double) + 5 * sizeof(int32_t)) + 2 * sizeof(int32_t) + 7 * 16;
}

int32_t sp_graph_field(const struct sp_surface *surface, const struct sp_graph *graph, const struct sp_field_request *request,
                       struct sp_arena *arena) {
    struct field field = {.surface = surface, .graph = graph, .request = request};
    struct sp_attachment attached;
    arena->used = 0;
    if (!sp_front_take(&field.front, graph, arena)) return SP_OUT_OF_MEMORY;
    if (graph->kind == SP_IMPLICIT && !sort_into_slabs(&field.slabs, graph, arena)) return SP_OUT_OF_MEMORY;
    enum sp_status status = sp_graph_attach(surface, graph, request->from, NULL, &attached);
    if (status != SP_CONVERGED) return status;
    for (int32_t i = 0; i < attached.count; i++)
        sp_front_offer(&field.front, attached.vertex[i], -1, attached.length[i]);
    sp_front_advance(&field.front, __builtin_inf());
    measure(&field);
    return SP_CONVERGED;
}
