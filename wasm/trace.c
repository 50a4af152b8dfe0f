/* Traces a geodesic: from a request to a result. The steps are in stride.c, the equations in flow.c. MATH.md, "Tracing". */
#include "trace.h"
#include "scalar.h"
#include "start.h"
#include "surfpath.h"

/* No step is longer than this part of the length, so that a short feature on a flat surface is not jumped over. */
static const double LONGEST_STEP = 0.125;
/* So many steps in a row that are shorter than this part of the coordinates are kept so by rounding, as where f has no gradient. Past a
 * pole there are many, but not as many. */
static const double SHORTEST_STEP = 1e-6;
enum { PATIENCE = 512, ROUNDS = 4 };
/* A direction whose tangent part is smaller than this is normal to the surface. */
static const double NORMAL = 1e-10;
static const double ROUNDING = 1e-15;
/* An end that may be farther off, in parts of the length, and not only by rounding of the coordinates, is within no tolerance. */
static const double MOST_ERROR = 1e-2, MOST_ROUNDING = 1e-12;

void sp_default_trace_options(struct sp_trace_options *options) { *options = (struct sp_trace_options){1e-12, 64, 200000}; }

static struct sp_trace_options clamped(const struct sp_trace_options *options) {
    double tolerance = options->tolerance > 1e-14 ? options->tolerance : 1e-14;
    return (struct sp_trace_options){tolerance < 1e-2 ? tolerance : 1e-2, clamp(options->point_count, 1, 100000),
                                     clamp(options->max_steps, 1, 10000000)};
}

/* The points of the path, two a pair as the surface takes them, while they are found. */
struct samples {
    sp_pair *places;
    int32_t dimension, count;
    int32_t done;
};

static int32_t pairs_of(int32_t count) { return (count + 1) / 2; }

double sp_trace_bytes(int32_t kind, const struct sp_trace_options *options) {
    int32_t count = clamped(options).point_count + 2;
    double numbers = kind == SP_PARAMETRIC ? 2 + 3 : 3;
    return (2.0 * pairs_of(count) * numbers + numbers * count) * sizeof(double) + 4 * 16;
}

static void add_sample(struct samples *samples, const double *state) {
    sp_pair *pair = samples->places + samples->dimension * (samples->done >> 1);
    int lane = samples->done & 1;
    for (int32_t j = 0; j < samples->dimension; j++) {
        double number = state[SP_PLACE + j];
        pair[j][lane] = number;
        if (!lane) pair[j][1] = number;
    }
    samples->done++;
}

/* Where the next inner point lies; infinite when all are done. */
static double next_sample(const struct sp_trace *trace, const struct samples *samples) {
    if (samples->done >= samples->count - 1) return __builtin_inf();
    return trace->length * ((double)samples->done / (samples->count - 1));
}

/* Adds the inner points that lie in an accepted step. */
static void sample(const struct sp_trace *trace, struct sp_stride *stride, struct samples *samples) {
    struct sp_dense dense;
    double end = trace->travelled + stride->h;
    if (!(next_sample(trace, samples) < end)) return;
    sp_dop853_dense(&trace->ode, trace->here.state, stride->h, &stride->stages, stride->end, &dense);
    for (double at = next_sample(trace, samples); at < end; at = next_sample(trace, samples)) {
        double state[SP_STATE];
        sp_dop853_between(&dense, (at - trace->travelled) / stride->h, state);
        add_sample(samples, state);
    }
}

/* Steps until the length is reached or something stops it. A wall shortens trace->length to where it stands. */
static enum sp_status run(struct sp_trace *trace, struct samples *samples) {
    struct sp_stride stride;
    int32_t short_steps = 0;
    while (trace->travelled < trace->length) {
        double left = trace->length - trace->travelled;
        if (trace->tried++ == trace->max_steps) return SP_ITERATION_LIMIT;
        short_steps = trace->step < SHORTEST_STEP * trace->scale ? short_steps + 1 : 0;
        if (short_steps == PATIENCE && trace->walls) return sp_trace_verdict(trace);
        if (trace->step > LONGEST_STEP * trace->length) trace->step = LONGEST_STEP * trace->length;
        stride.h = trace->step < left ? trace->step : left;
        if (!sp_trace_attempt(trace, &stride)) {
            if (trace->step > ROUNDING * (trace->travelled + 0.1 * trace->here.rounding.position)) continue;
            return sp_trace_verdict(trace);
        }
        double wall = sp_trace_wall(trace, &stride);
        if (wall <= stride.h) {
            trace->travelled += wall;
            return SP_EDGE_REACHED;
        }
        sample(trace, &stride, samples);
        sp_trace_advance(trace, &stride);
    }
    return SP_CONVERGED;
}

/* Traces a given length from the start. */
static enum sp_status travel(struct sp_trace *trace, const struct sp_traveller *start, double length, struct samples *samples) {
    trace->here = *start, trace->length = length, trace->step = length;
    trace->jacobi[0] = 0, trace->jacobi[1] = 1, trace->conjugate = not_a_number();
    trace->spread[0] = trace->spread[1] = trace->spread[2] = trace->along = 0;
    trace->travelled = 0, trace->tried = trace->accepted = 0, trace->after_rejection = 0, trace->obstacle = SP_TOLERANCE_NOT_MET;
    samples->done = 0;
    add_sample(samples, start->state);
    return run(trace, samples);
}

/* The unit velocity at the start. */
static enum sp_status depart(struct sp_trace *trace, const struct sp_trace_request *request, struct sp_traveller *start, int32_t *normal) {
    struct sp_request ends = {0};
    int32_t dimension = sp_kind_of(trace->surface)->dimension;
    int finite = 1;
    double from[3] = {0}, largest = 0, speed = 0;
    for (int32_t j = 0; j < dimension; j++) {
        double part = absolute(request->direction[j]);
        from[j] = ends.from[j] = ends.to[j] = request->from[j], largest = part > largest ? part : largest;
        finite &= is_finite(part);
    }
    *normal = finite && largest == 0;
    if (!(largest > 0 && finite && request->length >= 0 && is_finite(request->length))) return SP_NOT_FINITE;
    trace->scale = sp_start_scale(trace->surface, &ends);
    enum sp_status status = sp_start_end(trace->surface, trace->scale, from);
    if (status != SP_CONVERGED) return status;
    for (int32_t j = 0; j < dimension; j++) {
        start->state[SP_PLACE + j] = from[j];
        start->state[SP_VELOCITY + j] = request->direction[j] / largest;
    }
    status = sp_flow_arrive(trace->surface, trace->scale, start, &speed);
    trace->area = status == SP_CONVERGED ? sp_flow_area(trace->surface, start) : 0;
    *normal = status != SP_NOT_FINITE && trace->surface->kind == SP_IMPLICIT && speed < NORMAL;
    return *normal ? SP_NOT_FINITE : status;
}

/* Takes pairs of `stride` numbers a point apart. Returns 0 where a number is not finite. */
static int unpair(const sp_pair *pairs, int32_t stride, int32_t count, double *numbers) {
    double sum = 0;
    for (int32_t i = 0; i < count; i++)
        for (int32_t j = 0; j < stride; j++) {
            double number = pairs[stride * (i >> 1) + j][i & 1];
            *numbers++ = number;
            sum += number - number;
        }
    return is_finite(sum);
}

/* An inner point lies on an edge of the rectangle. */
static int32_t touches(const struct sp_surface *surface, const double *parameters, int32_t count) {
    int32_t touching = 0;
    for (int32_t i = 2; i < 2 * (count - 1); i++)
        touching |= parameters[i] <= surface->lower[i & 1] || parameters[i] >= surface->upper[i & 1];
    return touching;
}

/* Puts the places into the rectangle or onto the surface, and writes them and their positions. */
static enum sp_status write_points(const struct sp_trace *trace, const struct samples *samples, sp_pair *positions,
                                   struct sp_trace_result *result) {
    const struct sp_surface *surface = trace->surface;
    int32_t count = samples->count, pairs = pairs_of(count);
    if (surface->kind == SP_IMPLICIT) {
        if (!sp_implicit_settle(surface, pairs, samples->places, trace->scale)) return SP_OFF_SURFACE;
    } else {
        sp_parametric_clip(surface, pairs, samples->places);
        if (positions) surface->value(pairs, samples->places, positions);
        if (!unpair(samples->places, 2, count, result->parameters)) return SP_NOT_FINITE;
        result->touches_boundary = touches(surface, result->parameters, count);
    }
    return !positions || unpair(positions, 3, count, result->points) ? SP_CONVERGED : SP_NOT_FINITE;
}

static int take(const struct sp_surface *surface, struct sp_arena *arena, struct samples *samples, sp_pair **positions,
                struct sp_trace_result *result) {
    size_t pairs = (size_t)pairs_of(samples->count), count = (size_t)samples->count;
    int parametric = surface->kind == SP_PARAMETRIC, located = !parametric || surface->value != NULL;
    samples->places = sp_arena_take(arena, pairs * (size_t)samples->dimension, sizeof(sp_pair));
    *positions = !parametric ? samples->places : located ? sp_arena_take(arena, pairs * 3, sizeof(sp_pair)) : NULL;
    result->points = located ? sp_arena_take(arena, 3 * count, sizeof(double)) : NULL;
    result->parameters = parametric ? sp_arena_take(arena, 2 * count, sizeof(double)) : NULL;
    return samples->places && (!located || (*positions && result->points)) && (result->parameters || !parametric);
}

/* What a trace that goes on from there needs. */
static void write_end(const struct sp_trace *trace, struct sp_trace_result *result) {
    for (int32_t j = 0; j < 3; j++)
        result->velocity[j] = trace->here.state[SP_VELOCITY + j];
    for (int32_t j = 0; j < 2; j++)
        result->field[j] = trace->jacobi[j];
    result->turn_error = root(trace->accepted * trace->spread[2]);
}

/* The way to where a path ended, without walls: in other steps, which may end a little before an edge, or beyond it; or at the rim of a
 * formula that a step leapt over: then up to there. */
static enum sp_status retrace(struct sp_trace *trace, const struct sp_traveller *start, struct samples *samples, enum sp_status status) {
    trace->max_steps *= 2;
    for (int round = 0; round < ROUNDS; round++) {
        trace->walls = 0;
        travel(trace, start, trace->travelled, samples);
        if (trace->length - trace->travelled <= MOST_ERROR * trace->length) return status;
        trace->walls = 1, status = sp_trace_verdict(trace);
        if (status != SP_EDGE_REACHED) break;
    }
    return SP_TOLERANCE_NOT_MET;
}

static enum sp_status solve(const struct sp_surface *surface, const struct sp_trace_request *request,
                            const struct sp_trace_options *options, struct sp_arena *arena, struct sp_trace_result *result) {
    struct sp_trace trace = {.surface = surface, .tolerance = options->tolerance, .max_steps = options->max_steps, .walls = 1};
    struct samples samples = {.dimension = sp_kind_of(surface)->dimension, .count = options->point_count + 2};
    struct sp_traveller start = {.state = {0}};
    sp_pair *positions;
    double missed = 0;
    if (!take(surface, arena, &samples, &positions, result)) return SP_OUT_OF_MEMORY;
    trace.ode = sp_flow_ode(surface);
    enum sp_status status = depart(&trace, request, &start, &result->normal);
    if (status != SP_CONVERGED) return status;
    status = travel(&trace, &start, request->length, &samples);
    if (status < 0) return status;
    if (status != SP_CONVERGED) {
        status = retrace(&trace, &start, &samples, status);
        /* Where nothing tells how to go on, all that is left is missed. */
        double length = status == SP_TOLERANCE_NOT_MET ? request->length : trace.length;
        missed = length - trace.travelled + trace.tolerance * trace.length;
    }
    while (samples.done < samples.count)
        add_sample(&samples, trace.here.state);
    enum sp_status written = write_points(&trace, &samples, positions, result);
    if (written != SP_CONVERGED) return written;
    result->length = trace.length, result->length_error = sp_trace_error(&trace) + missed;
    if (surface->kind == SP_PARAMETRIC || surface->metric != SP_TENSOR) result->conjugate = trace.conjugate;
    result->steps = trace.accepted;
    write_end(&trace, result);
    int is_known = result->length_error <= larger(MOST_ERROR * trace.length, MOST_ROUNDING * trace.scale);
    return status == SP_CONVERGED && !is_known ? SP_TOLERANCE_NOT_MET : status;
}

int32_t sp_trace_path(const struct sp_surface *surface, const struct sp_trace_request *request, const struct sp_trace_options *options,
                      struct sp_arena *arena, struct sp_trace_result *result) {
    struct sp_trace_result none = {.length = not_a_number(), .length_error = not_a_number(), .conjugate = not_a_number()};
    struct sp_trace_options clean = clamped(options);
    arena->used = 0;
    *result = none;
    enum sp_status status = solve(surface, request, &clean, arena, result);
    if (status < 0) none.normal = result->normal, *result = none;
    result->status = status;
    return status;
}
