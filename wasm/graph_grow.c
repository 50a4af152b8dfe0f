/* Sheets that are nearer to each other than a cell is wide show no change of sign at its corners, or one for both: they are followed from
 * where they were seen, a cell's width at a time, around rims too. MATH.md, "The globally shortest path". */
#include "chart.h"
#include "graph_cells.h"
#include "scalar.h"

/* In widths of a cell: how near another place of the same sheet is to one that needs no cell of its own, as it is guessed and as it is
 * found; and how far the two are from each other at most. */
static const double GUESSED = 0.8, FOUND = 0.5, FARTHEST = 1;
/* Of two places on one sheet, cosine between normals. */
static const double SAME_SHEET = 0.3;
/* No more cells are added than this times those that are there. */
enum { MOST = 2, DIRECTIONS = 4 };

/* The cell in which a place lies. */
static void locate(const struct sp_cells *cells, struct sp_cell *cell) {
    for (int j = 0; j < 3; j++)
        cell->at[j] = (int32_t)sp_round_down((cell->place[j] - cells->origin[j]) / cells->width[j]);
}

/* Puts a place on the surface. Returns 0 where it does not come to rest within a distance. */
static int settle(const struct sp_cells *cells, const double from[3], double most, struct sp_cell *cell) {
    if (!sp_implicit_halve(cells->builder->surface, from, from, most, cell->place, cell->normal)) return 0;
    double length = norm(cell->normal);
    for (int j = 0; j < 3; j++)
        cell->normal[j] /= length;
    return length > 0 && distance_between(from, cell->place) <= most;
}

/* Whether a cell at or beside a place has its vertex on the same sheet, so near. */
static int is_covered(const struct sp_cells *cells, const struct sp_cell *cell, double near) {
    for (int32_t beside = 0; beside < 27; beside++) {
        int32_t at[3] = {cell->at[0] + beside % 3 - 1, cell->at[1] + beside / 3 % 3 - 1, cell->at[2] + beside / 9 - 1};
        for (int32_t i = sp_cells_at(cells, at); i >= 0; i = cells->list[i].next) {
            const struct sp_cell *other = cells->list + i;
            if (dot(cell->normal, other->normal) > SAME_SHEET && distance_between(cell->place, other->place) < near) return 1;
        }
    }
    return 0;
}

/* A place one step aside along the tangent plane. */
static struct sp_cell step_aside(const struct sp_cells *cells, const struct sp_cell *from, int direction, double width) {
    const double *n = from->normal;
    struct sp_cell next = *from;
    int least = 0;
    for (int j = 1; j < 3; j++)
        if (absolute(n[j]) < absolute(n[least])) least = j;
    double along[3], by = (direction & 2 ? -width : width) / root(1 - n[least] * n[least]);
    for (int j = 0; j < 3; j++)
        along[j] = by * ((j == least) - n[least] * n[j]);
    for (int j = 0; j < 3; j++) {
        int k = (j + 1) % 3, l = (j + 2) % 3;
        next.place[j] += direction & 1 ? n[k] * along[l] - n[l] * along[k] : along[j];
    }
    return locate(cells, &next), next;
}

/* A cell for the sheet in the next place in some direction. Returns 0 if the arena is full. */
static int go_on(struct sp_cells *cells, int32_t from, int direction, double width) {
    struct sp_cell next = step_aside(cells, cells->list + from, direction, width);
    double guess[3] = {next.place[0], next.place[1], next.place[2]};
    if (is_covered(cells, &next, GUESSED * width) || !settle(cells, guess, FARTHEST * width, &next)) return 1;
    locate(cells, &next);
    int32_t *slot = is_covered(cells, &next, FOUND * width) ? NULL : sp_cells_slot_in(cells, next.at);
    if (!slot) return 1;
    if (cells->count == cells->capacity) return 0;
    next.faces = 0, next.next = *slot, *slot = cells->count;
    cells->list[cells->count++] = next;
    return 1;
}

int sp_cells_grow(struct sp_cells *cells) {
    double diagonal = norm(cells->width), centre[3];
    for (int32_t i = 0; i < cells->count; i++) {
        struct sp_cell *cell = cells->list + i;
        sp_cells_centre(cells, cell->at, centre);
        if (!settle(cells, centre, diagonal, cell)) cell->normal[0] = cell->normal[1] = cell->normal[2] = 0;
    }
    for (int32_t i = 0; i < cells->count && cells->count < (1 + MOST) * cells->swept; i++)
        for (int direction = 0; direction < DIRECTIONS && norm(cells->list[i].normal) > 0; direction++)
            if (!go_on(cells, i, direction, diagonal / root(3))) return 0;
    return 1;
}
