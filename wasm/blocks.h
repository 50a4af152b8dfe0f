/* Block-tridiagonal systems with symmetric 2 x 2 blocks, folded: LDL' from both ends towards the middle, O(n). Knows nothing of paths.
 *
 * H has diagonal blocks [a b; b d] and, between neighbours k and k + 1, the block -Q. M = weight [e f; f g] is block diagonal: the metric
 * that shifts and eigenvalues are measured in. Rows stand one per pair of nodes (polyline.h). MATH.md, "The block solve". */
#ifndef SURFPATH_BLOCKS_H
#define SURFPATH_BLOCKS_H

#include "polyline.h"

struct sp_row {
    sp_pair a, b, d;            /* diagonal block of H */
    sp_pair e, f, g;            /* first fundamental form at the node */
    sp_pair weight;             /* M = weight [e f; f g]; 2 along a polyline */
    sp_pair q11, q12, q21, q22; /* Q, towards the next pair */
    sp_pair r1, r2;             /* right-hand side, -gradient */
    sp_pair pa, pb, pd;         /* pivot block after elimination */
    sp_pair w11, w12, w21, w22; /* W = P^-1 Q */
    sp_pair y1, y2;             /* P^-1 (eliminated right-hand side) */
};

/* Outcome of a factorisation. */
struct sp_inertia {
    int32_t negative; /* negative eigenvalues of H + shift M */
    int32_t usable;   /* 0: a pivot block is singular or not finite; nothing may be solved */
    double descent;   /* r'(H + shift M)^-1 r: minus the slope of the scaled energy along the solution */
    double softness;  /* the largest trace of P^-1 M over the pivots P, of that where the halves meet times 2/(n + 1), which on a straight
                       * line in a plane makes it 2; infinite unless all of them are positive definite */
};

/* Factors H + shift M of the unknown rows 1 … sp_fold_unknown and eliminates the right-hand side. */
struct sp_inertia sp_blocks_factor(struct sp_fold fold, struct sp_row *rows, double shift);

/* Writes the solution of (H + shift M) x = r after sp_blocks_factor, two numbers a pair, pairs 0 (zero) … both + 1. */
void sp_blocks_solve(struct sp_fold fold, const struct sp_row *rows, sp_pair *x);

/* Writes a direction of negative curvature, d'Hd < 0, after a factorisation with a negative pivot: the eigenvector of the first such pivot
 * carried outwards by L^-T. Returns 0, writing nothing, if there is none. */
int sp_blocks_descent(struct sp_fold fold, const struct sp_row *rows, sp_pair *x);

#endif
