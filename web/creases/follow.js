/** From a polyline to the path that it leads to, across creases and along them. */

import { largest } from '../vector.js';
import { isShortest, rest, surveyAll } from './balance.js';
import { beyond, directions, isTorn } from './crease.js';
import { cut } from './cut.js';
import { pastCorner } from './held.js';
import { lengthOf, lineOf, middleOf } from './legs.js';
import { join, landed, recut, withoutLeast, withoutPassed } from './parts.js';
import { refract } from './refract.js';
import { speedOn } from './tangent.js';

/** @typedef {import('./legs.js').Joint} Joint */
/** @typedef {import('./legs.js').Leg} Leg */
/** @typedef {import('./legs.js').Question} Question */
/** @typedef {import('./legs.js').Route} Route */

/** What begins beside a crease comes to it over this part of where it is near; where no leg leads so far, over less. */
const LEADS = [1 / 8, 1 / 64];
/** So many corners that do not hold a path are passed. */
const MOST_PASSED = 3;
/** So often what a path is put together from is changed. */
const MOST_CUTS = 12;
/** What is shorter than this part of what is usual has no length. */
const FREE = 1e-9;
/** Routes at rest are the same to so many digits. */
const SAME = 6;

/**
 * The path that a polyline leads to; null: none that holds.
 * @param {Question} question @param {Float64Array} line @param {number} near it follows creases that are nearer than this part of its length
 * @param {number} most what comes to rest longer than this is given up @returns {Route | null}
 */
export function follow(question, line, near, most) {
  for (let passed = 0; passed <= MOST_PASSED; passed++) {
    const route = comeToRest(question, line, near, most);
    const past = route && !question.field.isPlain ? pastCorner(question, route) : null;
    if (!past) return route;
    [line, near] = [past, 0];
  }
  return null;
}

/** As {@link follow}, corners or not. @param {Question} question @param {Float64Array} line @param {number} near @param {number} most @returns {Route | null} */
function comeToRest(question, line, near, most) {
  const { scale } = question.sides;
  const width = scale.length;
  /** @type {Route | null} */
  let route = null;
  /** @type {string | null} */
  let tried = null;
  for (let k = 0; !route && k < (near > 0 ? LEADS.length : 1); k++) {
    const first = cut(question.sides, line, { near, lead: LEADS[k] });
    /* Without a shore it is what not following creases is. */
    if (near > 0 && !first?.legs.some(({ shore }) => shore)) return null;
    const places = `${first?.joints.map(({ place }) => place)}`;
    if (places === tried) break;
    tried = places;
    const pieces = first && landed(question, first);
    if (
      pieces &&
      hasFreeJoint(
        question,
        pieces,
        pieces.slice(1).map(({ on, line: own }) => ({ ...on, place: own.slice(0, width) })),
      )
    )
      return null;
    route = pieces && join(question, pieces);
  }
  if (!route || isTornAnywhere(question, route)) return null;
  let isAtRest = false;
  /** Routes at rest that were cut anew: what comes to one of them again goes round in circles, over and back over a fold that it should follow. @type {string[]} */
  let known = [];
  let folds = false;
  for (let cuts = 0; route && cuts < MOST_CUTS; cuts++) {
    let again = recut(question, route, line, isAtRest, folds);
    if (!again && isAtRest) {
      const whole = finish(question, route);
      return whole && lengthOf(whole.legs) <= most ? whole : null;
    }
    if (again && isAtRest) {
      question.budget.lost = lineOf(route.legs, width);
      const key = keyOf(route);
      if (known.includes(key)) {
        if (folds) return null;
        [known, folds] = [[], true];
        again = recut(question, route, line, isAtRest, folds);
      }
      known.push(key);
    }
    isAtRest = !again;
    if (again) route = join(question, again);
    else {
      const rested = settleJoints(question, route);
      if (rested.isAtRest && lengthOf(rested.route.legs) > most) return null;
      if (rested.isAtRest) route = rested.route;
      else {
        isAtRest = false;
        const fewer = withoutPassed(rested.route, scale) ?? withoutLeast(rested.route, scale);
        route = fewer && join(question, fewer);
      }
    }
  }
  return null;
}

/** Whether a joint is where a crease has no length, as where a density is zero along it, or at a pole: what leads there comes to no rest, however long it is solved, or anywhere. @param {Question} question @param {{ signs: number[], line: ArrayLike<number> }[]} legs @param {Pick<Joint, 'crease' | 'signs' | 'place'>[]} joints */
function hasFreeJoint(question, legs, joints) {
  const width = question.sides.scale.length;
  const speedAt = (/** @type {import('./crease.js').On} */ on, /** @type {number[]} */ place) =>
    speedOn(question, on.signs, place, directions(question.sides, on, place).along);
  const usual = largest(
    joints.flatMap(({ crease }, j) => legs.slice(j, j + 2).map(({ signs, line }) => speedAt({ crease, signs }, middleOf(line, width)))),
  );
  return joints.some((joint) => speedAt(joint, joint.place) <= FREE * usual);
}

/** What tells a route at rest from others. @param {Route} route */
const keyOf = ({ legs, joints }) => `${joints.map(({ crease }) => crease)} ${lengthOf(legs).toPrecision(SAME)}`;

/** @param {Route} route */
const hasShores = ({ legs, joints }) => legs.some(({ shore }) => shore) || joints.some(({ isCorner }) => isCorner);

/** @param {Question} question @param {Route} route @returns {{ route: Route, isAtRest: boolean }} */
function settleJoints(question, route) {
  if (hasShores(route)) return rest(question, route);
  const rested = refract(question, route);
  if (rested) return { route: rested, isAtRest: true };
  if (!question.field.domain) return { route, isAtRest: false };
  /* Joints may be held by an edge of the rectangle; where none is, what pulls at none of them may be no minimum. */
  const balanced = rest(question, route);
  return { ...balanced, isAtRest: balanced.isAtRest && hasShores(balanced.route) };
}

/** @param {Question} question @param {Route} route */
function isTornAnywhere(question, { legs, joints }) {
  const [from, to] = question.ends;
  const isLoose = isOff(question, legs[0], from) || isOff(question, legs[legs.length - 1], to);
  /* In a rectangle a shore parts the sides of its crease. */
  const beside = (/** @type {Leg} */ leg, /** @type {number[]} */ ofShore) => (leg.shore && question.field.domain ? ofShore : leg.signs);
  return (
    isLoose ||
    joints.some(({ crease, signs, place }, j) =>
      isTorn(question, [beside(legs[j], signs), beside(legs[j + 1], beyond(signs, crease))], place),
    )
  );
}

/** Whether a place is beside the implicit surface that a leg's side is. @param {Question} question @param {Leg} leg @param {number[]} place */
const isOff = (question, { signs }, place) => !question.field.domain && isTorn(question, [signs], place);

/** @param {Question} question @param {Route} route at rest @returns {Route | null} */
function finish(question, route) {
  /* A leg between two sheets may have gone. */
  if (isTornAnywhere(question, route) || hasFreeJoint(question, route.legs, route.joints)) return null;
  if (!hasShores(route)) return route;
  return isShortest(question, route) ? surveyAll(question, route) : null;
}
