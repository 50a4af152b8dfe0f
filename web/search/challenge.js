/** Whether a path can be the shortest, where ways of the graph, or the straight line, were not followed: these are measured on the surface itself, or solved. */

import { STALLED } from '../runtime/status.js';
import { endAlike, holds, leaps, MARGIN, within } from './candidates.js';
import { estimate } from './distinct.js';
import { divide } from './join.js';
import { sumOf } from '../vector.js';

/** @typedef {import('./candidates.js').RawPath} RawPath */
/** @typedef {import('./candidates.js').SolveOptions} SolveOptions */
/** @typedef {import('./candidates.js').Tried} Tried */
/** @typedef {import('./candidates.js').Problem} Problem */

/** Of the ways that were not, the shortest first, so many are measured, in so many chords, at least. */
const MOST_MEASURED = 8;
/** In space fewer chords are shorter: a way that is too long in these is too long in those. */
const [COARSE, MEASURED] = [512, 32_768];
/** What the straight line leads to it leads to in as many steps, mostly: more are for where there is nothing else. */
const STEPS = 100;

/**
 * The path, or one that is shorter, of a way that could not be followed roughly. Where such a way is shorter than all that were found there is a shorter path,
 * and what is known of it is only that: `stalled`.
 * @param {Problem} problem @param {SolveOptions} options @param {RawPath} best @param {Tried[]} tried
 * @param {RawPath} [known] one that holds, where the best may be shorter
 * @returns {RawPath}
 */
export function challenge(problem, options, best, tried, known) {
  const { chords, isPlain, solve } = problem;
  let path = besideStraight(problem, options, best, tried, known);
  if (!chords || !holds({ path })) return path;
  let least = Infinity;
  const isShorter = (/** @type {number} */ length) => length < path.length * (1 - MARGIN);
  const open = tried.filter((one) => one.start && (!holds(one) || leaps(problem, one.path) || isShorter(one.path.length)));
  /** @type {RawPath[]} */
  const failed = [];
  for (const { to, start, followed } of open.slice(0, MOST_MEASURED)) {
    const way = /** @type {Float64Array} */ (start);
    const measure = (/** @type {number} */ count) => sumOf(chords(divide(way, 2, Math.ceil((2 * count) / way.length))));
    if (isPlain && !isShorter(measure(COARSE))) continue;
    const length = measure(MEASURED);
    if (!isShorter(length)) continue;
    least = Math.min(least, length);
    if (endAlike(failed)) continue;
    const shorter = followed ?? solve(to, start, options);
    if (!holds({ path: shorter })) failed.push(shorter);
    else if (shorter.length < path.length && !leaps(problem, shorter)) path = shorter;
  }
  return isShorter(least) ? { ...path, status: STALLED } : path;
}

/**
 * The path, or that of the straight line, where few chords strayed from this and it is shorter, or what was found is none and not surely shorter.
 * @param {Problem} problem @param {SolveOptions} options @param {RawPath} best @param {Tried[]} tried @param {RawPath} [known] one that holds: then it must be shorter than that, too
 */
function besideStraight(problem, options, best, tried, known) {
  const found = holds({ path: best });
  const most = found ? best.length * (1 - MARGIN) : Math.min(best.length + best.lengthError, known?.length ?? Infinity);
  const line = problem.domain && !problem.branches.length && tried.find(({ start, path }) => !start && (!found || estimate(path) < most));
  const straight = line ? problem.solve(line.to, null, found ? within(options, STEPS) : options) : best;
  return straight.length >= most || leaps(problem, straight) || !holds({ path: straight }) ? best : straight;
}
