/**
 * Paths across creases: geodesics on smooth sides of the surface, joined where they cross. Which way they lead polylines tell; what moves are the places at which
 * sides meet. MATH.md, "Creases".
 */

import { ELEMENTS, holds } from './candidates.js';
import { joinLegs, reverse } from './join.js';
import { placed } from './pieces.js';
import { isAfter, poseNear, sketch } from './routes.js';

/** @typedef {import('./path.js').Path} Path */
/** @typedef {import('./routes.js').Field} Field */
/** @typedef {import('./runtime/heap.js').SolveOptions} SolveOptions */
/** @typedef {import('./sides.js').Sides} Sides */
/** @typedef {{ signs: number[], line: Float64Array, length: number }} Leg on which side of each crease, and its polyline as it was solved last */
/** @typedef {{ crease: number, signs: number[], place: number[] }} Joint a place on a crease; signs: of the leg before */
/** @typedef {{ legs: Leg[], joints: Joint[] }} Route one joint less than legs */
/** @typedef {{ field: Field, sides: Sides, ends: number[][], budget: { steps: number } }} Question budget: of Newton, for all that is tried */

/** Each chord of a polyline is looked at in so many parts; there may be so many joints. */
const [PARTS, MOST_JOINTS] = [4, 12];
/** Legs while joints move: so exact, over so many points. */
const LEG = { tolerance: 1e-12, gradientTolerance: 0, algorithm: ELEMENTS, points: 31, maxIterations: 100, record: false };
/** In the end they are looked at in so many points, whether they cross more. */
const SEEN = 255;
/** Differences are taken over this part of the shorter leg; steps are at most this part of it. */
const [DIFFERENCE, FARTHEST] = [1e-4, 0.5];
/** So often joints are moved, so often a step halved, and legs that leave their sides cut anew. */
const [MOST_STEPS, MOST_HALVINGS, MOST_CUTS] = [30, 12, 6];
/** Steps of Newton for one question. */
const MOST_NEWTON = 30_000;
/** A place is on a crease to this part of how large coordinates are; events nearer to each other than this, in parts of a chord's, are one. */
const [ROUNDING, TOGETHER] = [1e-13, 1e-6];
/** Sides are the same surface where derivatives are, to this part of them. */
const SAME = 1e-9;
/** A polyline is longer or shorter than what lies under it by no more than this part. */
const ROUGH = 0.02;
/** And a way through the graph, whose edges may cross a jump, by this. */
const COARSE = 0.12;
/** A step that gains less, in parts of the length, is the last. */
const ENOUGH = 1e-13;

/**
 * The shortest path near a start, or of all that are found; null: no path was found that is one.
 * @param {Field} field @param {number[][]} ends @param {SolveOptions} options @param {import('./pieces.js').Start} start @returns {Path | null}
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
  const path = findFrom(field, sides, isTurned ? [ends[1], ends[0]] : ends, options, start);
  return path && isTurned ? placed(domain, reverse(path), ends[0]) : path;
}

/** @param {Field} field @param {Sides} sides @param {number[][]} ends @param {SolveOptions} options @param {import('./pieces.js').Start} start @returns {Path | null} */
function findFrom(field, sides, ends, options, start) {
  const budget = { steps: MOST_NEWTON };
  /** @type {Path | null} */
  let best = null;
  const { paths, distance } = sketch(field, ends, start);
  let missed = Infinity;
  for (const path of paths) {
    if (best && path.length * (1 - ROUGH) > best.length) continue;
    const found = follow({ field, sides, ends, budget }, path.parameters ?? path.points, options);
    if (found?.converged && !(best && best.length <= found.length)) best = found;
    if (!found?.converged) missed = Math.min(missed, path.length);
  }
  /* A shorter way that could not be followed, along a crease, say, leaves it open what is the shortest. */
  const isOpen = best && Math.min(missed * (1 + ROUGH), distance * (1 + COARSE)) < best.length;
  if (!best || !isOpen) return best;
  const lengthError = Math.max(best.lengthError, best.length - (1 - ROUGH) * Math.min(missed, distance));
  return { ...best, status: 'stalled', converged: false, lengthError };
}

/** The path that a polyline leads to. @param {Question} question @param {Float64Array} line @param {SolveOptions} options @returns {Path | null} */
function follow(question, line, options) {
  const { sides, ends } = question;
  const width = ends[0].length;
  let route = cut(sides, line, width);
  for (let cuts = 0; route && cuts < MOST_CUTS; cuts++) {
    const fitted = fit(question, route);
    if (!fitted) return null;
    const seen = solveAll(question, fitted, { ...LEG, points: SEEN });
    if (!seen) return null;
    if (seen.every((leg) => stays(sides, leg, width))) return write(question, fitted, options);
    route = cut(sides, concatenate(seen, width), width, 1);
  }
  return null;
}

/** All legs, over these joints; null: one does not hold. @param {Question} question @param {Route} route @param {SolveOptions} [options] @returns {Leg[] | null} */
function solveAll(question, { legs, joints }, options = LEG) {
  const places = placesOf(question, joints);
  /** @type {Leg[]} */
  const solved = [];
  for (const [i, leg] of legs.entries()) {
    const one = solveLeg(question, leg, places[i], places[i + 1], options);
    if (!one) return null;
    solved.push(one);
  }
  return solved;
}

/** Where legs begin and end. @param {Question} question @param {Joint[]} joints */
const placesOf = ({ ends }, joints) => [ends[0], ...joints.map(({ place }) => place), ends[1]];

/** A leg between two places. @param {Question} question @param {Leg} leg @param {number[]} from @param {number[]} to @param {SolveOptions} options @returns {Leg | null} */
function solveLeg({ field, sides, budget }, leg, from, to, options) {
  const side = sides.on(leg.signs);
  if (!side || budget.steps < 0 || [...from, ...to].some((x) => !(Math.abs(x) < Infinity))) return null;
  const path = poseNear({ ...field, run: side.run }, [from, to], leg.line).solve(options);
  budget.steps -= 1 + path.iterations;
  return holds({ path }) ? { ...leg, length: path.length, line: path.parameters ?? path.points } : null;
}

/** The lines of all legs. @param {Leg[]} legs @param {number} width */
const concatenate = (legs, width) => Float64Array.from(legs.flatMap(({ line }, i) => Array.from(i ? line.subarray(width) : line)));

/** Places along a polyline: each of its chords in parts. @param {Float64Array} line @param {number} width @param {number} parts */
function divide(line, width, parts) {
  const places = new Float64Array((line.length - width) * parts + width);
  for (let k = 0; k < places.length; k++) {
    const at = Math.floor(k / width) / parts;
    const i = width * Math.floor(at) + (k % width);
    places[k] = line[i] + (at % 1) * ((line[i + width] ?? 0) - line[i]);
  }
  return places;
}

/** Cuts a polyline where it crosses creases at which the surface, or what measures length, bends. @param {Sides} sides @param {Float64Array} line @param {number} width @param {number} [parts] of each chord @returns {Route | null} */
function cut(sides, line, width, parts = PARTS) {
  const places = divide(line, width, parts);
  const last = places.length / width - 1;
  const measured = sides.measure(places);
  const size = Math.max(...line.map(Math.abs));
  const creases = Array.from({ length: sides.count }, (_, k) => k);
  const signAt = (/** @type {number} */ i, /** @type {number} */ k) => {
    const slope = Math.max(...Array.from({ length: width }, (_, j) => Math.abs(measured[i][sides.count * (1 + j) + k])));
    return Math.abs(measured[i][k]) > ROUNDING * size * slope ? Math.sign(measured[i][k]) : 0;
  };
  const signs = creases.map((k) => measured.map((_, i) => signAt(i, k)).find((sign) => sign) ?? 1);
  const now = [...signs];
  /** @type {{ at: number, crease: number }[]} */
  const events = [];
  for (let i = 0; i <= last; i++)
    for (const crease of creases) {
      const sign = signAt(i, crease);
      if (sign && sign === now[crease] && i > 0 && i < last)
        for (const at of dips(measured[i - 1][crease], measured[i][crease], measured[i + 1][crease])) events.push({ at: i + at, crease });
      if (!sign || sign === now[crease]) continue;
      now[crease] = sign;
      const [before, after] = [measured[i - 1][crease], measured[i][crease]];
      events.push({ at: i - 1 + Math.min(Math.max(before / (before - after), 0), 1), crease });
    }
  events.sort((a, b) => a.at - b.at);
  const placeAt = (/** @type {number} */ at) => {
    const i = Math.min(Math.floor(at), last - 1);
    return Array.from({ length: width }, (_, j) => {
      const [a, b] = [places[width * i + j], places[width * (i + 1) + j]];
      return a + (at - i) * (b - a);
    });
  };
  /** @type {Route} */
  const route = { legs: [], joints: [] };
  let leg = { signs: [...signs], line: Array.from(places.subarray(0, width)), at: 0 };
  const goOn = (/** @type {number} */ at) => {
    for (let i = Math.floor(leg.at) + 1; i < at; i++) leg.line.push(...places.subarray(width * i, width * (i + 1)));
    leg.at = at;
  };
  for (let e = 0; e < events.length; e++) {
    const { at, crease } = events[e];
    const before = [...signs];
    signs[crease] *= -1;
    while (e + 1 < events.length && events[e + 1].at - at < TOGETHER) signs[events[++e].crease] *= -1;
    if (at < TOGETHER) leg.signs = [...signs];
    if (at < TOGETHER || at > last - TOGETHER) continue;
    const place = placeAt(at);
    /* Higher derivatives alone may jump: then the sides part beyond it. */
    const beyond = placeAt(0.5 * (at + (events[e + 1]?.at ?? last)));
    const bends = [place, beyond].map((there) => isBent(sides, before, signs, there));
    if (bends.includes(null)) return null;
    if (!bends.includes(true)) continue;
    goOn(at);
    leg.line.push(...place);
    route.legs.push({ signs: leg.signs, line: Float64Array.from(leg.line), length: 0 });
    route.joints.push({ crease, signs: before, place });
    leg = { signs: [...signs], line: [...place], at };
  }
  goOn(last);
  leg.line.push(...places.subarray(-width));
  route.legs.push({ signs: leg.signs, line: Float64Array.from(leg.line), length: 0 });
  return route.joints.length > MOST_JOINTS ? null : route;
}

/** Where the parabola through three numbers of one sign, side by side, has the other: from and to, from the middle one, or nothing. @param {number} before @param {number} here @param {number} after */
function dips(before, here, after) {
  const [bend, slope] = [0.5 * (before - 2 * here + after), 0.5 * (after - before)];
  const squared = slope * slope - 4 * bend * here;
  if (!(before * here > 0 && here * after > 0 && bend * here > 0 && squared > 0 && Math.abs(slope) < 2 * Math.abs(bend))) return [];
  const reach = Math.sqrt(squared);
  const roots = [(-slope - reach) / (2 * bend), (-slope + reach) / (2 * bend)].sort((a, b) => a - b);
  /* Between two places it is seen from the nearer one alone. */
  const middle = -slope / (2 * bend);
  return middle >= -0.5 && middle < 0.5 ? roots : [];
}

/** Whether two sides are different surfaces at a place; null: there are too many. @param {Sides} sides @param {number[]} before @param {number[]} after @param {number[]} place */
function isBent(sides, before, after, place) {
  const [a, b] = [sides.on(before), sides.on(after)];
  if (!a || !b) return null;
  const [[one], [other]] = [a.jets(place), b.jets(place)];
  const size = Math.max(...one.map(Math.abs), ...other.map(Math.abs));
  return one.some((x, i) => Math.abs(x - other[i]) > SAME * size);
}

/** Whether a leg crosses nothing between its ends. @param {Sides} sides @param {Leg} leg @param {number} width */
function stays(sides, { line, signs }, width) {
  const route = cut(sides, line, width, 1);
  const middle = width * Math.floor(line.length / width / 2);
  return route?.legs.length === 1 && isBent(sides, signs, route.legs[0].signs, Array.from(line.subarray(middle, middle + width))) === false;
}

/** Moves a place onto a crease, and on an implicit surface onto this side of it. @param {Sides} sides @param {Joint} joint @param {number[]} place */
function settle(sides, { crease, signs }, place) {
  const width = place.length;
  let at = place;
  for (let round = 0; round < 20; round++) {
    const [measured] = sides.measure(at);
    const gradient = at.map((_, j) => measured[sides.count * (1 + j) + crease]);
    const by = width === 2 ? along([[measured[crease], gradient]]) : along([[measured[crease], gradient], implicit(sides, signs, at)]);
    at = at.map((x, j) => x - by[j]);
    if (Math.max(...by.map(Math.abs)) <= ROUNDING * Math.max(...at.map(Math.abs))) break;
  }
  return at;
}

/** f and ∇f of a side. @param {Sides} sides @param {number[]} signs @param {number[]} at @returns {[number, number[]]} */
function implicit(sides, signs, at) {
  const [[f, x, y, z]] = /** @type {import('./sides.js').Side} */ (sides.on(signs)).jets(at);
  return [f, [x, y, z]];
}

/** The shortest step that takes away one or two values with these gradients. @param {[number, number[]][]} equations */
function along([[g, a], second]) {
  const times = (/** @type {number[]} */ p, /** @type {number[]} */ q) => p.reduce((sum, x, j) => sum + x * q[j], 0);
  if (!second) return a.map((x) => (x * g) / times(a, a));
  const [f, b] = second;
  const [aa, ab, bb] = [times(a, a), times(a, b), times(b, b)];
  const determinant = aa * bb - ab * ab;
  const [s, t] = [(g * bb - f * ab) / determinant, (f * aa - g * ab) / determinant];
  return a.map((x, j) => s * x + t * b[j]);
}

/** Along the crease, a unit vector. @param {Sides} sides @param {Joint} joint */
function direction(sides, { crease, signs, place }) {
  const [measured] = sides.measure(place);
  const g = place.map((_, j) => measured[sides.count * (1 + j) + crease]);
  const [, f] = place.length === 3 ? implicit(sides, signs, place) : [0, []];
  const t = f.length ? [f[1] * g[2] - f[2] * g[1], f[2] * g[0] - f[0] * g[2], f[0] * g[1] - f[1] * g[0]] : [-g[1], g[0]];
  const size = Math.sqrt(t.reduce((sum, x) => sum + x * x, 0));
  return t.map((x) => x / size);
}

/** Moves the joints until the path is shortest; null: that leads nowhere. @param {Question} question @param {Route} route @returns {Route | null} */
function fit(question, route) {
  const joints = route.joints.map((joint) => ({ ...joint, place: settle(question.sides, joint, joint.place) }));
  const legs = solveAll(question, { legs: route.legs, joints });
  let now = legs && { legs, joints };
  for (let step = 0; now && joints.length > 0; step++) {
    if (step === MOST_STEPS) return null;
    const next = improve(question, now);
    if (!next) return null;
    if (next.isLast) return next.isMinimum ? next.route : null;
    now = next.route;
  }
  return now;
}

/** How long all legs are. @param {Leg[]} legs */
const lengthOf = (legs) => legs.reduce((sum, { length }) => sum + length, 0);

/**
 * One step of Newton for the joints; null: none makes the path shorter.
 * @param {Question} question @param {Route} route
 * @returns {{ route: Route, isLast: boolean, isMinimum: boolean } | null} isLast: the step promised next to nothing
 */
function improve(question, { legs, joints }) {
  const { sides, ends } = question;
  const spans = legs.map(({ line }) => span(line, ends[0].length));
  const least = joints.map((_, j) => Math.min(spans[j], spans[j + 1]));
  const directions = joints.map((joint) => direction(sides, joint));
  const moved = (/** @type {number} */ j, /** @type {number} */ by) => {
    const { place } = joints[j];
    const there = place.map((x, i) => x + by * directions[j][i]);
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

/** @param {Question} question @param {number[]} place */
const isInside = ({ field: { domain } }, place) =>
  !domain || place.every((x, j) => domain.periodic[j] || (x >= domain.lower[j] && x <= domain.upper[j]));

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

/** How long a polyline is in its coordinates. @param {Float64Array} line @param {number} width */
function span(line, width) {
  let sum = 0;
  for (let i = width; i < line.length; i += width) {
    let squared = 0;
    for (let j = 0; j < width; j++) squared += (line[i + j] - line[i + j - width]) ** 2;
    sum += Math.sqrt(squared);
  }
  return sum;
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
    const { run } = /** @type {import('./sides.js').Side} */ (sides.on(legs[k].signs));
    const { solve: solveLeg, finish } = poseNear({ ...field, run }, [places[k], places[k + 1]], legs[k].line);
    return finish(solveLeg(asked));
  };
  return joinLegs(/** @type {any} */ (legs), options, solve, field.domain).path;
}
