/** Numbers and outcomes as a reader wants them: short, in plain words, with what to do. */

const MINUS = '\u2212';
/** Of a length: at most, and where its error is not known. */
const [MOST_DIGITS, FEW_DIGITS] = [9, 7];
/** Powers of ten from which, and below which, numbers are written without one. */
const [LEAST_ORDER, MOST_ORDER] = [-4, 6];
const DIGITS = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];

/** @type {Record<string, [string, string]>} what happened, what to do, by Path.status */
const OUTCOMES = {
  converged: ['Converged', 'No path nearby is shorter.'],
  'iteration-limit': ['Stopped early', 'The iterations ran out: choose fewer points or move the ends a little.'],
  stalled: ['Stuck', 'No step made the path shorter, or a shorter way leads to no path: try another algorithm or fewer points.'],
  'tolerance-not-met': ['Not exact enough', 'Choose a larger tolerance, or narrow the ranges.'],
  'ill-conditioned': ['Doubtful', 'The surface is almost singular along the path: narrow its ranges.'],
  saddle: ['Balanced, not shortest', 'A path beside it is shorter: choose another algorithm, or move an end a little.'],
  'edge-reached': ['Ended at the edge', 'The path left the surface there.'],
  disconnected: ['No path', 'The two ends lie on different pieces of this surface: move one of them.'],
  'singular-metric': ['No path', 'The surface has a crease or a tip on the way: narrow its ranges or move the ends.'],
  'sheet-jump': [
    'No path',
    'The straight start jumps to another part of the surface: start from a global search, or move the ends nearer to each other.',
  ],
  'off-surface': ['No path', 'An end point lies too far from the surface: move it nearer.'],
  'not-finite': ['No path', 'The formula has no value somewhere on the way: narrow its ranges or move the ends.'],
  'out-of-memory': ['No path', 'There was not enough memory: choose fewer points.'],
};

/**
 * @param {string} status of a Path
 * @param {{ start: string, task: string }} asked
 * @returns {[string, string]} what happened, what to do
 */
export function describeStatus(status, { start, task }) {
  const [words, advice] = OUTCOMES[status] ?? [status, ''];
  if (status !== 'converged') return [words, advice];
  if (task === 'trace') return [words, 'Straight ahead from A.'];
  return [words, start === 'global' && task === 'path' ? 'No shorter path was found.' : advice];
}

/** The power of ten of a number's first digit, once it is rounded. @param {number} x @param {number} digits */
const orderOf = (x, digits) => Number(x.toExponential(digits - 1).split('e')[1]);

/** A number with so many significant digits, in the reader's typography; with a power of ten where there would be many zeros. @param {number} x @param {number} [digits] */
export function formatNumber(x, digits = 6) {
  if (!Number.isFinite(x)) return '–';
  const order = orderOf(x, digits);
  if (order >= LEAST_ORDER && order < Math.max(MOST_ORDER, digits))
    return Number(x.toPrecision(digits))
      .toFixed(Math.max(digits - 1 - order, 0))
      .replace('-', MINUS);
  const mantissa = x
    .toExponential(digits - 1)
    .replace(/e.*/, '')
    .replace('-', MINUS);
  return `${mantissa} × 10${[...String(order)].map((c) => (c === '-' ? '⁻' : DIGITS[Number(c)])).join('')}`;
}

/** A number down to the first digit that is uncertain, as far as a reader follows. @param {number} x @param {number} uncertainty */
export function formatTo(x, uncertainty) {
  const digits = uncertainty > 0 && uncertainty < Infinity ? orderOf(x, MOST_DIGITS) - orderOf(uncertainty, 1) + 1 : FEW_DIGITS;
  return formatNumber(x, Math.min(Math.max(digits, 1), MOST_DIGITS));
}

/** @param {number} x a small positive estimate */
export const formatEstimate = (x) => (Number.isFinite(x) && x !== 0 ? `± ${formatNumber(x, 1)}` : '');

/** @param {number} milliseconds */
export const formatTime = (milliseconds) => `${milliseconds < 100 ? Number(milliseconds.toPrecision(2)) : Math.round(milliseconds)} ms`;
