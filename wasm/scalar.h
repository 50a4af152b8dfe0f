/* One number at a time, as pair.h has two. Included by .c files only, so the names are short. */
#ifndef SURFPATH_SCALAR_H
#define SURFPATH_SCALAR_H

#include <stdint.h>

static inline double root(double x) { return __builtin_sqrt(x); }

static inline double absolute(double x) { return __builtin_fabs(x); }

/* `b` where `a` is NaN. */
static inline double smaller(double a, double b) { return a < b ? a : b; }

/* `b` where `a` is NaN. */
static inline double larger(double a, double b) { return a > b ? a : b; }

static inline int is_finite(double x) { return x - x == 0; }

static inline double not_a_number(void) { return __builtin_nan(""); }

static inline int32_t clamp(int32_t x, int32_t least, int32_t most) { return x < least ? least : x > most ? most : x; }

static inline double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static inline double norm(const double a[3]) { return root(dot(a, a)); }

static inline double distance_between(const double a[3], const double b[3]) {
    double d[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    return norm(d);
}

#endif
