/* The normal of a parametric surface, and where it turns over: it vanishes on a singular curve, or only seems to turn, in a fold between
 * two places. */
#ifndef SURFPATH_NORMAL_H
#define SURFPATH_NORMAL_H

#include "polyline.h"

/* S_u x S_v at a place. */
void sp_normal_at(const struct sp_surface *surface, const double place[2], double normal[3]);

/* Whether a normal is zero up to rounding, beside that of another place: at a pole, where it points to either side. */
static inline int sp_normal_is_nothing(const double normal[3], const double beside[3]) {
    double squared = 0, other = 0;
    for (int j = 0; j < 3; j++)
        squared += normal[j] * normal[j], other += beside[j] * beside[j];
    return squared <= 1e-20 * other;
}

/* What a bisection found: the place and the normal that it looked at last; squares of lengths of normals, the least of all and the
 * larger one of the ends. */
struct sp_turn {
    double place[2], normal[3], least, largest;
};

/* Bisects between two places on the sign of N . N_from. Returns 0 where the normal does not turn over between them. */
int sp_normal_turn(const struct sp_surface *surface, const double from[2], const double to[2], int rounds, struct sp_turn *turn);

/* Whether the normal is zero where it turned over, or at one of the two places: a singular curve, no fold. */
int sp_normal_vanishes(const struct sp_turn *turn);

/* How often the normal turns over along a path on a parametric surface, from one node to the next, the nodes before `first` at either end
 * left out: where it ends on a singular curve it has no normal. Its charts are computed. */
int32_t sp_normal_turns(const struct sp_polyline *line, int32_t first);

#endif
