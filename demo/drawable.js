/** Meshes as they are drawn: without the triangles of which some corner is no number. */

/** @typedef {import('./tasks.js').Opened} Opened */
/** @typedef {{ positions: Float64Array, normals: Float64Array, parameters?: Float64Array, indices: Uint32Array }} SurfaceMesh */

/** Cells a direction: what is carried along a curve is much longer than wide. */
const CELLS_ALONG = 160;

/** @param {Opened} opened @param {number} [resolution] @returns {SurfaceMesh} */
export function meshOf({ drawn, definition }, resolution) {
  const wanted = resolution ?? (['tube', 'sweep'].includes(definition.kind) ? CELLS_ALONG : undefined);
  const mesh = drawable(drawn.mesh(wanted ? { resolution: wanted } : {}));
  if (mesh.indices.length > 0) return mesh;
  throw new RangeError(
    drawn.kind === 'implicit'
      ? 'there is no point with f = 0 inside these bounds: widen them or change the formula'
      : 'the formula has no value anywhere in these ranges',
  );
}

/** Triangles whose corners are all numbers: a formula may have no value on a part of its range. @param {SurfaceMesh} mesh @returns {SurfaceMesh} */
function drawable(mesh) {
  const { positions, normals } = mesh;
  if (positions.every(Number.isFinite) && normals.every(Number.isFinite)) return mesh;
  const good = (/** @type {number} */ i) =>
    [0, 1, 2].every((k) => Number.isFinite(positions[3 * i + k]) && Number.isFinite(normals[3 * i + k]));
  const indices = [];
  for (let i = 0; i < mesh.indices.length; i += 3) {
    const corners = mesh.indices.subarray(i, i + 3);
    if (corners.every(good)) indices.push(...corners);
  }
  const finite = (/** @type {number} */ x) => (Number.isFinite(x) ? x : 0);
  return { ...mesh, positions: positions.map(finite), normals: normals.map(finite), indices: Uint32Array.from(indices) };
}
