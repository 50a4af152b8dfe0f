/* Does one chord of a polyline follow the surface? For those that are not plainly in order: check.h. */
#ifndef SURFPATH_CHORD_H
#define SURFPATH_CHORD_H

#include "status.h"
#include "system.h"

/* Normals at the two ends of a chord whose cosine is less may be on two sheets; |S_u x S_v|^2 less than so much of |S_u|^2 |S_v|^2 is no
 * normal. */
static const double SP_CHORD_COSINE = 0.2, SP_CHORD_DEGENERATE = 1e-24;

/* Chord i, from node i to the next. SP_CONVERGED, or as sp_check_chords says. `scale`: size of the coordinates. */
enum sp_status sp_chord_check(const struct sp_system *system, int32_t i, double scale);

/* Whether the normals of two places of an implicit surface differ however near these come to each other on it: a crease between them. On
 * two sheets they stay apart. `scale`: size of what is rounded. */
int sp_chord_spans_crease(const struct sp_surface *surface, const double from[3], const double normal[3], const double to[3],
                          const double other[3], double scale);

#endif
