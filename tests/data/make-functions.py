#!/usr/bin/python3
"""Writes functions.csv, the table against which the elementary functions are measured: `./make-functions.py > functions.csv`.

Needs mpmath (Debian: python3-mpmath) and, for infinities, NaN and zeros, a C library that follows Annex F. Deterministic; takes a few
seconds; not part of `make test`. `./make-functions.py coefficients` prints those polynomials of wasm/functions_constants.c that were made here.

A line is `function,x,y,value,rest`. y is empty for functions of one argument. value is the correctly rounded result; value + rest ulp,
|rest| <= 0.5, is the result to four more digits, with 1 ulp the distance from |value| to the neighbour that differs in the last bit.
"""
import ctypes
import math
import random
import struct
import sys

import mpmath
from mpmath import mp, mpf

INFINITY = math.inf
LARGEST = sys.float_info.max
SMALLEST_NORMAL = sys.float_info.min
SMALLEST = 5e-324
HALF_PI = 1.5707963267948966
COUNT = 700
NAMES = 'sin cos tan asin acos atan atan2 sinh cosh tanh exp log cbrt log10 asinh acosh atanh hypot'
FUNCTIONS = {name: getattr(mpmath, name) for name in NAMES.split()}
FUNCTIONS['pow'] = mpmath.power
FUNCTIONS['log2'] = lambda x: mpmath.log(x, 2)


# --- numbers

def neighbour(x, steps):
    """The double `steps` places above x > 0."""
    return struct.unpack('<d', struct.pack('<q', struct.unpack('<q', struct.pack('<d', x))[0] + steps))[0]


def ulp(x):
    """Distance to the neighbour that differs from |x| in the last bit."""
    bits = struct.unpack('<q', struct.pack('<d', abs(x)))[0]
    return abs(struct.unpack('<d', struct.pack('<q', bits ^ 1))[0] - abs(x))


def rounded(exact):
    """The nearest double, gradually down to zero and up to infinity."""
    if exact == 0:
        return 0.0
    sign = -1 if exact < 0 else 1
    exponent = max(mpmath.frexp(exact)[1] - 53, -1074)
    nearest = mpmath.ldexp(mpmath.nint(mpmath.ldexp(exact, -exponent)), exponent)
    if abs(nearest) > LARGEST:
        return sign * INFINITY
    return math.copysign(float(nearest), sign)


# --- one line of the table

def is_regular(name, x, y):
    """Whether the result is an ordinary number that mpmath can compute; everything else is a rule of Annex F."""
    if not (math.isfinite(x) and math.isfinite(y)) or x == 0 or (name == 'atan2' and y == 0):
        return False
    if name == 'pow':
        return x > 0 or y == int(y)
    domains = {'log': x > 0, 'log2': x > 0, 'log10': x > 0, 'asin': abs(x) <= 1, 'acos': abs(x) <= 1, 'acosh': x >= 1, 'atanh': abs(x) < 1}
    return domains.get(name, True)


def by_rule(name, x, y):
    function = getattr(ctypes.CDLL('libm.so.6'), name)
    function.restype = ctypes.c_double
    function.argtypes = [ctypes.c_double] * (1 if y is None else 2)
    return function(x) if y is None else function(x, y)


def line(name, x, y=None):
    if not is_regular(name, x, y or 0.0):
        result = by_rule(name, x, y)
        # Of ordinary results, such as acos(0), the table wants all digits; 0 and 1 are exact.
        if not math.isfinite(result) or result in (0, 1, -1):
            return f'{name},{x!r},{"" if y is None else repr(y)},{result!r},0'
    arguments = [mpf(x)] if y is None else [mpf(x), mpf(y)]
    with mp.workprec(1300 if name in ('sin', 'cos', 'tan') else 240):
        exact = quotient_angle(x, y) if name == 'atan2' else FUNCTIONS[name](*arguments) if name != 'cbrt' else signed_cube_root(x)
        value = rounded(exact)
        rest = (exact - mpf(value)) / mpf(ulp(value)) if math.isfinite(value) else mpf(0)
        return f'{name},{x!r},{"" if y is None else repr(y)},{value!r},{float(rest):.4f}'


def quotient_angle(y, x):
    """atan2 with the sign of zeros: mpmath has none."""
    if math.isinf(x) or math.isinf(y):
        quarters = {(True, True): mpf(1) / 4, (False, True): mpf(1) / 2, (True, False): mpf(0)}[(math.isinf(x), math.isinf(y))]
        turn = 1 - quarters if math.copysign(1, x) < 0 else quarters
        return math.copysign(1, y) * turn * mp.pi
    if y == 0:
        return math.copysign(1, y) * mp.pi
    return mpmath.atan2(mpf(y), mpf(x))


def signed_cube_root(x):
    return math.copysign(1, x) * mpmath.cbrt(abs(mpf(x)))


# --- arguments

GENERATOR = random.Random(20240229)


def uniform(low, high):
    return low + (high - low) * GENERATOR.random()


def scaled(low, high):
    """Random mantissa and sign, exponent uniform in low..high - 1."""
    return GENERATOR.choice((-1, 1)) * math.ldexp(uniform(1, 2), GENERATOR.randrange(low, high))


def repeat(count, draw):
    return [draw() for _ in range(count)]


def both_signs(values):
    return [sign * value for value in values for sign in (1, -1)]


def around(*values):
    """Some doubles on both sides of each value > 0."""
    return both_signs(neighbour(value, step) for value in values for step in (-3, -2, -1, 0, 1, 2, 3))


SPECIAL = both_signs([0.0, SMALLEST, 3 * SMALLEST, neighbour(SMALLEST_NORMAL, -1), SMALLEST_NORMAL, 1e-300, 2.0 ** -60, 2.0 ** -27, 0.5,
                      neighbour(1.0, -1), 1.0, neighbour(1.0, 1), 2.0, 1e300, LARGEST, INFINITY]) + [math.nan]


def nearest_to_quarter_turns():
    """Per binary exponent the double closest to a multiple of pi/2: the last convergent of 2^e/(pi/2) with a denominator below 2^53."""
    found = [math.ldexp(6381956970095103.0, 797)]
    with mp.workprec(2400):
        for exponent in range(-50, 971, 6):
            rest, before, denominator = mpmath.ldexp(2 / mp.pi, exponent), 0, 1
            while denominator < 2 ** 53:
                best = denominator
                fraction = rest - mpmath.floor(rest)
                rest = 1 / fraction
                before, denominator = denominator, int(mpmath.floor(rest)) * denominator + before
            found.append(math.ldexp(float(best), exponent))
    return found


def angles():
    multiples = [k * HALF_PI for k in list(range(1, 65)) + [2 ** i + 1 for i in range(6, 21)]]
    return (SPECIAL + nearest_to_quarter_turns() + [m / 2 for m in multiples] + around(*multiples[:8]) + multiples
            + around(524288.0, 333772 * HALF_PI) + repeat(COUNT, lambda: uniform(-10, 10)) + repeat(300, lambda: scaled(-30, 20))
            + repeat(300, lambda: scaled(-1022, 1024)))


def unit_interval():
    return (SPECIAL + around(0.5, 1.0, 0.3125) + both_signs(1 - 2.0 ** -k for k in range(1, 54)) + repeat(COUNT, lambda: uniform(-1, 1))
            + repeat(200, lambda: scaled(-60, 0)) + repeat(200, lambda: math.copysign(1 - abs(scaled(-50, -1)), scaled(0, 1))))


def slopes():
    return (SPECIAL + around(0.3125, 0.5, 1.0, 1.6, 3.2) + repeat(COUNT, lambda: uniform(-4, 4)) + repeat(400, lambda: scaled(-60, 60))
            + repeat(100, lambda: scaled(-1074, 1024)))


def hyperbolic():
    ends = around(1.0, 0.625, 22.0, 709.7827128933841, 710.4758600739439, 711.0, 745.2, 19.0615)
    return (SPECIAL + ends + repeat(COUNT, lambda: uniform(-3, 3)) + repeat(300, lambda: uniform(-711, 711))
            + repeat(300, lambda: scaled(-40, 6)))


def near_halfway(function, inverse, draw):
    """Arguments whose results lie almost in the middle between two doubles: the best 60 of 6000."""
    def distance(x):
        exact = function(mpf(x))
        return abs(abs((exact - rounded(exact)) / ulp(rounded(exact))) - 0.5)
    with mp.workprec(240):
        middles = [mpf(v) + mpf(ulp(v)) / 2 for v in repeat(6000, draw)]
        return sorted((rounded(inverse(m)) for m in middles), key=distance)[:60]


def exponents():
    ends = around(709.782712893384, 708.3964185322641, 745.1332191019411, 744.4400719213812, 0.34657359027997264, 1.0397207708399179)
    tiny = both_signs(math.ldexp(k, -54) for k in range(1, 9))
    return (SPECIAL + ends + tiny + near_halfway(mpmath.exp, mpmath.log, lambda: math.ldexp(uniform(1, 2), GENERATOR.randrange(-20, 20)))
            + [k * math.log(2) for k in range(-1075, 1025, 25)] + repeat(COUNT, lambda: uniform(-3, 3))
            + repeat(400, lambda: uniform(-746, 710)) + repeat(100, lambda: uniform(-746, -708)))


def positive():
    close = [neighbour(1.0, step * sign) for k in range(50) for sign in (1, -1) for step in (2 ** k,)]
    return (SPECIAL + close + around(0.7071067811865476, 1.4142135623730951) + [2.0 ** k for k in range(-1074, 1024, 37)]
            + repeat(COUNT, lambda: uniform(0, 4)) + repeat(300, lambda: 1 + scaled(-40, -1)) + repeat(300, lambda: abs(scaled(-1074, 1024))))


def cubes():
    exact = both_signs(float(k) ** 3 for k in list(range(1, 40)) + [2 ** 17 - 1, 2 ** 17 + 1])
    middles = near_halfway(signed_cube_root, lambda m: m ** 3, lambda: uniform(1, 2))
    return (SPECIAL + exact + middles + around(1.0, 8.0) + repeat(COUNT, lambda: uniform(-8, 8)) + repeat(500, lambda: scaled(-1074, 1024)))


def points():
    special = both_signs([0.0, SMALLEST, SMALLEST_NORMAL, 1e-200, 1.0, 3.0, 1e200, LARGEST, INFINITY]) + [math.nan]
    pairs = [(y, x) for y in special for x in special]
    return (pairs + repeat(COUNT, lambda: (uniform(-1, 1), uniform(-1, 1))) + repeat(300, lambda: (scaled(-40, 40), scaled(-40, 40)))
            + repeat(100, lambda: (scaled(-1022, 1024), scaled(-1022, 1024))))


def powers():
    special = both_signs([0.0, SMALLEST, 1e-200, 1 / 3, 0.5, neighbour(1.0, -1), 1.0, neighbour(1.0, 1), 2.0, 3.0, 2.0 ** 52 + 1,
                          2.0 ** 53 - 1, 2.0 ** 53, 1e200, LARGEST, INFINITY]) + [math.nan]
    pairs = [(x, y) for x in special for y in special]
    integers = [(float(x), float(y)) for x in range(-12, 13) for y in range(-9, 10) if x]
    roots = [(abs(x), y) for x in repeat(50, lambda: scaled(-300, 300)) for y in (0.5, 1 / 3, 1.5, -0.5)]
    limits = [(x, limit / math.log(x)) for x in repeat(100, lambda: abs(scaled(-300, 300))) for limit in (-744, -720, -707, 709)]
    close = [(1 + scaled(-50, -2), uniform(-700, 700)) for _ in range(200)]
    close = [(x, y / math.log(x)) for x, y in close]
    return pairs + integers + roots + limits + close + repeat(COUNT // 2, lambda: (uniform(0, 10), uniform(-10, 10)))


def binary_logarithms():
    return positive() + [2.0 ** k for k in range(-1074, 1024, 41)] + around(3.0, 1e100)


def decimal_logarithms():
    return positive() + [float(f'1e{k}') for k in range(-323, 309, 7)] + [10.0 ** k for k in range(23)]


def inverse_hyperbolic():
    ends = around(1.0, 0.75, 2.0 ** 26, 2.0 ** 27, 2.0 ** 28, 2.0 ** -26, 2.0 ** -27, 2.0 ** -28, 2.0 ** -53, 2.0 ** 53, 1.3407807929942596e154)
    return (SPECIAL + ends + repeat(COUNT, lambda: uniform(-4, 4)) + repeat(500, lambda: scaled(-60, 60))
            + repeat(100, lambda: scaled(-1074, 1024)))


def above_one():
    close = [neighbour(1.0, 2 ** k + j) for k in range(52) for j in (0, 1, 3)]
    return (SPECIAL + close + around(2.0 ** 26, 2.0 ** 28, 1.3407807929942596e154) + repeat(COUNT, lambda: uniform(1, 8))
            + repeat(300, lambda: 1 + abs(scaled(-50, 1))) + repeat(300, lambda: abs(scaled(0, 60))) + repeat(100, lambda: abs(scaled(0, 1024))))


def inside_one():
    return (unit_interval() + around(2.0 ** -26, 2.0 ** -27, 2.0 ** -28, 2.0 ** -53, 1 / 3) + repeat(100, lambda: scaled(-1074, -60)))


def legs():
    near = [(x, neighbour(x, step)) for x in (1.0, 2.0 ** 500, 2.0 ** -500, 2.0 ** 511) for step in (-1, 0, 1)]
    exact = [(3.0 * k, 4.0 * k) for k in (1.0, 2.0 ** 1000, 2.0 ** -1074, 2.0 ** 500, 2.0 ** -500)]
    far = [(x, math.ldexp(x, -k)) for x in (1.0, 1.5, neighbour(2.0, -1)) for k in range(20, 30)]
    large = repeat(50, lambda: (abs(scaled(1022, 1024)) / 1.5, scaled(1000, 1023)))
    return points() + near + exact + far + large + repeat(100, lambda: (scaled(-1074, -1000), scaled(-1074, -1000)))


ARGUMENTS = {'sin': angles, 'cos': angles, 'tan': angles, 'asin': unit_interval, 'acos': unit_interval, 'atan': slopes, 'atan2': points,
             'sinh': hyperbolic, 'cosh': hyperbolic, 'tanh': hyperbolic, 'exp': exponents, 'log': positive, 'cbrt': cubes, 'pow': powers,
             'log2': binary_logarithms, 'log10': decimal_logarithms, 'asinh': inverse_hyperbolic, 'acosh': above_one, 'atanh': inside_one,
             'hypot': legs}


# --- polynomials of wasm/functions_constants.c

def interpolated(function, low, high, count):
    """Coefficients of the polynomial that agrees with the function at Chebyshev's points."""
    points = [(low + high) / 2 + (high - low) / 2 * mpmath.cos(mp.pi * (2 * i + 1) / (2 * count)) for i in range(count)]
    matrix = mpmath.matrix([[z ** j for j in range(count)] for z in points])
    return [float(c) for c in mpmath.lu_solve(matrix, mpmath.matrix([function(z) for z in points]))]


def print_coefficients():
    def odd(function):
        return lambda z: (function(mpmath.sqrt(z)) / mpmath.sqrt(z) - 1) / z
    with mp.workprec(300):
        wanted = {
            'arctangent': (odd(mpmath.atan), 1e-12, 1 / 9, 10),
            'exponential': (lambda r: (mpmath.exp(r) - 1 - r) / r ** 2 if abs(r) > 1e-20 else mpf(0.5), -0.34665, 0.34665, 11),
            'hyperbolic_sine': (odd(mpmath.sinh), 1e-12, 1, 8),
            'wide_logarithm': (lambda w: (3 * mpmath.atanh(mpmath.sqrt(w)) / mpmath.sqrt(w) - 3 - w) / w ** 2, 1e-9, 0.029438, 8)}
        for name, (function, low, high, count) in wanted.items():
            print(name, ', '.join(c.hex() for c in interpolated(function, mpf(low), mpf(high), count)))


def print_table():
    print('function,x,y,value,rest')
    for name, arguments in ARGUMENTS.items():
        for argument in arguments():
            print(line(name, *argument) if isinstance(argument, tuple) else line(name, argument))


if __name__ == '__main__':
    print_coefficients() if sys.argv[1:] == ['coefficients'] else print_table()
