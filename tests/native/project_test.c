/* The closest point of a surface: against the best of a fine grid, at walls, poles and cusps, and where there is none. */
#include "surfaces.h"
#include "surfpath.h"
#include "testing.h"

#include <math.h>
#include <string.h>

static double constant;
static void constant_surface(int32_t count, const sp_pair *in, sp_pair *out, int values) {
    (void)in;
    for (int32_t i = 0; i < count * values; i++)
        out[i] = sp_splat(constant);
}

COMPILED(constant_surface, SP_PARAMETRIC_JET, SP_PARAMETRIC_VALUES)

static const struct sp_surface no_surface = {constant_surface_jet, constant_surface_value, SP_PARAMETRIC, 0, {-1, -1}, {1, 1}, 0};

static double distance(const struct sp_surface *surface, const double place[2], const double point[3]) {
    sp_pair in[2] = {sp_splat(place[0]), sp_splat(place[1])}, out[3];
    surface->value(1, in, out);
    double x = out[0][0] - point[0], y = out[1][0] - point[1], z = out[2][0] - point[2];
    return sqrt(x * x + y * y + z * z);
}

/* The best of a grid over the rectangle `ends`: where to start from, and what must be beaten. */
static double search_grid(const struct sp_surface *surface, const double ends[4], const double point[3], double best[2]) {
    enum { CELLS = 60 };
    double least = INFINITY;
    for (int i = 0; i <= CELLS; i++)
        for (int j = 0; j <= CELLS; j++) {
            double place[2] = {ends[0] + (ends[1] - ends[0]) * i / CELLS, ends[2] + (ends[3] - ends[2]) * j / CELLS};
            double away = distance(surface, place, point);
            if (away < least) least = away, best[0] = place[0], best[1] = place[1];
        }
    return least;
}

/* Random points, most of them beyond the walls: no farther than the best of the grid, in the rectangle, and no neighbour is closer. */
static void check_random(const char *name, const struct sp_surface *surface, const double ends[4], uint64_t seed) {
    for (int i = 0; i < 300; i++) {
        double point[3], place[3] = {0};
        for (int j = 0; j < 3; j++)
            point[j] = 5 * random_unit(&seed) - 2.5;
        double grid = search_grid(surface, ends, point, place);
        int32_t status = sp_project_point(surface, point, place);
        double found = distance(surface, place, point);
        CHECK(status == SP_CONVERGED || status == SP_STALLED, "%s %d: status %d", name, i, status);
        CHECK(found <= grid, "%s %d: %.17g, the grid has %.17g", name, i, found, grid);
        for (int j = 0; j < 2; j++)
            CHECK(place[j] >= surface->lower[j] && place[j] <= surface->upper[j], "%s %d: outside", name, i);
        for (int direction = 0; direction < 16 && status == SP_CONVERGED; direction++) {
            double angle = direction * 3.14159265358979 / 8, near[2] = {place[0] + 1e-4 * cos(angle), place[1] + 1e-4 * sin(angle)};
            int inside = near[0] >= surface->lower[0] && near[0] <= surface->upper[0] && near[1] >= surface->lower[1] &&
                         near[1] <= surface->upper[1];
            CHECK(!inside || distance(surface, near, point) >= found - 1e-12, "%s %d: closer by %g", name, i,
                  found - distance(surface, near, point));
        }
    }
}

/* A start as far away as can be still leads to a wall, to a pole, or to the point itself. */
static void check_far_starts(void) {
    double point[3] = {-2, -2, 0}, place[3] = {1, 1.1, 0};
    CHECK(sp_project_point(&saddle_surface, point, place) == SP_CONVERGED, "%g %g", place[0], place[1]);
    double beyond[3] = {40, -40, 0}, outside[3] = {7, -7, 0};
    CHECK(sp_project_point(&saddle_surface, beyond, outside) == SP_CONVERGED && outside[0] == 1 && outside[1] == -1.1, "%g %g", outside[0],
          outside[1]);
    double above[3] = {0, 0, 5}, at_pole[3] = {0.3, 1.57079632679489661923, 0};
    CHECK(sp_project_point(&whole_globe_surface, above, at_pole) >= 0, "%g", at_pole[1]);
    CHECK(fabs(distance(&whole_globe_surface, at_pole, above) - 4) < 1e-12, "%g", distance(&whole_globe_surface, at_pole, above));
    double equator[3] = {2, 0, 0}, from_pole[3] = {0, 1.57079632679489661923, 0};
    int32_t status = sp_project_point(&whole_globe_surface, equator, from_pole);
    CHECK(status >= 0 && distance(&whole_globe_surface, from_pole, equator) <= sqrt(5.0), "status %d, %g", status, from_pole[1]);
    double edge[3] = {0.4, -1, 0}, on_cusp[3] = {0, 0, 0};
    CHECK(sp_project_point(&cusp_surface, edge, on_cusp) >= 0 && fabs(on_cusp[1]) < 1e-3, "%g %g", on_cusp[0], on_cusp[1]);
}

/* The centre of a sphere is as far from all of it; a torus has a far side. */
static void check_implicit(void) {
    double centre[3] = {0, 0, 0}, place[3] = {0.6, 0, 0.8};
    CHECK(sp_project_point(&sphere_surface, centre, place) == SP_CONVERGED, "the centre");
    CHECK(fabs(place[0] - 0.6) < 1e-12 && fabs(place[2] - 0.8) < 1e-12, "moved to %g %g %g", place[0], place[1], place[2]);
    double outside[3] = {9, 0, 0}, far[3] = {0, -5.4, 0.3};
    CHECK(sp_project_point(&torus_surface, outside, far) == SP_CONVERGED && fabs(far[0] - 5.5) < 1e-9, "%g %g %g", far[0], far[1], far[2]);
    double away[3] = {1e6, 0, 0}, below[3] = {1e6, 0, 0};
    CHECK(sp_project_point(&sphere_surface, away, below) == SP_CONVERGED && fabs(below[0] - 1) < 1e-12, "%g", below[0]);
}

/* Without a surface: a status, and the place as it was or a point of the rectangle. */
static void check_hostile(void) {
    const double constants[] = {0, 1, NAN, INFINITY, 1e308, 1e-200};
    for (int i = 0; i < 6; i++) {
        constant = constants[i];
        double point[3] = {0.1, 0.2, 0.3}, place[3] = {0.5, 0.25, 0};
        int32_t status = sp_project_point(&no_surface, point, place);
        CHECK(status == SP_NOT_FINITE || status >= 0, "%g: status %d", constants[i], status);
        CHECK(fabs(place[0]) <= 1 && fabs(place[1]) <= 1, "%g: %g %g", constants[i], place[0], place[1]);
        CHECK(status != SP_NOT_FINITE || (place[0] == 0.5 && place[1] == 0.25), "%g: moved", constants[i]);
    }
}

int main(void) {
    check_random("saddle", &saddle_surface, (double[]){-1, 1, -1.1, 1.1}, 1);
    check_random("bumpy", &bumpy_surface, (double[]){-3.2, 3.2, -3.2, 3.2}, 2);
    check_random("globe", &globe_surface, (double[]){-3.2, 3.2, -1.5, 1.5}, 3);
    check_random("cusp", &cusp_surface, (double[]){-1, 1, -1, 1}, 4);
    check_far_starts();
    check_implicit();
    check_hostile();
    return checks_failed();
}
