/**
 * Surfaces that hang together in points, as a double cone does: the rectangle is cut along the lines that are one point, and each piece is a surface with poles. A
 * path from one piece to another leads through the points between them. MATH.md, "Pieces".
 */

import { isAtPole } from '../manifold/domain.js';
import { liftEnds } from '../manifold/lifts.js';
import { isGeodesic, makePath, mostOf, stalled } from '../path.js';
import { emptyPath } from '../runtime/result.js';
import { CONVERGED } from '../runtime/status.js';
import { POLYLINE } from '../search/candidates.js';
import { inOrder, joinPieces, placed, replaced } from '../search/join.js';
import { findGlobal, findNear, poseNear, solveNear } from '../search/routes.js';
import { gap, largest, sumOf } from '../vector.js';
import { findThrough } from './through.js';

/** @typedef {import('../path.js').Path} Path */
/** @typedef {import('../manifold/domain.js').Domain} Domain */
/** @typedef {import('../manifold/domain.js').Pinches} Pinches */
/** @typedef {import('../manifold/domain.js').Piece} Piece */
/** @typedef {import('../search/routes.js').Field} Field */
/** @typedef {import('../runtime/heap.js').SolveOptions} SolveOptions */
/** @typedef {'global' | Float64Array | null} Start how a path is looked for: by a search, near a polyline, or straight */
/** @typedef {{ piece: Field, ends: number[][] }} Leg of a way, within a piece */

/**
 * The path of length 0 between two ends that are the same pole, from which nothing can tell where it leads; null if they are not.
 * @param {Field} field @param {number[][]} ends @param {SolveOptions} options
 */
function findPoint({ domain, positions }, ends, options) {
  if (!domain?.poles.some((pole) => ends.every((end) => isAtPole(domain, end, pole)))) return null;
  const parameters = Float64Array.from({ length: 2 * options.points + 4 }, (_, i) => ends[i > 2 * options.points + 1 ? 1 : 0][i & 1]);
  const points = positions?.(parameters) ?? new Float64Array();
  return makePath({ ...emptyPath(CONVERGED), length: 0, lengthError: 0, energy: 0, gradientNorm: 0, index: 0, points, parameters });
}

/** Ends this near, in parts of their coordinates or of the rectangle, may be too near for points between them. */
const NEAR = 1e-9;
/** A length that is so many times what rounding does to it has room for them; and an error that is so many times that is one of chords, across what curves. */
const [ROOM, CHORDS] = [1e5, 4];

/**
 * The path between two ends that are the same place, or so near that points between them would be mere rounding: half of its points are the one, half the other; null
 * if the ends are not.
 * @param {Field} field @param {number[][]} ends @param {SolveOptions} options @returns {Path | null}
 */
function findRest(field, ends, options) {
  const { domain } = field;
  const [from, to] = domain ? liftEnds(domain, ends[0], ends[1], null) : ends;
  const size = from.map((x, j) => (domain ? Math.max(Math.abs(x), domain.upper[j] - domain.lower[j]) : largest(from)));
  if (from.some((x, j) => !(Math.abs(x - to[j]) <= NEAR * size[j]))) return null;
  const near = poseNear(field, ends, null);
  const raw = near.solve({ ...options, algorithm: POLYLINE, points: 1 });
  const { length, lengthError, rounding = 0 } = raw;
  if (!(length <= ROOM * rounding && Math.min(length, lengthError) <= CHORDS * rounding)) return null;
  const path = near.finish(raw);
  const isSame = from.every((x, j) => x === to[j]);
  const last = options.points + 1;
  const widen = (/** @type {Float64Array} */ three) =>
    Float64Array.from({ length: (three.length / 3) * (last + 1) }, (_, i) => {
      const width = three.length / 3;
      const node = 2 * Math.floor(i / width) - last;
      return three[isSame ? i % width : width * (Math.sign(node) + 1) + (i % width)];
    });
  return {
    ...replaced(path, widen),
    lengthError: 2 * path.lengthError, // of two chords it may be a little too small
    ...(isSame && { length: 0, lengthError: 0, energy: 0, gradientNorm: 0 }),
    status: 'converged',
    converged: true,
    index: 0,
  };
}

/** @param {Field} field @param {number[][]} ends @param {SolveOptions} options @param {Start} start @returns {Path} */
function findIn(field, ends, options, start) {
  const point = findPoint(field, ends, options);
  if (point) return point;
  const rest = findRest(field, ends, options);
  if (start === 'global') return rest ?? findThrough(field, ends, options);
  if (!start) return rest ?? solveNear(field, ends, options, start);
  const path = solveNear(field, ends, options, start);
  /* A given start may lead around something; one that does not has shrunk to what rounding leaves. */
  const isShrunk = rest && !isGeodesic(path) && path.length <= NEAR * largest(rest.points.subarray(0, 3));
  return isShrunk ? rest : path;
}

/** The shortest path within a sheet of an implicit surface, through no node. @param {Field} field @param {number[][]} ends @param {SolveOptions} options @returns {Path} */
export const findWithin = (field, ends, options) => findRest(field, ends, options) ?? findGlobal(field, ends, options, 1)[0];

/** An end this near to a point between pieces, in parts of a piece, is that point. */
const ROUNDING = 1e-14;

/** The path with these legs, in the caller's turn of the parameters. @param {Field} field @param {Leg[]} legs @param {SolveOptions} options @param {number[]} from @returns {Path} */
function follow({ domain }, legs, options, from) {
  const solve = (/** @type {number} */ i, /** @type {SolveOptions} */ asked) => findGlobal(legs[i].piece, legs[i].ends, asked, 1)[0];
  return placed(domain, joinPieces(legs.length, options, solve, domain), from);
}

/** What no path with these legs is shorter than: their chords, and what it takes to cross the surface between their ends. @param {Field} field @param {Leg[]} legs */
function boundOf({ domain, isPlain, positions }, legs) {
  if (!positions || !isPlain) return 0;
  const across = domain?.pinches?.across ?? 0;
  return legs.reduce((sum, { piece, ends }) => {
    const points = positions(ends.flat());
    const { lower, upper, slabs } = /** @type {Piece} */ (piece.domain);
    const [low, high] = ends
      .map((end) => ((end[across] - lower[across]) / (upper[across] - lower[across])) * slabs.length)
      .sort((a, b) => a - b);
    const crossed = sumOf(slabs.slice(Math.ceil(low), Math.floor(high)));
    return sum + Math.max(gap(points, points.subarray(3)), crossed);
  }, 0);
}

/** A place moved by whole periods into a piece; null: it is not in it. @param {Pinches} pinches @param {Field} piece @param {number[]} place */
function into({ across, period }, { domain }, place) {
  const { lower, upper } = /** @type {Domain} */ (domain);
  const x = place[across];
  const lifted = period > 0 ? x - period * Math.floor((x - lower[across]) / period) : x;
  const edge = [lower, upper]
    .map((corner) => corner[across])
    .find((y) => Math.abs(lifted - y) <= ROUNDING * (upper[across] - lower[across]));
  if (edge === undefined && !(lifted > lower[across] && lifted < upper[across])) return null;
  return place.map((own, j) => (j === across ? (edge ?? lifted) : own));
}

/**
 * The ways between two places, from piece to piece: in one piece the one within it first.
 * @param {Field} field @param {number[][]} ends @returns {Leg[][]}
 */
function waysBetween({ domain, pieces }, [from, to]) {
  const pinches = /** @type {Pinches} */ (domain?.pinches);
  const { across, period } = pinches;
  const holding = (/** @type {number[]} */ place) => pieces.flatMap((piece, i) => (into(pinches, piece, place) ? [i] : []));
  const [starts, stops] = [holding(from), holding(to)];
  const first = starts.find((i) => stops.includes(i)) ?? starts[0];
  const last = stops.includes(first) ? first : stops[0];
  const count = pieces.length;
  /** So many pieces up, or down. @param {number} steps */
  const chain = (steps) =>
    Array.from({ length: Math.abs(steps) + 1 }, (_, k) => {
      const step = Math.sign(steps);
      const piece = pieces[(first + k * step + count) % count];
      const { lower, upper } = /** @type {Domain} */ (piece.domain);
      /* At a pole the coordinate around it is free. */
      const pole = (/** @type {number} */ side) => (side < 0 ? lower : upper).map((x, j) => (j === across ? x : from[j]));
      const [begin, end] = [k === 0 && into(pinches, piece, from), k === Math.abs(steps) && into(pinches, piece, to)];
      return { piece, ends: [begin || pole(-step), end || pole(step)] };
    });
  /* An end that is a point between two pieces needs no leg from there to there, unless there is no other. */
  const trimmed = (/** @type {Leg[]} */ legs) => {
    const needed = legs.filter(({ ends: [a, b] }) => a[across] !== b[across]);
    return needed.length > 0 ? needed : [legs[0]];
  };
  const up = (last - first + count) % count;
  const around = up === 0 ? [0, count, -count] : [up, up - count];
  return (period > 0 ? around : [last - first]).map((steps) => trimmed(chain(steps)));
}

/**
 * Where a place is left from in a direction: if there are pieces, in the one that holds it; from a point between two in that which the direction leads into.
 * @param {Field} field @param {number[]} place @param {number[]} direction @returns {{ domain: Domain | null, place: number[] }}
 */
export function placeIn({ domain, pieces }, place, direction) {
  const pinches = /** @type {Pinches} */ (domain?.pinches);
  let held = { domain, place };
  for (const piece of pieces) {
    const lifted = into(pinches, piece, place);
    if (lifted && (held.place === place || leadsInto(piece, pinches.across, lifted, direction)))
      held = { domain: piece.domain, place: lifted };
  }
  return held;
}

/** Whether a direction leads from a place towards the middle of a piece. @param {Field} piece @param {number} across @param {number[]} place @param {number[]} direction */
function leadsInto({ domain }, across, place, direction) {
  const { lower, upper } = /** @type {Domain} */ (domain);
  return direction[across] * (lower[across] + upper[across] - 2 * place[across]) > 0;
}

/**
 * The path between two ends.
 * @param {Field} field @param {number[][]} ends @param {SolveOptions} options @param {Start} start
 * @returns {Path}
 */
export function findByPieces(field, ends, options, start) {
  const { domain, pieces } = field;
  if (pieces.length === 0) return findIn(field, ends, options, start);
  const find = (/** @type {number[][]} */ asked) => findAcross(field, asked, options, start);
  return start && start !== 'global' ? find(ends) : inOrder(domain, ends, find);
}

/**
 * The shortest of the paths from piece to piece, and of those within one.
 * @param {Field} field @param {number[][]} ends @param {SolveOptions} options @param {Start} start
 * @returns {Path}
 */
function findAcross(field, ends, options, start) {
  const ways = waysBetween(field, ends);
  const solve = (/** @type {Leg[]} */ legs) =>
    legs.length > 1
      ? follow(field, legs, options, ends[0])
      : placed(field.domain, findIn(legs[0].piece, legs[0].ends, options, start), ends[0]);
  const isNear = start !== 'global' && ways[0].length === 1;
  const near = isNear ? solve(ways[0]) : null;
  if (near && isGeodesic(near)) return near;
  const open = (isNear ? ways.slice(1) : ways).map((legs) => ({ legs, bound: boundOf(field, legs) })).sort((a, b) => a.bound - b.bound);
  let best = near;
  let missed = Infinity;
  for (const { legs, bound } of open) {
    if (best && bound >= mostOf(best)) break;
    const path = solve(legs);
    if (!(path.length >= 0)) missed = Math.min(missed, bound);
    /* One that is shorter tells, whatever its status: then no longer one is the shortest. */
    if (!best || mostOf(path) < mostOf(best)) best = path;
  }
  const shortest = /** @type {Path} */ (best);
  return isGeodesic(shortest) && missed < shortest.length ? stalled(shortest) : shortest;
}

/**
 * As `findNear`, not for pieces.
 * @param {Field} field @param {number[][]} ends @param {SolveOptions} options @param {ArrayLike<number>[]} lines @param {number} shortest
 */
export function findBeside(field, ends, options, lines, shortest) {
  const point = findPoint(field, ends, options);
  return point ? [point] : findNear(field, ends, options, lines, shortest);
}

/**
 * All locally shortest paths between two ends that are found, shortest first.
 * @param {Field} field @param {number[][]} ends @param {SolveOptions} options @param {number} most
 * @returns {Path[]}
 */
export function findAllByPieces(field, ends, options, most) {
  const [nearest] = field.pieces.length > 0 ? waysBetween(field, ends) : [[{ piece: field, ends }]];
  const [leg] = nearest;
  if (nearest.length > 1 || findPoint(leg.piece, leg.ends, options)) return [findByPieces(field, ends, options, 'global')];
  const first = findRest(leg.piece, leg.ends, options);
  const paths = findGlobal(leg.piece, leg.ends, options, most);
  /* Rounded, the path that rests may be there more than once, of a length that is its own error; a loop's is known to more than a digit. */
  const isLoop = (/** @type {Path} */ { length, lengthError }) => length > 10 * lengthError && length > ROOM * (first?.lengthError ?? 0);
  if (!field.domain && !first && !paths.some(isGeodesic)) return [findByPieces(field, ends, options, 'global')];
  const all = first ? [first, ...paths.filter(isLoop)] : paths;
  return all.slice(0, most).map((path) => placed(field.domain, path, ends[0]));
}
