/* Distances through a graph, as of Dijkstra's algorithm or A*, resumable, and the ways they tell of. */
#ifndef SURFPATH_GRAPH_SEARCH_H
#define SURFPATH_GRAPH_SEARCH_H

#include "graph_build.h"

enum { SP_MAX_ATTACHED = 128 };

/* The vertices around a point that is not one, and how far they are. */
struct sp_attachment {
    int32_t vertex[SP_MAX_ATTACHED];
    double length[SP_MAX_ATTACHED];
    int32_t count;
};

/* Finds the vertices around a place: parametric, the 4 x 4 around it in the grid; implicit, those within one and a half cell diagonals on
 * its sheet. Returns SP_CONVERGED, SP_NOT_FINITE, or SP_OFF_SURFACE: there are none. */
enum sp_status sp_graph_attach(const struct sp_surface *surface, const struct sp_graph *graph, const double *place,
                               struct sp_attachment *attached);

/* A vertex of an implicit graph, and how far it is from the seeds of a search. */
struct sp_reached {
    double place[3], distance;
    int32_t vertex;
};

/* The length of the shortest way to a place over one of these vertices, `count` of them, that could be attached to it; infinite: there is
 * none. The vertex of that way becomes the first, as it will soon be known then that most are too far for a place nearby. */
double sp_graph_reach(const struct sp_surface *surface, const struct sp_graph *graph, const double *place, struct sp_reached *vertices,
                      int32_t count);

/* How far, in cell diagonals, attached vertices are from their place at most. Implicit. */
static const double SP_ATTACHED_NEAR = 1.5;

/* The length of the surface between two places that are so near that one could be attached to the other; else infinite. */
double sp_graph_near_length(const struct sp_surface *surface, const struct sp_graph *graph, const double *from, const double *to);

/* Distances from some seeds, settled as far as the search has gone. */
struct sp_front {
    const struct sp_graph *graph;
    double *distance; /* infinite: not reached */
    int32_t *before;  /* the vertex before this one; -1: a seed */
    double *key;      /* of a vertex to be visited: no way to the target over it is shorter */
    int32_t *near;    /* those to be visited next, near_count from `head` on, around the end: their keys are at most `bound` */
    int32_t *far;     /* the others, far_count, with some that have come near since */
    int32_t near_count, far_count, head;
    double bound, least; /* no key of the far ones is less than `least` */
    /* The sample to which ways lead, where none is shorter than its chord times `stretch`: a key is the distance and so much from there
     * (A*). NULL: the distance alone. */
    const double *target;
    double stretch;
    /* Distances from where ways lead. Where they and those from the seeds add up to more than `most`, none is visited. NULL: all are. */
    const double *other;
    double most, farthest; /* nor are those that are as far as `farthest` */
    double flat;           /* implicit: edges lead nowhere between whose normals the cosine is less */
};

/* Bytes a vertex. */
enum { SP_FRONT_BYTES = 2 * sizeof(double) + 3 * sizeof(int32_t) };

/* Takes the arrays, nothing reached. Returns 0 if the arena is full. */
int sp_front_take(struct sp_front *front, const struct sp_graph *graph, struct sp_arena *arena);

/* Offers a way to a vertex; it counts if it is shorter than the known one. */
void sp_front_offer(struct sp_front *front, int32_t vertex, int32_t before, double distance);

/* Visits all vertices whose key is below `limit`, but for those that are left out. */
void sp_front_advance(struct sp_front *front, double limit);

/* The length of the shortest known way to a place; infinite: there is none. */
double sp_front_reach(const struct sp_front *front, const struct sp_attachment *attached);

/* A way from one point over vertices to another. */
struct sp_way {
    const struct sp_surface *surface;
    const struct sp_graph *graph;
    const double *from, *to;
    const int32_t *vertices;
    int32_t count;
};

/* Polylines of point_count places that a way starts: appended to the answer, more than one if the way passes a collapsed edge. Returns a
 * status; SP_OUT_OF_MEMORY if the arena is full. */
enum sp_status sp_way_write(const struct sp_way *way, struct sp_arena *arena, struct sp_graph_answer *answer);

/* Bytes that sp_way_write needs for a way of all vertices. */
double sp_way_bytes(const struct sp_graph *graph);

#endif
