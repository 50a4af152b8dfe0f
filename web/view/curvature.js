/** Gaussian curvature K at many places of a surface, as space has it: exact normals and gradients, differentiated once more by central differences. */

import { cross, dot } from '../vector.js';
import { boxOf } from './origin.js';

/** @typedef {import('../surface.js').Surface} Surface */

/** Share of the range, or of the size, on either side: truncation and rounding are both near 1e-10 of K then, more of it far from the origin. */
const STEP = 1e-5;

/** @param {Float64Array} values @param {number} width @param {number} i @param {number} offset: the three from there on, of entry i minus those of entry i + 1 */
const difference = (values, width, i, offset) =>
  [0, 1, 2].map((k) => values[width * i + offset + k] - values[width * (i + 1) + offset + k]);

/**
 * K = (N_u × N_v) · (S_u × S_v) / |S_u × S_v|².
 * @param {Surface} surface parametric @param {Float64Array} places u v of each
 */
function parametricCurvature(surface, places) {
  const domain = /** @type {NonNullable<Surface['domain']>} */ (surface.domain);
  const ranges = [domain.u, domain.v];
  const steps = ranges.map(([from, to]) => STEP * (to - from));
  // Two steps away from the edges: there a formula may end, or a pole have no normal.
  const inside = (/** @type {number} */ x, /** @type {number} */ k) =>
    Math.min(Math.max(x, ranges[k][0] + 2 * steps[k]), ranges[k][1] - 2 * steps[k]);
  const stencil = new Float64Array(4 * places.length);
  for (let i = 0; i < places.length; i += 2) {
    const [u, v] = [inside(places[i], 0), inside(places[i + 1], 1)];
    stencil.set([u + steps[0], v, u - steps[0], v, u, v + steps[1], u, v - steps[1]], 4 * i);
  }
  const values = surface.evaluate(stencil);
  return Float64Array.from({ length: places.length / 2 }, (_, i) => {
    const area = cross(difference(values, 6, 4 * i, 0), difference(values, 6, 4 * i + 2, 0));
    return dot(cross(difference(values, 6, 4 * i, 3), difference(values, 6, 4 * i + 2, 3)), area) / dot(area, area);
  });
}

/**
 * K = ∇fᵀ adj(H) ∇f / |∇f|⁴, H the Hessian.
 * @param {Surface} surface implicit @param {Float64Array} places x y z of each
 */
function implicitCurvature(surface, places) {
  // Truncation goes with (step / radius)², rounding with farthest / step.
  const farthest = places.reduce((most, x) => Math.max(most, Math.abs(x)), 0) || 1;
  const size = Math.cbrt(farthest * (boxOf(places).radius || farthest) ** 2);
  const step = STEP * size;
  const stencil = new Float64Array(7 * places.length);
  for (let i = 0; i < places.length; i += 3)
    for (let j = 0; j < 7; j++)
      for (let k = 0; k < 3; k++) stencil[7 * i + 3 * j + k] = places[i + k] + (j >> 1 === k && j < 6 ? (j & 1 ? -step : step) : 0);
  const values = surface.evaluate(stencil);
  return Float64Array.from({ length: places.length / 3 }, (_, i) => {
    const gradient = values.subarray(28 * i + 25, 28 * i + 28);
    const rows = [0, 2, 4].map((j) => difference(values, 4, 7 * i + j, 1).map((x) => x / (2 * step)));
    const adjugate = [cross(rows[1], rows[2]), cross(rows[2], rows[0]), cross(rows[0], rows[1])];
    const image = adjugate.map((row) => dot(row, gradient));
    return dot(image, gradient) / dot(gradient, gradient) ** 2;
  });
}

/**
 * Gaussian curvature, unit 1/length². A density or a metric of the surface does not count. NaN where the surface is singular.
 * @param {Surface} surface parametric or implicit
 * @param {Float64Array} places u v, or x y z, of each
 * @returns {Float64Array}
 */
export function gaussianCurvature(surface, places) {
  return surface.kind === 'implicit' ? implicitCurvature(surface, places) : parametricCurvature(surface, places);
}
