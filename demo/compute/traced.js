/** A geodesic from a point in a direction: the angle of the form as a direction of the surface, and the traced path as the page shows paths. */

import { along, cross, dot, subtract, unit } from './vectors.js';

/** @typedef {import('surfpath').Surface} Surface */

/** Step of a difference quotient, in parts of the parameters' size. */
const STEP = 1e-6;

/** The derivatives S_u and S_v at a point, by differences. @param {Surface} surface @param {readonly number[]} point */
export function tangents(surface, point) {
  const { u, v } = /** @type {NonNullable<Surface['domain']>} */ (surface.domain);
  return [u, v].map((range, i) => {
    const step = STEP * (range[1] - range[0]);
    const inside = point[i] + step > range[1] ? -step : step;
    const [here, there] = [point, point.map((x, j) => (i === j ? x + inside : x))].map((p) => surface.evaluate(p).subarray(0, 3));
    return subtract(there, here).map((x) => x / inside);
  });
}

/**
 * Two orthonormal tangent vectors at a point: the first in the direction of u, or, on an implicit surface, level.
 * @param {Surface} surface @param {readonly number[]} point
 */
function frameAt(surface, point) {
  if (surface.kind === 'implicit') {
    const normal = unit(surface.evaluate(point).subarray(1, 4));
    const level = cross(Math.abs(normal[2]) > 0.9 ? [0, 1, 0] : [0, 0, 1], normal);
    return [unit(level), unit(cross(normal, level))];
  }
  const [su, sv] = tangents(surface, point);
  const first = unit(su);
  return [first, unit(along(sv, -dot(sv, first), first))];
}

/** A tangent vector as du, dv. @param {Surface} surface @param {readonly number[]} point @param {number[]} vector */
export function inParameters(surface, point, vector) {
  const [su, sv] = tangents(surface, point);
  const [E, F, G] = [dot(su, su), dot(su, sv), dot(sv, sv)];
  const [a, b] = [dot(vector, su), dot(vector, sv)];
  const area = E * G - F * F;
  return [(G * a - F * b) / area, (E * b - F * a) / area];
}

/**
 * @param {import('./tasks.js').Opened} opened @param {number[]} from @param {{ angle: number, reach: number, points: number }} options
 * @returns {import('./tasks.js').Solved}
 */
export function tracedPath({ surface }, from, { angle, reach, points }) {
  const start = surface.kind === 'implicit' ? surface.project(from, from) : from;
  const [first, second] = frameAt(surface, start);
  const turn = (angle * Math.PI) / 180;
  const vector = along(
    [0, 1, 2].map((k) => Math.cos(turn) * first[k]),
    Math.sin(turn),
    second,
  );
  const direction = surface.kind === 'implicit' ? vector : inParameters(surface, start, vector);
  const begin = performance.now();
  const path = surface.trace(start, direction, reach, { points: Math.max(points, 200) });
  return { paths: [path], legs: [], starts: [], films: [], straight: null, straightLength: NaN, milliseconds: performance.now() - begin };
}
