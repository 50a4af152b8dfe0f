/* Gradient and Hessian of the polyline's energy, two nodes at a time. Checked in tests/native against finite differences. MATH.md,
 * "Energy". */
#include "energy.h"
#include "elimination.h"

/* |r|^2 at a node: r = -B'D. */
static inline __attribute__((always_inline)) sp_pair slope_at(const sp_pair *chart, struct sp_vector pull) {
    sp_pair r1 = sp_dot(sp_load(chart + SP_CHART_1), pull), r2 = sp_dot(sp_load(chart + SP_CHART_2), pull);
    return r1 * r1 + r2 * r2;
}

double sp_polyline_squares(struct sp_fold fold, const sp_pair *charts, double *gradient_squared) {
    sp_pair sum = sp_splat(0.0), slopes = sum, middle = sum, zero = sum;
    const sp_pair *chart = charts + SP_CHART;
    struct sp_vector chord = sp_subtract(sp_load(chart), sp_load(charts));
    for (int32_t k = 1; k <= sp_fold_unknown(fold); k++, chart += SP_CHART) {
        int mirrored = k > sp_fold_both(fold);
        struct sp_vector next = mirrored ? sp_swap_vector(chord) : sp_subtract(sp_load(chart), sp_load(chart + SP_CHART));
        sum += sp_dot(chord, chord);
        if (gradient_squared) {
            sp_pair slope = slope_at(chart, sp_add(chord, next));
            slopes += mirrored ? zero : slope, middle = mirrored ? slope : zero;
        }
        chord = sp_subtract((struct sp_vector){zero, zero, zero}, next);
    }
    if (gradient_squared) *gradient_squared = slopes[0] + slopes[1] + middle[0];
    return sum[0] + sum[1] + (sp_fold_odd(fold) ? 0 : sp_dot(chord, chord)[0]);
}

double sp_polyline_length(struct sp_fold fold, const sp_pair *charts) {
    sp_pair sum = sp_splat(0.0);
    for (int32_t k = 1; k <= sp_fold_unknown(fold); k++) {
        struct sp_vector chord = sp_subtract(sp_load(charts + SP_CHART * k), sp_load(charts + SP_CHART * (k - 1)));
        sum += sp_square_root(sp_dot(chord, chord));
    }
    double length = sum[0] + sum[1];
    if (sp_fold_odd(fold)) return length;
    struct sp_vector here = sp_load(charts + SP_CHART * sp_fold_both(fold)), middle = sp_subtract(here, sp_swap_vector(here));
    return length + sp_square_root(sp_dot(middle, middle))[0];
}

static inline __attribute__((always_inline)) struct sp_vector minus(struct sp_vector a) { return (struct sp_vector){-a.x, -a.y, -a.z}; }

/* `force`: -D. */
static inline __attribute__((always_inline)) void assemble_node(const sp_pair *chart, struct sp_vector force, sp_pair weight,
                                                                sp_mask coordinate, struct sp_row *row) {
    struct sp_vector b1 = sp_load(chart + SP_CHART_1), b2 = sp_load(chart + SP_CHART_2), normal = sp_cross(b1, b2);
    row->e = sp_dot(b1, b1), row->f = sp_dot(b1, b2), row->g = sp_dot(b2, b2), row->weight = weight;
    row->r1 = sp_dot(b1, force), row->r2 = sp_dot(b2, force);
    struct sp_vector part = sp_scale(normal, sp_dot(force, normal) / sp_dot(normal, normal));
    part = (struct sp_vector){sp_select(coordinate, force.x, part.x), sp_select(coordinate, force.y, part.y),
                              sp_select(coordinate, force.z, part.z)};
    row->a = weight * row->e - sp_dot(part, sp_load(chart + SP_CHART_11));
    row->b = weight * row->f - sp_dot(part, sp_load(chart + SP_CHART_12));
    row->d = weight * row->g - sp_dot(part, sp_load(chart + SP_CHART_22));
}

void sp_row_assemble(const sp_pair *chart, const struct sp_vector *pull, sp_pair weight, sp_mask coordinate, struct sp_row *row) {
    assemble_node(chart, minus(*pull), weight, coordinate, row);
}

static inline __attribute__((always_inline)) void assemble_coupling(const sp_pair *chart, const sp_pair *next, struct sp_row *row) {
    struct sp_vector b1 = sp_load(chart + SP_CHART_1), b2 = sp_load(chart + SP_CHART_2);
    struct sp_vector next1 = sp_load(next + SP_CHART_1), next2 = sp_load(next + SP_CHART_2);
    row->q11 = sp_dot(b1, next1), row->q12 = sp_dot(b1, next2);
    row->q21 = sp_dot(b2, next1), row->q22 = sp_dot(b2, next2);
}

/* D = 2 X_k - X_k-1 - X_k+1 of pair k. */
static struct sp_vector pull_at(struct sp_fold fold, const sp_pair *charts, int32_t k) {
    const sp_pair *chart = charts + SP_CHART * k;
    struct sp_vector here = sp_load(chart), before = sp_subtract(here, sp_load(chart - SP_CHART));
    if (k > sp_fold_both(fold)) return sp_add(before, sp_swap_vector(before));
    return sp_subtract(before, sp_subtract(sp_load(chart + SP_CHART), here));
}

int sp_row_find_held(const struct sp_surface *surface, const sp_pair *place, const struct sp_row *row, sp_mask held[2]) {
    sp_pair force[2] = {row->r1, row->r2}, zero = sp_splat(0.0);
    for (int j = 0; j < 2; j++)
        held[j] = ((place[j] <= sp_splat(surface->lower[j])) & (force[j] < zero)) |
                  ((place[j] >= sp_splat(surface->upper[j])) & (force[j] > zero));
    return sp_any(held[0] | held[1]);
}

void sp_row_hold(struct sp_row *row, const sp_mask held[2]) {
    sp_pair zero = sp_splat(0.0), one = sp_splat(1.0);
    row->a = sp_select(held[0], one, row->a), row->d = sp_select(held[1], one, row->d);
    row->b = sp_select(held[0] | held[1], zero, row->b);
    row->e = sp_select(held[0], one / row->weight, row->e), row->g = sp_select(held[1], one / row->weight, row->g);
    row->f = sp_select(held[0] | held[1], zero, row->f);
    row->r1 = sp_select(held[0], zero, row->r1), row->r2 = sp_select(held[1], zero, row->r2);
}

double sp_rows_gradient_squared(struct sp_fold fold, const struct sp_row *rows) {
    double sum = 0;
    for (int32_t k = 1; k <= sp_fold_unknown(fold); k++)
        sum += sp_fold_sum(fold, k, rows[k].r1 * rows[k].r1 + rows[k].r2 * rows[k].r2);
    return sum;
}

void sp_row_hold_coupling(struct sp_row *row, const sp_mask here[2], const sp_mask next[2]) {
    sp_pair zero = sp_splat(0.0);
    row->q11 = sp_select(here[0] | next[0], zero, row->q11), row->q12 = sp_select(here[0] | next[1], zero, row->q12);
    row->q21 = sp_select(here[1] | next[0], zero, row->q21), row->q22 = sp_select(here[1] | next[1], zero, row->q22);
}

/* Holds the active coordinates of pair k; the node takes the coordinate Hessian and a straight step. */
static int32_t hold_active(const struct sp_polyline *line, int32_t k, const sp_mask held[2], struct sp_row *rows, sp_mask *straight) {
    sp_mask none[2] = {{0}, {0}};
    straight[k] |= held[0] | held[1];
    struct sp_vector pull = pull_at(line->fold, line->nodes.charts, k);
    sp_row_assemble(line->nodes.charts + SP_CHART * k, &pull, sp_splat(2.0), straight[k], rows + k);
    sp_row_hold(rows + k, held);
    sp_mask mirrored[2] = {sp_swap_mask(held[0]), sp_swap_mask(held[1])};
    int meets_itself = !sp_fold_odd(line->fold) && k == sp_fold_both(line->fold); /* the last Q leads to the same pair, lanes exchanged */
    sp_row_hold_coupling(rows + k, held, meets_itself ? mirrored : none);
    sp_row_hold_coupling(rows + k - 1, none, held);
    int32_t lanes = k > sp_fold_both(line->fold) ? 1 : 2, count = 0;
    for (int lane = 0; lane < lanes; lane++)
        count += (held[0][lane] != 0) + (held[1][lane] != 0);
    return count;
}

struct sp_energy sp_polyline_assemble(const struct sp_polyline *line, enum sp_hessian hessian, struct sp_row *rows, sp_mask *straight) {
    struct sp_fold fold = line->fold;
    struct sp_energy energy = {0};
    struct sp_sweep sweep = sp_sweep_start();
    sp_mask held[2], none = {0, 0}, coordinate = hessian == SP_COORDINATE ? ~none : none;
    sp_pair squares = sp_splat(0.0), slopes = squares, slope = squares;
    const sp_pair *chart = line->nodes.charts + SP_CHART;
    struct sp_vector chord = sp_subtract(sp_load(chart), sp_load(chart - SP_CHART));
    for (int32_t k = 1; k <= sp_fold_unknown(fold); k++, chart += SP_CHART) {
        int mirrored = k > sp_fold_both(fold);
        struct sp_vector next = mirrored ? minus(sp_swap_vector(chord)) : sp_subtract(sp_load(chart + SP_CHART), sp_load(chart));
        straight[k] = coordinate;
        assemble_node(chart, sp_subtract(next, chord), sp_splat(2.0), none, rows + k);
        struct sp_vector pull = sp_subtract(chord, next);
        if (coordinate[0]) sp_row_assemble(chart, &pull, sp_splat(2.0), coordinate, rows + k);
        if (!mirrored) assemble_coupling(chart, chart + SP_CHART, rows + k);
        if (line->touches && sp_row_find_held(line->surface, line->nodes.places + 2 * k, rows + k, held))
            energy.active += hold_active(line, k, held, rows, straight);
        squares += sp_dot(chord, chord), slopes += slope;
        slope = rows[k].r1 * rows[k].r1 + rows[k].r2 * rows[k].r2;
        chord = next;
        /* Q of the row before waited for the coordinates that this one holds; besides, nothing in this iteration waits for it. */
        if (k > 1) sp_eliminate(rows + k - 1, 0, &sweep);
    }
    struct sp_sweep end = sweep; /* a copy, as what a pointer leads to lies in memory, for all of the loop */
    energy.inertia = sp_blocks_join(fold, rows, 0, &end);
    energy.squares = squares[0] + squares[1] + (sp_fold_odd(fold) ? 0 : sp_dot(chord, chord)[0]);
    if (!sp_fold_odd(fold)) slopes += slope;
    energy.gradient_squared = slopes[0] + slopes[1] + (sp_fold_odd(fold) ? slope[0] : 0); /* the middle node counts once */
    return energy;
}
