/** Meshes of implicit surfaces, finer where these bend within a cell: along the rim of a flat body, or a crease, whole cells would be shaded from side to side. */

import { dot, gap } from '../vector.js';

/** @typedef {import('./drawable.js').SurfaceMesh} SurfaceMesh */
/** @typedef {(places: Float64Array) => Float64Array} Evaluate f and its gradient at each x y z */

/** An edge is halved where the normals of its ends turn by more than 35 degrees, so often: half a turn is an eighth of it then. */
const [TURNED, ROUNDS] = [Math.cos((35 * Math.PI) / 180), 3];
/** Steps of Newton's method that bring the middle of an edge to the surface. */
const STEPS = 6;

/** @param {SurfaceMesh} mesh @param {Evaluate} evaluate @returns {SurfaceMesh} the same vertices, then others, each beside one of these */
export function refineRims(mesh, evaluate) {
  let refined = mesh;
  for (let round = 0; round < ROUNDS; round++) refined = halve(refined, evaluate);
  return refined;
}

/** @param {SurfaceMesh} mesh @param {Evaluate} evaluate @returns {SurfaceMesh} */
function halve(mesh, evaluate) {
  const { positions, normals, indices, twins = [] } = mesh;
  const count = positions.length / 3;
  const keyOf = (/** @type {number} */ a, /** @type {number} */ b) => Math.min(a, b) * count + Math.max(a, b);
  const ends = bentEdges(mesh, keyOf);
  const middles = middlesOf(positions, ends, evaluate);
  /** The new vertex on an edge. @type {Map<number, number>} */ const cuts = new Map();
  /** Whether there is one on some edge of a vertex. */
  const marks = new Uint8Array(count);
  const found = middles.flatMap((middle, i) => {
    if (!middle) return [];
    const [one, other] = [ends[2 * i], ends[2 * i + 1]];
    marks[one] = marks[other] = 1;
    cuts.set(keyOf(one, other), count + cuts.size);
    const first = count - twins.length;
    return [{ ...middle, twin: one < first ? one : twins[one - first] }];
  });
  if (found.length === 0) return mesh;
  return {
    ...mesh,
    positions: extended(
      positions,
      found.flatMap(({ place }) => place),
    ),
    normals: extended(
      normals,
      found.flatMap(({ normal }) => normal),
    ),
    indices: cutTriangles(indices, marks, (a, b) => cuts.get(keyOf(a, b))),
    twins: [...twins, ...found.map(({ twin }) => twin)],
  };
}

/** @param {Float64Array} list @param {number[]} added */
function extended(list, added) {
  const longer = new Float64Array(list.length + added.length);
  longer.set(list);
  longer.set(added, list.length);
  return longer;
}

/** Both ends of each edge whose normals are turned to different sides. @param {SurfaceMesh} mesh @param {(a: number, b: number) => number} keyOf */
function bentEdges({ normals, indices }, keyOf) {
  /** @type {Set<number>} */ const known = new Set();
  /** @type {number[]} */ const ends = [];
  for (let i = 0; i < indices.length; i++) {
    const [one, other] = [indices[i], indices[i % 3 === 2 ? i - 2 : i + 1]];
    const [a, b] = [3 * one, 3 * other];
    if (!(normals[a] * normals[b] + normals[a + 1] * normals[b + 1] + normals[a + 2] * normals[b + 2] < TURNED)) continue;
    const key = keyOf(one, other);
    if (!known.has(key)) ends.push(one, other);
    known.add(key);
  }
  return ends;
}

/** Middles of edges, moved onto the surface; null where that leads far away. @param {Float64Array} positions @param {number[]} ends @param {Evaluate} evaluate */
function middlesOf(positions, ends, evaluate) {
  const at = (/** @type {number} */ i) => positions.subarray(3 * ends[i], 3 * ends[i] + 3);
  const places = new Float64Array((3 * ends.length) / 2);
  for (let i = 0; i < ends.length; i += 2)
    for (let k = 0; k < 3; k++) places[(3 * i) / 2 + k] = (positions[3 * ends[i] + k] + positions[3 * ends[i + 1] + k]) / 2;
  const begin = places.slice();
  let values = evaluate(places);
  for (let step = 0; step < STEPS; step++) {
    for (let i = 0, j = 0; i < places.length; i += 3, j += 4) {
      const [f, x, y, z] = values.subarray(j, j + 4);
      const share = f / (x * x + y * y + z * z);
      for (const [k, slope] of [x, y, z].entries()) places[i + k] -= share * slope;
    }
    values = evaluate(places);
  }
  const longest = ends.reduce((most, _, i) => (i % 2 ? most : Math.max(most, gap(at(i), at(i + 1)))), 0);
  return Array.from({ length: ends.length / 2 }, (_, i) => {
    const [place, before] = [places, begin].map((list) => list.subarray(3 * i, 3 * i + 3));
    const gradient = values.subarray(4 * i + 1, 4 * i + 4);
    const length = Math.sqrt(dot(gradient, gradient));
    const isNear = gap(place, before) <= longest && length > 0;
    return isNear ? { place: [...place], normal: Array.from(gradient, (x) => x / length) } : null;
  });
}

/** Triangles with new vertices on some of their edges. @param {Uint32Array} indices @param {Uint8Array} marks @param {(a: number, b: number) => number | undefined} cutOf */
function cutTriangles(indices, marks, cutOf) {
  /** @type {number[]} */ const result = [];
  for (let i = 0; i < indices.length; i += 3) {
    const corners = [indices[i], indices[i + 1], indices[i + 2]];
    const mayBe = marks[corners[0]] + marks[corners[1]] + marks[corners[2]] > 1;
    const cuts = mayBe ? corners.map((corner, k) => cutOf(corner, corners[(k + 1) % 3])) : [];
    const count = cuts.filter((cut) => cut !== undefined).length;
    if (count === 0) {
      result.push(...corners);
      continue;
    }
    // Turned so that the first edge is the only one that is cut, or that is not.
    const first = cuts.findIndex((cut) => (cut === undefined) === (count === 2));
    const [a, b, c] = [0, 1, 2].map((k) => corners[(Math.max(first, 0) + k) % 3]);
    const [ab, bc, ca] = [0, 1, 2].map((k) => /** @type {number} */ (cuts[(Math.max(first, 0) + k) % 3]));
    if (count === 1) result.push(a, ab, c, ab, b, c);
    else if (count === 2) result.push(a, b, bc, a, bc, ca, bc, c, ca);
    else result.push(a, ab, ca, ab, b, bc, bc, c, ca, ab, bc, ca);
  }
  return Uint32Array.from(result);
}
