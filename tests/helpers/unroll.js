import { simpson } from './simpson.js';

/** @typedef {import('./random.js').Random} Random */

/**
 * The length of the shortest path over z = f(x), which unrolls into a plane.
 * @param {(x: number) => number} slope f′, smooth @param {number[][]} ends x and y of each @param {number} [parts] even; of Simpson's rule
 */
export const unroll = (slope, [from, to], parts) =>
  Math.hypot(
    simpson((x) => Math.hypot(1, slope(x)), from[0], to[0], parts),
    to[1] - from[1],
  );

/** The slope of waves along x. @param {number} waves their wave number @param {number} slope the greatest @returns {(x: number) => number} */
export const corrugated = (waves, slope) => (x) => slope * Math.cos(waves * x);

/** Ends of a path across most of the square between −1 and 1. @param {Random} random */
export const acrossWaves = (random) => [-1, 0.6].map((x) => [random.between(x, x + 0.4), random.between(-1, 1)]);
