/* Where a path lies on the edges of its rectangle: nodes on them, or what leads beyond them between two nodes. MATH.md, "Arcs". */
#include "runs.h"

enum { MERGED_GAP = 2, HALVINGS = 40 /* to where a path crosses an edge */ };
/* How near to a node the slope is taken, in parts of what lies between two. */
static const double BESIDE = 1e-3;

static int lies_on(const struct sp_polyline *line, int32_t node, int32_t edge) {
    double x = sp_polyline_coordinate(line, node, edge / 2);
    return edge % 2 ? x >= line->surface->upper[edge / 2] : x <= line->surface->lower[edge / 2];
}

/* The edge on which a node lies: 2 * coordinate + side, or -1. An end in a corner lies on that of its neighbour. */
static int32_t edge_of(const struct sp_polyline *line, int32_t node) {
    int32_t last = line->fold.inner + 1, beside = node == 0 ? 1 : last - 1, found = -1;
    for (int32_t edge = 0; edge < 4; edge++)
        if (lies_on(line, node, edge) && (found < 0 || ((node == 0 || node == last) && lies_on(line, beside, edge)))) found = edge;
    return found;
}

int32_t sp_runs_find(const struct sp_system *system, int32_t lone, struct sp_run runs[SP_MAX_ARCS]) {
    const struct sp_polyline *line = &system->line;
    int32_t count = 0, kept = 0, last = line->fold.inner + 1;
    for (int32_t i = 0; i <= last; i++) {
        int32_t edge = edge_of(line, i);
        if (edge < 0) continue;
        struct sp_run *before = count ? runs + count - 1 : NULL;
        if (before && 2 * before->across + before->side == edge && i - before->last <= MERGED_GAP + 1)
            before->last = i;
        else if (count < SP_MAX_ARCS)
            runs[count++] = (struct sp_run){.first = i, .last = i, .across = edge / 2, .side = edge % 2};
    }
    for (int32_t r = 0; r < count; r++)
        if (lone || runs[r].first < runs[r].last || (runs[r].first > 0 && runs[r].first < last)) runs[kept++] = runs[r];
    for (int32_t r = 0; r < kept; r++) {
        struct sp_run *run = runs + r;
        int32_t first = run->first, end = run->last, along = 1 - run->across;
        run->from = sp_sample_parameter(&system->elements, first), run->to = sp_sample_parameter(&system->elements, end);
        run->beside[0] = sp_polyline_coordinate(line, first > 0 ? first - 1 : 0, along);
        run->beside[1] = sp_polyline_coordinate(line, end < last ? end + 1 : last, along);
        run->along[0] = 0.5 * (sp_polyline_coordinate(line, first, along) + run->beside[0]);
        run->along[1] = 0.5 * (sp_polyline_coordinate(line, end, along) + run->beside[1]);
    }
    return kept;
}

/* How far from an edge, inwards, a path is at t; and where along it. */
static double depth_at(const struct sp_system *system, const struct sp_run *edge, double t, double *along) {
    const struct sp_surface *surface = system->line.surface;
    double place[3];
    sp_sample_place(system, t, place);
    *along = place[1 - edge->across];
    return edge->side ? surface->upper[edge->across] - place[edge->across] : place[edge->across] - surface->lower[edge->across];
}

/* Where between `from`, which is inside, and `to`, which is beyond it, a path crosses an edge. */
static double crossing(const struct sp_system *system, const struct sp_run *edge, double from, double to) {
    double along;
    for (int i = 0; i < HALVINGS; i++) {
        double middle = 0.5 * (from + to);
        if (depth_at(system, edge, middle, &along) < 0)
            to = middle;
        else
            from = middle;
    }
    return to;
}

/* Whether a path goes beyond an edge between two nodes that do not: `dip` tells where. */
static int dips(const struct sp_system *system, const double depth[2], double slack, struct sp_run *dip) {
    double from = sp_sample_parameter(&system->elements, dip->first), to = sp_sample_parameter(&system->elements, dip->last),
           step = BESIDE * (to - from), along, low = from, high = to;
    if (!(depth_at(system, dip, from + step, &along) < depth[0] && depth_at(system, dip, to - step, &along) < depth[1])) return 0;
    while (high - low > step) {
        double middle = 0.5 * (low + high);
        if (depth_at(system, dip, middle - 0.25 * step, &along) < depth_at(system, dip, middle + 0.25 * step, &along))
            high = middle;
        else
            low = middle;
    }
    double lowest = 0.5 * (low + high);
    if (!(depth_at(system, dip, lowest, &along) < -slack)) return 0;
    dip->from = depth[0] > 0 ? crossing(system, dip, from, lowest) : from;
    dip->to = depth[1] > 0 ? crossing(system, dip, to, lowest) : to;
    for (int end = 0; end < 2; end++) {
        depth_at(system, dip, end ? dip->to : dip->from, dip->along + end);
        dip->beside[end] = dip->along[end];
    }
    return 1;
}

/* Puts a dip among the others, in the order of the path. Returns how many they are then. */
static int32_t insert(struct sp_run runs[SP_MAX_ARCS], int32_t count, const struct sp_run *dip) {
    if (count == SP_MAX_ARCS) return count;
    int32_t r = count;
    for (; r > 0 && runs[r - 1].first > dip->first; r--)
        runs[r] = runs[r - 1];
    runs[r] = *dip;
    return count + 1;
}

/* How far from an edge, inwards, the nodes of pair k are; the one after the middle is that before it in the other lane. */
static sp_pair depths(const struct sp_polyline *line, int32_t edge, int32_t k) {
    int32_t across = edge / 2, both = sp_fold_both(line->fold);
    sp_pair x = k > both + 1 ? sp_swap(line->nodes.places[2 * both + across]) : line->nodes.places[2 * k + across];
    return edge % 2 ? sp_splat(line->surface->upper[across]) - x : x - sp_splat(line->surface->lower[across]);
}

/* Only looked for where it comes nearer to an edge and leaves it again, and is not farther from it than its nodes are from each other. */
int32_t sp_runs_between(const struct sp_system *system, double least, struct sp_run runs[SP_MAX_ARCS]) {
    const struct sp_polyline *line = &system->line;
    const struct sp_surface *surface = line->surface;
    int32_t count = 0, both = system->elements.reference.degree > 1 ? sp_fold_both(line->fold) : -1;
    for (int32_t edge = 0; edge < 4; edge++) {
        double slack = least * (surface->upper[edge / 2] - surface->lower[edge / 2]);
        if (slack - slack != 0) continue;
        sp_pair here = depths(line, edge, 0), before = here, next = depths(line, edge, 1);
        for (int32_t k = 0; k <= both; k++) {
            sp_pair after = depths(line, edge, k + 2), apart = sp_larger(sp_absolute(next - here), sp_larger(before - here, after - next));
            sp_mask near = (sp_smaller(here, next) <= apart) & (before >= here) & (after >= next);
            for (int lane = 0; lane < 2 && sp_any(near); lane++) {
                struct sp_run dip = {.first = lane ? line->fold.inner - k : k, .across = edge / 2, .side = edge % 2};
                dip.last = dip.first + 1;
                double depth[2] = {(lane ? next : here)[lane], (lane ? here : next)[lane]};
                if (near[lane] && dips(system, depth, slack, &dip)) count = insert(runs, count, &dip);
            }
            before = here, here = next, next = after;
        }
    }
    return count;
}
