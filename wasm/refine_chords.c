/* Paths of chords: the ladder's first one, and polylines. MATH.md, "The ladder". */
#include "refine_chords.h"
#include "check.h"
#include "ends.h"
#include "metric_check.h"
#include "metric_elements.h"
#include "scalar.h"

/* Why these: MATH.md, "The ladder". */
static const double FIRST_DECREMENT = 1e-4, CHORD_ERROR = 0.005;
/* Of more chords projected Newton frees about one a step from a wall. */
enum { WALLED_CHORDS = 256 };
/* A start whose length in a metric is wrong by more than this part of it has more chords, up to so many. */
static const double UNSEEN = 0.05;
enum { SEEING_CHORDS = 512 };
/* From how many chords on a coarser polyline helps, how few it may have, and by what it is coarser. */
enum { LEAST_CHORDS = 128, COARSE_CHORDS = 16, COARSEN = 4 };

void sp_chords_climb(struct sp_newton *newton, const struct sp_options *options, int32_t count, const struct sp_system *from,
                     struct sp_arena *arena, struct sp_climbed *chords) {
    *chords = (struct sp_climbed){.outcome = {.status = SP_OUT_OF_MEMORY}};
    newton->decrement = FIRST_DECREMENT, newton->enough = 0, newton->draft = 0;
    if (sp_reference_make(&newton->system.elements.reference, 1, arena))
        sp_rung_climb(newton, options, from, &(struct sp_rung){1, count, NULL}, arena, chords);
}

/* What chords are wrong by in length, and whether they may be trusted. */
static double check_chords(const struct sp_newton *newton, const struct sp_climbed *chords, enum sp_status *status) {
    struct sp_chord_sums sums = {0, 0};
    *status = sp_check_chords(&newton->system, newton->scale, &sums);
    return sp_check_length_error(newton, &chords->outcome, &sums);
}

/* The path on twice as many chords. */
static enum sp_status double_chords(struct sp_newton *newton, const struct sp_storage *storage) {
    struct sp_system before = sp_storage_keep(storage, &newton->system);
    return sp_rung_carry(newton, &before, 2 * (newton->system.line.fold.inner + 1));
}

/* A start whose nodes do not see the metric along it, on more chords: Newton would hide nodes on both sides of what they do not see. */
static enum sp_status see_metric(struct sp_newton *newton, const struct sp_storage *storage) {
    struct sp_polyline *line = &newton->system.line;
    enum sp_status status = SP_CONVERGED;
    while (status == SP_CONVERGED && line->kind->components && line->fold.inner < SEEING_CHORDS &&
           sp_metric_length_error(line, newton->size, 0) > UNSEEN * sp_system_length(&newton->system, &line->nodes))
        status = double_chords(newton, storage);
    return status;
}

struct sp_climbed sp_chords_first(struct sp_newton *newton, const struct sp_options *options, const struct sp_storage *storage,
                                  double *error) {
    struct sp_polyline *line = &newton->system.line;
    newton->decrement = newton->enough = FIRST_DECREMENT, newton->draft = 0;
    newton->system.elements.count = line->fold.inner + 1, newton->system.elements.spread = NULL;
    struct sp_climbed now = {.outcome = {.status = see_metric(newton, storage)}};
    double before = 0;
    while (now.outcome.status == SP_CONVERGED) {
        int32_t count = 2 * (line->fold.inner + 1);
        now.outcome = sp_newton_run(newton, options);
        if (now.outcome.status < 0) break;
        sp_ends_turn(&newton->system);
        now.length = sp_system_length(&newton->system, &line->nodes);
        enum sp_status checked;
        double seen = check_chords(newton, &now, &checked);
        if (checked < 0) now.outcome.status = checked;
        /* Nodes that hide from a metric do so the better the more they are. */
        int hides = line->kind->components && before > 0 && seen > before;
        before = seen;
        *error = checked > 0 ? now.length : seen;
        int enough = count > (now.outcome.active ? WALLED_CHORDS : SP_REFINE_CHORDS) || *error <= CHORD_ERROR * now.length;
        if (now.outcome.status != SP_CONVERGED || enough || hides) break;
        now.outcome.status = double_chords(newton, storage);
    }
    return now;
}

struct sp_climbed sp_chords_given(struct sp_newton *newton) {
    const struct sp_polyline *line = &newton->system.line;
    newton->system.elements.count = line->fold.inner + 1, newton->system.elements.spread = NULL;
    double length = sp_system_length(&newton->system, &line->nodes);
    return (struct sp_climbed){.outcome = {.status = SP_CONVERGED, .energy = length * length}, .length = length};
}

struct sp_refined sp_refine_chords(struct sp_newton *newton, const struct sp_options *options, int32_t count, const struct sp_system *from,
                                   struct sp_arena *arena) {
    struct sp_climbed chords;
    enum sp_status ignored;
    sp_chords_climb(newton, options, count, from, arena, &chords);
    return sp_rung_finish(newton, &chords, chords.outcome.status < 0 ? 0 : check_chords(newton, &chords, &ignored));
}

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
    return (count / (2.0 * COARSEN) + 4) * dimension * sizeof(sp_pair) + (2 * (SP_MAX_DEGREE + 1) + SP_SPREAD + 1) * sizeof(double) +
           4 * 16;
}

int sp_refine_polyline(struct sp_newton *newton, const struct sp_options *options, int32_t count, struct sp_arena *arena) {
    struct sp_polyline *line = &newton->system.line;
    struct sp_storage storage;
    int32_t largest = (count + COARSEN - 1) / COARSEN;
    if (!sp_storage_take(&storage, line->kind->dimension, largest - 1, arena)) return 0;
    double wanted = newton->decrement;
    newton->draft = 1, newton->decrement = SP_DRAFT_DECREMENT;
    enum sp_status status = SP_CONVERGED;
    for (int32_t chords = line->fold.inner + 1; status == SP_CONVERGED && chords < count; chords = line->fold.inner + 1) {
        struct sp_outcome outcome = sp_newton_run(newton, options);
        if (outcome.status != SP_CONVERGED) break;
        struct sp_system before = sp_storage_keep(&storage, &newton->system);
        status = sp_rung_carry(newton, &before, finer(chords, count));
    }
    newton->draft = 0, newton->decrement = wanted;
    return status == SP_CONVERGED && line->fold.inner + 1 == count;
}
