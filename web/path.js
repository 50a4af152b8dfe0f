/** Options in, Path out: what a caller may ask of a path, checked, and how the solver's answer is handed back as plain data. */

import { checkBoolean, checkOptions, readFinite, readTolerance, refuse, refuseName, refuseNumber, wholeNumber } from './arguments.js';
import { confine } from './manifold/domain.js';
import { STATUS } from './runtime/status.js';

/**
 * How a path ended. `converged`: as asked. Usable, weaker: `iteration-limit`, `stalled`, `tolerance-not-met`, `ill-conditioned`, `saddle`, `edge-reached`.
 * No path: `disconnected`, `singular-metric`, `sheet-jump`, `off-surface`, `not-finite`, `out-of-memory`; from a pool also `worker-died`.
 * @typedef {'converged' | 'iteration-limit' | 'stalled' | 'tolerance-not-met' | 'ill-conditioned' | 'saddle' | 'edge-reached'
 *   | 'disconnected' | 'singular-metric' | 'sheet-jump' | 'off-surface' | 'not-finite' | 'out-of-memory' | 'worker-died'} Status
 */

/**
 * @typedef {object} Path a path, plain data, copies only
 * @property {Status} status how the computation ended
 * @property {boolean} converged true for status `converged` alone
 * @property {number} length in the unit of the surface's coordinates, or in that of its metric or density: of 'polyline' and 'paper' the sum of the chords; NaN
 *   without a path
 * @property {number} lengthError estimate of |length − length of the geodesic| (traced: of the error of the end's position), same unit
 * @property {Float64Array} points x y z of the K + 2 points, end points included; empty without a path, and on surfaces without positions
 * @property {Float64Array | null} parameters u v of the K + 2 points, continuous across seams; null for implicit surfaces, and without a path
 * @property {number} iterations Newton steps, also those that led to no path (traced: steps of the integrator that were taken; a try that is too long is none, but one of the 200,000 after which a trace ends)
 * @property {number} energy E = (K + 1) Σ |chord|², unit length²; 'elements': ∫ |X′|² over a unit of time, in which the arcs of a path share as their lengths do; NaN
 *   if traced, as gradientNorm
 * @property {number} gradientNorm Euclidean norm over all unknowns of ∇E
 * @property {number} index Morse index; 0: locally shortest, and with status `converged` certified to be; −1: not computed
 * @property {boolean} touchesBoundary some inner point lies on an edge of the parameter rectangle (where the surface is not smooth around a pole, that may be the pole)
 * @property {boolean} crossesSingularity the path crosses a curve where the surface is singular; with `'singular-metric'`: that is why there is none
 * @property {number | null} conjugate traced: length at which the first point conjugate to the start lies, null if there is none on the path; else null
 * @property {import('./runtime/result.js').Iterate[]} history one entry a step and one for the end: energy, gradientNorm, decrement, step; with `record` the points. NaN: not needed, so not computed.
 *   'elements': energies on the scale of the last discretisation; of a path of arcs the steps before it was cut into them
 */

/**
 * @typedef {object} PathOptions
 * @property {'elements' | 'polyline' | 'paper'} [algorithm] 'elements' (default): high-order elements, as many as `tolerance` asks for; 'polyline' (default where
 *   `gradientTolerance` is given): chords through exactly `points` unknown inner points, certified; 'paper': the same with the
 *   paper's sign test and line search
 * @property {number} [points] K, inner points of the polyline: 1 … 100,000, default 64, or 2n + 1 for more than 31 points on the way
 * @property {'global' | 'straight' | ArrayLike<number> | Path} [start] default 'global': the shortest of all paths that a graph search of the surface found;
 *   'straight': the locally shortest path near the straight line of the parameters (implicit: of space, projected); a polyline (u v or x y z, ends
 *   included, 2 to 1,000,000 points; what leads out of the rectangle is moved to its edge) or an earlier path: a warm start
 * @property {readonly ArrayLike<number>[]} [via] points (u v or x y z) that the path passes in this order, by the shortest piece from each to the next
 * @property {number} [maxIterations] Newton steps at most, in all stages of a path together, default 100; 'elements', which has many stages: 400
 * @property {number} [gradientTolerance] stop at ‖∇E‖ ≤ this, the paper's test; default: a scale-free Newton decrement of 1e-7 ('paper': 1e-6)
 * @property {number} [tolerance] 'elements': wanted relative error of the length, and of positions over the length, 1e-15 … 0.1, default 1e-9
 * @property {boolean} [record] keep every iterate's points in `history`
 */

/** Options of paths that many pairs share. @typedef {Omit<PathOptions, 'start' | 'via'> & { start?: 'global' | 'straight' }} PairOptions */
/**
 * @typedef {object} OfAll
 * @property {'global'} [start] no other: all paths are looked for
 * @property {number} [max] paths at most, 1 … 100,000, default 16
 */

/** Options of all geodesics between two points. @typedef {Omit<PathOptions, 'start' | 'via'> & OfAll} GeodesicsOptions */

const ALGORITHMS = new Map([
  ['elements', 0],
  ['polyline', 1],
  ['paper', 2],
]);
const KNOWN = ['algorithm', 'points', 'start', 'maxIterations', 'gradientTolerance', 'record', 'tolerance'];
export const MOST_POINTS = 100_000;
const MOST_ITERATIONS = 10_000;

/**
 * Checks the options of a path and fills in the defaults.
 * @param {string} caller name of the function, for messages
 * @param {PathOptions | undefined} given
 * @param {string[]} [others] options that this caller takes besides
 * @returns {{ solve: import('./runtime/heap.js').SolveOptions, start: 'global' | 'straight' | ArrayLike<number> | Path, via: unknown[] }}
 */
export function readOptions(caller, given, others = []) {
  const options = checkOptions(caller, given, [...KNOWN, ...others]);
  const { gradientTolerance, record = false, start = 'global', via = [], tolerance = 1e-9 } = options;
  const { points = Math.max(64, 2 * via?.length + 1) } = options;
  const { algorithm = gradientTolerance === undefined ? 'elements' : 'polyline' } = options;
  const { maxIterations = algorithm === 'elements' ? 400 : 100 } = options;
  const code = ALGORITHMS.get(algorithm);
  if (code === undefined) refuseName(`${caller}: options.algorithm`, "'elements', 'polyline' or 'paper'", algorithm);
  const [own, foreign] = algorithm === 'elements' ? ['tolerance', 'gradientTolerance'] : ['points and gradientTolerance', 'tolerance'];
  if (options[foreign] !== undefined)
    throw new RangeError(`${caller}: options.${foreign} is no option of '${algorithm}', which takes ${own}`);
  if (gradientTolerance !== undefined && !(Number.isFinite(gradientTolerance) && gradientTolerance > 0))
    refuseNumber(`${caller}: options.gradientTolerance`, 'a positive number', gradientTolerance);
  checkBoolean(caller, 'record', record);
  if (!Array.isArray(via)) refuse(`${caller}: options.via`, 'an array of points', via);
  const solve = {
    tolerance: readTolerance(caller, tolerance, 1e-15, 0.1),
    gradientTolerance: gradientTolerance ?? 0,
    algorithm: code,
    points: wholeNumber(caller, 'points', points, 1, MOST_POINTS),
    maxIterations: wholeNumber(caller, 'maxIterations', maxIterations, 0, MOST_ITERATIONS),
    record,
  };
  return { solve, start, via };
}

/**
 * The numbers of a given start: of a polyline, or of an earlier path.
 * @param {string} caller @param {'straight' | ArrayLike<number> | Path} start
 * @param {import('./manifold/domain.js').Domain | null} domain the rectangle, whose edges stand for what leads out of it; null: implicit
 * @returns {Float64Array | null} null: straight
 */
export function readStart(caller, start, domain) {
  if (start === 'straight') return null;
  const [dimension, what, field] = domain ? [2, 'u v', 'parameters'] : [3, 'x y z', 'points'];
  const path = /** @type {any} */ (start);
  const isGiven = typeof path?.status === 'string';
  const numbers = isGiven ? path[field] : path;
  if (isGiven && !(numbers?.length > 0))
    throw numbers && numbers.length === undefined
      ? new TypeError(`${caller}: options.start has lost its arrays to JSON; give Array.from(path.${field})`)
      : new RangeError(`${caller}: options.start is a path without ${what}, of status '${path.status}'`);
  if (typeof numbers !== 'object' || numbers === null || typeof numbers.length !== 'number')
    refuseName(`${caller}: options.start`, `'global', 'straight', a polyline (a flat array of ${what}) or a path`, start);
  if (Array.isArray(numbers) && numbers.some(Array.isArray))
    throw new TypeError(`${caller}: options.start must be a flat array of ${what}, not one of arrays; write points.flat()`);
  if (numbers.length % dimension || numbers.length < 2 * dimension || numbers.length > dimension * 1e6)
    throw new RangeError(`${caller}: options.start must be a flat array of ${what}, 2 to 1,000,000 points, not ${numbers.length} numbers`);
  const line = Float64Array.from(readFinite(caller, 'options.start', numbers));
  return domain ? confine(domain, line) : line;
}

/** Whether it is a geodesic, certified as far as it can be. @param {Path} path */
export const isGeodesic = ({ status }) => status === 'converged' || status === 'ill-conditioned';

/** What the length of a path is at most; infinite where there is none. @param {Path} path */
export const mostOf = (path) => (path.length >= 0 ? path.length + (isGeodesic(path) ? 0 : path.lengthError || 0) : Infinity);

/** A path beside which a shorter one may be. @param {Path} path @returns {Path} */
export const stalled = (path) => ({ ...path, status: 'stalled', converged: false });

/** @param {import('./runtime/result.js').RawPath} raw @returns {Path} */
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
    crossesSingularity: raw.crossesSingularity,
    conjugate: raw.conjugate,
    history: raw.history,
  };
}

/** A path as it is where all lengths are so many times as long. @param {Path} path @param {number} factor @returns {Path} */
export function scaled(path, factor) {
  if (factor === 1) return path;
  /** @template {{ energy: number, gradientNorm: number }} T @param {T} one @returns {T} */
  const rise = (one) => ({ ...one, energy: factor ** 2 * one.energy, gradientNorm: factor ** 2 * one.gradientNorm });
  const { length, lengthError, conjugate, history } = path;
  return {
    ...rise(path),
    length: factor * length,
    lengthError: factor * lengthError,
    conjugate: conjugate && factor * conjugate,
    history: history.map(rise),
  };
}
