/* The ladder of degrees and element counts, and its guard against changing to another geodesic. MATH.md, "The ladder". */
#include "check.h"
#include "refine_chords.h"
#include "refine_spread.h"
#include "scalar.h"
#include <string.h>

/* Degrees and counts. The last two three times: each tells better where elements should lie. */
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
                                    {SP_REFINE_LAST_DEGREE, SP_REFINE_LAST_COUNT},
                                    {SP_REFINE_DEGREE, SP_REFINE_COUNT},
                                    {SP_REFINE_LAST_DEGREE, SP_REFINE_LAST_COUNT},
                                    {SP_REFINE_DEGREE, SP_REFINE_COUNT},
                                    {SP_REFINE_LAST_DEGREE, SP_REFINE_LAST_COUNT}};
/* Where the path ends on a singular curve. */
static const uint8_t GRADED[][2] = {{8, 2}, {12, 2}, {16, 2}, {16, 4}, {16, 8}, {24, 8}, {24, 16}, {32, 16}, {32, 32}};
/* From so many nodes on elements may be spread unevenly, in space and in a metric, of which few see less. */
enum { SPREAD_NODES = 32, SPREAD_NODES_METRIC = 64 };
/* Elements of so many nodes that touch a wall show where: more do not settle, there the path bends aside. */
enum { TOUCHING_NODES = 768 };
/* A path that is solved again climbs so many rungs at least: two differences are what tells it settled. */
enum { LEAST_RUNGS = 3 };
/* The last rungs are no drafts: where they are needed what a step leaves is no longer less than what two of them differ by. */
enum { LAST_RUNGS = 2 };
/* So many are climbed a second time, and a third time from a fine start, which begins no lower. */
enum { AGAIN = 2 };
enum { FINE_RUNGS = sizeof(LADDER) / sizeof(LADDER[0]), RUNGS = FINE_RUNGS - AGAIN, GRADED_RUNGS = sizeof(GRADED) / sizeof(GRADED[0]) };

/* How far beyond an end a surface is looked at, in parts of the length: times the root of the tolerance. One that bends aside there by more
 * than the tolerance has a point beside the end where it is not smooth, and elements from this rung on close in on that. */
static const double REACH = 0.03;
enum { FINE = 7 /* (24, 32) */ };
/* At a branch point squares of speeds are this part of those beside it. */
static const double STILL = 1e-6;

/* Why these: MATH.md, "The ladder". */
static const double ENOUGH = 0.01, SLOWEST_TRUSTED = 1e-3, SAFETY = 100, LOOSEST = 1e-5;
static const double LENGTH_GUARD = 0.02, DISPLACEMENT_GUARD = 0.04;
/* A change of the length that happens to be small says little: MATH.md, "The ladder". */
static const double PART_OF_MOVE = 0.01, PART_OF_CHANGE = 0.03;
/* What agrees with chords to this part of a tolerance, or of the loosest, is enough, and wrong by the third of how far it moved. */
static const double CHORDS_AGREE = 0.1, CHORDS_LOOSEST = 1e-2, PART_OF_CHORDS = 0.3;

/* Enough for a step more to be below the tolerance. */
static double decrement_of(const struct sp_options *options) { return options->tolerance < 1e-8 ? 1e-8 : 1e-6; }

/* A draft is one step from a small decrement, not looked at again; any other run ends at rest. */
static void aim(struct sp_newton *newton, const struct sp_options *options, int32_t draft) {
    newton->draft = draft;
    newton->decrement = draft ? SP_DRAFT_DECREMENT : decrement_of(options);
    newton->enough = draft ? 0 : ENOUGH * smaller(options->tolerance, LOOSEST);
}

/* A rung that ended as another path than the first one found: in another class of geodesics, or not at rest. */
static int strayed(const struct sp_climbed *climbed, double first_length) {
    double change = climbed->length / first_length - 1;
    if (climbed->outcome.status < 0 || climbed->outcome.status == SP_STALLED) return 1;
    return first_length > 0 && (change > LENGTH_GUARD || change < -LENGTH_GUARD || climbed->moved > DISPLACEMENT_GUARD * climbed->length);
}

/* No looser than what ends of arcs are fitted to, no tighter than what the coordinates' rounding allows. */
static double tolerance_of(const struct sp_newton *newton, const struct sp_options *options, double length) {
    return larger(smaller(options->tolerance, LOOSEST), 8 * 2.2e-16 * newton->size / length);
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

/* What the path that a rung started from is: chords that are enough to compare it with where the tolerance is loose, elements of the rung
 * before, or what says nothing of it, as a path between other ends. */
enum origin { ORIGIN_OTHER, ORIGIN_CHORDS, ORIGIN_RUNG };

/* A climb, rung by rung. */
struct climb {
    struct sp_newton *newton;
    const struct sp_options *options;
    struct sp_arena *arena;
    struct sp_system *first;         /* a path that all must be near to */
    int is_fine;                     /* 1: it is a start, not at rest */
    const struct sp_storage *chords; /* its storage, if it is one of chords that may be more; else NULL */
    double first_length;             /* 0: not known */
    struct sp_system before;         /* the path that the next rung starts from */
    enum origin origin;              /* what that is */
    struct sp_climbed now;
    double last, change, moved; /* length of the last rung, by how much it had changed, how far nodes had moved (0: not known) */
    double error, allowed;      /* what the length of `now` is, and may be, wrong by */
    int astray;                 /* 1: `now` is another path than the first */
    int follows;                /* 1: it is not, and started from a path of elements */
    size_t floor, bottom;       /* bytes of arena below the reference element, and with it */
};

static struct sp_refined finish(const struct climb *climb, double error) { return sp_rung_finish(climb->newton, &climb->now, error); }

static struct sp_refined out_of_memory(struct climb *climb) { return climb->now.outcome.status = SP_OUT_OF_MEMORY, finish(climb, 0); }

/* The reference element, unless there is one of this degree. Returns 0 if the arena is full. */
static int take_reference(struct climb *climb, int32_t degree) {
    struct sp_reference *reference = &climb->newton->system.elements.reference;
    climb->arena->used = climb->bottom;
    if (climb->bottom > climb->floor && degree == reference->degree) return 1;
    climb->arena->used = climb->floor;
    if (!sp_reference_make(reference, degree, climb->arena)) return 0;
    climb->bottom = climb->arena->used;
    return 1;
}

/* A rung from the path of the rung before; if that leads astray, from the first path. */
static void climb_guarded(struct climb *climb, const struct sp_rung *rung) {
    sp_rung_climb(climb->newton, climb->options, &climb->before, rung, climb->arena, &climb->now);
    if (strayed(&climb->now, climb->first_length) && climb->before.elements.reference.degree > 1) {
        climb->arena->used = climb->bottom;
        sp_rung_climb(climb->newton, climb->options, climb->first, rung, climb->arena, &climb->now);
    }
}

/* What the rung that was climbed may differ by from the path before. */
static double allow(const struct climb *climb) {
    double length = climb->now.length, tolerance = tolerance_of(climb->newton, climb->options, length);
    if (climb->origin == ORIGIN_CHORDS) tolerance = CHORDS_AGREE * larger(tolerance, smaller(climb->options->tolerance, CHORDS_LOOSEST));
    return tolerance * length;
}

/* Climbs a rung; a draft that agrees with the path before, to its end. Returns whether the two agree. */
static int climb_rung(struct climb *climb, const struct sp_rung *rung) {
    struct sp_newton *newton = climb->newton;
    struct sp_climbed *now = &climb->now;
    climb_guarded(climb, rung);
    climb->allowed = allow(climb);
    climb->astray = strayed(now, climb->first_length);
    int agrees = !climb->astray && climb->origin != ORIGIN_OTHER && absolute(now->length - climb->last) <= climb->allowed &&
                 is_settled(now->moved, climb->moved, climb->allowed);
    if (agrees && newton->draft) {
        aim(newton, climb->options, 0);
        if (!sp_newton_confirm(newton, &now->outcome)) sp_rung_run(newton, climb->options, now);
        climb->astray = strayed(now, climb->first_length);
    }
    return agrees && !climb->astray;
}

/* Whether the first path is one of too few chords: a rung at rest that has twice as many nodes has strayed from it. */
static int wants_chords(const struct climb *climb, const struct sp_rung *rung) {
    int32_t count = 2 * (climb->first->line.fold.inner + 1);
    return climb->astray && climb->now.outcome.status == SP_CONVERGED && climb->chords && count <= rung->degree * rung->count &&
           count <= SP_REFINE_CHORDS;
}

/* A first path of twice as many chords. Returns 0 where that is none at rest. */
static int begin_again(struct climb *climb) {
    struct sp_climbed *now = &climb->now;
    climb->arena->used = climb->floor;
    sp_chords_climb(climb->newton, climb->options, 2 * (climb->first->line.fold.inner + 1), climb->first, climb->arena, now);
    if (now->outcome.status != SP_CONVERGED) return 0;
    climb->before = *climb->first = sp_storage_keep(climb->chords, &climb->newton->system);
    climb->last = climb->change = climb->first_length = now->length, climb->moved = 0;
    return 1;
}

/* The end of a climb that has no steps left. In a metric what is not at rest, and of another length than the first path, hides its nodes
 * from what is dear: it is no path, and less than the chords are, as long as they say. */
static struct sp_refined give_up(struct climb *climb) {
    const struct sp_polyline *line = &climb->first->line;
    if (!climb->astray || !climb->chords || line->kind->components == 0) return finish(climb, absolute(climb->now.length - climb->last));
    climb->arena->used = climb->floor;
    struct sp_refined chords = sp_refine_chords(climb->newton, climb->options, line->fold.inner + 1, climb->first, climb->arena);
    if (chords.outcome.status >= 0) chords.outcome.status = SP_ITERATION_LIMIT;
    return chords;
}

/* What the rung that was climbed is wrong by. Returns whether that is allowed. */
static int measure(struct climb *climb) {
    const struct sp_climbed *now = &climb->now;
    double previous = climb->change, uneven = sp_check_unevenness(now->outcome.energy, now->length), least = 0, tail = 0;
    climb->follows = !climb->astray && climb->origin == ORIGIN_RUNG;
    climb->change = absolute(now->length - climb->last);
    climb->last = now->length;
    if (climb->follows) least = smaller(PART_OF_MOVE * now->moved, PART_OF_CHANGE * previous);
    /* Rungs have other nodes than those before; between the first one's only what it leaves over tells. */
    if (climb->origin == ORIGIN_CHORDS) least = PART_OF_CHORDS * now->moved, tail = sp_spread_tail(&climb->newton->system) * now->length;
    climb->error = larger(uneven, larger(climb->change, least));
    return larger(climb->change, uneven) <= climb->allowed && tail <= climb->allowed &&
           is_settled(now->moved, climb->moved, climb->allowed);
}

/* Climbs until two neighbouring rungs agree. */
static struct sp_refined climb_all(struct climb *climb, const uint8_t (*ladder)[2], int rungs) {
    struct sp_newton *newton = climb->newton;
    const struct sp_elements *elements = &newton->system.elements;
    const struct sp_system *first = climb->first;
    struct sp_climbed *now = &climb->now;
    struct sp_storage storage;
    double spread[SP_SPREAD + 1], *present = sp_arena_take(climb->arena, SP_SPREAD + 1, sizeof(double));
    int uneven = elements->spread != NULL, least = first->line.kind->components ? SPREAD_NODES_METRIC : SPREAD_NODES;
    if (uneven) memcpy(spread, elements->spread, sizeof spread);
    /* A metric that changes much is what so many chords were for, or a path that turns much. */
    if (climb->chords && (climb->is_fine || first->line.kind->components) && first->line.fold.inner >= SPREAD_NODES_METRIC)
        uneven = sp_spread_elements(first, newton->step, spread);
    climb->before = *first;
    now->length = climb->last = climb->change = climb->first_length;
    if (!present || !sp_refine_take(&storage, newton, climb->arena)) return out_of_memory(climb);
    climb->floor = climb->bottom = climb->arena->used;
    for (int r = 0; r < rungs; r++) {
        struct sp_rung rung = {ladder[r][0], ladder[r][1], NULL};
        int nodes = rung.degree * rung.count, has_chords = climb->before.elements.reference.degree == 1;
        climb->origin = has_chords && climb->options->tolerance > LOOSEST ? ORIGIN_CHORDS
                        : has_chords || r == 0                            ? ORIGIN_OTHER
                                                                          : ORIGIN_RUNG;
        if (!take_reference(climb, rung.degree)) return out_of_memory(climb);
        aim(newton, climb->options, r < rungs - (climb->follows ? LAST_RUNGS : 1));
        if (uneven) rung.spread = memcpy(present, spread, sizeof spread);
        int agrees = climb_rung(climb, &rung), status = now->outcome.status;
        if (status == SP_ITERATION_LIMIT) return give_up(climb);
        /* Spread as chords say, rungs of a fine start may wander, and each that changes much tells the next better. */
        double change = absolute(now->length - climb->last);
        int wanders = status == SP_TOLERANCE_NOT_MET && !climb->astray && !(climb->is_fine && change > LOOSEST * now->length);
        if (wanders || status == SP_OUT_OF_MEMORY) return finish(climb, change);
        if (wants_chords(climb, &rung)) {
            if (!begin_again(climb)) return finish(climb, absolute(now->length - climb->last));
            r--;
            continue;
        }
        if (measure(climb) && agrees) return finish(climb, climb->error);
        if (now->outcome.active && !climb->astray && nodes >= TOUCHING_NODES) break;
        /* Elements that close in on an end beside which sheets meet see another sheet, however many they are. */
        if (climb->astray && elements->fixed && r > 0) break;
        climb->moved = climb->follows && first->elements.reference.degree == 1 ? now->moved : 0;
        climb->before = climb->astray ? *first : sp_storage_keep(&storage, &newton->system);
        if (!climb->astray && !elements->fixed && nodes >= least) uneven = sp_spread_elements(&newton->system, newton->step, spread);
    }
    /* At the top only positions may be left to settle: beside a singular curve they do so like square roots, the length does not. */
    int settled = climb->follows && climb->error <= climb->allowed;
    if (now->outcome.status == SP_CONVERGED && !settled) now->outcome.status = SP_TOLERANCE_NOT_MET;
    return finish(climb, climb->error);
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

struct sp_refined sp_refine_same(struct sp_newton *newton, const struct sp_options *options, const struct sp_system *from,
                                 struct sp_arena *arena) {
    struct sp_rung rung = {from->elements.reference.degree, from->elements.count, from->elements.spread};
    struct sp_climbed climbed = {.outcome = {.status = SP_OUT_OF_MEMORY}};
    aim(newton, options, 0);
    newton->decrement = larger(newton->decrement, 10 * options->tolerance);
    if (sp_reference_make(&newton->system.elements.reference, rung.degree, arena))
        sp_rung_climb(newton, options, from, &rung, arena, &climbed);
    return sp_rung_finish(newton, &climbed, 0);
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
    sp_spread_close(tolerance, spread);
    newton->system.elements.spread = spread, newton->system.elements.fixed = 1;
    struct climb climb = {.newton = newton, .options = options, .arena = arena, .first = from, .first_length = length};
    return climb_all(&climb, LADDER + FINE, RUNGS - FINE);
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

struct sp_refined sp_refine_run(struct sp_newton *newton, const struct sp_options *options, int32_t is_fine, struct sp_arena *arena) {
    struct sp_storage storage;
    struct sp_climbed first = {.outcome = {.status = SP_OUT_OF_MEMORY}};
    double error = 0;
    if (sp_refine_take(&storage, newton, arena))
        first = is_fine ? sp_chords_given(newton) : sp_chords_first(newton, options, &storage, &error);
    int at_rest = first.outcome.status == SP_CONVERGED || first.outcome.status == SP_ILL_CONDITIONED;
    if (!at_rest || first.outcome.energy == 0 || first.outcome.active)
        return sp_rung_finish(newton, &first, larger(sp_check_unevenness(first.outcome.energy, first.length), error));
    int rungs = is_fine ? FINE_RUNGS : RUNGS, lowest = lowest_rung(LADDER, RUNGS - (is_fine ? 1 : AGAIN), newton->system.line.fold.inner);
    struct sp_system kept = sp_storage_keep(&storage, &newton->system);
    size_t used = arena->used;
    if (ends_in_branch(&newton->system.line)) {
        struct sp_refined closer = climb_closer(newton, options, &kept, tolerance_of(newton, options, first.length), first.length, arena);
        if (closer.outcome.status == SP_CONVERGED) return closer;
        newton->system.elements.spread = NULL, newton->system.elements.fixed = 0, arena->used = used;
    }
    struct climb climb = {.newton = newton,
                          .options = options,
                          .arena = arena,
                          .first = &kept,
                          .chords = &storage,
                          .is_fine = is_fine,
                          .first_length = is_fine ? 0 : first.length};
    struct sp_refined refined = climb_all(&climb, LADDER + lowest, rungs - lowest);
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
    int graded = sp_elements_graded(&newton->system.elements), rungs = graded ? GRADED_RUNGS : RUNGS;
    const uint8_t(*ladder)[2] = graded ? GRADED : LADDER;
    int lowest = lowest_rung(ladder, graded ? rungs : rungs - AGAIN, from->elements.reference.degree * from->elements.count);
    struct sp_system first = *from;
    newton->system.elements.spread = from->elements.spread;
    struct climb climb = {.newton = newton, .options = options, .arena = arena, .first = &first, .first_length = length};
    return climb_all(&climb, ladder + lowest, rungs - lowest);
}
