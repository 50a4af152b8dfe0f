/* Distances from one point to many through a graph: against closed forms in space and in a metric, and in what order they are found;
 * unreachable places, memory; and the curvature of a metric, by which geodesics are known to be unique. */
#include "graph_field.h"
#include "graph_search.h"
#include "metric.h"
#include "scalar.h"
#include "surfaces.h"
#include "testing.h"

#include <math.h>
#include <stdlib.h>

enum { PLACES = 200 };

/* The hyperbolic half-plane: E = G = 1/v^2, F = 0. */
static void half_plane_jet(int32_t count, const sp_pair *in, sp_pair *out) {
    for (; count > 0; count--, in += 2, out += SP_PARAMETRIC_TENSOR_JET) {
        sp_pair v = in[1], zero = sp_splat(0.0), metric[6] = {1.0 / (v * v), zero, -2.0 / (v * v * v), zero, zero, 6.0 / (v * v * v * v)};
        for (int part = 0; part < 6; part++)
            out[3 * part] = out[3 * part + 2] = metric[part], out[3 * part + 1] = zero;
    }
}

/* Twice as long as in space: phi = 4. */
static void heavy_sphere_jet(int32_t count, const sp_pair *in, sp_pair *out) {
    for (; count > 0; count--, in += 3, out += SP_IMPLICIT_DENSITY_JET) {
        sp_pair jet[SP_IMPLICIT_JET];
        sphere_jet(1, in, jet);
        for (int j = 0; j < SP_IMPLICIT_JET; j++)
            out[2 * j] = jet[j], out[2 * j + 1] = sp_splat(j ? 0.0 : 4.0);
    }
}

static const struct sp_surface half_plane = {half_plane_jet, NULL, SP_PARAMETRIC, SP_TENSOR, {-2, 0.2}, {2, 4}, 0};
static const struct sp_surface heavy_sphere = {heavy_sphere_jet, sphere_value, SP_IMPLICIT, SP_DENSITY, {0, 0}, {0, 0}, 4};
static const struct sp_graph_options half_plane_box = {{-2, 2, 0.2, 4}, 0, 64, 0, 0, 0};
static const struct sp_graph_options sphere_box = {{-1.2, 1.2, -1.2, 1.2, -1.2, 1.2}, 0, 40, 0, 0, 0};

static struct sp_arena allocate_arena(double bytes) {
    size_t size = ((size_t)bytes + 15) & ~(size_t)15;
    return (struct sp_arena){aligned_alloc(16, size), size, 0};
}

static double half_plane_distance(const double *a, const double *b) {
    return acosh(1 + (pow(a[0] - b[0], 2) + pow(a[1] - b[1], 2)) / (2 * a[1] * b[1]));
}

static double heavy_distance(const double *a, const double *b) { return 2 * acos(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]); }

static void half_plane_place(uint64_t *state, double *place) {
    place[0] = 4 * random_unit(state) - 2, place[1] = 0.2 + 3.8 * random_unit(state);
}

static void sphere_place(uint64_t *state, double *place) {
    double turn = 6.283185307179586 * random_unit(state), z = 2 * random_unit(state) - 1, r = sqrt(1 - z * z);
    place[0] = r * cos(turn), place[1] = r * sin(turn), place[2] = z;
}

/* Every distance is at most 3 % and a part of a cell too long, and hardly too short; with less memory than is asked for, none. */
static void check_field(const struct sp_surface *surface, const struct sp_graph_options *options,
                        double (*truth)(const double *, const double *), void (*choose)(uint64_t *, double *), int32_t dimension) {
    struct sp_arena build = allocate_arena(4 * sp_graph_build_bytes(surface->kind, options));
    struct sp_graph graph;
    double places[3 * PLACES], lengths[PLACES];
    uint64_t state = 7;
    CHECK(sp_graph_build(surface, options, &build, &graph) == SP_CONVERGED, "the graph");
    struct sp_field_request request = {{0, 0, 0}, places, lengths, PLACES, 0};
    choose(&state, request.from);
    for (int i = 0; i < PLACES; i++)
        choose(&state, places + dimension * i);
    double enough = sp_graph_field_bytes(&graph, PLACES);
    for (double part = 0.1; part < 1; part += 0.2) {
        struct sp_arena less = allocate_arena(part * enough);
        CHECK(sp_graph_field(surface, &graph, &request, &less) == SP_OUT_OF_MEMORY, "%g of the memory", part);
        free(less.base);
    }
    struct sp_arena arena = allocate_arena(enough);
    CHECK(sp_graph_field(surface, &graph, &request, &arena) == SP_CONVERGED, "the field");
    for (int i = 0; i < PLACES; i++) {
        double length = truth(request.from, places + dimension * i);
        CHECK(lengths[i] < 1.03 * length + 0.02 && lengths[i] > 0.995 * length, "place %d, seed 7: %g, not %g", i, lengths[i], length);
    }
    request.from[0] = NAN;
    CHECK(sp_graph_field(surface, &graph, &request, &arena) == SP_NOT_FINITE, "from nowhere");
    free(arena.base);
    free(build.base);
}

static void check_curvature(void) {
    struct sp_point point;
    sp_metric_point(&half_plane, (sp_pair[2]){{0.3, -1}, {0.7, 2}}, &point);
    for (int lane = 0; lane < 2; lane++)
        CHECK(fabs(point.geometry.curvature[lane] + 1) < 1e-14, "half-plane: %g", point.geometry.curvature[lane]);
    sp_metric_point(&heavy_sphere, (sp_pair[3]){{0.6, 0}, {0, -1}, {0.8, 0}}, &point);
    for (int lane = 0; lane < 2; lane++)
        CHECK(fabs(point.geometry.curvature[lane] - 0.25) < 1e-14, "sphere of radius 2: %g", point.geometry.curvature[lane]);
}

/* A half-plane has curvature -1; its graph says that geodesics are unique. */
static void check_unique(void) {
    struct sp_arena arena = allocate_arena(4 * sp_graph_build_bytes(SP_PARAMETRIC, &half_plane_box));
    struct sp_graph graph;
    sp_graph_build(&half_plane, &half_plane_box, &arena, &graph);
    CHECK(graph.unique == 1, "no curvature above 0");
    free(arena.base);
}

/* As long as some edge leads to a shorter way it is taken: what Dijkstra's algorithm, and any order of visits, must come to, to the bit. */
static void relax(const struct sp_graph *graph, double *distance) {
    for (int changed = 1; changed;) {
        changed = 0;
        for (int32_t i = 0; i < graph->vertex_count; i++)
            for (int32_t k = graph->first[i]; k < graph->first[i + 1]; k++) {
                double by = distance[i] + (double)graph->edges[k].length;
                if (by < distance[graph->edges[k].to]) distance[graph->edges[k].to] = by, changed = 1;
            }
    }
}

/* A search in stages: at the end of each all that is nearer than its limit is known exactly, whatever waits beyond, and nothing known as
 * nearer than it is. With a target the keys are those of A*. More seeds may come when all was visited. */
static void check_order(const struct sp_surface *surface, const struct sp_graph_options *options, int led) {
    struct sp_arena build = allocate_arena(4 * sp_graph_build_bytes(surface->kind, options));
    struct sp_graph graph;
    struct sp_front front;
    CHECK(sp_graph_build(surface, options, &build, &graph) == SP_CONVERGED, "the graph");
    struct sp_arena arena = allocate_arena(graph.vertex_count * (double)SP_FRONT_BYTES + 16);
    CHECK(sp_front_take(&front, &graph, &arena), "room for a front");
    double *exact = malloc((size_t)graph.vertex_count * sizeof(double));
    for (int32_t i = 0; i < graph.vertex_count; i++)
        exact[i] = (double)INFINITY;
    if (led) front.target = graph.samples + (size_t)graph.width * (size_t)(graph.vertex_count / 3), front.stretch = 0.5 * graph.stretch;
    for (int32_t seed = 0; seed < graph.vertex_count; seed += graph.vertex_count / 2) {
        sp_front_offer(&front, seed, -1, 0);
        exact[seed] = 0;
        relax(&graph, exact);
        for (double limit = graph.step; front.least < (double)INFINITY || front.near_count; limit *= 2) {
            int32_t wrong = 0;
            sp_front_advance(&front, limit);
            for (int32_t i = 0; i < graph.vertex_count; i++) {
                double key = exact[i], known = front.distance[i];
                if (front.target) key += front.stretch * distance_between(graph.samples + (size_t)graph.width * (size_t)i, front.target);
                wrong += known < exact[i] || (key < limit * (1 - 1e-12) && known > exact[i]);
            }
            CHECK(wrong == 0, "%d distances below %g, seed %d", wrong, limit, seed);
            CHECK(front.far_count <= graph.vertex_count, "%d wait", front.far_count);
        }
        for (int32_t i = 0; i < graph.vertex_count; i++)
            CHECK(!(front.distance[i] != exact[i]), "vertex %d: %g, not %g", i, front.distance[i], exact[i]);
    }
    free(exact);
    free(arena.base);
    free(build.base);
}

int main(void) {
    check_curvature();
    check_unique();
    check_order(&half_plane, &half_plane_box, 0);
    check_order(&heavy_sphere, &sphere_box, 0);
    check_order(&heavy_sphere, &sphere_box, 1);
    check_field(&half_plane, &half_plane_box, half_plane_distance, half_plane_place, 2);
    check_field(&heavy_sphere, &sphere_box, heavy_distance, sphere_place, 3);
    return checks_failed();
}
