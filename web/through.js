/** Paths through the nodes of an implicit surface: of all chains of legs from node to node the shortest, of which as few as possible are solved. */

import { joinPaths, shareOut, thinned } from './join.js';
import { crosses, findNet } from './nodes.js';
import { isPath, mostOf } from './path.js';
import { dot, gap } from './rectangle.js';
import { ROUGHLY } from './rough.js';
import { findGlobal, isAfter, reverse, solveNear } from './routes.js';

/** @typedef {import('./path.js').Path} Path */
/** @typedef {import('./routes.js').Field} Field */
/** @typedef {import('./runtime/heap.js').SolveOptions} SolveOptions */

/** So many legs are solved at most, of so many points, to learn how long they are. */
const [MOST_LEGS, POINTS] = [64, 31];
/** Points a direction of the bounds from which nodes are looked for; and of a box around the ends, where there are none. */
const [FINE, ROUGH] = [24, 12];
/** Without bounds a box around the ends, this part of their distance larger on each side, is searched for nodes. */
const MARGIN = 0.5;
/** An end nearer to a node than this part of what is between the ends is that node. */
const SAME = 3e-12;

/** @param {number[][]} ends */
function boxAround([from, to]) {
  const margin = MARGIN * gap(from, to);
  return from.flatMap((x, j) => [Math.min(x, to[j]) - margin, Math.max(x, to[j]) + margin]);
}

/**
 * The shortest way from place 0 to place 1. @param {number} count of places @param {Float64Array} lengths of each to each @returns {number[]} places, none: there is no way
 */
function shortestWay(count, lengths) {
  const far = Array.from({ length: count }, (_, i) => (i ? Infinity : 0));
  const before = Array(count).fill(-1);
  const open = new Set(far.keys());
  while (open.has(1)) {
    const here = [...open].reduce((best, i) => (far[i] < far[best] ? i : best));
    open.delete(here);
    for (const i of open) {
      const through = far[here] + lengths[count * here + i];
      if (through < far[i]) [far[i], before[i]] = [through, here];
    }
  }
  const way = [1];
  for (let i = before[1]; i >= 0; i = before[i]) way.unshift(i);
  return way.length > 1 ? way : [];
}

/** @param {Field} field of an implicit surface @param {number[][]} ends of which a box is made, where there are no bounds */
export function netOf(field, ends) {
  const { box, graphs } = field;
  if (!box) return findNet(field, boxAround(ends), ROUGH);
  graphs.net ??= findNet(field, box, FINE);
  return graphs.net;
}

/**
 * The globally shortest path between two ends: within a sheet, or through nodes where that is shorter, or the only way.
 * @param {Field} field @param {number[][]} ends @param {SolveOptions} options
 * @returns {Path}
 */
export function findThrough(field, ends, options) {
  const { box, domain } = field;
  const solve = () => findGlobal(field, ends, options, 1)[0];
  const isStraight = () => isPath(solveNear(field, ends, { ...ROUGHLY, points: POINTS }, null));
  if (domain || (!box && isStraight())) return solve();
  const net = netOf(field, ends);
  if (net.nodes.length === 0) return solve();
  return isAfter(ends[0], ends[1]) ? reverse(joinThrough(field, net, [ends[1], ends[0]], options)) : joinThrough(field, net, ends, options);
}

/**
 * The shortest path, of whatever it passes.
 * @param {Field} field @param {ReturnType<typeof findNet>} net @param {number[][]} ends @param {SolveOptions} options
 * @returns {Path}
 */
function joinThrough(field, { nodes, partsAt }, ends, options) {
  const passed = nodes.filter(({ at }) => ends.every((end) => gap(at, end) > SAME * gap(ends[0], ends[1])));
  const places = [...ends.map((at) => ({ at, parts: partsAt(at) })), ...passed];
  const solve = (/** @type {number} */ i, /** @type {number} */ j, /** @type {SolveOptions} */ asked) =>
    findGlobal(field, [places[i].at, places[j].at], asked, 1)[0];
  /** @type {Map<string, Path>} by the smaller place, and the other */
  const solved = new Map();
  const legOf = (/** @type {number} */ i, /** @type {number} */ j) => solved.get(`${Math.min(i, j)} ${Math.max(i, j)}`);
  const count = places.length;
  const isJoined = (/** @type {number} */ i, /** @type {number} */ j) => places[i].parts.some((part) => places[j].parts.includes(part));
  /** At least as long is each leg; when it is solved, just that, whatever its status. */
  const lengths = Float64Array.from({ length: count ** 2 }, (_, k) => {
    const [i, j] = [Math.floor(k / count), k % count];
    return isJoined(i, j) ? (field.isPlain ? gap(places[i].at, places[j].at) : 0) : Infinity;
  });
  let way = shortestWay(count, lengths);
  for (let legs = 0; legs < MOST_LEGS; legs++) {
    const k = way.findIndex((_, at) => at > 0 && !legOf(way[at - 1], way[at]));
    if (k < 0) break;
    const [i, j] = [way[k - 1], way[k]].sort((a, b) => a - b);
    const leg = solve(i, j, j > 1 ? { ...options, points: POINTS, record: false } : options);
    solved.set(`${i} ${j}`, leg);
    lengths[count * i + j] = lengths[count * j + i] = mostOf(leg);
    way = shortestWay(count, lengths);
  }
  /** Where a path that begins or ends at a node leads from there. @param {number} node @param {number} other @returns {number[]} a unit vector */
  const leaving = (node, other) => {
    const { at } = places[node];
    const leg = /** @type {Path} */ (legOf(node, other));
    const { points } = node < other ? leg : reverse(leg);
    const tangent = at.map((x, j) => 4 * points[3 + j] - points[6 + j] - 3 * x);
    return tangent.map((x) => x / Math.sqrt(dot(tangent, tangent)));
  };
  const wayLength = () =>
    way.slice(1).reduce((sum, place, k) => sum + lengths[count * way[k] + place] + (legOf(way[k], place)?.lengthError ?? 0), 0);
  const inner = way.slice(1, -1);
  const isWhole = way.every((place, k) => k === 0 || legOf(way[k - 1], place));
  const isSmooth = isWhole && inner.every((node, k) => crosses(passed[node - 2], leaving(node, way[k]), leaving(node, way[k + 2])));
  if (inner.length === 0 || !isSmooth) {
    const path = legOf(0, 1) ?? solve(0, 1, options);
    /* A way over nodes that is shorter and no path, or not all of which was solved, leaves it open what is the shortest. */
    const isOpen = isPath(path) && wayLength() < path.length;
    return isOpen ? { ...path, status: 'stalled', converged: false } : path;
  }
  const points = Math.max(options.points, 2 * way.length - 3);
  const legs = way.slice(1).map((place, k) => {
    const leg = /** @type {Path} */ (legOf(way[k], place));
    return way[k] < place ? leg : reverse(leg);
  });
  const shares = shareOut(
    legs.map(({ length }) => length),
    points,
  );
  const solveAgain = (/** @type {Path} */ leg, /** @type {number} */ k) =>
    solveNear(field, [places[way[k]].at, places[way[k + 1]].at], { ...options, points: shares[k] }, leg.points);
  const path = joinPaths(legs.map(solveAgain), null);
  return points > options.points ? thinned(path, options.points + 2) : path;
}
