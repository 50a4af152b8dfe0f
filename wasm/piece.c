/* Solves one free arc between given ends with the ladder of elements. MATH.md, "Arcs". */
#include "piece.h"

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
    struct sp_refined refined = sp_refine_run(newton, options, arena);
    arena->used = bottom; /* what it used is read before anything else is taken */
    *iterations += refined.outcome.iterations;
    if (refined.outcome.status != SP_CONVERGED || newton->system.elements.reference.degree == 1) return 0;
    piece->length = refined.length, piece->error = refined.length_error;
    return 1;
}

void sp_piece_keep(const struct sp_newton *newton, struct sp_piece *piece) {
    piece->system = sp_storage_keep(&piece->storage, &newton->system);
    piece->first = 0, piece->last = 1;
}
