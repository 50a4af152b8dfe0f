/* The functions and constants that a formula may name, with their derivatives.
 *
 * A derivative is written with what is already there (the value, the slope), so that it costs little, and in a form that stays finite wherever the true
 * derivative is: no infinity over infinity at large arguments, no 0 * infinity at zeros. */

/** @typedef {import('./graph.js').Graph} Graph */

/**
 * A function of one argument. Each method adds nodes to the graph and returns the last: of f(x), f'(x), f''(x).
 * @typedef {{
 *   value: (graph: Graph, x: number) => number,
 *   slope: (graph: Graph, x: number, value: number) => number,
 *   curvature: (graph: Graph, x: number, value: number, slope: number) => number,
 * }} Rule
 */

/**
 * The solver's elementary functions; the position in this list is the number in `enum sp_function` of wasm/functions.h.
 * @type {readonly { name: string, arity: 1 | 2 }[]}
 */
export const solverFunctions = [
  'sin',
  'cos',
  'asin',
  'acos',
  'atan',
  'atan2',
  'sinh',
  'cosh',
  'tanh',
  'exp',
  'log',
  'cbrt',
  'pow',
  'log2',
  'log10',
  'asinh',
  'acosh',
  'atanh',
  'hypot',
].map((name) => ({
  name,
  arity: /** @type {1 | 2} */ (['atan2', 'pow', 'hypot'].includes(name) ? 2 : 1),
}));

/** @param {string} name */
const numberOf = (name) => solverFunctions.findIndex((entry) => entry.name === name);

export const SIN = numberOf('sin');
export const COS = numberOf('cos');
export const ATAN2 = numberOf('atan2');
export const LOG = numberOf('log');
export const POW = numberOf('pow');
export const HYPOT = numberOf('hypot');

/** @type {Map<string, number>} names a formula may use as numbers */
export const constants = new Map([
  ['pi', Math.PI],
  ['e', Math.E],
  ['tau', 2 * Math.PI],
]);

/** Square root of 1 - x², without cancellation near ±1. @param {Graph} g @param {number} x */
const cosineOfArcsine = (g, x) => g.squareRoot(g.multiply(g.subtract(g.one, x), g.add(g.one, x)));

/** @param {Graph} g @param {number} x */
const square = (g, x) => g.multiply(x, x);

/** @param {Graph} g @param {number} x */
const twice = (g, x) => g.multiply(g.constant(2), x);

/**
 * sin x / cos x. Of half an angle a it is taken from the whole one, whose sine and cosine a formula with it mostly has as well (the tractrix and what is made
 * of it): sin a / (1 + cos a) or, which is the same, (1 - cos a) / sin a: the one that adds numbers of one sign. 1.6 ulp; the quotient of both 1.7.
 * @param {Graph} g @param {number} x
 */
function tangent(g, x) {
  const angle = g.doubled(x);
  if (angle === undefined) return g.divide(g.call(SIN, x), g.call(COS, x));
  const [sine, cosine] = [g.call(SIN, angle), g.call(COS, angle)];
  const sum = g.add(g.one, g.absolute(cosine));
  return g.divide(g.select(cosine, g.zero, sum, sine), g.select(cosine, g.zero, sine, sum));
}

/** @param {Graph} g */
const nothing = (g) => g.zero;

/**
 * @param {string} name
 * @param {Rule['slope']} slope
 * @param {Rule['curvature']} curvature
 * @returns {[string, Rule]}
 */
function elementary(name, slope, curvature) {
  const number = numberOf(name);
  return [name, { value: (g, x) => g.call(number, x), slope, curvature }];
}

/**
 * A logarithm to another base.
 * @param {string} name
 * @param {number} slopeAtOne
 */
const logarithm = (name, slopeAtOne) =>
  elementary(
    name,
    (g, x) => g.divide(g.constant(slopeAtOne), x),
    (g, x, _, slope) => g.negate(g.divide(slope, x)),
  );

/** -x f'(x)³, with x f'(x) first: it stays of the size of 1. @type {Rule['curvature']} */
const minusCubeTimes = (g, x, _, slope) => g.negate(g.multiply(g.multiply(x, slope), square(g, slope)));

/** @type {Map<string, Rule>} functions of one argument; floor and sign count as constant, and the slope of abs at 0 is 0 */
export const rules = new Map([
  ['abs', { value: (g, x) => g.absolute(x), slope: (g, x) => g.sign(x), curvature: nothing }],
  ['sign', { value: (g, x) => g.sign(x), slope: nothing, curvature: nothing }],
  ['floor', { value: (g, x) => g.floor(x), slope: nothing, curvature: nothing }],
  [
    'sqrt',
    {
      value: (g, x) => g.squareRoot(x),
      slope: (g, _, value) => g.divide(g.constant(0.5), value),
      curvature: (g, _x, _, slope) => g.negate(g.multiply(square(g, slope), twice(g, slope))),
    },
  ],
  elementary(
    'sin',
    (g, x) => g.call(COS, x),
    (g, _, value) => g.negate(value),
  ),
  elementary(
    'cos',
    (g, x) => g.negate(g.call(SIN, x)),
    (g, _, value) => g.negate(value),
  ),
  [
    'tan',
    {
      value: tangent,
      slope: (g, _, value) => g.add(g.one, square(g, value)),
      curvature: (g, _x, value, slope) => twice(g, g.multiply(value, slope)),
    },
  ],
  elementary(
    'asin',
    (g, x) => g.divide(g.one, cosineOfArcsine(g, x)),
    (g, x, _, slope) => g.multiply(x, g.integerPower(slope, 3)),
  ),
  elementary(
    'acos',
    (g, x) => g.divide(g.constant(-1), cosineOfArcsine(g, x)),
    (g, x, _, slope) => g.multiply(x, g.integerPower(slope, 3)),
  ),
  elementary(
    'atan',
    (g, x) => g.divide(g.one, g.add(g.one, square(g, x))),
    (g, x, _, slope) => g.negate(twice(g, g.multiply(x, square(g, slope)))),
  ),
  elementary(
    'sinh',
    (g, x) => g.call(numberOf('cosh'), x),
    (_g, _x, value) => value,
  ),
  elementary(
    'cosh',
    (g, x) => g.call(numberOf('sinh'), x),
    (_g, _x, value) => value,
  ),
  elementary(
    'tanh',
    (g, _, value) => g.subtract(g.one, square(g, value)),
    (g, _x, value, slope) => g.negate(twice(g, g.multiply(value, slope))),
  ),
  elementary(
    'exp',
    (_g, _x, value) => value,
    (_g, _x, value) => value,
  ),
  elementary(
    'log',
    (g, x) => g.divide(g.one, x),
    (g, _x, _, slope) => g.negate(square(g, slope)),
  ),
  logarithm('log2', Math.LOG2E),
  logarithm('log10', Math.LOG10E),
  elementary('asinh', (g, x) => g.divide(g.one, g.call(HYPOT, x, g.one)), minusCubeTimes),
  // Two roots: their product does not overflow, and is NaN below 1 and -1.
  elementary(
    'acosh',
    (g, x) => g.divide(g.one, g.multiply(g.squareRoot(g.subtract(x, g.one)), g.squareRoot(g.add(x, g.one)))),
    minusCubeTimes,
  ),
  elementary(
    'atanh',
    (g, x) => g.divide(g.one, g.multiply(g.subtract(g.one, x), g.add(g.one, x))),
    (g, x, _, slope) => twice(g, g.multiply(x, square(g, slope))),
  ),
  elementary(
    'cbrt',
    (g, _, value) => g.divide(g.one, g.multiply(g.constant(3), square(g, value))),
    (g, _x, value, slope) => g.negate(g.divide(twice(g, square(g, slope)), value)),
  ),
]);

/** What a name in a formula calls, and with how many arguments. @typedef {{ name: string, least: number, most: number }} Callable */

/** @param {string} written @param {string} name @param {number} least @param {number} most @returns {[string, Callable]} */
const callable = (written, name, least, most) => [written, { name, least, most }];

/** Everything that a formula may call. @type {Map<string, Callable>} */
export const functions = new Map([
  ...[...rules.keys()].map((name) => callable(name, name, 1, 1)),
  callable('ln', 'log', 1, 1),
  callable('atan2', 'atan2', 2, 2),
  callable('pow', 'pow', 2, 2),
  callable('hypot', 'hypot', 1, Number.POSITIVE_INFINITY),
  callable('min', 'min', 1, Number.POSITIVE_INFINITY),
  callable('max', 'max', 1, Number.POSITIVE_INFINITY),
]);
