/* Where the elements of a path meet (sp_elements.spread), other than evenly. MATH.md, "The ladder". */
#ifndef SURFPATH_REFINE_SPREAD_H
#define SURFPATH_REFINE_SPREAD_H

#include "system.h"

/* Where elements meet if they are to be equally long, the path's parameter and its turns taken together: `spread`.
 * Returns 0 if that is nearly even. `turns`: scratch, a pair a node. */
int sp_spread_elements(const struct sp_system *system, sp_pair *turns, double spread[SP_SPREAD + 1]);

/* Where elements meet that close in on both ends of a path, up to `least`: each longer than the one before by the same factor. */
void sp_spread_close(double least, double spread[SP_SPREAD + 1]);

#endif
