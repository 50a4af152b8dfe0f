/* Paths close by an edge of the rectangle that is a point, or almost one, a hole: past it, and around it, which is two free arcs, tangent
 * to the edge, and a piece of that. Nodes at equal steps would not see it; the elements close in on it. MATH.md, "Arcs". */
#include "hole.h"
#include "contact.h"
#include "functions.h"
#include "pole.h"
#include "scalar.h"

/* Elements to begin with: more where the point is passed on the way, not at an end, from a part of it on that is so far from both. */
enum { DEGREE = 8, COUNT = 16, FINE_DEGREE = 24, FINE_COUNT = 32 };
static const double BETWEEN = 1e-3;
/* Largest step of a contact, radians around the hole. */
static const double STEP = 0.5;
/* Part of the angles of both tangents from which on they are tried: where the surface is curved, or has a density, they are smaller. */
static const double SURELY_BESIDE = 0.8;
/* Between the ends, radians: at the tip of a cusp there is none, and the line would lead over it. */
static const double LEAST_ANGLE = 1e-3, PI = 3.14159265358979323846;

/* The ends, and the point as the middle of a plane. */
struct near {
    double ends[2][2], far[2];   /* places, and how far they are from the middle */
    double middle, side, beyond; /* the middle, in the coordinate across; where the surface is from there, 1 or -1; how far the edge is */
    double angle, rate;          /* between the ends, seen from there; the coordinate along the edge per radian */
    int32_t across;
};

/* x + sqrt(1 + x^2): the exponential of asinh x. */
static double sum_with_root(double x) {
    double sum = absolute(x) + root(1 + x * x);
    return x < 0 ? 1 / sum : sum;
}

/* Where elements meet on the line between two points of the plane: as far apart as they are from the middle, about, at `foot` + `least`
 * sinh s for equal steps of s. Returns whether it passes the middle on the way. */
static int close_in(const double from[2], const double along[2], double spread[SP_SPREAD + 1]) {
    double squared = along[0] * along[0] + along[1] * along[1], foot = -(from[0] * along[0] + from[1] * along[1]) / squared,
           least = absolute(from[0] * along[1] - from[1] * along[0]) / squared;
    double power = sum_with_root(-foot / least), ratio = sum_with_root((1 - foot) / least) / power;
    for (int halvings = SP_SPREAD; halvings > 1; halvings /= 2)
        ratio = root(ratio);
    for (int k = 0; k <= SP_SPREAD; k++, power *= ratio) {
        spread[k] = foot + 0.5 * least * (power - 1 / power);
        if (!is_finite(spread[k])) spread[k] = (double)k / SP_SPREAD; /* the line meets the middle, as far as numbers tell */
    }
    spread[0] = 0, spread[SP_SPREAD] = 1;
    return foot * (1 - foot) > BETWEEN;
}

/* The straight line of the plane between an end, `i`, of the path and a point that far from the middle and seen at that angle, as elements
 * of the rectangle. Returns 0 if the arena is full. */
static int start_piece(struct sp_newton *newton, const struct near *near, int i, double far, double angle, struct sp_piece *piece,
                       struct sp_arena *arena) {
    struct sp_system *system = &newton->system;
    double *spread = sp_arena_take(arena, SP_SPREAD + 1, sizeof(double));
    if (!spread || !sp_refine_take(&piece->storage, newton, arena)) return 0;
    sp_pair cosine, sine = sp_sincos(sp_splat(angle), &cosine);
    double from[2] = {near->far[i], 0}, along[2] = {far * cosine[0] - from[0], far * sine[0]};
    for (int j = 0; j < 2 && i; j++)
        from[j] += along[j], along[j] = -along[j];
    int fine = close_in(from, along, spread);
    int32_t degree = fine ? FINE_DEGREE : DEGREE, count = fine ? FINE_COUNT : COUNT;
    if (!sp_reference_make(&system->elements.reference, degree, arena)) return 0;
    system->elements.count = count, system->elements.spread = spread, system->elements.fixed = 1;
    system->line.fold = (struct sp_fold){degree * count - 1};
    for (int32_t k = 0; k <= degree * count; k++) {
        double t = sp_sample_parameter(&system->elements, k), x = from[0] + t * along[0], y = from[1] + t * along[1],
               turned = near->rate * sp_atan2(sp_splat(y), sp_splat(x))[0];
        sp_polyline_put(&system->line, k, near->across, near->middle + near->side * root(x * x + y * y));
        sp_polyline_put(&system->line, k, 1 - near->across, near->ends[i][1 - near->across] + (i ? -turned : turned));
    }
    piece->system = sp_storage_keep(&piece->storage, system);
    piece->first = 0, piece->last = 1;
    for (int j = 0; j < 2; j++)
        piece->joint[j] = (struct sp_joint){.place = {near->ends[j][0], near->ends[j][1]}};
    return 1;
}

/* Around the hole: two tangents, and a piece of its edge. Returns 0 where the hole is not in the way, or the arena is full. */
static int wind(struct sp_newton *newton, const struct near *near, double wall, struct sp_contact *contact, struct sp_arena *arena) {
    double touching[2];
    int32_t across = near->across;
    for (int i = 0; i < 2; i++) {
        double nearest = near->beyond / near->far[i]; /* of an end on the edge 1, to rounding */
        touching[i] = sp_acos(sp_splat(nearest < 1 ? nearest : 1))[0];
    }
    /* It passes beside it; by how much only a plane tells beforehand. */
    if (!(near->angle > SURELY_BESIDE * (touching[0] + touching[1]))) return 0;
    for (int i = 0; i < 2; i++) {
        if (i)
            contact->arcs.arc[contact->arcs.count++] = (struct sp_arc){
                .on_edge = 1, .across = across, .value = wall, .ends = {near->ends[0][1 - across], near->ends[1][1 - across]}};
        if (near->ends[i][across] == wall) continue; /* there it begins, or ends */
        struct sp_piece *piece = contact->pieces + contact->made++;
        contact->arcs.arc[contact->arcs.count++] = (struct sp_arc){.on_edge = 0};
        if (!start_piece(newton, near, i, near->beyond, touching[i], piece, arena)) return 0;
        struct sp_joint *touch = piece->joint + 1 - i;
        touch->slides = 1, touch->across = across, touch->reach = STEP * absolute(near->rate), touch->towards = near->rate < 0 ? -1 : 1;
        touch->place[across] = wall;
        touch->place[1 - across] = near->ends[i][1 - across] + (i ? -near->rate : near->rate) * touching[i];
    }
    return 1;
}

struct sp_refined sp_hole_run(struct sp_newton *newton, const struct sp_options *options, const struct sp_passage *passage,
                              struct sp_arena *arena, struct sp_arcs *arcs) {
    const struct sp_surface *surface = newton->system.line.surface;
    struct sp_refined refined = {.outcome = {.status = SP_SINGULAR_METRIC}};
    int32_t upper = passage->edge % 2;
    double beyond = passage->beyond;
    struct near near = {.across = passage->edge / 2, .beyond = beyond};
    double wall = upper ? surface->upper[near.across] : surface->lower[near.across];
    near.side = upper ? -1 : 1, near.middle = wall - near.side * beyond;
    for (int i = 0; i < 2; i++) {
        for (int32_t j = 0; j < 2; j++)
            near.ends[i][j] = sp_polyline_end(&newton->system.line, i, j);
        near.far[i] = near.side * (near.ends[i][near.across] - near.middle);
        if (!(near.far[i] > 0)) return refined;
    }
    double from = near.ends[0][1 - near.across], to = near.ends[1][1 - near.across];
    near.angle = sp_pole_angle(surface, near.across, wall, from, to);
    if (near.angle < LEAST_ANGLE) near.angle = LEAST_ANGLE;
    near.rate = (to - from) / near.angle;
    if (beyond > 0) {
        struct sp_contact contact = {.made = 0};
        if (wind(newton, &near, wall, &contact, arena) && sp_contact_solve(newton, options, &contact, arena, &refined)) {
            refined.outcome.active = 1, *arcs = contact.arcs;
            return refined;
        }
    }
    if (!(near.angle < PI)) return refined;
    struct sp_piece piece;
    refined.outcome.status = SP_OUT_OF_MEMORY;
    if (!start_piece(newton, &near, 0, near.far[1], near.angle, &piece, arena)) return refined;
    refined = sp_refine_again(newton, options, &piece.system, 0, arena);
    if (refined.outcome.active || sp_contact_leaves(&newton->system)) refined.outcome.status = SP_SINGULAR_METRIC;
    return refined;
}
