/* The reference element: Gauss–Lobatto–Legendre nodes on [0, 1], quadrature, differentiation and stiffness. Knows no surface. MATH.md,
 * "Elements". */
#ifndef SURFPATH_REFERENCE_H
#define SURFPATH_REFERENCE_H

#include "arena.h"

enum { SP_MAX_DEGREE = 32 };

/* Degree p, p + 1 nodes; matrices (p + 1) x (p + 1), row by row. All symmetric under t -> 1 - t. */
struct sp_reference {
    int32_t degree;
    double *node;        /* 0 = t_0 < … < t_p = 1 */
    double *weight;      /* quadrature, exact to degree 2p - 1 */
    double *barycentric; /* weights of barycentric interpolation */
    double *derivative;  /* D: derivative of the interpolating polynomial at the nodes */
    double *stiffness;   /* K = D' diag(weight) D, rows adding up to 0 */
};

/* Makes the reference element of degree 1 … SP_MAX_DEGREE. Returns 0 if the arena is full. Cost: O(p^3). */
int sp_reference_make(struct sp_reference *reference, int32_t degree, struct sp_arena *arena);

/* Bytes that sp_reference_make takes. */
double sp_reference_bytes(int32_t degree);

/* Writes the values at t of the p + 1 Lagrange polynomials. */
void sp_reference_interpolate(const struct sp_reference *reference, double t, double values[SP_MAX_DEGREE + 1]);

#endif
