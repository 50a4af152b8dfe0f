/* From a request to a result: calls the stages in order. The only file that knows them all. */
#include "check.h"
#include "contact.h"
#include "cusp.h"
#include "hole.h"
#include "metric_elements.h"
#include "normal.h"
#include "polar.h"
#include "pole.h"
#include "refine_chords.h"
#include "sample.h"
#include "scalar.h"
#include "start.h"
#include "surfpath.h"
#include <string.h>

void sp_default_options(struct sp_options *options) { *options = (struct sp_options){1e-9, 0, SP_ELEMENTS, 64, 200, 0}; }

static struct sp_options clamped(const struct sp_options *options) {
    struct sp_options clean = *options;
    clean.point_count = clamp(clean.point_count, 1, 100000);
    clean.max_iterations = clamp(clean.max_iterations, 0, 10000);
    if (!(clean.tolerance >= 1e-15)) clean.tolerance = 1e-15;
    return clean;
}

/* Most inner nodes that the solve will use. */
static int32_t inner_nodes(const struct sp_options *options) {
    return options->algorithm == SP_ELEMENTS ? SP_REFINE_INNER : options->point_count;
}

/* Of a start: its lengths, and its like in a chart around a pole. */
double sp_solve_bytes(const struct sp_surface *surface, const struct sp_options *options, int32_t start_count) {
    struct sp_options clean = clamped(options);
    double kept = (SP_REFINE_INNER / 2 + 3) * 3.0 * sizeof(sp_pair); /* the start, for arcs to begin from */
    double refine = clean.algorithm == SP_ELEMENTS ? sp_refine_bytes() + sp_arcs_bytes() + kept
                                                   : sp_refine_polyline_bytes(sp_kind_of(surface)->dimension, clean.point_count + 1);
    return sp_newton_bytes(surface, &clean, inner_nodes(&clean)) + refine + 5 * (clean.point_count + 2.0) * sizeof(double) +
           24.0 * start_count + 5 * 16;
}

/* A start of more points is thinned: on 512 chords and more projected Newton frees about one node a step from a wall that the path leaves.
 */
enum { FINEST_START = 256 };
/* One of more points than these is first taken as it is. */
enum { FINE_START = 2 * FINEST_START };

/* Inner nodes of the first path of chords: more than usual where a start of many points is given, which then keeps what it knows. */
static int32_t first_inner(const struct sp_request *request) {
    int32_t chords = SP_REFINE_FIRST + 1;
    while (chords < FINEST_START && chords + 1 < request->start_count)
        chords *= 2;
    return chords - 1;
}

/* Writes the points of the path into the result. However a surface that is not smooth, or NaN in places, has led the stages astray, what
 * is handed out is a path: SP_NOT_FINITE where it is none. */
static enum sp_status write_points(const struct sp_newton *newton, const struct sp_arcs *arcs, int32_t point_count, struct sp_arena *arena,
                                   struct sp_result *result) {
    const struct sp_surface *surface = newton->system.line.surface;
    int32_t count = point_count + 2, reversed = newton->reversed;
    enum sp_status status = SP_NOT_FINITE;
    result->points = surface->value ? sp_arena_take(arena, 3 * (size_t)count, sizeof(double)) : NULL;
    result->parameters = surface->kind == SP_PARAMETRIC ? sp_arena_take(arena, 2 * (size_t)count, sizeof(double)) : NULL;
    if ((surface->value && !result->points) || (surface->kind == SP_PARAMETRIC && !result->parameters)) return SP_OUT_OF_MEMORY;
    if (arcs->count)
        status = sp_arcs_sample(arcs, surface, newton->scale, point_count, reversed, result->points, result->parameters, arena);
    else if (sp_sample_points(&newton->system, newton->scale, point_count, reversed, result->points, result->parameters))
        status = SP_CONVERGED;
    double *last = newton->record && result->points ? newton->record + (size_t)(newton->history_count - 1) * 3 * (size_t)count : NULL;
    if (last) memcpy(last, result->points, 3 * (size_t)count * sizeof(double));
    return is_finite(result->length + result->length_error) ? status : SP_NOT_FINITE;
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

/* A length beside which those of the path are rounded: the size of the coordinates at its ends, in the metric; each the larger of |X_k| and
 * of what the rounding of the unknowns is a part of, |q_a B_ak|, around a pole that of the coordinate across its edge. An infinite
 * derivative says nothing. */
static double size_of(const struct sp_polyline *line) {
    const struct sp_nodes *nodes = &line->nodes;
    sp_pair least = sp_splat(line->surface->kind == SP_PARAMETRIC ? sp_polar_offset(line->surface) : 0);
    int32_t components = line->kind->components;
    sp_pair t[SP_METRIC_COMPONENTS], at[3];
    for (int32_t c = 0; c < components; c++)
        t[c] = sp_absolute(nodes->metrics[c]);
    for (int k = 0; k < 3; k++) {
        at[k] = sp_absolute(nodes->charts[SP_CHART_X + k]);
        for (int a = 0; a < 2; a++) {
            sp_pair part = sp_larger(least, sp_absolute(nodes->places[a])) * sp_absolute(nodes->charts[SP_CHART_1 + 3 * a + k]);
            at[k] = sp_select((part > at[k]) & (part < sp_splat(__builtin_inf())), part, at[k]);
        }
    }
    sp_pair size = sp_square_root(sp_metric_product(components, t, at, at));
    return size[0] > size[1] ? size[0] : size[1];
}

static void fill(const struct sp_refined *refined, const struct sp_newton *newton, struct sp_result *result) {
    const struct sp_outcome *outcome = &refined->outcome;
    result->length = refined->length, result->length_error = result->rounding = sp_check_rounding(refined->length, newton->size);
    if (!(refined->length_error < result->rounding)) result->length_error = refined->length_error; /* that of an edge may be 0 */
    result->energy = outcome->energy, result->gradient_norm = outcome->gradient_norm;
    result->index = outcome->index, result->touches_boundary = outcome->active;
    result->history = newton->history, result->history_count = newton->history_count, result->record = newton->record;
}

/* How the length changes with the ends of the path, where it is one piece: inner nodes are at rest, so what these would do is nothing. In
 * space ends may be where there is no normal, and pull anywhere; a metric's pull is known along the surface. */
static void pull(const struct sp_newton *newton, int32_t is_whole, struct sp_result *result) {
    const struct sp_system *system = &newton->system;
    const sp_pair *chart = system->line.nodes.charts;
    sp_pair by[3] = {sp_splat(not_a_number()), sp_splat(not_a_number())};
    int is_implicit = system->line.surface->kind == SP_IMPLICIT;
    if (is_whole && is_implicit && system->line.kind->components == 0) {
        sp_store(sp_elements_end_pull(&system->elements, chart), by);
    } else if (is_whole) {
        sp_system_end_pull(system, by);
        if (is_implicit) sp_store(sp_add(sp_scale(sp_load(chart + SP_CHART_1), by[0]), sp_scale(sp_load(chart + SP_CHART_2), by[1])), by);
    }
    for (int32_t end = 0; end < 2; end++)
        for (int j = 0; j < 3; j++)
            result->pull[end][j] = by[j][end != newton->reversed] * (system->elements.count / root(result->energy));
}

/* The length of a polyline, and its error: at least the variance of its speed, which a crease leaves. MATH.md, "The ladder". */
static void measure(struct sp_refined *refined, const struct sp_newton *newton, const struct sp_chord_sums *sums) {
    const struct sp_polyline *line = &newton->system.line;
    refined->length = line->kind->components ? sp_system_length(&newton->system, &line->nodes) : sums->length;
    double uneven = sp_check_unevenness(refined->outcome.energy, refined->length);
    refined->length_error = sp_check_length_error(newton, &refined->outcome, sums) + refined->outcome.doubt * refined->length;
    if (line->kind->components == 0 && uneven > refined->length_error) refined->length_error = uneven;
}

/* Only the surface in space has cusps: E, F and G that vanish are another matter. */
static int may_cross(const struct sp_polyline *line) { return line->surface->kind == SP_PARAMETRIC && line->surface->metric == SP_INDUCED; }

static int32_t way_of(const struct sp_surface *surface, const struct sp_passage *passage) {
    return surface->kind == SP_PARAMETRIC && passage->edge >= 0 && passage->edge < 4 ? passage->way : SP_FREE;
}

/* Elements, from a fine start or a coarse one; where they touch a wall or meet a singular curve, arcs of them. */
static struct sp_refined solve_elements(struct sp_newton *newton, const struct sp_options *options, const struct sp_request *request,
                                        int32_t is_fine, struct sp_arena *arena, struct sp_arcs *arcs, struct sp_result *result) {
    struct sp_storage storage;
    struct sp_refined refined = {.outcome = {.status = SP_OUT_OF_MEMORY}};
    const struct sp_polyline *line = &newton->system.line;
    int32_t may = may_cross(line), way = way_of(line->surface, &request->passage);
    result->crosses_singularity = 0;
    if (way == SP_OVER_POINT) return sp_pole_run(newton, options, &request->passage, arena, arcs);
    if (way == SP_BESIDE_POINT) return sp_hole_run(newton, options, &request->passage, arena, arcs);
    if (!sp_refine_take(&storage, newton, arena)) return refined;
    size_t used = arena->used;
    struct sp_system start = sp_storage_keep(&storage, &newton->system);
    result->crosses_singularity = may && sp_cusp_divides(newton);
    if (!result->crosses_singularity) {
        /* Chords across two cusps may lead to a path across none, but not in many steps: as many are left for arcs. */
        int32_t kept = may && sp_normal_turns(line, 0) > 0 && sp_cusp_crosses(&start) ? newton->steps_left / 2 : 0;
        newton->steps_left -= kept;
        refined = sp_refine_run(newton, options, is_fine, arena);
        newton->steps_left += kept;
        if (kept && refined.outcome.status == SP_ITERATION_LIMIT) refined.outcome.status = SP_SINGULAR_METRIC;
        int status = refined.outcome.status,
            solved = status == SP_CONVERGED || status == SP_TOLERANCE_NOT_MET || status == SP_ILL_CONDITIONED;
        if (solved && (refined.outcome.active || (line->surface->kind == SP_PARAMETRIC && sp_contact_leaves(&newton->system)))) {
            start = sp_storage_keep(&storage, &newton->system), arena->used = used;
            if (start.elements.reference.degree == 1) start.elements.count = line->fold.inner + 1;
            return sp_contact_run(newton, options, &start, arena, arcs);
        }
        if (refined.outcome.status != SP_SINGULAR_METRIC || !may) return refined;
    }
    result->crosses_singularity = 1;
    return sp_cusp_run(newton, options, &start, arena, arcs);
}

/* A start of that many inner nodes, with its charts; `keep`: as sp_start_polyline. */
static enum sp_status start_with(struct sp_newton *newton, const struct sp_request *request, double ends[2][3], int32_t inner, int32_t keep,
                                 struct sp_arena *arena, struct sp_result *result) {
    struct sp_polyline *line = &newton->system.line;
    line->fold = (struct sp_fold){inner};
    enum sp_status status = sp_start_polyline(line, request, ends[0], ends[1], newton->scale, keep, arena);
    if (status != SP_CONVERGED) return status;
    sp_polyline_charts(line, &line->nodes);
    newton->size = size_of(line);
    if (line->kind->components == 0 && newton->size < newton->scale) newton->size = newton->scale;
    if (!is_finite(newton->size)) return SP_NOT_FINITE; /* a density, say, that is infinite at an end */
    result->crosses_singularity = may_cross(line) && sp_normal_turns(line, 0) > 0;
    return SP_CONVERGED;
}

/* The first polyline: of many points from the straight line, by way of coarser ones; else all points at once, which is also what is left
 * where that leads nowhere. */
static enum sp_status start_points(struct sp_newton *newton, const struct sp_request *request, const struct sp_options *options,
                                   double ends[2][3], struct sp_arena *arena, struct sp_result *result) {
    int32_t count = options->point_count + 1, coarse = sp_refine_coarsest(count);
    int climbs = options->algorithm == SP_POLYLINE && coarse < count && !request->start && newton->system.line.kind->components == 0;
    if (climbs && start_with(newton, request, ends, coarse - 1, 1, arena, result) == SP_CONVERGED &&
        sp_refine_polyline(newton, options, count, arena))
        return SP_CONVERGED;
    return start_with(newton, request, ends, options->point_count, 1, arena, result);
}

/* A path of many points, as an earlier one that is followed: with arcs along walls. Where that leads nowhere, or has to do with singular
 * places, as any other. */
static enum sp_status start_fine(struct sp_newton *newton, const struct sp_request *request, const struct sp_options *options,
                                 double ends[2][3], struct sp_arena *arena, struct sp_arcs *arcs, struct sp_result *result,
                                 struct sp_refined *refined) {
    const struct sp_surface *surface = newton->system.line.surface;
    size_t used = arena->used;
    struct sp_elements chords = newton->system.elements;
    int may = surface->kind == SP_PARAMETRIC && way_of(surface, &request->passage) == SP_FREE;
    enum sp_status status = start_with(newton, request, ends, SP_REFINE_CHORDS - 1, 0, arena, result);
    if (status == SP_CONVERGED && may && !(may_cross(&newton->system.line) && sp_cusp_divides(newton))) {
        if (sp_contact_follow(newton, options, arena, arcs, refined)) return refined->outcome.status;
        arcs->count = 0, arena->used = used, newton->system.elements = chords;
        status = start_with(newton, request, ends, SP_REFINE_CHORDS - 1, 0, arena, result);
    }
    if (status != SP_CONVERGED) return status;
    *refined = solve_elements(newton, options, request, 1, arena, arcs, result);
    return refined->outcome.status;
}

/* Elements from few chords; where these jump between sheets, or given ones stall, from twice as many. */
static enum sp_status start_coarse(struct sp_newton *newton, const struct sp_request *request, const struct sp_options *options,
                                   double ends[2][3], struct sp_arena *arena, struct sp_arcs *arcs, struct sp_result *result,
                                   struct sp_refined *refined) {
    size_t used = arena->used;
    struct sp_elements chords = newton->system.elements;
    for (int32_t inner = first_inner(request);; inner = 2 * inner + 1, arena->used = used, newton->system.elements = chords) {
        enum sp_status status = start_with(newton, request, ends, inner, 1, arena, result);
        if (status == SP_CONVERGED) {
            *refined = solve_elements(newton, options, request, 0, arena, arcs, result);
            status = refined->outcome.status;
        }
        int is_coarse = status == SP_SHEET_JUMP || (request->start && status == SP_STALLED);
        if (!is_coarse || inner >= SP_REFINE_CHORDS - 1) return status;
    }
}

/* Elements from a start of many points as it is, in most of the steps, and where that comes to nothing from few chords; the other way round
 * where few tell as much: that takes few steps, or leads nowhere. MATH.md, "Starts". */
static enum sp_status start_elements(struct sp_newton *newton, const struct sp_request *request, const struct sp_options *options,
                                     double ends[2][3], struct sp_arena *arena, struct sp_arcs *arcs, struct sp_result *result,
                                     struct sp_refined *refined) {
    size_t used = arena->used;
    struct sp_elements chords = newton->system.elements;
    int is_fine = request->start_count > FINE_START && !sp_start_is_smooth(&newton->system.line, request, FINEST_START, arena);
    int32_t kept = is_fine ? newton->steps_left / 4 : newton->steps_left / 4 * 3;
    arena->used = used;
    if (request->start_count > FINE_START) {
        newton->steps_left -= kept;
        enum sp_status status = (is_fine ? start_fine : start_coarse)(newton, request, options, ends, arena, arcs, result, refined);
        newton->steps_left += kept;
        if (status == SP_CONVERGED) return status;
        arcs->count = 0, arena->used = used, newton->system.elements = chords, is_fine = !is_fine;
    }
    return (is_fine ? start_fine : start_coarse)(newton, request, options, ends, arena, arcs, result, refined);
}

/* How large the block is around an end, in parts of the size of things, that tells whether f is a power. */
static const double CORNER = 1e-2;

/* Puts an end on the surface. Where sheets meet in a point it stays, and is an end: a polyline's charts are those of its inner nodes. Not
 * so where there is no normal anywhere. */
static enum sp_status put_end(const struct sp_surface *surface, double scale, double end[3]) {
    sp_pair seen[SP_IMPLICIT_VALUES];
    int is_node = surface->kind == SP_IMPLICIT && sp_implicit_is_node(surface, end, SP_NODE_FAR * scale, seen);
    enum sp_status status = is_node ? SP_CONVERGED : sp_start_end(surface, scale, end);
    int is_open = is_node || status == SP_OFF_SURFACE;
    return is_open && sp_start_is_multiple(surface, end, CORNER * scale) ? SP_SINGULAR_METRIC : status;
}

/* Many ways are as long as each other if their length is known to this part: else they may seem so, of too few nodes. */
static const double KNOWN = 1e-4;

/* The stages in order; the first that fails decides. */
static enum sp_status solve(const struct sp_surface *surface, const struct sp_request *request, const struct sp_options *options,
                            struct sp_arena *arena, struct sp_result *result) {
    struct sp_newton newton = {0};
    struct sp_polyline *line = &newton.system.line;
    double ends[2][3] = {{0}, {0}};
    int elements = options->algorithm == SP_ELEMENTS;
    if (!sp_newton_take(&newton, surface, options, inner_nodes(options), arena)) return SP_OUT_OF_MEMORY;
    newton.reversed = order_ends(surface, request, ends[0], ends[1]);
    newton.scale = sp_start_scale(surface, request);
    enum sp_status status = put_end(surface, newton.scale, ends[0]);
    if (status == SP_CONVERGED) status = put_end(surface, newton.scale, ends[1]);
    if (status != SP_CONVERGED) return status;
    struct sp_arcs arcs;
    arcs.count = 0;
    struct sp_chord_sums sums;
    struct sp_refined refined = {{0}, 0, 0};
    if (elements) {
        status = start_elements(&newton, request, options, ends, arena, &arcs, result, &refined);
    } else {
        status = start_points(&newton, request, options, ends, arena, result);
        if (status == SP_CONVERGED) refined.outcome = sp_newton_run(&newton, options), status = refined.outcome.status;
    }
    result->iterations = options->max_iterations - newton.steps_left, result->work = newton.work;
    if (status < 0) return status;
    status = arcs.count == 0 ? sp_check_chords(&newton.system, newton.scale, elements ? NULL : &sums) : SP_CONVERGED;
    if (surface->kind == SP_PARAMETRIC && surface->metric >= SP_POLAR && !sp_polar_holds(line)) status = SP_SINGULAR_METRIC;
    if (status < 0) return status;
    if (!elements) result->crosses_singularity = 0, measure(&refined, &newton, &sums);
    fill(&refined, &newton, result);
    pull(&newton, newton.system.elements.reference.degree > 1 && arcs.count == 0, result);
    enum sp_status written = write_points(&newton, &arcs, options->point_count, arena, result);
    /* The ends as they are given: at a pole the path may have turned them. */
    for (int j = 0; j < 2 && result->parameters; j++) {
        result->parameters[j] = ends[newton.reversed][j];
        result->parameters[2 * (options->point_count + 1) + j] = ends[!newton.reversed][j];
    }
    if (status == SP_CONVERGED && result->length_error > result->length) status = SP_TOLERANCE_NOT_MET; /* rounding is all there is */
    if (written < 0 || status > 0) return written < 0 ? written : status;
    if (elements && refined.outcome.status == SP_ILL_CONDITIONED &&
        result->length_error > larger(options->tolerance, KNOWN) * result->length)
        return SP_TOLERANCE_NOT_MET;
    return refined.outcome.status == SP_CONVERGED && result->index > 0 ? SP_SADDLE : (enum sp_status)refined.outcome.status;
}

int32_t sp_solve_path(const struct sp_surface *surface, const struct sp_request *request, const struct sp_options *options,
                      struct sp_arena *arena, struct sp_result *result) {
    struct sp_result none = {
        .length = not_a_number(), .length_error = not_a_number(), .energy = not_a_number(), .gradient_norm = not_a_number(), .index = -1};
    struct sp_options clean = clamped(options);
    arena->used = 0;
    *result = none;
    struct sp_polar polar;
    struct sp_request around;
    int is_polar = way_of(surface, &request->passage) == SP_POINT_CHART && request->passage.turn > 0,
        is_sound = !is_polar || sp_polar_make(&polar, surface, request, arena, &around);
    enum sp_status status = SP_SINGULAR_METRIC;
    if (is_sound) status = solve(is_polar ? &polar.surface : surface, is_polar ? &around : request, &clean, arena, result);
    if (is_polar && status >= 0) sp_polar_return(&polar, request, clean.point_count + 2, result->parameters);
    none.crosses_singularity = status == SP_SINGULAR_METRIC && result->crosses_singularity;
    none.iterations = result->iterations, none.work = result->work;
    if (status < 0) *result = none;
    result->status = status;
    return status;
}
