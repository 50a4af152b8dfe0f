/* Distances through a graph: Dijkstra's algorithm, or A*, but that vertices whose keys are within the length of an edge of the least are
 * visited in any order. Hardly any is visited twice, and a heap takes as long as the edges. MATH.md, "The globally shortest path". */
#include "graph_search.h"
#include "scalar.h"

/* Keys are no greater; that of a vertex which does not wait to be visited is infinite. */
static const double GREATEST = 1e308;

int sp_front_take(struct sp_front *front, const struct sp_graph *graph, struct sp_arena *arena) {
    size_t vertices = (size_t)graph->vertex_count;
    *front = (struct sp_front){.graph = graph, .bound = -1, .least = __builtin_inf(), .farthest = __builtin_inf(), .flat = -2};
    front->distance = sp_arena_take(arena, vertices, SP_FRONT_BYTES);
    if (!front->distance) return 0;
    front->key = front->distance + vertices;
    front->before = (int32_t *)(front->key + vertices);
    front->near = front->before + vertices;
    front->far = front->near + vertices;
    for (size_t i = 0; i < vertices; i++)
        front->distance[i] = front->key[i] = __builtin_inf(), front->before[i] = -1;
    return 1;
}

/* To the end of the near ones, whose array goes around; a vertex is once in it. */
static void come_near(struct sp_front *front, int32_t vertex) {
    int32_t end = front->head + front->near_count++, size = front->graph->vertex_count;
    front->near[end < size ? end : end - size] = vertex;
}

void sp_front_offer(struct sp_front *front, int32_t vertex, int32_t before, double distance) {
    if (!(distance < front->distance[vertex])) return;
    const double *sample = front->graph->samples + (size_t)front->graph->width * (size_t)vertex;
    double key = front->target ? distance + front->stretch * distance_between(sample, front->target) : distance,
           waited = front->key[vertex];
    front->distance[vertex] = distance;
    front->before[vertex] = before;
    front->key[vertex] = key < GREATEST ? key : GREATEST;
    if (waited <= front->bound) return;
    if (key <= front->bound) {
        come_near(front, vertex);
        return;
    }
    if (key < front->least) front->least = key;
    if (waited > GREATEST) front->far[front->far_count++] = vertex;
}

/* Whether the surface bends too much from one vertex to another. */
static int bends(const struct sp_front *front, int32_t from, int32_t to) {
    const float *normals = front->graph->normals;
    if (front->flat < -1 || !normals) return 0;
    double cosine = 0;
    for (size_t j = 0; j < 3; j++)
        cosine += (double)normals[3 * (size_t)from + j] * (double)normals[3 * (size_t)to + j];
    return cosine < front->flat;
}

/* The first of some edges by which a vertex is nearer than it was known to be. A loop of its own, without calls, keeps all in registers. */
static const struct sp_graph_edge *find_shorter(const struct sp_front *front, const struct sp_graph_edge *edge,
                                                const struct sp_graph_edge *end, double so_far) {
    const double *distances = front->distance, *other = front->other, most = front->most, farthest = front->farthest;
    for (; edge < end; edge++) {
        double distance = so_far + (double)edge->length;
        if ((distance < farthest) & (distance < distances[edge->to]) && !(other && other[edge->to] + distance > most)) break;
    }
    return edge;
}

static void visit(struct sp_front *front, int32_t vertex) {
    const struct sp_graph *graph = front->graph;
    const struct sp_graph_edge *edge = graph->edges + graph->first[vertex], *end = graph->edges + graph->first[vertex + 1];
    double so_far = front->distance[vertex];
    for (; (edge = find_shorter(front, edge, end, so_far)) < end; edge++)
        if (!bends(front, vertex, edge->to)) sp_front_offer(front, edge->to, vertex, so_far + (double)edge->length);
}

/* Those of the far ones that are not beyond a bound come near, and those that came near by a shorter way are dropped. */
static void divide(struct sp_front *front, double bound) {
    int32_t count = 0;
    front->bound = bound;
    front->least = __builtin_inf();
    for (int32_t i = 0; i < front->far_count; i++) {
        int32_t vertex = front->far[i];
        double key = front->key[vertex];
        if (key <= bound) {
            come_near(front, vertex);
        } else if (key <= GREATEST) {
            front->far[count++] = vertex;
            front->least = key < front->least ? key : front->least;
        }
    }
    front->far_count = count;
}

void sp_front_advance(struct sp_front *front, double limit) {
    for (;;) {
        while (front->near_count > 0) {
            int32_t vertex = front->near[front->head];
            front->near_count--;
            if (++front->head == front->graph->vertex_count) front->head = 0;
            front->key[vertex] = __builtin_inf();
            visit(front, vertex);
        }
        if (!(front->least < limit)) break;
        double until = front->least + front->graph->step;
        divide(front, until < limit ? until : limit);
    }
}

double sp_front_reach(const struct sp_front *front, const struct sp_attachment *attached) {
    double best = __builtin_inf();
    for (int32_t i = 0; i < attached->count; i++) {
        double length = front->distance[attached->vertex[i]] + attached->length[i];
        best = length < best ? length : best;
    }
    return best;
}
