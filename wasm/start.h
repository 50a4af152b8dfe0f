/* Where Newton starts: the ends put on the surface, and a first polyline between them. */
#ifndef SURFPATH_START_H
#define SURFPATH_START_H

#include "polyline.h"
#include "surfpath.h"

/* A length beside which the coordinates of this surface and request are rounded: the box's diagonal, or the size of the ends. */
double sp_start_scale(const struct sp_surface *surface, const struct sp_request *request);

/* Implicit: moves a given point onto the surface, at most a tenth of `scale` away. Parametric: checks that it is finite. */
enum sp_status sp_start_end(const struct sp_surface *surface, double scale, double point[3]);

/* Implicit: whether f vanishes like a square or a higher power all over its zeros: the gradient does on the way from eight places `near`
 * one to them, of which some lead beside a node. */
int sp_start_is_multiple(const struct sp_surface *surface, const double place[3], double near);

/* Fills line->nodes.places with n nodes between the ends: along the straight line of the places (implicit: of space, put onto the surface),
 * or along request->start, resampled by length, unless it has as many points and is to `keep` them, so that a polyline at rest stays.
 * `from` and `to` are the ends already put onto the surface. Needs arena for start_count points. */
enum sp_status sp_start_polyline(struct sp_polyline *line, const struct sp_request *request, const double from[3], const double to[3],
                                 double scale, int32_t keep, struct sp_arena *arena);

/* Whether no more than `chords` of its chords would tell the shape of request->start: it is hardly shorter then. Needs arena for
 * start_count points. */
int sp_start_is_smooth(const struct sp_polyline *line, const struct sp_request *request, int32_t chords, struct sp_arena *arena);

#endif
