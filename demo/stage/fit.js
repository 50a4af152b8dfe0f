/** How much of a view is taken. */

import { Vector3 } from 'three';
import { strideOf } from '../../web/view/spikes.js';

/** @typedef {import('../../web/view/spikes.js').Points} Points */

/**
 * How much of a view points take.
 * @param {Points} points
 * @param {import('three').Matrix4} toCamera from the points' space to the camera's
 * @param {number[]} slopes tangents of half the angles of view, across and up
 * @returns {{ reach: number, extent: number }} reach: from the view's middle, 1 at its edge, Infinity behind the camera; extent: the larger of width and height, 1 that of the view
 */
export function shareOfView(points, toCamera, slopes) {
  const stride = strideOf(points);
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
