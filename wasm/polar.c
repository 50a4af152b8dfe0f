/* Surfaces over the plane around a pole: their charts from those over u and v, by the chain rule. MATH.md, "Arcs". */
#include "polar.h"
#include "functions.h"
#include "metric.h"
#include "scalar.h"

/* Of the first path: what is near a pole is small. */
enum { POINTS = 129 };
/* Radians: ends half a turn apart may be more than that to rounding, and by as much as a smooth surface may seem not to be one. */
static const double TURN = 6.28318530717958647693, SLACK = 1e-5;
/* Of the ends' distances: nearer than that derivatives lose more to rounding than they change, those of a tensor, divided by squares,
 * sooner. Of the range: what rounding leads outside. Of the edge's coordinate: from there on its rounding does not spoil a tensor. */
static const double LEAST = 1e-8, LEAST_OF_TENSOR = 1e-5, INSIDE = 1e-12, QUIET = 2e-8, MOST_QUIET = 1e3;

static const struct sp_polar *polar_of(const struct sp_surface *surface) { return (const struct sp_polar *)surface; }

double sp_polar_offset(const struct sp_surface *surface) { return surface->metric >= SP_POLAR ? absolute(polar_of(surface)->edge) : 0; }

/* u v at the distance r from the pole, in the direction `angle`, from the middle. */
static void place_at(const struct sp_polar *polar, sp_pair r, sp_pair angle, sp_pair place[2]) {
    sp_pair outwards = polar->edge + polar->side * r, around = polar->middle + angle / polar->rate;
    place[0] = polar->across ? around : outwards, place[1] = polar->across ? outwards : around;
}

void sp_polar_leave(const struct sp_polar *polar, int32_t pair_count, const sp_pair *places, sp_pair *left) {
    for (int32_t k = 0; k < pair_count; k++) {
        sp_pair p = places[2 * k], q = places[2 * k + 1];
        place_at(polar, sp_square_root(p * p + q * q), sp_atan2(q, p), left + 2 * k);
    }
}

void sp_positions(const struct sp_surface *surface, int32_t pair_count, const sp_pair *places, sp_pair *positions) {
    for (int32_t k = 0; surface->metric >= SP_POLAR && k < pair_count; k++) {
        sp_pair place[2];
        sp_polar_leave(polar_of(surface), 1, places + 2 * k, place);
        surface->value(1, place, positions + SP_PARAMETRIC_VALUES * k);
    }
    if (surface->metric < SP_POLAR) surface->value(pair_count, places, positions);
}

/* A jet that stands in every third number, times factor/r, r the distance from the pole: over = 1/r, side its derivative. */
static void divide(int32_t across, sp_pair over, double side, double factor, sp_pair *f) {
    int32_t a = 3 + 3 * across, l = 6 - 3 * across, aa = 9 + 6 * across, al = 12;
    for (int i = 0; i < 18; i += 3)
        f[i] *= factor * over;
    over *= side;
    f[a] -= over * f[0], f[al] -= over * f[l], f[aa] -= 2.0 * over * f[a];
}

/* Makes E, F, G those over p and q, still as functions of u and v. With the tensor A, B, C over dr and r dθ, W = (A - C)/2 + iB turns into
 * W e^(2iθ), (A + C)/2 stays. */
static void turn_tensor(const struct sp_polar *polar, sp_pair over, sp_pair s, sp_pair c, sp_pair *jet) {
    int32_t across = polar->across, a = 3 + 3 * across, l = 6 - 3 * across, ll = 15 - 6 * across, al = 12;
    double side = polar->side, slower = 1 / polar->rate, k = 2 * polar->rate;
    sp_pair *outwards = jet + 2 * across, *mixed = jet + 1, *around = jet + 2 - 2 * across, cosine = c * c - s * s, sine = 2.0 * s * c;
    divide(across, over, side, side * slower, mixed);
    divide(across, over, side, slower, around), divide(across, over, side, slower, around);
    for (int i = 0; i < 18; i += 3)
        around[i] = 0.5 * (outwards[i] + around[i]), outwards[i] -= around[i];
    /* W_ll + 2ik W_l - k^2 W, W_al + ik W_a, W_l + ik W: along the edge e^(2iθ) changes by ik. */
    outwards[ll] -= k * (2.0 * mixed[l] + k * outwards[0]), mixed[ll] += k * (2.0 * outwards[l] - k * mixed[0]);
    outwards[al] -= k * mixed[a], mixed[al] += k * outwards[a];
    outwards[l] -= k * mixed[0], mixed[l] += k * outwards[0];
    for (int i = 0; i < 18; i += 3) {
        sp_pair x = cosine * outwards[i] - sine * mixed[i], y = sine * outwards[i] + cosine * mixed[i], mean = around[i];
        jet[i] = mean + x, jet[i + 1] = y, jet[i + 2] = mean - x;
    }
}

/* Values and derivatives by p and q of `count` functions, 6 count numbers. Nearer to the pole than `least` it is continued linearly. */
static void polar_jet(const struct sp_polar *polar, int32_t count, const sp_pair *place, sp_pair *jet) {
    sp_pair p = place[0], q = place[1], r = sp_square_root(p * p + q * q), angle = sp_atan2(q, p), at[2], c;
    sp_pair s = sp_sincos(angle, &c), radius = sp_select(r > sp_splat(polar->least), r, sp_splat(polar->least)), over = 1.0 / radius;
    double side = polar->side, slower = 1 / polar->rate;
    int32_t across = polar->across;
    place_at(polar, radius, angle, at);
    polar->whole->jet(1, at, jet);
    if (polar->whole->metric == SP_TENSOR) turn_tensor(polar, over, s, c, jet);
    for (sp_pair *f = jet; f < jet + count; f++) {
        sp_pair *first = f + count, *second = f + 3 * count;
        sp_pair outwards = side * first[count * across], around = slower * over * first[count * (1 - across)];
        sp_pair rr = second[2 * count * across], mixed = (side * slower * second[count] - around) * over;
        sp_pair bent = (slower * slower * over * second[2 * count * (1 - across)] + outwards) * over;
        f[0] += outwards * (r - radius);
        first[0] = c * outwards - s * around, first[count] = s * outwards + c * around;
        second[0] = c * c * rr - 2.0 * c * s * mixed + s * s * bent;
        second[count] = c * s * (rr - bent) + (c * c - s * s) * mixed;
        second[2 * count] = s * s * rr + 2.0 * c * s * mixed + c * c * bent;
    }
}

static void polar_charts(const struct sp_surface *surface, int32_t pair_count, const sp_pair *places, sp_pair *charts, sp_pair *metrics) {
    int32_t count = surface->metric == SP_POLAR ? 3 : 4;
    for (int32_t k = 0; k < pair_count; k++) {
        sp_pair jet[SP_PARAMETRIC_DENSITY_JET];
        polar_jet(polar_of(surface), count, places + 2 * k, jet);
        for (int32_t i = 0; i < SP_METRIC_PARTS; i++) {
            sp_store(sp_load(jet + count * i), charts + 3 * (SP_METRIC_PARTS * k + i));
            if (count == 4) metrics[SP_METRIC_PARTS * k + i] = jet[4 * i + 3];
        }
    }
}

static void polar_tensor_charts(const struct sp_surface *surface, int32_t pair_count, const sp_pair *places, sp_pair *charts,
                                sp_pair *metrics) {
    sp_flat_charts(pair_count, places, charts);
    for (int32_t k = 0; k < pair_count; k++)
        polar_jet(polar_of(surface), 3, places + 2 * k, metrics + SP_PARAMETRIC_TENSOR_JET * k);
}

/* Over p and q, from u and v. */
static void enter(const struct sp_polar *polar, const double *place, double *entered) {
    double r = polar->side * (place[polar->across] - polar->edge);
    sp_pair c, s = sp_sincos(sp_splat(polar->rate * (place[1 - polar->across] - polar->middle)), &c);
    entered[0] = r * c[0], entered[1] = r * s[0];
}

int sp_polar_make(struct sp_polar *polar, const struct sp_surface *surface, const struct sp_request *request, struct sp_arena *arena,
                  struct sp_request *moved) {
    const struct sp_passage *passage = &request->passage;
    int32_t across = passage->edge / 2, upper = passage->edge % 2;
    double open = __builtin_inf(), turn = passage->turn,
           edge = upper ? surface->upper[across] + passage->beyond : surface->lower[across] - passage->beyond;
    double from = request->from[1 - across], to = request->to[1 - across], middle = 0.5 * (from + to);
    *polar = (struct sp_polar){*surface, surface, across, edge, upper ? -1 : 1, middle, TURN / turn, turn, 0};
    polar->surface.metric += SP_POLAR;
    *moved = *request, moved->passage.way = SP_FREE;
    if (request->start) {
        double *start = sp_arena_take(arena, 2 * (size_t)request->start_count, sizeof(double));
        for (int32_t i = 0; start && i < request->start_count; i++)
            enter(polar, request->start + 2 * i, start + 2 * i);
        moved->start = start;
    }
    if (!moved->start) moved->start_count = POINTS;
    for (int j = 0; j < 2; j++) {
        const double *end = j ? request->to : request->from;
        double theta = polar->rate * (end[1 - across] - middle);
        if (!(2 * theta < TURN / 2 + SLACK && 2 * theta > -TURN / 2 - SLACK)) return 0;
        enter(polar, end, j ? moved->to : moved->from);
        polar->least += (surface->metric == SP_TENSOR ? LEAST_OF_TENSOR : LEAST) * polar->side * (end[across] - edge);
        polar->surface.lower[j] = -open, polar->surface.upper[j] = open;
    }
    if (surface->metric == SP_TENSOR) polar->least = larger(polar->least, smaller(QUIET * absolute(edge), MOST_QUIET * polar->least));
    return 1;
}

int sp_polar_holds(const struct sp_polyline *line) {
    const struct sp_surface *whole = polar_of(line->surface)->whole;
    for (int32_t i = 0; i <= line->fold.inner; i++) {
        double from[2], step[2];
        sp_pair place[2];
        for (int32_t j = 0; j < 2; j++)
            from[j] = sp_polyline_coordinate(line, i, j), step[j] = sp_polyline_coordinate(line, i + 1, j) - from[j];
        double t = -(from[0] * step[0] + from[1] * step[1]) / (step[0] * step[0] + step[1] * step[1]);
        t = t > 0 ? t < 1 ? t : 1 : 0;
        for (int32_t j = 0; j < 2; j++)
            place[j] = (sp_pair){from[j], from[j] + t * step[j]};
        sp_polar_leave(polar_of(line->surface), 1, place, place);
        for (int j = 0; j < 2; j++) {
            double slack = INSIDE * (whole->upper[j] - whole->lower[j]);
            if (sp_any((place[j] < sp_splat(whole->lower[j] - slack)) | (place[j] > sp_splat(whole->upper[j] + slack)))) return 0;
        }
    }
    return 1;
}

void sp_polar_return(const struct sp_polar *polar, const struct sp_request *request, int32_t count, double *parameters) {
    int32_t along = 1 - polar->across;
    for (int32_t i = 0; i < count; i++) {
        double *place = parameters + 2 * i;
        sp_pair at[2] = {sp_splat(place[0]), sp_splat(place[1])};
        const double *end = i == 0 ? request->from : request->to;
        sp_polar_leave(polar, 1, at, at);
        for (int j = 0; j < 2; j++)
            place[j] = i == 0 || i == count - 1 ? end[j] : at[j][0];
        for (int turns = -1; i && turns <= 1; turns++) {
            double step = at[along][0] + turns * polar->turn - place[along - 2];
            if (step >= -polar->turn / 2 && step < polar->turn / 2) place[along] += turns * polar->turn;
        }
    }
}

const struct sp_kind sp_polar_kind = {SP_PARAMETRIC_INPUTS, 0, polar_charts, sp_parametric_move};
const struct sp_kind sp_polar_density_kind = {SP_PARAMETRIC_INPUTS, 1, polar_charts, sp_parametric_move};
const struct sp_kind sp_polar_tensor_kind = {SP_PARAMETRIC_INPUTS, 3, polar_tensor_charts, sp_straight_move};
