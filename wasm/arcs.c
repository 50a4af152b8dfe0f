/* Lists of arcs: lengths of pieces of edges, and points at equal steps along all of them. MATH.md, "Arcs". */
#include "arcs.h"
#include "sample.h"

enum { PANELS = 64, EDGE_DEGREE = 16 };

static double root(double x) { return sp_square_root(sp_splat(x))[0]; }
static double absolute(double x) { return x < 0 ? -x : x; }
static double smaller(double a, double b) { return a < b ? a : b; }

/* |S_t| at a place of an edge. */
static double edge_speed_at(const struct sp_surface *surface, const struct sp_arc *arc, double t) {
    sp_pair place[2], chart[SP_CHART];
    place[arc->across] = sp_splat(arc->value), place[1 - arc->across] = sp_splat(t);
    sp_parametric_kind.charts(surface, 1, place, chart, NULL);
    struct sp_vector along = sp_load(chart + (arc->across ? SP_CHART_1 : SP_CHART_2));
    return root(sp_dot(along, along)[0]);
}

/* Length of an edge arc from its start to `to`: Gauss–Lobatto panels, doubled until they agree. */
static double edge_length(const struct sp_surface *surface, const struct sp_arc *arc, const struct sp_reference *reference, double to) {
    double last = -1, span = to - arc->ends[0];
    for (int32_t panels = 1; panels <= PANELS; panels *= 2) {
        double sum = 0;
        for (int32_t k = 0; k < panels; k++)
            for (int32_t i = 0; i <= reference->degree; i++)
                sum += reference->weight[i] * edge_speed_at(surface, arc, arc->ends[0] + span * (k + reference->node[i]) / panels);
        sum *= absolute(span) / panels;
        if (absolute(sum - last) <= 1e-15 * sum) return sum;
        last = sum;
    }
    return last;
}

double sp_arcs_measure(struct sp_arcs *arcs, const struct sp_surface *surface, struct sp_arena *arena) {
    struct sp_reference reference;
    if (!sp_reference_make(&reference, EDGE_DEGREE, arena)) return __builtin_nan("");
    double length = 0;
    for (int32_t i = 0; i < arcs->count; i++) {
        struct sp_arc *arc = arcs->arc + i;
        arc->system.line.surface = surface;
        if (arc->on_edge) arc->length = edge_length(surface, arc, &reference, arc->ends[1]);
        length += arc->length;
    }
    return length;
}

/* The coordinate along an edge arc that is `distance` further than `from`. */
static double walk_edge(const struct sp_surface *surface, const struct sp_arc *arc, const struct sp_reference *reference, double from,
                        double distance) {
    double direction = arc->ends[1] < arc->ends[0] ? -1 : 1, to = from;
    struct sp_arc rest = *arc;
    rest.ends[0] = from;
    for (int round = 0; round < 4; round++) {
        double missing = distance - edge_length(surface, &rest, reference, to);
        to += direction * missing / edge_speed_at(surface, arc, to);
    }
    return to;
}

/* The first or last place of an arc, exactly. */
static void arc_end(const struct sp_arc *arc, int end, double place[3]) {
    if (arc->on_edge) {
        place[arc->across] = arc->value, place[1 - arc->across] = arc->ends[end];
        return;
    }
    const struct sp_polyline *line = &arc->system.line;
    for (int32_t j = 0; j < 2; j++)
        place[j] = sp_fold_get(line->fold, line->nodes.places, 2, end != arc->reversed ? line->fold.inner + 1 : 0, j);
}

int sp_arcs_sample(const struct sp_arcs *arcs, const struct sp_surface *surface, double scale, int32_t point_count, double *points,
                   double *parameters, struct sp_arena *arena) {
    struct sp_reference reference;
    if (!sp_reference_make(&reference, EDGE_DEGREE, arena)) return 0;
    double total = 0, behind = 0, edge = 0, edge_at = 0;
    for (int32_t i = 0; i < arcs->count; i++)
        total += arcs->arc[i].length;
    for (int32_t i = 0, a = 0, entered = -1; i <= point_count + 1; i++) {
        double target = total * i / (point_count + 1), place[3] = {0};
        while (a < arcs->count - 1 && target > behind + arcs->arc[a].length)
            behind += arcs->arc[a++].length;
        const struct sp_arc *arc = arcs->arc + a;
        if (arc->on_edge) {
            if (entered != a) edge = arc->ends[0], edge_at = 0, entered = a;
            double along = smaller(target - behind, arc->length);
            edge = walk_edge(surface, arc, &reference, edge, along - edge_at), edge_at = along;
            place[arc->across] = arc->value, place[1 - arc->across] = edge;
        } else {
            double t = smaller((target - behind) / arc->length, 1);
            sp_sample_place(&arc->system, arc->reversed ? 1 - t : t, place);
        }
        if (i == 0 || i == point_count + 1) arc_end(arcs->arc + (i ? arcs->count - 1 : 0), i > 0, place);
        sp_sample_point(surface, scale, place, points + 3 * i, parameters + 2 * i);
    }
    return 1;
}

double sp_arcs_bytes(void) {
    double pairs = SP_REFINE_INNER / 2 + 3, stored = 2 * pairs * sizeof(sp_pair) + 2 * (SP_MAX_DEGREE + 1) * sizeof(double) + 3 * 16;
    return (SP_MAX_ARCS + 2) * stored + 2 * sp_reference_bytes(EDGE_DEGREE);
}
