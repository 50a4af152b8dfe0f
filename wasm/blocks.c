/* Twisted block LDL': the two halves of the path are eliminated in the two lanes and meet in one 2 x 2 block. MATH.md, "The block solve".
 */
#include "blocks.h"

/* A symmetric 2 x 2 block. */
struct block {
    sp_pair a, b, d;
};

/* Negative eigenvalues in both lanes of a pivot, 0 … 2 each; -1 where it is singular or not finite. */
static int32_t negative_eigenvalues(struct block p, int lane) {
    double determinant = p.a[lane] * p.d[lane] - p.b[lane] * p.b[lane];
    if (determinant < 0) return 1;
    if (!(determinant > 0) || determinant == __builtin_inf()) return -1;
    return p.a[lane] < 0 ? 2 : 0;
}

static void count_pivot(struct sp_inertia *inertia, struct block p, int lane) {
    int32_t negative = negative_eigenvalues(p, lane);
    if (negative < 0)
        inertia->usable = 0;
    else
        inertia->negative += negative;
}

static struct block shifted(const struct sp_row *row, double shift) {
    sp_pair by = shift * row->weight;
    return (struct block){row->a + by * row->e, row->b + by * row->f, row->d + by * row->g};
}

static void set_pivot(struct sp_row *row, struct block p, sp_pair s1, sp_pair s2) {
    sp_pair reciprocal = 1.0 / (p.a * p.d - p.b * p.b);
    row->pa = p.a, row->pb = p.b, row->pd = p.d;
    row->y1 = reciprocal * (p.d * s1 - p.b * s2);
    row->y2 = reciprocal * (p.a * s2 - p.b * s1);
    row->w11 = reciprocal * (p.d * row->q11 - p.b * row->q21);
    row->w12 = reciprocal * (p.d * row->q12 - p.b * row->q22);
    row->w21 = reciprocal * (p.a * row->q21 - p.b * row->q11);
    row->w22 = reciprocal * (p.a * row->q22 - p.b * row->q12);
}

/* What eliminating a row takes from the next one: Q'P^-1 Q from its block, and Q'P^-1 s, added, to its right-hand side. */
struct carry {
    struct block block;
    sp_pair s1, s2;
};

static struct carry carry_of(const struct sp_row *row) {
    return (struct carry){
        {row->q11 * row->w11 + row->q21 * row->w21, row->q11 * row->w12 + row->q21 * row->w22, row->q12 * row->w12 + row->q22 * row->w22},
        row->q11 * row->y1 + row->q21 * row->y2,
        row->q12 * row->y1 + row->q22 * row->y2};
}

static struct block subtract(struct block p, struct block q) { return (struct block){p.a - q.a, p.b - q.b, p.d - q.d}; }

/* The carry of lane 0 as lane 1 meets it; nothing for lane 0. */
static struct carry across(struct carry carry) {
    sp_mask second = {0, -1};
    sp_pair zero = sp_splat(0.0);
    return (struct carry){{sp_select(second, sp_swap(carry.block.a), zero), sp_select(second, sp_swap(carry.block.b), zero),
                           sp_select(second, sp_swap(carry.block.d), zero)},
                          sp_select(second, sp_swap(carry.s1), zero),
                          sp_select(second, sp_swap(carry.s2), zero)};
}

/* Both carries together. */
static struct carry both_carries(struct carry carry) {
    return (struct carry){
        {carry.block.a + sp_swap(carry.block.a), carry.block.b + sp_swap(carry.block.b), carry.block.d + sp_swap(carry.block.d)},
        carry.s1 + sp_swap(carry.s1),
        carry.s2 + sp_swap(carry.s2)};
}

struct sp_inertia sp_blocks_factor(struct sp_fold fold, struct sp_row *rows, double shift) {
    struct sp_inertia inertia = {0, 1};
    struct carry carry = {0};
    struct sp_row *row = rows;
    struct block p = {0};
    sp_pair s1 = sp_splat(0.0), s2 = s1;
    for (int32_t k = 1; k <= fold.both; k++) {
        row = rows + k;
        p = subtract(shifted(row, shift), carry.block);
        s1 = row->r1 + carry.s1, s2 = row->r2 + carry.s2;
        set_pivot(row, p, s1, s2);
        carry = carry_of(row);
        count_pivot(&inertia, p, 0);
        if (fold.odd || k < fold.both) count_pivot(&inertia, p, 1);
    }
    /* The halves meet: n odd, in the middle node, which takes both carries; n even, lane 1 of the last pair takes that of lane 0. */
    if (fold.odd) {
        row = rows + fold.both + 1, p = shifted(row, shift), s1 = row->r1, s2 = row->r2;
        carry = both_carries(carry);
    } else {
        carry = across(carry);
    }
    p = subtract(p, carry.block);
    set_pivot(row, p, s1 + carry.s1, s2 + carry.s2);
    count_pivot(&inertia, p, 1);
    return inertia;
}

/* x_k = start_k + W_k x_(k+1), outwards from pair `from`. */
static void carry_outwards(const struct sp_row *rows, int32_t from, int add_right, sp_pair *x) {
    for (int32_t k = from; k >= 1; k--) {
        sp_pair u = x[2 * k + 2], v = x[2 * k + 3];
        x[2 * k] = rows[k].w11 * u + rows[k].w12 * v;
        x[2 * k + 1] = rows[k].w21 * u + rows[k].w22 * v;
        if (add_right) x[2 * k] += rows[k].y1, x[2 * k + 1] += rows[k].y2;
    }
}

/* n even: lane 0 of the last pair follows from lane 1, which is known. */
static void unfold_last(struct sp_fold fold, const struct sp_row *rows, int add_right, sp_pair *x) {
    const struct sp_row *last = rows + fold.both;
    sp_pair *at = x + 2 * fold.both;
    double u = at[0][1], v = at[1][1];
    at[0][0] = last->w11[0] * u + last->w12[0] * v + (add_right ? last->y1[0] : 0.0);
    at[1][0] = last->w21[0] * u + last->w22[0] * v + (add_right ? last->y2[0] : 0.0);
}

/* From the solution at the meeting row outwards to both ends. */
static void finish(struct sp_fold fold, const struct sp_row *rows, int add_right, sp_pair *x) {
    if (!fold.odd) unfold_last(fold, rows, add_right, x);
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
    double radius = sp_square_root(sp_splat(half * half + b * b))[0];
    if (b == 0) {
        *u = a <= d, *v = a > d;
    } else if (half > 0) {
        *u = b, *v = -(half + radius);
    } else {
        *u = half - radius, *v = b;
    }
}

/* Whether the pivot in this lane of pair k is the one where the halves meet. */
static int is_meeting(struct sp_fold fold, int32_t k, int lane) { return k == sp_fold_unknown(fold) && (fold.odd || lane == 1); }

int sp_blocks_descent(struct sp_fold fold, const struct sp_row *rows, sp_pair *x) {
    for (int32_t k = 1; k <= sp_fold_unknown(fold); k++)
        for (int lane = 0; lane < 2; lane++) {
            if (negative_eigenvalues((struct block){rows[k].pa, rows[k].pb, rows[k].pd}, lane) <= 0) continue;
            double u, v;
            for (int32_t i = 0; i < 2 * sp_fold_pairs(fold); i++)
                x[i] = sp_splat(0.0);
            lowest_direction(rows + k, lane, &u, &v);
            x[2 * k][lane] = u, x[2 * k + 1][lane] = v;
            if (fold.odd && is_meeting(fold, k, lane)) x[2 * k] = sp_splat(u), x[2 * k + 1] = sp_splat(v);
            if (is_meeting(fold, k, lane))
                finish(fold, rows, 0, x);
            else
                carry_outwards(rows, k - 1, 0, x);
            sp_fold_mirror(fold, x, 2);
            return 1;
        }
    return 0;
}

/* Smaller eigenvalue of P relative to M: the smaller root of det(P - x M) = 0. */
static double relative_eigenvalue(const struct sp_row *row, int lane) {
    double a = row->pa[lane], b = row->pb[lane], d = row->pd[lane];
    double weight = row->weight[lane], e = weight * row->e[lane], f = weight * row->f[lane], g = weight * row->g[lane];
    double second = e * g - f * f, first = 0.5 * (a * g + d * e - 2 * b * f), zeroth = a * d - b * b;
    double root = first * first - second * zeroth;
    return zeroth / (first + sp_square_root(sp_splat(root > 0 ? root : 0))[0]);
}

double sp_blocks_conditioning(struct sp_fold fold, const struct sp_row *rows) {
    int32_t meeting = sp_fold_unknown(fold);
    double smallest = 0.5 * (fold.inner + 1) * relative_eigenvalue(rows + meeting, 1);
    for (int32_t k = 1; k <= fold.both; k++)
        for (int lane = 0; lane < 2; lane++) {
            double value = is_meeting(fold, k, lane) ? smallest : relative_eigenvalue(rows + k, lane);
            if (value < smallest) smallest = value;
        }
    return smallest;
}
