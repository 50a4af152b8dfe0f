/* Paths past such a point, or around it where it is a hole. MATH.md, "Arcs". */
#ifndef SURFPATH_HOLE_H
#define SURFPATH_HOLE_H

#include "arcs.h"
#include "surfpath.h"

/* Solves a path close by an edge that is a point, or almost one, a hole, whose middle lies `beyond` it: around the hole where that is in
 * the way; else past it, and arcs->count is 0 and newton->system the path. The end nodes of newton->system.line tell from where to where,
 * and on which side. SP_SINGULAR_METRIC where that fails. */
struct sp_refined sp_hole_run(struct sp_newton *newton, const struct sp_options *options, const struct sp_passage *passage,
                              struct sp_arena *arena, struct sp_arcs *arcs);

#endif
