/* Where elements meet: closer where the path turns, or at its ends. MATH.md, "The ladder". */
#include "refine_spread.h"
#include "sample.h"
#include "scalar.h"

/* Elements are no longer spread evenly if somewhere the path turns so many times faster than on an average. Then this part of their widths
 * stays even, so that none is without width. */
static const double UNEVEN = 3, EVENLY = 1e-6;

/* By how much the path's velocity changes at each node, in parts of itself: by how many radians it turns, about, where its speed is even,
 * as it is without a density; and the node's parameter. Returns the sum of the turns. */
static double measure_turns(const struct sp_system *system, sp_pair *turns) {
    struct sp_fold fold = system->line.fold;
    double at[3] = {0}, velocity[3] = {0}, from = 0, total = 0;
    for (int32_t i = 0; i <= fold.inner + 1; i++) {
        const sp_pair *chart = system->line.nodes.charts + (size_t)SP_CHART * (size_t)sp_fold_pair(fold, i) + SP_CHART_X;
        double to = sp_sample_parameter(&system->elements, i), rate = i > 0 ? 1 / (to - from) : 0, by = 0, size = 0;
        for (int c = 0; c < 3; c++) {
            double x = chart[c][sp_fold_lane(fold, i)], now = rate * (x - at[c]), change = now - velocity[c];
            by += change * change, size += now * now + velocity[c] * velocity[c];
            at[c] = x, velocity[c] = now;
        }
        turns[i] = (sp_pair){0, from = to};
        if (i > 1 && size > 0) total += turns[i - 1][0] = root(2 * by / size);
    }
    return total;
}

int sp_spread_elements(const struct sp_system *system, sp_pair *turns, double spread[SP_SPREAD + 1]) {
    int32_t k = 1;
    double total = 1 + measure_turns(system, turns), passed = 0, most = 0;
    for (int32_t i = 0; i <= system->line.fold.inner; i++) {
        double from = turns[i][1], span = turns[i + 1][1] - from, part = span + 0.5 * (turns[i][0] + turns[i + 1][0]);
        most = larger(most, part / span);
        for (; k < SP_SPREAD && passed + part >= total * k / SP_SPREAD; k++)
            spread[k] = from + span * ((total * k / SP_SPREAD - passed) / part);
        passed += part;
    }
    for (spread[0] = 0; k <= SP_SPREAD; k++)
        spread[k] = 1;
    for (k = 1; k < SP_SPREAD; k++)
        spread[k] += EVENLY * ((double)k / SP_SPREAD - spread[k]);
    return most > UNEVEN * total;
}

void sp_spread_close(double least, double spread[SP_SPREAD + 1]) {
    double ratio = 1 / least, far = 0.5 * least;
    for (int k = SP_SPREAD / 2; k > 1; k /= 2)
        ratio = root(ratio);
    for (int k = 1; k <= SP_SPREAD / 2; k++)
        far *= ratio, spread[k] = far, spread[SP_SPREAD - k] = 1 - far;
    spread[0] = 0, spread[SP_SPREAD] = 1;
}
