/** Places on a crease, and ways along it. Knows sides, nothing of paths. */

import { cross } from './vector.js';

/** @typedef {import('./sides.js').Sides} Sides */
/** @typedef {{ crease: number, signs: number[] }} On a crease, of the surface as it is on the side with these signs */

/** A place is on a crease to this part of how large coordinates are. */
export const ROUNDING = 1e-13;
/** So many steps of Newton lead onto a crease. */
const MOST_ROUNDS = 20;
/** Steps along a crease are as long as the next place is off its tangent by between these parts of them; so many lead from one joint to the next. */
const [STRAIGHT, BENT, MOST_STRIDES] = [0.02, 0.1, 1000];
/** The first step along a crease, in parts of how far away the other joint is. */
const STRIDE = 1 / 16;

/** Moves a place onto a crease, and on an implicit surface onto this side of it. @param {Sides} sides @param {On} on @param {number[]} place */
export function settle(sides, on, place) {
  return approach(place, (at) => [vanishing(sides, on, at), ...implicit(sides, on, at)]);
}

/** Moves a place onto this side of an implicit surface; in the rectangle every place is on it. @param {Sides} sides @param {On} on @param {number[]} place */
export function ground(sides, on, place) {
  return place.length === 2 ? place : approach(place, (at) => implicit(sides, on, at));
}

/** @param {number[]} place @param {(at: number[]) => [number, number[]][]} equations at a place: values that are to vanish, one or two, and their gradients */
function approach(place, equations) {
  let at = place;
  for (let round = 0; round < MOST_ROUNDS; round++) {
    const by = along(equations(at));
    at = at.map((x, j) => x - by[j]);
    if (Math.max(...by.map(Math.abs)) <= ROUNDING * Math.max(...at.map(Math.abs))) break;
  }
  return at;
}

/** What vanishes on a crease, and its gradient. @param {Sides} sides @param {On} on @param {number[]} at @returns {[number, number[]]} */
function vanishing(sides, { crease }, at) {
  const [measured] = sides.measure(at);
  return [measured[crease], at.map((_, j) => measured[sides.count * (1 + j) + crease])];
}

/** f and ∇f of a side; of a parametric surface nothing. @param {Sides} sides @param {On} on @param {number[]} at @returns {[number, number[]][]} */
function implicit(sides, { signs }, at) {
  if (at.length === 2) return [];
  const [[f, x, y, z]] = /** @type {import('./sides.js').Side} */ (sides.on(signs)).jets(at);
  return [[f, [x, y, z]]];
}

/** The shortest step that takes away one or two values with these gradients. @param {[number, number[]][]} equations */
function along([[g, a], second]) {
  const times = (/** @type {number[]} */ p, /** @type {number[]} */ q) => p.reduce((sum, x, j) => sum + x * q[j], 0);
  if (!second) return a.map((x) => (x * g) / times(a, a));
  const [f, b] = second;
  const [aa, ab, bb] = [times(a, a), times(a, b), times(b, b)];
  const determinant = aa * bb - ab * ab;
  const [s, t] = [(g * bb - f * ab) / determinant, (f * aa - g * ab) / determinant];
  return a.map((x, j) => s * x + t * b[j]);
}

/** Along a crease, and across it to where what vanishes there is positive: unit vectors of the coordinates. @param {Sides} sides @param {On} on @param {number[]} place */
export function directions(sides, on, place) {
  const [, g] = vanishing(sides, on, place);
  const [surface] = implicit(sides, on, place);
  const t = unit(surface ? cross(surface[1], g) : [-g[1], g[0]]);
  return { along: t, across: unit(surface ? cross(t, surface[1]) : g) };
}

/** @param {number[]} vector */
function unit(vector) {
  const size = Math.sqrt(vector.reduce((sum, x) => sum + x * x, 0));
  return vector.map((x) => x / size);
}

/**
 * Places along a crease from one on it to another, both included, that turn little from each to the next.
 * @param {Sides} sides @param {On} on @param {number[]} from @param {number[]} to @param {number} sense 1: as {@link directions} says; −1: the other way
 * @returns {number[][] | null} null: the other place is not reached
 */
export function walk(sides, on, from, to, sense) {
  const minus = (/** @type {number[]} */ a, /** @type {number[]} */ b) => a.map((x, j) => x - b[j]);
  const size = (/** @type {number[]} */ a) => Math.sqrt(a.reduce((sum, x) => sum + x * x, 0));
  const places = [from];
  let stride = STRIDE * size(minus(to, from));
  for (let count = 0; count < MOST_STRIDES && stride > 0; count++) {
    const at = places[places.length - 1];
    const t = directions(sides, on, at).along.map((x) => sense * x);
    const rest = minus(to, at);
    const ahead = rest.reduce((sum, x, j) => sum + x * t[j], 0);
    const isNear = size(rest) <= 1.5 * stride && ahead > 0;
    const step = isNear ? rest : t.map((x) => stride * x);
    const next = isNear
      ? to
      : settle(
          sides,
          on,
          at.map((x, j) => x + step[j]),
        );
    const off = size(
      isNear
        ? minus(
            rest,
            t.map((x) => ahead * x),
          )
        : minus(
            next,
            at.map((x, j) => x + step[j]),
          ),
    );
    if (!(off <= BENT * size(step))) {
      stride /= 2;
      continue;
    }
    places.push(next);
    if (isNear) return places;
    if (off < STRAIGHT * stride) stride *= 1.5;
  }
  return null;
}
