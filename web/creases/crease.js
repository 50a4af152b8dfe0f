/** Places on a crease, and ways along it. Knows sides, nothing of paths. */

import { cross, largest, minus, product } from '../vector.js';
import { ahead, apart, inner, sizeBy, solveLinear } from './linear.js';
import { isSame } from './same.js';

/** @typedef {import('../manifold/sides.js').Sides} Sides */
/** @typedef {{ crease: number, signs: number[] }} On a crease, of the surface as it is on the side with these signs, and it, too, as it is written there */
/** @typedef {{ signs: number[], places: number[][] }} Edge a part of a crease between two of its corners, on a side with these signs, and places along it, first and last included */

/** A place is on a crease to this part of how large coordinates are. */
export const ROUNDING = 1e-13;
/** Rounding moves a place on a crease by less than this part of how large coordinates are. */
export const ROUNDED = 1e-15;
/** A root that stands upright on a crease is less than this part high there, for all rounding: twice what first derivatives say. */
const UPRIGHT = 1e-7;
/** So many steps of Newton lead onto a crease. */
const MOST_ROUNDS = 20;
/** Steps along a crease are as long as the next place is off its tangent by between these parts of them; so many lead from one joint to the next. */
const [STRAIGHT, BENT, MOST_STRIDES] = [0.02, 0.1, 1000];
/** A crease is bent by another where its slopes differ by more than this part. */
const SAME = 1e-9;
/** The first step along a crease, in parts of how far away the other joint is. */
const STRIDE = 1 / 16;

/** A surface is torn where its sides are farther apart than this part of how large coordinates are. */
const TORN = 1e-9;

/** On a side that there is no room for. */
const NOWHERE = new Array(4).fill(Number.NaN);

/**
 * Moves a place onto a crease, and on an implicit surface onto this side of it. In the rectangle it is where both sides have derivatives: beyond the crease, by rounding, a root has none.
 * @param {Sides} sides @param {On} on @param {number[]} place
 */
export function settle(sides, on, place) {
  const at = approach(sides, place, (there) => [vanishing(sides, on, there), ...implicit(sides, on, there)]);
  if (at.length > 2) return at;
  const steep = [on.signs, beyond(on.signs, on.crease)].filter((signs) => isSteep(sides, signs, at));
  return steep.length === 1 ? ahead(at, directions(sides, on, at).across, steep[0][on.crease] * ROUNDED * largest(at)) : at;
}

/** Whether a side has no derivatives at a place: a slope is infinite there. @param {Sides} sides @param {number[]} signs @param {number[]} place */
export const isSteep = (sides, signs, place) => sides.on(signs)?.jets(place)[0].every(Number.isFinite) === false;

/**
 * Whether sides are in different places in space, or not where this place is: what leads over a step, or from sheet to sheet, is no path.
 * @param {{ field: import('../search/routes.js').Field, sides: Sides }} question @param {number[][]} all signs of the sides @param {number[]} place @param {number} [size] of coordinates
 */
export function isTorn({ field, sides }, all, place, size = largest(place)) {
  /* E, F and G, and a density, may jump. */
  if (field.domain && !field.positions) return false;
  const jets = all.map((signs) => sides.on(signs)?.jets(place)[0] ?? NOWHERE);
  if (!field.domain) return jets.some(([f, ...derivatives]) => !(Math.abs(f) <= TORN * size * largest(derivatives.slice(0, 3))));
  const [one, other] = jets.map((jet) => jet.slice(0, 3));
  const steep = largest(jets.flatMap((jet) => jet.slice(3, 9)));
  const part = Math.max(TORN, Math.min(UPRIGHT, 4 * ROUNDED * steep));
  return !one.every((x, i) => Math.abs(x - other[i]) <= part * Math.max(size, largest(one)));
}

/** The place on a crease that is so far along the chord between two on it, in parts of that. @param {Sides} sides @param {On} on @param {number[]} from @param {number[]} to @param {number} part */
export function between(sides, on, from, to, part) {
  if (part === 0 || part === 1) return part ? to : from;
  const chord = minus(to, from);
  const aim = ahead(from, chord, part);
  const gradient = chord.map((x, j) => x * sides.scale[j] ** 2);
  return approach(sides, aim, (at) => [
    vanishing(sides, on, at),
    [product(minus(at, aim), gradient), gradient],
    ...implicit(sides, on, at),
  ]);
}

/** Moves a place onto this side of an implicit surface; in the rectangle every place is on it. @param {Sides} sides @param {On} on @param {number[]} place */
export function ground(sides, on, place) {
  return place.length === 2 ? place : approach(sides, place, (at) => implicit(sides, on, at));
}

/** Where a crease meets the edge of the rectangle that a place lies beyond; null: it lies beyond none. @param {Sides} sides @param {On} on @param {import('../manifold/domain.js').Domain} domain @param {number[]} place */
export function meetEdge(sides, on, { lower, upper, periodic }, place) {
  const j = place.findIndex((x, i) => !periodic[i] && !(x >= lower[i] && x <= upper[i]));
  if (j < 0) return null;
  const edge = place[j] < lower[j] ? lower[j] : upper[j];
  const gradient = place.map((_, i) => Number(i === j));
  const met = approach(sides, place, (at) => [vanishing(sides, on, at), [at[j] - edge, gradient]]);
  return met.map((x, i) => (i === j ? edge : x));
}

/** Where creases meet, as they are written on the side with these signs, and on an implicit surface on this side of it. @param {Sides} sides @param {number[]} signs @param {number[]} creases @param {number[]} near */
export const meet = (sides, signs, creases, near) =>
  approach(sides, near, (at) => [
    ...creases.map((crease) => vanishing(sides, { crease, signs }, at)),
    ...implicit(sides, { crease: creases[0], signs }, at),
  ]);

/** @param {Sides} sides @param {number[]} place @param {(at: number[]) => [number, number[]][]} equations at a place: values that are to vanish and their gradients */
function approach({ scale }, place, equations) {
  let at = place;
  for (let round = 0; round < MOST_ROUNDS; round++) {
    const by = along(equations(at), scale);
    at = at.map((x, j) => x - by[j]);
    if (largest(by) <= ROUNDING * largest(at)) break;
  }
  return at;
}

/** What vanishes on a crease, and its gradient. @param {Sides} sides @param {On} on @param {number[]} at @returns {[number, number[]]} */
function vanishing(sides, { crease, signs }, at) {
  const [measured] = (sides.on(signs) ?? sides).measure(at);
  return [measured[crease], slopeOf(sides, measured, crease)];
}

/** @param {Sides} sides @param {On} on @param {number[]} at */
export const slopeAt = (sides, on, at) => vanishing(sides, on, at)[1];

/** The gradient of what vanishes on a crease. @param {Sides} sides @param {number[]} measured there @param {number} crease */
export const slopeOf = (sides, measured, crease) => sides.scale.map((_, j) => measured[sides.count * (1 + j) + crease]);

/** f and ∇f of a side; of a parametric surface nothing. @param {Sides} sides @param {On} on @param {number[]} at @returns {[number, number[]][]} */
function implicit(sides, { signs }, at) {
  if (at.length === 2) return [];
  const [f, x, y, z] = sides.on(signs)?.values(at) ?? NOWHERE;
  return [[f, [x, y, z]]];
}

/** The shortest step that takes away one, two or three values with these gradients. @param {[number, number[]][]} equations @param {readonly number[]} scale */
function along(equations, scale) {
  const gradients = equations.map(([, gradient]) => gradient.map((x, j) => x / scale[j]));
  const weights = solveLinear(
    gradients.map((p) => gradients.map((q) => product(p, q))),
    equations.map(([value]) => value),
  );
  return scale.map((by, j) => (weights ? gradients.reduce((sum, gradient, k) => sum + weights[k] * gradient[j], 0) / by : Number.NaN));
}

/** Along a crease, and across it to where what vanishes there is positive: unit vectors of the coordinates, by their scale. @param {Sides} sides @param {On} on @param {number[]} place @param {number[]} [slope] of what vanishes there */
export function directions(sides, on, place, slope = vanishing(sides, on, place)[1]) {
  const [surface] = implicit(sides, on, place);
  const { scale } = sides;
  const t = unit(surface ? cross(surface[1], slope) : [-slope[1], slope[0]], scale);
  return { along: t, across: unit(surface ? cross(t, surface[1]) : slope.map((x, j) => x / scale[j] ** 2), scale) };
}

/** Places on a crease so far back and so far on along it. @param {Sides} sides @param {On} on @param {number[]} place @param {number} step */
export function bothWays(sides, on, place, step) {
  const { along } = directions(sides, on, place);
  return [-step, step].map((by) => settle(sides, on, ahead(place, along, by)));
}

/** The side beyond a crease. @param {number[]} signs @param {number} crease */
export const beyond = (signs, crease) => signs.map((sign, k) => (k === crease ? -sign : sign));

/** @param {number[]} vector @param {readonly number[]} scale */
function unit(vector, scale) {
  const size = sizeBy(vector, scale);
  return vector.map((x) => x / size);
}

/**
 * Places along a crease from one on it to another, that turn little from each to the next, edge by edge.
 * @param {Sides} sides @param {On} on @param {number[]} from @param {number[]} to @param {number} sense 1: as {@link directions} says; −1: the other way
 * @param {number} [most] how long the way may be
 * @returns {Edge[] | null} null: the other place is not reached
 */
export function walk(sides, on, from, to, sense, most = Infinity) {
  /** @type {Edge[]} */
  const edges = [{ signs: on.signs, places: [from] }];
  const { scale } = sides;
  let stride = STRIDE * apart(to, from, scale);
  let length = 0;
  const reach = (/** @type {number[]} */ at, /** @type {number[]} */ next) => {
    length += apart(next, at, scale);
    edges[edges.length - 1].places.push(next);
  };
  for (let count = 0; count < MOST_STRIDES && stride > 0 && length <= most; count++) {
    const { signs, places } = edges[edges.length - 1];
    const here = { crease: on.crease, signs };
    const at = places[places.length - 1];
    const t = directions(sides, here, at).along.map((x) => sense * x);
    const rest = minus(to, at);
    const onwards = inner(rest, t, scale);
    const isNear = sizeBy(rest, scale) <= 1.5 * stride && onwards > 0;
    const step = isNear ? rest : t.map((x) => stride * x);
    const aim = ahead(at, step, 1);
    const next = isNear ? to : settle(sides, here, aim);
    const passed = corner(sides, here, at, isNear ? settle(sides, here, to) : next);
    const off = sizeBy(isNear ? ahead(rest, t, -onwards) : minus(next, aim), scale);
    if (!passed && !(off <= BENT * sizeBy(step, scale))) {
      stride /= 2;
      continue;
    }
    if (passed?.place) {
      reach(at, passed.place);
      edges.push({ signs: passed.signs, places: [passed.place] });
      continue;
    }
    if (passed) edges[edges.length - 1].signs = passed.signs;
    reach(at, next);
    if (isNear) return length <= most ? edges : null;
    if (off < STRAIGHT * stride) stride *= 1.5;
  }
  return null;
}

/**
 * Whether another crease is crossed between two places on one: where it bends that, or what measures length along it, there is a corner. null: none is.
 * @param {Sides} sides @param {On} on @param {number[]} at @param {number[]} next @returns {{ signs: number[], place: number[] | null } | null} signs: beyond it; place: of the corner
 */
function corner(sides, on, at, next) {
  const side = sides.on(on.signs);
  if (sides.count === 1 || !side) return null;
  const [[before], [after]] = [side.measure(at), side.measure(next)];
  const other = on.signs.findIndex(
    (sign, k) =>
      k !== on.crease && after[k] * sign < 0 && (before[k] - after[k]) * sign > 0 && Math.abs(after[k]) > ROUNDING * Math.abs(before[k]),
  );
  if (other < 0) return null;
  const signs = beyond(on.signs, other);
  const there = sides.on(signs)?.measure(next)[0];
  const [one, two] = [after, there ?? after].map((measured) => slopeOf(sides, measured, on.crease));
  const size = largest(one);
  const isStraight = one.every((x, j) => Math.abs(x - two[j]) <= SAME * size);
  const place = meet(sides, on.signs, [on.crease, other], next);
  return { signs, place: isStraight && isSame(sides, on.signs, signs, place) ? null : place };
}
