/** From which side a surface is looked at: from that of a curve on it, 30 degrees above. */

import { Vector3 } from 'three';

const ELEVATION = Math.PI / 6;
/** Parts of the surface's radius that the curve must be off its axis, or it has no side: then it is seen from here. */
const [OFF, ANYWHERE] = [0.08, new Vector3(0.6, -1, 0)];
/** A curve that goes so straight away from the eye, by the cosine, would be seen end on: it is looked at from so far aside, in radians. */
const [END_ON, ASIDE] = [0.85, Math.PI / 3];

/**
 * @param {ArrayLike<number>} curve x y z of each place along it; empty where there is none
 * @param {import('three').Sphere} bounds of the surface
 * @returns {Vector3} towards the eye, unit length
 */
export function sideOf(curve, { center, radius }) {
  const last = curve.length / 3 - 1;
  const place = (/** @type {number} */ i) => new Vector3().fromArray(curve, 3 * i);
  const towards = place(Math.ceil(last / 2))
    .sub(center)
    .setZ(0);
  if (!(towards.length() > OFF * radius)) towards.copy(ANYWHERE);
  towards.normalize().multiplyScalar(Math.cos(ELEVATION)).setZ(Math.sin(ELEVATION));
  const along = place(last).sub(place(0)).normalize();
  return Math.abs(along.dot(towards)) > END_ON ? towards.applyAxisAngle(new Vector3(0, 0, 1), ASIDE) : towards;
}
