/** A step along a surface in a direction of the screen: what an arrow key does. */

import { Vector3 } from 'three';

/** Where the surface turns away from the eye, at most so many steps along it for one on the screen. */
const MOST = 3;

const [direction, normal] = [new Vector3(), new Vector3()];

/**
 * @param {import('../surface.js').Surface} surface @param {number[]} point u v or x y z
 * @param {Vector3} position of it @param {import('three').Matrix4} frame from the surface's coordinates to the scene's
 * @param {import('three').Camera} camera @param {[number, number]} pixels right and up @param {number} height of the view in pixels
 * @returns {number[] | null} the point there; null where none is found
 */
export function stepAlong(surface, point, position, frame, camera, [right, up], height) {
  const { elements } = camera.projectionMatrix;
  const depth = -direction.copy(position).applyMatrix4(frame).applyMatrix4(camera.matrixWorldInverse).z;
  const pixel = (2 * (elements[15] + depth * -elements[11])) / (elements[5] * height);
  direction.setFromMatrixColumn(camera.matrixWorld, 0).multiplyScalar(right * pixel);
  direction.addScaledVector(normal.setFromMatrixColumn(camera.matrixWorld, 1), up * pixel);
  const length = direction.length() / frame.getMaxScaleOnAxis();
  direction.transformDirection(frame.clone().invert()).multiplyScalar(length);
  const values = surface.evaluate(point);
  normal.fromArray(values.subarray(-3)).normalize();
  direction.addScaledVector(normal, -direction.dot(normal));
  const tangent = direction.length();
  if (tangent > 0) direction.multiplyScalar(Math.min(length / tangent, MOST));
  try {
    return surface.project(direction.add(position).toArray(), surface.kind === 'implicit' ? undefined : point);
  } catch (error) {
    if (error instanceof RangeError) return null;
    throw error;
  }
}
