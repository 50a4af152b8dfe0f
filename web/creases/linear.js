/** Lists of numbers as vectors of any length, and small systems of linear equations. */

import { largest, minus, product } from '../vector.js';

/** The product of two vectors whose coordinates count by a scale. @param {number[]} a @param {number[]} b @param {readonly number[]} scale */
export const inner = (a, b, scale) => a.reduce((sum, x, j) => sum + x * b[j] * scale[j] * scale[j], 0);

/** How long a vector is whose coordinates count by a scale. @param {number[]} a @param {readonly number[]} scale */
export const sizeBy = (a, scale) => Math.sqrt(inner(a, a, scale));

/** How far apart two places are in their coordinates. @param {number[]} a @param {number[]} b @param {readonly number[]} scale */
export const apart = (a, b, scale) => sizeBy(minus(a, b), scale);

/** How steep a gradient is, by length of that. @param {number[]} gradient @param {readonly number[]} scale */
export const steepnessBy = (gradient, scale) => sizeOf(gradient.map((x, j) => x / scale[j]));

/** @param {number[]} a */
export const sizeOf = (a) => Math.sqrt(product(a, a));

/** @param {number[]} a @param {number} by */
export const scaled = (a, by) => a.map((x) => by * x);

/** A place, so far along a direction. @param {number[]} place @param {number[]} direction @param {number} by */
export const ahead = (place, direction, by) => place.map((x, j) => x + by * direction[j]);

/** Solves linear equations by elimination, with pivots; null: they have no one solution. @param {number[][]} matrix @param {number[]} right */
export function solveLinear(matrix, right) {
  const rows = matrix.map((row, i) => [...row, right[i]]);
  for (let i = 0; i < rows.length; i++) {
    let pivot = i;
    for (let k = i + 1; k < rows.length; k++) if (Math.abs(rows[k][i]) > Math.abs(rows[pivot][i])) pivot = k;
    [rows[i], rows[pivot]] = [rows[pivot], rows[i]];
    if (!rows[i][i]) return null;
    for (let k = 0; k < rows.length; k++) {
      if (k === i) continue;
      const factor = rows[k][i] / rows[i][i];
      for (let j = i; j <= rows.length; j++) rows[k][j] -= factor * rows[i][j];
    }
  }
  return rows.map((row, i) => row[rows.length] / row[i]);
}

/** Newton's step downhill, by Cholesky's factors of the matrix, shifted until it is positive definite; null: it is none, or not finite. @param {number[][]} matrix @param {number[]} slope */
export function descend(matrix, slope) {
  const size = largest(matrix.flat());
  if (!(size > 0 && size < Infinity)) return null;
  for (let shift = 0; shift <= 4 * size; shift = shift ? 4 * shift : 1e-3 * size) {
    const factor = matrix.map((row) => row.map(() => 0));
    const isPositive = matrix.every((row, i) => {
      for (let j = 0; j <= i; j++) {
        let sum = row[j] + (i === j ? shift : 0);
        for (let k = 0; k < j; k++) sum -= factor[i][k] * factor[j][k];
        if (i === j && !(sum > 1e-9 * size)) return false;
        factor[i][j] = i === j ? Math.sqrt(sum) : sum / factor[j][j];
      }
      return true;
    });
    if (!isPositive) continue;
    const step = slope.map((x) => -x);
    for (let i = 0; i < step.length; i++) {
      for (let k = 0; k < i; k++) step[i] -= factor[i][k] * step[k];
      step[i] /= factor[i][i];
    }
    for (let i = step.length - 1; i >= 0; i--) {
      for (let k = i + 1; k < step.length; k++) step[i] -= factor[k][i] * step[k];
      step[i] /= factor[i][i];
    }
    return { step, shifted: shift > 0 };
  }
  return null;
}
