/** Starts solved with few points, to learn which paths there are: as many points as that takes. */

import { ILL_CONDITIONED, ITERATION_LIMIT, SHEET_JUMP, STALLED } from '../runtime/status.js';
import { holds, leaps, POLYLINE, solveFrom } from './candidates.js';
import { isSame } from './distinct.js';
import { innerOf } from './join.js';

/** @typedef {import('./candidates.js').Found} Found */
/** @typedef {import('./candidates.js').Problem} Problem */
/** @typedef {import('./candidates.js').RawPath} RawPath */
/** @typedef {import('./candidates.js').Start} Start */
/** @typedef {import('./candidates.js').Tried} Tried */

/** Inner points of the rough solves, until one holds; and of one that must tell what elements did not. */
const ROUGH = [31, 63, 127, 255];
/** So many of them where formulas have creases: across these no polyline comes to rest. */
const FEW = 2;
export const MOST_ROUGH = 255;
export const FINEST = 1023;
export const ROUGHLY = { tolerance: 1e-6, gradientTolerance: 0, algorithm: POLYLINE, maxIterations: 60, record: false };
/** @param {number} points */
export const roughlyIn = (points) => ({ ...ROUGHLY, points });
/** A start as it is, in so many points. @param {number} points */
export const asItIs = (points) => ({ ...roughlyIn(points), maxIterations: 0 });
/** From so many inner points, and so small an error in parts of the length, a rough path tells what lies under it. A metric may change between few nodes. */
const JUDGED = { space: [0, 1e-2], metric: [63, 2e-3] };
/** Rough paths at rest at the same places are equally long up to this part of it; where there are poles some stall near rest. */
const [AT_REST, NEAR_REST] = [1e-9, 1e-4];

/** An error of this part of the length is that of nodes which do not see a metric between them; of this one, it may be. */
const UNSEEN = 0.1;
export const UNSURE = 0.01;

/** @param {RawPath} path @returns {boolean} more points may help */
export const isTooCoarse = ({ status, length, lengthError }) =>
  status === STALLED || status === SHEET_JUMP || lengthError > UNSEEN * length;

/**
 * Whether a path of the fewest points that stalls is one that another start had on its way to a path that holds. At a hole, which chords jump over, so look the ways on both
 * sides of it; at a pole they are one.
 * @param {Problem} problem @param {{ to: number[], coarse: RawPath }} one @param {Tried[]} tried
 */
export const isKnown = ({ domain }, { to, coarse }, tried) =>
  coarse.status === STALLED &&
  tried.some(
    (other) =>
      holds(other) &&
      (isOneOfMany(other.coarse, coarse) ||
        (Math.abs(other.coarse.length / coarse.length - 1) <= (domain?.poles.length ? NEAR_REST : AT_REST) &&
          (!domain || domain.poles.length > 0 || other.to.every((x, j) => 2 * Math.abs(x - to[j]) < domain.upper[j] - domain.lower[j])) &&
          isSame(other.coarse, coarse))),
  );

/** Whether a path is as long as one that is one of many: between the poles of a surface of revolution each meridian is as good. @param {RawPath} one @param {RawPath} path */
export const isOneOfMany = (one, path) => one.status === ILL_CONDITIONED && Math.abs(one.length / path.length - 1) <= AT_REST;

/**
 * Whether a path of the fewest points stalls on a surface with branch points: if it leads through one, or from sheet to sheet where these cross, as they do around one, more
 * points do not help.
 * @param {Problem} problem @param {{ coarse: RawPath }} one
 */
export const stallsAtBranch = ({ branches }, { coarse }) => coarse.status === STALLED && branches.length > 0;

/**
 * Solves with few points, and with more where that does not hold, unless that was done, or the start is a straight line beside others and one path is wanted.
 * @param {Problem} problem @param {Start} start @param {Tried[]} tried @param {number} [most] paths wanted
 * @returns {Tried}
 */
export function solveRoughly(problem, start, tried, most = 1) {
  const coarse = problem.solve(start.to, start.start, roughlyIn(ROUGH[0]));
  const one = { ...start, path: coarse, coarse };
  const more = (start.start || most > 1 || !tried.length) && !isKnown(problem, one, tried) && !stallsAtBranch(problem, one);
  return more ? solveFiner(problem, one) : one;
}

/** Solves with more and more points, until it does not stall, nor jump over a wall: from the start, or from what only did not see a metric between its nodes. @param {Problem} problem @param {Tried} one @returns {Tried} */
function solveFiner(problem, one) {
  let { path } = one;
  for (const points of ROUGH.slice(1, problem.isCreased ? FEW : ROUGH.length)) {
    const isBehind = isBehindWall(problem, { ...one, path });
    if (!isTooCoarse(path) && !isBehind) break;
    const finer = roughlyIn(points);
    const mayLead = !isBehind && path.status !== STALLED && path.lengthError < path.length;
    path = mayLead ? solveFrom(problem, { ...one, path }, finer) : problem.solve(one.to, one.start, finer);
  }
  /* Across many waves the straight line has far to go. */
  if (path.status === ITERATION_LIMIT) ({ path } = solveIn(problem, { ...one, path }, innerOf(path)));
  return { ...one, path };
}

/** Whether a rough path went to where it is longer than its start: it does not see between its nodes how dear that is. @param {Problem} problem @param {Tried} one */
function isBehindWall({ isPlain, solve }, { to, start, path }) {
  if (isPlain || !start || !holds({ path }) || !(path.lengthError > UNSURE * path.length)) return false;
  const measured = [start, path.parameters ?? path.points].map((line) => solve(to, line, asItIs(MOST_ROUGH)).length);
  return measured[0] < measured[1];
}

/** Where no way leads through branch points: those of the starts that stalled, solved with more points. @param {Problem} problem @param {Tried[]} tried */
export const solveBeside = (problem, tried) =>
  tried.map((one) => (one.start && stallsAtBranch(problem, one) ? solveFiner(problem, one) : one));

/** Whether a rough path tells what lies under it, or no more points are tried. @param {Problem} problem @param {RawPath} path */
export function isJudged({ isPlain }, path) {
  const [least, error] = isPlain ? JUDGED.space : JUDGED.metric;
  return innerOf(path) >= MOST_ROUGH || (innerOf(path) >= least && !(path.lengthError > error * path.length));
}

/**
 * The path under a rough one that is too coarse to be judged, or to be compared, with twice the points; null where no more are needed, or they lead nowhere.
 * @param {Problem} problem @param {Found} found @returns {Found | null}
 */
export const sharpen = (problem, found) => (isJudged(problem, found.path) ? null : finer(problem, found));

/** What a path leads to in so many points. @param {Problem} problem @param {Found} found @param {number} points @returns {Found} */
export const solveIn = (problem, { to, path }, points) => ({ to, path: solveFrom(problem, { to, path }, roughlyIn(points)) });

/** The path under a rough one, with twice the points; null where they lead nowhere. @param {Problem} problem @param {Found} found @returns {Found | null} */
export function finer(problem, found) {
  const sharper = solveIn(problem, found, 2 * innerOf(found.path) + 1);
  return holds(sharper) && !leaps(problem, sharper.path) ? sharper : null;
}
