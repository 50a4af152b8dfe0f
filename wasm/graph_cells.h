/* The cells of a cubic grid in which f changes sign, found by a sweep of a box or by a flood from a point. */
#ifndef SURFPATH_GRAPH_CELLS_H
#define SURFPATH_GRAPH_CELLS_H

#include "graph_build.h"

enum { SP_INSIDE = 8 };

struct sp_cell {
    int32_t at[3];
    int32_t faces; /* 0 if its vertex lies outside it; else SP_INSIDE, and bit j: the surface passes the lower face across axis j */
    int32_t next;  /* another one in the same place, for a sheet that the corners do not tell of; -1: none */
    /* Where a sheet was found, and its unit normal; not known where no others were looked for. */
    double place[3], normal[3];
};

/* The cells found so far, at the end of the arena, and a table from a cell's place to its number. */
struct sp_cells {
    struct sp_builder *builder;
    double origin[3], width[3];
    int32_t size[3]; /* cells of the box; 0 in a flood */
    struct sp_cell *list;
    int32_t count, capacity;
    int32_t *slots; /* numbers of cells, -1: free. Of a box in its order; of a flood by open addressing */
    int32_t halved; /* so many chords around rims */
    int32_t gaps;   /* pairs of cells that the surface passes between, but that are not joined */
    int32_t swept;  /* so many cells have corners of both signs; those after them were found from their neighbours */
};

/* Finds the cells that the options ask for: of a box, or, where `cell` is set, of a flood from the point (box[0], box[2], box[4]).
 * `builder` is set, all else zero. Returns 0 if the arena is full. */
int sp_cells_find(struct sp_cells *cells);

/* Adds cells in which sheets go on that no corner tells of, as they are nearer to each other than corners are. Returns 0 if the arena is
 * full. */
int sp_cells_grow(struct sp_cells *cells);

/* A flood's slot of a cell: the one that holds it, or the free one where it belongs. */
int32_t *sp_cells_slot(const struct sp_cells *cells, const int32_t at[3]);

/* Where a cell stands in the order of its box. */
static inline int32_t sp_cells_place(const struct sp_cells *cells, const int32_t at[3]) {
    return at[0] + cells->size[0] * (at[1] + cells->size[1] * at[2]);
}

/* A box's slot of a cell; NULL: it lies outside. */
static inline int32_t *sp_cells_slot_in(const struct sp_cells *cells, const int32_t at[3]) {
    for (int j = 0; j < 3; j++)
        if ((uint32_t)at[j] >= (uint32_t)cells->size[j]) return NULL;
    return cells->slots + sp_cells_place(cells, at);
}

/* The number of a cell; -1: none is there. */
static inline int32_t sp_cells_at(const struct sp_cells *cells, const int32_t at[3]) {
    if (!cells->size[0]) return *sp_cells_slot(cells, at);
    const int32_t *slot = sp_cells_slot_in(cells, at);
    return slot ? *slot : -1;
}

/* The lower corner of a cell. */
void sp_cells_corner(const struct sp_cells *cells, int32_t i, int32_t j, int32_t k, double point[3]);

/* The middle of a cell. */
void sp_cells_centre(const struct sp_cells *cells, const int32_t at[3], double point[3]);

#endif
