/** Candidates solved as they were asked for: rough paths, best ones first, and ways that rough polylines cannot follow. */

import { SHEET_JUMP } from '../runtime/status.js';
import { COMPARED_POINTS, compared, ELEMENTS, endAlike, holds, isOnSurface, lengthOfShortest, MARGIN } from './candidates.js';
import { distinct, estimate, isAmong, isBesideWay } from './distinct.js';
import { refine } from './poles.js';
import { innerOf } from './join.js';
import { finer, isJudged, isOneOfMany, isTooCoarse, MOST_ROUGH, sharpen } from './rough.js';

/** @typedef {import('./candidates.js').Found} Found */
/** @typedef {import('./candidates.js').Problem} Problem */
/** @typedef {import('./candidates.js').RawPath} RawPath */
/** @typedef {import('./candidates.js').SolveOptions} SolveOptions */
/** @typedef {import('./candidates.js').Tried} Tried */
/** @typedef {import('./candidates.js').Way} Way */

/** Of the rough paths that may be the shortest so many are solved finely: in space, and in a metric, where what they are long says less. */
const [MOST_FINE, MOST_FINE_METRIC] = [8, 16];
/** In a metric a path may be shorter than its rough one's length and error say by so many errors, where that has many nodes and where it has few. */
const [ERRORS, MORE_ERRORS] = [3, 8];
/** Where a path is not solved to the tolerance, another start may lead to it: a rough one that looks longer by no more than this. One not at rest is shorter only if by more. */
const SURELY = 1.02;
/** What a rough path's length is wrong by, in parts of the error that it has by itself, at most. */
const LEFT = 0.2;
/** Of the ways that rough polylines cannot follow, the shortest first, so many are solved; if nothing holds, up to so many. */
const [LEAST_UNFOLLOWED, MOST_UNFOLLOWED] = [2, 6];

/** In space the error of a rough path is known by its sign, in a metric by its size only, and that not well from few points. @param {Problem} problem @param {RawPath} path */
const doubt = (problem, path) =>
  0.5 * MARGIN * path.length + (problem.isPlain ? 0 : (isJudged(problem, path) ? ERRORS : MORE_ERRORS) * path.lengthError);

/** What the path under a rough one is long at least. @param {Problem} problem @param {RawPath} path */
export const atLeast = (problem, path) => estimate(path) - doubt(problem, path);

/**
 * Solves the rough paths finely, as many as may be the shortest, or as are wanted.
 * @param {Problem} problem @param {SolveOptions} options @param {number} most
 * @param {{ rough: Found[], passing: Found[], over: Way[] }} candidates passing: those that hold beside poles; over: those over poles
 * @returns {[usable: Found[], failed: RawPath[]]}
 */
export function solveFinely(problem, options, most, { rough, passing, over }) {
  const doubtOf = (/** @type {Found} */ found) => found.doubt ?? doubt(problem, found.path);
  /* What is found finely may be longer than it looked: then so may what looked longer be the shortest. In a metric it may as well be much shorter, and what it looked like says no more. */
  const mayBeShortest = (/** @type {Found} */ found) =>
    begun.length < (problem.isPlain ? MOST_FINE : MOST_FINE_METRIC) &&
    estimate(found.path) - doubtOf(found) <=
      Math.max(
        problem.isPlain || usable.length === 0 ? estimate(rough[0].path) + doubtOf(rough[0]) : 0,
        Math.min(lengthOfShortest(usable), SURELY * Math.min(...failed.filter(isOnSurface).map(estimate))),
      );
  /** @type {Found[]} */
  let usable = [...passing];
  /** @type {RawPath[]} */
  const failed = [];
  /** Rough paths that were solved: what comes to one of them, with more points, leads to the same. @type {Found[]} */
  const begun = [];
  for (let queue = rough; queue.length > 0; ) {
    const [found, ...rest] = queue;
    queue = rest;
    if (most > 1 && usable.length === most) break;
    /* The next one may be, if there is more doubt of it. */
    if (most === 1 && !mayBeShortest(found)) continue;
    if (isAmong(passing, found) || over.some((way) => isBesideWay(way, found, problem.domain))) continue;
    if (most === 1 && found !== rough[0] && isOneOfMany(rough[0].path, found.path)) continue;
    const sharper = sharpen(problem, found);
    if (sharper) {
      if (!isAmong(usable, sharper) && !isAmong(begun, sharper)) queue = distinct([sharper, ...rest]);
      continue;
    }
    begun.push(found);
    const refined = refineWell(problem, found, options);
    if (holds(refined)) usable = distinct([...usable, refined]);
    else failed.push(refined.path);
    if (endAlike(failed)) break;
  }
  return [usable, failed];
}

/**
 * A rough path as it was asked for. In space one that turns out longer than its rough one may be wrong by is another: of few nodes elements leave it where waves are many. Then
 * the shortest of those from more.
 * @param {Problem} problem @param {Found} found @param {SolveOptions} options @returns {Found}
 */
function refineWell(problem, found, options) {
  const isFew = options.algorithm === ELEMENTS && options.points < COMPARED_POINTS;
  const refineFrom = (/** @type {Found} */ one) => {
    const again = (/** @type {SolveOptions} */ wanted) => refine(problem, one, wanted);
    return isFew ? { to: one.to, path: { ...again(compared(options)), again }, again } : { to: one.to, path: again(options) };
  };
  let refined = refineFrom(found);
  const isLeft = (/** @type {Found} */ { path }) =>
    problem.isPlain && holds(refined) && refined.path.length - estimate(path) > LEFT * path.lengthError;
  let one = isLeft(found) ? finer(problem, found) : null;
  while (one && isLeft(one)) {
    const other = refineFrom(one);
    if (holds(other) && other.path.length < refined.path.length) refined = other;
    one = innerOf(one.path) <= MOST_ROUGH ? finer(problem, one) : null;
  }
  return refined;
}

/**
 * Those of the starts that rough polylines could not follow, and that may lead to the shortest path.
 * @param {Problem} problem @param {Tried[]} unknown @param {number} shortest length of the shortest path so far
 */
export const unfollowedOf = (problem, unknown, shortest) =>
  unknown.filter(
    ({ start, path }) =>
      start &&
      (path.crossesSingularity
        ? !isPointed(problem)
        : (isTooCoarse(path) && !(path.length > shortest)) || (isOnSurface(path) && SURELY * estimate(path) < shortest)),
  );

/**
 * Ways of the graph that rough polylines cannot follow: across a cuspidal edge, around a rim that is sharper than their chords, or along a road on which length is a tenth of what
 * it is beside it, where they take too many steps.
 * @param {Problem} problem @param {SolveOptions} options @param {Tried[]} unfollowed @param {boolean} isFound some path holds already
 */
export function followAsTheyAre({ solve }, options, unfollowed, isFound) {
  const most = isFound ? LEAST_UNFOLLOWED : MOST_UNFOLLOWED;
  /** @type {Found[]} */
  const found = [];
  /* Chords jump where the rough ones did; what was not at rest yet they lead to as well. */
  const able = options.algorithm === ELEMENTS ? unfollowed : unfollowed.filter(({ path }) => isOnSurface(path));
  const isLonger = (/** @type {RawPath} */ path) =>
    !path.crossesSingularity && found.some((one) => holds(one) && path.length > one.path.length);
  for (const one of able.slice(0, most)) {
    const { to, start, path } = one;
    if (isLonger(path) || (found.length >= LEAST_UNFOLLOWED && (!path.crossesSingularity || found.some(holds)))) continue;
    one.followed = solve(to, start, options);
    const fine = one.followed.status === SHEET_JUMP ? one.fine?.() : undefined;
    if (fine) one.followed = solve(to, fine, options);
    found.push({ to, path: one.followed });
  }
  return found;
}

/** Whether no other places are singular than poles and apices: a path that is singular there leads across nothing, and ways over them are solved as such. @param {Problem} problem */
const isPointed = ({ domain, graph }) => !!domain?.poles.length && !graph(0)?.singular;
