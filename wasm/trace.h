/* A geodesic on its way: adaptive steps, and what can happen in one. trace.c leads it from a request to a result. */
#ifndef SURFPATH_TRACE_H
#define SURFPATH_TRACE_H

#include "flow.h"

struct sp_trace {
    const struct sp_surface *surface;
    struct sp_ode ode;
    double tolerance, length, scale;
    double area; /* sp_flow_area of the start */
    int32_t max_steps;
    int walls; /* 0: the edges of the rectangle do not stop it */

    struct sp_traveller here;
    double travelled;        /* length so far */
    double step;             /* the next to try */
    double jacobi[2];        /* the Jacobi field that vanishes at the start, and its slope, up to a factor */
    double conjugate;        /* NaN: not yet */
    double spread[3];        /* sums of e^2, e e' and e'^2 over the errors of all steps, carried along as Jacobi fields */
    double along;            /* sum of all errors of position */
    int32_t tried, accepted; /* steps */
    int after_rejection;
    enum sp_status obstacle; /* why the last step was rejected */
};

/* An accepted step, before its end was put back onto the surface. */
struct sp_stride {
    double h;
    double end[SP_STATE];
    struct sp_stages stages;
    struct sp_deviation error;
    struct sp_traveller next; /* the end, on the surface */
};

/* Tries a step of stride->h and chooses the length of the next. Returns 1 where it is accepted: `stride` is then filled. */
int sp_trace_attempt(struct sp_trace *trace, struct sp_stride *stride);

/* Moves on to the end of an accepted step; notes a conjugate point in it. */
void sp_trace_advance(struct sp_trace *trace, const struct sp_stride *stride);

/* Where, in lengths from the step's start, the first wall of the rectangle is crossed; infinite if none is. */
double sp_trace_wall(const struct sp_trace *trace, const struct sp_stride *stride);

/* Why steps vanish here. SP_EDGE_REACHED: the surface ends at the wall ahead. */
enum sp_status sp_trace_verdict(const struct sp_trace *trace);

/* Estimate of the distance between the point reached and that of the geodesic. */
double sp_trace_error(const struct sp_trace *trace);

#endif
