/**
 * Paths on other sides of bumps. Across waves many lead side by side, as long to a thousandth: a graph's lengths are wrong by more, and it tells few of them apart. So the shortest rough
 * path is pushed aside at one place after the other, and compared with what it comes to rest at there.
 */

import { cross, dot, gap, minus, norm, unit } from '../vector.js';
import { holds, leaps } from './candidates.js';
import { distinct, estimate } from './distinct.js';
import { finer, innerOf, MOST_ROUGH, ROUGHLY } from './rough.js';

/** @typedef {import('./candidates.js').Found} Found */
/** @typedef {import('./candidates.js').Problem} Problem */
/** @typedef {import('./candidates.js').RawPath} RawPath */
/** @typedef {{ numbers: Float64Array, width: number, places: number[][], along: number[], halfWave: number }} Line nodes of a rough path as the solver takes them, so many numbers each, and in space; how long it is up to each; and half a wave */

/** A path bends to one side and the other so often, at least; bends count that are so large, in parts of the largest, and in radians. */
const [LEAST_BENDS, LARGE, LEAST_BEND] = [3, 0.1, 0.01];
/** Of half a wave: how far apart are the places at which it is pushed; how far it is pushed there, what is moved, to either side, and solved; and how far apart are paths on two sides of a bump. */
const [STEP, FAR, MOVED, SOLVED, APART] = [0.7, 1.5, 1.7, 6, 0.2];
/** What is pushed comes to rest within so many steps, mostly. */
const STEPS = 40;
/** What is longer by this part of the path may turn out to be shorter: so many, the shortest first, are solved whole. */
const [LONGER, SHORTER, MOST_SOLVED] = [2e-4, 1e-7, 4];
/** Rough paths that are longer than the shortest by up to this part of it are compared, with nodes enough for an error of this part of them. */
const [COMPARED, COARSE] = [5e-3, 1e-3];
/** The shortest path is pushed until none is shorter, but no more often. */
const MOST_ROUNDS = 6;

/**
 * The rough paths, and those beside the shortest of them, sorted by length.
 * @param {Problem} problem @param {Found[]} rough
 */
export function passBumps(problem, rough) {
  if (rough.length < 2 || problem.branches.length > 0 || !lineOf(rough[0].path)) return rough;
  const most = (1 + COMPARED) * estimate(rough[0].path);
  let found = distinct(rough.map((one) => (estimate(one.path) < most ? sharpened(problem, one) : one)));
  for (let round = 0; round < MOST_ROUNDS; round++) {
    const [best] = found;
    const beside = pushed(problem, best.path).map((line) => ({
      to: best.to,
      path: problem.solve(best.to, line, { ...ROUGHLY, points: innerOf(best.path) }),
    }));
    found = distinct([...found, ...beside.filter((one) => holds(one) && !leaps(problem, one.path))]);
    if (found[0] === best) break;
  }
  return found;
}

/** A rough path with nodes enough to be compared. @param {Problem} problem @param {Found} found @returns {Found} */
function sharpened(problem, found) {
  const { path } = found;
  const isCoarse = path.lengthError > COARSE * path.length && innerOf(path) < MOST_ROUGH;
  const next = isCoarse && finer(problem, found);
  return next ? sharpened(problem, next) : found;
}

/** Lines beside a path that lead along others, maybe shorter ones, the shortest first. @param {Problem} problem @param {RawPath} path */
function pushed(problem, path) {
  const line = lineOf(path);
  /** @type {{ gain: number, numbers: Float64Array }[]} */
  const found = [];
  if (!line) return [];
  const { along, halfWave } = line;
  const [length] = along.slice(-1);
  for (let middle = STEP * halfWave; middle < length; middle += STEP * halfWave) {
    const push = pushAt(problem, line, middle);
    for (const far of [-FAR, FAR]) {
      const { gain, numbers } = push(far);
      const isNew = !found.some((one) => Math.abs(one.gain - gain) < SHORTER * length);
      if (isNew && gain > -LONGER * length) found.push({ gain, numbers });
    }
  }
  return found
    .sort((a, b) => b.gain - a.gain)
    .slice(0, MOST_SOLVED)
    .map(({ numbers }) => numbers);
}

/** A rough path, if it crosses waves. @param {RawPath} path @returns {Line | null} */
function lineOf(path) {
  if (path.crossesSingularity) return null;
  const places = placesOf(path);
  const along = [0];
  for (let i = 1; i < places.length; i++) along.push(along[i - 1] + gap(places[i], places[i - 1]));
  const bends = bendsOf(places);
  const width = path.parameters ? 2 : 3;
  return bends < LEAST_BENDS
    ? null
    : { numbers: path.parameters ?? path.points, width, places, along, halfWave: along[places.length - 1] / (bends + 1) };
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

/** How often a line bends to one side after it bent to the other. @param {number[][]} places */
function bendsOf(places) {
  const turns = turnsOf(places);
  const least = Math.max(LEAST_BEND, LARGE * Math.max(...turns.map(norm)));
  const large = turns.filter((turn) => norm(turn) >= least);
  return large.filter((turn, i) => i > 0 && dot(turn, large[i - 1]) < 0).length;
}

/** By what the direction of a line changes at each inner node. @param {number[][]} places */
function turnsOf(places) {
  const directions = places.slice(1).map((place, i) => unit(minus(place, places[i])));
  return directions.slice(1).map((direction, i) => minus(direction, directions[i]));
}

/**
 * What pushes a path aside at a place: the line that results, and by how much it is shorter, -Infinity where it is the path itself.
 * @param {Problem} problem @param {Line} line @param {number} middle how far along the path that is
 */
function pushAt(problem, line, middle) {
  const { numbers, width, places, along, halfWave } = line;
  const { domain } = problem;
  const inReach = Array.from(along.keys()).filter((i) => Math.abs(along[i] - middle) <= SOLVED * halfWave);
  const [begin, end] = [inReach[0], inReach[inReach.length - 1]];
  const section = numbers.slice(width * begin, width * (end + 1));
  const solve = (/** @type {Float64Array} */ start, /** @type {number} */ steps) =>
    problem.between(start, { ...ROUGHLY, points: end - begin - 1, maxIterations: steps });
  const { length } = solve(section, 0);
  const across = acrossAt(problem, line, middle);
  return (/** @type {number} */ far) => {
    const start = section.slice();
    for (let i = begin + 1; i < end; i++) {
      const away = (along[i] - middle) / (MOVED * halfWave);
      const bent = Math.abs(away) < 1 ? far * halfWave * (1 - away * away) ** 2 : 0;
      if (bent)
        across(i).forEach((x, k) => {
          start[width * (i - begin) + k] += bent * x;
        });
    }
    if (domain) confine(domain, start);
    const path = solve(start, STEPS);
    const isOther = placesOf(path).some((place, i) => gap(place, places[begin + i]) > APART * halfWave);
    const whole = numbers.slice();
    whole.set(path.parameters ?? path.points, width * begin);
    return { gain: isOther ? length - path.length : -Infinity, numbers: whole };
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
  const last = places.length - 2;
  const nearest = Math.min(
    last,
    Math.max(
      1,
      along.findIndex((length) => length >= middle),
    ),
  );
  const [u, v] = numbers.subarray(2 * nearest);
  const [du, dv] = turned(nearest);
  const across = Float64Array.of(u - du / 2, v - dv / 2, u + du / 2, v + dv / 2);
  confine(domain, across);
  const { length } = between(across, { ...ROUGHLY, points: 1, maxIterations: 0 });
  const scale = gap([across[0], across[1], 0], [across[2], across[3], 0]) / length;
  return (i) =>
    unit([...turned(i), 0])
      .slice(0, 2)
      .map((x) => scale * x);
}

/** Moves places beyond walls onto these. @param {import('../manifold/domain.js').Domain} domain @param {Float64Array} places */
function confine({ lower, upper, periodic }, places) {
  for (let i = 0; i < places.length; i++) if (!periodic[i % 2]) places[i] = Math.min(Math.max(places[i], lower[i % 2]), upper[i % 2]);
}
