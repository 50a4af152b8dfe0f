/* One rung of the ladder: laid out, started from another path, solved. MATH.md, "The ladder". */
#include "refine_rung.h"
#include "check.h"
#include "ends.h"
#include "scalar.h"

/* On so many inner nodes a step is dear, and a rung that gains less wanders, as finer ones will: there the ladder ends. */
static const double LEAST_GAIN = 1e-5;
enum { LARGE_NODES = 700 };

/* The positions of the nodes, 3 numbers a pair; NULL if the arena is full. */
static sp_pair *note_start(const struct sp_system *system, struct sp_arena *arena) {
    int32_t pairs = sp_fold_pairs(system->line.fold);
    sp_pair *positions = sp_arena_take(arena, 3 * (size_t)pairs, sizeof(sp_pair));
    for (int32_t k = 0; positions && k < pairs; k++)
        sp_store(sp_load(system->line.nodes.charts + SP_CHART * k), positions + 3 * k);
    return positions;
}

/* Largest distance that a node has moved. */
static double displacement(const struct sp_system *system, const sp_pair *start) {
    double largest = 0;
    int32_t components = system->line.kind->components;
    const sp_pair *metrics = system->line.nodes.metrics;
    for (int32_t k = 1; k <= sp_fold_unknown(system->line.fold); k++) {
        struct sp_vector moved = sp_subtract(sp_load(system->line.nodes.charts + SP_CHART * k), sp_load(start + 3 * k));
        sp_pair squared = sp_dot(moved, moved), displaced[3];
        sp_store(moved, displaced);
        if (components) squared = sp_metric_product(components, metrics + SP_METRIC_PARTS * components * k, displaced, displaced);
        for (int lane = 0; lane < 2; lane++)
            largest = larger(largest, squared[lane]);
    }
    return root(largest);
}

enum sp_status sp_rung_carry(struct sp_newton *newton, const struct sp_system *from, int32_t count) {
    struct sp_polyline *line = &newton->system.line;
    line->fold = (struct sp_fold){newton->system.elements.reference.degree * count - 1};
    newton->system.elements.count = count;
    sp_sample_places(from, &newton->system.elements, line->nodes.places);
    if (!sp_polyline_settle(line, newton->scale)) return SP_SHEET_JUMP;
    sp_polyline_charts(line, &line->nodes);
    return SP_CONVERGED;
}

/* Sets the system up as `rung`, whose reference element is made, started from the path of `from`. */
static enum sp_status start_rung(struct sp_newton *newton, const struct sp_system *from, const struct sp_rung *rung, const sp_pair **start,
                                 struct sp_arena *arena) {
    struct sp_system *system = &newton->system;
    struct sp_elements *elements = &system->elements;
    size_t order = (size_t)sp_elements_order(rung->degree);
    elements->count = rung->count, elements->spread = rung->spread;
    elements->matrices = sp_arena_take(arena, order * order * (size_t)rung->count / 2, sizeof(sp_pair));
    elements->velocity = sp_arena_take(arena, 3 * ((size_t)rung->degree + 2), sizeof(sp_pair));
    elements->skeleton = sp_arena_take(arena, (size_t)rung->count / 2 + 1, sizeof(struct sp_row));
    if (!elements->matrices || !elements->velocity || !elements->skeleton) return SP_OUT_OF_MEMORY;
    if (sp_elements_graded(elements) && !sp_graded_make(&elements->graded, &elements->reference, elements->singular, arena))
        return SP_OUT_OF_MEMORY;
    enum sp_status status = sp_rung_carry(newton, from, rung->count);
    if (status != SP_CONVERGED) return status;
    *start = note_start(system, arena);
    return *start ? SP_CONVERGED : SP_OUT_OF_MEMORY;
}

void sp_rung_run(struct sp_newton *newton, const struct sp_options *options, struct sp_climbed *climbed) {
    const struct sp_elements *elements = &newton->system.elements;
    int may_wander = elements->reference.degree > 1 && !sp_elements_graded(elements) && newton->system.line.fold.inner >= LARGE_NODES;
    newton->least_gain = may_wander ? LEAST_GAIN : 0;
    climbed->outcome = sp_newton_run(newton, options);
    newton->least_gain = 0;
    if (climbed->outcome.status < 0) return;
    sp_ends_turn(&newton->system);
    climbed->length = sp_system_length(&newton->system, &newton->system.line.nodes);
    climbed->moved = displacement(&newton->system, climbed->start);
}

void sp_rung_climb(struct sp_newton *newton, const struct sp_options *options, const struct sp_system *from, const struct sp_rung *rung,
                   struct sp_arena *arena, struct sp_climbed *climbed) {
    *climbed = (struct sp_climbed){0};
    climbed->outcome.status = start_rung(newton, from, rung, &climbed->start, arena);
    if (climbed->outcome.status == SP_CONVERGED) sp_rung_run(newton, options, climbed);
}

struct sp_refined sp_rung_finish(const struct sp_newton *newton, const struct sp_climbed *climbed, double length_error) {
    double error = larger(length_error, sp_check_rounding(climbed->length, newton->size));
    return (struct sp_refined){climbed->outcome, climbed->length, error + climbed->outcome.doubt * climbed->length};
}
