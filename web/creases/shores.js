/** Legs along creases: a shore that is walked because what lies beyond it is dear, or because the surface bends away from it on both sides. */

import { joinPaths, thinned } from '../search/join.js';
import { poseNear } from '../search/routes.js';
import { beyond, bothWays, directions, ground, settle, slopeAt, slopeOf, walk } from './crease.js';
import { isInside, LEG, middleOf, nodesOf, solveLeg } from './legs.js';
import { ahead } from './linear.js';

/** @typedef {import('../path.js').Path} Path */
/** @typedef {import('./legs.js').Leg} Leg */
/** @typedef {import('./legs.js').Question} Question */
/** @typedef {import('../runtime/heap.js').SolveOptions} SolveOptions */
/** @typedef {{ crease: number, sense: number, isFold: boolean }} Shore sense: 1 if it is followed as {@link directions} says, else −1; isFold: both of its sides measure it alike */

/** Two sides measure alike to this part. */
const ALIKE = 1e-7;
/** Pieces of a shore are halved so often; of what is extrapolated from that the last two differ by no more than this part. */
const [HALVINGS, EXACT] = [5, 1e-11];
/** What lies between two places on a shore leaves its side by no more than this part of their distance. */
const LEAVES = 1e-9;

/** The length of what is straight between two places on a side; NaN: it does not hold. @param {Question} question @param {number[]} signs @param {number[]} from @param {number[]} to */
export const distance = (question, signs, from, to) => near(question, signs, from, to)?.length ?? Number.NaN;

/** @param {Question} question @param {number[]} signs @param {number[]} from @param {number[]} to */
const near = (question, signs, from, to) =>
  solveLeg(question, { signs, length: 0, shore: null, line: Float64Array.from([...from, ...to]) }, from, to, { ...LEG, points: 1 });

/** On which sides a shore is followed: a fold on both. @param {Shore} shore @param {number[]} signs of one */
export const sidesOf = ({ crease, isFold }, signs) => (isFold ? [signs, beyond(signs, crease)] : [signs]);

/** The leg along a shore, on the side of it on which that is shorter. @param {Question} question @param {Leg} leg @param {Shore} shore @param {number[]} place on it @param {number} step @returns {Leg | null} */
export function land(question, leg, shore, place, step) {
  const sides = [1, -1].map((sign) => leg.signs.map((of, k) => (k === shore.crease ? sign : of)));
  const speeds = sides.map((signs) => {
    const [back, on] = bothWays(question.sides, { crease: shore.crease, signs }, place, step);
    return distance(question, signs, back, on);
  });
  if (!speeds.every((speed) => speed > 0)) return null;
  const isFold = Math.abs(speeds[0] - speeds[1]) <= ALIKE * speeds[0];
  return { ...leg, signs: sides[isFold || speeds[0] < speeds[1] ? 0 : 1], shore: { ...shore, isFold } };
}

/**
 * How far a leg meets a shore from as it should: the tangent of half its angle, large where it turns back, less that of the critical one, whose cosine is the ratio of what both sides measure
 * along the shore: 0 on a fold.
 * @param {Question} question @param {Leg} leg @param {number[][]} ends of it @param {number} end which of them is on the shore @param {Leg} beside along the shore @param {number} step of differences
 */
export function graze(question, leg, ends, end, beside, step) {
  const { sides } = question;
  const { crease, sense, isFold } = /** @type {Shore} */ (beside.shore);
  const on = { crease, signs: leg.signs };
  const place = ends[end];
  const { along, across } = directions(sides, on, place, slopeAt(sides, { crease, signs: beside.signs }, place));
  const t = along.map((x) => (end ? sense : -sense) * x);
  const n = across.map((x) => leg.signs[crease] * x);
  const at = (/** @type {number} */ a, /** @type {number} */ b) => ground(sides, on, ahead(ahead(place, t, a * step), n, b * step));
  const lengthAt = (/** @type {number} */ a, /** @type {number} */ b) => {
    const there = at(a, b);
    return solveLeg(question, leg, end ? ends[0] : there, end ? there : ends[1], LEG)?.length ?? Number.NaN;
  };
  const speed = (/** @type {number[]} */ signs, /** @type {number} */ a, /** @type {number} */ b) =>
    distance(question, signs, at(-a, -b), at(a, b)) / (2 * step);
  const [tt, nn, both] = [speed(leg.signs, 1, 0) ** 2, speed(leg.signs, 0, 1) ** 2, speed(leg.signs, 1, 1) ** 2];
  const skew = (both - tt - nn) / (2 * tt);
  const [alongIt, acrossIt] = [lengthAt(1, 0) - lengthAt(-1, 0), lengthAt(0, 1) - lengthAt(0, -1)].map((by) => by / (2 * step));
  const [sine, cosine] = [(acrossIt - skew * alongIt) / Math.sqrt(nn - skew * skew * tt), alongIt / Math.sqrt(tt)];
  const isOwn = isFold || leg.signs[crease] === beside.signs[crease];
  const critical = isOwn ? 1 : Math.min(1, speed(beside.signs, 1, 0) / Math.sqrt(tt));
  return sine / (1 + cosine) + Math.sqrt((1 - critical) / (1 + critical));
}

/**
 * A leg along a shore from one place to another, with the places on it and its length: of legs between ever more of them, extrapolated. null: it is not reached, leaves the rectangle, or is no
 * shortest way, since the surface bends towards it.
 * @param {Question} question @param {Leg} leg along it @param {number[]} from @param {number[]} to @returns {Leg | null}
 */
export function survey(question, leg, from, to) {
  const { sides } = question;
  const shore = /** @type {Shore} */ (leg.shore);
  const { crease, sense } = shore;
  const on = { crease, signs: leg.signs };
  const edges = walk(sides, on, from, to, sense);
  const places = edges?.length === 1 ? edges[0].places : null;
  if (!places?.every((place) => isInside(question, place))) return null;
  const bends = sidesOf(shore, leg.signs);
  if (!bends.every((signs) => places.slice(1).every((place, i) => isBulging(question, { crease, signs }, places[i], place)))) return null;
  /** Romberg's table, a row at a time. @type {number[]} */
  let row = [];
  for (let level = 0; level <= HALVINGS; level++) {
    const parts = 2 ** level;
    let sum = 0;
    for (let i = 1; i < places.length; i++) {
      const nodes = Array.from({ length: parts + 1 }, (_, k) => between(sides, on, places[i - 1], places[i], k / parts));
      for (let k = 1; k <= parts; k++) sum += distance(question, leg.signs, nodes[k - 1], nodes[k]);
    }
    const next = [sum];
    for (let k = 0; k < row.length; k++) next.push(next[k] + (next[k] - row[k]) / (4 ** (k + 1) - 1));
    const [length, before] = [next[level], row[level - 1]];
    const error = Math.abs(length - before);
    row = next;
    if (error <= EXACT * length) return { ...leg, line: Float64Array.from(places.flat()), length, error };
    if (Number.isNaN(length)) return null;
  }
  return null;
}

/** A place between two on a crease. @param {import('../manifold/sides.js').Sides} sides @param {import('./crease.js').On} on @param {number[]} from @param {number[]} to @param {number} part */
const between = (sides, on, from, to, part) =>
  part === 0
    ? from
    : part === 1
      ? to
      : settle(
          sides,
          on,
          from.map((x, j) => x + part * (to[j] - x)),
        );

/** Whether what is straight between two places on a crease lies beyond it, or on it. @param {Question} question @param {import('./crease.js').On} on @param {number[]} from @param {number[]} to */
export function isBulging(question, { crease, signs }, from, to) {
  const leg = near(question, signs, from, to);
  if (!leg) return false;
  const width = from.length;
  const [measured] = question.sides.measure(middleOf(leg.line, width));
  const slope = Math.max(...slopeOf(question.sides, measured, crease, width).map(Math.abs));
  const apart = Math.max(...from.map((x, j) => Math.abs(x - to[j])));
  return signs[crease] * measured[crease] <= LEAVES * slope * apart;
}

/** The part of a path along a shore. @param {Question} question @param {Leg} leg as it was surveyed @param {SolveOptions} options @returns {Path} */
export function writeShore(question, leg, options) {
  const { field, sides } = question;
  const { length, error = 0 } = leg;
  const places = nodesOf(leg.line, question.ends[0].length);
  const on = { crease: leg.shore?.crease ?? 0, signs: leg.signs };
  const lengths = places.map((place, i) => (i ? distance(question, leg.signs, places[i - 1], place) : 0));
  const total = lengths.reduce((sum, x) => sum + x, 0);
  const pieces = options.points + 1;
  const nodes = [places[0]];
  let [piece, behind] = [1, 0];
  for (let k = 1; k < pieces; k++) {
    const wanted = (k / pieces) * total;
    while (piece < places.length - 1 && behind + lengths[piece] < wanted) behind += lengths[piece++];
    nodes.push(between(sides, on, places[piece - 1], places[piece], Math.min(1, (wanted - behind) / lengths[piece])));
  }
  nodes.push(places[places.length - 1]);
  const { run } = /** @type {import('../manifold/sides.js').Side} */ (sides.on(leg.signs));
  const parts = nodes.slice(1).map((node, k) => {
    const { solve, finish } = poseNear({ ...field, run }, [nodes[k], node], null);
    return finish(solve({ ...options, points: 1 }));
  });
  const whole = thinned(joinPaths(parts, field.domain), pieces + 1);
  return { ...whole, length, lengthError: error + Number.EPSILON * length };
}
