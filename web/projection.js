/** The point of a surface closest to one of space: downhill from a place, which the vertices of a mesh may tell. */

import { meshSurface } from './mesh.js';
import { CONVERGED, STATUS } from './runtime/status.js';
import { gap } from './vector.js';

/** @typedef {import('./manifold.js').Manifold} Manifold */

/** Without a place the nearest vertex of a mesh of this resolution is one. */
const SEARCH = 48;

/**
 * @param {Manifold} manifold @param {string} caller @param {number[]} target x y z
 * @param {number[] | null} near where to start; null: at the nearest vertex or, on an implicit surface, at the target and, where that leads nowhere, there
 * @returns {number[]} u v, or x y z
 */
export function projectOnto(manifold, caller, target, near) {
  const place = near ?? (manifold.domain ? nearestVertex(manifold, caller, target) : target);
  const found = manifold.run((heap, _, { record }) => heap.project(record, target, place));
  if (found.status >= CONVERGED) return found.place;
  if (place === target && !near && manifold.box) return projectOnto(manifold, caller, target, nearestVertex(manifold, caller, target));
  throw new RangeError(`${caller}: no point of the surface was found from there (${STATUS.get(found.status)}); pass a point nearer to it`);
}

/**
 * The vertex of a mesh nearest to a point of space, as u v or x y z; without any, the point.
 * @param {Manifold} manifold @param {string} caller @param {number[]} target
 */
function nearestVertex(manifold, caller, target) {
  const { positions, parameters } = meshSurface(manifold, caller, SEARCH);
  let [best, least] = [-1, Infinity];
  for (let i = 0; i < positions.length / 3; i++) {
    const away = gap(positions.subarray(3 * i), target);
    if (away < least) [best, least] = [i, away];
  }
  if (best < 0) return target;
  return Array.from(parameters ? parameters.subarray(2 * best, 2 * best + 2) : positions.subarray(3 * best, 3 * best + 3));
}
