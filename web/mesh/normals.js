/** Positions of a surface with its unit normals. */

import { vector } from '../manifold/rectangle.js';
import { cross, unit } from '../vector.js';

/**
 * @param {import('../manifold/manifold.js').Manifold} manifold parametric @param {ArrayLike<number>} points u v a point
 * @returns {Float64Array} six numbers a point; a normal that does not exist is NaN
 */
export function evaluateNormals(manifold, points) {
  const jets = manifold.evaluate('jet', points);
  const count = jets.length / 18;
  const result = new Float64Array(6 * count);
  for (let i = 0; i < count; i++) {
    result.set(vector(jets, i, 0), 6 * i);
    result.set(unit(cross(vector(jets, i, 3), vector(jets, i, 6))), 6 * i + 3);
  }
  return result;
}
