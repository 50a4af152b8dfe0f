/* Ends of a path that lie in a pole. MATH.md, "Starts". */
#include "ends.h"

/* An edge of the rectangle is a point where a coordinate moves it by no more than this part of what it moves the middle of the path by,
 * squared. */
static const double POINT = 1e-26;

double sp_ends_continued(const struct sp_system *system, int32_t end, int32_t j) {
    const struct sp_reference *reference = &system->elements.reference;
    int32_t p = reference->degree, last = system->line.fold.inner + 1;
    double value = 0;
    for (int32_t i = 1; i <= p; i++) {
        double weight = 1;
        for (int32_t k = 1; k <= p; k++)
            if (k != i) weight *= reference->node[k] / (reference->node[k] - reference->node[i]);
        value += weight * sp_polyline_coordinate(&system->line, end ? last - i : i, j);
    }
    return value;
}

static sp_pair squared_distance(const sp_pair *a, const sp_pair *b) {
    struct sp_vector between = sp_subtract(sp_load(a), sp_load(b));
    return sp_dot(between, between);
}

void sp_ends_turn(struct sp_system *system) {
    static const sp_pair nowhere[3];
    const struct sp_polyline *line = &system->line;
    const sp_pair *end = line->nodes.charts, *middle = end + SP_CHART * sp_fold_both(line->fold);
    /* Frames of an implicit surface, and those of u and v themselves, have length 1. */
    for (int j = 0; j < 2; j++) {
        int32_t first = SP_CHART_1 + 3 * j, second = SP_CHART_11 + 6 * j;
        sp_pair least = POINT * squared_distance(middle + first, nowhere), place[2], position[3];
        /* On a cusp only the first derivative vanishes. */
        sp_mask is_point = squared_distance(end + first, nowhere) + squared_distance(end + second, nowhere) <= least;
        if (!sp_any(is_point)) continue;
        place[1 - j] = line->nodes.places[1 - j];
        place[j] = (sp_pair){sp_ends_continued(system, 0, j), sp_ends_continued(system, 1, j)};
        sp_positions(line->surface, 1, place, position);
        is_point &= squared_distance(position, end) <= least;
        line->nodes.places[j] = sp_select(is_point, place[j], line->nodes.places[j]);
    }
}
