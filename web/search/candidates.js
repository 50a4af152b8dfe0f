/** What a path that was found between two ends is, and how it is compared with others. */

import { CONVERGED, ILL_CONDITIONED, STALLED } from '../runtime/status.js';
import { estimate } from './distinct.js';

/** @typedef {import('../runtime/result.js').RawPath} RawPath */
/** @typedef {import('../runtime/heap.js').Graph} Graph */
/** @typedef {import('../runtime/heap.js').SolveOptions} SolveOptions */
/** @typedef {{ to: number[], start: Float64Array | null, fine?: () => Float64Array | undefined }} Start where the second end is lifted to, and a polyline, or null: straight; fine: the polyline in many points, if its graph is still there */
/** @typedef {{ to: number[], path: RawPath, again?: (options: SolveOptions) => RawPath, doubt?: number }} Found a path, and where its second end is lifted to; again: solves it as asked, where so far it was as others can be compared with; doubt: by how much it may be shorter than it looks, where that is known better than from it alone */
/** @typedef {Found & Pick<Start, 'start' | 'fine'> & { coarse: RawPath, followed?: RawPath }} Tried a start, its path solved roughly, and the one of the fewest points; followed: what it led to as it was asked */
/** @typedef {Found & import('../manifold/domain.js').Tip & { bound: number, again: (options: SolveOptions) => RawPath }} Way over a pole, or where a hole takes its place; bound: no way over it is shorter */

/**
 * @typedef {object} Problem two ends, the lexicographically smaller first, and the surface they lie on
 * @property {number[]} from
 * @property {number[]} to
 * @property {import('../manifold/domain.js').Domain | null} domain
 * @property {boolean} isPlain length is that of space
 * @property {boolean} isCreased formulas have creases, which are looked for elsewhere
 * @property {((places: ArrayLike<number>) => Float64Array) | null} positions x y z of places u v, on a parametric surface that has them
 * @property {((places: ArrayLike<number>) => Float64Array) | null} [chords] of a rectangle: how long chords between places u v one after the other are
 * @property {(places: number[]) => ArrayLike<number>[]} forms E, F and G at places, where a density or a metric measures length
 * @property {(to: number[], start: ArrayLike<number> | null, options: SolveOptions, passage?: import('../runtime/heap.js').Passage | null) => RawPath} solve from `from`
 * @property {(line: Float64Array, options: SolveOptions) => RawPath} between from the first place of a line to its last one
 * @property {boolean} isLeg a leg of a way through branch points: what leads through others is none
 * @property {boolean} isBrief where no rough path holds somebody knows better how to go on
 * @property {import('./branches.js').Branch[]} branches branch points of the surface, and what solves globally, and near a start, between two other places
 * @property {(ends: number[][], options: SolveOptions) => import('../path.js').Path} leg
 * @property {(ends: number[][], options: SolveOptions, start: Float64Array) => import('../path.js').Path} near
 * @property {(level: number) => Graph | null} graph the surface's graph, refined `level` times; null: there is none so fine
 * @property {(level: number, length: number, wide: number) => Graph | null} flood a graph around the first end, bounds or not; length: in space, of a path, or that ways are looked for up to; 0: any; wide: so many times as wide are cells
 * @property {(graph: Graph, points: number, isAll: boolean) => { status: number, distance: number, candidates: Float64Array[] }} search distance: of the shortest way; isAll: all locally shortest ways
 */

/** As sp_algorithm in wasm/surfpath.h. */
export const ELEMENTS = 0;
export const POLYLINE = 1;

/** Where more than so many end equally long, and none as it was asked, others will as well. */
const MOST_ALIKE = 2;

/** Rough lengths this much longer than the best may still turn out to be the shortest. */
export const MARGIN = 1e-3;

/** Ways longer than the shortest by more are not candidates: LONGEST of wasm/graph_search.c. */
export const LONGEST = 1.25;

/** No more steps than so many. @param {SolveOptions} options @param {number} steps @returns {SolveOptions} */
export const within = (options, steps) => ({ ...options, maxIterations: Math.min(options.maxIterations, steps) });

/** What is compared has so many points, however many are asked for: which path it is must not depend on that. */
export const COMPARED_POINTS = 64;

/** Whether a path is locally shortest, as far as can be told. @param {{ path: RawPath }} found */
export const holds = ({ path }) => path.status === CONVERGED || path.status === ILL_CONDITIONED;

/** Whether a path that does not hold is one on the surface all the same, as long as it says: no shortest one is longer. @param {RawPath} path */
export const isOnSurface = ({ status }) => status > CONVERGED && status !== STALLED;

/** @param {SolveOptions} options @returns {SolveOptions} */
export const compared = (options) => ({ ...options, points: COMPARED_POINTS, record: false });

/** @param {SolveOptions} options */
export const isCompared = ({ points, record }) => points === COMPARED_POINTS && !record;

/** @param {Found} found @param {SolveOptions} options @returns {RawPath} */
export const asAsked = ({ path, again }, options) => (again && !(isCompared(options) && holds({ path })) ? again(options) : path);

/** Infinite where there is none. @param {Found[]} list */
export const lengthOfShortest = (list) => Math.min(...list.map(({ path }) => estimate(path) || Infinity));

/** Solves from a path that was found. @param {Problem} problem @param {Found} found @param {SolveOptions} options */
export const solveFrom = ({ solve }, { to, path: { parameters, points } }, options) =>
  solve(parameters ? Array.from(parameters.subarray(-2)) : to, parameters ?? points, options);

/**
 * Whether a polyline jumps over a pole, a hole or a slit. One that passes a pole nearer than its nodes are apart turns by about half a turn in a chord.
 * @param {Problem} problem @param {RawPath} path
 */
export function leaps({ domain }, { parameters }) {
  if (!domain || !parameters) return false;
  return domain.around.some(({ along, most }) =>
    parameters.some((x, i) => i > 1 && (i & 1) === along && Math.abs(x - parameters[i - 2]) > most),
  );
}

/** Whether paths that do not hold end as long as the last of them too often. @param {RawPath[]} failed */
export const endAlike = (failed) =>
  failed.filter(({ length }) => Math.abs(length - /** @type {RawPath} */ (failed.at(-1)).length) <= MARGIN * length).length > MOST_ALIKE;
