/* Bisection between a vertex of the surface, where there is surface, and one of a wall, where there is none: each place in between is
 * brought onto f = 0 by Newton steps, halved where they lead out of where f is a number. A block of vertices at a time. */
#include "mesh_rim.h"
#include "mesh_points.h"
#include "scalar.h"

#include <stdbool.h>

enum {
    BLOCK = SP_MESH_POINTS, /* vertices */
    BISECTIONS = 12,        /* to 1e-4 of a cell */
    STEPS = 12,
    SURFACE = -1, /* in place of the nearest vertex of the surface: it is one itself */
    WALL = -2     /* there is none */
};

/* Of the greatest |f| on the way: a crossing of f = 0, not a place where steps end because f is ever steeper. */
static const double least_fall = 1e-9;
/* Of the way to the wall, squared: a step that is rounding. */
static const double at_rest = 1e-24;
/* Of a rim's distance from a vertex of its triangles, how far it may be beside the plane that touches the surface there. */
static const double most_slope = 0.7;

/* Vertices of a rim, each on its way. */
struct block {
    struct sp_mesh_points points;
    int32_t vertex[BLOCK];
    double start[BLOCK][3], edge[BLOCK][3], normal[BLOCK][3]; /* the vertex of the surface, the way to the wall's, the normal there */
    double low[BLOCK], high[BLOCK];                           /* part of the way where the surface ends */
    double largest[BLOCK];
};

static double *position_of(const struct sp_mesh *mesh, int32_t vertex) { return mesh->positions + 3 * (size_t)vertex; }

static double *normal_of(const struct sp_mesh *mesh, int32_t vertex) { return mesh->normals + 3 * (size_t)vertex; }

static void put_between(struct block *block, int32_t i, double part) {
    for (int axis = 0; axis < 3; axis++)
        block->points.at[i][axis] = block->start[i][axis] + part * block->edge[i][axis];
}

/* The Newton step at vertex i, as evaluated last. A vertex stays on the face of the box on which its whole way lies. */
static void newton_step(const struct block *block, int32_t i, const double box[6], double step[3]) {
    sp_mesh_gradient(&block->points, i, step);
    for (int axis = 0; axis < 3; axis++) {
        double x = block->start[i][axis];
        if (block->edge[i][axis] == 0 && (x == box[2 * axis] || x == box[2 * axis + 1])) step[axis] = 0;
    }
    double factor = -sp_mesh_value(&block->points, i) / dot(step, step);
    for (int axis = 0; axis < 3; axis++)
        step[axis] *= factor;
}

/* Brings the vertices onto f = 0, as far as they come. */
static void approach(sp_evaluate value, const double box[6], struct block *block) {
    double last[BLOCK][3], step[BLOCK][3] = {{0}};
    for (int32_t i = 0; i < block->points.count; i++)
        for (int axis = 0; axis < 3; axis++)
            last[i][axis] = block->points.at[i][axis];
    int32_t moving = block->points.count;
    for (int count = 0; moving > 0 && count < STEPS; count++) {
        sp_mesh_evaluate(value, &block->points);
        moving = 0;
        for (int32_t i = 0; i < block->points.count; i++) {
            double next[3];
            newton_step(block, i, box, next);
            bool goes_on = is_finite(dot(next, next));
            for (int axis = 0; axis < 3; axis++) {
                if (goes_on) last[i][axis] = block->points.at[i][axis];
                step[i][axis] = goes_on ? next[axis] : 0.5 * step[i][axis];
                block->points.at[i][axis] = last[i][axis] + step[i][axis];
            }
            moving += dot(step[i], step[i]) > at_rest * dot(block->edge[i], block->edge[i]);
        }
    }
    sp_mesh_evaluate(value, &block->points);
}

/* Whether vertex i has come to rest on f = 0, inside the box, not far from where it set out, on the side of the surface that it began on.
 */
static bool rests(const struct block *block, int32_t i, const double box[6]) {
    double step[3], away[3], gradient[3];
    sp_mesh_gradient(&block->points, i, gradient);
    double part = 0.5 * (block->low[i] + block->high[i]), size = dot(block->edge[i], block->edge[i]);
    bool inside = true;
    for (int axis = 0; axis < 3; axis++) {
        double x = block->points.at[i][axis];
        away[axis] = x - block->start[i][axis] - part * block->edge[i][axis];
        inside = inside && x >= box[2 * axis] && x <= box[2 * axis + 1];
    }
    newton_step(block, i, box, step);
    return inside && dot(step, step) <= at_rest * size && dot(away, away) <= 0.25 * size && dot(gradient, block->normal[i]) > 0 &&
           absolute(sp_mesh_value(&block->points, i)) <= least_fall * block->largest[i] && dot(gradient, gradient) < 1e300;
}

/* Moves the vertices of a block to the rim: what was last found of the surface on their way, or NaN. */
static void draw_block(sp_evaluate value, const double box[6], struct block *block, struct sp_mesh *mesh, int32_t *near) {
    for (int32_t i = 0; i < block->points.count; i++)
        put_between(block, i, 1);
    sp_mesh_evaluate(value, &block->points);
    for (int32_t i = 0; i < block->points.count; i++) {
        block->low[i] = 0, block->high[i] = 1, block->largest[i] = absolute(sp_mesh_value(&block->points, i));
        near[block->vertex[i]] = WALL;
    }
    for (int count = 0; count < BISECTIONS; count++) {
        for (int32_t i = 0; i < block->points.count; i++)
            put_between(block, i, 0.5 * (block->low[i] + block->high[i]));
        approach(value, box, block);
        for (int32_t i = 0; i < block->points.count; i++) {
            bool found = rests(block, i, box);
            *(found ? &block->low[i] : &block->high[i]) = 0.5 * (block->low[i] + block->high[i]);
            if (!found) continue;
            int32_t vertex = block->vertex[i];
            double gradient[3];
            sp_mesh_gradient(&block->points, i, gradient);
            near[vertex] = vertex;
            for (int axis = 0; axis < 3; axis++) {
                position_of(mesh, vertex)[axis] = block->points.at[i][axis];
                normal_of(mesh, vertex)[axis] = gradient[axis] / norm(gradient);
            }
        }
    }
    block->points.count = 0;
}

static void add_to_block(struct block *block, const struct sp_mesh *mesh, int32_t vertex, int32_t from) {
    int32_t i = block->points.count++;
    block->vertex[i] = vertex;
    for (int axis = 0; axis < 3; axis++) {
        block->start[i][axis] = position_of(mesh, from)[axis];
        block->normal[i][axis] = normal_of(mesh, from)[axis];
        block->edge[i][axis] = position_of(mesh, vertex)[axis] - block->start[i][axis];
    }
}

/* Finds for each vertex of a wall the farthest of the surface that shares a triangle with it: the nearest may lie on the rim. Returns
 * whether there are walls. */
static bool link_walls(const struct sp_mesh *mesh, int32_t *near) {
    bool some = false;
    for (int32_t i = 0; i < mesh->vertex_count; i++) {
        bool is_wall = !is_finite(*normal_of(mesh, i));
        near[i] = is_wall ? WALL : SURFACE, some = some || is_wall;
    }
    for (int32_t side = 0; some && side < 9 * mesh->triangle_count; side++) {
        const int32_t *triangle = mesh->indices + 3 * (size_t)(side / 9);
        int32_t wall = triangle[side / 3 % 3], other = triangle[side % 3];
        if (near[wall] == SURFACE || near[other] != SURFACE) continue;
        const double *at = position_of(mesh, wall), *here = position_of(mesh, other);
        if (near[wall] == WALL || distance_between(at, here) > distance_between(at, position_of(mesh, near[wall]))) near[wall] = other;
    }
    return some;
}

/* Whether a vertex of a rim lies beside what continues the surface at another one of its triangle. */
static bool strays(const struct sp_mesh *mesh, int32_t rim, int32_t other) {
    const double *from = position_of(mesh, other), *to = position_of(mesh, rim);
    double way[3] = {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
    return absolute(dot(way, normal_of(mesh, other))) > most_slope * norm(way);
}

/* Whether a triangle belongs to the surface: some corner does, and it does not face away from the normals of those, as where a rim lies
 * behind the surface's last vertices. */
static bool is_surface(const struct sp_mesh *mesh, const int32_t *near, const int32_t triangle[3]) {
    const double *a = position_of(mesh, triangle[0]), *b = position_of(mesh, triangle[1]), *c = position_of(mesh, triangle[2]);
    double facing = 0;
    int corners = 0;
    for (int axis = 0; axis < 3; axis++) {
        int next = (axis + 1) % 3, last = (axis + 2) % 3;
        double area = (b[next] - a[next]) * (c[last] - a[last]) - (b[last] - a[last]) * (c[next] - a[next]);
        corners += near[triangle[axis]] == SURFACE;
        for (int corner = 0; corner < 3; corner++)
            facing += near[triangle[corner]] == SURFACE ? area * normal_of(mesh, triangle[corner])[axis] : 0;
    }
    return corners == 3 || (corners > 0 && !(facing <= 0));
}

/* What is on no rim is NaN; triangles that are not of the surface are left out. */
static void leave_walls_out(struct sp_mesh *mesh, int32_t *near) {
    for (int32_t side = 0; side < 9 * mesh->triangle_count; side++) {
        const int32_t *triangle = mesh->indices + 3 * (size_t)(side / 9);
        int32_t rim = triangle[side / 3 % 3], other = triangle[side % 3];
        if (near[rim] >= 0 && near[other] == SURFACE && strays(mesh, rim, other)) near[rim] = WALL;
    }
    for (int32_t i = 0; i < mesh->vertex_count; i++)
        for (int axis = 0; near[i] == WALL && axis < 3; axis++)
            position_of(mesh, i)[axis] = normal_of(mesh, i)[axis] = not_a_number();
    int32_t count = 0;
    for (int32_t i = 0; i < mesh->triangle_count; i++) {
        const int32_t *triangle = mesh->indices + 3 * (size_t)i;
        if (!is_surface(mesh, near, triangle)) continue;
        int32_t *kept = mesh->indices + 3 * (size_t)count++;
        for (int corner = 0; corner < 3; corner++)
            kept[corner] = triangle[corner];
    }
    mesh->triangle_count = count;
}

void sp_draw_rims(sp_evaluate value, const double box[6], struct sp_mesh *mesh, int32_t *near) {
    struct block block = {.points.count = 0};
    if (!link_walls(mesh, near)) return;
    for (int32_t i = 0; i < mesh->vertex_count; i++) {
        if (near[i] >= 0) add_to_block(&block, mesh, i, near[i]);
        if (block.points.count == BLOCK || i == mesh->vertex_count - 1) draw_block(value, box, &block, mesh, near);
    }
    leave_walls_out(mesh, near);
}
