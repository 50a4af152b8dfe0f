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
  const isPlace = (/** @type {number} */ x) => Math.abs(x) <= LARGEST;
  if (positions.every(isPlace) && normals.every(Number.isFinite)) return mesh;
  const good = (/** @type {number} */ i) => [0, 1, 2].every((k) => isPlace(positions[3 * i + k]) && Number.isFinite(normals[3 * i + k]));
  /** @type {number[]} */ const indices = [];
  for (let i = 0; i < mesh.indices.length; i += 3) {
    const corners = mesh.indices.subarray(i, i + 3);
    if (corners.every(good)) indices.push(...corners);
  }
  // Vertices of no triangle are put onto those that are drawn, as evenly as these lie: what is fitted into the view is what is seen, and where most of it is.
  const used = new Set(indices);
  const count = positions.length / 3;
  const from = Array.from({ length: count }, (_, i) => (used.has(i) ? i : indices[Math.floor((i / count) * indices.length)]));
  const place = (/** @type {Float64Array} */ list) => list.map((_, i) => list[3 * from[Math.floor(i / 3)] + (i % 3)] ?? 0);
  return { ...mesh, positions: place(positions), normals: place(normals), indices: Uint32Array.from(indices) };
}
