/** Moving a point along the surface: to where a pointer points, or a step across the screen for a key. */

import { Raycaster, Vector2, Vector3 } from 'three';
import { along, dot, unit } from './vectors.js';

/** @typedef {import('surfpath').Surface} Surface */
/** @typedef {import('./scene.js').View} View */

/** Points of a ray at which the sign of f is looked at. */
const SAMPLES = 256;
const BISECTIONS = 40;

const caster = new Raycaster();

/** The ray through a point of the screen. @param {View} view @param {number} x CSS pixels of the view @param {number} y */
function rayThrough(view, x, y) {
  const { width, height } = view.canvas.getBoundingClientRect();
  caster.setFromCamera(new Vector2((2 * x) / width - 1, 1 - (2 * y) / height), view.camera);
  return caster.ray;
}

/** Where a ray first meets f = 0, to the last digit. @param {Surface} surface @param {import('three').Ray} ray @param {number} near @param {number} far @returns {number[] | null} */
function meetImplicit(surface, ray, near, far) {
  const at = (/** @type {number} */ t) => along(ray.origin.toArray(), t, ray.direction.toArray());
  const value = (/** @type {number} */ t) => surface.evaluate(at(t))[0];
  const step = (far - near) / SAMPLES;
  const points = Float64Array.from({ length: SAMPLES + 1 }, (_, i) => near + i * step);
  const values = surface.evaluate(Float64Array.from([...points].flatMap(at)));
  for (let i = 0; i < SAMPLES; i++) {
    const [before, after] = [values[4 * i], values[4 * i + 4]];
    if (!(before < 0 !== after < 0) || !Number.isFinite(before + after)) continue;
    let [low, high] = [points[i], points[i + 1]];
    for (let k = 0; k < BISECTIONS; k++) {
      const middle = (low + high) / 2;
      if (value(middle) < 0 === before < 0) low = middle;
      else high = middle;
    }
    return at((low + high) / 2);
  }
  return null;
}

/** @param {View} view @param {Surface} drawn @param {import('three').Ray} ray @returns {{ place: number[], near: number[] | null } | null} place in space, and parameters near it */
function meet(view, drawn, ray) {
  const mesh = view.surface;
  const sphere = /** @type {import('three').Sphere} */ (mesh.geometry.boundingSphere);
  if (drawn.kind === 'implicit') {
    const middle = ray.direction.dot(new Vector3().subVectors(sphere.center, ray.origin));
    const place = meetImplicit(drawn, ray, Math.max(middle - sphere.radius, 0), middle + sphere.radius);
    return place && { place, near: null };
  }
  const [hit] = caster.intersectObject(mesh);
  return hit && { place: hit.point.toArray(), near: hit.face ? [hit.face.a] : null };
}

/**
 * The point of the surface under a pointer; beside the surface, the one next to where the pointer's ray passes the last point.
 * @param {View} view @param {Surface} drawn @param {import('./drawable.js').SurfaceMesh} mesh
 * @param {number[]} last @param {ArrayLike<number>} lastPlace in space
 * @param {number} x @param {number} y
 * @returns {number[]}
 */
export function pointUnder(view, drawn, mesh, last, lastPlace, x, y) {
  const ray = rayThrough(view, x, y);
  const found = meet(view, drawn, ray);
  if (found?.near && mesh.parameters) {
    const vertex = found.near[0];
    return project(drawn, found.place, Array.from(mesh.parameters.subarray(2 * vertex, 2 * vertex + 2)), last);
  }
  if (found) return project(drawn, found.place, found.place, last);
  const depth = ray.direction.dot(new Vector3(lastPlace[0], lastPlace[1], lastPlace[2]).sub(ray.origin));
  return project(drawn, ray.at(depth, new Vector3()).toArray(), last, last);
}

/**
 * The point a step away, to the right and upwards on the screen, along the surface.
 * @param {View} view @param {Surface} drawn @param {number[]} last @param {ArrayLike<number>} place @param {ArrayLike<number>} normal @param {number} right @param {number} up in CSS pixels
 */
export function pointBeside(view, drawn, last, place, normal, right, up) {
  const { height } = view.canvas.getBoundingClientRect();
  const distance = view.camera.position.distanceTo(new Vector3(place[0], place[1], place[2]));
  const pixel = (2 * distance * Math.tan((view.camera.fov * Math.PI) / 360)) / height;
  const axes = [0, 1].map((column) => new Vector3().setFromMatrixColumn(view.camera.matrixWorld, column).toArray());
  const wish = along(
    axes[0].map((x) => x * right),
    up,
    axes[1],
  );
  const level = along(wish, -dot(wish, normal), normal);
  const direction = unit(Math.hypot(...level) > 0.05 * Math.hypot(...wish) ? level : wish);
  return project(drawn, along(place, pixel * Math.hypot(right, up), direction), last, last);
}

/** @param {Surface} drawn @param {number[]} place @param {number[]} near @param {number[]} last what remains where there is nothing */
function project(drawn, place, near, last) {
  try {
    const point = drawn.project(place, near);
    return point.every(Number.isFinite) ? unwind(drawn, point, last) : last;
  } catch {
    return last;
  }
}

/** A periodic coordinate by whole turns as near as may be to the last one. @param {Surface} drawn @param {number[]} point @param {number[]} last */
function unwind(drawn, point, last) {
  const { domain } = drawn;
  if (!domain) return point;
  return point.map((x, i) => {
    const axis = i === 0 ? 'u' : 'v';
    if (!domain.periodic[axis]) return x;
    const turn = domain[axis][1] - domain[axis][0];
    return x + turn * Math.round((last[i] - x) / turn);
  });
}
