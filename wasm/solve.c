/* From a request to a result: calls the stages in order. The only file that knows them all. */
#include "check.h"
#include "functions.h"
#include "newton.h"
#include "start.h"
#include "surfpath.h"

static double not_a_number(void) { return __builtin_nan(""); }

void sp_default_options(struct sp_options *options) { *options = (struct sp_options){0, SP_POLYLINE, 64, 100, 0}; }

static int32_t clamp(int32_t x, int32_t least, int32_t most) { return x < least ? least : x > most ? most : x; }

static struct sp_options clamped(const struct sp_options *options) {
    struct sp_options clean = *options;
    clean.point_count = clamp(clean.point_count, 1, 100000);
    clean.max_iterations = clamp(clean.max_iterations, 0, 10000);
    return clean;
}

double sp_solve_bytes(int32_t kind, const struct sp_options *options, int32_t start_count) {
    struct sp_options clean = clamped(options);
    return sp_newton_bytes(kind, &clean) + 5 * (clean.point_count + 2.0) * sizeof(double) + 8.0 * start_count + 4 * 16;
}

/* Takes the places and charts apart into the arrays of the result. `reversed`: the path was solved from `to`. */
static int write_points(const struct sp_polyline *line, int reversed, struct sp_arena *arena, struct sp_result *result) {
    int32_t last = line->fold.inner + 1;
    result->points = sp_arena_take(arena, 3 * ((size_t)last + 1), sizeof(double));
    if (!result->points) return 0;
    if (line->surface->kind == SP_PARAMETRIC) {
        result->parameters = sp_arena_take(arena, 2 * ((size_t)last + 1), sizeof(double));
        if (!result->parameters) return 0;
    }
    for (int32_t i = 0; i <= last; i++) {
        int32_t to = reversed ? last - i : i;
        for (int32_t j = 0; j < 3; j++)
            result->points[3 * to + j] = sp_fold_get(line->fold, line->nodes.charts, SP_CHART, i, j);
        for (int32_t j = 0; result->parameters && j < 2; j++)
            result->parameters[2 * to + j] = sp_fold_get(line->fold, line->nodes.places, 2, i, j);
    }
    return 1;
}

/* Recorded polylines of a reversed solve run from `to`: turned round in place. */
static void reverse_record(double *record, int32_t polylines, int32_t points) {
    for (int32_t p = 0; record && p < polylines; p++) {
        double *polyline = record + (size_t)p * 3 * (size_t)points;
        for (int32_t i = 0, j = points - 1; i < j; i++, j--)
            for (int k = 0; k < 3; k++) {
                double kept = polyline[3 * i + k];
                polyline[3 * i + k] = polyline[3 * j + k], polyline[3 * j + k] = kept;
            }
    }
}

/* The ends in the order in which they are solved: without a given start the lexicographically smaller first. */
static int order_ends(const struct sp_surface *surface, const struct sp_request *request, double from[3], double to[3]) {
    int reversed = 0, dimension = sp_kind_of(surface)->dimension;
    for (int j = 0; j < dimension && !request->start; j++) {
        if (request->from[j] == request->to[j]) continue;
        reversed = request->from[j] > request->to[j];
        break;
    }
    for (int j = 0; j < dimension; j++)
        from[j] = reversed ? request->to[j] : request->from[j], to[j] = reversed ? request->from[j] : request->to[j];
    return reversed;
}

/* The two end charts must be regular enough to leave from: finite, and the metric not zero in every direction. */
static enum sp_status check_ends(const struct sp_polyline *line) {
    const sp_pair *chart = line->nodes.charts;
    sp_pair e = sp_dot(sp_load(chart + SP_CHART_1), sp_load(chart + SP_CHART_1)),
            g = sp_dot(sp_load(chart + SP_CHART_2), sp_load(chart + SP_CHART_2));
    if (sp_any((e + g) == sp_splat(0.0))) return SP_SINGULAR_METRIC;
    return SP_CONVERGED;
}

static void fill(const struct sp_outcome *outcome, const struct sp_newton *newton, struct sp_result *result) {
    double segments = newton->line.fold.inner + 1;
    result->length = sp_check_length(&newton->line);
    result->length_error = sp_check_length_error(&newton->line, outcome->active);
    result->energy = segments * outcome->squares, result->gradient_norm = outcome->gradient_norm;
    result->iterations = outcome->iterations, result->index = outcome->index, result->touches_boundary = outcome->active;
    result->history = newton->history, result->history_count = outcome->history_count, result->record = newton->record;
}

/* The stages in order; the first that fails decides. */
static enum sp_status solve(const struct sp_surface *surface, const struct sp_request *request, const struct sp_options *options,
                            struct sp_arena *arena, struct sp_result *result) {
    struct sp_newton newton = {0};
    double from[3] = {0}, to[3] = {0};
    if (!sp_newton_take(&newton, surface, options, arena)) return SP_OUT_OF_MEMORY;
    int reversed = order_ends(surface, request, from, to);
    newton.scale = sp_start_scale(surface, request);
    enum sp_status status = sp_start_end(surface, newton.scale, from);
    if (status == SP_CONVERGED) status = sp_start_end(surface, newton.scale, to);
    if (status == SP_CONVERGED) status = sp_start_polyline(&newton.line, request, from, to, newton.scale, arena);
    if (status != SP_CONVERGED) return status;
    struct sp_outcome outcome = sp_newton_run(&newton, options);
    if (outcome.status < 0) return (enum sp_status)outcome.status;
    status = check_ends(&newton.line);
    if (status == SP_CONVERGED) status = sp_check_chords(&newton.line, newton.scale);
    if (status < 0) return status;
    fill(&outcome, &newton, result);
    if (reversed) reverse_record(newton.record, outcome.history_count, options->point_count + 2);
    if (!write_points(&newton.line, reversed, arena, result)) return SP_OUT_OF_MEMORY;
    return status > 0 ? status : (enum sp_status)outcome.status;
}

int32_t sp_solve_path(const struct sp_surface *surface, const struct sp_request *request, const struct sp_options *options,
                      struct sp_arena *arena, struct sp_result *result) {
    struct sp_result none = {
        .length = not_a_number(), .length_error = not_a_number(), .energy = not_a_number(), .gradient_norm = not_a_number(), .index = -1};
    struct sp_options clean = clamped(options);
    arena->used = 0;
    *result = none;
    enum sp_status status = solve(surface, request, &clean, arena, result);
    if (status < 0) *result = none;
    result->status = status;
    return status;
}
