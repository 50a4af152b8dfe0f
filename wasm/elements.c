/* High-order elements: gradient and Hessian of their energy, static condensation, two mirrored elements at a time. MATH.md, "Elements". */
#include "elements.h"
#include "metric_elements.h"
#include "scalar.h"

/* The charts of the p + 1 nodes of element pair e. */
static const sp_pair *element_charts(const struct sp_elements *elements, const sp_pair *charts, int32_t e) {
    return charts + (size_t)SP_CHART * (size_t)(e * elements->reference.degree);
}

double sp_elements_border(const struct sp_elements *elements, int32_t e) {
    double t = (double)e / elements->count, at = t * SP_SPREAD;
    if (!elements->spread) return t;
    int32_t k = at < SP_SPREAD ? (int32_t)at : SP_SPREAD - 1;
    return elements->spread[k] + (at - k) * (elements->spread[k + 1] - elements->spread[k]);
}

/* What differentiates and integrates over an element pair: at how many points; per point weights in the energy, lane by lane, and in the
 * length; D, K lane by lane; how many times shorter than the mean the elements are, which their share in the energy is multiplied by. */
struct integral {
    sp_pair factor;
    int32_t points;
    const double *weight[2], *length_weight, *derivative, *stiffness[2];
};

static double stretch_at(const struct sp_elements *elements, int32_t e) {
    return 1 / (elements->count * (sp_elements_border(elements, e + 1) - sp_elements_border(elements, e)));
}

sp_pair sp_elements_stretch(const struct sp_elements *elements, int32_t e) {
    if (!elements->spread || elements->reference.degree == 1) return sp_splat(1.0);
    return (sp_pair){stretch_at(elements, e), stretch_at(elements, elements->count - 1 - e)};
}

static struct integral integral_of(const struct sp_elements *elements, int32_t e) {
    const struct sp_reference *plain = &elements->reference;
    const struct sp_graded *graded = &elements->graded;
    if (e == 0 && sp_elements_graded(elements))
        return (struct integral){sp_elements_stretch(elements, e),
                                 graded->count,
                                 {graded->weight[0], graded->weight[1]},
                                 graded->length_weight,
                                 graded->derivative,
                                 {graded->stiffness[0], graded->stiffness[1]}};
    return (struct integral){
        sp_elements_stretch(elements, e),    plain->degree + 1, {plain->weight, plain->weight}, plain->weight, plain->derivative,
        {plain->stiffness, plain->stiffness}};
}

static sp_pair stiffness_at(const struct integral *integral, int32_t at) {
    return integral->factor * (sp_pair){integral->stiffness[0][at], integral->stiffness[1][at]};
}

/* An element pair's share in the energy and in the length. */
struct share {
    sp_pair squares, length;
};

/* V_q = sum_j D_qj (X_j - X_o), the derivative of the interpolated path at the points of an element pair, times weight_q, into `velocity`;
 * X_o a node near q, which keeps short elements exact. */
static struct share differentiate(const struct integral *integral, int32_t p, const sp_pair *charts, sp_pair *velocity) {
    struct share share = {{0}, {0}};
    const double *row = integral->derivative;
    for (int32_t q = 0; q < integral->points; q++, row += p + 1) {
        struct sp_vector here = sp_load(charts + (integral->points == p + 1 ? SP_CHART * q : 0)), sum = {{0}, {0}, {0}};
        const sp_pair *there = charts;
        for (int32_t j = 0; j <= p; j++, there += SP_CHART)
            sum = sp_add(sum, sp_scale(sp_subtract(sp_load(there), here), sp_splat(row[j])));
        sp_pair squared = sp_dot(sum, sum), weight = integral->factor * (sp_pair){integral->weight[0][q], integral->weight[1][q]};
        share.squares += weight * squared;
        share.length += integral->length_weight[q] * sp_square_root(squared);
        sp_store(sp_scale(sum, weight), velocity + 3 * q);
    }
    return share;
}

double sp_elements_squares(const struct sp_elements *elements, const sp_pair *charts, double *length) {
    struct share sum = {{0}, {0}};
    for (int32_t e = 0; e < elements->count / 2; e++) {
        struct integral integral = integral_of(elements, e);
        struct share share = differentiate(&integral, elements->reference.degree, element_charts(elements, charts, e), elements->velocity);
        sum.squares += share.squares, sum.length += share.length;
    }
    if (length) *length = sum.length[0] + sum.length[1];
    return sum.squares[0] + sum.squares[1];
}

/* D_i = sum_q D_qi weight_q V_q, what node i of the element pair in `velocity` adds to minus the force on it. */
static struct sp_vector element_pull(const struct integral *integral, int32_t p, const sp_pair *velocity, int32_t i) {
    struct sp_vector sum = {{0}, {0}, {0}};
    const double *at = integral->derivative + i;
    for (int32_t q = 0; q < integral->points; q++, at += p + 1)
        sum = sp_add(sum, sp_scale(sp_load(velocity + 3 * q), sp_splat(*at)));
    return sum;
}

struct sp_vector sp_elements_end_pull(const struct sp_elements *elements, const sp_pair *charts) {
    struct integral integral = integral_of(elements, 0);
    differentiate(&integral, elements->reference.degree, charts, elements->velocity);
    return element_pull(&integral, elements->reference.degree, elements->velocity, 0);
}

/* One row, and the coordinates of it that are held. */
static int32_t assemble_node(const struct sp_polyline *line, int32_t k, struct sp_vector pull, sp_pair weight, struct sp_row *row,
                             sp_mask *straight, sp_mask held[2]) {
    const sp_pair *chart = line->nodes.charts + SP_CHART * k;
    sp_row_assemble(chart, pull, weight, *straight, row);
    held[0] = held[1] = (sp_mask){0, 0};
    if (!line->touches || !sp_row_find_held(line->surface, line->nodes.places + 2 * k, row, held)) return 0;
    *straight |= held[0] | held[1];
    sp_row_assemble(chart, pull, weight, *straight, row);
    sp_row_hold(row, held);
    return 1;
}

struct sp_energy sp_elements_assemble(const struct sp_elements *elements, const struct sp_polyline *line, enum sp_hessian hessian,
                                      struct sp_row *rows, sp_mask *straight, sp_mask *held) {
    int32_t p = elements->reference.degree, pairs = elements->count / 2;
    struct sp_energy energy = {0};
    struct sp_vector carried = {{0}, {0}, {0}};
    sp_pair squares = sp_splat(0.0), carried_weight = squares;
    held[0] = held[1] = (sp_mask){-1, -1}; /* the ends, where the surface may have no finite derivatives */
    for (int32_t e = 0; e < pairs; e++) {
        struct integral integral = integral_of(elements, e);
        squares += differentiate(&integral, p, element_charts(elements, line->nodes.charts, e), elements->velocity).squares;
        for (int32_t i = e == 0; i <= p; i++) {
            struct sp_vector pull = element_pull(&integral, p, elements->velocity, i);
            sp_pair weight = stiffness_at(&integral, i * (p + 1) + i);
            int32_t k = e * p + i;
            if (i == 0) pull = sp_add(pull, carried), weight += carried_weight;
            if (i == p && e < pairs - 1) {
                carried = pull, carried_weight = weight;
                continue;
            }
            if (k == p * pairs) pull = sp_add(pull, sp_swap_vector(pull)), weight += sp_swap(weight);
            straight[k] = hessian == SP_COORDINATE ? (sp_mask){-1, -1} : (sp_mask){0, 0};
            energy.active += assemble_node(line, k, pull, weight, rows + k, straight + k, held + 2 * k);
        }
    }
    energy.squares = squares[0] + squares[1];
    energy.gradient_squared = sp_rows_gradient_squared(line->fold, rows);
    return energy;
}

/* The tangent vectors of a node, zero in held coordinates. */
static void load_frame(const sp_pair *chart, const sp_mask *held, struct sp_vector frame[2]) {
    sp_pair zero = sp_splat(0.0);
    for (int a = 0; a < 2; a++) {
        frame[a] = sp_load(chart + (a ? SP_CHART_2 : SP_CHART_1));
        frame[a] = (struct sp_vector){sp_select(held[a], zero, frame[a].x), sp_select(held[a], zero, frame[a].y),
                                      sp_select(held[a], zero, frame[a].z)};
    }
}

/* The node whose two unknowns stand at rows 2 rank and 2 rank + 1 of an element's matrix, of which only the lower triangle is stored: inner
 * nodes, then the outer border, then the inner one (towards the middle). Then follows the right-hand side, as a row. */
static int32_t node_at(int32_t degree, int32_t rank) { return rank < degree - 1 ? rank + 1 : rank == degree ? degree : 0; }

/* K_ij B_i'B_j between the nodes of an element. */
static void fill_couplings(const struct sp_elements *elements, int32_t e, const sp_pair *charts, const sp_mask *held, sp_pair *matrix) {
    int32_t p = elements->reference.degree, order = sp_elements_order(p);
    struct integral integral = integral_of(elements, e);
    struct sp_vector frames[2 * (SP_MAX_DEGREE + 1)];
    for (int32_t rank = 0; rank <= p; rank++) {
        int32_t i = node_at(p, rank);
        struct sp_vector *frame = frames + 2 * rank;
        sp_pair *row = matrix + 2 * rank * order;
        load_frame(charts + SP_CHART * i, held + 2 * i, frame);
        for (int32_t other = 0; other < rank; other++, row += 2) {
            sp_pair stiffness = stiffness_at(&integral, i * (p + 1) + node_at(p, other));
            const struct sp_vector *there = frames + 2 * other;
            row[0] = stiffness * sp_dot(frame[0], there[0]), row[1] = stiffness * sp_dot(frame[0], there[1]);
            row[order] = stiffness * sp_dot(frame[1], there[0]), row[order + 1] = stiffness * sp_dot(frame[1], there[1]);
        }
    }
}

/* The same where length has a metric of its own. */
static void fill_metric_couplings(const struct sp_elements *elements, const struct sp_polyline *line, int32_t e, const sp_mask *held,
                                  sp_pair *matrix) {
    int32_t p = elements->reference.degree, order = sp_elements_order(p);
    struct sp_metric_element element;
    sp_metric_open(elements, line, line->nodes, e, &element);
    for (int32_t rank = 0; rank <= p; rank++)
        for (int32_t other = 0; other < rank; other++) {
            sp_pair block[4], *row = matrix + 2 * rank * order + 2 * other;
            sp_metric_couple(&element, node_at(p, rank), node_at(p, other), held, block);
            row[0] = block[0], row[1] = block[1], row[order] = block[2], row[order + 1] = block[3];
        }
}

/* One element's matrix but for its couplings: the diagonal blocks of its inner nodes, and their right-hand sides; those of the borders are
 * the skeleton's. */
static void fill_matrix(const struct sp_elements *elements, const struct sp_row *rows, double shift, sp_pair *matrix) {
    int32_t p = elements->reference.degree, order = sp_elements_order(p), right = 2 * (p + 1);
    for (int32_t i = 1; i < p; i++) {
        const struct sp_row *node = rows + i;
        int32_t at = 2 * (i - 1);
        sp_pair by = shift * node->weight, *row = matrix + at * order, *sides = matrix + right * order + at;
        row[at] = node->a + by * node->e;
        row[order + at] = node->b + by * node->f, row[order + at + 1] = node->d + by * node->g;
        sides[0] = node->r1, sides[1] = node->r2;
        sides[order] = sides[order + 1] = sp_splat(0.0);
    }
    for (int32_t first = 2 * (p - 1), row = first; row < order; row++)
        for (int32_t j = first; j <= row; j++)
            matrix[row * order + j] = sp_splat(0.0);
}

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

static struct sp_fold skeleton_fold(const struct sp_elements *elements) { return sp_fold_of(elements->count - 1); }

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
        fill_matrix(elements, rows + e * p, shift, matrix);
        if (line->kind->components)
            fill_metric_couplings(elements, line, e, held + 2 * e * p, matrix);
        else
            fill_couplings(elements, e, element_charts(elements, line->nodes.charts, e), held + 2 * e * p, matrix);
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
