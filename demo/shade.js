/** A number for each vertex of a mesh, to colour the surface by: Gaussian curvature, distance from A, or what length is multiplied by. */

import { gaussianCurvature } from '../web/view/curvature.js';
import { meshOf } from './drawable.js';

/** @typedef {import('./drawable.js').SurfaceMesh} SurfaceMesh */
/** @typedef {Float64Array} Shade a number a vertex; NaN where there is none */

const WORD = /(?:(?!π)[\p{L}_])(?:(?!π)[\p{L}\d_₀-₉])*/gu;

/**
 * @param {import('./tasks.js').Opened} opened
 * @param {{ colour: string, from: number[], resolution?: number }} request
 * @param {import('surfpath').Surfpath} surfpath
 * @returns {Shade}
 */
export function shade(opened, { colour, from, resolution }, surfpath) {
  if (colour === 'distance') return distances(opened, from);
  const mesh = meshOf(opened, resolution);
  return colour === 'curvature'
    ? gaussianCurvature(/** @type {any} */ (opened.drawn), mesh.parameters ?? mesh.positions)
    : stretches(opened, mesh, surfpath);
}

/** @param {import('./tasks.js').Opened} opened @param {number[]} from @returns {Shade} */
function distances({ surface, definition }, from) {
  if (surface.kind === 'metric' || definition.density || definition.metric)
    throw new RangeError('distances from a point are there only where space measures length');
  const along = ['tube', 'sweep'].includes(definition.kind) ? { resolution: 160 } : {};
  const { distances: found } = surface.distanceField(from, along);
  return found;
}

/** By how much length is multiplied, the mean of all directions. @param {import('./tasks.js').Opened} opened @param {SurfaceMesh} mesh @param {import('surfpath').Surfpath} surfpath */
function stretches({ definition }, mesh, surfpath) {
  const { density, metric, kind, u, v, parameters } = definition;
  const factor = density === undefined ? null : densities(definition, mesh, surfpath);
  const tensor = kind === 'metric' ? definition : metric;
  let values = factor ?? new Float64Array(mesh.positions.length / 3).fill(1);
  if (tensor && mesh.parameters) {
    const surface = surfpath.metric({ E: tensor.E, F: tensor.F, G: tensor.G, u, v, parameters });
    const entries = surface.evaluate(mesh.parameters);
    surface.dispose();
    values = values.map((x, i) => x * Math.max(entries[3 * i] * entries[3 * i + 2] - entries[3 * i + 1] ** 2, 0) ** 0.25);
  }
  return values;
}

/** ρ at the vertices: of x, y, z as an implicit formula, of u, v as a height; of both with the positions' formulas in place of x, y, z. @param {any} definition @param {SurfaceMesh} mesh @param {import('surfpath').Surfpath} surfpath */
function densities({ density, kind, x, y, z, u, v, parameters }, mesh, surfpath) {
  const names = new Set(String(density).match(WORD));
  const inSpace = ['x', 'y', 'z'].some((name) => names.has(name) && !Object.hasOwn(parameters, name));
  if (!mesh.parameters || !(inSpace && kind === 'parametric')) {
    if (!mesh.parameters || inSpace) return every(surfpath.implicit({ f: density, parameters }), mesh.positions, 4, 0);
    return every(surfpath.parametric({ x: density, y: 0, z: 0, u, v, parameters, periodic: {} }), mesh.parameters, 6, 0);
  }
  const positions = /** @type {Record<string, unknown>} */ ({ x, y, z });
  const replaced = String(density).replace(WORD, (name) =>
    name in positions && !Object.hasOwn(parameters, name) ? `(${positions[name]})` : name,
  );
  return every(surfpath.parametric({ x: replaced, y: 0, z: 0, u, v, parameters, periodic: {} }), mesh.parameters, 6, 0);
}

/** One of several values at each point. @param {import('surfpath').Surface} surface disposed @param {Float64Array} points @param {number} stride @param {number} which */
function every(surface, points, stride, which) {
  const values = surface.evaluate(points);
  surface.dispose();
  return Float64Array.from({ length: values.length / stride }, (_, i) => values[stride * i + which]);
}
