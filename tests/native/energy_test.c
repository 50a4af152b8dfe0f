/* Gradient and Hessian of the discrete energy against finite differences of the energy itself, and the folded block solve against dense
 * algebra. */
#include "energy.h"
#include "newton.h"
#include "surfaces.h"
#include "testing.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LARGEST = 12 };

/* A random path of n inner nodes on a surface, in memory of its own. */
static struct sp_newton random_path(const struct sp_surface *surface, int32_t inner, struct sp_arena *arena, uint64_t *seed) {
    struct sp_newton newton = {0};
    struct sp_options options = {.algorithm = SP_POLYLINE, .point_count = inner, .max_iterations = 10};
    arena->used = 0;
    CHECK(sp_newton_take(&newton, surface, &options, inner, arena), "arena");
    int dimension = newton.system.line.kind->dimension;
    for (int32_t i = 0; i <= inner + 1; i++)
        for (int j = 0; j < dimension; j++) {
            double value = 0.9 * (2 * random_unit(seed) - 1) + (surface->kind == SP_IMPLICIT && j == 0 ? 2.5 : 0);
            newton.system.line.nodes
                .places[dimension * sp_fold_pair(newton.system.line.fold, i) + j][sp_fold_lane(newton.system.line.fold, i)] = value;
        }
    sp_pair *middle = newton.system.line.nodes.places + dimension * (sp_fold_both(newton.system.line.fold) + 1);
    for (int j = 0; j < dimension && sp_fold_odd(newton.system.line.fold); j++)
        middle[j] = sp_splat(middle[j][0]);
    if (surface->kind == SP_IMPLICIT)
        sp_implicit_settle(surface, sp_fold_unknown(newton.system.line.fold) + 1, newton.system.line.nodes.places, 1);
    sp_fold_mirror(newton.system.line.fold, newton.system.line.nodes.places, dimension);
    sp_polyline_charts(&newton.system.line, &newton.system.line.nodes);
    return newton;
}

/* Half the sum of squares after moving along `step` by t: curved steps are geodesics to second order, so this is E along them. */
static double energy_along(struct sp_newton *newton, const sp_pair *step, double t) {
    struct sp_polyline *line = &newton->system.line;
    int32_t unknown = sp_fold_unknown(line->fold), dimension = line->kind->dimension;
    memcpy(newton->trial.places, line->nodes.places, sizeof(sp_pair) * (size_t)dimension);
    line->kind->move(line->surface, unknown, line->nodes.places + dimension, line->nodes.charts + SP_CHART, step + 2,
                     newton->system.straight + 1, t, newton->trial.places + dimension);
    sp_fold_mirror(line->fold, newton->trial.places, dimension);
    sp_polyline_charts(line, &newton->trial);
    return 0.5 * sp_polyline_squares(line->fold, newton->trial.charts, NULL);
}

/* x'Hx and r'x as the rows say. */
static double quadratic(const struct sp_newton *newton, const sp_pair *x, double *linear) {
    struct sp_fold fold = newton->system.line.fold;
    double sum = 0;
    *linear = 0;
    for (int32_t k = 1; k <= sp_fold_unknown(fold); k++) {
        const struct sp_row *row = newton->system.rows + k;
        sp_pair u = x[2 * k], v = x[2 * k + 1], nu = x[2 * k + 2], nv = x[2 * k + 3];
        sum += sp_fold_sum(fold, k, row->a * u * u + 2.0 * row->b * u * v + row->d * v * v);
        *linear += sp_fold_sum(fold, k, row->r1 * u + row->r2 * v);
        if (k > sp_fold_both(fold)) continue;
        sp_pair coupling = u * (row->q11 * nu + row->q12 * nv) + v * (row->q21 * nu + row->q22 * nv);
        sum -= (k == sp_fold_both(fold) && !sp_fold_odd(fold) ? 1.0 : 2.0) * (coupling[0] + coupling[1]);
    }
    return sum;
}

/* Random direction, the middle pair as the fold wants it. */
static void random_step(struct sp_fold fold, sp_pair *x, uint64_t *seed) {
    for (int32_t k = 0; k < 2 * sp_fold_pairs(fold); k++)
        x[k] = (sp_pair){random_unit(seed) - 0.5, random_unit(seed) - 0.5};
    x[0] = x[1] = sp_splat(0.0);
    for (int j = 0; j < 2 && sp_fold_odd(fold); j++)
        x[2 * (sp_fold_both(fold) + 1) + j] = sp_splat(x[2 * (sp_fold_both(fold) + 1) + j][0]);
    sp_fold_mirror(fold, x, 2);
}

/* E(t) = E - r.x t + x'Hx t^2/2 + O(t^3): the first two coefficients by central differences, Richardson-extrapolated. */
static void check_derivatives(const struct sp_surface *surface, enum sp_hessian hessian, int32_t inner, struct sp_arena *arena,
                              uint64_t *seed) {
    struct sp_newton newton = random_path(surface, inner, arena, seed);
    struct sp_energy energy = sp_polyline_assemble(&newton.system.line, hessian, newton.system.rows, newton.system.straight);
    double gradient, squares = sp_polyline_squares(newton.system.line.fold, newton.system.line.nodes.charts, &gradient);
    CHECK(squares == energy.squares, "n = %d: squares %.17g, in the sweep %.17g", inner, energy.squares, squares);
    CHECK(fabs(gradient - energy.gradient_squared) <= 1e-14 * gradient, "n = %d: gradient %.17g, in the sweep %.17g", inner,
          energy.gradient_squared, gradient);
    sp_pair x[2 * (LARGEST + 2)];
    random_step(newton.system.line.fold, x, seed);
    double linear, second = quadratic(&newton, x, &linear), h = surface->kind == SP_IMPLICIT ? 4e-3 : 2e-3, first_difference[2],
                   second_difference[2];
    for (int i = 0; i < 2; i++) {
        double t = h / (1 << i), ahead = energy_along(&newton, x, t), behind = energy_along(&newton, x, -t),
               here = energy_along(&newton, x, 0);
        first_difference[i] = (ahead - behind) / (2 * t), second_difference[i] = (ahead - 2 * here + behind) / (t * t);
    }
    double slope = (4 * first_difference[1] - first_difference[0]) / 3, curvature = (4 * second_difference[1] - second_difference[0]) / 3;
    CHECK(fabs(slope + linear) <= 1e-8 * (1 + fabs(linear)), "n = %d: slope %.12g, difference %.12g", inner, -linear, slope);
    CHECK(fabs(curvature - second) <= 2e-7 * (1 + fabs(second)), "n = %d: curvature %.12g, difference %.12g", inner, second, curvature);
}

/* The dense matrix that the folded rows stand for, unknowns in the order of the path. */
static void unfold(const struct sp_newton *newton, int32_t inner, double *matrix, double *right) {
    struct sp_fold fold = newton->system.line.fold;
    int32_t size = 2 * inner;
    memset(matrix, 0, sizeof(double) * (size_t)(size * size));
    for (int32_t i = 1; i <= inner; i++) {
        int32_t k = sp_fold_pair(fold, i), at = 2 * (i - 1);
        int lane = sp_fold_lane(fold, i);
        const struct sp_row *row = newton->system.rows + k;
        matrix[at * size + at] = row->a[lane], matrix[(at + 1) * size + at + 1] = row->d[lane];
        matrix[at * size + at + 1] = matrix[(at + 1) * size + at] = row->b[lane];
        right[at] = row->r1[lane], right[at + 1] = row->r2[lane];
        if (k > sp_fold_both(fold)) continue;
        int32_t next = lane ? at - 2 : at + 2;
        double q[4] = {row->q11[lane], row->q12[lane], row->q21[lane], row->q22[lane]};
        for (int j = 0; j < 4; j++)
            matrix[(at + j / 2) * size + next + j % 2] = matrix[(next + j % 2) * size + at + j / 2] = -q[j];
    }
}

/* Gaussian elimination with partial pivoting, and the number of negative eigenvalues by LDL' without (generic matrices need none). */
static int dense_solve(int32_t size, double *matrix, double *x, int *negative) {
    double *copy = malloc(sizeof(double) * (size_t)(size * size));
    memcpy(copy, matrix, sizeof(double) * (size_t)(size * size));
    *negative = 0;
    for (int32_t k = 0; k < size; k++) {
        *negative += copy[k * size + k] < 0;
        for (int32_t i = k + 1; i < size; i++)
            for (int32_t j = size - 1; j >= k; j--)
                copy[i * size + j] -= copy[i * size + k] / copy[k * size + k] * copy[k * size + j];
    }
    free(copy);
    for (int32_t k = 0; k < size; k++) {
        int32_t pivot = k;
        for (int32_t i = k; i < size; i++)
            if (fabs(matrix[i * size + k]) > fabs(matrix[pivot * size + k])) pivot = i;
        for (int32_t j = 0; j < size; j++) {
            double kept = matrix[k * size + j];
            matrix[k * size + j] = matrix[pivot * size + j], matrix[pivot * size + j] = kept;
        }
        double kept = x[k];
        x[k] = x[pivot], x[pivot] = kept;
        for (int32_t i = k + 1; i < size; i++) {
            double factor = matrix[i * size + k] / matrix[k * size + k];
            for (int32_t j = k; j < size; j++)
                matrix[i * size + j] -= factor * matrix[k * size + j];
            x[i] -= factor * x[k];
        }
    }
    for (int32_t k = size - 1; k >= 0; k--) {
        for (int32_t j = k + 1; j < size; j++)
            x[k] -= matrix[k * size + j] * x[j];
        x[k] /= matrix[k * size + k];
    }
    return 1;
}

/* Solution, inertia and descent direction of the folded rows against the dense matrix. */
static void check_solve(const struct sp_surface *surface, int32_t inner, struct sp_arena *arena, uint64_t *seed) {
    struct sp_newton newton = random_path(surface, inner, arena, seed);
    struct sp_energy energy = sp_polyline_assemble(&newton.system.line, SP_COORDINATE, newton.system.rows, newton.system.straight);
    double matrix[4 * LARGEST * LARGEST], right[2 * LARGEST];
    unfold(&newton, inner, matrix, right);
    int negative;
    dense_solve(2 * inner, matrix, right, &negative);
    struct sp_inertia inertia = sp_blocks_factor(newton.system.line.fold, newton.system.rows, 0);
    CHECK(inertia.usable && inertia.negative == negative, "n = %d: %d negative, dense %d", inner, inertia.negative, negative);
    CHECK(energy.inertia.negative == negative && energy.inertia.descent == inertia.descent, "n = %d: in the sweep %d, descent %g", inner,
          energy.inertia.negative, energy.inertia.descent);
    sp_pair x[2 * (LARGEST + 2)];
    sp_blocks_solve(newton.system.line.fold, newton.system.rows, x);
    double largest = 0, error = 0;
    for (int32_t i = 0; i < 2 * inner; i++) {
        double mine = sp_fold_get(newton.system.line.fold, x, 2, 1 + i / 2, i % 2);
        largest = fmax(largest, fabs(right[i])), error = fmax(error, fabs(right[i] - mine));
    }
    CHECK(error <= 1e-9 * largest, "n = %d: error %g of %g", inner, error, largest);
    double linear;
    quadratic(&newton, x, &linear);
    CHECK(fabs(inertia.descent - linear) <= 1e-9 * fabs(linear), "n = %d: descent %g, not %g", inner, inertia.descent, linear);
    if (negative)
        CHECK(sp_blocks_descent(newton.system.line.fold, newton.system.rows, x) && quadratic(&newton, x, &linear) < 0, "n = %d: no descent",
              inner);
}

int main(void) {
    struct sp_arena arena = {aligned_alloc(16, 1 << 20), 1 << 20, 0};
    uint64_t seed = 20240607;
    const struct sp_surface *surfaces[] = {&saddle_surface, &bumpy_surface, &globe_surface, &torus_surface, &sphere_surface};
    for (int i = 0; i < 5; i++)
        for (int32_t inner = 1; inner <= LARGEST; inner++)
            for (int round = 0; round < 10; round++) {
                check_derivatives(surfaces[i], SP_COVARIANT, inner, &arena, &seed);
                if (surfaces[i]->kind == SP_PARAMETRIC) check_derivatives(surfaces[i], SP_COORDINATE, inner, &arena, &seed);
                check_solve(surfaces[i], inner, &arena, &seed);
            }
    free(arena.base);
    return checks_failed();
}
