/** Legs of a path across creases: each on one side of them all, between two places. */

import { holdsPoint } from '../manifold/domain.js';
import { ELEMENTS, holds } from '../search/candidates.js';
import { concatenate } from '../search/join.js';
import { poseNear } from '../search/routes.js';
import { largest, listOf, product, sumOf } from '../vector.js';
import { ROUNDED } from './crease.js';
import { scaled } from './linear.js';

/** @typedef {import('../search/routes.js').Field} Field */
/** @typedef {import('../runtime/heap.js').SolveOptions} SolveOptions */
/** @typedef {import('../manifold/sides.js').Sides} Sides */
/**
 * @typedef {object} Leg
 * @property {number[]} signs on which side of each crease
 * @property {Float64Array} line its polyline as it was solved last
 * @property {number} length
 * @property {import('./shores.js').Shore | null} shore the crease that it follows, if it does
 * @property {number[][]} [pulls] how its length changes with where it begins, and ends
 * @property {number} [error] of the length, once a shore was surveyed
 */
/** @typedef {Pick<Leg, 'pulls'>} Pulled */
/** @typedef {{ crease: number, signs: number[], place: number[], moved?: number, isCorner?: boolean }} Joint a place on a crease; signs: those that hold there, on the side before it; moved: so far along it, since legs were joined; isCorner: of the crease, where it stays */
/** @typedef {{ legs: Leg[], joints: Joint[] }} Route one joint less than legs */
/** @typedef {{ steps: number, lost?: Float64Array | null, finest?: number }} Budget of Newton, for all that is tried; lost: the polyline of the last route that came to rest where it does not hold; finest: no leg is more exact */
/** @typedef {{ field: Field, sides: Sides, ends: number[][], budget: Budget }} Question */

/** Legs while joints move: so exact, over so many points. */
export const LEG = { tolerance: 1e-12, gradientTolerance: 0, algorithm: ELEMENTS, points: 31, maxIterations: 100, record: false };

/** So many moves of a node count as a step, and as many where length is not that of space: they are most of what legs take that do not hold, of the most elements. */
const [MOVES, METRIC_MOVES] = [500, 50];
/** After a leg of more moves, as up a slope that is infinite where it ends, others are not more exact than this: each digit takes several times as many elements. */
const [DEAR, ROUGH] = [3e4, 1e-9];

/** All legs, over these joints, but those that follow a crease; null: one does not hold. @param {Question} question @param {Route} route @param {SolveOptions} [options] @returns {Leg[] | null} */
export function solveAll(question, { legs, joints }, options = LEG) {
  const places = placesOf(question, joints);
  /** @type {Leg[]} */
  const solved = [];
  for (const [i, leg] of legs.entries()) {
    const one = leg.shore ? leg : solveLeg(question, leg, places[i], places[i + 1], options);
    if (!one) return null;
    solved.push(one);
  }
  return solved;
}

/** Where legs begin and end. @param {{ ends: number[][] }} question @param {{ place: number[] }[]} joints */
export const placesOf = ({ ends }, joints) => [ends[0], ...joints.map(({ place }) => place), ends[1]];

/** A leg between two places. @param {Question} question @param {Leg} leg @param {number[]} from @param {number[]} to @param {SolveOptions} options @returns {Leg | null} */
export function solveLeg({ field, sides, budget }, leg, from, to, options) {
  const side = sides.on(leg.signs);
  if (!side || budget.steps < 0 || ![...from, ...to].every(Number.isFinite)) return null;
  const asked = { ...options, tolerance: Math.max(options.tolerance, budget.finest ?? 0) };
  const { path, pulls, work } = solvePulled({ ...field, run: side.run }, [from, to], leg.line, asked);
  budget.steps -= 1 + path.iterations + work / (field.isPlain ? MOVES : METRIC_MOVES);
  if (work > DEAR) budget.finest = ROUGH;
  return holds({ path }) ? { ...leg, length: path.length, line: path.parameters ?? path.points, pulls } : null;
}

/** The path near a line, and how its length changes with where it begins, and ends; work: how often a node was moved. @param {Field} field @param {number[][]} ends @param {Float64Array} line @param {SolveOptions} options */
export function solvePulled(field, ends, line, options) {
  /** @type {number[][]} */
  let pulls = [];
  let work = 0;
  const path = poseNear(field, ends, line).solve(options, (heap) => {
    pulls = heap.pulls();
    work = heap.work;
  });
  return { path, pulls, work };
}

/** How the length of a leg changes as one of its ends, 0 or 1, moves in a direction: by the first variation. @param {Pulled} leg @param {number} end @param {number[]} way */
export const slopeAlong = ({ pulls }, end, way) => product(way, pulls?.[end] ?? []);

/** What rounding of joints makes of the length, as where the surface stands upright on a crease; where that is known by no derivatives, at a corner of two, nothing. @param {Route} route */
export const roundingOf = ({ legs, joints }) =>
  sumOf(
    joints.map(({ place }, j) => {
      const pulls = legs.slice(j, j + 2).flatMap(({ pulls }, k) => pulls?.[1 - k] ?? []);
      return 4 * ROUNDED * largest(place) * largest(pulls.filter(Number.isFinite));
    }),
  );

/**
 * How the length of all legs changes with the joints between them: first derivatives, and second ones by differences; NaN where a leg does not hold. A leg's length depends on the two joints beside it.
 * @param {Pulled[]} legs @param {number[][]} places where they begin and end @param {number[][]} ways in which joints move @param {number[]} steps of differences
 * @param {(j: number, by: number) => { place: number[], along: number[] } | null} moved where a joint is that has moved, and in which way it does there @param {(i: number, from: number[], to: number[]) => Pulled | null} solve a leg between other places
 */
export function changes(legs, places, ways, steps, moved, solve) {
  const slopes = ways.map(() => 0);
  const matrix = ways.map(() => ways.map(() => 0));
  const there = steps.map((step, j) => moved(j, step) ?? { place: null, along: [Number.NaN] });
  for (const [i, leg] of legs.entries()) {
    const beside = [i - 1, i].filter((j) => j in steps);
    const slopeAt = (/** @type {Pulled} */ of, /** @type {number} */ j, way = ways[j]) => slopeAlong(of, Number(j === i), way);
    for (const j of beside) {
      slopes[j] += slopeAt(leg, j);
      const { place, along } = there[j];
      /* Which way a curve leads may be told by another of its coordinates there. */
      const way = scaled(along, Math.sign(product(along, ways[j])));
      const other = (place && solve(i, j < i ? place : places[i], j < i ? places[i + 1] : place)) ?? {};
      for (const k of beside) matrix[k][j] += (slopeAt(other, k, k === j ? way : ways[k]) - slopeAt(leg, k)) / steps[j];
    }
  }
  return { slopes, matrix };
}

/** The polyline of all legs. @param {Leg[]} legs @param {number} width */
export const lineOf = (legs, width) =>
  concatenate(
    legs.map(({ line }) => line),
    width,
  );

/** The nodes of a polyline. @param {ArrayLike<number>} line @param {number} width */
export const nodesOf = (line, width) => Array.from({ length: line.length / width }, (_, i) => listOf(line, width * i, width * (i + 1)));

/** The node in the middle of a polyline. @param {ArrayLike<number>} line @param {number} width */
export function middleOf(line, width) {
  const first = width * Math.floor(line.length / width / 2);
  return listOf(line, first, first + width);
}

/** How long all legs are. @param {{ length: number }[]} legs */
export const lengthOf = (legs) => sumOf(legs.map(({ length }) => length));

/** How long a polyline is in its coordinates, which count by a scale, one for each. @param {ArrayLike<number>} line @param {readonly number[]} scale */
export function span(line, scale) {
  const width = scale.length;
  let sum = 0;
  for (let i = width; i < line.length; i += width) {
    let squared = 0;
    for (let j = 0; j < width; j++) squared += (scale[j] * (line[i + j] - line[i + j - width])) ** 2;
    sum += Math.sqrt(squared);
  }
  return sum;
}

/** How long the free legs beside each joint are in their coordinates, the shorter one. @param {Route} route @param {readonly number[]} scale */
export function leastBeside({ legs, joints }, scale) {
  const spans = legs.map(({ line, shore }) => (shore ? Infinity : span(line, scale)));
  return joints.map((_, j) => Math.min(spans[j], spans[j + 1]));
}

/** Whether a place is in the rectangle. @param {Question} question @param {number[]} place */
export const isInside = ({ field: { domain } }, place) => !domain || holdsPoint(domain, place);

/** Whether a place is on an edge of the rectangle. @param {Question} question @param {number[]} place */
export const isOnEdge = ({ field: { domain } }, place) =>
  !!domain && place.some((x, j) => !domain.periodic[j] && (x === domain.lower[j] || x === domain.upper[j]));
