/* Whole solves through the exported functions: known lengths, reversal to the bit, saddles left, arenas of every size, hostile numbers. */
#include "start.h"
#include "surfaces.h"
#include "surfpath.h"
#include "testing.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static struct sp_arena arena;

static struct sp_result solve(const struct sp_surface *surface, struct sp_request request, struct sp_options options) {
    struct sp_result result;
    arena.used = 0;
    sp_solve_path(surface, &request, &options, &arena, &result);
    return result;
}

static struct sp_options options_of(int32_t points, double gradient_tolerance) {
    struct sp_options options;
    sp_default_options(&options);
    options.algorithm = SP_POLYLINE, options.point_count = points, options.gradient_tolerance = gradient_tolerance;
    return options;
}

/* A polyline with K inner points on a great circle of angle a has length 2 (K + 1) sin(a/(2 (K + 1))), equally spaced. */
static void check_great_circle(const struct sp_surface *surface, struct sp_request request, double angle) {
    for (int32_t points = 1; points <= 300; points = points * 3 / 2 + 1) {
        struct sp_result result = solve(surface, request, options_of(points, 0));
        double expected = 2 * (points + 1) * sin(angle / (2 * (points + 1)));
        CHECK(result.status == SP_CONVERGED && result.index == 0, "K = %d: status %d, index %d", points, result.status, result.index);
        CHECK(fabs(result.length - expected) <= 1e-12 * expected, "K = %d: length %.17g, not %.17g", points, result.length, expected);
        CHECK(fabs(result.length + result.length_error - angle) <= 2 * pow(angle / (points + 1), 4), "K = %d: error estimate %g of %g",
              points, result.length_error, angle - result.length);
    }
}

/* A great circle beyond the antipode is a saddle of the energy: Newton leaves it for the short way round. */
static void check_escape(void) {
    double start[3 * 41];
    for (int i = 0; i <= 40; i++) {
        double angle = 1.4 * 3.141592653589793 * i / 40;
        start[3 * i] = cos(angle), start[3 * i + 1] = sin(angle), start[3 * i + 2] = 0;
    }
    struct sp_request request = {.from = {1, 0, 0}, .to = {start[120], start[121], 0}, .start = start, .start_count = 41};
    struct sp_result result = solve(&sphere_surface, request, options_of(40, 0));
    CHECK(result.status == SP_CONVERGED && result.index == 0, "status %d, index %d", result.status, result.index);
    CHECK(fabs(result.length - 0.6 * 3.141592653589793) < 1e-3, "length %g", result.length);
    struct sp_options paper = options_of(40, 0);
    paper.algorithm = SP_PAPER;
    result = solve(&sphere_surface, request, paper);
    CHECK(result.status == SP_SADDLE && result.index == 1, "paper: status %d, index %d", result.status, result.index);
}

/* A step moves every node at least once, and is tried with all of them or none. */
static void check_work(void) {
    struct sp_request request = {.from = {1, 0, 0}, .to = {0.6, 0, 0.8}};
    double start[9] = {1, 0, 0, 0.48, 0.64, 0.6, 0.6, 0, 0.8};
    struct sp_options options = options_of(40, 0);
    request.start = start, request.start_count = 3, options.algorithm = SP_PAPER;
    for (options.max_iterations = 0; options.max_iterations < 4; options.max_iterations++) {
        struct sp_result result = solve(&sphere_surface, request, options);
        int32_t least = 40 * options.max_iterations;
        CHECK(result.iterations == options.max_iterations, "%d steps of %d", result.iterations, options.max_iterations);
        CHECK(least == 0 ? result.work == 0 : result.work >= least && result.work % 40 == 0, "%d moves, not %d", result.work, least);
    }
}

/* What pulls at the ends, along the surface, is the derivative of the length, as two more paths tell, but for what is rounded of these over
 * the step; a polyline does not know it. */
static void check_pull(const struct sp_surface *surface, struct sp_request request, const double ways[2][3]) {
    static const double STEP = 1e-5;
    int dimension = surface->kind == SP_IMPLICIT ? 3 : 2;
    struct sp_options options;
    sp_default_options(&options);
    options.tolerance = 1e-12;
    for (int end = 0; end < 2; end++) {
        const double *way = ways[end];
        double lengths[2], expected, pulled = 0;
        for (int side = 0; side < 2; side++) {
            struct sp_request beside = request;
            for (int j = 0; j < dimension; j++)
                (end ? beside.to : beside.from)[j] += (side ? STEP : -STEP) * way[j];
            lengths[side] = solve(surface, beside, options).length;
        }
        struct sp_result result = solve(surface, request, options);
        expected = (lengths[1] - lengths[0]) / (2 * STEP);
        for (int j = 0; j < dimension; j++)
            pulled += result.pull[end][j] * way[j];
        CHECK(result.status == SP_CONVERGED && fabs(pulled - expected) <= 1e-8 * (1 + fabs(expected)),
              "end %d: status %d, %.12g, not %.12g", end, result.status, pulled, expected);
    }
    CHECK(isnan(solve(surface, request, options_of(20, 0)).pull[1][0]), "a polyline");
}

/* Exchanging the ends reverses every bit. */
static void check_reversal(const struct sp_surface *surface, uint64_t *seed) {
    int dimension = surface->kind == SP_IMPLICIT ? 3 : 2;
    struct sp_request there = {0}, back;
    for (int j = 0; j < dimension; j++)
        there.from[j] = 2 * random_unit(seed) - 1, there.to[j] = 2 * random_unit(seed) - 1;
    if (dimension == 3) there.from[0] += 4, there.to[0] += 4, there.to[1] += 1;
    back = there;
    memcpy(back.from, there.to, sizeof there.to), memcpy(back.to, there.from, sizeof there.from);
    int32_t points = 1 + (int32_t)(60 * random_unit(seed)), count = 3 * (points + 2);
    struct sp_result first = solve(surface, there, options_of(points, 0));
    double *kept = malloc(sizeof(double) * (size_t)count);
    if (first.points) memcpy(kept, first.points, sizeof(double) * (size_t)count);
    struct sp_result second = solve(surface, back, options_of(points, 0));
    CHECK(first.status == second.status && memcmp(&first.length, &second.length, sizeof(double)) == 0, "status %d, %d; length %.17g, %.17g",
          first.status, second.status, first.length, second.length);
    for (int32_t i = 0; first.points && i < count; i++) {
        int32_t mirrored = 3 * (points + 1 - i / 3) + i % 3;
        CHECK(kept[i] == second.points[mirrored], "number %d differs", i);
    }
    free(kept);
}

/* The arena of exactly the promised size is enough; every smaller one is refused, or enough too. */
static void check_arena(const struct sp_surface *surface, struct sp_request request, int32_t record) {
    struct sp_options options = options_of(7, 0);
    options.record = record, options.max_iterations = 20;
    size_t bytes = (size_t)sp_solve_bytes(surface, &options, request.start_count);
    for (size_t size = 0; size <= bytes; size += 16) {
        struct sp_arena small = {aligned_alloc(16, size + 16), size, 0};
        struct sp_result result;
        int32_t status = sp_solve_path(surface, &request, &options, &small, &result);
        CHECK(status == SP_CONVERGED || status == SP_OUT_OF_MEMORY, "size %zu: status %d", size, status);
        CHECK(size < bytes || status == SP_CONVERGED, "the promised size is not enough");
        CHECK(status == SP_CONVERGED || (!result.points && isnan(result.length)), "size %zu: a path without memory", size);
        free(small.base);
    }
}

/* Surfaces that return nothing usable: a status, never a trap or NaN called a path. */
static double hostile_value;
static void hostile_jet(int32_t count, const sp_pair *in, sp_pair *out) {
    (void)in;
    for (int32_t i = 0; i < count * SP_PARAMETRIC_JET; i++)
        out[i] = sp_splat(hostile_value);
}
static int32_t hostile_values;
static void hostile_value_only(int32_t count, const sp_pair *in, sp_pair *out) {
    (void)in;
    for (int32_t i = 0; i < count * hostile_values; i++)
        out[i] = sp_splat(hostile_value);
}

static void check_hostile(void) {
    double values[] = {0, 1, -1, NAN, INFINITY, -INFINITY, 1e308, 5e-324, 1e-200};
    for (int i = 0; i < 9; i++)
        for (int kind = 0; kind < 2; kind++)
            for (int32_t points = 1; points < 8; points++) {
                hostile_value = values[i], hostile_values = kind ? SP_IMPLICIT_VALUES : SP_PARAMETRIC_VALUES;
                struct sp_surface surface = {hostile_jet, hostile_value_only, kind, 0, {-1, -1}, {1, 1}, kind ? 3 : 0};
                struct sp_request request = {.from = {0.1, 0.2, 0.3}, .to = {0.5, -0.5, 0.1}};
                struct sp_result result = solve(&surface, request, options_of(points, 0));
                CHECK(result.status < 0 && !result.points, "value %g, kind %d: status %d", values[i], kind, result.status);
            }
}

/* x^2 + y^2 - z^2, whose gradient is zero at its apex. */
static void cone_jet(int32_t count, const sp_pair *in, sp_pair *out) {
    for (int32_t i = 0; i < count; i++, in += 3, out += SP_IMPLICIT_JET) {
        out[0] = in[0] * in[0] + in[1] * in[1] - in[2] * in[2];
        for (int j = 0; j < 3; j++)
            out[1 + j] = (j < 2 ? 2.0 : -2.0) * in[j];
        const double second[6] = {2, 0, 0, 2, 0, -2};
        for (int j = 0; j < 6; j++)
            out[4 + j] = sp_splat(second[j]);
    }
}
static void cone_value(int32_t count, const sp_pair *in, sp_pair *out) {
    sp_pair jet[SP_IMPLICIT_JET];
    for (int32_t i = 0; i < count; i++, in += 3, out += SP_IMPLICIT_VALUES) {
        cone_jet(1, in, jet);
        memcpy(out, jet, SP_IMPLICIT_VALUES * sizeof(sp_pair));
    }
}

/* Paths end in the apex of a cone, along straight lines; from half to half none leads that a solver may call one. */
static void check_apex(uint64_t *seed) {
    const struct sp_surface cone = {cone_jet, cone_value, SP_IMPLICIT, 0, {0, 0}, {0, 0}, 1};
    for (int32_t points = 1; points < 200; points = 2 * points + 1)
        for (int kind = 0; kind < 2; kind++) {
            double angle = 7 * random_unit(seed), height = random_unit(seed) - 0.5, radius = fabs(height);
            struct sp_request request = {.from = {radius * cos(angle), radius * sin(angle), height}, .to = {0, 0, 0}};
            struct sp_options options = options_of(points, 0);
            if (kind) options.algorithm = SP_ELEMENTS;
            struct sp_result result = solve(&cone, request, options);
            CHECK(result.status == SP_CONVERGED && result.index == 0, "K = %d, kind %d: status %d", points, kind, result.status);
            CHECK(fabs(result.length - sqrt(2) * radius) <= 1e-14, "K = %d, kind %d: %g", points, kind, result.length - sqrt(2) * radius);
            request.to[0] = -radius * cos(angle + 1), request.to[1] = radius * sin(angle + 1), request.to[2] = -height;
            result = solve(&cone, request, options);
            CHECK(result.status != SP_CONVERGED, "K = %d, kind %d, through the apex", points, kind);
        }
}

/* (u + iv)^3 in the plane, which goes three times around 0. */
static void cover_jet(int32_t count, const sp_pair *in, sp_pair *out) {
    for (; count > 0; count--, in += 2, out += SP_PARAMETRIC_JET) {
        sp_pair u = in[0], v = in[1], zero = sp_splat(0.0), x1 = 3.0 * (u * u - v * v), y1 = 6.0 * u * v, x2 = 6.0 * u, y2 = 6.0 * v;
        sp_pair jet[SP_PARAMETRIC_JET] = {u * u * u - 3.0 * u * v * v,
                                          3.0 * u * u * v - v * v * v,
                                          zero,
                                          x1,
                                          y1,
                                          zero,
                                          -y1,
                                          x1,
                                          zero,
                                          x2,
                                          y2,
                                          zero,
                                          -y2,
                                          x2,
                                          zero,
                                          -x2,
                                          -y2,
                                          zero};
        memcpy(out, jet, sizeof jet);
    }
}
static void cover_value(int32_t count, const sp_pair *in, sp_pair *out) {
    sp_pair jet[SP_PARAMETRIC_JET];
    for (int32_t i = 0; i < count; i++, in += 2, out += SP_PARAMETRIC_VALUES) {
        cover_jet(1, in, jet);
        memcpy(out, jet, SP_PARAMETRIC_VALUES * sizeof(sp_pair));
    }
}

/* Paths end in a branch point, along straight lines of the plane. From side to side none leads that a solver may call one, unless it passes
 * beside. */
static void check_branch(uint64_t *seed) {
    const struct sp_surface cover = {cover_jet, cover_value, SP_PARAMETRIC, 0, {-1, -1}, {1, 1}, 0};
    const struct sp_arena small = arena;
    arena = (struct sp_arena){aligned_alloc(16, 1 << 23), 1 << 23, 0};
    for (int i = 0; i < 40; i++) {
        double u = 2 * random_unit(seed) - 1, v = 2 * random_unit(seed) - 1, length = pow(u * u + v * v, 1.5);
        struct sp_request request = {.from = {u, v, 0}, .to = {0, 0, 0}};
        struct sp_options options = options_of(64, 0);
        options.algorithm = SP_ELEMENTS;
        struct sp_result result = solve(&cover, request, options);
        CHECK(result.status == SP_CONVERGED && result.index == 0, "%g, %g: status %d", u, v, result.status);
        CHECK(fabs(result.length / length - 1) <= 1e-12, "%g, %g: %g", u, v, result.length / length - 1);
        request.to[0] = -u, request.to[1] = -v; /* one and a half turns on */
        CHECK(solve(&cover, request, options).status != SP_CONVERGED, "%g, %g, through the point", u, v);
    }
    free(arena.base);
    arena = small;
}

static void check_projection(uint64_t *seed) {
    for (int i = 0; i < 200; i++) {
        double point[3], place[3], length = 0;
        for (int j = 0; j < 3; j++)
            point[j] = place[j] = 2 * random_unit(seed) - 1, length += point[j] * point[j];
        int32_t status = sp_project_point(&sphere_surface, point, place);
        CHECK(status == SP_CONVERGED, "sphere: status %d", status);
        for (int j = 0; j < 3; j++)
            CHECK(fabs(place[j] - point[j] / sqrt(length)) <= 1e-12, "sphere: %g", place[j] - point[j] / sqrt(length));
        double u = random_unit(seed) - 0.5, v = random_unit(seed) - 0.5, up = 0.05 * random_unit(seed),
               normal = sqrt(1 + 4 * u * u + 4 * v * v);
        double above[3] = {u - 2 * u * up / normal, v + 2 * v * up / normal, u * u - v * v + up / normal}, found[3] = {u + 0.2, v - 0.1, 0};
        status = sp_project_point(&saddle_surface, above, found);
        CHECK(status == SP_CONVERGED && fabs(found[0] - u) <= 1e-9 && fabs(found[1] - v) <= 1e-9, "saddle: status %d, %g %g", status,
              found[0] - u, found[1] - v);
    }
}

/* The larger |X| of the ends, where no box tells: of an implicit surface their places, of a metric alone u and v, else the positions. */
static void check_scale(void) {
    const struct sp_surface sphere = {sphere_jet, sphere_value, SP_IMPLICIT, 0, {0, 0}, {0, 0}, 0};
    const struct sp_surface abstract = {saddle_jet, NULL, SP_PARAMETRIC, SP_TENSOR, {-9, -9}, {9, 9}, 0};
    struct sp_request request = {.from = {3, 4, 0}, .to = {2, 3, 6}}, on_saddle = {.from = {0, 0, 0}, .to = {0.6, 0.8, 0}};
    struct {
        const struct sp_surface *surface;
        struct sp_request request;
        double scale;
    } cases[] = {{&sphere, request, 7}, {&abstract, request, 5}, {&sphere_surface, request, 3.5}};
    for (int i = 0; i < 3; i++)
        CHECK(sp_start_scale(cases[i].surface, &cases[i].request) == cases[i].scale, "case %d", i);
    sp_pair place[2] = {sp_splat(0.6), sp_splat(0.8)}, x[3];
    saddle_value(1, place, x);
    double size = sqrt(x[0][0] * x[0][0] + x[1][0] * x[1][0] + x[2][0] * x[2][0]);
    CHECK(fabs(sp_start_scale(&saddle_surface, &on_saddle) - size) < 1e-15, "a saddle's");
}

/* Whether 256 of 1,001 points tell the way that they lead: across a saddle, straight over u and v, or in waves of 25 points. */
static void check_smooth(void) {
    double start[2 * 1001];
    for (int waves = 0; waves <= 1; waves++) {
        for (int i = 0; i <= 1000; i++)
            start[2 * i] = 1e-3 * i - 0.5, start[2 * i + 1] = 0.3 + 1e-3 * waves * sin(2 * 3.141592653589793 * i / 25);
        struct sp_request request = {.start = start, .start_count = 1001};
        struct sp_polyline line = {.surface = &saddle_surface, .kind = sp_kind_of(&saddle_surface)};
        arena.used = 0;
        CHECK(sp_start_is_smooth(&line, &request, 256, &arena) == !waves, "waves: %d", waves);
    }
}

int main(void) {
    check_scale();
    arena = (struct sp_arena){aligned_alloc(16, 1 << 22), 1 << 22, 0};
    check_smooth();
    uint64_t seed = 77;
    struct sp_request on_globe = {.from = {0.1, -0.7, 0}, .to = {1.4, 0.9, 0}}, on_sphere = {.from = {1, 0, 0}, .to = {0, 1, 0}};
    check_great_circle(&globe_surface, on_globe, acos(sin(-0.7) * sin(0.9) + cos(-0.7) * cos(0.9) * cos(1.3)));
    check_great_circle(&sphere_surface, on_sphere, acos(0.0));
    check_pull(&globe_surface, on_globe, (double[2][3]){{0.3, -0.8, 0}, {0.6, 0.8, 0}});
    check_pull(&saddle_surface, (struct sp_request){.from = {0.7, -0.6, 0}, .to = {-0.8, 0.5, 0}},
               (double[2][3]){{-0.6, 0.8, 0}, {0.9, 0.1, 0}});
    check_pull(&sphere_surface, on_sphere, (double[2][3]){{0, 0.5, -0.7}, {-0.4, 0, 0.3}});
    check_escape();
    check_work();
    const struct sp_surface *surfaces[] = {&saddle_surface, &bumpy_surface, &globe_surface, &torus_surface};
    for (int i = 0; i < 400; i++)
        check_reversal(surfaces[i % 4], &seed);
    double start[6] = {0.1, -0.7, 1, 0, 1.4, 0.9};
    check_arena(&globe_surface, on_globe, 0);
    check_arena(&sphere_surface, on_sphere, 1);
    check_arena(&globe_surface, (struct sp_request){.from = {0.1, -0.7, 0}, .to = {1.4, 0.9, 0}, .start = start, .start_count = 3}, 1);
    check_hostile();
    check_apex(&seed);
    check_branch(&seed);
    check_projection(&seed);
    free(arena.base);
    return checks_failed();
}
