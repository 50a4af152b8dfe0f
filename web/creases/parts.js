/** What a path across creases is put together from: legs where they stay on their sides, shores where they bulge, corners between them. MATH.md, "Shores". */

import { listOf, minus, sumOf } from '../vector.js';
import { bothWays, isSteep, meetEdge, settle, walk } from './crease.js';
import { leavings, Survey } from './cut.js';
import { isInside, isOnEdge, LEG, middleOf, nodesOf, placesOf, solveAll, solveLeg, span } from './legs.js';
import { ahead, apart } from './linear.js';
import { isSame } from './same.js';
import { isBulging, land, sidesOf } from './shores.js';

/** @typedef {import('./legs.js').Leg} Leg */
/** @typedef {import('./legs.js').Question} Question */
/** @typedef {import('./legs.js').Route} Route */
/** @typedef {import('./shores.js').Shore} Shore */
/** @typedef {import('./crease.js').On} On */
/** @typedef {import('../manifold/sides.js').Sides} Sides */
/** @typedef {{ signs: number[], line: number[], shore: Shore | null, on: On, isCorner?: boolean }} Piece on: where it begins; isCorner: at a corner, which holds it */

/** In the end legs are looked at in so many points, whether they leave their sides; where they seem to by this part of them, it may be what lies between points, and they are looked at in so many. */
const [SEEN, LITTLE, CLOSELY] = [255, 0.02, 4095];
/** A shore is no longer than this many times what was guessed; a leg of this part of a path at most, on whose account its joints come to no rest, is none. */
const [LONGER, SPARE] = [2, 0.02];
/** A corner is looked at so far from it, in parts of the shorter leg. */
const BESIDE = 1e-3;
/** Joints begin so far inside the rectangle, in parts of its shorter side. */
const INWARD = 1e-3;
/** Where on the line past a corner, in parts of it, is looked whether that stays outside. */
const SHORTLY = [0.1, 0.25, 0.4, 0.5, 0.6, 0.75, 0.9];

/** Where slopes are infinite nodes lie, in parts of a chord. */
const HALVED = Array.from({ length: 40 }, (_, k) => 0.5 ** (40 - k));

/** A leg, or a part of it, as it is. @param {Pick<Piece, 'signs' | 'shore'> & { line: ArrayLike<number> }} leg @param {import('./legs.js').Joint | undefined} joint at which it begins @returns {Piece} */
const whole = ({ signs, line, shore }, joint) => ({
  ...{ signs, line: listOf(line), shore },
  on: joint ?? { crease: shore?.crease ?? 0, signs },
  isCorner: joint?.isCorner,
});

/** All legs as they are; shores from where their joints have moved to. @param {Route} route @param {readonly number[]} scale @returns {Piece[]} */
const wholes = ({ legs, joints }, scale) =>
  legs.map((leg, i) => {
    const own = whole(leg, joints[i - 1]);
    if (!leg.shore) return own;
    const [before, after] = [joints[i - 1], joints[i]];
    const nodes = nodesOf(own.line, scale.length);
    /* What joints have moved past is behind them. */
    const begin = leg.shore.sense * (before?.moved ?? 0);
    const end = span(own.line, scale) + leg.shore.sense * (after?.moved ?? 0);
    let along = 0;
    const inner = nodes.slice(1, -1).filter((node, k) => {
      along += apart(nodes[k], node, scale);
      return along > begin && along < end;
    });
    const places = [before?.place ?? nodes[0], ...inner, after?.place ?? nodes[nodes.length - 1]];
    return { ...own, line: places.flat() };
  });

/** A path of pieces; those on the same side, or along the same shore, one after the other, are one leg. null: a leg does not hold. @param {Question} question @param {Piece[]} pieces @returns {Route | null} */
export function join(question, pieces) {
  const { sides, ends } = question;
  const width = ends[0].length;
  /** @type {Piece[]} */
  const joined = [];
  for (const piece of pieces) {
    const last = joined[joined.length - 1];
    const isAlike = last?.shore?.crease === piece.shore?.crease && last?.shore?.sense === piece.shore?.sense;
    const isOne = last && isAlike && !piece.isCorner && isSame(sides, last.signs, piece.signs, middleOf(piece.line, width));
    if (isOne) last.line.push(...piece.line.slice(width));
    else joined.push({ ...piece, line: [...piece.line] });
  }
  if (joined.length === 0) return null;
  const joints = joined.slice(1).map(({ on: { crease, signs }, line, isCorner }) => {
    const place = line.slice(0, width);
    return { crease, signs, place: isCorner ? place : onto(question, { crease, signs }, place), moved: 0, isCorner };
  });
  const legs = joined.map(({ signs, line, shore }, i) => {
    const nodes = nodesOf(line, width);
    /* Exactly there: beyond a crease, by rounding, a root has no value. */
    if (i > 0) nodes[0] = joints[i - 1].place;
    if (i < joints.length) nodes[nodes.length - 1] = joints[i].place;
    return { signs, line: closer(sides, signs, nodes), length: 0, shore };
  });
  const solved = solveAll(question, { legs, joints });
  return solved && { legs: solved, joints };
}

/** A polyline with more nodes, ever nearer to where it begins, and ends, where a slope is infinite there. @param {Sides} sides @param {number[]} signs @param {number[][]} nodes */
function closer(sides, signs, nodes) {
  const last = nodes.length - 1;
  const near = (/** @type {number} */ end, /** @type {number} */ next) =>
    isSteep(sides, signs, nodes[end]) ? HALVED.map((part) => ahead(nodes[end], minus(nodes[next], nodes[end]), part)) : [];
  const all = [nodes[0], ...near(0, 1), ...nodes.slice(1, -1), ...near(last, last - 1).reverse(), nodes[last]];
  return Float64Array.from(all.flat());
}

/** A place moved onto a crease, and from beyond the rectangle into it, a little: derivatives want both sides. @param {Question} question @param {On} on @param {number[]} place */
function onto(question, on, place) {
  const { sides } = question;
  const { domain } = question.field;
  const there = settle(sides, on, place);
  const edge = domain && (isOnEdge(question, there) ? there : meetEdge(sides, on, domain, there));
  if (!edge) return there;
  const step = INWARD * Math.min(...edge.map((_, j) => domain.upper[j] - domain.lower[j]));
  return bothWays(sides, on, edge, step).find((at) => isInside(question, at)) ?? edge;
}

/**
 * A path cut anew where it is none yet; null: it is one.
 * @param {Question} question @param {Route} route @param {Float64Array} line the polyline that led to it @param {boolean} isAtRest else legs are cut only where they may follow a shore @param {boolean} folds what leads beyond a fold and back follows it @returns {Piece[] | null}
 */
export function recut(question, route, line, isAtRest, folds) {
  const seen = solveAll(question, route, { ...LEG, points: SEEN });
  if (!seen) return [];
  const { joints } = route;
  const places = placesOf(question, joints);
  const pieces = seen.flatMap((leg, i) => {
    const own = whole(leg, joints[i - 1]);
    if (leg.shore) return bulge(question, own, places[i], places[i + 1], reachOf(route, i, question.sides.scale));
    const parts = leave(question, line, { legs: seen, joints }, i, own, folds);
    return isAtRest || parts.some(({ shore }) => shore) ? parts : [own];
  });
  const isKept =
    pieces.length === seen.length && pieces.every(({ shore, signs }, i) => !shore === !seen[i].shore && (shore || signs === seen[i].signs));
  const freed = isAtRest && isKept ? release(question, route, pieces) : null;
  return freed ?? (isKept ? null : pieces);
}

/** How far a shore leads from joint to joint, as these have moved; not above 0: they have passed each other. @param {Route} route @param {number} i @param {readonly number[]} scale */
function reachOf({ legs, joints }, i, scale) {
  const { line, shore } = legs[i];
  return span(line, scale) + (shore?.sense ?? 1) * ((joints[i]?.moved ?? 0) - (joints[i - 1]?.moved ?? 0));
}

/** The legs without shores whose joints have passed each other; null: none have. @param {Route} route @param {readonly number[]} scale @returns {Piece[] | null} */
export function withoutPassed(route, scale) {
  const isPassed = (/** @type {Piece} */ { shore }, /** @type {number} */ i) => shore !== null && !(reachOf(route, i, scale) > 0);
  const all = wholes(route, scale);
  return all.some(isPassed) ? without(all, scale.length, isPassed) : null;
}

/** All pieces but some; what comes after one that began at a corner begins there. @param {Piece[]} pieces @param {number} width @param {(piece: Piece, i: number) => boolean} isSpare @returns {Piece[]} */
function without(pieces, width, isSpare) {
  /** @type {Piece | null} */
  let corner = null;
  return pieces.flatMap((piece, i) => {
    if (isSpare(piece, i)) {
      corner ??= piece.isCorner ? piece : null;
      return [];
    }
    const from = corner;
    corner = null;
    return [from ? { ...piece, on: from.on, isCorner: true, line: [...from.line.slice(0, width), ...piece.line] } : piece];
  });
}

/**
 * The parts of a leg that lie on one side of all creases each; what lies beyond one that it could follow instead follows it, the way round that a polyline went.
 * @param {Question} question @param {Float64Array} line @param {Route} route @param {number} i which of its legs @param {Piece} own that leg as it is @param {boolean} folds as {@link recut} takes it @returns {Piece[]}
 */
function leave(question, line, { legs, joints }, i, own, folds) {
  const { sides, ends } = question;
  const leg = legs[i];
  const parts = leavingsOf(question, leg);
  if (!parts) return [own];
  const survey = new Survey(sides, line, 1);
  const spans = [...legs.slice(0, i), ...parts.legs, ...legs.slice(i + 1)].map((part) => span(part.line, sides.scale));
  const total = sumOf(spans);
  return parts.legs.flatMap((part, k) => {
    /* A path that begins or ends on a crease may lead beyond it at once. */
    const crease = part.signs.findIndex((sign, of) => sign !== leg.signs[of]);
    const onEnd = (/** @type {number[]} */ place) => (crease < 0 ? undefined : { crease, signs: leg.signs, place });
    const begin = k > 0 ? parts.joints[k - 1] : (joints[i - 1] ?? onEnd(ends[0]));
    const end = parts.joints[k] ?? joints[i] ?? onEnd(ends[1]);
    const free = k > 0 ? whole(part, begin) : { ...own, signs: part.signs, line: Array.from(part.line) };
    const isBeyond = begin && begin.crease === end?.crease && part.signs !== leg.signs;
    if (!isBeyond || [k - 1, k + 1].some((beside) => parts.legs[beside] && parts.legs[beside].signs !== leg.signs)) return [free];
    const before = sumOf(spans.slice(0, i + k));
    const [from, to] = [before, before + spans[i + k]].map((x) => (x / total) * survey.last);
    const sense = survey.senseOf(begin.crease, begin.signs, Math.floor(from), Math.ceil(to));
    const near = { crease: begin.crease, sense, isFold: false };
    const shore = landOn(question, { ...part, signs: begin.signs }, near);
    const isFollowed = shore?.shore && (shore.shore.isFold ? folds : shore.signs[near.crease] === leg.signs[near.crease]);
    if (!shore?.shore || !isFollowed) return [free];
    const followed = bulge(question, { ...free, signs: shore.signs, shore: shore.shore }, begin.place, end.place, Infinity);
    return followed.length > 0 ? followed : [free];
  });
}

/** As {@link leavings}, but for what only seems to leave its side. @param {Question} question @param {Leg} leg */
function leavingsOf(question, leg) {
  const parts = leavings(question.sides, leg);
  const { scale } = question.sides;
  const width = scale.length;
  const least = LITTLE * span(leg.line, scale);
  if (!parts?.legs.some(({ line }) => span(line, scale) < least)) return parts;
  const [from, to] = [leg.line.subarray(0, width), leg.line.subarray(-width)].map((place) => Array.from(place));
  const closer = solveLeg(question, leg, from, to, { ...LEG, points: CLOSELY });
  return closer ? leavings(question.sides, closer) : parts;
}

/** A leg along a shore, on the side on which that is shorter. @param {Question} question @param {Leg} leg @param {Shore} shore */
function landOn(question, leg, shore) {
  const width = question.ends[0].length;
  const place = settle(question.sides, { crease: shore.crease, signs: leg.signs }, middleOf(leg.line, width));
  return land(question, leg, shore, place);
}

/**
 * The parts of a shore that bulge, edge by edge, and between them what cuts it short; nothing where its ends have passed each other.
 * @param {Question} question @param {Piece} piece @param {number[]} from @param {number[]} to @param {number} guess how long it is @returns {Piece[]}
 */
function bulge(question, { signs: first, shore: given, on, isCorner }, from, to, guess) {
  const { sides } = question;
  const shore = /** @type {Shore} */ (given);
  const { crease, sense } = shore;
  const edges = guess > 0 ? walk(sides, { crease, signs: first }, from, to, sense, LONGER * guess) : null;
  if (!edges?.every(({ places }) => places.every((place) => isInside(question, place)))) return [];
  /** @type {Piece[]} */
  const pieces = [];
  for (const [e, { signs, places }] of edges.entries()) {
    const bends = sidesOf(shore, signs);
    for (let i = 1; i < places.length; i++) {
      const isFollowed = bends.every((of) => isBulging(question, { crease, signs: of }, places[i - 1], places[i]));
      const last = pieces[pieces.length - 1];
      if (i > 1 && !last.shore === !isFollowed) last.line.push(...places[i]);
      else
        pieces.push({
          ...{ signs, shore: isFollowed ? shore : null, line: [...places[i - 1], ...places[i]] },
          on: pieces.length === 0 ? on : { crease, signs },
          isCorner: i === 1 && (e > 0 || isCorner),
        });
    }
  }
  return pieces;
}

/** The pieces without a corner that does not hold them: what goes past it shortly is on their side. null: all hold. @param {Question} question @param {Route} route @param {Piece[]} pieces @returns {Piece[] | null} */
function release(question, { legs, joints }, pieces) {
  const { sides } = question;
  const j = joints.findIndex(({ isCorner, place, crease }, k) => {
    if (!isCorner || isOnEdge(question, place)) return false;
    const least = BESIDE * Math.min(...[legs[k], legs[k + 1]].map(({ line }) => span(line, sides.scale)));
    const [before, after] = [legs[k].line, legs[k + 1].line].map((line, side) => beside(line, sides.scale, place, least, side));
    const past = SHORTLY.flatMap((part) => before.map((x, i) => x + part * (after[i] - x)));
    return sides.measure(past).every((measured) => measured[crease] * legs[k].signs[crease] > 0);
  });
  return j < 0 ? null : pieces.map((piece, i) => (i === j + 1 ? { ...piece, isCorner: false } : piece));
}

/** A place on a line, near an end of it. @param {Float64Array} line @param {readonly number[]} scale @param {number[]} end @param {number} away @param {number} side 0: its last, 1: its first */
export function beside(line, scale, end, away, side) {
  const width = scale.length;
  const next = Array.from(side ? line.subarray(width, 2 * width) : line.subarray(-2 * width, -width));
  const reach = apart(end, next, scale);
  return end.map((x, i) => x + (away / reach) * (next[i] - x));
}

/** The legs but for the shortest one that is free, between joints on the same crease; null: none is so short. @param {Route} route @param {readonly number[]} scale @param {number} [most] part of the path @returns {Piece[] | null} */
export function withoutLeast(route, scale, most = SPARE) {
  const { legs, joints } = route;
  const spans = legs.map(({ line }) => span(line, scale));
  const isSpare = (/** @type {number} */ i) => i > 0 && !legs[i].shore && joints[i]?.crease === joints[i - 1].crease;
  const least = spans.reduce((best, length, i) => (isSpare(i) && !(length >= spans[best]) ? i : best), -1);
  if (least < 0 || spans[least] > most * sumOf(spans)) return null;
  return without(wholes(route, scale), scale.length, (_, i) => i === least);
}

/** The pieces of a route that a polyline was cut into; null: it is not known on which side a shore is shorter. @param {Question} question @param {Route} route @returns {Piece[] | null} */
export function landed(question, { legs, joints }) {
  const { scale } = question.sides;
  const settled = joints.map((joint) => ({ ...joint, place: onto(question, joint, joint.place) }));
  const places = placesOf(question, settled);
  const pieces = legs.map((leg, i) => {
    if (!leg.shore) return [whole(leg, settled[i - 1])];
    const shore = landOn(question, leg, leg.shore);
    return shore && bulge(question, whole(shore, settled[i - 1]), places[i], places[i + 1], span(leg.line, scale));
  });
  return pieces.includes(null) ? null : pieces.flatMap((own) => own ?? []);
}
