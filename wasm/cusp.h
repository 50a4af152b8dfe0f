/* Paths across singular curves, along which S_u x S_v vanishes and turns over. MATH.md, "Arcs". */
#ifndef SURFPATH_CUSP_H
#define SURFPATH_CUSP_H

#include "arcs.h"

/* Whether a path leads from one side of a singular curve to the other (sp_cusp_run), so that no smooth path can be near it.
 * newton->system.line holds the path; its charts are computed. */
int sp_cusp_divides(const struct sp_newton *newton);

/* Whether it is such curves where its normal turns over, and no more of them than sp_cusp_run may cross: a steep surface turns, too. */
int sp_cusp_crosses(const struct sp_system *given);

/* Solves a path across a curve where S_u x S_v vanishes and turns over, or several: arcs that meet in points of them. `given`: a path from
 * end to end that crosses as often, at most six times, not in newton's own arrays; of one crossing several seeds are tried.
 * SP_SINGULAR_METRIC where that fails. */
struct sp_refined sp_cusp_run(struct sp_newton *newton, const struct sp_options *options, const struct sp_system *given,
                              struct sp_arena *arena, struct sp_arcs *arcs);

#endif
