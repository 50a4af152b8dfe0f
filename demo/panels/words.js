/** Numbers and outcomes as a reader wants them: short, in plain words, with what to do. */

import { KINDS } from '../state/kinds.js';

/** @typedef {import('../state/sketch.js').Sketch} Sketch */

const MINUS = '\u2212';
/** Of a length: at most, and where its error is not known. */
const [MOST_DIGITS, FEW_DIGITS] = [9, 7];
/** Relative difference of lengths that are one but for rounding. */
const SAME = 1e-8;
/** Powers of ten from which, and below which, numbers are written without one. */
const [LEAST_ORDER, MOST_ORDER] = [-4, 6];
const DIGITS = '⁰¹²³⁴⁵⁶⁷⁸⁹';

/** @type {Record<string, [string, string]>} what happened, what to do, by Path.status */
const OUTCOMES = {
  converged: ['Converged', 'No path nearby is shorter.'],
  'iteration-limit': ['Stopped early', 'The iterations ran out: choose fewer points or move the ends a little.'],
  stalled: [
    'Stuck',
    'No step made the path shorter, or a shorter way leads to no path: try another algorithm, fewer points or a less steep formula.',
  ],
  'tolerance-not-met': ['Not exact enough', 'Choose a larger tolerance, or narrow the ranges.'],
  'ill-conditioned': ['One of many', 'Ways beside it are as long, as from pole to pole.'],
  saddle: ['Balanced, not shortest', 'A path beside it is shorter: choose another algorithm, or move an end a little.'],
  'edge-reached': ['Ended at the edge', 'The path left the surface there.'],
  disconnected: ['No path', 'The two ends lie on different pieces of this surface: move one of them.'],
  'singular-metric': ['No path', ''],
  'sheet-jump': ['No path', 'The straight start leaves the surface: search globally, or bring the ends closer.'],
  'off-surface': ['No path', 'An end lies too far from the surface: move it nearer.'],
  'not-finite': [
    'No path',
    'The formula has no value somewhere on the way, or one too large: narrow its ranges, move the ends or change it.',
  ],
  'out-of-memory': ['No path', 'There was not enough memory: choose fewer points.'],
};

/** Advice as it is where fewer points help nobody. */
const withoutFewer = (/** @type {string} */ advice) =>
  advice.replace('choose fewer points or ', '').replace(', fewer points or', ' or').replace(': choose fewer points', '');

/**
 * What must hold for a measure of length to be one; nothing, where it is that of space.
 * @param {Pick<Sketch, 'kind' | 'density' | 'tensor'>} sketch
 */
function conditionsOf({ kind, density, tensor }) {
  const isOfPlane = kind === 'metric' || tensor.length === 3;
  return [
    ...(density.trim() && kind !== 'metric' ? ['the density must be greater than 0'] : []),
    ...(isOfPlane ? ['E, F and G must be positive definite, with E > 0 and EG − F² > 0'] : []),
    ...(tensor.length > 3 ? ['the matrix T must be positive definite'] : []),
  ].join(', and ');
}

/** Why there is no number anywhere to colour a surface by. @param {Pick<Sketch, 'kind' | 'density' | 'tensor'>} sketch */
export function describeNoMeasure(sketch) {
  const conditions = conditionsOf(sketch);
  return conditions ? `Length is measured nowhere: ${conditions}.` : 'There is nothing to measure on this surface.';
}

/** What is smooth in place of functions that bend. @type {Record<string, string>} */
const SMOOTH = {
  abs: 'sqrt(x^2+0.01) in place of abs(x)',
  min: '(x+y-sqrt((x-y)^2+0.01))/2 in place of min(x, y)',
  max: '(x+y+sqrt((x-y)^2+0.01))/2 in place of max(x, y)',
};
/** Functions that bend or jump somewhere. */
const ROUGH = /(?<![\p{L}\d_])(?:abs|sign|floor|min|max)(?=\s*\()/u;

const LEAPS = 'The surface has a gap between the ends or is too steep: move both to one side, or change the formula.';

const WAVY = 'The surface is too steep or too wavy between the ends: bring them closer, or change the formula.';
/** Without any of these a formula has a value everywhere, and is smooth: divisions, powers but those of whole numbers, and functions but these. */
const BROKEN = /\/|\^(?!\s*\d+(?![.\d]))|(?<![\p{L}\d_])(?!(?:sin|cos|exp|sinh|cosh|tanh|atan|asinh)\s*\()[\p{L}_][\p{L}\d_]*\s*\(/u;

/** A formula that jumps, or bends: where no path is exact, and what else to do about it. @param {string} name of the function @param {string} algorithm */
function describeRough(name, algorithm) {
  if (!SMOOTH[name]) return [`Across a jump, as ${name} makes one, a path is found roughly, if at all`, ''];
  if (algorithm !== 'elements') return [`Across an edge, as ${name} makes one, only elements are exact`, 'choose that algorithm, or '];
  return [`Past a corner, where edges meet as ${name} makes them, a path is found roughly, if at all`, 'move an end a little, or '];
}

/**
 * What to do about a path that comes to no rest, or is not exact.
 * @param {Pick<Sketch, 'kind' | 'texts' | 'density' | 'tensor' | 'algorithm'>} sketch @param {string} advice for a smooth one @param {boolean} leaps see `describeStatus`
 */
function adviseStuck({ kind, texts, density, tensor, algorithm }, advice, leaps) {
  const name = [...Object.values(texts), density, ...tensor].map((text) => ROUGH.exec(text)?.[0]).find(Boolean);
  const isSmooth = kind !== 'implicit' && !Object.keys(KINDS[kind].formulas).some((name) => BROKEN.test(texts[name]));
  if (!name) return !leaps ? advice : isSmooth ? WAVY : LEAPS;
  const [where, first] = describeRough(name, algorithm);
  return `${where}: ${first}write something smooth, such as ${SMOOTH[name] ?? 'tanh(9*x) in place of a step'}.`;
}

/** Why length cannot be measured on the way. @param {Pick<Sketch, 'kind' | 'density' | 'tensor'>} sketch */
function describeSingular(sketch) {
  const conditions = conditionsOf(sketch);
  if (sketch.kind === 'metric') return `On the way ${conditions}: change them, narrow the ranges or move the ends.`;
  if (sketch.density.trim() && Number(sketch.density) <= 0) return 'The density must be greater than 0.';
  const also = conditions && `; or its measure of length fails there: ${conditions}`;
  return `The surface has a crease or a tip on the way: narrow its ranges or move the ends${also}.`;
}

/** A polyline of fewer points may not follow a surface that is in order. */
const FEW_POINTS = 24;
const COARSE = 'So few points may not follow the surface: choose more of them.';
/** @param {Pick<Sketch, 'algorithm' | 'points'>} sketch */
const isCoarse = ({ algorithm, points }) => algorithm !== 'elements' && points < FEW_POINTS;

/** The statuses of a path that may be about a gap or an edge. */
const ROUGHLY = ['stalled', 'iteration-limit', 'tolerance-not-met'];

/**
 * @param {string} status of a Path
 * @param {Pick<Sketch, 'start' | 'task' | 'kind' | 'texts' | 'density' | 'tensor' | 'points' | 'algorithm'>} sketch that was asked
 * @param {{ isFollowed?: boolean, leaps?: boolean }} [seen] isFollowed: while something moves, the path comes from the last one, others were not looked
 *   for; leaps: two points of it next to each other are far apart
 * @returns {[string, string]} what happened, what to do
 */
export function describeStatus(status, sketch, { isFollowed = false, leaps = false } = {}) {
  const { start, task, points, algorithm } = sketch;
  const [words, given] = OUTCOMES[status] ?? [status, ''];
  // Elements are as many as the tolerance asks for, whatever the points.
  const advice = points > 1 && algorithm !== 'elements' ? given : withoutFewer(given);
  if (status === 'singular-metric') return [words, describeSingular(sketch)];
  if (task === 'trace' && status === 'iteration-limit') return [words, 'The steps ran out: shorten the length.'];
  if (ROUGHLY.includes(status)) return [words, isCoarse(sketch) ? COARSE : adviseStuck(sketch, advice, leaps)];
  if (status !== 'converged') return [words, advice];
  if (task === 'trace') return [words, 'Straight ahead from A.'];
  return [words, start === 'global' && task === 'path' && !isFollowed ? 'No shorter path was found.' : advice];
}

/** By what is asked. */
const WORK = { path: 'Looking for the shortest path…', all: 'Looking for geodesics…', trace: 'Following the geodesic…' };

/** What is being computed. @param {boolean} building the surface is not there yet @param {Pick<Sketch, 'task'>} sketch that is asked */
export const describeWork = (building, { task }) => (building ? 'Drawing the surface…' : WORK[task]);

/** The outcomes of a path that is not at rest: a step would still change it. */
const MOVING = ['stalled', 'iteration-limit'];
/** Those of one that is known to be as short as can be. */
const SHORTEST = ['converged', 'ill-conditioned'];

/**
 * What a path may be called: the shortest one only if all others were looked for.
 * @param {string} status of the path @param {Pick<Sketch, 'start' | 'task' | 'via'>} sketch that was asked @param {boolean} isFirst of all that were found; none were looked for while something moves
 */
export function namePath(status, { start, task, via }, isFirst) {
  if (task === 'trace') return 'Geodesic';
  if (MOVING.includes(status)) return 'Path, not at rest';
  const isShortest = (task === 'all' || start === 'global') && isFirst && SHORTEST.includes(status);
  if (isShortest) return 'Shortest path';
  return via.length > 0 || status === 'tolerance-not-met' ? 'Path' : 'Geodesic';
}

/** The power of ten of a number's first digit, once it is rounded. @param {number} x @param {number} digits */
const orderOf = (x, digits) => Number(x.toExponential(digits - 1).split('e')[1]);

/** A power of ten. @param {number} order */
export const tenTo = (order) => `10${[...String(order)].map((c) => (c === '-' ? '⁻' : DIGITS[Number(c)])).join('')}`;

/** A number with so many significant digits, in the reader's typography; with a power of ten where there would be many zeros. @param {number} x @param {number} [digits] */
export function formatNumber(x, digits = 6) {
  if (!Number.isFinite(x)) return '–';
  if (x === 0) return '0';
  const order = orderOf(x, digits);
  if (order >= LEAST_ORDER && order < Math.max(MOST_ORDER, digits))
    return Number(x.toPrecision(digits))
      .toFixed(Math.max(digits - 1 - order, 0))
      .replace('-', MINUS);
  const mantissa = x
    .toExponential(digits - 1)
    .replace(/e.*/, '')
    .replace('-', MINUS);
  return `${mantissa} × ${tenTo(order)}`;
}

/** A number down to the first digit that is uncertain, as far as a reader follows: two at least, as the first alone may mislead. @param {number} x @param {number} uncertainty */
export function formatTo(x, uncertainty) {
  const digits = uncertainty > 0 && uncertainty < Infinity ? orderOf(x, MOST_DIGITS) - orderOf(uncertainty, 1) + 1 : FEW_DIGITS;
  return `${uncertainty > 0 && uncertainty >= Math.abs(x) && uncertainty < Infinity ? '≈ ' : ''}${formatNumber(x, Math.min(Math.max(digits, 2), MOST_DIGITS))}`;
}

/** By how much a path is longer than the shortest, as far as the digits of their lengths tell. @param {number} length @param {number} least */
export function formatLonger(length, least) {
  const share = length / least - 1;
  return Math.abs(share) < SAME ? 'as long' : `+${formatNumber(100 * share, 3)} %`;
}

/** @param {number} x a small positive estimate */
export const formatEstimate = (x) => (Number.isFinite(x) && x !== 0 ? `± ${formatNumber(x, 1)}` : '');

/** The same beside a number that has no digit of its size: only that it is less than the last one. @param {number} x @param {number} error */
export function formatEstimateOf(x, error) {
  const last = orderOf(x, MOST_DIGITS) - MOST_DIGITS + 1;
  return error > 0 && error < 10 ** last ? `error < ${tenTo(last)}` : formatEstimate(error);
}

/** @param {number} milliseconds */
export const formatTime = (milliseconds) => `${milliseconds < 100 ? Number(milliseconds.toPrecision(2)) : Math.round(milliseconds)} ms`;
