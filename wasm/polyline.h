/* A polyline on a surface, stored folded: node k and node n + 1 - k side by side, so that both lanes of every register do the same work
 * from the two ends towards the middle. Every formula is symmetric under reversal, so nothing is shuffled. MATH.md, "Folding". */
#ifndef SURFPATH_POLYLINE_H
#define SURFPATH_POLYLINE_H

#include "arena.h"
#include "chart.h"
#include "metric.h"

/* How n unknown nodes lie in pairs: pair 0 holds the two ends; pairs 1 … both hold unknowns in both lanes; pair both + 1 is the middle node
 * twice if n is odd, else pair `both` with its lanes exchanged. */
struct sp_fold {
    int32_t inner; /* n; alone, so that a fold is passed as a number, not copied through memory */
};

static inline int32_t sp_fold_both(struct sp_fold fold) { return fold.inner >> 1; }
static inline int sp_fold_odd(struct sp_fold fold) { return fold.inner & 1; }

/* Pairs that are stored: 0 … both + 1. */
static inline int32_t sp_fold_pairs(struct sp_fold fold) { return sp_fold_both(fold) + 2; }

/* Pairs with unknowns: 1 … this. */
static inline int32_t sp_fold_unknown(struct sp_fold fold) { return (fold.inner + 1) >> 1; }

/* Where node i of 0 … n + 1 is stored: its pair and lane. */
static inline int32_t sp_fold_pair(struct sp_fold fold, int32_t i) { return i <= fold.inner + 1 - i ? i : fold.inner + 1 - i; }
static inline int sp_fold_lane(struct sp_fold fold, int32_t i) { return i > fold.inner + 1 - i; }

/* The sum over both lanes of what pair k of the unknowns contributes: the middle node counts once. */
static inline double sp_fold_sum(struct sp_fold fold, int32_t k, sp_pair x) { return k <= sp_fold_both(fold) ? x[0] + x[1] : x[0]; }

/* Reads number j of node i from an array of `stride` pairs a pair. */
static inline double sp_fold_get(struct sp_fold fold, const sp_pair *data, int32_t stride, int32_t i, int32_t j) {
    return data[(size_t)stride * (size_t)sp_fold_pair(fold, i) + (size_t)j][sp_fold_lane(fold, i)];
}

/* Nodes of a path: places, charts and metrics, folded. */
struct sp_nodes {
    sp_pair *places;  /* kind->dimension a pair */
    sp_pair *charts;  /* SP_CHART a pair */
    sp_pair *metrics; /* SP_METRIC_PARTS kind->components a pair; NULL without a metric of its own */
};

struct sp_polyline {
    const struct sp_surface *surface;
    const struct sp_kind *kind;
    struct sp_fold fold;
    struct sp_nodes nodes;
    int32_t touches; /* 0: no unknown lies on a wall of the rectangle */
};

/* Coordinate j of node i in the rectangle of a parametric surface. */
static inline double sp_polyline_coordinate(const struct sp_polyline *line, int32_t i, int32_t j) {
    return sp_fold_get(line->fold, line->nodes.places, 2, i, j);
}

/* Coordinate j of an end, 0 or 1. */
static inline double sp_polyline_end(const struct sp_polyline *line, int end, int32_t j) { return line->nodes.places[j][end]; }

/* Writes coordinate j of node i: of the middle one, which stands alone, into both lanes. */
void sp_polyline_put(const struct sp_polyline *line, int32_t i, int32_t j, double x);

/* Puts the nodes between the ends onto the surface, or into the rectangle. Returns 0 where they do not settle. */
int sp_polyline_settle(struct sp_polyline *line, double scale);

/* Makes pair both + 1 of an array of `stride` pairs follow pair `both`, where n is even. */
static inline void sp_fold_mirror(struct sp_fold fold, sp_pair *data, int32_t stride) {
    if (sp_fold_odd(fold)) return;
    const sp_pair *last = data + (size_t)stride * (size_t)sp_fold_both(fold);
    for (int32_t j = 0; j < stride; j++)
        data[(size_t)stride * (size_t)(sp_fold_both(fold) + 1) + (size_t)j] = sp_swap(last[j]);
}

/* Writes the charts and metrics of all nodes from their places. */
static inline void sp_polyline_charts(const struct sp_polyline *line, const struct sp_nodes *nodes) {
    line->kind->charts(line->surface, sp_fold_unknown(line->fold) + 1, nodes->places, nodes->charts, nodes->metrics);
    sp_fold_mirror(line->fold, nodes->charts, SP_CHART);
    sp_fold_mirror(line->fold, nodes->metrics, SP_METRIC_PARTS * line->kind->components);
}

#endif
