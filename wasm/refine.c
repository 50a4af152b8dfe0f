/* The ladder of degrees and element counts, and its guard against changing to another geodesic. MATH.md, "The ladder". */
#include "refine.h"
#include "check.h"
#include "ends.h"
#include "metric_check.h"
#include "metric_elements.h"
#include "sample.h"
#include "scalar.h"
#include <string.h>

struct rung {
    int32_t degree, count;
    const double *spread; /* of its elements */
};

/* Degrees and counts. */
static const uint8_t LADDER[][2] = {{8, 2},
                                    {8, 4},
                                    {8, 8},
                                    {8, 16},
                                    {12, 16},
                                    {16, 16},
                                    {24, 16},
                                    {24, 32},
                                    {24, 64},
                                    {16, 128},
                                    {SP_REFINE_DEGREE, SP_REFINE_COUNT},
                                    {SP_REFINE_LAST_DEGREE, SP_REFINE_LAST_COUNT}};
/* Where the path ends on a singular curve. */
static const uint8_t GRADED[][2] = {{8, 2}, {12, 2}, {16, 2}, {16, 4}, {16, 8}, {24, 8}, {24, 16}, {32, 16}, {32, 32}};
/* Elements are no longer spread evenly if somewhere the path turns so many times faster than on an average; from so many nodes on. Then
 * this part of their widths stays even, so that none is without width. */
static const double UNEVEN = 3, EVENLY = 1e-6;
enum { SPREAD_NODES = 64 };
/* Of more chords projected Newton frees about one a step from a wall. */
enum { WALLED_CHORDS = 256 };
/* Elements of so many nodes that touch a wall show where: more do not settle, there the path bends aside. */
enum { TOUCHING_NODES = 768 };
/* On so many inner nodes a step is dear, and a rung that gains less wanders, as finer ones will: there the ladder ends. */
static const double LEAST_GAIN = 1e-5;
enum { LARGE_NODES = 700 };
/* A path that is solved again climbs so many rungs at least: two differences are what tells it settled. */
enum { LEAST_RUNGS = 3 };
/* The last rungs are no drafts: where they are needed what a step leaves is no longer less than what two of them differ by. */
enum { LAST_RUNGS = 2 };
enum { RUNGS = sizeof(LADDER) / sizeof(LADDER[0]), GRADED_RUNGS = sizeof(GRADED) / sizeof(GRADED[0]) };

/* How far beyond an end a surface is looked at, in parts of the length: times the root of the tolerance. One that bends aside there by more
 * than the tolerance has a point beside the end where it is not smooth, and elements from this rung on close in on that. */
static const double REACH = 0.03;
enum { FINE = 7 /* (24, 32) */ };
/* A start whose length in a metric is wrong by more than this part of it has more chords, up to so many. */
static const double UNSEEN = 0.05;
enum { SEEING_CHORDS = 512 };
/* At a branch point squares of speeds are this part of those beside it. */
static const double STILL = 1e-6;

/* Why these: MATH.md, "The ladder". */
static const double FIRST_DECREMENT = 1e-4, DRAFT_DECREMENT = 1e-2, ENOUGH = 0.01, SLOWEST_TRUSTED = 1e-3, SAFETY = 100, LOOSEST = 1e-5;
static const double LENGTH_GUARD = 0.02, DISPLACEMENT_GUARD = 0.04, LENGTH_ALONE = 0.1, CHORD_ERROR = 0.005;
/* A change of the length that happens to be small says little: MATH.md, "The ladder". */
static const double PART_OF_MOVE = 0.01, PART_OF_CHANGE = 0.03;

static int is_graded(const struct sp_elements *elements) { return elements->singular[0] || elements->singular[1]; }

/* Where a rung started, to see how far it moved. */
struct start {
    sp_pair *positions; /* 3 a pair */
};

static int note_start(const struct sp_system *system, struct start *start, struct sp_arena *arena) {
    int32_t pairs = sp_fold_pairs(system->line.fold);
    start->positions = sp_arena_take(arena, 3 * (size_t)pairs, sizeof(sp_pair));
    if (!start->positions) return 0;
    for (int32_t k = 0; k < pairs; k++)
        sp_store(sp_load(system->line.nodes.charts + SP_CHART * k), start->positions + 3 * k);
    return 1;
}

/* Largest distance that a node has moved. */
static double displacement(const struct sp_system *system, const struct start *start) {
    double largest = 0;
    int32_t components = system->line.kind->components;
    const sp_pair *metrics = system->line.nodes.metrics;
    for (int32_t k = 1; k <= sp_fold_unknown(system->line.fold); k++) {
        struct sp_vector moved = sp_subtract(sp_load(system->line.nodes.charts + SP_CHART * k), sp_load(start->positions + 3 * k));
        sp_pair squared = sp_dot(moved, moved), displaced[3];
        sp_store(moved, displaced);
        if (components) squared = sp_metric_product(components, metrics + SP_METRIC_PARTS * components * k, displaced, displaced);
        for (int lane = 0; lane < 2; lane++)
            largest = larger(largest, squared[lane]);
    }
    return root(largest);
}

/* Nodes of `count` elements on the path of `from`, with their charts. */
static enum sp_status carry_over(struct sp_newton *newton, const struct sp_system *from, int32_t count) {
    struct sp_polyline *line = &newton->system.line;
    line->fold = sp_fold_of(newton->system.elements.reference.degree * count - 1);
    newton->system.elements.count = count;
    sp_sample_places(from, &newton->system.elements, line->nodes.places);
    int32_t unknown = sp_fold_unknown(line->fold);
    if (line->surface->kind == SP_PARAMETRIC)
        line->touches = sp_parametric_clip(line->surface, unknown, line->nodes.places + 2);
    else if (!sp_implicit_settle(line->surface, unknown, line->nodes.places + 3, newton->scale))
        return SP_SHEET_JUMP;
    sp_polyline_charts(line, line->nodes);
    return SP_CONVERGED;
}

/* Sets the system up as `rung`, whose reference element is made, started from the path of `from`. */
static enum sp_status start_rung(struct sp_newton *newton, const struct sp_system *from, struct rung rung, struct start *start,
                                 struct sp_arena *arena) {
    struct sp_system *system = &newton->system;
    struct sp_elements *elements = &system->elements;
    size_t order = (size_t)sp_elements_order(rung.degree);
    elements->count = rung.count, elements->spread = rung.spread;
    elements->matrices = sp_arena_take(arena, order * order * (size_t)rung.count / 2, sizeof(sp_pair));
    elements->velocity = sp_arena_take(arena, 3 * ((size_t)rung.degree + 2), sizeof(sp_pair));
    elements->skeleton = sp_arena_take(arena, (size_t)rung.count / 2 + 1, sizeof(struct sp_row));
    if (!elements->matrices || !elements->velocity || !elements->skeleton) return SP_OUT_OF_MEMORY;
    if (is_graded(elements) && !sp_graded_make(&elements->graded, &elements->reference, elements->singular, arena)) return SP_OUT_OF_MEMORY;
    enum sp_status status = carry_over(newton, from, rung.count);
    if (status != SP_CONVERGED) return status;
    return note_start(system, start, arena) ? SP_CONVERGED : SP_OUT_OF_MEMORY;
}

/* One rung from one start: its outcome, length and how far it moved. */
struct climbed {
    struct sp_outcome outcome;
    double length, moved;
};

/* Runs Newton from the path as it stands and measures where it leads. One that wanders is SP_TOLERANCE_NOT_MET. */
static void run(struct sp_newton *newton, const struct sp_options *options, const struct start *start, struct climbed *climbed) {
    const struct sp_elements *elements = &newton->system.elements;
    int may_wander = elements->reference.degree > 1 && !is_graded(elements) && newton->system.line.fold.inner >= LARGE_NODES;
    newton->least_gain = may_wander ? LEAST_GAIN : 0;
    climbed->outcome = sp_newton_run(newton, options);
    newton->least_gain = 0;
    if (climbed->outcome.status < 0) return;
    sp_ends_turn(&newton->system);
    climbed->length = sp_system_length(&newton->system, newton->system.line.nodes);
    climbed->moved = displacement(&newton->system, start);
}

static struct climbed climb(struct sp_newton *newton, const struct sp_options *options, const struct sp_system *from, struct rung rung,
                            struct start *start, struct sp_arena *arena) {
    struct climbed climbed = {0};
    climbed.outcome.status = start_rung(newton, from, rung, start, arena);
    if (climbed.outcome.status == SP_CONVERGED) run(newton, options, start, &climbed);
    return climbed;
}

/* Enough for a step more to be below the tolerance. */
static double decrement_of(const struct sp_options *options) { return options->tolerance < 1e-8 ? 1e-8 : 1e-6; }

/* A draft is one step from a small decrement, not looked at again; any other run ends at rest. */
static void aim(struct sp_newton *newton, const struct sp_options *options, int32_t draft) {
    newton->draft = draft;
    newton->decrement = draft ? DRAFT_DECREMENT : decrement_of(options);
    newton->enough = draft ? 0 : ENOUGH * smaller(options->tolerance, LOOSEST);
}

/* A rung that ended as another path than the first one found: in another class of geodesics, or not at rest. */
static int strayed(const struct climbed *climbed, double first_length) {
    double change = climbed->length / first_length - 1;
    if (climbed->outcome.status < 0 || climbed->outcome.status == SP_STALLED) return 1;
    return first_length > 0 && (change > LENGTH_GUARD || change < -LENGTH_GUARD || climbed->moved > DISPLACEMENT_GUARD * climbed->length);
}

/* No looser than what ends of arcs are fitted to, no tighter than what the coordinates' rounding allows. */
static double tolerance_of(const struct sp_newton *newton, const struct sp_options *options, double length) {
    return larger(smaller(options->tolerance, LOOSEST), 8 * 2.2e-16 * newton->size / length);
}

static struct sp_refined finish(const struct sp_newton *newton, struct climbed climbed, double length_error) {
    double error = larger(length_error, sp_check_rounding(climbed.length, newton->size));
    return (struct sp_refined){climbed.outcome, climbed.length, error + climbed.outcome.doubt * climbed.length};
}

/* A rung from the path of the rung before; if that leads astray, from the path of chords. */
static struct climbed climb_guarded(struct sp_newton *newton, const struct sp_options *options, const struct sp_system *before,
                                    const struct sp_system *first, double first_length, struct rung rung, struct start *start,
                                    struct sp_arena *arena) {
    size_t bottom = arena->used;
    struct climbed now = climb(newton, options, before, rung, start, arena);
    if (strayed(&now, first_length) && before->elements.reference.degree > 1) {
        arena->used = bottom;
        now = climb(newton, options, first, rung, start, arena);
    }
    return now;
}

/* Whether a path that moved so far from that of the rung before is itself within `allowed`: how far it moved is the error of that one, its
 * own is smaller, if rungs converge, by as much as the last two moves differ. */
static int is_settled(double moved, double moved_before, double allowed) {
    if (!(moved_before > 0)) return moved <= allowed;
    double ratio = larger(moved / moved_before, SLOWEST_TRUSTED);
    return moved <= allowed || SAFETY * ratio * moved <= allowed;
}

/* The last rung of fewer nodes: a path that took many has nothing to learn from a few, and Newton on them wanders. */
static int lowest_rung(const uint8_t (*ladder)[2], int rungs, int32_t nodes) {
    int r = 0;
    while (r + LEAST_RUNGS < rungs && ladder[r + 1][0] * ladder[r + 1][1] < nodes)
        r++;
    return r;
}

/* What a path at rest that is smooth has none of: E/L^2 - 1, the variance of its speed. A crease inside an element, or beside the nodes,
 * leaves both sides with speeds of their own. Times the length, what it may be too long by. */
static double unevenness(const struct climbed *climbed) {
    double length = climbed->length;
    return smaller(larger(climbed->outcome.energy / length - length, 0), length);
}

/* By how much the path's velocity changes at each node, in parts of itself: by how many radians it turns, about, where its speed is even,
 * as it is without a density; and the node's parameter. Returns the sum of the turns. */
static double measure_turns(const struct sp_system *system, sp_pair *turns) {
    struct sp_fold fold = system->line.fold;
    double at[3] = {0}, velocity[3] = {0}, from = 0, total = 0;
    for (int32_t i = 0; i <= fold.inner + 1; i++) {
        const sp_pair *chart = system->line.nodes.charts + (size_t)SP_CHART * (size_t)sp_fold_pair(fold, i) + SP_CHART_X;
        double to = sp_sample_parameter(&system->elements, i), rate = i > 0 ? 1 / (to - from) : 0, by = 0, size = 0;
        for (int c = 0; c < 3; c++) {
            double x = chart[c][sp_fold_lane(fold, i)], now = rate * (x - at[c]), change = now - velocity[c];
            by += change * change, size += now * now + velocity[c] * velocity[c];
            at[c] = x, velocity[c] = now;
        }
        turns[i] = (sp_pair){0, from = to};
        if (i > 1 && size > 0) total += turns[i - 1][0] = root(2 * by / size);
    }
    return total;
}

/* Where elements meet if they are to be equally long, the path's parameter and its turns taken together: `spread`.
 * Returns 0 if that is nearly even. `turns`: scratch, a pair a node. */
static int spread_elements(const struct sp_system *system, sp_pair *turns, double spread[SP_SPREAD + 1]) {
    int32_t k = 1;
    double total = 1 + measure_turns(system, turns), passed = 0, most = 0;
    for (int32_t i = 0; i <= system->line.fold.inner; i++) {
        double from = turns[i][1], span = turns[i + 1][1] - from, part = span + 0.5 * (turns[i][0] + turns[i + 1][0]);
        most = larger(most, part / span);
        for (; k < SP_SPREAD && passed + part >= total * k / SP_SPREAD; k++)
            spread[k] = from + span * ((total * k / SP_SPREAD - passed) / part);
        passed += part;
    }
    for (spread[0] = 0; k <= SP_SPREAD; k++)
        spread[k] = 1;
    for (k = 1; k < SP_SPREAD; k++)
        spread[k] += EVENLY * ((double)k / SP_SPREAD - spread[k]);
    return most > UNEVEN * total;
}

/* The path of `count` chords, from another one. */
static struct climbed climb_chords(struct sp_newton *newton, const struct sp_options *options, int32_t count, const struct sp_system *from,
                                   struct sp_arena *arena) {
    struct start start;
    struct climbed chords = {.outcome = {.status = SP_OUT_OF_MEMORY}};
    newton->decrement = FIRST_DECREMENT, newton->enough = 0, newton->draft = 0;
    if (sp_reference_make(&newton->system.elements.reference, 1, arena))
        chords = climb(newton, options, from, (struct rung){1, count, NULL}, &start, arena);
    return chords;
}

/* Climbs until two neighbouring rungs agree. `first`: a path that all must be near to; of chords, if it has a storage: then of twice as
 * many if a rung at rest that has as many nodes is not. */
static struct sp_refined climb_all(struct sp_newton *newton, const struct sp_options *options, const uint8_t (*ladder)[2], int rungs,
                                   struct sp_system *first, const struct sp_storage *chords, double first_length, struct sp_arena *arena) {
    struct climbed now = {.length = first_length};
    struct sp_system before = *first;
    double last = first_length, change = first_length, moved = 0, error = 0, allowed = 0;
    double spread[SP_SPREAD + 1], *present = sp_arena_take(arena, SP_SPREAD + 1, sizeof(double));
    int follows = 0, uneven = newton->system.elements.spread != NULL;
    if (uneven) memcpy(spread, newton->system.elements.spread, sizeof spread);
    /* A metric that changes much is what so many chords were for. */
    if (chords && first->line.kind->components && first->line.fold.inner >= SPREAD_NODES)
        uneven = spread_elements(first, newton->step, spread);
    struct start start;
    struct sp_storage storage;
    if (!present || !sp_refine_take(&storage, newton, arena)) return now.outcome.status = SP_OUT_OF_MEMORY, finish(newton, now, 0);
    size_t floor = arena->used, bottom = floor;
    for (int r = 0; r < rungs; r++) {
        int from_elements = r > 0 && before.elements.reference.degree > 1;
        arena->used = bottom;
        if (r == 0 || ladder[r][0] != newton->system.elements.reference.degree) {
            arena->used = floor;
            if (!sp_reference_make(&newton->system.elements.reference, ladder[r][0], arena))
                return now.outcome.status = SP_OUT_OF_MEMORY, finish(newton, now, 0);
            bottom = arena->used;
        }
        aim(newton, options, r < rungs - (follows ? LAST_RUNGS : 1));
        struct rung rung = {ladder[r][0], ladder[r][1], NULL};
        if (uneven) rung.spread = memcpy(present, spread, sizeof spread);
        now = climb_guarded(newton, options, &before, first, first_length, rung, &start, arena);
        allowed = tolerance_of(newton, options, now.length) * now.length;
        int astray = strayed(&now, first_length);
        int agrees = !astray && from_elements && absolute(now.length - last) <= allowed && is_settled(now.moved, moved, allowed);
        if (agrees && newton->draft) {
            aim(newton, options, 0);
            if (!sp_newton_confirm(newton, &now.outcome)) run(newton, options, &start, &now);
            astray = strayed(&now, first_length);
        }
        int wanders = now.outcome.status == SP_TOLERANCE_NOT_MET && !astray;
        if (wanders || now.outcome.status == SP_OUT_OF_MEMORY || now.outcome.status == SP_ITERATION_LIMIT)
            return finish(newton, now, absolute(now.length - last));
        int32_t count = 2 * (first->line.fold.inner + 1);
        if (astray && now.outcome.status == SP_CONVERGED && chords && count <= rung.degree * rung.count && count <= SP_REFINE_CHORDS) {
            arena->used = floor;
            now = climb_chords(newton, options, count, first, arena);
            if (now.outcome.status != SP_CONVERGED) return finish(newton, now, absolute(now.length - last));
            before = *first = sp_storage_keep(chords, &newton->system);
            last = change = first_length = now.length, moved = 0, r--;
            continue;
        }
        double previous = change;
        follows = !astray && from_elements;
        change = absolute(now.length - last);
        last = now.length;
        double uneven_by = unevenness(&now);
        error = larger(uneven_by, follows ? larger(change, smaller(PART_OF_MOVE * now.moved, PART_OF_CHANGE * previous)) : change);
        if (agrees && !astray && change <= allowed && uneven_by <= allowed && is_settled(now.moved, moved, allowed))
            return finish(newton, now, error);
        if (now.outcome.active && !astray && rung.degree * rung.count >= TOUCHING_NODES) break;
        moved = from_elements && !astray && first->elements.reference.degree == 1 ? now.moved : 0;
        if (astray)
            before = *first;
        else
            before = sp_storage_keep(&storage, &newton->system);
        if (!astray && !newton->system.elements.fixed && rung.degree * rung.count >= SPREAD_NODES)
            uneven = spread_elements(&newton->system, newton->step, spread);
    }
    /* At the top only positions may be left to settle: beside a singular curve they do so like square roots, the length does not. */
    int settled = follows && change <= LENGTH_ALONE * allowed && error <= allowed;
    if (now.outcome.status == SP_CONVERGED && !settled) now.outcome.status = SP_TOLERANCE_NOT_MET;
    return finish(newton, now, error);
}

int sp_refine_take(struct sp_storage *storage, const struct sp_newton *newton, struct sp_arena *arena) {
    return sp_storage_take(storage, newton->system.line.kind->dimension, SP_REFINE_INNER, arena);
}

/* The last rung; two stored paths. */
double sp_refine_bytes(void) {
    double order = sp_elements_order(SP_REFINE_DEGREE), pairs = SP_REFINE_INNER / 2 + 3;
    double numbers = order * order * (SP_REFINE_COUNT / 2) + 3 * (SP_REFINE_DEGREE + 2) + 3 * pairs + 2 * 3 * pairs + 2 * SP_SPREAD;
    return 4 * sp_reference_bytes(SP_REFINE_DEGREE) + numbers * sizeof(sp_pair) + (SP_REFINE_LAST_COUNT / 2 + 1.0) * sizeof(struct sp_row) +
           4 * (SP_REFINE_DEGREE + 1.0) * sizeof(double) + 20 * 16;
}

/* What chords are wrong by in length, and whether they may be trusted. */
static double check_chords(const struct sp_newton *newton, const struct climbed *chords, enum sp_status *status) {
    struct sp_chord_sums sums = {0, 0};
    *status = sp_check_chords(&newton->system, newton->scale, &sums);
    return sp_check_length_error(&newton->system.line, newton->size, chords->outcome.active, &sums);
}

/* The path on twice as many chords. */
static enum sp_status double_chords(struct sp_newton *newton, const struct sp_storage *storage) {
    struct sp_system before = sp_storage_keep(storage, &newton->system);
    return carry_over(newton, &before, 2 * (newton->system.line.fold.inner + 1));
}

/* A start whose nodes do not see the metric along it, on more chords: Newton would hide nodes on both sides of what they do not see. */
static enum sp_status see_metric(struct sp_newton *newton, const struct sp_storage *storage) {
    struct sp_polyline *line = &newton->system.line;
    enum sp_status status = SP_CONVERGED;
    while (status == SP_CONVERGED && line->kind->components && line->fold.inner < SEEING_CHORDS &&
           sp_metric_length_error(line, newton->size, 0) > UNSEEN * sp_system_length(&newton->system, line->nodes))
        status = double_chords(newton, storage);
    return status;
}

/* The path of chords, as it was checked, and what its length is wrong by. Where a surface has many waves, or a metric turns quickly, 32
 * chords are wrong by more than the guard allows (7 % on a field of 25:1 that turns by three radians): then twice as many, until they are
 * not. */
static struct climbed find_first(struct sp_newton *newton, const struct sp_options *options, const struct sp_storage *storage,
                                 double *error) {
    struct sp_polyline *line = &newton->system.line;
    newton->system.elements.count = line->fold.inner + 1;
    struct climbed now = {.outcome = {.status = see_metric(newton, storage)}};
    while (now.outcome.status == SP_CONVERGED) {
        int32_t count = 2 * (line->fold.inner + 1);
        now.outcome = sp_newton_run(newton, options);
        if (now.outcome.status < 0) break;
        sp_ends_turn(&newton->system);
        now.length = sp_system_length(&newton->system, line->nodes);
        enum sp_status checked;
        double before = *error;
        *error = check_chords(newton, &now, &checked);
        if (checked < 0) now.outcome.status = checked;
        int enough = count > (now.outcome.active ? WALLED_CHORDS : SP_REFINE_CHORDS) || *error <= CHORD_ERROR * now.length;
        /* Nodes that hide from a metric do so the better the more they are. */
        int hides = line->kind->components && before > 0 && *error > before;
        if (now.outcome.status != SP_CONVERGED || enough || hides) break;
        now.outcome.status = double_chords(newton, storage);
    }
    return now;
}

struct sp_refined sp_refine_same(struct sp_newton *newton, const struct sp_options *options, const struct sp_system *from,
                                 struct sp_arena *arena) {
    struct rung rung = {from->elements.reference.degree, from->elements.count, from->elements.spread};
    struct start start;
    aim(newton, options, 0);
    newton->decrement = larger(newton->decrement, 10 * options->tolerance);
    if (!sp_reference_make(&newton->system.elements.reference, rung.degree, arena))
        return finish(newton, (struct climbed){.outcome = {.status = SP_OUT_OF_MEMORY}}, 0);
    return finish(newton, climb(newton, options, from, rung, &start, arena), 0);
}

/* Where elements meet that close in on both ends of a path, up to `least`: each longer than the one before by the same factor. */
static void close_in(double least, double spread[SP_SPREAD + 1]) {
    double ratio = 1 / least, far = 0.5 * least;
    for (int k = SP_SPREAD / 2; k > 1; k /= 2)
        ratio = root(ratio);
    for (int k = 1; k <= SP_SPREAD / 2; k++)
        far *= ratio, spread[k] = far, spread[SP_SPREAD - k] = 1 - far;
    spread[0] = 0, spread[SP_SPREAD] = 1;
}

/* Whether the surface bends aside just beyond an end of the path by more than a smooth one does; not asked where rounding is all there is.
 * MATH.md, "The ladder". */
static int bends_aside(const struct sp_newton *newton, double tolerance, double length) {
    const struct sp_system *system = &newton->system;
    return tolerance < 1 && system->line.kind->components == 0 &&
           sp_sample_bend(system, newton->scale, REACH * root(tolerance)) > tolerance * length;
}

/* The path again, on elements that close in on its ends. */
static struct sp_refined climb_closer(struct sp_newton *newton, const struct sp_options *options, struct sp_system *from, double tolerance,
                                      double length, struct sp_arena *arena) {
    double spread[SP_SPREAD + 1];
    close_in(tolerance, spread);
    newton->system.elements.spread = spread, newton->system.elements.fixed = 1;
    return climb_all(newton, options, LADDER + FINE, RUNGS - FINE, from, NULL, length, arena);
}

/* Whether the path begins or ends in a branch point: there the surface's derivatives are nothing beside those at the next node. */
static int ends_in_branch(const struct sp_polyline *line) {
    sp_pair squares[2];
    for (int k = 0; k < 2; k++) {
        struct sp_vector a = sp_load(line->nodes.charts + SP_CHART * k + SP_CHART_1),
                         b = sp_load(line->nodes.charts + SP_CHART * k + SP_CHART_2);
        squares[k] = sp_dot(a, a) + sp_dot(b, b);
    }
    return sp_any(squares[0] < STILL * squares[1]);
}

struct sp_refined sp_refine_run(struct sp_newton *newton, const struct sp_options *options, struct sp_arena *arena) {
    struct sp_storage storage;
    if (!sp_refine_take(&storage, newton, arena)) return finish(newton, (struct climbed){.outcome = {.status = SP_OUT_OF_MEMORY}}, 0);
    newton->decrement = newton->enough = FIRST_DECREMENT, newton->draft = 0, newton->system.elements.spread = NULL;
    double error = 0;
    struct climbed first = find_first(newton, options, &storage, &error);
    int at_rest = first.outcome.status == SP_CONVERGED || first.outcome.status == SP_ILL_CONDITIONED;
    if (!at_rest || first.outcome.energy == 0 || first.outcome.active) return finish(newton, first, error);
    int lowest = lowest_rung(LADDER, RUNGS, newton->system.line.fold.inner);
    struct sp_system kept = sp_storage_keep(&storage, &newton->system);
    size_t used = arena->used;
    if (ends_in_branch(&newton->system.line)) {
        struct sp_refined closer = climb_closer(newton, options, &kept, tolerance_of(newton, options, first.length), first.length, arena);
        if (closer.outcome.status == SP_CONVERGED) return closer;
        newton->system.elements.spread = NULL, newton->system.elements.fixed = 0, arena->used = used;
    }
    struct sp_refined refined = climb_all(newton, options, LADDER + lowest, RUNGS - lowest, &kept, &storage, first.length, arena);
    double tolerance = tolerance_of(newton, options, refined.length);
    if (refined.outcome.status < 0 || !bends_aside(newton, tolerance, refined.length)) return refined;
    kept = sp_storage_keep(&storage, &newton->system), arena->used = used;
    struct sp_refined closer = climb_closer(newton, options, &kept, tolerance, refined.length, arena);
    if (closer.outcome.status == SP_CONVERGED) return closer;
    arena->used = used;
    closer = sp_refine_same(newton, options, &kept, arena);
    if (closer.outcome.status < 0) refined.outcome.status = closer.outcome.status;
    return refined;
}

struct sp_refined sp_refine_again(struct sp_newton *newton, const struct sp_options *options, const struct sp_system *from, double length,
                                  struct sp_arena *arena) {
    int graded = is_graded(&newton->system.elements), rungs = graded ? GRADED_RUNGS : RUNGS;
    const uint8_t(*ladder)[2] = graded ? GRADED : LADDER;
    int lowest = lowest_rung(ladder, rungs, from->elements.reference.degree * from->elements.count);
    struct sp_system first = *from;
    newton->system.elements.spread = from->elements.spread;
    return climb_all(newton, options, ladder + lowest, rungs - lowest, &first, NULL, length, arena);
}

struct sp_refined sp_refine_chords(struct sp_newton *newton, const struct sp_options *options, int32_t count, const struct sp_system *from,
                                   struct sp_arena *arena) {
    struct climbed chords = climb_chords(newton, options, count, from, arena);
    enum sp_status ignored;
    return finish(newton, chords, chords.outcome.status < 0 ? 0 : check_chords(newton, &chords, &ignored));
}

/* From how many chords on a coarser polyline helps, how few it may have, and by what it is coarser. */
enum { LEAST_CHORDS = 128, COARSE_CHORDS = 16, COARSEN = 4 };

int32_t sp_refine_coarsest(int32_t count) {
    int32_t coarse = count;
    while (count >= LEAST_CHORDS && coarse >= COARSEN * COARSE_CHORDS)
        coarse = (coarse + COARSEN - 1) / COARSEN;
    return coarse;
}

/* The next of the numbers of chords between `chords` and `count`. */
static int32_t finer(int32_t chords, int32_t count) {
    int32_t next = count;
    while ((next + COARSEN - 1) / COARSEN > chords)
        next = (next + COARSEN - 1) / COARSEN;
    return next;
}

double sp_refine_polyline_bytes(int32_t dimension, int32_t count) {
    return (count / (2.0 * COARSEN) + 4) * dimension * sizeof(sp_pair) + 2 * (SP_MAX_DEGREE + 1) * sizeof(double) + 3 * 16;
}

int sp_refine_polyline(struct sp_newton *newton, const struct sp_options *options, int32_t count, struct sp_arena *arena) {
    struct sp_polyline *line = &newton->system.line;
    struct sp_storage storage;
    int32_t largest = (count + COARSEN - 1) / COARSEN;
    if (!sp_storage_take(&storage, line->kind->dimension, largest - 1, arena)) return 0;
    double wanted = newton->decrement;
    newton->draft = 1, newton->decrement = DRAFT_DECREMENT;
    enum sp_status status = SP_CONVERGED;
    for (int32_t chords = line->fold.inner + 1; status == SP_CONVERGED && chords < count; chords = line->fold.inner + 1) {
        struct sp_outcome outcome = sp_newton_run(newton, options);
        if (outcome.status != SP_CONVERGED) break;
        struct sp_system before = sp_storage_keep(&storage, &newton->system);
        status = carry_over(newton, &before, finer(chords, count));
    }
    newton->draft = 0, newton->decrement = wanted;
    return status == SP_CONVERGED && line->fold.inner + 1 == count;
}
