/* Marching tetrahedra, layer by layer.
 *
 * Lattice points have doubled integer coordinates: corners of cells even, centres odd. Each face of a cell joins the centres on its two
 * sides to its four edges: four tetrahedra. Outside the box the centres are moved onto its faces, so that the tetrahedra fill the box
 * exactly. A tetrahedron spans three layers, so three are alive. Where on its edge a vertex lies
 * is decided in mesh_vertices.c, where the surface ends between points of the lattice in mesh_rim.c. */
#include "mesh.h"
#include "mesh_rim.h"
#include "mesh_vertices.h"
#include "scalar.h"

#include <stdbool.h>
#include <string.h>

enum {
    MOST_COLUMNS = SP_MESH_MAX_RESOLUTION + 2,
    FLAGS = 8,      /* of a row, looked at together */
    FACE_SITES = 6, /* lattice points around a face of a cell */
    EDGES = 7,      /* edges owned by a lattice point: those to points that come earlier in the sweep */
    LIVE_LAYERS = 3,
    TRIANGLES_A_VERTEX = 2, /* of a closed surface, but for its handles */
    VERTEX_BYTES = 6 * sizeof(double) + TRIANGLES_A_VERTEX * 3 * sizeof(int32_t),
    ALIGNED = 48,   /* each of the three arrays begins at a multiple of 16 */
    LEAST_PART = 12 /* a short side has this part of the cells of the longest, at least: thin boxes hold thin surfaces, but cells that are
                       no cubes thin triangles */
};

/* The layers of the lattice that the sweep can see, and what it has found. */
struct sweep {
    sp_evaluate value;
    const double *box;
    double cell[3];
    int32_t cells[3];
    size_t row;                   /* places in a row of a layer */
    uint8_t *inside[LIVE_LAYERS]; /* f < 0, a place a lattice point */
    int32_t *vertex[LIVE_LAYERS]; /* EDGES a place: number of the vertex on the edge, or -1 */
    struct sp_mesh *mesh;
    int32_t room; /* vertices that its arrays hold, and twice as many triangles; what is beyond is only counted */
};

struct site {
    int32_t at[3]; /* doubled coordinates */
    bool inside;
};

/* The lattice of a box: false when it is empty or not finite. */
static bool divide_box(struct sweep *sweep, const double box[6], int32_t resolution) {
    double longest = 0;
    for (int axis = 0; axis < 3; axis++) {
        double side = box[2 * axis + 1] - box[2 * axis];
        if (!(side > 0 && side < 1e300)) return false;
        longest = side > longest ? side : longest;
    }
    int32_t most = clamp(resolution, 1, SP_MESH_MAX_RESOLUTION);
    for (int axis = 0; axis < 3; axis++) {
        double side = box[2 * axis + 1] - box[2 * axis];
        sweep->cells[axis] = clamp((int32_t)(side / longest * most + 0.5), (most + LEAST_PART - 1) / LEAST_PART, most);
        sweep->cell[axis] = side / sweep->cells[axis];
    }
    sweep->box = box;
    sweep->row = (size_t)sweep->cells[0] + 2;
    return true;
}

static size_t places(const struct sweep *sweep) { return sweep->row * ((size_t)sweep->cells[1] + 2); }

static bool take_layers(struct sweep *sweep, struct sp_arena *arena) {
    bool fits = true;
    for (int layer = 0; layer < LIVE_LAYERS; layer++) {
        sweep->inside[layer] = sp_arena_take(arena, places(sweep), sizeof *sweep->inside[layer]);
        sweep->vertex[layer] = sp_arena_take(arena, places(sweep) * EDGES, sizeof *sweep->vertex[layer]);
        fits = fits && sweep->inside[layer] && sweep->vertex[layer];
    }
    return fits;
}

/* Exact on the faces of the box. */
static double coordinate(const struct sweep *sweep, int axis, int32_t doubled) {
    if (doubled >= 2 * sweep->cells[axis]) return sweep->box[2 * axis + 1];
    return sweep->box[2 * axis] + sweep->cell[axis] * (doubled < 0 ? 0 : 0.5 * doubled);
}

static size_t layer_of(const int32_t at[3]) { return (size_t)(at[2] + LIVE_LAYERS) % LIVE_LAYERS; }

static size_t place_of(const struct sweep *sweep, const int32_t at[3]) {
    return (size_t)((at[1] + 1) >> 1) * sweep->row + (size_t)((at[0] + 1) >> 1);
}

/* Evaluates a row of a layer: at most MOST_COLUMNS points. The lane without a point repeats the last. */
static void load_row(struct sweep *sweep, int32_t y, int32_t z) {
    sp_pair in[(MOST_COLUMNS + 1) / 2 * SP_IMPLICIT_INPUTS], out[(MOST_COLUMNS + 1) / 2 * SP_IMPLICIT_VALUES];
    int32_t first = -(z & 1), columns = sweep->cells[0] + 1 + (z & 1);
    sp_pair row = sp_splat(coordinate(sweep, 1, y)), layer = sp_splat(coordinate(sweep, 2, z));
    int32_t i = 0;
    do {
        double x = coordinate(sweep, 0, first + 2 * i);
        sp_pair *at = in + i / 2 * SP_IMPLICIT_INPUTS;
        at[0] = (sp_pair){x, i + 1 < columns ? coordinate(sweep, 0, first + 2 * i + 2) : x}, at[1] = row, at[2] = layer;
        i += 2;
    } while (i < columns);
    sweep->value((columns + 1) / 2, in, out);
    const int32_t at[3] = {first, y, z};
    uint8_t *inside = sweep->inside[layer_of(at)] + place_of(sweep, at);
    for (i = 0; i < columns; i++)
        inside[i] = out[i / 2 * SP_IMPLICIT_VALUES][i & 1] < 0;
}

static void load_layer(struct sweep *sweep, int32_t z) {
    for (int32_t y = -(z & 1); y <= 2 * sweep->cells[1] + (z & 1); y += 2)
        load_row(sweep, y, z);
    const int32_t top[3] = {0, 0, z};
    memset(sweep->vertex[layer_of(top)], 0xff, places(sweep) * EDGES * sizeof(int32_t));
}

/* Where the number of the vertex on an edge is kept: with the end that comes later in the sweep. */
static int32_t *edge_slot(const struct sweep *sweep, const struct site *a, const struct site *b) {
    int32_t d[3];
    for (int axis = 0; axis < 3; axis++)
        d[axis] = b->at[axis] - a->at[axis];
    bool b_is_later = d[2] != 0 ? d[2] > 0 : d[0] + d[1] > 0;
    const int32_t *owner = b_is_later ? b->at : a->at;
    int slot = d[2] == 0 ? d[0] == 0 : 2;
    if (d[2] & 1) slot = 3 + ((d[0] > 0) == b_is_later) + 2 * ((d[1] > 0) == b_is_later);
    return &sweep->vertex[layer_of(owner)][place_of(sweep, owner) * EDGES + (size_t)slot];
}

/* The vertex on the edge between a point inside and one outside. Until sp_place_vertices its position is the end inside and its normal the
 * vector to the other. */
static int32_t edge_vertex(struct sweep *sweep, const struct site *a, const struct site *b) {
    int32_t *slot = edge_slot(sweep, a, b);
    if (*slot >= 0) return *slot;
    const struct site *from = a->inside ? a : b, *to = a->inside ? b : a;
    struct sp_mesh *mesh = sweep->mesh;
    *slot = mesh->vertex_count++;
    int is_stored = *slot < sweep->room;
    for (int axis = 0; is_stored && axis < 3; axis++) {
        double start = coordinate(sweep, axis, from->at[axis]);
        mesh->positions[3 * *slot + axis] = start;
        mesh->normals[3 * *slot + axis] = coordinate(sweep, axis, to->at[axis]) - start;
    }
    return *slot;
}

static void emit(struct sweep *sweep, int32_t a, int32_t b, int32_t c) {
    struct sp_mesh *mesh = sweep->mesh;
    int is_stored = mesh->triangle_count < TRIANGLES_A_VERTEX * sweep->room;
    int32_t *triangle = is_stored ? mesh->indices + 3 * mesh->triangle_count : NULL;
    if (triangle) triangle[0] = a, triangle[1] = b, triangle[2] = c;
    mesh->triangle_count++;
}

/* By the bits of the corners inside: an even permutation that brings the lone corner, or the pair inside, to the front. */
static const uint8_t fronts[16][4] = {{0, 1, 2, 3}, {0, 1, 2, 3}, {1, 0, 3, 2}, {0, 1, 2, 3}, {2, 3, 0, 1}, {0, 2, 3, 1},
                                      {1, 2, 0, 3}, {3, 2, 1, 0}, {3, 2, 1, 0}, {0, 3, 1, 2}, {1, 3, 2, 0}, {2, 3, 0, 1},
                                      {2, 3, 0, 1}, {1, 0, 3, 2}, {0, 1, 2, 3}, {0, 1, 2, 3}};

/* `corners` are positively oriented. The first triangle of a quadrilateral is marked by the complement of its first index: its diagonal is
 * chosen when all vertices are in place. */
static void visit_tetrahedron(struct sweep *sweep, const struct site *const corners[4]) {
    int mask = corners[0]->inside | corners[1]->inside << 1 | corners[2]->inside << 2 | corners[3]->inside << 3;
    if (mask == 0 || mask == 15) return;
    const struct site *c[4];
    for (int i = 0; i < 4; i++)
        c[i] = corners[fronts[mask][i]];
    if (c[0]->inside == c[1]->inside) {
        int32_t p = edge_vertex(sweep, c[0], c[2]), q = edge_vertex(sweep, c[0], c[3]);
        int32_t r = edge_vertex(sweep, c[1], c[3]), s = edge_vertex(sweep, c[1], c[2]);
        emit(sweep, ~p, q, r);
        emit(sweep, p, r, s);
        return;
    }
    int32_t p = edge_vertex(sweep, c[0], c[1]), q = edge_vertex(sweep, c[0], c[2]), r = edge_vertex(sweep, c[0], c[3]);
    emit(sweep, p, c[0]->inside ? q : r, c[0]->inside ? r : q);
}

/* The six lattice points around a face normal to `axis`, from its centre: the centres of the two cells, then the corners in turn. */
static void face_offsets(int axis, int32_t offsets[FACE_SITES][3]) {
    static const int8_t turns[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    memset(offsets, 0, FACE_SITES * sizeof offsets[0]);
    offsets[0][axis] = -1, offsets[1][axis] = 1;
    for (int i = 0; i < 4; i++)
        offsets[2 + i][(axis + 1) % 3] = turns[i][0], offsets[2 + i][(axis + 2) % 3] = turns[i][1];
}

static struct site site_at(const struct sweep *sweep, const int32_t face[3], const int32_t offset[3]) {
    struct site site = {{face[0] + offset[0], face[1] + offset[1], face[2] + offset[2]}, false};
    site.inside = sweep->inside[layer_of(site.at)][place_of(sweep, site.at)];
    return site;
}

/* The four tetrahedra around the segment that joins the two cells at a face. */
static void visit_face(struct sweep *sweep, const int32_t offsets[FACE_SITES][3], const int32_t face[3]) {
    struct site site[FACE_SITES] = {{{0, 0, 0}, false}};
    for (int i = 0; i < FACE_SITES; i++)
        site[i] = site_at(sweep, face, offsets[i]);
    for (int i = 0; i < 4; i++) {
        const struct site *const corners[4] = {&site[0], &site[1], &site[2 + i], &site[2 + (i + 1) % 4]};
        visit_tetrahedron(sweep, corners);
    }
}

/* Whether the flags from one on are the same around all these faces. */
static bool are_plain(const uint8_t *const inside[FACE_SITES], int32_t first) {
    uint64_t any = 0, all = ~(uint64_t)0, flags;
    for (int i = 0; i < FACE_SITES; i++) {
        memcpy(&flags, inside[i] + first, FLAGS);
        any |= flags, all &= flags;
    }
    return any == all;
}

/* All faces normal to `axis` whose centres lie in one row. Most are far from the surface: those are passed over by their flags alone. */
static void visit_row(struct sweep *sweep, int axis, int32_t y, int32_t z) {
    int32_t offsets[FACE_SITES][3], face[3] = {axis != 0, y, z}, count = sweep->cells[0] + (axis == 0);
    const uint8_t *inside[FACE_SITES];
    face_offsets(axis, offsets);
    for (int i = 0; i < FACE_SITES; i++) {
        int32_t at[3] = {face[0] + offsets[i][0], y + offsets[i][1], z + offsets[i][2]};
        inside[i] = sweep->inside[layer_of(at)] + place_of(sweep, at);
    }
    for (int32_t i = 0; i < count; i++) {
        while (i + FLAGS <= count && are_plain(inside, i))
            i += FLAGS;
        if (i == count) return;
        int flags = inside[0][i] + inside[1][i] + inside[2][i] + inside[3][i] + inside[4][i] + inside[5][i];
        face[0] = (axis != 0) + 2 * i;
        if (flags != 0 && flags != FACE_SITES) visit_face(sweep, (const int32_t(*)[3])offsets, face);
    }
}

static void visit_faces(struct sweep *sweep, int axis, int32_t z) {
    for (int32_t y = axis != 1; y <= 2 * sweep->cells[1]; y += 2)
        visit_row(sweep, axis, y, z);
}

static void sweep_box(struct sweep *sweep) {
    sweep->mesh->vertex_count = sweep->mesh->triangle_count = 0;
    for (int32_t top = -1; top <= 2 * sweep->cells[2] + 1; top++) {
        load_layer(sweep, top);
        int32_t middle = top - 1;
        if (middle < 0) continue;
        if (middle & 1) visit_faces(sweep, 0, middle), visit_faces(sweep, 1, middle);
        if (!(middle & 1)) visit_faces(sweep, 2, middle);
    }
}

static double squared_distance(const struct sp_mesh *mesh, int32_t a, int32_t b) {
    const double *p = mesh->positions + 3 * (size_t)a, *q = mesh->positions + 3 * (size_t)b;
    return (p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) + (p[2] - q[2]) * (p[2] - q[2]);
}

/* Splits the quadrilaterals that the sweep marked along their shorter diagonal. */
static void choose_diagonals(struct sp_mesh *mesh) {
    for (int32_t triangle = 0; triangle < mesh->triangle_count; triangle++) {
        int32_t *t = mesh->indices + 3 * (size_t)triangle;
        if (t[0] >= 0) continue;
        t[0] = ~t[0];
        int32_t p = t[0], q = t[1], r = t[2], s = t[5];
        if (squared_distance(mesh, q, s) < squared_distance(mesh, p, r)) t[2] = s, t[3] = q, t[4] = r;
    }
}

static size_t scratch_bytes(const struct sweep *sweep) {
    size_t inside = (places(sweep) + 15) & ~(size_t)15, vertex = (places(sweep) * EDGES * sizeof(int32_t) + 15) & ~(size_t)15;
    return LIVE_LAYERS * (inside + vertex);
}

double sp_mesh_bytes(const double box[6], int32_t resolution, int32_t vertex_count, int32_t triangle_count) {
    struct sweep sweep;
    if (!divide_box(&sweep, box, resolution)) return 0;
    double room = larger(vertex_count, (triangle_count + 1) / TRIANGLES_A_VERTEX);
    return larger((double)scratch_bytes(&sweep), sizeof(int32_t) * (double)vertex_count) + VERTEX_BYTES * room + ALIGNED;
}

/* Arrays for as many vertices as there is room for beside the scratch, which lies behind them. */
static bool take_arrays(struct sweep *sweep, struct sp_arena *arena) {
    size_t left = arena->size - arena->used, scratch = scratch_bytes(sweep) + ALIGNED;
    size_t room = left > scratch ? (left - scratch) / VERTEX_BYTES : 0, most = INT32_MAX / TRIANGLES_A_VERTEX;
    sweep->room = (int32_t)(room < most ? room : most);
    struct sp_mesh *mesh = sweep->mesh;
    mesh->positions = sp_arena_take(arena, (size_t)sweep->room, 3 * sizeof(double));
    mesh->normals = sp_arena_take(arena, (size_t)sweep->room, 3 * sizeof(double));
    mesh->indices = sp_arena_take(arena, TRIANGLES_A_VERTEX * (size_t)sweep->room, 3 * sizeof(int32_t));
    return mesh->positions && mesh->normals && mesh->indices && take_layers(sweep, arena);
}

/* Moves the arrays together: exactly they are taken. */
static void close_arrays(struct sp_mesh *mesh, struct sp_arena *arena) {
    struct sp_mesh wide = *mesh;
    size_t vertices = (size_t)mesh->vertex_count, triangles = (size_t)mesh->triangle_count;
    sp_arena_take(arena, vertices, 3 * sizeof(double));
    mesh->normals = sp_arena_take(arena, vertices, 3 * sizeof(double));
    mesh->indices = sp_arena_take(arena, triangles, 3 * sizeof(int32_t));
    memmove(mesh->normals, wide.normals, 3 * vertices * sizeof(double));
    memmove(mesh->indices, wide.indices, 3 * triangles * sizeof(int32_t));
}

int32_t sp_mesh_implicit(sp_evaluate value, const double box[6], int32_t resolution, struct sp_arena *arena, struct sp_mesh *mesh) {
    struct sweep sweep = {.value = value, .mesh = mesh};
    size_t before = arena->used;
    *mesh = (struct sp_mesh){0};
    if (!divide_box(&sweep, box, resolution)) return SP_NOT_FINITE;
    bool fits = take_arrays(&sweep, arena);
    if (fits) sweep_box(&sweep);
    arena->used = before;
    if (fits && mesh->vertex_count <= sweep.room && mesh->triangle_count <= TRIANGLES_A_VERTEX * sweep.room) {
        close_arrays(mesh, arena);
        size_t kept = arena->used;
        int32_t *near = sp_arena_take(arena, (size_t)mesh->vertex_count, sizeof *near);
        if (near) {
            sp_place_vertices(value, box, mesh);
            choose_diagonals(mesh);
            sp_draw_rims(value, box, mesh, near);
            arena->used = kept;
            return SP_CONVERGED;
        }
    }
    *mesh = (struct sp_mesh){.vertex_count = mesh->vertex_count, .triangle_count = mesh->triangle_count};
    arena->used = before;
    return SP_OUT_OF_MEMORY;
}
