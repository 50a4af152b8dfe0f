/* One free arc of a path made of arcs, while its ends are being found. MATH.md, "Arcs". */
#ifndef SURFPATH_PIECE_H
#define SURFPATH_PIECE_H

#include "refine.h"
#include "sample.h"

/* One end of a free arc: an end of the path, or a contact that may slide along an edge. */
struct sp_joint {
    int32_t slides, across;
    double place[2];
};

/* A free arc: its ends, and the path it was last. */
struct sp_piece {
    struct sp_joint joint[2];
    struct sp_system system;
    struct sp_storage storage;
    double first, last; /* part of the path in `system` that it takes up */
    double length, error, sine[2];
};

/* Solves the elements of a piece between its joints as they are, from the path it was last; newton->system then holds it. Returns 0 where
 * that fails, or it touches a wall. */
int sp_piece_solve(struct sp_newton *newton, const struct sp_options *options, struct sp_piece *piece, struct sp_arena *arena,
                   int32_t *iterations);

/* Solves a piece that was solved and kept before on the same elements, after its joints have moved a little: fast, and not checked. */
int sp_piece_follow(struct sp_newton *newton, const struct sp_options *options, struct sp_piece *piece, struct sp_arena *arena,
                    int32_t *iterations);

/* The same where the end of that number lies on a singular curve. */
int sp_piece_solve_graded(struct sp_newton *newton, const struct sp_options *options, struct sp_piece *piece, int end,
                          struct sp_arena *arena, int32_t *iterations);

/* Lets the piece keep its paths in other storage from now on, its present one copied there. */
void sp_piece_move(struct sp_piece *piece, const struct sp_storage *storage);

/* Makes the path just solved the piece's own. */
void sp_piece_keep(const struct sp_newton *newton, struct sp_piece *piece);

#endif
