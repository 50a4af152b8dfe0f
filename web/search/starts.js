/** Where paths between two ends are started from: straight lines to lifts of the second end, and ways through a graph of the surface. */

import { neighbours } from '../manifold/lifts.js';
import { CONVERGED, DISCONNECTED, OFF_SURFACE, SINGULAR_METRIC } from '../runtime/status.js';
import { gap } from '../vector.js';
import { holds, LONGEST } from './candidates.js';

/** @typedef {import('./candidates.js').Graph} Graph */
/** @typedef {import('./candidates.js').Problem} Problem */
/** @typedef {import('./candidates.js').Start} Start */
/** @typedef {import('./candidates.js').Tried} Tried */
/** @typedef {{ graph: Graph, fine: () => Float64Array[] } & ReturnType<Problem['search']>} Looked what a graph says of the ends; fine: its candidates in many points, while it is there */

/** A flood that stopped at this many cells may not have come to its end: SP_GRAPH_FLOOD_CELLS of wasm/graph.h. */
const FLOOD_CELLS = 40_000;
/** Of a way; and of one that chords cannot follow, so many that none of them cuts off where it leads around a rim. */
const [CANDIDATE_POINTS, FINE_POINTS] = [65, 1000];
/** Where no path is known, a flood looks first where ways lead that are so many times as long as the ends are apart, then, 0, everywhere, in cells so many times as wide. */
const FLOODS = [
  [2, 1],
  [8, 1],
  [0, 4],
];
/** A flood of this level is refined only where it does not resolve the surface. */
const FINE = 2;

/**
 * Starts: the straight lines to the nearest lifts of the end, and the ways through the first graph that joins the ends; then, for who goes on as these came to nothing, those through
 * finer ones. The last status says why there are none of these.
 * @param {Problem} problem @param {boolean} isAll @param {Tried | undefined} straight the straight start, where there is no rectangle: it is none of the answer's
 * @returns {Generator<{ starts: Start[], status: number, distance?: number }, void>} distance: of the shortest way through the graph
 */
export function* findStarts(problem, isAll, straight) {
  const { from, to, domain, isPlain } = problem;
  /** @type {Start[]} */
  const starts = domain ? neighbours(domain, to, from, problem.graph(0)?.form).map((end) => ({ to: end, start: null })) : [];
  if (straight && isBadEnd(problem, straight.path.status)) return yield { starts, status: OFF_SURFACE };
  const along = (/** @type {Looked} */ looked) => {
    const { candidates, status, distance } = looked;
    for (const [i, start] of candidates.entries())
      starts.push({ to: Array.from(start.subarray(-from.length)), start, fine: () => looked.fine()[i] });
    return { starts: starts.splice(0), status, distance };
  };
  const known = straight && holds(straight) ? straight.path.length : 0;
  let status = OFF_SURFACE;
  let isFound = false;
  for (const looked of look(problem, problem.graph, domain || (isPlain && problem.graph(0)?.resolved) ? 0 : 1, isAll)) {
    status = looked.status;
    if (isOpen(status)) continue;
    isFound = true;
    yield along(looked);
  }
  /* What only hangs together outside the bounds: the straight start's path proves that it does, not that none is shorter. */
  const isOutside = status === OFF_SURFACE || (status === DISCONNECTED && known > 0);
  const apart = isPlain && (!known || isAll) ? gap(from, to) : 0;
  const floods = apart > 0 ? FLOODS.map(([times, wide]) => [times * apart, wide]) : [[isPlain ? known : 0, 1]];
  let most = Infinity;
  for (const [far, wide] of isOutside && !isFound ? floods : []) {
    const reach = Math.min(far, most);
    for (const looked of look(problem, (level) => problem.flood(level, reach, wide), 0, isAll, FINE)) {
      status = looked.status;
      if (isOpen(status)) {
        status = looked.graph.vertices === FLOOD_CELLS ? OFF_SURFACE : DISCONNECTED;
        if (status === OFF_SURFACE) break;
        continue;
      }
      /* Ways that are as short may lead farther, but no farther than this. */
      most = LONGEST * looked.distance;
      if (apart > 0 && reach > 0 && most > reach) break;
      isFound = true;
      yield along(looked);
    }
    if (isFound) break;
  }
  if (!isFound) yield { starts, status };
}

/**
 * What graphs say of the ends, from a level on.
 * @param {Problem} problem @param {(level: number) => Graph | null} find @param {number} level @param {boolean} isAll @param {number} [fine] no finer one is looked at than
 *   one of this level that resolves the surface
 * @returns {Generator<Looked, void>}
 */
function* look({ domain, search }, find, level, isAll, fine = Infinity) {
  for (let graph = find(level), before = null; graph; before = graph, graph = find(++level)) {
    /* A finer one was searched already in place of a coarse one. */
    if (graph === before) continue;
    /* Where its cells are too coarse for an implicit surface, or may be, length not being that of space, the search begins with finer ones, if there is room for these. */
    if (level === 0 && !domain && !graph.resolved) {
      const finer = find(1);
      const isRoom = finer && finer.vertices < FLOOD_CELLS;
      graph = isRoom ? finer : find(0);
      if (!graph) return;
      if (isRoom) level = 1;
    }
    const { status } = graph;
    const found = status === CONVERGED ? search(graph, CANDIDATE_POINTS, isAll) : { status, distance: 0, candidates: [] };
    /** @type {Float64Array[] | null} */
    let ways = null;
    const { isLoose } = graph;
    const looked = {
      graph,
      ...found,
      fine: () => (ways ??= isLoose ? [] : search(/** @type {Graph} */ (graph), FINE_POINTS, isAll).candidates),
    };
    yield looked;
    looked.fine = () => [];
    if (level >= fine && graph.resolved) return;
  }
}

/** Whether a finer graph may join the ends. @param {number} status */
const isOpen = (status) => status === DISCONNECTED || status === OFF_SURFACE;

/** Whether an end is to blame for the status of a straight start on an implicit surface: that no search will change. @param {Problem} problem @param {number} status */
const isBadEnd = ({ isPlain }, status) => status === OFF_SURFACE || (isPlain && status === SINGULAR_METRIC);
