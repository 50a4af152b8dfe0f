/**
 * Creases that paths over a body do not notice, as where a rounded edge begins: normals are the same on both sides, only curvatures jump. Elements follow there, of many ways quicker than legs come to rest at so many
 * joints.
 */

import { cross, norm } from '../vector.js';
import { beyond, settle } from './crease.js';
import { cut } from './cut.js';
import { span } from './legs.js';

/** @typedef {import('../manifold/sides.js').Sides} Sides */
/** @typedef {import('./legs.js').Joint} Joint */

/** Normals are the same if the sine between them is below this. */
const PARALLEL = 1e-6;
/** A polyline passes creases of the surface no farther from that than this part of its length; what it passes elsewhere, within the body, may bend. */
const BESIDE = 1 / 64;

/** Whether polylines cross creases, and the surface none at which it bends. @param {Sides} sides @param {Float64Array[]} ways */
export function areFaint(sides, ways) {
  let count = 0;
  for (const way of ways) {
    const route = cut(sides, way, { most: Infinity });
    if (!route) return false;
    count += route.joints.length;
    const far = BESIDE * span(way, sides.scale);
    if (route.joints.some((joint) => isSharp(sides, joint, far))) return false;
  }
  return count > 0;
}

/** Whether the surface has another normal beyond a crease. @param {Sides} sides @param {Joint} joint @param {number} far from the surface it is none of it */
function isSharp(sides, joint, far) {
  const seen = (/** @type {number[]} */ place) =>
    [joint.signs, beyond(joint.signs, joint.crease)].map((signs) => Array.from(sides.on(signs)?.values(place) ?? []));
  if (!seen(joint.place).every(([f, ...slope]) => Math.abs(f) <= far * norm(slope))) return false;
  const [one, other] = seen(settle(sides, joint, joint.place)).map(([, ...slope]) => slope);
  return norm(cross(one, other)) > PARALLEL * norm(one) * norm(other);
}
