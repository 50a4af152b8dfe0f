/** Positions of a surface with its unit normals. */

/**
 * @param {import('./manifold.js').Manifold} manifold parametric @param {ArrayLike<number>} points u v a point
 * @returns {Float64Array} six numbers a point; a normal that does not exist is NaN
 */
export function evaluateNormals(manifold, points) {
  const jets = manifold.evaluate('jet', points);
  const count = jets.length / 18;
  const result = new Float64Array(6 * count);
  for (let i = 0; i < count; i++) {
    const [x, y, z, ux, uy, uz, vx, vy, vz] = jets.subarray(18 * i, 18 * i + 9);
    const normal = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    const length = Math.sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
    result.set([x, y, z, normal[0] / length, normal[1] / length, normal[2] / length], 6 * i);
  }
  return result;
}
