/* Energy, gradient and Hessian under a metric tensor; node by node from what the one or two elements around it give. Checked in
 * tests/native against finite differences. MATH.md, "Metrics". */
#include "metric_elements.h"

/* What an element adds to a node, one sp_pair each; the sums of two elements are the node's. */
enum {
    PULL = 0,       /* sum_q D_qi weight_q T_q V_q, a vector */
    TURNING_1 = 3,  /* weight_i D_ii T_1 V_i, a vector */
    TURNING_2 = 6,  /* weight_i D_ii T_2 V_i */
    SLOPE = 9,      /* weight_i V_i' T_a V_i / 2, a = 1, 2 */
    CURVATURE = 11, /* weight_i V_i' T_ab V_i / 2, ab = 11, 12, 22 */
    MASS = 14,      /* sum_q weight_q D_qi^2 T_q, `components` numbers */
    TERMS = MASS + SP_METRIC_COMPONENTS
};

/* Elements of a path, and the pairs in which they lie: of an odd number the middle one stands twice in the last pair. */
static int32_t count_of(const struct sp_reference *reference, const struct sp_polyline *line) {
    return (line->fold.inner + 1) / reference->degree;
}

static int32_t pairs_of(const struct sp_reference *reference, const struct sp_polyline *line) {
    return (count_of(reference, line) + 1) / 2;
}

static double both_lanes(const struct sp_reference *reference, const struct sp_polyline *line, sp_pair sum, sp_pair last) {
    return count_of(reference, line) % 2 ? sum[0] + sum[1] + last[0] : sum[0] + sum[1] + last[0] + last[1];
}

/* Reads charts, metrics and velocities of element pair e: V_q = sum_j D_qj (X_j - X_q). */
static void open_element(const struct sp_reference *reference, const struct sp_polyline *line, struct sp_nodes nodes, int32_t e,
                         struct sp_metric_element *element) {
    int32_t p = reference->degree, first = e * p;
    element->reference = reference, element->components = line->kind->components;
    element->charts = nodes.charts + SP_CHART * first;
    element->metrics = nodes.metrics + SP_METRIC_PARTS * element->components * first;
    for (int32_t q = 0; q <= p; q++) {
        struct sp_vector here = sp_load(element->charts + SP_CHART * q), sum = {{0}, {0}, {0}};
        for (int32_t j = 0; j <= p; j++) {
            if (j == q) continue;
            struct sp_vector there = sp_load(element->charts + SP_CHART * j);
            sum = sp_add(sum, sp_scale(sp_subtract(there, here), sp_splat(reference->derivative[q * (p + 1) + j])));
        }
        element->velocity[q] = sum;
    }
}

static const sp_pair *metric_at(const struct sp_metric_element *element, int32_t i, int32_t part) {
    return element->metrics + element->components * (SP_METRIC_PARTS * i + part);
}

/* T_part V at node i. */
static struct sp_vector moment(const struct sp_metric_element *element, int32_t i, int32_t part) {
    return sp_metric_times(element->components, metric_at(element, i, part), element->velocity[i]);
}

static sp_mask positive_at(const struct sp_metric_element *element, int32_t i) {
    return sp_form_positive(sp_metric_form(element->components, element->charts + SP_CHART * i, metric_at(element, i, SP_METRIC_T)));
}

double sp_metric_squares(const struct sp_reference *reference, const struct sp_polyline *line, struct sp_nodes nodes, double *length) {
    int32_t p = reference->degree, pairs = pairs_of(reference, line);
    sp_pair squares = sp_splat(0.0), along = squares, last_squares = squares, last_along = squares;
    struct sp_metric_element element;
    for (int32_t e = 0; e < pairs; e++) {
        squares += last_squares, along += last_along;
        last_squares = last_along = sp_splat(0.0);
        open_element(reference, line, nodes, e, &element);
        for (int32_t q = 0; q <= p; q++) {
            if (e + q > 0 && sp_any(~positive_at(&element, q))) return __builtin_nan("");
            sp_pair squared = sp_dot(element.velocity[q], moment(&element, q, SP_METRIC_T));
            last_squares += reference->weight[q] * squared;
            last_along += reference->weight[q] * sp_square_root(squared);
        }
    }
    if (length) *length = both_lanes(reference, line, along, last_along);
    return both_lanes(reference, line, squares, last_squares);
}

/* Adds what the element gives to its node i. */
static void add_terms(const struct sp_metric_element *element, int32_t i, sp_pair *terms) {
    const struct sp_reference *reference = element->reference;
    int32_t size = reference->degree + 1;
    double weight = reference->weight[i], own = weight * reference->derivative[i * size + i];
    struct sp_vector pull = sp_load(terms + PULL), velocity = element->velocity[i];
    for (int32_t q = 0; q < size; q++) {
        double slope = reference->derivative[q * size + i], factor = reference->weight[q] * slope;
        const sp_pair *metric = metric_at(element, q, SP_METRIC_T);
        pull = sp_add(pull, sp_scale(moment(element, q, SP_METRIC_T), sp_splat(factor)));
        for (int32_t c = 0; c < element->components; c++)
            terms[MASS + c] += factor * slope * metric[c];
    }
    sp_store(pull, terms + PULL);
    for (int32_t a = 0; a < 2; a++) {
        struct sp_vector turned = moment(element, i, SP_METRIC_T1 + a);
        sp_store(sp_add(sp_load(terms + TURNING_1 + 3 * a), sp_scale(turned, sp_splat(own))), terms + TURNING_1 + 3 * a);
        terms[SLOPE + a] += 0.5 * weight * sp_dot(velocity, turned);
    }
    for (int32_t ab = 0; ab < 3; ab++)
        terms[CURVATURE + ab] += 0.5 * weight * sp_dot(velocity, moment(element, i, SP_METRIC_T11 + ab));
}

/* Takes Gamma^c_ab grad_c from the Hessian where a node moves along geodesics of the metric: the second derivative of the energy then. */
static void make_covariant(int32_t components, const sp_pair *chart, const sp_pair *metric, sp_mask straight, struct sp_row *row) {
    struct sp_connection at = sp_metric_connection(components, chart, metric);
    sp_pair determinant = at.form.e * at.form.g - at.form.f * at.form.f, zero = sp_splat(0.0);
    sp_pair up_1 = sp_select(straight, zero, (at.form.g * row->r1 - at.form.f * row->r2) / determinant);
    sp_pair up_2 = sp_select(straight, zero, (at.form.e * row->r2 - at.form.f * row->r1) / determinant);
    row->a += at.symbols[0][0] * up_1 + at.symbols[1][0] * up_2;
    row->b += at.symbols[0][1] * up_1 + at.symbols[1][1] * up_2;
    row->d += at.symbols[0][2] * up_1 + at.symbols[1][2] * up_2;
}

/* Diagonal block, M and right-hand side of one pair of nodes from its terms. */
static void assemble_row(int32_t components, const sp_pair *chart, const sp_pair *metric, const sp_pair *terms, double weight,
                         sp_mask straight, struct sp_row *row) {
    struct sp_vector b1 = sp_load(chart + SP_CHART_1), b2 = sp_load(chart + SP_CHART_2), pull = sp_load(terms + PULL);
    struct sp_vector turning_1 = sp_load(terms + TURNING_1), turning_2 = sp_load(terms + TURNING_2);
    struct sp_form mass = sp_metric_form(components, chart, terms + MASS);
    row->weight = sp_splat(weight);
    row->e = mass.e / weight, row->f = mass.f / weight, row->g = mass.g / weight;
    row->r1 = -sp_dot(b1, pull) - terms[SLOPE], row->r2 = -sp_dot(b2, pull) - terms[SLOPE + 1];
    row->a = mass.e + 2.0 * sp_dot(turning_1, b1) + terms[CURVATURE] + sp_dot(pull, sp_load(chart + SP_CHART_11));
    row->b = mass.f + sp_dot(turning_1, b2) + sp_dot(turning_2, b1) + terms[CURVATURE + 1] + sp_dot(pull, sp_load(chart + SP_CHART_12));
    row->d = mass.g + 2.0 * sp_dot(turning_2, b2) + terms[CURVATURE + 2] + sp_dot(pull, sp_load(chart + SP_CHART_22));
    make_covariant(components, chart, metric, straight, row);
}

/* One row, and the coordinates of it that are held. */
static int32_t assemble_node(const struct sp_polyline *line, int32_t k, const sp_pair *terms, double weight, struct sp_row *row,
                             sp_mask *straight, sp_mask held[2]) {
    int32_t components = line->kind->components;
    const sp_pair *chart = line->nodes.charts + SP_CHART * k, *metric = line->nodes.metrics + SP_METRIC_PARTS * components * k;
    assemble_row(components, chart, metric, terms, weight, *straight, row);
    held[0] = held[1] = (sp_mask){0, 0};
    if (line->surface->kind != SP_PARAMETRIC || !sp_row_find_held(line->surface, line->nodes.places + 2 * k, row, held)) return 0;
    *straight |= held[0] | held[1];
    assemble_row(components, chart, metric, terms, weight, *straight, row);
    sp_row_hold(row, held);
    return 1;
}

/* Degree 1: -H between every pair of nodes and the next. */
static void assemble_couplings(const struct sp_reference *reference, const struct sp_polyline *line, const sp_mask *held,
                               struct sp_row *rows) {
    struct sp_metric_element element;
    for (int32_t k = 1; k <= line->fold.both; k++) {
        sp_pair block[4];
        sp_metric_open(reference, line, k, held, &element);
        sp_metric_couple(&element, 0, 1, block);
        rows[k].q11 = -block[0], rows[k].q12 = -block[1], rows[k].q21 = -block[2], rows[k].q22 = -block[3];
    }
}

static void clear(sp_pair *terms) {
    for (int j = 0; j < TERMS; j++)
        terms[j] = sp_splat(0.0);
}

/* Nothing is held at the ends; where the path is folded the masks are mirrored like everything else. */
static void complete_held(struct sp_fold fold, sp_mask *held) {
    held[0] = held[1] = (sp_mask){0, 0};
    for (int j = 0; j < 2 && !fold.odd; j++)
        held[2 * (fold.both + 1) + j] = sp_swap_mask(held[2 * fold.both + j]);
}

struct sp_energy sp_metric_assemble(const struct sp_reference *reference, const struct sp_polyline *line, enum sp_hessian hessian,
                                    struct sp_row *rows, sp_mask *straight, sp_mask *held) {
    int32_t p = reference->degree, pairs = pairs_of(reference, line), unknown = sp_fold_unknown(line->fold);
    struct sp_energy energy = {sp_metric_squares(reference, line, line->nodes, NULL), 0, 0};
    struct sp_metric_element element;
    sp_pair terms[TERMS];
    clear(terms);
    for (int32_t e = 0; e < pairs; e++) {
        open_element(reference, line, line->nodes, e, &element);
        for (int32_t i = 0; i <= p; i++) {
            int32_t k = e * p + i, shared = i == p && e < pairs - 1;
            if (i > 0) clear(terms);
            add_terms(&element, i, terms);
            if (k == 0 || shared || k > unknown) continue;
            if (i == p)
                for (int j = 0; j < TERMS; j++)
                    terms[j] += sp_swap(terms[j]);
            straight[k] = hessian == SP_COORDINATE ? (sp_mask){-1, -1} : (sp_mask){0, 0};
            double weight = (i == 0 || i == p ? 2 : 1) * reference->stiffness[i * (p + 1) + i];
            energy.active += assemble_node(line, k, terms, weight, rows + k, straight + k, held + 2 * k);
        }
    }
    complete_held(line->fold, held);
    if (p == 1) assemble_couplings(reference, line, held, rows);
    energy.gradient_squared = sp_rows_gradient_squared(line->fold, rows);
    return energy;
}

void sp_metric_open(const struct sp_reference *reference, const struct sp_polyline *line, int32_t e, const sp_mask *held,
                    struct sp_metric_element *element) {
    open_element(reference, line, line->nodes, e, element);
    sp_pair zero = sp_splat(0.0);
    for (int32_t i = 0; i <= reference->degree; i++)
        for (int32_t a = 0; a < 2; a++) {
            sp_mask out = held[2 * (e * reference->degree + i) + a];
            struct sp_vector frame = sp_load(element->charts + SP_CHART * i + (a ? SP_CHART_2 : SP_CHART_1));
            struct sp_vector turning = sp_scale(moment(element, i, SP_METRIC_T1 + a), sp_splat(reference->weight[i]));
            element->frame[2 * i + a] =
                (struct sp_vector){sp_select(out, zero, frame.x), sp_select(out, zero, frame.y), sp_select(out, zero, frame.z)};
            element->turning[2 * i + a] =
                (struct sp_vector){sp_select(out, zero, turning.x), sp_select(out, zero, turning.y), sp_select(out, zero, turning.z)};
        }
}

/* B_i' (sum_q weight_q D_qi D_qj T_q) B_j + D_ij (T_a V)_i . B_j + D_ji B_i . (T_b V)_j */
void sp_metric_couple(const struct sp_metric_element *element, int32_t i, int32_t j, sp_pair block[4]) {
    const struct sp_reference *reference = element->reference;
    int32_t size = reference->degree + 1;
    sp_pair sum[SP_METRIC_COMPONENTS] = {{0}};
    for (int32_t q = 0; q < size; q++) {
        double factor = reference->weight[q] * reference->derivative[q * size + i] * reference->derivative[q * size + j];
        const sp_pair *metric = metric_at(element, q, SP_METRIC_T);
        for (int32_t c = 0; c < element->components; c++)
            sum[c] += factor * metric[c];
    }
    double ij = reference->derivative[i * size + j], ji = reference->derivative[j * size + i];
    for (int b = 0; b < 2; b++) {
        struct sp_vector frame = element->frame[2 * j + b], stiff = sp_metric_times(element->components, sum, frame);
        stiff = sp_add(stiff, sp_scale(element->turning[2 * j + b], sp_splat(ji)));
        for (int a = 0; a < 2; a++)
            block[2 * a + b] = sp_dot(element->frame[2 * i + a], stiff) + ij * sp_dot(element->turning[2 * i + a], frame);
    }
}

double sp_metric_size(const struct sp_polyline *line) {
    int32_t components = line->kind->components;
    sp_pair t[SP_METRIC_COMPONENTS];
    struct sp_vector at = sp_load(line->nodes.charts);
    for (int32_t c = 0; c < components; c++)
        t[c] = sp_absolute(line->nodes.metrics[c]);
    at = (struct sp_vector){sp_absolute(at.x), sp_absolute(at.y), sp_absolute(at.z)};
    sp_pair size = sp_square_root(sp_dot(at, sp_metric_times(components, t, at)));
    return size[0] > size[1] ? size[0] : size[1];
}

sp_pair sp_metric_squared(const struct sp_polyline *line, int32_t k, struct sp_vector displacement) {
    int32_t components = line->kind->components;
    return sp_dot(displacement, sp_metric_times(components, line->nodes.metrics + SP_METRIC_PARTS * components * k, displacement));
}
