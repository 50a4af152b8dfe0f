/**
 * Paths across creases beside poles, where the rectangle's coordinates turn, and what vanishes on a crease vanishes on all of the edge that is the pole. They are looked for over the plane around a pole.
 * MATH.md, "Creases at poles".
 */

import { holdsPoint } from '../manifold/domain.js';
import { edgeOf } from '../manifold/rectangle.js';
import { replaced } from '../search/join.js';
import { passedTip, SHARP } from '../search/poles.js';
import { nodesOf } from './legs.js';

/** @typedef {import('../path.js').Path} Path */
/** @typedef {import('../search/routes.js').Field} Field */
/** @typedef {import('../manifold/domain.js').Domain} Domain */
/** @typedef {import('../pieces/pieces.js').Start} Start */
/**
 * @typedef {object} Flattened a surface over the plane around a pole
 * @property {Field} field
 * @property {(places: ArrayLike<number>) => Float64Array} into places of the rectangle over the plane
 * @property {(places: ArrayLike<number>, ends: number[][]) => Float64Array} back a path over the plane in the rectangle, between these ends
 */

/** The poles around which a coordinate closes. @param {Domain | null} domain */
export const polesOf = (domain) => (domain ? domain.poles.filter((pole) => domain.periodic[edgeOf(pole).along]) : []);

/** The pole that a line passes, turning sharply from node to node; none if it passes none. @param {Domain | null} domain @param {ArrayLike<number> | null} line of the rectangle @returns {number[]} */
export function poleBeside(domain, line) {
  const passed = domain && line && passedTip(domain, line, SHARP);
  return polesOf(domain).filter((pole) => pole === passed?.pole);
}

/**
 * Paths found over the plane around a pole: those that lie in the rectangle.
 * @param {Field} field @param {number[][]} ends @param {Start} start @param {number} pole
 * @param {(field: Field, ends: number[][], start: Start) => Path[]} find
 * @returns {Path[]}
 */
export function findAtPole(field, ends, start, pole, find) {
  const flat = field.flattened?.(pole);
  const { domain } = field;
  if (!flat || !domain) return [];
  const places = ends.map((end) => [...flat.into(end)]);
  const line = start && start !== 'global' ? flat.into(start) : start;
  return find(flat.field, places, line).flatMap((path) => {
    if (!path.converged || path.touchesBoundary) return [];
    const lifted = replaced(path, (numbers, width) => (width === 2 ? flat.back(numbers, ends) : numbers));
    const nodes = nodesOf(lifted.parameters ?? [], 2);
    return nodes.length > 0 && nodes.every((node) => holdsPoint(domain, node)) ? lifted : [];
  });
}

/**
 * Paths of which those that pass poles are the ones found over the planes around these.
 * @param {Field} field @param {Path[]} paths @param {(pole: number) => Path[]} around
 */
export function withPoles({ domain }, paths, around) {
  const passes = (/** @type {Path} */ { parameters }, /** @type {number} */ pole) => poleBeside(domain, parameters).includes(pole);
  for (const pole of polesOf(domain).filter((pole) => paths.some((path) => passes(path, pole)))) {
    const found = around(pole).filter((path) => passes(path, pole));
    if (found.length > 0) paths = [...found, ...paths.filter((path) => !passes(path, pole))];
  }
  return paths.sort((a, b) => a.length - b.length);
}
