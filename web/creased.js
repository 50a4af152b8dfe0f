/**
 * Paths across creases: geodesics on smooth sides of the surface, joined where they cross, and legs along creases between them. Which way they lead polylines tell;
 * what moves are the places at which legs meet. MATH.md, "Across creases".
 */

import { ELEMENTS } from './candidates.js';
import { slopeOf } from './crease.js';
import { distinct } from './distinct.js';
import { follow } from './follow.js';
import { joinLegs, reverse } from './join.js';
import { LEG, lengthOf, placesOf, span } from './legs.js';
import { placed } from './pieces.js';
import { findWays, isAfter, measureLine, poseNear, relax } from './routes.js';
import { writeShore } from './shores.js';
import { gap } from './vector.js';

/** @typedef {import('./path.js').Path} Path */
/** @typedef {import('./routes.js').Field} Field */
/** @typedef {import('./runtime/heap.js').SolveOptions} SolveOptions */
/** @typedef {import('./sides.js').Sides} Sides */
/** @typedef {import('./legs.js').Joint} Joint */
/** @typedef {import('./legs.js').Leg} Leg */
/** @typedef {import('./legs.js').Question} Question */
/** @typedef {import('./legs.js').Route} Route */

/** Steps of Newton for one question, and for following one polyline. */
const [MOST_NEWTON, MOST_FOLLOWING] = [30_000, 10_000];
/** A path is longer than its polyline by no more than this part: in the rectangle, where a polyline is measured, and elsewhere; and shorter by no more than the third. */
const [ROUGH, ROUGHER, LOOSE] = [2e-3, 0.02, 0.04];
/**
 * Creases are rounded within these parts of the length; polylines there have so many inner points, and may be longer by that part: a road that is narrow is dearer there. The first come
 * to rest more often, the second stay in what is narrow. They follow creases that are nearer to them than these parts of their length, tried in turn; 0: they follow none.
 */
const ROUNDINGS = [
  { within: 0.01, points: 63, dearer: 0.15, shores: [0.04, 0.01, 0] },
  { within: 0.0025, points: 255, dearer: 0.04, shores: [0.01, 0.04, 0] },
];
/** A path that is longer than its polyline by this part is none of its own. */
const ASTRAY = 0.1;
/** Polylines that are nowhere farther apart than this part of their length lead the same way. */
const APART = 0.02;
/** A way through the graph, whose edges may pass what is narrow, is shorter than a path by no more than this part. */
const COARSE = 0.25;
/** A path that is longer than the graph's way by no more than this needs no finer look. */
const NEARLY = 1.003;
/** A path is the straight line in space if it is longer by no more than this part. */
const STRAIGHT = 1e-9;

/**
 * The shortest path near a start, or of all that are found, which is `converged` or null; and what no path is shorter than that is: beyond it a shorter way was seen.
 * @param {Field} field @param {number[][]} ends @param {SolveOptions} options @param {import('./pieces.js').Start} start @returns {{ path: Path | null, most: number } | null} null: there are no creases
 */
export function findCreased(field, ends, options, start) {
  const { domain, pieces } = field;
  const isWhole = pieces.length === 0 && !domain?.turn;
  if (!field.sides || !isWhole || options.algorithm !== ELEMENTS || options.record || options.maxIterations < LEG.maxIterations)
    return null;
  const sides = field.sides();
  if (!sides) return null;
  /* As everywhere: exchanged ends give the same path. */
  const isTurned = (start === null || start === 'global') && isAfter(ends[0], ends[1]);
  const { path, most } = findFrom(field, sides, isTurned ? [ends[1], ends[0]] : ends, options, start);
  return { path: path && isTurned ? placed(domain, reverse(path), ends[0]) : path, most };
}

/** @param {Field} field @param {Sides} sides @param {number[][]} ends @param {SolveOptions} options @param {import('./pieces.js').Start} start */
function findFrom(field, sides, ends, options, start) {
  const question = { field, sides, ends, budget: { steps: MOST_NEWTON } };
  const width = ends[0].length;
  /** @type {Route | null} */
  let best = null;
  const { ways, distance } = findWays(field, ends, start);
  /* Polylines in a rectangle are ways, so none is shorter than the shortest path; chords across an implicit surface may be. */
  const rough = field.domain ? ROUGH : ROUGHER;
  const measure = (/** @type {Float64Array} */ line) => (field.domain ? measureLine(field, ends, line) : Number.NaN);
  let least = Math.min(Infinity, ...ways.map(measure).filter((length) => length >= 0));
  /** @type {Float64Array[]} */
  const understood = [];
  /** @type {{ line: Float64Array, length: number }[]} */
  let missed = [];
  /* On folds of the surface alone polylines settle as they are. */
  for (const { within, points, dearer, shores } of field.isPlain ? ROUNDINGS.slice(0, 1) : ROUNDINGS) {
    const smooth = field.isPlain ? field : { ...field, run: round(field, sides, ways, within) };
    const drawn = ways.map((way) => ({ path: relax(smooth, ends, way, points) })).filter(({ path }) => path.length >= 0);
    for (const { path } of distinct(drawn)) {
      const line = path.parameters ?? path.points;
      const measured = measure(line);
      const length = measured >= 0 ? measured : path.length;
      if (best && length * (1 - dearer) > lengthOf(best.legs)) continue;
      if (measured < least) least = measured;
      if (understood.some((other) => isBeside(line, other, width))) continue;
      const found = followBest(question, line, shores, length * (1 + rough));
      if (found) best = shorter(best, found);
      /* What became longer than the polyline is another way. */
      if (found && lengthOf(found.legs) <= length * (1 + rough)) understood.push(line);
      else missed.push({ line, length });
    }
    missed = missed.filter(({ line }) => !understood.some((other) => isBeside(line, other, width)));
    if (best && lengthOf(best.legs) <= Math.min(least, distance * NEARLY, ...missed.map(({ length }) => length))) break;
  }
  const path = best ? write({ ...question, budget: { steps: MOST_NEWTON } }, best, options) : null;
  /* A shorter way that could not be followed leaves it open what is the shortest; where no way at all was found, what lies between the ends is the least there may be. */
  const isUnseen = start === 'global' && field.isPlain && !field.domain && distance === Infinity;
  const most = isUnseen
    ? gap(ends[0], ends[1]) * (1 + STRAIGHT)
    : Math.min(
        least * (1 + ROUGH),
        distance * (1 + COARSE),
        ...missed.map(({ length }) => length * (field.isPlain ? 1 + ROUGHER : 1 - LOOSE)),
      );
  return { path: path?.converged ? path : null, most };
}

/** The path that a polyline leads to, following creases or not, whichever way first is no longer than this; else the shortest. @param {Question} question @param {Float64Array} line @param {number[]} shores @param {number} most @returns {Route | null} */
function followBest(question, line, shores, most) {
  /** @type {Route | null} */
  let best = null;
  for (const near of shores) {
    const steps = Math.min(question.budget.steps, MOST_FOLLOWING);
    const budget = { steps };
    const found = follow({ ...question, budget }, line, near, most * (1 + ASTRAY));
    question.budget.steps -= steps - budget.steps;
    if (found) best = shorter(best, found);
    if (best && lengthOf(best.legs) <= most) break;
  }
  return best;
}

/** Whether no node of a polyline is far from another one. @param {Float64Array} line @param {Float64Array} other @param {number} width */
function isBeside(line, other, width) {
  const near = APART * span(line, width);
  const nodes = Array.from({ length: line.length / width }, (_, i) => line.subarray(width * i, width * (i + 1)));
  return nodes.every((node) => {
    for (let k = 0; k < other.length; k += width) if (node.every((x, j) => Math.abs(x - other[k + j]) <= near)) return true;
    return false;
  });
}

/**
 * The surface with its creases rounded, more widely where ends are far from each other: on it there is a path where jumps let none settle.
 * @param {Field} field @param {Sides} sides @param {ArrayLike<number>[]} lines along which paths may lead @param {number} within this part of their length
 */
function round({ domain, run }, sides, lines, within) {
  const width = domain ? 2 : 3;
  const measured = lines.map((line) => sides.measure(line));
  const reach = within * Math.min(...lines.map((line) => span(line, width)));
  const slope = (/** @type {number[]} */ seen, /** @type {number} */ crease) =>
    Math.sqrt(slopeOf(sides, seen, crease, width).reduce((sum, x) => sum + x * x, 0));
  const widths = Array.from({ length: sides.count }, (_, crease) => {
    const places = measured.flat().sort((a, b) => Math.abs(a[crease]) - Math.abs(b[crease]));
    const steep = places.slice(0, 8).map((seen) => slope(seen, crease));
    return reach * Math.max(...steep);
  });
  return sides.rounded(widths.map((x) => (x > 0 && x < Infinity ? x : reach)))?.run ?? run;
}

/** @param {Route | null} one @param {Route} other */
const shorter = (one, other) => (one && lengthOf(one.legs) <= lengthOf(other.legs) ? one : other);

/** @param {Question} question @param {Route} route @param {SolveOptions} options @returns {Path} */
function write(question, { legs, joints }, options) {
  const { field, sides } = question;
  const places = placesOf(question, joints);
  const solve = (/** @type {number} */ k, /** @type {SolveOptions} */ asked) => {
    if (legs[k].shore) return writeShore(question, legs[k], places[k], places[k + 1], asked);
    const { run } = /** @type {import('./sides.js').Side} */ (sides.on(legs[k].signs));
    const { solve: solveLeg, finish } = poseNear({ ...field, run }, [places[k], places[k + 1]], legs[k].line);
    return finish(solveLeg(asked));
  };
  return joinLegs(/** @type {any} */ (legs), options, solve, field.domain).path;
}
