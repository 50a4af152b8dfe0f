/**
 * Curves along which an implicit surface crosses itself: where ∇f = 0, and f″ has one positive and one negative eigenvalue. Four half sheets meet there, and a path may go on in any: it
 * consists of legs between places on such curves, which are moved until its length does not change with them. MATH.md, "Crossings".
 */

import { changes, LEG, lengthOf, nodesOf, placesOf, solvePulled, span } from '../creases/legs.js';
import { solveLinear } from '../creases/linear.js';
import { mostOf, stalled } from '../path.js';
import { holds } from '../search/candidates.js';
import { concatenate, inOrder, joinLegs, reverse, turned } from '../search/join.js';
import { CONVERGED } from '../runtime/status.js';
import { drawLine, findWays, solveAlong } from '../search/routes.js';
import { dot, gap, sumOf } from '../vector.js';
import { AT_REST, crossingsFrom } from './singular.js';

/** @typedef {import('../path.js').Path} Path */
/** @typedef {import('../search/routes.js').Field} Field */
/** @typedef {import('../runtime/heap.js').SolveOptions} SolveOptions */
/** @typedef {import('./singular.js').Crossing} Crossing */
/** @typedef {{ points: Float64Array, length: number }} Drawn a polyline on the surface */
/** @typedef {{ line: Float64Array, length: number, pulls?: number[][] }} Leg its polyline as it was solved last */
/** @typedef {{ legs: Leg[], joints: Crossing[] }} Route one joint less than legs */

/** A polyline passes a crossing where it leads nearer to it than so many of its chords are long. */
const NEAR = 1.5;
/** Polylines are drawn on the surface with so many points, and are shorter than what leads along them by this part at most; a path is so many times as short as its polyline, at most. */
const [DRAWN, ROUGH, LONGER] = [63, 2e-3, 1.05];
/** Places next to each other on a polyline are beside one crossing if its directions there are no farther apart than this cosine says. */
const ALIKE = 0.7;
const SPACE = [1, 1, 1];
/** So many routes are tried. */
const MOST_ROUTES = 24;
/** Where joints of polylines are no farther apart than this part of the length they lead the same way; and as a rule where they are no farther apart than this one. */
const [BESIDE, APART] = [0.03, 0.25];
/** Joints are at rest where the length changes with them by no more than this part of the way; so often they are moved, by no more than the third part of the longer leg beside each, and no less than the last one of a step. */
const [BALANCED, MOST_MOVES, FARTHEST, SHORTEST] = [1e-7, 20, 0.5, 1e-3];
/** Legs that hold do so in fewer steps. */
const WITHIN = { ...LEG, maxIterations: 30 };
/** Differences of lengths are taken over this part of the shorter leg. */
const DIFFERENCE = 1e-4;

/**
 * The shortest of the paths that lead over crossings, and of one that is known.
 * @param {Field} field @param {{ crossings: Crossing[], apart: number }} net places on all curves, and how far apart they are @param {number[][]} ends @param {SolveOptions} options
 * @param {Path} known
 * @returns {Path}
 */
export function overCrossings(field, net, ends, options, known) {
  const crossings = net.crossings.filter(({ place }) => gap(ends[0], place) + gap(place, ends[1]) <= mostOf(known) + 2 * net.apart);
  if (crossings.length === 0) return known;
  return inOrder(null, ends, (both, isTurned) => leadOver(field, crossings, both, options, isTurned ? reverse(known) : known));
}

/** As {@link overCrossings}, over some of these, from the lexicographically smaller end. @param {Field} field @param {Crossing[]} crossings @param {number[][]} ends @param {SolveOptions} options @param {Path} known @returns {Path} */
function leadOver(field, crossings, ends, options, known) {
  const lines = [...(known.points.length > 0 ? [known.points] : []), ...findWays(field, ends, 'global').ways];
  const ways = lines.map((line) => drawLine(field, ends, line, DRAWN)).filter(({ length }) => length >= 0);
  const drawn = [...ways, ...waysOver(field, crossings, ends)].sort((a, b) => a.length - b.length);
  /** @type {Route | null} */
  let best = null;
  let missed = Infinity;
  /** @type {{ joints: Crossing[], path: Route | null }[]} */
  const tried = [];
  for (const { points, length } of drawn) {
    if (length > LONGER * Math.min(mostOf(known), best ? lengthOf(best.legs) : Infinity)) break;
    const first = split(field, ends, points);
    let found = first.joints.length > 0 ? Infinity : 0;
    /* Near a place where such curves meet, a polyline may cross some that a path passes by. */
    for (const open = [first]; open.length > 0 && tried.length < MOST_ROUTES; ) {
      const route = /** @type {Route} */ (open.shift());
      const { joints } = route;
      const other = tried.find((one) => areBeside(joints, one.joints, BESIDE * length));
      const path = other ? other.path : balance(field, ends, route);
      if (!other) tried.push({ joints, path });
      if (path && !(best && lengthOf(best.legs) <= lengthOf(path.legs))) best = path;
      if (path) found = Math.min(found, lengthOf(path.legs));
      if (joints.length > 1) open.push(...joints.map((_, j) => without(route, j)));
    }
    const most = sumOf(first.legs.map(({ line }) => span(line, SPACE))) * (1 + ROUGH);
    if (found > most) missed = Math.min(missed, most);
  }
  if (!best || mostOf(known) <= lengthOf(best.legs)) return known;
  const { legs, joints } = best;
  const places = placesOf({ ends }, joints);
  const solve = (/** @type {number} */ k, /** @type {SolveOptions} */ asked) =>
    solveAlong(field, [places[k], places[k + 1]], asked, legs[k].line);
  const { path } = joinLegs(/** @type {any} */ (legs), options, solve, null);
  return missed < path.length ? { ...stalled(path), lengthError: path.length - missed } : path;
}

/** The graph's ways over one crossing each, the shortest of those near each other. @param {Field} field @param {Crossing[]} crossings @param {number[][]} ends @returns {Drawn[]} */
function waysOver(field, crossings, ends) {
  const places = crossings.flatMap(({ place }) => place);
  return field.run((heap, record) => {
    const graph = field.graphs.find(heap, record, field, 0);
    if (graph?.status !== CONVERGED) return [];
    const lengths = ends.map((end) => heap.measureField(record, graph, end, places).lengths);
    const over = crossings.map((joint, i) => ({ joint, length: lengths[0][i] + lengths[1][i] })).filter(({ length }) => length < Infinity);
    over.sort((one, other) => one.length - other.length);
    /** @type {typeof over} */
    const kept = [];
    for (const one of over) if (!kept.some(({ joint }) => areBeside([joint], [one.joint], APART * one.length))) kept.push(one);
    return kept.flatMap(({ joint, length }) => {
      const [there, back] = ends.flatMap((end) =>
        heap.searchGraph(record, graph, end, joint.place, (DRAWN - 1) / 2, false).candidates.slice(0, 1),
      );
      return back ? [{ points: concatenate([there, turned(back, 3)], 3), length }] : [];
    });
  });
}

/** Whether joints lie on the same curve, as far as directions tell. @param {Crossing} one @param {Crossing} other */
const areAlike = (one, other) => Math.abs(dot(one.along, other.along)) > ALIKE;

/** Whether as many joints are no farther apart than that, on the same curves. @param {Crossing[]} some @param {Crossing[]} others @param {number} far */
const areBeside = (some, others, far) =>
  some.length === others.length && some.every((joint, i) => gap(joint.place, others[i].place) <= far && areAlike(joint, others[i]));

/** A polyline cut where it passes crossings; its nodes beside these may lie on any sheet. @param {Field} field @param {number[][]} ends @param {Float64Array} line @returns {Route} */
function split({ jets }, ends, line) {
  const nodes = nodesOf(line, 3);
  const step = Math.max(...nodes.slice(1).map((node, i) => gap(node, nodes[i])));
  const inner = nodes.slice(1, -1);
  /** @type {{ joint: Crossing, away: number, last: number }[]} */
  const passed = [];
  /** @type {number[][][]} */
  const between = [[]];
  for (const [i, joint] of crossingsFrom(jets, inner, NEAR * step, gap(ends[0], ends[1])).entries()) {
    if (!joint) {
      between[passed.length].push(inner[i]);
      continue;
    }
    const away = gap(joint.place, inner[i]);
    const before = passed.at(-1);
    const isSame = before?.last === i - 1 && areAlike(joint, before.joint);
    if (!isSame) between.push([]);
    if (isSame) passed.pop();
    passed.push({ ...(isSame && before.away < away ? before : { joint, away }), last: i });
  }
  const joints = passed.map(({ joint }) => joint);
  const places = placesOf({ ends }, joints);
  return {
    joints,
    legs: between.map((own, k) => ({ line: Float64Array.from([places[k], ...own, places[k + 1]].flat()), length: Number.NaN })),
  };
}

/** A path that goes on within a sheet where it had a joint. @param {Route} route @param {number} j @returns {Route} */
function without({ joints, legs }, j) {
  const line = Float64Array.from([...legs[j].line.slice(0, -3), ...legs[j + 1].line.slice(3)]);
  return { joints: joints.filter((_, i) => i !== j), legs: [...legs.slice(0, j), { line, length: Number.NaN }, ...legs.slice(j + 2)] };
}

/** The leg near that line between two places, null if it does not hold. @param {Field} field @param {Leg} leg @param {number[]} from @param {number[]} to @returns {Leg | null} */
function solveLeg(field, { line }, from, to) {
  const { path, pulls } = solvePulled(field, [from, to], line, WITHIN);
  return holds({ path }) ? { line: path.points, length: path.length, pulls } : null;
}

/** All legs over these joints; null: one does not hold. @param {Field} field @param {number[][]} ends @param {Route} route @returns {Route | null} */
function solveAll(field, ends, { joints, legs }) {
  const places = placesOf({ ends }, joints);
  const solved = legs.map((leg, k) => solveLeg(field, leg, places[k], places[k + 1]));
  return solved.every((leg) => leg !== null) ? { joints, legs: solved } : null;
}

/** A crossing moved along its curve. @param {Field} field @param {Crossing} crossing @param {number} by @param {number} size of what is between the ends @returns {Crossing | null} */
const moved = ({ jets }, { place, along }, by, size) =>
  crossingsFrom(jets, [place.map((x, k) => x + by * along[k])], Math.abs(by) + AT_REST * size, size)[0];

/** How long the shorter of the two legs beside each joint is. @param {Leg[]} legs */
const leastBeside = (legs) => legs.slice(1).map(({ length }, j) => Math.min(legs[j].length, length));

/** Whether a matrix is positive definite, that is zero but on its diagonal and beside it. @param {number[][]} matrix */
function isPositive(matrix) {
  let pivot = Infinity;
  return matrix.every((row, j) => {
    pivot = row[j] - (j > 0 ? row[j - 1] ** 2 / pivot : 0);
    return pivot > 0;
  });
}

/**
 * Moves joints until the length does not change with them; null: they do not come to rest, or where it is no minimum.
 * @param {Field} field @param {number[][]} ends @param {Route} route @returns {Route | null}
 */
function balance(field, ends, route) {
  let now = route.joints.length > 0 ? solveAll(field, ends, route) : null;
  for (let move = 0; now && move < MOST_MOVES; move++) {
    const { joints, legs } = now;
    const { slopes, matrix } = changes(
      legs,
      placesOf({ ends }, joints),
      joints.map(({ along }) => along),
      leastBeside(legs).map((least) => DIFFERENCE * least),
      (j, by) => moved(field, joints[j], by, gap(ends[0], ends[1])),
      (i, from, to) => solveLeg(field, legs[i], from, to),
    );
    const isBent = isPositive(matrix);
    if (slopes.every((slope) => Math.abs(slope) <= BALANCED)) return isBent ? now : null;
    const step = isBent ? solveLinear(matrix, slopes) : slopes;
    now = step && descend(field, ends, now, step);
  }
  return null;
}

/** A path whose joints are moved back by a step, or a part of it, and that is no longer; null: there is none. @param {Field} field @param {number[][]} ends @param {Route} route @param {number[]} step @returns {Route | null} */
function descend(field, ends, route, step) {
  const size = gap(ends[0], ends[1]);
  const longest = route.joints.map((_, j) => Math.max(route.legs[j].length, route.legs[j + 1].length));
  const most = Math.max(1, ...step.map((x, j) => Math.abs(x) / (FARTHEST * longest[j])));
  for (let factor = 1 / most; factor > SHORTEST; factor /= 2) {
    const joints = route.joints.map((joint, j) => moved(field, joint, -factor * step[j], size));
    const tried = joints.every((joint) => joint !== null) ? solveAll(field, ends, { joints, legs: route.legs }) : null;
    if (tried && lengthOf(tried.legs) <= lengthOf(route.legs) * (1 + LEG.tolerance)) return tried;
  }
  return null;
}
