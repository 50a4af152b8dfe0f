/* Surfaces that are sound up to a plane and then something else: NaN, infinite, flat to a point, huge, torn. Whatever is asked of them ends
 * in a status; a path consists of finite numbers, and without one there are none. */
#include "surfaces.h"
#include "surfpath.h"
#include "testing.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SPOILT_ALL, SPOILT_DERIVATIVES, SPOILT_SECOND, MANNERS };

static struct {
    const struct sp_surface *sound;
    double beyond; /* first coordinate */
    double by;     /* what stands there instead, or, for a factor, what it is multiplied by */
    int is_factor, manner;
} spoilt;

static void spoil(int32_t count, const sp_pair *in, sp_pair *out, int outputs) {
    int is_implicit = spoilt.sound->kind == SP_IMPLICIT, inputs = is_implicit ? 3 : 2, values = is_implicit ? 1 : 3;
    int first = spoilt.manner == SPOILT_ALL ? 0 : spoilt.manner == SPOILT_DERIVATIVES ? values : values * (inputs + 1);
    for (int32_t i = 0; i < count; i++)
        for (int lane = 0; lane < 2; lane++)
            for (int j = first; in[inputs * i][lane] > spoilt.beyond && j < outputs; j++)
                out[outputs * i + j][lane] = spoilt.is_factor ? out[outputs * i + j][lane] * spoilt.by : spoilt.by;
}

static void spoilt_jet(int32_t count, const sp_pair *in, sp_pair *out) {
    spoilt.sound->jet(count, in, out);
    spoil(count, in, out, spoilt.sound->kind == SP_IMPLICIT ? SP_IMPLICIT_JET : SP_PARAMETRIC_JET);
}

static void spoilt_value(int32_t count, const sp_pair *in, sp_pair *out) {
    spoilt.sound->value(count, in, out);
    spoil(count, in, out, spoilt.sound->kind == SP_IMPLICIT ? SP_IMPLICIT_VALUES : SP_PARAMETRIC_VALUES);
}

static struct sp_arena arena;

static int are_finite(const double *numbers, int32_t count) {
    for (int32_t i = 0; numbers && i < count; i++)
        if (!isfinite(numbers[i])) return 0;
    return 1;
}

static void check_path(const char *what, int32_t status, double length, const double *points, const double *parameters, int32_t count) {
    int known = status >= -10 && status <= 10;
    CHECK(known && are_finite(points, 3 * count) && are_finite(parameters, 2 * count), "%s: status %d, length %g; beyond %g: %g, manner %d",
          what, status, length, spoilt.beyond, spoilt.by, spoilt.manner);
    CHECK(status < 0 ? isnan(length) && !points && !parameters : isfinite(length) && length >= 0, "%s: status %d, length %g", what, status,
          length);
}

static void check_solve(const struct sp_surface *surface, const double from[3], const double to[3], int32_t algorithm) {
    struct sp_request request = {.from = {from[0], from[1], from[2]}, .to = {to[0], to[1], to[2]}};
    struct sp_options options;
    struct sp_result result;
    sp_default_options(&options);
    options.algorithm = algorithm, options.point_count = 13;
    sp_solve_path(surface, &request, &options, &arena, &result);
    check_path("solve", result.status, result.length, result.points, result.parameters, 15);
}

static void check_trace(const struct sp_surface *surface, const double from[3], const double to[3], double length) {
    struct sp_trace_request request = {{from[0], from[1], from[2]}, {to[0] - from[0], to[1] - from[1], to[2] - from[2]}, length};
    struct sp_trace_options options;
    struct sp_trace_result result;
    sp_default_trace_options(&options);
    options.point_count = 13, options.max_steps = 3000;
    sp_trace_path(surface, &request, &options, &arena, &result);
    if (!result.normal) check_path("trace", result.status, result.length, result.points, result.parameters, 15);
}

static void check_others(const struct sp_surface *surface, const double from[3], const double to[3]) {
    double place[3] = {from[0], from[1], from[2]};
    int32_t status = sp_project_point(surface, to, place);
    CHECK(are_finite(place, 3), "project: status %d, %g %g %g", status, place[0], place[1], place[2]);
    struct sp_graph_options options = {{-5.7, 5.7, -5.7, 5.7, -5.7, 5.7}, 0, 12, 0, 0, 0};
    struct sp_graph graph;
    if (surface->kind == SP_PARAMETRIC) options = (struct sp_graph_options){{-1, 1, -1.1, 1.1}, 0, 12, 0, 0, 0};
    status = sp_graph_build(surface, &options, &arena, &graph);
    CHECK(status == SP_CONVERGED || status == SP_NOT_FINITE || status == SP_OUT_OF_MEMORY, "graph: status %d", status);
    if (status != SP_CONVERGED) return;
    void *kept = aligned_alloc(16, ((size_t)sp_graph_bytes(&graph) + 31) & ~(size_t)15);
    sp_graph_keep(&graph, kept);
    double ends[6] = {from[0], from[1], from[2], to[0], to[1], to[2]};
    struct sp_graph_answer answer;
    status = sp_graph_search(surface, &graph, ends, 9, 1, &arena, &answer);
    int32_t numbers = answer.candidate_count * answer.point_count * (surface->kind == SP_IMPLICIT ? 3 : 2);
    CHECK((status == SP_CONVERGED) == (answer.candidate_count > 0), "search: status %d, %d candidates", status, answer.candidate_count);
    CHECK(are_finite(answer.places, numbers), "search: status %d; beyond %g: %g, manner %d", status, spoilt.beyond, spoilt.by,
          spoilt.manner);
    free(kept);
}

static void check_mesh(void) {
    const double box[6] = {-5.7, 5.7, -5.7, 5.7, -5.7, 5.7};
    struct sp_mesh mesh;
    arena.used = 0;
    int32_t status = sp_mesh_implicit(spoilt_value, box, 10, &arena, &mesh);
    CHECK(status == SP_CONVERGED, "mesh: status %d", status);
    for (int32_t i = 0; i < mesh.vertex_count; i++) {
        const double *p = mesh.positions + 3 * i;
        CHECK(are_finite(p, 3) || (isnan(p[0]) && isnan(p[1]) && isnan(p[2])), "mesh: vertex %d at %g %g %g", i, p[0], p[1], p[2]);
    }
}

static void check_surface(const struct sp_surface *sound, const double from[3], const double to[3]) {
    const double by[][2] = {{NAN, 0}, {INFINITY, 0}, {0, 0}, {1e200, 0}, {-1, 1}, {1e-180, 1}, {1e150, 1}, {3, 1}};
    struct sp_surface surface = *sound;
    int step = getenv("EVERY_SAMPLE") ? 2 : 4;
    surface.jet = spoilt_jet, surface.value = spoilt_value, spoilt.sound = sound;
    for (int i = 0; i < 8; i++)
        for (spoilt.manner = 0; spoilt.manner < MANNERS; spoilt.manner++)
            /* Every other one of the places, or every fourth, in turn: each with so much of the numbers and manners. */
            for (int part = -1 + (i + spoilt.manner) % step; part < 6; part += step) {
                spoilt.beyond = from[0] + (to[0] - from[0]) * part / 5 + 1e-3, spoilt.by = by[i][0], spoilt.is_factor = by[i][1] != 0;
                for (int32_t algorithm = SP_ELEMENTS; algorithm <= SP_PAPER; algorithm++)
                    check_solve(&surface, from, to, algorithm), check_solve(&surface, to, from, algorithm);
                check_trace(&surface, from, to, 3), check_trace(&surface, to, from, 3);
                check_others(&surface, from, to), check_others(&surface, to, from);
                if (sound->kind == SP_IMPLICIT) check_mesh();
            }
}

int main(void) {
    arena = (struct sp_arena){aligned_alloc(16, 1 << 25), 1 << 25, 0};
    check_surface(&saddle_surface, (double[]){-0.8, -0.5, 0}, (double[]){0.7, 0.9, 0});
    check_surface(&torus_surface, (double[]){-5.5, 0, 0}, (double[]){0, 5.5, 0});
    free(arena.base);
    return checks_failed();
}
