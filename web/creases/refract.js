/** Joints of a path across creases, without shores: moved until it is shortest. That is Snell's law where a density jumps, and what is straight when unfolded on a fold. */

import { dot, minus, norm, product, sumOf } from '../vector.js';
import { directions, settle } from './crease.js';
import { changes, isInside, LEG, leastBeside, lengthOf, lineOf, placesOf, roundingOf, solveAll, solveLeg } from './legs.js';
import { ahead, descend, scaled } from './linear.js';

/** @typedef {import('./legs.js').Joint} Joint */
/** @typedef {import('./legs.js').Leg} Leg */
/** @typedef {import('./legs.js').Question} Question */
/** @typedef {import('./legs.js').Route} Route */

/** Differences are taken over this part of the shorter leg; steps are at most this part of it. */
const [DIFFERENCE, FARTHEST] = [1e-4, 0.5];
/** What rounding leaves of second derivatives, over the shorter leg: where a joint may be anywhere, as between the poles of two balls, it is at rest. */
const FLAT = 1e-7;
/** So often joints are moved, and so often a step halved. */
const [MOST_STEPS, MOST_HALVINGS] = [30, 12];
/** A step that gains less, in parts of the length, is the last. */
const ENOUGH = 1e-13;
/** As is, after so many, one that gains less than this part of what legs leave open, or what rounding makes of it. */
const [PATIENCE, LOOSE] = [3, 0.01];
/** So many steps of springs come first; no spring is slacker than one of this part of the length. */
const [MOST_SPRINGS, SLACK] = [4, 0.05];
/** Joints between which a leg shrinks to this part of the length have come to a corner. */
const GONE = 1e-6;

/** Moves the joints until the path is shortest. @param {Question} question @param {Route} route @returns {Route | null} null: that leads nowhere */
export function refract(question, route) {
  if (route.joints.length === 0) return route;
  const pulled = question.field.isPlain ? pull(question, route) : route;
  /* Springs know nothing of how legs bend: where these are long they may pull away from a path that is near. */
  return shorten(question, pulled) ?? (pulled === route ? null : shorten(question, route));
}

/** As {@link refract}, by steps of Newton alone. @param {Question} question @param {Route} route @returns {Route | null} */
function shorten(question, route) {
  let now = route;
  for (let step = 0, near = 0; step < MOST_STEPS; step++) {
    const next = improve(question, now);
    if (!next) return null;
    if (next.isNear) near++;
    if (next.isLast || near === PATIENCE) return next.isMinimum ? next.route : null;
    now = next.route;
    const total = lengthOf(now.legs);
    const isGone = now.legs.some(({ length }, i) => length < GONE * total && !(route.legs[i].length < total * Math.sqrt(GONE)));
    if (isGone) {
      question.budget.lost = lineOf(now.legs, question.ends[0].length);
      return null;
    }
  }
  return null;
}

/**
 * Joints moved to where springs in place of legs, straight in space, would be at rest, each as stiff as its leg is short: near a short leg steps of Newton are short, too, and may end where it is gone,
 * though the path is longer there.
 * @param {Question} question @param {Route} route @returns {Route} as it was where legs do not hold
 */
function pull(question, route) {
  let { joints } = route;
  for (let step = 0; step < MOST_SPRINGS && joints.length > 1; step++) {
    const { ways, moved } = motion(question, joints);
    const { slope, matrix } = tension(question, { legs: route.legs, joints }, ways);
    const down = descend(matrix, slope);
    const next = down && joints.map((joint, j) => ({ ...joint, place: moved(j, down.step[j]) }));
    if (!next?.every(({ place }) => isInside(question, place))) break;
    joints = next;
  }
  const legs = joints === route.joints ? null : solveAll(question, { legs: route.legs, joints });
  return legs ? { legs, joints } : route;
}

/**
 * First and second derivatives of the energy of springs between the joints, by where these lie on their creases as far as they are straight.
 * @param {Question} question @param {Route} route @param {number[][]} ways along which each joint moves
 */
function tension(question, { legs, joints }, ways) {
  const places = placesOf(question, joints);
  const still = places[0].map(() => 0);
  const nodes = places.map((place, i) => lift(question, legs[Math.max(0, i - 1)], place, ways[i - 1] ?? still));
  const chords = legs.map((_, i) => minus(nodes[i + 1].at, nodes[i].at));
  const lengths = chords.map((chord) => norm(chord));
  const slack = SLACK * sumOf(lengths);
  const stiffness = lengths.map((length) => 1 / Math.max(length, slack));
  const slope = joints.map((_, j) =>
    dot(minus(scaled(chords[j], stiffness[j]), scaled(chords[j + 1], stiffness[j + 1])), nodes[j + 1].along),
  );
  const matrix = joints.map((_, j) =>
    joints.map((_, k) => {
      if (Math.abs(j - k) > 1) return 0;
      const stiff = j === k ? stiffness[j] + stiffness[j + 1] : -stiffness[Math.max(j, k)];
      return stiff * dot(nodes[j + 1].along, nodes[k + 1].along);
    }),
  );
  return { slope, matrix };
}

/** A place in space, and a direction there. @param {Question} question @param {Leg} leg on whose side @param {number[]} place @param {number[]} way */
function lift({ sides }, { signs }, place, way) {
  if (place.length === 3) return { at: place, along: way };
  const [jet] = sides.on(signs)?.jets(place) ?? [[]];
  return { at: jet.slice(0, 3), along: [0, 1, 2].map((k) => product(way, [jet[3 + k], jet[6 + k]])) };
}

/** How joints may move: along which directions, and where one is that has moved. @param {Question} question @param {Joint[]} joints */
function motion({ sides }, joints) {
  const ways = joints.map((joint) => directions(sides, joint, joint.place).along);
  const moved = (/** @type {number} */ j, /** @type {number} */ by) => settle(sides, joints[j], ahead(joints[j].place, ways[j], by));
  return { ways, moved };
}

/**
 * One step of Newton for the joints; null: none makes the path shorter.
 * @param {Question} question @param {Route} route
 * @returns {{ route: Route, isLast: boolean, isNear: boolean, isMinimum: boolean } | null} isLast: the step promised next to nothing; isNear: or less than legs and joints are exact
 */
function improve(question, route) {
  const { legs, joints } = route;
  const ways = motion(question, joints);
  const least = leastBeside(route, question.sides.scale);
  const { slopes, matrix } = differentiate(question, route, least, ways);
  const down = descend(matrix, slopes);
  if (!down) return null;
  const gain = -0.5 * product(down.step, slopes);
  const before = lengthOf(legs);
  const isNear = gain <= LOOSE * (question.budget.finest ?? 0) * before + roundingOf(route);
  let factor = Math.min(1, ...down.step.map((x, j) => (FARTHEST * least[j]) / Math.abs(x)));
  for (let halving = 0; halving < MOST_HALVINGS; halving++, factor /= 2) {
    const tried = joints.map((joint, j) => ({ ...joint, place: ways.moved(j, factor * down.step[j]) }));
    const solved = tried.every(({ place }) => isInside(question, place)) ? solveAll(question, { legs, joints: tried }) : null;
    if (solved && lengthOf(solved) <= before * (1 + ENOUGH))
      return { route: { legs: solved, joints: tried }, isLast: gain <= ENOUGH * before, isNear, isMinimum: !down.shifted };
  }
  return isNear ? { route, isLast: true, isNear, isMinimum: !down.shifted } : null;
}

/** First and second derivatives of the length by where the joints lie on their creases. @param {Question} question @param {Route} route @param {number[]} least how long the shorter leg beside each joint is @param {ReturnType<typeof motion>} motion of the joints */
function differentiate(question, { legs, joints }, least, { ways, moved }) {
  const { slopes, matrix } = changes(
    legs,
    placesOf(question, joints),
    ways,
    least.map((length) => DIFFERENCE * length),
    (j, by) => {
      const place = moved(j, by);
      return { place, along: directions(question.sides, joints[j], place).along };
    },
    (i, from, to) => solveLeg(question, legs[i], from, to, LEG),
  );
  for (const [j, length] of least.entries()) matrix[j][j] += FLAT / length;
  return { slopes, matrix };
}
