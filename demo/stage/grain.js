/** A metric drawn on its surface: short strokes in the direction in which length counts least, where it depends on the direction. */

import { tangentForm } from '../compute/tensor.js';
import { along } from '../compute/vectors.js';

/** @typedef {import('surfpath').Surface} Surface */
/** @typedef {import('../compute/drawable.js').SurfaceMesh} SurfaceMesh */

/** Strokes a direction of the rectangle, or of the surface's box. */
const STROKES = 22;
/** Length of a stroke, in parts of the distance between two. */
const SHARE = 0.62;
/** Ratio of the greatest to the least factor, squared, from which a direction can be seen. */
const VISIBLE = 1.15;
/** Vertices that are looked at, of many. */
const ENOUGH = 20_000;
/** Steps that bring both ends of a stroke back onto a curved surface. */
const STEPS = 2;

/** The direction of the smaller eigenvalue of E, F, G, and by how much the greater one is greater. @param {number} E @param {number} F @param {number} G */
function easiest(E, F, G) {
  const [mean, half] = [(E + G) / 2, Math.hypot((E - G) / 2, F)];
  const angle = Math.atan2(2 * F, E - G) / 2 + Math.PI / 2;
  return { direction: [Math.cos(angle), Math.sin(angle)], ratio: (mean + half) / (mean - half) };
}

/** Both ends of each stroke of a metric E, F, G, x y z. @param {Surface} gauge the metric @param {Surface} drawn @returns {Float64Array} */
export function planeStrokes(gauge, drawn) {
  const { u, v } = /** @type {NonNullable<Surface['domain']>} */ (drawn.domain);
  const cell = [(u[1] - u[0]) / STROKES, (v[1] - v[0]) / STROKES];
  const places = Array.from({ length: STROKES ** 2 }, (_, i) => [
    u[0] + ((i % STROKES) + 0.5) * cell[0],
    v[0] + (Math.floor(i / STROKES) + 0.5) * cell[1],
  ]);
  const metric = gauge.evaluate(Float64Array.from(places.flat()));
  const size = (SHARE * Math.min(...cell)) / 2;
  const ends = places.flatMap((place, i) => {
    const { direction, ratio } = easiest(metric[3 * i], metric[3 * i + 1], metric[3 * i + 2]);
    if (!(ratio > VISIBLE)) return [];
    return [-size, size].flatMap((step) => place.map((x, k) => x + step * direction[k]));
  });
  const values = drawn.evaluate(Float64Array.from(ends));
  return Float64Array.from({ length: values.length / 2 }, (_, i) => values[6 * Math.floor(i / 3) + (i % 3)]);
}

/** Vertices about as far from each other as strokes are: one in each cell of a lattice. @param {Float64Array} positions @param {number} cell @returns {number[]} */
function spreadVertices(positions, cell) {
  const count = positions.length / 3;
  /** @type {Map<string, number>} */
  const found = new Map();
  for (let i = 0, stride = Math.ceil(count / ENOUGH); i < count; i += stride) {
    const key = [0, 1, 2].map((k) => Math.floor(positions[3 * i + k] / cell)).join();
    if (!found.has(key)) found.set(key, i);
  }
  return [...found.values()];
}

/** Both ends of each stroke of a metric of space on an implicit surface, x y z. @param {import('../compute/tensor.js').Tensor} gauge @param {Surface} surface @param {SurfaceMesh} mesh @returns {Float64Array} */
export function spaceStrokes(gauge, surface, { positions, normals }) {
  const cell = sizeOf(positions) / STROKES;
  const vertices = spreadVertices(positions, cell);
  const places = vertices.map((i) => positions.subarray(3 * i, 3 * i + 3));
  const tensors = gauge.evaluate(Float64Array.from(places.flatMap((place) => [...place])));
  const size = (SHARE * cell) / 2;
  const ends = places.flatMap((place, i) => {
    const { a, b, E, F, G } = tangentForm(tensors.subarray(6 * i, 6 * i + 6), normals.subarray(3 * vertices[i], 3 * vertices[i] + 3));
    const { direction, ratio } = easiest(E, F, G);
    if (!(ratio > VISIBLE)) return [];
    return [-size, size].flatMap((step) => along(along(place, step * direction[0], a), step * direction[1], b));
  });
  return ontoSurface(surface, Float64Array.from(ends));
}

/** The longest side of the box around points. @param {Float64Array} positions */
function sizeOf(positions) {
  const [low, high] = [
    [Infinity, Infinity, Infinity],
    [-Infinity, -Infinity, -Infinity],
  ];
  for (let i = 0; i < positions.length; i++) {
    low[i % 3] = Math.min(low[i % 3], positions[i]);
    high[i % 3] = Math.max(high[i % 3], positions[i]);
  }
  return Math.max(...high.map((x, k) => x - low[k]));
}

/** Points near a surface f = 0 moved onto it, by Newton's method. @param {Surface} surface @param {Float64Array} points changed in place */
function ontoSurface(surface, points) {
  for (let step = 0; step < STEPS; step++) {
    const values = surface.evaluate(points);
    for (let i = 0; i < points.length / 3; i++) {
      const [f, fx, fy, fz] = values.subarray(4 * i, 4 * i + 4);
      const share = f / (fx * fx + fy * fy + fz * fz);
      if (Number.isFinite(share)) for (const [k, slope] of [fx, fy, fz].entries()) points[3 * i + k] -= share * slope;
    }
  }
  return points;
}
