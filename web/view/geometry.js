/** A surface as three.js geometry: its mesh with exact normals, texture coordinates, and colours that show a quantity. */

import { Box3, BufferAttribute, BufferGeometry, Sphere, Vector3 } from 'three';
import { checkOptions, refuse, refuseName } from '../arguments.js';
import { checkDrawable } from './check.js';
import { bandScale, colourVertices, contourLevels, curvatureScale } from './colouring.js';
import { gaussianCurvature } from './curvature.js';
import { LARGEST } from './cuts.js';
import { drawableMesh } from './drawable.js';
import { FarGeometry } from './far.js';
import { originOf } from './origin.js';

/** @typedef {import('../surface.js').Surface} Surface */
/** @typedef {import('../mesh/mesh.js').Mesh} Mesh */
/** @typedef {import('./drawable.js').SurfaceMesh} SurfaceMesh */
/** @typedef {import('./colouring.js').ColourScale} ColourScale */

/**
 * @typedef {object} GeometryOptions
 * @property {number} [resolution] cells a direction, as for `surface.mesh`
 * @property {'none' | 'curvature' | 'distance' | ((mesh: Mesh) => ArrayLike<number>)} [colour] 'curvature': Gaussian curvature, zero neutral; 'distance': geodesic
 *   distance `from` a point; or a function that gives one number a vertex of the mesh as it is drawn, NaN: grey; default 'none'
 * @property {ArrayLike<number>} [from] 'distance': u v or x y z
 * @property {boolean} [exact] 'distance': as for `surface.distanceField`
 */

/** Cells between parameter lines along the surface's longer side. */
const CELLS = 22;
/** So many lines tell how long they are: of all this would take long while a page opens. */
const LINES = 12;
const NAMES = ['resolution', 'colour', 'from', 'exact'];

/** How long some of the lines of a grid are, between vertices a step apart. @param {Float64Array} positions @param {number} side vertices a side @param {number} step @param {number} across */
function gridLength(positions, side, step, across) {
  const stride = Math.ceil(side / LINES);
  let sum = 0;
  for (let line = 0; line < side; line += stride)
    for (let i = 1; i < side; i++) {
      const [a, b] = [3 * (line * across + (i - 1) * step), 3 * (line * across + i * step)];
      const length = Math.hypot(positions[b] - positions[a], positions[b + 1] - positions[a + 1], positions[b + 2] - positions[a + 2]);
      if (Number.isFinite(length)) sum += length;
    }
  return sum;
}

/** Vertices a side of a mesh that begins with a square grid. @param {Float64Array} parameters */
const sideOf = (parameters) => parameters.findIndex((x, i) => i % 2 === 1 && x !== parameters[1]) >> 1;

/** How many cells between parameter lines in both directions make them about square. @param {Float64Array} positions of a square grid @param {number} side */
function countCells(positions, side) {
  const lengths = [gridLength(positions, side, 1, side), gridLength(positions, side, side, 1)];
  const longer = Math.max(...lengths) || 1;
  return lengths.map((length) => Math.max(4, 2 * Math.round((CELLS * length) / longer / 2)));
}

/** The parameters as shares of their ranges. @param {Float64Array} parameters of a square grid @param {number} side */
function textureCoordinates(parameters, side) {
  const [low, high] = [parameters.subarray(0, 2), parameters.subarray(2 * side * side - 2)];
  return new Float32Array(parameters.map((x, i) => (x - low[i & 1]) / (high[i & 1] - low[i & 1])));
}

/** The numbers that colours are to show, and their scale. @param {Surface} surface @param {SurfaceMesh} mesh @param {Float64Array | undefined} distances @param {GeometryOptions['colour']} colour @param {number} size */
function measure(surface, mesh, distances, colour, size) {
  if (distances) {
    const values = Float64Array.from([...distances, ...(mesh.twins ?? []).map((i) => distances[i])]);
    return { values, scale: bandScale('distance', values) };
  }
  if (colour === 'curvature') {
    const values = gaussianCurvature(surface, mesh.parameters ?? mesh.positions);
    return { values, scale: curvatureScale(values, size) };
  }
  if (typeof colour !== 'function') return null;
  const values = colour(mesh);
  const count = mesh.positions.length / 3;
  if (values?.length !== count) throw new RangeError(`surfaceGeometry: options.colour must give ${count} numbers, one a vertex`);
  const odd = Array.prototype.findIndex.call(values, (x) => typeof x !== 'number');
  if (odd >= 0) refuse('surfaceGeometry: what options.colour gives', 'numbers', values[odd]);
  return { values, scale: bandScale('values', values) };
}

/** What `computeBoundingSphere` finds, about the middle of the box, without a call a number: that takes long while a page opens. @param {ArrayLike<number>} positions x y z of each vertex */
function sphereAround(positions) {
  const center = new Box3().setFromArray(/** @type {number[]} */ (positions)).getCenter(new Vector3());
  const { x, y, z } = center;
  let squared = 0;
  for (let i = 0; i < positions.length; i += 3)
    squared = Math.max(squared, (positions[i] - x) ** 2 + (positions[i + 1] - y) ** 2 + (positions[i + 2] - z) ** 2);
  return new Sphere(center, Math.sqrt(squared));
}

/** A mesh as geometry, without colours. @param {SurfaceMesh} mesh */
export function bareGeometry(mesh) {
  const isFar = originOf(mesh.positions).some((x) => x !== 0);
  const geometry = isFar ? new FarGeometry(mesh.positions) : new BufferGeometry();
  if (!isFar) geometry.setAttribute('position', new BufferAttribute(new Float32Array(mesh.positions), 3));
  geometry.setAttribute('normal', new BufferAttribute(new Float32Array(mesh.normals), 3));
  geometry.setIndex(new BufferAttribute(mesh.indices, 1));
  geometry.boundingSphere = sphereAround(isFar ? mesh.positions : geometry.getAttribute('position').array);
  geometry.userData.isOneSided = mesh.isOneSided === true;
  if (!mesh.parameters) return geometry;
  const side = sideOf(mesh.parameters);
  geometry.setAttribute('uv', new BufferAttribute(textureCoordinates(mesh.parameters, side), 2));
  geometry.userData.cells = countCells(mesh.positions, side);
  return geometry;
}

/**
 * Makes the geometry of a surface: attributes `position`, `normal` (exact, not averaged), parametric `uv` (shares of the parameters' ranges) and, coloured,
 * `color` and `contour` (contour lines run where it is whole). `userData.scale` tells what the colours mean, `userData.cells` how many parameter lines
 * suit it; {@link surfaceMaterial} draws both. Costs an evaluation a vertex; 'distance' a graph search too. Dispose it as any geometry.
 *
 * Throws TypeError for a surface without positions (kind 'metric'), RangeError for one too large to be drawn, and what `surface.mesh` and `surface.distanceField` throw.
 * @param {Surface} surface
 * @param {GeometryOptions} [options]
 * @returns {BufferGeometry}
 */
export function surfaceGeometry(surface, options = {}) {
  const caller = 'surfaceGeometry';
  checkDrawable(caller, surface);
  checkOptions(caller, options, NAMES);
  const { resolution, colour = 'none', from, exact } = options;
  if (typeof colour !== 'function' && !['none', 'curvature', 'distance'].includes(colour))
    refuseName(`${caller}: options.colour`, "'none', 'curvature', 'distance' or a function", colour);
  if (colour === 'distance' && from === undefined) throw new TypeError(`${caller}: options.colour 'distance' needs options.from, a point`);
  const field = colour === 'distance' ? surface.distanceField(/** @type {ArrayLike<number>} */ (from), { resolution, exact }) : null;
  const whole = field ? field.mesh : surface.mesh({ resolution });
  // A pole may be as far as it likes, but not a coordinate of half the vertices.
  const { positions } = whole;
  if (positions.filter((x) => Math.abs(x) > LARGEST).length > positions.length / 6)
    throw new RangeError(`${caller}: most of the surface lies beyond 1e18, too far for 32 bits: use a larger unit`);
  const mesh = drawableMesh(surface, whole);
  const geometry = bareGeometry(mesh);
  const size = geometry.boundingSphere?.radius || 1;
  const measured = measure(surface, mesh, field?.distances, colour, size);
  if (measured) {
    geometry.setAttribute('color', new BufferAttribute(colourVertices(measured.values, measured.scale), 3));
    geometry.setAttribute('contour', new BufferAttribute(contourLevels(measured.values, measured.scale), 1));
    geometry.userData.scale = measured.scale;
  }
  return geometry;
}
