/** Many pairs of points in one flat array, checked: what is wrong with one pair is that pair's status, what is wrong with the array is an exception. */

import { readList } from './definition.js';
import { enterDomain } from './manifold/domain.js';
import { readOptions } from './path.js';
import { NOT_FINITE, OFF_SURFACE } from './runtime/status.js';
import { listOf } from './vector.js';

/**
 * Options of paths that many pairs share.
 * @param {string} caller @param {import('./path.js').PairOptions | undefined} given
 * @returns {{ solve: import('./runtime/heap.js').SolveOptions, start: 'global' | 'straight' }}
 */
export function readPairOptions(caller, given) {
  const { solve, start } = readOptions(caller, given);
  if (start !== 'global' && start !== 'straight') throw new RangeError(`${caller}: options.start must be 'global' or 'straight'`);
  return { solve, start };
}

/** @param {string} caller @param {any} pairs @param {string[]} variables @returns {Float64Array} a copy */
export function readPairNumbers(caller, pairs, variables) {
  return readList(`${caller}: pairs`, pairs, [...variables, ...variables], 'pair');
}

/** @param {number[]} point @param {import('./manifold/domain.js').Domain | null} domain @returns {number[] | null} null: outside the rectangle */
function enter(point, domain) {
  if (!domain) return point;
  try {
    return enterDomain(domain, point, '', '', []);
  } catch (error) {
    if (error instanceof RangeError) return null;
    throw error;
  }
}

/**
 * The ends of each pair, or why it has none.
 * @param {string} caller @param {unknown} pairs @param {string[]} variables of a point @param {import('./manifold/domain.js').Domain | null} domain
 * @returns {(number[][] | typeof NOT_FINITE | typeof OFF_SURFACE)[]}
 */
export function readPairs(caller, pairs, variables, domain) {
  const numbers = readPairNumbers(caller, pairs, variables);
  const width = variables.length;
  return Array.from({ length: numbers.length / (2 * width) }, (_, i) => {
    const pair = listOf(numbers, 2 * width * i, 2 * width * (i + 1));
    if (!pair.every(Number.isFinite)) return NOT_FINITE;
    const [from, to] = [enter(pair.slice(0, width), domain), enter(pair.slice(width), domain)];
    return from && to ? [from, to] : OFF_SURFACE;
  });
}
