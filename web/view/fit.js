/** Where a camera must stand so that a surface just fills its view. */

import { Box3, Vector3 } from 'three';
import { refuse, refuseNumber } from '../arguments.js';
import { checkGeometry } from './check.js';
import { pointsWithin, rangesWithoutSpikes, strideOf } from './spikes.js';

/** @typedef {import('./spikes.js').Points} Points */
/** @typedef {ArrayLike<number> | Vector3} Place x y z */

/** The fit is exact for the distance, and centred to less than a per cent after so many rounds: perspective moves the middle a little. */
const ROUNDS = 4;
/** Of the distance: room to go near, and far. */
const [NEAR, FAR] = [0.02, 4];
/** Radians by which a view along `up`, where nothing is upright, is tilted; and how near to `up` that is. */
const [HAIR, ALONG] = [1e-3, 1e-6];

/**
 * Moves a perspective camera so that a geometry fills its view, centred, seen from a direction; sets its near and far planes for turning around it. Of spikes, as
 * beside a pole, and of what is so steep that all of it would be a thread, a part is looked at.
 * @param {import('three').PerspectiveCamera} camera `fov`, `aspect` and `up` set
 * @param {import('three').BufferGeometry} geometry of {@link surfaceGeometry}, with a bounding sphere
 * @param {Place} towards the camera from the surface, of any length; along `up`, where nothing is upright, it is tilted a hair
 * @param {number} [margin] share of the view that stays free around it, in [0, 1); default 0.1
 * @param {readonly Place[]} [shown] places on it that should be seen whatever is left out
 * @returns {Vector3} the point that the camera looks at: the target for its controls. Throws TypeError or RangeError naming the argument
 */
export function fitCamera(camera, geometry, towards, margin = 0.1, shown = []) {
  const { direction, places } = check(camera, geometry, towards, margin, shown);
  const all = geometry.getAttribute('position');
  const points = pointsWithin(all, rangesWithoutSpikes(all, places), places) ?? all;
  const box = new Box3().setFromBufferAttribute(/** @type {import('three').BufferAttribute} */ (points));
  const back = tilted(direction.normalize(), camera.up);
  const slope = Math.tan((camera.fov * Math.PI) / 360) * (1 - margin);
  const { target, distance } = fitView(points, box.getCenter(new Vector3()), back, camera.up, [slope * camera.aspect, slope]);
  camera.position.copy(target).addScaledVector(back, distance);
  camera.lookAt(target);
  [camera.near, camera.far] = [NEAR * distance, FAR * distance];
  camera.updateProjectionMatrix();
  return target;
}

/** The numbers of a place; of what is none, none or others. @param {any} place @returns {number[]} */
const readPlace = (place) => Array.from(place ?? []);

/** @param {import('three').PerspectiveCamera} camera @param {import('three').BufferGeometry} geometry @param {Place} towards @param {number} margin @param {any} shown */
function check(camera, geometry, towards, margin, shown) {
  const caller = 'fitCamera';
  if (!(camera?.isPerspectiveCamera && camera.aspect > 0)) refuse(`${caller}: camera`, 'a PerspectiveCamera, aspect > 0', camera);
  checkGeometry(caller, geometry);
  if (geometry.index?.count === 0) throw new RangeError(`${caller}: geometry has no triangles`);
  const direction = new Vector3().fromArray(readPlace(towards));
  if (!(direction.length() > 0 && direction.length() < Infinity))
    refuse(`${caller}: towards`, 'a direction x y z, none of length 0', towards);
  if (!(Number.isFinite(margin) && margin >= 0 && margin < 1)) refuseNumber(`${caller}: margin`, 'a number in [0, 1)', margin);
  const places = Array.isArray(shown) ? shown.map(readPlace) : [[]];
  if (!places.every((place) => place.length === 3 && place.every(Number.isFinite)))
    refuse(`${caller}: shown`, 'an array of places, x y z each', shown);
  return { direction, places };
}

/** A direction that is along `up`, a hair to the front: x is to the right then, if it can be. @param {Vector3} towards unit length @param {Vector3} up */
export function tilted(towards, up) {
  const upright = up.clone().normalize();
  if (towards.clone().cross(upright).length() > ALONG) return towards;
  const right = new Vector3().setComponent(Math.abs(upright.x) < 0.9 ? 0 : 1, 1);
  return towards.addScaledVector(right.cross(upright), HAIR).normalize();
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
  const [depths, ...across] = [towards, ...axes].map((axis) => placesAlong(points, center, axis));
  const shift = [0, 0];
  let distance = 0;
  for (let round = 0; round < ROUNDS; round++) {
    distance = 0;
    for (const [k, places] of across.entries())
      for (let i = 0; i < places.length; i++) distance = Math.max(distance, depths[i] + Math.abs(places[i] - shift[k]) / slopes[k]);
    for (const [k, places] of across.entries()) {
      let [low, high] = [Infinity, -Infinity];
      for (let i = 0; i < places.length; i++) {
        const seen = ((places[i] - shift[k]) * distance) / (distance - depths[i] || 1);
        low = Math.min(low, seen);
        high = Math.max(high, seen);
      }
      shift[k] += (low + high) / 2;
    }
  }
  const target = center.clone();
  for (const [k, axis] of axes.entries()) target.addScaledVector(axis, shift[k]);
  return { target, distance };
}

/** How far points lie from a place along a direction: of many, of enough. Plain loops: this is done while a page opens. @param {Points} points @param {Vector3} from @param {Vector3} along unit length */
function placesAlong(points, from, { x, y, z }) {
  const stride = strideOf(points);
  const places = new Float64Array(Math.ceil(points.count / stride));
  for (let i = 0, k = 0; i < points.count; i += stride, k++)
    places[k] = x * (points.getX(i) - from.x) + y * (points.getY(i) - from.y) + z * (points.getZ(i) - from.z);
  return places;
}
