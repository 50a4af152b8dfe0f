/** What kinds of surface differ in: their variables, and what a compiled surface of the kind computes. */

/** As enum sp_surface_kind of wasm/surface.h. */
export const KIND = { parametric: 0, implicit: 1, metric: 0 };

/** Of a point: its variables, and how many numbers the functions `jet` and `value` give of it. */
export const SHAPE = {
  parametric: { variables: ['u', 'v'], jet: 18, value: 3, valueOrder: /** @type {0} */ (0) },
  implicit: { variables: ['x', 'y', 'z'], jet: 10, value: 4, valueOrder: /** @type {1} */ (1) },
  metric: { variables: ['u', 'v'], jet: 18, value: 3, valueOrder: /** @type {0} */ (0) },
};
