/* Where elements meet: closer where the path turns, where they leave much over, or at its ends. MATH.md, "The ladder". */
#include "refine_spread.h"
#include "sample.h"
#include "scalar.h"

/* Elements are no longer spread evenly if somewhere they would lie so many times closer than on an average. Then this part of their widths
 * stays even, so that none is without width. */
static const double UNEVEN = 3, EVENLY = 1e-6;
/* Last coefficients are no smaller than rounding, in parts of the largest coordinate. */
static const double LEAST_TAIL = 1e-14;

/* Both measures write pieces of the path, one after another: how much of the elements each wants, and the path's parameter where it ends;
 * and return their number. */

/* A piece a chord, or two nodes of an element: its part of the path, and by how many radians it turns at their ends, about: by how much the
 * velocity changes, in parts of itself. */
static int32_t measure_turns(const struct sp_system *system, sp_pair *pieces) {
    struct sp_fold fold = system->line.fold;
    double at[3] = {0}, velocity[3] = {0}, from = 0;
    for (int32_t i = 0; i <= fold.inner + 1; i++) {
        const sp_pair *chart = system->line.nodes.charts + (size_t)SP_CHART * (size_t)sp_fold_pair(fold, i) + SP_CHART_X;
        double to = sp_sample_parameter(&system->elements, i), rate = i > 0 ? 1 / (to - from) : 0, by = 0, size = 0;
        for (int c = 0; c < 3; c++) {
            double x = chart[c][sp_fold_lane(fold, i)], now = rate * (x - at[c]), change = now - velocity[c];
            by += change * change, size += now * now + velocity[c] * velocity[c];
            at[c] = x, velocity[c] = now;
        }
        double half = i > 1 && size > 0 ? 0.5 * root(2 * by / size) : 0;
        if (i > 1) pieces[i - 2][0] += half;
        if (i > 0) pieces[i - 1] = (sp_pair){to - from + half, to};
        from = to;
    }
    return fold.inner + 1;
}

/* Numbers of nodes: so many of each, in pairs of nodes `stride` apart. */
struct numbers {
    const sp_pair *pairs;
    size_t stride;
    int count;
};

/* The square of what an element leaves over: of the last two Legendre coefficients of its nodes' numbers, the largest of which is
 * `largest`. At GLL nodes 1/P_p is a root of the weight, but for its sign, and P_p-1 is t P_p. */
static double tail_squared(const struct sp_system *system, const struct numbers *numbers, int32_t element, double *largest) {
    const struct sp_reference *reference = &system->elements.reference;
    struct sp_fold fold = system->line.fold;
    int32_t p = reference->degree;
    double last[6] = {0}, squares = 0;
    for (int32_t j = 0; j <= p; j++) {
        int32_t i = element * p + j;
        const sp_pair *node = numbers->pairs + numbers->stride * (size_t)sp_fold_pair(fold, i);
        double factor = root(reference->weight[j] * p / (p + 1)) * ((p - j) % 2 ? -1 : 1);
        for (int c = 0; c < numbers->count; c++) {
            double x = node[c][sp_fold_lane(fold, i)];
            last[c] += factor * x, last[3 + c] += (2.0 - 1.0 / p) * (2 * reference->node[j] - 1) * factor * x;
            *largest = larger(*largest, absolute(x));
        }
    }
    for (int c = 0; c < 6; c++)
        squares += last[c] * last[c];
    return squares;
}

double sp_spread_tail(const struct sp_system *system) {
    int32_t dimension = system->line.kind->dimension;
    struct numbers places = {system->line.nodes.places, (size_t)dimension, dimension};
    double squares = 0, largest = 0, extent = 0;
    for (int32_t e = 0; e < system->elements.count; e++)
        squares = larger(squares, tail_squared(system, &places, e, &largest));
    for (int c = 0; c < dimension; c++)
        extent = larger(extent, absolute(places.pairs[c][1] - places.pairs[c][0]));
    return root(squares) / extent;
}

/* A piece an element: some root of what its positions leave over. */
static int32_t measure_tails(const struct sp_system *system, sp_pair *pieces) {
    const struct sp_elements *elements = &system->elements;
    struct numbers positions = {system->line.nodes.charts + SP_CHART_X, SP_CHART, 3};
    int32_t p = elements->reference.degree;
    double largest = 0;
    for (int32_t e = 0; e < elements->count; e++)
        pieces[e] = (sp_pair){tail_squared(system, &positions, e, &largest), sp_sample_parameter(elements, e * p + p)};
    for (int32_t e = 0; e < elements->count; e++)
        pieces[e][0] = root(root(root(root(pieces[e][0] + LEAST_TAIL * LEAST_TAIL * largest * largest))));
    return elements->count;
}

int sp_spread_elements(const struct sp_system *system, sp_pair *pieces, double spread[SP_SPREAD + 1]) {
    /* What is left over tells best, but neither what a metric does between nodes nor how to close in on a singular curve. */
    int uneven = system->elements.spread && system->line.kind->components == 0 && !sp_elements_graded(&system->elements);
    int32_t count = uneven ? measure_tails(system, pieces) : measure_turns(system, pieces), k = 1;
    double total = 0, passed = 0, most = 0, from = 0;
    for (int32_t i = 0; i < count; i++)
        total += pieces[i][0];
    for (int32_t i = 0; i < count; i++) {
        double part = pieces[i][0], span = pieces[i][1] - from;
        most = larger(most, part / span);
        for (; k < SP_SPREAD && passed + part >= total * k / SP_SPREAD; k++)
            spread[k] = from + span * ((total * k / SP_SPREAD - passed) / part);
        passed += part, from = pieces[i][1];
    }
    for (spread[0] = 0; k <= SP_SPREAD; k++)
        spread[k] = 1;
    for (k = 1; k < SP_SPREAD; k++)
        spread[k] += EVENLY * ((double)k / SP_SPREAD - spread[k]);
    return uneven || most > UNEVEN * total;
}

void sp_spread_close(double least, double spread[SP_SPREAD + 1]) {
    double ratio = 1 / least, far = 0.5 * least;
    for (int k = SP_SPREAD / 2; k > 1; k /= 2)
        ratio = root(ratio);
    for (int k = 1; k <= SP_SPREAD / 2; k++)
        far *= ratio, spread[k] = far, spread[SP_SPREAD - k] = 1 - far;
    spread[0] = 0, spread[SP_SPREAD] = 1;
}
