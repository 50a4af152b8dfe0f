/* Where a path lies on the edges of its rectangle, or beyond them. MATH.md, "Arcs". */
#ifndef SURFPATH_RUNS_H
#define SURFPATH_RUNS_H

#include "piece.h"

/* A part of the path on one edge, or beyond it: nodes first … last, or what lies between those two. */
struct sp_run {
    int32_t first, last, across, side;
    double from, to;  /* where in the path, 0 … 1 */
    double along[2];  /* the coordinate along the edge halfway from there to the next node, */
    double beside[2]; /* and at that: of one node on an edge only the nodes beside it tell a direction */
};

/* Runs of nodes on the edges, those of the same edge at most two free nodes apart made one. `lone`: an end of the path that is alone on its
 * edge is one, too. Returns how many. */
int32_t sp_runs_find(const struct sp_system *system, int32_t lone, struct sp_run runs[SP_MAX_ARCS]);

/* Where a path of elements whose nodes are inside is beyond an edge between them, by more than the part `least` of the range: too short a
 * contact for so few of them. Returns how many. */
int32_t sp_runs_between(const struct sp_system *system, double least, struct sp_run runs[SP_MAX_ARCS]);

#endif
