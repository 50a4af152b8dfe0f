/* A step of Newton's: shift, Armijo search, escape from saddles; and the paper's own variant of it. MATH.md, "Newton". */
#include "newton_step.h"
#include "scalar.h"

/* Why these: MATH.md, "Constants". */
static const double ARMIJO = 1e-4;
enum { HALVINGS = 40, SHIFTS = 60 };

/* Puts the places of the path moved by scale * step into `trial`. Returns 0 where it may not go there. */
static int move(struct sp_newton *newton, double scale) {
    struct sp_polyline *line = &newton->system.line;
    int32_t unknown = sp_fold_unknown(line->fold), dimension = line->kind->dimension;
    sp_pair *places = newton->trial.places;
    for (int32_t j = 0; j < dimension; j++)
        places[j] = line->nodes.places[j];
    const sp_mask *straight = newton->short_step ? NULL : newton->system.straight + 1;
    int moved = line->kind->move(line->surface, unknown, line->nodes.places + dimension, line->nodes.charts + SP_CHART, newton->step + 2,
                                 straight, scale, places + dimension);
    newton->work += line->fold.inner;
    newton->trial_touches = moved == 2;
    sp_fold_mirror(line->fold, places, dimension);
    return moved;
}

double sp_newton_try(struct sp_newton *newton, double scale) {
    struct sp_polyline *line = &newton->system.line;
    if (!move(newton, scale)) return not_a_number();
    sp_polyline_charts(line, &newton->trial);
    if (!sp_system_keeps_normals(&newton->system, &newton->trial)) return not_a_number();
    return newton->trial_squares =
               sp_system_squares(&newton->system, &newton->trial, newton->certain && !newton->draft ? &newton->trial_gradient : NULL);
}

double sp_newton_try_blindly(struct sp_newton *newton, const struct sp_round *round) {
    return move(newton, 1) ? round->energy.squares - round->inertia.descent : not_a_number();
}

void sp_newton_accept(struct sp_newton *newton) {
    struct sp_nodes kept = newton->system.line.nodes;
    newton->system.line.nodes = newton->trial;
    newton->trial = kept;
    newton->system.line.touches = newton->trial_touches;
}

/* r . (trial - path): the decrease that the clipped step promises to first order. */
static double clipped_descent(const struct sp_newton *newton) {
    const sp_pair *from = newton->system.line.nodes.places, *to = newton->trial.places;
    struct sp_fold fold = newton->system.line.fold;
    double sum = 0;
    for (int32_t k = 1; k <= sp_fold_unknown(fold); k++)
        sum += sp_fold_sum(
            fold, k, newton->system.rows[k].r1 * (to[2 * k] - from[2 * k]) + newton->system.rows[k].r2 * (to[2 * k + 1] - from[2 * k + 1]));
    return sum;
}

/* Halves the step until the energy falls as Armijo asks; a step that leaves the chart or meets NaN is refused. Returns the scale, 0 if none
 * did. */
static double search_armijo(struct sp_newton *newton, double squares, double slope) {
    double scale = 1;
    for (int i = 0; i < HALVINGS; i++, scale *= 0.5) {
        double now = sp_newton_try(newton, scale), promised = scale * slope;
        if (!is_finite(now)) continue;
        if (newton->trial_touches) promised = clipped_descent(newton);
        if (promised >= 0 && 0.5 * now <= 0.5 * squares - ARMIJO * promised + SP_SLACK * squares) return scale;
    }
    return 0;
}

/* The paper's search: the parabola through E(0), E'(0) and E(scale), its minimum kept within [0.1, 0.5] of the scale. */
static double search_paper(struct sp_newton *newton, double squares, double slope) {
    double scale = 1;
    for (int i = 0; i < HALVINGS; i++) {
        double now = sp_newton_try(newton, scale);
        if (now < squares) return scale;
        double next = 0.5 * scale * scale * slope / (0.5 * (now - squares) + slope * scale);
        scale = !(next >= 0.1 * scale) ? 0.1 * scale : next > 0.5 * scale ? 0.5 * scale : next;
    }
    return 0;
}

/* Along a direction of negative curvature, first as far as an eighth of the path is long; of the two ways the one with less energy, on a
 * tie the first. */
static double search_escape(struct sp_newton *newton, double squares) {
    double length = root(squares * sp_system_segments(&newton->system));
    double scale = 0.125 * length / sp_system_largest(&newton->system, newton->step);
    for (int i = 0; i < HALVINGS; i++, scale *= 0.5) {
        double ahead = sp_newton_try(newton, scale), behind = sp_newton_try(newton, -scale), limit = squares * (1 - SP_SLACK);
        if (behind < limit && !(ahead <= behind)) return -scale;
        if (ahead < limit) return sp_newton_try(newton, scale) < limit ? scale : 0;
    }
    return 0;
}

/* The step of H + shift M, with a shift that makes it positive definite. Returns 0 if none does. */
static int shifted_step(struct sp_newton *newton, struct sp_round *round, double least) {
    double segments = newton->system.line.fold.inner + 1;
    double shift = round->shift > 0 ? 0.25 * round->shift : 1 / (segments * segments);
    if (shift < least) shift = least;
    for (int i = 0, broken = 0; i < SHIFTS; i++, shift *= 4) {
        struct sp_inertia inertia = sp_system_factor(&newton->system, shift);
        /* A pivot may be zero by chance, once: else second derivatives are no numbers, whatever is added. */
        if (!is_finite(inertia.descent) && broken++) return 0;
        if (!inertia.usable || inertia.negative) continue;
        round->shift = shift, round->inertia.descent = inertia.descent;
        sp_system_solve(&newton->system, newton->step);
        return 1;
    }
    return 0;
}

double sp_newton_step(struct sp_newton *newton, struct sp_round *round) {
    double squares = round->energy.squares;
    int definite = sp_round_is_definite(round);
    if (!definite && sp_system_steepness(&newton->system, squares) <= SP_STATIONARY && sp_system_negative(&newton->system, newton->step))
        return search_escape(newton, squares);
    if (definite)
        sp_system_solve(&newton->system, newton->step);
    else if (!shifted_step(newton, round, 0))
        return 0;
    double scale = search_armijo(newton, squares, round->inertia.descent);
    if (scale > 0 || !shifted_step(newton, round, 1)) return scale;
    return search_armijo(newton, squares, round->inertia.descent);
}

double sp_newton_step_paper(struct sp_newton *newton, struct sp_round *round) {
    double slope = round->inertia.descent;
    if (!round->inertia.usable) return 0;
    sp_system_solve(&newton->system, newton->step);
    for (int32_t k = 0; slope < 0 && k < 2 * sp_fold_pairs(newton->system.line.fold); k++)
        newton->step[k] = -newton->step[k];
    return search_paper(newton, round->energy.squares, absolute(slope));
}
