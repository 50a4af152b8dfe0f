/** What a view of a surface leaves out: spikes, as beside a pole, that would make all else tiny, and most of what would be a thread. */

import { BufferAttribute } from 'three';
import { isWithin } from '../vector.js';

/** @typedef {import('three').BufferAttribute | import('three').InterleavedBufferAttribute} Points */

/** Of many points, about so many are looked at. */
export const ENOUGH = 4000;

/** Of a surface's points along an axis, what lies between these shares is its bulk. */
const BULK = [0.05, 0.95];
/** A surface has spikes where it is so many times longer than its bulk, and than that is wide; */
const [SPIKY, TALL] = [3, 2];
/** or where, in a part as long as it is wide, its points are so many times denser than they would be spread evenly, and so large a share of all. */
const [DENSE, SOME] = [8, 0.1];
/** What is so many times longer than wide would be a thread: of a steep one only a part is seen. */
const THREAD = 200;
/** In parts of its width: a bulk up to here is seen. */
const LONG = 4;

const AXES = /** @type {const} */ (['getX', 'getY', 'getZ']);

/** @param {Points} points */
export const strideOf = ({ count }) => Math.max(1, Math.floor(count / ENOUGH));

/** Where in a sorted list most numbers lie within a size, near its middle if that is anywhere, and how many. @param {Float64Array} list @param {number} size */
function densest(list, size) {
  let [from, most] = [0, 0];
  for (let i = 0, j = 0; i < list.length; i++) {
    while (j < list.length && list[j] - list[i] <= size) j++;
    if (j - i > most || (j - i === most && i <= list.length / 2)) [from, most] = [i, j - i];
  }
  return { from: list[from], share: most / list.length };
}

/**
 * What a view of a surface must show along each axis: far out on spikes, as beside a pole, there is what would make all else tiny.
 * @param {Points} points @param {readonly ArrayLike<number>[]} [ends] places that should be seen, too, x y z each; on an implicit surface they may lie outside its bounds
 * @param {number} [farthest] how far apart, in parts of the width, they may be for that
 * @param {number} [chosen] along so many axes the surface is as long as it was asked for: there it may be a thread
 * @returns {number[][]} from and to, infinite where it is all
 */
export function rangesWithoutSpikes(points, ends = [], farthest = Infinity, chosen = 0) {
  const stride = strideOf(points);
  const lists = AXES.map((get) =>
    Float64Array.from({ length: Math.ceil(points.count / stride) }, (_, i) => points[get](i * stride)).sort(),
  );
  const bulks = lists.map((list) => BULK.map((share) => list[Math.floor(share * (list.length - 1))]));
  const sizes = bulks.map(([low, high]) => high - low);
  return lists.map((list, k) => {
    const [low, high] = bulks[k];
    let [from, to] = [list[0], list[list.length - 1]];
    const length = to - from;
    const width = Math.max(...sizes.filter((_, other) => other !== k));
    const { from: dense, share } = densest(list, width);
    const isEven =
      length <= SPIKY * sizes[k] && share <= Math.max((DENSE * width) / length, SOME) && (length <= THREAD * width || k < chosen);
    if (!isEven && length > TALL * width) {
      const isLong = sizes[k] > LONG * width;
      const size = isLong ? width : Math.max(sizes[k], width);
      from = isLong ? dense : Math.max(from, (low + high - size) / 2);
      to = from + size;
    } else if (!ends.some(({ [k]: end }) => end < from || end > to)) return [-Infinity, Infinity];
    for (const { [k]: end } of ends)
      if (Math.max(to, end) - Math.min(from, end) <= farthest * width) [from, to] = [Math.min(from, end), Math.max(to, end)];
    return [from, to];
  });
}

/** The points, and ends, that lie in such ranges; null: all. @param {Points} points @param {number[][]} ranges @param {readonly ArrayLike<number>[]} [ends] */
export function pointsWithin(points, ranges, ends = []) {
  if (!ranges.flat().some(Number.isFinite)) return null;
  const places = ends.map((end) => Array.from(end));
  for (let i = 0; i < points.count; i += strideOf(points)) places.push(AXES.map((get) => points[get](i)));
  return new BufferAttribute(Float64Array.from(places.filter((place) => isWithin(place, ranges)).flat()), 3);
}
