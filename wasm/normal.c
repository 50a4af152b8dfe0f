/* Normals of parametric surfaces: see the header. */
#include "normal.h"
#include "metric.h"
#include "scalar.h"

static const double VANISHING = 1e-8;

void sp_normal_at(const struct sp_surface *surface, const double place[2], double normal[3]) {
    sp_pair at[2] = {sp_splat(place[0]), sp_splat(place[1])}, chart[SP_CHART], metric[SP_METRIC_LARGEST];
    sp_kind_of(surface)->charts(surface, 1, at, chart, metric);
    struct sp_vector both = sp_chart_normal(chart);
    normal[0] = both.x[0], normal[1] = both.y[0], normal[2] = both.z[0];
}

int sp_normal_turn(const struct sp_surface *surface, const double from[2], const double to[2], int rounds, struct sp_turn *turn) {
    double low = 0, high = 1, first[3], last[3];
    sp_normal_at(surface, from, first), sp_normal_at(surface, to, last);
    if (!(dot(first, last) < 0)) return 0;
    turn->largest = larger(dot(first, first), dot(last, last));
    turn->least = smaller(dot(first, first), dot(last, last));
    for (int i = 0; i < rounds; i++) {
        double t = 0.5 * (low + high), squared;
        for (int j = 0; j < 2; j++)
            turn->place[j] = from[j] + t * (to[j] - from[j]);
        sp_normal_at(surface, turn->place, turn->normal);
        squared = dot(turn->normal, turn->normal);
        if (squared < turn->least) turn->least = squared;
        if (dot(turn->normal, first) > 0)
            low = t;
        else
            high = t;
    }
    return 1;
}

int sp_normal_vanishes(const struct sp_turn *turn) { return root(turn->least) <= VANISHING * root(turn->largest); }

int32_t sp_normal_turns(const struct sp_polyline *line, int32_t first) {
    const sp_pair *charts = line->nodes.charts;
    int32_t turns = 0, last = sp_fold_both(line->fold);
    struct sp_vector to = sp_chart_normal(charts + SP_CHART * first);
    for (int32_t k = first; k <= last; k++) {
        struct sp_vector from = to;
        to = sp_chart_normal(charts + SP_CHART * (k + 1));
        sp_pair product = sp_dot(from, to);
        turns += (product[0] < 0) + ((k < last || sp_fold_odd(line->fold)) && product[1] < 0);
    }
    return turns;
}
