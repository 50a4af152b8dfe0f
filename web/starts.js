/** Where paths between two ends are started from: straight lines to lifts of the second end, and ways through a graph of the surface. */

import { holds } from './candidates.js';
import { neighbours } from './lifts.js';
import { CONVERGED, DISCONNECTED, OFF_SURFACE, SINGULAR_METRIC } from './runtime/status.js';

/** @typedef {import('./candidates.js').Graph} Graph */
/** @typedef {import('./candidates.js').Problem} Problem */
/** @typedef {import('./candidates.js').Start} Start */
/** @typedef {import('./candidates.js').Tried} Tried */

/** A flood that stopped at this many cells may not have come to its end: SP_GRAPH_FLOOD_CELLS of wasm/graph.h. */
const FLOOD_CELLS = 40_000;
const CANDIDATE_POINTS = 65;

/**
 * Starts: the straight lines to the nearest lifts of the end, then the ways through the first graph that joins the ends. The last status says why
 * there are none of these.
 * @param {Problem} problem @param {boolean} isAll @param {Tried | undefined} straight the straight start, where there is no rectangle: it is none of the answer's
 */
export function findStarts(problem, isAll, straight) {
  const { from, to, domain } = problem;
  /** @type {Start[]} */
  const starts = domain ? neighbours(domain, to, from).map((end) => ({ to: end, start: null })) : [];
  if (straight && isBadEnd(problem, straight.path.status)) return { starts, status: OFF_SURFACE };
  const search = (/** @type {Graph} */ graph) => {
    if (graph.status !== CONVERGED) return graph.status;
    const { status, candidates } = problem.search(graph, CANDIDATE_POINTS, isAll);
    for (const start of candidates) starts.push({ to: Array.from(start.subarray(-problem.from.length)), start });
    return status;
  };
  let status = OFF_SURFACE;
  /* Where its cells are too coarse for an implicit surface, or may be, length not being that of space, the search begins with finer ones. */
  let level = problem.domain || (problem.isPlain && problem.graph(0)?.resolved) ? 0 : 1;
  const most = straight && problem.isPlain && !isAll && holds(straight) ? straight.path.length : 0;
  const flood = (/** @type {number} */ at) => problem.flood(at, most);
  for (const find of [problem.graph, flood]) {
    for (let graph = find(level); graph; graph = find(++level)) {
      if (level === 0 && !problem.domain && !graph.resolved) continue;
      status = search(graph);
      if (status !== DISCONNECTED && status !== OFF_SURFACE) break;
      if (find === problem.graph) continue;
      if (graph.vertices === FLOOD_CELLS) return { starts, status: OFF_SURFACE };
      status = DISCONNECTED;
    }
    /* What only hangs together outside the bounds: the straight start's path proves that it does, not that none is shorter. */
    if (status !== OFF_SURFACE && !(status === DISCONNECTED && straight && holds(straight))) break;
    level = 0;
  }
  return { starts, status };
}

/** Whether an end is to blame for the status of a straight start on an implicit surface: that no search will change. @param {Problem} problem @param {number} status */
const isBadEnd = ({ isPlain }, status) => status === OFF_SURFACE || (isPlain && status === SINGULAR_METRIC);
