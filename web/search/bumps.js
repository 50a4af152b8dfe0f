/**
 * Paths on other sides of bumps. Across waves many lead side by side, as long to a thousandth: a graph's lengths are wrong by more, and it tells few of them apart. So the shortest rough
 * path is pushed aside at one place after the other, and wound once more around a tube there, and compared with what it comes to rest at.
 */

import { confine } from '../manifold/domain.js';
import { cross, dot, gap, minus, norm, unit } from '../vector.js';
import { holds, leaps } from './candidates.js';
import { byEstimate, distinct, estimate } from './distinct.js';
import { innerOf } from './join.js';
import { asItIs, finer, MOST_ROUGH, roughlyIn, solveIn } from './rough.js';

/** @typedef {import('./candidates.js').Found} Found */
/** @typedef {import('./candidates.js').Problem} Problem */
/** @typedef {import('./candidates.js').RawPath} RawPath */
/** @typedef {{ to: number[], numbers: Float64Array, width: number, places: number[][], along: number[], halfWave: number }} Line nodes of a rough path as the solver takes them, so many numbers each, and in space; where its end is lifted to; how long it is up to each; and half a wave */
/** @typedef {{ far: number, turn: number[] }} Push to the side, and by how much all that follows is moved: by a turn of the rectangle, or nothing */
/** @typedef {{ gain: number, to: number[], numbers: Float64Array }} Pushed the line that results, and by how much it is shorter */

/** A path bends to one side and the other so often, at least; bends count that are so large, in parts of the largest, and in radians. */
const [LEAST_BENDS, LARGE, LEAST_BEND] = [3, 0.1, 0.01];
/** Of half a wave: how far apart are the places at which it is pushed; how far it is pushed there, what is moved, to either side, and solved; how far apart are paths on two sides of a bump; and how wide around is what it is wound around, at most. */
const [STEP, FAR, MOVED, SOLVED, APART, WIDEST] = [0.7, 1.5, 1.7, 6, 0.2, 3];
/** What is pushed comes to rest within so many steps, mostly. */
const STEPS = 40;
/** What is longer by this part of the path may turn out to be shorter, and what is as long to this part is the same: so many, the shortest first, are solved whole. */
const [LONGER, SAME, MOST_SOLVED] = [2e-4, 1e-9, 4];
/** Rough paths that are longer than the shortest by up to this part of it are compared, with nodes enough for an error of this part of them. */
const [COMPARED, COARSE] = [5e-3, 1e-3];
/** Of what was not pushed yet the shortest is, if longer by no more than this part, until so many in a row lead to none that is shorter than all; and so many at most. */
const [NEAR, IN_VAIN, MOST_ROUNDS] = [5e-5, 3, 7];
/** Of equally many nodes, a path is shorter for sure if by this part of its error; of those that are not, so many get more nodes, if half a wave has fewer than so many. */
const [UNSURE, MOST_UNSURE, FEW] = [0.01, 2, 7];

/**
 * The rough paths, and those beside the shortest of them; the shortest first.
 * @param {Problem} problem @param {Found[]} rough @returns {Found[]}
 */
export function passBumps(problem, rough) {
  if (rough.length === 0 || problem.branches.length > 0 || !lineOf(rough[0])) return rough;
  const most = (1 + COMPARED) * estimate(rough[0].path);
  let found = distinct(rough.map((one) => (estimate(one.path) < most ? sharpened(problem, one) : one)));
  /* Few nodes are too short. */
  for (let first = sharpened(problem, found[0]); first !== found[0]; first = sharpened(problem, found[0]))
    found = distinct([first, ...found.slice(1)]);
  return ranked(problem, besides(problem, found[0]), found);
}

/** A rough path with nodes enough to be compared. @param {Problem} problem @param {Found} found @returns {Found} */
function sharpened(problem, found) {
  const { path } = found;
  if (!(path.lengthError > COARSE * path.length)) return found;
  for (let points = 2 * innerOf(path) + 1; points <= MOST_ROUGH; points = 2 * points + 1) {
    const next = solveIn(problem, found, points);
    if (holds(next) && !leaps(problem, next.path)) return sharpened(problem, next);
  }
  return found;
}

/** A path and those that pushing it, and the shortest of these, leads to, of as many nodes; the shortest first. @param {Problem} problem @param {Found} first */
function besides(problem, first) {
  const found = [first];
  /** @type {Set<Found>} */
  const done = new Set();
  for (let inVain = 0; inVain < IN_VAIN && done.size < MOST_ROUNDS; inVain++) {
    const [best] = found;
    const next = found.find((one) => !done.has(one));
    if (!next || estimate(next.path) > (1 + NEAR) * estimate(best.path)) break;
    done.add(next);
    for (const { to, numbers } of pushed(problem, next)) {
      const one = { to, path: problem.solve(to, numbers, roughlyIn(innerOf(first.path))) };
      const length = estimate(one.path);
      const isNew = holds(one) && !leaps(problem, one.path) && !found.some(({ path }) => Math.abs(estimate(path) - length) < SAME * length);
      if (isNew) found.push(one);
    }
    found.sort(byEstimate);
    if (found[0] !== best) inVain = -1;
  }
  return found;
}

/**
 * Rough paths in the order in which they are to be solved finely. The shortest get many nodes, else elements may leave them for others.
 * @param {Problem} problem @param {Found[]} found of as many nodes, the shortest first @param {Found[]} known those known before
 * @returns {Found[]}
 */
function ranked(problem, found, known) {
  const [{ path }] = found;
  const unsure = UNSURE * path.lengthError;
  const nearest = found.filter((one) => estimate(one.path) <= estimate(path) + unsure).slice(0, MOST_UNSURE);
  const doubtful = (/** @type {Found} */ one, /** @type {number} */ doubt) => (problem.isPlain ? { ...one, doubt } : one);
  const inHalfWave = (innerOf(path) * (lineOf(found[0])?.halfWave ?? 0)) / path.length;
  const isCoarse = innerOf(path) < MOST_ROUGH && inHalfWave < FEW;
  const sharp = nearest.map((one) => doubtful((isCoarse && finer(problem, one)) || one, unsure));
  sharp.sort(byEstimate);
  /* Of fewer nodes the others look shorter, or longer, by as much as these did. */
  const off = estimate(sharp[0].path) - estimate(path);
  const others = [...found, ...known].filter((one) => !nearest.includes(one));
  const rest = others.map((one) => (innerOf(one.path) < innerOf(path) ? one : doubtful(one, unsure - off)));
  return [...sharp, ...distinct(rest)];
}

/** Lines beside a path that lead along others, maybe shorter ones, the shortest first. @param {Problem} problem @param {Found} found */
function pushed(problem, found) {
  const line = lineOf(found);
  /** @type {Pushed[]} */
  const lines = [];
  if (!line) return lines;
  const { along, halfWave } = line;
  const [length] = along.slice(-1);
  for (let middle = STEP * halfWave; middle < length; middle += STEP * halfWave) {
    const girths = [0, 1].map((k) => girthAt(problem, line, middle, k));
    const push = pushAt(problem, line, middle, Math.min(...girths));
    for (const one of pushesOf(problem, line, girths).map(push)) {
      const isNew = !lines.some(({ gain }) => Math.abs(gain - one.gain) < SAME * length);
      if (isNew && one.gain > -LONGER * length) lines.push(one);
    }
  }
  return lines.sort((a, b) => b.gain - a.gain).slice(0, MOST_SOLVED);
}

/** To either side and, where the surface is thin, once more around it. @param {Problem} problem @param {Line} line @param {number[]} girths @returns {Push[]} */
function pushesOf({ domain }, { to, halfWave }, girths) {
  const far = Math.min(FAR * halfWave, ...girths);
  const around = [0, 1].filter((k) => girths[k] < WIDEST * halfWave);
  const turns = around.map((k) => to.map((_, j) => (domain && j === k ? domain.upper[k] - domain.lower[k] : 0)));
  const none = to.map(() => 0);
  const aside = [-far, far].map((one) => ({ far: one, turn: none }));
  return [...aside, ...turns.flatMap((turn) => [turn.map((x) => -x), turn]).map((turn) => ({ far: 0, turn }))];
}

/** How long it is around the surface along a coordinate, at a place of a line. @param {Problem} problem @param {Line} line @param {number} middle @param {number} k */
function girthAt({ domain, between }, { numbers, along }, middle, k) {
  if (!domain?.periodic[k]) return Infinity;
  const place = numbers.subarray(2 * nearestTo(along, middle)).slice(0, 2);
  const around = Float64Array.of(...place, ...place);
  around[2 + k] += domain.upper[k] - domain.lower[k];
  return between(around, asItIs(31)).length;
}

/** An inner node near a place. @param {number[]} along @param {number} middle */
function nearestTo(along, middle) {
  const after = along.findIndex((length) => length >= middle);
  return Math.min(along.length - 2, Math.max(1, after));
}

/** A rough path, if it crosses waves. @param {Found} found @returns {Line | null} */
function lineOf({ to, path }) {
  if (path.crossesSingularity) return null;
  const places = placesOf(path);
  const along = [0];
  for (let i = 1; i < places.length; i++) along.push(along[i - 1] + gap(places[i], places[i - 1]));
  const bends = bendsOf(places);
  if (bends.length < LEAST_BENDS) return null;
  /* Between waves it may be straight for long. */
  const apart = bends.slice(1).map((i, k) => along[i] - along[bends[k]]);
  const halfWave = apart.sort((a, b) => a - b)[apart.length >> 1];
  return { to, numbers: path.parameters ?? path.points, width: path.parameters ? 2 : 3, places, along, halfWave };
}

/** Nodes of a path in space or, where it has no positions, u v 0. @param {RawPath} path */
function placesOf({ points, parameters }) {
  const [numbers, width] = points.length > 0 || !parameters ? [points, 3] : [parameters, 2];
  return Array.from({ length: numbers.length / width }, (_, i) => [
    numbers[width * i],
    numbers[width * i + 1],
    width < 3 ? 0 : numbers[width * i + 2],
  ]);
}

/** Nodes at which a line bends to one side after it bent to the other. @param {number[][]} places */
function bendsOf(places) {
  const turns = turnsOf(places);
  const least = Math.max(LEAST_BEND, LARGE * Math.max(...turns.map(norm)));
  const large = Array.from(turns.keys()).filter((i) => norm(turns[i]) >= least);
  return large.filter((i, k) => k > 0 && dot(turns[i], turns[large[k - 1]]) < 0).map((i) => i + 1);
}

/** By what the direction of a line changes at each inner node. @param {number[][]} places */
function turnsOf(places) {
  const directions = places.slice(1).map((place, i) => unit(minus(place, places[i])));
  return directions.slice(1).map((direction, i) => minus(direction, directions[i]));
}

/**
 * What pushes a path aside at a place: the line that results, and by how much it is shorter, -Infinity where it is the path itself.
 * @param {Problem} problem @param {Line} line @param {number} middle how far along the path that is @param {number} girth of the surface there
 * @returns {(push: Push) => Pushed}
 */
function pushAt(problem, line, middle, girth) {
  const { to, numbers, width, places, along, halfWave } = line;
  const { domain } = problem;
  const inReach = Array.from(along.keys()).filter((i) => Math.abs(along[i] - middle) <= SOLVED * halfWave);
  const [begin, end] = [inReach[0], inReach[inReach.length - 1]];
  const section = numbers.slice(width * begin, width * (end + 1));
  const solve = (/** @type {Float64Array} */ start) => problem.between(start, { ...roughlyIn(end - begin - 1), maxIterations: STEPS });
  const length = estimate(solve(section));
  const across = acrossAt(problem, line, middle);
  const apart = APART * Math.min(halfWave, girth / 2);
  const least = -LONGER * along[along.length - 1];
  return ({ far, turn }) => {
    const whole = numbers.slice();
    const start = whole.subarray(width * begin, width * (end + 1));
    for (let i = begin + 1; i < end; i++) {
      const away = (along[i] - middle) / (MOVED * halfWave);
      const bent = Math.abs(away) < 1 ? far * (1 - away * away) ** 2 : 0;
      if (bent)
        across(i).forEach((x, k) => {
          whole[width * i + k] += bent * x;
        });
    }
    if (domain) confine(domain, start);
    const isTurned = turn.some((x) => x !== 0);
    for (let i = begin + 1; isTurned && i < places.length; i++) {
      const part = i < end ? Math.min(Math.max((along[i] - middle) / (2 * halfWave) + 0.5, 0), 1) : 1;
      for (let k = 0; k < width; k++) whole[width * i + k] += part * turn[k];
    }
    const path = solve(start);
    const gain = length - estimate(path);
    const isOther = isTurned || !(gain > least) || placesOf(path).some((place, i) => gap(place, places[begin + i]) > apart);
    whole.set(path.parameters ?? path.points, width * begin);
    return { gain: isOther ? gain : -Infinity, to: to.map((x, k) => x + turn[k]), numbers: whole };
  };
}

/**
 * Across a path near a place: what is added to the coordinates of a node so that it moves by 1 on the surface.
 * @param {Problem} problem @param {Line} line @param {number} middle @returns {(i: number) => number[]}
 */
function acrossAt({ between, domain }, { numbers, places, along, halfWave }, middle) {
  if (!domain) {
    /* A geodesic bends along the normal. */
    const near = turnsOf(places).filter((_, i) => Math.abs(along[i + 1] - middle) < halfWave);
    const normal = near.reduce((sharpest, turn) => (norm(turn) > norm(sharpest) ? turn : sharpest), [0, 0, 0]);
    return (i) => unit(cross(normal, minus(places[i + 1], places[i - 1])));
  }
  const turned = (/** @type {number} */ i) => [numbers[2 * i - 1] - numbers[2 * i + 3], numbers[2 * i + 2] - numbers[2 * i - 2]];
  const nearest = nearestTo(along, middle);
  const [u, v] = numbers.subarray(2 * nearest);
  const [du, dv] = turned(nearest);
  const across = Float64Array.of(u - du / 2, v - dv / 2, u + du / 2, v + dv / 2);
  confine(domain, across);
  const { length } = between(across, asItIs(1));
  const scale = gap([across[0], across[1], 0], [across[2], across[3], 0]) / length;
  return (i) =>
    unit([...turned(i), 0])
      .slice(0, 2)
      .map((x) => scale * x);
}
