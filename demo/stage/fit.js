/** Where a camera must stand so that a surface just fills the view. Pure geometry. */

import { BufferAttribute, Vector3 } from 'three';

const ROUNDS = 4;
/** Of many points, about so many are looked at. */
const ENOUGH = 4000;

/** Of a surface's points along an axis, what lies between these shares is its bulk. */
const BULK = [0.05, 0.95];
/** A surface has spikes where it is so many times longer than its bulk, and than it is wide. */
const [SPIKY, TALL] = [3, 2];
/** What is seen of spikes, with the bulk, in parts of the surface's width. */
const SEEN = 1;

const AXES = /** @type {const} */ (['getX', 'getY', 'getZ']);

/** @typedef {import('three').BufferAttribute | import('three').InterleavedBufferAttribute} Points */

/** What to look at along each axis. @param {Points} points @param {readonly ArrayLike<number>[]} ends @returns {number[][]} from and to, infinite where it is all */
function rangesWithoutSpikes(points, ends) {
  const stride = Math.max(1, Math.floor(points.count / ENOUGH));
  const lists = AXES.map((get) =>
    Float64Array.from({ length: Math.floor((points.count - 1) / stride) + 1 }, (_, i) => points[get](i * stride)).sort(),
  );
  const lengths = lists.map((list) => list[list.length - 1] - list[0]);
  return lists.map((list, k) => {
    const [low, high] = BULK.map((share) => list[Math.floor(share * (list.length - 1))]);
    const width = Math.max(...lengths.filter((_, other) => other !== k));
    if (!(lengths[k] > Math.max(SPIKY * (high - low), TALL * width))) return [-Infinity, Infinity];
    const size = Math.max(high - low, SEEN * width);
    const from = Math.max(list[0], (low + high - size) / 2);
    const there = ends.map((end) => end[k]);
    return [Math.min(from, ...there), Math.max(from + size, ...there)];
  });
}

/**
 * The points of a surface that a view of it must show: those far out on spikes, as beside a pole, would make all else tiny.
 * @param {Points} points @param {readonly ArrayLike<number>[]} [ends] places that must be seen, too: x y z each
 * @returns {BufferAttribute | null} null: there are no spikes
 */
export function withoutSpikes(points, ends = []) {
  const ranges = rangesWithoutSpikes(points, ends);
  if (ranges.flat().every((x) => !Number.isFinite(x))) return null;
  /** @type {number[]} */ const kept = [];
  for (let i = 0; i < points.count; i++) {
    const place = AXES.map((get) => points[get](i));
    if (place.every((x, k) => x >= ranges[k][0] && x <= ranges[k][1])) kept.push(...place);
  }
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
