/** Joints of a path that follows shores: moved until each leg is met as it should be. MATH.md, "Shores". */

import { largest, sumOf } from '../vector.js';
import { bothWays, directions, meetEdge, settle } from './crease.js';
import { isInside, isOnEdge, LEG, leastBeside, placesOf, slopeAlong, solveLeg, span } from './legs.js';
import { ahead, apart, solveLinear } from './linear.js';
import { withoutLeast, withoutPassed } from './parts.js';
import { graze, survey } from './shores.js';
import { speedOn } from './tangent.js';

/** @typedef {import('./legs.js').Joint} Joint */
/** @typedef {import('./legs.js').Leg} Leg */
/** @typedef {import('./legs.js').Question} Question */
/** @typedef {import('./legs.js').Route} Route */

/** Legs are right where sines of their angles, or differences of cosines, are off by so little. */
const GRAZING = 1e-7;
/** Differences of angles are taken over this part of the shorter leg; steps are at most the second. */
const [BALANCE, FARTHEST] = [1e-3, 0.5];
/** A joint stays on an edge of the rectangle that is no farther than this part of the shorter leg. */
const NEAR_EDGE = 0.05;
/** A leg between two shores of this part of a path at most is none: that its joints are at rest says nothing. */
const PINCHED = 1e-6;
/** So often joints are moved, and so often a step halved; joints that have passed each other for so many steps have no shore between them. */
const [MOST_STEPS, MOST_HALVINGS, MOST_PASSED] = [30, 12, 3];

/** @typedef {{ legs: Leg[], joints: Joint[], off: number[] }} Balanced a path, and how far from right legs meet at each of its joints */

/** Moves joints until nothing is off, if that is to be had. @param {Question} question @param {Route} route @returns {{ route: Route, isAtRest: boolean }} */
export function rest(question, route) {
  let now = weigh(question, route);
  let passed = 0;
  for (let step = 0; now && step < MOST_STEPS; step++) {
    route = now;
    passed = withoutPassed(now, question.sides.scale) ? passed + 1 : 0;
    if (largest(now.off) <= GRAZING) return { route, isAtRest: passed === 0 && !withoutLeast(now, question.sides.scale, PINCHED) };
    if (passed === MOST_PASSED) break;
    now = rebalance(question, now);
  }
  return { route, isAtRest: false };
}

/** Its shores with their lengths; null: one is none. @param {Question} question @param {Route} route @returns {Route | null} */
export function surveyAll(question, { legs, joints }) {
  const places = placesOf(question, joints);
  const surveyed = legs.map((leg, i) => (leg.shore ? survey(question, leg, places[i], places[i + 1]) : leg));
  return surveyed.includes(null) ? null : { legs: /** @type {Leg[]} */ (surveyed), joints };
}

/** Whether joints farther along their shores are met at smaller angles, and beyond those that are crossed the length rises: else the path is longest there. @param {Question} question @param {Route} route */
export function isShortest(question, route) {
  const now = weigh(question, route);
  const least = leastBeside(route, question.sides.scale);
  return (
    now !== null &&
    route.joints.every(({ isCorner }, j) => {
      if (isCorner && !isHeld(question, now, j)) return false;
      const into = route.legs[j + 1].shore?.sense ?? -(route.legs[j].shore?.sense ?? -1);
      const there = isCorner ? now : shift(question, now, only(j, into * BALANCE * least[j], least.length));
      return there && there.off[j] >= -2 * GRAZING;
    })
  );
}

/** Whether a joint on an edge of the rectangle that is crossed there would make the path longer anywhere else. @param {Question} question @param {Balanced} route @param {number} j */
function isHeld(question, { legs, joints }, j) {
  const joint = joints[j];
  const pair = [legs[j], legs[j + 1]];
  if (!isOnEdge(question, joint.place) || pair.some(({ shore }) => shore)) return true;
  const [from, place, to] = placesOf(question, joints).slice(j, j + 3);
  const step = BALANCE * Math.min(...pair.map(({ line }) => span(line, question.sides.scale)));
  const inside = bothWays(question.sides, joint, place, step).find((at) => isInside(question, at));
  const moved = inside && [solveLeg(question, pair[0], from, inside, LEG), solveLeg(question, pair[1], inside, to, LEG)];
  return !!moved && sumOf(moved.map((leg) => leg?.length ?? Number.NaN)) >= pair[0].length + pair[1].length;
}

/** @param {number} j @param {number} x @param {number} count */
const only = (j, x, count) => Array.from({ length: count }, (_, k) => (k === j ? x : 0));

/** One step of Newton towards joints where nothing is off; null: none leads nearer. @param {Question} question @param {Balanced} now @returns {Balanced | null} */
function rebalance(question, now) {
  const { joints, off } = now;
  const least = leastBeside(now, question.sides.scale);
  const loose = [...joints.keys()].filter((j) => !joints[j].isCorner);
  const differ = (/** @type {number} */ j, /** @type {number} */ by) =>
    shift(question, now, only(j, by, joints.length))?.off.map((x, k) => (x - off[k]) / by);
  /* At an edge of the rectangle there may be nothing on one side. */
  const columns = loose.map((j) => differ(j, BALANCE * least[j]) ?? differ(j, -BALANCE * least[j]));
  const matrix = loose.map((i) => columns.map((column) => column?.[i] ?? Number.NaN));
  const right = loose.map((i) => -off[i]);
  const step = solveLinear(matrix, right);
  if (!step?.every(Number.isFinite)) return null;
  let factor = Math.min(1, ...step.map((x, k) => (FARTHEST * least[loose[k]]) / Math.abs(x)));
  for (let halving = 0; halving < MOST_HALVINGS; halving++, factor /= 2) {
    const by = joints.map((_, j) => (joints[j].isCorner ? 0 : factor * step[loose.indexOf(j)]));
    const tried = shift(question, now, by, least);
    if (tried && largest(tried.off) < largest(off)) return tried;
  }
  return null;
}

/**
 * Joints moved along their creases, by so much each; null: legs do not hold.
 * @param {Question} question @param {Balanced} now @param {number[]} by
 * @param {number[]} [least] how long the shorter leg beside each is: a joint that would leave the rectangle near by stays on its edge, as at a corner
 * @returns {Balanced | null}
 */
function shift(question, now, by, least) {
  const { domain } = question.field;
  const joints = now.joints.map((joint, j) => {
    if (!by[j]) return joint;
    const on = edgeAt(now, j);
    const { along } = directions(question.sides, on, joint.place);
    const place = settle(question.sides, on, ahead(joint.place, along, by[j]));
    const edge = least && domain && meetEdge(question.sides, on, domain, place);
    const isPressed = !!edge && apart(joint.place, edge, question.sides.scale) <= NEAR_EDGE * least[j];
    const there = isPressed ? edge : place;
    const moved = (joint.moved ?? 0) + Math.sign(by[j]) * apart(joint.place, there, question.sides.scale);
    return { ...joint, place: there, moved, isCorner: joint.isCorner || isPressed };
  });
  /* One that has passed another is only on its way to nowhere. */
  const isAnyPressed = joints.some(({ isCorner }, j) => isCorner && !now.joints[j].isCorner);
  if (isAnyPressed && withoutPassed({ legs: now.legs, joints }, question.sides.scale)) return null;
  if (!joints.every(({ place }) => isInside(question, place))) return null;
  return weigh(question, { legs: now.legs, joints }, now);
}

/** The edge of a crease along which a joint moves: that of the shore beside it. @param {Route} route @param {number} j @returns {import('./crease.js').On} */
function edgeAt({ legs, joints }, j) {
  const shore = legs[j].shore ? legs[j] : legs[j + 1].shore ? legs[j + 1] : null;
  return shore ? { crease: joints[j].crease, signs: shore.signs } : joints[j];
}

/** A path with its legs solved and weighed; null: one does not hold. @param {Question} question @param {Route} route @param {Balanced} [known] but for where joints are others: what is known need not be solved again @returns {Balanced | null} */
function weigh(question, route, known) {
  const { joints } = route;
  const places = placesOf(question, joints);
  const isNew = (/** @type {number} */ j) => joints[j] !== known?.joints[j];
  const isOpen = route.legs.map((_, i) => !known || (i > 0 && isNew(i - 1)) || (i < joints.length && isNew(i)));
  const legs = route.legs.map((leg, i) => (leg.shore || !isOpen[i] ? leg : solveLeg(question, leg, places[i], places[i + 1], LEG)));
  if (legs.includes(null)) return null;
  const solved = { legs: /** @type {Leg[]} */ (legs), joints };
  const off = joints.map((joint, j) => {
    if (joint.isCorner) return 0;
    if (known && !isOpen[j] && !isOpen[j + 1]) return known.off[j];
    return offAt(question, solved, j);
  });
  return off.every(Number.isFinite) ? { ...solved, off } : null;
}

/** How far from right the legs meet at a joint, as a sine: by Snell's law, what the length changes by along the crease, over what that measures. @param {Question} question @param {Route} route @param {number} j */
function offAt(question, { legs, joints }, j) {
  const [before, after] = [legs[j], legs[j + 1]];
  const { place } = joints[j];
  if (before.shore) return graze(question, after, place, 0, before);
  if (after.shore) return graze(question, before, place, 1, after);
  const { along } = directions(question.sides, joints[j], place);
  const speeds = [before, after].map(({ signs }) => speedOn(question, signs, place, along));
  return (slopeAlong(before, 1, along) + slopeAlong(after, 0, along)) / Math.max(...speeds);
}
