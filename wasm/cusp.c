/* Paths across a cuspidal edge, where S_u x S_v vanishes along a curve and changes sign: two free arcs that meet in a point of it. One
 * unknown, where; the elements that touch the curve are graded (reference.h). MATH.md, "Arcs". */
#include "arcs.h"
#include "piece.h"

static const double VANISHING = 1e-8, ROUNDING = 2e-15;
enum { BISECTIONS = 60, CORRECTIONS = 20, ROUNDS = 40, SEEDS = 7, SCAN = 64 };

static double root(double x) { return sp_square_root(sp_splat(x))[0]; }
static double absolute(double x) { return x < 0 ? -x : x; }

static double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static void chart_at(const struct sp_surface *surface, const double place[2], sp_pair chart[SP_CHART]) {
    sp_pair at[2] = {sp_splat(place[0]), sp_splat(place[1])};
    sp_parametric_kind.charts(surface, 1, at, chart, NULL);
}

static void normal_at(const struct sp_surface *surface, const double place[2], double normal[3]) {
    sp_pair chart[SP_CHART];
    chart_at(surface, place, chart);
    struct sp_vector n = sp_chart_normal(chart);
    normal[0] = n.x[0], normal[1] = n.y[0], normal[2] = n.z[0];
}

/* The singular curve near a place: h = N . nu and its gradient, nu the direction in which N leaves zero. */
struct curve {
    double value, slope[2];
};

static struct curve curve_at(const struct sp_surface *surface, const double place[2], double nu[3], int choose) {
    sp_pair chart[SP_CHART];
    chart_at(surface, place, chart);
    struct sp_vector u = sp_load(chart + SP_CHART_1), v = sp_load(chart + SP_CHART_2), uu = sp_load(chart + SP_CHART_11),
                     uv = sp_load(chart + SP_CHART_12), vv = sp_load(chart + SP_CHART_22), n = sp_cross(u, v);
    struct sp_vector slopes[2] = {sp_add(sp_cross(uu, v), sp_cross(u, uv)), sp_add(sp_cross(uv, v), sp_cross(u, vv))};
    if (choose) {
        struct sp_vector larger = sp_dot(slopes[0], slopes[0])[0] > sp_dot(slopes[1], slopes[1])[0] ? slopes[0] : slopes[1];
        double length = root(sp_dot(larger, larger)[0]);
        nu[0] = larger.x[0] / length, nu[1] = larger.y[0] / length, nu[2] = larger.z[0] / length;
    }
    struct sp_vector direction = {sp_splat(nu[0]), sp_splat(nu[1]), sp_splat(nu[2])};
    return (struct curve){sp_dot(n, direction)[0], {sp_dot(slopes[0], direction)[0], sp_dot(slopes[1], direction)[0]}};
}

/* The point of the crossing, and the direction of the curve there per unit of the coordinate `along`, which parametrises it. */
struct crossing {
    double place[2], nu[3];
    int32_t along;
};

/* Puts a crossing onto the curve again, at its coordinate `along`. Returns 0 where it does not settle. */
static int correct(const struct sp_surface *surface, struct crossing *crossing) {
    int32_t other = 1 - crossing->along;
    for (int round = 0; round < CORRECTIONS; round++) {
        struct curve at = curve_at(surface, crossing->place, crossing->nu, 0);
        double step = at.value / at.slope[other], size = absolute(crossing->place[other]) + absolute(crossing->place[crossing->along]);
        if (!(step - step == 0)) return 0;
        crossing->place[other] -= step;
        if (absolute(step) <= 1e-15 * size || step == 0) return 1;
    }
    return 0;
}

/* Where the normal turns over between two places, found by bisection; 0 if it does not vanish there (a fold too sharp to see). */
static int find_crossing(const struct sp_surface *surface, const double from[2], const double to[2], struct crossing *crossing) {
    double low = 0, high = 1, first[3], normal[3], last[3];
    normal_at(surface, from, first), normal_at(surface, to, last);
    double largest = root(dot(first, first)) > root(dot(last, last)) ? root(dot(first, first)) : root(dot(last, last)), least = largest;
    for (int i = 0; i < BISECTIONS; i++) {
        double t = 0.5 * (low + high);
        for (int j = 0; j < 2; j++)
            crossing->place[j] = from[j] + t * (to[j] - from[j]);
        normal_at(surface, crossing->place, normal);
        double length = root(dot(normal, normal));
        if (length < least) least = length;
        if (dot(normal, first) > 0)
            low = t;
        else
            high = t;
    }
    if (!(least <= VANISHING * largest)) return 0;
    struct curve at = curve_at(surface, crossing->place, crossing->nu, 1);
    crossing->along = absolute(at.slope[1]) >= absolute(at.slope[0]) ? 0 : 1;
    return correct(surface, crossing);
}

/* The two arcs between the ends and a crossing, solved; their lengths' derivative with respect to the crossing's coordinate. */
struct bridge {
    struct sp_piece piece[2];
    struct crossing crossing;
    double length, slope;
};

/* dL/ds of the arc just solved: the pull on its singular end, against the direction of the curve. */
static double end_slope(const struct sp_newton *newton, const struct crossing *crossing, int end) {
    const struct sp_system *system = &newton->system;
    struct curve at = curve_at(system->line.surface, crossing->place, (double *)crossing->nu, 0);
    double direction[2];
    direction[crossing->along] = 1, direction[1 - crossing->along] = -at.slope[crossing->along] / at.slope[1 - crossing->along];
    sp_pair chart[SP_CHART];
    chart_at(system->line.surface, crossing->place, chart);
    struct sp_vector along = sp_add(sp_scale(sp_load(chart + SP_CHART_1), sp_splat(direction[0])),
                                    sp_scale(sp_load(chart + SP_CHART_2), sp_splat(direction[1])));
    double pull = sp_dot(sp_elements_end_pull(&system->elements, system->line.nodes.charts), along)[end];
    return pull * root(system->elements.count / sp_system_squares(system, system->line.nodes));
}

/* Solves both arcs to the crossing. Returns 0 where one fails. */
static int solve_bridge(struct sp_newton *newton, const struct sp_options *options, struct bridge *bridge, struct sp_arena *arena,
                        int32_t *iterations) {
    bridge->length = bridge->slope = 0;
    for (int i = 0; i < 2; i++) {
        struct sp_piece *piece = bridge->piece + i;
        for (int j = 0; j < 2; j++)
            piece->joint[1 - i].place[j] = bridge->crossing.place[j];
        if (!sp_piece_solve_graded(newton, options, piece, i ? 0 : 1, arena, iterations)) return 0;
        bridge->length += piece->length;
        bridge->slope += end_slope(newton, &bridge->crossing, i ? 0 : 1);
        sp_piece_keep(newton, piece);
    }
    return 1;
}

static int move_crossing(const struct sp_surface *surface, struct crossing *crossing, double by) {
    crossing->place[crossing->along] += by;
    return correct(surface, crossing);
}

/* Moves the crossing downhill: secant steps on dL/ds, at most half the shorter arc, halved until the length falls. */
static int fit_bridge(struct sp_newton *newton, const struct sp_options *options, struct bridge *bridge, struct sp_storage spare[2],
                      double range, struct sp_arena *arena, int32_t *iterations) {
    const struct sp_surface *surface = newton->system.line.surface;
    if (!solve_bridge(newton, options, bridge, arena, iterations)) return 0;
    double enough = 0.02 * options->tolerance > ROUNDING ? 0.02 * options->tolerance : ROUNDING, curvature = 0, most = 0.1 * range;
    for (int round = 0; round < ROUNDS; round++) {
        double step = curvature > 0 ? -bridge->slope / curvature : (bridge->slope > 0 ? -1 : 1) * 0.02 * range;
        if (curvature > 0 && absolute(step * bridge->slope) <= enough * bridge->length) return 1;
        if (absolute(step) > most) step = step > 0 ? most : -most;
        struct bridge next = *bridge;
        for (int i = 0; i < 2; i++)
            sp_piece_move(&next.piece[i], spare + i);
        if (!move_crossing(surface, &next.crossing, step) || !solve_bridge(newton, options, &next, arena, iterations) ||
            next.length > bridge->length * (1 + 1e-14)) {
            most = 0.5 * absolute(step);
            if (curvature > 0) curvature *= 2;
            if (most < 1e-14 * range) return 0;
            continue;
        }
        curvature = (next.slope - bridge->slope) / step;
        for (int i = 0; i < 2; i++)
            spare[i] = bridge->piece[i].storage;
        *bridge = next;
    }
    return 0;
}

/* Node i of the given path at parameter t. */
static void given_place(const struct sp_system *given, double t, double place[2]) {
    double at[3];
    sp_sample_place(given, t, at);
    place[0] = at[0], place[1] = at[1];
}

/* The first place where the given path crosses a singular curve, and at which parameter; 0 if it crosses none, or more than one. */
static int scan(const struct sp_system *given, struct crossing *crossing, double *parameter) {
    const struct sp_surface *surface = given->line.surface;
    double before[2], here[2], first[3], normal[3];
    int found = 0;
    given_place(given, 0, before);
    normal_at(surface, before, first);
    for (int i = 1; i <= SCAN; i++) {
        given_place(given, (double)i / SCAN, here);
        normal_at(surface, here, normal);
        if (dot(first, normal) < 0) {
            if (found++ || !find_crossing(surface, before, here, crossing)) return 0;
            *parameter = (i - 0.5) / SCAN;
        }
        for (int j = 0; j < 3; j++)
            first[j] = normal[j];
        before[0] = here[0], before[1] = here[1];
    }
    return found == 1;
}

/* Room for the bridge being solved, the step it tries, and the best so far. */
static int take_storage(struct sp_storage storage[6], struct sp_arena *arena) {
    for (int i = 0; i < 6; i++)
        if (!sp_storage_take(storage + i, 2, SP_REFINE_INNER, arena)) return 0;
    return 1;
}

/* Solves from one seed on the curve, in the first four storages; what is shortest so far is in the last two. */
static void try_seed(struct sp_newton *newton, const struct sp_options *options, const struct sp_system *given, double parameter,
                     struct crossing seed, struct sp_storage storage[6], struct bridge *best, struct sp_arena *arena, int32_t *iterations) {
    const struct sp_surface *surface = newton->system.line.surface;
    double range = surface->upper[seed.along] - surface->lower[seed.along];
    struct bridge work = {.crossing = seed};
    if (!(range < __builtin_inf())) range = 1;
    for (int i = 0; i < 2; i++) {
        work.piece[i] = (struct sp_piece){.system = *given, .storage = storage[i], .first = i ? parameter : 0, .last = i ? 1 : parameter};
        given_place(given, i, work.piece[i].joint[i].place);
    }
    struct sp_storage spare[2] = {storage[2], storage[3]};
    int fits = fit_bridge(newton, options, &work, spare, range, arena, iterations);
    int better = fits && !(best->length > 0 && best->length <= work.length);
    for (int i = 0; i < 2; i++) {
        storage[i] = better ? storage[4 + i] : work.piece[i].storage;
        storage[2 + i] = spare[i];
        if (better) storage[4 + i] = work.piece[i].storage;
    }
    if (better) *best = work;
}

struct sp_refined sp_cusp_run(struct sp_newton *newton, const struct sp_options *options, const struct sp_system *given,
                              struct sp_arena *arena, struct sp_arcs *arcs) {
    struct sp_refined refined = {.outcome = {.status = SP_SINGULAR_METRIC}};
    struct crossing middle;
    struct bridge best = {.length = 0};
    struct sp_storage storage[6];
    double parameter = 0, ends[2][2];
    int32_t iterations = 0;
    arcs->count = 0;
    if (!scan(given, &middle, &parameter)) return refined;
    if (!take_storage(storage, arena)) return refined.outcome.status = SP_OUT_OF_MEMORY, refined;
    given_place(given, 0, ends[0]), given_place(given, 1, ends[1]);
    for (int i = 0; i <= SEEDS; i++) {
        struct crossing seed = middle;
        double t = (double)i / (SEEDS - 1);
        if (i < SEEDS) seed.place[seed.along] = ends[0][seed.along] + t * (ends[1][seed.along] - ends[0][seed.along]);
        if (correct(newton->system.line.surface, &seed))
            try_seed(newton, options, given, parameter, seed, storage, &best, arena, &iterations);
    }
    newton->system.elements.singular[0] = newton->system.elements.singular[1] = 0;
    if (!(best.length > 0)) return refined;
    for (int i = 0; i < 2; i++) {
        arcs->arc[i] = (struct sp_arc){.length = best.piece[i].length, .system = best.piece[i].system};
        refined.length_error += best.piece[i].error;
    }
    arcs->count = 2;
    refined.outcome.status = SP_CONVERGED, refined.outcome.iterations = iterations;
    refined.outcome.squares = refined.outcome.gradient_norm = __builtin_nan("");
    refined.length = best.length;
    return refined;
}
