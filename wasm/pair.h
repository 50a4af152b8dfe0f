/* Two doubles side by side: the unit in which surfaces are evaluated and the solver works.
 *
 * One vector register of WebAssembly (f64x2) and of every 64-bit machine. The operators + - * / and comparisons of C work on it lane by
 * lane, so a formula written once holds for two points. Knows nothing of surfaces; IEEE arithmetic only, so the bits are the same
 * everywhere. */
#ifndef SURFPATH_PAIR_H
#define SURFPATH_PAIR_H

#include <stdint.h>

#ifdef __wasm_simd128__
#include <wasm_simd128.h>
#elif defined(__SSE2__)
#include <emmintrin.h>
#endif

/* Two doubles; lane 0 and lane 1. */
typedef double sp_pair __attribute__((vector_size(16)));
/* Two lane masks or bit patterns: what comparing two pairs gives, all bits set where true. */
typedef int64_t sp_mask __attribute__((vector_size(16)));

static inline __attribute__((always_inline)) sp_pair sp_splat(double x) { return (sp_pair){x, x}; }

static inline __attribute__((always_inline)) sp_mask sp_bits(sp_pair x) { return (sp_mask)x; }

static inline __attribute__((always_inline)) sp_pair sp_from_bits(sp_mask bits) { return (sp_pair)bits; }

/* `mask ? yes : no`, lane by lane. */
static inline __attribute__((always_inline)) sp_pair sp_select(sp_mask mask, sp_pair yes, sp_pair no) {
    return sp_from_bits((mask & sp_bits(yes)) | (~mask & sp_bits(no)));
}

static inline __attribute__((always_inline)) sp_pair sp_absolute(sp_pair x) { return sp_from_bits(sp_bits(x) & INT64_MAX); }

/* Lanes exchanged. */
static inline __attribute__((always_inline)) sp_pair sp_swap(sp_pair x) { return (sp_pair){x[1], x[0]}; }

static inline __attribute__((always_inline)) sp_mask sp_swap_mask(sp_mask x) { return (sp_mask){x[1], x[0]}; }

static inline __attribute__((always_inline)) int sp_any(sp_mask mask) {
#ifdef __wasm_simd128__
    return wasm_v128_any_true((v128_t)mask);
#else
    return (mask[0] | mask[1]) != 0;
#endif
}

/* `a < b ? b : a`, lane by lane: `a` where it is NaN. */
static inline __attribute__((always_inline)) sp_pair sp_larger(sp_pair a, sp_pair b) {
#ifdef __wasm_simd128__
    return (sp_pair)wasm_f64x2_pmax((v128_t)a, (v128_t)b);
#elif defined(__SSE2__)
    return (sp_pair)_mm_max_pd((__m128d)b, (__m128d)a);
#else
    return sp_select(a < b, b, a);
#endif
}

/* `b < a ? b : a`, lane by lane: `a` where it is NaN. */
static inline __attribute__((always_inline)) sp_pair sp_smaller(sp_pair a, sp_pair b) {
#ifdef __wasm_simd128__
    return (sp_pair)wasm_f64x2_pmin((v128_t)a, (v128_t)b);
#elif defined(__SSE2__)
    return (sp_pair)_mm_min_pd((__m128d)b, (__m128d)a);
#else
    return sp_select(b < a, b, a);
#endif
}

/* Correctly rounded square root. */
static inline __attribute__((always_inline)) sp_pair sp_square_root(sp_pair x) {
#ifdef __wasm_simd128__
    return (sp_pair)wasm_f64x2_sqrt((v128_t)x);
#elif defined(__SSE2__)
    return (sp_pair)_mm_sqrt_pd((__m128d)x);
#else
    return (sp_pair){__builtin_sqrt(x[0]), __builtin_sqrt(x[1])};
#endif
}

#endif
