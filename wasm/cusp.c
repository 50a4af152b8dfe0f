/* Paths across a cuspidal edge, where S_u x S_v vanishes along a curve and changes sign: bridges of arcs that meet in points of it, from
 * rough ones that are ranked to one solved to the tolerance, along walls where it must. MATH.md, "Arcs". */
#include "cusp.h"
#include "bridge.h"
#include "check.h"
#include "normal.h"
#include "scalar.h"

static const double ROUNDING = 2e-15, ROUGH = 1e-4, ENOUGH = 0.02, MARGIN = 1.1, LOOSER = 1e4, TOUCHING = 1e-3, DOUBT = 2e-3, DOUBTFUL = 4;
enum { CHECKS = 6, SEEDS = 5, SCAN = 64, MOST_BEYOND = 5, SETS = 4 };

/* Where the given path is at parameter t. */
static void given_place(const struct sp_system *given, double t, double place[2]) {
    double at[3];
    sp_sample_place(given, t, at);
    place[0] = at[0], place[1] = at[1];
}

/* The places where the given path crosses singular curves, and its arcs between them. Returns 0 if it crosses none, or too many. */
static int scan(const struct sp_system *given, struct sp_bridge *bridge) {
    const struct sp_surface *surface = given->line.surface;
    double before[2], here[2], behind[3], ahead[3], from = 0;
    bridge->count = 0;
    given_place(given, 0, before);
    sp_normal_at(surface, before, behind);
    for (int i = 1; i <= SCAN; i++) {
        given_place(given, (double)i / SCAN, here);
        sp_normal_at(surface, here, ahead);
        int at_pole = (i == 1 && sp_normal_is_nothing(behind, ahead)) || (i == SCAN && sp_normal_is_nothing(ahead, behind));
        if (!at_pole && dot(behind, ahead) < 0) {
            if (bridge->count == SP_CROSSINGS || !sp_crossing_find(surface, before, here, bridge->crossing + bridge->count)) return 0;
            double parameter = (i - 0.5) / SCAN;
            bridge->piece[bridge->count++] = (struct sp_piece){.system = *given, .first = from, .last = parameter};
            from = parameter;
        }
        for (int j = 0; j < 3; j++)
            behind[j] = ahead[j];
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

int sp_cusp_crosses(const struct sp_system *given) {
    struct sp_bridge bridge;
    return scan(given, &bridge);
}

/* Solves a bridge of one crossing roughly with the crossing at evenly spaced places between the ends, each from the one before, and leaves
 * it at the given places of the two shortest of those that are shorter than their neighbours, or as long as the given: `seeds`. */
static int rank_seeds(struct sp_newton *newton, const struct sp_options *options, const struct sp_bridge *given, struct sp_bridge *bridge,
                      struct sp_crossing seeds[2], struct sp_arena *arena) {
    struct sp_crossing crossing[SEEDS];
    double length[SEEDS + 2], best[2] = {__builtin_inf(), __builtin_inf()};
    int32_t along = bridge->crossing[0].along, count = 0;
    double from = bridge->piece[0].joint[0].place[along], to = bridge->piece[1].joint[1].place[along];
    length[0] = length[SEEDS + 1] = __builtin_inf();
    for (int i = 0; i < SEEDS; i++) {
        bridge->crossing[0].place[along] = from + (to - from) * i / (SEEDS - 1);
        int solved =
            sp_crossing_correct(newton->system.line.surface, bridge->crossing) && sp_bridge_solve(newton, options, 0, bridge, arena);
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
static int approach(struct sp_newton *newton, const struct sp_options *rough, struct sp_bridge *bridge,
                    struct sp_storage spare[SP_CROSSINGS + 1], struct sp_arena *arena) {
    if (!sp_bridge_solve(newton, rough, 0, bridge, arena)) return 0;
    sp_bridge_start(bridge);
    return sp_bridge_descend(newton, rough, ENOUGH * rough->tolerance, bridge, spare, arena);
}

/* Finds the crossings roughly: those of found[0], or, of one, where two of some seeds lead, if as far as can be told by now both may be
 * the shortest. Returns how many ways, the shorter first. */
static int32_t find_bridges(struct sp_newton *newton, const struct sp_options *options, struct sp_storage storage[SETS][SP_CROSSINGS + 1],
                            struct sp_bridge found[2], struct sp_arena *arena) {
    struct sp_options rough = *options;
    struct sp_crossing seeds[2] = {{.along = 0}, {.along = 0}};
    struct sp_bridge given = found[0], work = given;
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
static int meet_wall(struct sp_newton *newton, const struct sp_options *options, int side, struct sp_bridge *bridge,
                     struct sp_arena *arena) {
    struct sp_piece *arc = bridge->piece + (side ? bridge->count : 0);
    struct sp_contact *beyond = sp_arena_take(arena, 1, sizeof(struct sp_contact));
    if (!beyond) return 0;
    sp_contact_cut(&arc->system, beyond);
    int32_t count = beyond->arcs.count;
    if (beyond->made < 1 || count < 2 || count > MOST_BEYOND || beyond->arcs.arc[side ? 0 : count - 1].on_edge) return 0;
    bridge->beyond[side] = beyond;
    struct sp_piece *part = sp_bridge_beyond(bridge, side);
    part->joint[1 - side] = arc->joint[1 - side], part->storage = arc->storage;
    for (int32_t i = 0; i < beyond->made; i++) {
        struct sp_piece *piece = beyond->pieces + i;
        if (piece == part) continue;
        int fits = sp_refine_take(&piece->storage, newton, arena) && sp_contact_fit(newton, options, 1, piece, arena);
        /* What is hardly determined there says nothing of how long the whole is. */
        if (!fits || piece->solved.outcome.status != SP_CONVERGED) return bridge->beyond[side] = NULL, 0;
    }
    *arc = *part;
    bridge->length = not_a_number(); /* not a path before all is solved anew */
    return 1;
}

/* Solves the arcs to the tolerance, and moves the crossings as long as that gains something. */
static int finish(struct sp_newton *newton, const struct sp_options *options, struct sp_bridge *bridge,
                  struct sp_storage spare[SP_CROSSINGS + 1], struct sp_arena *arena) {
    double enough = ENOUGH * options->tolerance > ROUNDING ? ENOUGH * options->tolerance : ROUNDING, step[SP_CROSSINGS];
    for (int i = 0; i < CHECKS; i++) {
        if (!sp_bridge_solve(newton, options, 1, bridge, arena)) return 0;
        bridge->gain = sp_bridge_downhill(bridge, SP_BRIDGE_STEP, step);
        if (bridge->gain <= enough * bridge->length) return 1;
        if (!sp_bridge_descend(newton, options, enough, bridge, spare, arena)) return 0;
    }
    return 0;
}

/* Where arcs from ends close to the curve do not settle to the tolerance: one that they do, LOOSER times it. */
static int finish_loosely(struct sp_newton *newton, const struct sp_options *options, struct sp_bridge *bridge,
                          struct sp_storage spare[SP_CROSSINGS + 1], struct sp_arena *arena) {
    struct sp_options loose = *options;
    while ((loose.tolerance *= LOOSER) < ROUGH && newton->steps_left > 0)
        if (finish(newton, &loose, bridge, spare, arena)) return 1;
    return 0;
}

/* The bridge as a list of arcs. */
static struct sp_refined cross(struct sp_newton *newton, const struct sp_options *options, const struct sp_bridge *bridge,
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

int sp_cusp_divides(const struct sp_newton *newton) {
    const struct sp_polyline *line = &newton->system.line;
    return sp_normal_turns(line, 0) % 2 == 1 && sp_check_chords(&newton->system, newton->scale, NULL) == SP_SINGULAR_METRIC;
}

/* Solves a bridge found roughly: SP_CONVERGED, SP_TOLERANCE_NOT_MET, SP_ITERATION_LIMIT or SP_SINGULAR_METRIC. */
static enum sp_status settle(struct sp_newton *newton, const struct sp_options *options, struct sp_bridge *bridge,
                             struct sp_storage spare[SP_CROSSINGS + 1], struct sp_arena *arena) {
    for (int side = 0; side < 2; side++)
        if (bridge->piece[side ? bridge->count : 0].solved.outcome.active) meet_wall(newton, options, side, bridge, arena);
    if (finish(newton, options, bridge, spare, arena)) return SP_CONVERGED;
    if (newton->steps_left <= 0) {
        bridge->gain = 0; /* at most what is gained by the slopes as they are, over all the reach */
        for (int32_t i = 0; i < bridge->count; i++)
            bridge->gain += absolute(bridge->slope[i]) * bridge->reach[i];
        return __builtin_isnan(bridge->length) ? SP_SINGULAR_METRIC : SP_ITERATION_LIMIT;
    }
    return finish_loosely(newton, options, bridge, spare, arena) ? SP_TOLERANCE_NOT_MET : SP_SINGULAR_METRIC;
}

struct sp_refined sp_cusp_run(struct sp_newton *newton, const struct sp_options *options, const struct sp_system *given,
                              struct sp_arena *arena, struct sp_arcs *arcs) {
    struct sp_refined refined = {.outcome = {.status = SP_SINGULAR_METRIC}};
    struct sp_bridge found[2] = {{0}}, *best = NULL;
    struct sp_storage storage[SETS][SP_CROSSINGS + 1];
    enum sp_status status = SP_SINGULAR_METRIC;
    arcs->count = 0;
    if (!scan(given, found)) return refined;
    for (int32_t i = 0; i <= found->count; i++)
        for (int32_t set = 0; set < (found->count == 1 ? SETS : 2); set++)
            if (!sp_refine_take(&storage[set][i], newton, arena)) return refined.outcome.status = SP_OUT_OF_MEMORY, refined;
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
