/** A number for each vertex of a mesh, to colour the surface by: Gaussian curvature, distance from A, or what length is multiplied by. */

import { meshOf } from './drawable.js';

/** @typedef {import('./drawable.js').SurfaceMesh} SurfaceMesh */
/** @typedef {{ values: Float32Array, low: number, high: number }} Shade values low … high, those of a sequence 0 … 1, of curvature −1 … 1 */

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
  return colour === 'curvature' ? curvatures(mesh) : stretches(opened, mesh, surfpath);
}

/** @param {import('./tasks.js').Opened} opened @param {number[]} from @returns {Shade} */
function distances({ surface, definition }, from) {
  if (surface.kind === 'metric' || definition.density || definition.metric)
    throw new RangeError('distances from a point are there only where space measures length');
  const along = ['tube', 'sweep'].includes(definition.kind) ? { resolution: 160 } : {};
  const { distances: found } = surface.distanceField(from, along);
  const high = found.reduce((most, x) => (Number.isFinite(x) && x > most ? x : most), 0);
  return { values: Float32Array.from(found, (x) => (Number.isFinite(x) ? x / high : -1)), low: 0, high };
}

/**
 * Gaussian curvature: the area that the normals sweep on the sphere over the area of the triangles around a vertex. The normals are exact, so this is
 * good to the size of a cell.
 * @param {SurfaceMesh} mesh @returns {Shade}
 */
function curvatures({ positions, normals, indices }) {
  const count = positions.length / 3;
  const [swept, area] = [new Float64Array(count), new Float64Array(count)];
  for (let i = 0; i < indices.length; i += 3) {
    const corners = indices.subarray(i, i + 3);
    const on = signedArea(normals, normals, corners);
    const off = signedArea(positions, normals, corners);
    for (const corner of corners) {
      swept[corner] += on;
      area[corner] += off;
    }
  }
  const values = swept.map((x, i) => (Math.abs(area[i]) > 0 ? x / area[i] : 0));
  const sizes = values.map(Math.abs).sort();
  const typical = sizes[Math.floor(0.8 * (count - 1))];
  const flat = typical < 1e-6 / Math.max(extentOf(positions) ** 2, 1e-12);
  const [low, high] = values.reduce(([a, b], x) => [Math.min(a, x), Math.max(b, x)], [Infinity, -Infinity]);
  return { values: Float32Array.from(values, (x) => (flat ? 0 : (1.6 * x) / (Math.abs(x) + typical))), low, high };
}

/** @param {Float64Array} positions */
const extentOf = (positions) => positions.reduce((most, x) => Math.max(most, Math.abs(x)), 0);

/** Twice the area of a triangle along its normal. @param {Float64Array} of @param {Float64Array} normals @param {Uint32Array} corners */
function signedArea(of, normals, [a, b, c]) {
  const edge = (/** @type {number} */ to) => [0, 1, 2].map((k) => of[3 * to + k] - of[3 * a + k]);
  const [p, q] = [edge(b), edge(c)];
  const n = [0, 1, 2].map((k) => normals[3 * a + k] + normals[3 * b + k] + normals[3 * c + k]);
  return n[0] * (p[1] * q[2] - p[2] * q[1]) + n[1] * (p[2] * q[0] - p[0] * q[2]) + n[2] * (p[0] * q[1] - p[1] * q[0]);
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
  return scaled(values);
}

/** On a logarithmic scale from the least to the greatest. @param {Float64Array} values @returns {Shade} */
function scaled(values) {
  const finite = values.filter((x) => Number.isFinite(x) && x > 0);
  const [low, high] = finite.reduce(([a, b], x) => [Math.min(a, x), Math.max(b, x)], [Infinity, -Infinity]);
  const span = Math.log(high / low);
  return { values: Float32Array.from(values, (x) => (span > 1e-9 && x > 0 ? Math.log(x / low) / span : 0)), low, high };
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
