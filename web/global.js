/**
 * The globally shortest path: starts from a graph search and straight lines, each solved roughly, the best ones finely. Knows the order of the
 * stages and what counts as the same path; the mathematics is in wasm/graph.h and in the solver.
 */

import { asAsked, ELEMENTS, holds, leaps, lengthOfShortest, MARGIN, solveFrom } from './candidates.js';
import { challenge } from './challenge.js';
import { comesNear, distinct, estimate, firsts, isAmong, isSame } from './distinct.js';
import { neighbours } from './lifts.js';
import { besidePoles, overPoles, refine } from './poles.js';
import { emptyPath } from './runtime/result.js';
import {
  CONVERGED,
  DISCONNECTED,
  ILL_CONDITIONED,
  NOT_FINITE,
  OFF_SURFACE,
  SHEET_JUMP,
  SINGULAR_METRIC,
  STALLED,
} from './runtime/status.js';

/** @typedef {import('./candidates.js').RawPath} RawPath */
/** @typedef {import('./candidates.js').Graph} Graph */
/** @typedef {import('./candidates.js').SolveOptions} SolveOptions */
/** @typedef {import('./candidates.js').Start} Start */
/** @typedef {import('./candidates.js').Found} Found */
/** @typedef {import('./candidates.js').Tried} Tried */
/** @typedef {import('./candidates.js').Way} Way */
/** @typedef {import('./candidates.js').Problem} Problem */

/** Why a straight start comes to nothing that has to do with an end alone. */
const BAD_ENDS = [SINGULAR_METRIC, OFF_SURFACE, NOT_FINITE];
/** A flood that stopped at this many cells may not have come to its end: SP_GRAPH_FLOOD_CELLS of wasm/graph.h. */
const FLOOD_CELLS = 40_000;
/** Inner points of the rough solves, until one holds; and of one that must tell what elements did not. */
const ROUGH = [31, 63, 127, 255];
const MOST_ROUGH = 255;
const FINEST = 1023;
const ROUGHLY = { tolerance: 1e-6, gradientTolerance: 0, algorithm: 1, maxIterations: 60, record: false };
const CANDIDATE_POINTS = 65;
/** From so many inner points, and so small an error in parts of the length, a rough path tells what lies under it. A metric may change between few nodes. */
const JUDGED = { space: [0, 1e-2], metric: [63, 2e-3] };
/** Of the rough paths that may be the shortest so many are solved finely. */
const MOST_FINE = 8;
/** What every path is shorter than. */
const NONE = { length: Infinity, lengthError: 0 };
/** A path that stalls is believed to be as long as it says where its rough one extrapolates to that, to this part of it. */
const AGREEMENT = 1e-6;
/** Beside a way over an apex that holds, within this part of its length, is no path: rough ones come there where they stall, or cut its corner. */
const BESIDE = 0.1;
/** Rough paths at rest at the same places are equally long up to this part of it; where there are poles some stall near rest. */
const [AT_REST, NEAR_REST] = [1e-9, 1e-4];
/** Of the ways that rough polylines cannot follow, the shortest first, so many are solved; if nothing holds, up to so many. */
const [LEAST_UNFOLLOWED, MOST_UNFOLLOWED] = [2, 6];

/** @param {RawPath} path @returns {boolean} more points may help */
const isTooCoarse = ({ status }) => status === STALLED || status === SHEET_JUMP;

/**
 * All locally shortest paths that are found between two points, shortest first; without any, the one path of a status that says why.
 * @param {Problem} problem @param {SolveOptions} options of the final solves
 * @param {number} most paths wanted; with 1 only those that may be the shortest are solved finely
 * @returns {RawPath[]}
 */
export function findPaths(problem, options, most) {
  if (problem.domain && problem.graph(0)?.unique) {
    const path = problem.solve(problem.to, null, options);
    if (path.status === CONVERGED) return [path];
  }
  /* Without a rectangle there is one straight start. */
  const tried = problem.domain ? [] : [solveRoughly(problem, { to: problem.to, start: null }, [])];
  const { starts, status } = findStarts(problem, most > 1, tried[0]);
  for (const start of starts) tried.push(solveRoughly(problem, start, tried));
  const rough = distinct(tried.filter((one) => holds(one) && !leaps(problem, one.path)));
  const ways = overPoles(problem, options, tried, rough);
  const found = choosePaths(problem, options, most, { tried, status, rough, ways });
  const corner = most === 1 && ways.find(({ path, beyond }) => !(beyond > 0) && path.status === STALLED);
  if (corner && !(found[0].length * (1 - options.tolerance) - found[0].lengthError <= corner.path.length))
    return [asAsked(corner, options)];
  return most === 1 && holds({ path: found[0] }) ? [challenge(problem, options, found[0], tried)] : found;
}

/**
 * The paths among all that were tried.
 * @param {Problem} problem @param {SolveOptions} options @param {number} most
 * @param {{ tried: Tried[], status: number, rough: Found[], ways: Way[] }} candidates status: of the search; rough: those tried that hold; ways: over poles
 * @returns {RawPath[]}
 */
function choosePaths(problem, options, most, { tried, status, rough, ways }) {
  const beside = besidePoles(problem, options, ways, rough);
  /* Charts around two poles may lead to the same path: the first one tells, whatever the last bits say. */
  const passing = firsts(beside.filter(holds));
  const over = ways.filter(holds);
  const unknown = tried.filter(
    (one) => !isKnown(problem, one, tried) && !isAmong(passing, one) && !isAmong(over, one, BESIDE) && !leaps(problem, one.path),
  );
  const shortest = lengthOfShortest([...rough, ...passing, ...over]);
  const unfollowed = unknown.filter(
    ({ start, path }) => start && (path.crossesSingularity ? !isPointed(problem) : isTooCoarse(path) && !(path.length > shortest)),
  );
  /* In space the error is known by its sign, in a metric by its size only. */
  const doubt = (/** @type {RawPath} */ path) => 0.5 * MARGIN * path.length + (problem.isPlain ? 0 : 2 * path.lengthError);
  /* What is found finely may be longer than it looked: then so may what looked longer be the shortest. */
  const mayBeShortest = (/** @type {Found} */ { path }) =>
    solved < MOST_FINE &&
    estimate(path) - doubt(path) <= Math.max(estimate(rough[0].path) + doubt(rough[0].path), lengthOfShortest(usable));
  /** @type {Found[]} */
  let usable = [...passing];
  /** @type {RawPath[]} */
  const failed = [];
  let solved = 0;
  for (let queue = rough; queue.length > 0; ) {
    const [found, ...rest] = queue;
    queue = rest;
    if (most > 1 ? usable.length === most : !mayBeShortest(found)) break;
    if (
      isAmong(passing, found) ||
      isAmong(
        over.filter(({ at }) => comesNear(found.path, at)),
        found,
        BESIDE,
      ) ||
      (most === 1 && found !== rough[0] && isOneOfMany(rough[0].path, found.path))
    )
      continue;
    const sharper = sharpen(problem, found);
    if (sharper) {
      if (!isAmong(usable, sharper)) queue = distinct([sharper, ...rest]);
      continue;
    }
    solved++;
    const refined = { to: found.to, path: refine(problem, found, options) };
    if (holds(refined)) usable = distinct([...usable, refined]);
    else failed.push(refined.path);
  }
  for (const followed of asTheyAre(problem, options, unfollowed, usable.length > 0 ? LEAST_UNFOLLOWED : MOST_UNFOLLOWED))
    if (holds(followed)) usable.push(followed);
    else failed.push(followed.path);
  usable.push(...over.filter(({ path }) => path.length < lengthOfShortest(usable) - path.lengthError).slice(0, 1));
  const chosen = distinct(usable);
  const best = chosen[0]?.path;
  const weak =
    most === 1 &&
    (failed.flatMap((path) => shorterAnyway(problem, path, best ?? NONE, options) ?? []).sort((a, b) => a.length - b.length)[0] ??
      (best && stalledBeside(problem, unknown, options, best)));
  if (weak) return [weak];
  if (chosen.length > 0) return chosen.slice(0, most).map((found) => asAsked(found, options));
  const apart = status === DISCONNECTED && !BAD_ENDS.includes(tried[0].path.status);
  if (beside.length > 0 && failed.every(({ status }) => status === STALLED)) return [asAsked(beside[0], options)];
  /* A path that is none of the best is better than none, if what is shorter can be told. */
  const weakest = failed.filter(({ length }) => length > 0).sort((a, b) => a.length - b.length)[0];
  if (weakest || (failed.length > 0 && !(problem.isPlain && problem.domain))) return [weakest ?? failed[0]];
  const last = apart ? emptyPath(status) : solveWeakly(problem, tried, options);
  return [last.length > 0 ? last : (failed[0] ?? last)];
}

/**
 * Starts: the straight lines to the nearest lifts of the end, then the ways through the first graph that joins the ends. The last status says why
 * there are none of these.
 * @param {Problem} problem @param {boolean} isAll @param {Tried | undefined} straight the straight start, where there is no rectangle: it is none of the answer's
 */
function findStarts(problem, isAll, straight) {
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

/** The shortest of those that would be locally shortest if they were at rest. @param {Found[]} tried @returns {Found | undefined} */
const shortestWeak = (tried) =>
  tried.filter(({ path }) => path.index === 0 && path.length >= 0).sort((a, b) => estimate(a.path) - estimate(b.path))[0];

/**
 * Beside a pole rough paths stall, the shortest among them: a path that is shorter than the best of those that do not, of its own status.
 * @param {Problem} problem @param {Found[]} unknown @param {SolveOptions} options @param {RawPath} best
 */
function stalledBeside(problem, unknown, options, best) {
  const weak = problem.domain?.poles.length && shortestWeak(unknown.filter(({ path }) => path.status === STALLED));
  const least = best.length * (1 - options.tolerance);
  if (!weak || !(estimate(weak.path) < least)) return null;
  const path = refine(problem, weak, options);
  const isMeant = Math.abs(path.length - estimate(weak.path)) <= AGREEMENT * path.length;
  return isMeant && path.length + path.lengthError < least - best.lengthError ? path : null;
}

/**
 * A path that was not solved to the tolerance (iteration-limit, tolerance-not-met) but may be shorter than the best of those that were: it is one on the surface.
 * A fine polyline tells whether its error leaves that open, and may lead to it; null: it is not shorter.
 * @param {Problem} problem @param {RawPath} path @param {{ length: number, lengthError: number }} best @param {SolveOptions} options @returns {RawPath | null}
 */
function shorterAnyway(problem, path, best, options) {
  const { status, length, lengthError } = path;
  const least = best.length * (1 - options.tolerance) - best.lengthError;
  if (status <= CONVERGED || status === STALLED || !(length < least)) return null;
  /* Who allows fewer steps than that takes wants to know where they end. */
  if (options.maxIterations < ROUGHLY.maxIterations) return path;
  const finer = { to: problem.to, path: solveFrom(problem, { to: problem.to, path }, { ...ROUGHLY, points: FINEST }) };
  if (!holds(finer)) return path;
  if (estimate(finer.path) >= least) return length + lengthError < least ? path : null;
  const refined = solveFrom(problem, finer, options);
  return holds({ path: refined }) && refined.length < least ? refined : path;
}

/**
 * Ways of the graph that rough polylines cannot follow: across a cuspidal edge, or around a rim that is sharper than their chords.
 * @param {Problem} problem @param {SolveOptions} options @param {Tried[]} unfollowed @param {number} most
 */
function asTheyAre({ solve }, options, unfollowed, most) {
  /** @type {Found[]} */
  const found = [];
  if (options.algorithm !== ELEMENTS) return found;
  for (const { to, start, path } of unfollowed.slice(0, most))
    if (found.length < LEAST_UNFOLLOWED || (path.crossesSingularity && !found.some(holds)))
      found.push({ to, path: solve(to, start, options) });
  return found;
}

/** Whether no other places are singular than poles and apices: a path that is singular there leads across nothing, and ways over them are solved as such. @param {Problem} problem */
const isPointed = ({ domain, graph }) => !!domain?.poles.length && !graph(0)?.singular;

/**
 * Whether a path of the fewest points that stalls is one that another start had on its way to a path that holds. At a hole, which chords jump over, so look the ways on both
 * sides of it; at a pole they are one.
 * @param {Problem} problem @param {{ to: number[], coarse: RawPath }} one @param {Tried[]} tried
 */
const isKnown = ({ domain }, { to, coarse }, tried) =>
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
const isOneOfMany = (one, path) => one.status === ILL_CONDITIONED && Math.abs(one.length / path.length - 1) <= AT_REST;

/**
 * Solves with few points, and with more where that does not hold, unless that was done.
 * @param {Problem} problem @param {Start} start @param {Tried[]} tried
 * @returns {Tried}
 */
function solveRoughly(problem, { to, start }, tried) {
  const solve = (/** @type {number} */ points) => problem.solve(to, start, { ...ROUGHLY, points });
  const coarse = solve(ROUGH[0]);
  let path = coarse;
  const more = start && !isKnown(problem, { to, coarse }, tried) ? ROUGH.slice(1) : [];
  for (const points of more) if (isTooCoarse(path)) path = solve(points);
  return { to, start, path, coarse };
}

/**
 * The path under a rough one that is too coarse to be judged, or to be compared, with twice the points; null where no more are needed, or they lead nowhere.
 * @param {Problem} problem @param {Found} found @returns {Found | null}
 */
function sharpen(problem, { to, path }) {
  const [least, error] = problem.isPlain ? JUDGED.space : JUDGED.metric;
  const inner = (path.parameters ? path.parameters.length / 2 : path.points.length / 3) - 2;
  if (inner >= MOST_ROUGH || (inner >= least && !(path.lengthError > error * path.length))) return null;
  const sharper = { to, path: solveFrom(problem, { to, path }, { ...ROUGHLY, points: 2 * inner + 1 }) };
  return holds(sharper) && !leaps(problem, sharper.path) ? sharper : null;
}

/** What can be had where no start leads to a path that holds: from the best of those that do not, or straight. @param {Problem} problem @param {Found[]} tried @param {SolveOptions} options */
function solveWeakly(problem, tried, options) {
  const best = shortestWeak(tried);
  return best ? refine(problem, best, options) : problem.solve(tried[0].to, null, options);
}
