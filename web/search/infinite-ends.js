/**
 * Paths whose ends lie where a density or a metric is infinite, on an edge of the rectangle as a rule, as that of a body which falls from rest: a little beside all is
 * finite, and the way there, straight away from the line, has a length of its own. MATH.md, "Infinite ends".
 */

import { GAUSS } from '../gauss.js';
import { makePath } from '../path.js';
import { emptyPath } from '../runtime/result.js';
import { NOT_FINITE } from '../runtime/status.js';
import { inOrder, turned } from './join.js';

/** @typedef {import('../path.js').Path} Path */
/** @typedef {import('../pieces/pieces.js').Start} Start */
/** @typedef {import('./routes.js').Field} Field */
/** @typedef {import('../runtime/heap.js').SolveOptions} SolveOptions */
/** @typedef {{ end: number[], across: number, depth: number, isEdge: boolean }} Infinite an end, a coordinate that leads away from where lengths are infinite, what that changes by from there to an edge, or less where the other end is near, and whether the end lies on the other one */
/** @typedef {{ place: number[], length: number, error: number }} Leg from an end to a place inside */
/** @typedef {{ path: Path, legs: Leg[], length: number, change: number, missed: number }} Found path: between the legs; length: with its legs; change: of that, from the depth before */

/** So far beside, in parts of the way to the edge, or of less where ends are near, paths begin. What they miss of the length falls with the depth, or sooner: the last two tell what is left. */
const DEPTHS = [1e-3, 1e-4, 1e-5, 1e-7, 1e-9];
/** Enough is known where what is missed is this part of the tolerance. */
const ENOUGH = 0.1;
/** What is missed falls to this part from one depth to the next, at least. */
const FALLS = 0.5;
/** A half of a leg is shorter than the one before by this factor at least, where all are not infinitely long: as long as each other, but for rounding. */
const FALLING = 0.999;
/** A half of a leg is measured in so many parts, each by Gauss's rule. */
const PARTS = 32;

/**
 * The path between two ends; null: at both of them length is measured by numbers.
 * @param {Field} field @param {number[][]} ends @param {SolveOptions} options @param {Start} start
 * @param {(field: Field, ends: number[][], options: SolveOptions, start: Start) => Path} solve between places inside
 * @returns {Path | null}
 */
export function findFromInfinite(field, ends, options, start, solve) {
  const { domain, isPlain } = field;
  if (!domain || isPlain || isMeasured(field, ends.flat()) || String(ends[0]) === String(ends[1])) return null;
  return inOrder(domain, ends, (both, isTurned) => findForwards(field, both, options, isTurned ? turnedStart(start) : start, solve));
}

/** A start from the second end to the first. @param {Start} start @returns {Start} */
export const turnedStart = (start) => (start && start !== 'global' ? turned(start, 2) : start);

/** @type {typeof findFromInfinite} */
function findForwards(field, ends, options, start, solve) {
  const { tolerance } = options;
  const infinite = ends.map((end, i) => infiniteAt(field, end, ends[1 - i]));
  if (!infinite.some((one) => one)) return null;
  /** @type {Found | null} */
  let best = null;
  for (const depth of DEPTHS) {
    const legs = ends.map((end, i) => legOf(field, infinite[i], depth) ?? { place: end, length: 0, error: 0 });
    if (legs.some(({ length }) => length === Infinity)) return makePath(emptyPath(NOT_FINITE));
    const places = legs.map(({ place }) => place);
    const path = solve(best ? inside(field, infinite, places) : field, places, options, best?.path.parameters ?? start);
    if (best && !path.converged) continue;
    const next = joined(path, legs, best);
    /* From here on depths are rounding. */
    if (best && next.missed > best.missed) break;
    best = next;
    if (!path.converged || best.missed <= ENOUGH * tolerance * best.length) break;
  }
  return best && begun(field, infinite, best, tolerance);
}

/**
 * Places beside those at which length is measured infinitely, so far away from them, and how far that is; null: it is at none of them, or also beside.
 * @param {Field} field @param {ArrayLike<number>} places u v of each @param {number} depth
 * @returns {{ places: Float64Array, away: Float64Array } | null}
 */
export function besideInfinite(field, places, depth) {
  if (!field.domain || field.isPlain || isMeasured(field, Array.from(places))) return null;
  const beside = { places: Float64Array.from(places), away: new Float64Array(places.length / 2) };
  for (const i of beside.away.keys()) {
    const end = [places[2 * i], places[2 * i + 1]];
    const leg = legOf(field, infiniteAt(field, end, end), depth);
    if (!leg || leg.length === Infinity) continue;
    beside.places.set(leg.place, 2 * i);
    beside.away[i] = leg.length;
  }
  return beside;
}

/** A path with its legs, and what is missed: the change from depth to depth tells. @param {Path} path @param {Leg[]} legs @param {Found | null} before @returns {Found} */
function joined(path, legs, before) {
  const own = legs[0].length + legs[1].length;
  const length = path.length + own;
  const change = before ? Math.abs(length - before.length) : Infinity;
  const part = before && before.change < Infinity ? Math.min(change / before.change || 0, FALLS) : FALLS;
  const missed = before ? (change * part) / (1 - part) : own;
  return { path, legs, length, change, missed: legs[0].error + legs[1].error + missed };
}

/** The surface as far as between places beside infinite ends: beyond these nothing need be tried. @param {Field} field @param {(Infinite | null)[]} infinite @param {number[][]} places @returns {Field} */
function inside(field, infinite, places) {
  const domain = domainOf(field);
  const [lower, upper] = [[...domain.lower], [...domain.upper]];
  for (const [i, one] of infinite.entries()) if (one?.isEdge) (one.depth > 0 ? lower : upper)[one.across] = places[i][one.across];
  const part = { ...domain, lower, upper };
  return { ...field, domain: part, run: (call) => field.run(call, part) };
}

/** @param {Field} field */
export const domainOf = ({ domain }) => /** @type {import('../manifold/domain.js').Domain} */ (domain);

/** Whether length is measured by numbers at all of some places. @param {Field} field @param {number[]} places */
const isMeasured = ({ forms }, places) => forms(places).every((form) => Number.isFinite(form[0] + form[1] + form[2]));

/**
 * What is known of an end at which length is measured infinitely; null: it is not, or also beside it.
 * @param {Field} field @param {number[]} end @param {number[]} other @returns {Infinite | null}
 */
function infiniteAt(field, end, other) {
  const { lower, upper, periodic } = domainOf(field);
  if (isMeasured(field, end)) return null;
  /* Between near ends less of the range is looked at. */
  const near = Math.min(Math.max(...end.map((x, j) => Math.abs(other[j] - x) / (upper[j] - lower[j]))) || 1, 1);
  const ways = [0, 1].flatMap((across) => {
    const sides = [upper[across] - end[across], lower[across] - end[across]];
    if (other[across] < end[across]) sides.reverse();
    return sides
      .filter((depth) => depth && !periodic[across])
      .map((depth) => ({ end, across, depth: near * depth, isEdge: sides.includes(0) }));
  });
  return ways.find((way) => isMeasured(field, placeOf(way, DEPTHS[0], 0))) ?? null;
}

/** @param {Infinite} infinite @param {number} part of the way across @param {number} slope what the other coordinate changes by */
const placeOf = ({ end, across, depth }, part, slope) => end.map((x, j) => x + part * depth * (j === across ? 1 : slope));

/** The leg from an end straight away from its edge. @param {Field} field @param {Infinite | null} infinite @param {number} depth @returns {Leg | null} */
function legOf(field, infinite, depth) {
  if (!infinite) return null;
  const { across } = infinite;
  const { forms } = field;
  const along = 1 - across;
  const [form] = forms(placeOf(infinite, depth, 0));
  const { lower, upper, periodic } = domainOf(field);
  const steepest = -form[1] / form[2 * along];
  const place = placeOf(infinite, depth, steepest);
  const isInside = periodic[along] || (place[along] >= lower[along] && place[along] <= upper[along]);
  return measure(field, infinite, depth, isInside ? steepest : 0);
}

/**
 * The straight way from an end: halves of halves of it are as a geometric series, where length is measured by a power of the depth.
 * @param {Field} field @param {Infinite} infinite @param {number} depth @param {number} slope
 * @returns {Leg} of infinite length where the halves do not become shorter
 */
export function measure({ forms }, infinite, depth, slope) {
  const { across } = infinite;
  const along = 1 - across;
  const [first, second, third] = [0.5, 0.25, 0.125].map((from) => {
    const parts = Array.from({ length: PARTS }, (_, i) => GAUSS.map(({ at }) => from * (1 + (i + at) / PARTS) * depth)).flat();
    const speeds = forms(parts.flatMap((part) => placeOf(infinite, part, slope))).map((at) =>
      Math.sqrt(at[2 * across] + slope * (2 * at[1] + slope * at[2 * along])),
    );
    const width = (from * depth * Math.abs(infinite.depth)) / PARTS;
    return width * speeds.reduce((length, speed, i) => length + GAUSS[i % GAUSS.length].weight * speed, 0);
  });
  const [once, twice] = [first / (1 - second / first), first + second / (1 - third / second)];
  const falls = second < FALLING * first && third < FALLING * second;
  return { place: placeOf(infinite, depth, slope), length: falls ? twice : Infinity, error: Math.abs(twice - once) };
}

/**
 * A path that begins, or ends, where it was asked to.
 * @param {Field} field @param {(Infinite | null)[]} infinite @param {{ path: Path, legs: Leg[], length: number, missed: number }} found @param {number} tolerance
 * @returns {Path}
 */
export function begun({ positions }, infinite, { path, legs, length, missed }, tolerance) {
  const lengthError = path.lengthError + missed;
  const [points, parameters] = [path.points.slice(), path.parameters?.slice() ?? null];
  for (const [i, one] of infinite.entries()) {
    if (!one || !parameters || parameters.length === 0) continue;
    const last = i * (parameters.length - 2);
    const along = 1 - one.across;
    parameters[last + one.across] = one.end[one.across];
    parameters[last + along] += one.end[along] - legs[i].place[along];
    if (positions && points.length > 0) points.set(positions(one.end), 1.5 * last);
  }
  const isMissed = path.converged && lengthError > tolerance * length;
  return {
    ...path,
    ...(isMissed && { status: 'tolerance-not-met', converged: false }),
    length,
    lengthError,
    energy: path.energy * (length / path.length) ** 2,
    points,
    parameters,
  };
}
