/**
 * Branch points of a parametric surface: places within its rectangle where S_u = S_v = 0, and around which the surface goes more than once, as those of Catalan's and
 * Henneberg's surfaces. MATH.md, "Branch points".
 */

import { copies } from '../manifold/lifts.js';
import { vector } from '../manifold/rectangle.js';
import { angleAlong } from '../manifold/tips.js';
import { cross, dot, minus } from '../vector.js';

/** @typedef {import('../manifold/domain.js').Domain} Domain */
/** @typedef {(places: ArrayLike<number>) => Float64Array} Evaluate */
/** @typedef {{ at: number[], point: Float64Array }} Branch u v, and x y z */

/** Points a direction of the rectangle from which they are looked for; so many Newton steps, until one is of this part of the range. Of more branch points none is taken. */
const [GRID, STEPS, SETTLED, MOST] = [16, 60, 1e-12, 32];
/** A step to one leaves no more than this part of the squares of speeds, to first order. */
const LEFT = 0.25;
/** Two of them nearer than this part of the range are one. */
const SAME = 1e-6;
/** Around one, at this part of the range, the surface is regular: |S_u × S_v|² is nowhere less than this part of (|S_u|² + |S_v|²)². */
const [AROUND, REGULAR] = [1e-3, 1e-6];
/** At it squares of speeds are this part of those around it. */
const STILL = 1e-10;
/** The angle of a path is computed where it is so many squares of a step away, and around the point along so many chords. */
const [RADII, CHORDS] = [6, 64];

/** Where |x| + |y| = 1, by a number of 0 … 4 that grows with the angle. @param {number} turn */
function cornerAt(turn) {
  const x = Math.abs((turn % 4) - 2) - 1;
  return [x, (turn % 4 < 2 ? 1 : -1) * (1 - Math.abs(x))];
}

/** That number, of a direction. @param {number} x @param {number} y */
function turnOf(x, y) {
  const part = x / (Math.abs(x) + Math.abs(y));
  return y >= 0 ? 1 - part : 3 + part;
}

/**
 * Whether a place is one: singular alone, and regular all around. @param {Domain} domain @param {Evaluate} jets @param {number[]} at
 */
function isBranch({ lower, upper }, jets, at) {
  const span = minus(upper, lower);
  const ring = Array.from({ length: 16 }, (_, i) => cornerAt(i / 4).map((x, j) => at[j] + AROUND * x * span[j]));
  const sampled = jets([...ring, at].flat());
  const seen = Array.from({ length: 17 }, (_, i) => {
    const [a, b] = [3, 6].map((offset, j) => vector(sampled, i, offset).map((x) => x * span[j]));
    return { squared: dot(a, a) + dot(b, b), normal: cross(a, b) };
  });
  return seen.slice(0, 16).every(({ squared, normal }, i) => {
    const next = seen[(i + 1) % 16].normal;
    return seen[16].squared <= STILL * squared && dot(normal, normal) > REGULAR * squared ** 2 && dot(normal, next) > 0;
  });
}

/**
 * The Gauss–Newton step to where S_u and S_v vanish, in parts of the range; infinite where they do not, by far, as it promises.
 * @param {Float64Array} jets @param {number} i @param {number[]} span
 */
function stepFrom(jets, i, [du, dv]) {
  let [a, b, c, p, q, squared] = [0, 0, 0, 0, 0, 0];
  for (let k = 18 * i + 3; k < 18 * i + 6; k++) {
    const [u, v, uu, uv, vv] = [jets[k] * du, jets[k + 3] * dv, jets[k + 6] * du * du, jets[k + 9] * du * dv, jets[k + 12] * dv * dv];
    a += uu * uu + uv * uv;
    b += uu * uv + uv * vv;
    c += uv * uv + vv * vv;
    p += u * uu + v * uv;
    q += u * uv + v * vv;
    squared += u * u + v * v;
  }
  const determinant = a * c - b * b;
  const step = [(b * q - c * p) / determinant, (b * p - a * q) / determinant];
  return squared + p * step[0] + q * step[1] <= LEFT * squared ? step : [Infinity, Infinity];
}

/**
 * Those within a rectangle; none where there are too many.
 * @param {Evaluate} jets @param {Domain} domain @returns {Branch[]}
 */
export function findBranches(jets, domain) {
  const { lower, upper, periodic } = domain;
  const span = minus(upper, lower);
  const cell = 1.5 / GRID;
  const far = (/** @type {number[]} */ [x, y]) => Math.max(Math.abs(x), Math.abs(y));
  /** @type {number[][]} */
  const found = [];
  const place = (/** @type {number} */ i, /** @type {number} */ j) => lower[j] + ((i + 0.5) / GRID) * span[j];
  const starts = new Float64Array(2 * GRID ** 2).map((_, k) => place(k & 1 ? Math.floor(k / (2 * GRID)) : (k >> 1) % GRID, k & 1));
  const sampled = jets(starts);
  for (let k = 0; k < GRID ** 2; k++) {
    let step = stepFrom(sampled, k, span);
    if (!(far(step) < cell)) continue;
    const start = [starts[2 * k], starts[2 * k + 1]];
    const moved = [0, 0];
    for (let i = 0; i < STEPS && far(step) > SETTLED && far(step) < cell && far(moved) < cell; i++) {
      for (const j of [0, 1]) moved[j] += step[j];
      step = stepFrom(jets(start.map((x, j) => x + moved[j] * span[j])), 0, span);
    }
    const at = start.map((x, j) => x + moved[j] * span[j]);
    const isWithin = at.every((x, j) => periodic[j] || Math.min(x - lower[j], upper[j] - x) > AROUND * span[j]);
    const isHere = (/** @type {number[]} */ other) =>
      other.every((x, j) => {
        const apart = (x - at[j]) / span[j];
        return Math.abs(periodic[j] ? apart - Math.round(apart) : apart) < SAME;
      });
    const isKnown = found.some((other) => copies(domain, other).some(isHere));
    if (far(step) < SAME && far(moved) < cell && isWithin && !isKnown && isBranch(domain, jets, at)) found.push(at);
  }
  return found.length > MOST ? [] : found.map((at) => ({ at, point: jets(at).slice(0, 3) }));
}

/** What some numbers at these places tend to at 0. @param {number[]} places @param {number[]} numbers */
function extrapolate(places, numbers) {
  const row = [...numbers];
  for (let k = 1; k < row.length; k++)
    for (let i = 0; i + k < row.length; i++) row[i] = (places[i + k] * row[i] - places[i] * row[i + 1]) / (places[i + k] - places[i]);
  return row[0];
}

/**
 * The smaller of the angles on both sides of a path through a branch point: below π it has a corner there. Each is that around the point from one leg to the other,
 * as it tends to be near by.
 * @param {Domain} domain @param {Evaluate} positions x y z @param {Branch} branch
 * @param {Float64Array[]} legs u v of both parts of the path, from the branch point on, in steps of equal lengths, so short that the squares of the first are short, too
 */
export function angleThrough({ lower, upper }, positions, { point }, legs) {
  const span = minus(upper, lower);
  const [a, b] = legs.map((numbers) =>
    Array.from({ length: RADII }, (_, i) => [0, 1].map((j) => (numbers[2 * (i + 1) ** 2 + j] - numbers[j]) / span[j])),
  );
  const at = [legs[0][0], legs[0][1]];
  const size = (/** @type {number[]} */ [x, y]) => Math.abs(x) + Math.abs(y);
  const radii = a.map((p, i) => size(p) + size(b[i]));
  const angle = (/** @type {number[]} */ from, /** @type {number[]} */ to) => {
    const turns = [turnOf(from[0], from[1]), turnOf(to[0], to[1])];
    if (turns[1] < turns[0]) turns[1] += 4;
    const places = Array.from({ length: CHORDS + 1 }, (_, i) => {
      const part = i / CHORDS;
      const corner = cornerAt((1 - part) * turns[0] + part * turns[1]);
      return corner.map((x, j) => at[j] + x * ((1 - part) * size(from) + part * size(to)) * span[j]);
    });
    const points = positions(places.flat());
    return angleAlong(places.map((_, i) => points.subarray(3 * i, 3 * i + 3).map((x, j) => x - point[j])));
  };
  const tendsTo = (/** @type {number[][]} */ from, /** @type {number[][]} */ to) =>
    extrapolate(
      radii,
      from.map((p, i) => angle(p, to[i])),
    );
  return Math.min(tendsTo(a, b), tendsTo(b, a));
}
