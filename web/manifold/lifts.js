/** Points of a glued rectangle, moved to other places that are the same point of the surface: by whole periods, and by turns after which it is turned over. */

import { product } from '../vector.js';

/** @typedef {import('./seams.js').Glued} Glued */

/**
 * The same point of the surface, so many turns on.
 * @param {Glued} glued @param {number[]} point @param {number} turns of the direction in which the surface turns over; 0 if there is none
 */
export function turnOn({ lower, upper, periodic, turn }, point, turns) {
  if (!turn || turns === 0) return point;
  const { direction, span, sign, offset } = turn;
  const other = 1 - direction;
  const mirror = (/** @type {number} */ x) => {
    if (periodic[other]) return offset - x;
    /* The walls' own numbers, whatever is rounded. */
    const [low, high] = [lower[other], upper[other]];
    return x === low ? high : x === high ? low : Math.min(Math.max(offset - x, low), high);
  };
  return point.map((x, j) => {
    if (j === direction) return x + turns * span;
    return sign > 0 ? x - turns * offset : turns % 2 === 0 ? x : mirror(x);
  });
}

/** All places of the rectangle that are this point of the surface; itself first. @param {Glued | null} glued @param {number[]} point */
export function copies(glued, point) {
  if (!glued?.turn) return [point];
  return Array.from({ length: glued.turn.folds }, (_, turns) => turnOn(glued, point, turns));
}

/**
 * The lift of a point nearest to another: moved by whole periods, and no turn.
 * @param {Glued} glued @param {number[]} point @param {number[]} near
 */
export function liftNear({ lower, upper, periodic }, point, near) {
  return point.map((x, j) => {
    const period = upper[j] - lower[j];
    return periodic[j] ? x - period * Math.round((x - near[j]) / period) : x;
  });
}

/** The turns by which a point comes nearest to another. @param {Glued} glued @param {ArrayLike<number>} point @param {ArrayLike<number>} near */
const turnsTo = ({ turn }, point, near) => (turn ? Math.round((near[turn.direction] - point[turn.direction]) / turn.span) : 0);

/** The lift nearest to another point, among all turns. @param {Glued} glued @param {number[]} point @param {number[]} near */
function turnNear(glued, point, near) {
  return liftNear(glued, turnOn(glued, point, turnsTo(glued, point, near)), near);
}

/**
 * The ends on the lifts where they are solved: near each other, or near the given start; the lexicographically smaller one stays, so that
 * exchanging the ends gives the same problem.
 * @param {Glued} glued @param {number[]} from @param {number[]} to @param {Float64Array | null} start u v of its points
 */
export function liftEnds(glued, from, to, start) {
  if (start) return [turnNear(glued, from, [start[0], start[1]]), turnNear(glued, to, Array.from(start.subarray(-2)))];
  const swap = from[0] !== to[0] ? from[0] > to[0] : from[1] > to[1];
  return swap ? [turnNear(glued, from, to), to] : [from, turnNear(glued, to, from)];
}

/** The product of two directions of the rectangle. @param {ArrayLike<number>} form e, f, g @param {number[]} a @param {number[]} b */
export const productBy = (form, a, b) => product([a[0] * b[0], a[0] * b[1] + a[1] * b[0], a[1] * b[1]], form);

/**
 * Whole periods, two where both directions have them, of which all others are made; as short as possible (Lagrange, Gauss), so that the shortest straight
 * line to any lift leads to one beside the nearest.
 * @param {Glued} glued @param {number[]} form
 */
function latticeOf({ lower, upper, periodic, turn }, form) {
  const lattice = [0, 1].map((j) => [0, 1].map((i) => (i === j ? upper[j] - lower[j] : 0)));
  if (turn || !periodic[0] || !periodic[1]) return lattice;
  for (;;) {
    const [a, b] = lattice;
    const large = productBy(form, a, a) <= productBy(form, b, b) ? 1 : 0;
    const short = lattice[1 - large];
    const before = productBy(form, lattice[large], lattice[large]);
    const times = Math.round(productBy(form, a, b) / productBy(form, short, short));
    const reduced = lattice[large].map((x, i) => x - times * short[i]);
    if (!(productBy(form, reduced, reduced) < before)) return lattice;
    lattice[large] = reduced;
  }
}

/**
 * By how many vectors of the lattice a lift is farther from the nearest one than by periods alone; 0 where the surface is not sheared.
 * @param {Glued} glued @param {number[]} form @param {number[][]} lattice @param {number[]} away what leads to the lift
 */
function shearOf({ periodic, turn }, form, [a, b], away) {
  const whole = (/** @type {number} */ x) => (Number.isFinite(x) ? Math.round(x) : 0);
  const isTorus = periodic[0] && periodic[1];
  if (turn || (isTorus && a[1] === 0 && b[0] === 0)) return [0, 0];
  const area = a[0] * b[1] - a[1] * b[0];
  if (isTorus) return [away[0] * b[1] - away[1] * b[0], a[0] * away[1] - a[1] * away[0]].map((x) => whole(x / area));
  /* What the way between the walls leads along the period. */
  return [a, b].map((period, j) => {
    const across = away.map((x, i) => (i === j ? 0 : x));
    return periodic[j] ? whole(productBy(form, period, across) / productBy(form, period, period)) : 0;
  });
}

/**
 * A point on its lift nearest to another, and on the neighbouring ones, as a form measures them.
 * @param {Glued} glued @param {number[]} point @param {number[]} near @param {number[]} [form] e, f, g: of the surface, on an average
 * @returns {number[][]}
 */
export function neighbours(glued, point, near, form = [1, 0, 1]) {
  const { periodic, turn } = glued;
  const lattice = latticeOf(glued, form);
  const nearest = turnNear(glued, point, near);
  const shear = shearOf(
    glued,
    form,
    lattice,
    nearest.map((x, j) => x - near[j]),
  );
  let lifts = [nearest.map((x, i) => x - shear[0] * lattice[0][i] - shear[1] * lattice[1][i])];
  for (const j of [0, 1]) {
    if (!periodic[j]) continue;
    const step = (/** @type {number[]} */ lift, /** @type {number} */ by) => {
      if (j !== turn?.direction) return lift.map((x, i) => x + by * lattice[j][i]);
      const turned = turnOn(glued, lift, by);
      const beside = [...near];
      beside[j] = turned[j];
      return liftNear(glued, turned, beside);
    };
    lifts = lifts.flatMap((lift) => [lift, step(lift, -1), step(lift, 1)]);
  }
  return lifts;
}

/** Moves u v pairs by turns, and then by this. @param {Glued} glued @param {Float64Array} parameters @param {number} turns @param {number[]} by */
function move(glued, parameters, turns, by) {
  if (turns === 0 && by[0] === 0 && by[1] === 0) return;
  for (let i = 0; i < parameters.length; i += 2) {
    const place = turnOn(glued, [parameters[i], parameters[i + 1]], turns);
    for (const j of [0, 1]) parameters[i + j] = place[j] + by[j];
  }
}

/** Moves u v pairs so that the first of them is exactly this, the same point of the surface. @param {Glued} glued @param {Float64Array} parameters @param {number[]} to u v */
export function moveOnto(glued, parameters, to) {
  const turns = turnsTo(glued, parameters, to);
  const first = turnOn(glued, [parameters[0], parameters[1]], turns);
  move(
    glued,
    parameters,
    turns,
    [0, 1].map((j) => (glued.periodic[j] ? to[j] - first[j] : 0)),
  );
  [parameters[0], parameters[1]] = to;
}

/** Moves u v pairs so that the first of them comes to lie next to a place. @param {Glued} glued @param {Float64Array} parameters @param {ArrayLike<number>} near u v */
export function moveNear(glued, parameters, near) {
  const turns = turnsTo(glued, parameters, near);
  const first = turnOn(glued, [parameters[0], parameters[1]], turns);
  const lifted = liftNear(glued, first, [near[0], near[1]]);
  move(
    glued,
    parameters,
    turns,
    [0, 1].map((j) => lifted[j] - first[j]),
  );
}

/**
 * A start from a line between points near two ends: moved to the lift of the first one, and slid along so that it joins them.
 * @param {{ domain: Glued | null, from: number[], to: number[] }} ends @param {Float64Array} line is overwritten
 * @returns {{ to: number[], start: Float64Array }} to: the lift of the second end
 */
export function slide({ domain, from, to }, line) {
  const width = from.length;
  if (domain) moveNear(domain, line, from);
  const last = line.length - width;
  const end = domain ? turnNear(domain, to, Array.from(line.subarray(last))) : to;
  const by = [from.map((x, j) => x - line[j]), end.map((x, j) => x - line[last + j])];
  for (let i = 0; i < line.length; i++) line[i] += by[0][i % width] + ((i - (i % width)) / last) * (by[1][i % width] - by[0][i % width]);
  line.set(from);
  line.set(end, last);
  return { to: end, start: line };
}
