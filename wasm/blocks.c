/* Twisted block LDL': the two halves of the path are eliminated in the two lanes and meet in one 2 x 2 block. MATH.md, "The block solve".
 */
#include "elimination.h"
#include "scalar.h"

/* How many eigenvalues of the pivot of a row are negative in this lane; -1: it is singular or not finite. */
static int negative_eigenvalues(const struct sp_row *row, int lane) {
    double determinant = row->pa[lane] * row->pd[lane] - row->pb[lane] * row->pb[lane];
    if (determinant < 0) return 1;
    if (!(determinant > 0 && determinant < __builtin_inf())) return -1;
    return row->pa[lane] < 0 ? 2 : 0;
}

static struct sp_carry add(struct sp_carry p, struct sp_carry q) {
    return (struct sp_carry){p.a + q.a, p.b + q.b, p.d + q.d, p.s1 + q.s1, p.s2 + q.s2};
}

static struct sp_carry swap(struct sp_carry carry) {
    return (struct sp_carry){sp_swap(carry.a), sp_swap(carry.b), sp_swap(carry.d), sp_swap(carry.s1), sp_swap(carry.s2)};
}

/* In lane 1 alone. */
static struct sp_carry second_lane(struct sp_carry carry) {
    sp_mask second = {0, -1};
    sp_pair zero = sp_splat(0.0);
    return (struct sp_carry){sp_select(second, carry.a, zero), sp_select(second, carry.b, zero), sp_select(second, carry.d, zero),
                             sp_select(second, carry.s1, zero), sp_select(second, carry.s2, zero)};
}

/* How many eigenvalues of the pivots are negative, and whether all pivots may be solved by: what is known without a look where all are
 * positive definite. */
static void count_negative(struct sp_fold fold, const struct sp_row *rows, struct sp_inertia *inertia) {
    for (int32_t k = 1; k <= sp_fold_unknown(fold); k++)
        for (int lane = k > sp_fold_both(fold); lane < 2; lane++) {
            int negative = negative_eigenvalues(rows + k, lane);
            if (negative < 0)
                inertia->usable = 0;
            else
                inertia->negative += negative;
        }
}

struct sp_inertia sp_blocks_join(struct sp_fold fold, struct sp_row *rows, double shift, const struct sp_sweep *sweep) {
    struct sp_row *row = rows + sp_fold_unknown(fold);
    struct sp_carry carry = sweep->carry;
    /* The middle node takes both carries, their sum first: its lanes are one node, and must agree to the bit, or a pivot that is nearly
     * singular drives them apart. Without one lane 1 takes that of lane 0, too, which is the row before it. */
    struct sp_carry p = sp_reduce(sp_row_left(row, shift), sp_fold_odd(fold) ? add(carry, swap(carry)) : carry);
    sp_pair trace;
    sp_mask definite;
    for (int again = !sp_fold_odd(fold);; again = 0) {
        definite = sweep->definite & sp_pivot(row, p, &trace);
        if (!again) break;
        p = sp_reduce(p, second_lane(swap(sp_carry_of(row))));
    }
    double met = 2.0 / (fold.inner + 1);
    sp_pair softness = sp_larger(sweep->softness, (sp_pair){sp_fold_odd(fold) ? met : 1, met} * trace);
    sp_pair last = p.s1 * row->y1 + p.s2 * row->y2, descent = sweep->descent + (sp_pair){sp_fold_odd(fold) ? 0 : last[0], last[1]};
    struct sp_inertia inertia = {0, 1, descent[0] + descent[1], sp_larger(softness, sp_swap(softness))[0]};
    if (!(definite[0] && definite[1])) count_negative(fold, rows, &inertia), inertia.softness = __builtin_inf();
    return inertia;
}

struct sp_inertia sp_blocks_factor(struct sp_fold fold, struct sp_row *rows, double shift) {
    struct sp_sweep sweep = sp_sweep_start();
    for (int32_t k = 1; k < sp_fold_unknown(fold); k++)
        sp_eliminate(rows + k, shift, &sweep);
    struct sp_sweep end = sweep; /* a copy, as what a pointer leads to lies in memory, for all of the loop */
    return sp_blocks_join(fold, rows, shift, &end);
}

/* x_k = start_k + W_k x_(k+1), outwards from pair `from`. */
static void carry_outwards(const struct sp_row *rows, int32_t from, int add_right, sp_pair *x) {
    sp_pair u = x[2 * from + 2], v = x[2 * from + 3];
    for (int32_t k = from; k >= 1; k--) {
        const struct sp_row *row = rows + k;
        sp_pair next_u = row->w11 * u + row->w12 * v, next_v = row->w21 * u + row->w22 * v;
        u = add_right ? next_u + row->y1 : next_u, v = add_right ? next_v + row->y2 : next_v;
        x[2 * k] = u, x[2 * k + 1] = v;
    }
}

/* n even: lane 0 of the last pair follows from lane 1, which is known. */
static void unfold_last(struct sp_fold fold, const struct sp_row *rows, int add_right, sp_pair *x) {
    const struct sp_row *last = rows + sp_fold_both(fold);
    sp_pair *at = x + 2 * sp_fold_both(fold);
    double u = at[0][1], v = at[1][1];
    at[0][0] = last->w11[0] * u + last->w12[0] * v + (add_right ? last->y1[0] : 0.0);
    at[1][0] = last->w21[0] * u + last->w22[0] * v + (add_right ? last->y2[0] : 0.0);
}

/* From the solution at the meeting row outwards to both ends. */
static void finish(struct sp_fold fold, const struct sp_row *rows, int add_right, sp_pair *x) {
    if (!sp_fold_odd(fold)) unfold_last(fold, rows, add_right, x);
    carry_outwards(rows, sp_fold_unknown(fold) - 1, add_right, x);
    x[0] = x[1] = sp_splat(0.0);
    sp_fold_mirror(fold, x, 2);
}

void sp_blocks_solve(struct sp_fold fold, const struct sp_row *rows, sp_pair *x) {
    int32_t meeting = sp_fold_unknown(fold);
    x[2 * meeting] = rows[meeting].y1, x[2 * meeting + 1] = rows[meeting].y2;
    finish(fold, rows, 1, x);
}

/* Eigenvector of the smaller eigenvalue of a pivot. */
static void lowest_direction(const struct sp_row *row, int lane, double *u, double *v) {
    double a = row->pa[lane], b = row->pb[lane], d = row->pd[lane], half = 0.5 * (a - d);
    double radius = root(half * half + b * b);
    if (b == 0) {
        *u = a <= d, *v = a > d;
    } else if (half > 0) {
        *u = b, *v = -(half + radius);
    } else {
        *u = half - radius, *v = b;
    }
}

/* Whether the pivot in this lane of pair k is the one where the halves meet. */
static int is_meeting(struct sp_fold fold, int32_t k, int lane) { return k == sp_fold_unknown(fold) && (sp_fold_odd(fold) || lane == 1); }

int sp_blocks_descent(struct sp_fold fold, const struct sp_row *rows, sp_pair *x) {
    for (int32_t k = 1; k <= sp_fold_unknown(fold); k++)
        for (int lane = 0; lane < 2; lane++) {
            if (negative_eigenvalues(rows + k, lane) <= 0) continue;
            double u, v;
            for (int32_t i = 0; i < 2 * sp_fold_pairs(fold); i++)
                x[i] = sp_splat(0.0);
            lowest_direction(rows + k, lane, &u, &v);
            x[2 * k][lane] = u, x[2 * k + 1][lane] = v;
            if (sp_fold_odd(fold) && is_meeting(fold, k, lane)) x[2 * k] = sp_splat(u), x[2 * k + 1] = sp_splat(v);
            if (is_meeting(fold, k, lane))
                finish(fold, rows, 0, x);
            else
                carry_outwards(rows, k - 1, 0, x);
            sp_fold_mirror(fold, x, 2);
            return 1;
        }
    return 0;
}
