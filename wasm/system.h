/* The Newton system of a path, whether polyline or elements: one face for both. MATH.md, "Newton". */
#ifndef SURFPATH_SYSTEM_H
#define SURFPATH_SYSTEM_H

#include "elements.h"

struct sp_system {
    struct sp_polyline line;     /* nodes; for elements those of all of them, ends shared */
    struct sp_row *rows;         /* one a pair */
    sp_mask *straight;           /* one a pair: nodes that move along straight lines of the parameters */
    sp_mask *held;               /* two a pair: coordinates that do not move; elements only */
    struct sp_elements elements; /* degree 1: a polyline, nothing else in it used but, with a metric, the reference element */
};

/* Number of elements or chords, m: the energy is m times `squares`. */
static inline int32_t sp_system_segments(const struct sp_system *system) {
    return system->elements.reference.degree == 1 ? system->line.fold.inner + 1 : system->elements.count;
}

/* Chords in space: a polyline without a metric. */
static inline int sp_system_is_plain(const struct sp_system *system) {
    return system->elements.reference.degree == 1 && system->line.kind->components == 0;
}

/* Energy over m of these nodes; of a polyline without a metric also the sum of squares of its scaled gradient, unless that is NULL. */
double sp_system_squares(const struct sp_system *system, const struct sp_nodes *nodes, double *gradient_squared);

/* Length of the path of these nodes: sum of chords, or quadrature. */
double sp_system_length(const struct sp_system *system, const struct sp_nodes *nodes);

/* The pieces of a Newton step: energy.h, blocks.h, elements.h. Assembling factors, too, without a shift; elements may be left unfactored,
 * with the factorisation there was before. */
struct sp_energy sp_system_assemble(struct sp_system *system, enum sp_hessian hessian);
struct sp_energy sp_system_rows(struct sp_system *system, enum sp_hessian hessian);
struct sp_inertia sp_system_factor(struct sp_system *system, double shift);
void sp_system_solve(const struct sp_system *system, sp_pair *x);
int sp_system_negative(const struct sp_system *system, sp_pair *x);

/* The derivative of the energy over 2m by the chart coordinates of the two ends, lane 0 the first: minus the velocity into the path, over
 * an element, its index lowered. */
void sp_system_end_pull(const struct sp_system *system, sp_pair pull[2]);

/* Whether the path may move to these nodes. No node's normal may turn by more than a right angle in one step: implicit, it would have
 * changed sheets, or crossed the singular curve at an end, near which it may not shrink to a tenth either. */
int sp_system_keeps_normals(const struct sp_system *system, const struct sp_nodes *nodes);

/* sqrt(2 g'M^-1 g / squares): how far from stationary, whatever the Hessian. */
double sp_system_steepness(const struct sp_system *system, double squares);

/* Largest length of x at a node, in the metric of the surface. */
double sp_system_largest(const struct sp_system *system, const sp_pair *x);

#endif
