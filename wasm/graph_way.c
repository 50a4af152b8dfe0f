/* Ways over vertices made into polylines: continuous across seams, past poles on either side, evenly spaced, smoothed. */
#include "functions.h"
#include "graph_search.h"
#include "scalar.h"

#include <string.h>

enum { SWEEPS = 2, POLAR_STEPS = 8 };

/* The widest angle at which a chord passes a pole: short of half a turn, where it would meet it. */
static const double WIDEST = 0.98 * 3.141592653589793;

/* Places of a polyline that is being made. */
struct line {
    const struct sp_way *way;
    double *places; /* dimension a point */
    double *along;  /* length up to each */
    int32_t count, dimension;
};

double sp_way_bytes(const struct sp_graph *graph) {
    double points = 2.0 * graph->vertex_count + 2 + POLAR_STEPS;
    return points * 4 * sizeof(double) + 2 * 16;
}

static int take_line(struct line *line, const struct sp_way *way, struct sp_arena *arena) {
    size_t most = (size_t)way->count + 2 + POLAR_STEPS;
    line->way = way, line->count = 0, line->dimension = way->graph->kind == SP_IMPLICIT ? 3 : 2;
    line->places = sp_arena_take(arena, most, (size_t)line->dimension * sizeof(double));
    line->along = sp_arena_take(arena, most, sizeof(double));
    return line->places && line->along;
}

static void append(struct line *line, const double *place) {
    memcpy(line->places + line->dimension * line->count, place, (size_t)line->dimension * sizeof(double));
    line->count++;
}

/* A place, moved by whole periods next to the last of the line. */
static void append_lifted(struct line *line, const double *place) {
    const struct sp_graph *graph = line->way->graph;
    const double *last = line->places + line->dimension * (line->count - 1);
    double lifted[2] = {place[0], place[1]};
    if (line->dimension == 3 || line->count == 0) {
        append(line, place);
        return;
    }
    for (int j = 0; j < 2; j++) {
        if (!graph->wraps[j]) continue;
        double period = sp_graph_period(graph, j);
        lifted[j] -= period * sp_round_down((place[j] - last[j]) / period + 0.5);
    }
    append(line, lifted);
}

static void append_vertex(struct line *line, int32_t vertex) {
    const struct sp_graph *graph = line->way->graph;
    if (line->dimension == 3) {
        append(line, graph->samples + (size_t)graph->width * (size_t)vertex);
        return;
    }
    int32_t index[2] = {vertex / graph->count[1], vertex % graph->count[1]};
    double place[2] = {graph->lines[0][index[0]], graph->lines[1][index[1]]};
    append_lifted(line, place);
}

/* Is a vertex on a collapsed edge of the rectangle? Which: 0 … 3, or -1. */
static int collapsed_edge(const struct sp_graph *graph, int32_t vertex) {
    if (graph->kind != SP_PARAMETRIC) return -1;
    int32_t index[2] = {vertex / graph->count[1], vertex % graph->count[1]};
    for (int edge = 0; edge < 4; edge++)
        if (graph->collapsed[edge] && index[edge / 2] == (edge & 1 ? graph->count[edge / 2] - 1 : 0)) return edge;
    return -1;
}

/* A chord in the polar coordinates of a collapsed edge, from the last place of the line to one whose angle is `turn` away in u. */
static void append_polar(struct line *line, int edge, const double to[2], double turn) {
    const struct sp_graph *graph = line->way->graph;
    int across = edge / 2, around = 1 - across;
    double from[2] = {line->places[2 * line->count - 2], line->places[2 * line->count - 1]}, place[2];
    double pole = graph->lines[across][edge & 1 ? graph->count[across] - 1 : 0], sign = edge & 1 ? -1 : 1;
    double near = sign * (from[across] - pole), far = sign * (to[across] - pole), size = absolute(turn);
    double angle = size < WIDEST ? size : WIDEST;
    sp_pair cosine, sine = sp_sincos(sp_splat(angle), &cosine);
    for (int k = 1; k < POLAR_STEPS; k++) {
        double t = (double)k / POLAR_STEPS, x = near + t * (far * cosine[0] - near), y = t * far * sine[0];
        double fraction = angle > 1e-6 ? sp_atan2(sp_splat(y), sp_splat(x))[0] / angle : t;
        place[across] = pole + sign * root(x * x + y * y);
        place[around] = from[around] + turn * fraction;
        append(line, place);
    }
}

/* Lengths of the chords up to each place. */
static void measure(struct line *line) {
    const struct sp_surface *surface = line->way->surface;
    double samples[2][SP_GRAPH_WIDTH];
    for (int32_t i = 0; i < line->count; i++) {
        const double *place = line->places + line->dimension * i, *before = i ? place - line->dimension : place;
        double by[2] = {place[0] - before[0], place[1] - before[1]};
        sp_graph_sample(surface, place, samples[i & 1]);
        line->along[i] = i ? line->along[i - 1] + sp_graph_chord(surface, samples[~i & 1], samples[i & 1], by) : 0;
    }
}

/* Places at equal steps of length. Returns 0 if they are all finite, else NaN. */
static double resample(const struct line *line, int32_t points, double *out) {
    int32_t segment = 0, dimension = line->dimension;
    double spoilt = 0;
    for (int32_t i = 0; i < points; i++) {
        double target = line->along[line->count - 1] * ((double)i / (points - 1));
        while (segment < line->count - 2 && line->along[segment + 1] < target)
            segment++;
        double span = line->along[segment + 1] - line->along[segment], t = span > 0 ? (target - line->along[segment]) / span : 0;
        const double *a = line->places + dimension * segment, *b = a + dimension;
        for (int32_t j = 0; j < dimension; j++) {
            double at = i == points - 1 ? line->places[dimension * (line->count - 1) + j] : a[j] + t * (b[j] - a[j]);
            *out++ = at, spoilt += at - at;
        }
    }
    return spoilt;
}

/* Every place becomes the mean of itself and its neighbours. */
static void smooth(double *places, int32_t points, int32_t dimension) {
    for (int32_t j = 0; j < dimension; j++) {
        double before = places[j];
        for (int32_t i = 1; i < points - 1; i++) {
            double here = places[dimension * i + j];
            places[dimension * i + j] = 0.25 * before + 0.5 * here + 0.25 * places[dimension * (i + 1) + j];
            before = here;
        }
    }
}

/* A line that is not finite, between vertices that are, is none; be it its length, or a place between ends that are huge. */
static void emit(struct line *line, struct sp_graph_answer *answer) {
    measure(line);
    int32_t points = answer->point_count;
    double *out = answer->places + (size_t)answer->candidate_count * (size_t)(points * line->dimension);
    double sum = line->along[line->count - 1] + resample(line, points, out);
    for (int sweep = 0; sweep < SWEEPS; sweep++)
        smooth(out, points, line->dimension);
    if (is_finite(sum)) answer->candidate_count++;
}

/* The vertices [begin, end) of a way that lie on its first collapsed edge, which is returned; -1, and none at its end: there is no such
 * edge. */
static int find_run(const struct sp_way *way, int32_t *begin, int32_t *end) {
    int edge = -1;
    for (*begin = 0; *begin < way->count && edge < 0; ++*begin)
        edge = collapsed_edge(way->graph, way->vertices[*begin]);
    *end = *begin;
    if (edge < 0) return -1;
    --*begin;
    while (*end < way->count && collapsed_edge(way->graph, way->vertices[*end]) == edge)
        ++*end;
    return edge;
}

/* The line with the run of vertices on a collapsed edge replaced by a chord past it, `turns` periods more around. */
static void write_line(struct line *line, int edge, int32_t begin, int32_t end, int turns) {
    const struct sp_way *way = line->way;
    const struct sp_graph *graph = way->graph;
    append(line, way->from);
    for (int32_t i = 0; i < begin; i++)
        append_vertex(line, way->vertices[i]);
    int32_t before = line->count - 1;
    if (edge >= 0) {
        struct line next = *line;
        if (end < way->count)
            append_vertex(&next, way->vertices[end]);
        else
            append_lifted(&next, way->to);
        int around = 1 - edge / 2;
        double to[2] = {next.places[2 * before + 2], next.places[2 * before + 3]}, turn = to[around] - next.places[2 * before + around];
        double period = sp_graph_period(graph, around);
        turn += turn > 0 ? -turns * period : turns * period;
        append_polar(line, edge, to, turn);
        to[around] = line->places[2 * before + around] + turn;
        append(line, to);
        if (end == way->count) return;
        end++;
    }
    for (int32_t i = end; i < way->count; i++)
        append_vertex(line, way->vertices[i]);
    append_lifted(line, way->to);
}

enum sp_status sp_way_write(const struct sp_way *way, struct sp_arena *arena, struct sp_graph_answer *answer) {
    int32_t begin, end;
    int edge = find_run(way, &begin, &end), sides = edge >= 0 && way->graph->wraps[1 - edge / 2] ? 2 : 1;
    for (int side = 0; side < sides && answer->candidate_count < SP_GRAPH_MAX_CANDIDATES; side++) {
        size_t before = arena->used;
        struct line line;
        if (!take_line(&line, way, arena)) return SP_OUT_OF_MEMORY;
        write_line(&line, edge, begin, end, side);
        emit(&line, answer);
        arena->used = before;
    }
    return SP_CONVERGED;
}
