/* Newton: when it ends, and what the end is worth. MATH.md, "Newton". */
#include "metric_check.h"
#include "newton_step.h"
#include "sample.h"
#include "scalar.h"

/* Why these: MATH.md, "Constants". */
static const double DECREMENT = 1e-7, CONDITIONING = 1e-3, CERTAIN = 1e-3, SHORT = 1e-4, SOFT = 1e-2, LEAST_SOFT = 1e-15,
                    PAPER_TOLERANCE = 1e-6;
enum { IDLE_LIMIT = 3, PATIENCE = 16, SOFTEST = 22 };

int sp_newton_take(struct sp_newton *newton, const struct sp_surface *surface, const struct sp_options *options, int32_t inner,
                   struct sp_arena *arena) {
    struct sp_system *system = &newton->system;
    struct sp_polyline *line = &system->line;
    line->surface = surface, line->kind = sp_kind_of(surface), line->fold = (struct sp_fold){inner},
    line->touches = surface->kind == SP_PARAMETRIC;
    size_t pairs = (size_t)sp_fold_pairs(line->fold), dimension = (size_t)line->kind->dimension;
    size_t metric = SP_METRIC_PARTS * (size_t)line->kind->components;
    struct sp_nodes *both[2] = {&line->nodes, &newton->trial};
    for (int i = 0; i < 2; i++) {
        both[i]->places = sp_arena_take(arena, pairs * dimension, sizeof(sp_pair));
        both[i]->charts = sp_arena_take(arena, pairs * SP_CHART, sizeof(sp_pair));
        both[i]->metrics = metric ? sp_arena_take(arena, pairs * metric, sizeof(sp_pair)) : NULL;
        if (!both[i]->places || !both[i]->charts || (metric && !both[i]->metrics)) return 0;
    }
    system->elements.reference.degree = 1;
    if (metric && !sp_reference_make(&system->elements.reference, 1, arena)) return 0;
    system->rows = sp_arena_take(arena, pairs, sizeof(struct sp_row));
    system->straight = sp_arena_take(arena, pairs, sizeof(sp_mask));
    system->held = sp_arena_take(arena, 2 * pairs, sizeof(sp_mask));
    newton->step = sp_arena_take(arena, pairs * 2, sizeof(sp_pair));
    newton->decrement = DECREMENT, newton->enough = newton->least_gain = 0, newton->draft = newton->certain = 0;
    newton->steps_left = options->max_iterations, newton->record_points = options->point_count;
    newton->history_count = 0;
    newton->history = sp_arena_take(arena, (size_t)options->max_iterations + 1, sizeof(struct sp_iterate));
    size_t record = ((size_t)options->max_iterations + 1) * 3 * ((size_t)options->point_count + 2);
    int keeps = options->record && surface->value;
    newton->record = keeps ? sp_arena_take(arena, record, sizeof(double)) : NULL;
    return system->rows && system->straight && system->held && newton->step && newton->history && (newton->record || !keeps);
}

double sp_newton_bytes(const struct sp_surface *surface, const struct sp_options *options, int32_t inner) {
    const struct sp_kind *kind = sp_kind_of(surface);
    double pairs = sp_fold_pairs((struct sp_fold){inner}), entries = options->max_iterations + 1.0;
    double node = kind->dimension + SP_CHART + SP_METRIC_PARTS * (double)kind->components;
    double rows = pairs * (sizeof(struct sp_row) + sizeof(sp_pair) * (2 * node + 2) + 3 * sizeof(sp_mask));
    double record = options->record && surface->value ? entries * 3 * (options->point_count + 2.0) * sizeof(double) : 0;
    return rows + entries * sizeof(struct sp_iterate) + record + sp_reference_bytes(1) + 18 * 16;
}

/* Whether the path resists every bend: 1/softness is above `bound`, and so are all eigenvalues of its Hessian's pivots relative to M. */
static int is_stiff(const struct sp_round *round, double bound) { return round->inertia.softness * bound < 1; }

static double norm_of(const struct sp_newton *newton, double gradient_squared) {
    return 2.0 * sp_system_segments(&newton->system) * root(gradient_squared);
}

static void assemble(struct sp_newton *newton, const struct sp_options *options, struct sp_round *round) {
    enum sp_hessian hessian = options->algorithm == SP_PAPER ? SP_COORDINATE : SP_COVARIANT;
    round->energy = sp_system_assemble(&newton->system, hessian);
    round->inertia = round->energy.inertia;
    round->gradient_norm = norm_of(newton, round->energy.gradient_squared);
    round->decrement = not_a_number();
    if (sp_round_is_definite(round)) round->decrement = root(2 * round->inertia.descent / round->energy.squares);
    newton->short_step = sp_system_is_plain(&newton->system) && round->decrement <= SHORT;
}

void sp_newton_tell_end(struct sp_newton *newton, const struct sp_iterate *end) {
    int32_t last = newton->history_count - 1, continues = last >= 0 && newton->history[last].step == 0;
    double ratio = continues && newton->history[last].energy > 0 ? end->energy / newton->history[last].energy : 1;
    for (int32_t i = 0; i < last; i++)
        newton->history[i].energy *= ratio;
    if (!continues) newton->history_count++;
    newton->history[newton->history_count - 1] = *end;
}

/* Adds the present path to the history, and its points to the record: as its end until a step is taken from it. */
static void note(struct sp_newton *newton, const struct sp_round *round) {
    if (!newton->history) return;
    sp_newton_tell_end(newton, &(struct sp_iterate){sp_system_segments(&newton->system) * round->energy.squares, round->gradient_norm,
                                                    round->decrement, 0});
    if (newton->record)
        sp_sample_points(&newton->system, newton->scale, newton->record_points, newton->reversed,
                         newton->record + (size_t)(newton->history_count - 1) * 3 * ((size_t)newton->record_points + 2), NULL);
}

/* Whether a step so small beside the conditioning cannot have changed the certificate, so that the end needs no matrix of its own. */
static int is_certain(const struct sp_newton *newton, struct sp_round *round) {
    const struct sp_system *system = &newton->system;
    int keeps = sp_system_is_plain(system) || system->elements.reference.degree > 1; /* rows of the others hold the factorisation, too */
    if (!keeps || !sp_round_is_definite(round) || round->energy.active || !(round->decrement <= CERTAIN)) return 0;
    double least = round->decrement / CERTAIN;
    return is_stiff(round, least > CONDITIONING ? least : CONDITIONING);
}

/* Energy and gradient where the step in `trial` led, without a matrix. Returns 0 where that needs one: some coordinate is held. */
static int look(struct sp_newton *newton, struct sp_round *round) {
    struct sp_energy energy = {.squares = newton->trial_squares, .gradient_squared = newton->trial_gradient};
    if (!newton->certain || newton->system.line.touches) return 0;
    if (!sp_system_is_plain(&newton->system)) energy = sp_system_rows(&newton->system, SP_COVARIANT);
    round->energy.squares = energy.squares, round->gradient_norm = norm_of(newton, energy.gradient_squared);
    round->decrement = not_a_number();
    return is_finite(round->gradient_norm);
}

/* Takes the step in `trial`, which was `scale` of a full one. It is the last one where that makes |grad E| <= tolerance. */
static void take_step(struct sp_newton *newton, const struct sp_options *options, double scale, double tolerance, struct sp_round *round) {
    if (newton->history) newton->history[newton->history_count - 1].step = scale;
    sp_newton_accept(newton);
    newton->steps_left--;
    newton->looked = look(newton, round) && round->gradient_norm <= tolerance;
    if (!newton->looked) assemble(newton, options, round);
    newton->certain = 0;
    note(newton, round);
}

/* Takes the full step in `trial`, of energy `squares`, without a look at where it leads. */
static void leave(struct sp_newton *newton, double squares, struct sp_round *round) {
    if (newton->history) newton->history[newton->history_count - 1].step = 1;
    sp_newton_accept(newton);
    newton->steps_left--;
    round->energy.squares = squares, round->gradient_norm = round->decrement = not_a_number();
    note(newton, round);
}

/* Below this the decrement is rounding: measured noise is 0.6 … 1 times 1e-16 N (1 + size/length). */
static double decrement_floor(const struct sp_newton *newton, double squares) {
    double nodes = newton->system.line.fold.inner + 1, length = root(squares * sp_system_segments(&newton->system));
    double floor = 1e-15 * nodes * (1 + newton->size / length);
    return floor > newton->decrement ? floor : newton->decrement;
}

/* Whether the stopping rule holds, whatever the index. */
static int at_rest(const struct sp_newton *newton, const struct sp_options *options, const struct sp_round *round) {
    if (round->energy.squares == 0) return 1;
    double tolerance = newton->draft ? 0 : options->gradient_tolerance;
    if (options->algorithm == SP_PAPER && !(tolerance > 0)) tolerance = PAPER_TOLERANCE;
    if (tolerance > 0) return round->gradient_norm <= tolerance;
    return round->decrement <= decrement_floor(newton, round->energy.squares);
}

/* What the end is worth: the certificate is the inertia of the Hessian there. */
static int32_t certify(const struct sp_newton *newton, const struct sp_round *round) {
    if (round->energy.squares == 0) return SP_CONVERGED;
    if (!round->inertia.usable) return SP_ILL_CONDITIONED;
    if (round->inertia.negative > 0) return SP_SADDLE;
    return newton->looked || is_stiff(round, CONDITIONING) ? SP_CONVERGED : SP_ILL_CONDITIONED;
}

/* Whether H + shift M is positive definite, and then what its solution promises. */
static int shifted_descent(struct sp_newton *newton, double shift, double *descent) {
    struct sp_inertia inertia = sp_system_factor(&newton->system, shift);
    *descent = inertia.descent;
    return inertia.usable && inertia.negative == 0;
}

/* By what curvature is negative, in steps: below SOFT there are SOFTEST. */
static double negative_part(int32_t step) { return LEAST_SOFT * (1 << step) * (1 << step); }

/* By what part of its length a path between nearly conjugate ends may be longer than the one to which it could turn, by as much as it is
 * long: the slope along its soft direction, without a word of the curvature, which is less than what is left to correct in all others; and
 * by what curvature is negative. MATH.md, "Newton". Above `most` nobody asks. Leaves a shifted factorisation. */
static double doubt_of(struct sp_newton *newton, const struct sp_round *round, double most) {
    struct sp_fold fold = newton->system.line.fold;
    double weights = 0, descent, unused;
    for (int32_t k = 1; k <= sp_fold_unknown(fold); k++)
        weights += sp_fold_sum(fold, k, newton->system.rows[k].weight);
    weights *= sp_system_segments(&newton->system);
    if (!shifted_descent(newton, SOFT / weights, &descent)) return 1;
    double doubt = root(2 * SOFT * descent / round->energy.squares);
    if (sp_round_is_definite(round)) return doubt;
    int32_t low = 0, high = SOFTEST;
    while (low < high) {
        int32_t middle = (low + high) / 2;
        if (doubt + negative_part(middle) > most || shifted_descent(newton, negative_part(middle) / weights, &unused))
            high = middle;
        else
            low = middle + 1;
    }
    return doubt + negative_part(low);
}

/* Whether the ends are so nearly conjugate that the path can hardly be moved on, and what is left to gain below `enough`. */
static int is_loose(struct sp_newton *newton, const struct sp_round *round, double enough) {
    if (is_stiff(round, CONDITIONING) || !(sp_system_steepness(&newton->system, round->energy.squares) <= SP_STATIONARY)) return 0;
    if (doubt_of(newton, round, enough) <= enough) return 1;
    sp_system_factor(&newton->system, 0);
    return 0;
}

/* Steps without progress in a row: neither the energy nor the gradient falls. */
static int32_t idle_count(int32_t idle, const struct sp_round *before, const struct sp_round *after) {
    int falls = after->energy.squares < before->energy.squares * (1 - SP_SLACK) || after->gradient_norm < 0.5 * before->gradient_norm;
    return falls ? 0 : idle + 1;
}

/* Takes steps until the stopping rule holds; fills outcome->status. */
static void iterate(struct sp_newton *newton, const struct sp_options *options, struct sp_round *round, struct sp_outcome *outcome) {
    double mark = round->energy.squares;
    for (int32_t idle = 0, steps = 0;;) {
        int rest = at_rest(newton, options, round), certified = options->algorithm != SP_PAPER;
        if (rest && (sp_round_is_definite(round) || !certified || round->energy.squares == 0)) {
            outcome->status = certify(newton, round);
            return;
        }
        outcome->status = newton->steps_left <= 0 ? SP_ITERATION_LIMIT : idle >= IDLE_LIMIT ? SP_STALLED : SP_CONVERGED;
        if (newton->least_gain > 0 && !outcome->status && ++steps % PATIENCE == 0) {
            if (mark - round->energy.squares <= newton->least_gain * mark) outcome->status = SP_TOLERANCE_NOT_MET;
            mark = round->energy.squares;
        }
        double enough = outcome->status ? SP_STATIONARY : options->gradient_tolerance > 0 ? 0 : options->tolerance;
        if (certified && is_loose(newton, round, enough)) outcome->status = SP_ILL_CONDITIONED;
        if (outcome->status) return;
        newton->certain = certified && !newton->draft && options->gradient_tolerance > 0 && is_certain(newton, round);
        double scale = certified ? sp_newton_step(newton, round) : sp_newton_step_paper(newton, round);
        if (scale == 0) {
            sp_system_factor(&newton->system, 0);
            outcome->status = rest ? SP_SADDLE : is_loose(newton, round, SP_STATIONARY) ? SP_ILL_CONDITIONED : SP_STALLED;
            return;
        }
        struct sp_round before = *round;
        take_step(newton, options, scale, options->gradient_tolerance, round);
        idle = idle_count(idle, &before, round);
    }
}

/* One full step more: at the stopping decrement the error left is of its square. Returns 0, taking none, where the energy rises. */
static int polish(struct sp_newton *newton, const struct sp_options *options, struct sp_round *round, struct sp_outcome *outcome) {
    newton->certain = (!newton->draft || newton->system.elements.reference.degree > 1) && is_certain(newton, round);
    newton->last_decrement = round->decrement;
    sp_system_solve(&newton->system, newton->step);
    int positions = !newton->draft || newton->record || !sp_system_is_plain(&newton->system);
    int blind = !positions && newton->system.line.surface->kind == SP_PARAMETRIC;
    double now = blind ? sp_newton_try_blindly(newton, round) : sp_newton_try(newton, 1);
    if (!(now <= round->energy.squares * (1 + SP_SLACK))) return newton->certain = 0;
    if (newton->draft) {
        leave(newton, now, round);
        return 1;
    }
    take_step(newton, options, 1, __builtin_inf(), round);
    outcome->status = certify(newton, round);
    return 1;
}

/* Steps, and the one more. A draft that may not take it goes on with shorter ones. */
static void converge(struct sp_newton *newton, const struct sp_options *options, struct sp_round *round, struct sp_outcome *outcome) {
    int by_decrement = options->algorithm != SP_PAPER && (newton->draft || !(options->gradient_tolerance > 0));
    iterate(newton, options, round, outcome);
    if (!by_decrement || outcome->status != SP_CONVERGED || round->energy.squares == 0 || round->decrement <= newton->enough) return;
    if (newton->steps_left <= 0) {
        if (newton->draft) outcome->status = SP_ITERATION_LIMIT;
        return;
    }
    if (polish(newton, options, round, outcome) || !newton->draft) return;
    double wanted = newton->decrement;
    newton->decrement = DECREMENT;
    iterate(newton, options, round, outcome);
    newton->decrement = wanted;
}

struct sp_outcome sp_newton_run(struct sp_newton *newton, const struct sp_options *options) {
    struct sp_outcome outcome = {SP_NOT_FINITE, -1, 0, not_a_number(), not_a_number(), 0};
    struct sp_round round = {0};
    newton->certain = newton->looked = 0;
    assemble(newton, options, &round);
    if (!is_finite(round.energy.squares)) {
        enum sp_status metric = sp_metric_check(&newton->system.line, newton->scale);
        if (metric < 0) outcome.status = metric;
        return outcome;
    }
    note(newton, &round);
    converge(newton, options, &round, &outcome);
    outcome.index = round.inertia.usable ? round.inertia.negative : -1;
    outcome.energy = sp_system_segments(&newton->system) * round.energy.squares, outcome.gradient_norm = round.gradient_norm;
    outcome.active = newton->system.line.touches;
    if (outcome.status == SP_ILL_CONDITIONED) outcome.doubt = doubt_of(newton, &round, __builtin_inf());
    return outcome;
}

int sp_newton_confirm(struct sp_newton *newton, struct sp_outcome *outcome) {
    struct sp_round round = {0};
    if (!(newton->last_decrement * newton->last_decrement <= newton->enough) || !look(newton, &round)) return 0;
    *outcome = (struct sp_outcome){SP_CONVERGED, 0, 0, sp_system_segments(&newton->system) * round.energy.squares, round.gradient_norm, 0};
    note(newton, &round);
    return 1;
}
