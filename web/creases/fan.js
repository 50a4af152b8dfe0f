/** What lies around a corner: sectors of its sides, one after the other, how far they turn, and whether ways through them are longer than through the corner. Angles are kept as tangents and unit vectors: no function of an engine is called. */

import { cross, largest, product } from '../vector.js';
import { slopeOf } from './crease.js';

/** @typedef {import('../manifold/sides.js').Sides} Sides */
/** @typedef {{ place: number[], creases: number[] }} Corner creases: that meet there */
/** @typedef {{ e1: number[], e2: number[], times: (a: number[], b: number[]) => number }} Plane tangent to a side: unit vectors at right angles, and the product that measures it */
/** @typedef {{ plane: Plane, half: number, onto: number, signs: number[] }} Sector of a side at a corner, from the plane's e1 on, counter-clockwise; half: the tangent of half its angle; onto: how long the ray that it begins with is on it, where it is 1 on the sector before */

/** Directions agree to this part. */
export const ALIKE = 1e-7;
/** No more sectors meet at a corner. */
const MOST_SECTORS = 64;

/** How far a turn is: half turns, and the rest as a unit vector. @typedef {{ halves: number, x: number, y: number }} Turn */

/** Whether it is surely more than so many half turns. @param {Turn} turn @param {number} halves */
export const isBeyond = (turn, halves) => turn.halves > halves || (turn.halves === halves && (turn.y > ALIKE || turn.x < 0));

/** A turn and an angle up to half a one more, of which half has this tangent. @param {Turn} turn @param {number} half @returns {Turn} */
function add({ halves, x, y }, half) {
  const { x: cosine, y: sine } = cosineAndSine(half);
  const next = { halves, x: x * cosine - y * sine, y: x * sine + y * cosine };
  return next.y < 0 ? { halves: halves + 1, x: -next.x, y: -next.y } : next;
}

/**
 * How far it is counter-clockwise around a corner from one direction to another, or all around to the same, the creases between, and whether ways past it on that side are longer.
 * @param {Sides} sides @param {Corner} corner @param {number[]} signs of the side of the first @param {number[]} from
 * @param {number[]} [toward] the other, as far as it is tangent to its side @param {number[]} [own] signs of that, which tell where it follows a crease
 * @returns {{ turn: Turn, rays: number[][], isHeld: boolean } | null}
 */
export function turnBetween(sides, corner, signs, from, toward = from, own = signs) {
  const side = sides.on(own);
  const to = side && planeAt(side, corner.place, toward)?.e1;
  if (!to) return null;
  /** @type {Turn} */
  let turn = { halves: 0, x: 1, y: 0 };
  const rays = [];
  /** @type {{ half: number, onto: number }[]} */
  const fan = [];
  for (const { plane, half, onto, signs: here } of sectors(sides, corner, signs, from)) {
    const rest = from !== toward || isBeyond(turn, 0) ? halfAngle(plane, to) : null;
    const isLast = rest !== null && rest <= half * (1 + ALIKE) + ALIKE;
    const isBeside = isLast && rest >= half * (1 - ALIKE) && corner.creases.some((k) => own[k] !== here[k]);
    if (isLast && !isBeside) return { turn: add(turn, rest), rays, isHeld: isLonger([...fan, { half: rest, onto }]) };
    turn = add(turn, half);
    fan.push({ half, onto });
    /* A direction that follows a crease has not passed it. */
    if (isBeyond(turn, 0)) rays.push(rayAt(plane, half));
  }
  return null;
}

/**
 * Whether ways from one direction to another that cross the rays between sectors at short distances s, of any ratio, are longer than the one through the corner: to first order that is longer by
 * −cos θ_0 s_1 + Σ |s_k r_k − s_k+1 r_k+1| − cos θ_m s_m, each as its sector measures it. From the last ray on, the least of that is a multiple w of s: cos(θ − φ) for w = cos φ.
 * @param {{ half: number, onto: number }[]} fan the first from one direction on, the last up to the other
 */
function isLonger(fan) {
  const [{ x: first }, ...others] = fan.map(({ half }) => cosineAndSine(half));
  /* Half a turn, but for ALIKE of it. */
  if (others.length === 0) return first <= -1 + ALIKE * ALIKE;
  let w = 1;
  for (let k = others.length - 1; k >= 0; k--) {
    const { x, y } = others[k];
    if (w < -1 - ALIKE) return false;
    const sine = Math.sqrt(Math.max(0, 1 - w * w));
    const least = w < 1 && x * sine >= w * y ? w * x + sine * y : 1;
    w = fan[k + 1].onto * (k === others.length - 1 ? -x : least);
  }
  return w - first >= -ALIKE;
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
    const slopes = creases.map((k) => slopeOf(sides, measured, k).map((x) => signs[k] * x));
    const steepest = largest(slopes.flat());
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
    yield { plane, half, onto: Math.sqrt(plane.times(direction, direction)), signs };
    direction = rayAt(plane, half);
    const crossed = creases.filter((_, i) => halves[i] === half || halves[i] - half <= ALIKE * (1 + half));
    signs = signs.map((sign, k) => (crossed.includes(k) ? -sign : sign));
  }
}

/** The tangent plane of a side at a place, turned to a direction; null: it has none. @param {import('../manifold/sides.js').Side} side @param {number[]} place @param {number[]} direction @returns {Plane | null} */
function planeAt(side, place, direction) {
  const [jet] = side.jets(place);
  const times = side.productOf(jet);
  const normal = jet.slice(1, 4);
  const first = place.length === 3 ? cross(cross(normal, direction), normal) : direction;
  const e1 = scaled(first, times);
  const aside = place.length === 3 ? cross(normal, e1) : [-e1[1], e1[0]];
  const along = times(e1, aside);
  const e2 = scaled(
    aside.map((x, j) => x - along * e1[j]),
    times,
  );
  return [...e1, ...e2].every(Number.isFinite) ? { e1, e2, times } : null;
}

/** @param {number[]} vector @param {(a: number[], b: number[]) => number} times */
function scaled(vector, times) {
  const size = Math.sqrt(times(vector, vector));
  return vector.map((x) => x / size);
}
