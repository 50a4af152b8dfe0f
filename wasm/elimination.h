/* The block solve one row at a time, so that rows are eliminated where they are made (energy.c) as well as afterwards (blocks.c). MATH.md,
 * "The block solve". */
#ifndef SURFPATH_ELIMINATION_H
#define SURFPATH_ELIMINATION_H

#include "blocks.h"

/* A symmetric 2 x 2 block and a vector: what eliminating a row takes from the next one, Q'P^-1 Q and -Q'P^-1 s; or what is left of a row.
 */
struct sp_carry {
    sp_pair a, b, d, s1, s2;
};

/* What all pivots so far have in common: eigenvalues counted, in each lane, and s'P^-1 s summed. */
struct sp_tally {
    sp_mask negative, unusable;
    sp_pair descent;
};

/* A row less the carry of the one before it. */
static inline __attribute__((always_inline)) struct sp_carry sp_reduce(const struct sp_row *row, double shift, struct sp_carry carry) {
    struct sp_carry left = {row->a, row->b, row->d, row->r1 - carry.s1, row->r2 - carry.s2};
    if (shift != 0) {
        sp_pair by = shift * row->weight;
        left.a += by * row->e, left.b += by * row->f, left.d += by * row->g;
    }
    left.a -= carry.a, left.b -= carry.b, left.d -= carry.d;
    return left;
}

/* Solves for the row by its pivot block, in the lanes of `counted` tallied: writes P, W = P^-1 Q, y = P^-1 s. */
static inline __attribute__((always_inline)) void sp_pivot(struct sp_row *row, struct sp_carry p, sp_mask counted, struct sp_tally *tally) {
    sp_pair zero = sp_splat(0.0), determinant = p.a * p.d - p.b * p.b, reciprocal = 1.0 / determinant;
    sp_mask one = determinant < zero, sound = one | ((determinant > zero) & (determinant < sp_splat(__builtin_inf())));
    sp_mask two = ~one & (p.a < zero);
    row->pa = p.a, row->pb = p.b, row->pd = p.d;
    row->w11 = reciprocal * (p.d * row->q11 - p.b * row->q21);
    row->w12 = reciprocal * (p.d * row->q12 - p.b * row->q22);
    row->w21 = reciprocal * (p.a * row->q21 - p.b * row->q11);
    row->w22 = reciprocal * (p.a * row->q22 - p.b * row->q12);
    row->y1 = reciprocal * (p.d * p.s1 - p.b * p.s2);
    row->y2 = reciprocal * (p.a * p.s2 - p.b * p.s1);
    tally->negative -= counted & (one + two + two);
    tally->unusable |= counted & ~sound;
    tally->descent += sp_select(counted, p.s1 * row->y1 + p.s2 * row->y2, zero);
}

static inline __attribute__((always_inline)) struct sp_carry sp_carry_of(const struct sp_row *row) {
    return (struct sp_carry){row->q11 * row->w11 + row->q21 * row->w21, row->q11 * row->w12 + row->q21 * row->w22,
                             row->q12 * row->w12 + row->q22 * row->w22, -(row->q11 * row->y1 + row->q21 * row->y2),
                             -(row->q12 * row->y1 + row->q22 * row->y2)};
}

/* Eliminates row k of 1 … both. `carry`: in, of the row before, at first zero; out, its own, or where the halves meet in it what is left of
 * it. */
static inline __attribute__((always_inline)) void sp_eliminate(struct sp_fold fold, struct sp_row *rows, int32_t k, double shift,
                                                               struct sp_carry *carry, struct sp_tally *tally) {
    int meets = !fold.odd && k == fold.both; /* in lane 1 of this row */
    struct sp_carry p = sp_reduce(rows + k, shift, *carry);
    sp_pivot(rows + k, p, (sp_mask){-1, meets ? 0 : -1}, tally);
    *carry = meets ? p : sp_carry_of(rows + k);
}

/* Where the halves meet, after rows 1 … both: the factorisation's outcome. */
struct sp_inertia sp_blocks_join(struct sp_fold fold, struct sp_row *rows, double shift, struct sp_carry carry, struct sp_tally tally);

#endif
