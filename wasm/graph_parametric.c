/* The graph of a parametric surface: a grid over its rectangle with wide steps, so that ways in 32 directions are straight. Its lines are
 * spread so that the cells are about square on the surface. It is sampled on a grid twice as fine, which holds the vertices and the middles
 * of all edges; where edges do not resolve a density or a tensor, on one four times as fine, which holds their quarters. */
#include "graph_build.h"
#include "metric.h"
#include "normal.h"
#include "scalar.h"
#include <string.h>

enum { REACH = 3, WIDE_REACH = 5, HALVES = 2, QUARTERS = 4, BISECTIONS = 12, STEPS = 32, ACROSS = 8 };

/* A pole: the samples of an edge of the rectangle vary by less than this part of what lies beside it: the surface may be far larger
 * elsewhere, or infinite. A curve where the normal vanishes: after the
 * bisections it is this much shorter than at the ends of the segment. Rounding of the square of a normal that vanishes. */
static const double COLLAPSED = 1e-9, VANISHING = 1e-2, NOTHING = 1e-12;

/* The curvature by which no geodesics as long as the rectangle meet again (they would at pi^2), beside rounding of one that is zero. */
static const double FLAT = 1e-6;

/* A cell is steep that is more than twice as long one way as across it, (1 + 2^2)^2 / 2^2; and a surface where more than this part is. */
static const double STEEP = 6.25, MOST_STEEP = 0.1;

/* The square root of how much longer a rectangle may be one way than the other; and what lines are spread by at least, of the mean. */
static const double LEAST_RATIO = 0.3, LEAST_SPREAD = 0.05;

struct grid {
    struct sp_builder *builder;
    int32_t parts;              /* of a cell in the fine grid */
    int32_t cells[2], count[2]; /* samples of the fine grid: `parts` times the cells, and one more between walls */
    double *lines[2];           /* places of its lines, parts * cells + 1 */
    double *samples;            /* v fastest */
    double *normals;            /* 3 a vertex: S_u x S_v */
    double size;                /* how long the surface is both ways */
    int32_t steep;              /* vertices at which a cell is far longer one way than across it */
};

/* Where a line of the fine grid lies, beyond a seam too. */
static double place_of(const struct grid *grid, int direction, int32_t line) {
    const double *lines = grid->lines[direction];
    int32_t last = grid->parts * grid->cells[direction];
    if (line < 0) return lines[line + last] - (lines[last] - lines[0]);
    return line <= last ? lines[line] : lines[line - last] + (lines[last] - lines[0]);
}

static const double *sample_at(const struct grid *grid, int32_t i, int32_t j) {
    return grid->samples + (size_t)grid->builder->graph->width * ((size_t)i * (size_t)grid->count[1] + (size_t)j);
}

static size_t vertex_at(const struct grid *grid, int32_t i, int32_t j) {
    return (size_t)i * (size_t)grid->builder->graph->count[1] + (size_t)j;
}

static void take_samples(const struct grid *grid) {
    struct sp_block block;
    sp_block_open(&block, grid->builder->surface, 1);
    size_t total = (size_t)grid->count[0] * (size_t)grid->count[1], row = (size_t)grid->count[1];
    for (size_t first = 0; first < total; first += (size_t)block.count) {
        block.count = 0;
        for (size_t k = first; k < total && block.count < block.capacity; k++) {
            double place[2] = {place_of(grid, 0, (int32_t)(k / row)), place_of(grid, 1, (int32_t)(k % row))};
            sp_block_put(&block, place);
        }
        sp_block_evaluate(&block);
        for (int32_t k = 0; k < block.count; k++)
            sp_block_sample(&block, k, grid->samples + (size_t)grid->builder->graph->width * (first + (size_t)k));
    }
}

/* Whether a cell at a vertex is far longer one way on the surface than across it: (trace of its form)^2 over its determinant. */
static int is_cell_steep(const struct grid *grid, const struct sp_form *form, int lane, int32_t i, int32_t j) {
    double by[2] = {place_of(grid, 0, HALVES * i + 1) - place_of(grid, 0, HALVES * i - 1),
                    place_of(grid, 1, HALVES * j + 1) - place_of(grid, 1, HALVES * j - 1)};
    double e = form->e[lane] * by[0] * by[0], f = form->f[lane] * by[0] * by[1], g = form->g[lane] * by[1] * by[1];
    return (e + g) * (e + g) > STEEP * (e * g - f * f);
}

/* Counts the form at a vertex in the mean; one that is not finite, beside a pole of a metric, is none. */
static void add_form(struct grid *grid, const struct sp_form *form, int lane) {
    double *sum = grid->builder->graph->form, e = form->e[lane], f = form->f[lane], g = form->g[lane];
    if (!is_finite(e + f + g)) return;
    double part = 1.0 / grid->builder->graph->vertex_count;
    sum[0] += part * e, sum[1] += part * f, sum[2] += part * g;
}

/* Normals and steepness at the vertices (offset 0), or at the middles of cells nothing (offset 1); and the largest curvature there,
 * infinite where it is not a number. */
static double inspect(struct grid *grid, int32_t offset) {
    const int32_t *count = offset ? grid->cells : grid->builder->graph->count;
    struct sp_point point;
    double largest = -__builtin_inf();
    for (int32_t i = 0; i < count[0]; i++)
        for (int32_t j = 0; j < count[1]; j += 2) {
            int32_t other = j + 1 < count[1] ? j + 1 : j;
            sp_pair place[2] = {sp_splat(place_of(grid, 0, 2 * i + offset)),
                                {place_of(grid, 1, 2 * j + offset), place_of(grid, 1, 2 * other + offset)}};
            sp_metric_point(grid->builder->surface, place, &point);
            sp_pair normal[3];
            sp_store(sp_chart_normal(point.chart), normal);
            for (int lane = 0; lane < 2; lane++) {
                double curvature = point.geometry.curvature[lane];
                if (!(curvature <= largest)) largest = is_finite(curvature) ? curvature : __builtin_inf();
                if (offset || (lane && other == j)) continue;
                double *at = grid->normals + 3 * vertex_at(grid, i, j + lane);
                for (int k = 0; k < 3; k++)
                    at[k] = normal[k][lane];
                add_form(grid, &point.geometry.form, lane);
                grid->steep += is_cell_steep(grid, &point.geometry.form, lane, i, j + lane);
            }
        }
    return largest;
}

/* Whether the normal turns round between two places by vanishing. */
static int crosses_singular(const struct sp_surface *surface, const double a[2], const double b[2]) {
    struct sp_turn turn;
    return sp_normal_turn(surface, a, b, BISECTIONS, &turn) && dot(turn.normal, turn.normal) < VANISHING * VANISHING * turn.largest;
}

/* Whether the normal vanishes between a vertex and the one before it in a direction. A vertex at which it vanishes tells nothing: it is
 * passed over. */
static int vanishes_before(const struct grid *grid, int direction, int32_t i, int32_t j) {
    int32_t at[2] = {i, j}, before[2] = {i, j};
    before[direction]--;
    const double *here = grid->normals + 3 * vertex_at(grid, i, j), *there = grid->normals + 3 * vertex_at(grid, before[0], before[1]);
    while (before[direction] > 0 && dot(there, there) <= NOTHING * dot(here, here)) {
        before[direction]--;
        there = grid->normals + 3 * vertex_at(grid, before[0], before[1]);
    }
    if (!(dot(here, there) < 0)) return 0;
    double places[2][2];
    for (int d = 0; d < 2; d++)
        places[0][d] = place_of(grid, d, 2 * before[d]), places[1][d] = place_of(grid, d, 2 * at[d]);
    return crosses_singular(grid->builder->surface, places[0], places[1]);
}

/* Whether there is a curve on which the normal vanishes. */
static int is_singular(const struct grid *grid) {
    const int32_t *count = grid->builder->graph->count;
    for (int32_t i = 0; i < count[0]; i++)
        for (int32_t j = 0; j < count[1]; j++)
            if ((i > 0 && vanishes_before(grid, 0, i, j)) || (j > 0 && vanishes_before(grid, 1, i, j))) return 1;
    return 0;
}

/* How far the samples of a line are from a point, at most. What is not finite does not count, or makes all infinite. */
static double farthest(const struct grid *grid, int direction, int32_t line, const double *point, int finite) {
    double farthest = 0;
    for (int32_t k = 0; k < grid->count[1 - direction]; k++) {
        double away = distance_between(direction ? sample_at(grid, k, line) : sample_at(grid, line, k), point);
        if (!is_finite(away)) away = finite ? 0 : __builtin_inf();
        farthest = away > farthest ? away : farthest;
    }
    return farthest;
}

/* Which edges of the rectangle are points. Without positions none is known to be. */
static int find_collapsed(const struct grid *grid) {
    struct sp_graph *graph = grid->builder->graph;
    int any = 0;
    if (grid->builder->surface->metric == SP_TENSOR) return 0;
    for (int edge = 0; edge < 4; edge++) {
        int direction = edge / 2;
        if (graph->wraps[direction]) continue;
        int32_t line = edge & 1 ? grid->count[direction] - 1 : 0, beside = edge & 1 ? line - 2 : 2;
        const double *first = direction ? sample_at(grid, 0, line) : sample_at(grid, line, 0);
        double size = farthest(grid, direction, beside, first, 1);
        any |= graph->collapsed[edge] = farthest(grid, direction, line, first, 0) <= COLLAPSED * size;
    }
    return any;
}

/* A line around the seam, at most once. */
static int32_t around(int32_t line, int32_t count) { return line < 0 ? line + count : line < count ? line : line - count; }

/* The sample on line i, j of the fine grid, around the seams. */
static const double *sample_around(const struct grid *grid, int32_t i, int32_t j) {
    return sample_at(grid, around(i, grid->count[0]), around(j, grid->count[1]));
}

/* What leads from one line of the fine grid to another in a direction. */
static double way_between(const struct grid *grid, int direction, int32_t from, int32_t to) {
    return place_of(grid, direction, to) - place_of(grid, direction, from);
}

struct step {
    int32_t du, dv;
};

/* The length of an edge, measured in halves of cells, or in quarters. */
static double edge_length(const struct grid *grid, int32_t i, int32_t j, struct step step) {
    const struct sp_surface *surface = grid->builder->surface;
    double length = 0;
    for (int32_t k = 0; k < grid->parts; k += 2) {
        int32_t at[2] = {grid->parts * i + k * step.du, grid->parts * j + k * step.dv};
        const double *from = sample_around(grid, at[0], at[1]), *middle = sample_around(grid, at[0] + step.du, at[1] + step.dv),
                     *to = sample_around(grid, at[0] + 2 * step.du, at[1] + 2 * step.dv);
        if (surface->metric == SP_INDUCED) {
            length += distance_between(from, middle) + distance_between(middle, to);
            continue;
        }
        double place[2] = {place_of(grid, 0, at[0]), place_of(grid, 1, at[1])};
        double by[2] = {way_between(grid, 0, at[0], at[0] + 2 * step.du), way_between(grid, 1, at[1], at[1] + 2 * step.dv)};
        length += sp_graph_segment(surface, place, from, middle, to, by);
    }
    return length;
}

/* What an edge would be long if the surface were flat and its metric linear. */
static double edge_chord(const struct grid *grid, int32_t i, int32_t j, struct step step) {
    const struct sp_surface *surface = grid->builder->surface;
    int32_t parts = grid->parts, to_i = parts * (i + step.du), to_j = parts * (j + step.dv);
    const double *from = sample_at(grid, parts * i, parts * j), *to = sample_around(grid, to_i, to_j);
    if (surface->metric == SP_INDUCED) return distance_between(from, to);
    double by[2] = {way_between(grid, 0, parts * i, to_i), way_between(grid, 1, parts * j, to_j)};
    return sp_graph_chord(surface, from, to, by);
}

/* The vertex to which a step leads; -1: it is beyond a wall. */
static int32_t step_to(const struct sp_graph *graph, int32_t i, int32_t j, struct step step) {
    int32_t to[2] = {i + step.du, j + step.dv};
    for (int d = 0; d < 2; d++) {
        if (graph->wraps[d]) to[d] = around(to[d], graph->count[d]);
        if (to[d] < 0 || to[d] >= graph->count[d]) return -1;
    }
    return to[0] * graph->count[1] + to[1];
}

static int is_coprime(int32_t a, int32_t b) {
    while (b != 0) {
        int32_t rest = a % b;
        a = b, b = rest;
    }
    return a * a == 1;
}

/* Coprime steps of at most `reach` cells: 32 of 3, 80 of 5. */
static int32_t list_steps(int32_t reach, struct step *steps) {
    int32_t count = 0;
    for (int32_t du = -reach; du <= reach; du++)
        for (int32_t dv = -reach; dv <= reach; dv++)
            if (is_coprime(du, dv)) steps[count++] = (struct step){du, dv};
    return count;
}

/* Every vertex with those around it that a step leads to. */
static int join_all(const struct grid *grid, int32_t reach) {
    struct sp_builder *builder = grid->builder;
    const struct sp_graph *graph = builder->graph;
    struct step steps[SP_WIDE_EDGES];
    int32_t count = list_steps(reach, steps);
    sp_builder_begin(builder);
    for (int32_t vertex = 0; vertex < graph->vertex_count; vertex++) {
        int32_t i = vertex / graph->count[1], j = vertex % graph->count[1];
        if (!sp_builder_turn(builder, vertex)) return 0;
        for (int32_t k = 0; k < count; k++) {
            int32_t to = step_to(graph, i, j, steps[k]);
            if (to > vertex && !sp_builder_join(builder, vertex, to, edge_length(grid, i, j, steps[k]), edge_chord(grid, i, j, steps[k])))
                return 0;
        }
    }
    return 1;
}

/* The vertices' samples and the places of the lines. */
static void write_vertices(const struct grid *grid) {
    struct sp_graph *graph = grid->builder->graph;
    for (int32_t i = 0; i < graph->count[0]; i++)
        for (int32_t j = 0; j < graph->count[1]; j++)
            memcpy(graph->samples + (size_t)graph->width * vertex_at(grid, i, j), sample_at(grid, HALVES * i, HALVES * j),
                   (size_t)graph->width * sizeof(double));
    for (int d = 0; d < 2; d++)
        for (int32_t i = 0; i <= grid->cells[d]; i++)
            graph->lines[d][i] = grid->lines[d][HALVES * i];
}

static int may_be_wide(const struct grid *grid) {
    return grid->builder->options->level < SP_LAST_LEVEL && grid->cells[0] > WIDE_REACH && grid->cells[1] > WIDE_REACH;
}

/* Whether wide edges are measured in quarters: where they are long beside the waves of a metric. In space chords over the middle are
 * better: a way around a steep bump is shorter than edges straight over it, by about what these cut off. */
static int may_be_quartered(const struct grid *grid) {
    return may_be_wide(grid) && grid->builder->options->level == 0 && grid->builder->surface->metric != SP_INDUCED;
}

static int take_grid(struct grid *grid) {
    struct sp_builder *builder = grid->builder;
    size_t vertices = (size_t)builder->graph->vertex_count, parts = may_be_quartered(grid) ? QUARTERS : HALVES,
           samples = parts * parts * vertices;
    grid->samples = sp_arena_take(builder->arena, samples * (size_t)builder->graph->width, sizeof(double));
    grid->normals = sp_arena_take(builder->arena, vertices, 3 * sizeof(double));
    return grid->samples && grid->normals && sp_builder_take(builder);
}

/* How long the surface is, step by step in a direction: sums over lines across the rectangle. Returns the length of all. */
static double measure_steps(const struct grid *grid, int direction, double steps[STEPS]) {
    const struct sp_builder *builder = grid->builder;
    const double *along = builder->options->box + 2 * direction, *across = builder->options->box + 2 * (1 - direction);
    double samples[2][SP_GRAPH_WIDTH], by[2] = {0, 0}, place[2], total = 0;
    struct sp_block block;
    by[direction] = (along[1] - along[0]) / STEPS;
    for (int s = 0; s < STEPS; s++)
        steps[s] = 0;
    for (int k = 0; k < ACROSS; k++) {
        sp_block_open(&block, builder->surface, 1);
        place[1 - direction] = across[0] + (across[1] - across[0]) * ((k + 0.5) / ACROSS);
        for (int s = 0; s <= STEPS; s++) {
            place[direction] = along[0] + by[direction] * s;
            sp_block_put(&block, place);
        }
        sp_block_evaluate(&block);
        for (int s = 0; s <= STEPS; s++) {
            sp_block_sample(&block, s, samples[s & 1]);
            double length = s ? sp_graph_chord(builder->surface, samples[~s & 1], samples[s & 1], by) : 0;
            if (s && is_finite(length)) steps[s - 1] += length / ACROSS, total += length / ACROSS;
        }
    }
    return total;
}

/* Lines between which the surface is equally long, on an average. */
static void spread_lines(double *lines, int32_t count, const double range[2], const double steps[STEPS], double total) {
    double least = total > 0 ? LEAST_SPREAD * total / STEPS : 1, sum = total + STEPS * least, passed = 0;
    int s = 0;
    for (int32_t i = 0; i < count; i++) {
        double target = sum * ((double)i / count);
        while (s < STEPS - 1 && passed + steps[s] + least < target)
            passed += steps[s++] + least;
        lines[i] = range[0] + (range[1] - range[0]) * ((s + (target - passed) / (steps[s] + least)) / STEPS);
    }
    lines[count] = range[1];
}

/* Cells that are about square on the surface: resolution^2 in all. */
static int choose_lines(struct grid *grid) {
    double steps[2][STEPS], length[2], resolution = grid->builder->options->resolution;
    for (int d = 0; d < 2; d++)
        length[d] = measure_steps(grid, d, steps[d]);
    double ratio = root(length[0] / length[1]);
    ratio = !(ratio > LEAST_RATIO) ? LEAST_RATIO : ratio > 1 / LEAST_RATIO ? 1 / LEAST_RATIO : ratio;
    grid->cells[0] = (int32_t)(resolution * ratio + 0.5), grid->cells[1] = (int32_t)(resolution / ratio + 0.5);
    /* No step leads around more than once. */
    for (int d = 0; d < 2; d++)
        if (grid->cells[d] <= REACH) grid->cells[d] = REACH + 1;
    grid->size = length[0] + length[1];
    for (int d = 0; d < 2; d++) {
        grid->lines[d] = sp_arena_take(grid->builder->arena, QUARTERS * (size_t)grid->cells[d] + 1, sizeof(double));
        if (!grid->lines[d]) return 0;
        spread_lines(grid->lines[d], HALVES * grid->cells[d], grid->builder->options->box + 2 * d, steps[d], length[d]);
    }
    return 1;
}

/* A fine grid of so many parts of a cell. */
static void set_parts(struct grid *grid, int32_t parts) {
    grid->parts = parts;
    for (int j = 0; j < 2; j++)
        grid->count[j] = parts * grid->cells[j] + !grid->builder->graph->wraps[j];
}

/* Halves of cells in halves. */
static void quarter(struct grid *grid) {
    for (int d = 0; d < 2; d++) {
        double *lines = grid->lines[d];
        for (int32_t i = HALVES * grid->cells[d]; i > 0; i--)
            lines[2 * i] = lines[i], lines[2 * i - 1] = 0.5 * (lines[i - 1] + lines[i]);
    }
    set_parts(grid, QUARTERS);
    take_samples(grid);
}

/* All edges: wide ones where the usual ones do not resolve the surface, or on slopes, along which few of them lead. */
static int join_fitting(struct grid *grid) {
    struct sp_builder *builder = grid->builder;
    struct sp_graph *graph = builder->graph;
    int first = builder->options->level == 0, may_widen = may_be_wide(grid);
    int is_steep = !first && grid->steep > MOST_STEEP * graph->vertex_count;
    if (!is_steep || !may_widen) {
        if (!join_all(grid, REACH)) return 0;
        graph->coarse = first && builder->surface->metric == SP_INDUCED && sp_builder_is_coarse(builder);
        if (graph->coarse || sp_builder_resolves(builder) || !may_widen) return 1;
    }
    if (may_be_quartered(grid)) quarter(grid);
    return join_all(grid, WIDE_REACH);
}

int32_t sp_graph_build_parametric(struct sp_builder *builder) {
    struct sp_graph *graph = builder->graph;
    struct grid grid = {.builder = builder};
    if (!choose_lines(&grid)) return SP_OUT_OF_MEMORY;
    for (int j = 0; j < 2; j++) {
        graph->wraps[j] = !is_finite(builder->surface->lower[j]);
        graph->count[j] = grid.cells[j] + !graph->wraps[j];
    }
    set_parts(&grid, HALVES);
    graph->vertex_count = graph->count[0] * graph->count[1];
    if (!take_grid(&grid)) return SP_OUT_OF_MEMORY;
    take_samples(&grid);
    double flat = FLAT / (grid.size * grid.size), curvature = inspect(&grid, 0);
    int collapsed = find_collapsed(&grid);
    graph->singular = is_singular(&grid);
    graph->unique =
        curvature <= flat && !collapsed && !graph->singular && !graph->wraps[0] && !graph->wraps[1] && inspect(&grid, 1) <= flat;
    write_vertices(&grid);
    return join_fitting(&grid) ? SP_CONVERGED : SP_OUT_OF_MEMORY;
}
