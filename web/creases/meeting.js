/** Where a geodesic on one side first comes to a crease. */

import { CONVERGED } from '../runtime/status.js';
import { largest, product } from '../vector.js';
import { beyond, ROUNDING, slopeOf } from './crease.js';
import { nodesOf } from './legs.js';
import { differ, isSame } from './same.js';
import { traceOn } from './tangent.js';

/** @typedef {import('./bend.js').Tracing} Tracing */
/** @typedef {import('../runtime/result.js').RawPath} RawPath */
/** @typedef {import('../manifold/sides.js').Side} Side */
/** @typedef {{ place: number[], velocity: number[], signs: number[], on: number[] }} Here on: the creases on which it is */
/** @typedef {{ at: number, crease: number }} Meeting crease: −1: it is not clear what is met there */
/** @typedef {{ place: number[], measured: number[] }} Node */

/** A geodesic is looked at in so many points, and what is not clear between two of them in as many again, so often. */
const [LOOKED, DEEPEST] = [127, 3];
/** What vanishes on a crease is seen well between two points if its slopes there are no more different than this part of them; its least value, by both tangents, is known to that of those beside it. */
const [BENT, ROUGH] = [0.5, 0.25];
/** Steps towards a crease, which end at this part of the way. */
const [MOST_ROUNDS, EXACT, SLACK] = [50, 4e-15, 1e-6];
/** Jets of two places next to each other differ by less than this part of them where a floor that changes between them makes no difference. */
const FITTING = 1e-6;
const [CLEAR, CROSSED, UNCLEAR, FOLLOWED] = [0, 1, 2, 3];

/** Where a trace ended. @param {RawPath} raw */
export const endOf = ({ parameters, points }) => Array.from(parameters ? parameters.subarray(-2) : points.subarray(-3));

/** Whether what vanishes on a crease does so at a place, to this part of how large coordinates are. @param {Tracing} tracing @param {number[]} measured there @param {number} crease @param {number} [part] */
export function vanishes({ sides, size }, measured, crease, part = ROUNDING) {
  const slope = slopeOf(sides, measured, crease);
  return Math.abs(measured[crease]) <= part * size * largest(slope);
}

/**
 * A geodesic from here, and where it first comes to a crease; null: it meets none.
 * @param {Tracing} tracing @param {Side} side @param {Here} here @param {number} length @param {number} [depth] @returns {{ raw: RawPath | null, met: Meeting | null }}
 */
export function look(tracing, side, here, length, depth = 0) {
  const raw = traceOn(tracing, side, here.place, here.velocity, length, LOOKED);
  if (!raw || raw.status < CONVERGED) return { raw, met: null };
  const places = nodesOf(raw.parameters ?? raw.points, here.place.length);
  const measured = side.measure(places.flat());
  const nodes = places.map((place, i) => ({ place, measured: measured[i] }));
  const floors = tracing.sides.floors(places.flat());
  const step = raw.length / (LOOKED + 1);
  for (let i = 0; i <= LOOKED; i++) {
    const seen = here.signs.map((_, crease) => judge(tracing, here.signs, nodes[i], nodes[i + 1], crease));
    const crossed = seen.flatMap((what, crease) => (what === CROSSED ? [crease] : []));
    const isChanged = floors.length > 0 && floors[i].some((floor, k) => floor !== floors[i + 1][k]);
    const jumps = isChanged && !(depth === DEEPEST && isSmooth(side, nodes[i].place, nodes[i + 1].place));
    const isOpen = jumps || seen.includes(UNCLEAR) || (i === 0 && crossed.some((crease) => here.on.includes(crease)));
    if (seen.includes(FOLLOWED)) return { raw, met: { at: i * step, crease: -1 } };
    /* A floor may change at a node itself, for which rounding says otherwise when it is looked at again. */
    const met = isOpen ? lookCloser(tracing, side, here, [i * step, jumps ? step * (1 + SLACK) : step], depth) : null;
    if (met) return { raw, met: { ...met, at: Math.min(met.at, (i + 1) * step) } };
    if (crossed.length === 0) continue;
    if (isOpen) return { raw, met: { at: i * step, crease: -1 } };
    const roots = crossed.map((crease) => ({ crease, at: locate(tracing, side, here, crease, [i * step, (i + 1) * step]) }));
    return { raw, met: roots.reduce((first, root) => (root.at < first.at ? root : first)) };
  }
  return { raw, met: null };
}

/** As {@link look}, between two points of it. @param {Tracing} tracing @param {Side} side @param {Here} here @param {number[]} part where, and how long @param {number} depth @returns {Meeting | null} */
function lookCloser(tracing, side, here, [from, length], depth) {
  const start = depth < DEEPEST ? traceOn(tracing, side, here.place, here.velocity, from) : null;
  if (!start?.end || start.status < CONVERGED) return { at: from, crease: -1 };
  const there = from > 0 ? { ...here, place: endOf(start), velocity: start.end.velocity, on: [] } : here;
  const { met } = look(tracing, side, there, length, depth + 1);
  return met && { ...met, at: from + met.at };
}

/** Whether a side is smooth between two places next to each other. @param {Side} side @param {number[]} a @param {number[]} b */
function isSmooth(side, a, b) {
  const [[one], [other]] = [a, b].map((place) => side.jets(place));
  return !differ(side.groups, one, other, FITTING, FITTING);
}

/** Whether a crease is met between two nodes. @param {Tracing} tracing @param {number[]} signs @param {Node} a @param {Node} b @param {number} crease */
function judge(tracing, signs, a, b, crease) {
  const { sides } = tracing;
  const sign = signs[crease];
  const [p, q] = [a, b].map(({ measured }) => sign * measured[crease]);
  const chord = b.place.map((x, j) => x - a.place[j]);
  const [down, up] = [a, b].map(({ measured }) => sign * product(slopeOf(sides, measured, crease), chord));
  const reach = Math.abs(down) + Math.abs(up);
  if (Math.min(p, q) > 2 * reach) return CLEAR;
  const isZero = [a, b].map(({ measured }) => vanishes(tracing, measured, crease));
  if (isZero[0] && isZero[1] && a.place.some((x, j) => x !== b.place[j]))
    return isSame(sides, signs, beyond(signs, crease), a.place) ? CLEAR : FOLLOWED;
  const isRight = Math.abs(q - p - (down + up) / 2) <= ROUGH * reach;
  const isPlain = isRight && Math.abs(up - down) <= BENT * Math.max(Math.abs(up), Math.abs(down));
  if (q < 0 && !isZero[1]) return isPlain ? CROSSED : UNCLEAR;
  if (isPlain || reach === 0) return CLEAR;
  if (!isRight) return UNCLEAR;
  if (down >= 0 || up <= 0) return CLEAR;
  /* In a valley, what is convex lies above both tangents. */
  const least = (p * up - q * down + down * up) / (up - down);
  return least > ROUGH * Math.min(p, q) ? CLEAR : UNCLEAR;
}

/** How far it is to a crease between two lengths: Newton, or halving where that leads out. @param {Tracing} tracing @param {Side} side @param {Here} here @param {number} crease @param {number[]} between */
function locate(tracing, side, { place, velocity, signs }, crease, [low, high]) {
  let at = 0.5 * (low + high);
  /* A node may be on the crease, but for rounding. */
  low = Math.max(0, low - SLACK * (high - low));
  for (let round = 0; round < MOST_ROUNDS; round++) {
    const raw = traceOn(tracing, side, place, velocity, at);
    if (!raw?.end || raw.status < CONVERGED) return Number.NaN;
    const [measured] = side.measure(endOf(raw));
    const value = signs[crease] * measured[crease];
    const by = value / (signs[crease] * product(slopeOf(tracing.sides, measured, crease), raw.end.velocity));
    if (Math.abs(by) <= EXACT * at) break;
    if (value > 0) low = at;
    else high = at;
    at = at - by >= low && at - by <= high ? at - by : 0.5 * (low + high);
  }
  return at;
}
