/* Densities and metric tensors: gradient, Hessian, condensation and solve for every kind, of chords and of elements, against finite
 * differences of the energy itself; and against the plain energy where the metric is that of space. */
#include "metric_check.h"
#include "newton.h"
#include "surfaces.h"
#include "testing.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LARGEST = 64 };

/* a + b sin(w . x) with its derivatives in `dimension` variables, upper-triangular order. */
static void write_wave(const sp_pair *in, int32_t dimension, double a, double b, sp_pair *out, int32_t stride) {
    const double w[3] = {1, 2, -1};
    sp_pair phase = in[0] + 2.0 * in[1] - (dimension == 3 ? in[2] : sp_splat(0.0)), cosine, sine = sp_sincos(phase, &cosine);
    *out = a + b * sine;
    for (int i = 0; i < dimension; i++)
        *(out += stride) = b * w[i] * cosine;
    for (int i = 0; i < dimension; i++)
        for (int j = i; j < dimension; j++)
            *(out += stride) = -b * w[i] * w[j] * sine;
}

/* Components a + b sin, xx xy yy xz yz zz: positive definite. `flat`: the metric of space. */
static const double WAVES[6][2] = {{3, 0.8}, {0.4, 0.5}, {2, -0.6}, {0.3, 0.2}, {-0.2, 0.4}, {2.5, 0.7}};
static int flat;

static void write_components(const sp_pair *in, int32_t dimension, int32_t count, sp_pair *out, int32_t stride) {
    for (int32_t c = 0; c < count; c++) {
        int diagonal = c == 0 || c == 2 || c == 5;
        write_wave(in, dimension, flat ? diagonal : WAVES[c][0], flat ? 0 : WAVES[c][1], out + c, stride);
    }
}

static void saddle_density_jet(int32_t count, const sp_pair *in, sp_pair *out) {
    for (; count > 0; count--, in += 2, out += SP_PARAMETRIC_DENSITY_JET) {
        sp_pair jet[SP_PARAMETRIC_JET];
        saddle_jet(1, in, jet);
        for (int i = 0; i < SP_METRIC_PARTS; i++)
            memcpy(out + 4 * i, jet + 3 * i, 3 * sizeof(sp_pair));
        write_components(in, 2, 1, out + 3, 4);
    }
}

static void tensor_jet(int32_t count, const sp_pair *in, sp_pair *out) {
    for (; count > 0; count--, in += 2, out += SP_PARAMETRIC_TENSOR_JET)
        write_components(in, 2, 3, out, 3);
}

static void torus_metric(int32_t count, const sp_pair *in, sp_pair *out, int32_t components) {
    int32_t outputs = components + 1;
    for (; count > 0; count--, in += 3, out += SP_IMPLICIT_JET * outputs) {
        sp_pair jet[SP_IMPLICIT_JET];
        torus_jet(1, in, jet);
        for (int i = 0; i < SP_IMPLICIT_JET; i++)
            out[outputs * i] = jet[i];
        write_components(in, 3, components, out + 1, outputs);
    }
}

static void torus_density_jet(int32_t count, const sp_pair *in, sp_pair *out) { torus_metric(count, in, out, 1); }
static void torus_tensor_jet(int32_t count, const sp_pair *in, sp_pair *out) { torus_metric(count, in, out, 6); }

static const struct sp_surface saddle_density = {saddle_density_jet, saddle_value, SP_PARAMETRIC, SP_DENSITY, {-9, -9}, {9, 9}, 0};
static const struct sp_surface tensor = {tensor_jet, NULL, SP_PARAMETRIC, SP_TENSOR, {-9, -9}, {9, 9}, 0};
static const struct sp_surface torus_density = {torus_density_jet, torus_value, SP_IMPLICIT, SP_DENSITY, {0, 0}, {0, 0}, 19.7};
static const struct sp_surface torus_tensor = {torus_tensor_jet, torus_value, SP_IMPLICIT, SP_TENSOR, {0, 0}, {0, 0}, 19.7};

static struct sp_arena arena;

static void take_elements(struct sp_elements *elements, int32_t degree, int32_t count) {
    size_t order = (size_t)sp_elements_order(degree);
    CHECK(sp_reference_make(&elements->reference, degree, &arena), "arena");
    elements->count = count;
    elements->spread = count > 2 ? growing_elements() : NULL;
    elements->matrices = sp_arena_take(&arena, order * order * (size_t)count / 2, sizeof(sp_pair));
    elements->velocity = sp_arena_take(&arena, 3 * ((size_t)degree + 1), sizeof(sp_pair));
    elements->skeleton = sp_arena_take(&arena, (size_t)count / 2 + 1, sizeof(struct sp_row));
}

/* Node i of a path that bends, shaken by a twentieth; u v or near the torus. */
static double random_coordinate(const struct sp_surface *surface, double t, int j, uint64_t *seed) {
    double bent[3] = {-0.5 + t, 0.3 + 0.4 * t * t, 1.2 * t - 0.3};
    if (surface->kind == SP_IMPLICIT) bent[0] = 2.6 + 0.3 * t;
    return bent[j] + 0.05 * (2 * random_unit(seed) - 1);
}

/* A random path of `count` elements; degree 1: `count` chords. */
static struct sp_newton random_path(const struct sp_surface *surface, int32_t degree, int32_t count, uint64_t *seed) {
    struct sp_newton newton = {0};
    struct sp_polyline *line = &newton.system.line;
    int32_t inner = degree * count - 1;
    struct sp_options options = {0, 0, SP_POLYLINE, inner, 10, 0};
    arena.used = 0;
    CHECK(sp_newton_take(&newton, surface, &options, inner, &arena), "arena");
    if (degree > 1) take_elements(&newton.system.elements, degree, count);
    int32_t dimension = line->kind->dimension;
    for (int32_t i = 0; i <= inner + 1; i++)
        for (int j = 0; j < dimension; j++)
            line->nodes.places[dimension * sp_fold_pair(line->fold, i) + j][sp_fold_lane(line->fold, i)] =
                random_coordinate(surface, (double)i / (inner + 1), j, seed);
    sp_pair *middle = line->nodes.places + dimension * (sp_fold_both(line->fold) + 1);
    for (int j = 0; j < dimension && sp_fold_odd(line->fold); j++)
        middle[j] = sp_splat(middle[j][0]);
    if (surface->kind == SP_IMPLICIT) sp_implicit_settle(surface, sp_fold_unknown(line->fold) + 1, line->nodes.places, 19.7);
    sp_fold_mirror(line->fold, line->nodes.places, dimension);
    sp_polyline_charts(line, &line->nodes);
    return newton;
}

/* First fundamental form of one pair of places, e f g. */
static void form_at(const struct sp_polyline *line, const sp_pair *place, sp_pair form[3]) {
    sp_pair chart[SP_CHART], metric[SP_METRIC_LARGEST];
    line->kind->charts(line->surface, 1, place, chart, metric);
    struct sp_form at = sp_metric_form(line->kind->components, chart, metric);
    form[0] = at.e, form[1] = at.f, form[2] = at.g;
}

/* -Gamma(d, d)/2 at a pair of places u v: from differences of the first fundamental form. */
static void bend(const struct sp_polyline *line, const sp_pair *place, const sp_pair *step, sp_pair *bent) {
    sp_pair form[3], slopes[2][3];
    for (int a = 0; a < 2; a++) {
        sp_pair ahead[3], behind[3], near[2] = {place[0], place[1]};
        near[a] = place[a] + 1e-4, form_at(line, near, ahead);
        near[a] = place[a] - 1e-4, form_at(line, near, behind);
        for (int k = 0; k < 3; k++)
            slopes[a][k] = (ahead[k] - behind[k]) / 2e-4;
    }
    form_at(line, place, form);
    /* Gamma_c(d, d) = d(g_cb d_b) along d, less half of the derivative of |d|^2 by c. */
    sp_pair lowered[2], u = step[0], v = step[1];
    for (int c = 0; c < 2; c++) {
        sp_pair along = u * (slopes[0][c] * u + slopes[0][c + 1] * v) + v * (slopes[1][c] * u + slopes[1][c + 1] * v);
        lowered[c] = along - 0.5 * (slopes[c][0] * u * u + 2.0 * slopes[c][1] * u * v + slopes[c][2] * v * v);
    }
    sp_pair determinant = form[0] * form[2] - form[1] * form[1];
    bent[0] = -0.5 * (form[2] * lowered[0] - form[1] * lowered[1]) / determinant;
    bent[1] = -0.5 * (form[0] * lowered[1] - form[1] * lowered[0]) / determinant;
}

/* Half the scaled energy after moving along x by t; `bent`: t^2 of that, too, or NULL. */
static double energy_along(struct sp_newton *newton, const sp_pair *x, const sp_pair *bent, double t) {
    struct sp_polyline *line = &newton->system.line;
    int32_t unknown = sp_fold_unknown(line->fold), dimension = line->kind->dimension;
    sp_pair step[2 * (LARGEST + 2)];
    for (int32_t k = 0; k < 2 * sp_fold_pairs(line->fold); k++)
        step[k] = x[k] + (bent ? t * bent[k] : sp_splat(0.0));
    memcpy(newton->trial.places, line->nodes.places, sizeof(sp_pair) * (size_t)dimension);
    int moved = line->kind->move(line->surface, unknown, line->nodes.places + dimension, line->nodes.charts + SP_CHART, step + 2,
                                 newton->system.straight + 1, t, newton->trial.places + dimension);
    CHECK(moved, "refused to move by %g", t);
    sp_fold_mirror(line->fold, newton->trial.places, dimension);
    sp_polyline_charts(line, &newton->trial);
    return 0.5 * sp_system_squares(&newton->system, &newton->trial, NULL);
}

/* Replaces the right-hand side by a random one. */
static void randomise_right(struct sp_system *system, uint64_t *seed) {
    struct sp_fold fold = system->line.fold;
    for (int32_t k = 1; k <= sp_fold_unknown(fold); k++) {
        struct sp_row *row = system->rows + k;
        row->r1 = (sp_pair){random_unit(seed) - 0.5, random_unit(seed) - 0.5},
        row->r2 = (sp_pair){random_unit(seed) - 0.5, random_unit(seed) - 0.5};
        if (k > sp_fold_both(fold)) row->r1 = sp_splat(row->r1[0]), row->r2 = sp_splat(row->r2[0]);
    }
}

/* With x = H^-1 s for a random s, E(t x) = E - r.x t + s.x t^2/2 + O(t^3): assembly, couplings, condensation and solve at once. */
static void check_derivatives(const struct sp_surface *surface, enum sp_hessian hessian, int32_t degree, int32_t count, uint64_t *seed) {
    struct sp_newton newton = random_path(surface, degree, count, seed);
    struct sp_system *system = &newton.system;
    int32_t pairs = sp_fold_pairs(system->line.fold);
    sp_pair gradient[2 * (LARGEST + 2)], x[2 * (LARGEST + 2)], bent[2 * (LARGEST + 2)] = {{0}};
    sp_system_assemble(system, hessian);
    for (int32_t k = 1; k <= sp_fold_unknown(system->line.fold); k++)
        gradient[2 * k] = system->rows[k].r1, gradient[2 * k + 1] = system->rows[k].r2;
    randomise_right(system, seed);
    struct sp_inertia inertia = sp_system_factor(system, 0);
    CHECK(inertia.usable, "singular");
    sp_system_solve(system, x);
    double largest = 0, linear = 0;
    for (int32_t k = 0; k < 2 * pairs; k++)
        largest = fmax(largest, fmax(fabs(x[k][0]), fabs(x[k][1])));
    double second = inertia.descent / (largest * largest), size = 0;
    for (int32_t k = 2; k < 2 * pairs; k++)
        x[k] /= largest;
    for (int32_t k = 1; k <= sp_fold_unknown(system->line.fold); k++) {
        linear += sp_fold_sum(system->line.fold, k, gradient[2 * k] * x[2 * k] + gradient[2 * k + 1] * x[2 * k + 1]);
        size += fabs(gradient[2 * k][0]) + fabs(gradient[2 * k + 1][0]);
        if (hessian == SP_COVARIANT) bend(&system->line, system->line.nodes.places + 2 * k, x + 2 * k, bent + 2 * k);
        system->straight[k] = (sp_mask){-1, -1};
    }
    sp_fold_mirror(system->line.fold, bent, 2);
    double slope[3], curvature[3], here = energy_along(&newton, x, NULL, 0);
    for (int i = 0; i < 3; i++) {
        double t = 8e-3 / (1 << i), ahead = energy_along(&newton, x, hessian == SP_COVARIANT ? bent : NULL, t),
               behind = energy_along(&newton, x, hessian == SP_COVARIANT ? bent : NULL, -t);
        slope[i] = (ahead - behind) / (2 * t), curvature[i] = (ahead - 2 * here + behind) / (t * t);
    }
    /* Richardson twice: what is left is of sixth order. */
    double first = (64 * slope[2] - 20 * slope[1] + slope[0]) / 45,
           difference = (64 * curvature[2] - 20 * curvature[1] + curvature[0]) / 45;
    CHECK(fabs(first + linear) <= 1e-8 * (1 + size), "degree %d, %d: slope %.12g, difference %.12g", degree, count, -linear, first);
    CHECK(fabs(difference - second) <= 1e-6 * (1 + fabs(second) + size), "degree %d, %d: curvature %.12g, difference %.12g", degree, count,
          second, difference);
}

/* A metric that is that of space changes nothing. */
static void check_plain(const struct sp_surface *weighted, const struct sp_surface *plain, int32_t degree, int32_t count, uint64_t *seed) {
    uint64_t same = *seed;
    flat = 1;
    struct sp_newton newton = random_path(weighted, degree, count, seed);
    struct sp_energy energy = sp_system_assemble(&newton.system, SP_COORDINATE);
    struct sp_inertia inertia = sp_system_factor(&newton.system, 0);
    sp_pair x[2 * (LARGEST + 2)], y[2 * (LARGEST + 2)];
    sp_system_solve(&newton.system, x);
    double length = sp_system_length(&newton.system, &newton.system.line.nodes);
    flat = 0;
    newton = random_path(plain, degree, count, &same);
    struct sp_energy wanted = sp_system_assemble(&newton.system, SP_COORDINATE);
    CHECK(sp_system_factor(&newton.system, 0).negative == inertia.negative, "index");
    sp_system_solve(&newton.system, y);
    CHECK(fabs(energy.squares - wanted.squares) <= 1e-13 * wanted.squares, "energy %.17g, plain %.17g", energy.squares, wanted.squares);
    CHECK(fabs(energy.gradient_squared - wanted.gradient_squared) <= 1e-11 * wanted.gradient_squared, "gradient %.17g, plain %.17g",
          energy.gradient_squared, wanted.gradient_squared);
    CHECK(fabs(sp_system_length(&newton.system, &newton.system.line.nodes) - length) <= 1e-13 * length, "length");
    double largest = 0, error = 0;
    for (int32_t k = 2; k < 2 * sp_fold_pairs(newton.system.line.fold); k++)
        for (int lane = 0; lane < 2; lane++)
            largest = fmax(largest, fabs(y[k][lane])), error = fmax(error, fabs(x[k][lane] - y[k][lane]));
    CHECK(error <= 1e-9 * largest, "degree %d, %d: step differs by %g of %g", degree, count, error, largest);
}

/* What the check of the metric says of straight lines from (-1, 0.2) to (1, 0.3), ds^2 = shape(u) du^2 + dv^2. */
static double (*shape)(double u);
static void shape_jet(int32_t count, const sp_pair *in, sp_pair *out) {
    for (; count > 0; count--, in += 2, out += SP_PARAMETRIC_TENSOR_JET) {
        memset(out, 0, SP_PARAMETRIC_TENSOR_JET * sizeof(sp_pair));
        out[0] = (sp_pair){shape(in[0][0]), shape(in[0][1])}, out[2] = sp_splat(1.0);
    }
}
static double sound(double u) { return 1 + u * u; }
static double vanishing(double u) { return u * u; }
static double almost_vanishing(double u) { return u * u + 1e-12; }
static double negative(double u) { return u - 0.4; }
static double negative_between(double u) { return fabs(u - 0.25) < 0.01 ? -1 : 1; }
static double not_finite(double u) { return sqrt(u); }
static double pole(double u) { return (u + 1) * (u + 1); }

static void check_status(double (*of)(double), int32_t inner, enum sp_status wanted) {
    static const struct sp_surface shaped = {shape_jet, NULL, SP_PARAMETRIC, SP_TENSOR, {-9, -9}, {9, 9}, 0};
    uint64_t seed = 1;
    shape = of;
    struct sp_newton newton = random_path(&shaped, 1, inner + 1, &seed);
    struct sp_polyline *line = &newton.system.line;
    for (int32_t i = 0; i <= inner + 1; i++) {
        sp_pair *place = line->nodes.places + 2 * sp_fold_pair(line->fold, i);
        double t = (double)i / (inner + 1);
        place[0][sp_fold_lane(line->fold, i)] = 2 * t - 1, place[1][sp_fold_lane(line->fold, i)] = 0.2 + 0.1 * t;
    }
    for (int j = 0; j < 2 && sp_fold_odd(line->fold); j++)
        line->nodes.places[2 * sp_fold_both(line->fold) + 2 + j] = sp_splat(line->nodes.places[2 * sp_fold_both(line->fold) + 2 + j][0]);
    sp_fold_mirror(line->fold, line->nodes.places, 2);
    sp_polyline_charts(line, &line->nodes);
    enum sp_status status = sp_metric_check(line, 1);
    CHECK(status == wanted, "n = %d: status %d, not %d", inner, status, wanted);
}

/* The arena of exactly the promised size is enough, for chords and for the whole ladder; half of it is refused, or
 * enough for a ladder that is not climbed to the end. */
static void check_arena(const struct sp_surface *surface, int32_t algorithm, int32_t record) {
    struct sp_request request = {.from = {-0.5, 0.3, 0.2}, .to = {0.6, 0.7, 0.9}};
    if (surface->kind == SP_IMPLICIT) request.from[0] = 2.7, request.to[0] = 2.9;
    struct sp_options options;
    struct sp_result result;
    sp_default_options(&options);
    options.algorithm = algorithm, options.record = record, options.point_count = 17;
    size_t bytes = (size_t)sp_solve_bytes(surface, &options, 0);
    for (size_t part = 1; part <= 2; part++) {
        struct sp_arena exact = {aligned_alloc(16, (bytes + 15) & ~(size_t)15), part * bytes / 2, 0};
        int32_t status = sp_solve_path(surface, &request, &options, &exact, &result);
        int refused = part == 1 && status == SP_OUT_OF_MEMORY, early = part == 1 && algorithm == SP_ELEMENTS && status == SP_CONVERGED;
        CHECK(refused || early || (part == 2 && status == SP_CONVERGED), "algorithm %d, half %zu: status %d", algorithm, part, status);
        CHECK(part == 1 || (!result.points == !surface->value && !result.record == !(record && surface->value)), "points or record");
        free(exact.base);
    }
}

int main(void) {
    arena = (struct sp_arena){aligned_alloc(16, 1 << 22), 1 << 22, 0};
    uint64_t seed = 20240611;
    const struct sp_surface *surfaces[] = {&saddle_density, &tensor, &torus_density, &torus_tensor};
    const int32_t shapes[][2] = {{1, 2}, {1, 3}, {1, 4}, {1, 5}, {1, 8}, {1, 13}, {6, 2}, {6, 4}, {8, 2}, {8, 6}, {12, 4}};
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 11; j++)
            for (int round = 0; round < 5; round++) {
                check_derivatives(surfaces[i], SP_COORDINATE, shapes[j][0], shapes[j][1], &seed);
                if (surfaces[i]->kind == SP_PARAMETRIC) check_derivatives(surfaces[i], SP_COVARIANT, shapes[j][0], shapes[j][1], &seed);
            }
    for (int j = 0; j < 11; j++) {
        check_plain(&saddle_density, &saddle_surface, shapes[j][0], shapes[j][1], &seed);
        check_plain(&torus_density, &torus_surface, shapes[j][0], shapes[j][1], &seed);
        check_plain(&torus_tensor, &torus_surface, shapes[j][0], shapes[j][1], &seed);
    }
    for (int32_t inner = 3; inner <= 24; inner++) {
        check_status(sound, inner, SP_CONVERGED);
        check_status(pole, inner, SP_CONVERGED);
        check_status(vanishing, inner, SP_SINGULAR_METRIC);
        check_status(almost_vanishing, inner, SP_SINGULAR_METRIC);
        check_status(negative, inner, SP_SINGULAR_METRIC);
        check_status(not_finite, inner, SP_NOT_FINITE);
    }
    check_status(negative_between, 3, SP_SINGULAR_METRIC);
    for (int i = 0; i < 4; i++)
        for (int32_t record = 0; record < 2; record++)
            check_arena(surfaces[i], SP_POLYLINE, record), check_arena(surfaces[i], SP_ELEMENTS, record);
    free(arena.base);
    return checks_failed();
}
