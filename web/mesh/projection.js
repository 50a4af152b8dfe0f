/** The point of a surface closest to one of space: downhill from a place, which the vertices of a mesh may tell. */

import { CONVERGED, OFF_SURFACE, STATUS } from '../runtime/status.js';
import { distancesFrom, gap, listOf } from '../vector.js';
import { meshSurface } from './mesh.js';

/** @typedef {import('../manifold/manifold.js').Manifold} Manifold */
/** @typedef {ReturnType<typeof withEdges>} Coarse */

/** Without a place the vertices of a mesh of this resolution tell some: so many at most, those that are nearer than all beside them. */
const [SEARCH, MOST] = [48, 24];
/** What is nearer by less than this part is as near: a place beyond a seam. */
const NEARER = 1e-9;
/** A point that is so far from a surface, in parts of its bounds' diagonal, may be nearer to another part of it than to that below it. */
const FAR = 0.01;

/**
 * @param {Manifold} manifold @param {string} caller @param {number[]} target x y z
 * @param {number[] | null} near where to start; null: at near vertices; on an implicit surface at the target and, where that leads far or nowhere, there, too
 * @returns {number[]} u v, or x y z
 */
export function projectOnto(manifold, caller, target, near) {
  const { domain, box, extent } = manifold;
  const from = (/** @type {number[]} */ place) => manifold.run((heap, _, { record }) => heap.project(record, target, place));
  const inSpace = (/** @type {number[]} */ place) => (domain ? manifold.evaluate('value', place) : place);
  const away = (/** @type {ReturnType<typeof from>} */ { status, place }) => (status < CONVERGED ? Infinity : gap(inSpace(place), target));
  let found = near || !domain ? from(near ?? target) : { status: OFF_SURFACE, place: target };
  const looksBeside = domain ? !near : !near && box && away(found) > FAR * extent;
  for (const { place, least } of looksBeside ? nearVertices(manifold, caller, target) : []) {
    if (least > away(found)) continue;
    const other = from(place);
    if (found.status < CONVERGED || away(other) < (1 - NEARER) * away(found)) found = other;
  }
  if (found.status >= CONVERGED) return found.place;
  throw new RangeError(`${caller}: no point of the surface was found from there (${STATUS.get(found.status)}); pass a point nearer`);
}

/**
 * The vertices of a mesh that are nearer to a point of space than all beside them, the nearest first, as u v or x y z, each with how near the surface beside it may be.
 * @param {Manifold} manifold @param {string} caller @param {number[]} target
 * @returns {{ place: number[], least: number }[]}
 */
function nearVertices(manifold, caller, target) {
  manifold.coarse ??= withEdges(meshSurface(manifold, caller, SEARCH));
  const { positions, parameters, edges, longest } = manifold.coarse;
  const away = distancesFrom(positions, target);
  const isNear = longest.map((edge) => Number(edge >= 0));
  for (let k = 0; k < edges.length; k += 2) {
    const between = away[edges[k]] - away[edges[k + 1]];
    if (between < 0 || between > 0) isNear[edges[between < 0 ? k + 1 : k]] = 0;
  }
  const [numbers, width] = parameters ? [parameters, 2] : [positions, 3];
  /** @type {number[]} */
  const found = [];
  for (let i = 0; i < isNear.length; i++) if (isNear[i]) found.push(i);
  return found
    .sort((i, j) => away[i] - away[j])
    .slice(0, MOST)
    .map((i) => ({ place: listOf(numbers, width * i, width * i + width), least: away[i] - longest[i] }));
}

/** A mesh with the edges of its triangles, two vertices each, and the longest edge of each vertex, −1 without any. @param {import('./mesh.js').Mesh} mesh */
function withEdges({ positions, parameters, indices }) {
  const after = (/** @type {number} */ k) => (k % 3 < 2 ? k + 1 : k - 2);
  const edges = Uint32Array.from({ length: 2 * indices.length }, (_, k) => indices[k & 1 ? after(k >> 1) : k >> 1]);
  const longest = new Float64Array(positions.length / 3).fill(-1);
  for (let k = 0; k < edges.length; k++) {
    const [from, to] = [edges[k & ~1], edges[k | 1]].map((i) => positions.subarray(3 * i));
    const length = gap(from, to);
    /* Beside a vertex where the formula has no value the others are as they are. */
    if (length < Infinity) longest[edges[k]] = Math.max(longest[edges[k]], length);
  }
  return { positions, parameters, edges, longest };
}
