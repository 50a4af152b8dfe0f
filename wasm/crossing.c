/* Finds and corrects points of a cuspidal edge, by bisection and Newton. MATH.md, "Arcs". */
#include "crossing.h"
#include "chart.h"
#include "normal.h"
#include "scalar.h"
#include <stddef.h>

enum { BISECTIONS = 60, CORRECTIONS = 20 };

struct sp_curve sp_curve_at(const struct sp_surface *surface, const double place[2], double nu[3], int choose) {
    sp_pair at[2] = {sp_splat(place[0]), sp_splat(place[1])}, chart[SP_CHART];
    sp_parametric_kind.charts(surface, 1, at, chart, NULL);
    struct sp_vector u = sp_load(chart + SP_CHART_1), v = sp_load(chart + SP_CHART_2), uu = sp_load(chart + SP_CHART_11),
                     uv = sp_load(chart + SP_CHART_12), vv = sp_load(chart + SP_CHART_22), n = sp_cross(u, v);
    struct sp_vector slopes[2] = {sp_add(sp_cross(uu, v), sp_cross(u, uv)), sp_add(sp_cross(uv, v), sp_cross(u, vv))};
    if (choose) {
        struct sp_vector longer = sp_dot(slopes[0], slopes[0])[0] > sp_dot(slopes[1], slopes[1])[0] ? slopes[0] : slopes[1];
        sp_pair unit[3];
        sp_store(sp_scale(longer, 1.0 / sp_square_root(sp_dot(longer, longer))), unit);
        for (int j = 0; j < 3; j++)
            nu[j] = unit[j][0];
    }
    struct sp_vector direction = {sp_splat(nu[0]), sp_splat(nu[1]), sp_splat(nu[2])};
    return (struct sp_curve){sp_dot(n, direction)[0], {sp_dot(slopes[0], direction)[0], sp_dot(slopes[1], direction)[0]}};
}

int sp_crossing_correct(const struct sp_surface *surface, struct sp_crossing *crossing) {
    int32_t other = 1 - crossing->along;
    for (int round = 0; round < CORRECTIONS; round++) {
        struct sp_curve at = sp_curve_at(surface, crossing->place, crossing->nu, 0);
        double step = at.value / at.slope[other], size = absolute(crossing->place[other]) + absolute(crossing->place[crossing->along]);
        if (!is_finite(step)) return 0;
        crossing->place[other] -= step;
        if (absolute(step) <= 1e-15 * size || step == 0) return 1;
    }
    return 0;
}

int sp_crossing_find(const struct sp_surface *surface, const double from[2], const double to[2], struct sp_crossing *crossing) {
    struct sp_turn turn;
    if (!sp_normal_turn(surface, from, to, BISECTIONS, &turn) || !sp_normal_vanishes(&turn)) return 0;
    crossing->place[0] = turn.place[0], crossing->place[1] = turn.place[1];
    struct sp_curve at = sp_curve_at(surface, crossing->place, crossing->nu, 1);
    crossing->along = absolute(at.slope[1]) >= absolute(at.slope[0]) ? 0 : 1;
    return sp_crossing_correct(surface, crossing);
}
