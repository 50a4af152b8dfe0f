/* Implicit surfaces f(x,y,z) = 0: charts in orthonormal tangent frames, the retraction of Eq. 37, and densities and tensors over x, y, z
 * along the charts. MATH.md, "Charts" and "Metrics".
 *
 * The paper composes the energy with the projection, which makes its Hessian singular along the normals; two tangent coordinates a node do
 * not. */
#include "metric.h"
#include "scalar.h"
#include <string.h>

/* Of gradients, beside those in this direction. */
static const double NOTHING = 1e-9, BESIDE[3] = {0.5, -0.6, 0.62};
/* Where there is no normal any will do. */
static const double LEAST_SIZE = 1e-150;

/* A step of so small a part of the size of things may be rounding of f. */
static const double NOISE = 1e-12;

enum { BLOCK = 32, JETS = SP_IMPLICIT_JET * BLOCK, SETTLE_LIMIT = 12, CAREFUL_LIMIT = 40 };

/* One tangent vector of a right-handed orthonormal frame with normal n; continuous except across n.z = 0. Duff et al., "Building an
 * orthonormal basis, revisited", JCGT 6 (2017). */
static void tangent_frame(struct sp_vector n, struct sp_vector *first, struct sp_vector *second) {
    sp_pair sign = sp_from_bits((sp_bits(n.z) & INT64_MIN) | sp_bits(sp_splat(1.0)));
    sp_pair a = -1.0 / (sign + n.z), b = n.x * n.y * a;
    *first = (struct sp_vector){1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x};
    *second = (struct sp_vector){b, sign + n.y * n.y * a, -n.y};
}

/* Second derivatives of f applied to a vector. */
static struct sp_vector hessian_times(const sp_pair *second, struct sp_vector v) {
    return (struct sp_vector){second[0] * v.x + second[1] * v.y + second[2] * v.z, second[1] * v.x + second[3] * v.y + second[4] * v.z,
                              second[2] * v.x + second[4] * v.y + second[5] * v.z};
}

/* The largest of |x|, |y|, |z|: dividing by it first keeps |v|^2 from overflow and underflow. */
static sp_pair magnitude(struct sp_vector v) {
    sp_pair x = sp_absolute(v.x), y = sp_absolute(v.y), z = sp_absolute(v.z), largest = sp_select(x > y, x, y);
    return sp_select(largest > z, largest, z);
}

/* S_ab = -(B_a' f'' B_b) grad f / |grad f|^2: differentiate f(S(a)) = 0 twice. */
static void chart_from_jet(const sp_pair *place, const sp_pair *jet, sp_pair *chart) {
    struct sp_vector gradient = sp_load(jet + 1), first, second;
    sp_pair unit = 1.0 / (magnitude(gradient) + LEAST_SIZE);
    gradient = sp_scale(gradient, unit);
    sp_pair squared = sp_dot(gradient, gradient) + LEAST_SIZE;
    struct sp_vector toward = sp_scale(gradient, -unit / squared);
    tangent_frame(sp_scale(gradient, 1.0 / sp_square_root(squared)), &first, &second);
    struct sp_vector second_first = hessian_times(jet + 4, first);
    sp_store(sp_load(place), chart + SP_CHART_X);
    sp_store(first, chart + SP_CHART_1);
    sp_store(second, chart + SP_CHART_2);
    sp_store(sp_scale(toward, sp_dot(first, second_first)), chart + SP_CHART_11);
    sp_store(sp_scale(toward, sp_dot(second, second_first)), chart + SP_CHART_12);
    sp_store(sp_scale(toward, sp_dot(second, hessian_times(jet + 4, second))), chart + SP_CHART_22);
}

/* Number j of those that a jet holds side by side, with its derivatives. */
static void gather(const sp_pair *jet, int32_t outputs, int32_t j, sp_pair *gathered) {
    for (int32_t i = 0; i < SP_IMPLICIT_JET; i++)
        gathered[i] = jet[outputs * i + j];
}

/* One component t(x,y,z) of a metric along the chart: t_a = grad t . B_a, t_ab = B_a' t'' B_b + grad t . S_ab. */
static void component_along(const sp_pair *chart, const sp_pair *jet, int32_t components, sp_pair *metric) {
    struct sp_vector gradient = sp_load(jet + 1), frame[2] = {sp_load(chart + SP_CHART_1), sp_load(chart + SP_CHART_2)};
    metric[SP_METRIC_T * components] = jet[0];
    for (int a = 0; a < 2; a++) {
        struct sp_vector turned = hessian_times(jet + 4, frame[a]);
        metric[(SP_METRIC_T1 + a) * components] = sp_dot(gradient, frame[a]);
        for (int b = a; b < 2; b++)
            metric[(SP_METRIC_T11 + a + b) * components] =
                sp_dot(frame[b], turned) + sp_dot(gradient, sp_load(chart + SP_CHART_11 + 3 * (a + b)));
    }
}

/* Chart and metric of one pair from the jet of f and of what the metric is made of. */
static void read_jet(const sp_pair *place, const sp_pair *jet, int32_t components, sp_pair *chart, sp_pair *metric) {
    sp_pair one[SP_IMPLICIT_JET];
    if (components) gather(jet, components + 1, 0, one);
    chart_from_jet(place, components ? one : jet, chart);
    for (int32_t c = 0; c < components; c++) {
        gather(jet, components + 1, 1 + c, one);
        component_along(chart, one, components, metric + c);
    }
}

static void implicit_charts(const struct sp_surface *surface, int32_t pair_count, const sp_pair *places, sp_pair *charts,
                            sp_pair *metrics) {
    sp_pair jets[JETS];
    int32_t components = sp_kind_of(surface)->components, size = SP_IMPLICIT_JET * (components + 1), block = JETS / size;
    for (int32_t k = 0; k < pair_count; k += block) {
        int32_t count = pair_count - k < block ? pair_count - k : block;
        surface->jet(count, places + 3 * k, jets);
        for (int32_t i = 0; i < count; i++)
            read_jet(places + 3 * (k + i), jets + size * i, components, charts + SP_CHART * (k + i),
                     metrics + SP_METRIC_PARTS * components * (k + i));
    }
}

/* Where f is the same all around a place on a chord, or nearly, its zero is looked for outwards, by these parts of the chord, and no
 * farther from that place than this part. */
enum { TRIES = 3 };
static const double OUTWARDS[TRIES] = {0.5, 0.25, 1}, FARTHEST = 1.5;

/* How far a pair of points has come: lanes that still move, their last step's length, and the size of the coordinates. Of those that are
 * looked after: which have just gone to where f has no value, the last step and gradient, and how many steps they may still take. */
struct settling {
    sp_mask moving, lost;
    sp_pair last, size, left;
    struct sp_vector step, gradient;
};

/* Faces are parallel, and meet in no edge, where the squared sine between their normals is below this. */
static const double PARALLEL = 1e-8;

/* The way to where f vanishes, by its gradient; where that has turned by more than a right angle since the last step, within its plane. */
static struct sp_vector toward_edge(struct sp_vector gradient, sp_pair value, struct settling *state) {
    sp_pair turned = sp_dot(gradient, state->gradient), squared = sp_dot(gradient, gradient);
    struct sp_vector within = sp_subtract(gradient, sp_scale(state->gradient, turned / sp_dot(state->gradient, state->gradient)));
    sp_pair across = sp_dot(within, within);
    sp_mask is_edge = (turned < sp_splat(0.0)) & (across > PARALLEL * squared);
    sp_pair far = value / sp_select(is_edge, across, squared);
    state->gradient = gradient;
    return (struct sp_vector){far * sp_select(is_edge, within.x, gradient.x), far * sp_select(is_edge, within.y, gradient.y),
                              far * sp_select(is_edge, within.z, gradient.z)};
}

/* A step to where f has no value, as beyond the rim of a root, is taken back by half. It counts for nothing. */
static struct sp_vector look_after(sp_pair value, struct sp_vector step, struct settling *state) {
    sp_mask none = ~(value - value == sp_splat(0.0)), lost = none & (state->last < sp_splat(__builtin_inf()));
    struct sp_vector half = sp_scale(state->step, sp_splat(-0.5));
    step = (struct sp_vector){sp_select(lost, half.x, step.x), sp_select(lost, half.y, step.y), sp_select(lost, half.z, step.z)};
    sp_pair sign = sp_select(lost, sp_splat(-1.0), sp_splat(1.0));
    state->lost = lost, state->step = sp_scale(step, sign);
    state->left = sp_select(none & ~lost, sp_splat(-1.0), state->left - sign);
    return step;
}

/* One step of Eq. 37 for the lanes that still move; the others are left alone, so that no point depends on its neighbours. Settled: f = 0,
 * the step is below 4e-15 of the size of things, or it has stopped shrinking where it may be rounding. */
static void settle_pair(const sp_pair *values, sp_pair *place, struct settling *state, int careful) {
    struct sp_vector gradient = sp_load(values + 1), at = sp_load(place);
    sp_pair unit = 1.0 / magnitude(gradient);
    gradient = sp_scale(gradient, unit);
    struct sp_vector step = sp_scale(gradient, values[0] * unit / sp_dot(gradient, gradient));
    if (careful) step = look_after(values[0], toward_edge(gradient, values[0] * unit, state), state);
    struct sp_vector next = sp_subtract(at, step);
    sp_pair length = sp_square_root(sp_dot(step, step)), size = state->size;
    sp_mask exact = values[0] == sp_splat(0.0), goes = ~exact & (state->left >= sp_splat(0.0)), moves = state->moving & goes;
    place[0] = sp_select(moves, next.x, at.x);
    place[1] = sp_select(moves, next.y, at.y);
    place[2] = sp_select(moves, next.z, at.z);
    sp_mask rests = (length < 4e-15 * size) | ((length >= state->last) & (length < NOISE * size));
    state->moving &= ~exact & ~(goes & rests & ~state->lost);
    state->last = length;
}

static int settle_block(const struct sp_surface *surface, int32_t count, sp_pair *places, double scale, int careful) {
    sp_pair values[SP_IMPLICIT_VALUES * BLOCK];
    struct settling states[BLOCK];
    for (int32_t i = 0; i < count; i++) {
        sp_pair size = sp_square_root(sp_dot(sp_load(places + 3 * i), sp_load(places + 3 * i)));
        states[i] = (struct settling){.moving = {-1, -1},
                                      .last = sp_splat(__builtin_inf()),
                                      .size = sp_larger(sp_splat(scale), size),
                                      .left = sp_splat(SETTLE_LIMIT)};
    }
    int open = 1;
    for (int round = 0; round < (careful ? CAREFUL_LIMIT : SETTLE_LIMIT) && open; round++) {
        surface->value(count, places, values);
        open = 0;
        for (int32_t i = 0; i < count; i++) {
            settle_pair(values + SP_IMPLICIT_VALUES * i, places + 3 * i, states + i, careful);
            open |= sp_any(states[i].moving & (states[i].left >= sp_splat(0.0)));
        }
    }
    int settled = 1;
    for (int32_t i = 0; i < count; i++)
        settled &= !sp_any(states[i].moving);
    return settled;
}

/* Whether a place is none, as f had no value on the way to it. */
static int is_lost(int32_t pair_count, const sp_pair *places) {
    sp_pair sum = sp_splat(0.0);
    for (int32_t k = 0; k < 3 * pair_count; k++)
        sum += places[k] - places[k];
    return sp_any(sum != sp_splat(0.0));
}

int sp_implicit_settle(const struct sp_surface *surface, int32_t pair_count, sp_pair *places, double scale) {
    int settled = 1;
    for (int32_t k = 0; k < pair_count; k += BLOCK) {
        int32_t count = pair_count - k < BLOCK ? pair_count - k : BLOCK;
        sp_pair given[3 * BLOCK], *block = places + 3 * k;
        memcpy(given, block, 3 * (size_t)count * sizeof *given);
        int rests = settle_block(surface, count, block, scale, 0);
        if (!rests && is_lost(count, block)) {
            memcpy(block, given, 3 * (size_t)count * sizeof *given);
            rests = settle_block(surface, count, block, scale, 1);
        }
        settled &= rests;
    }
    return settled;
}

int sp_implicit_settle_end(const struct sp_surface *surface, sp_pair place[3], double scale) {
    return sp_implicit_settle(surface, 1, place, scale) || settle_block(surface, 1, place, scale, 1);
}

int sp_implicit_halve(const struct sp_surface *surface, const double from[3], const double to[3], double scale, double at[3],
                      double normal[3]) {
    sp_pair middle[3], seen[SP_IMPLICIT_VALUES];
    for (int j = 0; j < 3; j++)
        middle[j] = sp_splat(0.5 * (from[j] + to[j]));
    if (!sp_implicit_settle(surface, 1, middle, scale)) return 0;
    surface->value(1, middle, seen);
    for (int j = 0; j < 3; j++)
        at[j] = middle[j][0], normal[j] = seen[1 + j][0];
    return 1;
}

int sp_implicit_between(const struct sp_surface *surface, const double *const ends[2], const double *const normals[2], double part,
                        double scale, double at[3]) {
    double outwards[3], chord[3], width = distance_between(ends[0], ends[1]);
    for (int j = 0; j < 3; j++)
        outwards[j] = normals[0][j] + normals[1][j], chord[j] = ends[0][j] + part * (ends[1][j] - ends[0][j]);
    double rate = width / norm(outwards);
    for (int k = 0; k < TRIES; k++) {
        sp_pair place[3];
        for (int j = 0; j < 3; j++)
            place[j] = sp_splat(chord[j] + OUTWARDS[k] * rate * outwards[j]);
        int settled = sp_implicit_settle(surface, 1, place, scale);
        for (int j = 0; j < 3; j++)
            at[j] = place[j][0];
        if (settled && distance_between(chord, at) <= FARTHEST * width) return 1;
    }
    return 0;
}

int sp_implicit_is_node(const struct sp_surface *surface, const double place[3], double near, sp_pair seen[SP_IMPLICIT_VALUES]) {
    sp_pair both[3];
    for (int j = 0; j < 3; j++)
        both[j] = (sp_pair){place[j], place[j] + BESIDE[j] * near};
    surface->value(1, both, seen);
    sp_pair squared = sp_dot(sp_load(seen + 1), sp_load(seen + 1));
    double nothing = NOTHING * NOTHING * squared[1];
    return nothing > 0 && !(squared[0] > nothing) && seen[0][0] * seen[0][0] <= nothing * near * near;
}

/* X + scale B d, settled. Refused where a point lands farther than twice its step from where it was, and not only by rounding: another
 * sheet. */
static int implicit_move(const struct sp_surface *surface, int32_t pair_count, const sp_pair *places, const sp_pair *charts,
                         const sp_pair *steps, const sp_mask *straight, double scale, sp_pair *moved) {
    (void)straight;
    for (int32_t k = 0; k < pair_count; k++) {
        const sp_pair *chart = charts + SP_CHART * k;
        struct sp_vector along = sp_add(sp_scale(sp_load(chart + SP_CHART_1), scale * steps[2 * k]),
                                        sp_scale(sp_load(chart + SP_CHART_2), scale * steps[2 * k + 1]));
        sp_store(sp_add(sp_load(places + 3 * k), along), moved + 3 * k);
    }
    if (!sp_implicit_settle(surface, pair_count, moved, surface->extent)) return 0;
    int near = 1;
    for (int32_t k = 0; k < pair_count; k++) {
        struct sp_vector displacement = sp_subtract(sp_load(moved + 3 * k), sp_load(places + 3 * k)), place = sp_load(places + 3 * k);
        sp_pair u = scale * steps[2 * k], v = scale * steps[2 * k + 1], rounding = NOISE * sp_square_root(sp_dot(place, place));
        near &= !sp_any(sp_square_root(sp_dot(displacement, displacement)) > 2.0 * sp_square_root(u * u + v * v) + rounding);
    }
    return near;
}

const struct sp_kind sp_implicit_kind = {SP_IMPLICIT_INPUTS, 0, implicit_charts, implicit_move};
const struct sp_kind sp_implicit_density_kind = {SP_IMPLICIT_INPUTS, 1, implicit_charts, implicit_move};
const struct sp_kind sp_implicit_tensor_kind = {SP_IMPLICIT_INPUTS, 6, implicit_charts, implicit_move};
