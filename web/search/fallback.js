/** What is answered where paths that hold are missing, or longer than one that does not. */

import { emptyPath } from '../runtime/result.js';
import { DISCONNECTED, NOT_FINITE, OFF_SURFACE, SINGULAR_METRIC, STALLED } from '../runtime/status.js';
import { asAsked, ELEMENTS, holds, isOnSurface, solveFrom } from './candidates.js';
import { byEstimate, estimate, isAmong } from './distinct.js';
import { refine } from './poles.js';
import { FINEST, ROUGHLY, solveIn, UNSURE } from './rough.js';

/** @typedef {import('./candidates.js').Found} Found */
/** @typedef {import('./candidates.js').Problem} Problem */
/** @typedef {import('./candidates.js').RawPath} RawPath */
/** @typedef {import('./candidates.js').SolveOptions} SolveOptions */
/** @typedef {import('./candidates.js').Tried} Tried */

/** Why a straight start comes to nothing that has to do with an end alone. */
const BAD_ENDS = [SINGULAR_METRIC, OFF_SURFACE, NOT_FINITE];
/** A path that stalls is believed to be as long as it says where its rough one extrapolates to that, to this part of it. */
const AGREEMENT = 1e-6;
/** So many of those that stall are solved with more points. */
const MOST_FINE = 3;

/** Those that are paths. @param {RawPath[]} paths */
const shortestFirst = (paths) => paths.filter(({ length }) => length > 0).sort((a, b) => a.length - b.length);

/**
 * A path that does not hold but is shorter than the best of those that do.
 * @param {Problem} problem @param {SolveOptions} options @param {RawPath | undefined} best
 * @param {{ failed: RawPath[], unknown: Found[] }} others failed: solved finely; unknown: rough ones that may be no path that was found
 * @returns {RawPath | null | undefined}
 */
export function shorterThan(problem, options, best, { failed, unknown }) {
  const least = best ? best.length * (1 - options.tolerance) - best.lengthError : Infinity;
  let shortest = /** @type {RawPath | null} */ (null);
  for (const path of shortestFirst(failed)) {
    /* Of two that do not hold, that one is better which is shorter at most. */
    if (shortest && !holds({ path: shortest }) && !(estimate(path) < estimate(shortest))) continue;
    shortest = shorterAnyway(problem, path, shortest?.length ?? least, options) ?? shortest;
  }
  return shortest ?? (best && stalledBeside(problem, unknown, options, best));
}

/**
 * What is returned where nothing holds.
 * @param {Problem} problem @param {SolveOptions} options @param {number} status of the search @param {{ tried: Tried[], failed: RawPath[], beside: Found[] }} others
 * @returns {RawPath}
 */
export function withoutAny(problem, options, status, { tried, failed, beside }) {
  const [fine] = shortestFirst(solveFine(problem, tried, options));
  if (fine) return fine;
  if (beside.length > 0 && !failed.some(isOnSurface)) return asAsked(beside[0], options);
  /* A path that is none of the best is better than none, if what is shorter can be told. */
  const [weakest] = shortestFirst(failed);
  if (weakest || (failed.length > 0 && !(problem.isPlain && problem.domain))) return weakest ?? failed[0];
  const isApart = status === DISCONNECTED && !BAD_ENDS.includes(tried[0].path.status);
  const last = isApart ? emptyPath(status) : solveWeakly(problem, tried, options);
  return last.length > 0 ? last : (failed[0] ?? last);
}

/** Those that would be locally shortest if they were at rest, the shortest first. @param {Found[]} tried */
const weakOf = (tried) => tried.filter(({ path }) => path.index === 0 && path.length >= 0).sort(byEstimate);

/**
 * Where all stall, as chords are too long for a surface of many waves: what the shortest lead to with as many as are tried at most.
 * @param {Problem} problem @param {Tried[]} tried @param {SolveOptions} options @returns {RawPath[]} those that hold
 */
function solveFine(problem, tried, options) {
  const isLong = options.algorithm === ELEMENTS && tried.every(({ path }) => path.status === STALLED);
  /** @type {Found[]} */
  const found = [];
  for (const weak of isLong ? weakOf(tried).slice(0, MOST_FINE) : []) {
    const fine = solveIn(problem, weak, FINEST);
    if (holds(fine) && !isAmong(found, fine)) found.push(fine);
  }
  return found.map((fine) => refine(problem, fine, options)).filter((path) => holds({ path }));
}

/**
 * Beside a pole rough paths stall, the shortest among them: a path that is shorter than the best of those that do not, of its own status.
 * @param {Problem} problem @param {Found[]} unknown @param {SolveOptions} options @param {RawPath} best
 */
function stalledBeside(problem, unknown, options, best) {
  const [weak] = problem.domain?.poles.length ? weakOf(unknown.filter(({ path }) => path.status === STALLED)) : [];
  const least = best.length * (1 - options.tolerance);
  if (!weak || !(estimate(weak.path) < least)) return null;
  const path = refine(problem, weak, options);
  const isMeant = Math.abs(path.length - estimate(weak.path)) <= AGREEMENT * path.length;
  return isMeant && path.length + path.lengthError < least - best.lengthError ? path : null;
}

/**
 * A path that was not solved to the tolerance (iteration-limit, tolerance-not-met) but may be shorter than the best of those that were: it is one on the surface.
 * A fine polyline tells whether its error leaves that open, and may lead to it; null: it is not shorter.
 * @param {Problem} problem @param {RawPath} path @param {number} least what it must be shorter than @param {SolveOptions} options @returns {RawPath | null}
 */
function shorterAnyway(problem, path, least, options) {
  const { length, lengthError } = path;
  if (!isOnSurface(path) || !(length < least)) return null;
  /* Who allows fewer steps than that takes wants to know where they end. */
  if (options.maxIterations < ROUGHLY.maxIterations) return path;
  const finer = solveIn(problem, { to: problem.to, path }, FINEST);
  const isClear = lengthError <= UNSURE * length && length + lengthError < least;
  if (!holds(finer) && (isClear || !isOnSurface(finer.path))) return path;
  /* One not at rest yet may come to anything. */
  if (!holds(finer) || estimate(finer.path) < least) {
    const refined = solveFrom(problem, finer, options);
    if (refined.length < least && (holds({ path: refined }) || refined.lengthError < lengthError)) return refined;
    /* Of one that is wrong by as much as it is long nothing is known. */
    if (!holds({ path: refined })) return lengthError < length ? path : null;
  }
  return length + lengthError < least ? path : null;
}

/** What can be had where no start leads to a path that holds: from the best of those that do not, or straight. @param {Problem} problem @param {Found[]} tried @param {SolveOptions} options */
function solveWeakly(problem, tried, options) {
  const [best] = weakOf(tried);
  return best ? refine(problem, best, options) : problem.solve(tried[0].to, null, options);
}
