/* The right-hand side of tracing, from the chart of a point: q'' = -Gamma(q', q') on parametric surfaces, on implicit ones the curve's
 * normal curvature, X'' = -(X' f'' X') grad f / |grad f|^2; and the Gaussian curvature. MATH.md, "Tracing". One point at a time: both
 * lanes of a chart are the same. */
#include "flow.h"

struct vector3 {
    double x, y, z;
};

static int is_finite(double x) { return x - x == 0; }
static struct vector3 read(const double at[3]) { return (struct vector3){at[0], at[1], at[2]}; }
static struct vector3 load(const sp_pair *at) { return (struct vector3){at[0][0], at[1][0], at[2][0]}; }
static void store(struct vector3 a, double at[3]) { at[0] = a.x, at[1] = a.y, at[2] = a.z; }
static double dot(struct vector3 a, struct vector3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static double length_of(struct vector3 a) { return sp_square_root(sp_splat(dot(a, a)))[0]; }
static struct vector3 add(struct vector3 a, struct vector3 b) { return (struct vector3){a.x + b.x, a.y + b.y, a.z + b.z}; }
static struct vector3 scale_by(double by, struct vector3 a) { return (struct vector3){by * a.x, by * a.y, by * a.z}; }
static struct vector3 cross(struct vector3 a, struct vector3 b) {
    return (struct vector3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/* The vector of space that two coordinates of the chart mean. */
static struct vector3 along(const sp_pair *chart, double i, double j) {
    return add(scale_by(i, load(chart + SP_CHART_1)), scale_by(j, load(chart + SP_CHART_2)));
}

/* The second derivatives of the chart in a direction, or, of two directions, what is linear in both. */
static struct vector3 bend(const sp_pair *chart, double ii, double ij, double jj) {
    struct vector3 first = scale_by(ii, load(chart + SP_CHART_11)), last = scale_by(jj, load(chart + SP_CHART_22));
    return add(add(first, last), scale_by(ij, load(chart + SP_CHART_12)));
}

/* K is the determinant of the second fundamental form over that of the first; Gamma what of the acceleration lies along S_u and S_v. */
static void slope_from(int implicit, const sp_pair *chart, const double *state, double *slope) {
    struct vector3 s_1 = load(chart + SP_CHART_1), s_2 = load(chart + SP_CHART_2), normal = cross(s_1, s_2);
    struct vector3 dual = scale_by(1 / dot(normal, normal), normal), velocity = read(state + SP_VELOCITY);
    double i = implicit ? dot(s_1, velocity) : velocity.x, j = implicit ? dot(s_2, velocity) : velocity.y;
    struct vector3 second = bend(chart, i * i, 2 * i * j, j * j);
    double b_11 = dot(load(chart + SP_CHART_11), dual), b_12 = dot(load(chart + SP_CHART_12), dual),
           b_22 = dot(load(chart + SP_CHART_22), dual), curvature = b_11 * b_22 - b_12 * b_12;
    if (!implicit) second = (struct vector3){dot(cross(s_2, second), dual), dot(cross(second, s_1), dual), 0};
    store(velocity, slope + SP_PLACE);
    store(second, slope + SP_VELOCITY);
    for (int k = 0; k < 2; k++) {
        slope[SP_FIELDS + k] = state[SP_FIELD_SLOPES + k];
        slope[SP_FIELD_SLOPES + k] = -curvature * state[SP_FIELDS + k];
    }
}

static void find_chart(const struct sp_surface *surface, const double *state, sp_pair *chart) {
    sp_pair place[3] = {sp_splat(state[0]), sp_splat(state[1]), sp_splat(state[2])};
    sp_kind_of(surface)->charts(surface, 1, place, chart, 0);
}

static void find_slope(const void *context, const double *state, double *slope) {
    const struct sp_surface *surface = context;
    sp_pair chart[SP_CHART];
    find_chart(surface, state, chart);
    slope_from(surface->kind == SP_IMPLICIT, chart, state, slope);
}

struct sp_system sp_flow_system(const struct sp_surface *surface) {
    return (struct sp_system){find_slope, surface};
}

static int settle(const struct sp_surface *surface, double scale, double *state) {
    sp_pair place[3] = {sp_splat(state[0]), sp_splat(state[1]), sp_splat(state[2])};
    int settled = sp_implicit_settle(surface, 1, place, scale);
    store(load(place), state);
    return settled;
}

struct sp_deviation sp_flow_measure(const struct sp_surface *surface, const struct sp_traveller *traveller, const double *change) {
    if (surface->kind == SP_IMPLICIT) return (struct sp_deviation){length_of(read(change)), length_of(read(change + SP_VELOCITY))};
    const double *velocity = traveller->state + SP_VELOCITY, *turn = change + SP_VELOCITY;
    double i = change[0], j = change[1];
    struct vector3 bent = bend(traveller->chart, i * velocity[0], i * velocity[1] + j * velocity[0], j * velocity[1]);
    return (struct sp_deviation){length_of(along(traveller->chart, i, j)), length_of(add(bent, along(traveller->chart, turn[0], turn[1])))};
}

double sp_flow_area(const struct sp_surface *surface, const struct sp_traveller *traveller) {
    const sp_pair *chart = traveller->chart;
    if (surface->kind != SP_IMPLICIT) return length_of(cross(load(chart + SP_CHART_1), load(chart + SP_CHART_2)));
    sp_pair values[SP_IMPLICIT_VALUES];
    surface->value(1, chart + SP_CHART_X, values);
    return length_of(load(values + 1));
}

/* An epsilon of each coordinate, and of the velocity. */
static struct sp_deviation find_rounding(const struct sp_surface *surface, const struct sp_traveller *traveller) {
    struct sp_deviation sum = {length_of(load(traveller->chart)), 1};
    for (int j = 0; j < 2 && surface->kind != SP_IMPLICIT; j++) {
        double change[SP_STATE] = {0};
        change[SP_PLACE + j] = traveller->state[SP_PLACE + j];
        struct sp_deviation part = sp_flow_measure(surface, traveller, change);
        sum.position += part.position, sum.direction += part.direction;
    }
    return sum;
}

enum sp_status sp_flow_arrive(const struct sp_surface *surface, double scale, struct sp_traveller *traveller, double *speed) {
    int implicit = surface->kind == SP_IMPLICIT;
    double *state = traveller->state, *velocity = state + SP_VELOCITY;
    const sp_pair *chart = traveller->chart;
    if (implicit && !settle(surface, scale, state)) return SP_OFF_SURFACE;
    find_chart(surface, state, traveller->chart);
    struct vector3 s_1 = load(chart + SP_CHART_1), s_2 = load(chart + SP_CHART_2), normal = cross(s_1, s_2);
    double i = implicit ? dot(s_1, read(velocity)) : velocity[0], j = implicit ? dot(s_2, read(velocity)) : velocity[1];
    struct vector3 tangent = along(chart, i, j);
    double area = length_of(normal);
    *speed = length_of(tangent);
    if (!is_finite(*speed + area)) return SP_NOT_FINITE;
    if (!(*speed > 0 && area > 0)) return SP_SINGULAR_METRIC;
    store(scale_by(1 / area, normal), traveller->normal);
    store(scale_by(1 / *speed, implicit ? tangent : read(velocity)), velocity);
    state[SP_FIELDS] = state[SP_FIELD_SLOPES + 1] = 1, state[SP_FIELDS + 1] = state[SP_FIELD_SLOPES] = 0;
    slope_from(implicit, chart, state, traveller->slope);
    traveller->rounding = find_rounding(surface, traveller);
    return is_finite(traveller->rounding.position + traveller->rounding.direction) ? SP_CONVERGED : SP_NOT_FINITE;
}
