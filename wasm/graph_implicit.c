/* The graph of an implicit surface: centres of cells in which f changes sign, moved onto f = 0; what lies within two cells on the same
 * sheet is joined. */
#include "chart.h"
#include "chord.h"
#include "graph_cells.h"
#include "scalar.h"
#include <string.h>

/* Vertices are joined whose cells are so many apart, at most, in each direction. */
enum { REACH = 2, ANYHOW = 1 };

/* A centre that moves farther than this many cells, or is left this far from f = 0, is not a point of its cell's piece of the surface. */
static const double FARTHEST = 1.0, SETTLED = 1e-3;
/* A centre is moved to a face of its cell, or beyond by rounding, of the width or of coordinates: surfaces may lie in planes of cells. */
static const double WITHIN = 1 + 1e-9, ROUNDING = 1e-14;

/* Cells that share a face, but not a sheet, are joined: as far apart as they are over a crease, but at most so many times their chord. */
static const double LOOSE = 2;

/* On a surface with creases no chord's middle is farther from it than this part of the chord. */
static const double FARTHEST_MIDDLE = 0.2;

/* Edges all around have a mean direction near zero, those of half a plane one of 0.64. */
static const double ONE_SIDED = 0.5;

/* Where the surface passes from cell to cell, and is too steep there to be joined, at more places than this part of the vertices, ways
 * are missing. Sharp edges alone, which ways lead around, part none. */
static const double MOST_GAPS = 0.01;

/* Newton comes to a node by halves: f is less steep there by this part, and more, than beside it. */
static const double NODE = 1e-3;

/* Around a rim so many chords are halved at most, it is no longer than so many times the first; and around all rims together so many, one
 * that comes to nothing counting for so many more: where that is not enough, cells are too coarse. */
enum { HALVINGS = 16, MOST_HALVED = 30000, IN_VAIN = 20 };
static const double FARTHEST_AROUND = 3;

/* Where sheets were followed around rims vertices lie on these, and none is looked for between places whose normals are so far apart. */
static const double OPPOSITE = -0.9;

/* Where the vertex of a cell is looked for. */
static void begin_at(const struct sp_cells *cells, int32_t cell, double at[3]) {
    if (cells->size[0] && cell >= cells->swept)
        memcpy(at, cells->list[cell].place, 3 * sizeof *at);
    else
        sp_cells_centre(cells, cells->list[cell].at, at);
}

/* Where f is constant around the centre, as within a body that is rounded by max(0, ...): the place nearest to it to which a corner leads.
 */
static void begin_at_corner(const struct sp_cells *cells, const double center[3], double position[3], double gradient[3]) {
    double nearest = __builtin_inf(), corner[3], place[3], normal[3];
    for (int32_t c = 0; c < 8; c++) {
        for (int32_t j = 0; j < 3; j++)
            corner[j] = center[j] + ((c >> j & 1) - 0.5) * cells->width[j];
        if (!sp_implicit_halve(cells->builder->surface, corner, corner, cells->builder->graph->spacing, place, normal)) continue;
        double away = distance_between(place, center);
        if (!(away < nearest)) continue;
        nearest = away;
        memcpy(position, place, sizeof place), memcpy(gradient, normal, sizeof normal);
    }
}

/* Writes one settled centre, or, if it went astray, a vertex without a normal. */
static void write_vertex(const struct sp_cells *cells, const struct sp_block *block, int32_t k, int32_t vertex) {
    struct sp_graph *graph = cells->builder->graph;
    double *position = graph->samples + (size_t)graph->width * (size_t)vertex, center[3], gradient[3];
    begin_at(cells, vertex, center);
    for (int32_t c = 0; c < 3; c++) {
        position[c] = block->in[SP_IMPLICIT_INPUTS * (k / 2) + c][k & 1];
        gradient[c] = sp_block_get(block, k, 1 + c);
    }
    double value = sp_block_get(block, k, 0);
    if (value != 0 && norm(gradient) == 0) {
        begin_at_corner(cells, center, position, gradient);
        value = 0;
    }
    double length = norm(gradient);
    int settled = length > 0 && value <= SETTLED * graph->spacing * length && -value <= SETTLED * graph->spacing * length &&
                  distance_between(position, center) <= FARTHEST * graph->spacing;
    for (int32_t c = 0; c < 3; c++) {
        double moved = absolute(center[c] - position[c]);
        if (!settled || 2 * moved > WITHIN * cells->width[c] + ROUNDING * absolute(center[c])) cells->list[vertex].faces = 0;
        graph->normals[3 * (size_t)vertex + (size_t)c] = (float)(settled ? gradient[c] / length : 0);
        if (!settled) position[c] = center[c];
    }
}

static void write_vertices(const struct sp_cells *cells) {
    const struct sp_graph *graph = cells->builder->graph;
    struct sp_block block;
    sp_block_open(&block, cells->builder->surface, 0);
    double point[3];
    for (int32_t first = 0; first < cells->count; first += block.capacity) {
        block.count = 0;
        for (int32_t i = first; i < cells->count && i < first + block.capacity; i++) {
            begin_at(cells, i, point);
            sp_block_put(&block, point);
        }
        sp_implicit_settle(cells->builder->surface, (block.count + 1) / 2, block.in, graph->spacing);
        sp_block_evaluate(&block);
        for (int32_t k = 0; k < block.count; k++)
            write_vertex(cells, &block, k, first + k);
    }
}

static double *sample_at(const struct sp_graph *graph, int32_t vertex) { return graph->samples + (size_t)graph->width * (size_t)vertex; }

/* What measures length at the vertices. */
static void sample_metric(const struct sp_cells *cells) {
    const struct sp_graph *graph = cells->builder->graph;
    struct sp_block block;
    sp_block_open(&block, cells->builder->surface, 1);
    for (int32_t first = 0; first < cells->count; first += block.count) {
        block.count = 0;
        for (int32_t i = first; i < cells->count && block.count < block.capacity; i++)
            sp_block_put(&block, sample_at(graph, i));
        sp_block_evaluate(&block);
        for (int32_t k = 0; k < block.count; k++)
            sp_block_sample(&block, k, sample_at(graph, first + k));
    }
}

static void read_vertex(const struct sp_graph *graph, int32_t vertex, double normal[3]) {
    for (int c = 0; c < 3; c++)
        normal[c] = (double)graph->normals[3 * (size_t)vertex + (size_t)c];
}

struct place {
    double sample[SP_GRAPH_WIDTH], normal[3];
};

static void read_place(const struct sp_graph *graph, int32_t vertex, struct place *place) {
    memcpy(place->sample, sample_at(graph, vertex), (size_t)graph->width * sizeof(double));
    read_vertex(graph, vertex, place->normal);
}

/* Whether the surface passes from one cell to another through a face that they share. */
static int passes(const struct sp_cell *from, const struct sp_cell *to) {
    int shared = 0, away = 0;
    for (int j = 0; j < 3; j++) {
        int32_t by = to->at[j] - from->at[j];
        away += by * by;
        if (by) shared = (by > 0 ? to : from)->faces >> j & 1;
    }
    return away == 1 && shared && from->faces && to->faces;
}

/* Whether two cells touch. */
static int are_beside(const struct sp_cell *from, const struct sp_cell *to) {
    int touch = 1;
    for (int j = 0; j < 3; j++)
        touch &= absolute(to->at[j] - from->at[j]) <= 1;
    return touch;
}

/* f and |grad f| in the middle of a chord. */
static void see_middle(const struct sp_surface *surface, const double *from, const double *to, double *value, double *steepness) {
    sp_pair middle[3], seen[SP_IMPLICIT_VALUES];
    for (int j = 0; j < 3; j++)
        middle[j] = sp_splat(0.5 * (from[j] + to[j]));
    surface->value(1, middle, seen);
    double gradient[3] = {seen[1][0], seen[2][0], seen[3][0]};
    *value = seen[0][0], *steepness = norm(gradient);
}

/* The place on f = 0 in the middle of a chord; 0: it does not settle, or at a node, where sheets meet. */
static int halve(const struct sp_graph *graph, const struct sp_surface *surface, const struct place *from, const struct place *to,
                 struct place *middle) {
    const double *ends[] = {from->sample, to->sample}, *normals[] = {from->normal, to->normal}, *at = middle->sample;
    if (!sp_implicit_halve(surface, ends[0], ends[1], graph->spacing, middle->sample, middle->normal) &&
        !(sp_implicit_between(surface, ends, normals, 0.5, graph->spacing, middle->sample) &&
          sp_implicit_halve(surface, at, at, graph->spacing, middle->sample, middle->normal)))
        return 0;
    if (graph->width > 3) sp_graph_sample(surface, middle->sample, middle->sample);
    double length = norm(middle->normal), value, steepness;
    for (int j = 0; j < 3; j++)
        middle->normal[j] /= length;
    see_middle(surface, ends[0], ends[1], &value, &steepness);
    return length > 0 && !(length < NODE * steepness);
}

/* How far it is from one vertex to another around a rim that is sharper than cells are wide: by places between them, which lie on one
 * sheet, each with the next. Infinite where they do not. */
static double length_around(struct sp_cells *cells, int32_t from, int32_t to) {
    const struct sp_graph *graph = cells->builder->graph;
    const struct sp_surface *surface = cells->builder->surface;
    struct place left, ahead[HALVINGS + 1];
    read_place(graph, from, &left), read_place(graph, to, ahead);
    double most = FARTHEST_AROUND * sp_graph_chord(surface, left.sample, ahead->sample, NULL), length = 0;
    if (cells->swept < cells->count && dot(left.normal, ahead->normal) < OPPOSITE) return __builtin_inf();
    for (int halvings = 0, next = 0; next >= 0;) {
        double part = sp_graph_sheet_length(surface, left.sample, left.normal, ahead[next].sample, ahead[next].normal);
        if (is_finite(part)) {
            length += part, left = ahead[next--];
            continue;
        }
        if (halvings++ == HALVINGS || cells->halved++ >= MOST_HALVED || !halve(graph, surface, &left, ahead + next, ahead + next + 1))
            return cells->halved += IN_VAIN, __builtin_inf();
        next++;
    }
    return length <= most ? length : __builtin_inf();
}

/* How many times their chord two places are apart over the line in which their tangent planes meet, when these are unfolded. */
static double stretch_over_crease(const double from[3], const double normal[3], const double to[3], const double other[3]) {
    double chord[3];
    for (int j = 0; j < 3; j++)
        chord[j] = to[j] - from[j];
    double aside = dot(chord, normal) * dot(chord, other), cosine = dot(normal, other);
    double longer = 2 * absolute(aside) / ((aside < 0 ? 1 + cosine : 1 - cosine) * dot(chord, chord));
    return longer < LOOSE * LOOSE - 1 ? root(1 + longer) : LOOSE;
}

/* Whether the middle of a chord is far from f = 0 beside its length: where bodies are joined, what is between may be one of them. */
static int leaves_surface(const struct sp_surface *surface, const double from[3], const double to[3]) {
    double value, steepness;
    see_middle(surface, from, to, &value, &steepness);
    return !(absolute(value) <= FARTHEST_MIDDLE * distance_between(from, to) * steepness);
}

/* How far it is from one vertex to a later one near it; infinite where they are not to be joined. Folds: whether that leads over a crease.
 */
static double length_between(struct sp_cells *cells, int32_t vertex, int32_t to, const double normal[3], int *folds) {
    const struct sp_graph *graph = cells->builder->graph;
    const struct sp_surface *surface = cells->builder->surface;
    const struct sp_graph_options *options = cells->builder->options;
    const double *here = sample_at(graph, vertex), *there = sample_at(graph, to);
    double other[3];
    read_vertex(graph, to, other);
    double length = sp_graph_sheet_length(surface, here, normal, there, other);
    if (is_finite(length) && options->loose > ANYHOW && leaves_surface(surface, here, there)) length = __builtin_inf();
    if (!is_finite(length) && are_beside(cells->list + vertex, cells->list + to)) length = length_around(cells, vertex, to);
    *folds = !is_finite(length) && options->loose && passes(cells->list + vertex, cells->list + to) &&
             (options->loose == ANYHOW || sp_chord_spans_crease(surface, here, normal, there, other, graph->spacing));
    return *folds ? stretch_over_crease(here, normal, there, other) * sp_graph_chord(surface, here, there, NULL) : length;
}

/* A vertex with those later ones whose cells are near: in a box, which is swept by layers, none of a lower layer. */
static int join_around(struct sp_cells *cells, int32_t vertex) {
    const struct sp_graph *graph = cells->builder->graph;
    const int32_t *center = cells->list[vertex].at;
    int is_plain = cells->builder->surface->metric == SP_INDUCED;
    double normal[3];
    read_vertex(graph, vertex, normal);
    for (int32_t k = cells->count == cells->swept ? 0 : -REACH; k <= REACH; k++)
        for (int32_t j = -REACH; j <= REACH; j++)
            for (int32_t i = -REACH; i <= REACH; i++)
                for (int32_t to = sp_cells_at(cells, (int32_t[3]){center[0] + i, center[1] + j, center[2] + k}); to >= 0;
                     to = cells->list[to].next) {
                    if (to <= vertex) continue;
                    int folds = 0;
                    double length = length_between(cells, vertex, to, normal, &folds);
                    cells->gaps += !is_finite(length) && passes(cells->list + vertex, cells->list + to);
                    /* A crease is no detail that is too small for the graph. Between the ends a metric was not looked at. */
                    double chord = !is_plain ? 0 : folds ? length : distance_between(sample_at(graph, vertex), sample_at(graph, to));
                    if (!sp_builder_join(cells->builder, vertex, to, length, chord)) return 0;
                }
    return 1;
}

/* Whether the edges of a vertex lead to one side, and one cell on, on the other, the surface goes on where no cell has it. */
static int is_end(const struct sp_cells *cells, int32_t vertex) {
    const struct sp_graph *graph = cells->builder->graph;
    const int32_t *at = cells->list[vertex].at;
    const double *here = sample_at(graph, vertex);
    int32_t first = graph->first[vertex], end = graph->first[vertex + 1], cell[3];
    double sum[3] = {0}, beyond[3], normal[3];
    for (int j = 0; j < 3; j++)
        if (at[j] < REACH || at[j] >= cells->size[j] - REACH) return 0;
    for (int32_t i = first; i < end; i++) {
        const double *there = sample_at(graph, graph->edges[i].to);
        double length = distance_between(here, there);
        for (int j = 0; j < 3; j++)
            sum[j] += (there[j] - here[j]) / length;
    }
    double all = norm(sum);
    if (!(all > ONE_SIDED * (end - first))) return 0;
    for (int j = 0; j < 3; j++)
        beyond[j] = here[j] - cells->width[j] * sum[j] / all;
    if (!sp_implicit_halve(cells->builder->surface, beyond, beyond, graph->spacing, beyond, normal)) return 0;
    for (int j = 0; j < 3; j++)
        cell[j] = (int32_t)((beyond[j] - cells->origin[j]) / cells->width[j]);
    return sp_cells_at(cells, cell) < 0;
}

/* Whether a surface is missing where it is thinner than cells are wide or, if it is smooth, full of gaps: what is cut there may hang
 * together by a longer way. */
static int is_torn(const struct sp_cells *cells) {
    int32_t loose = cells->builder->options->loose;
    if (!cells->size[0] || loose == ANYHOW) return 0;
    int is_found = !loose && cells->gaps > MOST_GAPS * cells->count;
    for (int32_t i = 0; !is_found && i < cells->count; i++)
        is_found = is_end(cells, i);
    return is_found;
}

int32_t sp_graph_build_implicit(struct sp_builder *builder) {
    struct sp_graph *graph = builder->graph;
    struct sp_cells cells = {.builder = builder};
    if (!sp_cells_find(&cells)) return SP_OUT_OF_MEMORY;
    graph->vertex_count = cells.count;
    graph->spacing = root(dot(cells.width, cells.width));
    if (!sp_builder_take(builder)) return SP_OUT_OF_MEMORY;
    write_vertices(&cells);
    if (graph->width > 3) sample_metric(&cells);
    sp_builder_begin(builder);
    for (int32_t i = 0; i < cells.count; i++)
        if (!sp_builder_turn(builder, i) || !join_around(&cells, i)) return SP_OUT_OF_MEMORY;
    graph->coarse = is_torn(&cells);
    return SP_CONVERGED;
}
