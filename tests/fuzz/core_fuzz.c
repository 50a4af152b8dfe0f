/* Every exported C function that takes a surface, called with random structs, sizes and hostile surfaces, by libFuzzer under the address
 * and undefined-behaviour sanitizers. What must hold whatever the input: no access outside the arena, a status of the list, no path of
 * numbers that are not finite, no path at all behind a negative status. */
#include "hostile.h"
#include "surfpath.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

#define DEMAND(condition, ...)                                                                                                             \
    do {                                                                                                                                   \
        if (!(condition)) {                                                                                                                \
            fprintf(stderr, "%s:%d: %s: ", __FILE__, __LINE__, #condition);                                                                \
            fprintf(stderr, __VA_ARGS__);                                                                                                  \
            fprintf(stderr, "\n");                                                                                                         \
            abort();                                                                                                                       \
        }                                                                                                                                  \
    } while (0)

/* The input, read from the front; zeros when it is used up. */
struct input {
    const uint8_t *at;
    size_t left;
};

static uint8_t read_byte(struct input *input) {
    if (input->left == 0) return 0;
    input->left--;
    return *input->at++;
}

static int32_t read_integer(struct input *input, int32_t least, int32_t most) {
    uint32_t bits = read_byte(input);
    bits |= (uint32_t)read_byte(input) << 8;
    return least + (int32_t)(bits % (uint32_t)(most - least + 1));
}

/* Mostly a plain number; else a special one, or any bits. */
static double read_number(struct input *input) {
    static const double special[] = {
        0,     -0.0, 1,      -1,  __builtin_nan(""), __builtin_inf(), -__builtin_inf(), 1e308, -1e308, 5e-324, 1e-200, 1e200,
        1e-17, 1e17, 0x1p53, 1e-9};
    uint8_t how = read_byte(input);
    if (how < 192) return (how % 16 + read_byte(input) / 256.0) * (how & 16 ? -0.25 : 0.25);
    if (how < 240) return special[how % 16];
    uint64_t bits = 0;
    for (int i = 0; i < 8; i++)
        bits = bits << 8 | read_byte(input);
    double number;
    memcpy(&number, &bits, sizeof number);
    return number;
}

static void read_numbers(struct input *input, double *numbers, int count) {
    for (int i = 0; i < count; i++)
        numbers[i] = read_number(input);
}

static struct sp_surface read_surface(struct input *input) {
    uint8_t what = read_byte(input), walls = read_byte(input);
    struct hostility hostility = {read_byte(input) % MOOD_COUNT, read_number(input), read_number(input)};
    struct sp_surface surface = hostile_surface(what & 1, (what >> 1) % 3, what >> 3, hostility);
    for (int j = 0; j < 2; j++) {
        if (walls >> j & 1) surface.lower[j] = read_number(input);
        if (walls >> j & 4) surface.upper[j] = read_number(input);
    }
    if (walls & 16) surface.extent = read_number(input);
    if (walls & 32 && surface.kind == SP_PARAMETRIC && surface.metric == SP_TENSOR) surface.value = NULL;
    return surface;
}

/* An arena of exactly the bytes asked for, or of a part of them. `whole`: out, whether it is all of them. */
static struct sp_arena read_arena(struct input *input, double bytes, int *whole) {
    uint8_t part = read_byte(input);
    DEMAND(bytes >= 0 && bytes < 1e9, "%g bytes", bytes);
    *whole = part < 192;
    size_t size = *whole ? (size_t)bytes : (size_t)(bytes * (part - 192) / 64);
    struct sp_arena arena = {malloc(size ? size : 1), size, 0};
    DEMAND(arena.base, "no memory");
    return arena;
}

static int is_finite(double x) { return x - x == 0; }

static void demand_inside(const struct sp_arena *arena, const void *at, size_t bytes) {
    const char *first = at;
    DEMAND(first >= arena->base && first + bytes <= arena->base + arena->size, "an array outside the arena");
}

/* An array of the result: in the arena, and finite. */
static void demand_numbers(const struct sp_arena *arena, const double *numbers, size_t count, const char *what) {
    demand_inside(arena, numbers, count * sizeof *numbers);
    for (size_t i = 0; i < count; i++)
        DEMAND(is_finite(numbers[i]), "%s[%zu] = %g", what, i, numbers[i]);
}

static struct sp_options read_options(struct input *input) {
    struct sp_options options;
    sp_default_options(&options);
    uint8_t given = read_byte(input);
    if (given & 1) options.tolerance = read_number(input);
    if (given & 2) options.gradient_tolerance = read_number(input);
    options.algorithm = given & 4 ? read_integer(input, 0, 2) : SP_ELEMENTS;
    options.point_count = given & 8 ? read_integer(input, -2, 100) : 7;
    options.max_iterations = given & 16 ? read_integer(input, -2, 50) : 20;
    options.record = given >> 5 & 1;
    return options;
}

/* Both ends lie in the rectangle. */
static int are_within(const struct sp_surface *surface, const struct sp_request *request) {
    int within = 1;
    for (int j = 0; j < 2; j++)
        within &= request->from[j] >= surface->lower[j] && request->from[j] <= surface->upper[j] && request->to[j] >= surface->lower[j] &&
                  request->to[j] <= surface->upper[j];
    return within;
}

static void check_path(const struct sp_surface *surface, const struct sp_request *request, const struct sp_options *options,
                       const struct sp_arena *arena, const struct sp_result *result) {
    size_t count = (size_t)(options->point_count < 1 ? 1 : options->point_count) + 2;
    if (result->status < 0) {
        DEMAND(!result->points && !result->parameters && !result->history && !result->record && result->history_count == 0, "status %d",
               result->status);
        DEMAND(isnan(result->length) && isnan(result->length_error), "length %g", result->length);
        return;
    }
    DEMAND(result->length >= 0 && is_finite(result->length), "status %d, length %g", result->status, result->length);
    DEMAND(result->length_error >= 0 && (result->status != SP_CONVERGED || is_finite(result->length_error)), "status %d, length_error %g",
           result->status, result->length_error);
    DEMAND((result->points != NULL) == (surface->value != NULL), "points");
    if (result->points) demand_numbers(arena, result->points, 3 * count, "points");
    DEMAND((result->parameters != NULL) == (surface->kind == SP_PARAMETRIC), "parameters");
    if (result->parameters) {
        const double *last = result->parameters + 2 * count - 2;
        demand_numbers(arena, result->parameters, 2 * count, "parameters");
        /* In a chart around a pole the end is the lift that the path leads to. */
        double turn = request->passage.way == SP_POINT_CHART ? request->passage.turn : 0;
        for (int j = 0; j < 2 && are_within(surface, request); j++)
            DEMAND(result->parameters[j] == request->from[j] &&
                       (last[j] == request->to[j] || last[j] == request->to[j] + turn || last[j] == request->to[j] - turn),
                   "coordinate %d: from %g to %g, not from %g to %g", j, result->parameters[j], last[j], request->from[j], request->to[j]);
    }
    DEMAND(result->history_count >= 0, "history_count %d", result->history_count);
    if (result->history_count > 0) demand_inside(arena, result->history, (size_t)result->history_count * sizeof *result->history);
    DEMAND(options->record || !result->record, "a record that was not asked for");
    if (result->record) demand_inside(arena, result->record, (size_t)result->history_count * 3 * count * sizeof(double));
}

static void fuzz_solve(struct input *input) {
    struct sp_surface surface = read_surface(input);
    struct sp_options options = read_options(input);
    struct sp_request request = {0};
    int dimension = surface.kind == SP_IMPLICIT ? 3 : 2, whole;
    read_numbers(input, request.from, 3);
    read_numbers(input, request.to, 3);
    uint8_t given = read_byte(input);
    double *start = NULL;
    if (given & 1) {
        request.start_count = read_integer(input, 2, 70);
        request.start = start = malloc(sizeof(double) * (size_t)(dimension * request.start_count));
        read_numbers(input, start, dimension * request.start_count);
    }
    if (given & 2) {
        double numbers[2];
        read_numbers(input, numbers, 2);
        request.passage =
            (struct sp_passage){read_integer(input, SP_FREE, SP_BESIDE_POINT), read_integer(input, -2, 5), numbers[0], numbers[1]};
    }
    struct sp_arena arena = read_arena(input, sp_solve_bytes(&surface, &options, request.start_count), &whole);
    struct sp_result result;
    memset(&result, 0xa5, sizeof result);
    int32_t status = sp_solve_path(&surface, &request, &options, &arena, &result);
    DEMAND(status == result.status, "%d and %d", status, result.status);
    DEMAND((status >= SP_CONVERGED && status <= SP_SADDLE) || (status >= SP_OUT_OF_MEMORY && status <= SP_SINGULAR_METRIC), "status %d",
           status);
    DEMAND(!whole || status != SP_OUT_OF_MEMORY, "the promised size is not enough");
    check_path(&surface, &request, &options, &arena, &result);
    free(arena.base), free(start);
}

static void fuzz_trace(struct input *input) {
    struct sp_surface surface = read_surface(input);
    if (surface.metric != SP_INDUCED) surface = hostile_surface(surface.kind, SP_INDUCED, 0, (struct hostility){SOUND, 0, 0});
    struct sp_trace_request request;
    struct sp_trace_options options;
    sp_default_trace_options(&options);
    read_numbers(input, request.from, 3);
    read_numbers(input, request.direction, 3);
    request.length = read_number(input);
    uint8_t given = read_byte(input);
    if (given & 1) options.tolerance = read_number(input);
    if (given & 2) options.point_count = read_integer(input, -2, 100);
    options.max_steps = given & 4 ? read_integer(input, -2, 1000) : 100;
    int whole;
    struct sp_arena arena = read_arena(input, sp_trace_bytes(surface.kind, &options), &whole);
    struct sp_trace_result result;
    memset(&result, 0xa5, sizeof result);
    int32_t status = sp_trace_path(&surface, &request, &options, &arena, &result);
    size_t count = (size_t)(options.point_count < 1 ? 1 : options.point_count) + 2;
    DEMAND(status == result.status && status <= SP_EDGE_REACHED && status >= SP_OUT_OF_MEMORY, "status %d", status);
    DEMAND(!whole || status != SP_OUT_OF_MEMORY, "the promised size is not enough");
    DEMAND(status >= 0 || (isnan(result.length) && !result.points && !result.parameters), "a path behind status %d", status);
    DEMAND(status < 0 || (result.length >= 0 && result.length <= request.length), "length %g of %g", result.length, request.length);
    DEMAND(status < 0 || isnan(result.conjugate) || (result.conjugate >= 0 && result.conjugate <= result.length), "conjugate %g",
           result.conjugate);
    if (status >= 0) demand_numbers(&arena, result.points, 3 * count, "points");
    if (status >= 0 && result.parameters) demand_numbers(&arena, result.parameters, 2 * count, "parameters");
    free(arena.base);
}

static void fuzz_project(struct input *input) {
    struct sp_surface surface = read_surface(input);
    if (surface.metric != SP_INDUCED) surface = hostile_surface(surface.kind, SP_INDUCED, 0, (struct hostility){SOUND, 0, 0});
    double point[3], place[3], before[3];
    int dimension = surface.kind == SP_IMPLICIT ? 3 : 2;
    read_numbers(input, point, 3);
    read_numbers(input, place, 3);
    memcpy(before, place, sizeof place);
    int32_t status = sp_project_point(&surface, point, place);
    DEMAND(status == SP_CONVERGED || status == SP_STALLED || status == SP_OFF_SURFACE || status == SP_NOT_FINITE, "status %d", status);
    DEMAND(status >= 0 || memcmp(before, place, sizeof place) == 0, "the place moved, status %d", status);
    for (int j = 0; status >= 0 && j < dimension; j++)
        DEMAND(is_finite(place[j]), "place[%d] = %g", j, place[j]);
}

static void fuzz_mesh(struct input *input) {
    struct sp_surface surface = read_surface(input);
    if (surface.kind != SP_IMPLICIT) return;
    double box[6] = {-6, 6, -6, 6, -2, 2};
    if (read_byte(input) & 1) read_numbers(input, box, 6);
    int32_t resolution = read_integer(input, -1, 24);
    struct sp_mesh mesh = {0};
    for (int attempt = 0; attempt < 3; attempt++) {
        int whole;
        struct sp_arena arena = read_arena(input, sp_mesh_bytes(box, resolution, mesh.vertex_count, mesh.triangle_count), &whole);
        int32_t status = sp_mesh_implicit(surface.value, box, resolution, &arena, &mesh);
        DEMAND(status == SP_CONVERGED || status == SP_NOT_FINITE || status == SP_OUT_OF_MEMORY, "status %d", status);
        DEMAND(status == SP_CONVERGED || !mesh.positions, "a mesh behind status %d", status);
        DEMAND(mesh.vertex_count >= 0 && mesh.triangle_count >= 0, "counts %d, %d", mesh.vertex_count, mesh.triangle_count);
        if (status == SP_CONVERGED) {
            demand_inside(&arena, mesh.positions, 3 * sizeof(double) * (size_t)mesh.vertex_count);
            demand_inside(&arena, mesh.normals, 3 * sizeof(double) * (size_t)mesh.vertex_count);
            for (int32_t i = 0; i < mesh.vertex_count; i++) {
                const double *p = mesh.positions + 3 * i;
                DEMAND(is_finite(p[0] + p[1] + p[2]) || (p[0] != p[0] && p[1] != p[1] && p[2] != p[2]), "vertex %d at %g", i, p[0]);
            }
            for (int32_t i = 0; i < 3 * mesh.triangle_count; i++)
                DEMAND(mesh.indices[i] >= 0 && mesh.indices[i] < mesh.vertex_count, "index %d of %d", mesh.indices[i], mesh.vertex_count);
        }
        free(arena.base);
    }
}

static struct sp_graph_options read_graph_options(struct input *input, int32_t kind) {
    struct sp_graph_options options = {{-1, 1, -1, 1, 0, 0}, 0, 8, 0, 0, 0};
    if (kind == SP_IMPLICIT) options = (struct sp_graph_options){{-6, 6, -6, 6, -2, 2}, 0, 8, 0, 0, 0};
    uint8_t given = read_byte(input);
    if (given & 1) read_numbers(input, options.box, 6);
    if (given & 2 && kind == SP_IMPLICIT) options.cell = read_number(input);
    if (given & 4) options.resolution = read_integer(input, -1, 20);
    if (given & 8) options.reach = read_number(input);
    if (given & 16) options.level = read_integer(input, 0, 2);
    if (given & 32) options.loose = read_integer(input, 0, 2);
    return options;
}

static void check_answer(const struct sp_arena *arena, const struct sp_graph_answer *answer, int32_t status, int dimension) {
    DEMAND(status == SP_CONVERGED || status == SP_DISCONNECTED || status == SP_OFF_SURFACE || status == SP_NOT_FINITE ||
               status == SP_OUT_OF_MEMORY,
           "status %d", status);
    DEMAND(answer->candidate_count >= 0 && answer->candidate_count <= SP_GRAPH_MAX_CANDIDATES, "%d candidates", answer->candidate_count);
    DEMAND(status == SP_CONVERGED || answer->candidate_count == 0, "candidates behind status %d", status);
    DEMAND(status != SP_CONVERGED || (answer->distance >= 0 && is_finite(answer->distance)), "distance %g", answer->distance);
    if (answer->candidate_count == 0) return;
    demand_numbers(arena, answer->places, (size_t)(answer->candidate_count * answer->point_count * dimension), "places");
}

static void fuzz_search(struct input *input, const struct sp_surface *surface, const struct sp_graph *graph) {
    double ends[6], lengths[8];
    int dimension = surface->kind == SP_IMPLICIT ? 3 : 2, whole;
    read_numbers(input, ends, 6);
    int32_t points = read_integer(input, 2, 80);
    struct sp_arena arena = read_arena(input, sp_graph_search_bytes(graph, points), &whole);
    struct sp_graph_answer answer;
    memset(&answer, 0xa5, sizeof answer);
    int32_t status = sp_graph_search(surface, graph, ends, points, points & 1, &arena, &answer);
    DEMAND(!whole || status != SP_OUT_OF_MEMORY, "the promised size is not enough");
    check_answer(&arena, &answer, status, dimension);
    free(arena.base);
    double places[24];
    read_numbers(input, places, 24);
    struct sp_field_request field = {{ends[0], ends[1], ends[2]}, places, lengths, 8, 0};
    arena = read_arena(input, sp_graph_field_bytes(graph, 8), &whole);
    status = sp_graph_field(surface, graph, &field, &arena);
    DEMAND(!whole || status != SP_OUT_OF_MEMORY, "the promised size is not enough");
    for (int i = 0; status == SP_CONVERGED && i < 8; i++)
        DEMAND(lengths[i] >= 0, "length %g", lengths[i]);
    free(arena.base);
}

static void fuzz_graph(struct input *input) {
    struct sp_surface surface = read_surface(input);
    if (surface.metric != SP_INDUCED) surface = hostile_surface(surface.kind, SP_INDUCED, 0, (struct hostility){SOUND, 0, 0});
    struct sp_graph_options options = read_graph_options(input, surface.kind);
    struct sp_graph graph;
    int whole;
    struct sp_arena arena = read_arena(input, sp_graph_build_bytes(surface.kind, &options), &whole);
    int32_t status = sp_graph_build(&surface, &options, &arena, &graph);
    DEMAND(status == SP_CONVERGED || status == SP_NOT_FINITE || status == SP_OUT_OF_MEMORY, "status %d", status);
    if (status != SP_CONVERGED) {
        free(arena.base);
        return;
    }
    size_t bytes = (size_t)sp_graph_bytes(&graph);
    void *block = malloc(bytes ? bytes : 1);
    sp_graph_keep(&graph, block);
    free(arena.base);
    fuzz_search(input, &surface, &graph);
    free(block);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size) {
    static void (*const functions[])(struct input *) = {fuzz_solve,   fuzz_solve, fuzz_solve, fuzz_trace,
                                                        fuzz_project, fuzz_mesh,  fuzz_graph};
    struct input input = {bytes, size};
    functions[read_byte(&input) % (sizeof functions / sizeof *functions)](&input);
    return 0;
}
