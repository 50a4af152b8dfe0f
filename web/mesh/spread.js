/**
 * Shortest paths from one point to all vertices of a mesh. Whatever leads to a vertex leads past its neighbours: each path is begun from theirs, also from those
 * that are not the shortest there. MATH.md, "Distance fields".
 */

import { isGeodesic } from '../path.js';
import { thinned } from '../search/join.js';
import { gap } from '../vector.js';

/** @typedef {import('../path.js').Path} Path */
/** @typedef {import('./mesh.js').Mesh} Mesh */
/** @typedef {{ length: number, line: Float32Array, trail: Float64Array }} Reached a path: line: u v or x y z along it; trail: x y z of some of its points, the end last */

/** Points of a trail, and how many of a line there are for each. */
const [TRAIL, EACH] = [8, 4];
/** Lines, and paths as they are roughly, that are nowhere farther apart than so much of their length are the same. */
const [EXACTLY, ROUGHLY] = [1e-4, 0.01];
/** So often vertices are looked at again, if their neighbours have new paths. */
const MOST_SWEEPS = 8;
/** Where this many lines a vertex are followed, and of the first of them more, many ways are about as long: then searches, which know 32 at most, take less time. */
const [CROWDED, FIRST] = [16, 64];
/** Vertices that are one point of the surface, as at seams and poles, in parts of its size. */
const SAME = 1e-9;

/**
 * Lengths of the shortest paths.
 * @param {Mesh} mesh
 * @param {Float64Array} rough lengths of ways, at least those of the shortest paths: where finite a path is wanted, the shorter ones first
 * @param {(vertex: number, lines: Float32Array[], shortest?: number) => Path[]} find the shortest of the paths near these lines, if shorter than
 *   that, then all of them; without any lines, the shortest of all
 * @returns {Float64Array} NaN: none was found
 */
export function spread(mesh, rough, find) {
  const lengths = rough.map((length) => (length > 0 && length < Infinity ? Number.NaN : length));
  const order = [...rough.keys()].filter((i) => Number.isNaN(lengths[i])).sort((i, j) => rough[i] - rough[j]);
  const neighbours = findNeighbours(mesh);
  /** @type {Reached[][]} */ const reached = Array.from(rough, () => []);
  /** Those of the neighbours' that were followed to each. @type {Set<Reached>[]} */ const followed = Array.from(rough, () => new Set());
  /** Edges in the metric in use: along one of them distance grows as it does. */
  const edges = rough.map((length, j) =>
    Math.max(0, ...[...neighbours[j]].map((k) => Math.abs(rough[k] - length)).filter(Number.isFinite)),
  );
  const isOpen = new Uint8Array(rough.length).fill(1);

  const linesTo = (/** @type {number} */ i) => {
    /* What is the shortest here passes half an edge beside a neighbour at most, and is no longer there than the shortest to it, half an edge back and forth. */
    const near = [...neighbours[i]].flatMap((j) => {
      const most = lengths[j] + Math.max(edges[j], gap(mesh.positions.subarray(3 * i), mesh.positions.subarray(3 * j)));
      return reached[j].filter(({ length }) => length <= most);
    });
    /** @type {Reached[]} */ const chosen = [];
    for (const one of near.sort((a, b) => a.length - b.length)) {
      if (followed[i].has(one) || [...reached[i], ...chosen].some(({ trail }) => isBeside(one.trail, trail, EXACTLY * one.length)))
        continue;
      followed[i].add(one);
      chosen.push(one);
    }
    return chosen.map(({ line }) => line);
  };
  const take = (/** @type {number} */ i, /** @type {Path[]} */ paths) => {
    if (isGeodesic(paths[0]) && !(paths[0].length >= lengths[i])) lengths[i] = paths[0].length;
    for (const path of paths) {
      if (!isGeodesic(path)) continue;
      const one = reachedBy(path);
      if (reached[i].some(({ trail }) => isBeside(one.trail, trail, ROUGHLY * path.length))) continue;
      reached[i].push(one);
      for (const j of neighbours[i]) isOpen[j] = 1;
    }
  };
  const search = (/** @type {number} */ i) => take(i, find(i, []));
  let [lineCount, vertexCount] = [0, FIRST];
  const isCrowded = () => lineCount > CROWDED * vertexCount;
  for (let sweep = 0; sweep < MOST_SWEEPS; sweep++)
    for (const i of order) {
      if (!isOpen[i]) continue;
      isOpen[i] = 0;
      if (sweep === 0) vertexCount++;
      /* Of those that look alike one may come to nothing where another does not. */
      for (let lines = linesTo(i); lines.length > 0 && !isCrowded(); lines = linesTo(i)) {
        take(i, find(i, lines, lengths[i] || Infinity));
        lineCount += lines.length;
      }
      if (isCrowded()) {
        order.forEach(search);
        return lengths;
      }
      if (sweep === 0 && !(lengths[i] <= rough[i])) search(i);
    }
  return lengths;
}

/** @param {Path} path @returns {Reached} */
function reachedBy(path) {
  const { length, points, parameters } = thinned(path, 1 + EACH * TRAIL);
  const trail = Float64Array.from({ length: 3 * TRAIL }, (_, k) => points[3 * EACH * (1 + Math.floor(k / 3)) + (k % 3)]);
  return { length, line: Float32Array.from(parameters ?? points), trail };
}

/** Whether paths from the same point are nowhere farther apart than at their ends, and this. @param {Float64Array} one @param {Float64Array} other @param {number} least */
function isBeside(one, other, least) {
  const apart = (/** @type {number} */ k) => gap(one.subarray(3 * k), other.subarray(3 * k));
  const most = apart(TRAIL - 1) + least;
  for (let k = 0; k < TRAIL - 1; k++) if (apart(k) > most) return false;
  return true;
}

/** The vertices that share an edge with each, or with one at the same place. @param {Mesh} mesh @returns {Set<number>[]} */
function findNeighbours({ positions, indices }) {
  const same = SAME * positions.reduce((most, x) => (Math.abs(x) < Infinity ? Math.max(most, Math.abs(x)) : most), 0);
  /** Vertices at the same place share the list of them; those that are nowhere share none. @type {Map<string, number[]>} */ const places =
    new Map();
  const here = Array.from({ length: positions.length / 3 }, (_, i) => {
    const point = positions.subarray(3 * i, 3 * i + 3);
    const place = point.every(Number.isFinite) ? point.map((x) => Math.round(x / same)).join() : `${i}`;
    const list = places.get(place) ?? [];
    list.push(i);
    places.set(place, list);
    return list;
  });
  /** @type {Map<number[], Set<number>>} */ const sets = new Map(here.map((list) => [list, new Set()]));
  const join = (/** @type {number} */ one, /** @type {number} */ other) => {
    for (const i of here[other]) sets.get(here[one])?.add(i);
  };
  for (let i = 0; i < indices.length; i++) {
    const [one, other] = [indices[i], indices[i % 3 === 2 ? i - 2 : i + 1]];
    join(one, other);
    join(other, one);
  }
  return here.map((list) => /** @type {Set<number>} */ (sets.get(list)));
}
