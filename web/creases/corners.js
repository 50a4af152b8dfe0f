/** Corners, where creases meet: one with more than a full turn around it holds a path, as a nail holds a string. MATH.md, "Corners". */

import { meet, ROUNDING, slopeOf } from './crease.js';
import { Survey } from './cut.js';
import { ALIKE, isAtLeast, isBeyond, turnBetween } from './fan.js';
import { isInside, span } from './legs.js';

/** @typedef {import('./legs.js').Leg} Leg */
/** @typedef {import('./legs.js').Question} Question */
/** @typedef {import('../manifold/sides.js').Sides} Sides */
/** @typedef {{ place: number[], creases: number[], signs: number[], at: number }} Corner creases: that meet there; signs: of a side that it is on; at: the nearest node of a polyline */

/** A polyline passes corners that are nearer to it than this part of its length. */
const NEAR = 0.03;
/** Corners nearer to each other than this part of that are one. */
const SAME = 1e-6;
/** Creases vanish at a corner where their values are this part of how large coordinates are. */
const VANISHES = 1e4 * ROUNDING;

/**
 * Corners near a polyline around which there is more than a full turn, in its order.
 * @param {Question} question @param {Float64Array} line @returns {Corner[]}
 */
export function cornersNear(question, line) {
  const { sides, ends } = question;
  const width = ends[0].length;
  const survey = new Survey(sides, line, width, 1);
  const reach = NEAR * span(line, width);
  /** @type {(Corner & { away: number, isSaddle: boolean })[]} */
  const corners = [];
  for (let at = 1; at < survey.last; at++) {
    const near = survey.creases.filter((k) => Math.abs(survey.measured[at][k]) <= reach * survey.steepness(at, k));
    const node = survey.placeAt(at);
    const signs = survey.creases.map((k) => survey.signFrom(at, k) || 1);
    for (const pair of near.flatMap((one, i) => near.slice(i + 1).map((other) => [one, other]))) {
      const place = meet(sides, signs, pair, node);
      const away = apart(place, node);
      if (!(away <= reach) || !isInside(question, place) || ends.some((end) => apart(end, place) <= SAME * reach)) continue;
      const known = corners.find((corner) => apart(corner.place, place) <= SAME * reach);
      if (known && away < known.away) Object.assign(known, { at, away });
      const creases = known ? null : creasesAt(sides, signs, place, survey.size);
      if (!creases) continue;
      const corner = { place, creases, signs, at };
      const toNode = node.map((x, j) => x - place[j]);
      const around = turnBetween(sides, corner, signs, toNode, toNode);
      corners.push({ ...corner, away, isSaddle: around !== null && isBeyond(around.turn, 2) });
    }
  }
  return corners.filter(({ isSaddle }) => isSaddle).sort((a, b) => a.at - b.at);
}

/** @param {number[]} a @param {number[]} b */
const apart = (a, b) => span([...a, ...b], a.length);

/** The creases that meet at a place; null: the side with these signs is not there. @param {Sides} sides @param {number[]} signs @param {number[]} place @param {number} size of coordinates */
function creasesAt(sides, signs, place, size) {
  const [measured] = (sides.on(signs) ?? sides).measure(place);
  const [real] = sides.measure(place);
  const creases = [...signs.keys()].filter((k) => {
    const slope = Math.max(...slopeOf(sides, measured, k, place.length).map(Math.abs));
    return Math.abs(real[k]) <= VANISHES * size * slope;
  });
  return signs.every((sign, k) => creases.includes(k) || sign * real[k] > 0) ? creases : null;
}

/**
 * Where legs that meet at a corner would rather lead past it, on the side on which there is less than half a turn between them: directions of the creases there, from one leg to the other.
 * None: the corner holds them. null: it is not known.
 * @param {Question} question @param {Corner} corner @param {Leg} before @param {Leg} after @returns {number[][] | null}
 */
export function passing({ sides }, corner, before, after) {
  const width = corner.place.length;
  const [back, on] = [Array.from(before.line.subarray(-3 * width)), Array.from(after.line.subarray(0, 3 * width))];
  const came = tangent(corner.place, back.slice(width, 2 * width), back.slice(0, width));
  const goes = tangent(corner.place, on.slice(width, 2 * width), on.slice(2 * width));
  const right = turnBetween(sides, corner, signsAlong(sides, corner, before, came), came, goes);
  const left = turnBetween(sides, corner, signsAlong(sides, corner, after, goes), goes, came);
  if (!right || !left) return null;
  if (!isAtLeast(right.turn, 1)) return right.rays;
  return isAtLeast(left.turn, 1) ? [] : left.rays.reverse();
}

/** The direction of a parabola through three places, at the first. @param {number[]} place @param {number[]} next @param {number[]} second */
const tangent = (place, next, second) => place.map((x, j) => 4 * (next[j] - x) - (second[j] - x));

/**
 * On which side of all creases a direction from a corner leads; of those that it follows on that of a leg, which elsewhere may have been written for what it never came to.
 * @param {Sides} sides @param {Corner} corner @param {Leg} leg @param {number[]} direction
 */
function signsAlong(sides, { place, creases }, leg, direction) {
  const size = Math.sqrt(direction.reduce((sum, x) => sum + x * x, 0));
  const [real] = sides.measure(place);
  let signs = leg.signs.map((sign, k) => (creases.includes(k) ? sign : Math.sign(real[k]) || sign));
  /* What vanishes on one crease may be written by the signs of others. */
  for (let round = 0; round <= creases.length; round++) {
    const [measured] = (sides.on(signs) ?? sides).measure(place);
    const before = signs;
    signs = before.map((sign, k) => {
      if (!creases.includes(k)) return sign;
      const slope = slopeOf(sides, measured, k, place.length);
      const along = slope.reduce((sum, x, j) => sum + x * direction[j], 0);
      const steep = Math.sqrt(slope.reduce((sum, x) => sum + x * x, 0)) * size;
      return Math.abs(along) <= ALIKE * steep ? sign : Math.sign(along);
    });
    if (signs.every((sign, k) => sign === before[k])) break;
  }
  return signs;
}
