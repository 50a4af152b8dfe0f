/** Vectors of three numbers, as few lines as the page needs beside the library's. */

export { cross, dot } from '../../web/vector.js';

/** @typedef {ArrayLike<number>} Vector */

/** @param {Vector} a @param {Vector} b */
export const subtract = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
/** a + t b @param {Vector} a @param {number} t @param {Vector} b */
export const along = (a, t, b) => [a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]];
/** @param {Vector} a */
export const unit = (a) => {
  const length = Math.hypot(a[0], a[1], a[2]) || 1;
  return [a[0] / length, a[1] / length, a[2] / length];
};
