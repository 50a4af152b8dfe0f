/* Does the polyline tell the truth about the surface under its chords? MATH.md, "Checks". */
#ifndef SURFPATH_CHECK_H
#define SURFPATH_CHECK_H

#include "status.h"
#include "system.h"

/* Over all chords: their lengths, and by how much the geodesic is longer, from the angles between them and the tangent planes. */
struct sp_chord_sums {
    double length, error;
};

/* SP_CONVERGED if every chord follows the surface; else SP_SHEET_JUMP (implicit: a chord leads to another sheet), SP_SINGULAR_METRIC
 * (parametric: the path crosses a curve where S_u x S_v vanishes), SP_STALLED (parametric: a chord is too long to tell, or jumps where the
 * surface overlaps itself), SP_NOT_FINITE. `sums`: unless NULL, filled if the status is not negative. */
enum sp_status sp_check_chords(const struct sp_system *system, double scale, struct sp_chord_sums *sums);

/* Estimate of |length of the chords - length of the geodesic|: that of their `sums`; on a path that touches a wall (`touches`) also from
 * the polyline through every second node; with a metric (metric.h) from that alone. At least what rounding leaves. */
double sp_check_length_error(const struct sp_polyline *line, double scale, int touches, const struct sp_chord_sums *sums);

/* What rounding coordinates of size `scale` leaves of a length: no error is said to be smaller. */
double sp_check_rounding(double length, double scale);

#endif
