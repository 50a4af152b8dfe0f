/** Meshes as the page draws them, or why there is nothing to draw. */

import { drawableMesh } from '../../web/view/drawable.js';
import { cross, subtract } from './vectors.js';

/** @typedef {import('surfpath').Surface} Surface */
/** @typedef {import('./tasks.js').Opened} Opened */
/** @typedef {import('../../web/view/drawable.js').SurfaceMesh} SurfaceMesh */

/** Cells a direction of what is carried along a curve, which is much longer than wide, of what has many waves, and of what has shores to be drawn. */
const FINE = 160;
/** A density that jumps. */
const JUMPS = /(?<![\p{L}\d_])(?:sign|floor)(?=\s*\()/u;
/** How far apart, in radians, the normals of neighbouring vertices are on average where waves are drawn with too few cells: the gallery's surfaces have up to 0.13. */
const WAVY = 0.2;
/** Places a direction of a box at which a formula is tried. */
const SAMPLES = 9;
/** Share of its box below which a surface is drawn in a smaller one. */
const TINY = 0.1;

/** @param {Opened} opened @param {number | undefined} resolution cells a direction; default: what suits it @param {import('surfpath').Surfpath} surfpath @returns {SurfaceMesh} */
export function meshOf(opened, resolution, surfpath) {
  const { drawn, definition } = opened;
  const isFine = ['tube', 'sweep'].includes(definition.kind) || (drawn.kind !== 'implicit' && JUMPS.test(definition.density));
  const wanted = resolution ?? (isFine ? FINE : undefined);
  const coarse = drawn.mesh(wanted ? { resolution: wanted } : {});
  const given = !wanted && isWavy(coarse) ? drawn.mesh({ resolution: FINE }) : coarse;
  const mesh = drawableMesh(drawn, given);
  const isSurface = hasArea(mesh);
  const bounds = isSurface && drawn.kind === 'implicit' && findTighter(mesh.positions, definition.bounds);
  if (bounds) return meshInside(surfpath, { ...definition, bounds }, resolution);
  if (isSurface) return mesh;
  throw new RangeError(drawn.kind === 'implicit' ? whyNowhere(drawn, definition.bounds) : whyNothing(given));
}

/** Whether a grid of vertices is too coarse for what it shows, along its lines or across. @param {SurfaceMesh} mesh */
function isWavy({ normals, parameters }) {
  const side = Math.sqrt(normals.length / 3);
  return parameters !== undefined && [3, 3 * side].some((step) => meanTurn(normals, step) > WAVY);
}

/** @param {Float64Array} normals @param {number} step from one to the next */
function meanTurn(normals, step) {
  let [sum, count] = [0, 0];
  for (let i = 0; i + step < normals.length; i += 3) {
    const [j, k] = [i + step, i + step + 1];
    const cosine = normals[i] * normals[j] + normals[i + 1] * normals[k] + normals[i + 2] * normals[k + 1];
    if (Number.isNaN(cosine)) continue;
    sum += Math.acos(Math.max(-1, Math.min(cosine, 1)));
    count++;
  }
  return sum / count;
}

/** Whether some triangle is one. @param {SurfaceMesh} mesh */
function hasArea({ positions, indices }) {
  const corner = (/** @type {number} */ i) => positions.subarray(3 * indices[i], 3 * indices[i] + 3);
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = [corner(i), corner(i + 1), corner(i + 2)];
    if (cross(subtract(b, a), subtract(c, a)).some((x) => x !== 0)) return true;
  }
  return false;
}

/** Why a mesh of formulas has nothing to draw. @param {SurfaceMesh} mesh */
function whyNothing({ positions }) {
  const hasPlaces = positions.some((_, i) => i % 3 === 0 && positions.subarray(i, i + 3).every(Number.isFinite));
  return hasPlaces
    ? 'the formulas give a point or a curve here, or what is too large to draw: change them'
    : 'the formula has no value anywhere in these ranges, as where it divides by 0: change it or the ranges';
}

/** Why no part of f = 0 was found in a box. @param {Surface} surface @param {number[][]} bounds */
function whyNowhere(surface, bounds) {
  const places = Array.from({ length: SAMPLES ** 3 }, (_, i) =>
    bounds.map(([low, high], k) => low + ((Math.floor(i / SAMPLES ** k) % SAMPLES) + 0.5) * ((high - low) / SAMPLES)),
  );
  const values = surface.evaluate(places.flat());
  return places.some((_, i) => Number.isFinite(values[4 * i]))
    ? 'f changes its sign nowhere inside these bounds: widen them or change the formula'
    : 'the formula has no value anywhere inside these bounds, as where it divides by 0: change it or the bounds';
}

/** The mesh of an implicit surface in another box. @param {import('surfpath').Surfpath} surfpath @param {any} definition @param {number} [resolution] @returns {SurfaceMesh} */
function meshInside(surfpath, definition, resolution) {
  const surface = surfpath.surface(definition);
  try {
    return meshOf({ surface, drawn: surface, definition }, resolution, surfpath);
  } finally {
    surface.dispose();
  }
}

/** A box around what was found, if that is so small in its box that it is a few cells wide. @param {Float64Array} positions @param {number[][]} bounds */
function findTighter(positions, bounds) {
  const box = bounds.map((_, k) => {
    let [low, high] = [Infinity, -Infinity];
    for (let i = k; i < positions.length; i += 3) [low, high] = [Math.min(low, positions[i]), Math.max(high, positions[i])];
    return [low, high];
  });
  const size = Math.max(...box.map(([low, high]) => high - low));
  const isSmall = box.every((_, k) => size < TINY * (bounds[k][1] - bounds[k][0]));
  return isSmall && size > 0 ? box.map(([low, high]) => [low - size / 2, high + size / 2]) : null;
}
