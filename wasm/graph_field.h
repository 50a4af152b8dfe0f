/* Distances from one point to many through a graph. Knows nothing of meshes. */
#ifndef SURFPATH_GRAPH_FIELD_H
#define SURFPATH_GRAPH_FIELD_H

#include "graph.h"

struct sp_field_request {
    double from[3];       /* u v, or x y z on the surface */
    const double *places; /* u v, or x y z on the surface, of `count` places */
    double *lengths;      /* out: of the shortest way to each, as a rule at most a few per cent too long; infinite: there is none */
    int32_t count, unused;
};

/* Bytes of arena that sp_graph_field needs for `count` places. */
double sp_graph_field_bytes(const struct sp_graph *graph, int32_t count);

/* Finds how far places are from a point: one search of the whole graph, then for each place the least sum over the vertices around it, or
 * the length straight to it. Returns SP_CONVERGED; SP_OFF_SURFACE: no vertex is near the point; SP_NOT_FINITE: the point; SP_OUT_OF_MEMORY.
 * Cost: 2 ms, and 1 us a place. */
int32_t sp_graph_field(const struct sp_surface *surface, const struct sp_graph *graph, const struct sp_field_request *request,
                       struct sp_arena *arena);

#endif
