/** Where a camera must stand so that a surface just fills its view. */

import { Vector3 } from 'three';
import { refuse, refuseNumber } from '../arguments.js';
import { checkGeometry } from './check.js';

/** The fit is exact for the distance, and centred to a per cent after so many rounds: perspective moves the middle a little. */
const ROUNDS = 3;
/** Of the distance: room to go near, and far. */
const [NEAR, FAR] = [0.02, 4];

/**
 * Moves a perspective camera so that a geometry fills its view, centred, seen from a direction; sets its near and far planes for turning around it.
 * @param {import('three').PerspectiveCamera} camera `fov`, `aspect` and `up` set
 * @param {import('three').BufferGeometry} geometry of {@link surfaceGeometry}, with a bounding sphere
 * @param {ArrayLike<number>} towards the camera from the surface, x y z of any length; not along `up`
 * @param {number} [margin] share of the view that stays free around it, in [0, 1); default 0.1
 * @returns {Vector3} the point that the camera looks at: the target for its controls. Throws TypeError or RangeError naming the argument
 */
export function fitCamera(camera, geometry, towards, margin = 0.1) {
  check(camera, geometry, towards, margin);
  const { center } = /** @type {import('three').Sphere} */ (geometry.boundingSphere);
  const back = new Vector3(towards[0], towards[1], towards[2]).normalize();
  const right = new Vector3().crossVectors(camera.up, back).normalize();
  const axes = [right, new Vector3().crossVectors(back, right)];
  const slope = Math.tan((camera.fov * Math.PI) / 360) * (1 - margin);
  const slopes = [slope * camera.aspect, slope];
  const target = center.clone();
  let distance = 0;
  for (let round = 0; round < ROUNDS; round++) distance = centre(geometry, target, back, axes, slopes);
  camera.position.copy(target).addScaledVector(back, distance);
  camera.lookAt(target);
  [camera.near, camera.far] = [NEAR * distance, FAR * distance];
  camera.updateProjectionMatrix();
  return target;
}

/** @param {import('three').PerspectiveCamera} camera @param {import('three').BufferGeometry} geometry @param {ArrayLike<number>} towards @param {number} margin */
function check(camera, geometry, towards, margin) {
  const caller = 'fitCamera';
  if (!camera?.isPerspectiveCamera) refuse(`${caller}: camera`, 'a PerspectiveCamera', camera);
  checkGeometry(caller, geometry);
  if (geometry.index?.count === 0) throw new RangeError(`${caller}: geometry has no triangles`);
  const length = Math.hypot(towards?.[0], towards?.[1], towards?.[2]);
  if (!(length > 0 && Number.isFinite(length))) refuse(`${caller}: towards`, 'a direction x y z, none of length 0', towards);
  if (!(margin >= 0 && margin < 1)) refuseNumber(`${caller}: margin`, 'a number in [0, 1)', margin);
}

/**
 * Moves the target to the middle of what is seen of the geometry.
 * @param {import('three').BufferGeometry} geometry @param {Vector3} target @param {Vector3} back @param {Vector3[]} axes @param {number[]} slopes
 * @returns {number} how far the camera must be to see all
 */
function centre({ attributes, index }, target, back, axes, slopes) {
  const { position } = attributes;
  const point = new Vector3();
  const count = index ? index.count : position.count;
  const places = Array.from({ length: count }, (_, i) => {
    point.fromBufferAttribute(position, index ? index.getX(i) : i).sub(target);
    return [point.dot(axes[0]), point.dot(axes[1]), point.dot(back)];
  });
  let distance = 0;
  for (const [x, y, depth] of places) distance = Math.max(distance, depth + Math.max(Math.abs(x) / slopes[0], Math.abs(y) / slopes[1]));
  for (const [k, axis] of axes.entries()) {
    let [least, most] = [Infinity, -Infinity];
    for (const place of places) {
      const seen = (place[k] * distance) / (distance - place[2]);
      [least, most] = [Math.min(least, seen), Math.max(most, seen)];
    }
    target.addScaledVector(axis, (least + most) / 2);
  }
  return distance;
}
