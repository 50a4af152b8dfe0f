/* Energy, gradient and Hessian under a metric tensor; node by node from what the one or two elements around it give. Checked in
 * tests/native against finite differences. MATH.md, "Metrics". */
#include "metric_elements.h"
#include "scalar.h"

/* What an element adds to a node, one sp_pair each; the sums of two elements are the node's. */
enum {
    FORCE = 0,     /* sum_q D_qi weight_q B_a' T_q V_q + weight_i V_i' T_a V_i / 2, a = 1, 2: the gradient */
    CURVATURE = 2, /* the Hessian's block but for MASS, ab = 11, 12, 22 */
    MASS = 5,      /* sum_q weight_q D_qi^2 T_q, `components` numbers */
    TERMS = MASS + SP_METRIC_COMPONENTS
};

/* Elements of a path, and the pairs in which they lie: of an odd number the middle one stands twice in the last pair. */
static int32_t count_of(const struct sp_reference *reference, const struct sp_polyline *line) {
    return (line->fold.inner + 1) / reference->degree;
}

static int32_t pairs_of(const struct sp_reference *reference, const struct sp_polyline *line) {
    return (count_of(reference, line) + 1) / 2;
}

/* What nodes ask most often is inline for a density. */
#define INLINE static inline __attribute__((always_inline))

INLINE const sp_pair *metric_at(const struct sp_metric_element *element, int32_t i, int32_t part) {
    return element->metrics + element->components * (SP_METRIC_PARTS * i + part);
}

/* a' T b */
INLINE sp_pair product(int32_t components, const sp_pair *t, const sp_pair *a, const sp_pair *b) {
    return components == 1 ? t[0] * sp_dot(sp_load(a), sp_load(b)) : sp_metric_product(components, t, a, b);
}

static struct sp_form form_of(int32_t components, const sp_pair *chart, const sp_pair *metric) {
    if (components > 1) return sp_metric_form(components, chart, metric);
    struct sp_vector b1 = sp_load(chart + SP_CHART_1), b2 = sp_load(chart + SP_CHART_2);
    return (struct sp_form){metric[0] * sp_dot(b1, b1), metric[0] * sp_dot(b1, b2), metric[0] * sp_dot(b2, b2)};
}

static struct sp_vector lower_by_tensor(int32_t components, const sp_pair *t, struct sp_vector v) {
    if (components == 3) return (struct sp_vector){t[0] * v.x + t[1] * v.y, t[1] * v.x + t[2] * v.y, sp_splat(0.0)};
    return (struct sp_vector){t[0] * v.x + t[1] * v.y + t[3] * v.z, t[1] * v.x + t[2] * v.y + t[4] * v.z,
                              t[3] * v.x + t[4] * v.y + t[5] * v.z};
}

/* T_part V at node i. */
INLINE struct sp_vector lower(const struct sp_metric_element *element, int32_t i, int32_t part) {
    const sp_pair *t = metric_at(element, i, part);
    struct sp_vector v = element->velocity[i];
    return element->components == 1 ? sp_scale(v, t[0]) : lower_by_tensor(element->components, t, v);
}

/* V_q = sum_j D_qj (X_j - X_q) */
static void open_element(const struct sp_elements *elements, const struct sp_polyline *line, const struct sp_nodes *nodes, int32_t e,
                         struct sp_metric_element *element) {
    const struct sp_reference *reference = &elements->reference;
    int32_t p = reference->degree, first = e * p;
    element->reference = reference, element->factor = sp_elements_stretch(elements, e), element->components = line->kind->components;
    element->charts = nodes->charts + SP_CHART * first;
    element->metrics = nodes->metrics + SP_METRIC_PARTS * element->components * first;
    for (int32_t q = 0; q <= p; q++) {
        struct sp_vector here = sp_load(element->charts + SP_CHART * q), sum = {sp_splat(0.0), sp_splat(0.0), sp_splat(0.0)};
        for (int32_t j = 0; j <= p; j++)
            sum = sp_add(sum, sp_scale(sp_subtract(sp_load(element->charts + SP_CHART * j), here),
                                       sp_splat(reference->derivative[q * (p + 1) + j])));
        element->velocity[q] = sum, element->momentum[q] = lower(element, q, SP_METRIC_T);
    }
}

void sp_metric_open(const struct sp_elements *elements, const struct sp_polyline *line, int32_t e, struct sp_metric_element *element) {
    open_element(elements, line, &line->nodes, e, element);
    for (int32_t q = 0; q <= element->reference->degree; q++)
        for (int a = 0; a < 2; a++)
            element->pull[a][q] = lower(element, q, SP_METRIC_T1 + a);
}

double sp_metric_squares(const struct sp_elements *elements, const struct sp_polyline *line, const struct sp_nodes *nodes, double *length) {
    const struct sp_reference *reference = &elements->reference;
    int32_t p = reference->degree, count = count_of(reference, line);
    sp_pair squares = sp_splat(0.0), along = squares;
    struct sp_metric_element element;
    for (int32_t e = 0; 2 * e < count; e++) {
        sp_pair once = {1, 2 * e + 1 < count};
        open_element(elements, line, nodes, e, &element);
        for (int32_t q = 0; q <= p; q++) {
            /* The first node of an element is the last of the one before. */
            if (q > 0 &&
                sp_any(~sp_form_positive(form_of(element.components, element.charts + SP_CHART * q, metric_at(&element, q, SP_METRIC_T)))))
                return not_a_number();
            sp_pair squared = sp_dot(element.momentum[q], element.velocity[q]), weight = reference->weight[q] * once;
            squares += element.factor * weight * squared;
            along += weight * sp_square_root(squared);
        }
    }
    if (length) *length = along[0] + along[1];
    return squares[0] + squares[1];
}

INLINE struct sp_vector base(const sp_pair *chart, int32_t a) { return sp_load(chart + SP_CHART_1 + 3 * a); }

/* Adds what the element gives to its node i. */
static void add_terms(const struct sp_metric_element *element, int32_t i, sp_pair *terms) {
    const struct sp_reference *reference = element->reference;
    int32_t size = reference->degree + 1;
    const sp_pair *chart = element->charts + SP_CHART * i;
    sp_pair weight = element->factor * reference->weight[i], own = weight * reference->derivative[i * size + i];
    struct sp_vector velocity = element->velocity[i], sum = sp_scale(velocity, sp_splat(0.0));
    for (int32_t q = 0; q < size; q++) {
        double slope = reference->derivative[q * size + i];
        sp_pair factor = element->factor * (reference->weight[q] * slope);
        const sp_pair *metric = metric_at(element, q, SP_METRIC_T);
        for (int32_t c = 0; c < element->components; c++)
            terms[MASS + c] += factor * slope * metric[c];
        sum = sp_add(sum, sp_scale(element->momentum[q], factor));
    }
    for (int32_t k = 0; k < 5; k++) /* B_1, B_2, S_11, S_12, S_22 */
        terms[FORCE + k] += sp_dot(base(chart, k), sum);
    for (int32_t a = 0; a < 2; a++)
        terms[FORCE + a] += 0.5 * weight * sp_dot(element->pull[a][i], velocity);
    for (int32_t ab = 0; ab < 3; ab++) { /* with weight_i D_ii (B_b' T_a V_i + B_a' T_b V_i) */
        int32_t a = ab / 2, b = (ab + 1) / 2;
        sp_pair turning = sp_dot(element->pull[a][i], base(chart, b)) + sp_dot(element->pull[b][i], base(chart, a));
        terms[CURVATURE + ab] += own * turning + 0.5 * weight * sp_dot(lower(element, i, SP_METRIC_T11 + ab), velocity);
    }
}

/* Takes Gamma^c_ab grad_c from the Hessian: the second derivative of the energy along geodesics of the metric. With w the gradient, indices
 * raised, and W = w^c B_c, that is S_ab'T W + (B_b'T_a W + B_a'T_b W - B_a'(w^c T_c) B_b)/2. Not where a node moves straight. */
static void make_covariant(int32_t components, struct sp_form form, const sp_pair *chart, const sp_pair *metric, sp_mask straight,
                           struct sp_row *row) {
    sp_pair reciprocal = sp_select(straight, sp_splat(0.0), 1.0 / (form.e * form.g - form.f * form.f)), along[3],
            turned[SP_METRIC_COMPONENTS];
    sp_pair w1 = reciprocal * (form.g * row->r1 - form.f * row->r2), w2 = reciprocal * (form.e * row->r2 - form.f * row->r1);
    for (int k = 0; k < 3; k++)
        along[k] = w1 * chart[SP_CHART_1 + k] + w2 * chart[SP_CHART_2 + k];
    for (int32_t c = 0; c < components; c++)
        turned[c] = w1 * metric[components + c] + w2 * metric[2 * components + c];
    sp_pair *block[3] = {&row->a, &row->b, &row->d};
    for (int32_t ab = 0; ab < 3; ab++) {
        int32_t a = ab / 2, b = (ab + 1) / 2;
        const sp_pair *b_a = chart + SP_CHART_1 + 3 * a, *b_b = chart + SP_CHART_1 + 3 * b;
        sp_pair turning = product(components, metric + components * (SP_METRIC_T1 + a), b_b, along) +
                          product(components, metric + components * (SP_METRIC_T1 + b), b_a, along) - product(components, turned, b_a, b_b);
        *block[ab] += product(components, metric, chart + SP_CHART_11 + 3 * ab, along) + 0.5 * turning;
    }
}

/* Diagonal block, M and right-hand side of pair k from its terms; adds the coordinates of it that are held. Returns whether T is positive
 * definite there. */
static int assemble_node(const struct sp_polyline *line, int32_t k, const sp_pair *terms, double weight, struct sp_row *row,
                         sp_mask *straight, sp_mask held[2], int32_t *count) {
    int32_t components = line->kind->components, active = 0;
    const sp_pair *chart = line->nodes.charts + SP_CHART * k, *metric = line->nodes.metrics + SP_METRIC_PARTS * components * k;
    struct sp_form mass = form_of(components, chart, terms + MASS), form = form_of(components, chart, metric);
    row->weight = sp_splat(weight);
    row->e = mass.e / weight, row->f = mass.f / weight, row->g = mass.g / weight;
    row->r1 = -terms[FORCE], row->r2 = -terms[FORCE + 1];
    row->a = mass.e + terms[CURVATURE], row->b = mass.f + terms[CURVATURE + 1], row->d = mass.g + terms[CURVATURE + 2];
    held[0] = held[1] = (sp_mask){0, 0};
    if (line->touches) active = sp_row_find_held(line->surface, line->nodes.places + 2 * k, row, held);
    *straight |= held[0] | held[1];
    make_covariant(components, form, chart, metric, *straight, row);
    if (active) sp_row_hold(row, held);
    *count += active;
    return !sp_any(~sp_form_positive(form));
}

/* B_i' (sum_q weight_q D_qi D_qj T_q) B_j + weight_i D_ij (T_a V)_i . B_j + weight_j D_ji B_i . (T_b V)_j */
static void couple(const struct sp_metric_element *element, int32_t i, int32_t j, sp_pair block[4]) {
    const struct sp_reference *reference = element->reference;
    int32_t size = reference->degree + 1, components = element->components;
    sp_pair mean[SP_METRIC_COMPONENTS];
    for (int32_t c = 0; c < components; c += 3) { /* three sums in registers; of a density's the first is used */
        sp_pair x = sp_splat(0.0), y = x, z = x;
        for (int32_t q = 0; q < size; q++) {
            double factor = reference->weight[q] * reference->derivative[q * size + i] * reference->derivative[q * size + j];
            const sp_pair *metric = metric_at(element, q, SP_METRIC_T) + c;
            x += factor * metric[0];
            y += factor * metric[1];
            z += factor * metric[2];
        }
        mean[c] = x, mean[c + 1] = y, mean[c + 2] = z;
    }
    double ij = reference->weight[i] * reference->derivative[i * size + j], ji = reference->weight[j] * reference->derivative[j * size + i];
    for (int32_t k = 0; k < 4; k++) {
        int32_t a = k / 2, b = k % 2;
        const sp_pair *here = element->charts + SP_CHART * i + SP_CHART_1 + 3 * a,
                      *there = element->charts + SP_CHART * j + SP_CHART_1 + 3 * b;
        sp_pair value = product(components, mean, here, there) + ij * sp_dot(element->pull[a][i], sp_load(there)) +
                        ji * sp_dot(element->pull[b][j], sp_load(here));
        block[k] = element->factor * value;
    }
}

void sp_metric_couple(const struct sp_metric_element *element, int32_t i, int32_t j, const sp_mask *held, sp_pair block[4]) {
    couple(element, i, j, block);
    for (int32_t k = 0; k < 4; k++)
        block[k] = sp_select(held[2 * i + k / 2] | held[2 * j + k % 2], sp_splat(0.0), block[k]);
}

/* Nothing is held at the ends; where the path is folded the masks are mirrored like everything else. */
static void complete_held(struct sp_fold fold, sp_mask *held) {
    held[0] = held[1] = (sp_mask){0, 0};
    for (int j = 0; j < 2 && !sp_fold_odd(fold); j++)
        held[2 * (sp_fold_both(fold) + 1) + j] = sp_swap_mask(held[2 * sp_fold_both(fold) + j]);
}

struct sp_energy sp_metric_assemble(const struct sp_elements *elements, const struct sp_polyline *line, enum sp_hessian hessian,
                                    struct sp_row *rows, sp_mask *straight, sp_mask *held) {
    const struct sp_reference *reference = &elements->reference;
    int32_t p = reference->degree, pairs = pairs_of(reference, line), unknown = sp_fold_unknown(line->fold), positive = 1;
    struct sp_energy energy = {0};
    struct sp_metric_element element;
    sp_pair terms[TERMS] = {{0}}, squares = sp_splat(0.0);
    for (int32_t e = 0; e < pairs; e++) {
        sp_pair once = {1, 2 * e + 1 < count_of(reference, line)};
        sp_metric_open(elements, line, e, &element);
        for (int32_t q = 0; q <= p; q++)
            squares += element.factor * (reference->weight[q] * once) * sp_dot(element.momentum[q], element.velocity[q]);
        for (int32_t i = 0; i <= p; i++) {
            int32_t k = e * p + i, shared = i == p && e < pairs - 1;
            for (int j = 0; j < TERMS && i > 0; j++)
                terms[j] = sp_splat(0.0);
            add_terms(&element, i, terms);
            if (k == 0 || shared || k > unknown) continue;
            for (int j = 0; j < TERMS && i == p; j++)
                terms[j] += sp_swap(terms[j]);
            straight[k] = hessian == SP_COORDINATE ? (sp_mask){-1, -1} : (sp_mask){0, 0};
            double weight = (i == 0 || i == p ? 2 : 1) * reference->stiffness[i * (p + 1) + i];
            positive &= assemble_node(line, k, terms, weight, rows + k, straight + k, held + 2 * k, &energy.active);
        }
        if (p > 1 || e == 0) continue;
        sp_pair block[4];
        couple(&element, 0, 1, block);
        rows[e].q11 = -block[0], rows[e].q12 = -block[1], rows[e].q21 = -block[2], rows[e].q22 = -block[3];
    }
    complete_held(line->fold, held);
    for (int32_t k = 1; k <= sp_fold_both(line->fold) && p == 1 && energy.active; k++)
        sp_row_hold_coupling(rows + k, held + 2 * k, held + 2 * (k + 1));
    energy.squares = positive ? squares[0] + squares[1] : not_a_number();
    energy.gradient_squared = sp_rows_gradient_squared(line->fold, rows);
    return energy;
}

void sp_metric_end_pull(const struct sp_elements *elements, const struct sp_polyline *line, sp_pair pull[2]) {
    struct sp_metric_element element;
    sp_pair terms[TERMS] = {{0}};
    sp_metric_open(elements, line, 0, &element);
    add_terms(&element, 0, terms);
    pull[0] = terms[FORCE], pull[1] = terms[FORCE + 1];
}
