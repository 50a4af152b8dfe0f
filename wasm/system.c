/* Chooses between polyline and elements, and measures steps. MATH.md, "Newton". */
#include "system.h"
#include "metric_elements.h"
#include "scalar.h"

static int is_polyline(const struct sp_system *system) { return system->elements.reference.degree == 1; }
static int has_metric(const struct sp_system *system) { return system->line.kind->components > 0; }

double sp_system_squares(const struct sp_system *system, const struct sp_nodes *nodes, double *gradient_squared) {
    if (has_metric(system)) return sp_metric_squares(&system->elements, &system->line, nodes, NULL);
    if (is_polyline(system)) return sp_polyline_squares(system->line.fold, nodes->charts, gradient_squared);
    return sp_elements_squares(&system->elements, nodes->charts, NULL);
}

double sp_system_length(const struct sp_system *system, const struct sp_nodes *nodes) {
    double length;
    if (has_metric(system))
        sp_metric_squares(&system->elements, &system->line, nodes, &length);
    else if (is_polyline(system))
        length = sp_polyline_length(system->line.fold, nodes->charts);
    else
        sp_elements_squares(&system->elements, nodes->charts, &length);
    return length;
}

struct sp_energy sp_system_rows(struct sp_system *system, enum sp_hessian hessian) {
    const struct sp_polyline *line = &system->line;
    if (has_metric(system)) return sp_metric_assemble(&system->elements, line, hessian, system->rows, system->straight, system->held);
    return sp_elements_assemble(&system->elements, line, hessian, system->rows, system->straight, system->held);
}

struct sp_energy sp_system_assemble(struct sp_system *system, enum sp_hessian hessian) {
    if (sp_system_is_plain(system)) return sp_polyline_assemble(&system->line, hessian, system->rows, system->straight);
    struct sp_energy energy = sp_system_rows(system, hessian);
    energy.inertia = sp_system_factor(system, 0);
    return energy;
}

struct sp_inertia sp_system_factor(struct sp_system *system, double shift) {
    if (is_polyline(system)) return sp_blocks_factor(system->line.fold, system->rows, shift);
    return sp_elements_factor(&system->elements, &system->line, system->rows, system->held, shift);
}

void sp_system_solve(const struct sp_system *system, sp_pair *x) {
    if (is_polyline(system))
        sp_blocks_solve(system->line.fold, system->rows, x);
    else
        sp_elements_solve(&system->elements, x);
}

int sp_system_negative(const struct sp_system *system, sp_pair *x) {
    if (is_polyline(system)) return sp_blocks_descent(system->line.fold, system->rows, x);
    return sp_elements_descent(&system->elements, x);
}

void sp_system_end_pull(const struct sp_system *system, sp_pair pull[2]) {
    const sp_pair *chart = system->line.nodes.charts;
    if (has_metric(system)) {
        sp_metric_end_pull(&system->elements, &system->line, pull);
        return;
    }
    struct sp_vector force = sp_elements_end_pull(&system->elements, chart);
    pull[0] = sp_dot(force, sp_load(chart + SP_CHART_1)), pull[1] = sp_dot(force, sp_load(chart + SP_CHART_2));
}

int sp_system_keeps_normals(const struct sp_system *system, const struct sp_nodes *nodes) {
    int graded = sp_elements_graded(&system->elements);
    if (system->line.surface->kind != SP_IMPLICIT && !graded) return 1;
    for (int32_t k = 1; k <= sp_fold_unknown(system->line.fold); k++) {
        struct sp_vector old = sp_chart_normal(system->line.nodes.charts + SP_CHART * k),
                         now = sp_chart_normal(nodes->charts + SP_CHART * k);
        if (sp_any(sp_dot(old, now) <= sp_splat(0.0))) return 0;
        if (graded && sp_any(sp_dot(now, now) < 0.01 * sp_dot(old, old))) return 0;
    }
    return 1;
}

double sp_system_steepness(const struct sp_system *system, double squares) {
    struct sp_fold fold = system->line.fold;
    double sum = 0;
    for (int32_t k = 1; k <= sp_fold_unknown(fold); k++) {
        const struct sp_row *row = system->rows + k;
        sp_pair form = row->g * row->r1 * row->r1 - 2.0 * row->f * row->r1 * row->r2 + row->e * row->r2 * row->r2;
        sum += sp_fold_sum(fold, k, 2.0 * form / (row->weight * (row->e * row->g - row->f * row->f)));
    }
    return root(sum / squares);
}

double sp_system_largest(const struct sp_system *system, const sp_pair *x) {
    double largest = 0;
    for (int32_t k = 1; k <= sp_fold_unknown(system->line.fold); k++) {
        const struct sp_row *row = system->rows + k;
        sp_pair u = x[2 * k], v = x[2 * k + 1], squared = row->e * u * u + 2.0 * row->f * u * v + row->g * v * v;
        for (int lane = 0; lane < 2; lane++)
            if (squared[lane] > largest) largest = squared[lane];
    }
    return root(largest);
}
