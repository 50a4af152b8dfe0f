/* Paths made of arcs against closed forms: round the walls of a wavy strip, over poles, across cusps; and that too few steps or too little
 * memory end them honestly, wherever in the making they run out. */
#include "surfaces.h"
#include "surfpath.h"
#include "testing.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SIZES = 150, STEPS = 40 };

static const double PI = 3.14159265358979323846;

/* The plane as (u, v + sin u): lines v = const are waves. */
static void wavy(int32_t count, const sp_pair *in, sp_pair *out, int values) {
    for (; count > 0; count--, in += 2, out += values) {
        sp_pair cosine, sine = sp_sincos(in[0], &cosine), zero = sp_splat(0.0), one = sp_splat(1.0);
        sp_pair jet[SP_PARAMETRIC_JET] = {in[0], in[1] + sine, zero, one, cosine, zero, zero, one, zero, zero, -sine, zero};
        for (int j = 0; j < values; j++)
            out[j] = j < 12 ? jet[j] : zero;
    }
}

/* 100 (v - u^2)^2 over the plane. */
static int32_t valley_pairs; /* evaluated so far */

static void valley(int32_t count, const sp_pair *in, sp_pair *out, int values) {
    valley_pairs += count;
    for (; count > 0; count--, in += 2, out += values) {
        sp_pair u = in[0], w = in[1] - u * u, zero = sp_splat(0.0), one = sp_splat(1.0);
        sp_pair jet[SP_PARAMETRIC_JET] = {u,    in[1], 100.0 * w * w, one,  zero, -400.0 * u * w,
                                          zero, one,   200.0 * w,     zero, zero, 800.0 * u * u - 400.0 * w,
                                          zero, zero,  -400.0 * u,    zero, zero, sp_splat(200.0)};
        for (int j = 0; j < values; j++)
            out[j] = jet[j];
    }
}

/* The plane under the length element r^2 ds. */
static void funnel_jet(int32_t count, const sp_pair *in, sp_pair *out) {
    for (; count > 0; count--, in += 2, out += SP_PARAMETRIC_TENSOR_JET) {
        sp_pair u = in[0], v = in[1], r = u * u + v * v;
        sp_pair jet[6] = {r * r, 4.0 * r * u, 4.0 * r * v, 4.0 * r + 8.0 * u * u, 8.0 * u * v, 4.0 * r + 8.0 * v * v};
        for (int j = 0; j < 6; j++)
            out[3 * j] = out[3 * j + 2] = jet[j], out[3 * j + 1] = sp_splat(0.0);
    }
}

/* (cos u cos v, cos u sin v, sin u): the poles at the ends of u. */
static void upright(int32_t count, const sp_pair *in, sp_pair *out, int values) {
    for (; count > 0; count--, in += 2, out += values) {
        static const int exchanged[6] = {0, 2, 1, 5, 4, 3};
        sp_pair place[2] = {in[1], in[0]}, jet[SP_PARAMETRIC_JET];
        globe_jet(1, place, jet);
        for (int j = 0; j < values; j++)
            out[j] = jet[3 * exchanged[j / 3] + j % 3];
    }
}

/* The ellipsoid of semiaxes 3/2, 1 and 7/10, as longitude and latitude and as f = 0. */
static const double AXES[3] = {1.5, 1, 0.7};
static int32_t ellipsoid_pairs; /* evaluated so far */

static void ellipsoid(int32_t count, const sp_pair *in, sp_pair *out, int values) {
    ellipsoid_pairs += count;
    for (; count > 0; count--, in += 2, out += values) {
        sp_pair jet[SP_PARAMETRIC_JET];
        globe_jet(1, in, jet);
        for (int j = 0; j < values; j++)
            out[j] = AXES[j % 3] * jet[j];
    }
}

static void quadric(int32_t count, const sp_pair *in, sp_pair *out, int values) {
    for (; count > 0; count--, in += 3, out += values) {
        sp_pair zero = sp_splat(0.0), jet[SP_IMPLICIT_JET] = {sp_splat(-1.0), zero, zero, zero, zero, zero, zero, zero, zero, zero};
        for (int j = 0; j < 3; j++) {
            double weight = 1 / (AXES[j] * AXES[j]);
            jet[0] += weight * in[j] * in[j], jet[1 + j] = 2 * weight * in[j], jet[j == 0 ? 4 : 5 + 2 * j] = sp_splat(2 * weight);
        }
        for (int j = 0; j < values; j++)
            out[j] = jet[j];
    }
}

/* Five cusps, at v = 0, +-A and +-B: (u, y, z) with y' = p, z' = v p, p = v (v^2 - A^2) (v^2 - B^2). Bent out of a plane: u and the length
 * along v are Cartesian coordinates of it. */
static const double A = 0.4, B = 0.8;

static void pleated(int32_t count, const sp_pair *in, sp_pair *out, int values) {
    double s = A * A + B * B, q = A * A * B * B;
    for (; count > 0; count--, in += 2, out += values) {
        sp_pair v = in[1], w = v * v, zero = sp_splat(0.0), one = sp_splat(1.0);
        sp_pair p = v * (w * w - s * w + q), slope = 5.0 * w * w - 3.0 * s * w + q;
        sp_pair y = w * (w * w / 6.0 - s * w / 4.0 + q / 2.0), z = v * w * (w * w / 7.0 - s * w / 5.0 + q / 3.0);
        sp_pair jet[SP_PARAMETRIC_JET] = {in[0], y,    z,    one,  zero, zero, zero, p,     v * p,
                                          zero,  zero, zero, zero, zero, zero, zero, slope, p + v * slope};
        for (int j = 0; j < values; j++)
            out[j] = jet[j];
    }
}

/* An integral of |p| sqrt(1 + v^2) where p has one sign. */
static double integral(double v) {
    double s = A * A + B * B, q = A * A * B * B, w = 1 + v * v;
    return w * sqrt(w) * (w * w / 7 - (2 + s) * w / 5 + (1 + s + q) / 3);
}

/* The length along v between two places, and how many cusps are in between. */
static double pleated_distance(double from, double to, int *cusps) {
    const double all[] = {-B, -A, 0, A, B};
    double sum = 0;
    *cusps = 0;
    for (int i = 0; i < 5; i++) {
        if (all[i] <= from || all[i] >= to) continue;
        sum += fabs(integral(all[i]) - integral(from)), from = all[i], ++*cusps;
    }
    return sum + fabs(integral(to) - integral(from));
}

COMPILED(wavy, SP_PARAMETRIC_JET, SP_PARAMETRIC_VALUES)
COMPILED(valley, SP_PARAMETRIC_JET, SP_PARAMETRIC_VALUES)
COMPILED(upright, SP_PARAMETRIC_JET, SP_PARAMETRIC_VALUES)
COMPILED(ellipsoid, SP_PARAMETRIC_JET, SP_PARAMETRIC_VALUES)
COMPILED(quadric, SP_IMPLICIT_JET, SP_IMPLICIT_VALUES)
COMPILED(pleated, SP_PARAMETRIC_JET, SP_PARAMETRIC_VALUES)

static const struct sp_surface edge_of_valley = {valley_jet, valley_value, SP_PARAMETRIC, 0, {-2, -2}, {2, 2}, 0};
static const struct sp_surface strip = {wavy_jet, wavy_value, SP_PARAMETRIC, 0, {-4, -0.3}, {10, 0.3}, 0};
static const struct sp_surface corner = {funnel_jet, NULL, SP_PARAMETRIC, SP_TENSOR, {0.01, 0.01}, {1, 1}, 0};
static const struct sp_surface sector = {
    globe_jet, globe_value, SP_PARAMETRIC, 0, {0, -1.57079632679489661923}, {4, 1.57079632679489661923}, 0};
static const struct sp_surface upright_globe = {
    upright_jet, upright_value, SP_PARAMETRIC, 0, {-1.57079632679489661923, -INFINITY}, {1.57079632679489661923, INFINITY}, 0};
static const struct sp_surface ellipsoid_surface = {
    ellipsoid_jet, ellipsoid_value, SP_PARAMETRIC, 0, {-INFINITY, -1.57079632679489661923}, {INFINITY, 1.57079632679489661923}, 0};
static const struct sp_surface quadric_surface = {quadric_jet, quadric_value, SP_IMPLICIT, 0, {0, 0}, {0, 0}, 4};
static const struct sp_surface pleats = {pleated_jet, pleated_value, SP_PARAMETRIC, 0, {-2, -1}, {2, 1}, 0};

static struct sp_arena arena;

static struct sp_result solve(const struct sp_surface *surface, struct sp_request request, struct sp_options options) {
    struct sp_result result;
    sp_solve_path(surface, &request, &options, &arena, &result);
    return result;
}

static struct sp_options options_of(double tolerance) {
    struct sp_options options;
    sp_default_options(&options);
    options.tolerance = tolerance;
    return options;
}

/* With fewer steps no path is shorter than the shortest, beyond the error it admits; with less memory there is none, or the same. */
static void check_starved(const char *name, const struct sp_surface *surface, struct sp_request request, double length) {
    struct sp_options options = options_of(1e-9);
    size_t enough = (size_t)sp_solve_bytes(surface, &options, 0) & ~(size_t)15;
    arena.size = enough;
    struct sp_result all = solve(surface, request, options);
    double whole = all.length;
    CHECK(all.status == SP_CONVERGED && fabs(whole - length) <= 1e-9 * length, "%s: the promised memory: status %d", name, all.status);
    for (options.max_iterations = 0; options.max_iterations <= STEPS; options.max_iterations++) {
        struct sp_result result = solve(surface, request, options);
        CHECK(result.iterations <= options.max_iterations, "%s: %d steps of %d", name, result.iterations, options.max_iterations);
        CHECK(result.status < 0 ? !result.points : result.length >= length - result.length_error - 1e-9 * length,
              "%s: %d steps: status %d, length %.17g", name, options.max_iterations, result.status, result.length);
    }
    options = options_of(1e-9);
    for (size_t i = 0; i < SIZES; i++) {
        arena.size = enough * i / SIZES & ~(size_t)15;
        struct sp_result result = solve(surface, request, options);
        CHECK(result.status < 0 ? !result.points && isnan(result.length) : result.length == whole,
              "%s: %zu of %zu bytes: status %d, length %.17g", name, arena.size, enough, result.status, result.length);
    }
    arena.size = enough;
}

static void check_length(const char *name, struct sp_result result, double length, double tolerance) {
    CHECK(result.status == SP_CONVERGED, "%s: status %d", name, result.status);
    CHECK(fabs(result.length - length) <= tolerance * length, "%s: length %.17g, not %.17g", name, result.length, length);
    CHECK(fabs(result.length - length) <= result.length_error + 4e-15 * length, "%s: error %g, said %g", name, result.length - length,
          result.length_error);
}

/* A taut string from (0, 0) to (2 pi, 0) between y = sin x - 0.3 and sin x + 0.3: straight to the lower wave, along its crest, straight
 * through (pi, 0) to the upper one, and the same upside down. Each bend is symmetric about its crest. */
static double taut_length(void) {
    double low = 0.1, high = PI / 2, arc = 0;
    for (int i = 0; i < 200; i++) {
        double t = 0.5 * (low + high);
        if (cos(t) * t > sin(t) - 0.3)
            low = t;
        else
            high = t;
    }
    /* Simpson's rule over the crest. */
    for (int i = 0, panels = 2000; i <= panels; i++) {
        double x = low + (PI - 2 * low) * i / panels;
        arc += (i % panels == 0 ? 1 : i % 2 ? 4 : 2) * sqrt(1 + cos(x) * cos(x)) * (PI - 2 * low) / panels / 3;
    }
    return 2 * (arc + 2 * hypot(low, sin(low) - 0.3));
}

static void test_walls(void) {
    struct sp_request request = {.from = {0, 0, 0}, .to = {2 * PI, 0, 0}};
    for (double tolerance = 1e-4; tolerance > 1e-13; tolerance *= 1e-4) {
        struct sp_result result = solve(&strip, request, options_of(tolerance));
        check_length("strip", result, taut_length(), tolerance);
        CHECK(result.touches_boundary == 1, "touches no wall");
    }
    check_starved("strip", &strip, request, taut_length());
}

/* Round a corner in which length is nearly nothing there is no arc between the edges: chords, which say how far they are off. The shortest
 * path cuts the corner: it is a little less than both edges, 2 (r^3/3 + r/10^4) from r = 0.01 to 1, by less than the edges inside 0.04. */
static void test_corner(void) {
    struct sp_request request = {.from = {1, 0.01, 0}, .to = {0.01, 1, 0}};
    struct sp_result result = solve(&corner, request, options_of(1e-9));
    double edges = 2 * ((1 - 1e-6) / 3 + 0.99e-4), inside = 2 * ((64e-6 - 1e-6) / 3 + 0.03e-4);
    CHECK(result.status == SP_TOLERANCE_NOT_MET && result.touches_boundary == 1, "status %d", result.status);
    CHECK(result.length - result.length_error <= edges && result.length + result.length_error >= edges - inside,
          "length %.12g +- %g, not %.12g", result.length, result.length_error, edges);
}

static void test_poles(void) {
    const double turns[] = {PI, -PI, 3 * PI};
    for (int i = 0; i < 3; i++) {
        struct sp_request north = {.from = {0.3, 1.3}, .to = {0.3 + turns[i], 1.2}, .passage = {SP_OVER_POINT, 3, 0, 2 * PI}};
        struct sp_request south = {.from = {0.3, -1.3}, .to = {0.3 + turns[i], -1.2}, .passage = {SP_OVER_POINT, 2, 0, 2 * PI}};
        struct sp_request upright_north = {.from = {1.3, 0.3}, .to = {1.2, 0.3 + turns[i]}, .passage = {SP_OVER_POINT, 1, 0, 2 * PI}};
        check_length("north", solve(&whole_globe_surface, north, options_of(1e-9)), PI - 2.5, 1e-9);
        check_length("south", solve(&whole_globe_surface, south, options_of(1e-9)), PI - 2.5, 1e-9);
        check_length("upright", solve(&upright_globe, upright_north, options_of(1e-9)), PI - 2.5, 1e-9);
    }
    struct sp_request over = {.from = {0.3, 1.3}, .to = {0.3 + PI, 1.2}, .passage = {SP_OVER_POINT, 3, 0, 2 * PI}};
    check_starved("pole", &whole_globe_surface, over, PI - 2.5);
    /* Between walls a path over the pole is the shortest from half a turn on; else it has a corner that is shorter cut. */
    for (double apart = 0.5; apart < 3.9; apart += 0.3) {
        struct sp_result result =
            solve(&sector, (struct sp_request){.from = {0.05, 1.3}, .to = {0.05 + apart, 1.2}, .passage = {SP_OVER_POINT, 3, 0, 0}},
                  options_of(1e-9));
        CHECK(result.status == (apart >= PI ? SP_CONVERGED : SP_STALLED), "%g apart: status %d", apart, result.status);
        CHECK(fabs(result.length - (PI - 2.5)) <= 1e-9, "%g apart: length %.17g", apart, result.length);
    }
}

/* Past the end of a globe that is cut off: along a great circle, or one that touches the parallel at the cut, along that, and away.
 * `apart`: radians. */
static double past_cut(double radius, const double to_middle[2], double apart) {
    double length = 0, turned = 0, a = to_middle[0], b = to_middle[1];
    for (int i = 0; i < 2; i++)
        length += acos(cos(to_middle[i]) / cos(radius)), turned += acos(tan(radius) / tan(to_middle[i]));
    return apart > turned ? length + (apart - turned) * sin(radius) : acos(cos(a) * cos(b) + sin(a) * sin(b) * cos(apart));
}

static void test_holes(void) {
    const double radii[] = {0.05, 1e-3, 1e-6, 1e-9};
    struct sp_surface cut = whole_globe_surface;
    for (int i = 0; i < 4; i++)
        for (double apart = -3.9; apart < 4; apart += 0.6) {
            double radius = radii[i], end = PI / 2 - radius, to_middle[2] = {PI / 2 - 1.2, PI / 2 - 0.3};
            double length = past_cut(radius, to_middle, fabs(apart));
            cut.lower[1] = -end, cut.upper[1] = end;
            for (int side = -1; side <= 1; side += 2) {
                struct sp_request around = {
                    .from = {0.3, side * 1.2}, .to = {0.3 + apart, side * 0.3}, .passage = {SP_BESIDE_POINT, side > 0 ? 3 : 2, radius, 0}};
                check_length("around a hole, or past it", solve(&cut, around, options_of(1e-9)), length, 1e-9);
            }
        }
    cut.lower[1] = -PI / 2 + 1e-3, cut.upper[1] = PI / 2 - 1e-3;
    struct sp_request around = {.from = {0.3, 1.2}, .to = {4, 0.3}, .passage = {SP_BESIDE_POINT, 3, 1e-3, 0}};
    check_starved("hole", &cut, around, past_cut(1e-3, (double[2]){PI / 2 - 1.2, PI / 2 - 0.3}, 3.7));
    /* The same cut, over its middle, and in the chart around that. */
    struct sp_request over = {.from = {0.3, 1.2}, .to = {0.3 + PI, 1.1}, .passage = {SP_OVER_POINT, 3, 1e-3, 2 * PI}},
                      beside = {.from = {0.3, 1.2}, .to = {2.3, 0.3}, .passage = {SP_POINT_CHART, 3, 1e-3, 2 * PI}};
    check_length("over a hole", solve(&cut, over, options_of(1e-9)), PI - 2.3, 1e-9);
    check_length("past a hole", solve(&cut, beside, options_of(1e-9)), acos(sin(1.2) * sin(0.3) + cos(1.2) * cos(0.3) * cos(2)), 1e-9);
    /* Half a turn apart, but for what lets the great circle pass the middle by half the hole's radius, between two nodes. */
    double off = 0.5e-3 * (1 / tan(PI / 2 - 1.2) + 1 / tan(PI / 2 - 0.3));
    struct sp_request through = {.from = {0.3, 1.2}, .to = {0.3 + PI - off, 0.3}, .passage = {SP_POINT_CHART, 3, 1e-3, 2 * PI}};
    CHECK(solve(&cut, through, options_of(1e-9)).status == SP_SINGULAR_METRIC, "through a hole");
}

/* Where longitude is no polar angle a path that arrives straight turns, in the chart, on its way to the pole. Between places opposite to
 * each other it goes on in the opposite direction; else it would have to turn there, and is no geodesic. */
static void test_turning(void) {
    for (double u = 0.1; u < 3; u += 0.4)
        for (double v = 0.3; v < 1.5; v += 0.4) {
            struct sp_request over = {.from = {u, v}, .to = {u + PI, v}, .passage = {SP_OVER_POINT, 3, 0, 2 * PI}},
                              turned = {.from = {u, v}, .to = {u + PI, v + 0.1}, .passage = {SP_OVER_POINT, 3, 0, 2 * PI}};
            struct sp_request around = {0};
            double place[3] = {AXES[0] * cos(v) * cos(u), AXES[1] * cos(v) * sin(u), AXES[2] * sin(v)};
            double start[9] = {place[0], place[1], place[2], 0, 0, AXES[2], -place[0], -place[1], place[2]};
            around.start = start, around.start_count = 3;
            memcpy(around.from, start, sizeof place), memcpy(around.to, start + 6, sizeof place);
            struct sp_result in_space = solve(&quadric_surface, around, options_of(1e-12));
            CHECK(in_space.status == SP_CONVERGED || in_space.status == SP_SADDLE, "(%g, %g): status %d", u, v, in_space.status);
            for (double tolerance = 1e-6; tolerance > 1e-13; tolerance *= 1e-3)
                check_length("ellipsoid", solve(&ellipsoid_surface, over, options_of(tolerance)), in_space.length, tolerance);
            ellipsoid_pairs = 0;
            int32_t status = solve(&ellipsoid_surface, turned, options_of(1e-9)).status;
            CHECK(status == SP_STALLED, "(%g, %g) turned: status %d", u, v, status);
            /* Two or three rounds, each to the last rung; 28,576 at most were measured. */
            CHECK(ellipsoid_pairs < 35000, "(%g, %g): %d pairs evaluated", u, v, ellipsoid_pairs);
        }
}

/* Along an edge where rounding of a coordinate changes lengths by 5e-14, and points by 1e-11 of what they are apart: the length is right
 * all the same, by many panels, and points take few, 25,309 pairs in all, where it was 2,055,118. */
static void test_fine_edge(void) {
    const double from = -1.4077572524498445, to = -1.4108934059987148;
    struct sp_request along = {.from = {from, 2, 0}, .to = {to, 2, 0}};
    long double length = 0;
    enum { STEPS_OF_SUM = 100000 };
    for (int i = 0; i < STEPS_OF_SUM; i++) {
        long double u = from + ((long double)to - from) * (i + 0.5L) / STEPS_OF_SUM, slope = 400 * u * (u * u - 2);
        length += sqrtl(1 + slope * slope) * fabsl((long double)to - from) / STEPS_OF_SUM;
    }
    valley_pairs = 0;
    struct sp_options options = options_of(1e-9);
    options.point_count = 127;
    check_length("edge of the valley", solve(&edge_of_valley, along, options), (double)length, 1e-11);
    CHECK(valley_pairs < 30000, "along an edge: %d pairs evaluated", valley_pairs);
}

/* Across all five cusps a path is the closed form's. Between two cusps arcs had begun on the wrong side of one, and stayed there, 3e-6 to
 * 3e-5 too long. */
static void test_cusps(void) {
    int solved[6] = {0}, cusps;
    uint64_t seed = 5;
    for (int i = 0; i < 240; i++) {
        double u = 2 * random_unit(&seed) - 1, v = 2 * random_unit(&seed) - 1, to_u = 2 * random_unit(&seed) - 1;
        double to_v = v + (1 - v) * random_unit(&seed), length = hypot(to_u - u, pleated_distance(v, to_v, &cusps));
        double tolerance = i % 3 == 0 ? 1e-4 : i % 3 == 1 ? 1e-9 : 1e-12;
        struct sp_result result = solve(&pleats, (struct sp_request){.from = {u, v, 0}, .to = {to_u, to_v, 0}}, options_of(tolerance));
        solved[cusps]++;
        CHECK(result.status == SP_CONVERGED, "(%.17g, %.17g) to (%.17g, %.17g), %d cusps: status %d", u, v, to_u, to_v, cusps,
              result.status);
        CHECK(result.crosses_singularity == (cusps > 0), "%d cusps: %d", cusps, result.crosses_singularity);
        double error = fabs(result.length - length);
        CHECK(error <= 2 * result.length_error + 4e-15 * length && error <= tolerance * length,
              "(%.17g, %.17g) to (%.17g, %.17g): error %g, said %g", u, v, to_u, to_v, error, result.length_error);
    }
    for (cusps = 0; cusps < 6; cusps++)
        CHECK(solved[cusps] > 0, "no path across %d cusps", cusps);
    /* An end 1e-2 to 1e-5 beside a cusp that the path crosses: its arc there is a millionth of the path. */
    for (int i = 0; i < 60; i++) {
        double off = pow(10, -2 - 3 * random_unit(&seed)), u = random_unit(&seed), to_u = u + 0.5 * random_unit(&seed);
        double v = (i % 2 ? 0 : -A) - off, to_v = v + off + 0.05 + 0.3 * random_unit(&seed);
        double length = hypot(to_u - u, pleated_distance(v, to_v, &cusps));
        struct sp_result result = solve(&pleats, (struct sp_request){.from = {u, v, 0}, .to = {to_u, to_v, 0}}, options_of(1e-9));
        CHECK(result.status == SP_CONVERGED && result.crosses_singularity, "(%.17g, %.17g) to (%.17g, %.17g): status %d", u, v, to_u, to_v,
              result.status);
        CHECK(fabs(result.length - length) <= 1e-9 * length, "(%.17g, %.17g) to (%.17g, %.17g): error %g", u, v, to_u, to_v,
              result.length - length);
    }
    struct sp_request all = {.from = {-0.9, -0.9, 0}, .to = {0.8, 0.95, 0}};
    double length = hypot(1.7, pleated_distance(-0.9, 0.95, &cusps));
    check_length("five cusps", solve(&pleats, all, options_of(1e-9)), length, 1e-9);
    check_starved("five cusps", &pleats, all, length);
}

int main(void) {
    arena = (struct sp_arena){aligned_alloc(16, 1 << 24), 1 << 24, 0};
    test_walls();
    test_corner();
    test_poles();
    arena.size = 1 << 24;
    test_holes();
    arena.size = 1 << 24;
    test_turning();
    arena.size = 1 << 24;
    test_cusps();
    test_fine_edge();
    free(arena.base);
    return checks_failed();
}
