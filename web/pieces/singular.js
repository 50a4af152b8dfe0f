/** Singular places of an implicit surface, where ∇f = 0: what second derivatives tell of them, and steps to curves of such places. */

import { ahead, scaled } from '../creases/linear.js';
import { cross, dot, gap, largest as largestOf, listOf, norm, unit } from '../vector.js';

/** Jets of places, ten numbers each. @typedef {(places: ArrayLike<number>) => Float64Array} Jets */

/** @typedef {{ place: number[], along: number[], isEdge?: boolean, lengths?: Float64Array }} Crossing a place on a curve along which the surface crosses itself, or ends in a cuspidal edge, and the curve's direction there */

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
    return ahead(turned, axis, -along);
  };
  return { isLine, axis, back, trace, product, largest };
}

/** Two directions at right angles in the plane that is normal to an axis. @param {number[]} axis */
export function planeOf(axis) {
  const aside = unit(longest([cross(axis, [1, 0, 0]), cross(axis, [0, 1, 0])]));
  return [aside, cross(axis, aside)];
}

/** Where a step leads to which ∇f vanishes f is f − ½∇f·by, but for so much of what second derivatives make of the step, by those of higher order. */
const HIGHER = 10;
/** Where the gradient vanishes like a power of these orders, steps shrink by the same part, 1 − 1/order, up to this, and in a row, up to that cosine. */
const [ORDERS, ALIKE, STRAIGHT] = [[2, 3, 4], 0.02, 0.99];

/** @typedef {{ extent: number, far: number }} Reach extent: of the box; far: no walk leads farther from where it began */

/** Steps towards a singular place, of the kind that is looked for. @template T @typedef {{ from: number[], at: number[], by: number[], size: number, limit: number, order: number, end: T | null }} Walk by: the last step; size: of it taken once; limit: what the next shrinks from: where this only mended what one taken several times did to faster coordinates, that; order: taken so many times; end: what is where the steps end */

/** @template T @param {number[]} from @returns {Walk<T>} */
export const walkFrom = (from) => ({ from, at: from, by: [], size: Infinity, limit: Infinity, order: 0, end: null });

/** So many steps are taken: coordinates may approach a node each like a power of its own. */
const LONGEST = 3 * STEPS;

/** Takes a step to where f would be stationary; whether more of them may lead to where it is, and f is zero. @param {Walk<any>} walk @param {number[]} jet @param {number[]} by @param {Reach} reach */
export function step(walk, jet, by, { extent, far }) {
  const { size: before, limit, order } = walk;
  walk.size = norm(by);
  walk.limit = order > 1 ? limit : walk.size;
  const isStraight = order === 1 && dot(by, walk.by) > STRAIGHT * walk.size * before;
  walk.order = (isStraight && ORDERS.find((n) => Math.abs(1 - 1 / n - walk.size / before) < ALIKE)) || 1;
  walk.by = by;
  walk.at = ahead(walk.at, by, -walk.order);
  const mayEnd = Math.abs(jet[0] - dot(by, jet.slice(1)) / 2) <= largestOf(jet.slice(4)) * (HIGHER * dot(by, by) + ZERO * extent ** 2);
  return mayEnd && walk.size <= SHRINKING * limit && gap(walk.at, walk.from) <= far;
}

/**
 * Walks until they end on the surface, or lead to nothing. All take a step together: one by one, calls took most of the time.
 * @template {Walk<any>} W @param {Jets} jets @param {W[]} walks @param {Reach} reach @param {(walk: W, jet: number[]) => boolean} goesOn takes a step @param {(walk: W, jet: number[]) => W['end']} endOf
 */
export function walkOn(jets, walks, { extent }, goesOn, endOf) {
  let walking = walks;
  for (let k = 0; k < LONGEST && walking.length > 0; k++) {
    const seen = jets(walking.flatMap(({ at }) => at));
    walking = walking.filter((walk, i) => {
      const jet = jetOf(seen, i);
      const isOn = goesOn(walk, jet);
      if (!(walk.size <= AT_REST * extent)) return isOn;
      if (isZero(jet, extent)) walk.end = endOf(walk, jet);
      return false;
    });
  }
}

/** Whether f is zero but for rounding. @param {number[]} jet @param {number} extent of the box */
const isZero = (jet, extent) => Math.abs(jet[0]) <= ZERO * largestOf(jet.slice(4)) * extent ** 2;

/** Steps to a cuspidal edge from beside it, and the part of how far off it may be that third derivatives are differences over. */
const [EDGE_STEPS, DIFFERENCE] = [4, 1e-4];

/**
 * The place on a cuspidal edge beside a place. There f″ is of rank 1, and in the plane in which it is zero third derivatives are a cube, c(b·v)³: the sheets end along the edge, at right angles to b.
 * The gradient vanishes with the square of how far off the edge is, f″ with itself: so what is zero is the gradient along the axis of f″, and its trace in the plane.
 * @param {Jets} jets @param {number[]} from @param {Reach} reach
 * @returns {Crossing | null}
 */
function edgeFrom(jets, from, { extent, far }) {
  const h = DIFFERENCE * far;
  let place = from;
  /** @type {Crossing | null} */
  let edge = null;
  for (let k = 0; k < EDGE_STEPS; k++) {
    const jet = jetOf(jets(place), 0);
    const [slope, second] = [jet.slice(1, 4), jet.slice(4)];
    const { axis, trace, largest } = formOf(second);
    const flat = (/** @type {number[]} */ six) => traceOf(six) - dot(axis, times(six, axis));
    const plane = planeOf(axis);
    const beside = jets(plane.flatMap((e) => [h, -h].flatMap((by) => ahead(place, e, by))));
    const [p, m, q, n] = [0, 1, 2, 3].map((i) => flat(jetOf(beside, i).slice(4)));
    const bend = ahead(scaled(plane[0], (p - m) / (2 * h)), plane[1], (q - n) / (2 * h));
    const across = unit(bend);
    const fall = flat(second) / norm(bend);
    place = ahead(ahead(place, axis, -dot(axis, slope) / trace), across, -fall);
    const isOn = isZero(jet, extent) && norm(slope) <= ZERO * largest * extent && Math.abs(fall) <= AT_REST * extent;
    edge = isOn ? { place, along: cross(axis, across), isEdge: true } : null;
  }
  return edge;
}

/**
 * The crossings to which steps lead from some places, none where they lead to none.
 * @param {Jets} jets @param {number[][]} places @param {number} far no step leads farther from where it began
 * @param {number} extent of the box
 * @returns {(Crossing | null)[]} one a place
 */
export function crossingsFrom(jets, places, far, extent) {
  const reach = { extent, far };
  /** @type {(Walk<Crossing> & { isFlat?: boolean })[]} */
  const walks = places.map((from) => walkFrom(from));
  walkOn(
    jets,
    walks,
    reach,
    (walk, jet) => {
      const { isLine, back } = formOf(jet.slice(4));
      walk.isFlat = !isLine;
      return isLine && step(walk, jet, back(jet.slice(1, 4)), reach);
    },
    ({ at }, jet) => {
      const { product, axis } = formOf(jet.slice(4));
      return product < 0 ? { place: at, along: axis } : null;
    },
  );
  return walks.map(({ at, end, isFlat }) => (isFlat ? edgeFrom(jets, at, reach) : end));
}
