/** Distances from one point to all vertices of a mesh: by one search of the surface's graph, which is in wasm/graph_field.c, or each by the solver. */

import { checkBoolean, checkOptions } from '../arguments.js';
import { findPath } from '../intrinsic.js';
import { copies } from '../manifold/lifts.js';
import { isGeodesic, readOptions } from '../path.js';
import { findBeside, findWithin } from '../pieces/pieces.js';
import { netOf } from '../pieces/through.js';
import { EXHAUSTED } from '../runtime/solver.js';
import { CONVERGED, OUT_OF_MEMORY } from '../runtime/status.js';
import { besideInfinite } from '../search/infinite-ends.js';
import { gap, listOf } from '../vector.js';
import { spread } from './spread.js';

/**
 * @typedef {object} FieldOptions
 * @property {number} [resolution] of the mesh, as for `mesh`
 * @property {boolean} [exact] true: the length of the shortest path to each vertex, to 1e-9, begun from the paths to its neighbours, in 0.1 to 1 ms a vertex (up to
 *   10 ms where many paths are about as long, 100 ms on bodies joined and cut and from a point where the surface is singular or a density infinite, 400 ms under a density with creases); default false: of the
 *   shortest way through a graph: on smooth surfaces of moderate slopes 0.5 % too long as a rule, up to a few per cent; a fifth and more in places where one
 *   direction counts much more than the other, as on steep slopes; up to 4 % too short where there are waves of a dozen cells of the graph and less
 */

/**
 * @typedef {object} DistanceField
 * @property {import('./mesh.js').Mesh} mesh
 * @property {Float64Array} distances along the surface, in the metric in use, one a vertex; Infinity where no way leads; NaN where `exact` found no path
 */

/** @typedef {import('../search/routes.js').Field} Field */
/** @typedef {{ place: number[], away: number, lengths: Float64Array, isUnique: boolean }} Source a point, how far it is, and ways from there: those that pass it are longer by that */

/** Neighbours in a mesh of fewer vertices are too far apart to lead to each other: each path is searched for. */
const LEAST_VERTICES = 600;
/** A way through the graph that is so many times as long as another may be the shorter. */
const LONGER = 1.25;
/** So far, in parts of the range, from where length is measured infinitely ways through the graph begin and end. */
const BESIDE = 1e-3;
/** A node this near to the point, in parts of its coordinates, is that point. */
const SAME = 1e-9;

/** @param {string} caller @param {FieldOptions | undefined} given @returns {{ resolution: number | undefined, exact: boolean }} */
export function readFieldOptions(caller, given) {
  const { resolution, exact = false } = checkOptions(caller, given, ['resolution', 'exact']);
  checkBoolean(caller, 'exact', exact);
  return { resolution, exact };
}

/**
 * Lengths of the shortest ways through the graph; where the graph does not lead, through a finer one.
 * @param {Field} field @param {string} caller @param {number[]} from on the surface @param {Float64Array} places u v or x y z of each
 * @returns {{ lengths: Float64Array, isUnique: boolean }} isUnique: geodesics of this surface are taken as unique
 */
function search(field, caller, from, places) {
  const { domain, graphs, run } = field;
  const width = from.length;
  const lengths = new Float64Array(places.length / width).fill(Infinity);
  let isUnique = false;
  let missing = Array.from(lengths.keys());
  for (let level = 0; missing.length > 0; level++) {
    const wanted = level === 0 ? places : Float64Array.from(missing.flatMap((i) => listOf(places, width * i, width * (i + 1))));
    const found = run((heap, record) => {
      const graph = graphs.find(heap, record, field, level);
      if (graph?.status === OUT_OF_MEMORY) return { status: OUT_OF_MEMORY, lengths };
      isUnique ||= graph?.unique ?? false;
      return graph && joinFields(copies(domain, from).map((place) => heap.measureField(record, graph, place, wanted)));
    });
    if (!found) break;
    if (found.status === OUT_OF_MEMORY) throw new RangeError(`${caller}: ${EXHAUSTED}`);
    if (found.status !== CONVERGED) continue;
    for (const [k, i] of missing.entries()) lengths[i] = found.lengths[k];
    missing = missing.filter((i) => lengths[i] === Infinity);
  }
  return { lengths, isUnique };
}

/** Lengths from the same point in several places, the shorter ones. @param {{ status: number, lengths: Float64Array }[]} fields */
function joinFields(fields) {
  const [first, ...others] = fields.filter(({ status }) => status === CONVERGED);
  for (const { lengths } of others) for (const [i, length] of lengths.entries()) if (length < first.lengths[i]) first.lengths[i] = length;
  return first ?? fields[0];
}

/**
 * Where shortest ways begin: the point itself, and nodes, the nearer ones first.
 * @param {Field} field @param {string} caller @param {number[]} from on the surface @param {Float64Array} places @returns {Source[]}
 */
function findSources(field, caller, from, places) {
  const net = field.domain ? null : netOf(field);
  const nodes = (net?.nodes ?? []).map(({ at }) => at).filter((at) => gap(at, from) > SAME * gap(at, [0, 0, 0]));
  const wanted = nodes.length > 0 ? Float64Array.from([...places, ...nodes.flat()]) : places;
  const count = places.length / from.length;
  /** @type {Source[]} */
  const sources = [];
  const far = new Float64Array(count + nodes.length).fill(Infinity);
  const add = (/** @type {number[]} */ place, /** @type {number} */ away) => {
    const { lengths, isUnique } = search(field, caller, place, wanted);
    for (const [i, length] of lengths.entries()) far[i] = Math.min(far[i], away + length);
    sources.push({ place, away, lengths: lengths.subarray(0, count), isUnique });
  };
  add(from, 0);
  const open = new Set(nodes.keys());
  const mostOf = () => far.subarray(0, count).reduce((most, x) => Math.max(most, x), 0);
  while (open.size > 0) {
    const nearest = [...open].reduce((best, i) => (far[count + i] < far[count + best] ? i : best));
    if (!(far[count + nearest] < mostOf())) break;
    open.delete(nearest);
    add(nodes[nearest], far[count + nearest]);
  }
  if (far.every((length) => length === Infinity || length === 0)) {
    const asked = field.domain ? 'are its formulas finite there, and lengths positive?' : 'is the point inside the bounds?';
    throw new RangeError(`${caller}: the graph of the surface reaches no vertex of the mesh from there; ${asked}`);
  }
  return sources;
}

/**
 * Lengths of the shortest paths from one source to all vertices to which it has a way.
 * @param {Field} field @param {Source} source @param {import('./mesh.js').Mesh} mesh @param {import('../runtime/heap.js').SolveOptions} options
 */
function solveFrom(field, { place, lengths, isUnique }, mesh, options) {
  const places = mesh.parameters ?? mesh.positions;
  const width = place.length;
  /* Neighbours' lines rest across no crease, nor does what is looked for within a sheet. */
  const isCreased = !field.domain && Boolean(field.sides?.());
  const isAlone = isUnique || isCreased || field.pieces.length > 0 || lengths.length < LEAST_VERTICES;
  const find = (/** @type {number} */ i, /** @type {Float32Array[]} */ lines, shortest = Infinity) => {
    const ends = [place, listOf(places, width * i, width * (i + 1))];
    if (lines.length > 0) return findBeside(field, ends, options, lines, shortest);
    return [field.domain || isCreased ? findPath(field, ends, options, 'global') : findWithin(field, ends, options)];
  };
  if (!isAlone) return spread(mesh, lengths, find);
  return lengths.map((length, i) => {
    if (length === Infinity || length === 0) return length;
    const [path] = find(i, []);
    return isGeodesic(path) ? path.length : Number.NaN;
  });
}

/**
 * @param {Field} field @param {string} caller @param {number[]} from on the surface @param {import('./mesh.js').Mesh} mesh @param {boolean} exact
 * @returns {Float64Array} a distance a vertex
 */
export function measureField(field, caller, from, mesh, exact) {
  const start = besideInfinite(field, from, BESIDE);
  const ends = mesh.parameters && besideInfinite(field, mesh.parameters, BESIDE);
  if (!start && !ends) return measure(field, caller, from, mesh, exact);
  const inner = { ...mesh, parameters: ends?.places ?? mesh.parameters };
  const lengths = measure(field, caller, start ? Array.from(start.places) : from, inner, exact && !start);
  const { solve } = readOptions(caller, undefined);
  return lengths.map((length, i) => {
    const to = Array.from(mesh.parameters?.subarray(2 * i, 2 * i + 2) ?? []);
    const away = (start?.away[0] ?? 0) + (ends?.away[i] ?? 0);
    if (String(from) === String(to)) return 0;
    if (!exact || away === 0 || length === Infinity) return length + away;
    const path = findPath(field, [from, to], solve, 'global');
    return isGeodesic(path) ? path.length : Number.NaN;
  });
}

/** As {@link measureField}, where length is measured by numbers. @param {Field} field @param {string} caller @param {number[]} from @param {import('./mesh.js').Mesh} mesh @param {boolean} exact @returns {Float64Array} */
function measure(field, caller, from, mesh, exact) {
  const sources = findSources(field, caller, from, mesh.parameters ?? mesh.positions);
  const rough = sources[0].lengths.map((_, i) => Math.min(...sources.map(({ away, lengths }) => away + lengths[i])));
  if (!exact) return rough;
  const { solve } = readOptions(caller, undefined);
  /* A way through the graph may pass a node unseen: what is beyond it is measured from there. */
  const partsAt = (sources.length > 1 && netOf(field)?.partsAt) || ((/** @type {number[]} */ _) => [0]);
  const parts = Array.from(rough, (_, i) => partsAt([...mesh.positions.subarray(3 * i, 3 * i + 3)]));
  const distances = rough.map((length) => (length < Infinity ? Number.NaN : Infinity));
  for (const source of sources) {
    const away = source.away && findPath(field, [from, source.place], solve, 'global').length;
    const own = partsAt(source.place);
    const isNear = (/** @type {number} */ length, /** @type {number} */ i) =>
      source.away + length <= LONGER * rough[i] && parts[i].some((part) => own.includes(part));
    const lengths = source.lengths.map((length, i) => (isNear(length, i) ? length : Infinity));
    for (const [i, length] of solveFrom(field, { ...source, lengths }, mesh, solve).entries())
      if (away + length < Infinity && !(distances[i] <= away + length)) distances[i] = away + length;
  }
  return distances;
}
