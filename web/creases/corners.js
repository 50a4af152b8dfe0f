/** Corners, where creases meet: one past which all ways are longer holds a path, as a nail holds a string. MATH.md, "Corners". */

import { largest, product } from '../vector.js';
import { directions, meet, ROUNDING, slopeOf } from './crease.js';
import { Survey } from './cut.js';
import { ALIKE, isBeyond, turnBetween } from './fan.js';
import { isInside, span } from './legs.js';
import { apart, sizeBy, steepnessBy } from './linear.js';

/** @typedef {import('./legs.js').Leg} Leg */
/** @typedef {import('./legs.js').Question} Question */
/** @typedef {import('../manifold/sides.js').Sides} Sides */
/** @typedef {{ place: number[], creases: number[], signs: number[], at: number }} Corner creases: that meet there; signs: of a side that it is on; at: the nearest node of a polyline */

/** Corners nearer to each other than this part of that are one. */
const SAME = 1e-6;
/** So many nodes on from the nearest one the others lie that are tried. */
const BESIDE = [0, -2, 2, -4, 4];
/** Creases vanish at a corner where their values are this part of how large coordinates are. */
const VANISHES = 1e4 * ROUNDING;

/**
 * Corners near a polyline that may hold a path, in its order: where length is that of space, those around which there is more than a full turn.
 * @param {Question} question @param {Float64Array} line @param {number} near no farther than this part of its length @returns {Corner[]}
 */
export function cornersNear(question, line, near) {
  const { field, sides, ends } = question;
  const survey = new Survey(sides, line, 1);
  const reach = near * span(line, sides.scale);
  /** @type {Corner[]} */
  const corners = [];
  /** From where pairs of creases were followed to where they meet. @type {Map<string, number[]>} */
  const tried = new Map();
  for (let at = 1; at < survey.last; at++) {
    const beside = survey.creases.filter((k) => Math.abs(survey.valueAt(at, k)) <= reach * survey.steepness(at, k));
    const node = survey.placeAt(at);
    const signs = survey.creases.map((k) => survey.signFrom(at, k) || 1);
    for (const pair of beside.flatMap((one, i) => beside.slice(i + 1).map((other) => [one, other]))) {
      if (!(stepToBoth(survey, at, pair) <= 2 * reach)) continue;
      const key = `${pair} ${signs}`;
      const before = tried.get(key);
      if (before && apart(before, node, sides.scale) <= 2 * reach) continue;
      tried.set(key, node);
      const place = meet(sides, signs, pair, node);
      if (
        !(apart(place, node, sides.scale) <= 3 * reach) ||
        !isInside(question, place) ||
        ends.some((end) => apart(end, place, sides.scale) <= SAME * reach)
      )
        continue;
      const known = corners.find((corner) => apart(corner.place, place, sides.scale) <= SAME * reach);
      const creases = known ? null : creasesAt(sides, signs, place, survey.size);
      if (!creases) continue;
      corners.push({ place, creases, signs, at });
    }
  }
  return corners
    .map((corner) => ({ corner, ...nearest(survey, corner.place) }))
    .filter(({ corner, away }) => away <= reach && (!field.isPlain || hasMore(survey, corner)))
    .sort((a, b) => a.at - b.at)
    .map(({ corner, at }) => ({ ...corner, at }));
}

/** Whether there is more than a full turn around a corner, from the direction of a node near by, or of an end, that lies on the side which that tells. @param {Survey} survey @param {Corner} corner */
function hasMore(survey, corner) {
  const { sides, last } = survey;
  const nodes = [...BESIDE.map((by) => Math.min(Math.max(corner.at + by, 0), last)), 0, last];
  for (const at of nodes) {
    const direction = survey.placeAt(at).map((x, j) => x - corner.place[j]);
    const around = turnBetween(sides, corner, signsAlong(sides, corner, corner.signs, direction), direction);
    if (around) return isBeyond(around.turn, 2);
  }
  return false;
}

/** The inner node of a polyline nearest to a place, and how far away that is. @param {Survey} survey @param {number[]} place */
function nearest(survey, place) {
  let best = { at: 1, away: Infinity };
  for (let at = 1; at < survey.last; at++) {
    const away = apart(survey.placeAt(at), place, survey.sides.scale);
    if (away < best.away) best = { at, away };
  }
  return best;
}

/** How long the shortest step is from a node to where two creases vanish, as far as their slopes tell. @param {Survey} survey @param {number} at @param {number[]} pair */
function stepToBoth(survey, at, pair) {
  const lengthen = (/** @type {number[]} */ slope) => slope.map((x, j) => x / survey.sides.scale[j]);
  const [p, q] = pair.map((k) => lengthen(survey.slopes(at, k)));
  const [a, b] = pair.map((k) => survey.valueAt(at, k));
  const [pp, pq, qq] = [
    [p, p],
    [p, q],
    [q, q],
  ].map(([one, other]) => product(one, other));
  return Math.sqrt((qq * a * a - 2 * pq * a * b + pp * b * b) / (pp * qq - pq * pq));
}

/** The creases that meet at a place; null: the side with these signs is not there. @param {Sides} sides @param {number[]} signs @param {number[]} place @param {number} size of coordinates */
function creasesAt(sides, signs, place, size) {
  const [measured] = (sides.on(signs) ?? sides).measure(place);
  const [real] = sides.measure(place);
  const creases = [...signs.keys()].filter((k) => {
    const slope = largest(slopeOf(sides, measured, k));
    return Math.abs(real[k]) <= VANISHES * size * slope;
  });
  return signs.every((sign, k) => creases.includes(k) || sign * real[k] > 0) ? creases : null;
}

/**
 * Whether a corner holds the legs that meet there. Else they would rather lead past it, on a side on which that is shorter, as where there is less than half a turn between them: over creases in
 * these directions, from one leg to the other. null: it is not known.
 * @param {Question} question @param {Corner} corner @param {Leg} before @param {Leg} after @returns {{ isHeld: boolean, rays: number[][] } | null}
 */
export function passing({ sides }, corner, before, after) {
  const width = corner.place.length;
  const [back, on] = [Array.from(before.line.subarray(-3 * width)), Array.from(after.line.subarray(0, 3 * width))];
  const came = alongShore(sides, corner, before, -1) ?? tangent(corner.place, back.slice(width, 2 * width), back.slice(0, width));
  const goes = alongShore(sides, corner, after, 1) ?? tangent(corner.place, on.slice(width, 2 * width), on.slice(2 * width));
  const [first, second] = [signsAlong(sides, corner, before.signs, came), signsAlong(sides, corner, after.signs, goes)];
  const right = turnBetween(sides, corner, first, came, goes, second);
  const left = turnBetween(sides, corner, second, goes, came, first);
  return right && left && { isHeld: right.isHeld && left.isHeld, rays: right.isHeld ? left.rays.reverse() : right.rays };
}

/** The direction of the crease that a leg follows, from a corner on; null: it follows none. @param {Sides} sides @param {Corner} corner @param {Leg} leg @param {number} way 1: it begins there; −1: it ends there */
function alongShore(sides, { place }, { shore, signs }, way) {
  return shore && directions(sides, { crease: shore.crease, signs }, place).along.map((x) => way * shore.sense * x);
}

/** The direction of a parabola through three places, at the first. @param {number[]} place @param {number[]} next @param {number[]} second */
const tangent = (place, next, second) => place.map((x, j) => 4 * (next[j] - x) - (second[j] - x));

/**
 * On which side of all creases a direction from a corner leads; of those that it follows on that of a leg, which elsewhere may have been written for what it never came to.
 * @param {Sides} sides @param {Corner} corner @param {number[]} own of a leg, or a node @param {number[]} direction
 */
function signsAlong(sides, { place, creases }, own, direction) {
  const size = sizeBy(direction, sides.scale);
  const [real] = sides.measure(place);
  let signs = own.map((sign, k) => (creases.includes(k) ? sign : Math.sign(real[k]) || sign));
  /* What vanishes on one crease may be written by the signs of others. */
  for (let round = 0; round <= creases.length; round++) {
    const [measured] = (sides.on(signs) ?? sides).measure(place);
    const before = signs;
    signs = before.map((sign, k) => {
      if (!creases.includes(k)) return sign;
      const slope = slopeOf(sides, measured, k);
      const along = product(slope, direction);
      return Math.abs(along) <= ALIKE * (steepnessBy(slope, sides.scale) * size) ? sign : Math.sign(along);
    });
    if (signs.every((sign, k) => sign === before[k])) break;
  }
  return signs;
}
