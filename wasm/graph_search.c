/* Ways through a graph between two points: distances from both ends, then the best vertex to go by, again and again. MATH.md, "The globally
 * shortest path". */
#include "graph_search.h"
#include "scalar.h"

/* Ways up to a quarter longer than the shortest are looked at; of those that may lead to the shortest path fewer where length is that of
 * space, or where the graph's lengths are nearly the surface's. One that keeps within a fifth of the shortest is taken for the same at
 * first, then within a tenth; in the end not on another side of an edge, across which normals turn by more than 37 degrees: a narrow rim
 * is a way of its own. */
static const double LONGEST = 1.25, LONGEST_IN_SPACE = 1.12, LONGEST_RESOLVED = 1.06, APART[] = {0.2, 0.1, 0.05}, GROWTH = 1.05,
                    ROUNDING = 1e-6, FLAT = 0.8;

/* Of a chord: edges are rounded to 24 bits, and none is shorter than what is left of its chord. */
static const double BELOW = 1 - 1e-6;

/* At first, and where the graph does not resolve the surface. */
enum { ROUNDS = 2, WAYS = 16, MOST_ROUNDS = sizeof(APART) / sizeof(APART[0]), MOST_WAYS = SP_GRAPH_MAX_CANDIDATES };

struct search {
    const struct sp_surface *surface;
    const struct sp_graph *graph;
    const double *ends[2];
    struct sp_attachment attached[2];
    struct sp_front front[2], taken;              /* distances from the ends, and from the ways already found */
    int32_t *listed, *listed_end;                 /* vertices that ways of interest lead over */
    int32_t *vertices;                            /* those of one way */
    double longest, best, target[SP_GRAPH_WIDTH]; /* ways of interest, in units of the best; its length; sample at the second end */
};

static enum sp_status attach(struct search *search) {
    enum sp_status status = SP_CONVERGED;
    for (int end = 0; end < 2 && status == SP_CONVERGED; end++)
        status = sp_graph_attach(search->surface, search->graph, search->ends[end], search->attached + end);
    return status;
}

/* Lists the vertices that ways of interest lead over, and leaves the others out of the distances from ways: as near as can be, they are
 * never offered. */
static void leave_out(struct search *search, double most) {
    int32_t *listed = search->listed;
    for (int32_t i = 0; i < search->graph->vertex_count; i++) {
        *listed = i;
        if (search->front[0].distance[i] + search->front[1].distance[i] <= most)
            listed++;
        else
            search->taken.distance[i] = -__builtin_inf();
    }
    search->listed_end = listed;
}

/* No way to the second end is shorter than its chord times this: neither edges are, nor what joins the end to them. */
static double least_stretch(const struct search *search) {
    const struct sp_graph *graph = search->graph;
    const struct sp_attachment *attached = search->attached + 1;
    double least = graph->stretch;
    for (int32_t i = 0; i < attached->count && search->surface->metric != SP_INDUCED; i++) {
        double chord = distance_between(graph->samples + (ptrdiff_t)graph->width * attached->vertex[i], search->target);
        if (attached->length[i] < least * chord) least = attached->length[i] / chord;
    }
    return BELOW * least;
}

/* Distances from both ends as far as ways of interest go. */
static enum sp_status measure(struct search *search) {
    struct sp_front *front = search->front;
    if (search->graph->stretch > 0) {
        sp_graph_sample(search->surface, search->ends[1], search->target);
        front->target = search->target, front->stretch = least_stretch(search);
    }
    for (int end = 0; end < 2; end++)
        for (int32_t i = 0; i < search->attached[end].count; i++)
            sp_front_offer(front + end, search->attached[end].vertex[i], -1, search->attached[end].length[i]);
    for (double limit = 0;;) {
        search->best = sp_front_reach(front, search->attached + 1);
        if (search->best <= limit || !(front->least < __builtin_inf())) break;
        limit = GROWTH * (limit > front->least ? limit : front->least) + 1e-300;
        sp_front_advance(front, limit);
    }
    /* Where all is visited the end may be the farthest of it. */
    if (!(search->best < __builtin_inf())) return SP_DISCONNECTED;
    double most = (search->longest + ROUNDING) * search->best;
    front[0].farthest = front[1].farthest = search->longest * search->best;
    front[1].other = front[0].distance, front[1].most = most;
    sp_front_advance(front, most);
    sp_front_advance(front + 1, front[1].farthest);
    leave_out(search, most);
    return SP_CONVERGED;
}

/* The vertex with the shortest way through it that is not near a way already found; -1: none is short enough. */
static int32_t best_via(const struct search *search, double apart) {
    double least = search->longest * search->best;
    int32_t best = -1;
    for (const int32_t *listed = search->listed; listed < search->listed_end; listed++) {
        double length = search->front[0].distance[*listed] + search->front[1].distance[*listed];
        if (!(length < least) || search->taken.distance[*listed] < apart * search->best) continue;
        least = length, best = *listed;
    }
    return best;
}

/* The vertices of the way through one, in order. */
static int32_t trace(const struct search *search, int32_t via) {
    int32_t count = 0;
    for (int32_t i = via; i >= 0; i = search->front[0].before[i])
        count++;
    for (int32_t i = via, k = count; i >= 0; i = search->front[0].before[i])
        search->vertices[--k] = i;
    for (int32_t i = search->front[1].before[via]; i >= 0 && count < 2 * search->graph->vertex_count; i = search->front[1].before[i])
        search->vertices[count++] = i;
    return count;
}

/* From now on what lies across an edge from a way that was taken is not near it. */
static void part_at_edges(struct search *search) {
    struct sp_front *taken = &search->taken;
    taken->flat = FLAT;
    taken->far_count = 0; /* none waits */
    for (const int32_t *listed = search->listed; listed < search->listed_end; listed++) {
        double distance = taken->distance[*listed];
        taken->distance[*listed] = __builtin_inf();
        if (distance == 0) sp_front_offer(taken, *listed, -1, 0);
    }
    sp_front_advance(taken, taken->farthest);
}

static enum sp_status find_ways(struct search *search, struct sp_arena *arena, struct sp_graph_answer *answer) {
    int32_t edges = search->graph->resolved ? ROUNDS : MOST_ROUNDS, most = search->graph->resolved ? WAYS : MOST_WAYS;
    int32_t rounds = edges + (search->graph->kind == SP_IMPLICIT);
    search->taken.farthest = APART[0] * search->best;
    for (int32_t found = 0, round = 0; found < most && round < rounds; found++) {
        int32_t via = best_via(search, APART[round % edges]);
        while (via < 0 && ++round < rounds) {
            search->taken.farthest = APART[round % edges] * search->best; /* what is farther is not asked for */
            if (round == edges) part_at_edges(search);
            via = best_via(search, APART[round % edges]);
        }
        if (via < 0) break;
        struct sp_way way = {search->surface, search->graph, search->ends[0], search->ends[1], search->vertices, trace(search, via)};
        enum sp_status status = sp_way_write(&way, arena, answer);
        if (status != SP_CONVERGED) return status;
        for (int32_t i = 0; i < way.count; i++)
            sp_front_offer(&search->taken, way.vertices[i], -1, 0);
        sp_front_advance(&search->taken, search->taken.farthest);
    }
    return SP_CONVERGED;
}

static int32_t clamped_points(int32_t point_count) { return clamp(point_count, 3, SP_GRAPH_MAX_POINTS); }

double sp_graph_search_bytes(const struct sp_graph *graph, int32_t point_count) {
    double front = graph->vertex_count * (double)SP_FRONT_BYTES + 16;
    double answer = SP_GRAPH_MAX_CANDIDATES * 3.0 * clamped_points(point_count) * sizeof(double) + 16;
    return 3 * front + 3.0 * graph->vertex_count * sizeof(int32_t) + 16 + answer + sp_way_bytes(graph);
}

int32_t sp_graph_search(const struct sp_surface *surface, const struct sp_graph *graph, const double ends[6], int32_t point_count,
                        int32_t all, struct sp_arena *arena, struct sp_graph_answer *answer) {
    struct search search = {.surface = surface, .graph = graph, .ends = {ends, ends + 3}};
    double longest = surface->metric == SP_INDUCED ? LONGEST_IN_SPACE : LONGEST;
    search.longest = all ? LONGEST : graph->resolved ? LONGEST_RESOLVED : longest;
    size_t places = SP_GRAPH_MAX_CANDIDATES * (size_t)clamped_points(point_count);
    arena->used = 0;
    *answer = (struct sp_graph_answer){.distance = not_a_number(), .point_count = clamped_points(point_count)};
    answer->places = sp_arena_take(arena, places, (graph->kind == SP_IMPLICIT ? 3 : 2) * sizeof(double));
    search.listed = sp_arena_take(arena, 3 * (size_t)graph->vertex_count, sizeof(int32_t));
    search.vertices = search.listed + graph->vertex_count;
    int fits = answer->places && search.listed;
    for (int end = 0; end < 2; end++)
        fits = fits && sp_front_take(search.front + end, graph, arena);
    if (!fits || !sp_front_take(&search.taken, graph, arena)) return SP_OUT_OF_MEMORY;
    enum sp_status status = attach(&search);
    if (status == SP_CONVERGED) status = measure(&search);
    if (status != SP_CONVERGED) return status;
    answer->distance = search.best;
    status = find_ways(&search, arena, answer);
    /* On a surface that is not finite everywhere there may be none that can be written down. */
    return status == SP_CONVERGED && answer->candidate_count == 0 ? SP_DISCONNECTED : status;
}
