/** Singular places of an implicit surface, where ∇f = 0: what second derivatives tell of them, and steps to curves of such places. */

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
    return turned.map((x, j) => x - along * axis[j]);
  };
  return { isLine, axis, back, trace, product, largest };
}

/** Where a step leads to which ∇f vanishes f is f − ½∇f·by, but for so much of what second derivatives make of the step, by those of higher order. */
const HIGHER = 10;

/** Whether f may be zero where steps end. @param {number[]} jet @param {number[]} by the next of them @param {number} largest number of f″ @param {number} size of the box */
export const endsAtZero = (jet, by, largest, size) =>
  Math.abs(jet[0] - dot(by, jet.slice(1)) / 2) <= largest * (HIGHER * dot(by, by) + ZERO * size ** 2);

/** Two directions at right angles in the plane that is normal to an axis. @param {number[]} axis */
export function planeOf(axis) {
  const aside = unit(longest([cross(axis, [1, 0, 0]), cross(axis, [0, 1, 0])]));
  return [aside, cross(axis, aside)];
}

/** Where the gradient vanishes like a power of these orders, steps shrink by the same part, 1 − 1/order, up to this, and in a row, up to that cosine. */
const [ORDERS, ALIKE, STRAIGHT] = [[2, 3, 4], 0.02, 0.99];

/** How many times a step is taken, by the one before it. @param {number[]} by @param {number} size @param {{ by: number[], size: number, order: number }} before */
export function orderOf(by, size, before) {
  const isStraight = before.order === 1 && dot(by, before.by) > STRAIGHT * size * before.size;
  return (isStraight && ORDERS.find((n) => Math.abs(1 - 1 / n - size / before.size) < ALIKE)) || 1;
}

/** Steps to a cuspidal edge from beside it, and the part of how far off it may be that third derivatives are differences over. */
const [EDGE_STEPS, DIFFERENCE] = [4, 1e-4];

/**
 * The places on cuspidal edges beside some places. There f″ is of rank 1, and in the plane in which it is zero third derivatives are a cube, c(b·v)³: the sheets end along the edge, at right angles to b.
 * The gradient vanishes with the square of how far off the edge is, f″ with itself: so what is zero is the gradient along the axis of f″, and its trace in the plane.
 * @param {Jets} jets @param {number[][]} places @param {number} far @param {number} size of the box
 * @returns {(Crossing | null)[]}
 */
function edgesFrom(jets, places, far, size) {
  const h = DIFFERENCE * far;
  /** @type {{ place: number[], along: number[], isOn: boolean }[]} */
  let edges = places.map((place) => ({ place, along: [], isOn: false }));
  for (let k = 0; k < EDGE_STEPS && edges.length > 0; k++) {
    const here = jets(edges.flatMap(({ place }) => place));
    const frames = edges.map((_, i) => {
      const { axis, trace, largest } = formOf(jetOf(here, i).slice(4));
      return { axis, trace, largest, plane: planeOf(axis) };
    });
    const beside = jets(
      edges.flatMap(({ place }, i) => frames[i].plane.flatMap((e) => [1, -1].flatMap((sign) => place.map((x, j) => x + sign * h * e[j])))),
    );
    edges = edges.map(({ place }, i) => {
      const { axis, trace, largest, plane } = frames[i];
      const flat = (/** @type {number[]} */ jet) => traceOf(jet.slice(4)) - dot(axis, times(jet.slice(4), axis));
      const jet = jetOf(here, i);
      const slopes = plane.map((_, j) => (flat(jetOf(beside, 4 * i + 2 * j)) - flat(jetOf(beside, 4 * i + 2 * j + 1))) / (2 * h));
      const bend = plane[0].map((x, j) => slopes[0] * x + slopes[1] * plane[1][j]);
      const cube = norm(bend);
      const across = unit(bend);
      const [rise, fall] = [dot(axis, jet.slice(1, 4)) / trace, flat(jet) / cube];
      const isOn =
        Math.abs(jet[0]) <= ZERO * largest * size ** 2 &&
        norm(jet.slice(1, 4)) <= ZERO * largest * size &&
        Math.abs(fall) <= AT_REST * size;
      return { place: place.map((x, j) => x - rise * axis[j] - fall * across[j]), along: cross(axis, across), isOn };
    });
  }
  return edges.map(({ place, along, isOn }) => (isOn ? { place, along, isEdge: true } : null));
}

/**
 * The crossings to which steps lead from some places, none where they lead to none. All take a step together.
 * @param {(places: ArrayLike<number>) => Float64Array} jets @param {number[][]} places @param {number} far no step leads farther from where it began
 * @param {number} size of the box
 * @returns {(Crossing | null)[]} one a place
 */
export function crossingsFrom(jets, places, far, size) {
  const walks = places.map((from) => ({
    from,
    at: from,
    by: /** @type {number[]} */ ([]),
    size: Infinity,
    order: 0,
    isFlat: false,
    crossing: /** @type {Crossing | null} */ (null),
  }));
  let walking = walks;
  for (let k = 0; k < STEPS && walking.length > 0; k++) {
    const seen = jets(walking.flatMap(({ at }) => at));
    walking = walking.filter((walk, i) => {
      const jet = jetOf(seen, i);
      const { isLine, axis, back, product, largest } = formOf(jet.slice(4));
      walk.isFlat = !isLine;
      if (walk.isFlat) return false;
      const by = back(jet.slice(1, 4));
      const step = norm(by);
      const order = orderOf(by, step, walk);
      walk.at = walk.at.map((x, j) => x - order * by[j]);
      const isAtRest = step <= AT_REST * size;
      if (isAtRest && product < 0 && Math.abs(jet[0]) <= ZERO * largest * size ** 2) walk.crossing = { place: walk.at, along: axis };
      /* To a crossing steps shrink; by far most walks lead to none, and end here. */
      const isOn = !isAtRest && endsAtZero(jet, by, largest, size) && step <= SHRINKING * walk.size && gap(walk.at, walk.from) <= far;
      walk.by = by;
      walk.size = step;
      walk.order = order;
      return isOn;
    });
  }
  const flat = walks.filter(({ isFlat }) => isFlat);
  for (const [i, edge] of edgesFrom(
    jets,
    flat.map(({ at }) => at),
    far,
    size,
  ).entries())
    flat[i].crossing = edge;
  return walks.map(({ crossing }) => crossing);
}
