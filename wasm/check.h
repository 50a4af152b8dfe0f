/* Does the polyline tell the truth about the surface under its chords? MATH.md, "Checks". */
#ifndef SURFPATH_CHECK_H
#define SURFPATH_CHECK_H

#include "newton.h"
#include "status.h"

/* Over all chords: their lengths, and by how much the geodesic is longer, from the angles between them and the tangent planes. */
struct sp_chord_sums {
    double length, error;
};

/* SP_CONVERGED if every chord follows the surface; else SP_SHEET_JUMP (implicit: a chord leads to another sheet), SP_SINGULAR_METRIC
 * (parametric: the path crosses a curve where S_u x S_v vanishes), SP_STALLED (parametric: a chord is too long to tell, or jumps where the
 * surface overlaps itself), SP_NOT_FINITE. `sums`: unless NULL, filled if the status is not negative. */
enum sp_status sp_check_chords(const struct sp_system *system, double scale, struct sp_chord_sums *sums);

/* Estimate of |length of the chords - length of the geodesic|: that of their `sums`; on a path that touches a wall also from the polyline
 * through every second node; with a metric (metric.h) from that alone. */
double sp_check_length_error(const struct sp_newton *newton, const struct sp_outcome *outcome, const struct sp_chord_sums *sums);

/* What a path at rest that is smooth has none of: E/L^2 - 1, the variance of its speed. A crease inside an element, or beside the nodes,
 * leaves both sides with speeds of their own, as waves do far from rest. Times the length L, what it may be too long by: at most L, and at
 * rest rounding, of either sign. */
double sp_check_unevenness(double energy, double length);

/* What rounding coordinates of size `scale` leaves of a length: no error is said to be smaller. */
double sp_check_rounding(double length, double scale);

#endif
