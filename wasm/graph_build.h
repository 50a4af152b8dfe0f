/* What the two builders of graphs share: arrays taken piece by piece, edges appended to the end of the arena. */
#ifndef SURFPATH_GRAPH_BUILD_H
#define SURFPATH_GRAPH_BUILD_H

#include "graph.h"
#include "vector.h"

enum { SP_GRAPH_BLOCK = 32 };                     /* pairs evaluated at once */
enum { SP_USUAL_EDGES = 32, SP_WIDE_EDGES = 80 }; /* of a vertex of a parametric graph: by steps up to 3 and 5 */
enum { SP_LAST_LEVEL = 2 };                       /* only the usual ones: it is to join what is apart */

/* An edge that a later vertex has to an earlier one, measured when it was that one's turn. */
struct sp_waiting {
    int32_t next, to; /* next: the one that waited before it for the same vertex; 0: none */
    float length;
};

struct sp_builder {
    const struct sp_surface *surface;
    const struct sp_graph_options *options;
    struct sp_arena *arena;
    struct sp_graph *graph;
    int32_t *waits;         /* of each vertex: the last edge that waits for it, or 0 */
    struct sp_waiting *end; /* waiting edges are numbered from the end of the arena downwards: number i lies at end[-i] */
    int32_t waiting, spare; /* how many there are, spare ones among them; the last spare one, or 0 */
    int32_t bent;           /* edges that are not about as long as their chords */
};

int32_t sp_graph_build_parametric(struct sp_builder *builder);
int32_t sp_graph_build_implicit(struct sp_builder *builder);

/* Takes the arrays of graph->vertex_count vertices, and all that is left of the arena for edges. Nothing may be taken afterwards. */
int sp_builder_take(struct sp_builder *builder);

/* Before the first vertex: forgets all edges. */
void sp_builder_begin(struct sp_builder *builder);

/* The turn of a vertex, one after the other: its edges to earlier ones. 0 if there is no room. */
int sp_builder_turn(struct sp_builder *builder, int32_t vertex);

/* Joins the vertex whose turn it is with a later one; 0 if there is no room. A length that is not finite is no edge. chord: what it would
 * be if the surface were flat and its metric linear; 0: not known. */
int sp_builder_join(struct sp_builder *builder, int32_t vertex, int32_t to, double length, double chord);

/* Whether few edges are longer than their chords by what a detail of the surface makes them. */
int sp_builder_resolves(const struct sp_builder *builder);

/* Whether so many edges are bent that finer cells tell more than wider edges. */
int sp_builder_is_coarse(const struct sp_builder *builder);

/* Points put and got one by one, evaluated together: `capacity` of them. The lane without a point repeats the last. */
struct sp_block {
    const struct sp_surface *surface;
    sp_evaluate evaluate;
    sp_pair in[3 * SP_GRAPH_BLOCK], out[SP_PARAMETRIC_JET * SP_GRAPH_BLOCK];
    int32_t inputs, outputs, count, capacity;
};

/* Opens a block that evaluates positions (implicit: f and its gradient), or, `metric`, what samples are made of. */
void sp_block_open(struct sp_block *block, const struct sp_surface *surface, int metric);

void sp_block_put(struct sp_block *block, const double *point);

void sp_block_evaluate(struct sp_block *block);

double sp_block_get(const struct sp_block *block, int32_t i, int32_t j);

/* A sample: what lengths at a place are measured by. Parametric: x y z, with a density also rho; with a tensor E F G alone. Implicit: x y z
 * and, with a density, rho^2; with a tensor, its six numbers. */
enum { SP_GRAPH_WIDTH = 9 };

/* Whether samples begin with x y z. */
int sp_graph_has_positions(const struct sp_surface *surface);

/* Numbers of a sample. */
int32_t sp_graph_width(const struct sp_surface *surface);

/* The sample at a point of a block that was opened with `metric` and evaluated. */
void sp_block_sample(const struct sp_block *block, int32_t i, double *sample);

/* The sample at a place. */
void sp_graph_sample(const struct sp_surface *surface, const double *place, double *sample);

/* Parametric: the length of a segment from a place over (du, dv), with samples at its ends and its middle; where these tell that its metric
 * changes much, with more. */
double sp_graph_segment(const struct sp_surface *surface, const double place[2], const double *from, const double *middle, const double *to,
                        const double by[2]);

/* Any kind: the length of a short chord with samples at its ends. */
double sp_graph_chord(const struct sp_surface *surface, const double *from, const double *to, const double by[2]);

/* The largest whole number that is not above x, for |x| < 2^51. */
static inline double sp_round_down(double x) {
    double rounded = (x + 6755399441055744.0) - 6755399441055744.0;
    return rounded > x ? rounded - 1 : rounded;
}

/* Implicit: the length of the surface between two samples with unit normals, c (1 + theta^2/24) in space; infinite unless they lie on one
 * sheet: normals at most 72 degrees apart, the chord at most 37 degrees out of the tangent planes. */
double sp_graph_sheet_length(const struct sp_surface *surface, const double *a, const double normal_a[3], const double *b,
                             const double normal_b[3]);

/* Parametric: how far it is around in a direction that wraps; 0 where it does not. */
static inline double sp_graph_period(const struct sp_graph *graph, int direction) {
    const double *lines = graph->lines[direction];
    return graph->wraps[direction] ? lines[graph->count[direction]] - lines[0] : 0;
}

#endif
