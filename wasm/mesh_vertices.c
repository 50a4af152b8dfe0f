/* Bisection, then Newton steps along the gradient, a block of vertices at a time.
 *
 * A vertex that the projection loses (to another sheet, to a place without a gradient, to NaN) stays on its edge, where f does change sign.
 * So every vertex is right to rounding, and the mesh keeps the topology that the lattice gave it. Where f changes sign and is not 0, at a
 * jump, a pole or the end of where it is a number, there is no surface, but a wall: the normal is NaN. */
#include "mesh_vertices.h"
#include "mesh_points.h"
#include "scalar.h"

#include <stdbool.h>
#include <string.h>

enum {
    BLOCK = SP_MESH_POINTS, /* vertices */
    BISECTIONS = 8,         /* enough to see past an f that is far from linear on the edge */
    BITS = 53,              /* bisections that exhaust a double */
    PROJECTIONS = 8         /* Newton steps; most vertices need three */
};

/* Crossings are kept this part of an edge away from its ends until they are projected: without it a vertex of the lattice that lies almost
 * on the surface is surrounded by needles. Smallest angle, one per cent of the angles below, mean, on genus 2 at resolution 48: 0.1, 0.3,
 * 33 degrees for 0; 7.7, 12.7, 36.6 for 0.2; 10.4, 20.3, 39.8 for 0.3; 8.4, 24.5, 41.9 for 0.35. */
static const double edge_margin = 0.3;

/* At a zero f falls to less than this part of its largest: a seventh root to 6e-3. */
static const double least_fall = 0.01;

/* A block of vertices on their way from the lattice edge to the surface. */
struct block {
    struct sp_mesh_points points;
    const double *box;
    double start[BLOCK][3], edge[BLOCK][3]; /* f < 0 at start, not at start + edge */
    double freedom[BLOCK][3];               /* 0 along the axes in which the vertex is bound to a face of the box, else 1 */
    double low[BLOCK], high[BLOCK];         /* part of the edge where f changes sign */
    double largest[BLOCK];                  /* |f| of all parts seen where it is finite */
};

void sp_mesh_evaluate(sp_evaluate value, struct sp_mesh_points *points) {
    for (int32_t i = 0; i < points->count + (points->count & 1); i++)
        for (int axis = 0; axis < 3; axis++)
            points->in[i / 2 * SP_IMPLICIT_INPUTS + axis][i & 1] = points->at[i < points->count ? i : i - 1][axis];
    value((points->count + 1) / 2, points->in, points->out);
}

void sp_mesh_gradient(const struct sp_mesh_points *points, int32_t i, double gradient[3]) {
    for (int axis = 0; axis < 3; axis++)
        gradient[axis] = points->out[i / 2 * SP_IMPLICIT_VALUES + 1 + axis][i & 1];
}

static void put_on_edge(struct block *block, int32_t i, double part) {
    for (int axis = 0; axis < 3; axis++)
        block->points.at[i][axis] = block->start[i][axis] + part * block->edge[i][axis];
}

/* Bisects `times` on the edges of the block; leaves `low` inside, `high` outside. */
static void bisect(sp_evaluate value, struct block *block, int times) {
    for (int step = 0; step < times; step++) {
        for (int32_t i = 0; i < block->points.count; i++)
            put_on_edge(block, i, 0.5 * (block->low[i] + block->high[i]));
        sp_mesh_evaluate(value, &block->points);
        for (int32_t i = 0; i < block->points.count; i++) {
            double middle = 0.5 * (block->low[i] + block->high[i]), f = sp_mesh_value(&block->points, i), size = absolute(f);
            *(f < 0 ? &block->low[i] : &block->high[i]) = middle;
            if (size > block->largest[i] && size < 1e300) block->largest[i] = size;
        }
    }
}

/* Gradient of f at vertex i, as evaluated last, along its free axes. Returns f/|grad f|^2: the Newton step is minus that times the
 * gradient. */
static double newton_factor(const struct block *block, int32_t i, double gradient[3]) {
    sp_mesh_gradient(&block->points, i, gradient);
    for (int axis = 0; axis < 3; axis++)
        gradient[axis] *= block->freedom[i][axis];
    return sp_mesh_value(&block->points, i) / dot(gradient, gradient);
}

/* Newton steps along the gradient, none longer than half the edge. Returns the number of vertices that the last one moved visibly. */
static int32_t project(struct block *block) {
    int32_t moving = 0;
    for (int32_t i = 0; i < block->points.count; i++) {
        double gradient[3], factor = newton_factor(block, i, gradient);
        double reach = 0.25 * dot(block->edge[i], block->edge[i]), step = factor * factor * dot(gradient, gradient);
        if (!(step <= reach)) factor = 0;
        for (int axis = 0; axis < 3; axis++)
            block->points.at[i][axis] -= factor * gradient[axis];
        moving += step <= reach && step > 1e-28 * reach;
    }
    return moving;
}

/* True when vertex i came to rest on f = 0, not far from its edge, on the sheet that crosses it: f grows along the edge. Nor may it leave
 * the box: triangles would fold back over its faces. */
static bool settled(const struct block *block, int32_t i) {
    double gradient[3], away[3], factor = newton_factor(block, i, gradient), edge = dot(block->edge[i], block->edge[i]);
    for (int axis = 0; axis < 3; axis++) {
        const double at = block->points.at[i][axis], *box = block->box + 2 * axis;
        away[axis] = at - block->start[i][axis] - block->low[i] * block->edge[i][axis];
        if (at > box[1] || at < box[0]) return false;
    }
    return factor * factor * dot(gradient, gradient) <= 1e-20 * edge && dot(away, away) <= 0.25 * edge && dot(gradient, block->edge[i]) > 0;
}

static double clamp_part(double part) { return part < edge_margin ? edge_margin : part > 1 - edge_margin ? 1 - edge_margin : part; }

/* Brings the vertices of a block onto the surface; those that projection loses stay on their edge, bisected to the last bit. */
static void settle_block(sp_evaluate value, struct block *block) {
    bisect(value, block, BISECTIONS);
    for (int32_t i = 0; i < block->points.count; i++)
        put_on_edge(block, i, clamp_part(0.5 * (block->low[i] + block->high[i])));
    sp_mesh_evaluate(value, &block->points);
    for (int step = 0; step < PROJECTIONS; step++) {
        int32_t moving = project(block);
        sp_mesh_evaluate(value, &block->points);
        if (moving == 0) break;
    }
}

/* The normal is the gradient's direction; of one that is infinite, as at the end of a root, that of its infinite parts; where there is
 * none, the edge's. */
static void store_vertex(const struct block *block, int32_t i, double position[3], double normal[3]) {
    double gradient[3];
    sp_mesh_gradient(&block->points, i, gradient);
    if (norm(gradient) >= 1e300)
        for (int axis = 0; axis < 3; axis++)
            gradient[axis] = smaller(larger(gradient[axis] * 1e-300, -1), 1);
    double scale = norm(gradient);
    bool differentiable = scale > 0;
    const double *direction = differentiable ? gradient : block->edge[i];
    scale = differentiable ? scale : norm(block->edge[i]);
    for (int axis = 0; axis < 3; axis++)
        position[axis] = block->points.at[i][axis], normal[axis] = direction[axis] / scale;
}

static void place_block(sp_evaluate value, struct block *block, double *positions, double *normals) {
    bool lost[BLOCK] = {false};
    int32_t lost_count = 0;
    settle_block(value, block);
    for (int32_t i = 0; i < block->points.count; i++) {
        lost[i] = !settled(block, i);
        lost_count += lost[i];
        if (!lost[i]) store_vertex(block, i, positions + 3 * i, normals + 3 * i);
    }
    if (lost_count == 0) return;
    bisect(value, block, BITS - BISECTIONS);
    for (int32_t i = 0; i < block->points.count; i++)
        put_on_edge(block, i, block->low[i]);
    sp_mesh_evaluate(value, &block->points);
    for (int32_t i = 0; i < block->points.count; i++) {
        if (!lost[i]) continue;
        store_vertex(block, i, positions + 3 * i, normals + 3 * i);
        if (-sp_mesh_value(&block->points, i) <= least_fall * block->largest[i]) continue;
        for (int axis = 0; axis < 3; axis++)
            normals[3 * i + axis] = not_a_number();
    }
}

static void prepare(struct block *block, int32_t i) {
    block->low[i] = 0, block->high[i] = 1, block->largest[i] = 0;
    for (int axis = 0; axis < 3; axis++) {
        bool on_face = block->start[i][axis] == block->box[2 * axis] || block->start[i][axis] == block->box[2 * axis + 1];
        block->freedom[i][axis] = on_face && block->edge[i][axis] == 0 ? 0 : 1;
    }
}

void sp_place_vertices(sp_evaluate value, const double box[6], struct sp_mesh *mesh) {
    struct block block;
    block.box = box;
    for (int32_t first = 0; first < mesh->vertex_count; first += BLOCK) {
        size_t offset = 3 * (size_t)first;
        block.points.count = mesh->vertex_count - first < BLOCK ? mesh->vertex_count - first : BLOCK;
        memcpy(block.start, mesh->positions + offset, (size_t)block.points.count * sizeof block.start[0]);
        memcpy(block.edge, mesh->normals + offset, (size_t)block.points.count * sizeof block.edge[0]);
        for (int32_t i = 0; i < block.points.count; i++)
            prepare(&block, i);
        place_block(value, &block, mesh->positions + offset, mesh->normals + offset);
    }
}
