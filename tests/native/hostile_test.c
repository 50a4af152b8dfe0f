/* What the fuzzer of tests/fuzz has found, one check each. */
#include "surfaces.h"
#include "surfpath.h"
#include "testing.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static struct sp_arena arena_of(double bytes) {
    size_t size = (size_t)bytes;
    return (struct sp_arena){malloc(size ? size : 1), size, 0};
}

static struct sp_result solve(const struct sp_surface *surface, const struct sp_request *request) {
    struct sp_options options;
    struct sp_result result;
    sp_default_options(&options);
    struct sp_arena arena = arena_of(sp_solve_bytes(surface, &options, 0));
    sp_solve_path(surface, request, &options, &arena, &result);
    free(arena.base);
    return result;
}

/* An edge that is none of the four was read from beyond the walls. Beside an edge it is the same path, on other elements. */
static void check_pole(void) {
    struct sp_request request = {.from = {0.1, 0.2, 0}, .to = {1.4, -0.3, 0}}, wrong = request;
    struct sp_result plain = solve(&globe_surface, &request);
    for (int32_t way = SP_FREE; way <= SP_BESIDE_POINT + 1; way++)
        for (int32_t edge = -1; edge <= 4; edge++) {
            int is_edge = edge >= 0 && edge < 4;
            if (way == SP_OVER_POINT && is_edge) continue;
            wrong.passage = (struct sp_passage){way, edge, 0, 0};
            struct sp_result result = solve(&globe_surface, &wrong);
            double most = way == SP_BESIDE_POINT && is_edge ? plain.length_error + result.length_error : 0;
            CHECK(result.status == SP_CONVERGED && fabs(result.length - plain.length) <= most, "way %d, edge %d: status %d", way, edge,
                  result.status);
        }
}

/* How far beyond an edge the surface collapses may be any number, and wrong. */
static void check_beyond(void) {
    const double numbers[] = {0, -1, 1e-3, 1, 1e308, -1e308, 1e-308, (double)INFINITY, -(double)INFINITY, (double)NAN};
    for (int32_t k = 0; k < 120; k++) {
        int32_t way = 1 + k / 40, edge = k / 10 % 4, i = k % 10;
        struct sp_request request = {.from = {0.1, 0.2}, .to = {1.4, -0.3}, .passage = {way, edge, numbers[i], 6.28}};
        struct sp_result result = solve(&globe_surface, &request);
        int is_path = result.length >= 0 && result.length_error >= 0;
        CHECK(result.status < 0 ? isnan(result.length) : is_path, "way %d, edge %d, %g beyond: status %d, length %g", way, edge, numbers[i],
              result.status, result.length);
    }
}

/* A rectangle from infinity led to a length of NaN, called converged. */
static void check_rectangle(void) {
    struct sp_surface surface = globe_surface;
    surface.lower[1] = (double)INFINITY;
    struct sp_request request = {.from = {-0.01, 3, 0}, .to = {2.25, 0, 0}};
    struct sp_result result = solve(&surface, &request);
    CHECK(result.status < 0 && isnan(result.length), "status %d, length %g", result.status, result.length);
}

/* A path over an edge that is no pole, from so far away that it could not be solved, was called usable, with another end. */
static void check_unsolved_pole(void) {
    struct sp_surface surface = globe_surface;
    surface.lower[0] = -2.5;
    surface.upper[0] = (double)INFINITY;
    struct sp_request request = {.from = {5e303, -1.2}, .to = {-2.5, -1.2}, .passage = {SP_OVER_POINT, 0, 0, 0}};
    struct sp_result result = solve(&surface, &request);
    CHECK(result.status < 0 && isnan(result.length), "status %d, length %g", result.status, result.length);
}

static void one(int32_t count, const sp_pair *in, sp_pair *out) {
    (void)in;
    for (int32_t i = 0; i < count * SP_PARAMETRIC_JET; i++)
        out[i] = sp_splat(1.0);
}

/* A surface that is everywhere the same point let a projection from NaN rest there. */
static void check_projection(void) {
    const struct sp_surface surface = {one, one, SP_PARAMETRIC, 0, {-1, -1}, {1, 1}, 0};
    double point[3] = {0, 0, 0}, place[3] = {(double)NAN, 0, 0};
    int32_t status = sp_project_point(&surface, point, place);
    CHECK(status == SP_NOT_FINITE && place[1] == 0, "status %d", status);
}

static int calls;

/* A sphere that grows at every call. */
static void growing(int32_t count, const sp_pair *in, sp_pair *out) {
    calls++;
    for (; count > 0; count--, in += 3, out += 4) {
        out[0] = in[0] * in[0] + in[1] * in[1] + in[2] * in[2] - 1e-3 * calls;
        out[1] = 2.0 * in[0], out[2] = 2.0 * in[1], out[3] = 2.0 * in[2];
    }
}

/* A surface that is larger when its mesh is stored than when it was counted was written past the end of the arrays. */
static void check_mesh(void) {
    double box[6] = {-2, 2, -2, 2, -2, 2};
    struct sp_mesh mesh = {0};
    calls = 0;
    for (int attempt = 0; attempt < 3; attempt++) {
        struct sp_arena arena = arena_of(sp_mesh_bytes(box, 12, mesh.vertex_count, mesh.triangle_count));
        int32_t status = sp_mesh_implicit(growing, box, 12, &arena, &mesh);
        CHECK(status == SP_OUT_OF_MEMORY && !mesh.positions, "status %d", status);
        free(arena.base);
    }
    CHECK(mesh.vertex_count > 0, "nothing was counted");
}

static void far_away(int32_t count, const sp_pair *in, sp_pair *out) {
    (void)in;
    for (int32_t i = 0; i < count * SP_IMPLICIT_VALUES; i++)
        out[i] = sp_splat(1.0);
}

/* Of a graph without vertices the extent, minus infinity, became a number of slabs. */
static void check_empty_graph(void) {
    const struct sp_surface surface = {NULL, far_away, SP_IMPLICIT, 0, {0, 0}, {0, 0}, 7};
    const struct sp_graph_options options = {{-1, 1, -1, 1, -1, 1}, 0, 8, 0, 0, 0};
    struct sp_graph graph;
    struct sp_arena arena = arena_of(sp_graph_build_bytes(SP_IMPLICIT, &options));
    int32_t status = sp_graph_build(&surface, &options, &arena, &graph);
    CHECK(status == SP_CONVERGED && graph.vertex_count == 0, "status %d, %d vertices", status, graph.vertex_count);
    double places[3] = {0, 0, 0}, length = 0;
    struct sp_field_request field = {{0, 0, 0}, places, &length, 1, 0};
    struct sp_arena scratch = arena_of(sp_graph_field_bytes(&graph, 1));
    status = sp_graph_field(&surface, &graph, &field, &scratch);
    CHECK(status == SP_OFF_SURFACE, "status %d", status);
    free(arena.base), free(scratch.base);
}

int main(void) {
    check_pole();
    check_beyond();
    check_rectangle();
    check_unsolved_pole();
    check_projection();
    check_mesh();
    check_empty_graph();
    return checks_failed();
}
