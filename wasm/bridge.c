/* Lengths of bridges, their derivatives by the crossings, and quasi-Newton steps (BFGS) on these. MATH.md, "Arcs". */
#include "bridge.h"
#include "metric.h"
#include "scalar.h"
#include <string.h>

static const double SLACK = 1e-14, ASIDE = 0.1;
static const double FIRST_STEP = 0.25, LEAST_STEP = 1e-14; /* of a crossing's reach */
enum { ROUNDS = 40, WIDER = 2 /* the next step may be so many times as long */ };

/* Adds dL/ds of the arc just solved, the pull on its singular end in the direction of the curve, and lowers the crossing's reach to the
 * arc's length. */
static void measure_end(const struct sp_newton *newton, const struct sp_piece *piece, int end, int32_t k, struct sp_bridge *bridge) {
    const struct sp_system *system = &newton->system;
    const struct sp_crossing *crossing = bridge->crossing + k;
    double nu[3] = {crossing->nu[0], crossing->nu[1], crossing->nu[2]};
    struct sp_curve at = sp_curve_at(system->line.surface, crossing->place, nu, 0);
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
static void place_joints(struct sp_bridge *bridge, int32_t i) {
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

struct sp_piece *sp_bridge_beyond(const struct sp_bridge *bridge, int side) {
    struct sp_contact *beyond = bridge->beyond[side];
    return beyond->pieces + (side ? 0 : beyond->made - 1);
}

/* Length of what is beyond the wall from which the first, last, arc leaves; NaN if the piece of edge would run backwards. */
static double length_beyond(const struct sp_bridge *bridge, int side, const struct sp_surface *surface, struct sp_arena *arena) {
    struct sp_contact *beyond = bridge->beyond[side];
    double length = 0;
    *sp_bridge_beyond(bridge, side) = bridge->piece[side ? bridge->count : 0];
    if (!sp_contact_assemble(beyond)) return not_a_number();
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

/* As sp_bridge_solve; where it fails what was measured at the crossings is gone. */
static int solve_arcs(struct sp_newton *newton, const struct sp_options *options, int checked, struct sp_bridge *bridge,
                      struct sp_arena *arena) {
    struct sp_options own = *options;
    double length = 0;
    for (int32_t i = 0; i < bridge->count; i++)
        bridge->slope[i] = 0, bridge->reach[i] = __builtin_inf();
    for (int32_t i = 0; i <= bridge->count; i++) {
        struct sp_piece *piece = bridge->piece + i;
        struct sp_refined before = piece->solved;
        /* An arc that is a small part of the bridge may be wrong by so much more of its own length. */
        double parts = bridge->length / piece->solved.length;
        own.tolerance = options->tolerance * (parts > 1 ? parts : 1);
        place_joints(bridge, i);
        if (!solve_arc(newton, &own, checked, piece, arena)) return piece->solved = before, 0;
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

int sp_bridge_solve(struct sp_newton *newton, const struct sp_options *options, int checked, struct sp_bridge *bridge,
                    struct sp_arena *arena) {
    double slope[SP_CROSSINGS], reach[SP_CROSSINGS];
    memcpy(slope, bridge->slope, sizeof slope), memcpy(reach, bridge->reach, sizeof reach);
    if (solve_arcs(newton, options, checked, bridge, arena)) return 1;
    memcpy(bridge->slope, slope, sizeof slope), memcpy(bridge->reach, reach, sizeof reach);
    return 0;
}

void sp_bridge_start(struct sp_bridge *bridge) {
    bridge->learnt = 0;
    for (int32_t i = 0; i < bridge->count; i++)
        for (int32_t j = 0; j < bridge->count; j++)
            bridge->inverse[i][j] = i == j && bridge->slope[i] != 0 ? FIRST_STEP * bridge->reach[i] / absolute(bridge->slope[i]) : 0;
}

/* Learns from a step and what it changed of the slopes (BFGS): H <- (1 - s y'/s'y) H (1 - y s'/s'y) + s s'/s'y. */
static void learn(const double step[SP_CROSSINGS], const double change[SP_CROSSINGS], struct sp_bridge *bridge) {
    double product = 0, moved[SP_CROSSINGS] = {0}, twice = 0;
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
static double largest_part(const struct sp_bridge *bridge, const double step[SP_CROSSINGS]) {
    double largest = 0;
    for (int32_t i = 0; i < bridge->count; i++)
        if (absolute(step[i]) > largest * bridge->reach[i]) largest = absolute(step[i]) / bridge->reach[i];
    return largest;
}

double sp_bridge_downhill(const struct sp_bridge *bridge, double most, double step[SP_CROSSINGS]) {
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

static int move_crossings(const struct sp_surface *surface, struct sp_bridge *bridge, const double step[SP_CROSSINGS]) {
    for (int32_t i = 0; i < bridge->count; i++) {
        struct sp_crossing *crossing = bridge->crossing + i;
        crossing->place[crossing->along] += step[i];
        if (!sp_crossing_correct(surface, crossing)) return 0;
    }
    return 1;
}

int sp_bridge_descend(struct sp_newton *newton, const struct sp_options *options, double enough, struct sp_bridge *bridge,
                      struct sp_storage spare[SP_CROSSINGS + 1], struct sp_arena *arena) {
    const struct sp_surface *surface = newton->system.line.surface;
    double step[SP_CROSSINGS] = {0}, change[SP_CROSSINGS] = {0}, most = SP_BRIDGE_STEP;
    for (int round = 0; round < ROUNDS && most > LEAST_STEP; round++) {
        if (sp_bridge_downhill(bridge, most, step) <= enough * bridge->length) return 1;
        struct sp_bridge next = *bridge;
        for (int32_t i = 0; i <= bridge->count; i++)
            sp_piece_move(&next.piece[i], spare + i);
        if (!move_crossings(surface, &next, step) || !sp_bridge_solve(newton, options, 0, &next, arena) ||
            !(next.length <= bridge->length * (1 + SLACK))) {
            most = 0.5 * largest_part(bridge, step);
            continue;
        }
        for (int32_t i = 0; i < bridge->count; i++)
            change[i] = next.slope[i] - bridge->slope[i];
        learn(step, change, &next);
        for (int32_t i = 0; i <= bridge->count; i++)
            spare[i] = bridge->piece[i].storage;
        *bridge = next, most = smaller(WIDER * most, SP_BRIDGE_STEP);
    }
    return 0;
}
