/**
 * Solves random pairs of points at random tolerances and judges each answer by a finer solve of the same path and by shooting: geodesics traced from
 * points of it until they hit the next of these points. Knows nothing of how they are printed.
 */

/** @typedef {import('../../../web/index.js').Path} Path */
/** @typedef {import('../../../web/index.js').Surface} Surface */
/** @typedef {{ from: number[], to: number[], tolerance: number }} Question */

/**
 * What became of a question. verdict: right; wrong: the length is off by more than the tolerance; astray: the traced
 * geodesics have another length, or do not hit; unchecked: no finer solve converged; refused: not converged, with a status of the list; slow: more than 5 s; unclassified: an exception, or no
 * status of the list. error: relative, of the length. miss: how much longer the traced
 * geodesics are together, relative; infinite: one does not hit. owned: the error is no larger than lengthError says, beside that of the finer solve.
 * @typedef {Question & { verdict: string, status: string, length: number, fine: number, error: number, miss: number, traced: boolean, owned: boolean, milliseconds: number }} Answer
 */

const TOLERANCES = [1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10];
const FINER = [1e-12, 1e-11, 2e-11];
/** A finer solve that is not as fine as asked for still tells, if its own error is this part of the tolerance. */
const KNOWN = 0.01;
const SLOW = 5000;
const FINE_POINTS = 255;
/** A path is traced in so many pieces: a direction at its start says little about a far end. */
const PIECES = 8;
/** Of a piece: as many as tell its first direction. */
const FEWEST_CHORDS = 8;
/** One-sided differences of eighth order at the first of equally spaced points, times 840. */
const DIFFERENCES = [-2283, 6720, -11760, 15680, -14700, 9408, -3920, 960, -105];
const TURN = 1e-6;
/** Corrections of the direction and the length, and where they are small enough. */
const SHOTS = 8;
const HIT = 1e-10;
/** What the lengths of the traced and of the fine path may differ by: a miss of HIT, and the tracing. */
const MISS = 1e-9;
const WEAKER = ['iteration-limit', 'stalled', 'tolerance-not-met', 'ill-conditioned', 'saddle'];
const NONE = ['disconnected', 'singular-metric', 'sheet-jump', 'off-surface', 'not-finite', 'out-of-memory'];

/** The direction at one of the equally spaced points of a path, in space, as a pole of the chart does not disturb it. @param {Float64Array} points @param {number} at */
function directionAt(points, at) {
  return [0, 1, 2].map((k) => DIFFERENCES.reduce((sum, factor, i) => sum + factor * points[3 * (at + i) + k], 0));
}

/** A direction in space as du dv. @param {Surface} surface @param {number[]} from u v @param {number[]} direction */
function inParameters(surface, [u, v], direction) {
  const around = surface.evaluate([u + TURN, v, u - TURN, v, u, v + TURN, u, v - TURN]);
  const [first, second] = [0, 12].map((at) => [0, 1, 2].map((k) => (around[at + k] - around[at + 6 + k]) / (2 * TURN)));
  return fit(first, second, direction);
}

/** @param {Path} path */
const endOf = (path) => path.points.subarray(-3);

/** @param {ArrayLike<number>} a @param {ArrayLike<number>} b */
const distance = (a, b) => Math.sqrt((a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2 + (a[2] - b[2]) ** 2);

/** A direction across another, of about its length. @param {Surface} surface @param {number[]} from @param {number[]} direction */
function across(surface, from, [x, y, z]) {
  if (z === undefined) return [-y, x];
  const [, a, b, c] = surface.evaluate(from);
  const size = Math.hypot(a, b, c);
  return [(b * z - c * y) / size, (c * x - a * z) / size, (a * y - b * x) / size];
}

/** The least squares solution of p s + q t = r. @param {number[]} p @param {number[]} q @param {number[]} r */
function fit(p, q, r) {
  const dot = (/** @type {number[]} */ a, /** @type {number[]} */ b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const determinant = dot(p, p) * dot(q, q) - dot(p, q) ** 2;
  return [(dot(p, r) * dot(q, q) - dot(q, r) * dot(p, q)) / determinant, (dot(q, r) * dot(p, p) - dot(p, r) * dot(p, q)) / determinant];
}

/**
 * Shoots: corrects direction and length until the geodesic hits.
 * @param {Surface} surface @param {number[]} from @param {number[]} direction @param {number} length @param {ArrayLike<number>} target x y z
 * @returns {number} the length; infinite: it does not hit; NaN: an edge is in the way
 */
function shoot(surface, from, direction, length, target) {
  const trace = (/** @type {number[]} */ way, /** @type {number} */ far) => surface.trace(from, way, far, { points: 1, tolerance: 1e-14 });
  let [way, far] = [direction, length];
  for (let shot = 0; shot < SHOTS && far > 0 && far < 2 * length; shot++) {
    const side = across(surface, from, way);
    const tilted = way.map((x, k) => x + TURN * side[k]);
    const [straight, turned, short] = [trace(way, far), trace(tilted, far), trace(way, far * (1 - TURN))];
    if (![straight, turned, short].every(({ converged }) => converged)) return Number.NaN;
    if (distance(endOf(straight), target) <= HIT * far) return far;
    const relative = (/** @type {ArrayLike<number>} */ point) => Array.from(point, (x, k) => x - endOf(straight)[k]);
    const [turn, longer] = fit(relative(endOf(turned)), relative(endOf(short)), relative(target));
    way = way.map((x, k) => x + turn * TURN * side[k]);
    far *= 1 - longer * TURN;
  }
  return Infinity;
}

/**
 * The length of a piece of a path, traced; where that does not hit its end, as beside a rim, of its halves.
 * @param {Surface} surface @param {Path} fine @param {number} at its first chord @param {number} chords
 * @returns {number} as shoot
 */
function tracedLength(surface, fine, at, chords) {
  const [places, width] = fine.parameters ? [fine.parameters, 2] : [fine.points, 3];
  const from = Array.from(places.subarray(width * at, width * (at + 1)));
  const target = fine.points.subarray(3 * (at + chords), 3 * (at + chords + 1));
  const direction = directionAt(fine.points, at);
  const way = width === 2 ? inParameters(surface, from, direction) : direction;
  const length = shoot(surface, from, way, (fine.length * chords) / (FINE_POINTS + 1), target);
  const half = chords / 2;
  if (length !== Infinity || half < FEWEST_CHORDS) return length;
  return tracedLength(surface, fine, at, half) + tracedLength(surface, fine, at + half, half);
}

/**
 * How much longer a path is if it is traced, piece by piece.
 * @param {Surface} surface @param {Path} fine
 * @returns {number} relative; infinite: a piece does not hit its end; NaN: an edge is in the way
 */
function missOf(surface, fine) {
  const chords = (FINE_POINTS + 1) / PIECES;
  let length = 0;
  for (let at = 0; at <= FINE_POINTS; at += chords) length += tracedLength(surface, fine, at, chords);
  return (length - fine.length) / fine.length;
}

/** The same path, solved as finely as it can be. @param {Surface} surface @param {Question} question @param {Path} path */
function refine(surface, { from, to, tolerance }, path) {
  for (const finer of FINER) {
    if (finer >= tolerance) continue;
    const fine = surface.shortestPath(from, to, { tolerance: finer, start: path, points: FINE_POINTS });
    if (fine.converged || fine.lengthError <= KNOWN * tolerance * fine.length) return fine;
  }
  return null;
}

/** @param {Surface} surface @param {Question} question @returns {Answer} */
export function answer(surface, question) {
  const nothing = { length: Number.NaN, fine: Number.NaN, error: Number.NaN, miss: Number.NaN, traced: false, owned: false };
  const begin = performance.now();
  let path;
  try {
    path = surface.shortestPath(question.from, question.to, { tolerance: question.tolerance });
  } catch (error) {
    return { ...question, ...nothing, verdict: 'unclassified', status: String(error), milliseconds: performance.now() - begin };
  }
  const found = { ...question, ...nothing, status: path.status, length: path.length, milliseconds: performance.now() - begin };
  if (found.milliseconds > SLOW) return { ...found, verdict: 'slow' };
  if (!path.converged) {
    const classified = WEAKER.includes(path.status) ? path.length > 0 : NONE.includes(path.status) && Number.isNaN(path.length);
    return { ...found, verdict: classified ? 'refused' : 'unclassified' };
  }
  return { ...found, ...judge(surface, question, path) };
}

/** @param {Surface} surface @param {Question} question @param {Path} path */
function judge(surface, question, path) {
  const fine = refine(surface, question, path);
  if (!fine) return { verdict: 'unchecked' };
  const error = Math.abs(path.length - fine.length) / fine.length;
  const free = !fine.touchesBoundary && !fine.crossesSingularity;
  const miss = free ? missOf(surface, fine) : Number.NaN;
  const verdict = !(error <= question.tolerance) ? 'wrong' : Math.abs(miss) > MISS ? 'astray' : 'right';
  const owned = Math.abs(path.length - fine.length) <= path.lengthError + fine.lengthError;
  return { verdict, fine: fine.length, error, miss, traced: Number.isFinite(miss), owned };
}

/**
 * The same failure with as few digits as show it.
 * @param {Surface} surface @param {Answer} failure @returns {Answer}
 */
export function shorten(surface, failure) {
  for (const digits of [1, 2, 3, 4, 6, 9]) {
    const round = (/** @type {number[]} */ point) => point.map((x) => Number(x.toFixed(digits)));
    const { tolerance } = failure;
    const shorter = answer(surface, { from: round(failure.from), to: round(failure.to), tolerance });
    if (shorter.verdict === failure.verdict && shorter.status === failure.status) return shorter;
  }
  return failure;
}

/**
 * Asks about random pairs until there are enough, or the time is up.
 * @param {Surface} surface @param {import('../../helpers/random.js').Random} random @param {() => number[]} point @param {number} count @param {number} [seconds]
 * @returns {Answer[]}
 */
export function askAbout(surface, random, point, count, seconds = Infinity) {
  const end = performance.now() + 1000 * seconds;
  const answers = [];
  while (answers.length < count && performance.now() < end)
    answers.push(answer(surface, { from: point(), to: point(), tolerance: random.pick(TOLERANCES) }));
  return answers;
}
