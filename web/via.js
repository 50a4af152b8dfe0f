/** Paths through given points: the shortest path from each to the next. */

import { findPath } from './intrinsic.js';
import { inOrder, joinPieces } from './search/join.js';

/** @typedef {import('./runtime/heap.js').SolveOptions} SolveOptions */

/**
 * @param {import('./search/routes.js').Field} field @param {string} caller @param {number[][]} places @param {SolveOptions} options @param {unknown} start
 * @returns {import('./path.js').Path}
 */
export function passThrough(field, caller, places, options, start) {
  if (start !== 'global' && start !== 'straight')
    throw new RangeError(`${caller}: options.start must be 'global' or 'straight' where options.via is given`);
  const count = places.length - 1;
  const least = 2 * count - 1;
  if (options.points < least)
    throw new RangeError(`${caller}: options.points must be at least ${least} where options.via has ${count - 1}, not ${options.points}`);
  return inOrder(field.domain, places, (stops) => {
    const solve = (/** @type {number} */ i, /** @type {SolveOptions} */ asked) =>
      findPath(field, stops.slice(i, i + 2), asked, start === 'global' ? start : null);
    return joinPieces(count, options, solve, field.domain);
  });
}
