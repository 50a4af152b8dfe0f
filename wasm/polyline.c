/* Nodes of a path written where folding puts them, and put onto the surface. */
#include "polyline.h"

void sp_polyline_put(const struct sp_polyline *line, int32_t i, int32_t j, double x) {
    sp_pair *place = line->nodes.places + line->kind->dimension * sp_fold_pair(line->fold, i) + j;
    (*place)[sp_fold_lane(line->fold, i)] = x;
    if (2 * i == line->fold.inner + 1) (*place)[1] = x;
}

int sp_polyline_settle(struct sp_polyline *line, double scale) {
    int32_t unknown = sp_fold_unknown(line->fold);
    if (line->surface->kind == SP_PARAMETRIC)
        line->touches = sp_parametric_clip(line->surface, unknown, line->nodes.places + 2);
    else if (!sp_implicit_settle(line->surface, unknown, line->nodes.places + 3, scale))
        return 0;
    sp_fold_mirror(line->fold, line->nodes.places, line->kind->dimension);
    return 1;
}
