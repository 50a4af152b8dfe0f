/** Paths through the nodes of an implicit surface: of all chains of legs from node to node the shortest, of which as few as possible are solved. */

import { findChain } from './chain.js';
import { joinLegs, reverse } from './join.js';
import { crosses, findNet } from './nodes.js';
import { isGeodesic } from './path.js';
import { ROUGHLY } from './rough.js';
import { findGlobal, isAfter, solveNear } from './routes.js';
import { dot, gap } from './vector.js';

/** @typedef {import('./path.js').Path} Path */
/** @typedef {import('./routes.js').Field} Field */
/** @typedef {import('./runtime/heap.js').SolveOptions} SolveOptions */

/** Legs are solved with so many points, to learn how long they are. */
const POINTS = 31;
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
  const isStraight = () => isGeodesic(solveNear(field, ends, { ...ROUGHLY, points: POINTS }, null));
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
  const isJoined = (/** @type {number} */ i, /** @type {number} */ j) => places[i].parts.some((part) => places[j].parts.includes(part));
  const bound = (/** @type {number} */ i, /** @type {number} */ j) =>
    isJoined(i, j) ? (field.isPlain ? gap(places[i].at, places[j].at) : 0) : Infinity;
  const { way, length, legs, legOf } = findChain(places.length, bound, (i, j) =>
    solve(i, j, j > 1 ? { ...options, points: POINTS, record: false } : options),
  );
  const known = legs.flatMap((leg) => leg ?? []);
  const isSmooth =
    known.length === legs.length &&
    way.slice(1, -1).every((node, k) => crosses(passed[node - 2], leaving(reverse(known[k])), leaving(known[k + 1])));
  if (way.length < 3 || !isSmooth) {
    const path = legOf(0, 1) ?? solve(0, 1, options);
    /* A way over nodes that is shorter and no path, or not all of which was solved, leaves it open what is the shortest. */
    const isOpen = isGeodesic(path) && known.reduce((sum, leg) => sum + leg.lengthError, length) < path.length;
    return isOpen ? { ...path, status: 'stalled', converged: false } : path;
  }
  const solveAgain = (/** @type {number} */ k, /** @type {SolveOptions} */ asked) =>
    solveNear(field, [places[way[k]].at, places[way[k + 1]].at], asked, known[k].points);
  return joinLegs(known, options, solveAgain, null).path;
}

/** Where a path that begins at a node leads from there, a unit vector. @param {Path} path */
function leaving({ points }) {
  const tangent = [0, 1, 2].map((j) => 4 * points[3 + j] - points[6 + j] - 3 * points[j]);
  return tangent.map((x) => x / Math.sqrt(dot(tangent, tangent)));
}
