/* Ends of a path at which a coordinate says nothing, as at a pole. */
#ifndef SURFPATH_ENDS_H
#define SURFPATH_ENDS_H

#include "system.h"

/* Coordinate j to which the other nodes of an outermost element lead at the path's end 0 or 1: extrapolated; of chords, that of the node
 * beside it. */
double sp_ends_continued(const struct sp_system *system, int32_t end, int32_t j);

/* At an end that is a pole the coordinate around it says nothing, and what is interpolated with it is not smooth: moves it to where the
 * path beside it leads. The points of the path stay. Its charts are computed. */
void sp_ends_turn(struct sp_system *system);

#endif
