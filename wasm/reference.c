/* Gauss–Lobatto–Legendre nodes by Newton on (1 - x^2) P'_p, and what follows from them. MATH.md, "Elements". */
#include "reference.h"
#include "functions.h"

static const double PI = 3.14159265358979323846;

/* P_p(x), and P_(p-1)(x), by the three-term recurrence. */
static double legendre(int32_t degree, double x, double *before) {
    double now = x, last = 1;
    for (int32_t k = 2; k <= degree; k++) {
        double next = ((2 * k - 1) * x * now - (k - 1) * last) / k;
        last = now, now = next;
    }
    *before = last;
    return now;
}

/* Node i of -1 … 1: the Chebyshev–Lobatto point, then Newton; P'_p (1 - x^2) = p (P_(p-1) - x P_p). */
static double lobatto(int32_t degree, int32_t i) {
    if (i == 0) return -1;
    if (2 * i == degree) return 0;
    double x = -sp_cos(sp_splat(PI * i / degree))[0], before;
    for (int round = 0; round < 12; round++) {
        double value = legendre(degree, x, &before), step = (x * value - before) / ((degree + 1) * value);
        x -= step;
        if (step * step < 1e-31) break;
    }
    return x;
}

static void fill_nodes(struct sp_reference *reference) {
    int32_t p = reference->degree;
    for (int32_t i = 0; 2 * i <= p; i++) {
        double x = lobatto(p, i), before, value = legendre(p, x, &before), weight = 1 / (p * (p + 1) * value * value);
        reference->node[i] = 0.5 * (1 + x), reference->node[p - i] = 0.5 * (1 - x);
        reference->weight[i] = reference->weight[p - i] = weight;
        reference->barycentric[i] = 1 / value, reference->barycentric[p - i] = (p % 2 ? -1 : 1) / value;
    }
}

/* D_ij = b_j/(b_i (t_i - t_j)), rows adding up to 0. */
static void fill_derivative(struct sp_reference *reference) {
    int32_t p = reference->degree;
    for (int32_t i = 0; i <= p; i++) {
        double *row = reference->derivative + i * (p + 1), sum = 0;
        for (int32_t j = 0; j <= p; j++) {
            if (j == i) continue;
            row[j] = reference->barycentric[j] / (reference->barycentric[i] * (reference->node[i] - reference->node[j]));
            sum += row[j];
        }
        row[i] = -sum;
    }
}

/* K_ij = 2 b_i b_j/(p (p + 1) (t_i - t_j)^2), b = 1/P_p: by parts, since the rule is exact for l_i l_j''. */
static void fill_stiffness(struct sp_reference *reference) {
    int32_t p = reference->degree, size = p + 1;
    for (int32_t i = 0; i <= p; i++) {
        double sum = 0;
        for (int32_t j = 0; j <= p; j++) {
            double away = reference->node[i] - reference->node[j], product = reference->barycentric[i] * reference->barycentric[j];
            if (j != i) sum += reference->stiffness[i * size + j] = 2 * product / (p * size * away * away);
        }
        reference->stiffness[i * size + i] = -sum;
    }
}

double sp_reference_bytes(int32_t degree) {
    double size = degree + 1.0;
    return (3 * size + 2 * size * size) * sizeof(double) + 5 * 16;
}

int sp_reference_make(struct sp_reference *reference, int32_t degree, struct sp_arena *arena) {
    size_t size = (size_t)degree + 1;
    double **vectors[] = {&reference->node, &reference->weight, &reference->barycentric, &reference->derivative, &reference->stiffness};
    reference->degree = degree;
    for (int i = 0; i < 5; i++) {
        *vectors[i] = sp_arena_take(arena, i < 3 ? size : size * size, sizeof(double));
        if (!*vectors[i]) return 0;
    }
    fill_nodes(reference);
    fill_derivative(reference);
    fill_stiffness(reference);
    return 1;
}

void sp_reference_interpolate(const struct sp_reference *reference, double t, double values[SP_MAX_DEGREE + 1]) {
    int32_t p = reference->degree;
    double sum = 0;
    for (int32_t j = 0; j <= p; j++) {
        double away = t - reference->node[j];
        if (away == 0) {
            for (int32_t k = 0; k <= p; k++)
                values[k] = k == j;
            return;
        }
        values[j] = reference->barycentric[j] / away;
        sum += values[j];
    }
    double scale = 1 / sum;
    for (int32_t j = 0; j <= p; j++)
        values[j] *= scale;
}

/* Node i of the n-point Gauss rule on 0 … 1, and its weight: Newton on P_n from Chebyshev's guess. */
static double gauss(int32_t n, int32_t i, double *weight) {
    double x = -sp_cos(sp_splat(PI * (i + 0.75) / (n + 0.5)))[0], before, slope = 1;
    for (int round = 0; round < 12; round++) {
        double value = legendre(n, x, &before);
        slope = n * (before - x * value) / (1 - x * x);
        x -= value / slope;
        if (value * value < 1e-31 * slope * slope) break;
    }
    legendre(n, x, &before);
    slope = n * before / (1 - x * x);
    *weight = 1 / ((1 - x * x) * slope * slope);
    return 0.5 * (1 + x);
}

/* Derivatives at t of the p + 1 Lagrange polynomials: l_j' = sum_i l_i(t) D_ij. */
static void differentiate_at(const struct sp_reference *reference, double t, double *row) {
    int32_t size = reference->degree + 1;
    double values[SP_MAX_DEGREE + 1];
    sp_reference_interpolate(reference, t, values);
    for (int32_t j = 0; j < size; j++) {
        row[j] = 0;
        for (int32_t i = 0; i < size; i++)
            row[j] += values[i] * reference->derivative[i * size + j];
    }
}

static void fill_graded_stiffness(const struct sp_graded *graded, int32_t size, int lane) {
    for (int32_t i = 0; i < size; i++) {
        double sum = 0;
        for (int32_t j = 0; j < size; j++) {
            double entry = 0;
            for (int32_t q = 0; q < graded->count; q++)
                entry += graded->weight[lane][q] * graded->derivative[q * size + i] * graded->derivative[q * size + j];
            graded->stiffness[lane][i * size + j] = entry;
            sum += j == i ? 0 : entry;
        }
        graded->stiffness[lane][i * size + i] = -sum;
    }
}

int sp_graded_make(struct sp_graded *graded, const struct sp_reference *reference, const int32_t ends[2], struct sp_arena *arena) {
    size_t size = (size_t)reference->degree + 1, count = size + 1;
    double **vectors[] = {&graded->derivative, &graded->length_weight, &graded->weight[0],
                          &graded->weight[1],  &graded->stiffness[0],  &graded->stiffness[1]};
    size_t lengths[] = {count * size, count, count, count, size * size, size * size};
    graded->count = reference->degree + 2;
    for (int i = 0; i < 6; i++) {
        *vectors[i] = sp_arena_take(arena, lengths[i], sizeof(double));
        if (!*vectors[i]) return 0;
    }
    for (int32_t q = 0; q < graded->count; q++) {
        double sigma = gauss(graded->count, q, graded->length_weight + q);
        differentiate_at(reference, sigma, graded->derivative + q * (reference->degree + 1));
        for (int lane = 0; lane < 2; lane++)
            graded->weight[lane][q] = graded->length_weight[q] / (ends[lane] ? 2 * sigma : 1);
    }
    for (int lane = 0; lane < 2; lane++)
        fill_graded_stiffness(graded, reference->degree + 1, lane);
    return 1;
}
