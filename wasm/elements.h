/* The energy of a path of high-order elements: E = m sum_e sum_ij K_ij X_i.X_j, the positions interpolated on Gauss–Lobatto–Legendre nodes.
 *
 * m elements of degree p, m even, folded like a polyline (polyline.h): element e and its mirror image, e < m/2, side by side. The inner
 * nodes of each element are condensed statically, which leaves a block-tridiagonal system on the nodes between elements. As in energy.h all
 * is divided by 2m. Degree 1 is the polyline itself. MATH.md, "Elements". */
#ifndef SURFPATH_ELEMENTS_H
#define SURFPATH_ELEMENTS_H

#include "energy.h"
#include "reference.h"

/* Numbers that say where elements meet, less one. */
enum { SP_SPREAD = 256 };

struct sp_elements {
    struct sp_reference reference; /* degree p */
    int32_t count;                 /* m, even */
    const double *spread;          /* the path's parameter at k/SP_SPREAD of the elements: closer where the path turns. NULL: evenly */
    int32_t fixed;                 /* 1: that stays as it is */
    int32_t singular[2];           /* 1: the path begins, ends, on a singular curve, and its outermost elements are graded */
    struct sp_graded graded;       /* for them; not used if neither is */
    sp_pair *matrices; /* m/2 matrices of sp_elements_order^2 numbers: LDL' of each element, below it its borders and right-hand side */
    sp_pair *velocity; /* 3 a node pair of one element: scratch of the assembly */
    struct sp_row *skeleton; /* m/2 + 1 rows: the nodes between elements */
};

/* Whether some elements are graded. */
static inline int sp_elements_graded(const struct sp_elements *elements) { return elements->singular[0] || elements->singular[1]; }

/* Rows of an element's matrix: two a node of p - 1 inner and two border nodes, the right-hand side, and one of zeros, since rows are taken
 * in twos. */
static inline int32_t sp_elements_order(int32_t degree) { return 2 * (degree + 2); }

/* How many times shorter than the mean the elements of pair e are, which their share in the energy is multiplied by. */
sp_pair sp_elements_stretch(const struct sp_elements *elements, int32_t e);

/* sum_e sum_ij K_ij X_i.X_j, the path's energy over m; and, where `length` is not NULL, the path's length. */
double sp_elements_squares(const struct sp_elements *elements, const sp_pair *charts, double *length);

/* The path's parameter, 0 … 1, where element e begins. */
double sp_elements_border(const struct sp_elements *elements, int32_t e);

/* Assembles the rows of all nodes (diagonal blocks, right-hand sides) but not yet the couplings. As sp_polyline_assemble. `held`: two masks
 * a pair. */
struct sp_energy sp_elements_assemble(const struct sp_elements *elements, const struct sp_polyline *line, enum sp_hessian hessian,
                                      struct sp_row *rows, sp_mask *straight, sp_mask *held);

/* The matrix of element pair e of H + shift M, its borders' own blocks zero: those are the skeleton's. */
void sp_elements_fill(const struct sp_elements *elements, const struct sp_polyline *line, int32_t e, const struct sp_row *rows,
                      const sp_mask *held, double shift, sp_pair *matrix);

/* Factors H + shift M: condenses every element and factors the skeleton. */
struct sp_inertia sp_elements_factor(const struct sp_elements *elements, const struct sp_polyline *line, const struct sp_row *rows,
                                     const sp_mask *held, double shift);

/* D at the two ends of the path, lane 0 the first: minus the force that would move them, and so minus the path's velocity into it, over an
 * element. */
struct sp_vector sp_elements_end_pull(const struct sp_elements *elements, const sp_pair *charts);

/* As sp_blocks_solve and sp_blocks_descent, after sp_elements_factor. */
void sp_elements_solve(const struct sp_elements *elements, sp_pair *x);
int sp_elements_descent(const struct sp_elements *elements, sp_pair *x);

#endif
