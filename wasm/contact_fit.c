/* Contacts with the walls: where a free arc meets an edge it must be tangent to it, an angle of 0, one equation for one unknown.
 * (Minimising the length instead would look for a double root.) MATH.md, "Arcs". */
#include "contact.h"
#include "metric.h"
#include "runs.h"
#include "scalar.h"

enum {
    CONTACT_ROUNDS = 30,
    MOST_VAIN = 8 /* of them come no nearer */,
    PATIENCE = 24 /* steps of a solve that begins near where it ends */
};
static const double DIFFERENCE = 2e-4, RADIAN = 1, BEHIND = 0.5, LEAST_SLANT = 3e-9, LARGEST_SLANT = 1e-4, ROUGHLY = 1e-4;
/* An arc between conjugate ends: the tolerance it is solved to, and how much it may slant: the more, the more rounds were in vain. */
static const double LOOSELY = 1e-9, LOOSE_SLANTS[] = {1e-5, 1e-4, 1e-3};
/* What is solved for is held back by this part of the squares of its derivatives, of which differences know no more. */
static const double RIDGE = 1e-8;
/* A path that was fitted to an edge is only as exact as this, in parts of the range. */
static const double INSIDE = 1e-9;

/* How much the path slants at both ends against the way along the edge, by twice the tangent of half the angle, which has no other zero
 * where the path turns back: from the force p that holds the end node, which is accurate to the order of the length; across the edge over
 * all of it the sine is (g^-1 p)^c / sqrt(p'g^-1 p g^cc), the cosine p_t / sqrt(p'g^-1 p g_tt). */
static void contact_slants(const struct sp_newton *newton, struct sp_piece *piece) {
    const struct sp_polyline *line = &newton->system.line;
    struct sp_form form = sp_metric_form(line->kind->components, line->nodes.charts, line->nodes.metrics);
    sp_pair p[2];
    sp_system_end_pull(&newton->system, p);
    sp_pair squared = form.g * p[0] * p[0] - 2.0 * form.f * p[0] * p[1] + form.e * p[1] * p[1];
    sp_pair area = sp_square_root(form.e * form.g - form.f * form.f);
    for (int end = 0; end < 2; end++) {
        const struct sp_joint *joint = piece->joint + end;
        int32_t across = joint->across;
        double along = (across ? form.e : form.g)[end], whole = root(squared[end] * along);
        double onwards = (end ? joint->towards : -joint->towards) * area[end] * p[1 - across][end];
        piece->speed[end] = root(along);
        piece->slant[end] = joint->slides ? 2 * (along * p[across][end] - form.f[end] * p[1 - across][end]) / (whole + onwards) : 0;
    }
}

/* Solves a piece, keeps it, and measures its angles. */
static int solve_piece(struct sp_newton *newton, const struct sp_options *options, int checked, struct sp_piece *piece,
                       struct sp_arena *arena) {
    if (!sp_piece_solve(newton, options, checked, piece, arena) || piece->solved.outcome.active) return 0;
    contact_slants(newton, piece);
    sp_piece_keep(newton, piece);
    return 1;
}

/* The piece with its ends moved: few steps lead there, if any do. */
static int solve_moved(struct sp_newton *newton, const struct sp_options *options, struct sp_piece *piece, struct sp_arena *arena) {
    int32_t kept = newton->steps_left > PATIENCE ? newton->steps_left - PATIENCE : 0;
    newton->steps_left -= kept;
    int solved = solve_piece(newton, options, 0, piece, arena);
    newton->steps_left += kept;
    return solved;
}

/* The curvature of the edge at a contact. `unit`: how long units of the coordinates along and across it are. */
static double curvature_at(const struct sp_surface *surface, const struct sp_joint *joint, double unit[2]) {
    struct sp_arc edge = {.across = joint->across, .value = joint->place[joint->across]};
    return sp_arcs_edge_curvature(surface, &edge, joint->place[1 - joint->across], unit);
}

/* The most that an end may slide in one step: half of the arc, and no more than what the edge turns by a radian on; a metric that is small
 * on the edge may bend it much within little of the arc. */
static double reach_of(const struct sp_surface *surface, const struct sp_piece *piece, int end) {
    const struct sp_joint *joint = piece->joint + end;
    if (joint->reach > 0) return joint->reach;
    double unit[2], curvature = curvature_at(surface, joint, unit), half = 0.5 * piece->solved.length;
    return (curvature * half > RADIAN ? RADIAN / curvature : half) / piece->speed[end];
}

/* Derivatives of both slants with respect to the sliding ends, in parts of their reaches, by differences. */
static int contact_jacobian(struct sp_newton *newton, const struct sp_options *options, const struct sp_piece *piece, const double reach[2],
                            struct sp_arena *arena, double jacobian[2][2]) {
    for (int end = 0; end < 2; end++) {
        jacobian[0][end] = jacobian[1][end] = 0;
        if (!piece->joint[end].slides) continue;
        struct sp_piece moved = *piece;
        /* Shorter: a longer arc may reach beyond conjugate ends. */
        double by = (end ? -DIFFERENCE : DIFFERENCE) * piece->joint[end].towards;
        *sp_piece_slide(&moved, end) += by * reach[end];
        if (!solve_moved(newton, options, &moved, arena)) return 0;
        for (int i = 0; i < 2; i++)
            if (piece->joint[i].slides) jacobian[i][end] = (moved.slant[i] - piece->slant[i]) / by;
    }
    return 1;
}

/* Newton's step of the ends that slide, each no farther than its reach; of many, where both slide as well together, the least. Returns 0
 * where there is none. */
static int contact_step(struct sp_newton *newton, const struct sp_options *options, const struct sp_surface *walled,
                        const struct sp_piece *piece, struct sp_arena *arena, double move[2]) {
    double jacobian[2][2], reach[2];
    const double *slant = piece->slant;
    for (int end = 0; end < 2; end++)
        reach[end] = piece->joint[end].slides ? reach_of(walled, piece, end) : 0;
    if (!contact_jacobian(newton, options, piece, reach, arena, jacobian)) return 0;
    double squares[2], mixed = jacobian[0][0] * jacobian[0][1] + jacobian[1][0] * jacobian[1][1], down[2];
    for (int end = 0; end < 2; end++) {
        squares[end] = jacobian[0][end] * jacobian[0][end] + jacobian[1][end] * jacobian[1][end];
        down[end] = -jacobian[0][end] * slant[0] - jacobian[1][end] * slant[1];
    }
    double ridge = RIDGE * (squares[0] + squares[1]), determinant = (squares[0] + ridge) * (squares[1] + ridge) - mixed * mixed;
    for (int end = 0; end < 2; end++) {
        double part = ((squares[1 - end] + ridge) * down[end] - mixed * down[1 - end]) / determinant;
        if (!(part - part == 0)) return 0;
        move[end] = reach[end] * (part > 1 ? 1 : part < -1 ? -1 : part);
    }
    return 1;
}

/* Newton; first on the few elements of a rough solve, where most of the way is gone. A step to where no path leads is halved. Where edges
 * are alike, as on a band of a sphere, arcs between contacts have conjugate ends, and lie as well a little aside: what slants then says
 * little of the length. */
static int fit(struct sp_newton *newton, const struct sp_surface *walled, const struct sp_options *options, int wanted,
               struct sp_piece *piece, struct sp_arena *arena) {
    double enough = smaller(LARGEST_SLANT, 0.1 * root(options->tolerance)), best = __builtin_inf(), move[2] = {0, 0};
    if (enough < LEAST_SLANT) enough = LEAST_SLANT;
    struct sp_options now = *options;
    if (now.tolerance < ROUGHLY) now.tolerance = ROUGHLY;
    for (int round = 0, checked = 0, vain = 0; round < CONTACT_ROUNDS && vain < MOST_VAIN; round++) {
        int moved = round > 0 && !checked;
        if (moved ? solve_moved(newton, &now, piece, arena) : solve_piece(newton, &now, checked, piece, arena)) {
            int is_loose = piece->solved.outcome.status == SP_ILL_CONDITIONED;
            now.tolerance = is_loose ? smaller(options->tolerance, LOOSELY) : options->tolerance;
            double slants = larger(absolute(piece->slant[0]), absolute(piece->slant[1]));
            vain = slants < best ? 0 : vain + 1;
            best = smaller(best, slants);
            int fits = slants <= (is_loose ? LOOSE_SLANTS[vain < 2 ? vain : 2] : enough);
            if (fits && (checked || !wanted)) return 1;
            checked = fits;
            if (fits) continue;
            if (!contact_step(newton, &now, walled, piece, arena, move)) return 0;
            *sp_piece_slide(piece, 0) += move[0], *sp_piece_slide(piece, 1) += move[1];
        } else if (moved) {
            move[0] *= 0.5, move[1] *= 0.5;
            *sp_piece_slide(piece, 0) -= move[0], *sp_piece_slide(piece, 1) -= move[1];
        } else
            return 0;
    }
    return 0;
}

int sp_contact_inside(const struct sp_surface *surface, const struct sp_piece *piece) {
    const struct sp_polyline *line = &piece->system.line;
    for (int32_t i = 1; i <= line->fold.inner; i++)
        for (int32_t j = 0; j < 2; j++) {
            double x = sp_polyline_coordinate(line, i, j), slack = INSIDE * (surface->upper[j] - surface->lower[j]);
            if (x < surface->lower[j] - slack || x > surface->upper[j] + slack) return 0;
        }
    struct sp_run dips[SP_MAX_ARCS];
    return sp_runs_between(&piece->system, INSIDE, dips) == 0;
}

int sp_contact_cut_corner(const struct sp_surface *surface, struct sp_joint *from, struct sp_joint *to) {
    struct sp_joint *joints[2] = {from, to};
    double corner[2], place[2];
    if (from->across == to->across) return 0;
    for (int k = 0; k < 2; k++)
        corner[joints[k]->across] = joints[k]->place[joints[k]->across];
    for (int k = 0; k < 2; k++) {
        struct sp_joint there = *joints[k];
        int32_t along = 1 - there.across;
        there.place[along] = corner[along];
        double unit[2], step = RADIAN / (curvature_at(surface, &there, unit) * unit[0]);
        if (!(step > 0)) return 0;
        place[along] = corner[along] + (corner[along] == surface->lower[along] ? step : -step);
    }
    for (int k = 0; k < 2; k++)
        joints[k]->place[1 - joints[k]->across] = place[1 - joints[k]->across];
    return 1;
}

/* Beyond an edge that a path is pressed onto a free arc to it goes no farther than this part of the edge's radius. */
static void limit(const struct sp_surface *surface, const struct sp_joint *joint, struct sp_surface *open) {
    int32_t j = joint->across;
    double unit[2], room = BEHIND / (curvature_at(surface, joint, unit) * unit[1]);
    if (!(room > 0)) return;
    if (joint->place[j] == surface->lower[j])
        open->lower[j] = joint->place[j] - room;
    else
        open->upper[j] = joint->place[j] + room;
}

int sp_contact_fit(struct sp_newton *newton, const struct sp_options *options, int checked, struct sp_piece *piece,
                   struct sp_arena *arena) {
    const struct sp_surface *surface = newton->system.line.surface;
    struct sp_surface open = *surface;
    for (int j = 0; j < 2; j++)
        open.lower[j] = -__builtin_inf(), open.upper[j] = __builtin_inf();
    for (int end = 0; end < 2; end++)
        if (piece->joint[end].slides) limit(surface, piece->joint + end, &open);
    newton->system.line.surface = &open;
    int fits = fit(newton, surface, options, checked, piece, arena);
    newton->system.line.surface = piece->system.line.surface = surface;
    return fits && sp_contact_inside(surface, piece);
}
