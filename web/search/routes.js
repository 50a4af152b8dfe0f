/** From two ends to a path: near a start, or the globally shortest. Joins the solver, the graphs and the lifts of a surface. */

import { facePoles } from '../manifold/domain.js';
import { copies, liftEnds, moveOnto, slide } from '../manifold/lifts.js';
import { makePath } from '../path.js';
import { emptyPath } from '../runtime/result.js';
import { CONVERGED, OUT_OF_MEMORY } from '../runtime/status.js';
import { gap, listOf } from '../vector.js';
import { findBranches } from './branches.js';
import { ELEMENTS, holds, LONGEST } from './candidates.js';
import { findPaths, findPathsFrom } from './global.js';
import { isAfter, reverse, turned } from './join.js';
import { passBranches } from './over-branches.js';
import { passedTip, passPoles } from './poles.js';
import { asItIs, ROUGHLY } from './rough.js';
import { findStarts } from './starts.js';

/** @typedef {import('../path.js').Path} Path */
/** @typedef {import('../runtime/heap.js').Heap} Heap */
/** @typedef {import('../runtime/result.js').RawPath} RawPath */
/** @typedef {import('../runtime/heap.js').SolveOptions} SolveOptions */

/**
 * A call of the solver. record: address of the surface as it measures length; shape: where the surface is installed as space measures it.
 * @template T @typedef {(heap: Heap, record: number, shape: { record: number, value: number }) => T} Call
 */

/**
 * @typedef {object} Field a surface, as far as finding paths on it needs to know
 * @property {number} kind 0: parametric, 1: implicit
 * @property {import('../manifold/domain.js').Domain | null} domain
 * @property {(() => Field | null) | null} [own] a parametric surface as measured by its E, F and G, over u and v alone, where space measures it; null: there is no room for them
 * @property {(() => import('../manifold/sides.js').Sides | null) | null} [sides] of its creases; null: it has none, or is a part of another, or there is no room for them
 * @property {((places: ArrayLike<number>) => Float64Array) | null} [chords] of a rectangle: how long chords between places u v one after the other are
 * @property {(() => import('../manifold/sides.js').Sides | null) | null} [jumps] the same, also where formulas have only floors, which no side tells apart
 * @property {(() => import('../manifold/bodies.js').Bodies) | null} [bodies] what boxes hold of an implicit surface; null: it has a metric, or is no such surface
 * @property {((pole: number) => import('../creases/at-poles.js').Flattened | null) | null} [flattened] a surface with creases over the plane around a pole; null: it has none, or cannot be written so
 * @property {(() => import('./raised.js').Lowered | null) | null} [lowered] a surface over x and y with lower heights; null: it is no such surface, or not smooth
 * @property {Field[]} pieces where the rectangle hangs together in points: what lies between them, in order; else none
 * @property {number[] | null} box of an implicit surface
 * @property {boolean} [isLeg] paths are legs of ways through branch points
 * @property {boolean} [isBrief] where no rough path holds nothing is solved: there are other ways
 * @property {import('../manifold/graphs.js').Graphs} graphs
 * @property {boolean} isPlain length is that of space: no density, no metric
 * @property {((places: ArrayLike<number>) => Float64Array) | null} positions x y z of places u v, on a parametric surface that has them
 * @property {<T>(call: Call<T>, part?: import('../manifold/domain.js').Domain) => T} run on the rectangle, or a part of it
 * @property {(places: ArrayLike<number>) => Float64Array} jets of the surface in space
 * @property {(places: number[]) => ArrayLike<number>[]} forms E, F and G at places, where a density or a metric measures length
 * @property {(box: number[], resolution: number) => import('../mesh/mesh.js').Mesh} mesh of an implicit surface; without vertices where there is no room
 */

/** Steps after which a path that turns around a pole by this part of a turn in a chord is looked for beside it. */
const [PATIENCE, SLIPPING] = [40, 0.1];
/** What asks only where the ends are, and how far from the surface, in parts of their coordinates, one is beside it. */
const AT_ONCE = asItIs(1);
const BESIDE = 1e-6;
/** What a polyline is relaxed with that is only to tell which way a path leads. */
const SKETCH = { ...ROUGHLY, points: 63 };
/** So many legs between branch points are kept: more than there are between as many as are looked for. */
const MOST_KNOWN = 1024;
/** Points in which a polyline is measured. */
const MEASURED = 999;

/**
 * The solve near a polyline, or the straight line, without what it may pass, and what makes a path of it.
 * @param {Field} field @param {number[][]} ends @param {Float64Array | null} start null: straight
 */
export function poseNear({ kind, domain, run }, ends, start) {
  const faced = facePoles(domain, ends[0], ends[1]);
  const lifted = domain ? liftEnds(domain, faced[0], faced[1], start) : ends;
  const request = { kind, from: lifted[0], to: lifted[1], start };
  return {
    /** What the solver's memory has of the path besides is for `read`. */
    solve: (/** @type {SolveOptions} */ asked, read = (/** @type {Heap} */ _) => {}) =>
      run((heap, record) => {
        const raw = heap.solve(record, request, asked);
        read(heap);
        return raw;
      }),
    finish(/** @type {import('../runtime/result.js').RawPath} */ raw) {
      const path = makePath(raw);
      if (domain && path.parameters) moveOnto(domain, path.parameters, faced[0]);
      return path;
    },
  };
}

/**
 * The locally shortest path near a start. One that comes to nothing near a pole may want to pass that on the other side, whereto no step in the rectangle
 * leads: then the shortest of those that pass it; and on a surface with branch points, the shortest through these.
 * @param {Field} field @param {number[][]} ends @param {SolveOptions} options @param {Float64Array | null} start null: straight
 * @returns {Path}
 */
export function solveNear(field, ends, options, start) {
  const { domain } = field;
  const { solve, finish } = poseNear(field, ends, start);
  const branches = branchesOf(field).length > 0;
  const mayPass = domain && (branches || domain.tips.length > 0) && options.algorithm === ELEMENTS;
  const isCut = mayPass && options.maxIterations > PATIENCE;
  let near = solve(isCut ? { ...options, maxIterations: PATIENCE } : options);
  const pass = () => {
    const rest = { ...options, maxIterations: Math.max(isCut ? PATIENCE : 0, options.maxIterations - near.iterations) };
    return mayPass && !holds({ path: near }) && rest.maxIterations > 0
      ? pose(field, ends, (problem) => [...passPoles(problem, rest, near), ...passBranches(problem, rest)])[0]
      : undefined;
  };
  /* Cut short, it may only take long. */
  const isOpen = isCut && near.iterations >= PATIENCE && !holds({ path: near });
  const slips = branches || (near.parameters && mayPass && passedTip(domain, near.parameters, SLIPPING));
  let passing = !isOpen || slips ? pass() : undefined;
  if (isOpen && !passing) {
    near = solve(options);
    passing = pass();
  }
  return passing ?? finish(near);
}

/**
 * The shortest paths that a graph search finds, or one without a path that says why.
 * @param {Field} field @param {number[][]} ends @param {SolveOptions} options @param {number} most
 * @returns {Path[]}
 */
export function findGlobal(field, ends, options, most) {
  return pose(field, ends, (problem) => findPaths(problem, options, most));
}

/**
 * Polylines along which paths between two ends may lead, as a graph has them.
 * @param {Field} field @param {number[][]} ends @param {import('../creases/creased.js').Sought} start @param {number} [finer] so many graphs are passed over that join the ends
 * @returns {{ ways: Float64Array[], distance: number }} distance: of the shortest way through the graph; infinite where none was looked for
 */
export function findWays(field, ends, start, finer = 0) {
  if (start !== 'global' && start !== 'all') return { ways: [start ?? Float64Array.from(ends.flat())], distance: Infinity };
  /** @type {Float64Array[]} */
  let ways = [];
  let distance = Infinity;
  pose(field, ends, (problem) => {
    const { from, to, domain, solve } = problem;
    const straight = { to, start: null };
    const path = domain ? null : solve(to, null, SKETCH);
    const graphs = findStarts(problem, start === 'all', path ? { ...straight, path, coarse: path } : undefined);
    for (let i = 0; i < finer; i++) graphs.next();
    const found = graphs.next().value;
    const starts = [...(path && !finer ? [straight] : []), ...(found?.starts ?? [])];
    ways = starts.map(({ to: end, start: given }) => Float64Array.from(given ?? [...from, ...end]));
    distance = found?.distance ?? Infinity;
    return [];
  });
  return { ways, distance };
}

/** The path near a polyline, or the straight line, whatever it may pass. @param {Field} field @param {number[][]} ends @param {SolveOptions} options @param {Float64Array | null} start null: straight */
export function solveAlong(field, ends, options, start) {
  const { solve, finish } = poseNear(field, ends, start);
  return finish(solve(options));
}

/** A polyline relaxed, not further than is needed to tell which way a path leads. @param {Field} field @param {number[][]} ends @param {Float64Array} line @param {number} points */
export const relax = (field, ends, line, points) => solveAlong(field, ends, { ...SKETCH, points }, line);

/** How long a polyline is on the surface as it is. @param {Field} field @param {number[][]} ends @param {Float64Array} line */
export const measureLine = (field, ends, line) => poseNear(field, ends, line).solve(asItIs(MEASURED)).length;

/** A polyline as it is, in so many points. @param {Field} field @param {number[][]} ends @param {Float64Array} line @param {number} points @returns {Path} */
export const drawLine = (field, ends, line, points) => solveAlong(field, ends, asItIs(points), line);

/**
 * The shortest of the paths near some lines, one that holds not if none is shorter than what is known; and after it, roughly solved, all that these lead to.
 * @param {Field} field @param {number[][]} ends @param {SolveOptions} options
 * @param {ArrayLike<number>[]} lines polylines from the first end to near the second @param {number} shortest length of the shortest path so far
 * @returns {Path[]}
 */
export function findNear(field, ends, options, lines, shortest) {
  const isTurned = isAfter(ends[0], ends[1]);
  return pose(field, ends, (problem) => {
    const starts = lines.map((line) =>
      slide(problem, isTurned ? turned(Float64Array.from(line), ends[0].length) : Float64Array.from(line)),
    );
    return findPathsFrom(problem, options, starts, shortest);
  });
}

/**
 * Paths between two ends, found from the lexicographically smaller one, from the first to the second.
 * @param {Field} field @param {number[][]} ends @param {(problem: import('./candidates.js').Problem) => import('../runtime/result.js').RawPath[]} find
 * @returns {Path[]}
 */
function pose(field, [from, to], find) {
  const { kind, domain, graphs, isPlain, positions, forms, chords, run } = field;
  const swap = isAfter(from, to);
  const [a, b] = facePoles(domain, ...(swap ? /** @type {const} */ ([to, from]) : /** @type {const} */ ([from, to])));
  const branches = branchesOf(field);
  let exhausted = false;
  /** What did not fit might have been the shortest. @template {{ status: number } | null} T @param {T} answer */
  const watch = (answer) => {
    exhausted ||= answer?.status === OUT_OF_MEMORY;
    return answer;
  };
  const found = run((heap, record) => {
    const [first, last] = domain ? [a, b] : [a, b].map((end) => ontoBeside(heap, record, kind, end));
    /* Where no pole lets paths slip from one to another. */
    const wound = domain && domain.tips.length + domain.poles.length + branches.length === 0 ? domain : null;
    /** @param {Omit<Parameters<Heap['solve']>[1], 'kind'>} request @param {SolveOptions} asked */
    const solve = (request, asked) => {
      const path = watch(heap.solve(record, { kind, ...request }, asked));
      return wound ? { ...path, turns: turnsOf(wound, request.from, request.to) } : path;
    };
    return find({
      from: first,
      to: last,
      isPlain,
      isCreased: !!field.sides,
      positions,
      forms,
      chords,
      domain,
      solve: (end, start, asked, passage) => solve({ from: first, to: end, start, passage }, asked),
      between: (line, asked) =>
        solve({ from: listOf(line, 0, first.length), to: listOf(line, line.length - first.length), start: line }, asked),
      branches,
      isLeg: !!field.isLeg,
      isBrief: !!field.isBrief,
      leg: (places, asked) =>
        remember(graphs.legs, JSON.stringify([places, asked]), () => findGlobal({ ...field, isLeg: true }, places, asked, 1)[0]),
      near: (places, asked, start) => solveNear({ ...field, isLeg: true }, places, asked, start),
      graph: (level) => watch(graphs.find(heap, record, field, level)),
      flood: (level, length, wide) => watch(graphs.flood(heap, record, first, last, level, length, wide)),
      search: (graph, points, isAll) =>
        joinSearches(copies(domain, last).map((end) => watch(heap.searchGraph(record, graph, first, end, points, isAll)))),
    });
  });
  const raw = exhausted ? [emptyPath(OUT_OF_MEMORY)] : found;
  return raw.map((one) => {
    const path = makePath(swap ? reverse(one) : one);
    if (domain && path.parameters) moveOnto(domain, path.parameters, swap ? b : a);
    return path;
  });
}

/** How often a path to there leads around. @param {import('../manifold/domain.js').Domain} domain @param {number[]} from @param {number[]} to */
const turnsOf = ({ lower, upper, periodic }, from, to) =>
  `${from.map((x, j) => periodic[j] && Math.round((to[j] - x) / (upper[j] - lower[j])))}`;

/**
 * Where a path begins whose end is given beside an implicit surface: there a graph is looked into, too. What is near enough stays as it is, to the bit.
 * @param {Heap} heap @param {number} record @param {number} kind @param {number[]} end
 */
function ontoBeside(heap, record, kind, end) {
  const there = ontoSurface(heap, record, kind, end);
  return gap(there, end) > BESIDE * gap(end, [0, 0, 0]) ? there : end;
}

/** Where an end of a path on an implicit surface lies on it; the end itself, where nothing tells. @param {Heap} heap @param {number} record @param {number} kind @param {number[]} end */
function ontoSurface(heap, record, kind, end) {
  const { points } = heap.solve(record, { kind, from: end, to: end, start: null }, AT_ONCE);
  return points.length > 0 ? Array.from(points.subarray(0, 3)) : end;
}

/** @param {Field} field an implicit surface @param {number[]} end of a path on it @returns {number[]} where it lies on the surface */
export const settleEnd = ({ kind, run }, end) => run((heap, record) => ontoSurface(heap, record, kind, end));

/**
 * What was found before, or is found now. Wherever a way fails, ways through branch points are looked for, and they share most of their legs.
 * @param {Map<string, Path>} known @param {string} key @param {() => Path} find
 */
function remember(known, key, find) {
  const path = known.get(key) ?? find();
  if (known.size >= MOST_KNOWN) known.clear();
  if (path.status !== 'out-of-memory') known.set(key, path);
  return path;
}

/** Branch points that paths may lead through, where length is that of space. @param {Field} field @returns {import('./branches.js').Branch[]} */
export function branchesOf({ domain, graphs, isPlain, jets }) {
  if (!domain || !isPlain) return [];
  graphs.branches ??= findBranches(jets, domain);
  return graphs.branches;
}

/**
 * Searches for ways to the same point in several places as one. Ways that are much longer than the shortest are of no interest.
 * @param {ReturnType<Heap['searchGraph']>[]} searches
 */
function joinSearches(searches) {
  const found = searches.filter(({ status }) => status === CONVERGED).sort((a, b) => a.distance - b.distance);
  if (found.length === 0) return searches[0];
  const near = found.filter(({ distance }) => distance <= LONGEST * found[0].distance);
  return { ...found[0], candidates: near.flatMap(({ candidates }) => candidates) };
}
