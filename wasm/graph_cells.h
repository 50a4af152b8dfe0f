/* The cells of a cubic grid in which f changes sign, found by a sweep of a box or by a flood from a point. */
#ifndef SURFPATH_GRAPH_CELLS_H
#define SURFPATH_GRAPH_CELLS_H

#include "graph_build.h"

enum { SP_INSIDE = 8 };

struct sp_cell {
    int32_t at[3];
    int32_t faces; /* 0 if its vertex lies outside it; else SP_INSIDE, and bit j: the surface passes the lower face across axis j */
};

/* The cells found so far, at the end of the arena, and a table from a cell's place to its number. */
struct sp_cells {
    struct sp_builder *builder;
    double origin[3], width[3];
    int32_t size[3]; /* cells of the box; 0 in a flood */
    struct sp_cell *list;
    int32_t count, capacity;
    int32_t *slots;           /* open addressing; -1: free */
    uint32_t mask, stride[2]; /* strides: of a box */
};

/* Finds the cells that the options ask for: of a box, or, where `cell` is set, of a flood from the point (box[0], box[2], box[4]).
 * `builder` is set, all else zero. Returns 0 if the arena is full. */
int sp_cells_find(struct sp_cells *cells);

/* Whether there may be such a cell. */
int sp_cells_hold(const struct sp_cells *cells, const int32_t at[3]);

/* The slot of a cell that there may be: the one that holds it, or the free one where it belongs. */
int32_t *sp_cells_slot(const struct sp_cells *cells, const int32_t at[3]);

/* The lower corner of a cell. */
void sp_cells_corner(const struct sp_cells *cells, int32_t i, int32_t j, int32_t k, double point[3]);

#endif
