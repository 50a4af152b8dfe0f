/** How much coordinates count, so that distances in them are about lengths: degrees beside radii are not to be compared as they are. */

import { CONVERGED } from '../runtime/status.js';

/** Steps of length 0, which only tell how fast coordinates change, are taken from the middles of so many cells a direction. */
const CELLS = 5;
const STILL = { points: 1, tolerance: 1 };

/**
 * Of each coordinate the power of two that is about as long as a step of 1 along it; 1 where nothing tells.
 * @param {number} kind of the surface @param {import('./domain.js').Domain | null} domain @param {import('../search/routes.js').Field['run']} run
 * @returns {readonly number[]}
 */
export function scaleOf(kind, domain, run) {
  if (!domain) return [1, 1, 1];
  const { lower, upper } = domain;
  const middles = Array.from({ length: CELLS ** 2 }, (_, k) =>
    [Math.floor(k / CELLS), k % CELLS].map((cell, j) => lower[j] + ((cell + 0.5) / CELLS) * (upper[j] - lower[j])),
  );
  return [0, 1].map((j) => {
    const direction = [1 - j, j];
    const lengths = middles.flatMap((from) => {
      const still = run((heap, record) => heap.trace(record, { kind, from, direction, length: 0 }, STILL));
      return still?.status === CONVERGED && still.end ? [1 / still.end.velocity[j]] : [];
    });
    lengths.sort((a, b) => a - b);
    return nextPower(lengths[lengths.length >> 1]);
  });
}

/** @param {number | undefined} x */
function nextPower(x) {
  if (x === undefined || !(x > 0 && x < Infinity)) return 1;
  let power = 1;
  while (power * Math.SQRT2 < x) power *= 2;
  while (power > x * Math.SQRT2) power /= 2;
  return power;
}
