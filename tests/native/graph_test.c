/* Graphs of surfaces: distances against closed forms, ways continuous across seams and past poles, sheets kept apart, memory. */
#include "../../wasm/graph.h"
#include "surfaces.h"
#include "testing.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double PI = 3.14159265358979323846;

/* (cos u, sin u, v) */
static void cylinder(int32_t count, const sp_pair *in, sp_pair *out, int values) {
    for (; count > 0; count--, in += 2, out += values) {
        sp_pair cosine, sine = sp_sincos(in[0], &cosine), zero = sp_splat(0.0), one = sp_splat(1.0);
        sp_pair jet[SP_PARAMETRIC_JET] = {cosine,  sine,  in[1], -sine, cosine, zero, zero, zero, one,
                                          -cosine, -sine, zero,  zero,  zero,   zero, zero, zero, zero};
        for (int j = 0; j < values; j++)
            out[j] = jet[j];
    }
}

/* Two spheres of radius 1, apart: their product. */
static void two_spheres_value(int32_t count, const sp_pair *in, sp_pair *out) {
    for (; count > 0; count--, in += 3, out += 4) {
        sp_pair x = in[0] - 1.5, w = in[0] + 1.5, rest = in[1] * in[1] + in[2] * in[2] - 1.0, f = x * x + rest, g = w * w + rest;
        out[0] = f * g;
        out[1] = 2.0 * (x * g + w * f), out[2] = 2.0 * in[1] * (f + g), out[3] = 2.0 * in[2] * (f + g);
    }
}

/* A plane whose E = G = (1.5 + sin(stripes u))^2; of the derivatives, which tell its curvature, none. */
static double stripes;

static void striped_jet(int32_t count, const sp_pair *in, sp_pair *out) {
    for (; count > 0; count--, in += 2, out += SP_PARAMETRIC_TENSOR_JET) {
        sp_pair cosine, density = 1.5 + sp_sincos(stripes * in[0], &cosine);
        for (int j = 0; j < SP_PARAMETRIC_TENSOR_JET; j++)
            out[j] = j == 0 || j == 2 ? density * density : sp_splat(0.0);
    }
}

/* A plane with a density between a half and two and a half, written without derivatives. */
static void uneven_jet(int32_t count, const sp_pair *in, sp_pair *out) {
    for (; count > 0; count--, in += 2, out += SP_PARAMETRIC_DENSITY_JET) {
        sp_pair cosine, other, density = 1.5 + sp_sincos(5.0 * in[0], &cosine) * sp_sincos(4.0 * in[1], &other);
        for (int j = 0; j < SP_PARAMETRIC_DENSITY_JET; j++)
            out[j] = j < 2 ? in[j] : j == 3 ? density * density : sp_splat(j == 4 || j == 9);
    }
}

static void uneven_value(int32_t count, const sp_pair *in, sp_pair *out) {
    for (; count > 0; count--, in += 2, out += 3)
        out[0] = in[0], out[1] = in[1], out[2] = sp_splat(0.0);
}

COMPILED(cylinder, SP_PARAMETRIC_JET, SP_PARAMETRIC_VALUES)

#define WRAPPED -INFINITY
static const struct sp_surface round_cylinder = {cylinder_jet, cylinder_value, SP_PARAMETRIC, 0, {WRAPPED, -1}, {INFINITY, 1}, 0};
static const struct sp_surface cut_cylinder = {cylinder_jet, cylinder_value, SP_PARAMETRIC, 0, {0, -1}, {2 * 3.14159265358979323846, 1}, 0};
static const struct sp_surface two_spheres = {NULL, two_spheres_value, SP_IMPLICIT, 0, {0, 0}, {0, 0}, 7};

static const struct sp_surface striped = {striped_jet, NULL, SP_PARAMETRIC, SP_TENSOR, {-1, -1}, {1, 1}, 0};

static const struct sp_surface uneven = {uneven_jet, uneven_value, SP_PARAMETRIC, SP_DENSITY, {-1, -1}, {1, 1}, 0};

static const struct sp_graph_options round_box = {{0, 6.28318530717958647692, -1, 1}, 0, 64, 0, 0, 0};
static const struct sp_graph_options square_box = {{-1, 1, -1, 1}, 0, 64, 0, 0, 0};
static const struct sp_graph_options saddle_box = {{-1, 1, -1.1, 1.1}, 0, 64, 0, 0, 0};
static const struct sp_graph_options globe_box = {
    {0, 6.28318530717958647692, -1.57079632679489661923, 1.57079632679489661923}, 0, 64, 0, 0, 0};
static const struct sp_graph_options torus_box = {{-5.7, 5.7, -5.7, 5.7, -5.7, 5.7}, 0, 40, 0, 0, 0};
static const struct sp_graph_options spheres_box = {{-3, 3, -3, 3, -3, 3}, 0, 40, 0, 0, 0};

/* A graph that is kept, and an arena for searches. */
struct fixture {
    const struct sp_surface *surface;
    struct sp_graph graph;
    struct sp_graph_answer answer;
    struct sp_arena arena;
    void *kept;
    int32_t status;
};

static struct sp_arena allocate_arena(double bytes) {
    size_t size = ((size_t)bytes + 15) & ~(size_t)15;
    return (struct sp_arena){aligned_alloc(16, size), size, 0};
}

static struct fixture make(const struct sp_surface *surface, const struct sp_graph_options *options) {
    struct fixture fixture = {.surface = surface};
    double bytes = sp_graph_build_bytes(surface->kind, options);
    struct sp_arena build = allocate_arena(bytes);
    fixture.status = sp_graph_build(surface, options, &build, &fixture.graph);
    for (int doubled = 1; fixture.status == SP_OUT_OF_MEMORY && doubled < 4; doubled++) {
        free(build.base);
        build = allocate_arena(bytes *= 2);
        fixture.status = sp_graph_build(surface, options, &build, &fixture.graph);
    }
    CHECK(fixture.status == SP_CONVERGED, "status %d", fixture.status);
    fixture.kept = allocate_arena(sp_graph_bytes(&fixture.graph) + 16).base;
    sp_graph_keep(&fixture.graph, fixture.kept);
    free(build.base);
    fixture.arena = allocate_arena(sp_graph_search_bytes(&fixture.graph, 65));
    return fixture;
}

static void drop(struct fixture *fixture) {
    free(fixture->kept);
    free(fixture->arena.base);
}

/* Searches; the ways must begin and end where they were asked, up to whole turns of u, and be no shorter than the surface allows. */
static int32_t search(struct fixture *fixture, const double from[3], const double to[3]) {
    double ends[6] = {from[0], from[1], from[2], to[0], to[1], to[2]};
    struct sp_graph_answer *answer = &fixture->answer;
    int32_t status = sp_graph_search(fixture->surface, &fixture->graph, ends, 65, 1, &fixture->arena, answer);
    int dimension = fixture->surface->kind == SP_IMPLICIT ? 3 : 2;
    CHECK((status == SP_CONVERGED) == (answer->candidate_count > 0), "status %d, %d candidates", status, answer->candidate_count);
    for (int32_t c = 0; c < answer->candidate_count; c++) {
        const double *first = answer->places + (size_t)(c * dimension * 65), *last = first + (size_t)(dimension * 64);
        for (int j = 0; j < dimension; j++) {
            double turns = dimension == 2 && fixture->graph.wraps[j] ? (last[j] - to[j]) / (2 * PI) : last[j] - to[j];
            CHECK(first[j] == from[j], "candidate %d starts at %g", c, first[j]);
            CHECK(fabs(turns - round(turns)) < 1e-12 && (fixture->graph.kind == SP_PARAMETRIC || turns == 0), "ends at %g", last[j]);
        }
    }
    return status;
}

/* The graph's distance is at most `excess` longer than the true one, and not shorter by more than half a percent (chords). */
static void check_distance(struct fixture *fixture, const double from[3], const double to[3], double length, double excess,
                           const char *what) {
    int32_t status = search(fixture, from, to);
    double ratio = fixture->answer.distance / length;
    CHECK(status == SP_CONVERGED && ratio > 0.995 && ratio < 1 + excess, "%s: status %d, ratio %.4f", what, status, ratio);
}

static void test_plane_like(void) {
    struct fixture fixture = make(&saddle_surface, &saddle_box);
    CHECK(fixture.graph.unique == 1, "a saddle has curvature < 0");
    CHECK(abs(fixture.graph.vertex_count - 65 * 65) < 200, "%d vertices", fixture.graph.vertex_count);
    search(&fixture, (double[3]){0, 0}, (double[3]){0.9, 0.8});
    CHECK(fixture.answer.distance < 1.4 && fixture.answer.distance > 1.2, "distance %g", fixture.answer.distance);
    drop(&fixture);
    fixture = make(&cut_cylinder, &round_box);
    CHECK(fixture.graph.unique == 1, "a cut cylinder is flat");
    check_distance(&fixture, (double[3]){0.1, -0.9}, (double[3]){6.1, 0.7}, hypot(6, 1.6), 0.02, "cut cylinder");
    check_distance(&fixture, (double[3]){1.234, -0.3}, (double[3]){1.321, -0.211}, hypot(0.087, 0.089), 0.2, "close ends");
    drop(&fixture);
}

/* Resolved are surfaces, and metrics, that change little along an edge. */
static void test_resolved(void) {
    struct fixture fixture = make(&saddle_surface, &saddle_box);
    CHECK(fixture.graph.resolved == 1, "a saddle is smooth");
    drop(&fixture);
    for (int fine = 0; fine < 2; fine++) {
        stripes = fine ? 30 : 1;
        fixture = make(&striped, &square_box);
        CHECK(fixture.graph.resolved == !fine, "%g stripes: %d", stripes, fixture.graph.resolved);
        drop(&fixture);
    }
}

/* A search that is led to its end finds what one that is not does. */
static void test_led(void) {
    struct fixture fixture = make(&uneven, &square_box);
    double stretch = fixture.graph.stretch;
    CHECK(stretch >= 0.5 && stretch < 0.6, "no edge is shorter than its chord times %g", stretch);
    for (int k = 0; k < 8; k++) {
        double from[3] = {-0.9, 0.2 * k - 0.85, 0}, to[3] = {0.83 - 0.1 * k, 0.9 - 0.21 * k, 0};
        fixture.graph.stretch = stretch;
        int32_t status = search(&fixture, from, to), count = fixture.answer.candidate_count;
        double distance = fixture.answer.distance;
        fixture.graph.stretch = 0;
        CHECK(status == SP_CONVERGED && search(&fixture, from, to) == status, "pair %d: status %d", k, status);
        CHECK(fabs(fixture.answer.distance / distance - 1) < 1e-14, "pair %d: %.17g, not %.17g", k, distance, fixture.answer.distance);
        CHECK(fixture.answer.candidate_count == count, "pair %d: %d ways, not %d", k, count, fixture.answer.candidate_count);
    }
    drop(&fixture);
    fixture = make(&saddle_surface, &saddle_box);
    CHECK(fixture.graph.stretch == 1, "in space: %g", fixture.graph.stretch);
    drop(&fixture);
    stripes = 1;
    fixture = make(&striped, &square_box);
    CHECK(fixture.graph.stretch == 0, "without positions: %g", fixture.graph.stretch);
    drop(&fixture);
}

static void test_seam(void) {
    struct fixture fixture = make(&round_cylinder, &round_box);
    CHECK(fixture.graph.unique == 0, "ways around");
    check_distance(&fixture, (double[3]){0.1, -0.9}, (double[3]){6.1, 0.7}, hypot(2 * PI - 6, 1.6), 0.02, "across the seam");
    const double *first = fixture.answer.places;
    for (int32_t i = 1; i < 65; i++)
        CHECK(fabs(first[2 * i] - first[2 * i - 2]) < 0.2, "u jumps by %g", first[2 * i] - first[2 * i - 2]);
    CHECK(fabs(first[128] - (6.1 - 2 * PI)) < 1e-12, "ends at u = %g", first[128]);
    check_distance(&fixture, (double[3]){-12.0, 0}, (double[3]){40.0, 0}, 52 - 16 * PI, 0.02, "lifts far away");
    drop(&fixture);
}

/* The great circle between two places of longitude and latitude. */
static double great_circle(const double a[2], const double b[2]) {
    return acos(sin(a[1]) * sin(b[1]) + cos(a[1]) * cos(b[1]) * cos(a[0] - b[0]));
}

static void test_poles(void) {
    struct fixture fixture = make(&whole_globe_surface, &globe_box);
    double from[3] = {0.3, 1.3}, to[3] = {0.3 + PI - 0.2, 1.2}, pole[3] = {0.7, 1.57079632679489661923};
    CHECK(fixture.graph.collapsed[2] && fixture.graph.collapsed[3] && !fixture.graph.collapsed[0], "two poles");
    check_distance(&fixture, from, to, great_circle(from, to), 0.04, "over the pole");
    CHECK(fixture.answer.candidate_count >= 2, "%d candidates", fixture.answer.candidate_count);
    double left = fixture.answer.places[128], right = fixture.answer.places[2 * 65 + 128];
    CHECK(fabs(fabs(left - right) - 2 * PI) < 1e-9, "the pole is passed on both sides: %g, %g", left, right);
    check_distance(&fixture, pole, to, PI / 2 - to[1], 0.01, "from the pole");
    uint64_t state = 20;
    for (int i = 0; i < 40; i++) {
        double a[3] = {10 * random_unit(&state), asin(2 * random_unit(&state) - 1)};
        double b[3] = {10 * random_unit(&state), asin(2 * random_unit(&state) - 1)};
        check_distance(&fixture, a, b, great_circle(a, b), 0.06, "random ends, seed 20");
    }
    drop(&fixture);
}

static void test_cusp(void) {
    struct fixture fixture = make(&cusp_surface, &square_box);
    CHECK(fixture.graph.singular == 1, "the normal turns over at v = 0");
    CHECK(search(&fixture, (double[3]){0, -0.5}, (double[3]){0, 0.5}) == SP_CONVERGED, "a way across the cusp");
    for (int i = 0; i < 65; i++)
        CHECK(fabs(fixture.answer.places[2 * i]) < 0.1, "straight across: u = %g", fixture.answer.places[2 * i]);
    CHECK(search(&fixture, (double[3]){-0.9, 0.5}, (double[3]){0.9, 0.4}) == SP_CONVERGED, "on one side of it");
    drop(&fixture);
    fixture = make(&bumpy_surface, &(struct sp_graph_options){{-3.2, 3.2, -3.2, 3.2}, 0, 64, 0, 0, 0});
    CHECK(fixture.graph.singular == 0, "steep is not singular");
    drop(&fixture);
}

static void test_implicit(void) {
    struct fixture fixture = make(&torus_surface, &torus_box);
    check_distance(&fixture, (double[3]){2.5, 0, 0}, (double[3]){0, 2.5, 0}, 2.5 * PI / 2, 0.06, "inside of the torus");
    check_distance(&fixture, (double[3]){5.5, 0, 0}, (double[3]){2.5, 0, 0}, 1.5 * PI, 0.06, "around the tube");
    CHECK(fixture.answer.candidate_count >= 2, "both ways around the tube: %d", fixture.answer.candidate_count);
    CHECK(search(&fixture, (double[3]){40, 0, 0}, (double[3]){2.5, 0, 0}) == SP_OFF_SURFACE, "an end nowhere");
    CHECK(search(&fixture, (double[3]){NAN, 0, 0}, (double[3]){2.5, 0, 0}) == SP_NOT_FINITE, "an end that is not a number");
    drop(&fixture);
    fixture = make(&two_spheres, &spheres_box);
    CHECK(search(&fixture, (double[3]){0.5, 0, 0}, (double[3]){-0.5, 0, 0}) == SP_DISCONNECTED, "two spheres");
    check_distance(&fixture, (double[3]){0.5, 0, 0}, (double[3]){2.5, 0, 0}, PI, 0.06, "one of them");
    drop(&fixture);
}

static void test_flood(void) {
    struct sp_graph_options options = {{0.5, 0.5, 0, 0, 0, 0}, 0.1, 0, 0, 0, 0};
    struct fixture fixture = make(&two_spheres, &options);
    check_distance(&fixture, (double[3]){0.5, 0, 0}, (double[3]){1.5, 1, 0}, PI / 2, 0.06, "flooded sphere");
    CHECK(search(&fixture, (double[3]){0.5, 0, 0}, (double[3]){-0.5, 0, 0}) == SP_OFF_SURFACE, "the flood stays on its sphere");
    int32_t all = fixture.graph.vertex_count;
    drop(&fixture);
    /* As far as a way may lead that is half as long again as the shortest. */
    options = (struct sp_graph_options){{0.5, 1.5, 0, 1, 0, 0}, 0.1, 0, 0, 0.75 * PI, 0};
    fixture = make(&two_spheres, &options);
    check_distance(&fixture, (double[3]){0.5, 0, 0}, (double[3]){1.5, 1, 0}, PI / 2, 0.06, "a part of a sphere");
    CHECK(2 * fixture.graph.vertex_count < all, "%d cells, of the whole sphere %d", fixture.graph.vertex_count, all);
    drop(&fixture);
    options = (struct sp_graph_options){{0.5, 0.5, 0, 0, 0, 0}, 0.005, 0, 0, 0, 0};
    fixture = make(&two_spheres, &options);
    CHECK(fixture.graph.vertex_count == SP_GRAPH_FLOOD_CELLS, "%d cells", fixture.graph.vertex_count);
    drop(&fixture);
}

static void test_memory(void) {
    struct fixture grid = make(&round_cylinder, &(struct sp_graph_options){{0, 2 * PI, -1, 1}, 0, 128, 0, 0, 2});
    CHECK(sp_graph_bytes(&grid.graph) <= 16e6, "128^2: %g bytes", sp_graph_bytes(&grid.graph));
    drop(&grid);
    struct fixture cells = make(&torus_surface, &(struct sp_graph_options){{-5.7, 5.7, -5.7, 5.7, -5.7, 5.7}, 0, 80, 0, 0, 0});
    CHECK(sp_graph_bytes(&cells.graph) <= 48e6, "80^3: %g bytes", sp_graph_bytes(&cells.graph));
    drop(&cells);
}

/* Arenas of every size up to enough: refused or right, never written beyond their end (the sanitizer looks). */
static void test_tiny_arenas(void) {
    static const struct sp_surface *surfaces[2] = {&round_cylinder, &torus_surface};
    static const struct sp_graph_options *boxes[2] = {&round_box, &torus_box};
    for (int s = 0; s < 2; s++) {
        double enough = sp_graph_build_bytes(surfaces[s]->kind, boxes[s]);
        struct fixture whole = make(surfaces[s], boxes[s]);
        struct sp_graph graph;
        int refused = 0, built = 0;
        for (double part = 0; part <= 1; part += 0.0625) {
            struct sp_arena arena = allocate_arena(part * enough + 16);
            int32_t status = sp_graph_build(surfaces[s], boxes[s], &arena, &graph);
            CHECK(status == SP_OUT_OF_MEMORY || (status == SP_CONVERGED && graph.edge_count == whole.graph.edge_count), "status %d",
                  status);
            refused += status == SP_OUT_OF_MEMORY, built += status == SP_CONVERGED;
            free(arena.base);
        }
        CHECK(refused > 0 && built > 0, "%d refused, %d built", refused, built);
        double ends[6] = {s ? 2.5 : 0.1, 0, 0, s ? -2.5 : 3, 0, 0}, needed = sp_graph_search_bytes(&whole.graph, 65);
        refused = 0;
        for (double part = 0; part <= 1; part += 0.0625) {
            struct sp_arena arena = allocate_arena(part * needed + 16);
            int32_t status = sp_graph_search(whole.surface, &whole.graph, ends, 65, 1, &arena, &whole.answer);
            CHECK(status == SP_OUT_OF_MEMORY || status == SP_CONVERGED, "status %d", status);
            refused += status == SP_OUT_OF_MEMORY;
            CHECK(part < 1 || status == SP_CONVERGED, "status %d with all its memory", status);
            free(arena.base);
        }
        CHECK(refused > 4, "%d searches refused", refused);
        drop(&whole);
    }
}

int main(void) {
    test_plane_like();
    test_resolved();
    test_led();
    test_seam();
    test_poles();
    test_cusp();
    test_implicit();
    test_flood();
    test_memory();
    test_tiny_arenas();
    return checks_failed();
}
