/**
 * Creases that paths over a body do not notice, as where a rounded edge begins: normals are the same on both sides, only curvatures jump. Elements follow there, of many ways quicker than legs come to rest at so many
 * joints.
 */

import { cross, largest, norm } from '../vector.js';
import { beyond, settle } from './crease.js';
import { cut } from './cut.js';

/** @typedef {import('../manifold/sides.js').Sides} Sides */
/** @typedef {import('./legs.js').Joint} Joint */

/** Normals are the same if the sine between them is below this. */
const PARALLEL = 1e-6;

/** Whether polylines cross creases, and the surface none at which it bends. @param {Sides} sides @param {Float64Array[]} ways */
export function areFaint(sides, ways) {
  let count = 0;
  for (const way of ways) {
    const route = cut(sides, way, { most: Infinity });
    if (!route) return false;
    count += route.joints.length;
    if (route.joints.some((joint) => isSharp(sides, joint))) return false;
  }
  return count > 0;
}

/** Whether the surface has another normal beyond a crease. Within the body, where f is constant or from where nothing leads to the surface, it has none. @param {Sides} sides @param {Joint} joint */
function isSharp(sides, joint) {
  const slopes = (/** @type {number[]} */ place) =>
    [joint.signs, beyond(joint.signs, joint.crease)].map((signs) => Array.from(sides.on(signs)?.values(place).slice(1) ?? []));
  if (!slopes(joint.place).every(largest)) return false;
  const [one, other] = slopes(settle(sides, joint, joint.place));
  return norm(cross(one, other)) > PARALLEL * norm(one) * norm(other);
}
