/* The elementary functions against the high-precision table of tests/data/functions.csv (its making is described in make-functions.py), and
 * the two lanes against each other. Each bound is what wasm/functions.h promises. */
#include "functions.h"
#include "testing.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* In formulas quotients; the second of half an angle, from the sine and cosine of the whole. */
enum { TAN = SP_FUNCTION_COUNT, TAN_OF_HALF, FUNCTIONS };

static const struct {
    const char *name;
    double bound; /* ulp */
} functions[FUNCTIONS] = {
    [SP_SIN] = {"sin", 1},       [SP_COS] = {"cos", 1},       [TAN] = {"tan", 2.5},
    [SP_ASIN] = {"asin", 2.5},   [SP_ACOS] = {"acos", 2.5},   [SP_ATAN] = {"atan", 2.5},
    [SP_ATAN2] = {"atan2", 2.5}, [SP_SINH] = {"sinh", 2.5},   [SP_COSH] = {"cosh", 2.5},
    [SP_TANH] = {"tanh", 2.5},   [SP_EXP] = {"exp", 1},       [SP_LOG] = {"log", 1},
    [SP_CBRT] = {"cbrt", 2.5},   [SP_POW] = {"pow", 2.5},     [SP_LOG2] = {"log2", 1},
    [SP_LOG10] = {"log10", 1},   [SP_ASINH] = {"asinh", 2.5}, [SP_ACOSH] = {"acosh", 2.5},
    [SP_ATANH] = {"atanh", 2.5}, [SP_HYPOT] = {"hypot", 2.5}, [TAN_OF_HALF] = {"tan of half", 2.5},
};

/* A line of the table: the result is value + rest ulp(value). */
struct entry {
    int function;
    double x, y, value, rest;
};

static uint64_t bits_of(double x) {
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static double from_bits(uint64_t bits) {
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* The same number: all NaN count as one, zeros differ by sign. */
static int same(double a, double b) { return bits_of(a) == bits_of(b) || (isnan(a) && isnan(b)); }

static sp_pair tangent_of_half(sp_pair angle) {
    sp_pair cosine, sine = sp_sincos(angle, &cosine), sum = 1.0 + sp_absolute(cosine);
    return sp_select(cosine < 0.0, sum, sine) / sp_select(cosine < 0.0, sine, sum);
}

static sp_pair apply(int function, sp_pair x, sp_pair y) {
    switch (function) {
    case SP_SIN:
        return sp_sin(x);
    case SP_COS:
        return sp_cos(x);
    case TAN:
        return sp_sin(x) / sp_cos(x);
    case TAN_OF_HALF:
        return tangent_of_half(x);
    case SP_ASIN:
        return sp_asin(x);
    case SP_ACOS:
        return sp_acos(x);
    case SP_ATAN:
        return sp_atan(x);
    case SP_ATAN2:
        return sp_atan2(x, y);
    case SP_SINH:
        return sp_sinh(x);
    case SP_COSH:
        return sp_cosh(x);
    case SP_TANH:
        return sp_tanh(x);
    case SP_EXP:
        return sp_exp(x);
    case SP_LOG:
        return sp_log(x);
    case SP_CBRT:
        return sp_cbrt(x);
    case SP_POW:
        return sp_pow(x, y);
    case SP_LOG2:
        return sp_log2(x);
    case SP_LOG10:
        return sp_log10(x);
    case SP_ASINH:
        return sp_asinh(x);
    case SP_ACOSH:
        return sp_acosh(x);
    case SP_ATANH:
        return sp_atanh(x);
    default:
        return sp_hypot(x, y);
    }
}

static double apply_alone(int function, double x, double y) {
    if (function == TAN_OF_HALF) return tangent_of_half(sp_splat(x))[0];
    if (function == TAN) return sp_apply_function(SP_SIN, x, y) / sp_apply_function(SP_COS, x, y);
    return sp_apply_function(function, x, y);
}

static double error_in_ulp(double result, const struct entry *entry) {
    double ulp = fabs(from_bits(bits_of(entry->value) ^ 1) - entry->value);
    return fabs((result - entry->value) / ulp - entry->rest);
}

/* Zeros, infinities and NaN have to be met exactly; a result that underflows may also be the smallest number. Returns the error in ulp. */
static double check_entry(const struct entry *entry) {
    const char *name = functions[entry->function].name;
    double bound = functions[entry->function].bound, result = apply_alone(entry->function, entry->x, entry->y);
    int exact = !isfinite(entry->value) || (entry->value == 0 && entry->rest == 0) || result == 0;
    if (exact) {
        CHECK(same(result, entry->value), "%s(%a, %a) = %a, not %a", name, entry->x, entry->y, result, entry->value);
        return 0;
    }
    double error = error_in_ulp(result, entry);
    CHECK(error <= bound, "%s(%a, %a) = %a, not %a: %.3f ulp", name, entry->x, entry->y, result, entry->value, error);
    return error;
}

/* Neither lane may depend on the other, nor a result on its lane. */
static void check_lanes(int function, sp_pair x, sp_pair y) {
    sp_pair result = apply(function, x, y);
    for (int lane = 0; lane < 2; lane++) {
        double expected = apply_alone(function, x[lane], y[lane]);
        CHECK(same(result[lane], expected), "lane %d of %s(%a %a, %a %a) = %a, alone %a", lane, functions[function].name, x[0], x[1], y[0],
              y[1], result[lane], expected);
    }
}

static void check_beside_others(const struct entry *entry) {
    static const double others[] = {0.0, 1.0, -0.3, 1e-310, 1e10, 1e300, (double)INFINITY, (double)NAN};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++) {
        sp_pair x = {entry->x, others[i]}, y = {entry->y, -others[i]};
        check_lanes(entry->function, x, y);
        check_lanes(entry->function, sp_swap(x), sp_swap(y));
    }
}

/* Any pattern of bits, NaN and infinities included. */
static double random_double(uint64_t *seed) {
    return from_bits((uint64_t)(random_unit(seed) * 0x1p53) << 11 ^ (uint64_t)(random_unit(seed) * 0x1p53));
}

static void check_random_lanes(uint64_t seed) {
    printf("random lanes: seed %llu\n", (unsigned long long)seed);
    for (int i = 0; i < 5000; i++)
        for (int function = 0; function < FUNCTIONS; function++) {
            sp_pair x = {random_double(&seed), 4 * random_unit(&seed)}, y = {random_double(&seed), random_double(&seed)};
            check_lanes(function, x, y);
        }
}

static void check_sincos(double x) {
    sp_pair cosine, sine = sp_sincos((sp_pair){x, -x}, &cosine);
    CHECK(same(sine[0], sp_sin(sp_splat(x))[0]) && same(sine[1], sp_sin(sp_splat(-x))[0]), "sine of sincos(%a)", x);
    CHECK(same(cosine[0], sp_cos(sp_splat(x))[0]) && same(cosine[1], sp_cos(sp_splat(-x))[0]), "cosine of sincos(%a)", x);
    sp_pair other = {0.5, 1e9 * x}, others[3], first = sp_sincos_two((sp_pair){x, -x}, other, others), c, s = sp_sincos(other, &c);
    for (int lane = 0; lane < 2; lane++)
        CHECK(same(first[lane], sine[lane]) && same(others[0][lane], cosine[lane]) && same(others[1][lane], s[lane]) &&
                  same(others[2][lane], c[lane]),
              "two angles, of which one is %a, lane %d", x, lane);
}

/* Reads `name,x,y,value,rest`; an empty y is read as 0. Returns false on anything else. */
static int read_entry(char *line, struct entry *entry) {
    double numbers[4];
    char *at = strchr(line, ',');
    if (!at) return 0;
    *at = 0;
    for (entry->function = 0; entry->function < FUNCTIONS; entry->function++)
        if (!strcmp(functions[entry->function].name, line)) break;
    for (int i = 0; i < 4; i++) {
        if (*at != ',' && i > 0) return 0;
        numbers[i] = strtod(at + 1, &at);
    }
    *entry = (struct entry){entry->function, numbers[0], numbers[1], numbers[2], numbers[3]};
    return entry->function < FUNCTIONS && *at == '\n';
}

/* By function. */
struct tally {
    int count;
    double worst;
};

static void check_in_full(const struct entry *entry, struct tally *tallies) {
    struct tally *tally = tallies + entry->function;
    double error = check_entry(entry);
    tally->count++;
    if (error > tally->worst) tally->worst = error;
    check_beside_others(entry);
}

static void check_table(FILE *table) {
    static char line[256];
    struct tally tallies[FUNCTIONS] = {{0}};
    CHECK(fgets(line, sizeof line, table) && !strcmp(line, "function,x,y,value,rest\n"), "heading");
    while (fgets(line, sizeof line, table)) {
        struct entry entry;
        if (!read_entry(line, &entry)) {
            CHECK(0, "unreadable line of the table: %s", line);
            return;
        }
        check_in_full(&entry, tallies);
        if (entry.function == SP_SIN) check_sincos(entry.x);
        struct entry twice = {TAN_OF_HALF, 2 * entry.x, entry.y, entry.value, entry.rest};
        if (entry.function == TAN && isfinite(entry.value) && isfinite(twice.x)) check_in_full(&twice, tallies);
    }
    for (int i = 0; i < FUNCTIONS; i++) {
        CHECK(tallies[i].count >= 1000, "%s: %d entries", functions[i].name, tallies[i].count);
        printf("%-5s %4d entries, at most %.2f ulp\n", functions[i].name, tallies[i].count, tallies[i].worst);
    }
}

int main(int count, char **arguments) {
    char path[4096];
    snprintf(path, sizeof path, "%s/functions.csv", count > 1 ? arguments[1] : "tests/data");
    FILE *table = fopen(path, "r");
    CHECK(table, "no table at %s", path);
    if (table) {
        check_table(table);
        fclose(table);
    }
    check_random_lanes(20240229);
    CHECK(isnan(sp_apply_function(-1, 0.5, 0.5)) && isnan(sp_apply_function(SP_FUNCTION_COUNT, 0.5, 0.5)), "unknown number");
    return checks_failed();
}
