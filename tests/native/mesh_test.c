/* Meshes of implicit surfaces: closed, oriented, of the right topology, on the surface, and honest about memory.
 *
 * The surfaces are written by hand, gradients included, so that nothing here depends on the expression compiler. */
#include "../../wasm/mesh.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int failures;

#define CHECK(condition, ...)                                                                                                              \
    do {                                                                                                                                   \
        if (!(condition)) {                                                                                                                \
            failures++;                                                                                                                    \
            printf("%s:%d: %s: ", __FILE__, __LINE__, #condition);                                                                         \
            printf(__VA_ARGS__);                                                                                                           \
            printf("\n");                                                                                                                  \
        }                                                                                                                                  \
    } while (0)

/* Makes an sp_evaluate of a function that writes f and its gradient. */
#define SURFACE(name)                                                                                                                      \
    static void name(int32_t pair_count, const sp_pair *in, sp_pair *out) {                                                                \
        for (int32_t k = 0; k < pair_count; k++)                                                                                           \
            name##_at(in[3 * k], in[3 * k + 1], in[3 * k + 2], out + 4 * k);                                                               \
    }

static void sphere_at(sp_pair x, sp_pair y, sp_pair z, sp_pair *out) {
    out[0] = x * x + y * y + z * z - 1;
    out[1] = 2 * x, out[2] = 2 * y, out[3] = 2 * z;
}
SURFACE(sphere)

/* Eq. 46, R = 4, a = 1.5. */
static void torus_at(sp_pair x, sp_pair y, sp_pair z, sp_pair *out) {
    sp_pair s = x * x + y * y + z * z + 16 - 2.25;
    out[0] = s * s - 64 * (x * x + y * y);
    out[1] = 4 * s * x - 128 * x, out[2] = 4 * s * y - 128 * y, out[3] = 4 * s * z;
}
SURFACE(torus)

/* Eq. 43, R = 1, a = 0.2, r = 0.01: a wall of thickness 0.04 where two tori touch. */
static void three_tori_at(sp_pair x, sp_pair y, sp_pair z, sp_pair *out) {
    sp_pair at[3] = {x, y, z}, s = x * x + y * y + z * z + 0.96, torus[3], slope[3][3];
    for (int axis = 0; axis < 3; axis++) {
        torus[axis] = s * s - 4 * (x * x + y * y + z * z - at[axis] * at[axis]);
        for (int k = 0; k < 3; k++)
            slope[axis][k] = 4 * s * at[k] - (k == axis ? 0 : 8) * at[k];
    }
    out[0] = torus[0] * torus[1] * torus[2] - 0.01;
    for (int k = 0; k < 3; k++)
        out[1 + k] = slope[0][k] * torus[1] * torus[2] + torus[0] * slope[1][k] * torus[2] + torus[0] * torus[1] * slope[2][k];
}
SURFACE(three_tori)

/* Eq. 45. */
static void genus2_at(sp_pair x, sp_pair y, sp_pair z, sp_pair *out) {
    sp_pair p = 2 * y * (y * y - 3 * x * x), r = x * x + y * y, q = 1 - z * z, w = 9 * z * z - 1;
    out[0] = p * q + r * r - w * q;
    out[1] = -12 * x * y * q + 4 * x * r;
    out[2] = (6 * y * y - 6 * x * x) * q + 4 * y * r;
    out[3] = -2 * z * p - 18 * z * q + 2 * z * w;
}
SURFACE(genus2)

/* Eq. 44: a product of four distances, d = sqrt(s). */
static void metamorphosis_at(sp_pair x, sp_pair y, sp_pair z, sp_pair *out) {
    static const double foci[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    sp_pair product = sp_splat(1), sum[3] = {sp_splat(0), sp_splat(0), sp_splat(0)};
    for (int i = 0; i < 4; i++) {
        sp_pair dx = x - foci[i][0], dy = y - foci[i][1], s = dx * dx + dy * dy + z * z;
        product *= sp_square_root(s);
        sum[0] += dx / s, sum[1] += dy / s, sum[2] += z / s;
    }
    out[0] = product - 1.1;
    for (int axis = 0; axis < 3; axis++)
        out[1 + axis] = product * sum[axis];
}
SURFACE(metamorphosis)

/* A tilted plane: every box cuts it. */
static void plane_at(sp_pair x, sp_pair y, sp_pair z, sp_pair *out) {
    out[0] = x + 2 * y + 3 * z - 0.25;
    out[1] = sp_splat(1), out[2] = sp_splat(2), out[3] = sp_splat(3);
}
SURFACE(plane)

/* NaN for x > 0.3, a sphere elsewhere. */
static void torn_at(sp_pair x, sp_pair y, sp_pair z, sp_pair *out) {
    sphere_at(x, y, z, out);
    for (int j = 0; j < 4; j++)
        out[j] = sp_select((sp_mask)(x > 0.3), sp_splat((double)NAN), out[j]);
}
SURFACE(torn)

/* Zero at many lattice points of the boxes used here, and on whole planes of them. */
static void cube_corner_at(sp_pair x, sp_pair y, sp_pair z, sp_pair *out) {
    out[0] = x * y * z;
    out[1] = y * z, out[2] = x * z, out[3] = x * y;
}
SURFACE(cube_corner)

struct statistics {
    int32_t open_edges, bad_edges, euler;
    double worst_residual; /* |f|/|grad f| over the diagonal of the box */
    double worst_turn;     /* smallest cosine between a triangle and the surface */
    double smallest_angle, worst_percent_angle, mean_angle;
};

static int compare_edges(const void *a, const void *b) { return memcmp(a, b, 2 * sizeof(int32_t)); }

/* All edges of all triangles, sorted: smaller end, larger end, 1 or -1 for the direction. */
static void list_edges(const struct sp_mesh *mesh, int32_t (*edges)[3]) {
    for (int32_t i = 0; i < 3 * mesh->triangle_count; i++) {
        int32_t a = mesh->indices[i], b = mesh->indices[i - i % 3 + (i + 1) % 3];
        edges[i][0] = a < b ? a : b, edges[i][1] = a < b ? b : a, edges[i][2] = a < b ? 1 : -1;
    }
    qsort(edges, 3 * (size_t)mesh->triangle_count, sizeof *edges, compare_edges);
}

/* Counts the distinct edges, those of one triangle (open), and those not passed once in each direction (bad). */
static int32_t inspect_edges(const struct sp_mesh *mesh, struct statistics *found) {
    int32_t count = 3 * mesh->triangle_count, distinct = 0;
    int32_t(*edges)[3] = malloc((size_t)count * sizeof *edges + 1);
    list_edges(mesh, edges);
    for (int32_t i = 0, next; i < count; i = next, distinct++) {
        int32_t sum = 0;
        for (next = i; next < count && compare_edges(edges[i], edges[next]) == 0; next++)
            sum += edges[next][2];
        found->open_edges += next - i == 1;
        found->bad_edges += next - i > 2 || (next - i == 2 && sum != 0);
    }
    free(edges);
    return distinct;
}

static int compare_doubles(const void *a, const void *b) {
    return (*(const double *)a > *(const double *)b) - (*(const double *)a < *(const double *)b);
}

static double angle_between(const double a[3], const double b[3]) {
    double aa = a[0] * a[0] + a[1] * a[1] + a[2] * a[2], bb = b[0] * b[0] + b[1] * b[1] + b[2] * b[2];
    double c = (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) / sqrt(aa * bb);
    return acos(fmax(-1, fmin(1, c))) * 57.29577951308232;
}

/* Smallest angle of a triangle in degrees; `turn`: cosine between its normal and the surface's at its first corner. */
static double triangle_angle(const struct sp_mesh *mesh, const int32_t t[3], double *turn) {
    double side[3][3], back[3][3], smallest = 180;
    for (int i = 0; i < 3; i++)
        for (int axis = 0; axis < 3; axis++) {
            side[i][axis] = mesh->positions[3 * t[(i + 1) % 3] + axis] - mesh->positions[3 * t[i] + axis];
            back[(i + 1) % 3][axis] = -side[i][axis];
        }
    for (int i = 0; i < 3; i++)
        smallest = fmin(smallest, angle_between(side[i], back[i]));
    double n[3];
    for (int axis = 0; axis < 3; axis++)
        n[axis] = side[0][(axis + 1) % 3] * side[1][(axis + 2) % 3] - side[0][(axis + 2) % 3] * side[1][(axis + 1) % 3];
    *turn = cos(angle_between(n, mesh->normals + 3 * t[0]) / 57.29577951308232);
    return smallest;
}

static void inspect_triangles(const struct sp_mesh *mesh, struct statistics *found) {
    double *angles = malloc((size_t)mesh->triangle_count * sizeof *angles + 1);
    found->worst_turn = 1;
    for (int32_t i = 0; i < mesh->triangle_count; i++) {
        double turn;
        angles[i] = triangle_angle(mesh, mesh->indices + 3 * i, &turn);
        found->worst_turn = fmin(found->worst_turn, turn);
        found->mean_angle += angles[i] / mesh->triangle_count;
    }
    qsort(angles, (size_t)mesh->triangle_count, sizeof *angles, compare_doubles);
    found->smallest_angle = mesh->triangle_count ? angles[0] : 0;
    found->worst_percent_angle = mesh->triangle_count ? angles[mesh->triangle_count / 100] : 0;
    free(angles);
}

/* Largest distance to the surface, |f|/|grad f|, relative to the box's diagonal, and whether the normals are the gradients'. */
static void inspect_vertices(sp_evaluate value, const struct sp_mesh *mesh, double diagonal, struct statistics *found) {
    for (int32_t i = 0; i < mesh->vertex_count; i++) {
        sp_pair in[3], out[4];
        for (int axis = 0; axis < 3; axis++)
            in[axis] = sp_splat(mesh->positions[3 * i + axis]);
        value(1, in, out);
        double length = sqrt(out[1][0] * out[1][0] + out[2][0] * out[2][0] + out[3][0] * out[3][0]);
        found->worst_residual = fmax(found->worst_residual, fabs(out[0][0]) / length / diagonal);
        for (int axis = 0; axis < 3; axis++)
            CHECK(fabs(out[1 + axis][0] / length - mesh->normals[3 * i + axis]) < 1e-14, "normal of vertex %d", (int)i);
    }
}

static struct sp_arena make_arena(size_t size) { return (struct sp_arena){aligned_alloc(16, (size + 15) & ~(size_t)15), size, 0}; }

static double diagonal_of(const double box[6]) {
    double x = box[1] - box[0], y = box[3] - box[2], z = box[5] - box[4];
    return sqrt(x * x + y * y + z * z);
}

static struct statistics inspect(sp_evaluate value, const struct sp_mesh *mesh, double diagonal) {
    struct statistics found = {0};
    found.euler = mesh->vertex_count - inspect_edges(mesh, &found) + mesh->triangle_count;
    inspect_triangles(mesh, &found);
    inspect_vertices(value, mesh, diagonal, &found);
    return found;
}

/* A closed surface: every edge in two triangles, passed in opposite directions, and the Euler characteristic of the surface. */
static void test_closed(const char *name, sp_evaluate value, const double box[6], int32_t resolution, int32_t euler) {
    struct sp_arena arena = make_arena((size_t)64 << 20);
    struct sp_mesh mesh;
    int32_t status = sp_mesh_implicit(value, box, resolution, &arena, &mesh);
    CHECK(status == SP_CONVERGED, "%s: status %d", name, (int)status);
    struct statistics found = inspect(value, &mesh, diagonal_of(box));
    printf("%-14s %3d: %6d triangles, angles min %.2f 1%% %.1f mean %.1f, residual %.1e, turn %.3f\n", name, (int)resolution,
           (int)mesh.triangle_count, found.smallest_angle, found.worst_percent_angle, found.mean_angle, found.worst_residual,
           found.worst_turn);
    CHECK(mesh.triangle_count > 100, "%s: %d triangles", name, (int)mesh.triangle_count);
    CHECK(found.open_edges == 0 && found.bad_edges == 0, "%s: %d open, %d bad edges", name, (int)found.open_edges, (int)found.bad_edges);
    CHECK(found.euler == euler, "%s: Euler characteristic %d, not %d", name, (int)found.euler, (int)euler);
    /* Rounding of f alone; measured 2.4e-16. */
    CHECK(found.worst_residual < 2e-15, "%s: residual %g of the diagonal", name, found.worst_residual);
    CHECK(found.worst_turn > 0.5, "%s: a triangle at cosine %g to the surface", name, found.worst_turn);
    CHECK(found.smallest_angle > 5 && found.worst_percent_angle > 15, "%s: angles from %g degrees", name, found.smallest_angle);
    free(arena.base);
}

/* On a face of the box, exactly. */
static bool on_box(const double point[3], const double box[6]) {
    for (int side = 0; side < 6; side++)
        if (point[side / 2] == box[side]) return true;
    return false;
}

/* Edges of a single triangle that do not have both ends on faces of the box. */
static int32_t open_edges_off_box(const struct sp_mesh *mesh, const double box[6]) {
    int32_t count = 3 * mesh->triangle_count, off = 0;
    int32_t(*edges)[3] = malloc((size_t)count * sizeof *edges + 1);
    list_edges(mesh, edges);
    for (int32_t i = 0; i < count; i++) {
        bool shared =
            (i > 0 && compare_edges(edges[i], edges[i - 1]) == 0) || (i + 1 < count && compare_edges(edges[i], edges[i + 1]) == 0);
        off += !shared && !(on_box(mesh->positions + 3 * edges[i][0], box) && on_box(mesh->positions + 3 * edges[i][1], box));
    }
    free(edges);
    return off;
}

/* A surface that leaves the box: a flat cut, its open edges on the faces of the box and nowhere else. */
static void test_cut_by_box(void) {
    static const double box[6] = {-1, 2.1, -0.5, 0.7, -1, 1};
    struct sp_arena arena = make_arena((size_t)16 << 20);
    struct sp_mesh mesh;
    CHECK(sp_mesh_implicit(plane, box, 40, &arena, &mesh) == SP_CONVERGED, "plane");
    struct statistics found = inspect(plane, &mesh, diagonal_of(box));
    CHECK(found.euler == 1 && found.bad_edges == 0 && found.open_edges > 50, "Euler characteristic %d", (int)found.euler);
    CHECK(open_edges_off_box(&mesh, box) == 0, "%d open edges inside the box", (int)open_edges_off_box(&mesh, box));
    free(arena.base);
}

/* f = 0 on whole planes of the lattice, and at single points of it: still a manifold. */
static void test_zeros(void) {
    static const double wide[6] = {-2, 2, -2, 2, -2, 2};
    for (int32_t resolution = 4; resolution <= 16; resolution += 4) {
        struct sp_arena arena = make_arena((size_t)8 << 20);
        struct sp_mesh mesh;
        CHECK(sp_mesh_implicit(cube_corner, wide, resolution, &arena, &mesh) == SP_CONVERGED, "xyz = 0");
        struct statistics found = {0};
        inspect_edges(&mesh, &found);
        CHECK(mesh.triangle_count > 0 && found.bad_edges == 0, "xyz = 0 at %d: %d bad edges", (int)resolution, (int)found.bad_edges);
        CHECK(open_edges_off_box(&mesh, wide) == 0, "xyz = 0 at %d", (int)resolution);
        free(arena.base);
    }
    test_closed("sphere, zeros", sphere, wide, 8, 2);
    test_closed("sphere, touches", sphere, (const double[6]){-1, 1, -1, 1, -1, 1}, 16, 2);
}

static double area_of(const struct sp_mesh *mesh) {
    double area = 0;
    for (int32_t i = 0; i < mesh->triangle_count; i++) {
        const int32_t *t = mesh->indices + 3 * i;
        const double *a = mesh->positions + 3 * t[0], *b = mesh->positions + 3 * t[1], *c = mesh->positions + 3 * t[2];
        double twice[3];
        for (int k = 0; k < 3; k++) {
            int m = (k + 1) % 3, n = (k + 2) % 3;
            twice[k] = (b[m] - a[m]) * (c[n] - a[n]) - (b[n] - a[n]) * (c[m] - a[m]);
        }
        area += sqrt(twice[0] * twice[0] + twice[1] * twice[1] + twice[2] * twice[2]) / 2;
    }
    return area;
}

/* Where f stops being a number the surface ends, all around in vertices on its rim; what would wall it off is NaN, and in no triangle. */
static void test_not_a_number(void) {
    enum { SECTORS = 64 };
    static const double box[6] = {-1.2, 1.2, -1.2, 1.2, -1.2, 1.2};
    struct sp_arena arena = make_arena((size_t)16 << 20);
    struct sp_mesh mesh;
    bool is_rim[SECTORS] = {false};
    CHECK(sp_mesh_implicit(torn, box, 20, &arena, &mesh) == SP_CONVERGED, "torn sphere");
    int32_t walled = 0, rim = 0;
    for (int32_t i = 0; i < mesh.vertex_count; i++) {
        const double *p = mesh.positions + 3 * i, *n = mesh.normals + 3 * i;
        int is_wall = isnan(p[0]) && isnan(p[1]) && isnan(p[2]) && isnan(n[0]) && isnan(n[1]) && isnan(n[2]);
        walled += is_wall;
        if (is_wall) continue;
        CHECK(fabs(sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) - 1) < 1e-14, "normal of vertex %d", (int)i);
        CHECK(fabs(sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) - 1) < 1e-14, "vertex %d is off the sphere", (int)i);
        CHECK(p[0] <= 0.3, "vertex %d at x = %g", (int)i, p[0]);
        if (p[0] > 0.3 - 1e-4 * 0.12) is_rim[(int)(SECTORS * (atan2(p[1], p[2]) / 6.2832 + 0.5))] = true;
    }
    for (int sector = 0; sector < SECTORS; sector++)
        rim += is_rim[sector];
    CHECK(rim == SECTORS, "%d of %d sectors end at the rim", (int)rim, SECTORS);
    CHECK(walled > 0 && 2 * walled < mesh.vertex_count, "%d of %d vertices are walls", (int)walled, (int)mesh.vertex_count);
    /* 2 pi 1.3, and what triangles of this size cut off. */
    CHECK(fabs(area_of(&mesh) - 8.168) < 0.03, "an area of %g", area_of(&mesh));
    free(arena.base);
}

static void nowhere(int32_t pair_count, const sp_pair *in, sp_pair *out) {
    for (int32_t k = 0; k < pair_count; k++)
        for (int j = 0; j < 4; j++)
            out[4 * k + j] = in[3 * k] * (double)NAN;
}

static void test_no_mesh(void) {
    static const double boxes[4][6] = {
        {0, 0, -1, 1, -1, 1}, {1, -1, -1, 1, -1, 1}, {-1, (double)NAN, -1, 1, -1, 1}, {-1, 1, -1, (double)INFINITY, -1, 1}};
    struct sp_arena arena = make_arena((size_t)1 << 20);
    struct sp_mesh mesh;
    for (int i = 0; i < 4; i++)
        CHECK(sp_mesh_implicit(sphere, boxes[i], 8, &arena, &mesh) == SP_NOT_FINITE, "box %d", i);
    const double inside[6] = {-0.5, 0.5, -0.5, 0.5, -0.5, 0.5};
    CHECK(sp_mesh_implicit(sphere, inside, 8, &arena, &mesh) == SP_CONVERGED && mesh.triangle_count == 0, "no surface in the box");
    CHECK(sp_mesh_implicit(nowhere, inside, 8, &arena, &mesh) == SP_CONVERGED && mesh.vertex_count == 0, "NaN everywhere");
    free(arena.base);
}

/* Every arena that is too small by any amount says so and is left alone; the counts it answers with lead to one that suffices. */
static void test_memory(void) {
    static const double box[6] = {-1.2, 1.2, -1.1, 1.3, -1.2, 1.2};
    struct sp_mesh mesh;
    struct sp_arena all = make_arena((size_t)1 << 20);
    CHECK(sp_mesh_implicit(sphere, box, 5, &all, &mesh) == SP_CONVERGED, "sphere");
    struct sp_mesh wanted = mesh;
    size_t scratch = (size_t)sp_mesh_bytes(box, 5, 0, 0),
           enough = (size_t)sp_mesh_bytes(box, 5, wanted.vertex_count, wanted.triangle_count);
    size_t arrays = (size_t)wanted.vertex_count * 48 + (size_t)wanted.triangle_count * 12;
    CHECK(all.used >= arrays && all.used < arrays + 48, "%zu bytes kept for %zu of arrays", all.used, arrays);
    int32_t refused = 0, learned = 0;
    for (size_t size = 0; size < enough; size += 8) {
        struct sp_arena arena = make_arena(size);
        int32_t status = sp_mesh_implicit(sphere, box, 5, &arena, &mesh);
        bool fits = status == SP_CONVERGED;
        refused += !fits;
        CHECK(fits || status == SP_OUT_OF_MEMORY, "%zu bytes: status %d", size, (int)status);
        CHECK(!fits || size + 48 >= enough, "%zu bytes were enough, not %zu", size, enough);
        CHECK(fits || (arena.used == 0 && !mesh.positions && !mesh.normals && !mesh.indices), "%zu bytes: used %zu", size, arena.used);
        bool counted = mesh.vertex_count == wanted.vertex_count && mesh.triangle_count == wanted.triangle_count;
        CHECK(size < scratch || counted, "%zu bytes: %d vertices", size, (int)mesh.vertex_count);
        learned += counted;
        free(arena.base);
    }
    CHECK(refused > 100 && learned > 100, "%d refused, %d counted", (int)refused, (int)learned);
    struct sp_arena arena = make_arena(enough);
    CHECK(sp_mesh_implicit(sphere, box, 5, &arena, &mesh) == SP_CONVERGED, "%zu bytes", enough);
    CHECK(memcmp(mesh.positions, wanted.positions, (size_t)mesh.vertex_count * 24) == 0, "same positions");
    CHECK(memcmp(mesh.indices, wanted.indices, (size_t)mesh.triangle_count * 12) == 0, "same indices");
    free(arena.base);
    free(all.base);
}

/* Oriented towards growing f: the volume enclosed is that of the ball, and positive. */
static void test_volume(void) {
    static const double box[6] = {-1.2, 1.2, -1.2, 1.2, -1.2, 1.2};
    struct sp_arena arena = make_arena((size_t)32 << 20);
    struct sp_mesh mesh;
    double volume = 0;
    CHECK(sp_mesh_implicit(sphere, box, 32, &arena, &mesh) == SP_CONVERGED, "sphere");
    for (int32_t i = 0; i < mesh.triangle_count; i++) {
        const double *a = mesh.positions + 3 * mesh.indices[3 * i], *b = mesh.positions + 3 * mesh.indices[3 * i + 1];
        const double *c = mesh.positions + 3 * mesh.indices[3 * i + 2];
        volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6;
    }
    /* A chord of length h leaves out h^2/8 of the radius: below 0.3 % for h <= 0.1. */
    CHECK(volume > 0 && fabs(volume / 4.188790204786391 - 1) < 3e-3, "volume %g", volume);
    free(arena.base);
}

int main(void) {
    static const double unit[6] = {-1.2, 1.2, -1.2, 1.2, -1.2, 1.2}, torus_box[6] = {-5.7, 5.7, -5.7, 5.7, -5.7, 5.7};
    static const double two[6] = {-2, 2, -2, 2, -2, 2}, long_box[6] = {-8, 8, -1.1, 1.2, -1.3, 1.4};
    for (int32_t resolution = 24; resolution <= 48; resolution += 12) {
        test_closed("sphere", sphere, unit, resolution, 2);
        test_closed("torus", torus, torus_box, resolution, 0);
        test_closed("genus 2", genus2, two, resolution, -2);
        test_closed("metamorphosis", metamorphosis, two, resolution, 2);
    }
    test_closed("three tori", three_tori, two, 80, 0);
    test_closed("three tori", three_tori, two, 96, 0);
    test_closed("sphere, long", sphere, long_box, SP_MESH_MAX_RESOLUTION + 1, 2);
    test_cut_by_box();
    test_zeros();
    test_not_a_number();
    test_no_mesh();
    test_memory();
    test_volume();
    printf("mesh: %d failures\n", failures);
    return failures != 0;
}
