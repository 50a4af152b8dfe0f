/* The graph of a parametric surface: a grid over its rectangle with wide steps, so that ways in 32 directions are straight. The surface is
 * sampled once, on a grid twice as fine, which holds the vertices and the middles of all edges. */
#include "graph_build.h"

enum { REACH = 3, BISECTIONS = 12, PROBES = 8 };

/* A pole: the samples of an edge of the rectangle vary by less than this part of the patch. A curve where the normal vanishes: after the
 * bisections it is this much shorter than at the ends of the segment. Rounding of a curvature that is zero, and
 * of the square of a normal that is. */
static const double COLLAPSED = 1e-9, VANISHING = 1e-2, FLAT = 1e-10, NOTHING = 1e-12;

/* The square root of how much longer a rectangle may be one way than the other. */
static const double LEAST_RATIO = 0.3;

struct grid {
    const struct sp_builder *builder;
    int32_t cells[2], samples[2]; /* samples of the fine grid: twice the cells, and one more between walls */
    double *positions;            /* 3 a sample, v fastest */
    double *normals;              /* 3 a vertex: S_u x S_v */
    int8_t *sheet;                /* a vertex: -1 on the other side of a curve where the normal turns over */
};

static int is_even(int32_t x) { return (x & 1) == 0; }

static double place_of(const struct grid *grid, int direction, int32_t sample) {
    const double *range = grid->builder->options->box + 2 * direction;
    if (sample == 2 * grid->cells[direction]) return range[1];
    return range[0] + (range[1] - range[0]) * ((double)sample / (2 * grid->cells[direction]));
}

static const double *position_at(const struct grid *grid, int32_t i, int32_t j) {
    return grid->positions + 3 * ((size_t)i * (size_t)grid->samples[1] + (size_t)j);
}

static size_t vertex_at(const struct grid *grid, int32_t i, int32_t j) {
    return (size_t)i * (size_t)grid->builder->graph->count[1] + (size_t)j;
}

static void sample_positions(const struct grid *grid) {
    struct sp_block block;
    sp_block_open(&block, SP_PARAMETRIC_INPUTS, SP_PARAMETRIC_VALUES);
    size_t total = (size_t)grid->samples[0] * (size_t)grid->samples[1];
    for (size_t first = 0; first < total; first += 2 * SP_GRAPH_BLOCK) {
        block.count = 0;
        for (size_t k = first; k < total && k < first + 2 * SP_GRAPH_BLOCK; k++) {
            int32_t i = (int32_t)(k / (size_t)grid->samples[1]), j = (int32_t)(k % (size_t)grid->samples[1]);
            double place[2] = {place_of(grid, 0, i), place_of(grid, 1, j)};
            sp_block_put(&block, place);
        }
        sp_block_evaluate(&block, grid->builder->surface->value);
        for (int32_t k = 0; k < block.count; k++)
            for (int32_t c = 0; c < 3; c++)
                grid->positions[3 * (first + (size_t)k) + (size_t)c] = sp_block_get(&block, k, c);
    }
}

static void jet_normal(const struct sp_block *block, int32_t k, double normal[3]) {
    double u[3], v[3];
    for (int32_t c = 0; c < 3; c++)
        u[c] = sp_block_get(block, k, 3 + c), v[c] = sp_block_get(block, k, 6 + c);
    normal[0] = u[1] * v[2] - u[2] * v[1], normal[1] = u[2] * v[0] - u[0] * v[2], normal[2] = u[0] * v[1] - u[1] * v[0];
}

/* Is the curvature certainly positive, or not a number? Second fundamental form times |N|: l n - m^2, against its own rounding. */
static int curves_outwards(const struct sp_block *block, int32_t k, const double normal[3]) {
    double form[3], size[3], length = sp_root(sp_dot3(normal, normal));
    for (int32_t s = 0; s < 3; s++) {
        double second[3] = {sp_block_get(block, k, 9 + 3 * s), sp_block_get(block, k, 10 + 3 * s), sp_block_get(block, k, 11 + 3 * s)};
        form[s] = sp_dot3(second, normal), size[s] = length * sp_root(sp_dot3(second, second));
    }
    double rounding = FLAT * (size[0] * size[2] + size[1] * size[1]);
    return !(form[0] * form[2] - form[1] * form[1] <= rounding);
}

/* Normals at the vertices, and whether the surface curves outwards anywhere at a vertex (offset 0) or at the middle of a cell (offset 1).
 */
static int inspect(const struct grid *grid, int32_t offset) {
    struct sp_block block;
    sp_block_open(&block, SP_PARAMETRIC_INPUTS, SP_PARAMETRIC_JET);
    const int32_t *count = offset ? grid->cells : grid->builder->graph->count;
    int outwards = 0;
    double normal[3];
    for (int32_t i = 0; i < count[0]; i++)
        for (int32_t first = 0; first < count[1]; first += 2 * SP_GRAPH_BLOCK) {
            block.count = 0;
            for (int32_t j = first; j < count[1] && j < first + 2 * SP_GRAPH_BLOCK; j++) {
                double place[2] = {place_of(grid, 0, 2 * i + offset), place_of(grid, 1, 2 * j + offset)};
                sp_block_put(&block, place);
            }
            sp_block_evaluate(&block, grid->builder->surface->jet);
            for (int32_t k = 0; k < block.count; k++) {
                jet_normal(&block, k, normal);
                outwards |= curves_outwards(&block, k, normal);
                for (int c = 0; c < 3 && !offset; c++)
                    grid->normals[3 * vertex_at(grid, i, first + k) + (size_t)c] = normal[c];
            }
        }
    return outwards;
}

void sp_graph_position(const struct sp_surface *surface, const double place[2], double position[3]) {
    sp_pair in[SP_PARAMETRIC_INPUTS] = {sp_splat(place[0]), sp_splat(place[1])}, out[SP_PARAMETRIC_VALUES];
    surface->value(1, in, out);
    for (int c = 0; c < 3; c++)
        position[c] = out[c][0];
}

void sp_graph_normal(const struct sp_surface *surface, const double place[2], double normal[3]) {
    struct sp_block block;
    sp_block_open(&block, SP_PARAMETRIC_INPUTS, SP_PARAMETRIC_JET);
    sp_block_put(&block, place);
    sp_block_evaluate(&block, surface->jet);
    jet_normal(&block, 0, normal);
}

int sp_graph_crosses(const struct sp_surface *surface, const double a[2], const double b[2]) {
    double start[3], end[3], middle[3], low = 0, high = 1;
    sp_graph_normal(surface, a, start);
    sp_graph_normal(surface, b, end);
    if (!(sp_dot3(start, end) < 0)) return 0;
    for (int i = 0; i < BISECTIONS; i++) {
        double t = 0.5 * (low + high), place[2] = {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])};
        sp_graph_normal(surface, place, middle);
        if (sp_dot3(middle, start) > 0)
            low = t;
        else
            high = t;
    }
    double larger = sp_dot3(start, start) > sp_dot3(end, end) ? sp_dot3(start, start) : sp_dot3(end, end);
    return sp_dot3(middle, middle) < VANISHING * VANISHING * larger;
}

/* The side of a vertex from that of the one before it in a direction. A vertex at which the normal vanishes tells nothing: it is passed
 * over. */
static int8_t side_after(const struct grid *grid, int direction, int32_t i, int32_t j) {
    int32_t at[2] = {i, j}, before[2] = {i, j};
    before[direction]--;
    const double *here = grid->normals + 3 * vertex_at(grid, i, j), *there = grid->normals + 3 * vertex_at(grid, before[0], before[1]);
    int8_t side = grid->sheet[vertex_at(grid, before[0], before[1])];
    while (before[direction] > 0 && sp_dot3(there, there) <= NOTHING * sp_dot3(here, here)) {
        before[direction]--;
        there = grid->normals + 3 * vertex_at(grid, before[0], before[1]);
    }
    if (!(sp_dot3(here, there) < 0)) return side;
    double places[2][2];
    for (int d = 0; d < 2; d++)
        places[0][d] = place_of(grid, d, 2 * before[d]), places[1][d] = place_of(grid, d, 2 * at[d]);
    return sp_graph_crosses(grid->builder->surface, places[0], places[1]) ? (int8_t)-side : side;
}

/* Curves on which the normal vanishes divide the rectangle; crossing one changes the side. */
static int divide_sheets(const struct grid *grid) {
    const int32_t *count = grid->builder->graph->count;
    int divided = 0;
    grid->sheet[0] = 1;
    for (int32_t i = 0; i < count[0]; i++)
        for (int32_t j = 0; j < count[1]; j++) {
            if (i + j == 0) continue;
            int8_t side = side_after(grid, j > 0, i, j);
            grid->sheet[vertex_at(grid, i, j)] = side;
            divided |= side < 0;
        }
    return divided;
}

/* Which edges of the rectangle are points. */
static int find_collapsed(const struct grid *grid) {
    struct sp_graph *graph = grid->builder->graph;
    const double *origin = position_at(grid, 0, 0);
    double size = 0;
    int any = 0;
    for (size_t k = 0; k < (size_t)grid->samples[0] * (size_t)grid->samples[1]; k++) {
        double away = sp_distance3(grid->positions + 3 * k, origin);
        size = away > size ? away : size;
    }
    for (int edge = 0; edge < 4; edge++) {
        int direction = edge / 2;
        if (graph->wraps[direction]) continue;
        int32_t fixed = edge & 1 ? grid->samples[direction] - 1 : 0;
        double variation = 0;
        for (int32_t k = 0; k < grid->samples[1 - direction]; k++) {
            const double *here = direction ? position_at(grid, k, fixed) : position_at(grid, fixed, k);
            double away = sp_distance3(here, direction ? position_at(grid, 0, fixed) : position_at(grid, fixed, 0));
            variation = away <= variation ? variation : away;
        }
        any |= graph->collapsed[edge] = variation <= COLLAPSED * size;
    }
    return any;
}

/* Where a step leads: false beyond a wall. */
static int step_to(const struct sp_graph *graph, int direction, int32_t from, int32_t by, int32_t *to) {
    int32_t count = graph->count[direction];
    *to = from + by;
    if (graph->wraps[direction]) *to = (*to + count) % count;
    return *to >= 0 && *to < count;
}

static int join(const struct grid *grid, int32_t i, int32_t j, int32_t du, int32_t dv) {
    struct sp_graph *graph = grid->builder->graph;
    int32_t to_i, to_j;
    if (!step_to(graph, 0, i, du, &to_i) || !step_to(graph, 1, j, dv, &to_j)) return 1;
    size_t here = vertex_at(grid, i, j), there = vertex_at(grid, to_i, to_j);
    if (grid->sheet[here] != grid->sheet[there]) return 1;
    int32_t middle_i = (2 * i + du + grid->samples[0]) % grid->samples[0], middle_j = (2 * j + dv + grid->samples[1]) % grid->samples[1];
    const double *middle = position_at(grid, middle_i, middle_j);
    double length = sp_distance3(position_at(grid, 2 * i, 2 * j), middle) + sp_distance3(middle, position_at(grid, 2 * to_i, 2 * to_j));
    return sp_builder_edge((struct sp_builder *)grid->builder, (int32_t)there, length);
}

static int is_coprime(int32_t a, int32_t b) {
    if (a == 0 || b == 0) return a * a + b * b == 1;
    return !(is_even(a) && is_even(b)) && !(a % 3 == 0 && b % 3 == 0);
}

static int join_all(const struct grid *grid) {
    struct sp_graph *graph = grid->builder->graph;
    int fits = 1;
    for (int32_t i = 0; i < graph->count[0]; i++)
        for (int32_t j = 0; j < graph->count[1]; j++) {
            graph->first[vertex_at(grid, i, j)] = graph->edge_count;
            for (int32_t k = 0; k < (2 * REACH + 1) * (2 * REACH + 1) && fits; k++) {
                int32_t du = k / (2 * REACH + 1) - REACH, dv = k % (2 * REACH + 1) - REACH;
                if (is_coprime(du, dv)) fits = join(grid, i, j, du, dv);
            }
        }
    graph->first[graph->vertex_count] = graph->edge_count;
    return fits;
}

static void write_positions(const struct grid *grid) {
    struct sp_graph *graph = grid->builder->graph;
    for (int32_t i = 0; i < graph->count[0]; i++)
        for (int32_t j = 0; j < graph->count[1]; j++)
            for (int c = 0; c < 3; c++)
                graph->positions[3 * vertex_at(grid, i, j) + (size_t)c] = position_at(grid, 2 * i, 2 * j)[c];
}

static int take_grid(struct grid *grid) {
    struct sp_builder *builder = (struct sp_builder *)grid->builder;
    size_t samples = (size_t)grid->samples[0] * (size_t)grid->samples[1], vertices = (size_t)builder->graph->vertex_count;
    grid->positions = sp_graph_take(builder->arena, samples, 3 * sizeof(double));
    grid->normals = sp_graph_take(builder->arena, vertices, 3 * sizeof(double));
    grid->sheet = sp_graph_take(builder->arena, vertices, 1);
    return grid->positions && grid->normals && grid->sheet && sp_builder_take(builder);
}

/* Cells that are about square on the surface: their numbers in both directions, resolution^2 in all. From the chords of an 8 x 8 grid. */
static void choose_cells(struct grid *grid) {
    double position[PROBES][PROBES][3], length[2] = {0, 0}, resolution = grid->builder->options->resolution;
    grid->cells[0] = grid->cells[1] = PROBES - 1;
    for (int32_t i = 0; i < PROBES; i++)
        for (int32_t j = 0; j < PROBES; j++) {
            double place[2] = {place_of(grid, 0, 2 * i), place_of(grid, 1, 2 * j)};
            sp_graph_position(grid->builder->surface, place, position[i][j]);
            if (i) length[0] += sp_distance3(position[i][j], position[i - 1][j]);
            if (j) length[1] += sp_distance3(position[i][j], position[i][j - 1]);
        }
    double ratio = sp_root(length[0] / length[1]);
    ratio = !(ratio > LEAST_RATIO) ? LEAST_RATIO : ratio > 1 / LEAST_RATIO ? 1 / LEAST_RATIO : ratio;
    if (!sp_is_finite(length[0] + length[1])) ratio = 1;
    grid->cells[0] = (int32_t)(resolution * ratio + 0.5), grid->cells[1] = (int32_t)(resolution / ratio + 0.5);
}

int32_t sp_graph_build_parametric(struct sp_builder *builder) {
    struct sp_graph *graph = builder->graph;
    struct grid grid = {.builder = builder};
    choose_cells(&grid);
    for (int j = 0; j < 2; j++) {
        graph->wraps[j] = !sp_is_finite(builder->surface->lower[j]);
        graph->count[j] = grid.cells[j] + !graph->wraps[j];
        grid.samples[j] = 2 * grid.cells[j] + !graph->wraps[j];
        graph->lower[j] = builder->options->box[2 * j];
        graph->step[j] = (builder->options->box[2 * j + 1] - graph->lower[j]) / grid.cells[j];
    }
    graph->vertex_count = graph->count[0] * graph->count[1];
    if (!take_grid(&grid)) return SP_OUT_OF_MEMORY;
    sample_positions(&grid);
    int outwards = inspect(&grid, 0) | inspect(&grid, 1), collapsed = find_collapsed(&grid);
    graph->singular = divide_sheets(&grid);
    graph->unique = !outwards && !collapsed && !graph->singular && !graph->wraps[0] && !graph->wraps[1];
    write_positions(&grid);
    return join_all(&grid) ? SP_CONVERGED : SP_OUT_OF_MEMORY;
}
