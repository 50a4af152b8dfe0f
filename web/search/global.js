/**
 * The globally shortest path: starts from a graph search and straight lines, each solved roughly, the best ones finely. Knows the order of the
 * stages and what counts as the same path; the mathematics is in wasm/graph.h and in the solver.
 */

import { emptyPath } from '../runtime/result.js';
import { CONVERGED, SHEET_JUMP, STALLED } from '../runtime/status.js';
import { passBumps } from './bumps.js';
import { asAsked, holds, leaps, lengthOfShortest } from './candidates.js';
import { challenge } from './challenge.js';
import { BESIDE, distinct, firsts, isAmong, isSame } from './distinct.js';
import { shorterThan, withoutAny } from './fallback.js';
import { atLeast, followAsTheyAre, solveFinely, unfollowedOf } from './fine.js';
import { overBranches } from './over-branches.js';
import { challengeByEdges } from './free-edges.js';
import { besidePoles, overPoles } from './poles.js';
import { asItIs, isKnown, solveBeside, solveRoughly, stallsAtBranch } from './rough.js';
import { findStarts } from './starts.js';

/** @typedef {import('./candidates.js').RawPath} RawPath */
/** @typedef {import('./candidates.js').SolveOptions} SolveOptions */
/** @typedef {import('./candidates.js').Found} Found */
/** @typedef {import('./candidates.js').Tried} Tried */
/** @typedef {import('./candidates.js').Way} Way */
/** @typedef {import('./candidates.js').Problem} Problem */

/** Starts of a graph, those most apart from each other first, after which no other is tried if all have led to the same path, each in so few steps: from farther away others may lead elsewhere. */
const [ENOUGH, STRAIGHT] = [8, 6];
/** Points of a straight line between which elements see waves that keep its chords from coming to rest. */
const DRAWN = 4095;

/**
 * All locally shortest paths that are found between two points, shortest first; without any, the one path of a status that says why.
 * @param {Problem} problem @param {SolveOptions} options of the final solves
 * @param {number} most paths wanted; with 1 only those that may be the shortest are solved finely
 * @returns {RawPath[]}
 */
export function findPaths(problem, options, most) {
  const only = solveOnly(problem, options);
  if (only) return [only];
  /* Without a rectangle there is one straight start. */
  const tried = problem.domain ? [] : [solveRoughly(problem, { to: problem.to, start: null }, [])];
  /** @type {RawPath[]} */
  let found = [];
  for (const { starts, status } of findStarts(problem, most > 1, tried[0])) {
    found = solveBest(problem, options, most, status, tryAll(problem, starts, tried, most));
    /* A finer graph may lead where chords follow. */
    if (problem.domain || found[0].status !== SHEET_JUMP) break;
  }
  return found;
}

/**
 * The shortest of the paths that some starts lead to, none if no one is shorter than what is known, and after it, as they are roughly, all of them.
 * @param {Problem} problem @param {SolveOptions} options @param {import('./candidates.js').Start[]} starts @param {number} shortest length of the shortest path so far
 */
export function findPathsFrom(problem, options, starts, shortest) {
  const only = solveOnly(problem, options);
  if (only) return [only];
  const candidates = tryAll(problem, starts, [], Infinity);
  const { tried, rough } = candidates;
  const isLonger = tried.every((one) => holds(one) && !leaps(problem, one.path) && atLeast(problem, one.path) > shortest);
  const [path] = isLonger ? [emptyPath(STALLED)] : solveBest(problem, options, 1, CONVERGED, candidates);
  return [path, ...rough.map((found) => found.path)];
}

/** The path where there is only one, as no curvature is positive. @param {Problem} problem @param {SolveOptions} options */
function solveOnly(problem, options) {
  const { domain, to, solve } = problem;
  if (!domain || !problem.graph(0)?.unique) return null;
  const rough = solveRoughly(problem, { to, start: null }, []);
  const isAtRest = holds(rough);
  /* What winds around a hole takes hundreds of steps to the path that the search has at once. */
  if (stallsAtBranch(problem, rough) || (!isAtRest && domain.tips.length > 0)) return null;
  const start = isAtRest ? null : solve(to, null, asItIs(DRAWN)).parameters;
  const path = solve(to, start, options);
  return path.status === CONVERGED ? path : null;
}

/**
 * Solves starts roughly.
 * @param {Problem} problem @param {import('./candidates.js').Start[]} starts @param {Tried[]} tried before them @param {number} most paths wanted; with 1 no more once
 *   enough have led to one path, and none elsewhere
 */
function tryAll(problem, starts, tried, most) {
  for (const [i, start] of starts.entries()) {
    const isEnough = most === 1 && i >= ENOUGH;
    if (isEnough && tried.every(({ path }) => holds({ path }) && path.iterations <= STRAIGHT && isSame(path, tried[0].path))) break;
    tried.push(solveRoughly(problem, start, tried, most));
  }
  return { tried, rough: holding(problem, tried) };
}

/** Those that hold, each path once. @param {Problem} problem @param {Tried[]} tried @returns {Found[]} */
const holding = (problem, tried) => distinct(tried.filter((one) => holds(one) && !leaps(problem, one.path)));

/**
 * Of what the starts led to, and of ways over poles, the paths as they were asked for.
 * @param {Problem} problem @param {SolveOptions} options @param {number} most @param {number} status of the search
 * @param {ReturnType<typeof tryAll>} candidates @returns {RawPath[]}
 */
function solveBest(problem, options, most, status, { tried, rough }) {
  const through = overBranches(problem, options, rough);
  if (!problem.isLeg && !through.some(holds)) {
    tried = solveBeside(problem, tried);
    rough = holding(problem, tried);
  }
  rough = passBumps(problem, rough);
  const poles = overPoles(problem, options, tried, rough);
  const { beside, over } = besidePoles(problem, options, poles, rough);
  const ways = [...over, ...through];
  if ((problem.isLeg || problem.isBrief) && rough.length === 0 && ![...ways, ...beside].some(holds)) return [emptyPath(STALLED)];
  const found = choosePaths(problem, options, most, { tried, status, rough, ways, beside });
  const corner = most === 1 && ways.find(({ path, beyond }) => !(beyond > 0) && path.status === STALLED);
  if (corner && !(found[0].length * (1 - options.tolerance) - found[0].lengthError <= corner.path.length))
    return [asAsked(corner, options)];
  return most === 1 ? [challengeByEdges(problem, options, challenge(problem, options, found[0], tried, found[1]))] : found;
}

/**
 * The paths among all that were tried.
 * @param {Problem} problem @param {SolveOptions} options @param {number} most
 * @param {{ tried: Tried[], status: number, rough: Found[], ways: Way[], beside: Found[] }} candidates status: of the search; rough: those tried that hold; ways: over poles and through
 *   branch points; beside: those that pass poles
 * @returns {RawPath[]}
 */
function choosePaths(problem, options, most, { tried, status, rough, ways, beside }) {
  /* Charts around two poles may lead to the same path: the first one tells, whatever the last bits say. */
  const passing = firsts(beside.filter(holds));
  const over = ways.filter(holds);
  const unknown = tried.filter(
    (one) =>
      !isKnown(problem, one, tried) &&
      (one.path !== one.coarse || !stallsAtBranch(problem, one)) &&
      !isAmong(passing, one) &&
      !isAmong(over, one, BESIDE) &&
      !leaps(problem, one.path),
  );
  const [usable, failed] = solveFinely(problem, options, most, { rough, passing, over });
  const unfollowed = unfollowedOf(problem, unknown, lengthOfShortest([...rough, ...passing, ...over]));
  for (const followed of followAsTheyAre(problem, options, unfollowed, usable.length > 0))
    if (holds(followed)) usable.push(followed);
    else failed.push(followed.path);
  usable.push(...over.filter(({ path }) => path.length < lengthOfShortest(usable) - path.lengthError).slice(0, 1));
  const chosen = distinct(usable);
  const shorter = most === 1 && shorterThan(problem, options, chosen[0]?.path, { failed, unknown });
  if (!shorter && chosen.length > 0) return chosen.slice(0, most).map((found) => asAsked(found, options));
  const weak = shorter || withoutAny(problem, options, status, { tried, failed, beside });
  return [weak.again?.(options) ?? weak, ...chosen.map(({ path }) => path)];
}
