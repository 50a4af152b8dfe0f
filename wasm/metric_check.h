/* Is the metric along a path what a metric must be, and how long is the path really? MATH.md, "Checks". */
#ifndef SURFPATH_METRIC_CHECK_H
#define SURFPATH_METRIC_CHECK_H

#include "metric.h"
#include "polyline.h"
#include "status.h"

/* SP_SINGULAR_METRIC where T is not positive definite at a node or in the middle between two (at the ends: where it is negative or zero),
 * or where its determinant comes down to nothing between two neighbours; SP_NOT_FINITE; else, and always without a metric, SP_CONVERGED. */
enum sp_status sp_metric_check(const struct sp_polyline *line, double scale);

/* Estimate of |length of the chords - length of the geodesic|: a third of what changes without every second node, what middles say if that
 * is much more, and, of a path at rest, what its nodes are unevenly apart by. At least what rounding coordinates of that size leaves. */
double sp_metric_length_error(const struct sp_polyline *line, double size, int at_rest);

#endif
