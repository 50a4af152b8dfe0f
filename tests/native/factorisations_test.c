/* How often Newton factorises the Hessian, which is most of what a step of elements costs. Its two files are compiled here once more, under
 * other names, with a count. */
#include "system.h"

static int factorised;
static struct sp_inertia counted_factor(struct sp_system *system, double shift) { return factorised++, sp_system_factor(system, shift); }

#define sp_system_factor counted_factor
#define sp_newton_step counted_step
#define sp_newton_step_paper counted_step_paper
#define sp_newton_try counted_try
#define sp_newton_try_blindly counted_try_blindly
#define sp_newton_accept counted_accept
#define sp_newton_take counted_take
#define sp_newton_bytes counted_bytes
#define sp_newton_tell_end counted_tell_end
#define sp_newton_run counted_run
#define sp_newton_confirm counted_confirm
#include "newton.c"
#include "newton_step.c"

#include "surfaces.h"
#include "testing.h"

enum { INNER = 31 };

static sp_pair memory[1 << 16];

/* A path along v = `across`, its nodes equally far apart. */
static struct sp_newton path_along(const struct sp_surface *surface, const struct sp_options *options, double length, double across) {
    struct sp_arena arena = {(char *)memory, sizeof memory, 0};
    struct sp_newton newton = {0};
    CHECK(sp_newton_take(&newton, surface, options, INNER, &arena), "arena");
    struct sp_polyline *line = &newton.system.line;
    for (int32_t i = 0; i <= INNER + 1; i++) {
        sp_pair *place = line->nodes.places + 2 * sp_fold_pair(line->fold, i);
        int32_t lane = sp_fold_lane(line->fold, i);
        place[0][lane] = length * i / (INNER + 1), place[1][lane] = across;
        if (2 * i == INNER + 1) place[0] = sp_splat(place[0][lane]), place[1] = sp_splat(across);
    }
    sp_fold_mirror(line->fold, line->nodes.places, 2);
    sp_polyline_charts(line, &line->nodes);
    return newton;
}

/* The saddle, whose second derivatives are no numbers: those of a root are none where it is zero. */
static void broken_jet(int32_t count, const sp_pair *in, sp_pair *out) {
    saddle_jet(count, in, out);
    for (int32_t i = 0; i < count; i++)
        out[18 * i + 11] = sp_splat(__builtin_nan(""));
}

int main(void) {
    struct sp_options options = {.algorithm = SP_POLYLINE, .point_count = INNER, .max_iterations = 0, .tolerance = 1e-9};

    struct sp_surface broken = saddle_surface;
    broken.jet = broken_jet;
    struct sp_newton newton = path_along(&broken, &options, 0.9, 0.3);
    struct sp_round round = {0};
    assemble(&newton, &options, &round);
    factorised = 0;
    CHECK(sp_newton_step(&newton, &round) == 0, "no step without second derivatives");
    CHECK(factorised == 2, "%d factorisations of what is no number, whatever is added", factorised);

    /* Beyond half of a great circle: at rest, of negative curvature by 1e-4, which 20 trials, each of four times as much, would tell. */
    newton = path_along(&globe_surface, &options, 3.14159265358979 + 1e-4, 0);
    factorised = 0;
    CHECK(sp_newton_run(&newton, &options).status >= 0, "a path");
    CHECK(factorised > 0 && factorised <= 7, "%d factorisations to tell how soft a path is", factorised);
    return checks_failed();
}
