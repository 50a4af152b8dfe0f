/** Meshes as they are drawn: cut where a formula ends or jumps, without what has a place that is no number, or one that graphics cannot compute with. */

import { cutMesh, LARGEST } from './cuts.js';
import { refineRims } from './rims.js';

/** @typedef {import('../surface.js').Surface} Surface */
/** @typedef {import('../mesh/mesh.js').Mesh} Mesh */
/**
 * @typedef {object} DrawnMesh
 * @property {number[]} [twins] after the mesh's own vertices there are others, each beside the one of these
 * @property {boolean} [isOneSided] a Möbius strip, say: its normals point to both sides of a seam, and it has no back to be told from a front
 */
/** @typedef {Mesh & DrawnMesh} SurfaceMesh */

/** @param {Pick<Surface, 'domain' | 'evaluate'>} surface with positions @param {Mesh} mesh of it @returns {SurfaceMesh} */
export function drawableMesh(surface, mesh) {
  const drawn = dropUndrawable((mesh.parameters ? cutMesh : refineRims)(mesh, (places) => surface.evaluate(places)));
  return surface.domain?.turn?.sign === -1 ? { ...drawn, isOneSided: true } : drawn;
}

/** Triangles whose corners can be drawn: a formula may have no value on a part of its range, or a huge one. @param {SurfaceMesh} mesh @returns {SurfaceMesh} */
function dropUndrawable(mesh) {
  const { positions, normals } = mesh;
  const isDrawable = (/** @type {number} */ x) => Math.abs(x) <= LARGEST;
  if (positions.every(isDrawable) && normals.every(isDrawable)) return mesh;
  const good = (/** @type {number} */ i) => [positions, normals].every((list) => list.subarray(3 * i, 3 * i + 3).every(isDrawable));
  const indices = mesh.indices.filter((_, i, all) => all.subarray(i - (i % 3), i - (i % 3) + 3).every(good));
  // Vertices of no triangle are put onto those that are drawn, as evenly as these lie: what is fitted into the view is what is seen, and where most of it is.
  const used = new Set(indices);
  const drawn = (/** @type {number} */ i) => (used.has(i) ? i : indices[Math.floor((3 * i * indices.length) / positions.length)]);
  const place = (/** @type {Float64Array} */ list) => list.map((_, i) => list[3 * drawn(Math.floor(i / 3)) + (i % 3)] ?? 0);
  return { ...mesh, positions: place(positions), normals: place(normals), indices };
}
