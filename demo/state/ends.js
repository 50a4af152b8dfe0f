/** The two ends of a path: what is wrong with them, and where to put them instead. */

import { coordinates } from './definition.js';

/** @typedef {import('surfpath').Surface} Surface */
/** @typedef {import('../compute/drawable.js').SurfaceMesh} SurfaceMesh */
/** @typedef {{ end: number, coordinate: number, message: string }} EndProblem end −1: neither of the two alone is at fault */

/** @param {import('./kinds.js').Kind} kind @param {Surface} surface @param {number[][]} ends @returns {EndProblem | null} */
export function findBadEnd(kind, { domain }, ends) {
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

/** Where a point of the surface lies in space; null if it lies nowhere. @param {Surface} drawn @param {number[]} point */
export function placeOf(drawn, point) {
  if (!point.every(Number.isFinite)) return null;
  const place = drawn.kind === 'implicit' ? point : Array.from(drawn.evaluate(point).subarray(0, 3));
  return place.every(Number.isFinite) ? place : null;
}

/**
 * Two points of the surface at random, not too near to each other, that a path was found between, unless twenty pairs have none.
 * @param {Surface} surface @param {SurfaceMesh} mesh
 * @returns {number[][]}
 */
export function chooseEnds(surface, mesh) {
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
