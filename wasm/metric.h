/* The metric at a node, where length is not measured as space does: a symmetric tensor T over the coordinates X of the chart, with its
 * derivatives along the chart. Length is the integral of sqrt(dX' T dX). Knows no path. MATH.md, "Metrics".
 *
 * Layout, in sp_pair: T, T_1, T_2, T_11, T_12, T_22, `components` numbers each. 1: a factor of the identity (density); 3: xx xy yy, of
 * places u v, whose chart is X = (u, v, 0); 6: xx xy yy xz yz zz. */
#ifndef SURFPATH_METRIC_H
#define SURFPATH_METRIC_H

#include "chart.h"

enum { SP_METRIC_PARTS = 6, SP_METRIC_COMPONENTS = 6, SP_METRIC_LARGEST = SP_METRIC_PARTS * SP_METRIC_COMPONENTS };

/* Parts of a metric. */
enum { SP_METRIC_T = 0, SP_METRIC_T1, SP_METRIC_T2, SP_METRIC_T11, SP_METRIC_T12, SP_METRIC_T22 };

/* The charts of places u v themselves: flat. */
void sp_flat_charts(int32_t pair_count, const sp_pair *places, sp_pair *charts);

/* a' T b for a tensor of `components` numbers, vectors of three; of none, T = 1. */
sp_pair sp_metric_product(int32_t components, const sp_pair *t, const sp_pair *a, const sp_pair *b);

/* The first fundamental form e = B_1'T B_1, f = B_1'T B_2, g = B_2'T B_2. */
struct sp_form {
    sp_pair e, f, g;
};

struct sp_form sp_metric_form(int32_t components, const sp_pair *chart, const sp_pair *metric);

/* What geodesics turn by: the form, Christoffel's symbols of the first kind, Gamma_c,ab in gamma[ab][c] (ab = 11, 12, 22), and the Gaussian
 * curvature. */
struct sp_geometry {
    struct sp_form form;
    sp_pair gamma[3][2];
    sp_pair determinant, curvature;
};

/* The chart, the metric and the geometry of a pair of places. Where length is that of space, the metric is a density of 1. */
struct sp_point {
    sp_pair chart[SP_CHART], metric[SP_METRIC_LARGEST];
    int32_t components;
    struct sp_geometry geometry;
};

void sp_metric_point(const struct sp_surface *surface, const sp_pair *place, struct sp_point *point);

/* x' e^-1 y for two covectors, e the form. */
sp_pair sp_geometry_raise(const struct sp_geometry *geometry, const sp_pair x[2], const sp_pair y[2]);

/* Determinant of the first fundamental form at a pair of places, which are put onto the surface first; -1 where the form is not even
 * semidefinite. `scale`: of sp_implicit_settle. */
sp_pair sp_metric_determinant(const struct sp_surface *surface, sp_pair *place, double scale);

/* Lanes in which a form is positive definite. */
static inline sp_mask sp_form_positive(struct sp_form form) {
    sp_pair zero = sp_splat(0.0);
    return (form.e + form.g > zero) & (form.e * form.g - form.f * form.f > zero);
}

#endif
