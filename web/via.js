/** Paths through given points: the shortest path from each to the next. */

import { joinPieces } from './join.js';
import { findPath } from './pieces.js';

/**
 * @param {import('./routes.js').Field} field @param {string} caller @param {number[][]} places @param {import('./runtime/heap.js').SolveOptions} options @param {unknown} start
 * @returns {import('./path.js').Path}
 */
export function passThrough(field, caller, places, options, start) {
  if (start !== 'global' && start !== 'straight')
    throw new RangeError(`${caller}: options.start must be 'global' or 'straight' where options.via is given`);
  const count = places.length - 1;
  const least = 2 * count - 1;
  if (options.points < least)
    throw new RangeError(`${caller}: options.points must be at least ${least} where options.via has ${count - 1}, not ${options.points}`);
  const solve = (/** @type {number} */ i, /** @type {number} */ points) =>
    findPath(field, places.slice(i, i + 2), { ...options, points }, start === 'global' ? start : null);
  return joinPieces(count, options.points, solve, field.domain);
}
