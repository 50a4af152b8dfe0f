/* The discrete energy of a polyline, E = (n + 1) sum |X_i+1 - X_i|^2 (the paper's Eq. 19), its exact gradient and Hessian. MATH.md,
 * "Energy".
 *
 * Everything here is divided by 2 (n + 1): half the sum of squared chords, whose gradient at a node is B'(2 X_i - X_i-1 - X_i+1). */
#ifndef SURFPATH_ENERGY_H
#define SURFPATH_ENERGY_H

#include "blocks.h"

/* The Hessian's curvature term at a node. */
enum sp_hessian {
    SP_COVARIANT, /* (D.N)(S_ab.N)/(N.N): Riemannian, the derivative along geodesics of the surface */
    SP_COORDINATE /* D.S_ab: along straight lines of the parameters */
};

struct sp_energy {
    double squares;            /* sum of squared chords: E = (n + 1) squares */
    double gradient_squared;   /* sum of squares of the scaled gradient, active coordinates left out */
    int32_t active;            /* coordinates held at a wall */
    struct sp_inertia inertia; /* of the Hessian, which is factored */
};

/* Diagonal block, metric and right-hand side of one pair of nodes: `pull` is D, minus the force on the node, `weight` the stiffness of the
 * node itself. */
void sp_row_assemble(const sp_pair *chart, const struct sp_vector *pull, sp_pair weight, sp_mask coordinate, struct sp_row *row);

/* Coordinates of a pair that lie on a wall of the surface's rectangle and that their force pushes outwards. Returns whether there are any.
 */
int sp_row_find_held(const struct sp_surface *surface, const sp_pair *place, const struct sp_row *row, sp_mask held[2]);

/* Makes held coordinates those of the identity: they do not move. */
void sp_row_hold(struct sp_row *row, const sp_mask held[2]);

/* Q between a pair and the next without the rows of coordinates held in this pair, the columns of those held in the next. */
void sp_row_hold_coupling(struct sp_row *row, const sp_mask here[2], const sp_mask next[2]);

/* Sum of squares of the scaled gradient. */
double sp_rows_gradient_squared(struct sp_fold fold, const struct sp_row *rows);

/* sum |X_i+1 - X_i|^2; and, where `gradient_squared` is not NULL, the sum of squares of the scaled gradient, no coordinate held. */
double sp_polyline_squares(struct sp_fold fold, const sp_pair *charts, double *gradient_squared);

/* sum |X_i+1 - X_i| */
double sp_polyline_length(struct sp_fold fold, const sp_pair *charts);

/* Assembles gradient and Hessian into `rows` (1 … sp_fold_unknown) and factors them (sp_blocks_factor) in the same sweep. Coordinates that
 * lie on a wall of the surface's rectangle and are pushed outwards are active: their rows become the identity and their node takes the
 * coordinate Hessian; `straight`, a mask a pair, is set at such nodes (everywhere with SP_COORDINATE). */
struct sp_energy sp_polyline_assemble(const struct sp_polyline *line, enum sp_hessian hessian, struct sp_row *rows, sp_mask *straight);

#endif
