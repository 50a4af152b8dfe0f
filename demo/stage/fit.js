/** Where a camera must stand so that a surface just fills the view. Pure geometry. */

import { BufferAttribute, Vector3 } from 'three';
import { isWithin } from '../compute/vectors.js';

const ROUNDS = 4;
/** Of many points, about so many are looked at. */
const ENOUGH = 4000;

/** Of a surface's points along an axis, what lies between these shares is its bulk. */
const BULK = [0.05, 0.95];
/** A surface has spikes where it is so many times longer than its bulk, and than that is wide; */
const [SPIKY, TALL] = [3, 2];
/** or where, in a part as long as it is wide, its points are so many times denser than they would be spread evenly, and so large a share of all. */
const [DENSE, SOME] = [8, 0.1];
/** Whatever it is like, what is so many times longer than wide would be a thread. */
const THREAD = 200;
/** In parts of its width: a bulk up to here is seen, and ends of a path that lie so far apart. */
const [LONG, FARTHEST] = [4, 6];

const AXES = /** @type {const} */ (['getX', 'getY', 'getZ']);

/** @typedef {import('three').BufferAttribute | import('three').InterleavedBufferAttribute} Points */

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
 * @param {Points} points @param {readonly ArrayLike<number>[]} [ends] places that should be seen, too, x y z each
 * @returns {number[][]} from and to, infinite where it is all
 */
export function rangesWithoutSpikes(points, ends = []) {
  const stride = Math.max(1, Math.floor(points.count / ENOUGH));
  const lists = AXES.map((get) =>
    Float64Array.from({ length: Math.floor((points.count - 1) / stride) + 1 }, (_, i) => points[get](i * stride)).sort(),
  );
  const bulks = lists.map((list) => BULK.map((share) => list[Math.floor(share * (list.length - 1))]));
  const sizes = bulks.map(([low, high]) => high - low);
  return lists.map((list, k) => {
    const [low, high] = bulks[k];
    const length = list[list.length - 1] - list[0];
    const width = Math.max(...sizes.filter((_, other) => other !== k));
    if (!(length > TALL * width)) return [-Infinity, Infinity];
    const { from: dense, share } = densest(list, width);
    const isEven = length <= SPIKY * sizes[k] && share <= Math.max((DENSE * width) / length, SOME);
    if (isEven && length <= THREAD * width) return [-Infinity, Infinity];
    const size = Math.max(sizes[k], width);
    const isLong = size > LONG * width;
    let from = isLong ? dense : Math.max(list[0], (low + high - size) / 2);
    let to = from + (isLong ? width : size);
    for (const { [k]: end } of ends)
      if (Math.max(to, end) - Math.min(from, end) <= FARTHEST * width) [from, to] = [Math.min(from, end), Math.max(to, end)];
    return [from, to];
  });
}

/** The points, and ends, that lie in such ranges; null: all. @param {Points} points @param {number[][]} ranges @param {readonly ArrayLike<number>[]} [ends] */
export function pointsWithin(points, ranges, ends = []) {
  if (ranges.flat().every((x) => !Number.isFinite(x))) return null;
  /** @type {number[]} */ const kept = [];
  for (let i = 0; i < points.count; i++) {
    const place = AXES.map((get) => points[get](i));
    if (isWithin(place, ranges)) kept.push(...place);
  }
  for (const end of ends) if (isWithin(end, ranges)) kept.push(...Array.from(end));
  return new BufferAttribute(Float32Array.from(kept), 3);
}

/**
 * Moves a camera along a direction, and its target across it, until all points lie inside the view, centred.
 * @param {Points} points
 * @param {Vector3} center about which the camera turns
 * @param {Vector3} towards the camera from there, unit length
 * @param {Vector3} up
 * @param {number[]} slopes tangents of half the angles of view, across and up, that the points may fill
 * @returns {{ target: Vector3, distance: number }} distance: of the camera from the target
 */
export function fitView(points, center, towards, up, slopes) {
  const right = new Vector3().crossVectors(up, towards).normalize();
  const axes = [right, new Vector3().crossVectors(towards, right)];
  const target = center.clone();
  const stride = Math.max(1, Math.floor(points.count / ENOUGH));
  const point = new Vector3();
  let distance = 0;
  for (let round = 0; round < ROUNDS; round++) {
    distance = 0;
    for (let i = 0; i < points.count; i += stride) {
      point.fromBufferAttribute(points, i).sub(target);
      const depth = point.dot(towards);
      for (const [k, axis] of axes.entries()) distance = Math.max(distance, depth + Math.abs(point.dot(axis)) / slopes[k]);
    }
    const ranges = axes.map(() => [Infinity, -Infinity]);
    for (let i = 0; i < points.count; i += stride) {
      point.fromBufferAttribute(points, i).sub(target);
      const scale = distance / (distance - point.dot(towards));
      for (const [k, axis] of axes.entries()) {
        const seen = point.dot(axis) * scale;
        ranges[k] = [Math.min(ranges[k][0], seen), Math.max(ranges[k][1], seen)];
      }
    }
    for (const [k, axis] of axes.entries()) target.addScaledVector(axis, (ranges[k][0] + ranges[k][1]) / 2);
  }
  return { target, distance };
}

/**
 * How much of a view points take.
 * @param {Points} points
 * @param {import('three').Matrix4} toCamera from the points' space to the camera's
 * @param {number[]} slopes tangents of half the angles of view, across and up
 * @returns {{ reach: number, extent: number }} reach: from the view's middle, 1 at its edge, Infinity behind the camera; extent: the larger of width and height, 1 that of the view
 */
export function shareOfView(points, toCamera, slopes) {
  const stride = Math.max(1, Math.floor(points.count / ENOUGH));
  const point = new Vector3();
  const ranges = slopes.map(() => [Infinity, -Infinity]);
  for (let i = 0; i < points.count; i += stride) {
    const { x, y, z } = point.fromBufferAttribute(points, i).applyMatrix4(toCamera);
    if (z >= 0) return { reach: Infinity, extent: Infinity };
    for (const [k, across] of [x, y].entries()) {
      const seen = across / -z / slopes[k];
      ranges[k] = [Math.min(ranges[k][0], seen), Math.max(ranges[k][1], seen)];
    }
  }
  return {
    reach: Math.max(...ranges.map(([low, high]) => Math.max(-low, high))),
    extent: Math.max(...ranges.map(([low, high]) => (high - low) / 2)),
  };
}
