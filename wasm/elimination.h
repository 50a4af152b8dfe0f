/* The block solve one row at a time, so that rows are eliminated where they are made (energy.c) as well as afterwards (blocks.c). MATH.md,
 * "The block solve". */
#ifndef SURFPATH_ELIMINATION_H
#define SURFPATH_ELIMINATION_H

#include "blocks.h"

/* A symmetric 2 x 2 block and a vector: what eliminating a row takes from the next one, Q'P^-1 Q, and adds to it, Q'P^-1 s; or what is left
 * of a row. */
struct sp_carry {
    sp_pair a, b, d, s1, s2;
};

/* An elimination on its way: what the last row carries on, and what all pivots so far have in common. */
struct sp_sweep {
    struct sp_carry carry;
    sp_mask definite; /* lanes of positive definite pivots alone */
    sp_pair descent;  /* s'P^-1 s, summed */
    sp_pair softness; /* the largest trace of P^-1 M */
};

/* Before the first row. */
static inline struct sp_sweep sp_sweep_start(void) { return (struct sp_sweep){{{0}, {0}, {0}, {0}, {0}}, {-1, -1}, {0}, {0}}; }

static inline __attribute__((always_inline)) struct sp_carry sp_reduce(struct sp_carry left, struct sp_carry carry) {
    return (struct sp_carry){left.a - carry.a, left.b - carry.b, left.d - carry.d, left.s1 + carry.s1, left.s2 + carry.s2};
}

/* A row of H + shift M before anything is taken from it. */
static inline __attribute__((always_inline)) struct sp_carry sp_row_left(const struct sp_row *row, double shift) {
    struct sp_carry left = {row->a, row->b, row->d, row->r1, row->r2};
    if (shift != 0) {
        sp_pair by = shift * row->weight;
        left.a += by * row->e, left.b += by * row->f, left.d += by * row->g;
    }
    return left;
}

/* Solves for the row by its pivot block: writes P, W = P^-1 Q, y = P^-1 s, and the trace of P^-1 M. Returns where P is positive definite.
 */
static inline __attribute__((always_inline)) sp_mask sp_pivot(struct sp_row *row, struct sp_carry p, sp_pair *trace) {
    sp_pair zero = sp_splat(0.0), determinant = p.a * p.d - p.b * p.b, reciprocal = 1.0 / determinant;
    row->pa = p.a, row->pb = p.b, row->pd = p.d;
    row->w11 = reciprocal * (p.d * row->q11 - p.b * row->q21);
    row->w12 = reciprocal * (p.d * row->q12 - p.b * row->q22);
    row->w21 = reciprocal * (p.a * row->q21 - p.b * row->q11);
    row->w22 = reciprocal * (p.a * row->q22 - p.b * row->q12);
    row->y1 = reciprocal * (p.d * p.s1 - p.b * p.s2);
    row->y2 = reciprocal * (p.a * p.s2 - p.b * p.s1);
    *trace = reciprocal * row->weight * (row->g * p.a - 2.0 * row->f * p.b + row->e * p.d);
    return (p.a > zero) & (determinant > zero) & (determinant < sp_splat(__builtin_inf()));
}

static inline __attribute__((always_inline)) struct sp_carry sp_carry_of(const struct sp_row *row) {
    return (struct sp_carry){row->q11 * row->w11 + row->q21 * row->w21, row->q11 * row->w12 + row->q21 * row->w22,
                             row->q12 * row->w12 + row->q22 * row->w22, row->q11 * row->y1 + row->q21 * row->y2,
                             row->q12 * row->y1 + row->q22 * row->y2};
}

/* Eliminates a row, one of all but the last of the unknown ones. */
static inline __attribute__((always_inline)) void sp_eliminate(struct sp_row *row, double shift, struct sp_sweep *sweep) {
    struct sp_carry p = sp_reduce(sp_row_left(row, shift), sweep->carry);
    sp_pair trace;
    sweep->definite &= sp_pivot(row, p, &trace);
    sweep->softness = sp_larger(sweep->softness, trace);
    sweep->descent += p.s1 * row->y1 + p.s2 * row->y2;
    sweep->carry = sp_carry_of(row);
}

/* The last row, where the halves meet: the factorisation's outcome. */
struct sp_inertia sp_blocks_join(struct sp_fold fold, struct sp_row *rows, double shift, const struct sp_sweep *sweep);

#endif
