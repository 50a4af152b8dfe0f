/** A metric tensor of space, T(x, y, z), at many places, and what of it is felt along a surface. */

import { tensorNames } from '../state/kinds.js';
import { along, cross, dot, unit } from './vectors.js';

/** Each entry as the function f of an implicit surface: that is what the library evaluates over x, y, z. */
export class Tensor {
  kind = /** @type {const} */ ('space');
  /** By formula: many entries are the same. @type {Map<string, import('surfpath').Surface>} */ #functions = new Map();
  /** @type {string[]} */ #formulas;

  /** @param {import('surfpath').Surfpath} surfpath @param {Record<string, unknown>} metric @param {Record<string, number>} [parameters] */
  constructor(surfpath, metric, parameters) {
    this.#formulas = tensorNames('implicit').map((name) => String(metric[name]));
    for (const f of new Set(this.#formulas)) this.#functions.set(f, surfpath.implicit({ f, parameters }));
  }

  /** @param {ArrayLike<number>} places x y z … @returns {Float64Array} xx xy xz yy yz zz of each */
  evaluate(places) {
    const values = new Map([...this.#functions].map(([formula, surface]) => [formula, surface.evaluate(places)]));
    const entries = this.#formulas.map((formula) => /** @type {Float64Array} */ (values.get(formula)));
    return Float64Array.from({ length: 2 * places.length }, (_, i) => entries[i % 6][4 * Math.floor(i / 6)]);
  }

  /** @param {Record<string, number>} parameters */
  set(parameters) {
    for (const surface of this.#functions.values()) surface.set(parameters);
  }

  dispose() {
    for (const surface of this.#functions.values()) surface.dispose();
  }
}

/** EG − F² of a metric; NaN where it is none, as it is not positive definite. @param {number} E @param {number} F @param {number} G */
export const determinantOf = (E, F, G) => (E > 0 && E * G > F * F ? E * G - F * F : Number.NaN);

/**
 * The metric in the tangent plane, by two orthonormal vectors of it: E = aᵀTa, F = aᵀTb, G = bᵀTb.
 * @param {Float64Array} tensor xx xy xz yy yz zz @param {ArrayLike<number>} normal unit length
 */
export function tangentForm([xx, xy, xz, yy, yz, zz], normal) {
  const aside = Math.abs(normal[2]) > 0.9 ? [0, 1, 0] : [0, 0, 1];
  const a = unit(along(aside, -dot(aside, normal), normal));
  const b = cross(normal, a);
  const image = (/** @type {number[]} */ [x, y, z]) => [xx * x + xy * y + xz * z, xy * x + yy * y + yz * z, xz * x + yz * y + zz * z];
  return { a, b, E: dot(a, image(a)), F: dot(a, image(b)), G: dot(b, image(b)) };
}
