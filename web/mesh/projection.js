/** The point of a surface closest to one of space: downhill from a place, which the vertices of a mesh may tell. */

import { CONVERGED, STATUS } from '../runtime/status.js';
import { gap } from '../vector.js';
import { meshSurface } from './mesh.js';

/** @typedef {import('../manifold/manifold.js').Manifold} Manifold */

/** Without a place the nearest vertex of a mesh of this resolution is one. */
const SEARCH = 48;
/** A point that is so far from a surface, in parts of its bounds' diagonal, may be nearer to another part of it than to that below it. */
const FAR = 0.01;

/**
 * @param {Manifold} manifold @param {string} caller @param {number[]} target x y z
 * @param {number[] | null} near where to start; null: at the nearest vertex; on an implicit surface at the target and, where that leads far or nowhere, there, too
 * @returns {number[]} u v, or x y z
 */
export function projectOnto(manifold, caller, target, near) {
  const { domain, box, extent } = manifold;
  const from = (/** @type {number[]} */ place) => manifold.run((heap, _, { record }) => heap.project(record, target, place));
  const away = (/** @type {typeof found} */ { status, place }) => (status < CONVERGED ? Infinity : gap(place, target));
  const vertex = () => from(nearestVertex(manifold, caller, target));
  let found = near || !domain ? from(near ?? target) : vertex();
  if (!near && box && away(found) > FAR * extent) {
    const other = vertex();
    if (away(other) < away(found)) found = other;
  }
  if (found.status >= CONVERGED) return found.place;
  throw new RangeError(`${caller}: no point of the surface was found from there (${STATUS.get(found.status)}); pass a point nearer to it`);
}

/**
 * The vertex of a mesh nearest to a point of space, as u v or x y z; without any, the point.
 * @param {Manifold} manifold @param {string} caller @param {number[]} target
 */
function nearestVertex(manifold, caller, target) {
  manifold.coarse ??= meshSurface(manifold, caller, SEARCH);
  const { positions, parameters } = manifold.coarse;
  let [best, least] = [-1, Infinity];
  for (let i = 0; i < positions.length / 3; i++) {
    const away = gap(positions.subarray(3 * i), target);
    if (away < least) [best, least] = [i, away];
  }
  if (best < 0) return target;
  return Array.from(parameters ? parameters.subarray(2 * best, 2 * best + 2) : positions.subarray(3 * best, 3 * best + 3));
}
