/* Graphs of surfaces, whatever their kind: sizes, memory, edges. The builders are in graph_parametric.c and graph_implicit.c. */
#include "graph_build.h"

#include <string.h>

static const double LEAST_COSINE = 0.3, LARGEST_SINE = 0.6;

/* Implicit, measured: 2 to 9 N^2 cells with a change of sign, 40 to 60 edges each. */
enum { PARAMETRIC_EDGES = 32, IMPLICIT_EDGES = 56, CELLS_PER_FACE = 6 };

static int32_t clamp(int32_t x, int32_t least, int32_t most) { return x < least ? least : x > most ? most : x; }

double sp_graph_build_bytes(int32_t kind, const struct sp_graph_options *options) {
    double resolution = clamp(options->resolution, 8, SP_GRAPH_MAX_RESOLUTION), vertex = 3 * sizeof(double) + 3 * sizeof(float) + 4;
    double edge = sizeof(struct sp_graph_edge);
    if (kind == SP_PARAMETRIC) {
        double vertices = 1.2 * (resolution + 2) * (resolution + 2);
        return vertices * (vertex + PARAMETRIC_EDGES * edge + 4 * 3 * sizeof(double) + 1) + 4096;
    }
    double flood = SP_GRAPH_FLOOD_CELLS / 4, cells = options->cell > 0 ? flood : CELLS_PER_FACE * resolution * resolution;
    double lookup = options->cell > 0 ? 1 << 17 : 2 * resolution * resolution * resolution;
    return cells * (vertex + 16 + IMPLICIT_EDGES * edge) + lookup * sizeof(int32_t) + 4096;
}

int32_t sp_graph_build(const struct sp_surface *surface, const struct sp_graph_options *options, struct sp_arena *arena,
                       struct sp_graph *graph) {
    struct sp_graph_options clean = *options;
    struct sp_builder builder = {surface, &clean, arena, graph, 0};
    clean.resolution = clamp(clean.resolution, 8, SP_GRAPH_MAX_RESOLUTION);
    arena->used = 0;
    *graph = (struct sp_graph){.kind = surface->kind};
    int sides = surface->kind == SP_IMPLICIT ? 3 : 2;
    for (int j = 0; j < sides; j++) {
        double side = clean.box[2 * j + 1] - clean.box[2 * j];
        if (!(side > 0 || (clean.cell > 0 && side == 0)) || !sp_is_finite(side)) return SP_NOT_FINITE;
    }
    return surface->kind == SP_IMPLICIT ? sp_graph_build_implicit(&builder) : sp_graph_build_parametric(&builder);
}

int sp_builder_take(struct sp_builder *builder) {
    struct sp_graph *graph = builder->graph;
    struct sp_arena *arena = builder->arena;
    size_t vertices = (size_t)graph->vertex_count;
    graph->positions = sp_graph_take(arena, vertices, 3 * sizeof(double));
    graph->normals = graph->kind == SP_IMPLICIT ? sp_graph_take(arena, vertices, 3 * sizeof(float)) : NULL;
    graph->first = sp_graph_take(arena, vertices + 1, sizeof(int32_t));
    size_t left = (arena->size - arena->used) / sizeof(struct sp_graph_edge), most = INT32_MAX / 2;
    builder->edge_capacity = (int32_t)(left < most ? left : most);
    graph->edges = sp_graph_take(arena, 0, sizeof(struct sp_graph_edge));
    return graph->positions && (graph->normals || graph->kind != SP_IMPLICIT) && graph->first;
}

int sp_builder_edge(struct sp_builder *builder, int32_t to, double length) {
    struct sp_graph *graph = builder->graph;
    if (!sp_is_finite(length)) return 1;
    if (graph->edge_count == builder->edge_capacity) return 0;
    graph->edges[graph->edge_count++] = (struct sp_graph_edge){to, (float)length};
    return 1;
}

/* sp_builder_take puts the arrays one behind the other, the edges last. */
static char *begin_of(const struct sp_graph *graph) { return (char *)graph->positions; }

double sp_graph_bytes(const struct sp_graph *graph) { return (double)((char *)(graph->edges + graph->edge_count) - begin_of(graph)); }

void sp_graph_keep(struct sp_graph *graph, void *block) {
    char *begin = begin_of(graph), *to = block;
    memcpy(to, begin, (size_t)sp_graph_bytes(graph));
    graph->edges = (struct sp_graph_edge *)(to + ((char *)graph->edges - begin));
    graph->first = (int32_t *)(to + ((char *)graph->first - begin));
    if (graph->normals) graph->normals = (float *)(to + ((char *)graph->normals - begin));
    graph->positions = (double *)to;
}

double sp_graph_sheet_length(const double a[3], const double normal_a[3], const double b[3], const double normal_b[3]) {
    double cosine = sp_dot3(normal_a, normal_b), chord[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]},
           length = sp_root(sp_dot3(chord, chord));
    double rise_a = sp_dot3(chord, normal_a), rise_b = sp_dot3(chord, normal_b), limit = LARGEST_SINE * length;
    int one_sheet = cosine > LEAST_COSINE && rise_a <= limit && rise_a >= -limit && rise_b <= limit && rise_b >= -limit;
    return one_sheet ? length * (1 + (1 - cosine) / 12) : __builtin_inf();
}

void *sp_graph_take(struct sp_arena *arena, size_t count, size_t item_bytes) { return sp_arena_take(arena, count, item_bytes); }

void sp_block_open(struct sp_block *block, int32_t inputs, int32_t outputs) {
    block->inputs = inputs, block->outputs = outputs, block->count = 0;
}

double sp_block_get(const struct sp_block *block, int32_t i, int32_t j) { return block->out[block->outputs * (i >> 1) + j][i & 1]; }

void sp_block_put(struct sp_block *block, const double *point) {
    int32_t i = block->count++;
    for (int32_t j = 0; j < block->inputs; j++) {
        sp_pair *at = block->in + block->inputs * (i >> 1) + j;
        *at = i & 1 ? (sp_pair){(*at)[0], point[j]} : sp_splat(point[j]);
    }
}

void sp_block_evaluate(struct sp_block *block, sp_evaluate evaluate) { evaluate((block->count + 1) / 2, block->in, block->out); }

double sp_dot3(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

double sp_distance3(const double a[3], const double b[3]) {
    double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
    return sp_root(x * x + y * y + z * z);
}
