/* Contacts with the walls: where a free arc meets an edge it must be tangent to it, sin(angle) = 0, one equation for one unknown.
 * (Minimising the length instead would look for a double root.) MATH.md, "Arcs". */
#include "contact.h"
#include "metric.h"
#include "runs.h"
#include "scalar.h"

static const double DIFFERENCE = 2e-4, LEAST_SINE = 3e-9, LARGEST_SINE = 1e-4, ROUGHLY = 1e-4;
enum { CONTACT_ROUNDS = 30 };
/* A path that was fitted to an edge is only as exact as this, in parts of the range. */
static const double INSIDE = 1e-9;

/* Sine of the angle between the path and the edge at both ends: from the force p that holds the end node, which is accurate to the order
 * of the length; across the edge over all of it, (g^-1 p)^c / sqrt(p'g^-1 p g^cc). */
static void contact_sines(const struct sp_newton *newton, struct sp_piece *piece) {
    const struct sp_polyline *line = &newton->system.line;
    struct sp_form form = sp_metric_form(line->kind->components, line->nodes.charts, line->nodes.metrics);
    sp_pair p[2];
    sp_system_end_pull(&newton->system, p);
    sp_pair squared = form.g * p[0] * p[0] - 2.0 * form.f * p[0] * p[1] + form.e * p[1] * p[1];
    for (int end = 0; end < 2; end++) {
        int32_t across = piece->joint[end].across;
        double along = (across ? form.e : form.g)[end];
        piece->speed[end] = root(along);
        piece->sine[end] =
            piece->joint[end].slides ? (along * p[across][end] - form.f[end] * p[1 - across][end]) / root(squared[end] * along) : 0;
    }
}

/* Solves a piece, keeps it, and measures its angles. */
static int solve_piece(struct sp_newton *newton, const struct sp_options *options, int checked, struct sp_piece *piece,
                       struct sp_arena *arena) {
    if (!sp_piece_solve(newton, options, checked, piece, arena)) return 0;
    contact_sines(newton, piece);
    sp_piece_keep(newton, piece);
    return 1;
}

/* The most that an end may slide in one step. */
static double reach_of(const struct sp_piece *piece, int end) {
    double reach = piece->joint[end].reach;
    return reach > 0 ? reach : 0.5 * piece->solved.length / piece->speed[end];
}

/* Derivatives of both sines with respect to the sliding ends, by differences. */
static int contact_jacobian(struct sp_newton *newton, const struct sp_options *options, const struct sp_piece *piece,
                            struct sp_arena *arena, double jacobian[2][2]) {
    double step[2];
    for (int end = 0; end < 2; end++)
        step[end] = DIFFERENCE * reach_of(piece, end);
    for (int end = 0; end < 2; end++) {
        jacobian[0][end] = 0, jacobian[1][end] = end == 1;
        if (end == 0) jacobian[0][0] = 1;
        if (!piece->joint[end].slides) continue;
        struct sp_piece moved = *piece;
        *sp_piece_slide(&moved, end) += step[end];
        if (!solve_piece(newton, options, 0, &moved, arena)) return 0;
        for (int i = 0; i < 2; i++)
            if (piece->joint[i].slides) jacobian[i][end] = (moved.sine[i] - piece->sine[i]) / step[end];
    }
    return 1;
}

/* Newton; first on the few elements of a rough solve, where most of the way is gone. */
static int fit(struct sp_newton *newton, const struct sp_options *options, int wanted, struct sp_piece *piece, struct sp_arena *arena) {
    double enough = smaller(LARGEST_SINE, 0.1 * root(options->tolerance));
    if (enough < LEAST_SINE) enough = LEAST_SINE;
    struct sp_options now = *options;
    if (now.tolerance < ROUGHLY) now.tolerance = ROUGHLY;
    for (int round = 0, checked = 0; round < CONTACT_ROUNDS; round++) {
        if (!solve_piece(newton, &now, checked, piece, arena)) return 0;
        now.tolerance = options->tolerance;
        int fits = absolute(piece->sine[0]) <= enough && absolute(piece->sine[1]) <= enough;
        if (fits && (checked || !wanted)) return 1;
        checked = fits;
        if (fits) continue;
        double jacobian[2][2];
        if (!contact_jacobian(newton, options, piece, arena, jacobian)) return 0;
        double determinant = jacobian[0][0] * jacobian[1][1] - jacobian[0][1] * jacobian[1][0];
        double move[2] = {-(jacobian[1][1] * piece->sine[0] - jacobian[0][1] * piece->sine[1]) / determinant,
                          -(jacobian[0][0] * piece->sine[1] - jacobian[1][0] * piece->sine[0]) / determinant};
        for (int end = 0; end < 2; end++) {
            double most = reach_of(piece, end);
            if (!piece->joint[end].slides) continue;
            if (!(move[end] - move[end] == 0)) return 0;
            *sp_piece_slide(piece, end) += move[end] > most ? most : move[end] < -most ? -most : move[end];
        }
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

int sp_contact_fit(struct sp_newton *newton, const struct sp_options *options, int checked, struct sp_piece *piece,
                   struct sp_arena *arena) {
    const struct sp_surface *surface = newton->system.line.surface;
    struct sp_surface open = *surface;
    for (int j = 0; j < 2; j++)
        open.lower[j] = -__builtin_inf(), open.upper[j] = __builtin_inf();
    newton->system.line.surface = &open;
    int fits = fit(newton, options, checked, piece, arena);
    newton->system.line.surface = piece->system.line.surface = surface;
    return fits && sp_contact_inside(surface, piece);
}
