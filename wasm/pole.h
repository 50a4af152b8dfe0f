/* Paths through the point to which an edge of the rectangle collapses. MATH.md, "Arcs". */
#ifndef SURFPATH_POLE_H
#define SURFPATH_POLE_H

#include "arcs.h"
#include "surfpath.h"

/* Solves a path through the point to which an edge of the rectangle collapses (a pole, an apex): two free arcs. newton->system.line holds
 * any polyline from end to end. */
struct sp_refined sp_pole_run(struct sp_newton *newton, const struct sp_options *options, const struct sp_passage *passage,
                              struct sp_arena *arena, struct sp_arcs *arcs);

/* The angle on the surface at a pole between the lines along which the coordinate around it is `from` and `to`: the directions in between,
 * turned through. `across`, `value`: the coordinate that is constant on its edge. */
double sp_pole_angle(const struct sp_surface *surface, int32_t across, double value, double from, double to);

#endif
