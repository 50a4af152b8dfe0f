/** Polylines cut where they cross creases, or follow them: which legs a path has. */

import { divide } from '../search/join.js';
import { minus } from '../vector.js';
import { beyond, directions, ROUNDING } from './crease.js';
import { middleOf, span } from './legs.js';
import { inner } from './linear.js';
import { isBent } from './same.js';

/** @typedef {import('./legs.js').Leg} Leg */
/** @typedef {import('./legs.js').Route} Route */
/** @typedef {import('../manifold/sides.js').Sides} Sides */
/** @typedef {{ crease: number, from: number, to: number, sense: number }} Run of a polyline along a crease */

/** Each chord of a polyline is looked at in so many parts; there may be so many joints. */
const [PARTS, MOST_JOINTS] = [4, 12];
/** Events nearer to each other than this, in parts of a chord's, are one. */
const TOGETHER = 1e-6;
/** The chords at a leg's ends are halved so often towards these: beyond a corner near by a leg may leave its side just before it ends on another crease. */
const HALVINGS = 10;
/** A polyline follows a crease if it is near it over this part of its length, or crosses it twice there. */
const LONG = 0.08;

/** @type {number[]} */
const NONE = [];

/** What a polyline passes, looked at in parts of its chords. */
export class Survey {
  /** Of each place, what vanishes on each crease, then its derivatives. @type {Float64Array} */ #measured;

  /** @param {Sides} sides @param {Float64Array} line @param {number} parts of each chord */
  constructor(sides, line, parts) {
    const width = sides.scale.length;
    this.sides = sides;
    this.width = width;
    this.places = divide(line, width, parts);
    this.last = this.places.length / width - 1;
    this.#measured = sides.measureAll(this.places);
    this.size = Math.max(...line.map(Math.abs));
    this.count = sides.count;
    this.creases = Array.from({ length: sides.count }, (_, k) => k);
  }

  /** What vanishes on a crease. @param {number} i @param {number} k */
  valueAt(i, k) {
    return this.#measured[i * this.count * (1 + this.width) + k];
  }

  /** Its derivative by a variable. @param {number} i @param {number} k @param {number} j */
  slopeBy(i, k, j) {
    return this.#measured[(i * (1 + this.width) + 1 + j) * this.count + k];
  }

  /** @param {number} i @param {number} k */
  slopes(i, k) {
    return Array.from({ length: this.width }, (_, j) => this.slopeBy(i, k, j));
  }

  /** How steeply a crease's function rises. @param {number} i @param {number} k */
  steepness(i, k) {
    let squared = 0;
    for (let j = 0; j < this.width; j++) squared += (this.slopeBy(i, k, j) / this.sides.scale[j]) ** 2;
    return Math.sqrt(squared);
  }

  /** On which side of a crease a place is; 0: on it. @param {number} i @param {number} k */
  signAt(i, k) {
    const value = this.valueAt(i, k);
    let slope = 0;
    for (let j = 0; j < this.width; j++) slope = Math.max(slope, Math.abs(this.slopeBy(i, k, j)));
    return Math.abs(value) > ROUNDING * this.size * slope ? Math.sign(value) : 0;
  }

  /** The first sign from a place on; 0: none. @param {number} i @param {number} k */
  signFrom(i, k) {
    for (i = Math.ceil(i); i <= this.last; i++) if (this.signAt(i, k)) return this.signAt(i, k);
    return 0;
  }

  /** Which way the polyline follows a crease. @param {number} crease @param {number[]} signs @param {number} from @param {number} to */
  senseOf(crease, signs, from, to) {
    let sum = 0;
    for (let i = from; i < to; i++) {
      const [here, next] = [this.placeAt(i), this.placeAt(i + 1)];
      const { along } = directions(this.sides, { crease, signs }, here, this.slopes(i, crease));
      sum += inner(along, minus(next, here), this.sides.scale);
    }
    return Math.sign(sum) || 1;
  }

  /** @param {number} at in parts */
  placeAt(at) {
    const i = Math.min(Math.floor(at), this.last - 1);
    const place = [];
    for (let k = this.width * i; k < this.width * (i + 1); k++)
      place.push(this.places[k] + (at - i) * (this.places[k + this.width] - this.places[k]));
    return place;
  }
}

/**
 * Cuts a polyline where it crosses creases at which the surface, or what measures length, bends.
 * @param {Sides} sides @param {Float64Array} line @param {{ parts?: number, near?: number, lead?: number, most?: number }} [how] parts of each chord; near: where it is nearer to a crease than this part of its length, that is a leg of its own; lead: what begins beside one comes to it over this part of that; most: joints
 * @returns {Route | null}
 */
export function cut(sides, line, { parts = PARTS, near = 0, lead = 0, most = MOST_JOINTS } = {}) {
  const survey = new Survey(sides, line, parts);
  const { last, creases } = survey;
  const runs = near ? runsOf(survey, near, lead) : [];
  const signs = creases.map((k) => survey.signFrom(0, k) || 1);
  const events = [
    ...crossings(survey, signs).filter(({ at }) => !runs.some(({ from, to }) => at > from - 1 && at < to + 1)),
    ...runs.flatMap((run) => [
      { at: run.from, crease: run.crease, run, isEnd: false },
      { at: run.to, crease: run.crease, run, isEnd: true },
    ]),
  ].sort((a, b) => a.at - b.at);
  /** @type {Route} */
  const route = { legs: [], joints: [] };
  const begin = (/** @type {number} */ at, /** @type {number[]} */ place, /** @type {import('./shores.js').Shore | null} */ shore) => ({
    signs: [...signs],
    line: [...place],
    at,
    shore,
  });
  let leg = begin(0, survey.placeAt(0), null);
  const finish = (/** @type {number} */ at, /** @type {number[]} */ place) => {
    for (let i = Math.floor(leg.at) + 1; i < at; i++) leg.line.push(...survey.placeAt(i));
    leg.line.push(...place);
    route.legs.push({ signs: leg.signs, line: Float64Array.from(leg.line), length: 0, shore: leg.shore });
  };
  for (let e = 0; e < events.length; e++) {
    const { at, crease, run, isEnd } = events[e];
    const before = [...signs];
    const place = survey.placeAt(at);
    if (run) {
      if (isEnd) for (const k of creases) signs[k] = survey.signFrom(run.to + 1, k) || signs[k];
      if (at === 0) leg.shore = { crease, sense: run.sense, isFold: false };
      if (at === 0 || at === last) continue;
      finish(at, place);
      route.joints.push({ crease, signs: isEnd ? [...signs] : before, place });
      leg = begin(at, place, isEnd ? null : { crease, sense: run.sense, isFold: false });
      continue;
    }
    signs[crease] *= -1;
    while (e + 1 < events.length && !events[e + 1].run && events[e + 1].at - at < TOGETHER) signs[events[++e].crease] *= -1;
    if (at < TOGETHER) leg.signs = [...signs];
    if (at < TOGETHER || at > last - TOGETHER) continue;
    /* Higher derivatives alone may jump: then the sides part beyond it. */
    const later = survey.placeAt(0.5 * (at + (events[e + 1]?.at ?? last)));
    const bends = [place, later].map((there) => isBent(sides, before, signs, there));
    if (bends.includes(null)) return null;
    if (!bends.includes(true)) continue;
    finish(at, place);
    route.joints.push({ crease, signs: before, place });
    leg = begin(at, place, null);
  }
  finish(last, survey.placeAt(last));
  return route.joints.length > most ? null : route;
}

/** Where a polyline comes to the other side of a crease. @param {Survey} survey @param {number[]} signs at its beginning @returns {{ at: number, crease: number, run?: Run, isEnd?: boolean }[]} */
function crossings(survey, signs) {
  const { last } = survey;
  const now = [...signs];
  const events = [];
  for (let i = 0; i <= last; i++)
    for (const crease of survey.creases) {
      const sign = survey.signAt(i, crease);
      if (sign && sign === now[crease] && i > 0 && i < last)
        for (const at of dips(survey.valueAt(i - 1, crease), survey.valueAt(i, crease), survey.valueAt(i + 1, crease)))
          events.push({ at: i + at, crease });
      if (!sign || sign === now[crease]) continue;
      now[crease] = sign;
      const [before, after] = [survey.valueAt(i - 1, crease), survey.valueAt(i, crease)];
      events.push({ at: i - 1 + Math.min(Math.max(before / (before - after), 0), 1), crease });
    }
  return events;
}

/** Where a polyline follows creases, one at a time. @param {Survey} survey @param {number} near @param {number} lead @returns {Run[]} */
function runsOf(survey, near, lead) {
  const { sides, places, width, last } = survey;
  const total = span(places, sides.scale);
  /** @type {(Run & { length: number })[]} */
  const runs = [];
  for (const crease of survey.creases)
    for (let i = 0; i <= last; i++) {
      const from = i;
      while (i <= last && Math.abs(survey.valueAt(i, crease)) <= near * total * survey.steepness(i, crease)) i++;
      if (i - from < 2) continue;
      const part = places.subarray(width * from, width * i);
      const length = span(part, sides.scale);
      const changes = Array.from(
        { length: i - 1 - from },
        (_, j) => survey.valueAt(from + j, crease) * survey.valueAt(from + j + 1, crease) < 0,
      );
      if (length < LONG * total && changes.filter(Boolean).length < 2) continue;
      /* What begins beside a crease, not on it, comes to it: where it is crossed, or later. */
      const by = lead * (i - 1 - from);
      const [first, final] = [changes.indexOf(true), changes.lastIndexOf(true)];
      const [start, end] = [
        from === 0 && survey.signAt(0, crease) ? (first < 0 ? by : Math.min(by, first + 0.5)) : from,
        i > last && survey.signAt(last, crease) ? (final < 0 ? last - by : Math.max(last - by, from + final + 0.5)) : i - 1,
      ];
      const signs = survey.creases.map((k) => survey.signFrom(from, k) || 1);
      const middle = Math.floor((from + i) / 2);
      if (isBent(sides, signs, beyond(signs, crease), survey.placeAt(middle)))
        runs.push({ crease, from: start, to: end, length, sense: survey.senseOf(crease, signs, from, i - 1) });
    }
  runs.sort((a, b) => b.length - a.length);
  const kept = runs.filter((run, i) => !runs.slice(0, i).some((longer) => run.from <= longer.to && run.to >= longer.from));
  return kept.sort((a, b) => a.from - b.from);
}

/** Where the parabola through three numbers of one sign, side by side, has the other: from and to, from the middle one, or nothing. @param {number} before @param {number} here @param {number} after */
function dips(before, here, after) {
  const bend = 0.5 * (before - 2 * here + after);
  const slope = 0.5 * (after - before);
  const squared = slope * slope - 4 * bend * here;
  if (!(before * here > 0 && here * after > 0 && bend * here > 0 && squared > 0 && Math.abs(slope) < 2 * Math.abs(bend))) return NONE;
  const reach = Math.sqrt(squared);
  const roots = [(-slope - reach) / (2 * bend), (-slope + reach) / (2 * bend)].sort((a, b) => a - b);
  /* Between two places it is seen from the nearer one alone. */
  const middle = -slope / (2 * bend);
  return middle >= -0.5 && middle < 0.5 ? roots : NONE;
}

/** A polyline with more nodes in place of its first and its last chord, ever nearer to its ends, by what interpolates six nodes: chords dip into a shore that what they stand for is tangent to. @param {Float64Array} line @param {number} width */
function closeToEnds(line, width) {
  const count = line.length / width - 1;
  const used = Array.from({ length: Math.min(6, count + 1) }, (_, k) => k);
  const nodeAt = (/** @type {number} */ at) => {
    const first = Math.max(0, Math.min(Math.floor(at) - 2, count + 1 - used.length));
    const weights = used.map((k) => used.reduce((product, m) => (m === k ? product : (product * (at - first - m)) / (k - m)), 1));
    return Array.from({ length: width }, (_, j) => weights.reduce((sum, weight, k) => sum + weight * line[width * (first + k) + j], 0));
  };
  const near = Array.from({ length: HALVINGS }, (_, k) => 0.5 ** (HALVINGS - k));
  const [first, last] = [near, near.map((x) => count - x).reverse()].map((all) => all.flatMap(nodeAt));
  const [begin, end] = [width, line.length - width];
  return Float64Array.from([...line.subarray(0, begin), ...first, ...line.subarray(begin, end), ...last, ...line.subarray(end)]);
}

/**
 * A leg in the parts that lie on one side of all creases each; null: it lies on one side, its own.
 * @param {Sides} sides @param {Leg} leg @returns {Route | null}
 */
export function leavings(sides, leg) {
  const width = sides.scale.length;
  const route = cut(sides, closeToEnds(leg.line, width), { parts: 1 });
  const isOwn = (/** @type {Leg} */ { signs, line }) => isBent(sides, leg.signs, signs, middleOf(line, width)) === false;
  if (route?.legs.length === 1 && isOwn(route.legs[0])) return null;
  return route && { ...route, legs: route.legs.map((part) => (isOwn(part) ? { ...part, signs: leg.signs } : part)) };
}
