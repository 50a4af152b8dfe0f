/** Where a camera must stand so that a surface just fills the view. Pure geometry. */

import { Vector3 } from 'three';

const ROUNDS = 4;
/** Of many points, about so many are looked at. */
const ENOUGH = 4000;

/**
 * Moves a camera along a direction, and its target across it, until all points lie inside the view, centred.
 * @param {import('three').BufferAttribute | import('three').InterleavedBufferAttribute} points
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
 * @param {import('three').BufferAttribute | import('three').InterleavedBufferAttribute} points
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
