/* The right-hand side of tracing, from the geometry at a point: in its chart w' = -Gamma(w, w), on implicit surfaces in space X'' = S_ab
 * w_a w_b
 * + B_a w_a'; and the Gaussian curvature. MATH.md, "Tracing". One point at a time: both lanes of a chart are the same. */
#include "flow.h"
#include "scalar.h"

static void find_point(const struct sp_surface *surface, const double *state, struct sp_point *point) {
    sp_pair place[3] = {sp_splat(state[0]), sp_splat(state[1]), sp_splat(state[2])};
    sp_metric_point(surface, place, point);
}

/* The coordinates of a velocity in the chart. */
static void velocity_in(const struct sp_surface *surface, const sp_pair *chart, const double *velocity, sp_pair w[2]) {
    struct sp_vector space = {sp_splat(velocity[0]), sp_splat(velocity[1]), sp_splat(velocity[2])};
    int implicit = surface->kind == SP_IMPLICIT;
    for (int a = 0; a < 2; a++)
        w[a] = implicit ? sp_dot(sp_load(chart + SP_CHART_1 + 3 * a), space) : sp_splat(velocity[a]);
}

/* The vector of space that two coordinates of the chart mean. */
static struct sp_vector along(const sp_pair *chart, const sp_pair w[2]) {
    return sp_add(sp_scale(sp_load(chart + SP_CHART_1), w[0]), sp_scale(sp_load(chart + SP_CHART_2), w[1]));
}

/* Gamma_c,ab x_a y_b. */
static void turning(const struct sp_geometry *geometry, const sp_pair x[2], const sp_pair y[2], sp_pair turn[2]) {
    for (int c = 0; c < 2; c++)
        turn[c] =
            geometry->gamma[0][c] * x[0] * y[0] + geometry->gamma[1][c] * (x[0] * y[1] + x[1] * y[0]) + geometry->gamma[2][c] * x[1] * y[1];
}

static void store(const sp_pair a[3], double at[3]) {
    for (int j = 0; j < 3; j++)
        at[j] = a[j][0];
}

static void slope_at(const struct sp_surface *surface, const struct sp_point *point, const double *state, double *slope) {
    static const sp_pair AXES[2][2] = {{{1, 1}, {0, 0}}, {{0, 0}, {1, 1}}};
    const sp_pair *chart = point->chart;
    sp_pair w[2], turn[2], change[2];
    velocity_in(surface, chart, state + SP_VELOCITY, w);
    turning(&point->geometry, w, w, turn);
    for (int a = 0; a < 2; a++)
        change[a] = -sp_geometry_raise(&point->geometry, AXES[a], turn);
    sp_pair second[3] = {change[0], change[1], sp_splat(0.0)};
    if (surface->kind == SP_IMPLICIT) {
        struct sp_vector sum = along(chart, change);
        for (int ab = 0; ab < 3; ab++)
            sum = sp_add(sum, sp_scale(sp_load(chart + SP_CHART_11 + 3 * ab), (ab == 1 ? 2.0 : 1.0) * w[ab / 2] * w[(ab + 1) / 2]));
        sp_store(sum, second);
    }
    store(second, slope + SP_VELOCITY);
    for (int j = 0; j < 3; j++)
        slope[SP_PLACE + j] = state[SP_VELOCITY + j];
    for (int k = 0; k < 2; k++) {
        slope[SP_FIELDS + k] = state[SP_FIELD_SLOPES + k];
        slope[SP_FIELD_SLOPES + k] = -point->geometry.curvature[0] * state[SP_FIELDS + k];
    }
}

static void find_slope(const void *context, const double *state, double *slope) {
    const struct sp_surface *surface = context;
    struct sp_point point;
    find_point(surface, state, &point);
    slope_at(surface, &point, state, slope);
}

struct sp_ode sp_flow_ode(const struct sp_surface *surface) {
    return (struct sp_ode){find_slope, surface};
}

static int settle(const struct sp_surface *surface, double scale, double *state) {
    sp_pair place[3] = {sp_splat(state[0]), sp_splat(state[1]), sp_splat(state[2])};
    int settled = sp_implicit_settle(surface, 1, place, scale);
    store(place, state);
    return settled;
}

/* The length of a vector of space in the metric. */
static double length_of(const struct sp_point *point, const double *vector) {
    sp_pair v[3] = {sp_splat(vector[0]), sp_splat(vector[1]), sp_splat(vector[2])};
    return root(sp_metric_product(point->components, point->metric, v, v)[0]);
}

/* What it is at most, whichever way it points: beside the surface a metric need not be one. */
static double most_of(const struct sp_point *point, const double *vector) {
    sp_pair metric[SP_METRIC_COMPONENTS], v[3];
    for (int32_t c = 0; c < point->components; c++)
        metric[c] = sp_absolute(point->metric[c]);
    for (int j = 0; j < 3; j++)
        v[j] = sp_splat(absolute(vector[j]));
    return root(sp_metric_product(point->components, metric, v, v)[0]);
}

struct sp_deviation sp_flow_measure(const struct sp_surface *surface, const struct sp_traveller *traveller, const double *change) {
    const struct sp_point *point = &traveller->point;
    const struct sp_form form = point->geometry.form;
    if (surface->kind == SP_IMPLICIT) return (struct sp_deviation){most_of(point, change), most_of(point, change + SP_VELOCITY)};
    const double *velocity = traveller->state + SP_VELOCITY, *slope = change + SP_VELOCITY;
    sp_pair by[2] = {sp_splat(change[0]), sp_splat(change[1])}, w[2] = {sp_splat(velocity[0]), sp_splat(velocity[1])}, turn[2];
    turning(&point->geometry, w, by, turn);
    turn[0] += form.e * slope[0] + form.f * slope[1];
    turn[1] += form.f * slope[0] + form.g * slope[1];
    sp_pair square = form.e * by[0] * by[0] + 2.0 * form.f * by[0] * by[1] + form.g * by[1] * by[1];
    return (struct sp_deviation){root(square[0]), root(sp_geometry_raise(&point->geometry, turn, turn)[0])};
}

double sp_flow_area(const struct sp_surface *surface, const struct sp_traveller *traveller) {
    sp_pair values[SP_IMPLICIT_VALUES];
    if (surface->kind != SP_IMPLICIT) return root(traveller->point.geometry.determinant[0]);
    surface->value(1, traveller->point.chart + SP_CHART_X, values);
    return root(sp_dot(sp_load(values + 1), sp_load(values + 1))[0]);
}

/* An epsilon of each coordinate, and of the velocity. */
static struct sp_deviation find_rounding(const struct sp_surface *surface, const struct sp_traveller *traveller) {
    double place[3];
    store(traveller->point.chart + SP_CHART_X, place);
    struct sp_deviation sum = {most_of(&traveller->point, place), 1};
    for (int j = 0; j < 2 && surface->kind != SP_IMPLICIT; j++) {
        double change[SP_STATE] = {0};
        change[SP_PLACE + j] = traveller->state[SP_PLACE + j];
        struct sp_deviation part = sp_flow_measure(surface, traveller, change);
        sum.position += part.position, sum.direction += part.direction;
    }
    return sum;
}

enum sp_status sp_flow_arrive(const struct sp_surface *surface, double scale, struct sp_traveller *traveller, double *speed) {
    double *state = traveller->state, *velocity = state + SP_VELOCITY, vector[3];
    struct sp_point *point = &traveller->point;
    struct sp_form form;
    sp_pair w[2], stored[3];
    if (surface->kind == SP_IMPLICIT && !settle(surface, scale, state)) return SP_OFF_SURFACE;
    find_point(surface, state, point);
    form = point->geometry.form;
    velocity_in(surface, point->chart, velocity, w);
    struct sp_vector tangent = along(point->chart, w), normal = sp_chart_normal(point->chart);
    sp_store(tangent, stored);
    if (surface->kind == SP_IMPLICIT) store(stored, velocity);
    store(stored, vector);
    double length = length_of(point, vector), determinant = point->geometry.determinant[0];
    *speed = root(sp_dot(tangent, tangent)[0]);
    if (!is_finite(form.e[0] + determinant + *speed)) return SP_NOT_FINITE;
    if (!(length > 0 && determinant > 0)) return SP_SINGULAR_METRIC;
    sp_store(sp_scale(normal, 1.0 / sp_square_root(sp_dot(normal, normal))), stored);
    store(stored, traveller->normal);
    for (int j = 0; j < 3; j++)
        velocity[j] /= length;
    state[SP_FIELDS] = state[SP_FIELD_SLOPES + 1] = 1, state[SP_FIELDS + 1] = state[SP_FIELD_SLOPES] = 0;
    slope_at(surface, point, state, traveller->slope);
    traveller->rounding = find_rounding(surface, traveller);
    return is_finite(traveller->rounding.position + traveller->rounding.direction) ? SP_CONVERGED : SP_NOT_FINITE;
}
