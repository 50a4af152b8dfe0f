/** Legs along creases: a shore that is walked because what lies beyond it is dear, or because the surface bends away from it on both sides. */

import { joinPaths, thinned } from '../search/join.js';
import { solveAlong } from '../search/routes.js';
import { largest, minus, sumOf } from '../vector.js';
import { between, beyond, directions, slopeAt, slopeOf, walk } from './crease.js';
import { isInside, LEG, middleOf, nodesOf, slopeAlong, solveLeg } from './legs.js';
import { apart, inner, scaled } from './linear.js';
import { endOf } from './meeting.js';
import { frameOn, speedOn, traceOn } from './tangent.js';

/** @typedef {import('../path.js').Path} Path */
/** @typedef {import('./legs.js').Leg} Leg */
/** @typedef {import('./legs.js').Question} Question */
/** @typedef {import('../runtime/heap.js').SolveOptions} SolveOptions */
/** @typedef {{ crease: number, sense: number, isFold: boolean }} Shore sense: 1 if it is followed as {@link directions} says, else −1; isFold: both of its sides measure it alike */

/** Two sides measure alike to this part. */
const ALIKE = 1e-7;
/** Pieces of a shore are halved so often, at most; their lengths before and after differ by no more than this part. */
const [HALVINGS, EXACT] = [5, 1e-11];
/** Gauss's rule: places in the piece from −1 to 1, on both sides of 0, and their weights. */
const GAUSS = [
  [0.1834346424956498, 0.362683783378362],
  [0.525532409916329, 0.3137066458778873],
  [0.7966664774136267, 0.2223810344533745],
  [0.9602898564975363, 0.1012285362903763],
];
/** Legs between neighbours on a shore are almost straight, or none. */
const NEAR = { ...LEG, points: 1, maxIterations: 12 };
/** Between two places on a shore so much on both sides of the middle is looked at. */
const MIDDLE = 0.125;
/** What lies between two places on a shore leaves its side by no more than this part of their distance. */
const LEAVES = 1e-9;
/** A geodesic that begins along a shore follows it if it ends from it by no more than this part of how far that leads. */
const BESIDE = 1e-5;

/** What is straight between two places on a side. @param {Question} question @param {number[]} signs @param {number[]} from @param {number[]} to */
const near = (question, signs, from, to) =>
  solveLeg(question, { signs, length: 0, shore: null, line: Float64Array.from([...from, ...to]) }, from, to, NEAR);

/** On which sides a shore is followed: a fold on both. @param {Shore} shore @param {number[]} signs of one */
export const sidesOf = ({ crease, isFold }, signs) => (isFold ? [signs, beyond(signs, crease)] : [signs]);

/** The leg along a shore, on the side of it on which that is shorter. @param {Question} question @param {Leg} leg @param {Shore} shore @param {number[]} place on it @returns {Leg | null} */
export function land(question, leg, shore, place) {
  const sides = [1, -1].map((sign) => leg.signs.map((of, k) => (k === shore.crease ? sign : of)));
  const { along } = directions(question.sides, { crease: shore.crease, signs: sides[0] }, place);
  const speeds = sides.map((signs) => speedOn(question, signs, place, along));
  if (!speeds.every((speed) => speed > 0)) return null;
  const isFold = Math.abs(speeds[0] - speeds[1]) <= ALIKE * speeds[0];
  return { ...leg, signs: sides[isFold || speeds[0] < speeds[1] ? 0 : 1], shore: { ...shore, isFold } };
}

/**
 * How far a leg meets a shore from as it should: the tangent of half its angle, large where it turns back, less that of the critical one, whose cosine is the ratio of what both sides measure
 * along the shore: 0 on a fold.
 * @param {Question} question @param {Leg} leg @param {number[]} place where that is @param {number} end 0: of the leg's beginning; 1: of its end @param {Leg} beside along the shore
 */
export function graze(question, leg, place, end, beside) {
  const { sides } = question;
  const { crease, sense, isFold } = /** @type {Shore} */ (beside.shore);
  const on = { crease, signs: leg.signs };
  const { along, across } = directions(sides, on, place, slopeAt(sides, { crease, signs: beside.signs }, place));
  const t = along.map((x) => (end ? sense : -sense) * x);
  const n = across.map((x) => leg.signs[crease] * x);
  const { t: tt, n: nn, skew } = frameOn(question, leg.signs, place, t, n);
  const [alongIt, acrossIt] = [t, n].map((way) => slopeAlong(leg, end, way));
  const [sine, cosine] = [(acrossIt - skew * alongIt) / Math.sqrt(nn), alongIt / Math.sqrt(tt)];
  const isOwn = isFold || leg.signs[crease] === beside.signs[crease];
  const critical = isOwn ? 1 : Math.min(1, speedOn(question, beside.signs, place, t) / Math.sqrt(tt));
  return sine / (1 + cosine) + Math.sqrt((1 - critical) / (1 + critical));
}

/**
 * A leg along a shore from one place to another, with the places on it and its length. null: it is not reached, leaves the rectangle, or is no
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
  let before = Number.NaN;
  for (let level = 0; level <= HALVINGS; level++) {
    const length = sumOf(places.slice(1).map((place, i) => lengthAlong(question, on, places[i], place, 2 ** level)));
    const error = Math.abs(length - before);
    if (error <= EXACT * length) {
      const isSpent = bends.some((signs) => isPastConjugate(question, { crease, signs }, sense, length, from, to));
      return isSpent ? null : { ...leg, line: Float64Array.from(places.flat()), length, error };
    }
    before = length;
  }
  return null;
}

/**
 * Whether a crease is a geodesic of a side, as the rim of Luneburg's lens, and from one place on it to another leads past a point that is conjugate to the first.
 * @param {Question} question @param {import('./crease.js').On} on @param {number} sense @param {number} length @param {number[]} from @param {number[]} to
 */
function isPastConjugate({ field, sides }, on, sense, length, from, to) {
  const side = sides.on(on.signs);
  const way = scaled(directions(sides, on, from).along, sense);
  const traced = side && traceOn({ field, tolerance: ALIKE }, side, from, way, length);
  return !!traced?.conjugate && apart(endOf(traced), to, sides.scale) <= BESIDE * apart(from, to, sides.scale);
}

/** How long a crease is between two places on it, by Gauss's rule in so many parts. @param {Question} question @param {import('./crease.js').On} on @param {number[]} from @param {number[]} to @param {number} [parts] */
function lengthAlong(question, on, from, to, parts = 1) {
  const { sides } = question;
  const chord = minus(to, from);
  let sum = 0;
  for (let part = 0; part < parts; part++)
    for (const [x, weight] of GAUSS)
      for (const at of [-x, x]) {
        const place = between(sides, on, from, to, (part + 0.5 + 0.5 * at) / parts);
        const { along } = directions(sides, on, place);
        sum += ((weight / 2 / parts) * speedOn(question, on.signs, place, along)) / Math.abs(inner(along, chord, sides.scale));
      }
  return sum * inner(chord, chord, sides.scale);
}

/**
 * Whether what is straight between two places on a crease lies beyond it, or on it: around the middle, and where nothing straight leads so far, nearer to it.
 * @param {Question} question @param {import('./crease.js').On} on @param {number[]} from @param {number[]} to
 */
export function isBulging(question, on, from, to) {
  const { crease, signs } = on;
  for (let k = 0, part = MIDDLE; k <= HALVINGS; k++, part /= 2) {
    const [back, next] = [0.5 - part, 0.5 + part].map((at) => between(question.sides, on, from, to, at));
    const leg = near(question, signs, back, next);
    if (!leg) continue;
    const width = from.length;
    const [measured] = question.sides.measure(middleOf(leg.line, width));
    const slope = largest(slopeOf(question.sides, measured, crease));
    const apart = largest(minus(back, next));
    return signs[crease] * measured[crease] <= LEAVES * slope * apart;
  }
  return false;
}

/** The part of a path along a shore. @param {Question} question @param {Leg} leg as it was surveyed @param {SolveOptions} options @returns {Path} */
export function writeShore(question, leg, options) {
  const { field, sides } = question;
  const { length, error = 0 } = leg;
  const pieces = options.points + 1;
  const { run } = /** @type {import('../manifold/sides.js').Side} */ (sides.on(leg.signs));
  for (let finer = 1; ; finer *= 2) {
    const nodes = spread(question, leg, finer * pieces);
    const asked = { ...options, points: NEAR.points, maxIterations: NEAR.maxIterations };
    const parts = nodes.slice(1).map((node, k) => solveAlong({ ...field, run }, [nodes[k], node], asked, null));
    const whole = joinPaths(parts, field.domain, true);
    if (whole.converged)
      return { ...thinned(whole, pieces + 1), length, energy: length * length, lengthError: error + Number.EPSILON * length };
    if (finer === 2 ** HALVINGS) return whole;
  }
}

/** Places along a shore, in so many equal pieces of its length, about. @param {Question} question @param {Leg} leg as it was surveyed @param {number} pieces */
function spread(question, leg, pieces) {
  const { sides } = question;
  const places = nodesOf(leg.line, question.ends[0].length);
  const on = { crease: leg.shore?.crease ?? 0, signs: leg.signs };
  const lengths = places.map((place, i) => (i ? lengthAlong(question, on, places[i - 1], place) : 0));
  const total = sumOf(lengths);
  const nodes = [places[0]];
  let [piece, behind] = [1, 0];
  for (let k = 1; k < pieces; k++) {
    const wanted = (k / pieces) * total;
    while (piece < places.length - 1 && behind + lengths[piece] < wanted) behind += lengths[piece++];
    nodes.push(between(sides, on, places[piece - 1], places[piece], Math.min(1, (wanted - behind) / lengths[piece])));
  }
  nodes.push(places[places.length - 1]);
  return nodes;
}
