/** Options in, Path out: what a caller may ask of a path, checked, and how the solver's answer is handed back as plain data. */

/**
 * How a path ended. `converged`: as asked. Usable, weaker: `iteration-limit`, `stalled`, `tolerance-not-met`, `ill-conditioned`, `saddle`, `edge-reached`.
 * No path: `disconnected`, `singular-metric`, `sheet-jump`, `off-surface`, `not-finite`, `out-of-memory`.
 * @typedef {'converged' | 'iteration-limit' | 'stalled' | 'tolerance-not-met' | 'ill-conditioned' | 'saddle' | 'edge-reached'
 *   | 'disconnected' | 'singular-metric' | 'sheet-jump' | 'off-surface' | 'not-finite' | 'out-of-memory'} Status
 */

/** @type {Map<number, Status>} enum sp_status of wasm/status.h */
export const STATUS = new Map([
  [0, 'converged'],
  [1, 'iteration-limit'],
  [2, 'stalled'],
  [3, 'tolerance-not-met'],
  [4, 'ill-conditioned'],
  [5, 'saddle'],
  [6, 'edge-reached'],
  [-1, 'disconnected'],
  [-2, 'singular-metric'],
  [-3, 'sheet-jump'],
  [-4, 'off-surface'],
  [-5, 'not-finite'],
  [-6, 'out-of-memory'],
]);

/**
 * @typedef {object} Path a path, plain data, copies only
 * @property {Status} status how the computation ended
 * @property {boolean} converged true for status `converged` alone
 * @property {number} length in the unit of the surface's coordinates, or in that of its metric or density; NaN without a path
 * @property {number} lengthError estimate of |length − length of the geodesic|, same unit
 * @property {Float64Array} points x y z of the K + 2 points, end points included; empty without a path, and on surfaces without positions
 * @property {Float64Array | null} parameters u v of the K + 2 points, continuous across seams; null for implicit surfaces
 * @property {number} iterations Newton steps
 * @property {number} energy E = (K + 1) Σ |chord|², unit length²
 * @property {number} gradientNorm Euclidean norm over all unknowns of ∇E
 * @property {number} index Morse index; 0: locally shortest; −1: not computed
 * @property {boolean} touchesBoundary some inner point lies on an edge of the parameter rectangle
 * @property {boolean} crossesSingularity the path crosses a curve where the surface is singular
 * @property {number | null} conjugate first conjugate length (traced paths only)
 * @property {import('./runtime/heap.js').Iterate[]} history one entry a step and one for the end: energy, gradientNorm, decrement, step; with `record` the points
 */

/**
 * @typedef {object} PathOptions
 * @property {'polyline' | 'paper'} [algorithm] 'polyline' (default): chords through exactly `points` unknown inner points, certified; 'paper': the same with the
 *   paper's sign test and line search
 * @property {number} [points] K, inner points of the polyline: 1 … 100,000, default 64
 * @property {'straight' | ArrayLike<number> | Path} [start] default 'straight': the straight line of the parameters (implicit: of space, projected); a
 *   polyline (u v or x y z, ends included) or an earlier path: a warm start
 * @property {number} [maxIterations] Newton steps at most, default 100
 * @property {number} [gradientTolerance] stop at ‖∇E‖ ≤ this, the paper's test; default: a scale-free Newton decrement of 1e-7 ('paper': 1e-6)
 * @property {boolean} [record] keep every iterate's points in `history`
 */

const ALGORITHMS = new Map([
  ['elements', 0],
  ['polyline', 1],
  ['paper', 2],
]);
const KNOWN = ['algorithm', 'points', 'start', 'maxIterations', 'gradientTolerance', 'record', 'tolerance'];
const MOST_POINTS = 100_000;
const MOST_ITERATIONS = 10_000;

/** @param {string} caller @param {string} name @param {unknown} value @param {number} least @param {number} most @returns {number} */
function integer(caller, name, value, least, most) {
  if (typeof value !== 'number') throw new TypeError(`${caller}: options.${name} must be a number, not ${describe(value)}`);
  if (!Number.isInteger(value) || value < least || value > most)
    throw new RangeError(`${caller}: options.${name} must be a whole number from ${least} to ${most}, not ${value}`);
  return value;
}

/** A value as an error message shows it. @param {unknown} value */
export function describe(value) {
  if (value === null) return 'null';
  if (typeof value === 'string') return `'${value.length > 40 ? `${value.slice(0, 40)}…` : value}'`;
  if (Array.isArray(value)) return `an array of ${value.length}`;
  return typeof value === 'object' ? 'an object' : String(value);
}

/** Refuses options that do not exist. @param {string} caller @param {object} options @param {string[]} known */
export function checkNames(caller, options, known) {
  for (const [name, value] of Object.entries(options))
    if (!known.includes(name) && value !== undefined)
      throw new TypeError(`${caller}: there is no option '${name}'; the options are ${known.join(', ')}`);
}

/** What is designed but not built yet is refused, never silently replaced. @param {string} caller @param {Record<string, unknown>} options */
function refuseUnbuilt(caller, options) {
  const unbuilt = [
    [options.start === 'global', "start 'global' is not built yet: use 'straight', a polyline or an earlier path"],
    [options.via !== undefined, 'via is not built yet: solve piece by piece'],
  ];
  for (const [asked, message] of unbuilt) if (asked) throw new RangeError(`${caller}: ${message}`);
}

/**
 * Checks the options of a path and fills in the defaults.
 * @param {string} caller name of the function, for messages
 * @param {PathOptions | undefined} given
 * @returns {{ solve: import('./runtime/heap.js').SolveOptions, start: 'straight' | ArrayLike<number> | Path }}
 */
export function readOptions(caller, given) {
  if (given !== undefined && (typeof given !== 'object' || given === null))
    throw new TypeError(`${caller}: options must be an object, not ${describe(given)}`);
  const options = /** @type {Record<string, any>} */ (given ?? {});
  refuseUnbuilt(caller, options);
  checkNames(caller, options, KNOWN);
  const { algorithm = 'polyline', points = 64, maxIterations = 100, gradientTolerance, record = false, start = 'straight' } = options;
  const code = ALGORITHMS.get(algorithm);
  if (code === undefined) throw new RangeError(`${caller}: options.algorithm must be 'polyline' or 'paper', not ${describe(algorithm)}`);
  if (gradientTolerance !== undefined && !(typeof gradientTolerance === 'number' && gradientTolerance > 0 && gradientTolerance < Infinity))
    throw new RangeError(`${caller}: options.gradientTolerance must be a positive number, not ${describe(gradientTolerance)}`);
  if (typeof record !== 'boolean') throw new TypeError(`${caller}: options.record must be true or false, not ${describe(record)}`);
  const solve = {
    tolerance: options.tolerance ?? 1e-9,
    gradientTolerance: gradientTolerance ?? 0,
    algorithm: code,
    points: integer(caller, 'points', points, 1, MOST_POINTS),
    maxIterations: integer(caller, 'maxIterations', maxIterations, 0, MOST_ITERATIONS),
    record,
  };
  return { solve, start };
}

/**
 * The numbers of a given start: of a polyline, or of an earlier path.
 * @param {string} caller @param {'straight' | ArrayLike<number> | Path} start @param {number} dimension 2 or 3
 * @returns {Float64Array | null} null: straight
 */
export function readStart(caller, start, dimension) {
  if (start === 'straight') return null;
  const path = /** @type {any} */ (start);
  const isPath = typeof path === 'object' && path !== null && path.points instanceof Float64Array;
  const numbers = isPath ? (dimension === 2 ? path.parameters : path.points) : path;
  const what = dimension === 2 ? 'u v' : 'x y z';
  if (isPath && !(numbers?.length > 0))
    throw new RangeError(`${caller}: options.start is a path without ${what}, of status '${path.status}'`);
  if (typeof numbers !== 'object' || numbers === null || typeof numbers.length !== 'number')
    throw new TypeError(
      `${caller}: options.start must be 'straight', a polyline (a flat array of ${what}) or a path, not ${describe(start)}`,
    );
  if (numbers.length % dimension || numbers.length < 2 * dimension || numbers.length > dimension * 1e6)
    throw new RangeError(`${caller}: options.start must be a flat array of ${what}, 2 to 1,000,000 points, not ${numbers.length} numbers`);
  const copy = Float64Array.from(/** @type {ArrayLike<number>} */ (numbers));
  const bad = copy.findIndex((x) => !Number.isFinite(x));
  if (bad >= 0) throw new RangeError(`${caller}: options.start[${bad}] must be a finite number, not ${describe(numbers[bad])}`);
  return copy;
}

/** @param {import('./runtime/heap.js').RawPath} raw @returns {Path} */
export function makePath(raw) {
  const status = /** @type {Status} */ (STATUS.get(raw.status));
  return {
    status,
    converged: status === 'converged',
    length: raw.length,
    lengthError: raw.lengthError,
    points: raw.points,
    parameters: raw.parameters,
    iterations: raw.iterations,
    energy: raw.energy,
    gradientNorm: raw.gradientNorm,
    index: raw.index,
    touchesBoundary: raw.touchesBoundary,
    crossesSingularity: false,
    conjugate: null,
    history: raw.history,
  };
}
