/* A chart in which paths past a pole are smooth: the surface over p = r cos θ, q = r sin θ, r the coordinate across the edge that is a
 * point, θ the angle around it. MATH.md, "Arcs". */
#ifndef SURFPATH_POLAR_H
#define SURFPATH_POLAR_H

#include "polyline.h"
#include "surfpath.h"

/* Metrics of surfaces over p and q: what they are over u and v, and this. */
enum { SP_POLAR = 3 };

struct sp_polar {
    struct sp_surface surface; /* over p and q, without walls; first, so that its kind finds the rest */
    const struct sp_surface *whole;
    int32_t across;      /* the coordinate that is constant on the edge */
    double edge, side;   /* where; 1, -1: the surface lies beyond, before */
    double middle, rate; /* θ = rate (u - middle), u the coordinate along the edge */
    double turn, least;  /* once around, of u; the least r at which the surface is differentiated */
};

/* Makes the chart around the point that a request passes, and the request's like in it, a start in the arena, if there is room
 * for it. Returns 0 where the ends are more than half a turn apart, or there is none. */
int sp_polar_make(struct sp_polar *polar, const struct sp_surface *surface, const struct sp_request *request, struct sp_arena *arena,
                  struct sp_request *moved);

/* What distances from the pole are added to, if the surface is such a chart: they are rounded beside it. */
double sp_polar_offset(const struct sp_surface *surface);

/* Places over u and v from those over p and q. */
void sp_polar_leave(const struct sp_polar *polar, int32_t pair_count, const sp_pair *places, sp_pair *left);

/* Whether all nodes lie in the rectangle, and the place nearest to the pole between any two, where there may be a hole. */
int sp_polar_holds(const struct sp_polyline *line);

/* Makes the parameters of a path those over u and v, from end to end of the request, continuous but for jumps of half turns at the pole. */
void sp_polar_return(const struct sp_polar *polar, const struct sp_request *request, int32_t count, double *parameters);

#endif
