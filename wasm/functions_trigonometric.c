/* Sine and cosine.
 *
 * The argument is reduced by the nearest multiple of pi/2 to |r| <= pi/4, in three parts after Cody and Waite; the few that this does not
 * reduce well enough (large, or next to a multiple of pi/2) go through the integer product with 2/pi of Payne and Hanek. */
#include "functions_wide.h"

/* Up to here the integer multiple has at most 19 bits, and its products with the first two parts of pi/2 are exact. */
#define REDUCED_EASILY 0x1p19
/* |r| below this share of the multiple: the third part of pi/2 is too short for it. */
#define TOO_CLOSE 0x1p-64

/* x = (quadrant + 4 n) pi/2 + high + low. Only the two lowest bits of the quadrant count. */
struct reduced_angle {
    sp_pair high, low;
    sp_word quadrant;
};

/* The upper half of the 128 bits of a b. */
static uint64_t multiply_high(uint64_t a, uint64_t b) {
    uint64_t a_high = a >> 32, a_low = a & UINT32_MAX, b_high = b >> 32, b_low = b & UINT32_MAX;
    uint64_t middle = a_high * b_low + (a_low * b_low >> 32);
    uint64_t carried = a_low * b_high + (middle & UINT32_MAX);
    return a_high * b_high + (middle >> 32) + (carried >> 32);
}

/* The 64 bits of 2/pi that begin `position` bits into the table. */
static uint64_t bits_of_two_over_pi(uint64_t position) {
    const uint64_t *word = sp_constants.two_over_pi_words + position / 64;
    uint64_t shift = position % 64;
    return word[0] << shift | word[1] >> 1 >> (63 - shift);
}

/* A fixed-point number of 128 bits. */
struct fixed_point {
    uint64_t high, low;
};

/* x 2/pi modulo 4, two bits before the point, for finite x >= 1/2. With x = m 2^e, only 192 bits of 2/pi matter: those before them make
 * multiples of 4, those behind less than 2^-126. */
static struct fixed_point quarter_turns(double x) {
    uint64_t bits = sp_word_of(sp_splat(x))[0];
    uint64_t mantissa = (bits & 0xfffffffffffff) | 0x10000000000000, position = (bits >> 52) - 1075 + 62;
    uint64_t middle = bits_of_two_over_pi(position + 64), carried = multiply_high(mantissa, bits_of_two_over_pi(position + 128));
    uint64_t low = mantissa * middle + carried;
    return (struct fixed_point){mantissa * bits_of_two_over_pi(position) + multiply_high(mantissa, middle) + (low < carried), low};
}

/* x - quadrant pi/2 for finite x >= 1/2, in two parts. */
static struct sp_wide rest_of(double x, uint64_t *quadrant) {
    struct fixed_point turns = quarter_turns(x);
    *quadrant = (turns.high + ((uint64_t)1 << 61)) >> 62;
    /* A fraction of one half or more counts as negative. Its complement is too small by 2^-128. */
    uint64_t fraction = turns.high << 2 | turns.low >> 62, rest = turns.low << 2, negative = fraction >> 63;
    fraction ^= 0 - negative, rest ^= 0 - negative;
    /* 53, 53 and 22 bits, since next to a multiple of pi/2 up to 62 of them are 0. */
    double upper = (double)(fraction & ~(uint64_t)0x7ff), middle = (double)((fraction & 0x7ff) << 42 | rest >> 22) * 0x1p-42;
    struct sp_wide sum = sp_add_smaller(sp_splat(upper), sp_splat(middle));
    sum.low += (double)(rest & 0x3fffff) * 0x1p-64;
    struct sp_wide angle = sp_wide_multiply(sum, sp_constants.half_pi);
    double unit = negative ? -0x1p-64 : 0x1p-64;
    return (struct sp_wide){angle.high * unit, angle.low * unit};
}

/* The parts of a reduced angle. */
enum part { HIGH, LOW, QUADRANT };

/* One part of the angle of x, reduced in full. Kept out of line, and asked for one part at a time: rare, and what it would write to memory
 * would have to lie there on the common way, too. */
__attribute__((noinline, cold)) static double reduce_fully(double x, enum part part) {
    double magnitude = sp_absolute(sp_splat(x))[0];
    if (!(magnitude < SP_INFINITY)) return SP_NAN;
    uint64_t quadrant;
    struct sp_wide rest = rest_of(magnitude, &quadrant);
    double value = part == HIGH ? rest.high[0] : part == LOW ? rest.low[0] : (double)quadrant;
    return x < 0 ? -value : value;
}

static inline __attribute__((always_inline)) struct reduced_angle reduce(sp_pair x) {
    const double *parts = sp_constants.half_pi_parts;
    sp_pair shifted = x * sp_constants.two_over_pi + SP_ROUNDER;
    sp_pair multiple = shifted - SP_ROUNDER;
    sp_pair first = x - multiple * parts[0];
    sp_pair second = first - multiple * parts[1];
    sp_pair lost = (first - second) - multiple * parts[1];
    sp_pair third = multiple * parts[2] - lost;
    sp_pair high = second - third;
    struct reduced_angle angle = {high, (second - high) - third, sp_word_of(shifted)};

    sp_mask hard = (sp_absolute(x) >= REDUCED_EASILY) | (sp_absolute(high) < sp_absolute(multiple) * TOO_CLOSE);
    if (sp_any(hard)) {
        SP_UNROLL for (int lane = 0; lane < 2; lane++) {
            if (!hard[lane]) continue;
            angle.high[lane] = reduce_fully(x[lane], HIGH), angle.low[lane] = reduce_fully(x[lane], LOW);
            angle.quadrant[lane] = sp_word_of(sp_splat(reduce_fully(x[lane], QUADRANT) + SP_ROUNDER))[0];
        }
    }
    return angle;
}

/* sin and cos of high + low. The order of the sums keeps what rounding loses below a tenth of an ulp, and the sign of zero. */
static inline __attribute__((always_inline)) sp_pair reduced_sine(const struct reduced_angle *angle) {
    sp_pair x = angle->high, square = x * x, cube = square * x;
    sp_pair tail = square * (0.5 * angle->low - cube * sp_polynomial(square, sp_constants.sine + 1, 5)) - angle->low;
    return x - (tail - cube * sp_constants.sine[0]);
}

static inline __attribute__((always_inline)) sp_pair reduced_cosine(const struct reduced_angle *angle) {
    sp_pair square = angle->high * angle->high, half = 0.5 * square, head = 1.0 - half;
    sp_pair tail = square * (square * sp_polynomial(square, sp_constants.cosine, 6)) - angle->high * angle->low;
    return head + (((1.0 - head) - half) + tail);
}

/* The one formula for all: who asks for the sine alone pays for both, two operations in three of which they share. */
static inline __attribute__((always_inline)) sp_pair sincos_of(const struct reduced_angle *angle, sp_pair *cosine) {
    sp_pair s = reduced_sine(angle), c = reduced_cosine(angle);
    sp_mask odd = (sp_mask)(0 - (angle->quadrant & 1));
    sp_word sine_sign = (angle->quadrant & 2) << 62, cosine_sign = ((angle->quadrant + 1) & 2) << 62;
    *cosine = sp_pair_of(sp_word_of(sp_select(odd, s, c)) ^ cosine_sign);
    return sp_pair_of(sp_word_of(sp_select(odd, c, s)) ^ sine_sign);
}

__attribute__((noinline)) sp_pair sp_sincos(sp_pair x, sp_pair *cosine) {
    struct reduced_angle angle = reduce(x);
    return sincos_of(&angle, cosine);
}

/* A processor waits for most of one angle's results; here it has the other's to work on. */
__attribute__((noinline)) sp_pair sp_sincos_two(sp_pair x, sp_pair y, sp_pair *others) {
    struct reduced_angle first = reduce(x), second = reduce(y);
    others[1] = sincos_of(&second, others + 2);
    return sincos_of(&first, others);
}

sp_pair sp_sin(sp_pair x) {
    sp_pair cosine;
    return sp_sincos(x, &cosine);
}

sp_pair sp_cos(sp_pair x) {
    sp_pair cosine;
    sp_sincos(x, &cosine);
    return cosine;
}
