/* Places between the vertices of a graph: which vertices are around them, and how far. Knows nothing of ways. */
#include "graph_search.h"

enum { PATCH = 4 };

/* The place in its period that lies in the rectangle. */
static double reduce(const struct sp_graph *graph, int direction, double x) {
    if (!graph->wraps[direction]) return x;
    double turns = (x - graph->lower[direction]) / (graph->step[direction] * graph->count[direction]);
    return x - sp_round_down(turns) * (graph->step[direction] * graph->count[direction]);
}

/* The length over the middle of a parameter segment; infinite if a curve where the normal vanishes lies between. */
static double middle_length(const struct sp_surface *surface, const struct sp_graph *graph, const double place[2], const double vertex[2],
                            const double position[3]) {
    double middle[2] = {0.5 * (place[0] + vertex[0]), 0.5 * (place[1] + vertex[1])}, from[3], over[3];
    if (graph->singular && sp_graph_crosses(surface, place, vertex)) return __builtin_inf();
    sp_graph_position(surface, place, from);
    sp_graph_position(surface, middle, over);
    return sp_distance3(from, over) + sp_distance3(over, position);
}

/* The cell of the grid that holds a place of the rectangle. */
static int32_t cell_of(const struct sp_graph *graph, int direction, double x) {
    double cell = (x - graph->lower[direction]) / graph->step[direction];
    return !(cell > 0) ? 0 : cell < graph->count[direction] ? (int32_t)cell : graph->count[direction] - 1;
}

/* The 4 x 4 vertices around a place of the rectangle. */
static void attach_parametric(const struct sp_surface *surface, const struct sp_graph *graph, const double *end,
                              struct sp_attachment *attached) {
    double place[2] = {reduce(graph, 0, end[0]), reduce(graph, 1, end[1])};
    int32_t corner[2];
    for (int j = 0; j < 2; j++)
        corner[j] = cell_of(graph, j, place[j]) - (PATCH / 2 - 1);
    for (int32_t k = 0; k < PATCH * PATCH; k++) {
        int32_t at[2] = {corner[0] + k / PATCH, corner[1] + k % PATCH}, index[2];
        double vertex[2] = {graph->lower[0] + graph->step[0] * at[0], graph->lower[1] + graph->step[1] * at[1]};
        int inside = 1;
        for (int j = 0; j < 2; j++) {
            index[j] = graph->wraps[j] ? (at[j] + graph->count[j]) % graph->count[j] : at[j];
            inside &= index[j] >= 0 && index[j] < graph->count[j];
        }
        if (!inside) continue;
        int32_t number = index[0] * graph->count[1] + index[1];
        double length = middle_length(surface, graph, place, vertex, graph->positions + 3 * (size_t)number);
        if (!sp_is_finite(length)) continue;
        attached->vertex[attached->count] = number, attached->length[attached->count++] = length;
    }
}

/* The unit normal of an implicit surface. */
static void implicit_normal(const struct sp_surface *surface, const double place[3], double normal[3]) {
    struct sp_block block;
    sp_block_open(&block, SP_IMPLICIT_INPUTS, SP_IMPLICIT_VALUES);
    sp_block_put(&block, place);
    sp_block_evaluate(&block, surface->value);
    for (int32_t c = 0; c < 3; c++)
        normal[c] = sp_block_get(&block, 0, 1 + c);
    double size = sp_root(sp_dot3(normal, normal));
    for (int c = 0; c < 3; c++)
        normal[c] /= size;
}

/* The vertices within one and a half cell diagonals, on the same sheet. */
static void attach_implicit(const struct sp_surface *surface, const struct sp_graph *graph, const double *end,
                            const struct sp_candidates *among, struct sp_attachment *attached) {
    double normal[3], other[3];
    implicit_normal(surface, end, normal);
    int32_t count = among ? among->count : graph->vertex_count;
    for (int32_t k = 0; k < count && attached->count < SP_MAX_ATTACHED; k++) {
        int32_t i = among ? among->vertices[k] : k;
        const double *position = graph->positions + 3 * (size_t)i;
        if (!(sp_distance3(position, end) <= SP_ATTACHED_NEAR * graph->spacing)) continue;
        for (int c = 0; c < 3; c++)
            other[c] = (double)graph->normals[3 * (size_t)i + (size_t)c];
        double length = sp_graph_sheet_length(end, normal, position, other);
        if (!sp_is_finite(length)) continue;
        attached->vertex[attached->count] = i, attached->length[attached->count++] = length;
    }
}

enum sp_status sp_graph_attach(const struct sp_surface *surface, const struct sp_graph *graph, const double *place,
                               const struct sp_candidates *among, struct sp_attachment *attached) {
    attached->count = 0;
    for (int j = 0; j < (graph->kind == SP_IMPLICIT ? 3 : 2); j++)
        if (!sp_is_finite(place[j])) return SP_NOT_FINITE;
    if (graph->kind == SP_IMPLICIT)
        attach_implicit(surface, graph, place, among, attached);
    else
        attach_parametric(surface, graph, place, attached);
    return attached->count == 0 ? SP_OFF_SURFACE : SP_CONVERGED;
}

double sp_graph_near_length(const struct sp_surface *surface, const struct sp_graph *graph, const double *from, const double *to) {
    if (graph->kind == SP_IMPLICIT) {
        double normal[2][3];
        if (!(sp_distance3(from, to) <= SP_ATTACHED_NEAR * graph->spacing)) return __builtin_inf();
        implicit_normal(surface, from, normal[0]);
        implicit_normal(surface, to, normal[1]);
        return sp_graph_sheet_length(from, normal[0], to, normal[1]);
    }
    double near[2], position[3];
    for (int j = 0; j < 2; j++) {
        double period = graph->wraps[j] ? graph->step[j] * graph->count[j] : 0, away = to[j] - from[j];
        if (period > 0) away -= period * sp_round_down(away / period + 0.5);
        if (!(away * away <= graph->step[j] * graph->step[j] * PATCH * PATCH / 4)) return __builtin_inf();
        near[j] = from[j] + away;
    }
    sp_graph_position(surface, near, position);
    return middle_length(surface, graph, from, near, position);
}
