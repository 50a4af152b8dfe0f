/* The native side of the golden hash: solves problems from its input on a surface written as C, and prints the hash of all bits of the
 * answers.
 *
 *   native SURFACE < problems
 *
 * Input: a count, then for each problem: algorithm, points, max_iterations, and the two ends, two or three numbers each. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../bench/native.h"
#include "surfpath.h"

/* As BitHash in bits.js. */
struct bit_hash {
    uint32_t a, b;
};

static uint32_t rotate(uint32_t x, int by) { return x << by | x >> (32 - by); }

static void add(struct bit_hash *hash, double number) {
    uint64_t bits;
    memcpy(&bits, &number, sizeof bits);
    if (number != number) bits = 0x7ff8000000000000;
    hash->a = rotate((hash->a ^ (uint32_t)bits) * 0x9e3779b1u, 13);
    hash->b = rotate((hash->b ^ (uint32_t)(bits >> 32) ^ hash->a) * 0x85ebca6bu, 17);
}

static void add_all(struct bit_hash *hash, const double *numbers, size_t count) {
    for (size_t i = 0; numbers && i < count; i++)
        add(hash, numbers[i]);
}

/* As addPath in bits.js. */
static void add_path(struct bit_hash *hash, const struct sp_result *result, size_t point_count) {
    const double numbers[] = {result->status, result->length,           result->length_error,
                              result->energy, result->gradient_norm,    result->iterations,
                              result->index,  result->touches_boundary, result->crosses_singularity};
    add_all(hash, numbers, sizeof numbers / sizeof *numbers);
    add_all(hash, result->points, 3 * (point_count + 2));
    add_all(hash, result->parameters, 2 * (point_count + 2));
    for (int32_t i = 0; i < result->history_count; i++)
        add_all(hash, (const double *)(result->history + i), 4);
}

static double read_number(void) {
    double number;
    if (scanf("%lf", &number) != 1) exit(4);
    return number;
}

static void solve(const struct sp_surface *surface, struct bit_hash *hash) {
    int dimension = surface->kind == SP_IMPLICIT ? 3 : 2;
    struct sp_request request = {0};
    struct sp_options options;
    struct sp_result result;
    sp_default_options(&options);
    options.algorithm = (int32_t)read_number();
    options.point_count = (int32_t)read_number();
    options.max_iterations = (int32_t)read_number();
    for (int j = 0; j < dimension; j++)
        request.from[j] = read_number();
    for (int j = 0; j < dimension; j++)
        request.to[j] = read_number();
    size_t bytes = (size_t)sp_solve_bytes(surface, &options, 0);
    struct sp_arena arena = {malloc(bytes), bytes, 0};
    if (!arena.base) exit(3);
    sp_solve_path(surface, &request, &options, &arena, &result);
    add_path(hash, &result, (size_t)options.point_count);
    free(arena.base);
}

int main(int count, char **arguments) {
    struct bit_hash hash = {0x243f6a88, 0x85a308d3};
    for (int i = 0; count == 2 && i < named_surface_count; i++) {
        if (strcmp(named_surfaces[i].name, arguments[1]) != 0) continue;
        for (int problems = (int)read_number(); problems > 0; problems--)
            solve(&named_surfaces[i].surface, &hash);
        printf("%08x%08x\n", hash.a, hash.b);
        return 0;
    }
    return 2;
}
