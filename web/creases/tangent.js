/** How a side of the surface measures directions at a place, and where geodesics lead that begin there. */

import { CONVERGED } from '../runtime/status.js';
import { ahead, product } from './linear.js';

/** @typedef {import('../runtime/result.js').RawPath} RawPath */
/** @typedef {import('../manifold/sides.js').Side} Side */
/** @typedef {{ field: import('../search/routes.js').Field, sides: import('../manifold/sides.js').Sides }} Surface */

/** A geodesic on one side, from a place. @param {{ field: Surface['field'], tolerance: number }} tracing @param {Side} side @param {number[]} from @param {number[]} direction @param {number} length @param {number} [points] @returns {RawPath | null} */
export function traceOn({ field, tolerance }, side, from, direction, length, points = 1) {
  return side.run((heap, record) => heap.trace(record, { kind: field.kind, from, direction, length }, { points, tolerance }));
}

/** A direction as a velocity, as a side measures it, of which the tangent part counts; null: it has none. @param {Surface} surface @param {number[]} signs @param {number[]} place @param {number[]} direction */
export function velocityOn({ field, sides }, signs, place, direction) {
  const side = sides.on(signs);
  const still = side && traceOn({ field, tolerance: 1 }, side, place, direction, 0);
  return (still?.status === CONVERGED && still.end?.velocity) || null;
}

/** How long a tangent vector is, as a side measures it; NaN: it is none there. @param {Surface} surface @param {number[]} signs @param {number[]} place @param {number[]} vector */
export function speedOn(surface, signs, place, vector) {
  const velocity = velocityOn(surface, signs, place, vector);
  return velocity ? product(vector, vector) / product(vector, velocity) : Number.NaN;
}

/**
 * How a side measures what is along a crease, a unit vector of the coordinates, and what is across, at right angles as it measures: their squared lengths.
 * @param {Surface} surface @param {number[]} signs @param {number[]} place @param {number[]} along @param {number[]} across
 */
export function frameOn(surface, signs, place, along, across) {
  const [t, n, both] = [along, across, ahead(along, across, 1)].map((vector) => speedOn(surface, signs, place, vector) ** 2);
  const skew = (both - t - n) / (2 * t);
  return { t, n: n - skew * skew * t, skew, across: ahead(across, along, -skew) };
}
