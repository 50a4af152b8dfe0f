/* Points of a cuspidal edge: the curve in the rectangle along which S_u x S_v vanishes and turns over. MATH.md, "Arcs". */
#ifndef SURFPATH_CROSSING_H
#define SURFPATH_CROSSING_H

#include "surface.h"

/* The singular curve near a place: h = N . nu and its gradient, nu the direction in which N leaves zero. */
struct sp_curve {
    double value, slope[2];
};

/* At a place near the curve; nu is given, or with `choose` found first. */
struct sp_curve sp_curve_at(const struct sp_surface *surface, const double place[2], double nu[3], int choose);

/* A point of the curve, nu there, and the coordinate by which it moves along the curve. */
struct sp_crossing {
    double place[2], nu[3];
    int32_t along;
};

/* Puts a crossing onto the curve again, at its coordinate `along`. Returns 0 where it does not settle. */
int sp_crossing_correct(const struct sp_surface *surface, struct sp_crossing *crossing);

/* Where the normal turns over between two places, found by bisection. Returns 0 if it does not vanish there (a fold too sharp to see). */
int sp_crossing_find(const struct sp_surface *surface, const double from[2], const double to[2], struct sp_crossing *crossing);

#endif
