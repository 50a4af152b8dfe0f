/* Nodes of a path written where folding puts them, and put onto the surface. */
#include "polyline.h"
#include "scalar.h"

/* A node is on the surface to this part of the size of things. */
static const double SETTLED = 1e-6;

struct node {
    double at[3], normal[3];
};

/* Reads a node, and its normal as a unit vector. Returns whether it is on the surface. */
static int read_node(const struct sp_polyline *line, int32_t i, double scale, struct node *node) {
    sp_pair place[3], seen[SP_IMPLICIT_VALUES];
    for (int j = 0; j < 3; j++)
        node->at[j] = sp_fold_get(line->fold, line->nodes.places, 3, i, j), place[j] = sp_splat(node->at[j]);
    line->surface->value(1, place, seen);
    double gradient[3] = {seen[1][0], seen[2][0], seen[3][0]}, length = norm(gradient);
    for (int j = 0; j < 3; j++)
        node->normal[j] = gradient[j] / length;
    return is_finite(length) && absolute(seen[0][0]) <= SETTLED * scale * length;
}

/* Puts a node between two others that are on the surface. Returns 0 where it does not settle near by. */
static int put_between(const struct sp_polyline *line, int32_t i, const struct node *before, const struct node *after, double part,
                       double scale) {
    double at[3];
    if (!sp_implicit_between(line->surface, (const double *[]){before->at, after->at}, (const double *[]){before->normal, after->normal},
                             part, scale, at))
        return 0;
    for (int j = 0; j < 3; j++)
        sp_polyline_put(line, i, j, at[j]);
    return 1;
}

/* Nodes that do not settle, as those of chords within a rounded edge where f is the same all around, are put between those that do. */
static int mend(const struct sp_polyline *line, double scale) {
    int32_t last = line->fold.inner + 1, next = 0;
    struct node before, after;
    int settled = read_node(line, 0, scale, &before);
    for (int32_t i = 1; i < last && settled; i++) {
        if (next < i)
            for (next = i; !read_node(line, next, scale, &after) && next < last;)
                next++;
        if (next > i)
            settled = put_between(line, i, &before, &after, 1.0 / (next - i + 1), scale) && read_node(line, i, scale, &before);
        else
            before = after;
    }
    return settled;
}

void sp_polyline_put(const struct sp_polyline *line, int32_t i, int32_t j, double x) {
    sp_pair *place = line->nodes.places + line->kind->dimension * sp_fold_pair(line->fold, i) + j;
    (*place)[sp_fold_lane(line->fold, i)] = x;
    if (2 * i == line->fold.inner + 1) (*place)[1] = x;
}

int sp_polyline_settle(struct sp_polyline *line, double scale) {
    int32_t unknown = sp_fold_unknown(line->fold);
    if (line->surface->kind == SP_PARAMETRIC)
        line->touches = sp_parametric_clip(line->surface, unknown, line->nodes.places + 2);
    else if (!sp_implicit_settle(line->surface, unknown, line->nodes.places + 3, scale) && !mend(line, scale))
        return 0;
    sp_fold_mirror(line->fold, line->nodes.places, line->kind->dimension);
    return 1;
}
