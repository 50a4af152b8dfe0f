/* Solves one free arc between given ends with the ladder of elements. MATH.md, "Arcs". */
#include "piece.h"
#include "normal.h"

enum { START_DEGREE = 16, START_COUNT = 2 };
static const double CHORD_DECREMENT = 1e-2;

/* Where a first path of chords ends. */
static const double *start_of(const struct sp_joint *joint) { return joint->singular ? joint->aside : joint->place; }

/* Fills the chords of `start` with the piece's last path, its ends moved to the joints. */
static void fill(const struct sp_piece *piece, struct sp_system *start) {
    struct sp_polyline *line = &start->line;
    int32_t last = line->fold.inner + 1;
    double ends[2][3], place[3];
    sp_sample_place(&piece->system, piece->first, ends[0]), sp_sample_place(&piece->system, piece->last, ends[1]);
    for (int32_t i = 0; i <= last; i++) {
        double run = (double)i / last;
        sp_sample_place(&piece->system, piece->first + run * (piece->last - piece->first), place);
        for (int32_t j = 0; j < 2; j++) {
            double moved =
                place[j] + (1 - run) * (start_of(piece->joint)[j] - ends[0][j]) + run * (start_of(piece->joint + 1)[j] - ends[1][j]);
            if (i == 0 || i == last) moved = start_of(piece->joint + (i > 0))[j];
            sp_polyline_put(line, i, j, moved);
        }
    }
}

/* Moves the ends of a path of elements to the joints, what is between them along. */
static void move_ends(const struct sp_piece *piece, struct sp_system *start) {
    struct sp_polyline *line = &start->line;
    int32_t last = line->fold.inner + 1;
    double by[2][2];
    for (int e = 0; e < 2; e++)
        for (int32_t j = 0; j < 2; j++)
            by[e][j] = piece->joint[e].place[j] - sp_polyline_end(line, e, j);
    for (int32_t i = 0; i <= last; i++) {
        double t = sp_sample_parameter(&start->elements, i);
        for (int32_t j = 0; j < 2; j++)
            sp_polyline_put(line, i, j, sp_polyline_coordinate(line, i, j) + ((1 - t) * by[0][j] + t * by[1][j]));
    }
}

/* Chords between the joints, to be solved, and their charts. Returns 0 if the arena is full. */
static int start_chords(struct sp_newton *newton, const struct sp_piece *piece, struct sp_arena *arena) {
    if (!sp_reference_make(&newton->system.elements.reference, 1, arena)) return 0;
    newton->system.line.fold = (struct sp_fold){SP_REFINE_FIRST}, newton->system.elements.spread = NULL;
    struct sp_polyline *line = &newton->system.line;
    fill(piece, &newton->system);
    sp_polyline_settle(line, newton->scale);
    sp_polyline_charts(line, &line->nodes);
    return 1;
}

/* A first path of elements to a singular end: chords are solved, roughly, and kept; elements lie on them. Returns 0 where that fails. */
static int start_graded(struct sp_newton *newton, const struct sp_options *options, struct sp_piece *piece, struct sp_system *start,
                        struct sp_arena *arena) {
    newton->decrement = CHORD_DECREMENT, newton->enough = 0, newton->draft = 0;
    if (!start_chords(newton, piece, arena)) return 0;
    if (sp_newton_run(newton, options).status < 0) return 0;
    sp_piece_keep(newton, piece);
    *start = newton->system;
    start->elements.count = START_COUNT;
    start->line.fold = (struct sp_fold){START_DEGREE * START_COUNT - 1};
    start->line.nodes.places = sp_arena_take(arena, 2 * (size_t)sp_fold_pairs(start->line.fold), sizeof(sp_pair));
    if (!start->line.nodes.places || !sp_reference_make(&start->elements.reference, START_DEGREE, arena)) return 0;
    sp_sample_places(&piece->system, &start->elements, start->line.nodes.places);
    move_ends(piece, start);
    return 1;
}

int sp_piece_solve(struct sp_newton *newton, const struct sp_options *options, int checked, struct sp_piece *piece,
                   struct sp_arena *arena) {
    size_t bottom = arena->used;
    struct sp_system start;
    struct sp_iterate *history = newton->history;
    int32_t *singular = newton->system.elements.singular;
    singular[0] = piece->joint[0].singular, singular[1] = piece->joint[1].singular;
    int has_elements = piece->system.elements.reference.degree > 1 && piece->first == 0 && piece->last == 1,
        is_graded = singular[0] || singular[1], ready = 1;
    newton->history = NULL; /* a piece is not the path */
    if (has_elements)
        start = piece->system, move_ends(piece, &start);
    else
        ready = is_graded ? start_graded(newton, options, piece, &start, arena) : start_chords(newton, piece, arena);
    if (ready)
        piece->solved = !has_elements && !is_graded ? sp_refine_run(newton, options, 0, arena)
                        : checked ? sp_refine_again(newton, options, &start, piece->checked ? piece->solved.length : 0, arena)
                                  : sp_refine_same(newton, options, &start, arena);
    piece->checked = checked;
    newton->history = history;
    arena->used = bottom; /* what it used is read before anything else is taken */
    int status = piece->solved.outcome.status, slides = piece->joint[0].slides || piece->joint[1].slides,
        solved = status == SP_CONVERGED || (status == SP_ILL_CONDITIONED && slides && !is_graded);
    if (!ready || !solved || newton->system.elements.reference.degree == 1) return 0;
    /* Beyond the curve on which it ends the same lengths are there for ways that are none. */
    return !is_graded || sp_normal_turns(&newton->system.line, 1) == 0;
}

void sp_piece_keep(const struct sp_newton *newton, struct sp_piece *piece) {
    piece->system = sp_storage_keep(&piece->storage, &newton->system);
    piece->first = 0, piece->last = 1;
}

void sp_piece_move(struct sp_piece *piece, const struct sp_storage *storage) {
    piece->storage = *storage;
    piece->system = sp_storage_keep(&piece->storage, &piece->system);
}

struct sp_arc sp_piece_arc(const struct sp_piece *piece, int32_t reversed) {
    const struct sp_refined *solved = &piece->solved;
    return (struct sp_arc){.length = solved->length,
                           .error = solved->length_error,
                           .energy = solved->outcome.energy,
                           .gradient_norm = solved->outcome.gradient_norm,
                           .system = piece->system,
                           .reversed = reversed};
}
