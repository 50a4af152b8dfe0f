/* One free arc of a path made of arcs, while its ends are being found. MATH.md, "Arcs". */
#ifndef SURFPATH_PIECE_H
#define SURFPATH_PIECE_H

#include "arcs.h"
#include "sample.h"

/* One end of a free arc: an end of the path; a contact, that slides along an edge; or a point of a singular curve. */
struct sp_joint {
    int32_t slides, across; /* a contact, and the coordinate across its edge */
    int32_t singular;
    double place[2];
    double towards;  /* a contact: the sign of the path's way along its edge */
    double doubt;    /* a contact: how well its place is known */
    double reach;    /* a contact: as far as it may slide at once, in the coordinate along its edge; 0: by half the arc, or a radian */
    double aside[2]; /* singular: a place beside it, on the side of the arc, where a first path is easier to find */
};

/* A free arc: its ends, and the path it was last. */
struct sp_piece {
    struct sp_joint joint[2];
    struct sp_system system;
    struct sp_storage storage;
    double first, last; /* part of the path in `system` that it takes up */
    struct sp_refined solved;
    int32_t checked;           /* it is solved to the tolerance, not only on the elements it had */
    double slant[2], speed[2]; /* contacts: against the edge, about the angle; how long a unit of the coordinate along it is */
};

/* Where a contact stands along its edge. */
static inline double *sp_piece_slide(struct sp_piece *piece, int end) { return piece->joint[end].place + 1 - piece->joint[end].across; }

/* Solves a piece between its joints as they are, from the path it was last: chords or elements, these with their ends moved. `checked`: to
 * the tolerance; else on the elements it has (if it has any), fast. newton->system then holds the path, which sp_piece_keep makes the
 * piece's own. Returns 0 where that fails, or it touches a wall; a piece that slides may be SP_ILL_CONDITIONED. */
int sp_piece_solve(struct sp_newton *newton, const struct sp_options *options, int checked, struct sp_piece *piece, struct sp_arena *arena);

/* Makes the path just solved the piece's own. */
void sp_piece_keep(const struct sp_newton *newton, struct sp_piece *piece);

/* Lets the piece keep its paths in other storage from now on, its present one copied there. */
void sp_piece_move(struct sp_piece *piece, const struct sp_storage *storage);

/* The piece as an arc of a path; `reversed`: the path runs through it from its second joint. */
struct sp_arc sp_piece_arc(const struct sp_piece *piece, int32_t reversed);

#endif
