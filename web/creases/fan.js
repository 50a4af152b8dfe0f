/** What lies around a corner: sectors of its sides, one after the other, and how far they turn. Angles are kept as tangents and unit vectors: no function of an engine is called. */

import { cross, dot } from '../vector.js';
import { slopeOf } from './crease.js';
import { product } from './linear.js';

/** @typedef {import('../manifold/sides.js').Sides} Sides */
/** @typedef {{ place: number[], creases: number[] }} Corner creases: that meet there */
/** @typedef {{ e1: number[], e2: number[], times: (a: number[], b: number[]) => number }} Plane tangent to a side: unit vectors at right angles, and the product that measures it */
/** @typedef {{ plane: Plane, half: number }} Sector of a side at a corner, from the plane's e1 on, counter-clockwise; half: the tangent of half its angle */

/** Directions agree to this part. */
export const ALIKE = 1e-7;
/** No more sectors meet at a corner. */
const MOST_SECTORS = 64;

/** How far a turn is: half turns, and the rest as a unit vector. @typedef {{ halves: number, x: number, y: number }} Turn */

/** Whether it is a half turn or more, but for rounding. @param {Turn} turn */
export const isHalf = ({ halves, x, y }) => halves > 0 || (x < 0 && y <= ALIKE);

/** Whether it is surely more than so many half turns. @param {Turn} turn @param {number} halves */
export const isBeyond = (turn, halves) => turn.halves > halves || (turn.halves === halves && (turn.y > ALIKE || turn.x < 0));

/** A turn and an angle up to half a one more, of which half has this tangent. @param {Turn} turn @param {number} half @returns {Turn} */
function add({ halves, x, y }, half) {
  const { x: cosine, y: sine } = cosineAndSine(half);
  const next = { halves, x: x * cosine - y * sine, y: x * sine + y * cosine };
  return next.y < 0 ? { halves: halves + 1, x: -next.x, y: -next.y } : next;
}

/**
 * How far it is counter-clockwise around a corner from one direction to another, or all around to the same, and the creases between.
 * @param {Sides} sides @param {Corner} corner @param {number[]} signs of the side of the first @param {number[]} from @param {number[]} to @returns {{ turn: Turn, rays: number[][] } | null}
 */
export function turnBetween(sides, corner, signs, from, to) {
  /** @type {Turn} */
  let turn = { halves: 0, x: 1, y: 0 };
  const rays = [];
  for (const { plane, half } of sectors(sides, corner, signs, from)) {
    const rest = from !== to || isBeyond(turn, 0) ? halfAngle(plane, to) : null;
    if (rest !== null && rest <= half * (1 + ALIKE) + ALIKE) return { turn: add(turn, rest), rays };
    turn = add(turn, half);
    /* A direction that follows a crease has not passed it. */
    if (isBeyond(turn, 0)) rays.push(rayAt(plane, half));
  }
  return null;
}

/** The direction in a plane whose half angle from its first vector has this tangent. @param {Plane} plane @param {number} half */
function rayAt({ e1, e2 }, half) {
  const { x, y } = cosineAndSine(half);
  return e1.map((e, j) => x * e + y * e2[j]);
}

/** Of twice the angle with this tangent. @param {number} half */
const cosineAndSine = (half) =>
  half < Infinity ? { x: (1 - half * half) / (1 + half * half), y: (2 * half) / (1 + half * half) } : { x: -1, y: 0 };

/** The tangent of half the angle from a plane's first vector to a direction in it; null: it is not, or more than half a turn away. @param {Plane} plane @param {number[]} direction */
function halfAngle({ e1, e2, times }, direction) {
  const [x, y, size] = [times(e1, direction), times(e2, direction), Math.sqrt(times(direction, direction))];
  if (!(Math.abs(Math.sqrt(x * x + y * y) - size) <= ALIKE * size) || y < -ALIKE * size) return null;
  return Math.abs(y) <= ALIKE * size ? (x > 0 ? 0 : Infinity) : (size - x) / y;
}

/** The sectors of all sides around a corner, counter-clockwise, from a direction on. @param {Sides} sides @param {Corner} corner @param {number[]} signs of its side @param {number[]} direction @returns {Generator<Sector, void>} */
function* sectors(sides, { place, creases }, signs, direction) {
  for (let count = 0; count < MOST_SECTORS; count++) {
    const side = sides.on(signs);
    const plane = side && planeAt(side, place, direction);
    if (!plane) return;
    const [measured] = side.measure(place);
    const { e1, e2 } = plane;
    const slopes = creases.map((k) => slopeOf(sides, measured, k, place.length).map((x) => signs[k] * x));
    const steepest = Math.max(...slopes.flat().map(Math.abs));
    const halves = slopes.map((slope) => {
      const [along, up] = [e1, e2].map((e) => product(slope, e));
      const steep = Math.sqrt(along * along + up * up);
      /* What vanishes all over a side is no crease of it. */
      if (!(steep > ALIKE * steepest)) return Infinity;
      if (Math.abs(along) <= ALIKE * steep) return up < 0 ? 0 : Infinity;
      return along < 0 ? Number.NaN : (steep + up) / along;
    });
    const half = Math.min(...halves);
    if (!(half >= 0)) return;
    yield { plane, half };
    direction = rayAt(plane, half);
    const crossed = creases.filter((_, i) => halves[i] === half || halves[i] - half <= ALIKE * (1 + half));
    signs = signs.map((sign, k) => (crossed.includes(k) ? -sign : sign));
  }
}

/** The tangent plane of a side at a place, turned to a direction; null: it has none. @param {import('../manifold/sides.js').Side} side @param {number[]} place @param {number[]} direction @returns {Plane | null} */
function planeAt(side, place, direction) {
  const [jet] = side.jets(place);
  if (place.length === 3) {
    const normal = scaled(jet.slice(1, 4), dot);
    const e1 = scaled(cross(cross(normal, direction), normal), dot);
    const e2 = cross(normal, e1);
    return [...e1, ...e2].every(Number.isFinite) ? { e1, e2, times: dot } : null;
  }
  const [u, v] = [jet.slice(3, 6), jet.slice(6, 9)];
  const [e, f, g] = [dot(u, u), dot(u, v), dot(v, v)];
  const times = (/** @type {number[]} */ a, /** @type {number[]} */ b) =>
    e * a[0] * b[0] + f * (a[0] * b[1] + a[1] * b[0]) + g * a[1] * b[1];
  const e1 = scaled(direction, times);
  const e2 = scaled([-(f * e1[0] + g * e1[1]), e * e1[0] + f * e1[1]], times);
  return [...e1, ...e2].every(Number.isFinite) ? { e1, e2, times } : null;
}

/** @param {number[]} vector @param {(a: number[], b: number[]) => number} times */
function scaled(vector, times) {
  const size = Math.sqrt(times(vector, vector));
  return vector.map((x) => x / size);
}
