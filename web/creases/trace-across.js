/** Traces across creases: geodesics on smooth sides of the surface, from each crease to the next, one after the other. MATH.md, "Traces across creases". */

import { emptyPath } from '../runtime/result.js';
import { CONVERGED, ITERATION_LIMIT, NOT_FINITE, SINGULAR_METRIC, TOLERANCE_NOT_MET } from '../runtime/status.js';
import { diagonalOf, minus, product, sumOf } from '../vector.js';
import { bend } from './bend.js';
import { beyond, directions, isTorn, settle, slopeOf } from './crease.js';
import { inner, sizeBy, sizeOf, steepnessBy } from './linear.js';
import { endOf, look, vanishes } from './meeting.js';
import { isSame } from './same.js';
import { traceOn, velocityOn } from './tangent.js';

/** @typedef {import('./bend.js').Tracing} Tracing */
/** @typedef {import('./meeting.js').Here} Here */
/** @typedef {import('../runtime/result.js').RawPath} RawPath */
/** @typedef {import('../manifold/sides.js').Side} Side */
/** @typedef {{ side: Side, here: Here, raw: RawPath }} Leg on one side, as it was traced */
/** @typedef {import('./bend.js').Spread} Spread */
/** @typedef {{ place: number[], direction: number[], length: number, reach: number }} Asked reach: how far that is in the coordinates, about */
/** @typedef {{ points: number, tolerance: number }} Wanted */

/** An error of this part of the length says nothing. */
const UNKNOWN = 0.01;
/** Two ways of one length from a place end no farther apart than so many times that. */
const FARTHEST = 2;
/** After so many creases, or steps, a trace ends. */
const [MOST_CREASES, MOST_STEPS] = [1000, 200_000];
/** Where a side ends beyond a crease, so many times half as far is looked. */
const MOST_HALVINGS = 12;
/** Creases nearer to a place than this part of the coordinates meet there; of these, cosines of directions that are one. */
const [NEAR, ALIKE] = [1e-9, 1e-9];
/** A crease is where a leg came to it, to this part of the coordinates. */
const AWAY = 1e-7;
/** A trace begins where so many creases meet, at most. */
const MOST_MEETING = 5;
/** Directions are along a crease whose sines are less. */
const ALONG = 1e-7;

/**
 * The geodesic from a place on the surface in a direction.
 * @param {import('../search/routes.js').Field} field @param {import('../manifold/sides.js').Sides} sides @param {Asked} asked @param {Wanted} wanted
 * @returns {RawPath | null} null: nothing tells on which side it begins
 */
export function traceAcross(field, sides, { place, direction, length, reach }, { points, tolerance }) {
  sides.begin();
  const { domain, box } = field;
  const span = domain ? Math.max(...minus(domain.upper, domain.lower)) : box ? diagonalOf(box) : reach;
  const tracing = { field, sides, tolerance, size: Math.max(...place.map(Math.abs), reach) };
  const here = enter(tracing, place, direction);
  if (!here) return null;
  const { legs, status, spread, smooth, hasCrossed } = walk(tracing, here, length, length * Math.min(1, span / reach || 1));
  const [first] = legs;
  if (!first || status < CONVERGED) return status < CONVERGED ? emptyPath(status) : null;
  if (!hasCrossed) return traceOn(tracing, first.side, place, direction, length, points);
  const total = sumOf(legs.map(({ raw }) => raw.length));
  const drawn = sample(tracing, legs, total, points);
  if (!drawn) return emptyPath(NOT_FINITE);
  /* An end of which nothing is known is none. */
  const final = status === CONVERGED && !(spread.position <= UNKNOWN * length) ? TOLERANCE_NOT_MET : status;
  return {
    ...emptyPath(final),
    length: status === CONVERGED ? length : total,
    lengthError:
      (spread.position <= FARTHEST * total ? spread.position : FARTHEST * total) + (status === TOLERANCE_NOT_MET ? length - total : 0),
    iterations: sumOf(legs.map(({ raw }) => raw.iterations)),
    touchesBoundary: legs.some(({ raw }) => raw.touchesBoundary),
    conjugate: (smooth > first.raw.length && traceOn(tracing, first.side, place, direction, smooth)?.conjugate) || first.raw.conjugate,
    ...drawn,
  };
}

/** Whether a trace comes to another side of a crease, or to where a floor changes. @param {import('../manifold/sides.js').Sides} sides @param {RawPath} path in the rectangle */
export function changesSides(sides, { parameters }) {
  const places = parameters ?? [];
  const [signs, floors] = [sides.measure(places).map((seen) => seen.slice(0, sides.count).map(Math.sign)), sides.floors(places)];
  return [signs, floors].some((lists) => lists.some((list) => list.some((x, k) => x !== lists[0][k])));
}

/** On which side a trace begins: on a crease, on the one that it leads to. @param {Tracing} tracing @param {number[]} place @param {number[]} direction @returns {Here | null} null: on none, or on several */
function enter(tracing, place, direction) {
  const { sides } = tracing;
  const [measured] = sides.measure(place);
  const creases = Array.from({ length: sides.count }, (_, k) => k);
  const on = creases.filter((k) => vanishes(tracing, measured, k));
  if (on.length > MOST_MEETING) return null;
  const known = creases.map((k) => Math.sign(measured[k]) || 1);
  /** @type {{ signs: number[], tangent: number }[]} */
  const open = [];
  for (let choice = 0; choice < 2 ** on.length; choice++) {
    const signs = known.map((sign, k) => (on.includes(k) ? ((choice >> on.indexOf(k)) & 1 ? -1 : 1) : sign));
    const velocity = velocityOn(tracing, signs, place, direction);
    if (!velocity || !on.every((k) => leads(tracing, signs, place, velocity, k))) continue;
    open.push({ signs, tangent: inner(velocity, direction, sides.scale) / sizeBy(velocity, sides.scale) });
  }
  open.sort((a, b) => b.tangent - a.tangent);
  const [best, ...others] = open;
  const isOne =
    best && others.every(({ signs, tangent }) => tangent < best.tangent * (1 - ALONG) || isSame(sides, best.signs, signs, place));
  return isOne ? { place, velocity: direction, signs: best.signs, on } : null;
}

/** Whether a velocity leads from a crease into a side; along it, if both sides are the same. @param {Tracing} tracing @param {number[]} signs @param {number[]} place @param {number[]} velocity @param {number} crease */
function leads({ sides }, signs, place, velocity, crease) {
  const measured = sides.on(signs)?.measure(place)[0];
  if (!measured) return false;
  const slope = slopeOf(sides, measured, crease);
  const into = signs[crease] * product(slope, velocity);
  if (Math.abs(into) > ALONG * steepnessBy(slope, sides.scale) * sizeBy(velocity, sides.scale)) return into > 0;
  return isSame(sides, signs, beyond(signs, crease), place);
}

/**
 * Legs, from crease to crease, and how the last one ended.
 * @param {Tracing} tracing @param {Here} here @param {number} length @param {number} most length of one, which is looked at in so many points
 * @returns {{ legs: Leg[], status: number, spread: Spread, smooth: number, hasCrossed: boolean }} smooth: length before the first crease
 */
function walk(tracing, here, length, most) {
  /** @type {Leg[]} */
  const legs = [];
  /** @type {Spread} */
  let spread = { position: 0, turn: 0 };
  let [rest, smooth, crossed, steps] = [length, 0, 0, 0];
  const ended = (/** @type {number} */ status) => ({ legs, status, spread, smooth, hasCrossed: crossed > 0 });
  while (crossed < MOST_CREASES && steps < MOST_STEPS) {
    const side = tracing.sides.on(here.signs);
    const { raw, crease } = stride(tracing, side, here, Math.min(rest, most));
    /* What ends beyond a crease says nothing of the way to it. */
    if (!side || !raw?.end || raw.status < CONVERGED) return ended(crossed > 0 || !raw ? TOLERANCE_NOT_MET : raw.status);
    legs.push({ side, here, raw });
    spread = carry(spread, raw);
    rest -= raw.length;
    if (crossed === 0) smooth += raw.length;
    steps += raw.iterations;
    if (crease === null && (rest <= 0 || raw.status !== CONVERGED)) return ended(raw.status);
    const end = { ...here, place: endOf(raw), velocity: raw.end.velocity };
    if (crease !== null) crossed++;
    const next = crease === null ? { here: { ...end, on: [] }, spread } : cross(tracing, end, crease, spread);
    if (!next) return ended(TOLERANCE_NOT_MET);
    ({ here, spread } = next);
  }
  return ended(ITERATION_LIMIT);
}

/**
 * A leg: to the first crease, or as far as it goes.
 * @param {Tracing} tracing @param {Side | null} side @param {Here} here @param {number} length at most
 * @returns {{ raw: RawPath | null, crease: number | null }} crease: −1: it is not clear what is met; null: none is
 */
function stride(tracing, side, here, length) {
  /** @type {RawPath | null} */
  let failed = side && emptyPath(SINGULAR_METRIC);
  for (let halving = 0; side && halving <= MOST_HALVINGS; halving++) {
    const { raw, met } = look(tracing, side, here, length * 0.5 ** halving);
    if (met) return { raw: traceOn(tracing, side, here.place, here.velocity, met.at), crease: met.crease };
    if (raw && raw.status >= CONVERGED) return { raw, crease: null };
    if (halving === 0 && raw) failed = raw;
  }
  return { raw: failed, crease: null };
}

/** Errors, carried along a leg, which adds its own. @param {Spread} spread @param {RawPath} raw @returns {Spread} */
function carry({ position, turn }, { length, lengthError, end }) {
  const { field = 0, slope = 1, turn: own = 0 } = end ?? {};
  const growth = length > 0 ? Math.max(1, Math.abs(field) / length, Math.abs(slope)) : 1;
  const bent = length > 0 ? ((growth - 1) * position) / length : 0;
  return { position: growth * (position + turn * length) + lengthError, turn: growth * (turn + bent) + own };
}

/** Beyond a crease; null: more than one bends the surface there, or it is not clear what becomes of the path. @param {Tracing} tracing @param {Here} here @param {number} crease @param {Spread} spread @returns {{ here: Here, spread: Spread } | null} */
function cross(tracing, { place: end, velocity, signs }, crease, spread) {
  const { sides } = tracing;
  if (crease < 0) return null;
  const place = settle(sides, { crease, signs }, end);
  /* What vanishes jumps there, as atan2 does: Newton's method led elsewhere. */
  if (!(sizeOf(minus(place, end)) <= AWAY * tracing.size)) return null;
  const measured = sides.on(signs)?.measure(place)[0] ?? [];
  const on = signs.flatMap((_, k) => (k === crease || vanishes(tracing, measured, k, NEAR) ? [k] : []));
  const alike = likeness(tracing, on, crease, signs, place);
  const flipped = signs.map((sign, k) => (alike.get(k) ? -signs[crease] * (alike.get(k) ?? 1) : sign));
  const after = settled(tracing, flipped, on, place);
  const others = on.filter((k) => !alike.get(k));
  if (!others.every((k) => [signs, after].every((side) => isSame(sides, side, beyond(side, k), place)))) return null;
  if (isTorn(tracing, [signs, after], place, tracing.size)) return null;
  const bent = isSame(sides, signs, after, place)
    ? { velocity, isReflected: false, spread }
    : bend(tracing, crease, signs, after, place, velocity, spread);
  if (!bent) return null;
  const final = bent.isReflected ? signs : after;
  const there = sides.on(final)?.measure(place)[0];
  const rises = (/** @type {number} */ k) => (there ? Math.sign(product(slopeOf(sides, there, k), bent.velocity)) : 0);
  const next = final.map((sign, k) => (others.includes(k) ? rises(k) || sign : sign));
  if (!on.every((k) => !alike.get(k) || rises(k) === next[k])) return null;
  return { here: { place, velocity: bent.velocity, signs: next, on }, spread: bent.spread };
}

/** Which of the creases at a place are one curve: 1 or −1 for those, as what vanishes on them rises to the same side or to the other. @param {Tracing} tracing @param {number[]} on @param {number} crease @param {number[]} signs @param {number[]} place */
function likeness({ sides }, on, crease, signs, place) {
  const one = directions(sides, { crease, signs }, place);
  return new Map(
    on.map((k) => {
      const other = k === crease ? one : directions(sides, { crease: k, signs }, place);
      const isOne = Math.abs(inner(one.along, other.along, sides.scale)) >= 1 - ALIKE;
      return [k, isOne ? Math.sign(inner(one.across, other.across, sides.scale)) : 0];
    }),
  );
}

/** Signs as they are beyond a crease, where what vanishes on others may have jumped. @param {Tracing} tracing @param {number[]} signs @param {number[]} on creases at the place @param {number[]} place */
function settled({ sides }, signs, on, place) {
  for (let round = 0; round <= signs.length; round++) {
    const measured = sides.on(signs)?.measure(place)[0] ?? [];
    const next = signs.map((sign, k) => (on.includes(k) ? sign : Math.sign(measured[k]) || sign));
    if (next.every((sign, k) => sign === signs[k])) break;
    signs = next;
  }
  return signs;
}

/** Points equally spaced over all legs; null: a part of one cannot be traced again. @param {Tracing} tracing @param {Leg[]} legs @param {number} total @param {number} points @returns {{ points: Float64Array, parameters: Float64Array | null } | null} */
function sample(tracing, legs, total, points) {
  const step = total / (points + 1);
  /** @type {number[][]} */
  const written = [[], []];
  let [next, behind] = [0, 0];
  for (const [i, leg] of legs.entries()) {
    const { length } = leg.raw;
    const isLast = i === legs.length - 1;
    const last = isLast ? points + 1 : Math.min(points, Math.floor((behind + length) / step));
    const offset = Math.min(Math.max(0, next * step - behind), length);
    if (last >= next) {
      const parts = spaced(tracing, leg, offset, isLast ? length - offset : (last - next) * step, last - next);
      if (!parts) return null;
      for (const part of parts) for (const [which, numbers] of written.entries()) for (const x of part[which]) numbers.push(x);
    }
    next = Math.max(next, last + 1);
    behind += length;
  }
  return { points: Float64Array.from(written[0]), parameters: tracing.field.domain && Float64Array.from(written[1]) };
}

/**
 * A place on a leg, and so many more, equally spaced over a length from there: x y z and u v of each.
 * @param {Tracing} tracing @param {Leg} leg @param {number} offset @param {number} length @param {number} count @returns {number[][][] | null}
 */
function spaced(tracing, { side, here }, offset, length, count) {
  const first = traceOn(tracing, side, here.place, here.velocity, offset);
  if (!first?.end) return null;
  const rest = count > 0 ? traceOn(tracing, side, endOf(first), first.end.velocity, length, Math.max(1, count - 1)) : first;
  if (!rest?.end) return null;
  const pick = (/** @type {RawPath} */ { points, parameters }, /** @type {number} */ from) => [
    Array.from(points.subarray(3 * from)),
    Array.from(parameters?.subarray(2 * from) ?? []),
  ];
  const start = pick(first, -1);
  return count === 0 ? [start] : [start, pick(rest, count === 1 ? -1 : 1)];
}
