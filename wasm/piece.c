/* Solves one free arc between given ends with the ladder of elements. MATH.md, "Arcs". */
#include "piece.h"

enum { START_DEGREE = 8, START_COUNT = 2 };

static double root(double x) { return sp_square_root(sp_splat(x > 0 ? x : 0))[0]; }

/* How far along its last path the piece is at t: towards a singular end the distance to it falls like the square root of what is left, as
 * that of a geodesic does. */
static double run_through(const struct sp_piece *piece, double t) {
    int32_t first = piece->joint[0].singular, last = piece->joint[1].singular;
    if (first && last) return t < 0.5 ? 0.5 * root(2 * t) : 1 - 0.5 * root(2 - 2 * t);
    return first ? root(t) : last ? 1 - root(1 - t) : t;
}

/* Fills the nodes of `start` with the piece's last path, its ends moved to the joints. */
static void fill(const struct sp_piece *piece, int has_elements, struct sp_system *start) {
    struct sp_polyline *line = &start->line;
    int32_t last = line->fold.inner + 1;
    double ends[2][3], place[3];
    sp_sample_place(&piece->system, piece->first, ends[0]), sp_sample_place(&piece->system, piece->last, ends[1]);
    for (int32_t i = 0; i <= last; i++) {
        double t = has_elements ? sp_sample_parameter(&start->elements, i) : (double)i / last, run = run_through(piece, t);
        sp_sample_place(&piece->system, piece->first + run * (piece->last - piece->first), place);
        for (int32_t j = 0; j < 2; j++) {
            double moved = place[j] + (1 - run) * (piece->joint[0].place[j] - ends[0][j]) + run * (piece->joint[1].place[j] - ends[1][j]);
            if (i == 0 || i == last) moved = piece->joint[i > 0].place[j];
            line->nodes.places[2 * sp_fold_pair(line->fold, i) + j][sp_fold_lane(line->fold, i)] = moved;
        }
    }
    sp_pair *middle = line->nodes.places + 2 * (line->fold.both + 1);
    middle[0] = sp_splat(middle[0][0]), middle[1] = sp_splat(middle[1][0]);
}

/* A first path of elements to a singular end. Returns 0 if the arena is full. */
static int start_graded(const struct sp_newton *newton, const struct sp_piece *piece, struct sp_system *start, struct sp_arena *arena) {
    *start = newton->system;
    start->elements.count = START_COUNT;
    start->line.fold = sp_fold_of(START_DEGREE * START_COUNT - 1);
    start->line.nodes.places = sp_arena_take(arena, 2 * (size_t)sp_fold_pairs(start->line.fold), sizeof(sp_pair));
    if (!start->line.nodes.places || !sp_reference_make(&start->elements.reference, START_DEGREE, arena)) return 0;
    fill(piece, 1, start);
    return 1;
}

/* The piece's own elements with their ends moved to the joints. */
static struct sp_system follow(const struct sp_piece *piece) {
    struct sp_system start = piece->system;
    struct sp_polyline *line = &start.line;
    int32_t last = line->fold.inner + 1;
    double by[2][2];
    for (int e = 0; e < 2; e++)
        for (int32_t j = 0; j < 2; j++)
            by[e][j] = piece->joint[e].place[j] - sp_fold_get(line->fold, line->nodes.places, 2, e ? last : 0, j);
    for (int32_t i = 0; i <= last; i++) {
        double t = sp_sample_parameter(&start.elements, i);
        for (int32_t j = 0; j < 2; j++)
            line->nodes.places[2 * sp_fold_pair(line->fold, i) + j][sp_fold_lane(line->fold, i)] += (1 - t) * by[0][j] + t * by[1][j];
    }
    sp_pair *middle = line->nodes.places + 2 * (line->fold.both + 1);
    middle[0] = sp_splat(middle[0][0]), middle[1] = sp_splat(middle[1][0]);
    return start;
}

/* Chords first: the ladder from its foot. */
static struct sp_refined solve_new(struct sp_newton *newton, const struct sp_options *options, const struct sp_piece *piece,
                                   struct sp_arena *arena) {
    struct sp_refined none = {.outcome = {.status = SP_OUT_OF_MEMORY}};
    if (!sp_reference_make(&newton->system.elements.reference, 1, arena)) return none;
    newton->system.line.fold = sp_fold_of(SP_REFINE_FIRST);
    fill(piece, 0, &newton->system);
    return sp_refine_run(newton, options, arena);
}

int sp_piece_solve(struct sp_newton *newton, const struct sp_options *options, int checked, struct sp_piece *piece,
                   struct sp_arena *arena) {
    size_t bottom = arena->used;
    struct sp_system start;
    struct sp_iterate *history = newton->history;
    int32_t *singular = newton->system.elements.singular;
    singular[0] = piece->joint[0].singular, singular[1] = piece->joint[1].singular;
    int has_elements = piece->system.elements.reference.degree > 1, is_graded = singular[0] || singular[1];
    if (has_elements)
        start = follow(piece);
    else if (is_graded && !start_graded(newton, piece, &start, arena))
        return 0;
    newton->history = NULL; /* a piece is not the path */
    piece->solved = !has_elements && !is_graded ? solve_new(newton, options, piece, arena)
                    : checked                   ? sp_refine_again(newton, options, &start, piece->solved.length, arena)
                                                : sp_refine_same(newton, options, &start, arena);
    newton->history = history;
    arena->used = bottom; /* what it used is read before anything else is taken */
    return piece->solved.outcome.status == SP_CONVERGED && newton->system.elements.reference.degree > 1;
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
