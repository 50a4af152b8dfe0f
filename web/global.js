/**
 * The globally shortest path: starts from a graph search and straight lines, each solved roughly, the best ones finely. Knows the order of the
 * stages and what counts as the same path; the mathematics is in wasm/graph.h and in the solver.
 */

import { distinct, estimate, isSame } from './distinct.js';
import { isAtPole } from './domain.js';
import { copies, liftNear, neighbours } from './lifts.js';
import { gap } from './rectangle.js';
import { emptyPath } from './runtime/heap.js';
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

/** @typedef {import('./runtime/heap.js').RawPath} RawPath */
/** @typedef {import('./runtime/heap.js').Graph} Graph */
/** @typedef {import('./runtime/heap.js').SolveOptions} SolveOptions */
/** @typedef {{ to: number[], start: Float64Array | null }} Start where the second end is lifted to, and a polyline, or null: straight */
/** @typedef {{ to: number[], path: RawPath, again?: (options: SolveOptions) => RawPath }} Found a path, and where its second end is lifted to; again: solves it as asked, where so far it was as others can be compared with */
/** @typedef {Found & { start: Start['start'], coarse: RawPath }} Tried a start, its path solved roughly, and the one of the fewest points */
/** @typedef {Found & import('./domain.js').Tip & { bound: number, again: (options: SolveOptions) => RawPath }} Way over a pole, or where a hole takes its place; bound: no way over it is shorter */

/**
 * @typedef {object} Problem two ends, the lexicographically smaller first, and the surface they lie on
 * @property {number[]} from
 * @property {number[]} to
 * @property {import('./domain.js').Domain | null} domain
 * @property {boolean} isPlain length is that of space
 * @property {((places: ArrayLike<number>) => Float64Array) | null} positions x y z of places u v, on a parametric surface where length is that of space
 * @property {(to: number[], start: ArrayLike<number> | null, options: SolveOptions, pole?: number, beyond?: number) => RawPath} solve from `from`; pole: through the
 *   point to which an edge of the rectangle collapses, 1 + 2 · coordinate + side, that far beyond it; 4 more: in a chart around it, and a third
 *   number of the end is what the coordinate along that edge changes by once around, a start is over u and v; 8 more: around the edge, as around a hole
 * @property {(level: number) => Graph | null} graph the surface's graph, refined `level` times; null: there is none so fine
 * @property {(level: number, length: number) => Graph | null} flood a graph around the first end, bounds or not; length: of a path in space, 0: none is known
 * @property {(graph: Graph, points: number, isAll: boolean) => { status: number, candidates: Float64Array[] }} search isAll: all locally shortest ways
 */

/** As sp_algorithm in wasm/surfpath.h. */
export const ELEMENTS = 0;
/** Why a straight start comes to nothing that has to do with an end alone. */
const BAD_ENDS = [SINGULAR_METRIC, OFF_SURFACE, NOT_FINITE];
/** A flood that stopped at this many cells may not have come to its end: SP_GRAPH_FLOOD_CELLS of wasm/graph.h. */
const FLOOD_CELLS = 40_000;
/** Inner points of the rough solves, until one holds. */
const ROUGH = [31, 63, 127, 255];
const CANDIDATE_POINTS = 65;
/** Rough lengths this much longer than the best may still turn out to be the shortest. */
const MARGIN = 1e-3;
/** Of those, so many are solved finely. */
const MOST_FINE = 4;
/** A path that stalls is believed to be as long as it says where its rough one extrapolates to that, to this part of it. */
const AGREEMENT = 1e-6;
/** Rough paths at rest at the same places are equally long up to this part of it. */
const AT_REST = 1e-9;
/** Of the ways that rough polylines cannot follow, the shortest first, so many are solved; if nothing holds, up to so many. */
const [LEAST_UNFOLLOWED, MOST_UNFOLLOWED] = [2, 6];
/** Of the ways that were not, the shortest first, so many are measured, each chord of them in at most so many parts. */
const [MOST_MEASURED, MOST_PARTS] = [8, 512];
/** What is compared has so many points, however many are asked for: which path it is must not depend on that. */
const COMPARED_POINTS = 64;
/** A chord that turns around a pole by this part of a turn passes it nearby. */
const SHARP = 0.05;
/** Near a pole of its own chart a path takes 10 to 25 steps; near another one hundreds, and for nothing. */
const BESIDE_STEPS = 60;

/** Whether a path is locally shortest, as far as can be told. @param {{ path: RawPath }} found */
export const holds = ({ path }) => path.status === CONVERGED || path.status === ILL_CONDITIONED;

/** @param {SolveOptions} options @returns {SolveOptions} */
const compared = (options) => ({ ...options, points: COMPARED_POINTS, record: false });

/** @param {Found} found @param {SolveOptions} options @returns {RawPath} */
const asAsked = ({ path, again }, options) =>
  again && (options.points !== COMPARED_POINTS || options.record || !holds({ path })) ? again(options) : path;

/** Whether a path is one of these. @param {Found[]} list @param {Found} found */
const isAmong = (list, { path }) => list.some((other) => isSame(other.path, path));

/** Infinite where there is none. @param {Found[]} list */
const lengthOfShortest = (list) => Math.min(...list.map(({ path }) => estimate(path) || Infinity));

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
  const { starts, status } = findStarts(problem, most > 1);
  /** @type {Tried[]} */
  const tried = [];
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
 * The path, or one that is shorter, of a way that could not be followed roughly. Where such a way is shorter than all that were found there is a shorter path,
 * and what is known of it is only that: `stalled`.
 * @param {Problem} problem @param {SolveOptions} options @param {RawPath} best @param {Tried[]} tried
 * @returns {RawPath}
 */
function challenge(problem, options, best, tried) {
  const { positions, solve } = problem;
  let path = best;
  let least = Infinity;
  const isShorter = (/** @type {number} */ length) => length < path.length * (1 - MARGIN);
  const open = tried.filter((one) => one.start && (!holds(one) || leaps(problem, one.path) || isShorter(one.path.length)));
  for (const { to, start } of positions ? open.slice(0, MOST_MEASURED) : []) {
    let length = 0;
    // Fewer chords are shorter.
    for (let parts = 1; parts <= MOST_PARTS && isShorter(length); parts *= 8)
      length = lengthOf(problem, /** @type {Float64Array} */ (start), parts);
    if (!isShorter(length)) continue;
    least = Math.min(least, length);
    const shorter = solve(to, start, options);
    if (holds({ path: shorter }) && shorter.length < path.length && !leaps(problem, shorter)) path = shorter;
  }
  return isShorter(least) ? { ...path, status: STALLED } : path;
}

/** Length on the surface of a polyline of places, each of its chords taken in parts. @param {Problem} problem @param {Float64Array} polyline @param {number} parts */
function lengthOf({ positions }, polyline, parts) {
  const places = new Float64Array((polyline.length - 2) * parts + 2);
  for (let k = 0; k < places.length; k++) {
    const at = (k >> 1) / parts;
    const i = 2 * Math.floor(at) + (k & 1);
    places[k] = polyline[i] + (at % 1) * ((polyline[i + 2] ?? 0) - polyline[i]);
  }
  const points = /** @type {(places: ArrayLike<number>) => Float64Array} */ (positions)(places);
  let length = 0;
  for (let i = 3; i < points.length; i += 3) length += gap(points.subarray(i), points.subarray(i - 3));
  return length;
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
  const passing = beside.filter((found, i) => holds(found) && !isAmong(beside.slice(0, i).filter(holds), found));
  const fine = [...passing, ...ways.filter(holds)];
  const unknown = tried.filter((one) => !isKnown(one.coarse, tried) && !isAmong(fine, one) && !leaps(problem, one.path));
  const shortest = lengthOfShortest([...rough, ...fine]);
  const unfollowed = unknown.filter(
    ({ start, path }) => start && (path.crossesSingularity ? !isPointed(problem) : isTooCoarse(path) && !(path.length > shortest)),
  );
  /* In space the error is known by its sign, in a metric by its size only. */
  const doubt = (/** @type {RawPath} */ path) => 0.5 * MARGIN * path.length + (problem.isPlain ? 0 : 2 * path.lengthError);
  const mayBeShortest = (/** @type {Found} */ { path }, /** @type {number} */ i) =>
    i < MOST_FINE && estimate(path) - doubt(path) <= estimate(rough[0].path) + doubt(rough[0].path);
  /** @type {Found[]} */
  let usable = [...passing];
  /** @type {RawPath[]} */
  const failed = [];
  for (const found of most === 1 ? rough.filter(mayBeShortest) : rough) {
    if (most > 1 && usable.length === most) break;
    if (isAmong(passing, found)) continue;
    const refined = { to: found.to, path: refine(problem, found, options) };
    if (holds(refined)) usable = distinct([...usable, refined]);
    else failed.push(refined.path);
  }
  for (const followed of asTheyAre(problem, options, unfollowed, usable.length > 0 ? LEAST_UNFOLLOWED : MOST_UNFOLLOWED))
    if (holds(followed)) usable.push(followed);
    else failed.push(followed.path);
  usable.push(...shorterOverPole(ways, usable));
  const chosen = distinct(usable);
  const weak =
    most === 1 &&
    chosen.length > 0 &&
    (failed.find((path) => isShorterAnyway(path, chosen[0].path, options)) ?? stalledBeside(problem, unknown, options, chosen[0].path));
  if (weak) return [weak];
  if (chosen.length > 0) return chosen.slice(0, most).map((found) => asAsked(found, options));
  const apart = status === DISCONNECTED && !BAD_ENDS.includes(tried[0].path.status);
  if (failed.length === 0 && beside.length > 0) return [asAsked(beside[0], options)];
  /* A path that is none of the best is better than none, if what is shorter can be told. */
  const weakest = failed.filter(({ length }) => length > 0).sort((a, b) => a.length - b.length)[0];
  if (weakest || (failed.length > 0 && !problem.positions)) return [weakest ?? failed[0]];
  const last = apart ? emptyPath(status) : solveWeakly(problem, tried, options);
  return [last.length > 0 ? last : (failed[0] ?? last)];
}

/**
 * Starts: the straight lines to the nearest lifts of the end, then the ways through the first graph that joins the ends. The last status says why
 * there are none of these.
 * @param {Problem} problem @param {boolean} isAll
 */
function findStarts(problem, isAll) {
  const { from, to, domain } = problem;
  /** @type {Start[]} */
  const starts = (domain ? neighbours(domain, to, from) : [to]).map((end) => ({ to: end, start: null }));
  const search = (/** @type {Graph} */ graph) => {
    if (graph.status !== CONVERGED) return graph.status;
    const { status, candidates } = problem.search(graph, CANDIDATE_POINTS, isAll);
    for (const start of candidates) starts.push({ to: Array.from(start.subarray(-problem.from.length)), start });
    return status;
  };
  let status = OFF_SURFACE;
  /* Where its cells are too coarse for an implicit surface, or may be, length not being that of space, the search begins with finer ones. */
  let level = problem.domain || (problem.isPlain && problem.graph(0)?.resolved) ? 0 : 1;
  const flood = (/** @type {number} */ at) => {
    const near = solveRoughly(problem, { to: problem.to, start: null }, []);
    return problem.flood(at, problem.isPlain && !isAll && holds(near) ? near.path.length : 0);
  };
  for (const find of [problem.graph, flood]) {
    for (let graph = find(level); graph; graph = find(++level)) {
      status = search(graph);
      if (status !== DISCONNECTED && status !== OFF_SURFACE) break;
      if (find === problem.graph) continue;
      if (graph.vertices === FLOOD_CELLS) return { starts, status: OFF_SURFACE };
      status = DISCONNECTED;
    }
    if (status !== OFF_SURFACE) break;
    level = 0;
  }
  return { starts, status };
}

/**
 * Ways over a pole, which no chart shows as stationary, shortest first. One with a corner, `stalled`, is no geodesic; but what is longer is not the
 * shortest. Over a hole none leads: it tells how short a way around it may be; where the surface is smooth, nothing needs to be told. Those that
 * even as straight lines in space are longer than the best path are left out.
 * @param {Problem} problem @param {SolveOptions} options @param {Found[]} tried @param {Found[]} rough those that hold
 * @returns {Way[]}
 */
function overPoles({ from, to, domain, isPlain, solve }, options, tried, rough) {
  if (!domain || options.algorithm !== ELEMENTS) return [];
  const points = isPlain && tried.find(({ path }) => path.points.length > 0)?.path.points;
  const ends = copies(domain, to);
  return ends
    .flatMap((end) => domain.tips.map((tip) => ({ ...tip, to: end })))
    .filter((tip) => tip.beyond > 0 || (!isAtPole(domain, from, tip.pole) && !isAtPole(domain, tip.to, tip.pole)))
    .map((tip) => ({ ...tip, bound: tip.at && points ? gap(points, tip.at) + gap(points.subarray(-3), tip.at) - 2 * tip.radius : 0 }))
    .filter(({ bound }) => !(rough.length > 0 && bound > (1 + MARGIN) * estimate(rough[0].path)))
    .map((tip) => {
      const along = tip.pole > 2 ? 0 : 1;
      const end = [...tip.to, domain.periodic[along] ? domain.upper[along] - domain.lower[along] : 0];
      const again = (/** @type {SolveOptions} */ asked) => solve(end, null, asked, tip.pole, tip.beyond);
      const path = tip.smooth ? emptyPath(SINGULAR_METRIC) : again(compared(options));
      return { ...tip, again, path: tip.beyond > 0 ? { ...path, status: STALLED } : path };
    })
    .sort((a, b) => (a.path.length || a.bound) - (b.path.length || b.bound));
}

/**
 * Where a path near a start came to nothing: the shortest of those that pass a pole, or lead over it, unless what was found is shorter, and a path.
 * @param {Problem} problem @param {SolveOptions} options @param {RawPath} near @returns {RawPath[]} none or one
 */
export function passPoles(problem, options, near) {
  const weak = { to: problem.to, path: near, start: null, coarse: near };
  const others = leaps(problem, near) ? [] : [weak];
  const ways = overPoles(problem, options, [weak], others);
  const most = others.length > 0 && near.length > 0 ? (1 + MARGIN) * near.length : Infinity;
  return [...besidePoles(problem, options, ways, others), ...ways]
    .filter((found) => holds(found) && found.path.length <= most)
    .sort((a, b) => a.path.length - b.path.length)
    .slice(0, 1)
    .map((found) => asAsked(found, options));
}

/** Of these ways the shortest without a corner, if it is shorter than all others. @param {Way[]} ways @param {Found[]} others */
function shorterOverPole(ways, others) {
  const shortest = lengthOfShortest(others);
  return ways.filter((way) => holds(way) && way.path.length < shortest - way.path.lengthError).slice(0, 1);
}

/**
 * Paths that pass a pole nearby, or wind around a hole, over which a way is hardly longer: in the rectangle's own coordinates they turn too sharply there.
 * @param {Problem} problem @param {SolveOptions} options @param {Way[]} ways @param {Found[]} others
 */
function besidePoles({ from, domain, solve }, options, ways, others) {
  let shortest = lengthOfShortest([...others, ...ways.filter(({ beyond }) => !(beyond > 0))]);
  const asked = compared({ ...options, maxIterations: Math.min(options.maxIterations, BESIDE_STEPS) });
  /** @type {Found[]} */
  const found = [];
  for (const tip of ways) {
    const { pole, beyond, at, radius, bound } = tip;
    if (Math.max(tip.path.length - 2 * radius || 0, bound) * (1 - MARGIN) > shortest) continue;
    const range = /** @type {import('./domain.js').Domain} */ (domain);
    const along = pole > 2 ? 0 : 1;
    const end = [...liftNear(range, tip.to, from), range.upper[along] - range.lower[along]];
    /* Of a pole, where half a turn in longitude may be none around it; over a hole no way leads. */
    const isInsteadOfArcs = tip.smooth && bound > 0 && !(beyond > 0);
    for (const kind of [...(at || !beyond ? [4] : []), ...(beyond > 0 ? [8] : [])]) {
      const again = (/** @type {SolveOptions} */ wanted) => solve(end, null, wanted, pole + kind, beyond);
      const way = { to: end, again, path: again(asked) };
      if (way.path.status >= CONVERGED) found.push(way);
      if (holds(way)) shortest = Math.min(shortest, way.path.length);
      else if (isInsteadOfArcs) tip.path = tip.again(compared(options));
    }
  }
  return found;
}

/**
 * Whether a polyline jumps over a pole, a hole or a slit. One that passes a pole nearer than its nodes are apart turns by about half a turn in a chord.
 * @param {Problem} problem @param {RawPath} path
 */
function leaps({ domain }, { parameters }) {
  if (!domain || !parameters) return false;
  return domain.around.some(({ along, most }) =>
    parameters.some((x, i) => i > 1 && (i & 1) === along && Math.abs(x - parameters[i - 2]) > most),
  );
}

/** The shortest of those that would be locally shortest if they were at rest. @param {Found[]} tried @returns {Found | undefined} */
const shortestWeak = (tried) =>
  tried.filter(({ path }) => path.index === 0 && path.length >= 0).sort((a, b) => estimate(a.path) - estimate(b.path))[0];

/** Solves from a path found roughly; past a pole of a round metric in a chart around that. @param {Problem} problem @param {Found} found @param {SolveOptions} options */
function refine({ from, domain, solve }, { to, path }, options) {
  const { parameters } = path;
  const pole = domain && parameters && options.algorithm === ELEMENTS && passedPole(domain, parameters, SHARP);
  if (pole && domain.tips.some((tip) => tip.pole === pole && tip.smooth && !tip.at)) {
    const along = pole > 2 ? 0 : 1;
    const beside = solve([...liftNear(domain, to, from), domain.upper[along] - domain.lower[along]], parameters, options, pole + 4);
    if (holds({ path: beside })) return beside;
  }
  return solve(to, parameters ?? path.points, options);
}

/**
 * The pole nearest to a chord of a path that turns around it by this part of a turn, or more, so that the rectangle's coordinates are no good there; 0: none.
 * @param {import('./domain.js').Domain} domain @param {Float64Array} parameters @param {number} part
 */
export function passedPole({ lower, upper, tips }, parameters, part) {
  let [passed, nearest] = [0, Infinity];
  for (const { pole } of tips) {
    const across = (pole - 1) >> 1;
    const along = 1 - across;
    for (let i = 2; i < parameters.length; i += 2) {
      const away = Math.abs(parameters[i + across] - (pole & 1 ? lower : upper)[across]);
      const turned = Math.abs(parameters[i + along] - parameters[i + along - 2]);
      if (turned > part * (upper[along] - lower[along]) && away < nearest) [passed, nearest] = [pole, away];
    }
  }
  return passed;
}

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
 * Whether a path that was not solved to the tolerance (iteration-limit, tolerance-not-met) shows that the best of those that were is not the shortest: it is one on the surface, and shorter.
 * @param {RawPath} path @param {RawPath} best @param {SolveOptions} options
 */
const isShorterAnyway = ({ status, length, lengthError }, best, { tolerance }) =>
  status > CONVERGED && status !== STALLED && length + lengthError < best.length * (1 - tolerance) - best.lengthError;

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

/**
 * Whether an end is a pole or an apex, and no other place singular: ways that turn around it are singular there, and lead across nothing.
 * @param {Problem} problem
 */
function isPointed({ from, to, domain, graph }) {
  return !!domain?.poles.some((pole) => isAtPole(domain, from, pole) || isAtPole(domain, to, pole)) && !graph(0)?.singular;
}

/**
 * Whether a path of the fewest points that stalls is one that another start had on its way to a path that holds.
 * @param {RawPath} coarse @param {Tried[]} tried
 */
const isKnown = (coarse, tried) =>
  coarse.status === STALLED &&
  tried.some((other) => holds(other) && Math.abs(other.coarse.length / coarse.length - 1) <= AT_REST && isSame(other.coarse, coarse));

/**
 * Solves with few points, and with more where that does not hold, unless that was done.
 * @param {Problem} problem @param {Start} start @param {Tried[]} tried
 * @returns {Tried}
 */
function solveRoughly(problem, { to, start }, tried) {
  const options = { tolerance: 1e-6, gradientTolerance: 0, algorithm: 1, maxIterations: 60, record: false };
  const solve = (/** @type {number} */ points) => problem.solve(to, start, { ...options, points });
  const coarse = solve(ROUGH[0]);
  let path = coarse;
  const more = start && !isKnown(coarse, tried) ? ROUGH.slice(1) : [];
  for (const points of more) if (isTooCoarse(path)) path = solve(points);
  return { to, start, path, coarse };
}

/** What can be had where no start leads to a path that holds: from the best of those that do not, or straight. @param {Problem} problem @param {Found[]} tried @param {SolveOptions} options */
function solveWeakly(problem, tried, options) {
  const best = shortestWeak(tried);
  return best ? refine(problem, best, options) : problem.solve(tried[0].to, null, options);
}

/** Turns a path round. @param {RawPath} path @returns {RawPath} */
export function reverse(path) {
  const turned = (/** @type {Float64Array} */ numbers, /** @type {number} */ width) => {
    const result = new Float64Array(numbers.length);
    for (let i = 0; i < numbers.length; i += width) result.set(numbers.subarray(i, i + width), numbers.length - width - i);
    return result;
  };
  return {
    ...path,
    points: turned(path.points, 3),
    parameters: path.parameters && turned(path.parameters, 2),
    history: path.history.map((iterate) => (iterate.points ? { ...iterate, points: turned(iterate.points, 3) } : iterate)),
  };
}
