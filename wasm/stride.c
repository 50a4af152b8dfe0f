/* Single steps of a trace: their error, their length, and what lies in them: walls, conjugate points, singular points. MATH.md, "Tracing".
 */
#include "scalar.h"
#include "trace.h"
#include <string.h>

enum { ROUNDS = 60 };
static const double ROUNDING = 1e-15, EPSILON = 2.220446049250313e-16, SLACK = 1e-14, VANISHED = 1e-4, INFINITE = __builtin_inf();
static const double MOST_GROWTH = 6, LEAST_GROWTH = 1.0 / 3, SAFETY = 0.9;

/* The square of an error of the state over h, free of units: of the position and of b beside the whole length, of the direction, a and b',
 * and of a' over the step. Its parts in space go to `deviation`. */
static double square_of(const struct sp_trace *trace, const double *error, double h, struct sp_deviation *deviation) {
    *deviation = sp_flow_measure(trace->surface, &trace->here, error);
    deviation->position *= h, deviation->direction *= h;
    double place = deviation->position / trace->length, turn = deviation->direction;
    double a = h * error[SP_FIELDS], b = h / trace->length * error[SP_FIELDS + 1];
    double a_slope = h * h * error[SP_FIELD_SLOPES], b_slope = h * error[SP_FIELD_SLOPES + 1];
    return place * place + turn * turn + a * a + b * b + a_slope * a_slope + b_slope * b_slope;
}

/* The estimated error of a step; of its parts in space, to stride->error. */
static double estimate(const struct sp_trace *trace, struct sp_stride *stride) {
    double fifth[SP_STATE], third[SP_STATE];
    struct sp_deviation unused;
    sp_dop853_errors(&stride->stages, fifth, third);
    double high = square_of(trace, fifth, stride->h, &stride->error), low = square_of(trace, third, stride->h, &unused);
    if (high == 0) return 0;
    double factor = root(high / (high + 0.01 * low));
    stride->error.position *= factor, stride->error.direction *= factor;
    return root(high) * factor;
}

/* How much longer the next step may be, for an error in units of the tolerance: it goes like h^8. */
static double growth(double error) {
    double factor = error > 0 ? SAFETY / root(root(root(error))) : MOST_GROWTH;
    return factor > MOST_GROWTH ? MOST_GROWTH : factor > LEAST_GROWTH ? factor : LEAST_GROWTH;
}

/* Within the tolerance, on the surface, and on the same side of it: a normal that turns over belongs to another sheet, or lies across a
 * point where it vanishes; and near the surface Newton's method finds it unless grad f vanishes. `error` is in units of the tolerance. */
static enum sp_status judge(const struct sp_trace *trace, double error, struct sp_stride *stride) {
    double speed;
    if (!(error < INFINITE)) return SP_NOT_FINITE;
    if (error > 1) return SP_TOLERANCE_NOT_MET;
    memcpy(stride->next.state, stride->end, sizeof stride->end);
    enum sp_status status = sp_flow_arrive(trace->surface, trace->scale, &stride->next, &speed);
    if (status != SP_CONVERGED) return status == SP_OFF_SURFACE ? SP_SINGULAR_METRIC : status;
    return dot(trace->here.normal, stride->next.normal) > 0 ? SP_CONVERGED : SP_SINGULAR_METRIC;
}

int sp_trace_attempt(struct sp_trace *trace, struct sp_stride *stride) {
    for (int i = 0; i < SP_STATE; i++)
        stride->stages.slope[0][i] = trace->here.slope[i];
    sp_dop853_step(&trace->ode, trace->here.state, stride->h, &stride->stages, stride->end);
    double error = estimate(trace, stride) / (trace->tolerance + 4 * EPSILON * trace->here.rounding.direction);
    enum sp_status status = judge(trace, error, stride);
    double factor = status == SP_CONVERGED || status == SP_TOLERANCE_NOT_MET ? growth(error) : LEAST_GROWTH;
    if (status == SP_CONVERGED && trace->after_rejection && factor > 1) factor = 1;
    trace->step = stride->h * factor;
    trace->after_rejection = status != SP_CONVERGED;
    if (status != SP_CONVERGED) trace->obstacle = status;
    return status == SP_CONVERGED;
}

/* A quantity that is linear in the state: the sum of two of its numbers, weighted, and an offset. */
struct event {
    int number;
    double weight, next_weight, offset;
};

static double weigh(const struct event *event, const double *state) {
    return event->weight * state[event->number] + event->next_weight * state[event->number + 1];
}

/* The state after a part of the step: a step of its own, as accurate as the whole. */
static void look(const struct sp_trace *trace, double h, double *state) {
    struct sp_stages stages;
    for (int i = 0; i < SP_STATE; i++)
        stages.slope[0][i] = trace->here.slope[i];
    sp_dop853_step(&trace->ode, trace->here.state, h, &stages, state);
}

/* Where an event that is positive before and negative after crosses zero in (0, high]: Newton, or halving where that leaves the bracket.
 * About five rounds. */
static double locate(const struct sp_trace *trace, const struct event *event, double high) {
    double low = 0, end = high, at = 0.5 * high;
    for (int round = 0; round < ROUNDS; round++) {
        double state[SP_STATE], slope[SP_STATE];
        look(trace, at, state);
        trace->ode.slope(trace->ode.context, state, slope);
        double value = weigh(event, state) + event->offset, next = at - value / weigh(event, slope);
        if (value > 0)
            low = at;
        else
            high = at;
        if (!(next >= low && next <= high)) next = 0.5 * (low + high);
        if (absolute(next - at) <= ROUNDING * end) return next;
        at = next;
    }
    return at;
}

static void find_conjugate(struct sp_trace *trace, const struct sp_stride *stride) {
    struct event field = {SP_FIELDS, trace->jacobi[0], trace->jacobi[1], 0};
    if (weigh(&field, stride->end) > 0) return;
    trace->conjugate = trace->travelled + locate(trace, &field, stride->h);
}

/* Carries the Jacobi field and the errors so far through the step, and adds its own and that of rounding. */
static void carry(struct sp_trace *trace, const struct sp_stride *stride) {
    const double *end = stride->end;
    double a = end[SP_FIELDS], b = end[SP_FIELDS + 1], da = end[SP_FIELD_SLOPES], db = end[SP_FIELD_SLOPES + 1];
    double field = trace->jacobi[0], slope = trace->jacobi[1], *spread = trace->spread;
    double shrink = absolute(field) + absolute(slope) * trace->length > 1e100 * trace->length ? 1e-100 : 1;
    trace->jacobi[0] = shrink * (a * field + b * slope), trace->jacobi[1] = shrink * (da * field + db * slope);
    double position = stride->error.position + EPSILON * stride->next.rounding.position;
    double direction = stride->error.direction + EPSILON * stride->next.rounding.direction;
    double square = spread[0], mixed = spread[1], turn = spread[2];
    spread[0] = a * a * square + 2 * a * b * mixed + b * b * turn + position * position;
    spread[1] = a * da * square + (a * db + b * da) * mixed + b * db * turn;
    spread[2] = da * da * square + 2 * da * db * mixed + db * db * turn + direction * direction;
    trace->along += position;
}

void sp_trace_advance(struct sp_trace *trace, const struct sp_stride *stride) {
    if (trace->conjugate != trace->conjugate) find_conjugate(trace, stride);
    carry(trace, stride);
    double left = trace->length - trace->travelled;
    trace->travelled = stride->h < left ? trace->travelled + stride->h : trace->length;
    trace->here = stride->next;
    trace->accepted++;
}

/* Lateral errors add up at most to sqrt(steps) times the root of the sum of their squares. */
double sp_trace_error(const struct sp_trace *trace) {
    double error = root(trace->accepted * trace->spread[0]) + trace->along, least = 4e-15 * trace->length;
    return error < INFINITE ? larger(error, least) : INFINITE;
}

/* A wall of the rectangle: coordinate 0 or 1, at its lower (side -1) or upper end (side 1). */
struct wall {
    int coordinate, side;
    double at, slack;
};

static struct wall wall_of(const struct sp_surface *surface, int number) {
    int coordinate = number >> 1, side = number & 1 ? 1 : -1;
    double low = surface->lower[coordinate], high = surface->upper[coordinate];
    return (struct wall){coordinate, side, side > 0 ? high : low, SLACK * (high - low)};
}

static double gap_of(struct wall wall, const double *state) { return wall.side * (wall.at - state[wall.coordinate]); }
static double speed_toward(struct wall wall, const double *state) { return wall.side * state[SP_VELOCITY + wall.coordinate]; }

static struct event position_before(struct wall wall) { return (struct event){wall.coordinate, -wall.side, 0, wall.side * wall.at}; }
static struct event turn_at(struct wall wall) { return (struct event){SP_VELOCITY + wall.coordinate, wall.side, 0, 0}; }

/* A length at which the path is beyond the wall: the whole step, or where it turns back inside it; 0 if it is nowhere. */
static double beyond(const struct sp_trace *trace, const struct sp_stride *stride, struct wall wall) {
    const double *start = trace->here.state, *end = stride->end;
    if (gap_of(wall, end) < -wall.slack) return stride->h;
    double before = speed_toward(wall, start), after = speed_toward(wall, end);
    if (!(before > 0 && after < 0 && gap_of(wall, start) < 2 * stride->h * larger(before, -after))) return 0;
    struct event turn = turn_at(wall);
    double farthest = locate(trace, &turn, stride->h);
    double state[SP_STATE];
    look(trace, farthest, state);
    return gap_of(wall, state) < -wall.slack ? farthest : 0;
}

static double crossing(const struct sp_trace *trace, const struct sp_stride *stride, struct wall wall) {
    double high = beyond(trace, stride, wall);
    if (high == 0) return INFINITE;
    if (gap_of(wall, trace->here.state) <= 0 && speed_toward(wall, trace->here.state) > 0) return 0;
    struct event position = position_before(wall);
    return locate(trace, &position, high);
}

double sp_trace_wall(const struct sp_trace *trace, const struct sp_stride *stride) {
    double first = INFINITE;
    if (!trace->walls || trace->surface->kind != SP_PARAMETRIC) return first;
    for (int number = 0; number < 4; number++) {
        struct wall wall = wall_of(trace->surface, number);
        double at = wall.slack < INFINITE ? crossing(trace, stride, wall) : INFINITE;
        if (at < first) first = at;
    }
    return first;
}

/* Heading for a wall that is no farther than rounding can tell: beyond it there may be no surface, so that no step crosses it. */
static int is_at_wall(const struct sp_trace *trace) {
    if (!trace->walls || trace->surface->kind != SP_PARAMETRIC) return 0;
    for (int number = 0; number < 4; number++) {
        struct wall wall = wall_of(trace->surface, number);
        if (wall.slack < INFINITE && gap_of(wall, trace->here.state) <= 100 * wall.slack && speed_toward(wall, trace->here.state) > 0)
            return 1;
    }
    return 0;
}

enum sp_status sp_trace_verdict(const struct sp_trace *trace) {
    if (is_at_wall(trace)) return SP_EDGE_REACHED;
    if (sp_flow_area(trace->surface, &trace->here) < VANISHED * trace->area) return SP_SINGULAR_METRIC;
    return trace->obstacle;
}
