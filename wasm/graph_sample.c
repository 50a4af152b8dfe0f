/* What a graph's lengths are measured by: samples of positions and metrics, evaluated in blocks, and the lengths between them. */
#include "graph_build.h"
#include "metric.h"
#include "scalar.h"

static const double LEAST_COSINE = 0.3, LARGEST_SINE = 0.6;

/* Rules of two and of three samples differ by this part where neither is near: a metric jumps, or nearly. Then there are so many pieces. */
static const double UNEVEN = 0.1;
enum { PIECES = 16 };

int sp_graph_has_positions(const struct sp_surface *surface) { return surface->kind != SP_PARAMETRIC || surface->metric != SP_TENSOR; }

int32_t sp_graph_width(const struct sp_surface *surface) { return 3 * sp_graph_has_positions(surface) + sp_kind_of(surface)->components; }

void sp_block_open(struct sp_block *block, const struct sp_surface *surface, int metric) {
    static const int32_t JETS[2][3] = {{0, SP_PARAMETRIC_DENSITY_JET, SP_PARAMETRIC_TENSOR_JET},
                                       {0, SP_IMPLICIT_DENSITY_JET, SP_IMPLICIT_TENSOR_JET}};
    int implicit = surface->kind == SP_IMPLICIT, by_jet = metric && surface->metric != SP_INDUCED;
    block->surface = surface, block->evaluate = by_jet ? surface->jet : surface->value;
    block->inputs = implicit ? SP_IMPLICIT_INPUTS : SP_PARAMETRIC_INPUTS;
    block->outputs = by_jet ? JETS[implicit][surface->metric] : implicit ? SP_IMPLICIT_VALUES : SP_PARAMETRIC_VALUES;
    int32_t pairs = SP_PARAMETRIC_JET * SP_GRAPH_BLOCK / block->outputs;
    block->count = 0, block->capacity = 2 * (pairs < SP_GRAPH_BLOCK ? pairs : SP_GRAPH_BLOCK);
}

double sp_block_get(const struct sp_block *block, int32_t i, int32_t j) { return block->out[block->outputs * (i >> 1) + j][i & 1]; }

void sp_block_put(struct sp_block *block, const double *point) {
    int32_t i = block->count++;
    for (int32_t j = 0; j < block->inputs; j++) {
        sp_pair *at = block->in + block->inputs * (i >> 1) + j;
        *at = i & 1 ? (sp_pair){(*at)[0], point[j]} : sp_splat(point[j]);
    }
}

void sp_block_evaluate(struct sp_block *block) { block->evaluate((block->count + 1) / 2, block->in, block->out); }

void sp_block_sample(const struct sp_block *block, int32_t i, double *sample) {
    int implicit = block->surface->kind == SP_IMPLICIT;
    int32_t width = sp_graph_width(block->surface);
    for (int32_t j = 0; j < width; j++)
        sample[j] = implicit && j < 3 ? block->in[3 * (i >> 1) + j][i & 1] : sp_block_get(block, i, implicit ? j - 2 : j);
    if (!implicit && width == 4) sample[3] = root(sample[3]);
}

void sp_graph_sample(const struct sp_surface *surface, const double *place, double *sample) {
    struct sp_block block;
    sp_block_open(&block, surface, 1);
    sp_block_put(&block, place);
    if (surface->kind != SP_IMPLICIT || surface->metric != SP_INDUCED) sp_block_evaluate(&block);
    sp_block_sample(&block, 0, sample);
}

/* The length of (du, dv); not a number where the form is not positive. */
static double form_length(const double form[3], const double by[2]) {
    if (form[0] * form[2] < form[1] * form[1]) return not_a_number();
    return root(form[0] * by[0] * by[0] + 2 * form[1] * by[0] * by[1] + form[2] * by[1] * by[1]);
}

static double simpson(const struct sp_surface *surface, const double *from, const double *middle, const double *to, const double by[2]) {
    if (surface->metric == SP_TENSOR) return (form_length(from, by) + 4 * form_length(middle, by) + form_length(to, by)) / 6;
    double length = distance_between(from, middle) + distance_between(middle, to);
    return surface->metric == SP_DENSITY ? length * (from[3] + 4 * middle[3] + to[3]) / 6 : length;
}

/* The length of a chord in space as a sample on an implicit surface measures it. */
static double tensor_length(int32_t components, const double *t, const double c[3]) {
    double square = dot(c, c);
    if (components == 0) return root(square);
    if (components == 1) square *= t[0];
    if (components == 6)
        square = t[0] * c[0] * c[0] + t[2] * c[1] * c[1] + t[5] * c[2] * c[2] +
                 2 * (t[1] * c[0] * c[1] + t[3] * c[0] * c[2] + t[4] * c[1] * c[2]);
    return root(square);
}

static double chord_in_space(const struct sp_surface *surface, const double *from, const double *to) {
    int32_t components = sp_kind_of(surface)->components;
    double chord[3] = {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
    return 0.5 * (tensor_length(components, from + 3, chord) + tensor_length(components, to + 3, chord));
}

double sp_graph_chord(const struct sp_surface *surface, const double *from, const double *to, const double by[2]) {
    if (surface->kind == SP_IMPLICIT) return chord_in_space(surface, from, to);
    if (surface->metric == SP_TENSOR) return 0.5 * (form_length(from, by) + form_length(to, by));
    return distance_between(from, to) * (surface->metric == SP_DENSITY ? 0.5 * (from[3] + to[3]) : 1);
}

double sp_graph_sheet_length(const struct sp_surface *surface, const double *a, const double normal_a[3], const double *b,
                             const double normal_b[3]) {
    double cosine = dot(normal_a, normal_b), chord[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, size = norm(chord);
    double rise_a = dot(chord, normal_a), rise_b = dot(chord, normal_b), limit = LARGEST_SINE * size;
    int one_sheet = cosine > LEAST_COSINE && rise_a <= limit && rise_a >= -limit && rise_b <= limit && rise_b >= -limit;
    if (!one_sheet) return __builtin_inf();
    return (surface->metric == SP_INDUCED ? size : chord_in_space(surface, a, b)) * (1 + (1 - cosine) / 12);
}

/* Chords between samples at many places of a segment. */
static double sum_pieces(const struct sp_surface *surface, const double place[2], const double by[2]) {
    double samples[2][SP_GRAPH_WIDTH], step[2] = {by[0] / PIECES, by[1] / PIECES}, sum = 0;
    struct sp_block block;
    sp_block_open(&block, surface, 1);
    for (int k = 0; k <= PIECES; k++) {
        /* Segments are of u and v only; a block may take three coordinates. */
        double at[3] = {place[0] + k * step[0], place[1] + k * step[1]};
        sp_block_put(&block, at);
    }
    sp_block_evaluate(&block);
    for (int k = 0; k <= PIECES; k++) {
        sp_block_sample(&block, k, samples[k & 1]);
        if (k) sum += sp_graph_chord(surface, samples[~k & 1], samples[k & 1], step);
    }
    return sum;
}

double sp_graph_segment(const struct sp_surface *surface, const double place[2], const double *from, const double *middle, const double *to,
                        const double by[2]) {
    double length = simpson(surface, from, middle, to, by);
    if (surface->metric == SP_INDUCED) return length;
    double off = sp_graph_chord(surface, from, to, by) - length;
    return off * off > UNEVEN * UNEVEN * length * length ? sum_pieces(surface, place, by) : length;
}
