/* Dijkstra's algorithm, or A*, with a heap of four children a parent that knows where each vertex is. */
#include "graph_search.h"
#include "scalar.h"

/* In place of a slot: visited, and not to be visited again. Keys fall along no way but by rounding, which may be more than edges are long
 * where a surface is large beside them: led by that, a search would come back for ever. */
enum { CLOSED = -2 };

/* Half as many levels as with two: 1 to 5 % of a query; eight are slower. */
enum { CHILDREN = 4 };

int sp_front_take(struct sp_front *front, const struct sp_graph *graph, struct sp_arena *arena) {
    size_t vertices = (size_t)graph->vertex_count;
    *front = (struct sp_front){.graph = graph, .farthest = __builtin_inf(), .flat = -2};
    front->distance = sp_arena_take(arena, vertices, sizeof(double));
    front->before = sp_arena_take(arena, vertices, sizeof(int32_t));
    front->heap = sp_arena_take(arena, vertices, sizeof(struct sp_queued));
    front->slot = sp_arena_take(arena, vertices, sizeof(int32_t));
    if (!front->distance || !front->before || !front->heap || !front->slot) return 0;
    for (size_t i = 0; i < vertices; i++)
        front->distance[i] = __builtin_inf(), front->before[i] = -1, front->slot[i] = -1;
    return 1;
}

static void put(struct sp_front *front, int32_t slot, struct sp_queued queued) {
    front->heap[slot] = queued;
    front->slot[queued.vertex] = slot;
}

static void rise(struct sp_front *front, int32_t slot, struct sp_queued queued) {
    while (slot > 0) {
        int32_t parent = (slot - 1) / CHILDREN;
        if (front->heap[parent].key <= queued.key) break;
        put(front, slot, front->heap[parent]);
        slot = parent;
    }
    put(front, slot, queued);
}

static void sink(struct sp_front *front, int32_t slot, struct sp_queued queued) {
    for (;;) {
        int32_t child = CHILDREN * slot + 1, end = child + CHILDREN < front->count ? child + CHILDREN : front->count;
        if (child >= end) break;
        for (int32_t i = child + 1; i < end; i++)
            if (front->heap[i].key < front->heap[child].key) child = i;
        if (queued.key <= front->heap[child].key) break;
        put(front, slot, front->heap[child]);
        slot = child;
    }
    put(front, slot, queued);
}

void sp_front_offer(struct sp_front *front, int32_t vertex, int32_t before, double distance) {
    if (!(distance < front->distance[vertex]) || front->slot[vertex] == CLOSED) return;
    front->distance[vertex] = distance;
    front->before[vertex] = before;
    const double *sample = front->graph->samples + (size_t)front->graph->width * (size_t)vertex;
    struct sp_queued queued = {front->target ? distance + front->stretch * distance_between(sample, front->target) : distance, vertex};
    rise(front, front->slot[vertex] < 0 ? front->count++ : front->slot[vertex], queued);
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

void sp_front_advance(struct sp_front *front, double limit) {
    const struct sp_graph *graph = front->graph;
    const double *distances = front->distance, *other = front->other, most = front->most, farthest = front->farthest;
    while (front->count > 0 && front->heap[0].key < limit) {
        int32_t vertex = front->heap[0].vertex;
        struct sp_queued last = front->heap[--front->count];
        front->slot[vertex] = front->target ? CLOSED : -1;
        if (front->count > 0) sink(front, 0, last);
        double so_far = distances[vertex];
        /* Most edges lead to no shorter way: asked before the call. */
        for (const struct sp_graph_edge *edge = graph->edges + graph->first[vertex], *end = graph->edges + graph->first[vertex + 1];
             edge < end; edge++) {
            double distance = so_far + (double)edge->length;
            if (!(distance < distances[edge->to]) || distance >= farthest || (other && other[edge->to] + distance > most) ||
                bends(front, vertex, edge->to))
                continue;
            sp_front_offer(front, edge->to, vertex, distance);
        }
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
