/* The closest point of a surface: Newton on half the squared distance, in the chart of the point so far. MATH.md, "Projection". */
#include "chart.h"
#include "scalar.h"
#include "surfpath.h"
#include <string.h>

/* From far away a step leads the n-th part of the way to where a form of degree n vanishes: so often as many as one at hand takes. */
enum { FAR = 30 };

enum { ROUNDS = 100, HALVINGS = 40 };
static const double STATIONARY = 1e-10, ROUNDING = 1e-15;

/* Distance to the target, its slope and curvature along the surface. */
struct distance {
    double squared;
    double r1, r2; /* -gradient */
    double a, b, d, e, f, g;
};

static struct distance distance_at(const sp_pair *chart, const sp_pair target[3]) {
    struct sp_vector away = sp_subtract(sp_load(chart), sp_load(target)), b1 = sp_load(chart + SP_CHART_1),
                     b2 = sp_load(chart + SP_CHART_2);
    struct distance at = {sp_dot(away, away)[0], -sp_dot(b1, away)[0], -sp_dot(b2, away)[0], 0, 0, 0,
                          sp_dot(b1, b1)[0],     sp_dot(b1, b2)[0],    sp_dot(b2, b2)[0]};
    at.a = at.e + sp_dot(away, sp_load(chart + SP_CHART_11))[0];
    at.b = at.f + sp_dot(away, sp_load(chart + SP_CHART_12))[0];
    at.d = at.g + sp_dot(away, sp_load(chart + SP_CHART_22))[0];
    return at;
}

/* The Newton step, or, where the distance is not convex, that of the first fundamental form. Coordinates in `held` stay. */
static void newton_step(struct distance at, const int held[2], sp_pair step[2]) {
    double determinant = at.a * at.d - at.b * at.b;
    if (!(determinant > 1e-12 * at.e * at.g && at.a > 0)) at.a = at.e, at.b = at.f, at.d = at.g;
    if (held[0] || held[1]) at.b = 0;
    determinant = at.a * at.d - at.b * at.b;
    double r1 = held[0] ? 0 : at.r1, r2 = held[1] ? 0 : at.r2;
    if (!(determinant > 0)) at.a = at.d = at.e + at.g, at.b = 0, determinant = at.a * at.a;
    step[0] = sp_splat(determinant > 0 ? (at.d * r1 - at.b * r2) / determinant : 0);
    step[1] = sp_splat(determinant > 0 ? (at.a * r2 - at.b * r1) / determinant : 0);
}

/* Coordinates on a wall that the way downhill leads across. */
static void find_held(const struct sp_surface *surface, const sp_pair *place, const struct distance *at, int held[2]) {
    double force[2] = {at->r1, at->r2};
    for (int j = 0; j < 2; j++)
        held[j] = surface->kind == SP_PARAMETRIC &&
                  ((place[j][0] <= surface->lower[j] && force[j] < 0) || (place[j][0] >= surface->upper[j] && force[j] > 0));
}

/* Closer; or, where the difference is lost in rounding (d^2 is flat there: half of all digits), as close and half as steep. `size`: of the
 * coordinates. */
static int is_better(const struct distance *next, const struct distance *before, double size) {
    double slack = ROUNDING * (before->squared + size * root(before->squared));
    if (next->squared < before->squared - slack) return 1;
    double steep = next->r1 * next->r1 + next->r2 * next->r2, was = before->r1 * before->r1 + before->r2 * before->r2;
    return next->squared <= before->squared + slack && steep < 0.25 * was;
}

static double size_of(const sp_pair target[3]) { return root(sp_dot(sp_load(target), sp_load(target))[0]); }

/* One step downhill. Returns 0 where none is found. */
static int go_down(const struct sp_surface *surface, const sp_pair target[3], const struct distance *before, const sp_pair *step,
                   sp_pair *place, sp_pair *chart) {
    const struct sp_kind *kind = sp_kind_of(surface);
    sp_pair moved[3], next[SP_CHART];
    sp_mask bent = {0, 0};
    double scale = 1;
    for (int i = 0; i < HALVINGS; i++, scale *= 0.5) {
        if (!kind->move(surface, 1, place, chart, step, &bent, scale, moved)) continue;
        kind->charts(surface, 1, moved, next, NULL);
        struct distance there = distance_at(next, target);
        if (!is_better(&there, before, size_of(target))) continue;
        memcpy(place, moved, (size_t)kind->dimension * sizeof(sp_pair)), memcpy(chart, next, sizeof next);
        return 1;
    }
    return 0;
}

/* The free slope relative to what it could be, |grad|/(|B| distance), or to rounding of the coordinates. */
static int is_stationary(const struct distance *at, const int held[2], const sp_pair target[3]) {
    double u = held[0] || at->e == 0 ? 0 : at->r1 / root(at->e), v = held[1] || at->g == 0 ? 0 : at->r2 / root(at->g);
    return u * u + v * v <= STATIONARY * STATIONARY * at->squared || root(u * u + v * v) <= 1e-14 * (size_of(target) + root(at->squared));
}

static int settle_from_afar(const struct sp_surface *surface, sp_pair at[3]) {
    int settled = 0;
    for (int i = 0; i < FAR && !settled; i++)
        settled = sp_implicit_settle(surface, 1, at, surface->extent);
    return settled;
}

int32_t sp_project_point(const struct sp_surface *surface, const double point[3], double place[3]) {
    const struct sp_kind *kind = sp_kind_of(surface);
    sp_pair target[3] = {sp_splat(point[0]), sp_splat(point[1]), sp_splat(point[2])};
    sp_pair at[3] = {{0}}, chart[SP_CHART], step[2];
    for (int j = 0; j < kind->dimension; j++)
        at[j] = sp_splat(place[j]);
    if (surface->kind == SP_PARAMETRIC)
        sp_parametric_clip(surface, 1, at);
    else if (!settle_from_afar(surface, at))
        return SP_OFF_SURFACE;
    kind->charts(surface, 1, at, chart, NULL);
    struct distance here = distance_at(chart, target);
    if (!is_finite(here.squared)) return SP_NOT_FINITE;
    int held[2];
    for (int i = 0; find_held(surface, at, &here, held), i < ROUNDS; i++) {
        newton_step(here, held, step);
        if (!go_down(surface, target, &here, step, at, chart)) break;
        here = distance_at(chart, target);
    }
    for (int j = 0; j < kind->dimension; j++)
        if (!is_finite(at[j][0])) return SP_NOT_FINITE;
    for (int j = 0; j < kind->dimension; j++)
        place[j] = at[j][0];
    return is_stationary(&here, held, target) ? SP_CONVERGED : SP_STALLED;
}
