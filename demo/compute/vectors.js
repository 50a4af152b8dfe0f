/** Vectors of three numbers, as few lines as the page needs. */

/** @typedef {ArrayLike<number>} Vector */

/** @param {Vector} a @param {Vector} b */
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
/** @param {Vector} a @param {Vector} b */
export const subtract = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
/** a + t b @param {Vector} a @param {number} t @param {Vector} b */
export const along = (a, t, b) => [a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]];
/** @param {Vector} a @param {Vector} b */
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
/** @param {Vector} a */
export const unit = (a) => {
  const length = Math.hypot(a[0], a[1], a[2]) || 1;
  return [a[0] / length, a[1] / length, a[2] / length];
};

/** Whether a place lies in ranges, one a coordinate. @param {ArrayLike<number>} place @param {number[][]} ranges none: it does */
export const isWithin = (place, ranges) => ranges.every(([low, high], k) => place[k] >= low && place[k] <= high);
