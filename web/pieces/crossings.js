/**
 * Curves along which an implicit surface crosses itself, where ∇f = 0, and f″ has one positive and one negative eigenvalue: four half sheets meet there, and a path may go on in any; and cuspidal edges, in which two
 * end, where f″ is of rank 1. A path consists of legs between places on such curves, which are moved until its length does not change with them. MATH.md, "Crossings".
 */

import { changes, LEG, lengthOf, nodesOf, placesOf, solvePulled, span } from '../creases/legs.js';
import { ahead, descend, scaled } from '../creases/linear.js';
import { isGeodesic, mostOf, stalled } from '../path.js';
import { holds } from '../search/candidates.js';
import { shortestWay, tableOf } from '../search/chain.js';
import { concatenate, inOrder, joinLegs, reverse } from '../search/join.js';
import { CONVERGED } from '../runtime/status.js';
import { roughlyIn } from '../search/rough.js';
import { drawLine, findWays, solveAlong } from '../search/routes.js';
import { dot, gap, largest } from '../vector.js';
import { AT_REST, crossingsFrom, jetOf } from './singular.js';

/** @typedef {import('../path.js').Path} Path */
/** @typedef {import('../search/routes.js').Field} Field */
/** @typedef {import('../runtime/heap.js').SolveOptions} SolveOptions */
/** @typedef {import('./singular.js').Crossing} Crossing */
/** @typedef {{ points: Float64Array, length: number }} Drawn a polyline on the surface */
/** @typedef {{ line: Float64Array, length: number, pulls: number[][] }} Leg */
/** @typedef {{ legs: Pick<Leg, 'line'>[], joints: Crossing[] }} Route polylines of legs, and one joint less */
/** spanned: how long the polyline is that leads over these joints. @typedef {Route & { spanned: number }} Split */
/** @typedef {{ legs: Leg[], joints: Crossing[], length: number }} Solved */
/** @typedef {{ field: Field, ends: number[][], exactness: Exactness, budget: { moves: number } }} Question budget: of nodes, for all that is tried */

/** A polyline passes a crossing where it leads nearer to it than so many of its chords are long. */
const NEAR = 1.5;
/** An edge that a chord spans is no farther from it than so many chords are long. */
const BEYOND = 10;
/** Polylines are drawn on the surface with so many points, and are shorter than what leads along them by this part at most, or, over an edge beside which they change sheets, by that; a path is so many times as short as its polyline, at most. */
const [DRAWN, ROUGH, OVER_EDGE, LONGER] = [63, 2e-3, 1e-2, 1.05];
/** Places next to each other on a polyline are beside one crossing if its directions there are no farther apart than this cosine says. */
const ALIKE = 0.7;
const SPACE = [1, 1, 1];
/** So many routes are tried. */
const MOST_ROUTES = 24;
/** Where joints of polylines are no farther apart than this part of the length they lead the same way; and as a rule where they are no farther apart than this one. */
const [BESIDE, APART] = [0.03, 0.25];
/** So often joints are moved, by no more than this part of the longer leg beside each, and no less than that one of a step. */
const [MOST_MOVES, FARTHEST, SHORTEST] = [20, 0.5, 1e-3];
/** Legs that hold do so in fewer steps. */
const WITHIN = { ...LEG, maxIterations: 30 };
/** @typedef {{ options: SolveOptions, balanced: number, aside: number }} Exactness how legs are solved, at which slope joints rest, and over what differences are taken: of slopes, in parts of the shorter leg beside a joint; of the lengths of a leg that ends at an edge, in parts of its own */
/** @type {Exactness} */
const EXACTLY = { options: WITHIN, balanced: 1e-7, aside: 1e-4 };
/** Joints on edges find their places roughly first, as most routes come to nothing. @type {Exactness} */
const ROUGHLY = { options: roughlyIn(31), balanced: 1e-4, aside: 1e-2 };
/** Then legs are so much more exact than the path, if they can be, or as exact as that; and where lengths are exact to t, joints are at rest below so many √t: then the length is right to a twentieth of t. */
const [FINER, BALANCED] = [[1e-2, 1], 0.3];
/** A leg to an edge takes thousands of moves of nodes; where the edge is lost in rounding, a thousand times as many, and these are all that are made. */
const MOST_WORK = 2e7;

/** Where lengths are that exact, differences of them are best over its fourth root: what rounding and curvature make of them is less than joints need. @param {number} tolerance @returns {Exactness} */
function exactTo(tolerance) {
  const aside = Math.sqrt(Math.sqrt(tolerance));
  return { options: { ...WITHIN, tolerance }, balanced: BALANCED * Math.sqrt(tolerance), aside };
}

/** @param {Route} route */
const passesEdge = ({ joints }) => joints.some(({ isEdge }) => isEdge);

/**
 * The shortest of the paths that lead over crossings, and of one that is known.
 * @param {Field} field @param {{ crossings: Crossing[], apart: number }} net places on all curves, and how far apart they are @param {number[][]} ends @param {SolveOptions} options
 * @param {Path} known
 * @returns {Path}
 */
export function overCrossings(field, net, ends, options, known) {
  const crossings = net.crossings.filter(({ place }) => gap(ends[0], place) + gap(place, ends[1]) <= mostOf(known) + 2 * net.apart);
  if (crossings.length === 0) return known;
  return inOrder(null, ends, (both, isTurned) => leadOver(field, net, crossings, both, options, isTurned ? reverse(known) : known));
}

/** As {@link overCrossings}, over some of these, from the lexicographically smaller end. @param {Field} field @param {{ crossings: Crossing[] }} net @param {Crossing[]} crossings @param {number[][]} ends @param {SolveOptions} options @param {Path} known @returns {Path} */
function leadOver(field, net, crossings, ends, options, known) {
  const lines = [...(known.points.length > 0 ? [known.points] : []), ...findWays(field, ends, 'global').ways];
  const ways = lines.map((line) => drawLine(field, ends, line, DRAWN));
  const drawn = [...ways, ...waysOver(field, net.crossings, crossings, ends)].filter(({ length }) => length >= 0);
  drawn.sort((a, b) => a.length - b.length);
  const followed = followAll(field, ends, drawn, mostOf(known));
  const solved = solveShortest(field, ends, options, followed.routes, mostOf(known));
  const chosen = solved.best ?? (isGeodesic(known) ? null : followed.routes[0]);
  if (!chosen) return known;
  const { legs, joints } = chosen;
  const places = placesOf({ ends }, joints);
  const solve = (/** @type {number} */ k, /** @type {SolveOptions} */ asked) =>
    solveAlong(field, [places[k], places[k + 1]], solved.best ? asked : roughlyIn(asked.points), legs[k].line);
  const { path } = joinLegs(/** @type {any} */ (legs), options, solve, null);
  const missed = Math.min(followed.missed, solved.missed);
  return missed < path.length ? { ...stalled(path), lengthError: path.length - missed } : path;
}

/**
 * The routes that polylines lead to, over all or some of the crossings that these pass, the shortest first; missed: as long as that, at most, is what a polyline leads along that leads to no route.
 * @param {Field} field @param {number[][]} ends @param {Drawn[]} drawn the shortest first @param {number} shortest what is longer is of no interest
 */
function followAll(field, ends, drawn, shortest) {
  const asked = { field, ends, budget: { moves: Infinity } };
  let missed = Infinity;
  /** @type {{ joints: Crossing[], path: Solved | null }[]} */
  const tried = [];
  for (const { points, length } of drawn) {
    if (length > LONGER * shortest) break;
    const first = split(field, ends, points);
    let least = first.joints.length > 0 ? Infinity : 0;
    /* Near a place where such curves meet, a polyline may cross some that a path passes by. */
    for (const /** @type {Route[]} */ open = [first]; open.length > 0 && tried.length < MOST_ROUTES; ) {
      const route = /** @type {Route} */ (open.shift());
      const { joints } = route;
      let one = tried.find((other) => areBeside(joints, other.joints, BESIDE * length));
      if (!one) {
        one = { joints, path: balance({ ...asked, exactness: passesEdge(route) ? ROUGHLY : EXACTLY }, route) };
        tried.push(one);
      }
      least = Math.min(least, one.path?.length ?? Infinity);
      if (joints.length > 1) open.push(...joints.map((_, j) => without(route, j)));
    }
    const most = first.spanned * (1 + (passesEdge(first) ? OVER_EDGE : ROUGH));
    shortest = Math.min(shortest, least || Infinity);
    if (least > most) missed = Math.min(missed, most);
  }
  return { routes: tried.flatMap(({ path }) => path ?? []).sort((a, b) => a.length - b.length), missed };
}

/**
 * The shortest of these routes, as exact as it is asked for; missed: as long as that, at least, is one that is not to be had so exactly.
 * @param {Field} field @param {number[][]} ends @param {SolveOptions} options @param {Solved[]} routes the shortest first @param {number} shortest what is longer is of no interest
 */
function solveShortest(field, ends, options, routes, shortest) {
  /** @type {Solved | null} */
  let best = null;
  for (const route of routes) {
    const isRough = passesEdge(route);
    const least = route.length * (isRough ? 1 - ROUGH : 1);
    if (least > shortest) break;
    const path = isRough ? solveExactly(field, ends, route, options.tolerance) : route;
    /* Where one edge is lost in rounding, others are. */
    if (!path) return { best, missed: least };
    if (path.length >= shortest) continue;
    best = path;
    shortest = path.length;
  }
  return { best, missed: Infinity };
}

/** A route over edges, solved as exactly as they allow; null: not so exactly as asked. @param {Field} field @param {number[][]} ends @param {Route} route @param {number} tolerance @returns {Solved | null} */
function solveExactly(field, ends, route, tolerance) {
  const budget = { moves: MOST_WORK };
  for (const exact of new Set(FINER.map((finer) => Math.max(LEG.tolerance, finer * tolerance)))) {
    const path = balance({ field, ends, exactness: exactTo(exact), budget }, route);
    if (path) return path;
  }
  return null;
}

/**
 * The graph's ways over each crossing, the shortest of those near each other. Edges end it: between them it leads from one to another, all of which are measured once.
 * @param {Field} field @param {Crossing[]} all @param {Crossing[]} near those of interest @param {number[][]} ends @returns {Drawn[]}
 */
function waysOver(field, all, near, ends) {
  const places = all.map(({ place }) => place);
  const stops = [...places, ...ends];
  const found = field.run((heap, record) => {
    const graph = field.graphs.find(heap, record, field, 0);
    if (graph?.status !== CONVERGED) return [];
    const measured = (/** @type {number[]} */ from) => heap.measureField(record, graph, from, places.flat()).lengths;
    for (const one of all) if (one.isEdge) one.lengths ??= measured(one.place);
    const rows = [...all.map((one) => one.lengths ?? []), ...ends.map(measured)];
    const known = (/** @type {number} */ i, /** @type {number} */ j) => rows[i][j] ?? rows[j][i] ?? Infinity;
    const lengths = tableOf(stops.length, (i, j) => (i > j ? known(i, j) : known(j, i)));
    const over = near.flatMap((joint) => {
      const [there, back] = ends.map((_, end) => shortestWay(stops.length, lengths, all.length + end, all.indexOf(joint)));
      const way = [...there.way, ...back.way.reverse().slice(1)];
      const joints = way.slice(1, -1).map((stop) => all[stop]);
      return joints.length > 0 && joints.every(Boolean) ? [{ way, joints, length: there.length + back.length }] : [];
    });
    over.sort((one, other) => one.length - other.length);
    /** @type {typeof over} */
    const kept = [];
    for (const one of over) if (!kept.some(({ joints }) => areBeside(joints, one.joints, APART * one.length))) kept.push(one);
    return kept.map(({ way }) => {
      const points = Math.floor((DRAWN - 1) / (way.length - 1));
      return way.slice(1).map((stop, k) => {
        const between = [stops[way[k]], stops[stop]];
        return { between, points, line: heap.searchGraph(record, graph, between[0], between[1], points, false).candidates[0] };
      });
    });
  });
  /* The graph's own lines cut off what is curved. */
  return found
    .filter((legs) => legs.every(({ line }) => line))
    .map((legs) => {
      const drawn = legs.map(({ between, points, line }) => drawLine(field, between, line, points));
      const lines = drawn.map(({ points }) => points);
      return { points: concatenate(lines, 3), length: lengthOf(drawn) };
    });
}

/** Whether joints lie on the same curve, as far as directions tell. @param {Crossing} one @param {Crossing} other */
const areAlike = (one, other) => Math.abs(dot(one.along, other.along)) > ALIKE;

/** Whether as many joints are no farther apart than that, on the same curves. @param {Crossing[]} some @param {Crossing[]} others @param {number} far */
const areBeside = (some, others, far) =>
  some.length === others.length && some.every((joint, i) => gap(joint.place, others[i].place) <= far && areAlike(joint, others[i]));

/** Nodes, and between two whose normals are turned over, where the chord leads from sheet to sheet, the place on the edge beyond it in which these end. @param {import('./singular.js').Jets} jets @param {number[][]} nodes @param {number} far @param {number} size */
function withEdges(jets, nodes, far, size) {
  const seen = jets(nodes.flat());
  const slopeAt = (/** @type {number} */ i) => jetOf(seen, i).slice(1, 4);
  const turned = [...nodes.keys()].filter((i) => i > 0 && dot(slopeAt(i), slopeAt(i - 1)) < 0);
  const middles = turned.map((i) => nodes[i].map((x, j) => (x + nodes[i - 1][j]) / 2));
  const edges = crossingsFrom(jets, middles, far, size);
  return nodes.flatMap((node, i) => {
    const edge = edges[turned.indexOf(i)];
    return edge?.isEdge ? [edge.place, node] : [node];
  });
}

/** A polyline cut where it passes crossings; its nodes beside these may lie on any sheet. @param {Field} field @param {number[][]} ends @param {Float64Array} line @returns {Split} */
function split({ jets }, ends, line) {
  const nodes = nodesOf(line, 3);
  const step = Math.max(...nodes.slice(1).map((node, i) => gap(node, nodes[i])));
  const size = gap(ends[0], ends[1]);
  const inner = withEdges(jets, nodes.slice(1, -1), BEYOND * step, size);
  /** @type {{ joint: Crossing, away: number, nearest: number, last: number }[]} */
  const passed = [];
  /** @type {number[][][]} */
  const between = [[]];
  for (const [i, joint] of crossingsFrom(jets, inner, NEAR * step, size).entries()) {
    if (!joint) {
      between[passed.length].push(inner[i]);
      continue;
    }
    const away = gap(joint.place, inner[i]);
    const before = passed.at(-1);
    if (before?.last !== i - 1 || !areAlike(joint, before.joint)) {
      between.push([]);
      passed.push({ joint, away, nearest: i, last: i });
      continue;
    }
    if (away <= before.away) Object.assign(before, { joint, away, nearest: i });
    before.last = i;
  }
  const joints = passed.map(({ joint }) => joint);
  const places = placesOf({ ends }, joints);
  /* A chord from sheet to sheet cuts the crossing off, as do those from the nodes beside it. */
  const over = [ends[0], ...inner, ends[1]];
  for (const { joint, nearest } of passed) over[nearest + 1] = joint.place;
  return {
    joints,
    spanned: span(over.flat(), SPACE),
    legs: between.map((own, k) => ({ line: Float64Array.from([places[k], ...own, places[k + 1]].flat()) })),
  };
}

/** A path that goes on within a sheet where it had a joint. @param {Route} route @param {number} j @returns {Route} */
function without({ joints, legs }, j) {
  const line = Float64Array.from([...legs[j].line.slice(0, -3), ...legs[j + 1].line.slice(3)]);
  return { joints: joints.filter((_, i) => i !== j), legs: [...legs.slice(0, j), { line }, ...legs.slice(j + 2)] };
}

/**
 * The leg near that line between two places, null if it does not hold. Where one ends at an edge, there it is no smoother than a power of 3/2, and its direction is known much worse than its length: how
 * this changes is a difference.
 * @param {Question} question @param {Pick<Leg, 'line'>} leg @param {number[][]} places @param {(Crossing | undefined)[]} joints which of these are joints @returns {Leg | null}
 */
function solveLeg(question, { line }, places, joints) {
  const { field, exactness, budget } = question;
  const solve = (/** @type {number[][]} */ between, /** @type {Float64Array} */ near) => {
    const solved = budget.moves > 0 ? solvePulled(field, between, near, exactness.options) : null;
    budget.moves -= solved?.work ?? 0;
    return solved && holds(solved) ? solved : null;
  };
  const leg = solve(places, line);
  if (!leg) return null;
  const { path, pulls } = leg;
  for (const [end, joint] of joints.entries()) {
    if (!joint?.isEdge) continue;
    const [back, ahead] = [-1, 1].map((sign) => {
      const place = moved(question, { ...joint, place: places[end] }, sign * exactness.aside * path.length)?.place;
      const other = place && solve(end ? [places[0], place] : [place, places[1]], path.points);
      return other && { along: dot(place, joint.along), length: other.path.length };
    });
    if (!back || !ahead) return null;
    pulls[end] = scaled(joint.along, (ahead.length - back.length) / (ahead.along - back.along));
  }
  return { line: path.points, length: path.length, pulls };
}

/** All legs over these joints; null: one does not hold. @param {Question} question @param {Route} route @returns {Solved | null} */
function solveAll(question, { joints, legs }) {
  const places = placesOf(question, joints);
  const solved = legs.map((leg, k) => solveLeg(question, leg, [places[k], places[k + 1]], [joints[k - 1], joints[k]]));
  return solved.every((leg) => leg !== null) ? { joints, legs: solved, length: lengthOf(solved) } : null;
}

/** A crossing moved along its curve. @param {Question} question @param {Crossing} crossing @param {number} by @returns {Crossing | null} */
function moved({ field: { jets }, ends }, { place, along }, by) {
  const size = gap(ends[0], ends[1]);
  return crossingsFrom(jets, [ahead(place, along, by)], Math.abs(by) + AT_REST * size, size)[0];
}

/** How long the shorter, or the longer, of the two legs beside each joint is. @param {Leg[]} legs @param {(a: number, b: number) => number} choose */
const beside = (legs, choose) => legs.slice(1).map(({ length }, j) => choose(legs[j].length, length));

/**
 * Moves joints until the length does not change with them; null: they do not come to rest, or where it is no minimum.
 * @param {Question} question @param {Route} route @returns {Solved | null}
 */
function balance(question, route) {
  const { exactness } = question;
  let now = route.joints.length > 0 ? solveAll(question, route) : null;
  for (let move = 0; now && move < MOST_MOVES; move++) {
    const { joints, legs } = now;
    const { slopes, matrix } = changes(
      legs,
      placesOf(question, joints),
      joints.map(({ along }) => along),
      beside(legs, Math.min).map((least) => exactness.aside * least),
      (j, by) => moved(question, joints[j], by),
      (i, from, to) => solveLeg(question, legs[i], [from, to], [joints[i - 1], joints[i]]),
    );
    const down = descend(matrix, slopes);
    if (largest(slopes) <= exactness.balanced) return down && !down.shifted ? now : null;
    now = down && moveJoints(question, now, down.step);
  }
  return null;
}

/** A path whose joints are moved by a step, or a part of it, and that is no longer; null: there is none. @param {Question} question @param {Solved} route @param {number[]} step @returns {Solved | null} */
function moveJoints(question, route, step) {
  const longest = beside(route.legs, Math.max);
  const most = Math.max(1, ...step.map((x, j) => Math.abs(x) / (FARTHEST * longest[j])));
  for (let factor = 1 / most; factor > SHORTEST; factor /= 2) {
    const joints = route.joints.map((joint, j) => moved(question, joint, factor * step[j]));
    const tried = joints.every((joint) => joint !== null) ? solveAll(question, { joints, legs: route.legs }) : null;
    if (tried && tried.length <= route.length * (1 + question.exactness.options.tolerance)) return tried;
  }
  return null;
}
