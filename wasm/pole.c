/* Paths over a pole: two free arcs that end in the point to which an edge of the rectangle collapses. In the chart they end at some point
 * of the edge, any of which is the pole; the one that continues the arc smoothly is found by extrapolating it. MATH.md, "Arcs". */
#include "pole.h"
#include "contact.h"
#include "ends.h"
#include "metric.h"
#include "scalar.h"

enum { ROUNDS = 12, SWEEP = 64 };
static const double ENOUGH = 1e-13, LOOSE = 1e-5, PI = 3.14159265358979323846;

/* How far from straight a path may pass a pole, radians. A path that passes beside it is shorter by the square of that over twice the
 * stiffness of the path; between nearly antipodal places of the earth, where that is least, by 2e-11 of its length. */
static const double STRAIGHT = 1e-6;
/* Of the range: there directions differ by the root of it from those at a pole, and angles by it. */
static const double BESIDE = 1e-10;

/* Of a tensor the direction away from the pole turns so much per unit of the coordinate around it: |X_a x X_ab| / |X_a|^2, where X_ab is
 * what the vector around the pole grows by with the distance. There g_around has the value and the slope 0, g_mixed the value 0. */
static double growth_of(int32_t across, const sp_pair *metric) {
    sp_pair bend = metric[3 * (across ? SP_METRIC_T22 : SP_METRIC_T11) + (across ? 0 : 2)], away = metric[across ? 2 : 0],
            mixed = metric[3 * (across ? SP_METRIC_T2 : SP_METRIC_T1) + 1];
    return sp_square_root(0.5 * bend * away - mixed * mixed)[0] / away[0];
}

double sp_pole_angle(const struct sp_surface *surface, int32_t across, double value, double from, double to) {
    double angle = 0, step = (to > from ? to - from : from - to) / SWEEP;
    struct sp_vector before = {{0}, {0}, {0}};
    for (int i = 0; i <= SWEEP; i++) {
        sp_pair place[2], chart[SP_CHART], metric[SP_METRIC_LARGEST];
        place[across] = sp_splat(value), place[1 - across] = sp_splat(from + (to - from) * i / SWEEP);
        sp_kind_of(surface)->charts(surface, 1, place, chart, metric);
        if (surface->metric == SP_TENSOR) { /* Simpson's rule */
            angle += (i == 0 || i == SWEEP ? 1 : i % 2 ? 4 : 2) * step / 3 * growth_of(across, metric);
            continue;
        }
        struct sp_vector along = sp_load(chart + (across ? SP_CHART_2 : SP_CHART_1));
        along = sp_scale(along, 1.0 / sp_square_root(sp_dot(along, along)));
        struct sp_vector change = sp_subtract(along, before);
        double squared = sp_dot(change, change)[0], chord = root(squared);
        angle += i ? chord * (1 + squared / 24 * (1 + 9 * squared / 80 * (1 + 25 * squared / 168))) : 0;
        before = along;
    }
    return angle;
}

/* By how much the way over the pole turns there towards where a way past it is shorter, radians: into the rectangle between walls, and to
 * the side of the smaller angle where the surface closes around the pole after a `period`; 0 if on no side the angle is below half a turn,
 * as may be where all angles are more than a turn. `beside`: the coordinate across next to the pole, where its derivatives are no numbers.
 */
static double corner_of(const struct sp_surface *surface, int32_t across, double value, double beside, const double around[2],
                        double period) {
    double angle = sp_pole_angle(surface, across, value, around[0], around[1]), other = PI;
    if (!(angle >= 0)) angle = sp_pole_angle(surface, across, value = beside, around[0], around[1]);
    if (period > 0) {
        double whole = sp_pole_angle(surface, across, value, 0, period), more = whole - 2 * PI;
        if (more * more < STRAIGHT * STRAIGHT) whole = 2 * PI; /* a smooth pole's, to rounding */
        double turns = angle / whole;
        if (turns < 100) angle -= (int32_t)turns * whole;
        other = whole - angle;
    }
    if (other < angle) angle = other;
    return angle >= PI ? 0 : PI - angle; /* not a number: no angle at all */
}

/* Solves the arc from an end to the pole, until its end in the chart continues it. */
static int fit(struct sp_newton *newton, const struct sp_options *options, struct sp_piece *piece, int32_t across, double range,
               struct sp_arena *arena) {
    double *end = piece->joint[1].place + 1 - across;
    struct sp_options loose = *options;
    if (loose.tolerance < LOOSE) loose.tolerance = LOOSE;
    for (int round = 0, strict = 0; round < ROUNDS; round++) {
        if (!sp_piece_solve(newton, strict ? options : &loose, 1, piece, arena)) return 0;
        sp_piece_keep(newton, piece);
        double next = sp_ends_continued(&piece->system, 1, 1 - across), change = next - *end, enough = (strict ? ENOUGH : LOOSE) * range;
        if (strict && change * change <= enough * enough) return 1;
        strict |= change * change <= enough * enough || 2 * round >= ROUNDS;
        *end = next;
    }
    return 1;
}

struct sp_refined sp_pole_run(struct sp_newton *newton, const struct sp_options *options, const struct sp_passage *passage,
                              struct sp_arena *arena, struct sp_arcs *arcs) {
    struct sp_polyline *line = &newton->system.line;
    const struct sp_surface *surface = line->surface;
    struct sp_refined none = {.outcome = {.status = SP_OUT_OF_MEMORY}};
    struct sp_storage storage;
    int32_t across = passage->edge / 2;
    struct sp_surface open = *surface;
    double value = passage->edge % 2 ? surface->upper[across] + passage->beyond : surface->lower[across] - passage->beyond, around[2];
    for (int i = 0; i < 2; i++)
        around[i] = sp_polyline_end(line, i, 1 - across);
    double range = around[1] - around[0]; /* not the rectangle's: where the chart closes that is infinite */
    arcs->count = 0;
    if (!sp_storage_take(&storage, line->kind->dimension, line->fold.inner, arena)) return none;
    struct sp_system given = sp_storage_keep(&storage, &newton->system);
    double infinite = __builtin_inf();
    open.lower[across] = -infinite, open.upper[across] = infinite;
    struct sp_surface walls = open;
    open.lower[1 - across] = -infinite, open.upper[1 - across] = infinite;
    line->surface = &open;
    for (int i = 0; i < 2; i++) {
        struct sp_piece piece = {.system = given, .first = i ? 1 : 0, .last = i ? 1 : 0};
        for (int32_t j = 0; j < 2; j++)
            piece.joint[0].place[j] = piece.joint[1].place[j] = sp_polyline_end(&given.line, i, j);
        piece.joint[1].place[across] = value;
        if (!sp_refine_take(&piece.storage, newton, arena)) break;
        /* No path: what newton holds may be half an arc, or set up for a rung that memory was too short for. */
        none.outcome.status = SP_SINGULAR_METRIC;
        if (!fit(newton, options, &piece, across, range, arena) || !sp_contact_inside(&walls, &piece.system)) break;
        around[i] = piece.joint[1].place[1 - across];
        arcs->arc[arcs->count++] = sp_piece_arc(&piece, i);
    }
    line->surface = surface;
    if (arcs->count < 2) return arcs->count = 0, none;
    struct sp_refined whole = sp_arcs_join(arcs, newton, 0, arena);
    whole.outcome.active = 1;
    double beside = value + BESIDE * ((passage->edge % 2 ? surface->lower : surface->upper)[across] - value);
    double corner = corner_of(surface, across, value, beside, around, passage->turn), first = arcs->arc[0].length,
           second = arcs->arc[1].length, gain = (corner < 2 ? corner : 2) * (first < second ? first : second);
    if (gain > 0) whole.length_error += gain;
    if (!(corner <= STRAIGHT && gain <= options->tolerance * whole.length)) whole.outcome.status = SP_STALLED, whole.outcome.index = -1;
    return whole;
}
