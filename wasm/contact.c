/* Paths that touch walls: cut where they do, the pieces fitted, joined; or what chords can do. MATH.md, "Arcs". */
#include "contact.h"
#include "refine_chords.h"
#include "runs.h"
#include "scalar.h"
#include <string.h>

enum {
    CONTACT_NODES = 64,
    FALLBACK_CHORDS = 256,
    KEPT = 4 /* one in so many steps, for these */,
    SPLITS = 4,
    FEW_STEPS = 32 /* lead from a start to what it is without walls, if this is near; */,
    MANY = 3 /* times as many must be left */,
    CORNER_CHORDS = 4 /* from edge to edge: as many do not tell where it leaves them */
};
/* A path that leaves by so much, in parts of the range, touches an edge. */
static const double BEYOND = 1e-12;
/* A path touches a wall that it comes so near to, in parts of the range, if without the wall it would leave the rectangle. */
static const double NEAR = 1e-3;
/* Squared part of a chord that it may differ by from what its nodes' derivatives say. */
static const double ELSEWHERE = 0.04;

/* The way that leaves a wall whose curvature is a parabola is sqrt(3) times as wide as where that is negative. */
static const double WIDER = 0.37;

int sp_contact_leaves(const struct sp_system *system) {
    struct sp_run runs[SP_MAX_ARCS];
    return sp_runs_between(system, BEYOND, runs) > 0;
}

/* The pieces and edge arcs that the runs cut the path into. Returns how many pieces, or -1. */
static int32_t cut(const struct sp_system *system, const struct sp_run *runs, int32_t count, struct sp_piece *pieces,
                   struct sp_arcs *arcs) {
    const struct sp_polyline *line = &system->line;
    int32_t made = 0;
    double from = 0;
    struct sp_joint start = {0};
    for (int32_t j = 0; j < 2; j++)
        start.place[j] = sp_polyline_end(line, 0, j);
    arcs->count = 0;
    for (int32_t r = 0; r <= count; r++) {
        const struct sp_run *run = runs + r;
        double to = r < count ? run->from : 1;
        if (r > 0 && r < count && !(to > from)) return -1; /* no way between them */
        struct sp_joint end = {.slides = r < count && to > 0};
        for (int32_t j = 0; j < 2; j++)
            end.place[j] = sp_polyline_end(line, 1, j);
        if (r < count) {
            end.across = run->across;
            end.place[run->across] = run->side ? line->surface->upper[run->across] : line->surface->lower[run->across];
            end.place[1 - run->across] = run->along[0], end.doubt = absolute(run->along[0] - run->beside[0]);
            end.towards = run->beside[1] < run->beside[0] ? -1 : 1;
        }
        int turns = r > 0 && r < count && (run->across != run[-1].across || run->side != run[-1].side);
        int32_t apart = turns ? run->first - run[-1].last : CORNER_CHORDS + 1;
        if (apart <= CORNER_CHORDS && !sp_contact_cut_corner(line->surface, &start, &end) && apart <= 1) return -1;
        if (to > from && arcs->count < SP_MAX_ARCS) {
            pieces[made++] = (struct sp_piece){.joint = {start, end}, .system = *system, .first = from, .last = to};
            arcs->arc[arcs->count++] = (struct sp_arc){.on_edge = 0};
        }
        if (r == count) break;
        if (arcs->count >= SP_MAX_ARCS - 1) return -1;
        arcs->arc[arcs->count++] =
            (struct sp_arc){.on_edge = 1, .across = run->across, .value = end.place[run->across], .ends = {run->beside[0], run->beside[1]}};
        from = run->to;
        start = end;
        start.slides = from < 1, start.place[1 - run->across] = run->along[1], start.doubt = absolute(run->along[1] - run->beside[1]);
    }
    return made;
}

void sp_contact_cut(const struct sp_system *system, struct sp_contact *contact) {
    struct sp_run runs[SP_MAX_ARCS];
    int32_t count = sp_runs_find(system, 0, runs);
    contact->made = cut(system, runs, count, contact->pieces, &contact->arcs);
}

int sp_contact_assemble(struct sp_contact *contact) {
    struct sp_arcs *arcs = &contact->arcs;
    struct sp_piece *pieces = contact->pieces;
    int32_t piece = 0;
    for (int32_t i = 0; i < arcs->count; i++) {
        struct sp_arc *arc = arcs->arc + i;
        if (!arc->on_edge) {
            *arc = sp_piece_arc(pieces + piece++, 0);
            continue;
        }
        double direction = arc->ends[1] - arc->ends[0];
        if (i > 0) arc->ends[0] = *sp_piece_slide(pieces + piece - 1, 1);
        if (i + 1 < arcs->count) arc->ends[1] = *sp_piece_slide(pieces + piece, 0);
        if (direction * (arc->ends[1] - arc->ends[0]) < 0) return 0;
    }
    return 1;
}

/* Room for what outlives the solves: the path of every piece. */
static int take_storage(const struct sp_newton *newton, struct sp_piece *pieces, int32_t made, struct sp_arena *arena) {
    for (int32_t i = 0; i < made; i++)
        if (!sp_refine_take(&pieces[i].storage, newton, arena)) return 0;
    return 1;
}

/* How many chords lead elsewhere than their nodes' coordinates do: across a hole, say, that is smaller. Of the others the part by which the
 * way along a coordinate line, and so an edge, is longer: an angle's square by six. */
static double chords_astray(const struct sp_polyline *line) {
    double sum = 0;
    for (int32_t i = 0; i <= line->fold.inner; i++)
        for (int end = 0; end < 2; end++) {
            const sp_pair *chart = line->nodes.charts + (size_t)SP_CHART * (size_t)sp_fold_pair(line->fold, i + end);
            int lane = sp_fold_lane(line->fold, i + end);
            double squared = 0, apart = 0, by[2];
            for (int32_t j = 0; j < 2; j++)
                by[j] = sp_polyline_coordinate(line, i + 1, j) - sp_polyline_coordinate(line, i, j);
            for (int32_t k = 0; k < 3; k++) {
                double chord = sp_fold_get(line->fold, line->nodes.charts, SP_CHART, i + 1, k) -
                               sp_fold_get(line->fold, line->nodes.charts, SP_CHART, i, k),
                       off = chord - chart[SP_CHART_1 + k][lane] * by[0] - chart[SP_CHART_2 + k][lane] * by[1];
                squared += chord * chord, apart += off * off;
            }
            if (squared > 0) sum += apart > ELSEWHERE * squared ? 0.5 : apart / squared / 6;
        }
    return sum;
}

/* The best that chords can do, where arcs do not fit. */
static struct sp_refined fall_back(struct sp_newton *newton, const struct sp_options *options, const struct sp_system *contact,
                                   struct sp_arena *arena) {
    struct sp_refined chords = sp_refine_chords(newton, options, FALLBACK_CHORDS, contact, arena);
    chords.length_error *= 3; /* what twice as long ones differ by: round a corner the error falls no faster than they do */
    chords.length_error += chords_astray(&newton->system.line) * chords.length / (newton->system.line.fold.inner + 1);
    if (chords.outcome.status == SP_CONVERGED && chords.length_error > options->tolerance * chords.length)
        chords.outcome.status = SP_TOLERANCE_NOT_MET;
    return chords;
}

/* Sum of the squared derivatives of the length by the contacts' coordinates: cos - 1 of the angle, times what a unit is long. */
static double slopes_of(const struct sp_piece *pieces, int32_t made) {
    double sum = 0;
    for (int32_t i = 0; i < made; i++)
        for (int end = 0; end < 2; end++) {
            double slant = pieces[i].slant[end], slope = 0.5 * slant * slant * pieces[i].speed[end];
            sum += slope * slope;
        }
    return sum;
}

/* Takes the shortest run out of the list: the path was only thought to touch there. */
static void drop_shortest(struct sp_run *runs, int32_t count) {
    int32_t shortest = 0;
    for (int32_t r = 1; r < count; r++)
        if (runs[r].to - runs[r].from < runs[shortest].to - runs[shortest].from) shortest = r;
    memmove(runs + shortest, runs + shortest + 1, (size_t)(count - shortest - 1) * sizeof *runs);
}

/* Cuts the runs in two whose edge the path wants to leave midway, as nothing presses it there: few chords bridge what is shorter. What it
 * leaves only at an end of the path is an end, and no run. Returns whether any was cut; -1: there are too many. */
static int split(const struct sp_surface *surface, const struct sp_arcs *arcs, double least, struct sp_run *runs, int32_t *total) {
    int32_t count = *total, any = 0;
    for (int32_t i = 0, r = 0; i < arcs->count; i++) {
        const struct sp_arc *arc = arcs->arc + i;
        double stretch[2];
        if (!arc->on_edge) continue;
        struct sp_run *run = runs + r++;
        if (!(sp_arcs_edge_gain(surface, arc, stretch) > least)) continue;
        if (count == SP_MAX_ARCS) return -1;
        memmove(run + 1, run, (size_t)(count - r + 1) * sizeof *run);
        double from = run->from, span = run->to - from, wider = WIDER * (stretch[1] - stretch[0]);
        for (int end = 0; end < 2; end++) {
            double rest = 0.5 * (arc->ends[end] - stretch[end]), at = stretch[end];
            at += absolute(rest) < absolute(wider) ? rest : end ? wider : -wider;
            *(end ? &run[1].from : &run->to) = from + span * (at - arc->ends[0]) / (arc->ends[1] - arc->ends[0]);
            run[end].along[1 - end] = run[end].beside[1 - end] = at;
        }
        any = 1, count++, r++;
    }
    int32_t kept = 0;
    for (int32_t r = 0; r < count; r++)
        if (!any || (runs[r].to > 0 && runs[r].from < 1)) runs[kept++] = runs[r];
    *total = kept;
    return any;
}

int sp_contact_solve(struct sp_newton *newton, const struct sp_options *options, struct sp_contact *contact, struct sp_arena *arena,
                     struct sp_refined *whole) {
    int fits = contact->made >= 0;
    for (int32_t i = 0; fits && i < contact->made; i++)
        fits = sp_contact_fit(newton, options, 1, contact->pieces + i, arena);
    fits = fits && sp_contact_assemble(contact);
    if (!fits) return 0;
    *whole = sp_arcs_join(&contact->arcs, newton, slopes_of(contact->pieces, contact->made), arena);
    for (int32_t i = 0; i < contact->made; i++) {
        const struct sp_piece *piece = contact->pieces + i;
        if (piece->solved.outcome.status != SP_ILL_CONDITIONED) continue;
        /* It slides along the edges, as long as they are: 1 - cos of the angle. */
        double slant = larger(absolute(piece->slant[0]), absolute(piece->slant[1]));
        whole->outcome.status = SP_ILL_CONDITIONED, whole->length_error += 0.5 * slant * slant * (whole->length - piece->solved.length);
    }
    return 1;
}

/* The arcs that the runs cut a path into, fitted, and the runs split where the path wants to leave an edge midway. Returns whether they
 * fit; what they take of the arena is then still in use. */
static int fit_runs(struct sp_newton *newton, const struct sp_options *options, const struct sp_system *walled, struct sp_run *runs,
                    int32_t *count, struct sp_contact *contact, struct sp_arena *arena, struct sp_refined *whole) {
    size_t bottom = arena->used;
    for (int32_t splits = 0; splits <= SPLITS; splits++) {
        arena->used = bottom;
        contact->made = cut(walled, runs, *count, contact->pieces, &contact->arcs);
        if (!take_storage(newton, contact->pieces, contact->made, arena)) break;
        if (!sp_contact_solve(newton, options, contact, arena, whole)) break;
        int apart = split(walled->line.surface, &contact->arcs, 0.1 * options->tolerance * whole->length, runs, count);
        if (apart < 0) break;
        if (apart > 0) continue;
        whole->outcome.active = *count > 0;
        return 1;
    }
    arena->used = bottom;
    return 0;
}

/* Puts the node of a path that is nearest to each wall onto it, if it is near: a contact may be shorter than what nodes are apart. */
static void touch(struct sp_polyline *line) {
    for (int32_t edge = 0; edge < 4; edge++) {
        int32_t across = edge / 2, nearest = 0;
        double lower = line->surface->lower[across], upper = line->surface->upper[across], wall = edge % 2 ? upper : lower,
               least = NEAR * (upper - lower);
        for (int32_t i = 1; i <= line->fold.inner; i++) {
            double depth = absolute(sp_polyline_coordinate(line, i, across) - wall);
            if (depth < least) nearest = i, least = depth;
        }
        if (nearest) sp_polyline_put(line, nearest, across, wall);
    }
}

/* A path of arcs, as its nodes on walls tell. */
static int follow(struct sp_newton *newton, const struct sp_options *options, const struct sp_system *given, struct sp_arena *arena,
                  struct sp_arcs *arcs, struct sp_refined *whole) {
    struct sp_contact contact;
    struct sp_run runs[SP_MAX_ARCS];
    int32_t count = sp_runs_find(given, 0, runs);
    int fits = count > 0 && fit_runs(newton, options, given, runs, &count, &contact, arena, whole);
    if (fits) *arcs = contact.arcs;
    return fits;
}

int sp_contact_follow(struct sp_newton *newton, const struct sp_options *options, struct sp_arena *arena, struct sp_arcs *arcs,
                      struct sp_refined *whole) {
    struct sp_storage storages[2];
    struct sp_polyline *line = &newton->system.line;
    const struct sp_surface *surface = line->surface;
    struct sp_surface open = sp_contact_open(surface);
    if (!sp_refine_take(storages, newton, arena) || !sp_refine_take(storages + 1, newton, arena)) return 0;
    newton->system.elements.count = line->fold.inner + 1, newton->system.elements.spread = NULL;
    struct sp_system given = sp_storage_keep(storages, &newton->system);
    if (line->touches) return follow(newton, options, &given, arena, arcs, whole);
    int32_t kept = newton->steps_left - FEW_STEPS;
    if (kept < MANY * FEW_STEPS) return 0;
    line->surface = &open, newton->steps_left = FEW_STEPS;
    *whole = sp_refine_run(newton, options, 1, arena);
    line->surface = surface, newton->steps_left += kept;
    int status = whole->outcome.status, is_path = status == SP_CONVERGED || status == SP_TOLERANCE_NOT_MET;
    if (!is_path || newton->system.elements.reference.degree == 1) return 0;
    if (sp_contact_inside(surface, &newton->system)) return 1;
    struct sp_system beyond = sp_storage_keep(storages + 1, &newton->system);
    touch(&given.line);
    return follow(newton, options, &given, arena, arcs, whole) || follow(newton, options, &beyond, arena, arcs, whole);
}

struct sp_refined sp_contact_run(struct sp_newton *newton, const struct sp_options *options, const struct sp_system *given,
                                 struct sp_arena *arena, struct sp_arcs *arcs) {
    struct sp_contact contact;
    struct sp_storage storage;
    struct sp_refined refined = {.outcome = {.status = SP_OUT_OF_MEMORY, .active = 1}};
    if (!sp_refine_take(&storage, newton, arena)) return refined;
    int32_t count = given->line.fold.inner + 1, chosen = count < CONTACT_NODES     ? CONTACT_NODES
                                                         : count > FALLBACK_CHORDS ? FALLBACK_CHORDS
                                                                                   : count;
    struct sp_refined chords = sp_refine_chords(newton, options, chosen, given, arena);
    if (chords.outcome.status < 0) return chords;
    struct sp_system kept = sp_storage_keep(&storage, &newton->system);
    const struct sp_system *walled = &kept;
    struct sp_run runs[SP_MAX_ARCS];
    int32_t lone = 0, fits, touching = sp_runs_find(walled, 0, runs);
    if (touching == 0) { /* too short a contact for so few chords */
        walled = given;
        touching = sp_runs_find(walled, 0, runs);
        if (touching == 0) touching = sp_runs_between(walled, BEYOND, runs);
    }
    int32_t spared = newton->steps_left / KEPT;
    newton->steps_left -= spared;
    for (;;) {
        fits = fit_runs(newton, options, walled, runs, &touching, &contact, arena, &refined);
        /* Chords need steps, too, where nothing fits; and what cannot be cut is no mistake of theirs. */
        int may_try = contact.made >= 0 && 2 * (newton->steps_left + spared) > options->max_iterations;
        if (fits || lone || (touching == 0 && !may_try)) break;
        if (touching == 0)
            lone = 1, touching = sp_runs_find(walled, lone, runs);
        else if (may_try)
            drop_shortest(runs, touching--);
        else
            touching = 0;
    }
    newton->steps_left += spared;
    *arcs = contact.arcs;
    /* Where only an end touches, nothing has told whether the path wants to cross the wall or to leave it. */
    if (fits && !(lone && absolute(refined.length - chords.length) > 3 * chords.length_error)) return refined;
    arcs->count = 0;
    return fall_back(newton, options, walled, arena);
}
