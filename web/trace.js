/** What a caller may ask of a traced geodesic, checked. */

import { readNumbers } from './definition.js';
import { checkOptions, describe, MOST_POINTS, readTolerance, wholeNumber } from './path.js';

/**
 * @typedef {object} TraceOptions
 * @property {number} [points] K, points of the path between its ends, equally spaced by length: 1 … 100,000, default 64
 * @property {number} [tolerance] largest error of a step, of the direction and relative to the length: 1e-14 … 0.01, default 1e-12
 */

/**
 * @param {string} caller @param {unknown} direction @param {unknown} length @param {number} dimension 2 or 3
 * @returns {{ direction: number[], length: number }}
 */
export function readTrace(caller, direction, length, dimension) {
  const numbers = readNumbers(caller, 'direction', direction, dimension);
  if (numbers.every((x) => x === 0)) throw new RangeError(`${caller}: direction must not be zero; only its length does not matter`);
  if (typeof length !== 'number') throw new TypeError(`${caller}: length must be a number, not ${describe(length)}`);
  if (!(length >= 0 && length < Infinity))
    throw new RangeError(`${caller}: length must be a finite number that is not negative, not ${length}`);
  return { direction: numbers, length };
}

/** @param {string} caller @param {TraceOptions | undefined} given @returns {{ points: number, tolerance: number }} */
export function readTraceOptions(caller, given) {
  const { points = 64, tolerance = 1e-12 } = checkOptions(caller, given, ['points', 'tolerance']);
  return { points: wholeNumber(caller, 'points', points, 1, MOST_POINTS), tolerance: readTolerance(caller, tolerance, 1e-14, 0.01) };
}
