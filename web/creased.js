/**
 * Paths across creases: geodesics on smooth sides of the surface, joined where they cross, and legs along creases between them. Which way they lead polylines tell;
 * what moves are the places at which legs meet. MATH.md, "Across creases".
 */

import { ELEMENTS } from './candidates.js';
import { slopeOf } from './crease.js';
import { follow } from './follow.js';
import { joinLegs, reverse } from './join.js';
import { LEG, lengthOf, placesOf, span } from './legs.js';
import { placed } from './pieces.js';
import { isAfter, poseNear, sketch } from './routes.js';
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

/** Steps of Newton for one question. */
const MOST_NEWTON = 30_000;
/** A polyline is longer or shorter than what lies under it by no more than this part. */
const ROUGH = 0.02;
/** One on the surface with its creases rounded may be longer by this: a road that is narrow is dearer there. */
const ROUNDER = 0.15;
/** And a way through the graph, whose edges may cross a jump, by this. */
const COARSE = 0.25;
/** A path is the straight line in space if it is longer by no more than this part. */
const STRAIGHT = 1e-9;
/** Polylines follow creases that are nearer to them than these parts of their length, tried in turn; 0: they follow none. */
const SHORES = [0.04, 0.01, 0];
/** Creases are rounded within this part of the length. */
const ROUNDED = 0.01;

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
  /** @type {Route | null} */
  let best = null;
  const { paths, distance } = sketch(field, ends, start, (lines) => round(field, sides, lines));
  let missed = Infinity;
  for (const path of paths) {
    if (best && path.length * (1 - ROUNDER) > lengthOf(best.legs)) continue;
    const line = path.parameters ?? path.points;
    const found = SHORES.reduce((/** @type {Route | null} */ known, near) => known ?? follow(question, line, near), null);
    if (found) best = shorter(best, found);
    /* What became longer than the polyline is another way. */
    if (!found || lengthOf(found.legs) > path.length * (1 + ROUGH)) missed = Math.min(missed, path.length);
  }
  const path = best && write({ ...question, budget: { steps: MOST_NEWTON } }, best, options);
  /* A shorter way that could not be followed, as it is where creases are not rounded, leaves it open what is the shortest; where no way at all was found, what lies between the ends is the least there may be. */
  const isUnseen = start === 'global' && field.isPlain && !field.domain && distance === Infinity;
  const most = isUnseen
    ? gap(ends[0], ends[1]) * (1 + STRAIGHT)
    : Math.min(missed * (field.isPlain ? 1 + ROUGH : 1 - 2 * ROUGH), distance * (1 + COARSE));
  return { path: path?.converged ? path : null, most };
}

/**
 * The surface with its creases rounded, more widely where ends are far from each other: on it there is a path where jumps let none settle.
 * @param {Field} field @param {Sides} sides @param {ArrayLike<number>[]} lines along which paths may lead
 */
function round({ domain, isPlain, run }, sides, lines) {
  /* On folds of the surface alone polylines do settle. */
  if (isPlain) return run;
  const width = domain ? 2 : 3;
  const measured = lines.map((line) => sides.measure(line));
  const reach = ROUNDED * Math.min(...lines.map((line) => span(line, width)));
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
