/* Paths around a hole: an edge of the rectangle that is almost a point, which a path between walls winds around. Two free arcs, tangent to
 * the edge, and a piece of it. Nodes at equal steps would not see it; the elements close in on it. MATH.md, "Arcs". */
#include "contact.h"
#include "functions.h"

enum { DEGREE = 8, COUNT = 16 };
/* Largest step of a contact, radians around the hole. */
static const double STEP = 0.5;
/* Part of the angles of both tangents from which on they are tried: where the surface is curved, or has a density, they are smaller. */
static const double SURELY_BESIDE = 0.8;

static double absolute(double x) { return x < 0 ? -x : x; }
static double root(double x) { return sp_square_root(sp_splat(x))[0]; }

/* An end of the path, and the tangent from it to the hole in the plane around that, in which the end lies at (far, 0). */
struct tangent {
    double end[2];
    double far, nearest;    /* distance from the middle of the hole; the hole's radius in parts of that */
    double touch[2], angle; /* where it touches, and under which angle that is seen from the middle */
};

static struct tangent tangent_from(const double end[2], double far, double radius) {
    double squared = far * far - radius * radius, along = squared > 0 ? root(squared) : 0, cosine = radius / far, sine = along / far;
    return (struct tangent){
        {end[0], end[1]}, far, cosine, {radius * cosine, radius * sine}, sp_atan2(sp_splat(along), sp_splat(radius))[0]};
}

/* Where elements meet, from the end to the hole: as close as they are far from its middle, in equal ratios. */
static void close_in(double nearest, int from_hole, double spread[SP_SPREAD + 1]) {
    double ratio = 1 + 1 / nearest, power = 1;
    for (int halvings = SP_SPREAD; halvings > 1; halvings /= 2)
        ratio = root(ratio);
    for (int k = 0; k <= SP_SPREAD; k++, power *= ratio) {
        double away = nearest * (power - 1);
        spread[from_hole ? k : SP_SPREAD - k] = from_hole ? away : 1 - away;
    }
    spread[0] = 0, spread[SP_SPREAD] = 1;
}

/* The straight line of the plane, as elements of the rectangle. Returns 0 if the arena is full. `turned`: radians around the hole, signed,
 * that a unit of the coordinate along the edge is seen from the end. */
static int start_piece(struct sp_newton *newton, const struct tangent *tangent, int32_t across, double middle, double turned, int from_hole,
                       struct sp_piece *piece, struct sp_arena *arena) {
    struct sp_system *system = &newton->system;
    double *spread = sp_arena_take(arena, SP_SPREAD + 1, sizeof(double));
    if (!spread || !sp_reference_make(&system->elements.reference, DEGREE, arena) || !sp_refine_take(&piece->storage, newton, arena))
        return 0;
    close_in(tangent->nearest, from_hole, spread);
    system->elements.count = COUNT, system->elements.spread = spread, system->elements.fixed = 1;
    system->line.fold = sp_fold_of(DEGREE * COUNT - 1);
    double side = tangent->end[across] > middle ? 1 : -1;
    for (int32_t i = 0; i <= DEGREE * COUNT; i++) {
        double t = sp_sample_parameter(&system->elements, i), run = from_hole ? 1 - t : t;
        double x = tangent->far + run * (tangent->touch[0] - tangent->far), y = run * tangent->touch[1], place[2];
        place[across] = middle + side * root(x * x + y * y);
        place[1 - across] = tangent->end[1 - across] + sp_atan2(sp_splat(y), sp_splat(x))[0] / turned;
        for (int32_t j = 0; j < 2; j++)
            system->line.nodes.places[2 * sp_fold_pair(system->line.fold, i) + j][sp_fold_lane(system->line.fold, i)] = place[j];
    }
    sp_fold_mirror(system->line.fold, system->line.nodes.places, 2);
    piece->system = sp_storage_keep(&piece->storage, system);
    piece->first = 0, piece->last = 1;
    return 1;
}

struct sp_refined sp_hole_run(struct sp_newton *newton, const struct sp_options *options, int32_t edge, double beyond,
                              struct sp_arena *arena, struct sp_arcs *arcs) {
    const struct sp_surface *surface = newton->system.line.surface;
    struct sp_fold fold = newton->system.line.fold;
    struct sp_contact contact = {.made = 0, .arcs = {.count = 0}};
    struct sp_refined refined = {.outcome = {.status = SP_SINGULAR_METRIC}};
    struct tangent tangents[2];
    int32_t across = edge / 2;
    double wall = edge % 2 ? surface->upper[across] : surface->lower[across], middle = edge % 2 ? wall + beyond : wall - beyond, ends[2][2];
    for (int i = 0; i < 2; i++) {
        for (int32_t j = 0; j < 2; j++)
            ends[i][j] = sp_fold_get(fold, newton->system.line.nodes.places, 2, i ? fold.inner + 1 : 0, j);
        double far = absolute(ends[i][across] - middle);
        if (!(far > beyond || ends[i][across] == wall)) return refined;
        tangents[i] = tangent_from(ends[i], far, beyond);
    }
    double from = ends[0][1 - across], to = ends[1][1 - across], angle = sp_pole_angle(surface, across, wall, from, to),
           rate = angle / (to - from);
    /* It passes beside it; by how much only a plane tells beforehand. */
    if (!(angle > SURELY_BESIDE * (tangents[0].angle + tangents[1].angle))) return refined;
    for (int i = 0; i < 2; i++) {
        if (i) contact.arcs.arc[contact.arcs.count++] = (struct sp_arc){.on_edge = 1, .across = across, .value = wall, .ends = {from, to}};
        if (ends[i][across] == wall) continue; /* there it begins, or ends */
        struct sp_piece *piece = contact.pieces + contact.made++;
        contact.arcs.arc[contact.arcs.count++] = (struct sp_arc){.on_edge = 0};
        double turned = i ? -rate : rate;
        if (!start_piece(newton, tangents + i, across, middle, turned, i, piece, arena))
            return refined.outcome.status = SP_OUT_OF_MEMORY, refined;
        for (int32_t j = 0; j < 2; j++)
            piece->joint[i].place[j] = piece->joint[1 - i].place[j] = ends[i][j];
        struct sp_joint *touching = piece->joint + 1 - i;
        touching->slides = 1, touching->across = across, touching->reach = STEP / absolute(rate);
        touching->place[across] = wall, touching->place[1 - across] += tangents[i].angle / turned;
    }
    if (sp_contact_solve(newton, options, &contact, arena, &refined)) refined.outcome.active = 1, *arcs = contact.arcs;
    return refined;
}
