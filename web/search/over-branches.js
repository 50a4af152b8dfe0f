/** Ways through the branch points of a parametric surface: of all chains of legs from point to point the shortest. MATH.md, "Branch points". */

import { moveNear } from '../manifold/lifts.js';
import { isGeodesic } from '../path.js';
import { CONVERGED, STALLED } from '../runtime/status.js';
import { gap } from '../vector.js';
import { angleThrough } from './branches.js';
import { asAsked, compared, ELEMENTS, holds, lengthOfShortest, MARGIN } from './candidates.js';
import { findChain } from './chain.js';
import { joinLegs, reverse } from './join.js';

/** @typedef {import('./candidates.js').Problem} Problem */
/** @typedef {import('./candidates.js').SolveOptions} SolveOptions */
/** @typedef {import('./candidates.js').Way} Way */
/** @typedef {import('../path.js').Path} Path */
/** @typedef {{ at: number[], point: Float64Array }} Place u v, and x y z */

/** Legs are first solved with so many points, then in so many parts, at least, which tell where they lead from a branch point. */
const [POINTS, PARTS] = [31, 4096];
/** A path may turn so much, radians, as at poles (wasm/pole.c). */
const STRAIGHT = 1e-6;
/** An end nearer to a branch point than this part of what is between the ends is that point. */
const SAME = 1e-9;

/**
 * The shortest way through branch points, one or more, if it may be shorter than what was found: `stalled` where it has a corner.
 * @param {Problem} problem @param {SolveOptions} options @param {import('./candidates.js').Found[]} found those that hold @returns {Way[]} none or one
 */
export function overBranches(problem, options, found) {
  const { domain, positions, to, near } = problem;
  if (problem.isLeg || options.algorithm !== ELEMENTS || !domain || !positions || problem.branches.length === 0) return [];
  const { places, legs } = findLegs(problem, positions, options, (1 + MARGIN) * lengthOfShortest(found));
  if (legs.length < 2) return [];
  const join = (/** @type {SolveOptions} */ asked, least = 1) => {
    const solve = (/** @type {number} */ k, /** @type {SolveOptions} */ own) =>
      near([places[k].at, places[k + 1].at], own, /** @type {Float64Array} */ (legs[k].parameters));
    return joinLegs(legs, asked, solve, domain, least);
  };
  const { path, parts } = join(compared(options), PARTS);
  if (!parts.every(isGeodesic)) return [];
  const corner = places.slice(1, -1).reduce((sum, branch, k) => {
    const sides = [reverse(parts[k]), parts[k + 1]].map(({ parameters }) => {
      const own = Float64Array.from(/** @type {Float64Array} */ (parameters));
      moveNear(domain, own, branch.at);
      return own;
    });
    const turn = Math.PI - angleThrough(domain, positions, branch, sides);
    return turn <= STRAIGHT ? sum : sum + (turn < 2 ? turn : 2) * Math.min(parts[k].length, parts[k + 1].length);
  }, 0);
  const judged = (/** @type {Path} */ whole) =>
    corner === 0 && isGeodesic(whole)
      ? { ...whole, status: CONVERGED }
      : { ...whole, status: STALLED, index: -1, lengthError: whole.lengthError + corner };
  return [
    {
      to,
      path: judged(path),
      again: (asked) => judged(join(asked).path),
      ...{ pole: 0, beyond: 0, at: places[1].point, radius: 0, smooth: false, bound: path.length },
    },
  ];
}

/** Where a path near a start came to nothing: the shortest through branch points, if it is one. @param {Problem} problem @param {SolveOptions} options */
export const passBranches = (problem, options) =>
  overBranches(problem, options, [])
    .filter(holds)
    .map((found) => asAsked(found, options));

/**
 * The shortest way through branch points; no legs where it is longer than that, or one of them is no path.
 * @param {Problem} problem @param {(places: ArrayLike<number>) => Float64Array} positions @param {SolveOptions} options @param {number} most
 * @returns {{ places: Place[], legs: Path[] }}
 */
function findLegs({ from, to, branches, leg }, positions, options, most) {
  const ends = [from, to].map((at) => ({ at, point: positions(at) }));
  const isEnd = (/** @type {Place} */ { point }) => ends.some((end) => gap(end.point, point) <= SAME * gap(ends[0].point, ends[1].point));
  const places = [...ends, ...branches.filter((branch) => !isEnd(branch))];
  const asked = { ...options, points: POINTS, record: false };
  const bound = (/** @type {number} */ i, /** @type {number} */ j) => (i + j === 1 ? Infinity : gap(places[i].point, places[j].point));
  /* A leg that is no path may be none on the surface; and where it led through another branch point, that way is a chain, too. */
  const solve = (/** @type {number} */ i, /** @type {number} */ j) => {
    const path = leg([places[i].at, places[j].at], asked);
    return isGeodesic(path) ? path : { ...path, length: Number.NaN };
  };
  const { way, length, legsOf } = findChain(places.length, bound, solve, most);
  const legs = legsOf(way);
  const known = legs.flatMap((path) => path ?? []);
  const isWhole = length <= most && known.length === legs.length;
  return { places: way.map((i) => places[i]), legs: isWhole ? known : [] };
}
