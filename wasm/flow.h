/* Geodesics as a first-order system in arc length, with the Jacobi fields along them. MATH.md, "Tracing".
 *
 * a and b solve f'' + K f = 0 (K the Gaussian curvature) with a = 1, a' = 0, b = 0, b' = 1 where the step began. A deviation (e, e') across
 * the path becomes (a e + b e', a' e + b' e'): a step carries errors and Jacobi fields alike. Lengths are those of the metric in use. */
#ifndef SURFPATH_FLOW_H
#define SURFPATH_FLOW_H

#include "dop853.h"
#include "metric.h"
#include "status.h"

/* Where the numbers of a state begin: place (u v 0 or x y z), its velocity, a b, a' b'. */
enum { SP_PLACE = 0, SP_VELOCITY = 3, SP_FIELDS = 6, SP_FIELD_SLOPES = 8 };

/* The two parts of an error of a state, as the metric in use measures them. */
struct sp_deviation {
    double position;  /* length */
    double direction; /* of the unit velocity: an angle */
};

/* A point of a geodesic, on the surface and with unit speed, and what is known of the surface there. */
struct sp_traveller {
    double state[SP_STATE], slope[SP_STATE];
    struct sp_point point;
    double normal[3];             /* of length 1 */
    struct sp_deviation rounding; /* what rounding of the state does, over the machine's epsilon: beside a pole it turns the path */
};

/* The system of a surface, which must outlive it. */
struct sp_ode sp_flow_ode(const struct sp_surface *surface);

/* Puts the place of traveller->state onto the surface and its velocity into the tangent plane, with length 1; starts a and b; fills in the
 * rest. `scale`: a length beside which coordinates are rounded. Writes the length in space of the velocity's tangent part as it was to
 * `speed`. Returns SP_CONVERGED, SP_NOT_FINITE, SP_OFF_SURFACE (implicit), or SP_SINGULAR_METRIC, also for a speed of 0; but for the first,
 * the traveller is not to be used. */
enum sp_status sp_flow_arrive(const struct sp_surface *surface, double scale, struct sp_traveller *traveller, double *speed);

/* sqrt(EG - F^2), or |grad f|: what vanishes where the surface is singular. */
double sp_flow_area(const struct sp_surface *surface, const struct sp_traveller *traveller);

/* What a small change of the traveller's state means: the length of its step, and of the change of velocity beside parallel transport
 * along it. */
struct sp_deviation sp_flow_measure(const struct sp_surface *surface, const struct sp_traveller *traveller, const double *change);

#endif
