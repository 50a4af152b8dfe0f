/** Whether two sides of creases are one surface. */

/** @typedef {import('../manifold/sides.js').Sides} Sides */

/** Sides are the same surface where derivatives are, to this part of those of the same order, or to this part of all, which is rounding. */
const [SAME, NOISE] = [1e-9, 1e-14];

/** Whether two sides are the same surface at a place. @param {Sides} sides @param {number[]} before @param {number[]} after @param {number[]} place */
export const isSame = (sides, before, after, place) =>
  before.every((sign, k) => sign === after[k]) || isBent(sides, before, after, place) === false;

/** Whether two sides are different surfaces at a place; null: there are too many. @param {Sides} sides @param {number[]} before @param {number[]} after @param {number[]} place */
export function isBent(sides, before, after, place) {
  const [a, b] = [sides.on(before), sides.on(after)];
  if (!a || !b) return null;
  const [[one], [other]] = [a.jets(place), b.jets(place)];
  return differ(a.groups, one, other, SAME, NOISE);
}

/**
 * Whether two jets differ by more than this part of their numbers of the same unit, and by more than the second of all of the shape, or of what measures length: these may be of very different sizes.
 * @param {number[]} groups as {@link import('../manifold/sides.js').Side} has them @param {number[]} one @param {number[]} other @param {number} part @param {number} ofAll
 */
export function differ(groups, one, other, part, ofAll) {
  const sizes = new Float64Array(6);
  for (const [i, group] of groups.entries()) sizes[group] = Math.max(sizes[group], Math.abs(one[i]), Math.abs(other[i]));
  const least = [sizes.subarray(0, 3), sizes.subarray(3)].map((orders) => ofAll * Math.max(...orders));
  return !one.every((x, i) => Math.abs(x - other[i]) <= Math.max(part * sizes[groups[i]], least[Math.trunc(groups[i] / 3)]));
}
