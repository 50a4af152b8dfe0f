/* Where the elements of a path meet (sp_elements.spread), other than evenly. MATH.md, "The ladder". */
#ifndef SURFPATH_REFINE_SPREAD_H
#define SURFPATH_REFINE_SPREAD_H

#include "system.h"

/* Where elements meet if each is to get as much as the others, of the path's parameter and its turns taken together or, where they are
 * spread already, of what they leave over: `spread`. Returns 0 if that is nearly even. `pieces`: scratch, a pair a node. */
int sp_spread_elements(const struct sp_system *system, sp_pair *pieces, double spread[SP_SPREAD + 1]);

/* The most that an element leaves over of u and v, or of x, y and z, in parts of what these differ by at the path's ends: what they may be
 * wrong by between nodes, about, where they are right at the nodes. */
double sp_spread_tail(const struct sp_system *system);

/* Where elements meet that close in on both ends of a path, up to `least`: each longer than the one before by the same factor. */
void sp_spread_close(double least, double spread[SP_SPREAD + 1]);

#endif
