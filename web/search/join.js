/** Paths that follow each other, joined into one; paths turned round. Knows paths as plain data. */

import { moveNear } from '../manifold/lifts.js';
import { isGeodesic } from '../path.js';
import { listOf, sumOf } from '../vector.js';
import { ELEMENTS } from './candidates.js';

/** @typedef {import('../path.js').Path} Path */
/** @typedef {import('../manifold/seams.js').Glued} Glued */
/** @typedef {import('../runtime/heap.js').SolveOptions} SolveOptions */

/**
 * Shares inner points out among pieces in proportion to their lengths, the points where they meet left out: at least one each.
 * @param {number[]} lengths @param {number} points inner points of the whole, at least 2 lengths.length − 1
 * @returns {number[]}
 */
function shareOut(lengths, points) {
  const total = sumOf(lengths);
  const free = points - (lengths.length - 1) - lengths.length;
  const wanted = lengths.map((length) => (total > 0 ? (free * length) / total : 0));
  const shares = wanted.map((want) => 1 + Math.floor(want));
  const left = free - sumOf(shares.map((share) => share - 1));
  const order = wanted.map((_, i) => i).sort((i, j) => (wanted[j] % 1) - (wanted[i] % 1) || lengths[j] - lengths[i]);
  for (let k = 0; k < left; k++) shares[order[k % order.length]]++;
  return shares;
}

/** Inner points of a path. @param {Pick<Path, 'points' | 'parameters'>} path */
export const innerOf = ({ parameters, points }) => (parameters ? parameters.length / 2 : points.length / 3) - 2;

/** Segments of the polyline of a path. @param {Path} path */
const segmentsOf = (path) => innerOf(path) + 1;

/** A sum that does not depend on the order. @param {number[]} numbers */
const sum = (numbers) => sumOf([...numbers].sort((a, b) => a - b));

/** One array after the other, the first `width` numbers of each but the first, which repeat the end of the one before, left out. @param {Float64Array[]} arrays @param {number} width */
export function concatenate(arrays, width) {
  const numbers = arrays.flatMap((array, i) => Array.from(i ? array.subarray(width) : array));
  return Float64Array.from(numbers);
}

/** u v of the pieces, each moved to go on where the one before ended; at a pole, where they differ in the coordinate around it, in its direction. @param {Path[]} pieces @param {Glued | null} glued @returns {Float64Array | null} */
function joinParameters(pieces, glued) {
  if (!glued) return null;
  /** @type {Float64Array[]} */
  const moved = [];
  for (const { parameters } of pieces) {
    const own = Float64Array.from(/** @type {Float64Array} */ (parameters));
    moveNear(glued, own, moved.at(-1)?.subarray(-2) ?? own);
    moved.push(own);
  }
  return concatenate(moved, 2);
}

/**
 * Joins paths that follow each other. A piece without a path makes the whole one; else the status is the first that is not `converged`.
 * @param {Path[]} pieces @param {Glued | null} glued the rectangle, if they have parameters @param {boolean} areElements they share time as their lengths do; chords take as long as each other
 * @returns {Path}
 */
export function joinPaths(pieces, glued, areElements) {
  const missing = pieces.find(({ length }) => Number.isNaN(length));
  if (missing) return missing;
  const status = pieces.find(({ converged }) => !converged)?.status ?? 'converged';
  const points = concatenate(
    pieces.map((piece) => piece.points),
    3,
  );
  const timeOf = areElements ? (/** @type {Path} */ { length }) => length : segmentsOf;
  return {
    status,
    converged: status === 'converged',
    length: sum(pieces.map(({ length }) => length)),
    lengthError: sum(pieces.map(({ lengthError }) => lengthError)),
    points,
    parameters: joinParameters(pieces, glued),
    iterations: sum(pieces.map(({ iterations }) => iterations)),
    energy: sum(pieces.map(timeOf)) * sum(pieces.map((piece) => piece.energy / timeOf(piece) || 0)),
    gradientNorm: Math.sqrt(sum(pieces.map(({ gradientNorm }) => gradientNorm ** 2))),
    index: pieces.some(({ index }) => index < 0) ? -1 : sum(pieces.map(({ index }) => index)),
    touchesBoundary: pieces.some(({ touchesBoundary }) => touchesBoundary),
    crossesSingularity: pieces.some(({ crossesSingularity }) => crossesSingularity),
    conjugate: null,
    history: pieces.flatMap(({ history }) => history),
  };
}

/**
 * A path of legs, each solved as it is asked for, with its part of the points.
 * @param {Path[]} legs as they are known @param {SolveOptions} asked @param {(leg: number, options: SolveOptions) => Path} solve
 * @param {Glued | null} glued the rectangle, if they have parameters @param {number} [least] the legs are solved in so many parts at least
 * @returns {{ path: Path, parts: Path[] }} and its legs
 */
export function joinLegs(legs, asked, solve, glued, least = 1) {
  const points = Math.max(asked.points, 2 * legs.length - 1);
  const shares = shareOut(
    legs.map(({ length }) => length || 0),
    points,
  );
  const parts = shares.map((share, k) => solve(k, { ...asked, points: (share + 1) * Math.ceil(least / (share + 1)) - 1 }));
  const whole = joinPaths(
    parts.map((part, k) => (least > 1 && isGeodesic(part) ? thinned(part, shares[k] + 2) : part)),
    glued,
    asked.algorithm === ELEMENTS,
  );
  return { parts, path: points > asked.points && whole.length >= 0 ? thinned(whole, asked.points + 2) : whole };
}

/** Inner points of a piece, at least, whose length is only to tell how many points it gets. */
const ROUGH = 31;

/**
 * So many pieces, one after the other: first roughly, to share out the points, then as asked.
 * @param {number} count @param {SolveOptions} options @param {(piece: number, options: SolveOptions) => Path} solve
 * @param {Glued | null} glued the rectangle, if they have parameters
 * @returns {Path}
 */
export function joinPieces(count, options, solve, glued) {
  const least = { ...options, points: Math.max(ROUGH, Math.ceil(options.points / count)), record: false };
  const rough = Array.from({ length: count }, (_, i) => solve(i, least));
  return joinLegs(rough, options, solve, glued).path;
}

/** Fewer points of a path. @param {Path} path @param {number} count @returns {Path} */
export function thinned(path, count) {
  const pick = (/** @type {Float64Array} */ numbers, /** @type {number} */ width) => {
    const last = numbers.length / width - 1;
    const at = Array.from({ length: count }, (_, i) => Math.round((i * last) / (count - 1)));
    return Float64Array.from(at.flatMap((i) => listOf(numbers, width * i, width * (i + 1))));
  };
  return {
    ...path,
    points: pick(path.points, 3),
    parameters: path.parameters && pick(path.parameters, 2),
  };
}

/** Places along a polyline: each of its chords in parts. @param {Float64Array} line @param {number} width @param {number} parts */
export function divide(line, width, parts) {
  const places = new Float64Array((line.length - width) * parts + width);
  for (let i = 0; i + width < line.length; i += width)
    for (let part = 0; part < parts; part++)
      for (let j = i; j < i + width; j++) places[i * parts + part * width + j - i] = line[j] + (part / parts) * (line[j + width] - line[j]);
  for (let j = 1; j <= width; j++) places[places.length - j] = line[line.length - j];
  return places;
}

/** @param {Float64Array} numbers @param {number} width so many a point */
export function turned(numbers, width) {
  const result = new Float64Array(numbers.length);
  const last = numbers.length - width;
  for (let i = 0; i <= last; i += width) for (let j = 0; j < width; j++) result[last - i + j] = numbers[i + j];
  return result;
}

/**
 * A path with other places, those of its history, too.
 * @template {import('../runtime/result.js').RawPath | Path} T @param {T} path @param {(numbers: Float64Array, width: number) => Float64Array} change @returns {T}
 */
export function replaced(path, change) {
  return {
    ...path,
    points: change(path.points, 3),
    parameters: path.parameters && change(path.parameters, 2),
    history: path.history.map((iterate) => (iterate.points ? { ...iterate, points: change(iterate.points, 3) } : iterate)),
  };
}

/** Turns a path round. @template {import('../runtime/result.js').RawPath | Path} T @param {T} path */
export const reverse = (path) => replaced(path, turned);

/** Whether numbers are lexicographically larger than others: then what lies between them is found the other way round. @param {number[]} a @param {number[]} b */
export function isAfter(a, b) {
  const different = a.findIndex((x, j) => x !== b[j]);
  return different >= 0 && a[different] > b[different];
}

/** A path whose parameters begin where the caller's do. @param {Glued | null} glued @param {Path} path @param {number[]} from */
export function placed(glued, path, from) {
  if (glued && path.parameters) moveNear(glued, path.parameters, from);
  return path;
}

/**
 * What finds a path over some places, asked so that these the other way round reverse it.
 * @template {Path | null} T @param {Glued | null} glued @param {number[][]} places @param {(places: number[][], isTurned: boolean) => T} find @returns {T}
 */
export function inOrder(glued, places, find) {
  const back = [...places].reverse();
  if (!isAfter(places.flat(), back.flat())) return find(places, false);
  const path = find(back, true);
  return path && /** @type {T} */ (placed(glued, reverse(path), places[0]));
}
