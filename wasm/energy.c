/* Gradient and Hessian of the polyline's energy, two nodes at a time. Checked in tests/native against finite differences. MATH.md,
 * "Energy". */
#include "energy.h"

double sp_polyline_squares(struct sp_fold fold, const sp_pair *charts) {
    sp_pair sum = sp_splat(0.0);
    struct sp_vector here = sp_load(charts);
    for (int32_t k = 1; k <= sp_fold_unknown(fold); k++) {
        struct sp_vector next = sp_load(charts + SP_CHART * k), chord = sp_subtract(next, here);
        sum += sp_dot(chord, chord);
        here = next;
    }
    double squares = sum[0] + sum[1];
    if (fold.odd) return squares;
    struct sp_vector middle = sp_subtract(here, sp_swap_vector(here));
    return squares + sp_dot(middle, middle)[0];
}

/* The row of one pair but for Q: `pull` is D = 2 X_k - X_k-1 - X_k+1. */
static void assemble_row(const sp_pair *chart, struct sp_vector pull, sp_mask coordinate, struct sp_row *row) {
    struct sp_vector b1 = sp_load(chart + SP_CHART_1), b2 = sp_load(chart + SP_CHART_2), normal = sp_cross(b1, b2);
    row->e = sp_dot(b1, b1), row->f = sp_dot(b1, b2), row->g = sp_dot(b2, b2);
    row->r1 = -sp_dot(b1, pull), row->r2 = -sp_dot(b2, pull);
    struct sp_vector part = sp_scale(normal, sp_dot(pull, normal) / sp_dot(normal, normal));
    part = (struct sp_vector){sp_select(coordinate, pull.x, part.x), sp_select(coordinate, pull.y, part.y),
                              sp_select(coordinate, pull.z, part.z)};
    row->a = 2.0 * row->e + sp_dot(part, sp_load(chart + SP_CHART_11));
    row->b = 2.0 * row->f + sp_dot(part, sp_load(chart + SP_CHART_12));
    row->d = 2.0 * row->g + sp_dot(part, sp_load(chart + SP_CHART_22));
}

static void assemble_coupling(const sp_pair *chart, const sp_pair *next, struct sp_row *row) {
    struct sp_vector b1 = sp_load(chart + SP_CHART_1), b2 = sp_load(chart + SP_CHART_2);
    struct sp_vector next1 = sp_load(next + SP_CHART_1), next2 = sp_load(next + SP_CHART_2);
    row->q11 = sp_dot(b1, next1), row->q12 = sp_dot(b1, next2);
    row->q21 = sp_dot(b2, next1), row->q22 = sp_dot(b2, next2);
}

/* D = 2 X_k - X_k-1 - X_k+1 of pair k. */
static struct sp_vector pull_at(struct sp_fold fold, const sp_pair *charts, int32_t k) {
    const sp_pair *chart = charts + SP_CHART * k;
    struct sp_vector here = sp_load(chart), before = sp_subtract(here, sp_load(chart - SP_CHART));
    if (k > fold.both) return sp_add(before, sp_swap_vector(before));
    return sp_subtract(before, sp_subtract(sp_load(chart + SP_CHART), here));
}

/* Coordinate j of pair k is on a wall of the rectangle and its force -gradient pushes it outwards. */
static sp_mask active_coordinate(const struct sp_surface *surface, const sp_pair *place, int j, sp_pair force) {
    sp_pair zero = sp_splat(0.0);
    sp_mask low = (place[j] <= sp_splat(surface->lower[j])) & (force < zero);
    return low | ((place[j] >= sp_splat(surface->upper[j])) & (force > zero));
}

/* Rows and columns of held coordinates become those of the identity, in the pair itself and in the Q that leads to it. */
static void hold(struct sp_row *row, struct sp_row *before, sp_mask held1, sp_mask held2) {
    sp_pair zero = sp_splat(0.0), one = sp_splat(1.0);
    row->a = sp_select(held1, one, row->a), row->d = sp_select(held2, one, row->d);
    row->b = sp_select(held1 | held2, zero, row->b);
    row->e = sp_select(held1, 0.5 * one, row->e), row->g = sp_select(held2, 0.5 * one, row->g);
    row->f = sp_select(held1 | held2, zero, row->f);
    row->r1 = sp_select(held1, zero, row->r1), row->r2 = sp_select(held2, zero, row->r2);
    row->q11 = sp_select(held1, zero, row->q11), row->q12 = sp_select(held1, zero, row->q12);
    row->q21 = sp_select(held2, zero, row->q21), row->q22 = sp_select(held2, zero, row->q22);
    before->q11 = sp_select(held1, zero, before->q11), before->q21 = sp_select(held1, zero, before->q21);
    before->q12 = sp_select(held2, zero, before->q12), before->q22 = sp_select(held2, zero, before->q22);
}

/* Holds the active coordinates of pair k; the node takes the coordinate Hessian and a straight step. */
static int32_t hold_active(const struct sp_polyline *line, int32_t k, struct sp_row *rows, sp_mask *straight) {
    const sp_pair *place = line->nodes.places + 2 * k;
    struct sp_row *row = rows + k;
    sp_mask held1 = active_coordinate(line->surface, place, 0, row->r1), held2 = active_coordinate(line->surface, place, 1, row->r2);
    sp_mask held = held1 | held2;
    if (!sp_any(held)) return 0;
    straight[k] |= held;
    assemble_row(line->nodes.charts + SP_CHART * k, pull_at(line->fold, line->nodes.charts, k), straight[k], row);
    hold(row, row - 1, held1, held2);
    if (!line->fold.odd && k == line->fold.both) /* the last Q leads to the same pair, lanes exchanged */
        hold(&(struct sp_row){0}, row, sp_bits(sp_swap(sp_from_bits(held1))), sp_bits(sp_swap(sp_from_bits(held2))));
    int32_t lanes = k > line->fold.both ? 1 : 2, count = 0;
    for (int lane = 0; lane < lanes; lane++)
        count += (held1[lane] != 0) + (held2[lane] != 0);
    return count;
}

struct sp_energy sp_polyline_assemble(const struct sp_polyline *line, enum sp_hessian hessian, struct sp_row *rows, sp_mask *straight) {
    struct sp_fold fold = line->fold;
    const sp_pair *charts = line->nodes.charts;
    struct sp_energy energy = {sp_polyline_squares(fold, charts), 0.0, 0};
    sp_mask coordinate = hessian == SP_COORDINATE ? (sp_mask){-1, -1} : (sp_mask){0, 0};
    int32_t unknown = sp_fold_unknown(fold);
    for (int32_t k = 1; k <= unknown; k++) {
        straight[k] = coordinate;
        assemble_row(charts + SP_CHART * k, pull_at(fold, charts, k), coordinate, rows + k);
        if (k <= fold.both) assemble_coupling(charts + SP_CHART * k, charts + SP_CHART * (k + 1), rows + k);
    }
    for (int32_t k = 1; line->surface->kind == SP_PARAMETRIC && k <= unknown; k++)
        energy.active += hold_active(line, k, rows, straight);
    sp_pair sum = sp_splat(0.0);
    for (int32_t k = 1; k <= fold.both; k++)
        sum += rows[k].r1 * rows[k].r1 + rows[k].r2 * rows[k].r2;
    energy.gradient_squared = sum[0] + sum[1];
    if (fold.odd) energy.gradient_squared += (rows[unknown].r1 * rows[unknown].r1 + rows[unknown].r2 * rows[unknown].r2)[0];
    return energy;
}
