/* A graph on a surface: vertices spread over all of it, edges as long as the surface is between them in the metric in use. Built once a
 * surface; the shortest ways through it are where Newton starts. Knows nothing of Newton. MATH.md, "The globally shortest path". */
#ifndef SURFPATH_GRAPH_H
#define SURFPATH_GRAPH_H

#include "arena.h"
#include "status.h"
#include "surface.h"

enum {
    SP_GRAPH_MAX_RESOLUTION = 256,
    SP_GRAPH_FLOOD_CELLS = 40000, /* a flood stops at this many cells */
    SP_GRAPH_MAX_CANDIDATES = 32, /* candidates of one search */
    SP_GRAPH_MAX_POINTS = 1000,   /* points of a candidate */
};

struct sp_graph_options {
    double box[6]; /* parametric: umin umax vmin vmax, one period of a direction without walls; implicit: xmin xmax ymin ymax zmin zmax */
    double cell;   /* implicit: > 0: no box; cells of this width are flooded from the point (box[0], box[2], box[4]). Else 0 */
    int32_t resolution; /* parametric: about this many cells a direction; implicit: cells along the longest side. 8 … 256 */
    int32_t loose; /* implicit: 1: join cells that share a face across creases, too, and whatever else keeps their sheets apart; 2: across
                      creases alone */
    double reach;  /* of a flood, > 0: no farther than where the distances in space from the point and from (box[1], box[3], box[5])
                      add up to this; 0: however far */
    int32_t level; /* parametric: how often coarser graphs were refined, 0 … 2; the last one has no wide edges */
};

struct sp_graph_edge {
    int32_t to;
    float length;
};

/* Everything lies in one piece of memory: in the arena at first, then where sp_graph_keep puts it. */
struct sp_graph {
    double spacing;   /* implicit: diagonal of a cell */
    double *samples;  /* what lengths at a vertex are measured by, `width` numbers: x y z, if it has a position, and the metric */
    double *lines[2]; /* parametric: places of the lines of the grid, count[j] and, where it wraps, the first one period on;
                         vertex i * count[1] + j lies where lines i and j cross */
    float *normals;   /* implicit: 3 a vertex, unit; (0, 0, 0): not a point of the surface, without edges. Parametric: NULL */
    int32_t *first;   /* vertex_count + 1: where the edges of a vertex begin */
    struct sp_graph_edge *edges; /* each way */
    int32_t kind, vertex_count, edge_count;
    int32_t unique;   /* 1: no curvature at a sample of a rectangle without wraps, collapsed edges or cusps, by which neighbouring geodesics
                         could meet again in the rectangle: they are unique */
    int32_t singular; /* 1: the normal vanishes along a curve, which edges cross */
    int32_t collapsed[4]; /* the edges u = min, u = max, v = min, v = max of the rectangle that are points: poles, apexes */
    int32_t count[2], wraps[2];
    int32_t width;
    int32_t resolved; /* 1: few details are smaller than edges. 0 with a metric on an implicit surface */
    int32_t coarse;   /* 1: parametric, level 0, in space: so many are that level 1 finds ways which this one, without wide edges, does not;
                         implicit, of a box, smooth: sheets end in it where what is thinner than cells was not seen, or many
                         cells that share a sheet are not joined */
    double form[3];   /* parametric: e, f, g of the surface, on an average over the vertices at which they are finite */
    double stretch;   /* no edge is shorter than its chord times this: 1 in space, 0 where samples have no positions */
    double step;      /* mean length of the edges */
};

/* What a search found. */
struct sp_graph_answer {
    double distance; /* length of the shortest way through the graph; NaN without one */
    double *places;  /* candidate_count polylines of point_count places (u v, continuous across seams, or x y z), in the arena */
    int32_t candidate_count, point_count;
};

/* Bytes of arena with which sp_graph_build is likely to succeed; if it does not, it does with a few times as many. */
double sp_graph_build_bytes(int32_t kind, const struct sp_graph_options *options);

/* Builds the graph of a surface in `arena`, which is reset first.
 *
 * Parametric: a grid whose lines are as far apart on the surface as it goes, every vertex joined to the 32 around it that a coprime step of
 * at most 3 reaches or, where these do not resolve the surface and it is not `coarse`, and at level 1 also where it is steep, the 80 that
 * one of at most 5 does; an edge is two chords through its middle on the surface, or Simpson's rule for the metric in use. Edges do not
 * cross a curve on which S_u x S_v vanishes. Implicit: the cells of a cubic grid in which f changes sign, centres moved onto f = 0;
 * neighbours at most two cells away are joined where their normals and the chord say that they lie on the same sheet. Returns SP_CONVERGED,
 * SP_NOT_FINITE (the box is empty or not finite) or SP_OUT_OF_MEMORY. */
int32_t sp_graph_build(const struct sp_surface *surface, const struct sp_graph_options *options, struct sp_arena *arena,
                       struct sp_graph *graph);

/* Bytes that a graph needs outside the arena. */
double sp_graph_bytes(const struct sp_graph *graph);

/* Moves a graph out of the arena into a block of sp_graph_bytes bytes, aligned to 16, that the caller keeps as long as the graph. */
void sp_graph_keep(struct sp_graph *graph, void *block);

/* Bytes of arena that sp_graph_search needs. */
double sp_graph_search_bytes(const struct sp_graph *graph, int32_t point_count);

/* Finds ways through the graph from one point to another: the shortest, then the shortest through a vertex away from all those found before
 * (by a fifth of the shortest; when there are no more such, by a tenth), as long as they are at most a quarter longer, at most 16; where
 * the graph does not resolve the surface, in the end by a twentieth, at most 32; implicit, then also across an edge from those found.
 * Ways over a collapsed edge pass it on both sides. With
 * `all` = 0 only those are looked for that may become the shortest path: at most 6 % longer on a surface that the graph resolves, and 12 %
 * where length is that of space. Each is resampled by length and smoothed; implicit, its places are near f = 0.
 *
 * `ends`: u v, or x y z on the surface, three numbers each. Returns SP_CONVERGED, SP_DISCONNECTED, SP_OFF_SURFACE (no vertex near an end),
 * SP_NOT_FINITE (an end), SP_OUT_OF_MEMORY. */
int32_t sp_graph_search(const struct sp_surface *surface, const struct sp_graph *graph, const double ends[6], int32_t point_count,
                        int32_t all, struct sp_arena *arena, struct sp_graph_answer *answer);

#endif
