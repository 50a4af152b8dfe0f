/* Traced geodesics: the integrator's orders, closed forms on both kinds of surface, conjugate points, walls, singular points, hostile
 * input.
 */
#include "dop853.h"
#include "surfaces.h"
#include "surfpath.h"
#include "testing.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double PI = 3.141592653589793;
static struct sp_arena arena;

/* A length that no one can go takes as many steps as it is given. */
#define MOST_STEPS 3000
#define FAR 1e6

static struct sp_trace_result trace(const struct sp_surface *surface, struct sp_trace_request request, double tolerance, int32_t points) {
    struct sp_trace_options options;
    struct sp_trace_result result;
    sp_default_trace_options(&options);
    options.tolerance = tolerance, options.point_count = points;
    if (!(request.length < FAR)) options.max_steps = MOST_STEPS;
    sp_trace_path(surface, &request, &options, &arena, &result);
    return result;
}

/* Infinite where there is no path. */
static double distance(const double *a, const double *b) {
    return a && b ? sqrt(pow(a[0] - b[0], 2) + pow(a[1] - b[1], 2) + pow(a[2] - b[2], 2)) : (double)INFINITY;
}
static const double *end_of(const struct sp_trace_result *result, int32_t points) {
    return result->points ? result->points + 3 * (points + 1) : NULL;
}

/* Surfaces of revolution (r cos u, r sin u, z) of a profile r(v), z(v) and its derivatives. */
static void write_revolution(sp_pair u, sp_pair r, sp_pair r1, sp_pair r2, sp_pair z, sp_pair z1, sp_pair z2, int values, sp_pair *out) {
    sp_pair c, s = sp_sincos(u, &c), zero = sp_splat(0.0);
    sp_pair jet[SP_PARAMETRIC_JET] = {r * c,  r * s,  z,    -r * s,  r * c,  zero, r1 * c, r1 * s, z1,
                                      -r * c, -r * s, zero, -r1 * s, r1 * c, zero, r2 * c, r2 * s, z2};
    for (int j = 0; j < values; j++)
        out[j] = jet[j];
}

static double size = 1; /* of the ring and the cylinder */

/* The paper's torus, Eq. 46, as a chart. */
static void ring(int32_t count, const sp_pair *in, sp_pair *out, int values) {
    for (; count > 0; count--, in += 2, out += values) {
        sp_pair c, s = sp_sincos(in[1], &c), a = sp_splat(1.5 * size), r = 4 * size + a * c;
        write_revolution(in[0], r, -a * s, -a * c, a * s, a * c, -a * s, values, out);
    }
}

static void cylinder(int32_t count, const sp_pair *in, sp_pair *out, int values) {
    sp_pair one = sp_splat(1.0), zero = sp_splat(0.0);
    for (; count > 0; count--, in += 2, out += values)
        write_revolution(in[0], 2 * size * one, zero, zero, in[1], one, zero, values, out);
}

static void catenoid(int32_t count, const sp_pair *in, sp_pair *out, int values) {
    for (; count > 0; count--, in += 2, out += values)
        write_revolution(in[0], sp_cosh(in[1]), sp_sinh(in[1]), sp_cosh(in[1]), in[1], sp_splat(1.0), sp_splat(0.0), values, out);
}

static void paraboloid(int32_t count, const sp_pair *in, sp_pair *out, int values) {
    for (; count > 0; count--, in += 2, out += values) {
        sp_pair u = in[0], v = in[1], two = sp_splat(2.0);
        sp_pair h[6] = {u * u + v * v, 2.0 * u, 2.0 * v, two, sp_splat(0.0), two};
        write_height(u, v, h, values, out);
    }
}

/* z = (1 - u)^(5/2): smooth up to the edge u = 1, NaN beyond. */
static void ends_at_edge(int32_t count, const sp_pair *in, sp_pair *out, int values) {
    for (; count > 0; count--, in += 2, out += values) {
        sp_pair t = 1.0 - in[0], root = sp_square_root(t), zero = sp_splat(0.0);
        sp_pair h[6] = {t * t * root, -2.5 * t * root, zero, 3.75 * root, zero, zero};
        write_height(in[0], in[1], h, values, out);
    }
}

/* The plane with x = u^3: S_u vanishes at u = 0 without changing its direction. */
static void cubic_plane(int32_t count, const sp_pair *in, sp_pair *out, int values) {
    for (; count > 0; count--, in += 2, out += values) {
        sp_pair u = in[0], zero = sp_splat(0.0), one = sp_splat(1.0);
        sp_pair jet[SP_PARAMETRIC_JET] = {u * u * u, in[1], zero, 3.0 * u * u, zero, zero, zero, one, zero, 6.0 * u};
        for (int j = 10; j < SP_PARAMETRIC_JET; j++)
            jet[j] = zero;
        for (int j = 0; j < values; j++)
            out[j] = jet[j];
    }
}

/* x^2 + y^2 = z^2, of which grad f vanishes at the apex. */
static void cone(int32_t count, const sp_pair *in, sp_pair *out, int values) {
    for (; count > 0; count--, in += 3, out += values) {
        sp_pair x = in[0], y = in[1], z = in[2], two = sp_splat(2.0), zero = sp_splat(0.0);
        sp_pair jet[SP_IMPLICIT_JET] = {x * x + y * y - z * z, 2.0 * x, 2.0 * y, -2.0 * z, two, zero, zero, two, zero, -two};
        for (int j = 0; j < values; j++)
            out[j] = jet[j];
    }
}

COMPILED(ring, SP_PARAMETRIC_JET, SP_PARAMETRIC_VALUES)
COMPILED(cylinder, SP_PARAMETRIC_JET, SP_PARAMETRIC_VALUES)
COMPILED(catenoid, SP_PARAMETRIC_JET, SP_PARAMETRIC_VALUES)
COMPILED(paraboloid, SP_PARAMETRIC_JET, SP_PARAMETRIC_VALUES)
COMPILED(ends_at_edge, SP_PARAMETRIC_JET, SP_PARAMETRIC_VALUES)
COMPILED(cubic_plane, SP_PARAMETRIC_JET, SP_PARAMETRIC_VALUES)
COMPILED(cone, SP_IMPLICIT_JET, SP_IMPLICIT_VALUES)

#define CHART(name, u0, v0, u1, v1)                                                                                                        \
    { name##_jet, name##_value, SP_PARAMETRIC, 0, {u0, v0}, {u1, v1}, 0 }
static const struct sp_surface ring_surface = CHART(ring, -INFINITY, -INFINITY, INFINITY, INFINITY);
static const struct sp_surface cylinder_surface = CHART(cylinder, -INFINITY, -1e9, INFINITY, 1e9);
static const struct sp_surface catenoid_surface = CHART(catenoid, -INFINITY, -5, INFINITY, 5);
static const struct sp_surface paraboloid_surface = CHART(paraboloid, -9, -9, 9, 9);
static const struct sp_surface ends_at_edge_surface = CHART(ends_at_edge, 0, -1, 1, 1);
static const struct sp_surface cubic_plane_surface = CHART(cubic_plane, -1, -1, 1, 1);
static const struct sp_surface overlapping_globe_surface = CHART(globe, -INFINITY, -3, INFINITY, 3);
static const struct sp_surface cone_surface = {cone_jet, cone_value, SP_IMPLICIT, 0, {0, 0}, {0, 0}, 4};

/* y'' = -y: a step of h and its polynomial against sine and cosine. */
static void rotation(const void *context, const double *state, double *slope) {
    (void)context;
    for (int i = 0; i < SP_STATE; i += 2)
        slope[i] = state[i + 1], slope[i + 1] = -state[i];
}

static void errors_of_step(double h, double *end, double *inside) {
    struct sp_ode ode = {rotation, NULL};
    struct sp_stages stages;
    struct sp_dense dense;
    double state[SP_STATE], next[SP_STATE], between[SP_STATE];
    for (int i = 0; i < SP_STATE; i += 2)
        state[i] = sin(0.3), state[i + 1] = cos(0.3);
    rotation(NULL, state, stages.slope[0]);
    sp_dop853_step(&ode, state, h, &stages, next);
    sp_dop853_dense(&ode, state, h, &stages, next, &dense);
    *end = fabs(next[0] - sin(0.3 + h)), *inside = 0;
    for (double part = 0; part <= 1; part += 1.0 / 64) {
        sp_dop853_between(&dense, part, between);
        *inside = fmax(*inside, fabs(between[0] - sin(0.3 + part * h)));
    }
}

/* The local error falls like h^9, that of the polynomial like h^8. */
static void check_orders(void) {
    double end[2], inside[2];
    errors_of_step(0.8, end, inside);
    errors_of_step(0.4, end + 1, inside + 1);
    CHECK(log2(end[0] / end[1]) > 8.5, "order %g", log2(end[0] / end[1]));
    CHECK(log2(inside[0] / inside[1]) > 7.5, "order %g", log2(inside[0] / inside[1]));
    CHECK(inside[1] < 1e-9 && end[1] < 1e-10, "errors %g, %g", inside[1], end[1]);
}

/* y_i = t^i: y_1 is the time. */
static void powers(const void *context, const double *state, double *slope) {
    (void)context;
    slope[0] = 0, slope[1] = 1;
    for (int i = 2; i < SP_STATE; i++)
        slope[i] = i * pow(state[1], i - 1);
}

/* Exact for t^i up to its order, but for rounding of coefficients up to 43: no digit of the tables is wrong by more. */
static void check_powers(void) {
    struct sp_ode ode = {powers, NULL};
    struct sp_stages stages;
    struct sp_dense dense;
    double state[SP_STATE] = {1}, next[SP_STATE], between[SP_STATE], fifth[SP_STATE], third[SP_STATE];
    powers(NULL, state, stages.slope[0]);
    sp_dop853_step(&ode, state, 1, &stages, next);
    sp_dop853_errors(&stages, fifth, third);
    sp_dop853_dense(&ode, state, 1, &stages, next, &dense);
    for (int i = 1; i <= 8; i++) {
        CHECK(fabs(next[i] - 1) < 3e-14, "t^%d: off by %g", i, next[i] - 1);
        CHECK(i > 5 || fabs(fifth[i]) < 3e-14, "t^%d: fifth order estimate %g", i, fifth[i]);
        CHECK(i > 3 || fabs(third[i]) < 3e-14, "t^%d: third order estimate %g", i, third[i]);
    }
    for (double part = 0; part <= 1; part += 1.0 / 64) {
        sp_dop853_between(&dense, part, between);
        for (int i = 1; i <= 7; i++)
            CHECK(fabs(between[i] - pow(part, i)) < 1e-13, "t^%d at %g: off by %g", i, part, between[i] - pow(part, i));
    }
}

/* Every point against a great circle of radius 1: from p along the unit vector t. */
static void check_circle(const struct sp_surface *surface, struct sp_trace_request request, const double p[3], const double t[3]) {
    struct sp_trace_result result = trace(surface, request, 1e-13, 37);
    CHECK(result.status == SP_CONVERGED && result.length == request.length, "status %d, length %g", result.status, result.length);
    for (int i = 0; result.points && i <= 38; i++) {
        double angle = request.length * i / 38, exact[3];
        for (int j = 0; j < 3; j++)
            exact[j] = cos(angle) * p[j] + sin(angle) * t[j];
        CHECK(distance(exact, result.points + 3 * i) < 1e-12 * (1 + request.length), "point %d: off by %g", i,
              distance(exact, result.points + 3 * i));
    }
    if (request.length < PI)
        CHECK(isnan(result.conjugate), "conjugate at %.17g", result.conjugate);
    else
        CHECK(fabs(result.conjugate - PI) < 1e-12, "conjugate at %.17g", result.conjugate);
}

static void check_spheres(void) {
    double u = 0.4, v = 0.7, along = 0.6, up = 0.8;
    double p[3] = {cos(v) * cos(u), cos(v) * sin(u), sin(v)};
    double t[3] = {-along * sin(u) - up * sin(v) * cos(u), along * cos(u) - up * sin(v) * sin(u), up * cos(v)};
    double lengths[] = {0.1, 1, 3, 3.5, 6.5, 40};
    for (int i = 0; i < 6; i++) {
        struct sp_trace_request chart = {{u, v, 0}, {7 * along / cos(v), 7 * up, 0}, lengths[i]};
        struct sp_trace_request space = {{p[0], p[1], p[2]}, {t[0] + 3 * p[0], t[1] + 3 * p[1], t[2] + 3 * p[2]}, lengths[i]};
        check_circle(&whole_globe_surface, chart, p, t);
        check_circle(&sphere_surface, space, p, t);
    }
}

/* Half the tolerance, half the error, give or take: so it is over ten orders of magnitude. lengthError bounds the error in each. */
static void check_tolerance(void) {
    struct sp_trace_request request = {{0.2, 0.1, 0}, {0.3, 1, 0}, 20};
    struct sp_trace_result fine = trace(&ring_surface, request, 1e-14, 1);
    double exact[3], before = INFINITY;
    memcpy(exact, end_of(&fine, 1), sizeof exact);
    for (double tolerance = 1e-4; tolerance > 1e-13; tolerance *= 0.01) {
        struct sp_trace_result result = trace(&ring_surface, request, tolerance, 1);
        double error = distance(exact, end_of(&result, 1));
        CHECK(error < 0.2 * before && error < 20 * tolerance, "tolerance %g: error %g, before %g", tolerance, error, before);
        CHECK(error <= result.length_error && result.length_error < 1e4 * tolerance, "tolerance %g: error %g, estimate %g", tolerance,
              error, result.length_error);
        before = error;
    }
}

static void check_helix(void) {
    double exact[3], slope = 0.75;
    struct sp_trace_request request = {{0.5, -1, 0}, {slope, 1, 0}, 100};
    struct sp_trace_result result = trace(&cylinder_surface, request, 1e-12, 10);
    for (int i = 0; i <= 11; i++) {
        double up = 100.0 * i / 11 / sqrt(1 + 4 * slope * slope), u = 0.5 + slope * up;
        exact[0] = 2 * cos(u), exact[1] = 2 * sin(u), exact[2] = up - 1;
        CHECK(distance(exact, result.points + 3 * i) < 1e-11, "off by %g", distance(exact, result.points + 3 * i));
        CHECK(fabs(result.parameters[2 * i] - u) < 1e-11, "u %g, not %g", result.parameters[2 * i], u);
    }
    CHECK(result.status == SP_CONVERGED && isnan(result.conjugate), "status %d, conjugate %g", result.status, result.conjugate);
}

/* Simpson's rule. */
static double integrate(double (*f)(double, double), double c, double end) {
    double sum = f(c, 0) + f(c, end);
    for (int i = 1; i < 4000; i++)
        sum += (i % 2 ? 4 : 2) * f(c, end * i / 4000);
    return sum * end / 12000;
}

/* From Clairaut's relation, on the paraboloid in t = sqrt(r^2 - c^2), from the point nearest to the apex on. */
static double paraboloid_length(double c, double t) { return sqrt(1 + 4 * (c * c + t * t)); }
static double paraboloid_angle(double c, double t) { return c * sqrt(1 + 4 * (c * c + t * t)) / (c * c + t * t); }

/* On the catenoid in v, for c < 1, through the neck. */
static double catenoid_length(double c, double v) { return cosh(v) * cosh(v) / sqrt(cosh(v) * cosh(v) - c * c); }
static double catenoid_angle(double c, double v) { return c / sqrt(cosh(v) * cosh(v) - c * c); }

static void check_clairaut(void) {
    double c = 0.4, t = 2.5, angle = integrate(paraboloid_angle, c, t), r = sqrt(c * c + t * t);
    struct sp_trace_request request = {{c, 0, 0}, {0, 1, 0}, integrate(paraboloid_length, c, t)};
    struct sp_trace_result result = trace(&paraboloid_surface, request, 1e-13, 5);
    double exact[3] = {r * cos(angle), r * sin(angle), r * r};
    CHECK(distance(exact, end_of(&result, 5)) < 1e-11, "paraboloid: off by %g", distance(exact, end_of(&result, 5)));
    double sine = 0.7, v = 3;
    struct sp_trace_request through = {{0, 0, 0}, {sine, sqrt(1 - sine * sine), 0}, integrate(catenoid_length, sine, v)};
    result = trace(&catenoid_surface, through, 1e-13, 5);
    CHECK(fabs(result.parameters[12] - integrate(catenoid_angle, sine, v)) < 1e-11 && fabs(result.parameters[13] - v) < 1e-11,
          "catenoid: %.15g %.15g", result.parameters[12], result.parameters[13]);
    CHECK(isnan(result.conjugate), "catenoid: conjugate %g", result.conjugate);
}

/* r times the cosine of the angle to the parallel, by central differences of the points: constant along 50 lengths of the torus. */
static void check_torus(void) {
    struct sp_trace_request request = {{0.2, 0.1, 0}, {0.25, 0.4, 0}, 1000};
    double first = 0, worst = 0;
    int32_t count = 100000;
    struct sp_trace_result result = trace(&ring_surface, request, 1e-12, count);
    CHECK(result.status == SP_CONVERGED, "status %d", result.status);
    double step = 1000.0 / (count + 1);
    for (int32_t i = 4; i < count - 3; i += 97) {
        const double *u = result.parameters + 2 * i;
        double slope = (672 * (u[2] - u[-2]) - 168 * (u[4] - u[-4]) + 32 * (u[6] - u[-6]) - 3 * (u[8] - u[-8])) / (840 * step);
        double clairaut = pow(4 + 1.5 * cos(u[1]), 2) * slope;
        if (i == 4) first = clairaut;
        worst = fmax(worst, fabs(clairaut - first));
    }
    CHECK(worst < 1e-10 * 5.5, "Clairaut's constant wanders by %g", worst);
}

/* The chart of the torus and its equation: the same path and the same conjugate point. */
static void check_two_forms(void) {
    struct sp_trace_request chart = {{0.2, 0.1, 0}, {0.25, 0.4, 0}, 30};
    struct sp_trace_result one = trace(&ring_surface, chart, 1e-13, 20);
    double points[66], conjugate = one.conjugate, du = 0.25 * (4 + 1.5 * cos(0.1)), dv = 0.4 * 1.5;
    memcpy(points, one.points, sizeof points);
    struct sp_trace_request space = {{points[0], points[1], points[2]},
                                     {-du * sin(0.2) - dv * sin(0.1) * cos(0.2), du * cos(0.2) - dv * sin(0.1) * sin(0.2), dv * cos(0.1)},
                                     30};
    struct sp_trace_result other = trace(&torus_surface, space, 1e-13, 20);
    for (int i = 0; i <= 21; i++)
        CHECK(distance(points + 3 * i, other.points + 3 * i) < 3e-11, "off by %g", distance(points + 3 * i, other.points + 3 * i));
    CHECK(fabs(conjugate - other.conjugate) < 1e-11, "conjugate %.15g, %.15g", conjugate, other.conjugate);
}

/* There and back again, on random geodesics. */
static void check_return(uint64_t *seed) {
    for (int i = 0; i < 100; i++) {
        double u = random_unit(seed), v = 6 * random_unit(seed), angle = 6.3 * random_unit(seed), length = 12 * random_unit(seed);
        struct sp_trace_request there = {{u, v, 0}, {cos(angle), sin(angle), 0}, length};
        struct sp_trace_result out = trace(&ring_surface, there, 1e-13, 100);
        const double *end = out.parameters + 2 * 101, *before = end - 2;
        struct sp_trace_request short_way = {{end[0], end[1], 0}, {before[0] - end[0], before[1] - end[1], 0}, length};
        double start[3];
        memcpy(start, out.points, sizeof start);
        struct sp_trace_result back = trace(&ring_surface, short_way, 1e-13, 1);
        double step = length / 101; /* the direction is a difference, exact to first order in the step */
        CHECK(distance(start, end_of(&back, 1)) < 3 * (step + step * length), "%d: off by %g", i, distance(start, end_of(&back, 1)));
    }
}

/* A surface a million times larger or smaller: the same path, scaled. */
static void check_scale(void) {
    struct sp_trace_request request = {{0.2, 0.1, 0}, {0.25, 0.4, 0}, 30};
    struct sp_trace_result one = trace(&ring_surface, request, 1e-12, 20);
    double points[66], conjugate = one.conjugate, sizes[] = {1e6, 1e-6};
    memcpy(points, one.points, sizeof points);
    int32_t steps = one.steps;
    for (int k = 0; k < 2; k++) {
        struct sp_trace_request scaled = request;
        size = sizes[k], scaled.length *= size;
        struct sp_trace_result other = trace(&ring_surface, scaled, 1e-12, 20);
        CHECK(other.steps == steps && fabs(other.conjugate / size - conjugate) < 1e-12, "%d steps, not %d", other.steps, steps);
        for (int i = 0; i < 66; i++)
            CHECK(fabs(other.points[i] / size - points[i]) < 1e-12, "off by %g", other.points[i] / size - points[i]);
    }
    size = 1;
}

/* Stops on the edge; what lies before is the path. */
static void check_edges(void) {
    struct sp_trace_request request = {{-0.5, -0.3, 0}, {1, 0.4, 0}, 1e6};
    struct sp_trace_result result = trace(&saddle_surface, request, 1e-12, 9);
    CHECK(result.status == SP_EDGE_REACHED && fabs(result.parameters[20] - 1) < 1e-14, "status %d, u = 1 - %g", result.status,
          1 - result.parameters[20]);
    double v = result.parameters[21], length = result.length;
    request.length = length;
    struct sp_surface open = saddle_surface;
    open.lower[0] = open.lower[1] = -INFINITY, open.upper[0] = open.upper[1] = INFINITY;
    result = trace(&open, request, 1e-14, 9);
    CHECK(fabs(result.parameters[20] - 1) < 1e-12 && fabs(result.parameters[21] - v) < 1e-12, "without walls u = 1 - %g, v off by %g",
          1 - result.parameters[20], result.parameters[21] - v);
    struct sp_trace_request outward = {{1, 0.2, 0}, {1, 0, 0}, 1}, inward = {{1, 0.2, 0}, {-1, 0, 0}, 1};
    result = trace(&saddle_surface, outward, 1e-12, 3);
    CHECK(result.status == SP_EDGE_REACHED && result.length == 0 && result.parameters[8] == 1, "outward: status %d", result.status);
    CHECK(trace(&saddle_surface, inward, 1e-12, 3).status == SP_CONVERGED, "inward");
    struct sp_trace_request to_nothing = {{0.2, 0, 0}, {1, 0.1, 0}, 5};
    result = trace(&ends_at_edge_surface, to_nothing, 1e-12, 3);
    CHECK(result.status == SP_EDGE_REACHED && fabs(result.parameters[8] - 1) < 1e-12, "no surface beyond: status %d, u = 1 - %g",
          result.status, 1 - result.parameters[8]);
}

/* A great circle that crosses the wall v = 1.5 by little, and comes back within one step: sin v = sin(top) sin s. */
static void check_grazing(void) {
    double tops[] = {1.5 + 1e-2, 1.5 + 1e-5, 1.5 + 1e-9, 1.5 - 1e-9};
    for (int k = 0; k < 4; k++)
        for (double tolerance = 1e-2; tolerance > 1e-13; tolerance *= 0.1) {
            struct sp_trace_request request = {{0, 0, 0}, {cos(tops[k]), sin(tops[k]), 0}, 3};
            struct sp_trace_result result = trace(&globe_surface, request, tolerance, 5);
            double exact = tops[k] > 1.5 ? asin(sin(1.5) / sin(tops[k])) : 3;
            enum sp_status status = tops[k] > 1.5 ? SP_EDGE_REACHED : SP_CONVERGED;
            double slack = 10 * sqrt(tolerance); /* the crossing is nearly a double root */
            if (fabs(tops[k] - 1.5) > 10 * tolerance)
                CHECK(result.status == (int32_t)status && fabs(result.length - exact) < slack,
                      "top 1.5 + %g, tolerance %g: status %d, %g not %g", tops[k] - 1.5, tolerance, result.status, result.length, exact);
        }
}

/* Past a pole as near as can be, onto it, and over it where the chart goes on. */
static void check_poles(void) {
    for (double miss = 1e-1; miss > 1e-9; miss *= 0.1) {
        struct sp_trace_request request = {{0, 0, 0}, {sin(miss), cos(miss), 0}, PI - 0.2};
        struct sp_trace_result result = trace(&whole_globe_surface, request, 1e-12, 50);
        double exact[3] = {cos(PI - 0.2), sin(0.2) * sin(miss), sin(0.2) * cos(miss)};
        double error = distance(exact, end_of(&result, 50));
        CHECK(result.status == SP_CONVERGED && error < 1e-11 + 1e-14 / miss, "miss %g: status %d, off by %g", miss, result.status, error);
        CHECK(error <= result.length_error && result.length_error < 1e-10 + 1e-12 / miss, "miss %g: off by %g, estimate %g", miss, error,
              result.length_error);
    }
    struct sp_trace_request meridian = {{0.3, 0, 0}, {0, 1, 0}, 3};
    struct sp_trace_result result = trace(&whole_globe_surface, meridian, 1e-12, 50);
    CHECK(result.status == SP_EDGE_REACHED && fabs(result.length - PI / 2) < 1e-12, "status %d, length %.15g", result.status,
          result.length);
    result = trace(&overlapping_globe_surface, meridian, 1e-12, 50);
    CHECK(result.status == SP_SINGULAR_METRIC && !result.points, "over the pole: status %d", result.status);
}

static void check_singular(void) {
    struct sp_trace_request into = {{0.5, 0, 0}, {-1, 0.3, 0}, 5}, to_apex = {{0.6, 0.8, 1}, {-0.6, -0.8, -1}, 5},
                            at_apex = {{0, 0, 0}, {1, 0, 0}, 1}, at_fold = {{0, 0, 0}, {0, 1, 0}, 1};
    CHECK(trace(&cubic_plane_surface, into, 1e-12, 3).status == SP_SINGULAR_METRIC, "cubic plane");
    CHECK(trace(&cubic_plane_surface, at_fold, 1e-12, 3).status == SP_SINGULAR_METRIC, "cubic plane, at the fold");
    CHECK(trace(&cone_surface, to_apex, 1e-12, 3).status == SP_SINGULAR_METRIC, "cone");
    CHECK(trace(&cone_surface, at_apex, 1e-12, 3).status == SP_SINGULAR_METRIC, "cone, at the apex");
    struct sp_trace_result normal = trace(&sphere_surface, (struct sp_trace_request){{1, 0, 0}, {2, 0, 0}, 1}, 1e-12, 3);
    CHECK(normal.status < 0 && normal.normal == 1, "normal direction: status %d", normal.status);
}

/* 100 turns round the torus, length 0, too few steps, and lengths that no one can go. */
static void check_extremes(void) {
    struct sp_trace_request request = {{0.2, 0.1, 0}, {0.25, 0.1, 0}, 3456}, still = request, far = request;
    struct sp_trace_result result = trace(&ring_surface, request, 1e-12, 5);
    CHECK(result.status == SP_CONVERGED && result.length_error < 1e-5, "status %d, error %g", result.status, result.length_error);
    still.length = 0;
    result = trace(&ring_surface, still, 1e-12, 5);
    for (int i = 0; i < 7; i++)
        CHECK(distance(result.points, result.points + 3 * i) == 0 && result.parameters[2 * i] == 0.2, "point %d moves", i);
    CHECK(result.status == SP_CONVERGED && result.length == 0, "status %d", result.status);
    struct sp_trace_options options = {1e-12, 5, 100};
    sp_trace_path(&ring_surface, &request, &options, &arena, &result);
    CHECK(result.status == SP_ITERATION_LIMIT && result.steps <= 100 && result.length > 1, "status %d, length %g", result.status,
          result.length);
    options.max_steps = MOST_STEPS;
    for (far.length = 1e10; far.length < 1e308; far.length *= 1e21) {
        sp_trace_path(&ring_surface, &far, &options, &arena, &result);
        CHECK(result.status == SP_ITERATION_LIMIT && result.length > 0, "length %g: status %d", far.length, result.status);
    }
    for (far.length = 1e-300; far.length < 1; far.length *= 1e7)
        CHECK(trace(&ring_surface, far, 1e-12, 5).status == SP_CONVERGED, "length %g", far.length);
}

/* The arena of exactly the promised size is enough; every smaller one is refused, or enough too. */
static void check_arena(const struct sp_surface *surface, struct sp_trace_request request) {
    struct sp_trace_options options = {1e-9, 7, 1000};
    size_t bytes = (size_t)sp_trace_bytes(surface->kind, &options);
    for (size_t given = 0; given <= bytes; given += 16) {
        struct sp_arena small = {aligned_alloc(16, given + 16), given, 0};
        struct sp_trace_result result;
        int32_t status = sp_trace_path(surface, &request, &options, &small, &result);
        CHECK(status == SP_CONVERGED || status == SP_OUT_OF_MEMORY, "size %zu: status %d", given, status);
        CHECK(given < bytes || status == SP_CONVERGED, "the promised size is not enough");
        CHECK(status == SP_CONVERGED || (!result.points && isnan(result.length)), "size %zu: a path without memory", given);
        free(small.base);
    }
}

/* Surfaces that return nothing usable, and numbers that are none: a status, never a trap or NaN called a path. */
static double hostile_number;
static void hostile(int32_t count, const sp_pair *in, sp_pair *out) {
    (void)in;
    for (int32_t i = 0; i < count * SP_PARAMETRIC_VALUES; i++)
        out[i] = sp_splat(hostile_number);
}
static void hostile_jet(int32_t count, const sp_pair *in, sp_pair *out) {
    (void)in;
    for (int32_t i = 0; i < count * SP_IMPLICIT_JET; i++)
        out[i] = sp_splat(hostile_number);
}
static void hostile_chart(int32_t count, const sp_pair *in, sp_pair *out) {
    (void)in;
    for (int32_t i = 0; i < count * SP_PARAMETRIC_JET; i++)
        out[i] = sp_splat(hostile_number);
}
static void hostile_value(int32_t count, const sp_pair *in, sp_pair *out) {
    (void)in;
    for (int32_t i = 0; i < count * SP_IMPLICIT_VALUES; i++)
        out[i] = sp_splat(hostile_number);
}

static void check_hostile(void) {
    double numbers[] = {0, 1, -1, NAN, INFINITY, -INFINITY, 1e308, 5e-324, 1e-200};
    for (int i = 0; i < 9; i++) {
        hostile_number = numbers[i];
        struct sp_surface chart = {hostile_chart, hostile, SP_PARAMETRIC, 0, {-1, -1}, {1, 1}, 0},
                          equation = {hostile_jet, hostile_value, SP_IMPLICIT, 0, {0, 0}, {0, 0}, 3};
        struct sp_trace_request request = {{0.1, 0.2, 0.3}, {1, 0.5, 0.25}, 1}, odd = {{0.1, 0.2, 0}, {1, 0.5, 0}, numbers[i]};
        CHECK(trace(&chart, request, 1e-12, 3).status < 0, "chart of %g", numbers[i]);
        CHECK(trace(&equation, request, 1e-12, 3).status < 0, "equation of %g", numbers[i]);
        struct sp_trace_result result = trace(&ring_surface, odd, 1e-12, 3);
        CHECK(result.points ? isfinite(result.length) : result.status < 0, "length %g: status %d", numbers[i], result.status);
        odd.length = 1, odd.direction[0] = numbers[i], odd.direction[1] = 0;
        result = trace(&ring_surface, odd, 1e-12, 3);
        CHECK((result.status == SP_CONVERGED) == (isfinite(numbers[i]) && numbers[i] != 0), "direction %g: status %d", numbers[i],
              result.status);
        CHECK(result.normal == (numbers[i] == 0), "direction %g", numbers[i]);
    }
}

int main(void) {
    arena = (struct sp_arena){aligned_alloc(16, 1 << 24), 1 << 24, 0};
    uint64_t seed = 31;
    check_orders();
    check_powers();
    check_spheres();
    check_tolerance();
    check_helix();
    check_clairaut();
    check_torus();
    check_two_forms();
    check_return(&seed);
    check_scale();
    check_edges();
    check_grazing();
    check_poles();
    check_singular();
    check_extremes();
    check_arena(&ring_surface, (struct sp_trace_request){{0.2, 0.1, 0}, {1, 1, 0}, 3});
    check_arena(&sphere_surface, (struct sp_trace_request){{0, 0, 1}, {1, 1, 0}, 3});
    check_hostile();
    free(arena.base);
    return checks_failed();
}
