/* Graphs of surfaces, whatever their kind: sizes, memory, edges. The builders are in graph_parametric.c and graph_implicit.c. */
#include "graph_build.h"
#include "scalar.h"

#include <string.h>

/* Implicit, measured: 2 to 9 N^2 cells with a change of sign, 40 to 60 edges each. */
enum { IMPLICIT_EDGES = 56, CELLS_PER_FACE = 6 };

/* An edge longer than its chord by more than a surface of a radius of 2.5 edges makes it, or a metric that changes as much along it; how
 * many may be, where the graph resolves the surface, and where it does so nearly. */
static const double BENT = 0.02, MOST_BENT = 0.01, COARSE = 0.25;

/* A flood that ends with the cells it began with saw no surface. */
enum { FIRST_CELLS = 7 };

double sp_graph_build_bytes(int32_t kind, const struct sp_graph_options *options) {
    double resolution = clamp(options->resolution, 8, SP_GRAPH_MAX_RESOLUTION), vertex = 4 * sizeof(double) + 3 * sizeof(float) + 8;
    double edge = sizeof(struct sp_graph_edge);
    if (kind == SP_PARAMETRIC) {
        double vertices = 1.2 * (resolution + 2) * (resolution + 2);
        int32_t edges = options->level < SP_LAST_LEVEL ? SP_WIDE_EDGES : SP_USUAL_EDGES, samples = options->level == 0 ? 16 : 4;
        return vertices * (vertex + edges * edge + samples * (4.0 * sizeof(double)) + 1) + 4096;
    }
    double flood = SP_GRAPH_FLOOD_CELLS / 4, cells = options->cell > 0 ? flood : CELLS_PER_FACE * resolution * resolution;
    double lookup = options->cell > 0 ? 1 << 17 : resolution * resolution * resolution;
    return cells * (vertex + 72 + IMPLICIT_EDGES * edge) + lookup * sizeof(int32_t) + 4096;
}

int32_t sp_graph_build(const struct sp_surface *surface, const struct sp_graph_options *options, struct sp_arena *arena,
                       struct sp_graph *graph) {
    struct sp_graph_options clean = *options;
    struct sp_builder builder = {.surface = surface, .options = &clean, .arena = arena, .graph = graph};
    clean.resolution = clamp(clean.resolution, 8, SP_GRAPH_MAX_RESOLUTION);
    arena->used = 0;
    *graph = (struct sp_graph){.kind = surface->kind, .width = sp_graph_width(surface)};
    graph->stretch = surface->metric == SP_INDUCED ? 1 : sp_graph_has_positions(surface) ? __builtin_inf() : 0;
    int sides = surface->kind == SP_IMPLICIT ? 3 : 2;
    for (int j = 0; j < sides; j++) {
        double side = clean.box[2 * j + 1] - clean.box[2 * j];
        if (!(side > 0 || clean.cell > 0) || !is_finite(side)) return SP_NOT_FINITE;
    }
    int32_t status = surface->kind == SP_IMPLICIT ? sp_graph_build_implicit(&builder) : sp_graph_build_parametric(&builder);
    if (!is_finite(graph->stretch)) graph->stretch = 0;
    graph->step *= 2.0 / graph->edge_count;
    graph->resolved = status == SP_CONVERGED && graph->vertex_count > FIRST_CELLS && sp_builder_resolves(&builder);
    return status;
}

int sp_builder_resolves(const struct sp_builder *builder) { return builder->bent <= MOST_BENT * builder->graph->edge_count; }

int sp_builder_is_coarse(const struct sp_builder *builder) { return builder->bent > COARSE * builder->graph->edge_count; }

int sp_builder_take(struct sp_builder *builder) {
    struct sp_graph *graph = builder->graph;
    struct sp_arena *arena = builder->arena;
    size_t vertices = (size_t)graph->vertex_count;
    builder->waits = sp_arena_take(arena, vertices, sizeof(int32_t));
    graph->samples = sp_arena_take(arena, vertices * (size_t)graph->width, sizeof(double));
    for (int j = 0; j < 2; j++)
        graph->lines[j] = sp_arena_take(arena, (size_t)graph->count[j] + 1, sizeof(double));
    graph->normals = graph->kind == SP_IMPLICIT ? sp_arena_take(arena, vertices, 3 * sizeof(float)) : NULL;
    graph->first = sp_arena_take(arena, vertices + 1, sizeof(int32_t));
    graph->edges = sp_arena_take(arena, 0, sizeof(struct sp_graph_edge));
    builder->end = (struct sp_waiting *)(arena->base + (arena->size & ~(size_t)15));
    return builder->waits && graph->samples && graph->lines[0] && graph->lines[1] && (graph->normals || graph->kind != SP_IMPLICIT) &&
           graph->first && graph->edges;
}

void sp_builder_begin(struct sp_builder *builder) {
    builder->graph->step = 0;
    builder->graph->first[0] = builder->graph->edge_count = builder->bent = builder->waiting = builder->spare = 0;
    memset(builder->waits, 0, (size_t)builder->graph->vertex_count * sizeof(int32_t));
}

/* Room for so many edges, and one that waits. */
static int is_room(const struct sp_builder *builder, int32_t edges) {
    const char *free = (const char *)(builder->graph->edges + builder->graph->edge_count);
    return (const char *)(builder->end - builder->waiting - 1) - free >= (ptrdiff_t)sizeof(struct sp_graph_edge) * edges;
}

int sp_builder_turn(struct sp_builder *builder, int32_t vertex) {
    struct sp_graph *graph = builder->graph;
    int32_t count = 0;
    graph->first[vertex] = graph->edge_count;
    for (int32_t i = builder->waits[vertex]; i; i = builder->end[-i].next)
        count++;
    if (!is_room(builder, count)) return 0;
    graph->edge_count += count;
    graph->first[vertex + 1] = graph->edge_count;
    struct sp_graph_edge *edge = graph->edges + graph->edge_count;
    for (int32_t i = builder->waits[vertex], next; i; i = next) {
        struct sp_waiting *one = builder->end - i;
        *--edge = (struct sp_graph_edge){one->to, one->length};
        next = one->next, one->next = builder->spare, builder->spare = i;
    }
    return 1;
}

/* Of an edge under a metric; in space all are longer than their chords. */
static void note_stretch(const struct sp_builder *builder, int32_t vertex, int32_t to, double length) {
    struct sp_graph *graph = builder->graph;
    if (builder->surface->metric == SP_INDUCED || !(graph->stretch > 0)) return;
    const double *samples = graph->samples;
    double chord = distance_between(samples + (ptrdiff_t)graph->width * vertex, samples + (ptrdiff_t)graph->width * to);
    if (length < graph->stretch * chord) graph->stretch = length / chord;
}

int sp_builder_join(struct sp_builder *builder, int32_t vertex, int32_t to, double length, double chord) {
    struct sp_graph *graph = builder->graph;
    if (!is_finite(length)) return 1;
    if (!is_room(builder, 1)) return 0;
    builder->bent += 2 * !(absolute(length - chord) <= BENT * chord);
    note_stretch(builder, vertex, to, length);
    graph->edges[graph->edge_count++] = (struct sp_graph_edge){to, (float)length};
    graph->step += length;
    graph->first[vertex + 1] = graph->edge_count;
    int32_t i = builder->spare;
    if (i)
        builder->spare = builder->end[-i].next;
    else
        i = ++builder->waiting;
    builder->end[-i] = (struct sp_waiting){builder->waits[to], vertex, (float)length};
    builder->waits[to] = i;
    return 1;
}

/* sp_builder_take puts the arrays one behind the other, the edges last. */
static char *begin_of(const struct sp_graph *graph) { return (char *)graph->samples; }

double sp_graph_bytes(const struct sp_graph *graph) { return (double)((char *)(graph->edges + graph->edge_count) - begin_of(graph)); }

void sp_graph_keep(struct sp_graph *graph, void *block) {
    char *begin = begin_of(graph), *to = block;
    memcpy(to, begin, (size_t)sp_graph_bytes(graph));
    graph->edges = (struct sp_graph_edge *)(to + ((char *)graph->edges - begin));
    graph->first = (int32_t *)(to + ((char *)graph->first - begin));
    if (graph->normals) graph->normals = (float *)(to + ((char *)graph->normals - begin));
    for (int j = 0; j < 2; j++)
        graph->lines[j] = (double *)(to + ((char *)graph->lines[j] - begin));
    graph->samples = (double *)to;
}
