/* The little that native tests need: CHECK counts and prints what failed; main returns checks_failed(). */
#ifndef SURFPATH_TEST_TESTING_H
#define SURFPATH_TEST_TESTING_H

#include "elements.h"

#include <stdint.h>
#include <stdio.h>

static int check_count, check_failures;

#define CHECK(condition, ...)                                                                                                              \
    do {                                                                                                                                   \
        check_count++;                                                                                                                     \
        if (!(condition)) {                                                                                                                \
            check_failures++;                                                                                                              \
            printf("%s:%d: %s: ", __FILE__, __LINE__, #condition);                                                                         \
            printf(__VA_ARGS__);                                                                                                           \
            printf("\n");                                                                                                                  \
        }                                                                                                                                  \
    } while (0)

static int checks_failed(void) {
    printf("%d checks, %d failed\n", check_count, check_failures);
    return check_failures != 0 || check_count == 0;
}

/* Seeded random numbers in [0, 1): xorshift64*. */
static inline double random_unit(uint64_t *state) {
    *state ^= *state >> 12, *state ^= *state << 25, *state ^= *state >> 27;
    return (double)((*state * 0x2545F4914F6CDD1DULL) >> 11) / 9007199254740992.0;
}

/* Where elements meet that get longer from the first to the last: as sp_elements.spread. */
static inline const double *growing_elements(void) {
    static double spread[SP_SPREAD + 1];
    for (int k = 0; k <= SP_SPREAD; k++)
        spread[k] = k * (k + 20.0) / (SP_SPREAD * (SP_SPREAD + 20.0));
    return spread;
}

#endif
