/* The native side of the benchmarks: takes one sample of the same core on the same surface, and prints it as JSON.
 *
 *   native solve SURFACE K REPETITIONS < pairs        nanoseconds a solve, and the sum of the lengths: polylines, or, if K is below 1,
 *                                                     elements to that tolerance
 *   native at-once SURFACE K REPETITIONS STEPS < pairs   polylines from the straight line given as a start, which no coarser one precedes,
 *                                                     in at most so many steps
 *   native evaluate SURFACE COUNT REPETITIONS < points  nanoseconds a point for all that `jet` stores, and the sum of it
 *
 * Input: a count, then the numbers; a pair is its two ends of two or three numbers. One pass over all comes first, to warm up. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "native.h"
#include "surfpath.h"

static double nanoseconds(void) {
    struct timespec now;
    timespec_get(&now, TIME_UTC);
    return 1e9 * (double)now.tv_sec + (double)now.tv_nsec;
}

static const struct sp_surface *find_surface(const char *name) {
    for (int i = 0; i < named_surface_count; i++)
        if (strcmp(named_surfaces[i].name, name) == 0) return &named_surfaces[i].surface;
    return NULL;
}

/* Memory that is there and aligned to 16 bytes; exits if not. */
static void *reserve(size_t bytes) {
    void *memory = aligned_alloc(16, (bytes + 31) & ~(size_t)15);
    if (!memory) exit(3);
    return memory;
}

/* The numbers of the input, `width` for each of `*count`. */
static double *read_numbers(int width, int *count) {
    if (scanf("%d", count) != 1 || *count < 1) exit(4);
    int total = *count * width;
    double *numbers = reserve(sizeof(double) * (size_t)total);
    for (int i = 0; i < total; i++)
        if (scanf("%lf", &numbers[i]) != 1) exit(4);
    return numbers;
}

static void print_sample(double elapsed, double operations, double sum) {
    printf("{\"nanoseconds\": %.17g, \"sum\": %.17g}\n", elapsed / operations, sum);
}

/* One pass over all pairs; the sum of the lengths. */
static double solve_all(const struct sp_surface *surface, const struct sp_request *requests, int count, const struct sp_options *options,
                        struct sp_arena *arena) {
    double sum = 0;
    for (int i = 0; i < count; i++) {
        struct sp_result result;
        sp_solve_path(surface, &requests[i], options, arena, &result);
        sum += result.length;
    }
    return sum;
}

static void sample_solves(const struct sp_surface *surface, double size, int repetitions, int steps) {
    int count, dimension = surface->kind == SP_IMPLICIT ? 3 : 2;
    double *numbers = read_numbers(2 * dimension, &count), sum = 0;
    struct sp_request *requests = reserve(sizeof *requests * (size_t)count);
    for (int i = 0; i < count; i++) {
        requests[i] = (struct sp_request){0};
        if (steps) requests[i].start = numbers + 2 * dimension * i, requests[i].start_count = 2;
        memcpy(requests[i].from, numbers + 2 * dimension * i, sizeof(double) * (size_t)dimension);
        memcpy(requests[i].to, numbers + 2 * dimension * i + dimension, sizeof(double) * (size_t)dimension);
    }
    struct sp_options options;
    sp_default_options(&options);
    if (size < 1)
        options.tolerance = size;
    else
        options.algorithm = SP_POLYLINE, options.point_count = (int)size;
    if (steps) options.max_iterations = steps;
    size_t bytes = (size_t)sp_solve_bytes(surface, &options, 2);
    struct sp_arena arena = {reserve(bytes), bytes, 0};
    solve_all(surface, requests, count, &options, &arena);
    double start = nanoseconds();
    for (int i = 0; i < repetitions; i++)
        sum = solve_all(surface, requests, count, &options, &arena);
    print_sample(nanoseconds() - start, (double)repetitions * count, sum);
    free(arena.base), free(requests), free(numbers);
}

static void sample_evaluations(const struct sp_surface *surface, int repetitions) {
    int count, dimension = surface->kind == SP_IMPLICIT ? 3 : 2,
               outputs = surface->kind == SP_IMPLICIT ? SP_IMPLICIT_JET : SP_PARAMETRIC_JET;
    double *points = read_numbers(dimension, &count), sum = 0;
    int32_t pairs = count / 2;
    sp_pair *in = reserve(sizeof(sp_pair) * (size_t)(pairs * dimension)), *out = reserve(sizeof(sp_pair) * (size_t)(pairs * outputs));
    for (int i = 0; i < 2 * pairs * dimension; i++)
        in[dimension * (i / dimension / 2) + i % dimension][i / dimension % 2] = points[i];
    surface->jet(pairs, in, out);
    double start = nanoseconds();
    for (int i = 0; i < repetitions; i++)
        surface->jet(pairs, in, out);
    double elapsed = nanoseconds() - start;
    for (int i = 0; i < pairs * outputs; i++)
        sum += out[i][0] + out[i][1];
    print_sample(elapsed, 2.0 * pairs * repetitions, sum);
    free(out), free(in), free(points);
}

int main(int count, char **arguments) {
    const struct sp_surface *surface = count >= 5 ? find_surface(arguments[2]) : NULL;
    if (!surface) return 2;
    int repetitions = atoi(arguments[4]), at_once = strcmp(arguments[1], "at-once") == 0;
    if (at_once != (count == 6)) return 2;
    if (at_once || strcmp(arguments[1], "solve") == 0)
        sample_solves(surface, atof(arguments[3]), repetitions, at_once ? atoi(arguments[5]) : 0);
    else
        sample_evaluations(surface, repetitions);
    return 0;
}
