/** Lengths along a mesh, which know nothing of geodesics: an upper bound of distances, up to how well the mesh fits. */

/** Cells around a node that are joined to it by a straight line. */
const AROUND = 2.5;

/**
 * Distances of the vertices from one of them, over edges and across them to the next vertices, and through nodes.
 *
 * @param {import('../../web/mesh/mesh.js').Mesh} mesh
 * @param {number} from a vertex
 * @param {number[][]} nodes x y z of points where sheets meet, of which the mesh knows nothing
 * @param {number} cell of the mesh
 * @returns {Float64Array} infinite where no way leads
 */
export function distancesAlong({ positions, indices }, from, nodes, cell) {
  const own = positions.length / 3;
  const at = Float64Array.from([...positions, ...nodes.flat()]);
  const count = at.length / 3;
  const apart = (/** @type {number} */ i, /** @type {number} */ j) =>
    Math.hypot(at[3 * i] - at[3 * j], at[3 * i + 1] - at[3 * j + 1], at[3 * i + 2] - at[3 * j + 2]);
  /** @type {Set<number>[]} */
  const beside = Array.from({ length: count }, () => new Set());
  const join = (/** @type {number} */ i, /** @type {number} */ j) => beside[i].add(j) && beside[j].add(i);
  for (let i = 0; i < indices.length; i += 3)
    for (const [a, b] of [
      [0, 1],
      [1, 2],
      [2, 0],
    ])
      join(indices[i + a], indices[i + b]);
  for (let node = own; node < count; node++) for (let i = 0; i < own; i++) if (apart(node, i) <= AROUND * cell) join(node, i);
  const distances = new Float64Array(count).fill(Infinity);
  distances[from] = 0;
  /** Places by tenths of a cell, which settle in order but for those of one tenth, which may be settled again. @type {number[][]} */
  const waiting = [[from]];
  for (let k = 0; k < waiting.length; k++)
    for (const i of waiting[k] ?? []) {
      const reach = (/** @type {number} */ j) => {
        const through = distances[i] + apart(i, j);
        if (!(through < distances[j])) return;
        distances[j] = through;
        const later = Math.floor((10 * through) / cell);
        waiting[later] ??= [];
        waiting[later].push(j);
      };
      for (const j of beside[i]) {
        reach(j);
        if (i < own && j < own) for (const next of beside[j]) if (next < own) reach(next);
      }
    }
  return distances.subarray(0, own);
}
