/**
 * Paths from place to place as they are answered: by positions in space or, where these lead astray, by E, F and G. Chords see only what is between their ends in
 * space: where sheets cross or lie close to each other they jump over, and nothing leads back. Over u and v alone there is no other sheet. MATH.md, "Intrinsic paths".
 */

import { compared, ELEMENTS } from './candidates.js';
import { mostOf } from './path.js';
import { findGeodesics as findAllIn, findPath as findIn } from './pieces.js';
import { dot, gap, vector } from './rectangle.js';

/** @typedef {import('./path.js').Path} Path */
/** @typedef {import('./routes.js').Field} Field */
/** @typedef {import('./runtime/heap.js').SolveOptions} SolveOptions */

/** Steps of Newton after which no more is tried; who allows fewer altogether wants to know where they end. */
const STEPS = 100;
/** Statuses of paths that may be none because of how they were measured. */
const ASTRAY = ['stalled', 'singular-metric', 'iteration-limit', 'tolerance-not-met'];
/** Lines are measured from node to node in so many parts, each by Gauss's rule: where in a part, and of what weight. */
const PARTS = 32;
const GAUSS = [-1, 0, 1].map((side) => ({ at: 0.5 + side * Math.sqrt(0.15), weight: side ? 5 / 18 : 4 / 9 }));
/** The surface is torn under a line whose chords are longer than derivatives say by more than this part. */
const TORN = 1e-9;
/** So much of the coordinates is what they leave open of a length. */
const ROUNDING = 1e-15;

/**
 * Places on a line that is straight over u and v from node to node, some in each part.
 * @param {Float64Array} line u v of its nodes @param {number[]} places where in each part
 */
const placesOn = (line, places) =>
  Array.from({ length: (line.length / 2 - 1) * PARTS * places.length * 2 }, (_, i) => {
    const [k, at] = [(i >> 1) % places.length, Math.floor((i >> 1) / places.length)];
    const from = 2 * Math.floor(at / PARTS) + (i & 1);
    return line[from] + (((at % PARTS) + places[k]) / PARTS) * (line[from + 2] - line[from]);
  });

/** How long such a line is. @param {Float64Array} line @param {(places: number[]) => (i: number) => ArrayLike<number>} tensors gives E, F and G of each place */
function lengthAlong(line, tensors) {
  const places = placesOn(
    line,
    GAUSS.map(({ at }) => at),
  );
  const tensor = tensors(places);
  let sum = 0;
  for (let i = 0; 2 * i < places.length; i++) {
    const k = 2 * Math.floor(i / (PARTS * GAUSS.length));
    const [du, dv] = [line[k + 2] - line[k], line[k + 3] - line[k + 1]];
    const { 0: E, 1: F, 2: G } = tensor(i);
    sum += (GAUSS[i % GAUSS.length].weight / PARTS) * Math.sqrt(E * du * du + 2 * F * du * dv + G * dv * dv);
  }
  return sum;
}

/** Whether the surface is no surface under a path: a step, say, which derivatives do not see. @param {Field} field @param {Float64Array} line */
function isTorn({ jets, positions }, line) {
  const length = lengthAlong(line, (places) => {
    const seen = jets(places);
    return (i) => {
      const [a, b] = [vector(seen, i, 3), vector(seen, i, 6)];
      return [dot(a, a), dot(a, b), dot(b, b)];
    };
  });
  const points = /** @type {NonNullable<typeof positions>} */ (positions)([...placesOn(line, [0]), ...line.subarray(-2)]);
  let chords = 0;
  for (let i = 3; i < points.length; i += 3) chords += gap(points.subarray(i, i + 3), points.subarray(i - 3, i));
  return !(chords <= (1 + TORN) * length);
}

/**
 * The surface by its E, F and G, and the options for it, where a path does not hold; null: there is nothing to gain. Ways through branch points are known in space alone.
 * @param {Field} field @param {Path} path @param {SolveOptions} options
 */
function instead({ own, graphs }, path, options) {
  const isOpen = ASTRAY.includes(path.status) && options.algorithm === ELEMENTS && options.maxIterations >= STEPS;
  const field = own && isOpen && !graphs.branches?.length ? own() : null;
  return field && { field, options: { ...options, maxIterations: STEPS } };
}

/** Whether a path by E, F and G is one in space, as good as was asked. @param {Field} field @param {Path} path @param {SolveOptions} options */
function isGood(field, { converged, parameters, points, length }, { tolerance }) {
  if (!converged || !parameters) return false;
  const size = points.reduce((most, x) => Math.max(most, Math.abs(x)), 0);
  return ROUNDING * size <= tolerance * length && !isTorn(field, parameters);
}

/**
 * The path between two ends.
 * @param {Field} field @param {number[][]} ends @param {SolveOptions} options @param {import('./pieces.js').Start} start
 * @returns {Path}
 */
export function findPath(field, ends, options, start) {
  const path = findIn(field, ends, options, start);
  const again = instead(field, path, options);
  if (!again) return path;
  const asked = compared(options);
  const isCompared = options.points === asked.points && !options.record;
  const own = findIn(again.field, ends, compared(again.options), start);
  if (!isGood(field, own, options)) return path;
  /* Chords that stall may have jumped, and are as long as the line through their nodes; any other path is one on the surface. */
  const mayJump = path.status === 'stalled' && !path.crossesSingularity;
  if (!mayJump && own.length > mostOf(path)) return path;
  const line = mayJump && start === 'global' ? (isCompared ? path : findIn(field, ends, asked, start)).parameters : null;
  const tensors = (/** @type {number[]} */ places) => {
    const seen = again.field.jets(places);
    return (/** @type {number} */ i) => seen.subarray(18 * i);
  };
  if (line && own.length > lengthAlong(line, tensors)) return path;
  return isCompared ? own : findIn(again.field, ends, again.options, start);
}

/**
 * All locally shortest paths between two ends that are found, shortest first.
 * @param {Field} field @param {number[][]} ends @param {SolveOptions} options @param {number} most
 * @returns {Path[]}
 */
export function findGeodesics(field, ends, options, most) {
  const paths = findAllIn(field, ends, options, most);
  const again = paths.length === 1 ? instead(field, paths[0], options) : null;
  const own = again ? findAllIn(again.field, ends, again.options, most).filter((path) => isGood(field, path, options)) : [];
  return own.length > 0 ? own : paths;
}
