/** What the page asks of the library: build a surface from the form, find a path on it, choose end points. Touches neither the page nor the scene. */

import { isNear } from './curves.js';
import { coordinates, sentence } from './definition.js';
import { drawable } from './surface-mesh.js';

/** @typedef {import('surfpath').Surface} Surface */
/** @typedef {import('surfpath').Path} Path */
/** @typedef {import('surfpath').Surfpath} Surfpath */
/** @typedef {import('./surface-mesh.js').SurfaceMesh} SurfaceMesh */
/** @typedef {import('./kinds.js').Kind} Kind */
/** @typedef {{ kind: Kind, surface: Surface, mesh: SurfaceMesh }} Built */
/** @typedef {{ end: number, coordinate: number, message: string }} EndProblem end −1: neither of the two alone is at fault */
/** @typedef {{ points: number, algorithm: 'elements' | 'polyline' | 'paper', tolerance: number, start: 'global' | 'straight' }} Options */

/**
 * @typedef {object} Solved
 * @property {Path | null} path
 * @property {Float64Array[]} frames what is played: how the straight line becomes the path, or the path alone
 * @property {Float64Array | null} straight the straight line from A to B
 * @property {number} milliseconds that one such solve takes
 * @property {EndProblem | null} problem
 */

/** Milliseconds. */
const MEASURE_FOR = 9;
const BATCH = 1.5;
/** Cells a direction: what is carried along a curve is much longer than wide. */
const CELLS_ALONG = 160;

/** @type {Solved} */
export const UNSOLVED = { path: null, frames: [], straight: null, milliseconds: NaN, problem: null };

/**
 * @param {Surfpath} surfpath @param {import('./definition.js').Definition} definition
 * @returns {Built}
 */
export function buildSurface(surfpath, definition) {
  const surface = surfpath.surface(definition);
  try {
    return { kind: definition.kind, surface, mesh: meshOf(surface, definition.kind) };
  } catch (error) {
    surface.dispose();
    throw error;
  }
}

/** @param {Surface} surface @param {Kind} kind */
export function meshOf(surface, kind) {
  const mesh = drawable(surface.mesh(kind === 'tube' || kind === 'sweep' ? { resolution: CELLS_ALONG } : {}));
  if (mesh.indices.length > 0) return mesh;
  throw new RangeError(
    surface.kind === 'implicit'
      ? 'there is no point with f = 0 inside these bounds: widen them or change the formula'
      : 'the formula has no value anywhere in these ranges',
  );
}

/** @param {Built} built @param {number[][]} ends @returns {EndProblem | null} */
export function findBadEnd({ kind, surface: { domain } }, ends) {
  for (const [end, point] of ends.entries())
    for (const [coordinate, name] of coordinates(kind).entries()) {
      const axis = coordinate === 0 ? 'u' : 'v';
      const value = point[coordinate];
      if (!Number.isFinite(value)) return { end, coordinate, message: `${'AB'[end]} needs a number for ${name}.` };
      if (!domain || domain.periodic[axis]) continue;
      const range = domain[axis];
      const slack = 1e-9 * (range[1] - range[0]);
      if (value < range[0] - slack || value > range[1] + slack)
        return { end, coordinate, message: `${name} of ${'AB'[end]} must lie between ${shorten(range[0])} and ${shorten(range[1])}.` };
    }
  return null;
}

/** A number of a range for the reader, and for an input. @param {number} x */
const shorten = (x) => String(Number(x.toPrecision(5)));

/**
 * The path, what is played of it, and the time that one such solve takes.
 * @param {Built} built @param {number[][]} ends @param {Options} options
 * @returns {Solved}
 */
export function solve(built, ends, { points, algorithm, tolerance, start }) {
  const problem = findBadEnd(built, ends);
  if (problem) return { ...UNSOLVED, problem };
  const { surface } = built;
  const wanted = algorithm === 'elements' ? { algorithm, tolerance, points, start } : { algorithm, points, start };
  const find = () => surface.shortestPath(ends[0], ends[1], wanted);
  try {
    const path = find();
    const played = { points, algorithm: wanted.algorithm === 'paper' ? wanted.algorithm : 'polyline', start: 'straight', record: true };
    const { history } = surface.shortestPath(ends[0], ends[1], /** @type {import('surfpath').PathOptions} */ (played));
    const iterates = history.flatMap((iterate) => (iterate.points && iterate.points.length > 0 ? [iterate.points] : []));
    return { path, frames: framesOf(path, iterates), straight: iterates[0] ?? null, milliseconds: measure(find), problem: null };
  } catch (error) {
    const message = sentence(error instanceof Error ? error.message : String(error));
    return { ...UNSOLVED, problem: { end: -1, coordinate: 0, message } };
  }
}

/** The iterates where they lead to the path, which takes the last one's place; else the path alone. @param {Path} path @param {Float64Array[]} iterates */
function framesOf(path, iterates) {
  if (path.points.length === 0) return [];
  const last = iterates.at(-1);
  return last && isNear(last, path.points) ? [...iterates.slice(0, -1), path.points] : [path.points];
}

/** The least mean time of a run in several batches, in milliseconds: a batch outlasts the grain of the browser's clock. @param {() => void} run */
function measure(run) {
  const end = performance.now() + MEASURE_FOR;
  let least = Infinity;
  do {
    const begin = performance.now();
    let [count, elapsed] = [0, 0];
    while (elapsed < BATCH) {
      run();
      count++;
      elapsed = performance.now() - begin;
    }
    least = Math.min(least, elapsed / count);
  } while (performance.now() < end);
  return least;
}

/** Where an end point lies in space; null if it lies nowhere. @param {Surface} surface @param {number[]} point */
export function placeOf(surface, point) {
  const place = surface.kind === 'implicit' ? point : Array.from(surface.evaluate(point).subarray(0, 3));
  return place.every(Number.isFinite) ? place : null;
}

/**
 * Two points of the surface at random, not too near to each other, that a path was found between, unless twenty pairs have none.
 * @param {Built} built
 * @returns {number[][]}
 */
export function chooseEnds({ surface, mesh }) {
  let ends = randomPair(surface, mesh);
  for (let i = 0; i < 20 && !isJoined(surface, ends); i++) ends = randomPair(surface, mesh);
  return ends;
}

/** @param {Surface} surface @param {number[][]} ends */
function isJoined(surface, ends) {
  try {
    return surface.shortestPath(ends[0], ends[1], { points: 16, algorithm: 'polyline', start: 'straight' }).converged;
  } catch {
    return false;
  }
}

/** The farthest but one of six random pairs. @param {Surface} surface @param {SurfaceMesh} mesh */
function randomPair(surface, mesh) {
  const pick = () => mesh.indices[Math.floor(Math.random() * mesh.indices.length)];
  const gap = (/** @type {number[]} */ [a, b]) =>
    Math.hypot(...[0, 1, 2].map((k) => mesh.positions[3 * a + k] - mesh.positions[3 * b + k]));
  const pairs = Array.from({ length: 6 }, () => [pick(), pick()]).sort((one, other) => gap(one) - gap(other));
  const [dimension, places] = surface.domain && mesh.parameters ? [2, mesh.parameters] : [3, mesh.positions];
  return pairs[4].map((vertex) =>
    Array.from(places.subarray(dimension * vertex, dimension * vertex + dimension), (x) => Math.trunc(1000 * x) / 1000),
  );
}
