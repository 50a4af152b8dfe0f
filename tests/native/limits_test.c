/* The edges of what the exported functions accept: arenas of every size, options beyond their ranges, numbers that are not finite. */
#include "surfaces.h"
#include "surfpath.h"
#include "testing.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SIZES = 400 };

static const double HALF_TURN = 3.14159265358979323846;

/* E = G = 1 + u^2, F = 0. */
static void tensor_jet(int32_t count, const sp_pair *in, sp_pair *out) {
    for (; count > 0; count--, in += 2, out += SP_PARAMETRIC_TENSOR_JET) {
        sp_pair zero = sp_splat(0.0), two = sp_splat(2.0), e = 1.0 + in[0] * in[0], slope = 2.0 * in[0];
        sp_pair jet[SP_PARAMETRIC_TENSOR_JET] = {e,   zero, e,   slope, zero, slope, zero, zero, zero,
                                                 two, zero, two, zero,  zero, zero,  zero, zero, zero};
        memcpy(out, jet, sizeof jet);
    }
}

static const struct sp_surface tensor_surface = {tensor_jet, NULL, SP_PARAMETRIC, SP_TENSOR, {-1, -1}, {1, 1}, 0};
/* Its walls at v = 0.9 are in the way of great circles. */
static const struct sp_surface cap = {globe_jet, globe_value, SP_PARAMETRIC, 0, {-10, -1.5}, {10, 0.9}, 0};

static struct sp_options default_options(void) {
    struct sp_options options;
    sp_default_options(&options);
    return options;
}

static struct sp_arena allocate(double bytes) {
    size_t size = ((size_t)bytes + 15) & ~(size_t)15;
    return (struct sp_arena){aligned_alloc(16, size + 16), size, 0};
}

static int is_same(const double *a, const double *b, int32_t count) {
    return (!a && !b) || (a && b && memcmp(a, b, sizeof(double) * (size_t)count) == 0);
}

/* Every size of arena up to the promised one: out of memory (or, where the path meets a cusp or a pole, a
 * crossing that could not be solved), and then no path; or the very
 * same path. */
static void check_solve(const char *name, const struct sp_surface *surface, struct sp_request request, struct sp_options options,
                        int is_crossing) {
    double enough = sp_solve_bytes(surface, &options, request.start_count);
    struct sp_arena whole = allocate(enough), small = allocate(enough);
    struct sp_result expected, result;
    int32_t numbers = 3 * (options.point_count + 2), refused = 0;
    sp_solve_path(surface, &request, &options, &whole, &expected);
    CHECK(expected.status == SP_CONVERGED, "%s: status %d", name, expected.status);
    for (int i = 0; i <= SIZES; i++) {
        small.size = (size_t)(enough * i / SIZES) & ~(size_t)15;
        int32_t status = sp_solve_path(surface, &request, &options, &small, &result);
        int is_unsolved = status == SP_OUT_OF_MEMORY || (is_crossing && status == SP_SINGULAR_METRIC);
        int is_refused = is_unsolved && !result.points && !result.parameters && isnan(result.length);
        int is_equal = status == expected.status && result.length == expected.length && is_same(result.points, expected.points, numbers) &&
                       is_same(result.parameters, expected.parameters, numbers / 3 * 2);
        CHECK(is_refused || is_equal, "%s: %zu of %.0f bytes: status %d, length %.17g", name, small.size, enough, status, result.length);
        refused += is_refused;
    }
    CHECK(refused > 0 && refused <= SIZES, "%s: refused %d times", name, refused);
    free(whole.base), free(small.base);
}

static void check_solves(void) {
    struct sp_options elements = default_options(), polyline = elements, recorded = elements;
    polyline.algorithm = SP_POLYLINE, recorded.record = 1;
    struct sp_request across = {.from = {0.1, -0.7, 0}, .to = {1.4, 0.9, 0}}, over_cusp = {.from = {-0.2, -0.5, 0}, .to = {0.3, 0.6, 0}};
    struct sp_request on_torus = {.from = {5.5, 0, 0}, .to = {3, 4, 1}}, at_wall = {.from = {0, 0.8, 0}, .to = {2, 0.7, 0}};
    struct sp_request past_pole = {.from = {0.3, 1.3}, .to = {0.3 + HALF_TURN, 1.2}, .passage = {SP_OVER_POINT, 3, 0, 2 * HALF_TURN}};
    check_solve("globe", &globe_surface, across, elements, 0);
    check_solve("globe, recorded", &globe_surface, across, recorded, 0);
    check_solve("globe, polyline", &globe_surface, across, polyline, 0);
    check_solve("torus", &torus_surface, on_torus, elements, 0);
    check_solve("tensor", &tensor_surface, over_cusp, elements, 0);
    check_solve("tensor, polyline", &tensor_surface, over_cusp, polyline, 0);
    check_solve("cusp", &cusp_surface, over_cusp, elements, 1);
    check_solve("wall", &cap, at_wall, elements, 0);
    check_solve("pole", &whole_globe_surface, past_pole, elements, 1);
    past_pole.passage.way = SP_POINT_CHART, past_pole.to[0] -= 1e-4;
    check_solve("beside a pole", &whole_globe_surface, past_pole, elements, 0);
    struct sp_surface cut = whole_globe_surface;
    cut.upper[1] -= 1e-3;
    struct sp_request around = {.from = {0.3, 1.3}, .to = {0.5 + HALF_TURN, 1.2}, .passage = {SP_BESIDE_POINT, 3, 1e-3, 0}};
    check_solve("around a hole", &cut, around, elements, 1);
}

static void check_traces(void) {
    const struct sp_surface *surfaces[] = {&globe_surface, &torus_surface};
    struct sp_trace_request requests[] = {{{0.1, 0.2, 0}, {1, 0.5, 0}, 2}, {{5.5, 0, 0}, {0, 1, 1}, 3}};
    struct sp_trace_options options;
    sp_default_trace_options(&options);
    for (int i = 0; i < 2; i++) {
        double enough = sp_trace_bytes(surfaces[i]->kind, &options);
        struct sp_arena arena = allocate(enough);
        struct sp_trace_result result;
        for (int part = 0; part <= SIZES; part++) {
            arena.size = (size_t)(enough * part / SIZES) & ~(size_t)15;
            int32_t status = sp_trace_path(surfaces[i], &requests[i], &options, &arena, &result);
            CHECK(status == SP_CONVERGED ? result.length == requests[i].length : status == SP_OUT_OF_MEMORY && !result.points,
                  "trace %d: %zu bytes: status %d", i, arena.size, status);
            CHECK(part < SIZES || status == SP_CONVERGED, "trace %d: the promised size is not enough", i);
        }
        free(arena.base);
    }
}

/* Searches and fields of one graph, in arenas of every size. */
static void check_questions(const struct sp_surface *surface, const struct sp_graph *graph, const double ends[6]) {
    double searching = sp_graph_search_bytes(graph, 65), spreading = sp_graph_field_bytes(graph, 1);
    struct sp_arena arena = allocate(searching > spreading ? searching : spreading);
    struct sp_graph_answer answer;
    double length;
    struct sp_field_request field = {{ends[0], ends[1], ends[2]}, ends + 3, &length, 1, 0};
    for (int i = 0; i <= SIZES / 4; i++) {
        arena.size = (size_t)(searching * 4 * i / SIZES) & ~(size_t)15;
        int32_t status = sp_graph_search(surface, graph, ends, 65, 1, &arena, &answer);
        CHECK(status == SP_CONVERGED || (status == SP_OUT_OF_MEMORY && i < SIZES / 4), "search: %zu bytes: status %d", arena.size, status);
        CHECK((status == SP_CONVERGED) == (answer.candidate_count > 0), "search: %d candidates", answer.candidate_count);
        arena.size = (size_t)(spreading * 4 * i / SIZES) & ~(size_t)15;
        status = sp_graph_field(surface, graph, &field, &arena);
        CHECK(status == SP_CONVERGED || (status == SP_OUT_OF_MEMORY && i < SIZES / 4), "field: %zu bytes: status %d", arena.size, status);
    }
    free(arena.base);
}

static void check_graph(const struct sp_surface *surface, struct sp_graph_options options, const double ends[6]) {
    double enough = 8 * sp_graph_build_bytes(surface->kind, &options);
    struct sp_arena arena = allocate(enough);
    struct sp_graph graph;
    for (int i = 0; i <= SIZES; i++) {
        arena.size = (size_t)(enough * pow((double)i / SIZES, 3)) & ~(size_t)15;
        int32_t status = sp_graph_build(surface, &options, &arena, &graph);
        CHECK(status == SP_CONVERGED || (status == SP_OUT_OF_MEMORY && i < SIZES), "graph: %zu bytes: status %d", arena.size, status);
    }
    check_questions(surface, &graph, ends);
    free(arena.base);
}

static void check_graphs(void) {
    const struct sp_graph_options round = {{0, 2 * HALF_TURN, -HALF_TURN / 2, HALF_TURN / 2}, 0, 8, 0, 0, 0};
    const struct sp_graph_options box = {{-5.7, 5.7, -5.7, 5.7, -5.7, 5.7}, 0, 16, 0, 0, 0},
                                  flood = {{5.5, 5.5, 0, 0, 0, 0}, 1, 0, 0, 0, 0};
    check_graph(&whole_globe_surface, round, (double[6]){0.3, 1.3, 0, 0.3 + HALF_TURN, 1.2, 0});
    check_graph(&torus_surface, box, (double[6]){5.5, 0, 0, -5.5, 0, 0});
    check_graph(&torus_surface, flood, (double[6]){5.5, 0, 0, 4, 0, 1.5});
}

/* cos(8 pi x): of 16 cells a direction, each has a change of sign. */
static void planes_value(int32_t count, const sp_pair *in, sp_pair *out) {
    for (; count > 0; count--, in += 3, out += 4) {
        sp_pair sine = sp_sincos(8 * HALF_TURN * in[0], out);
        out[1] = -8 * HALF_TURN * sine, out[2] = out[3] = sp_splat(0.0);
    }
}

/* A graph that fills its box to the last cell is built, and an end of time. */
static void check_full_box(void) {
    const struct sp_surface planes = {planes_value, planes_value, SP_IMPLICIT, SP_INDUCED, {0}, {0}, 3.5};
    const struct sp_graph_options box = {{-1, 1, -1, 1, -1, 1}, 0, 16, 0, 0, 0};
    struct sp_arena arena = allocate(1 << 28);
    struct sp_graph graph;
    int32_t status = sp_graph_build(&planes, &box, &arena, &graph);
    CHECK(status == SP_CONVERGED && graph.vertex_count == 16 * 16 * 16, "full box: status %d, %d vertices", status, graph.vertex_count);
    free(arena.base);
}

static void check_meshes(void) {
    const double box[6] = {-5.7, 5.7, -5.7, 5.7, -5.7, 5.7};
    struct sp_mesh mesh;
    struct sp_arena arena = allocate(1 << 20);
    int32_t status = sp_mesh_implicit(torus_value, box, 12, &arena, &mesh), vertices = mesh.vertex_count;
    CHECK(status == SP_CONVERGED && vertices > 0, "mesh: status %d, %d vertices", status, vertices);
    double enough = sp_mesh_bytes(box, 12, vertices, mesh.triangle_count);
    for (int i = 0; i <= SIZES; i++) {
        arena.size = (size_t)(enough * i / SIZES) & ~(size_t)15, arena.used = 0;
        status = sp_mesh_implicit(torus_value, box, 12, &arena, &mesh);
        CHECK(status == SP_CONVERGED || (status == SP_OUT_OF_MEMORY && !mesh.positions && i < SIZES), "mesh: %zu bytes: status %d",
              arena.size, status);
        CHECK(status == SP_OUT_OF_MEMORY || mesh.vertex_count == vertices, "mesh: %d vertices", mesh.vertex_count);
    }
    free(arena.base);
}

/* Options out of range are clamped: the answer is that of the nearest that is in range. */
static void check_options(void) {
    struct sp_arena arena = allocate(1 << 26);
    struct sp_request request = {.from = {0.1, -0.7, 0}, .to = {1.4, 0.9, 0}};
    struct sp_result result;
    struct sp_options options = default_options();
    options.algorithm = SP_POLYLINE, options.point_count = -7;
    int32_t status = sp_solve_path(&globe_surface, &request, &options, &arena, &result);
    CHECK(status == SP_CONVERGED && result.points[3] != result.points[0], "one point: status %d", status);
    options.point_count = 1 << 30, options.max_iterations = 1 << 30;
    status = sp_solve_path(&globe_surface, &request, &options, &arena, &result);
    CHECK(status == SP_CONVERGED || status == SP_OUT_OF_MEMORY, "too many points: status %d", status);
    CHECK(sp_solve_bytes(&globe_surface, &options, 0) < 1e9, "%g bytes", sp_solve_bytes(&globe_surface, &options, 0));
    options = default_options(), options.max_iterations = -3;
    status = sp_solve_path(&globe_surface, &request, &options, &arena, &result);
    CHECK(status == SP_ITERATION_LIMIT && result.iterations == 0, "no iterations: status %d, %d", status, result.iterations);
    for (int i = 0; i < 3; i++) {
        options = default_options(), options.tolerance = (double[]){0, -1, NAN}[i];
        status = sp_solve_path(&globe_surface, &request, &options, &arena, &result);
        CHECK((status == SP_CONVERGED || status == SP_TOLERANCE_NOT_MET) && result.length_error < 1e-13 * result.length,
              "tolerance %g: status %d, error %g", options.tolerance, status, result.length_error);
    }
    struct sp_trace_options trace = {0, -1, -1};
    struct sp_trace_request along = {{0.1, 0.2, 0}, {1, 0.5, 0}, 2};
    struct sp_trace_result traced;
    status = sp_trace_path(&globe_surface, &along, &trace, &arena, &traced);
    CHECK(status == SP_ITERATION_LIMIT && traced.steps <= 1 && traced.length < 2, "trace: status %d, %d steps", status, traced.steps);
    trace = (struct sp_trace_options){NAN, 1, 1 << 30};
    status = sp_trace_path(&globe_surface, &along, &trace, &arena, &traced);
    CHECK(status == SP_CONVERGED && traced.length_error < 1e-9, "trace: status %d, error %g", status, traced.length_error);
    free(arena.base);
}

/* Graphs of boxes that are none, of too few and too many cells; ways of too few and too many points. */
static void check_graph_options(void) {
    struct sp_arena arena = allocate(1 << 28);
    struct sp_graph graph;
    struct sp_graph_answer answer;
    const double bad[][2] = {{0, 0}, {1, -1}, {NAN, 1}, {-INFINITY, 1}, {0, INFINITY}, {-1e308, 1e308}};
    for (int i = 0; i < 6; i++) {
        struct sp_graph_options flat = {{bad[i][0], bad[i][1], -1, 1, -1, 1}, 0, 16, 0, 0, 0};
        CHECK(sp_graph_build(&saddle_surface, &flat, &arena, &graph) == SP_NOT_FINITE, "box %d", i);
        CHECK(sp_graph_build(&torus_surface, &flat, &arena, &graph) == SP_NOT_FINITE, "box %d, implicit", i);
    }
    for (int32_t resolution = -1; resolution < 2000; resolution += 2000) {
        struct sp_graph_options options = {{-1, 1, -1.1, 1.1}, 0, resolution, 0, 0, 0};
        CHECK(sp_graph_build(&saddle_surface, &options, &arena, &graph) == SP_CONVERGED, "resolution %d", resolution);
        CHECK(graph.vertex_count >= 49 && graph.vertex_count <= 300 * 300, "resolution %d: %d vertices", resolution, graph.vertex_count);
    }
    struct sp_graph_options options = {{-1, 1, -1.1, 1.1}, 0, 8, 0, 0, 0};
    sp_graph_build(&saddle_surface, &options, &arena, &graph);
    struct sp_arena rest = allocate(1 << 24);
    const double ends[6] = {-0.9, -1, 0, 0.9, 1, 0}, nowhere[6] = {-0.9, -1, 0, NAN, 1, 0};
    for (int32_t points = 0; points < 6000; points += 3000) {
        int32_t status = sp_graph_search(&saddle_surface, &graph, ends, points, 1, &rest, &answer);
        CHECK(status == SP_CONVERGED && answer.point_count == (points ? SP_GRAPH_MAX_POINTS : 3), "%d points: status %d, %d", points,
              status, answer.point_count);
    }
    CHECK(sp_graph_search(&saddle_surface, &graph, nowhere, 9, 1, &rest, &answer) == SP_NOT_FINITE, "an end that is not a number");
    free(rest.base), free(arena.base);
}

/* Ends and starts that are no numbers, or too large to add. */
static void check_not_finite(void) {
    struct sp_arena arena = allocate(1 << 24);
    struct sp_result result;
    struct sp_options options = default_options();
    const double bad[] = {NAN, INFINITY, -INFINITY, 1e308, -1e308};
    for (int i = 0; i < 5; i++) {
        double start[6] = {0.1, -0.7, bad[i], 0.2, 1.4, 0.9};
        struct sp_request ends = {.from = {0.1, bad[i], 0}, .to = {1.4, 0.9, 0}},
                          by_start = {.from = {0.1, -0.7, 0}, .to = {1.4, 0.9, 0}, .start = start, .start_count = 3};
        struct sp_request space = {.from = {5.5, bad[i], 0}, .to = {3, 4, 1}};
        CHECK(sp_solve_path(&whole_globe_surface, &by_start, &options, &arena, &result) < 0 && !result.points, "start %g: %d", bad[i],
              result.status);
        CHECK(sp_solve_path(&torus_surface, &space, &options, &arena, &result) < 0 && !result.points, "end %g: %d", bad[i], result.status);
        int32_t status = sp_solve_path(&whole_globe_surface, &ends, &options, &arena, &result);
        CHECK(isfinite(bad[i]) || (status == SP_NOT_FINITE && isnan(result.length)), "end %g: status %d", bad[i], status);
    }
    free(arena.base);
}

int main(void) {
    check_solves();
    check_traces();
    check_graphs();
    check_full_box();
    check_meshes();
    check_options();
    check_graph_options();
    check_not_finite();
    return checks_failed();
}
