/** How a side of the surface measures directions at a place, and where geodesics lead that begin there. */

import { CONVERGED } from '../runtime/status.js';
import { ahead } from './linear.js';

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

/** The product that measures tangent vectors on a side, at a place; NaN: there is none. @param {Surface} surface @param {number[]} signs @param {number[]} place @returns {import('../manifold/sides.js').Product} */
function timesOn({ sides }, signs, place) {
  const side = sides.on(signs);
  return side ? side.productOf(side.jets(place)[0]) : () => Number.NaN;
}

/** How long a tangent vector is, as a side measures it; NaN: it is none there. @param {Surface} surface @param {number[]} signs @param {number[]} place @param {number[]} vector */
export const speedOn = (surface, signs, place, vector) => Math.sqrt(timesOn(surface, signs, place)(vector, vector));

/**
 * How a side measures what is along a crease, a unit vector of the coordinates, and what is across, at right angles as it measures: their squared lengths.
 * @param {Surface} surface @param {number[]} signs @param {number[]} place @param {number[]} along @param {number[]} across
 */
export function frameOn(surface, signs, place, along, across) {
  const times = timesOn(surface, signs, place);
  const t = times(along, along);
  const skew = times(along, across) / t;
  return { t, n: times(across, across) - skew * skew * t, skew, across: ahead(across, along, -skew) };
}
