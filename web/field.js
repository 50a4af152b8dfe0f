/** Distances from one point to all vertices of a mesh: by one search of the surface's graph, which is in wasm/graph_field.c, or each by the solver. */

import { copies } from './lifts.js';
import { checkBoolean, checkOptions, readOptions } from './path.js';
import { findPath } from './pieces.js';
import { EXHAUSTED } from './runtime/solver.js';
import { CONVERGED, OUT_OF_MEMORY } from './runtime/status.js';

/**
 * @typedef {object} FieldOptions
 * @property {number} [resolution] of the mesh, as for `mesh`
 * @property {boolean} [exact] true: the length of the shortest path to each vertex, as `shortestPath` finds it with its own defaults: to 1e-9, in about
 *   10 ms a vertex (0.3 ms where no curvature is positive); default false: of the shortest way through a graph:
 *   a few per cent too long at most, 0.5 % typically, seldom too short by less, more where a metric counts one direction much more than the other
 */

/**
 * @typedef {object} DistanceField
 * @property {import('./mesh.js').Mesh} mesh
 * @property {Float64Array} distances along the surface, in the metric in use, one a vertex; Infinity where no way leads; NaN where `exact` found no path
 */

/** @typedef {import('./routes.js').Field} Field */

/** @param {string} caller @param {FieldOptions | undefined} given @returns {{ resolution: number | undefined, exact: boolean }} */
export function readFieldOptions(caller, given) {
  const { resolution, exact = false } = checkOptions(caller, given, ['resolution', 'exact']);
  checkBoolean(caller, 'exact', exact);
  return { resolution, exact };
}

/**
 * Lengths of the shortest ways through the graph; where the graph does not lead, through a finer one.
 * @param {Field} field @param {string} caller @param {number[]} from on the surface @param {Float64Array} places u v or x y z of each
 * @returns {Float64Array}
 */
function search({ domain, box, graphs, run }, caller, from, places) {
  const place = domain ? [domain.lower[0], domain.upper[0], domain.lower[1], domain.upper[1]] : box;
  const width = from.length;
  const lengths = new Float64Array(places.length / width).fill(Infinity);
  let missing = Array.from(lengths.keys());
  for (let level = 0; missing.length > 0; level++) {
    const wanted =
      level === 0 ? places : Float64Array.from(missing.flatMap((i) => Array.from(places.subarray(width * i, width * (i + 1)))));
    const found = run((heap, record) => {
      const graph = graphs.find(heap, record, place, level, domain?.turn?.folds);
      if (graph?.status === OUT_OF_MEMORY) return { status: OUT_OF_MEMORY, lengths };
      return graph && joinFields(copies(domain, from).map((place) => heap.measureField(record, graph, place, wanted)));
    });
    if (!found) break;
    if (found.status === OUT_OF_MEMORY) throw new RangeError(`${caller}: ${EXHAUSTED}`);
    if (found.status !== CONVERGED) continue;
    for (const [k, i] of missing.entries()) lengths[i] = found.lengths[k];
    missing = missing.filter((i) => lengths[i] === Infinity);
  }
  if (missing.length === lengths.length)
    throw new RangeError(`${caller}: the graph of the surface reaches no vertex of the mesh from there; is the point inside the bounds?`);
  return lengths;
}

/** Lengths from the same point in several places, the shorter ones. @param {{ status: number, lengths: Float64Array }[]} fields */
function joinFields(fields) {
  const [first, ...others] = fields.filter(({ status }) => status === CONVERGED);
  for (const { lengths } of others) for (const [i, length] of lengths.entries()) if (length < first.lengths[i]) first.lengths[i] = length;
  return first ?? fields[0];
}

/** A place at a pole, turned to face another: there, one coordinate is free. @param {import('./domain.js').Domain | null} domain @param {number[]} place @param {number[]} other */
function face(domain, place, other) {
  for (const pole of domain?.poles ?? []) {
    const [coordinate, side] = [(pole - 1) >> 1, (pole - 1) & 1];
    const edge = (side ? domain?.upper : domain?.lower)?.[coordinate];
    if (place[coordinate] === edge) return place.map((x, j) => (j === coordinate ? x : other[j]));
  }
  return place;
}

/**
 * @param {Field} field @param {string} caller @param {number[]} from on the surface @param {import('./mesh.js').Mesh} mesh @param {boolean} exact
 * @returns {Float64Array} a distance a vertex
 */
export function measureField(field, caller, from, mesh, exact) {
  const places = mesh.parameters ?? mesh.positions;
  const lengths = search(field, caller, from, places);
  if (!exact) return lengths;
  const { solve } = readOptions(caller, undefined);
  const width = from.length;
  return lengths.map((length, i) => {
    if (length === Infinity || length === 0) return length;
    const to = Array.from(places.subarray(width * i, width * (i + 1)));
    const path = findPath(field, [face(field.domain, from, to), face(field.domain, to, from)], solve, 'global');
    return path.converged || path.status === 'ill-conditioned' ? path.length : Number.NaN;
  });
}
