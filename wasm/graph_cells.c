/* Cells of a cubic grid that a surface passes: a sweep of a box, layer by layer, or a flood from a point, from face to face. */
#include "graph_cells.h"
#include "chart.h"
#include "scalar.h"

enum { FLOOD_BITS = 17, FLOOD_SLOTS = 1 << FLOOD_BITS };

/* A short side of a box has this part of the cells of the longest, at least: in space thin things are thin, in the grid they are not. */
enum { LEAST_PART = 4 };

/* Where coarser cells than those of this level are enough, corners tell of all sheets. */
enum { GROWN = 2 };

/* Whatever the shape of a flood, eight cells of a row lie side by side, and what is next to them anywhere else: long rows would pile up. */
static uint32_t home(const int32_t at[3]) {
    uint32_t x = (uint32_t)at[0], y = (uint32_t)at[1], z = (uint32_t)at[2];
    uint32_t mixed = (x >> 3) * 0x9e3779b1U + y * 0x85ebca77U + z * 0xc2b2ae3dU;
    return mixed >> (32 - (FLOOD_BITS - 3)) << 3 | (x & 7);
}

int32_t *sp_cells_slot(const struct sp_cells *cells, const int32_t at[3]) {
    for (uint32_t slot = home(at);; slot = (slot + 1) & (FLOOD_SLOTS - 1)) {
        int32_t *found = cells->slots + slot;
        if (*found < 0) return found;
        const int32_t *cell = cells->list[*found].at;
        if (cell[0] == at[0] && cell[1] == at[1] && cell[2] == at[2]) return found;
    }
}

static int take_slots(struct sp_cells *cells, uint32_t count) {
    cells->slots = sp_arena_take(cells->builder->arena, count, sizeof(int32_t));
    for (uint32_t i = 0; cells->slots && i < count; i++)
        cells->slots[i] = -1;
    return cells->slots != NULL;
}

/* What is left of the arena becomes the list; close_list gives back what was not used. */
static void open_list(struct sp_cells *cells) {
    struct sp_arena *arena = cells->builder->arena;
    size_t most = (arena->size - arena->used) / sizeof(struct sp_cell);
    cells->capacity = (int32_t)(most < 1U << 24 ? most : 1U << 24);
    cells->list = sp_arena_take(arena, 0, sizeof(struct sp_cell));
}

static int close_list(struct sp_cells *cells) {
    return sp_arena_take(cells->builder->arena, (size_t)cells->count, sizeof(struct sp_cell)) != NULL;
}

void sp_cells_corner(const struct sp_cells *cells, int32_t i, int32_t j, int32_t k, double point[3]) {
    point[0] = cells->origin[0] + cells->width[0] * i;
    point[1] = cells->origin[1] + cells->width[1] * j;
    point[2] = cells->origin[2] + cells->width[2] * k;
}

void sp_cells_centre(const struct sp_cells *cells, const int32_t at[3], double point[3]) {
    sp_cells_corner(cells, at[0], at[1], at[2], point);
    for (int c = 0; c < 3; c++)
        point[c] += 0.5 * cells->width[c];
}

/* Bit 0: f < 0. Bit 1: f >= 0. Neither where f is not a number. */
static uint8_t sign_bits(double f) { return (uint8_t)((f < 0) | (f >= 0) << 1); }

/* The corners of one layer of the box. */
static void sweep_layer(const struct sp_cells *cells, int32_t k, uint8_t *signs) {
    struct sp_block block;
    sp_block_open(&block, cells->builder->surface, 0);
    int32_t columns = cells->size[0] + 1, total = columns * (cells->size[1] + 1);
    double point[3];
    for (int32_t first = 0; first < total; first += block.capacity) {
        block.count = 0;
        for (int32_t p = first; p < total && p < first + block.capacity; p++) {
            sp_cells_corner(cells, p % columns, p / columns, k, point);
            sp_block_put(&block, point);
        }
        sp_block_evaluate(&block);
        for (int32_t p = 0; p < block.count; p++)
            signs[first + p] = sign_bits(sp_block_get(&block, p, 0));
    }
}

/* The bits of the corners of one face of a cell. */
static int face_bits(const uint8_t signs[8], int axis, int upper) {
    int bits = 0;
    for (int c = 0; c < 8; c++)
        if ((c >> axis & 1) == upper) bits |= signs[c];
    return bits;
}

/* See struct sp_cell. */
static int32_t faces_of(const uint8_t signs[8]) {
    int32_t faces = SP_INSIDE;
    for (int axis = 0; axis < 3; axis++)
        faces |= (face_bits(signs, axis, 0) == 3) << axis;
    return faces;
}

/* Lists the cells between two layers of corners in which f changes sign. */
static int list_layer(struct sp_cells *cells, int32_t k, const uint8_t *below, const uint8_t *above) {
    int32_t columns = cells->size[0] + 1;
    for (int32_t j = 0; j < cells->size[1]; j++)
        for (int32_t i = 0; i < cells->size[0]; i++) {
            int32_t p = i + columns * j, q = p + columns;
            const uint8_t signs[8] = {below[p], below[p + 1], below[q], below[q + 1], above[p], above[p + 1], above[q], above[q + 1]};
            if ((signs[0] | signs[1] | signs[2] | signs[3] | signs[4] | signs[5] | signs[6] | signs[7]) != 3) continue;
            if (cells->count == cells->capacity) return 0;
            cells->list[cells->count++] = (struct sp_cell){.at = {i, j, k}, .faces = faces_of(signs), .next = -1};
        }
    return 1;
}

static int sweep_box(struct sp_cells *cells) {
    const struct sp_graph_options *options = cells->builder->options;
    double longest = 0;
    for (int j = 0; j < 3; j++) {
        double side = options->box[2 * j + 1] - options->box[2 * j];
        longest = side > longest ? side : longest;
    }
    for (int j = 0; j < 3; j++) {
        double side = options->box[2 * j + 1] - options->box[2 * j];
        cells->size[j] = (int32_t)(side / longest * options->resolution + 0.999);
        if (cells->size[j] < options->resolution / LEAST_PART) cells->size[j] = options->resolution / LEAST_PART;
        cells->origin[j] = options->box[2 * j], cells->width[j] = side / cells->size[j];
    }
    size_t corners = (size_t)(cells->size[0] + 1) * (size_t)(cells->size[1] + 1);
    uint8_t *below = sp_arena_take(cells->builder->arena, corners, 1), *above = sp_arena_take(cells->builder->arena, corners, 1);
    uint32_t columns = (uint32_t)cells->size[0], rows = (uint32_t)cells->size[1];
    if (!below || !above || !take_slots(cells, columns * rows * (uint32_t)cells->size[2])) return 0;
    open_list(cells);
    sweep_layer(cells, 0, below);
    for (int32_t k = 0; k < cells->size[2]; k++) {
        sweep_layer(cells, k + 1, above);
        if (!list_layer(cells, k, below, above)) return 0;
        uint8_t *turned = below;
        below = above, above = turned;
    }
    for (int32_t i = 0; i < cells->count; i++)
        cells->slots[sp_cells_place(cells, cells->list[i].at)] = i;
    cells->swept = cells->count;
    return (options->level < GROWN || options->loose || sp_cells_grow(cells)) && close_list(cells);
}

/* The signs at the corners of a cell; corner c lies at x + (c & 1), y + (c >> 1 & 1), z + (c >> 2). */
static void read_corners(const struct sp_cells *cells, const int32_t at[3], uint8_t signs[8]) {
    struct sp_block block;
    sp_block_open(&block, cells->builder->surface, 0);
    double point[3];
    for (int32_t c = 0; c < 8; c++) {
        sp_cells_corner(cells, at[0] + (c & 1), at[1] + (c >> 1 & 1), at[2] + (c >> 2), point);
        sp_block_put(&block, point);
    }
    sp_block_evaluate(&block);
    for (int32_t c = 0; c < 8; c++)
        signs[c] = sign_bits(sp_block_get(&block, c, 0));
}

static int is_within_reach(const struct sp_cells *cells, const int32_t at[3]) {
    const struct sp_graph_options *options = cells->builder->options;
    double ends[2][3], middle[3];
    for (int j = 0; j < 3; j++)
        ends[0][j] = options->box[2 * j], ends[1][j] = options->box[2 * j + 1], middle[j] = ends[0][j] + at[j] * options->cell;
    return options->reach <= 0 || distance_between(ends[0], middle) + distance_between(ends[1], middle) <= options->reach;
}

/* Lists the neighbours into which the surface passes through a face; of the first cell, which it may pass by its corners, all six. */
static void flood_around(struct sp_cells *cells, int32_t from, int32_t most) {
    uint8_t signs[8];
    read_corners(cells, cells->list[from].at, signs);
    cells->list[from].faces = faces_of(signs);
    for (int face = 0; face < 6 && cells->count < most; face++) {
        int axis = face / 2, upper = face % 2;
        if (from != 0 && face_bits(signs, axis, upper) != 3) continue;
        struct sp_cell next = cells->list[from];
        next.at[axis] += 2 * upper - 1, next.faces = 0;
        if (!is_within_reach(cells, next.at)) continue;
        int32_t *slot = sp_cells_slot(cells, next.at);
        if (*slot >= 0) continue;
        *slot = cells->count;
        cells->list[cells->count++] = next;
    }
}

/* The grid lies so that the point is at the middle of cell (0, 0, 0), which is listed whether f changes sign at its corners or not. */
static int flood(struct sp_cells *cells) {
    double width = cells->builder->options->cell;
    for (int j = 0; j < 3; j++)
        cells->width[j] = width, cells->origin[j] = cells->builder->options->box[2 * j] - 0.5 * width;
    if (!take_slots(cells, FLOOD_SLOTS)) return 0;
    open_list(cells);
    int32_t most = cells->capacity < SP_GRAPH_FLOOD_CELLS ? cells->capacity : SP_GRAPH_FLOOD_CELLS;
    if (most < 1) return 0;
    cells->list[0] = (struct sp_cell){.next = -1}, cells->count = 1;
    *sp_cells_slot(cells, cells->list[0].at) = 0;
    for (int32_t i = 0; i < cells->count; i++)
        flood_around(cells, i, most);
    return cells->count < cells->capacity && close_list(cells);
}

int sp_cells_find(struct sp_cells *cells) { return cells->builder->options->cell > 0 ? flood(cells) : sweep_box(cells); }
