/** Lists of numbers as vectors of any length, and small systems of linear equations. */

import { minus, product } from '../vector.js';

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
