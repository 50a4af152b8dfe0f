/** A number for each vertex of a mesh, to colour the surface by: Gaussian curvature, distance from A, or what length is multiplied by. */

import { gaussianCurvature } from '../../web/view/curvature.js';
import { coordinates } from '../state/definition.js';
import { measureDistances } from './distances.js';
import { meshOf } from './drawable.js';
import { NAMES } from '../state/names.js';
import { runInSlices } from './slices.js';
import { soften } from './soften.js';
import { determinantOf, tangentForm, Tensor } from './tensor.js';

/** @typedef {import('./drawable.js').SurfaceMesh} SurfaceMesh */
/** @typedef {Float64Array} Shade a number a vertex; NaN where there is none */

/**
 * @param {import('./tasks.js').Opened} opened
 * @param {{ colour: string, from: number[], resolution?: number }} request
 * @param {import('./slices.js').Job} job hears of a shade that is there before the exact one
 * @param {import('surfpath').Surfpath} surfpath
 * @returns {Shade | Promise<Shade | null>} null: it was stopped
 */
export function shade(opened, { colour, from, resolution }, job, surfpath) {
  const mesh = meshOf(opened, resolution, surfpath);
  if (colour === 'distance') return distances(opened.surface, from, job, mesh);
  return colour === 'curvature'
    ? gaussianCurvature(/** @type {any} */ (opened.drawn), mesh.parameters ?? mesh.positions)
    : stretches(opened, mesh, surfpath);
}

/** @param {import('surfpath').Surface} surface @param {number[]} from @param {import('./slices.js').Job} job @param {SurfaceMesh} drawn */
async function distances(surface, from, job, { positions, parameters, twins = [] }) {
  if (surface.kind === 'metric') throw new RangeError('distances from a point are there only for surfaces in space');
  // The vertices that are drawn: of a rectangle a square grid, and twins.
  const cells = Math.sqrt(positions.length / 3 - twins.length) - 1;
  const { mesh, distances: rough } = surface.distanceField(from, parameters ? { resolution: cells } : {});
  const withTwins = (/** @type {Shade} */ shade) => Float64Array.from([...shade, ...twins.map((i) => shade[i])]);
  job.report({ shade: withTwins(rough) });
  const start = surface.kind === 'implicit' ? surface.project(from, from) : from;
  const exact = await runInSlices(measureDistances(surface, start, mesh, rough), job);
  return exact && withTwins(exact);
}

/** By how much length is multiplied, the mean of all directions. @param {import('./tasks.js').Opened} opened @param {SurfaceMesh} mesh @param {import('surfpath').Surfpath} surfpath */
function stretches({ definition, drawn }, mesh, surfpath) {
  const { density, metric, kind } = definition;
  const ranges = drawn.domain ?? { u: [0, 1], v: [0, 1] };
  const tensor = kind === 'metric' ? definition : metric;
  const values =
    density === undefined
      ? new Float64Array(mesh.positions.length / 3).fill(1)
      : drawnDensities({ definition, drawn }, ranges, mesh, surfpath);
  // Where length counts nothing, or less, it is not measured.
  const positive = values.map((x) => (x > 0 ? x : Number.NaN));
  if (!tensor) return positive;
  const areas = mesh.parameters
    ? areasInPlane(tensor, definition, ranges, mesh.parameters, surfpath)
    : areasInSpace(definition, mesh, surfpath);
  return positive.map((x, i) => x * areas[i] ** 0.25);
}

/** ρ at the vertices, softened where it jumps. @param {Pick<import('./tasks.js').Opened, 'definition' | 'drawn'>} opened @param {{ u: number[], v: number[] }} ranges @param {SurfaceMesh} mesh @param {import('surfpath').Surfpath} surfpath */
function drawnDensities({ definition, drawn }, ranges, mesh, surfpath) {
  const values = densities(definition, ranges, mesh, surfpath);
  if (!mesh.parameters || drawn.kind !== 'parametric') return values;
  return soften(values, mesh.parameters, mesh.twins ?? [], ranges, (parameters) => {
    const seen = drawn.evaluate(parameters);
    const positions = Float64Array.from({ length: (3 * parameters.length) / 2 }, (_, i) => seen[6 * Math.floor(i / 3) + (i % 3)]);
    return densities(definition, ranges, { parameters, positions }, surfpath);
  });
}

/** EG − F² of a metric over u and v; NaN where there is no length. @param {any} tensor @param {any} definition @param {{ u: number[], v: number[] }} ranges @param {Float64Array} places u v … @param {import('surfpath').Surfpath} surfpath */
function areasInPlane(tensor, definition, { u, v }, places, surfpath) {
  const [E, F, G] = [tensor.E, tensor.F, tensor.G].map((text) => inPlane(String(text), definition));
  const surface = surfpath.metric({ E, F, G, u: [u[0], u[1]], v: [v[0], v[1]], parameters: definition.parameters });
  const entries = surface.evaluate(places);
  surface.dispose();
  return Float64Array.from({ length: places.length / 2 }, (_, i) => determinantOf(entries[3 * i], entries[3 * i + 1], entries[3 * i + 2]));
}

/** EG − F² of a metric of space, along the surface; NaN where there is no length. @param {any} definition @param {SurfaceMesh} mesh @param {import('surfpath').Surfpath} surfpath */
function areasInSpace({ metric, parameters }, { positions, normals }, surfpath) {
  const tensor = new Tensor(surfpath, metric, parameters);
  const entries = tensor.evaluate(positions);
  tensor.dispose();
  return Float64Array.from({ length: positions.length / 3 }, (_, i) => {
    const { E, F, G } = tangentForm(entries.subarray(6 * i, 6 * i + 6), normals.subarray(3 * i, 3 * i + 3));
    return determinantOf(E, F, G);
  });
}

/** A formula with u and v in place of what the kind calls them. @param {string} text @param {any} definition */
function inPlane(text, { kind, parameters }) {
  const names = coordinates(kind);
  return text.replace(NAMES, (name) => {
    const place = names.indexOf(name);
    return place < 0 || Object.hasOwn(parameters, name) ? name : 'uv'[place];
  });
}

/**
 * ρ at the vertices: a formula of x, y, z as an implicit surface, one of u and v as a height; of both, with the positions' formulas in place of x, y, z.
 * @param {any} definition @param {{ u: number[], v: number[] }} ranges @param {Pick<SurfaceMesh, 'positions' | 'parameters'>} mesh @param {import('surfpath').Surfpath} surfpath
 */
function densities(definition, { u, v }, mesh, surfpath) {
  const { density, kind, parameters } = definition;
  if (!mesh.parameters) return every(surfpath.implicit({ f: density, parameters }), mesh.positions, 4, 0);
  const height = (/** @type {string} */ text) =>
    every(
      surfpath.parametric({ x: text, y: 0, z: 0, u: [u[0], u[1]], v: [v[0], v[1]], parameters, periodic: {} }),
      mesh.parameters ?? [],
      6,
      0,
    );
  if (kind !== 'parametric') {
    const inSpace = String(density)
      .match(NAMES)
      ?.some((name) => ['x', 'y', 'z'].includes(name) && !coordinates(kind).includes(name));
    return inSpace
      ? every(surfpath.implicit({ f: density, parameters }), mesh.positions, 4, 0)
      : height(inPlane(String(density), definition));
  }
  const hidden = (/** @type {string} */ name) => !['x', 'y', 'z'].includes(name) || Object.hasOwn(parameters, name);
  return height(String(density).replace(NAMES, (name) => (hidden(name) ? name : `(${definition[name]})`)));
}

/** One of several values at each point. @param {import('surfpath').Surface} surface disposed @param {ArrayLike<number>} points @param {number} stride @param {number} which */
function every(surface, points, stride, which) {
  const values = surface.evaluate(points);
  surface.dispose();
  return Float64Array.from({ length: values.length / stride }, (_, i) => values[stride * i + which]);
}
