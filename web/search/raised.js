/**
 * Paths on steep surfaces. On its way from crest to crest a path turns within a thousandth of its length: chords jump, and of all ways the graph sees none along lines of equal height. With
 * lower heights the path is found as any other; then it follows the surface, which is raised step by step. MATH.md, "Steep surfaces".
 */

import { isGeodesic } from '../path.js';
import { compared } from './candidates.js';
import { branchesOf, findGlobal, solveNear } from './routes.js';

/** @typedef {import('../path.js').Path} Path */
/** @typedef {import('./routes.js').Field} Field */
/** @typedef {import('../runtime/heap.js').SolveOptions} SolveOptions */
/**
 * @typedef {object} Lowered
 * @property {number} steepness root mean square of its slopes
 * @property {(height: number) => Field | null} at it with its heights multiplied by a number; null: there is no room for it. Valid until the next one
 */

/** How steep a surface is made on which the first path is looked for: each may lead to another one. */
const SLOPES = [12, 6, 3];
/** By what heights are multiplied at first, at most, by how much more after each path that was found, and at least; and how often that may be in vain. */
const [FIRST, MOST, FASTER, LEAST, OFTEN] = [1.5, 2, 1.3, 1.05, 4];
/** Paths of one height that are as long up to this part are the same. */
const SAME = 1e-9;
/** A path is handed on by so many points: between fewer, lines straight over u and v lead over crests. */
const POINTS = 16383;
/** It is followed in no more steps than these: what takes more has become another one; but where it comes to touch an edge it takes more. */
const [STEPS, MORE_STEPS] = [100, 400];

/**
 * The shortest of the paths between two ends that are found with lower heights; null: none can be raised, or is short enough.
 * @param {Lowered} low @param {Field} field @param {number[][]} ends @param {SolveOptions} options @param {number} most what it must be shorter than @returns {Path | null}
 */
export function findRaised(low, field, ends, options, most) {
  const roughly = { ...compared(options), points: POINTS };
  /** @type {Path | null} */
  let shortest = null;
  const passed = new Map();
  for (const slope of SLOPES) {
    const height = slope / low.steepness;
    const path = height < 1 ? raise(low.at, ends, roughly, height, { passed, most }) : null;
    if (path && path.length < most) [shortest, most] = [path, path.length];
  }
  return shortest && solveNear(field, ends, options, shortest.parameters);
}

/**
 * A path found on a lower surface, followed to the height that this has; null: it cannot be, or comes to where another one was.
 * @param {(height: number) => Field | null} at @param {number[][]} ends @param {SolveOptions} options @param {number} height the first
 * @param {{ passed: Map<number, number>, most: number }} known lengths of paths that were followed, by height; and what it must be shorter than: it grows with its heights
 */
function raise(at, ends, options, height, { passed, most }) {
  const low = at(height);
  /** With branch points it stands upright somewhere: it lies over no plane. @type {Path | null} */
  let path = low && branchesOf(low).length === 0 ? findGlobal({ ...low, isBrief: true }, ends, options, 1)[0] : null;
  if (!path || !isGeodesic(path)) return null;
  let factor = FIRST;
  for (let failures = 0; height < 1; ) {
    if (failures === OFTEN || factor < LEAST || path.length > most) return null;
    const higher = Math.min(factor * height, 1);
    const field = at(higher);
    /** @type {Path} */
    const before = path;
    const follow = (/** @type {number} */ maxIterations) =>
      field && solveNear(field, ends, { ...options, maxIterations }, before.parameters);
    let next = follow(STEPS);
    if (next && !isGeodesic(next) && next.touchesBoundary) next = follow(MORE_STEPS);
    if (next && isGeodesic(next)) {
      if (Math.abs(next.length - (passed.get(higher) ?? 0)) < SAME * next.length) return null;
      passed.set(higher, next.length);
      [path, height] = [next, higher];
      factor = Math.min(factor * FASTER, MOST);
    } else {
      failures++;
      /* What leads to the full height at once is not tried again by more. */
      factor = Math.sqrt(Math.min(factor, 1 / height));
    }
  }
  return path;
}
