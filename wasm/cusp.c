/* Paths across a cuspidal edge, where S_u x S_v vanishes along a curve and changes sign: free arcs that meet in points of it. One unknown
 * each, where; the elements that touch the curve are graded (reference.h). MATH.md, "Arcs". */
#include "check.h"
#include "contact.h"
#include "metric.h"
#include "normal.h"

static const double VANISHING = 1e-8, ROUNDING = 2e-15, SLACK = 1e-14, ROUGH = 1e-4, ENOUGH = 0.02, ASIDE = 0.1, MARGIN = 1.1, LOOSER = 1e4,
                    TOUCHING = 1e-3, DOUBT = 2e-3, DOUBTFUL = 4;
static const double FIRST_STEP = 0.25, LARGEST_STEP = 0.5, LEAST_STEP = 1e-14; /* of a crossing's reach */
enum { BISECTIONS = 60, CORRECTIONS = 20, ROUNDS = 40, CHECKS = 6, SEEDS = 5, SCAN = 64, MOST = 3, MOST_BEYOND = 5, SETS = 4 };

static double root(double x) { return sp_square_root(sp_splat(x))[0]; }
static double absolute(double x) { return x < 0 ? -x : x; }

static double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static void chart_at(const struct sp_surface *surface, const double place[2], sp_pair chart[SP_CHART]) {
    sp_pair at[2] = {sp_splat(place[0]), sp_splat(place[1])};
    sp_parametric_kind.charts(surface, 1, at, chart, NULL);
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
    struct sp_turn turn;
    if (!sp_normal_turn(surface, from, to, BISECTIONS, &turn) || !(root(turn.least) <= VANISHING * root(turn.largest))) return 0;
    crossing->place[0] = turn.place[0], crossing->place[1] = turn.place[1];
    struct curve at = curve_at(surface, crossing->place, crossing->nu, 1);
    crossing->along = absolute(at.slope[1]) >= absolute(at.slope[0]) ? 0 : 1;
    return correct(surface, crossing);
}

/* Arcs from end to end by way of the crossings; the derivatives of their length with respect to the crossings' coordinates, and an estimate
 * of the inverse of its second ones. */
struct bridge {
    int32_t count; /* crossings */
    struct crossing crossing[MOST];
    struct sp_piece piece[MOST + 1];
    struct sp_contact *beyond[2]; /* the whole of which the first, last, arc is the part from a wall to the crossing; NULL: it meets none */
    double length, slope[MOST], inverse[MOST][MOST];
    double reach[MOST]; /* how far, in its coordinate, a crossing is from the nearer end of its arcs */
    double gain;        /* what moving the crossings on would still gain */
    int learnt;         /* the estimate is more than a first guess */
};

/* Adds dL/ds of the arc just solved, the pull on its singular end in the direction of the curve, and lowers the crossing's reach to the
 * arc's length. */
static void measure_end(const struct sp_newton *newton, const struct sp_piece *piece, int end, int32_t k, struct bridge *bridge) {
    const struct sp_system *system = &newton->system;
    const struct crossing *crossing = bridge->crossing + k;
    double nu[3] = {crossing->nu[0], crossing->nu[1], crossing->nu[2]};
    struct curve at = curve_at(system->line.surface, crossing->place, nu, 0);
    struct sp_form form = sp_metric_form(0, system->line.nodes.charts, NULL);
    int32_t along = crossing->along;
    double beside = -at.slope[along] / at.slope[1 - along], energy = piece->solved.outcome.energy;
    double squared = (along ? form.g : form.e)[end] + 2 * beside * form.f[end] + beside * beside * (along ? form.e : form.g)[end];
    sp_pair pull[2];
    sp_system_end_pull(system, pull);
    bridge->slope[k] += (pull[along][end] + beside * pull[1 - along][end]) * system->elements.count / root(energy);
    double reach = piece->solved.length / root(squared);
    if (!(bridge->reach[k] <= reach)) bridge->reach[k] = reach;
}

/* Puts the singular joints of arc i onto their crossings, and aside of them by a part of what the other end of the arc is beside the curve.
 */
static void place_joints(struct bridge *bridge, int32_t i) {
    struct sp_joint *joint = bridge->piece[i].joint;
    for (int32_t end = 0; end < 2; end++)
        for (int j = 0; j < 2 && joint[end].singular; j++)
            joint[end].place[j] = joint[end].aside[j] = bridge->crossing[i - 1 + end].place[j];
    for (int32_t end = 0; end < 2; end++) {
        if (!joint[end].singular) continue;
        int32_t other = 1 - bridge->crossing[i - 1 + end].along;
        joint[end].aside[other] += ASIDE * (joint[1 - end].place[other] - joint[end].place[other]);
    }
}

/* The part of a path beyond a wall that the first, last, arc of a bridge is. */
static struct sp_piece *part_beyond(const struct bridge *bridge, int side) {
    struct sp_contact *beyond = bridge->beyond[side];
    return beyond->pieces + (side ? 0 : beyond->made - 1);
}

/* Length of what is beyond the wall from which the first, last, arc leaves; NaN if the piece of edge would run backwards. */
static double length_beyond(const struct bridge *bridge, int side, const struct sp_surface *surface, struct sp_arena *arena) {
    struct sp_contact *beyond = bridge->beyond[side];
    double length = 0;
    *part_beyond(bridge, side) = bridge->piece[side ? bridge->count : 0];
    if (!sp_contact_assemble(beyond)) return __builtin_nan("");
    for (int32_t i = side; i < beyond->arcs.count - 1 + side; i++) {
        const struct sp_arc *arc = beyond->arcs.arc + i;
        length += arc->on_edge ? sp_arcs_edge_length(surface, arc, arena) : arc->length;
    }
    return length;
}

static int solve_arc(struct sp_newton *newton, const struct sp_options *options, int checked, struct sp_piece *piece,
                     struct sp_arena *arena) {
    int slides = piece->joint[0].slides || piece->joint[1].slides;
    return slides ? sp_contact_fit(newton, options, checked, piece, arena) : sp_piece_solve(newton, options, checked, piece, arena);
}

/* Solves all arcs to the crossings. Returns 0 where one fails: then the length stays that of the last time all were solved. */
static int solve_bridge(struct sp_newton *newton, const struct sp_options *options, int checked, struct bridge *bridge,
                        struct sp_arena *arena) {
    double length = 0;
    for (int32_t i = 0; i < bridge->count; i++)
        bridge->slope[i] = 0, bridge->reach[i] = __builtin_inf();
    for (int32_t i = 0; i <= bridge->count; i++) {
        struct sp_piece *piece = bridge->piece + i;
        place_joints(bridge, i);
        if (!solve_arc(newton, options, checked, piece, arena)) return 0;
        length += piece->solved.length;
        for (int32_t end = 0; end < 2; end++)
            if (piece->joint[end].singular) measure_end(newton, piece, end, i - 1 + end, bridge);
        sp_piece_keep(newton, piece);
    }
    for (int side = 0; side < 2; side++)
        if (bridge->beyond[side]) length += length_beyond(bridge, side, newton->system.line.surface, arena);
    if (length - length != 0) return 0;
    bridge->length = length;
    return 1;
}

/* A first guess: steps of FIRST_STEP. */
static void start_curvature(struct bridge *bridge) {
    bridge->learnt = 0;
    for (int32_t i = 0; i < bridge->count; i++)
        for (int32_t j = 0; j < bridge->count; j++)
            bridge->inverse[i][j] = i == j && bridge->slope[i] != 0 ? FIRST_STEP * bridge->reach[i] / absolute(bridge->slope[i]) : 0;
}

/* Learns from a step and what it changed of the slopes (BFGS): H <- (1 - s y'/s'y) H (1 - y s'/s'y) + s s'/s'y. */
static void learn(const double step[MOST], const double change[MOST], struct bridge *bridge) {
    double product = 0, moved[MOST] = {0}, twice = 0;
    for (int32_t i = 0; i < bridge->count; i++)
        product += step[i] * change[i];
    if (!(product > 0)) return;
    for (int32_t i = 0; i < bridge->count; i++) {
        for (int32_t j = 0; j < bridge->count; j++)
            moved[i] += bridge->inverse[i][j] * change[j];
        twice += change[i] * moved[i];
    }
    for (int32_t i = 0; i < bridge->count; i++)
        for (int32_t j = 0; j < bridge->count; j++)
            bridge->inverse[i][j] += ((1 + twice / product) * step[i] * step[j] - moved[i] * step[j] - step[i] * moved[j]) / product;
    bridge->learnt = 1;
}

/* A step in parts of the crossings' reaches. */
static double largest_part(const struct bridge *bridge, const double step[MOST]) {
    double largest = 0;
    for (int32_t i = 0; i < bridge->count; i++)
        if (absolute(step[i]) > largest * bridge->reach[i]) largest = absolute(step[i]) / bridge->reach[i];
    return largest;
}

/* The step downhill, no crossing by more than `most` of its reach. Returns the gain it promises; infinite while that is a guess. */
static double downhill(const struct bridge *bridge, double most, double step[MOST]) {
    double gain = bridge->learnt ? 0 : __builtin_inf(), largest;
    for (int32_t i = 0; i < bridge->count; i++) {
        step[i] = 0;
        for (int32_t j = 0; j < bridge->count; j++)
            step[i] -= bridge->inverse[i][j] * bridge->slope[j];
        gain -= step[i] * bridge->slope[i];
    }
    largest = largest_part(bridge, step);
    for (int32_t i = 0; i < bridge->count && largest > most; i++)
        step[i] *= most / largest;
    return gain;
}

static int move_crossings(const struct sp_surface *surface, struct bridge *bridge, const double step[MOST]) {
    for (int32_t i = 0; i < bridge->count; i++) {
        struct crossing *crossing = bridge->crossing + i;
        crossing->place[crossing->along] += step[i];
        if (!correct(surface, crossing)) return 0;
    }
    return 1;
}

/* Moves the crossings of a solved bridge downhill until the gain promised is below `enough` of the length; steps are halved until the
 * length falls. `spare`: room for what is tried. */
static int descend(struct sp_newton *newton, const struct sp_options *options, double enough, struct bridge *bridge,
                   struct sp_storage spare[MOST + 1], struct sp_arena *arena) {
    const struct sp_surface *surface = newton->system.line.surface;
    double step[MOST] = {0}, change[MOST] = {0}, most = LARGEST_STEP;
    for (int round = 0; round < ROUNDS && most > LEAST_STEP; round++) {
        if (downhill(bridge, most, step) <= enough * bridge->length) return 1;
        struct bridge next = *bridge;
        for (int32_t i = 0; i <= bridge->count; i++)
            sp_piece_move(&next.piece[i], spare + i);
        if (!move_crossings(surface, &next, step) || !solve_bridge(newton, options, 0, &next, arena) ||
            !(next.length <= bridge->length * (1 + SLACK))) {
            most = 0.5 * largest_part(bridge, step);
            continue;
        }
        for (int32_t i = 0; i < bridge->count; i++)
            change[i] = next.slope[i] - bridge->slope[i];
        learn(step, change, &next);
        for (int32_t i = 0; i <= bridge->count; i++)
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

/* The places where the given path crosses singular curves, and its arcs between them. Returns 0 if it crosses none, or too many. */
static int scan(const struct sp_system *given, struct bridge *bridge) {
    const struct sp_surface *surface = given->line.surface;
    double before[2], here[2], first[3], normal[3], from = 0;
    bridge->count = 0;
    given_place(given, 0, before);
    sp_normal_at(surface, before, first);
    for (int i = 1; i <= SCAN; i++) {
        given_place(given, (double)i / SCAN, here);
        sp_normal_at(surface, here, normal);
        if (dot(first, normal) < 0) {
            if (bridge->count == MOST || !find_crossing(surface, before, here, bridge->crossing + bridge->count)) return 0;
            double parameter = (i - 0.5) / SCAN;
            bridge->piece[bridge->count++] = (struct sp_piece){.system = *given, .first = from, .last = parameter};
            from = parameter;
        }
        for (int j = 0; j < 3; j++)
            first[j] = normal[j];
        before[0] = here[0], before[1] = here[1];
    }
    bridge->piece[bridge->count] = (struct sp_piece){.system = *given, .first = from, .last = 1};
    for (int32_t i = 0; i <= bridge->count; i++) {
        struct sp_joint *joint = bridge->piece[i].joint;
        joint[0].singular = i > 0, joint[1].singular = i < bridge->count;
    }
    given_place(given, 0, bridge->piece[0].joint[0].place), given_place(given, 1, bridge->piece[bridge->count].joint[1].place);
    return bridge->count > 0;
}

/* Solves a bridge of one crossing roughly with the crossing at evenly spaced places between the ends, each from the one before, and leaves
 * it at the given places of the two shortest of those that are shorter than their neighbours, or as long as the given: `seeds`. */
static int rank_seeds(struct sp_newton *newton, const struct sp_options *options, const struct bridge *given, struct bridge *bridge,
                      struct crossing seeds[2], struct sp_arena *arena) {
    struct crossing crossing[SEEDS];
    double length[SEEDS + 2], best[2] = {__builtin_inf(), __builtin_inf()};
    int32_t along = bridge->crossing[0].along, count = 0;
    double from = bridge->piece[0].joint[0].place[along], to = bridge->piece[1].joint[1].place[along];
    length[0] = length[SEEDS + 1] = __builtin_inf();
    for (int i = 0; i < SEEDS; i++) {
        bridge->crossing[0].place[along] = from + (to - from) * i / (SEEDS - 1);
        int solved = correct(newton->system.line.surface, bridge->crossing) && solve_bridge(newton, options, 0, bridge, arena);
        crossing[i] = bridge->crossing[0], length[i + 1] = solved ? bridge->length : __builtin_inf();
        for (int k = 0; k < 2 && !solved; k++)
            bridge->piece[k].system = given->piece[k].system, bridge->piece[k].first = given->piece[k].first,
            bridge->piece[k].last = given->piece[k].last;
    }
    for (int i = 0; i < SEEDS; i++) {
        if (!(length[i + 1] < best[1]) || length[i + 1] > MARGIN * best[0] || length[i + 1] > length[i] || length[i + 1] > length[i + 2])
            continue;
        int shortest = length[i + 1] < best[0];
        if (shortest) seeds[1] = seeds[0], best[1] = best[0];
        seeds[!shortest] = crossing[i], best[!shortest] = length[i + 1];
        count = count < 2 ? count + 1 : 2;
    }
    return count;
}

/* From the present crossings downhill on few elements. */
static int approach(struct sp_newton *newton, const struct sp_options *rough, struct bridge *bridge, struct sp_storage spare[MOST + 1],
                    struct sp_arena *arena) {
    if (!solve_bridge(newton, rough, 0, bridge, arena)) return 0;
    start_curvature(bridge);
    return descend(newton, rough, ENOUGH * rough->tolerance, bridge, spare, arena);
}

/* Finds the crossings roughly: those of found[0], or, of one, where two of some seeds lead, if as far as can be told by now both may be
 * the shortest. Returns how many ways, the shorter first. */
static int32_t find_bridges(struct sp_newton *newton, const struct sp_options *options, struct sp_storage storage[SETS][MOST + 1],
                            struct bridge found[2], struct sp_arena *arena) {
    struct sp_options rough = *options;
    struct crossing seeds[2];
    struct bridge given = found[0], work = given;
    int32_t count = 0;
    if (rough.tolerance < ROUGH) rough.tolerance = ROUGH;
    int32_t tried = given.count == 1 ? rank_seeds(newton, &rough, &given, &work, seeds, arena) : 0;
    if (tried == 0) return approach(newton, &rough, found, storage[1], arena);
    for (int32_t i = 0; i < tried; i++) {
        work.crossing[0] = seeds[i];
        if (!approach(newton, &rough, &work, storage[1], arena)) continue;
        found[count] = work;
        for (int32_t k = 0; k <= work.count; k++)
            sp_piece_move(&found[count].piece[k], storage[2 + count] + k);
        count++;
    }
    if (count < 2 || found[1].length > (1 + DOUBT) * found[0].length) return count;
    if (found[0].length <= found[1].length) return 2;
    work = found[0], found[0] = found[1], found[1] = work;
    return found[1].length > (1 + DOUBT) * found[0].length ? 1 : 2;
}

/* Cuts the first or last arc of a bridge, solved with nodes on walls, where it leaves them: what is beyond is solved once, the rest becomes
 * the arc. Returns 0, the bridge as it was, where that fails. */
static int meet_wall(struct sp_newton *newton, const struct sp_options *options, int side, struct bridge *bridge, struct sp_arena *arena) {
    struct sp_piece *arc = bridge->piece + (side ? bridge->count : 0);
    struct sp_contact *beyond = sp_arena_take(arena, 1, sizeof(struct sp_contact));
    if (!beyond) return 0;
    sp_contact_cut(&arc->system, beyond);
    int32_t count = beyond->arcs.count;
    if (beyond->made < 1 || count < 2 || count > MOST_BEYOND || beyond->arcs.arc[side ? 0 : count - 1].on_edge) return 0;
    bridge->beyond[side] = beyond;
    struct sp_piece *part = part_beyond(bridge, side);
    part->joint[1 - side] = arc->joint[1 - side], part->storage = arc->storage;
    for (int32_t i = 0; i < beyond->made; i++) {
        struct sp_piece *piece = beyond->pieces + i;
        if (piece == part) continue;
        if (!sp_storage_take(&piece->storage, 2, SP_REFINE_INNER, arena) || !sp_contact_fit(newton, options, 1, piece, arena))
            return bridge->beyond[side] = NULL, 0;
    }
    *arc = *part;
    bridge->length = __builtin_nan(""); /* not a path before all is solved anew */
    return 1;
}

/* Solves the arcs to the tolerance, and moves the crossings as long as that gains something. */
static int finish(struct sp_newton *newton, const struct sp_options *options, struct bridge *bridge, struct sp_storage spare[MOST + 1],
                  struct sp_arena *arena) {
    double enough = ENOUGH * options->tolerance > ROUNDING ? ENOUGH * options->tolerance : ROUNDING, step[MOST];
    for (int i = 0; i < CHECKS; i++) {
        if (!solve_bridge(newton, options, 1, bridge, arena)) return 0;
        bridge->gain = downhill(bridge, LARGEST_STEP, step);
        if (bridge->gain <= enough * bridge->length) return 1;
        if (!descend(newton, options, enough, bridge, spare, arena)) return 0;
    }
    return 0;
}

/* Where arcs from ends close to the curve do not settle to the tolerance: one that they do, LOOSER times it. */
static int finish_loosely(struct sp_newton *newton, const struct sp_options *options, struct bridge *bridge,
                          struct sp_storage spare[MOST + 1], struct sp_arena *arena) {
    struct sp_options loose = *options;
    while ((loose.tolerance *= LOOSER) < ROUGH && newton->steps_left > 0)
        if (finish(newton, &loose, bridge, spare, arena)) return 1;
    return 0;
}

/* The bridge as a list of arcs. */
static struct sp_refined cross(struct sp_newton *newton, const struct sp_options *options, const struct bridge *bridge,
                               struct sp_arena *arena, struct sp_arcs *arcs) {
    double slopes = 0;
    for (int32_t i = 0; i <= bridge->count; i++) {
        const struct sp_contact *beyond = i == 0 ? bridge->beyond[0] : i == bridge->count ? bridge->beyond[1] : NULL;
        for (int32_t k = 0; beyond && k < beyond->arcs.count; k++)
            arcs->arc[arcs->count++] = beyond->arcs.arc[k];
        if (!beyond) arcs->arc[arcs->count++] = sp_piece_arc(bridge->piece + i, 0);
    }
    for (int32_t i = 0; i < bridge->count; i++)
        slopes += bridge->slope[i] * bridge->slope[i];
    struct sp_refined whole = sp_arcs_join(arcs, newton, slopes, arena);
    whole.length_error += DOUBTFUL * bridge->gain;
    for (int32_t i = 0; i <= bridge->count; i++)
        whole.outcome.active |= bridge->piece[i].solved.outcome.active;
    if (!whole.outcome.active) return whole.outcome.active = bridge->beyond[0] || bridge->beyond[1], whole;
    whole.length_error += TOUCHING * whole.length; /* an element that spans a contact is not smooth */
    if (TOUCHING > options->tolerance) whole.outcome.status = SP_TOLERANCE_NOT_MET;
    return whole;
}

int32_t sp_cusp_turns(const struct sp_polyline *line, int32_t first) {
    const sp_pair *charts = line->nodes.charts;
    int32_t turns = 0, last = line->fold.both;
    struct sp_vector to = sp_chart_normal(charts + SP_CHART * first);
    for (int32_t k = first; k <= last; k++) {
        struct sp_vector from = to;
        to = sp_chart_normal(charts + SP_CHART * (k + 1));
        sp_pair product = sp_dot(from, to);
        turns += (product[0] < 0) + ((k < last || line->fold.odd) && product[1] < 0);
    }
    return turns;
}

int sp_cusp_divides(const struct sp_newton *newton) {
    const struct sp_polyline *line = &newton->system.line;
    return sp_cusp_turns(line, 0) % 2 == 1 && sp_check_chords(line, newton->scale, NULL) == SP_SINGULAR_METRIC;
}

/* Solves a bridge found roughly: SP_CONVERGED, SP_TOLERANCE_NOT_MET, SP_ITERATION_LIMIT or SP_SINGULAR_METRIC. */
static enum sp_status settle(struct sp_newton *newton, const struct sp_options *options, struct bridge *bridge,
                             struct sp_storage spare[MOST + 1], struct sp_arena *arena) {
    for (int side = 0; side < 2; side++)
        if (bridge->piece[side ? bridge->count : 0].solved.outcome.active) meet_wall(newton, options, side, bridge, arena);
    if (finish(newton, options, bridge, spare, arena)) return SP_CONVERGED;
    if (newton->steps_left <= 0) {
        bridge->gain = 0; /* at most what is gained by the slopes as they are, over all the reach */
        for (int32_t i = 0; i < bridge->count; i++)
            bridge->gain += absolute(bridge->slope[i]) * bridge->reach[i];
        return bridge->length > 0 ? SP_ITERATION_LIMIT : SP_SINGULAR_METRIC;
    }
    return finish_loosely(newton, options, bridge, spare, arena) ? SP_TOLERANCE_NOT_MET : SP_SINGULAR_METRIC;
}

struct sp_refined sp_cusp_run(struct sp_newton *newton, const struct sp_options *options, const struct sp_system *given,
                              struct sp_arena *arena, struct sp_arcs *arcs) {
    struct sp_refined refined = {.outcome = {.status = SP_SINGULAR_METRIC}};
    struct bridge found[2] = {{0}}, *best = NULL;
    struct sp_storage storage[SETS][MOST + 1];
    enum sp_status status = SP_SINGULAR_METRIC;
    arcs->count = 0;
    if (!scan(given, found)) return refined;
    for (int32_t i = 0; i <= found->count; i++)
        for (int32_t set = 0; set < (found->count == 1 ? SETS : 2); set++)
            if (!sp_storage_take(&storage[set][i], 2, SP_REFINE_INNER, arena)) return refined.outcome.status = SP_OUT_OF_MEMORY, refined;
    for (int32_t i = 0; i <= found->count; i++)
        found->piece[i].storage = storage[0][i];
    int32_t count = find_bridges(newton, options, storage, found, arena);
    for (int32_t i = 0; i < count; i++) {
        enum sp_status now = settle(newton, options, found + i, storage[1], arena);
        if (now == SP_SINGULAR_METRIC || (best && found[i].length >= best->length)) continue;
        best = found + i, status = now;
    }
    newton->system.elements.singular[0] = newton->system.elements.singular[1] = 0;
    if (!best) return refined;
    refined = cross(newton, options, best, arena, arcs);
    if (status != SP_CONVERGED) refined.outcome.status = status;
    if (status == SP_ITERATION_LIMIT) refined.outcome.index = -1;
    return refined;
}
