/** What the page asks of the library: build a surface from the form, find a path on it, choose end points. Touches neither the page nor the scene. */

import { coordinates, sentence } from './definition.js';
import { drawable } from './surface-mesh.js';

/** @typedef {import('surfpath').Surface} Surface */
/** @typedef {import('surfpath').Path} Path */
/** @typedef {import('surfpath').Surfpath} Surfpath */
/** @typedef {import('./surface-mesh.js').SurfaceMesh} SurfaceMesh */
/** @typedef {{ end: number, coordinate: number, message: string }} EndProblem end −1: neither of the two alone is at fault */

/** Milliseconds. */
const MEASURE_FOR = 9;
const BATCH = 1.5;

/**
 * @param {Surfpath} surfpath @param {Parameters<Surfpath['surface']>[0]} definition
 * @returns {{ surface: Surface, mesh: SurfaceMesh }}
 */
export function buildSurface(surfpath, definition) {
  const surface = surfpath.surface(definition);
  try {
    return { surface, mesh: meshOf(surface) };
  } catch (error) {
    surface.dispose();
    throw error;
  }
}

/** @param {Surface} surface */
export function meshOf(surface) {
  const mesh = drawable(surface.mesh());
  if (mesh.indices.length > 0) return mesh;
  throw new RangeError(
    surface.kind === 'implicit'
      ? 'there is no point with f = 0 inside these bounds: widen them or change the formula'
      : 'the formula has no value anywhere in these ranges',
  );
}

/** @param {Surface} surface @param {number[][]} ends @returns {EndProblem | null} */
export function findBadEnd(surface, ends) {
  const names = coordinates(surface.kind);
  for (const [end, point] of ends.entries())
    for (const [coordinate, name] of names.entries()) {
      const value = point[coordinate];
      if (!Number.isFinite(value)) return { end, coordinate, message: `${'AB'[end]} needs a number for ${name}.` };
      const range = surface.domain?.[/** @type {'u' | 'v'} */ (name)];
      if (!range || surface.domain?.periodic[/** @type {'u' | 'v'} */ (name)]) continue;
      const slack = 1e-9 * (range[1] - range[0]);
      if (value < range[0] - slack || value > range[1] + slack)
        return { end, coordinate, message: `${name} of ${'AB'[end]} must lie between ${shorten(range[0])} and ${shorten(range[1])}.` };
    }
  return null;
}

/** A number of a range for the reader, and for an input. @param {number} x */
const shorten = (x) => String(Number(x.toPrecision(5)));

/**
 * The path, all its iterates, and the time that one such solve takes.
 * @param {Surface} surface @param {number[][]} ends @param {{ points: number, algorithm: 'polyline' | 'paper' }} options
 * @returns {{ path: Path | null, milliseconds: number, problem: EndProblem | null }}
 */
export function solve(surface, ends, options) {
  const problem = findBadEnd(surface, ends);
  if (problem) return { path: null, milliseconds: NaN, problem };
  try {
    const path = surface.shortestPath(ends[0], ends[1], { ...options, start: 'straight', record: true });
    return { path, milliseconds: measure(() => surface.shortestPath(ends[0], ends[1], { ...options, start: 'straight' })), problem: null };
  } catch (error) {
    return {
      path: null,
      milliseconds: NaN,
      problem: { end: -1, coordinate: 0, message: sentence(error instanceof Error ? error.message : String(error)) },
    };
  }
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
 * @param {Surface} surface @param {SurfaceMesh} mesh
 * @returns {number[][]}
 */
export function chooseEnds(surface, mesh) {
  let ends = randomPair(surface, mesh);
  for (let i = 0; i < 20 && !solve(surface, ends, { points: 16, algorithm: 'polyline' }).path?.converged; i++)
    ends = randomPair(surface, mesh);
  return ends;
}

/** The farthest but one of six random pairs. @param {Surface} surface @param {SurfaceMesh} mesh */
function randomPair(surface, mesh) {
  const pick = () => mesh.indices[Math.floor(Math.random() * mesh.indices.length)];
  const gap = (/** @type {number[]} */ [a, b]) =>
    Math.hypot(...[0, 1, 2].map((k) => mesh.positions[3 * a + k] - mesh.positions[3 * b + k]));
  const pairs = Array.from({ length: 6 }, () => [pick(), pick()]).sort((one, other) => gap(one) - gap(other));
  const dimension = coordinates(surface.kind).length;
  const places = dimension === 2 && mesh.parameters ? mesh.parameters : mesh.positions;
  return pairs[4].map((vertex) =>
    Array.from(places.subarray(dimension * vertex, dimension * vertex + dimension), (x) => Math.trunc(1000 * x) / 1000),
  );
}
