/* High-order elements: energy, gradient and Hessian, two mirrored elements at a time. MATH.md, "Elements". */
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
static int32_t assemble_node(const struct sp_polyline *line, int32_t k, const struct sp_vector *pull, sp_pair weight, struct sp_row *row,
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
            energy.active += assemble_node(line, k, &pull, weight, rows + k, straight + k, held + 2 * k);
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
    sp_metric_open(elements, line, e, &element);
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

void sp_elements_fill(const struct sp_elements *elements, const struct sp_polyline *line, int32_t e, const struct sp_row *rows,
                      const sp_mask *held, double shift, sp_pair *matrix) {
    int32_t first = e * elements->reference.degree;
    fill_matrix(elements, rows + first, shift, matrix);
    if (line->kind->components)
        fill_metric_couplings(elements, line, e, held + 2 * first, matrix);
    else
        fill_couplings(elements, e, element_charts(elements, line->nodes.charts, e), held + 2 * first, matrix);
}
