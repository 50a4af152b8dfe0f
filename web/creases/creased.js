/**
 * Paths across creases: geodesics on smooth sides of the surface, joined where they cross, and legs along creases between them. Which way they lead polylines tell;
 * what moves are the places at which legs meet. MATH.md, "Across creases".
 */

import { stalled } from '../path.js';
import { ELEMENTS } from '../search/candidates.js';
import { isAfter, joinLegs, placed, reverse } from '../search/join.js';
import { drawLine, findWays, settleEnd, solveAlong } from '../search/routes.js';
import { gap, sumOf } from '../vector.js';
import { poleBeside, polesOf } from './at-poles.js';
import { cut } from './cut.js';
import { areFaint } from './faint.js';
import { follow } from './follow.js';
import { isOnEdge, LEG, lengthOf, lineOf, placesOf, roundingOf } from './legs.js';
import { followPinned } from './pinned.js';
import { writeShore } from './shores.js';
import { isBeside, measureLength, measureLine, roundingsOf, sketch } from './sketches.js';

/** @typedef {import('../path.js').Path} Path */
/** @typedef {import('../search/routes.js').Field} Field */
/** @typedef {import('../runtime/heap.js').SolveOptions} SolveOptions */
/** @typedef {import('./legs.js').Question} Question */
/** @typedef {import('./legs.js').Route} Route */
/** @typedef {import('./sketches.js').Sketch} Sketch */

/** Steps of Newton for one question, and for following one polyline. */
const [MOST_NEWTON, MOST_FOLLOWING] = [30_000, 10_000];
/** A path is longer than its polyline by no more than this part: in the rectangle, where a polyline is measured, and elsewhere; and shorter by no more than the third. */
const [ROUGH, ROUGHER, LOOSE] = [2e-3, 0.02, 0.04];
/** A path that is longer than its polyline by this part is none of its own. */
const ASTRAY = 0.1;
/** A way through the graph, whose edges may pass what is narrow, is shorter than a path by no more than this part. */
const COARSE = 0.25;
/** Polylines are measured to this part where what measures length jumps. */
const EXACT = 1.0003;
/** A path that is longer than the graph's way by no more than this needs no finer look. */
const NEARLY = 1.003;
/** A way of the graph may lead to a path shorter by so much. */
const UNTOLD = 1.01;
/** A graph whose way is longer than a path by this sees too little. */
const BLIND = 1.05;
/** A path is the straight line in space if it is longer by no more than this part. */
const STRAIGHT = 1e-9;
/** Paths are solved to this part of their length where those next to them are. */
const NEAR = 1e-6;
/** Polylines lead the same way that are nowhere farther apart than this part of their length, or than the second if they cross the same creases. */
const [APART, ALIKE] = [0.02, 0.1];

/** @typedef {{ line: Float64Array, crossed: string | null }} Understood a polyline that was followed, and which creases it crosses; null: not known, or past corners, of which that does not tell the side */
/** @typedef {{ line: Float64Array, measured: number }} Way a polyline, and how long it is on the surface */
/** findSmooth finds paths as if there were no creases; findAround over the plane around a pole. @typedef {{ findSmooth: (options: SolveOptions) => Path[], findAround: (pole: number) => Path[] }} Others */
/** all: every path that is found, not the shortest one alone. @typedef {import('../pieces/pieces.js').Start | 'all'} Sought */
/** paths: `converged`; path: the first of them, or null; bound: the shortest is no longer, by what was measured; most: nor, by ways, too, that could not be followed: beyond it a shorter one was seen; known: a path within that; rough: the shortest polyline, if any is measured, as a path that is `stalled`. @typedef {{ path: Path | null, known: Path | null, paths: Path[], bound: number, most: number, rough: () => Path | null }} Creased */

/**
 * The shortest path near a start, or of all that are found; or all of them, shortest first.
 * @param {Field} field @param {number[][]} ends @param {SolveOptions} options @param {Sought} start @param {number} [finer] as findWays takes it
 * @param {Others | null} [others]
 * @returns {Creased | null} null: there are no creases
 */
export function findCreased(field, ends, options, start, finer = 0, others = null) {
  const { domain, pieces } = field;
  const isWhole = pieces.length === 0 && !domain?.turn;
  if (!field.sides || !isWhole || options.algorithm !== ELEMENTS || options.record || options.maxIterations < LEG.maxIterations)
    return null;
  const sides = field.sides();
  if (!sides) return null;
  sides.begin();
  /* As everywhere: exchanged ends give the same path. */
  const isTurned = !ArrayBuffer.isView(start) && isAfter(ends[0], ends[1]);
  const settled = field.domain ? ends : ends.map((end) => settleEnd(field, end));
  const asked = isTurned ? [settled[1], settled[0]] : settled;
  const turn = (/** @type {Path} */ path) => (isTurned ? placed(domain, reverse(path), ends[0]) : path);
  const ways = findWays(field, asked, start, finer);
  /* A finer graph that does not join the ends, as one on an edge, tells nothing of them. */
  if (finer && ways.ways.length === 0) return null;
  const known = others ? findElse(field, ends, options, { sides, ways, isAll: start === 'all' }, others) : [];
  if (known.length > 0) return { path: known[0], known: known[0], paths: known, bound: Infinity, most: Infinity, rough: () => null };
  const ask = () => ({ field, sides, ends: asked, budget: { steps: MOST_NEWTON } });
  const { routes, least, bound, most } = findRoutes(ask(), ways, start);
  const length = leastOf(routes);
  /* A graph that knows no way nearly as short may know none where the shortest leads; in the rectangle a finer one may see more where it is not certain. */
  const isOpen = ways.distance > length * BLIND || (field.domain && length > most);
  if (length < Infinity && !finer && ways.distance < Infinity && isOpen) {
    const other = findCreased(field, ends, options, start, 1);
    if (other && (other.known || other.most < length)) return other;
  }
  const paths = routes
    .slice(0, start === 'all' ? routes.length : 1)
    .map((route) => turn(write(ask(), route, options)))
    .filter((path) => path.converged);
  const [path = null] = paths;
  return {
    path,
    known: path && path.length <= most ? path : null,
    paths,
    bound,
    most,
    rough: () => least && turn(roughly(field, asked, least, options.points)),
  };
}

/**
 * Paths that are better found by others: across creases that they do not notice, and beside the pole that the shortest way passes.
 * @param {Field} field @param {number[][]} ends @param {SolveOptions} options @param {{ sides: import('../manifold/sides.js').Sides, ways: ReturnType<typeof findWays>, isAll: boolean }} known @param {Others} others @returns {Path[]}
 */
function findElse(field, ends, options, { sides, ways: { ways, distance }, isAll }, { findSmooth, findAround }) {
  const { domain } = field;
  if (!domain) return field.isPlain && areFaint(sides, ways) ? solveAcross(field, ends, options, findSmooth) : [];
  const passed = isAll ? [] : poleBeside(domain, ways[0] ?? null);
  /* Over the plane around one pole others are circles, which may be in the way. */
  for (const pole of passed.length > 0 ? new Set([...passed, ...polesOf(domain)]) : []) {
    const paths = findAround(pole).filter(({ length }) => length <= distance * (1 + COARSE));
    if (paths.length > 0) return paths;
  }
  return [];
}

/**
 * The paths across creases that they do not notice: where joints come to rest near those that elements follow, they are as exact as on smooth sides; else as these are.
 * @param {Field} field @param {number[][]} ends @param {SolveOptions} options @param {(options: SolveOptions) => Path[]} findSmooth @returns {Path[]}
 */
function solveAcross(field, ends, options, findSmooth) {
  const tolerance = Math.max(options.tolerance, NEAR);
  const solve = (/** @type {SolveOptions} */ asked) => findSmooth(asked).filter(({ converged }) => converged);
  const found = solve({ ...options, tolerance });
  const exact = found.flatMap((path) => {
    const near = findCreased(field, ends, options, path.points)?.path;
    return near && Math.abs(near.length - path.length) <= tolerance * path.length ? near : [];
  });
  return exact.length === found.length ? exact : solve(options);
}

/** The routes that polylines lead to, each once, the best one first, the shortest of these, if it was measured, and what no path is shorter than that is. @param {Question} question @param {ReturnType<typeof findWays>} found @param {Sought} start @returns {{ routes: Route[], least: Way | null, bound: number, most: number }} */
function findRoutes(question, { ways, distance: told }, start) {
  const { field, sides, ends } = question;
  const width = ends[0].length;
  const isBody = field.isPlain && !field.domain;
  const isAll = start === 'all';
  /* Polylines in the rectangle are ways, so none is shorter than the shortest path. */
  const measured = (field.domain ? ways : [])
    .map((line) => ({ line, measured: measureLine(field, sides, line) }))
    .filter(({ measured }) => measured >= 0);
  /** @type {Way | null} */
  let least = measured.reduce(shortestOf, null);
  /* Edges of the graph cut folds off, as chords of its ways do. */
  const cutOff = field.isPlain && least && least.line.length > 4 ? least.measured / sumOf(field.chords?.(least.line) ?? []) : 1;
  const distance = (cutOff || 1) * told;
  /** @type {Route[]} */
  const routes = [];
  let shortest = Infinity;
  /** @type {Understood[]} */
  const understood = [];
  /** @type {Sketch[]} */
  let missed = [];
  let strays = false;
  for (const rounding of roundingsOf(field, isAll)) {
    const sketches = sketch(field, sides, ends, ways, rounding);
    /* As they are ways are followed where edges are sharp. */
    if (isBody && rounding.within > 0 && !sketches.some(({ isRelaxed }) => isRelaxed)) continue;
    for (const drawn of sketches) {
      const { line, length } = drawn;
      if (!isAll && length * (1 - rounding.dearer) > shortest) continue;
      /* A chord through the body is no way. */
      if (isBody && !drawn.isRelaxed && distance < Infinity && length * (1 + COARSE) < distance) continue;
      if (field.domain) least = shortestOf(least, { line, measured: length });
      const crossed = crossedBy(sides, line);
      if (
        understood.some((other) => isBeside(line, other.line, sides.scale, crossed !== null && other.crossed === crossed ? ALIKE : APART))
      )
        continue;
      const { most, measured } = mostOf(field, line, length, distance);
      /* Of all, those that follow creases are others than those that do not. */
      for (const shores of isAll ? rounding.shores.map((near) => [near]) : [rounding.shores]) {
        const found = followPinned(question, line, length, (part, along, about) =>
          followBest(part, along, shores, along === line ? most : mostOf(field, along, about, distance).most),
        );
        if (found) routes.push(found.route);
        shortest = leastOf(routes);
        strays ||= isBody && !(found && isBeside(line, lineOf(found.route.legs, width), sides.scale, APART));
        /* What became longer than the polyline is another way; one that never came to rest need not lead to any. */
        if (found && lengthOf(found.route.legs) <= most) understood.push({ line, crossed: found.isClear ? crossed : null });
        else {
          if (drawn.isAtRest) missed.push(drawn);
          if (drawn.isRelaxed) least = shortestOf(least, { line, measured });
        }
      }
    }
    missed = missed.filter(({ line }) => !understood.some((other) => isBeside(line, other.line, sides.scale, APART)));
    const isOpen = measured.some(
      (way) => way.measured <= shortest * UNTOLD && !understood.some((other) => isBeside(way.line, other.line, sides.scale, ALIKE)),
    );
    if (
      !isAll &&
      shortest < Infinity &&
      !isOpen &&
      !strays &&
      shortest <= Math.min((least?.measured ?? Infinity) * EXACT, distance * NEARLY, ...missed.map(({ length }) => length))
    )
      break;
  }
  /* A shorter way that could not be followed leaves it open what is the shortest; where no way at all was found, what lies between the ends is the least there may be. */
  const isUnseen = start === 'global' && field.isPlain && !field.domain && distance === Infinity;
  const seen = missed.map(({ length }) => length * (field.isPlain ? 1 + ROUGHER : 1 - LOOSE));
  const bound = isUnseen
    ? gap(ends[0], ends[1]) * (1 + STRAIGHT)
    : Math.min((least?.measured ?? Infinity) * (1 + ROUGH), distance * (1 + COARSE));
  const most = isUnseen ? bound : Math.min(bound, ...seen);
  routes.sort((one, other) => lengthOf(one.legs) - lengthOf(other.legs));
  const lines = routes.map(({ legs }) => lineOf(legs, width));
  const isNew = (/** @type {number} */ i) => !lines.slice(0, i).some((line) => isBeside(lines[i], line, sides.scale, APART));
  return { routes: routes.filter((_, i) => isNew(i)), least, bound, most };
}

/** How long the shortest is, infinite if there is none. @param {Route[]} routes */
const leastOf = (routes) => Math.min(...routes.map(({ legs }) => lengthOf(legs)));

/** Which creases a polyline crosses, and from which sides. @param {import('../manifold/sides.js').Sides} sides @param {Float64Array} line */
const crossedBy = (sides, line) =>
  cut(sides, line)
    ?.joints.map(({ crease, signs }) => `${crease} ${signs}`)
    .join() ?? null;

/**
 * How long a polyline of about this length is on the surface, infinite where that is not known, and a path that it leads to at most. One that leaps through a body beside a sharp edge tells no
 * length; the way that it was relaxed from does.
 * @param {Field} field @param {Float64Array} line @param {number} length @param {number} distance of the shortest way
 */
function mostOf(field, line, length, distance) {
  const measured = measureLength(field, line, length);
  const known = measured < Infinity ? measured * (1 + ROUGH) : field.isPlain && distance < Infinity ? distance * (1 + ROUGHER) : 0;
  return { measured, most: Math.max(length * (1 + (field.domain ? ROUGH : ROUGHER)), known) };
}

/** @param {Way | null} one @param {Way} other */
const shortestOf = (one, other) => (other.measured < (one?.measured ?? Infinity) ? other : one);

/** A polyline as a path. @param {Field} field @param {number[][]} ends @param {Way} way @param {number} points @returns {Path} */
const roughly = (field, ends, { line, measured }, points) => ({
  ...stalled(drawLine(field, ends, line, points)),
  ...{ length: measured, lengthError: LOOSE * measured },
});

/** The path that a polyline leads to, following creases or not, whichever way first is no longer than this; else the shortest. @param {Question} question @param {Float64Array} line @param {number[]} shores @param {number} most @returns {Route | null} */
function followBest(question, line, shores, most) {
  /** @type {Route | null} */
  let best = null;
  for (const near of shores) {
    const steps = Math.min(question.budget.steps, MOST_FOLLOWING);
    /** @type {import('./legs.js').Budget} */
    const budget = { steps, finest: question.budget.finest };
    const found = follow({ ...question, budget }, line, near, most * (1 + ASTRAY));
    question.budget.steps -= steps - budget.steps;
    question.budget.lost = budget.lost ?? question.budget.lost;
    question.budget.finest = budget.finest;
    if (found) best = shorter(best, found);
    if (best && lengthOf(best.legs) <= most) break;
  }
  return best;
}

/** @param {Route | null} one @param {Route} other */
const shorter = (one, other) => (one && lengthOf(one.legs) <= lengthOf(other.legs) ? one : other);

/** @param {Question} question @param {Route} route @param {SolveOptions} options @returns {Path} */
function write(question, route, options) {
  const { field, sides } = question;
  const { legs, joints } = route;
  const places = placesOf(question, joints);
  const solve = (/** @type {number} */ k, /** @type {SolveOptions} */ asked) => {
    if (legs[k].shore) return writeShore(question, legs[k], asked);
    const { run } = /** @type {import('../manifold/sides.js').Side} */ (sides.on(legs[k].signs));
    return solveAlong({ ...field, run }, [places[k], places[k + 1]], asked, legs[k].line);
  };
  const { path } = joinLegs(/** @type {any} */ (legs), options, solve, field.domain);
  path.lengthError += roundingOf(route);
  for (const { place } of joints) path.touchesBoundary ||= isOnEdge(question, place);
  return path;
}
