/* Solves one free arc between given ends with the ladder of elements. MATH.md, "Arcs". */
#include "piece.h"

enum { START_DEGREE = 8, START_COUNT = 2 };

/* Fills the working polyline with a piece's last path, its ends moved to the joints. */
static void start_piece(struct sp_newton *newton, const struct sp_piece *piece) {
    struct sp_polyline *line = &newton->system.line;
    newton->system.elements.reference.degree = 1;
    line->fold = sp_fold_of(SP_REFINE_FIRST);
    double ends[2][3];
    sp_sample_place(&piece->system, piece->first, ends[0]), sp_sample_place(&piece->system, piece->last, ends[1]);
    for (int32_t i = 0; i <= SP_REFINE_FIRST + 1; i++) {
        double t = (double)i / (SP_REFINE_FIRST + 1), place[3];
        sp_sample_place(&piece->system, piece->first + t * (piece->last - piece->first), place);
        for (int32_t j = 0; j < 2; j++) {
            double moved = place[j] + (1 - t) * (piece->joint[0].place[j] - ends[0][j]) + t * (piece->joint[1].place[j] - ends[1][j]);
            if (i == 0) moved = piece->joint[0].place[j];
            if (i == SP_REFINE_FIRST + 1) moved = piece->joint[1].place[j];
            line->nodes.places[2 * sp_fold_pair(line->fold, i) + j][sp_fold_lane(line->fold, i)] = moved;
        }
    }
    sp_pair *middle = line->nodes.places + 2 * (line->fold.both + 1);
    middle[0] = sp_splat(middle[0][0]), middle[1] = sp_splat(middle[1][0]);
}

int sp_piece_solve(struct sp_newton *newton, const struct sp_options *options, struct sp_piece *piece, struct sp_arena *arena,
                   int32_t *iterations) {
    start_piece(newton, piece);
    size_t bottom = arena->used;
    newton->system.elements.singular[0] = newton->system.elements.singular[1] = 0;
    struct sp_refined refined = sp_refine_run(newton, options, arena);
    arena->used = bottom; /* what it used is read before anything else is taken */
    *iterations += refined.outcome.iterations;
    if (refined.outcome.status != SP_CONVERGED || newton->system.elements.reference.degree == 1) return 0;
    piece->length = refined.length, piece->error = refined.length_error;
    return 1;
}

/* A first path to a singular end: the piece's own, run through so that its distance to the end falls like the square root of what is left,
 * as that of a geodesic does. */
static int start_graded(const struct sp_newton *newton, const struct sp_piece *piece, int end, struct sp_system *start,
                        struct sp_arena *arena) {
    struct sp_elements *elements = &start->elements;
    *start = newton->system;
    elements->count = START_COUNT, elements->singular[end] = 1, elements->singular[1 - end] = 0;
    start->line.fold = sp_fold_of(START_DEGREE * START_COUNT - 1);
    start->line.nodes.places = sp_arena_take(arena, 2 * (size_t)sp_fold_pairs(start->line.fold), sizeof(sp_pair));
    if (!start->line.nodes.places || !sp_reference_make(&elements->reference, START_DEGREE, arena)) return 0;
    double ends[2][3];
    sp_sample_place(&piece->system, piece->first, ends[0]), sp_sample_place(&piece->system, piece->last, ends[1]);
    for (int32_t i = 0; i <= START_DEGREE * START_COUNT; i++) {
        double t = sp_sample_parameter(elements, i), left = end ? 1 - t : t, place[3];
        double run = sp_square_root(sp_splat(left > 0 ? left : 0))[0];
        run = end ? 1 - run : run;
        sp_sample_place(&piece->system, piece->first + run * (piece->last - piece->first), place);
        for (int32_t j = 0; j < 2; j++)
            start->line.nodes.places[2 * sp_fold_pair(start->line.fold, i) + j][sp_fold_lane(start->line.fold, i)] =
                place[j] + (1 - run) * (piece->joint[0].place[j] - ends[0][j]) + run * (piece->joint[1].place[j] - ends[1][j]);
    }
    sp_pair *middle = start->line.nodes.places + 2 * (start->line.fold.both + 1);
    middle[0] = sp_splat(middle[0][0]), middle[1] = sp_splat(middle[1][0]);
    return 1;
}

/* The piece's own path with its ends moved to the joints. */
static void follow(const struct sp_piece *piece, struct sp_system *start) {
    int32_t last = piece->system.line.fold.inner + 1;
    *start = piece->system;
    double by[2][2];
    for (int e = 0; e < 2; e++)
        for (int32_t j = 0; j < 2; j++)
            by[e][j] = piece->joint[e].place[j] - sp_fold_get(start->line.fold, start->line.nodes.places, 2, e ? last : 0, j);
    for (int32_t i = 0; i <= last; i++) {
        double t = sp_sample_parameter(&start->elements, i);
        for (int32_t j = 0; j < 2; j++)
            start->line.nodes.places[2 * sp_fold_pair(start->line.fold, i) + j][sp_fold_lane(start->line.fold, i)] +=
                (1 - t) * by[0][j] + t * by[1][j];
    }
    sp_pair *middle = start->line.nodes.places + 2 * (start->line.fold.both + 1);
    middle[0] = sp_splat(middle[0][0]), middle[1] = sp_splat(middle[1][0]);
}

int sp_piece_follow(struct sp_newton *newton, const struct sp_options *options, struct sp_piece *piece, struct sp_arena *arena,
                    int32_t *iterations) {
    size_t bottom = arena->used;
    struct sp_system start;
    follow(piece, &start);
    newton->system.elements.singular[0] = newton->system.elements.singular[1] = 0;
    struct sp_refined refined = sp_refine_same(newton, options, &start, arena);
    arena->used = bottom;
    *iterations += refined.outcome.iterations;
    piece->length = refined.length;
    return refined.outcome.status == SP_CONVERGED;
}

int sp_piece_solve_graded(struct sp_newton *newton, const struct sp_options *options, struct sp_piece *piece, int end,
                          struct sp_arena *arena, int32_t *iterations) {
    size_t bottom = arena->used;
    struct sp_system start;
    int is_graded = piece->system.elements.reference.degree > 1 && piece->system.elements.singular[end];
    if (is_graded)
        follow(piece, &start);
    else if (!start_graded(newton, piece, end, &start, arena))
        return 0;
    newton->system.elements.singular[end] = 1, newton->system.elements.singular[1 - end] = 0;
    struct sp_refined refined = sp_refine_graded(newton, options, &start, arena);
    arena->used = bottom;
    *iterations += refined.outcome.iterations;
    piece->length = refined.length, piece->error = refined.length_error;
    return refined.outcome.status == SP_CONVERGED;
}

void sp_piece_move(struct sp_piece *piece, const struct sp_storage *storage) {
    piece->storage = *storage;
    piece->system = sp_storage_keep(&piece->storage, &piece->system);
}

void sp_piece_keep(const struct sp_newton *newton, struct sp_piece *piece) {
    piece->system = sp_storage_keep(&piece->storage, &newton->system);
    piece->first = 0, piece->last = 1;
}
