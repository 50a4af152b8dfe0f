/** Where Newton's method may begin: the straight line between two points and lines that bulge to either side of it. */

import { along, cross, subtract, unit } from './vectors.js';

/** @typedef {import('./tasks.js').Opened} Opened */

/** @typedef {{ places: Float64Array, parameters: Float64Array | null }} Start where a line runs in space, or in the plane of a metric, and in the parameters */

/** How far the lines bulge, in parts of their length. */
const BULGES = [0, 0.22, -0.22, 0.42, -0.42];
const PIECES = 24;

/**
 * Five lines between two points: the straight one and two on each side. In the parameters, or, on an implicit surface, in space, moved onto it.
 * @param {Opened} opened @param {number[]} from @param {number[]} to
 * @returns {Float64Array[]}
 */
export function severalStarts({ surface }, from, to) {
  const aside = surface.kind === 'implicit' ? sideways(surface, from, to) : [from[1] - to[1], to[0] - from[0]];
  return BULGES.map((bulge) => {
    const points = Array.from({ length: PIECES + 1 }, (_, i) => {
      const t = i / PIECES;
      const point = from.map((x, k) => x + t * (to[k] - x) + bulge * Math.sin(Math.PI * t) * aside[k]);
      return surface.kind === 'implicit' ? place(surface, point) : within(surface, point);
    });
    return Float64Array.from(points.flat());
  });
}

/** @param {Opened} opened @param {Float64Array} line @returns {Start} */
export function startOf({ surface, drawn }, line) {
  if (surface.kind === 'implicit') return { places: line, parameters: null };
  const values = drawn.evaluate(line);
  return { places: values.filter((_, i) => i % 6 < 3), parameters: line };
}

/** Across the line and along the surface, as long as the line. @param {import('surfpath').Surface} surface @param {number[]} from @param {number[]} to */
function sideways(surface, from, to) {
  const line = subtract(to, from);
  const middle = along(from, 0.5, line);
  const normal = surface.evaluate(middle).subarray(1, 4);
  const size = Math.hypot(...line);
  return unit(cross(normal, line)).map((x) => x * size);
}

/** @param {import('surfpath').Surface} surface @param {number[]} point */
function place(surface, point) {
  try {
    return surface.project(point, point);
  } catch {
    return point;
  }
}

/** @param {import('surfpath').Surface} surface @param {number[]} point */
function within(surface, point) {
  const { u, v, periodic } = /** @type {NonNullable<import('surfpath').Surface['domain']>} */ (surface.domain);
  const clamp = (/** @type {number} */ x, /** @type {number[]} */ range) => Math.min(Math.max(x, range[0]), range[1]);
  return [periodic.u ? point[0] : clamp(point[0], u), periodic.v ? point[1] : clamp(point[1], v)];
}
