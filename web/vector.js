/** Vectors in space: of arrays, from their first number on. */

/** @param {ArrayLike<number>} a @param {ArrayLike<number>} b */
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** @param {ArrayLike<number>} a */
export const norm = (a) => Math.sqrt(dot(a, a));

/** @param {number[]} a */
export function unit(a) {
  const length = norm(a);
  return a.map((x) => x / length);
}

/** @param {ArrayLike<number>} a @param {ArrayLike<number>} b */
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

/** The product of two lists, of any length; what counts nothing may be infinite. @param {number[]} weights @param {ArrayLike<number>} b */
export const product = (weights, b) => weights.reduce((sum, x, j) => (x === 0 ? sum : sum + x * b[j]), 0);

/** The difference of two lists, of any length. @param {readonly number[]} a @param {readonly number[]} b */
export const minus = (a, b) => a.map((x, k) => x - b[k]);

/** The largest of some numbers, whatever their signs; 0 of none. @param {ArrayLike<number>} numbers */
export function largest(numbers) {
  let most = 0;
  for (let i = 0; i < numbers.length; i++) most = Math.max(most, Math.abs(numbers[i]));
  return most;
}

/** The sum of some numbers, in an array of any type. @param {{ reduce(add: (sum: number, x: number) => number, from: number): number }} numbers */
export const sumOf = (numbers) => numbers.reduce((sum, x) => sum + x, 0);

/** The distance of two points. @param {ArrayLike<number>} a @param {ArrayLike<number>} b */
export const gap = (a, b) => Math.sqrt((a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2 + (a[2] - b[2]) ** 2);

/** @param {number[]} box from and to of x, y and z */
export const diagonalOf = (box) => gap([box[1], box[3], box[5]], [box[0], box[2], box[4]]);

/** Whether a place lies in ranges, one a coordinate. @param {ArrayLike<number>} place @param {number[][]} ranges none: it does */
export const isWithin = (place, ranges) => ranges.every(([low, high], k) => place[k] >= low && place[k] <= high);

/** How far all points of a list are from one. @param {Float64Array} positions x y z of each @param {ArrayLike<number>} from */
export function distancesFrom(positions, { 0: x, 1: y, 2: z }) {
  const away = new Float64Array(positions.length / 3);
  for (let i = 0, k = 0; i < away.length; i++)
    away[i] = Math.sqrt((positions[k++] - x) ** 2 + (positions[k++] - y) ** 2 + (positions[k++] - z) ** 2);
  return away;
}

/**
 * Numbers as a plain array: several times as fast as Array.from, which asks typed arrays for an iterator.
 * @param {ArrayLike<number>} numbers @param {number} [from] @param {number} [to]
 */
export function listOf(numbers, from = 0, to = numbers.length) {
  const list = [];
  for (let i = from; i < to; i++) list.push(numbers[i]);
  return list;
}
