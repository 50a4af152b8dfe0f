/** Paths through the nodes of an implicit surface: of all chains of legs from node to node the shortest, of which as few as possible are solved. */

import { isGeodesic, stalled } from '../path.js';
import { ELEMENTS } from '../search/candidates.js';
import { findChain } from '../search/chain.js';
import { inOrder, joinLegs, reverse } from '../search/join.js';
import { roughlyIn } from '../search/rough.js';
import { findGlobal, solveNear } from '../search/routes.js';
import { gap } from '../vector.js';
import { overCrossings } from './crossings.js';
import { crosses, findNet } from './nodes.js';

/** @typedef {import('../path.js').Path} Path */
/** @typedef {import('../search/routes.js').Field} Field */
/** @typedef {import('../runtime/heap.js').SolveOptions} SolveOptions */

/** Legs are solved with so many points, to learn how long they are. */
const POINTS = 31;
/** Points a direction of the bounds from which nodes are looked for; and where there are no bounds, near the ends. */
const [FINE, ROUGH] = [24, 12];
/** Without bounds nodes are looked for where ways of so many times the ends' distance lead; twice as far where none was found, so many times. */
const [NEAR, MOST_ROUNDS] = [2, 2];
/** And where ways lead that are longer than a known path by this factor: as much room as cells need. */
const LONGER = 1.1;
/** An end nearer to a node than this part of what is between the ends is that node. */
const SAME = 3e-12;

/** The box around all places that ways up to a length pass, as these lie in an ellipsoid whose foci are the ends. @param {number[][]} ends @param {number} length */
function boxAround([from, to], length) {
  const short = length ** 2 - gap(from, to) ** 2;
  return from.flatMap((x, j) => {
    const [middle, half] = [(x + to[j]) / 2, Math.sqrt(short + (to[j] - x) ** 2) / 2];
    return [middle - half, middle + half];
  });
}

/** The nodes within the bounds; null where there are no bounds. @param {Field} field of an implicit surface */
export function netOf(field) {
  const { box, graphs } = field;
  graphs.net ??= box && findNet(field, box, FINE);
  return graphs.net;
}

/**
 * The globally shortest path between two ends: within a sheet, or through nodes where that is shorter, or the only way.
 * @param {Field} field @param {number[][]} ends @param {SolveOptions} options
 * @returns {Path}
 */
export function findThrough(field, ends, options) {
  const { domain } = field;
  /** @type {Path | undefined} */
  let within;
  const solve = () => (within ??= findGlobal(field, ends, options, 1)[0]);
  /** @param {ReturnType<typeof findNet>} net */
  const through = (net) => {
    const path = passNodes(net);
    return field.isPlain && options.algorithm === ELEMENTS && !options.record ? overCrossings(field, net, ends, options, path) : path;
  };
  /** @param {ReturnType<typeof findNet>} net */
  const passNodes = (net) => {
    if (net.nodes.length === 0) return solve();
    return inOrder(null, ends, (both, isTurned) => joinThrough(field, net, both, options, () => (isTurned ? reverse(solve()) : solve())));
  };
  if (domain) return solve();
  const net = netOf(field);
  return net ? through(net) : findFarther(field, ends, through);
}

/**
 * Without bounds: the shortest path through what nodes there are where it may lead.
 * @param {Field} field @param {number[][]} ends @param {(net: ReturnType<typeof findNet>) => Path} through @returns {Path}
 */
function findFarther(field, ends, through) {
  const nearest = NEAR * gap(ends[0], ends[1]);
  const straight = solveNear(field, ends, roughlyIn(POINTS), null);
  let reach = field.isPlain && isGeodesic(straight) ? LONGER * straight.length : nearest;
  for (let round = 0; ; round++) {
    const path = through(findNet(field, boxAround(ends, reach), reach > nearest ? FINE : ROUGH));
    const isFound = path.length >= 0;
    if (round === MOST_ROUNDS || (isFound && !(field.isPlain && path.length > reach))) return path;
    reach = isFound ? LONGER * path.length : NEAR * reach;
  }
}

/**
 * The shortest path, of whatever it passes.
 * @param {Field} field @param {ReturnType<typeof findNet>} net @param {number[][]} ends @param {SolveOptions} options @param {() => Path} within one that passes no node
 * @returns {Path}
 */
function joinThrough(field, { nodes, partsAt, near }, ends, options, within) {
  const passed = nodes.filter(({ at }) => ends.every((end) => gap(at, end) > SAME * gap(ends[0], ends[1])));
  const places = [...ends.map((at) => ({ at, parts: partsAt(at) })), ...passed];
  const solve = (/** @type {number} */ i, /** @type {number} */ j, /** @type {SolveOptions} */ asked) =>
    findGlobal(field, [places[i].at, places[j].at], asked, 1)[0];
  const isNear = (/** @type {number} */ i, /** @type {number} */ j) => gap(places[i].at, places[j].at) < near * (+(i > 1) + +(j > 1));
  const isJoined = (/** @type {number} */ i, /** @type {number} */ j) =>
    isNear(i, j) || places[i].parts.some((part) => places[j].parts.includes(part));
  const bound = (/** @type {number} */ i, /** @type {number} */ j) =>
    isJoined(i, j) ? (field.isPlain ? gap(places[i].at, places[j].at) : 0) : Infinity;
  const { way, legsOf, solvedWay, least } = findChain(places.length, bound, (i, j) =>
    j > 1 ? solve(i, j, { ...options, points: POINTS, record: false }) : weighed(within(), options),
  );
  const known = legsOf(way).flatMap((leg) => leg ?? []);
  /** Whether a way leads through nodes, one at least, as paths do. @param {number[]} over @param {Path[]} legs */
  const isSmooth = (over, legs) =>
    over.length > 2 &&
    legs.length === over.length - 1 &&
    over.slice(1, -1).every((node, k) => node > 1 && crosses(passed[node - 2], reverse(legs[k]), legs[k + 1]));
  const solveAgain = (/** @type {number} */ k, /** @type {SolveOptions} */ asked) =>
    solveNear(field, [places[way[k]].at, places[way[k + 1]].at], asked, known[k].points);
  const path = isSmooth(way, known) ? joinLegs(known, options, solveAgain, null).path : within();
  /* What lies on two sides of nodes is joined by no other leg. */
  const isOpen = (/** @type {number} */ i, /** @type {number} */ j) => {
    const over = solvedWay(i, j);
    return !isSmooth(over, /** @type {Path[]} */ (legsOf(over)));
  };
  /* A way over nodes that is shorter and no path, or not all of which was solved, leaves it open what is the shortest. */
  const shortest = known.reduce((sum, leg) => sum + leg.lengthError, least(isOpen));
  return isGeodesic(path) && shortest < path.length ? stalled(path) : path;
}

/** What passes a node nearer than can be told is no path by itself: a way over that which is as long stands before it. @param {Path} path @param {SolveOptions} options */
const weighed = (path, { tolerance }) => (isGeodesic(path) ? path : { ...path, length: path.length * (1 + tolerance) });
