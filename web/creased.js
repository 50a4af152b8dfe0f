/**
 * Paths across creases: geodesics on smooth sides of the surface, joined where they cross, and legs along creases between them. Which way they lead polylines tell;
 * what moves are the places at which legs meet. MATH.md, "Across creases".
 */

import { ELEMENTS } from './candidates.js';
import { directions, settle } from './crease.js';
import { cut, stays } from './cut.js';
import { joinLegs, reverse } from './join.js';
import { isInside, LEG, lengthOf, placesOf, solveAll, solveLeg, span } from './legs.js';
import { placed } from './pieces.js';
import { isAfter, poseNear, sketch } from './routes.js';
import { graze, land, survey, writeShore } from './shores.js';
import { gap } from './vector.js';

/** @typedef {import('./path.js').Path} Path */
/** @typedef {import('./routes.js').Field} Field */
/** @typedef {import('./runtime/heap.js').SolveOptions} SolveOptions */
/** @typedef {import('./sides.js').Sides} Sides */
/** @typedef {import('./legs.js').Joint} Joint */
/** @typedef {import('./legs.js').Leg} Leg */
/** @typedef {import('./legs.js').Question} Question */
/** @typedef {import('./legs.js').Route} Route */

/** In the end legs are looked at in so many points, whether they cross more. */
const SEEN = 255;
/** Differences are taken over this part of the shorter leg; steps are at most this part of it. */
const [DIFFERENCE, FARTHEST] = [1e-4, 0.5];
/** So often joints are moved, so often a step halved, and legs that leave their sides cut anew. */
const [MOST_STEPS, MOST_HALVINGS, MOST_CUTS] = [30, 12, 6];
/** Steps of Newton for one question. */
const MOST_NEWTON = 30_000;
/** A polyline is longer or shorter than what lies under it by no more than this part. */
const ROUGH = 0.02;
/** And a way through the graph, whose edges may cross a jump, by this. */
const COARSE = 0.12;
/** A step that gains less, in parts of the length, is the last. */
const ENOUGH = 1e-13;
/** The surface is torn where its sides are farther apart than this part of how large coordinates are. */
const TORN = 1e-9;
/** A path is the straight line in space if it is longer by no more than this part. */
const STRAIGHT = 1e-9;
/** A shore is no longer than this many times what was guessed. */
const LONGER = 2;
/** Polylines follow creases that are nearer to them than these parts of their length, tried in turn; 0: they follow none. */
const SHORES = [0.01, 0.04, 0];
/** Legs that meet a shore are at rest where the sine of their angle is off by so little; differences of it are taken over this part of the shorter leg. */
const [GRAZING, BALANCE] = [1e-7, 1e-3];

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
  const { paths, distance } = sketch(field, ends, start);
  let missed = Infinity;
  for (const path of paths) {
    if (best && path.length * (1 - ROUGH) > lengthOf(best.legs)) continue;
    const line = path.parameters ?? path.points;
    const found = SHORES.reduce((/** @type {Route | null} */ known, near) => known ?? follow(question, line, near), null);
    if (found) best = shorter(best, found);
    else missed = Math.min(missed, path.length);
  }
  const path = best && write({ ...question, budget: { steps: MOST_NEWTON } }, best, options);
  /* A shorter way that could not be followed leaves it open what is the shortest; where no way at all was found, what lies between the ends is the least there may be. */
  const isUnseen = start === 'global' && field.isPlain && !field.domain && distance === Infinity;
  const most = isUnseen ? gap(ends[0], ends[1]) * (1 + STRAIGHT) : Math.min(missed * (1 + ROUGH), distance * (1 + COARSE));
  return { path: path?.converged ? path : null, most };
}

/** @param {Route | null} one @param {Route} other */
const shorter = (one, other) => (one && lengthOf(one.legs) <= lengthOf(other.legs) ? one : other);

/** The path that a polyline leads to; null: none that holds. @param {Question} question @param {Float64Array} line @param {number} near it follows creases that are nearer than this part of its length @returns {Route | null} */
function follow(question, line, near) {
  const { sides, ends } = question;
  const width = ends[0].length;
  let route = cut(sides, line, width, { near });
  if (near && !route?.legs.some(({ shore }) => shore)) return null;
  for (let cuts = 0; route && cuts < MOST_CUTS; cuts++) {
    const fitted = fit(question, route);
    if (!fitted) return null;
    const seen = solveAll(question, fitted, { ...LEG, points: SEEN });
    if (!seen) return null;
    if (seen.every((leg) => leg.shore || stays(sides, leg, width))) return fitted;
    route = cut(sides, concatenate(seen, width), width, { parts: 1, near });
  }
  return null;
}

/** The lines of all legs. @param {Leg[]} legs @param {number} width */
const concatenate = (legs, width) => Float64Array.from(legs.flatMap(({ line }, i) => Array.from(i ? line.subarray(width) : line)));

/** Moves the joints until the path is shortest; null: that leads nowhere. @param {Question} question @param {Route} route @returns {Route | null} */
function fit(question, route) {
  const joints = route.joints.map((joint) => ({ ...joint, place: settle(question.sides, joint, joint.place) }));
  if (joints.some((joint, j) => isTorn(question, joint, route.legs[j + 1]))) return null;
  const legs = solveAll(question, { legs: route.legs, joints });
  let now = legs && { legs, joints };
  if (now?.legs.some(({ shore }) => shore)) return balance(question, now);
  for (let step = 0; now && joints.length > 0; step++) {
    if (step === MOST_STEPS) return null;
    const next = improve(question, now);
    if (!next) return null;
    if (next.isLast) return next.isMinimum ? next.route : null;
    now = next.route;
  }
  return now;
}

/** Whether the sides of a crease are in different places in space: what leads over a step is no path. @param {Question} question @param {Joint} joint @param {Leg} next */
function isTorn({ field, sides }, { crease, signs, place }, next) {
  /* E, F and G, and a density, may jump. */
  if (!field.positions) return false;
  const beyond = next.shore ? signs.map((sign, k) => (k === crease ? -sign : sign)) : next.signs;
  const [[one], [other]] = [sides.on(signs)?.jets(place) ?? [[]], sides.on(beyond)?.jets(place) ?? [[]]];
  const size = Math.max(...place.map(Math.abs), ...one.slice(0, 3).map(Math.abs));
  return one.slice(0, 3).some((x, i) => Math.abs(x - other[i]) > TORN * size);
}

/** How long the free legs beside a joint are in their coordinates, the shorter one. @param {Route} route @param {number} width */
function leastBeside({ legs, joints }, width) {
  const spans = legs.map(({ line, shore }) => (shore ? Infinity : span(line, width)));
  return joints.map((_, j) => Math.min(spans[j], spans[j + 1]));
}

/**
 * Moves the joints of a path that follows creases until each leg is met as it should be.
 * @param {Question} question @param {Route} route @returns {Route | null} null: that leads nowhere
 */
function balance(question, route) {
  const { sides, ends } = question;
  const width = ends[0].length;
  const landed = route.legs.map((leg) => {
    if (!leg.shore) return leg;
    const middle = Array.from(leg.line.subarray(width * Math.floor(leg.line.length / width / 2)).subarray(0, width));
    const place = settle(sides, { crease: leg.shore.crease, signs: leg.signs }, middle);
    return land(question, leg, leg.shore, place, DIFFERENCE * span(leg.line, width));
  });
  if (landed.includes(null)) return null;
  let now = { legs: /** @type {Leg[]} */ (landed), joints: route.joints };
  let off = offs(question, now);
  for (let step = 0; off; step++) {
    const size = largest(off);
    if (size <= GRAZING) break;
    if (step === MOST_STEPS) return null;
    const next = rebalance(question, now, off);
    if (!next) return null;
    [now, off] = [next.route, next.off];
  }
  if (!off || !isShortest(question, now, off)) return null;
  const places = placesOf(question, now.joints);
  const legs = now.legs.map((leg, i) => {
    const surveyed = leg.shore && survey(question, leg, places[i], places[i + 1]);
    /* Joints that have passed each other are joined the long way round. */
    const isWay = surveyed && span(surveyed.places.flat(), width) <= LONGER * span(leg.line, width);
    return isWay ? { ...leg, length: surveyed.length, line: Float64Array.from(surveyed.places.flat()) } : leg;
  });
  return legs.some(({ shore, length }) => shore && !(length > 0)) ? null : { ...now, legs };
}

/** @param {number[]} numbers */
const largest = (numbers) => Math.max(...numbers.map(Math.abs));

/**
 * One step of Newton towards joints where nothing is off. null: none leads nearer.
 * @param {Question} question @param {Route} route @param {number[]} off
 */
function rebalance(question, { legs, joints }, off) {
  const least = leastBeside({ legs, joints }, question.ends[0].length);
  const moved = (/** @type {number[]} */ by) => shift(question, { legs, joints }, by);
  const differ = (/** @type {number} */ j, /** @type {number} */ by) =>
    moved(joints.map((_, k) => (k === j ? by : 0)))?.off.map((x, k) => (x - off[k]) / by);
  /* At an edge of the rectangle there may be nothing on one side. */
  const columns = joints.map((_, j) => differ(j, BALANCE * least[j]) ?? differ(j, -BALANCE * least[j]));
  const matrix = joints.map((_, i) => columns.map((column) => column?.[i] ?? Number.NaN));
  const step = solveLinear(
    matrix,
    off.map((x) => -x),
  );
  if (!step?.every(Number.isFinite)) return null;
  let factor = Math.min(1, ...step.map((x, j) => (FARTHEST * least[j]) / Math.abs(x)));
  for (let halving = 0; halving < MOST_HALVINGS; halving++, factor /= 2) {
    const tried = moved(step.map((x) => factor * x));
    if (tried && largest(tried.off) < largest(off)) return tried;
  }
  return null;
}

/** Joints moved along their creases, by so much each, and what is off there; null: legs do not hold. @param {Question} question @param {Route} route @param {number[]} by */
function shift(question, { legs, joints }, by) {
  const there = joints.map((joint, j) => {
    const { along } = directions(question.sides, joint, joint.place);
    const place = joint.place.map((x, i) => x + by[j] * along[i]);
    return by[j] ? { ...joint, place: settle(question.sides, joint, place) } : joint;
  });
  const isGood = there.every(({ place }) => isInside(question, place));
  const solved = isGood && solveAll(question, { legs, joints: there });
  const route = solved ? { legs: solved, joints: there } : null;
  const off = route && offs(question, route);
  return route && off && { route, off };
}

/** Whether joints farther along their shores are met at smaller angles: else the path is longest there. @param {Question} question @param {Route} route @param {number[]} off */
function isShortest(question, route, off) {
  const { legs, joints } = route;
  const least = leastBeside(route, question.ends[0].length);
  return joints.every((_, j) => {
    const into = legs[j + 1].shore?.sense ?? -(legs[j].shore?.sense ?? 0);
    const there = shift(
      question,
      route,
      joints.map((_, k) => (k === j ? into * BALANCE * least[j] : 0)),
    );
    return there && there.off[j] >= off[j] - GRAZING;
  });
}

/** How far from right the legs meet at each joint, as sines. null: that is not known. @param {Question} question @param {Route} route @returns {number[] | null} */
function offs(question, { legs, joints }) {
  const places = placesOf(question, joints);
  const least = leastBeside({ legs, joints }, question.ends[0].length);
  const off = joints.map((_, j) => {
    const step = DIFFERENCE * least[j];
    const [before, after] = [legs[j], legs[j + 1]];
    if (before.shore) return graze(question, after, [places[j + 1], places[j + 2]], 0, before, step);
    if (after.shore) return graze(question, before, [places[j], places[j + 1]], 1, after, step);
    return Number.NaN;
  });
  return off.every(Number.isFinite) ? off : null;
}

/** Solves linear equations by elimination, with pivots; null: they have no one solution. @param {number[][]} matrix @param {number[]} right */
function solveLinear(matrix, right) {
  const rows = matrix.map((row, i) => [...row, right[i]]);
  for (let i = 0; i < rows.length; i++) {
    let pivot = i;
    for (let k = i + 1; k < rows.length; k++) if (Math.abs(rows[k][i]) > Math.abs(rows[pivot][i])) pivot = k;
    [rows[i], rows[pivot]] = [rows[pivot], rows[i]];
    if (!rows[i][i]) return null;
    for (let k = 0; k < rows.length; k++) {
      if (k === i) continue;
      const factor = rows[k][i] / rows[i][i];
      for (let j = i; j <= rows.length; j++) rows[k][j] -= factor * rows[i][j];
    }
  }
  return rows.map((row, i) => row[rows.length] / row[i]);
}

/**
 * One step of Newton for the joints; null: none makes the path shorter.
 * @param {Question} question @param {Route} route
 * @returns {{ route: Route, isLast: boolean, isMinimum: boolean } | null} isLast: the step promised next to nothing
 */
function improve(question, { legs, joints }) {
  const { sides, ends } = question;
  const spans = legs.map(({ line }) => span(line, ends[0].length));
  const least = joints.map((_, j) => Math.min(spans[j], spans[j + 1]));
  const ways = joints.map((joint) => directions(sides, joint, joint.place).along);
  const moved = (/** @type {number} */ j, /** @type {number} */ by) => {
    const { place } = joints[j];
    const there = place.map((x, i) => x + by * ways[j][i]);
    return settle(sides, joints[j], there);
  };
  const { slope, matrix } = differentiate(question, { legs, joints }, least, moved);
  const down = descend(matrix, slope);
  if (!down) return null;
  const gain = -0.5 * down.step.reduce((sum, x, j) => sum + x * slope[j], 0);
  const before = lengthOf(legs);
  let factor = Math.min(1, ...down.step.map((x, j) => (FARTHEST * least[j]) / Math.abs(x)));
  for (let halving = 0; halving < MOST_HALVINGS; halving++, factor /= 2) {
    const tried = joints.map((joint, j) => ({ ...joint, place: moved(j, factor * down.step[j]) }));
    const solved = tried.every(({ place }) => isInside(question, place)) ? solveAll(question, { legs, joints: tried }) : null;
    if (solved && lengthOf(solved) <= before * (1 + ENOUGH))
      return { route: { legs: solved, joints: tried }, isLast: gain <= ENOUGH * before, isMinimum: !down.shifted };
  }
  return null;
}

/**
 * First and second derivatives of the length by where the joints lie on their creases: by differences, of each leg by its own ends.
 * @param {Question} question @param {Route} route @param {number[]} least how long the shorter leg beside each joint is @param {(j: number, by: number) => number[]} moved a joint's place, moved
 */
function differentiate(question, { legs, joints }, least, moved) {
  const count = joints.length;
  const places = placesOf(question, joints);
  /** @type {number[]} */
  const slope = new Array(count).fill(0);
  const matrix = slope.map(() => /** @type {number[]} */ (new Array(count).fill(0)));
  const steps = least.map((length) => DIFFERENCE * length);
  for (const [i, leg] of legs.entries()) {
    const placeOf = (/** @type {number} */ j, /** @type {number} */ by) => (by ? moved(j, by * steps[j]) : places[j + 1]);
    const lengthAt = (/** @type {number} */ from, /** @type {number} */ to) =>
      solveLeg(question, leg, placeOf(i - 1, from), placeOf(i, to), LEG)?.length ?? Number.NaN;
    const add = (/** @type {number} */ j, /** @type {number} */ on, /** @type {number} */ back) => {
      slope[j] += (on - back) / (2 * steps[j]);
      matrix[j][j] += (on - 2 * leg.length + back) / steps[j] ** 2;
    };
    const from = i > 0 ? lengthAt(1, 0) : 0;
    const to = i < count ? lengthAt(0, 1) : 0;
    if (i > 0) add(i - 1, from, lengthAt(-1, 0));
    if (i < count) add(i, to, lengthAt(0, -1));
    if (i > 0 && i < count) matrix[i - 1][i] = matrix[i][i - 1] = (lengthAt(1, 1) - from - to + leg.length) / (steps[i - 1] * steps[i]);
  }
  return { slope, matrix };
}

/** Newton's step downhill, by Cholesky's factors of the matrix, shifted until it is positive definite; null: it is none, or not finite. @param {number[][]} matrix @param {number[]} slope */
function descend(matrix, slope) {
  const size = Math.max(...matrix.flat().map(Math.abs));
  if (!(size > 0 && size < Infinity)) return null;
  for (let shift = 0; shift <= 4 * size; shift = shift ? 4 * shift : 1e-3 * size) {
    const factor = matrix.map((row) => row.map(() => 0));
    const isPositive = matrix.every((row, i) => {
      for (let j = 0; j <= i; j++) {
        let sum = row[j] + (i === j ? shift : 0);
        for (let k = 0; k < j; k++) sum -= factor[i][k] * factor[j][k];
        if (i === j && !(sum > 1e-9 * size)) return false;
        factor[i][j] = i === j ? Math.sqrt(sum) : sum / factor[j][j];
      }
      return true;
    });
    if (!isPositive) continue;
    const step = slope.map((x) => -x);
    for (let i = 0; i < step.length; i++) {
      for (let k = 0; k < i; k++) step[i] -= factor[i][k] * step[k];
      step[i] /= factor[i][i];
    }
    for (let i = step.length - 1; i >= 0; i--) {
      for (let k = i + 1; k < step.length; k++) step[i] -= factor[k][i] * step[k];
      step[i] /= factor[i][i];
    }
    return { step, shifted: shift > 0 };
  }
  return null;
}

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
