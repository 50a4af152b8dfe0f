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

/* The operator of the two outermost elements where the path ends on a singular curve at one end or both: there the path is smooth not in
 * its parameter a but in sigma, a = sigma^2 counted from the end, and its nodes lie at equal sigma as elsewhere at equal a. Lanes as in a
 * folded path, lane 0 the first end. */
struct sp_graded {
    int32_t count;         /* Gauss points */
    double *derivative;    /* count x (p + 1): d/dsigma of the interpolating polynomial at the Gauss points */
    double *length_weight; /* quadrature of the length */
    double *weight[2];     /* quadrature of the energy, per lane: w/(2 sigma), or w where the end is regular */
    double *stiffness[2];  /* K per lane */
};

/* Makes the graded operator of a reference element; ends[i]: end i lies on a singular curve. Returns 0 if the arena is full. */
int sp_graded_make(struct sp_graded *graded, const struct sp_reference *reference, const int32_t ends[2], struct sp_arena *arena);

/* Makes the reference element of degree 1 … SP_MAX_DEGREE. Returns 0 if the arena is full. Cost: O(p^3). */
int sp_reference_make(struct sp_reference *reference, int32_t degree, struct sp_arena *arena);

/* Bytes that sp_reference_make takes. */
double sp_reference_bytes(int32_t degree);

/* Writes the values at t of the p + 1 Lagrange polynomials. */
void sp_reference_interpolate(const struct sp_reference *reference, double t, double values[SP_MAX_DEGREE + 1]);

#endif
