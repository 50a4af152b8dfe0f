/* The reference element, the elements' gradient and Hessian against finite differences, their condensed solve against dense algebra, and
 * the ladder. */
#include "elements.h"
#include "newton.h"
#include "refine_spread.h"
#include "sample.h"
#include "surfaces.h"
#include "surfpath.h"
#include "testing.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static struct sp_arena arena;

static void check_reference(int32_t degree) {
    struct sp_reference reference;
    arena.used = 0;
    CHECK(sp_reference_make(&reference, degree, &arena), "arena");
    for (int32_t power = 0; power <= 2 * degree - 1; power++) {
        double sum = 0;
        for (int32_t i = 0; i <= degree; i++)
            sum += reference.weight[i] * pow(reference.node[i], power);
        CHECK(fabs(sum * (power + 1) - 1) <= 1e-14, "degree %d: integral of t^%d is off by %g", degree, power, sum * (power + 1) - 1);
    }
    double values[SP_MAX_DEGREE + 1], at = 0.3217, interpolated = 0;
    sp_reference_interpolate(&reference, at, values);
    for (int32_t i = 0; i <= degree; i++) {
        double slope = 0;
        for (int32_t j = 0; j <= degree; j++)
            slope += reference.derivative[i * (degree + 1) + j] * pow(reference.node[j], degree);
        CHECK(fabs(slope - degree * pow(reference.node[i], degree - 1)) <= 1e-12 * degree * degree, "degree %d: slope at node %d", degree,
              i);
        interpolated += values[i] * pow(reference.node[i], degree);
    }
    CHECK(fabs(interpolated - pow(at, degree)) <= 1e-14, "degree %d: interpolation", degree);
}

/* A random path of `count` elements of a degree, evenly long or growing_elements, and room for one step. */
static struct sp_newton random_elements(const struct sp_surface *surface, int32_t degree, int32_t count, uint64_t *seed) {
    struct sp_newton newton = {0};
    struct sp_options options = {.point_count = 1, .max_iterations = 10};
    struct sp_elements *elements = &newton.system.elements;
    size_t order = (size_t)sp_elements_order(degree);
    int32_t last = degree * count;
    arena.used = 0;
    CHECK(sp_newton_take(&newton, surface, &options, last - 1, &arena) && sp_reference_make(&elements->reference, degree, &arena), "arena");
    elements->count = count;
    elements->spread = count > 2 ? growing_elements() : NULL;
    elements->matrices = sp_arena_take(&arena, order * order * (size_t)count / 2, sizeof(sp_pair));
    elements->velocity = sp_arena_take(&arena, 3 * ((size_t)degree + 1), sizeof(sp_pair));
    elements->skeleton = sp_arena_take(&arena, (size_t)count / 2 + 1, sizeof(struct sp_row));
    struct sp_polyline *line = &newton.system.line;
    int dimension = line->kind->dimension;
    double wave[3][2];
    for (int j = 0; j < 3; j++)
        wave[j][0] = random_unit(seed) - 0.5, wave[j][1] = 3 * random_unit(seed);
    for (int32_t i = 0; i <= last; i++)
        for (int j = 0; j < dimension; j++) {
            double t = sp_sample_parameter(elements, i);
            double value =
                wave[j][0] * (1 - t) + 0.9 * t * sin(wave[j][1] * t) + 0.02 * random_unit(seed) + (dimension == 3 && j == 0 ? 2.5 : 0);
            line->nodes.places[dimension * sp_fold_pair(line->fold, i) + j][sp_fold_lane(line->fold, i)] = value;
        }
    sp_pair *middle = line->nodes.places + dimension * (sp_fold_both(line->fold) + 1);
    for (int j = 0; j < dimension; j++)
        middle[j] = sp_splat(middle[j][0]);
    if (surface->kind == SP_IMPLICIT) sp_implicit_settle(surface, sp_fold_unknown(line->fold) + 1, line->nodes.places, 1);
    sp_polyline_charts(line, &line->nodes);
    return newton;
}

static double energy_along(struct sp_newton *newton, const sp_pair *step, double t) {
    struct sp_polyline *line = &newton->system.line;
    int32_t dimension = line->kind->dimension;
    memcpy(newton->trial.places, line->nodes.places, sizeof(sp_pair) * (size_t)dimension);
    line->kind->move(line->surface, sp_fold_unknown(line->fold), line->nodes.places + dimension, line->nodes.charts + SP_CHART, step + 2,
                     newton->system.straight + 1, t, newton->trial.places + dimension);
    sp_polyline_charts(line, &newton->trial);
    return 0.5 * sp_system_squares(&newton->system, &newton->trial, NULL);
}

/* Entry of the scaled Hessian between unknowns a of node i and b of node j, written down from the formula and not as the solver does. */
static double hessian_entry(const struct sp_newton *newton, int32_t i, int a, int32_t j, int b) {
    const struct sp_elements *elements = &newton->system.elements;
    struct sp_fold fold = newton->system.line.fold;
    int32_t p = elements->reference.degree;
    const struct sp_row *row = newton->system.rows + sp_fold_pair(fold, i);
    int lane = sp_fold_lane(fold, i);
    if (i == j) return a == b ? (a ? row->d : row->a)[lane] : row->b[lane];
    double sum = 0, product = 0;
    for (int32_t e = 0; e < elements->count; e++)
        if (i >= e * p && i <= (e + 1) * p && j >= e * p && j <= (e + 1) * p)
            sum += elements->reference.stiffness[(i - e * p) * (p + 1) + j - e * p] /
                   (elements->count * (sp_elements_border(elements, e + 1) - sp_elements_border(elements, e)));
    for (int32_t k = 0; k < 3; k++)
        product += sp_fold_get(fold, newton->system.line.nodes.charts, SP_CHART, i, (a ? SP_CHART_2 : SP_CHART_1) + k) *
                   sp_fold_get(fold, newton->system.line.nodes.charts, SP_CHART, j, (b ? SP_CHART_2 : SP_CHART_1) + k);
    return sum * product;
}

/* Negative eigenvalues of a dense symmetric matrix, by LDL' (generic, so no pivoting), which it destroys. */
static int dense_negative(int32_t size, double *matrix) {
    int negative = 0;
    for (int32_t k = 0; k < size; k++) {
        negative += matrix[k * size + k] < 0;
        for (int32_t i = k + 1; i < size; i++) {
            double factor = matrix[i * size + k] / matrix[k * size + k];
            for (int32_t j = k; j < size; j++)
                matrix[i * size + j] -= factor * matrix[k * size + j];
        }
    }
    return negative;
}

static void check_elements(const struct sp_surface *surface, enum sp_hessian hessian, int32_t degree, int32_t count, uint64_t *seed) {
    struct sp_newton newton = random_elements(surface, degree, count, seed);
    struct sp_fold fold = newton.system.line.fold;
    int32_t size = 2 * fold.inner;
    double *matrix = malloc(sizeof(double) * (size_t)(size * size)), linear = 0, second = 0, difference[2][2];
    sp_system_assemble(&newton.system, hessian);
    sp_pair *x = newton.step;
    for (int32_t k = 0; k < 2 * sp_fold_pairs(fold); k++)
        x[k] = (sp_pair){random_unit(seed) - 0.5, random_unit(seed) - 0.5};
    x[0] = x[1] = sp_splat(0.0);
    for (int j = 0; j < 2; j++)
        x[2 * (sp_fold_both(fold) + 1) + j] = sp_splat(x[2 * (sp_fold_both(fold) + 1) + j][0]);
    for (int32_t i = 0; i < size; i++)
        for (int32_t j = 0; j < size; j++) {
            matrix[i * size + j] = hessian_entry(&newton, 1 + i / 2, i % 2, 1 + j / 2, j % 2);
            second += matrix[i * size + j] * sp_fold_get(fold, x, 2, 1 + i / 2, i % 2) * sp_fold_get(fold, x, 2, 1 + j / 2, j % 2);
        }
    for (int32_t k = 1; k <= sp_fold_unknown(fold); k++)
        linear += sp_fold_sum(fold, k, newton.system.rows[k].r1 * x[2 * k] + newton.system.rows[k].r2 * x[2 * k + 1]);
    for (int i = 0; i < 2; i++) {
        double t = 4e-4 / (1 << i), ahead = energy_along(&newton, x, t), behind = energy_along(&newton, x, -t),
               here = energy_along(&newton, x, 0);
        difference[0][i] = (ahead - behind) / (2 * t), difference[1][i] = (ahead - 2 * here + behind) / (t * t);
    }
    double slope = (4 * difference[0][1] - difference[0][0]) / 3, curvature = (4 * difference[1][1] - difference[1][0]) / 3;
    CHECK(fabs(slope + linear) <= 1e-7 * (1 + fabs(linear)), "p = %d, m = %d: slope %.12g, difference %.12g", degree, count, -linear,
          slope);
    CHECK(fabs(curvature - second) <= 1e-5 * (1 + fabs(second)), "p = %d, m = %d: curvature %.12g, difference %.12g", degree, count, second,
          curvature);
    struct sp_inertia inertia = sp_system_factor(&newton.system, 0);
    sp_system_solve(&newton.system, x);
    double worst = 0, largest = 0;
    for (int32_t i = 0; i < size; i++) {
        double sum = -(i % 2 ? newton.system.rows[sp_fold_pair(fold, 1 + i / 2)].r2
                             : newton.system.rows[sp_fold_pair(fold, 1 + i / 2)].r1)[sp_fold_lane(fold, 1 + i / 2)];
        largest = fmax(largest, fabs(sum));
        for (int32_t j = 0; j < size; j++)
            sum += matrix[i * size + j] * sp_fold_get(fold, x, 2, 1 + j / 2, j % 2);
        worst = fmax(worst, fabs(sum));
    }
    double descent = 0;
    for (int32_t k = 1; k <= sp_fold_unknown(fold); k++)
        descent += sp_fold_sum(fold, k, newton.system.rows[k].r1 * x[2 * k] + newton.system.rows[k].r2 * x[2 * k + 1]);
    CHECK(fabs(inertia.descent - descent) <= 1e-9 * fabs(descent), "p = %d, m = %d: descent %g, not %g", degree, count, inertia.descent,
          descent);
    CHECK(worst <= 1e-8 * largest, "p = %d, m = %d: residual %g of %g", degree, count, worst, largest);
    int negative = dense_negative(size, matrix);
    CHECK(inertia.usable && inertia.negative == negative, "p = %d, m = %d: %d negative, dense %d", degree, count, inertia.negative,
          negative);
    if (negative) {
        CHECK(sp_system_negative(&newton.system, x), "no direction");
        double value = 0;
        for (int32_t i = 0; i < size; i++)
            for (int32_t j = 0; j < size; j++)
                value += hessian_entry(&newton, 1 + i / 2, i % 2, 1 + j / 2, j % 2) * sp_fold_get(fold, x, 2, 1 + i / 2, i % 2) *
                         sp_fold_get(fold, x, 2, 1 + j / 2, j % 2);
        CHECK(value < 0, "p = %d, m = %d: curvature %g along the direction", degree, count, value);
    }
    free(matrix);
}

/* The last two Legendre coefficients, squared and added up, of an element's positions: from all of them, by Gauss's elimination. */
static double legendre_tail(const struct sp_system *system, int32_t e) {
    const struct sp_reference *reference = &system->elements.reference;
    int32_t p = reference->degree, size = p + 1;
    double matrix[13][16], sum = 0;
    for (int32_t j = 0; j < size; j++) {
        double t = 2 * reference->node[j] - 1;
        matrix[j][0] = 1, matrix[j][1] = t;
        for (int32_t k = 1; k < p; k++)
            matrix[j][k + 1] = ((2 * k + 1) * t * matrix[j][k] - k * matrix[j][k - 1]) / (k + 1);
        for (int32_t c = 0; c < 3; c++)
            matrix[j][size + c] = sp_fold_get(system->line.fold, system->line.nodes.charts, SP_CHART, e * p + j, SP_CHART_X + c);
    }
    for (int32_t k = 0; k < size; k++) {
        int32_t pivot = k;
        for (int32_t i = k + 1; i < size; i++)
            if (fabs(matrix[i][k]) > fabs(matrix[pivot][k])) pivot = i;
        for (int32_t j = k; j < size + 3; j++) {
            double kept = matrix[k][j];
            matrix[k][j] = matrix[pivot][j], matrix[pivot][j] = kept;
        }
        for (int32_t i = 0; i < size; i++) {
            double factor = i == k ? 0 : matrix[i][k] / matrix[k][k];
            for (int32_t j = k; j < size + 3; j++)
                matrix[i][j] -= factor * matrix[k][j];
        }
    }
    for (int32_t c = 0; c < 3; c++)
        for (int32_t k = p - 1; k <= p; k++)
            sum += matrix[k][size + c] * matrix[k][size + c] / (matrix[k][k] * matrix[k][k]);
    return sum;
}

/* What elements leave over is what they are spread by: each 64th has the same part of it, but for the millionth of their widths that stays
 * even, which an element of a hundredth of the width counts a hundred times. */
static void check_spread(const struct sp_surface *surface, int32_t degree, int32_t count, uint64_t *seed) {
    struct sp_newton newton = random_elements(surface, degree, count, seed);
    double spread[SP_SPREAD + 1], total = 0;
    CHECK(sp_spread_elements(&newton.system, newton.step, spread), "p = %d, m = %d: even", degree, count);
    for (int32_t e = 0; e < count; e++) {
        double tail = legendre_tail(&newton.system, e), measured = pow(newton.step[e][0], 16);
        CHECK(fabs(measured / tail - 1) < 1e-9, "p = %d, element %d of %d leaves %g over, not %g", degree, e, count, tail, measured);
        total += newton.step[e][0];
    }
    for (int k = 0; k <= SP_SPREAD; k++) {
        double passed = 0, from = 0;
        for (int32_t e = 0; e < count; e++) {
            double to = newton.step[e][1], part = (spread[k] - from) / (to - from);
            passed += newton.step[e][0] * (part > 1 ? 1 : part > 0 ? part : 0), from = to;
        }
        CHECK(fabs(passed / total - (double)k / SP_SPREAD) < 1e-4, "p = %d, m = %d: %g of the whole before %d/64", degree, count,
              passed / total, k);
    }
}

/* Lengths to the tolerance asked for, and never an error estimate below the true error. */
static void check_ladder(const struct sp_surface *surface, struct sp_request request, double truth) {
    for (double tolerance = 1e-3; tolerance > 1e-13; tolerance *= 0.1) {
        struct sp_options options;
        struct sp_result result;
        sp_default_options(&options);
        options.tolerance = tolerance;
        sp_solve_path(surface, &request, &options, &arena, &result);
        double error = fabs(result.length - truth);
        CHECK(result.status == SP_CONVERGED && result.index == 0, "tolerance %g: status %d, index %d", tolerance, result.status,
              result.index);
        CHECK(error <= tolerance * truth && error <= result.length_error, "tolerance %g: error %g, said %g", tolerance, error,
              result.length_error);
    }
}

int main(void) {
    arena = (struct sp_arena){aligned_alloc(16, 1 << 24), 1 << 24, 0};
    uint64_t seed = 4711;
    int32_t degrees[] = {2, 3, 6, 8, 12};
    for (int32_t degree = 1; degree <= SP_MAX_DEGREE; degree++)
        check_reference(degree);
    const struct sp_surface *surfaces[] = {&saddle_surface, &bumpy_surface, &globe_surface, &torus_surface, &sphere_surface};
    for (int s = 0; s < 5; s++)
        for (int d = 0; d < 5; d++)
            for (int32_t count = 2; count <= 6; count += 2) {
                check_elements(surfaces[s], SP_COVARIANT, degrees[d], count, &seed);
                if (surfaces[s]->kind == SP_PARAMETRIC) check_elements(surfaces[s], SP_COORDINATE, degrees[d], count, &seed);
            }
    for (int s = 0; s < 5; s++)
        for (int d = 1; d < 5; d++)
            check_spread(surfaces[s], degrees[d], 6, &seed);
    check_ladder(&globe_surface, (struct sp_request){.from = {0.1, -0.7, 0}, .to = {1.4, 0.9, 0}},
                 acos(sin(-0.7) * sin(0.9) + cos(-0.7) * cos(0.9) * cos(1.3)));
    check_ladder(&sphere_surface, (struct sp_request){.from = {1, 0, 0}, .to = {0, 0.6, 0.8}}, acos(0.0));
    free(arena.base);
    return checks_failed();
}
