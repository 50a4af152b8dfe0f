/** Singular places of an implicit surface, where ∇f = 0: what second derivatives tell of them, and steps to curves of such places. */

import { dot, gap, largest as largestOf, listOf, norm, unit } from '../vector.js';

/** Jets of places, ten numbers each. @typedef {(places: ArrayLike<number>) => Float64Array} Jets */

/** @typedef {{ place: number[], along: number[] }} Crossing a place on a curve along which the surface crosses itself, and the curve's direction there */

/** Steps to a singular place; f is zero there, and second derivatives are not singular, up to these parts of what they could be. */
export const [STEPS, ZERO, SINGULAR] = [12, 1e-13, 1e-6];
/** A step is at rest that is shorter than this part of the box; and of the one before it each is this part at most. */
export const [AT_REST, SHRINKING] = [1e-12, 0.8];

/** @param {number[][]} vectors */
export const longest = (vectors) => vectors.reduce((most, v) => (norm(v) > norm(most) ? v : most));

/** The jet of one of several places, f, ∇f and f″. @param {Float64Array} jets @param {number} i */
export const jetOf = (jets, i) => listOf(jets, 10 * i, 10 * i + 10);

/** The rows of a symmetric matrix. @param {number[]} six of its numbers: xx xy xz yy yz zz */
const rowsOf = ([xx, xy, xz, yy, yz, zz]) => [
  [xx, xy, xz],
  [xy, yy, yz],
  [xz, yz, zz],
];

/** @param {number[]} second six numbers of f″ @param {ArrayLike<number>} v */
export const times = (second, v) => rowsOf(second).map((row) => dot(row, v));

/** The cofactors of f″, in the order of its numbers. @param {number[]} second */
export const cofactors = ([xx, xy, xz, yy, yz, zz]) => [
  yy * zz - yz * yz,
  yz * xz - xy * zz,
  xy * yz - yy * xz,
  zz * xx - xz * xz,
  xz * xy - yz * xx,
  xx * yy - xy * xy,
];

/** The trace of a symmetric matrix. @param {number[]} six of its numbers */
const traceOf = (six) => six[0] + six[3] + six[5];

/** Whether f″, where it is singular, has eigenvalues above and below zero: their product is the sum of its minors. @param {number[]} second */
export const isSaddle = (second) => traceOf(cofactors(second)) < 0;

/**
 * A form that is singular, as second derivatives are where sheets touch or cross: of rank 2 it is zero along a line, of rank 1 in a plane.
 * @param {number[]} second
 * @returns {{ isLine: boolean, axis: number[], back: (slope: number[]) => number[], trace: number, product: number, largest: number }} axis: the line, or what is normal to the
 *   plane; back: how far it is to where f is stationary, by its inverse in the directions in which it has one; product: of its two eigenvalues that are not zero
 */
export function formOf(second) {
  const minors = cofactors(second);
  const [trace, product] = [second, minors].map(traceOf);
  const largest = largestOf(second);
  const isLine = Math.abs(product) > SINGULAR * largest ** 2;
  const axis = unit(longest(rowsOf(isLine ? minors : second)));
  const back = (/** @type {number[]} */ slope) => {
    const bent = times(second, slope);
    if (!isLine) return bent.map((x) => x / trace ** 2);
    const turned = bent.map((x, j) => (trace * slope[j] - x) / product);
    const along = dot(turned, axis);
    return turned.map((x, j) => x - along * axis[j]);
  };
  return { isLine, axis, back, trace, product, largest };
}

/** Where a step leads to which ∇f vanishes f is f − ½∇f·by, but for so much of what second derivatives make of the step, by those of higher order. */
const HIGHER = 10;

/** Whether f may be zero where steps end. @param {number[]} jet @param {number[]} by the next of them @param {number} largest number of f″ @param {number} size of the box */
export const endsAtZero = (jet, by, largest, size) =>
  Math.abs(jet[0] - dot(by, jet.slice(1)) / 2) <= largest * (HIGHER * dot(by, by) + ZERO * size ** 2);

/**
 * The crossings to which steps lead from some places, none where they lead to none. All take a step together.
 * @param {(places: ArrayLike<number>) => Float64Array} jets @param {number[][]} places @param {number} far no step leads farther from where it began
 * @param {number} size of the box
 * @returns {(Crossing | null)[]} one a place
 */
export function crossingsFrom(jets, places, far, size) {
  const walks = places.map((from) => ({ from, at: from, last: Infinity, crossing: /** @type {Crossing | null} */ (null) }));
  let walking = walks;
  for (let k = 0; k < STEPS && walking.length > 0; k++) {
    const seen = jets(walking.flatMap(({ at }) => at));
    walking = walking.filter((walk, i) => {
      const jet = jetOf(seen, i);
      const { isLine, axis, back, product, largest } = formOf(jet.slice(4));
      if (!isLine) return false;
      const by = back(jet.slice(1, 4));
      walk.at = walk.at.map((x, j) => x - by[j]);
      const step = norm(by);
      const isAtRest = step <= AT_REST * size;
      if (isAtRest && product < 0 && Math.abs(jet[0]) <= ZERO * largest * size ** 2) walk.crossing = { place: walk.at, along: axis };
      /* To a crossing steps shrink; by far most walks lead to none, and end here. */
      const isOn = !isAtRest && endsAtZero(jet, by, largest, size) && step <= SHRINKING * walk.last && gap(walk.at, walk.from) <= far;
      walk.last = step;
      return isOn;
    });
  }
  return walks.map(({ crossing }) => crossing);
}
