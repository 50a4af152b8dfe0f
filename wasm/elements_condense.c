/* Static condensation of elements: LDL' of each, the Schur complements on the skeleton between them, and back. MATH.md, "Elements". */
#include "elements.h"
#include "scalar.h"

/* sum_k L_ik u_jk of two rows of L and two of u; an even count. */
static void multiply(const sp_pair *l, const sp_pair *u, int32_t order, int32_t count, sp_pair sum[4]) {
    const sp_pair *next_l = l + order, *next_u = u + order;
    sp_pair s00 = sp_splat(0.0), s01 = s00, s10 = s00, s11 = s00;
    for (int32_t k = 0; k < count; k += 2, l += 2, next_l += 2, u += 2, next_u += 2) {
        s00 += u[0] * l[0], s01 += u[0] * next_l[0], s10 += next_u[0] * l[0], s11 += next_u[0] * next_l[0];
        s00 += u[1] * l[1], s01 += u[1] * next_l[1], s10 += next_u[1] * l[1], s11 += next_u[1] * next_l[1];
    }
    sum[0] = s00, sum[1] = s01, sum[2] = s10, sum[3] = s11;
}

/* Turns the entries of two rows left of their diagonal block from those of H into u = L D, all but for the columns from `inner` on, which
 * become their Schur complement. */
static void reduce_rows(sp_pair *matrix, int32_t order, int32_t inner, int32_t j) {
    sp_pair *u = matrix + j * order, *next = u + order, sum[4];
    for (int32_t i = 0; i < j; i += 2) {
        const sp_pair *l = matrix + i * order;
        multiply(l, u, order, i < inner ? i : inner, sum);
        u[i] -= sum[0], u[i + 1] -= sum[1], next[i] -= sum[2], next[i + 1] -= sum[3];
        if (i >= inner) continue;
        u[i + 1] -= l[order + i] * u[i], next[i + 1] -= l[order + i] * next[i];
    }
}

/* Divides `count` entries of two rows by the pivots, whose reciprocals stand on the diagonal, and takes the products with what they were
 * from the diagonal block. */
static void divide_rows(sp_pair *matrix, int32_t order, int32_t count, int32_t j) {
    sp_pair *u = matrix + j * order, *next = u + order, a = u[j], b = next[j], d = next[j + 1];
    for (int32_t k = 0; k < count; k++) {
        sp_pair reciprocal = matrix[k * order + k], first = u[k] * reciprocal, second = next[k] * reciprocal;
        a -= first * u[k], b -= first * next[k], d -= second * next[k];
        u[k] = first, next[k] = second;
    }
    u[j] = a, next[j] = b, next[j + 1] = d;
}

/* Counts a pivot and turns it into its reciprocal. */
static void invert(sp_pair *pivot, struct sp_inertia *inertia) {
    for (int lane = 0; lane < 2; lane++) {
        double value = (*pivot)[lane];
        if (!(value != 0 && is_finite(value))) inertia->usable = 0;
        inertia->negative += value < 0;
    }
    *pivot = 1.0 / *pivot;
}

/* LDL' of the first `inner` rows, in place, by rows in twos: L, on its diagonal D^-1; below, what is left on the borders is the Schur
 * complement, and beside the right-hand side's stands D^-1 L^-1 r. */
static struct sp_inertia eliminate(sp_pair *matrix, int32_t order, int32_t inner) {
    struct sp_inertia inertia = {0, 1, 0, 0};
    for (int32_t j = 0; j < order; j += 2) {
        sp_pair *row = matrix + j * order, *next = row + order;
        reduce_rows(matrix, order, inner, j);
        divide_rows(matrix, order, j < inner ? j : inner, j);
        if (j >= inner) continue;
        sp_pair coupling = next[j];
        invert(row + j, &inertia);
        next[j] = coupling * row[j];
        next[j + 1] -= next[j] * coupling;
        invert(next + j + 1, &inertia);
    }
    /* The right-hand side's own Schur complement is -r'H^-1 r. */
    sp_pair ascent = matrix[(inner + 4) * order + inner + 4];
    inertia.descent = -(ascent[0] + ascent[1]);
    return inertia;
}

/* Rows of the skeleton begin as those of their nodes; elements add their Schur complements. */
static void start_skeleton(const struct sp_elements *elements, const struct sp_row *rows, double shift) {
    int32_t p = elements->reference.degree;
    for (int32_t e = 1; e <= elements->count / 2; e++) {
        struct sp_row *row = elements->skeleton + e;
        *row = rows[e * p];
        sp_pair by = shift * row->weight;
        row->a += by * row->e, row->b += by * row->f, row->d += by * row->g;
        row->weight = sp_splat(2.0);
    }
}

/* Adds what condensing element pair e leaves to its two borders. */
static void add_schur(const struct sp_elements *elements, const sp_pair *matrix, int32_t e) {
    int32_t p = elements->reference.degree, order = sp_elements_order(p), outer = 2 * (p - 1), inner = 2 * p;
    const sp_pair *first = matrix + outer * order + outer, *second = matrix + inner * order + inner, *right = matrix + (inner + 2) * order;
    const sp_pair *between = matrix + inner * order + outer;
    struct sp_row *before = elements->skeleton + e, *after = before + 1;
    sp_pair a = second[0], b = second[order], d = second[order + 1], r1 = right[inner], r2 = right[inner + 1];
    if (e == elements->count / 2 - 1) a += sp_swap(a), b += sp_swap(b), d += sp_swap(d), r1 += sp_swap(r1), r2 += sp_swap(r2);
    after->a += a, after->b += b, after->d += d, after->r1 += r1, after->r2 += r2;
    before->q11 = -between[0], before->q12 = -between[order];
    before->q21 = -between[1], before->q22 = -between[order + 1];
    if (e == 0) return;
    before->a += first[0], before->b += first[order], before->d += first[order + 1];
    before->r1 += right[outer], before->r2 += right[outer + 1];
}

static struct sp_fold skeleton_fold(const struct sp_elements *elements) { return (struct sp_fold){elements->count - 1}; }

static sp_pair *matrix_of(const struct sp_elements *elements, int32_t e) {
    int32_t order = sp_elements_order(elements->reference.degree);
    return elements->matrices + (size_t)e * (size_t)(order * order);
}

struct sp_inertia sp_elements_factor(const struct sp_elements *elements, const struct sp_polyline *line, const struct sp_row *rows,
                                     const sp_mask *held, double shift) {
    int32_t p = elements->reference.degree, order = sp_elements_order(p);
    struct sp_inertia inertia = {0, 1, 0, 0};
    start_skeleton(elements, rows, shift);
    for (int32_t e = 0; e < elements->count / 2; e++) {
        sp_pair *matrix = matrix_of(elements, e);
        sp_elements_fill(elements, line, e, rows, held, shift, matrix);
        struct sp_inertia inner = eliminate(matrix, order, 2 * (p - 1));
        inertia.negative += inner.negative, inertia.usable &= inner.usable, inertia.descent += inner.descent;
        add_schur(elements, matrix, e);
    }
    struct sp_inertia skeleton = sp_blocks_factor(skeleton_fold(elements), elements->skeleton, 0);
    skeleton.negative += inertia.negative, skeleton.usable &= inertia.usable, skeleton.descent += inertia.descent;
    return skeleton;
}

/* Inner unknowns of element pair e from its borders, which `x` holds: backwards through L'. */
static void back_substitute(const struct sp_elements *elements, int32_t e, int32_t from, int add_right, sp_pair *x) {
    int32_t p = elements->reference.degree, order = sp_elements_order(p), inner = 2 * (p - 1);
    const sp_pair *matrix = matrix_of(elements, e), *right = matrix + (inner + 4) * order;
    sp_pair values[2 * (SP_MAX_DEGREE + 1)], *nodes = x + 2 * e * p;
    for (int32_t j = 0; j < inner; j++)
        values[j] = nodes[2 + j];
    values[inner] = nodes[0], values[inner + 1] = nodes[1];
    values[inner + 2] = nodes[2 * p], values[inner + 3] = nodes[2 * p + 1];
    for (int32_t k = 0; k <= from; k++)
        values[k] = add_right ? right[k] : sp_splat(0.0);
    for (int32_t j = inner + 3; j > 0; j--) {
        const sp_pair *row = matrix + j * order, value = values[j];
        for (int32_t k = 0; k < j && k <= from; k++)
            values[k] -= row[k] * value;
    }
    for (int32_t j = 0; j < inner; j++)
        nodes[2 + j] = values[j];
}

/* From the skeleton's solution, at its nodes' places in x, to all nodes. */
static void expand(const struct sp_elements *elements, int add_right, sp_pair *x) {
    int32_t inner = 2 * (elements->reference.degree - 1);
    for (int32_t e = 0; e < elements->count / 2; e++)
        back_substitute(elements, e, inner - 1, add_right, x);
}

/* Moves the skeleton's solution, two numbers a pair at the front of x, to its nodes' places; last first, as they only move up. */
static void spread(const struct sp_elements *elements, sp_pair *x) {
    int32_t p = elements->reference.degree;
    for (int32_t e = elements->count / 2; e >= 1; e--)
        for (int32_t j = 0; j < 2; j++) {
            sp_pair value = x[2 * e + j];
            x[2 * e + j] = sp_splat(0.0);
            x[2 * e * p + j] = value;
        }
}

void sp_elements_solve(const struct sp_elements *elements, sp_pair *x) {
    sp_blocks_solve(skeleton_fold(elements), elements->skeleton, x);
    spread(elements, x);
    expand(elements, 1, x);
}

/* The first negative pivot inside an element: that unknown and what follows from it within the element. */
static int descend_inside(const struct sp_elements *elements, sp_pair *x) {
    int32_t p = elements->reference.degree, order = sp_elements_order(p);
    for (int32_t e = 0; e < elements->count / 2; e++)
        for (int32_t k = 0; k < 2 * (p - 1); k++)
            for (int lane = 0; lane < 2; lane++) {
                if (!(matrix_of(elements, e)[k * order + k][lane] < 0)) continue;
                x[2 * e * p + 2 + k][lane] = 1;
                back_substitute(elements, e, k - 1, 0, x);
                return 1;
            }
    return 0;
}

int sp_elements_descent(const struct sp_elements *elements, sp_pair *x) {
    int32_t count = 2 * (elements->reference.degree * elements->count / 2 + 1);
    for (int32_t k = 0; k < count; k++)
        x[k] = sp_splat(0.0);
    if (descend_inside(elements, x)) return 1;
    if (!sp_blocks_descent(skeleton_fold(elements), elements->skeleton, x)) return 0;
    spread(elements, x);
    expand(elements, 0, x);
    return 1;
}
