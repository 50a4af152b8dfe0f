/* Lists of arcs: lengths of pieces of edges, and points at equal steps along all of them. MATH.md, "Arcs". */
#include "arcs.h"
#include "metric.h"
#include "sample.h"
#include "scalar.h"

/* Stored paths beyond those of the arcs: two sets of a bridge's, and what lies beyond walls at both its ends. */
enum { PANELS = 64, EDGE_DEGREE = 16, SPARE = 6, STRETCHES = 128 /* of an edge, looked at one by one */, WALK_ROUNDS = 20 };
/* Panels along an edge agree to the first part for its length, to the second for points along it, or as far as the coordinate is known, to
 * the third; so many, and none narrower than this part of it, where those of one width do not. */
static const double EXACT = 1e-15, AGREES = 1e-13, ROUNDING = 4.4e-16, NARROWEST = 1e-15;
enum { MOST_GRADED = 4000 };
/* Step across an edge, in parts of the range, for what its length changes by. */
static const double ACROSS = 1e-5;
/* Where points along an edge lie, in parts of what they are apart. */
static const double ENOUGH = 1e-14;

/* The metric beside an edge, `by` from it: that along it, across it, and between both. */
struct beside {
    double along, across, mixed;
};

static struct beside beside_edge(const struct sp_surface *surface, const struct sp_arc *arc, double by, double t) {
    const struct sp_kind *kind = sp_kind_of(surface);
    sp_pair place[2], chart[SP_CHART], metric[SP_METRIC_LARGEST];
    place[arc->across] = sp_splat(arc->value + by), place[1 - arc->across] = sp_splat(t);
    kind->charts(surface, 1, place, chart, metric);
    struct sp_form form = sp_metric_form(kind->components, chart, metric);
    return (struct beside){(arc->across ? form.e : form.g)[0], (arc->across ? form.g : form.e)[0], form.f[0]};
}

/* What a unit of the coordinate along an edge is long at a place of it. */
static double edge_speed_at(const struct sp_surface *surface, const struct sp_arc *arc, double t) {
    return root(beside_edge(surface, arc, 0, t).along);
}

/* Length of a piece of an edge by Gauss and Lobatto's rule. */
static double panel(const struct sp_surface *surface, const struct sp_arc *arc, const struct sp_reference *reference, double from,
                    double width) {
    double sum = 0;
    for (int32_t i = 0; i <= reference->degree; i++)
        sum += reference->weight[i] * edge_speed_at(surface, arc, from + width * reference->node[i]);
    return sum * absolute(width);
}

/* Whether two lengths of a piece of an edge differ by more than its coordinate, of so much `span`, and its rounding account for. */
static int differ(double from, double span, double length, double other) {
    return absolute(length - other) > (AGREES + ROUNDING * absolute(from / span)) * length;
}

/* The same of all of it, where panels of one width do not agree: ever narrower ones where the speed grows, as beside a place where it is
 * infinite, and wider ones beyond. */
static double graded_length(const struct sp_surface *surface, const struct sp_arc *arc, const struct sp_reference *reference, double start,
                            double span) {
    double sum = 0, at = 0, width = 1;
    for (int32_t step = 0; step < MOST_GRADED && at < 1; step++) {
        if (at + width > 1) width = 1 - at;
        double from = start + span * at, whole = panel(surface, arc, reference, from, span * width), halves = 0;
        for (int32_t half = 0; half < 2; half++)
            halves += panel(surface, arc, reference, from + 0.5 * half * span * width, 0.5 * span * width);
        if (width > NARROWEST && differ(from, span * width, halves, whole)) {
            width *= 0.5;
            continue;
        }
        sum += halves, at += width, width *= 2;
    }
    return at < 1 ? not_a_number() : sum;
}

/* Length of an edge from one coordinate along it to another: panels, doubled until they agree; `exactly`: until as many make up for what
 * the rounding of the coordinate does to the speed. */
static double edge_length(const struct sp_surface *surface, const struct sp_arc *arc, const struct sp_reference *reference, double from,
                          double to, int32_t exactly) {
    double last = 0, sum = 0, span = to - from;
    for (int32_t panels = 1; panels <= PANELS; panels *= 2) {
        last = sum, sum = 0;
        for (int32_t k = 0; k < panels; k++)
            sum += panel(surface, arc, reference, from + span * k / panels, span / panels);
        if (!(exactly ? absolute(sum - last) > EXACT * sum : differ(from, span, sum, last))) return sum;
    }
    return differ(from, span, sum, last) ? graded_length(surface, arc, reference, from, span) : sum;
}

double sp_arcs_edge_length(const struct sp_surface *surface, const struct sp_arc *arc, struct sp_arena *arena) {
    struct sp_reference reference;
    size_t bottom = arena->used;
    int fits = sp_reference_make(&reference, EDGE_DEGREE, arena);
    arena->used = bottom;
    return fits ? edge_length(surface, arc, &reference, arc->ends[0], arc->ends[1], 1) : not_a_number();
}

/* Sets the lengths of the pieces of edges and returns the whole length; NaN if the arena is full. */
static double measure(struct sp_arcs *arcs, const struct sp_surface *surface, struct sp_arena *arena) {
    double length = 0;
    for (int32_t i = 0; i < arcs->count; i++) {
        struct sp_arc *arc = arcs->arc + i;
        arc->system.line.surface = surface;
        if (arc->on_edge) arc->length = sp_arcs_edge_length(surface, arc, arena), arc->energy = arc->length * arc->length;
        length += arc->length;
    }
    return length;
}

/* With c across and t along the edge, L = int sqrt(E c'^2 + 2 F c' + G) dt changes by int (G_c / (2 sqrt G) - (F / sqrt G)_t) dc dt, which
 * is the edge's curvature in the surface, inwards, times sqrt(EG - F^2). `mixed`: (F / sqrt G)_t. */
static double curvature_with(const struct sp_surface *surface, const struct sp_arc *arc, double t, double mixed, double *speed) {
    double range = surface->upper[arc->across] - surface->lower[arc->across];
    double step = (arc->value == surface->lower[arc->across] ? ACROSS : -ACROSS) * range, inwards[3];
    struct beside here = beside_edge(surface, arc, 0, t);
    for (int32_t i = 1; i <= 2; i++)
        inwards[i] = root(beside_edge(surface, arc, i * step, t).along);
    inwards[0] = *speed = root(here.along);
    double change = (4 * inwards[1] - 3 * inwards[0] - inwards[2]) / (2 * step) - mixed;
    return (step > 0 ? change : -change) / root(here.along * here.across - here.mixed * here.mixed);
}

static double mixed_at(const struct sp_surface *surface, const struct sp_arc *arc, double t) {
    struct beside beside = beside_edge(surface, arc, 0, t);
    return beside.mixed / root(beside.along);
}

double sp_arcs_edge_curvature(const struct sp_surface *surface, const struct sp_arc *arc, double t, double unit[2]) {
    struct beside here = beside_edge(surface, arc, 0, t);
    double by = ACROSS * (surface->upper[arc->across] - surface->lower[arc->across]) * root(here.across / here.along), speed;
    double mixed = (mixed_at(surface, arc, t + by) - mixed_at(surface, arc, t - by)) / (2 * by);
    unit[0] = root(here.along), unit[1] = root(here.across);
    return curvature_with(surface, arc, t, mixed, &speed);
}

double sp_arcs_edge_gain(const struct sp_surface *surface, const struct sp_arc *arc, double stretch[2]) {
    double by = (arc->ends[1] - arc->ends[0]) / STRETCHES, most = 0, turn = 0, length = 0, from = 0;
    double last = mixed_at(surface, arc, arc->ends[0]);
    for (int32_t k = 0; k < STRETCHES; k++) {
        double t = arc->ends[0] + by * (k + 0.5), next = mixed_at(surface, arc, t + 0.5 * by), speed;
        double curvature = curvature_with(surface, arc, t, (next - last) / by, &speed);
        last = next;
        if (!(curvature < 0)) {
            turn = length = 0;
            continue;
        }
        if (length == 0) from = t - 0.5 * by;
        length += speed * absolute(by), turn += curvature * speed * absolute(by);
        double gain = turn * turn * length / 24;
        if (gain > most) most = gain, stretch[0] = from, stretch[1] = t + 0.5 * by;
    }
    return most;
}

/* An arc that takes the part l/L of the time has L/l times the energy, and as much the gradient, that it has in a unit of time. */
struct sp_refined sp_arcs_join(struct sp_arcs *arcs, struct sp_newton *newton, double slopes, struct sp_arena *arena) {
    struct sp_refined whole = {.outcome = {.status = SP_CONVERGED}, .length = measure(arcs, newton->system.line.surface, arena)};
    double squared = 4 * whole.length * whole.length * slopes;
    for (int32_t i = 0; i < arcs->count; i++) {
        const struct sp_arc *arc = arcs->arc + i;
        double share = arc->length > 0 ? whole.length / arc->length : 0, gradient = share * arc->gradient_norm;
        whole.length_error += arc->error, whole.outcome.energy += share * arc->energy, squared += gradient * gradient;
    }
    whole.outcome.gradient_norm = root(squared);
    sp_newton_tell_end(newton, &(struct sp_iterate){whole.outcome.energy, whole.outcome.gradient_norm, not_a_number(), 0});
    return whole;
}

/* The coordinate along an edge arc that is `distance` further than `from`: by Newton, halved where its speed changes too much for that,
 * until the length or the coordinate is as right as rounding lets it be. */
static double walk_edge(const struct sp_surface *surface, const struct sp_arc *arc, const struct sp_reference *reference, double from,
                        double distance) {
    double to = from, short_of = from, beyond = arc->ends[1], missing = distance;
    for (int round = 0; round < WALK_ROUNDS && !(absolute(missing) <= ENOUGH * distance); round++) {
        double before = to, move = missing / edge_speed_at(surface, arc, to);
        *(missing > 0 ? &short_of : &beyond) = to;
        to += arc->ends[1] < from ? -move : move;
        if (!((to - short_of) * (beyond - to) >= 0)) to = 0.5 * (short_of + beyond);
        if (absolute(before - to) <= absolute(ROUNDING * to)) break;
        missing = distance - edge_length(surface, arc, reference, from, to, 0);
    }
    return to;
}

/* The first or last place of an arc, exactly. */
static void arc_end(const struct sp_arc *arc, int end, double place[3]) {
    if (arc->on_edge) {
        place[arc->across] = arc->value, place[1 - arc->across] = arc->ends[end];
        return;
    }
    const struct sp_polyline *line = &arc->system.line;
    for (int32_t j = 0; j < 2; j++)
        place[j] = sp_polyline_end(line, end != arc->reversed, j);
}

enum sp_status sp_arcs_sample(const struct sp_arcs *arcs, const struct sp_surface *surface, double scale, int32_t point_count,
                              int32_t reversed, double *points, double *parameters, struct sp_arena *arena) {
    struct sp_reference reference;
    if (!sp_reference_make(&reference, EDGE_DEGREE, arena)) return SP_OUT_OF_MEMORY;
    int finite = 1;
    double total = 0, behind = 0, edge = 0, edge_at = 0;
    for (int32_t i = 0; i < arcs->count; i++)
        total += arcs->arc[i].length;
    for (int32_t i = 0, a = 0, entered = -1; i <= point_count + 1; i++) {
        double target = total * i / (point_count + 1), place[3] = {0};
        while (a < arcs->count - 1 && target > behind + arcs->arc[a].length)
            behind += arcs->arc[a++].length;
        const struct sp_arc *arc = arcs->arc + a;
        if (arc->on_edge) {
            if (entered != a) edge = arc->ends[0], edge_at = 0, entered = a;
            double along = smaller(target - behind, arc->length);
            edge = walk_edge(surface, arc, &reference, edge, along - edge_at), edge_at = along;
            place[arc->across] = arc->value, place[1 - arc->across] = edge;
        } else {
            double t = smaller((target - behind) / arc->length, 1);
            sp_sample_place(&arc->system, arc->reversed ? 1 - t : t, place);
        }
        if (i == 0 || i == point_count + 1) arc_end(arcs->arc + (i ? arcs->count - 1 : 0), i > 0, place);
        int32_t at = reversed ? point_count + 1 - i : i;
        finite &= sp_sample_point(surface, scale, place, points ? points + 3 * at : NULL, parameters + 2 * at);
    }
    return finite ? SP_CONVERGED : SP_NOT_FINITE;
}

double sp_arcs_bytes(void) {
    double pairs = SP_REFINE_INNER / 2 + 3,
           stored = 2 * pairs * sizeof(sp_pair) + (2 * (SP_MAX_DEGREE + 1) + SP_SPREAD + 1) * sizeof(double) + 4 * 16;
    return (SP_MAX_FREE + SPARE) * stored + 2 * sp_reference_bytes(EDGE_DEGREE);
}
