/** A geodesic from a point in a direction: the angle of the form as a direction of the surface, and the traced path as the page shows paths. */

import { cross, dot, subtract, unit } from './vectors.js';

/** @typedef {import('surfpath').Surface} Surface */

/** Step of a difference quotient, in parts of the parameters' size. */
const STEP = 1e-6;
/** Where the surface is so many times longer one way than the other, it is a point. */
const FLAT = 1e-8;
const NO_DIRECTION = 'There is no direction at A, as at a tip: move it.';

/** The derivatives S_u and S_v at a point, by differences. @param {Surface} surface @param {readonly number[]} point */
function tangents(surface, point) {
  const { u, v } = /** @type {NonNullable<Surface['domain']>} */ (surface.domain);
  return [u, v].map((range, i) => {
    const step = STEP * (range[1] - range[0]);
    const inside = point[i] + step > range[1] ? -step : step;
    const [here, there] = [point, point.map((x, j) => (i === j ? x + inside : x))].map((p) => surface.evaluate(p).subarray(0, 3));
    return subtract(there, here).map((x) => x / inside);
  });
}

/** E, F and G at a point: what a metric is, else of the tangents. @param {Surface} surface @param {number[]} point */
function formAt(surface, point) {
  if (surface.kind === 'metric') return surface.evaluate(point);
  const [su, sv] = tangents(surface, point);
  return [dot(su, su), dot(su, sv), dot(sv, sv)];
}

/**
 * The direction at an angle from that of u, as u and v, measured as the surface measures it.
 * @param {Surface} surface @param {number[]} point @param {number} turn in radians
 */
function inParameters(surface, point, turn) {
  const [E, F, G] = formAt(surface, point);
  // Of u, and of v as far as it leads away from u.
  const [along, aside] = [Math.sqrt(E), Math.sqrt(G - (F * F) / E)];
  const { u, v } = /** @type {NonNullable<Surface['domain']>} */ (surface.domain);
  const sides = [along * (u[1] - u[0]), aside * (v[1] - v[0])];
  const isFlat = !(Math.min(...sides) > FLAT * Math.max(...sides));
  // What is wrong with a metric the trace says.
  if (isFlat && surface.kind === 'metric') return [1, 0];
  if (isFlat) throw new RangeError(NO_DIRECTION);
  return [Math.cos(turn) / along - (Math.sin(turn) * F) / (E * aside), Math.sin(turn) / aside];
}

/** The direction at an angle from the level one on an implicit surface. @param {Surface} surface @param {number[]} point @param {number} turn in radians */
function inSpace(surface, point, turn) {
  const normal = surface.evaluate(point).subarray(1, 4);
  if (!(dot(normal, normal) > 0)) throw new RangeError(NO_DIRECTION);
  const first = unit(cross(Math.abs(unit(normal)[2]) > 0.9 ? [0, 1, 0] : [0, 0, 1], normal));
  const second = unit(cross(normal, first));
  return first.map((x, k) => Math.cos(turn) * x + Math.sin(turn) * second[k]);
}

/**
 * @param {import('./tasks.js').Opened} opened @param {number[]} from @param {{ angle: number, reach: number, points: number }} options
 * @returns {import('./tasks.js').Solved}
 */
export function tracedPath({ surface }, from, { angle, reach, points }) {
  const turn = (angle * Math.PI) / 180;
  const isImplicit = surface.kind === 'implicit';
  const start = isImplicit ? surface.project(from, from) : from;
  const direction = isImplicit ? inSpace(surface, start, turn) : inParameters(surface, start, turn);
  const begin = performance.now();
  const path = surface.trace(start, direction, reach, { points: Math.max(points, 200) });
  return { paths: [path], legs: [], starts: [], films: [], straight: null, straightLength: NaN, milliseconds: performance.now() - begin };
}
