/* The profile runtime that clang's instrumented WebAssembly wants: remembers where each function's counters are, so that preload.js can
 * read them. Knows nothing of files; the names are matched there. */
#include <stdint.h>

/* __llvm_profile_data of clang 14 on a 32-bit target; `counters` is relative to the struct's own address. */
struct profile_data {
    uint64_t name_hash, structure_hash;
    uint32_t counters;
    void *function, *values;
    uint32_t counter_count;
    uint16_t value_sites[2];
};

struct coverage {
    uint64_t name_hash, structure_hash;
    uint64_t *counters;
    uint32_t counter_count;
};

enum { MOST_FUNCTIONS = 4096, MOST_NAMES = 256 };

static struct coverage functions[MOST_FUNCTIONS];
static uint32_t function_count;
static struct {
    const void *text;
    uint32_t bytes;
} names[MOST_NAMES];
static uint32_t name_count;

/* Linked against by every instrumented object. */
int __llvm_profile_runtime;
void __llvm_profile_register_function(void *data);
void __llvm_profile_register_names_function(void *text, uint64_t bytes);
struct coverage *coverage_functions(void);
uint32_t coverage_function_count(void);
void *coverage_names(void);
uint32_t coverage_name_count(void);

void __llvm_profile_register_function(void *data) {
    const struct profile_data *from = data;
    if (function_count == MOST_FUNCTIONS) __builtin_trap();
    functions[function_count++] =
        (struct coverage){from->name_hash, from->structure_hash, (uint64_t *)((char *)data + from->counters), from->counter_count};
}

void __llvm_profile_register_names_function(void *text, uint64_t bytes) {
    if (name_count == MOST_NAMES) __builtin_trap();
    names[name_count].text = text;
    names[name_count++].bytes = (uint32_t)bytes;
}

struct coverage *coverage_functions(void) {
    return functions;
}

uint32_t coverage_function_count(void) { return function_count; }

void *coverage_names(void) { return names; }

uint32_t coverage_name_count(void) { return name_count; }
