/* The energy of a path where length has a metric of its own (metric.h): E = m sum_e sum_q weight_q V_q' T(X_q) V_q with V = D X, elements
 * of any degree, 1 included, its exact gradient and Hessian. As in energy.h all is divided by 2m. MATH.md, "Metrics". */
#ifndef SURFPATH_METRIC_ELEMENTS_H
#define SURFPATH_METRIC_ELEMENTS_H

#include "elements.h"
#include "metric.h"

/* sum_e sum_q weight_q V_q' T V_q, the path's energy over m; NaN where T is not positive definite at a node between the ends. And, where
 * `length` is not NULL, the path's length. */
double sp_metric_squares(const struct sp_elements *elements, const struct sp_polyline *line, const struct sp_nodes *nodes, double *length);

/* As sp_elements_assemble, for all degrees; the couplings, too, of degree 1. The curvature term is covariant in the metric in use. */
struct sp_energy sp_metric_assemble(const struct sp_elements *elements, const struct sp_polyline *line, enum sp_hessian hessian,
                                    struct sp_row *rows, sp_mask *straight, sp_mask *held);

/* An element with what its nodes have of vectors: the velocity V, the momentum T V, and the pulls T_1 V and T_2 V. */
struct sp_metric_element {
    const struct sp_reference *reference;
    sp_pair factor; /* sp_elements_stretch */
    int32_t components;
    const sp_pair *charts, *metrics; /* of its first node */
    struct sp_vector velocity[SP_MAX_DEGREE + 1], momentum[SP_MAX_DEGREE + 1], pull[2][SP_MAX_DEGREE + 1];
};

/* Reads element pair e. */
void sp_metric_open(const struct sp_elements *elements, const struct sp_polyline *line, int32_t e, struct sp_metric_element *element);

/* Writes the 2 x 2 block of H between nodes i != j of a whole element, row by row; zero in coordinates that are held (`held`: two masks a
 * pair, from its first node). */
void sp_metric_couple(const struct sp_metric_element *element, int32_t i, int32_t j, const sp_mask *held, sp_pair block[4]);

/* As sp_elements_end_pull: B_a' times the pull of space, and the force of T itself. */
void sp_metric_end_pull(const struct sp_elements *elements, const struct sp_polyline *line, sp_pair pull[2]);

#endif
