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
/* A move that leaves no more than this part of what slants is a good one. */
static const double GOOD = 0.5;
/* A slant of a right angle. */
static const double SQUARE = 2;
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

/* Whether its ends are conjugate. */
static int is_loose(const struct sp_piece *piece) { return piece->solved.outcome.status == SP_ILL_CONDITIONED; }

static int slides_alone(const struct sp_piece *piece) { return piece->joint[0].slides != piece->joint[1].slides; }

/* The larger of its slants. */
static double slant_of(const struct sp_piece *piece) { return larger(absolute(piece->slant[0]), absolute(piece->slant[1])); }

/* Solves a piece, measures its angles and, unless they are beyond `most`, keeps it. */
static int solve_piece(struct sp_newton *newton, const struct sp_options *options, int checked, double most, struct sp_piece *piece,
                       struct sp_arena *arena) {
    if (!sp_piece_solve(newton, options, checked, piece, arena) || piece->solved.outcome.active) return 0;
    contact_slants(newton, piece);
    if (slant_of(piece) > most) return 0;
    sp_piece_keep(newton, piece);
    return 1;
}

/* The piece with its ends moved: few steps lead there, if any do. Where it turns back it is another path. */
static int solve_moved(struct sp_newton *newton, const struct sp_options *options, double before, struct sp_piece *piece,
                       struct sp_arena *arena) {
    int32_t kept = newton->steps_left > PATIENCE ? newton->steps_left - PATIENCE : 0;
    newton->steps_left -= kept;
    int solved = solve_piece(newton, options, 0, larger(before, SQUARE), piece, arena);
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

/* What is known while the ends slide: their last move, and the slants where it began; the slants' derivatives, in parts of the reaches; and
 * places beside that of an end that slides alone, where it slants to one side and to the other, NaN where there is none yet, and how far it
 * goes where derivatives mislead. */
struct search {
    double move[2], before[2], reach[2], jacobian[2][2], beside[2], careful;
    int has_jacobian;
};

/* Derivatives of both slants with respect to the sliding ends, by differences. Returns 0 where there are none. */
static int differentiate(struct sp_newton *newton, const struct sp_options *options, const struct sp_surface *walled,
                         const struct sp_piece *piece, struct sp_arena *arena, struct search *search) {
    for (int end = 0; end < 2; end++) {
        search->jacobian[0][end] = search->jacobian[1][end] = search->reach[end] = 0;
        if (!piece->joint[end].slides) continue;
        search->reach[end] = reach_of(walled, piece, end);
        struct sp_piece moved = *piece;
        /* Shorter: a longer arc may reach beyond conjugate ends. */
        double by = (end ? -DIFFERENCE : DIFFERENCE) * piece->joint[end].towards;
        *sp_piece_slide(&moved, end) += by * search->reach[end];
        if (!solve_moved(newton, options, slant_of(piece), &moved, arena)) return 0;
        for (int i = 0; i < 2; i++)
            if (piece->joint[i].slides) search->jacobian[i][end] = (moved.slant[i] - piece->slant[i]) / by;
    }
    return 1;
}

/* The derivatives as the last move tells (Broyden), if it was a good one. Returns 0 where they are not known. */
static int learn(const struct sp_piece *piece, struct search *search) {
    double part[2] = {0, 0}, squared = 0, before = 0, now = 0;
    for (int end = 0; end < 2; end++) {
        if (piece->joint[end].slides) part[end] = search->move[end] / search->reach[end];
        squared += part[end] * part[end];
        before = larger(before, absolute(search->before[end])), now = larger(now, absolute(piece->slant[end]));
    }
    if (!search->has_jacobian || !(squared > 0) || !(now <= GOOD * before) || is_loose(piece)) return 0;
    for (int i = 0; i < 2; i++) {
        double *row = search->jacobian[i], missing = piece->slant[i] - search->before[i] - row[0] * part[0] - row[1] * part[1];
        for (int end = 0; end < 2; end++)
            row[end] += missing * part[end] / squared;
    }
    return 1;
}

/* Newton's step of the ends that slide, each no farther than its reach; of many, where both slide as well together, the least. Returns 0
 * where there is none. */
static int newton_step(const double slant[2], struct search *search) {
    double(*jacobian)[2] = search->jacobian;
    double squares[2], mixed = jacobian[0][0] * jacobian[0][1] + jacobian[1][0] * jacobian[1][1], down[2];
    for (int end = 0; end < 2; end++) {
        squares[end] = jacobian[0][end] * jacobian[0][end] + jacobian[1][end] * jacobian[1][end];
        down[end] = -jacobian[0][end] * slant[0] - jacobian[1][end] * slant[1];
    }
    double ridge = RIDGE * (squares[0] + squares[1]), determinant = (squares[0] + ridge) * (squares[1] + ridge) - mixed * mixed;
    for (int end = 0; end < 2; end++) {
        double part = ((squares[1 - end] + ridge) * down[end] - mixed * down[1 - end]) / determinant;
        if (!(part - part == 0)) return 0;
        search->move[end] = search->reach[end] * (part > 1 ? 1 : part < -1 ? -1 : part);
    }
    return 1;
}

/* Whether such places are known on both sides. */
static int is_between(const struct search *search) { return is_finite(search->beside[0] + search->beside[1]); }

/* An end that slides alone: an edge is left sooner where the path leaves it at an angle, later where it would lead through it; between
 * places of both kinds, where Newton's step leads elsewhere halfway. */
static void guide(const struct sp_surface *surface, struct sp_piece *piece, struct search *search) {
    int end = piece->joint[1].slides;
    const struct sp_joint *joint = piece->joint + end;
    double at = *sp_piece_slide(piece, end), *move = search->move + end, *beside = search->beside;
    if (!slides_alone(piece) || is_loose(piece)) return;
    int inwards = (piece->slant[end] > 0) == (joint->place[joint->across] > surface->lower[joint->across]);
    double sign = inwards == end ? joint->towards : -joint->towards;
    beside[piece->slant[end] > 0] = at;
    int misled = *move * sign < 0, leaves = !((at + *move - beside[0]) * (at + *move - beside[1]) < 0);
    if (is_between(search) && (misled || leaves))
        *move = 0.5 * (beside[0] + beside[1]) - at;
    else if (misled && search->careful > 0)
        *move = sign * search->careful, search->careful *= 2;
}

/* The next move, from the path that the piece is. Returns 0 where there is none. */
static int next_move(struct sp_newton *newton, const struct sp_options *options, const struct sp_surface *walled, struct sp_piece *piece,
                     struct sp_arena *arena, struct search *search) {
    search->has_jacobian = learn(piece, search) || differentiate(newton, options, walled, piece, arena, search);
    if (!search->has_jacobian || !newton_step(piece->slant, search)) return 0;
    guide(walled, piece, search);
    for (int end = 0; end < 2; end++)
        search->before[end] = piece->slant[end], *sp_piece_slide(piece, end) += search->move[end];
    return 1;
}

/* Half of the last move, where no path leads to all of it: an end that slides alone does not go again to where it turned back. */
static void move_half(struct sp_piece *piece, struct search *search) {
    int end = piece->joint[1].slides;
    if (slides_alone(piece) && slant_of(piece) > SQUARE) search->beside[!(search->before[end] > 0)] = *sp_piece_slide(piece, end);
    for (int i = 0; i < 2; i++)
        search->move[i] *= 0.5, *sp_piece_slide(piece, i) -= search->move[i];
}

/* Newton; first on the few elements of a rough solve, where most of the way is gone. A step to where no path leads is halved. Where edges
 * are alike, as on a band of a sphere, arcs between contacts have conjugate ends, and lie as well a little aside: what slants then says
 * little of the length. */
static int fit(struct sp_newton *newton, const struct sp_surface *walled, const struct sp_options *options, int wanted,
               struct sp_piece *piece, struct sp_arena *arena) {
    double enough = smaller(LARGEST_SLANT, 0.1 * root(options->tolerance)), best = __builtin_inf();
    const struct search unknown = {.beside = {not_a_number(), not_a_number()}, .careful = piece->joint[piece->joint[1].slides].doubt};
    struct search search = unknown;
    if (enough < LEAST_SLANT) enough = LEAST_SLANT;
    struct sp_options now = *options;
    if (now.tolerance < ROUGHLY) now.tolerance = ROUGHLY;
    for (int round = 0, checked = 0, vain = 0; round < CONTACT_ROUNDS && vain < MOST_VAIN; round++) {
        int moved = round > 0 && !checked;
        int solved =
            moved ? solve_moved(newton, &now, best, piece, arena) : solve_piece(newton, &now, checked, __builtin_inf(), piece, arena);
        if (solved) {
            int loose = is_loose(piece);
            now.tolerance = loose ? smaller(options->tolerance, LOOSELY) : options->tolerance;
            double slants = slant_of(piece);
            vain = slants < best || is_between(&search) ? 0 : vain + 1;
            best = smaller(best, slants);
            int fits = slants <= (loose ? LOOSE_SLANTS[vain < 2 ? vain : 2] : enough);
            if (fits && (checked || !wanted)) return 1;
            if (checked) search = unknown, best = slants; /* few elements knew another path */
            checked = fits;
            if (!fits && !next_move(newton, &now, walled, piece, arena, &search)) return 0;
        } else if (moved)
            move_half(piece, &search);
        else
            return 0;
    }
    return 0;
}

int sp_contact_inside(const struct sp_surface *surface, const struct sp_system *system) {
    const struct sp_polyline *line = &system->line;
    for (int32_t i = 1; i <= line->fold.inner; i++)
        for (int32_t j = 0; j < 2; j++) {
            double x = sp_polyline_coordinate(line, i, j), slack = INSIDE * (surface->upper[j] - surface->lower[j]);
            if (x < surface->lower[j] - slack || x > surface->upper[j] + slack) return 0;
        }
    struct sp_run dips[SP_MAX_ARCS];
    return sp_runs_between(system, INSIDE, dips) == 0;
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

struct sp_surface sp_contact_open(const struct sp_surface *surface) {
    struct sp_surface open = *surface;
    for (int j = 0; j < 2; j++)
        open.lower[j] = -__builtin_inf(), open.upper[j] = __builtin_inf();
    return open;
}

int sp_contact_fit(struct sp_newton *newton, const struct sp_options *options, int checked, struct sp_piece *piece,
                   struct sp_arena *arena) {
    const struct sp_surface *surface = newton->system.line.surface;
    struct sp_surface open = sp_contact_open(surface);
    for (int end = 0; end < 2; end++)
        if (piece->joint[end].slides) limit(surface, piece->joint + end, &open);
    newton->system.line.surface = &open;
    int fits = fit(newton, surface, options, checked, piece, arena);
    newton->system.line.surface = piece->system.line.surface = surface;
    return fits && sp_contact_inside(surface, &piece->system);
}
