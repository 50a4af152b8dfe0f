/** Positions on graphs, surfaces of revolution, tubes and sweeps, computed number by number from their definitions: shares nothing with web/ but the
 * conventions. The frame of a tube or sweep needs its reference direction; where the definition has none, it is the z axis, which web/ tries first. */

import { add, compileDerivative, compileExpression, cross, scale, unit } from './reference.js';

/** @typedef {import('./reference.js').Vector} Vector */
/** @typedef {string | number} Expression */

/** What variables the ranges of a definition have, in the order of u and v. @type {Record<string, string[]>} */
const RANGES = { graph: ['x', 'y'], revolution: ['', 't'], tube: ['', 't'], sweep: ['s', 't'] };

/** @param {{ kind: string }} definition */
export const isShape = ({ kind }) => Object.hasOwn(RANGES, kind);

/** A parametric surface's ranges. @param {any} definition @returns {(readonly Expression[])[]} */
export const rangesOfShape = (definition) => RANGES[definition.kind].map((name) => (name ? definition[name] : [0, '2*pi']));

/**
 * The position as a function of u and v.
 * @param {any} definition
 * @returns {(place: ArrayLike<number>) => Vector}
 */
export function positionOnShape(definition) {
  const { kind, parameters } = definition;
  const read = (/** @type {Expression} */ source, /** @type {string[]} */ variables) => compileExpression(source, variables, parameters);
  if (kind === 'graph') {
    const height = read(definition.z, ['x', 'y']);
    return (place) => [place[0], place[1], height(place)];
  }
  if (kind === 'revolution') {
    const [radius, height] = [definition.r, definition.z].map((source) => read(source, ['u', 't']));
    return (place) => [radius(place) * Math.cos(place[0]), radius(place) * Math.sin(place[0]), height(place)];
  }
  const place = frameOf(kind === 'tube' ? definition.centreline : definition.path, definition);
  if (kind === 'sweep') {
    const [left, up] = definition.profile.map((/** @type {Expression} */ source) => read(source, ['s', 't']));
    return (at) => place(at[1], left(at), up(at));
  }
  const radius = read(definition.radius, ['u', 't']);
  return (at) => place(at[1], radius(at) * Math.cos(at[0]), radius(at) * Math.sin(at[0]));
}

/**
 * The point at t of a curve, so far to its left and so far up.
 * @param {readonly Expression[]} curve
 * @param {{ reference?: readonly Expression[], parameters?: Record<string, number> }} definition
 * @returns {(t: number, left: number, up: number) => Vector}
 */
function frameOf(curve, { reference = [0, 0, 1], parameters }) {
  const positions = curve.map((source) => compileExpression(source, ['t'], parameters));
  const slopes = curve.map((source) => compileDerivative(source, 0, ['t'], parameters));
  const references = reference.map((source) => compileExpression(source, ['t'], parameters));
  return (t, x, y) => {
    const [position, slope, upwards] = [positions, slopes, references].map((vector) => vector.map((component) => component([t])));
    const left = unit(cross(upwards, slope));
    return add(position, add(scale(left, x), scale(cross(unit(slope), left), y)));
  };
}
