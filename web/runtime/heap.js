/** Calls of the solver: each writes its arguments into memory, reserves the arena, runs an exported function, and copies the result out. */

import * as layout from './layout.js';
import { Memory } from './memory.js';
import { emptyPath, readResult, readTrace } from './result.js';
import { CONVERGED, OUT_OF_MEMORY } from './status.js';

/** A graph that does not fit into the arena it was expected to need is tried again with twice as much, up to this. */
const MOST_GRAPH_BYTES = 2 ** 29;
/** Structs of wasm/surfpath.h that hold options, requests or results are at most so large. */
export const MOST_STRUCT_BYTES = 144;
const MOST_TRACE_STEPS = 200_000;
/** A mesh rarely has more vertices for the square of its cells a direction, and of 64³ cells rarely more than so many. */
const [USUAL_DENSITY, USUAL_VERTICES] = [30, 60_000];

/** As sp_way in wasm/surfpath.h. */
export const OVER_POINT = 1;
export const POINT_CHART = 2;
export const BESIDE_POINT = 3;

/** @typedef {{ kind: number, metric: number, jet: number, value: number, lower: number[], upper: number[], extent: number }} SurfaceRecord */
/** @typedef {import('./result.js').RawPath} RawPath */
/** @typedef {{ tolerance: number, gradientTolerance: number, algorithm: number, points: number, maxIterations: number, record: boolean }} SolveOptions */
/** @typedef {{ way: number, edge: number, beyond: number, turn: number }} Passage struct sp_passage: OVER_POINT, … and which edge, 2 · coordinate + side; how far beyond it the point lies; what the coordinate along it changes by once around, 0 between walls */
/**
 * @typedef {object} Graph a graph of a surface, in linear memory until {@link Heap.releaseGraph}
 * @property {number} status
 * @property {number} at address of its struct
 * @property {number} block address of its arrays
 * @property {boolean} isLoose it joins whatever shares a face, walls and all
 * @property {number} bytes of them
 * @property {number} vertices
 * @property {number} spacing implicit: diagonal of a cell
 * @property {boolean} unique geodesics of this surface are taken as unique
 * @property {boolean} singular the normal vanishes along a curve
 * @property {boolean} resolved its lengths are nearly those of the surface
 * @property {boolean} coarse a finer one finds ways that it does not
 * @property {number[]} form parametric: e, f, g of the surface, on an average
 */

export class Heap extends Memory {
  // Addresses of what a call is asked and answers, for the life of the instance; those of the next call lie in the same places.
  #options;
  #request;
  #result;

  /** @param {WebAssembly.Exports} exports of the solver */
  constructor(exports) {
    super(exports);
    this.#options = this.allocate(MOST_STRUCT_BYTES);
    this.#request = this.allocate(MOST_STRUCT_BYTES);
    this.#result = this.allocate(MOST_STRUCT_BYTES);
  }

  /** @param {number} at @param {SurfaceRecord} surface */
  writeSurface(at, surface) {
    this.words(at + layout.sp_surface_jet, 4).set([surface.jet, surface.value, surface.kind, surface.metric]);
    this.writeDoubles(at + layout.sp_surface_lower, surface.lower);
    this.writeDoubles(at + layout.sp_surface_upper, surface.upper);
    this.writeDoubles(at + layout.sp_surface_extent, [surface.extent]);
  }

  /**
   * Evaluates a compiled surface at `count` points.
   * @param {(pairs: number, input: number, output: number) => void} evaluate
   * @param {ArrayLike<number>} points `inputs` numbers a point
   * @param {number} inputs @param {number} outputs
   * @returns {Float64Array | null} `outputs` numbers a point; null: memory is exhausted
   */
  evaluate(evaluate, points, inputs, outputs) {
    const count = points.length / inputs;
    const pairs = (count + 1) >> 1;
    const bytes = pairs * 16 * (inputs + outputs);
    if (!this.reserve(bytes)) return null;
    const numbers = this.allDoubles();
    const input = this.arenaBase >> 3;
    for (let i = 0; i < 2 * pairs; i++) {
      const point = Math.min(i, count - 1) * inputs;
      const lane = input + 2 * inputs * (i >> 1) + (i & 1);
      for (let j = 0; j < inputs; j++) numbers[lane + 2 * j] = points[point + j];
    }
    const output = input + 2 * pairs * inputs;
    evaluate(pairs, input << 3, output << 3);
    const result = new Float64Array(count * outputs);
    for (let i = 0; i < count; i++) {
      const lane = output + 2 * outputs * (i >> 1) + (i & 1);
      for (let j = 0; j < outputs; j++) result[outputs * i + j] = numbers[lane + 2 * j];
    }
    return result;
  }

  /**
   * Runs sp_solve_path.
   * @param {number} surface address of its record
   * @param {{ kind: number, from: number[], to: number[], start: ArrayLike<number> | null, passage?: Passage | null }} request
   * @param {SolveOptions} options
   * @returns {RawPath}
   */
  solve(surface, request, options) {
    this.#writeOptions(options);
    const dimension = request.kind === 1 ? 3 : 2;
    const start = request.start;
    const startCount = start ? start.length / dimension : 0;
    const startBytes = (8 * (start ? start.length : 0) + 15) & ~15;
    const bytes = this.exports.sp_solve_bytes(surface, this.#options, startCount);
    if (!this.reserve(startBytes + bytes)) return emptyPath(OUT_OF_MEMORY);
    if (start) this.writeDoubles(this.arenaBase, start);
    this.writePoint(this.#request + layout.sp_request_from, request.from);
    this.writePoint(this.#request + layout.sp_request_to, request.to);
    const passage = request.passage;
    this.writeWords(this.#request + layout.sp_request_start, start ? this.arenaBase : 0, startCount, passage ? passage.way : 0);
    if (passage) {
      const at = this.#request + layout.sp_request_passage;
      this.words(at + layout.sp_passage_edge, 1)[0] = passage.edge;
      this.writeDoubles(at + layout.sp_passage_beyond, [passage.beyond, passage.turn]);
    }
    this.exports.sp_solve_path(surface, this.#request, this.#options, this.openArena(startBytes), this.#result);
    return readResult(this, this.#result, options.points + 2);
  }

  /** Of the path just solved: how its length changes with u v or x y z of its first end, and of its last; NaN where that is not known. */
  pulls() {
    return [0, 24].map((offset) => Array.from(this.doubles(this.#result + layout.sp_result_pull + offset, 3)));
  }

  /** Of the path just solved, or not: how often a node of it was moved. */
  get work() {
    return this.words(this.#result + layout.sp_result_work, 1)[0];
  }

  /**
   * Runs sp_trace_path.
   * @param {number} surface address of its record
   * @param {{ kind: number, from: number[], direction: number[], length: number }} request
   * @param {{ points: number, tolerance: number }} options
   * @returns {RawPath | null} null: the direction is normal to the surface
   */
  trace(surface, request, options) {
    this.writeDoubles(this.#options + layout.sp_trace_options_tolerance, [options.tolerance]);
    this.words(this.#options + layout.sp_trace_options_point_count, 2).set([options.points, MOST_TRACE_STEPS]);
    if (!this.reserve(this.exports.sp_trace_bytes(request.kind, this.#options))) return emptyPath(OUT_OF_MEMORY);
    this.writePoint(this.#request + layout.sp_trace_request_from, request.from);
    this.writePoint(this.#request + layout.sp_trace_request_direction, request.direction);
    this.writeDoubles(this.#request + layout.sp_trace_request_length, [request.length]);
    this.exports.sp_trace_path(surface, this.#request, this.#options, this.openArena(), this.#result);
    return readTrace(this, this.#result, options.points + 2);
  }

  /**
   * Runs sp_project_point from `place` downhill.
   * @param {number} surface address of its record @param {number[]} point @param {number[]} place
   * @returns {{ status: number, place: number[] }}
   */
  project(surface, point, place) {
    const at = this.#request;
    this.writeDoubles(at, point);
    this.writeDoubles(at + 24, place);
    const status = this.exports.sp_project_point(surface, at, at + 24);
    return { status, place: Array.from(this.doubles(at + 24, place.length)) };
  }

  /**
   * Runs sp_mesh_implicit, once more with as much arena as it asks for where the mesh is larger than usual.
   * @param {number} value table slot of the surface's value function
   * @param {number[]} box @param {number} resolution
   * @returns {{ status: number, positions: Float64Array, normals: Float64Array, indices: Uint32Array }}
   */
  meshImplicit(value, box, resolution) {
    const numbers = this.#request;
    this.writeDoubles(numbers, box);
    let [vertices, triangles] = [Math.min(USUAL_DENSITY * resolution ** 2, USUAL_VERTICES), 0];
    for (let attempt = 0; ; attempt++) {
      const bytes = this.exports.sp_mesh_bytes(numbers, resolution, vertices, triangles);
      if (!this.reserve(bytes)) return emptyMesh(OUT_OF_MEMORY);
      const status = this.exports.sp_mesh_implicit(value, numbers, resolution, this.openArena(), this.#result);
      const [positionsAt, normalsAt, indicesAt, vertexCount, triangleCount] = this.words(this.#result + layout.sp_mesh_positions, 5);
      if (status === OUT_OF_MEMORY && attempt === 0) {
        [vertices, triangles] = [vertexCount, triangleCount];
        continue;
      }
      if (status !== CONVERGED) return emptyMesh(status);
      return {
        status,
        positions: this.copyDoubles(positionsAt, 3 * vertexCount),
        normals: this.copyDoubles(normalsAt, 3 * vertexCount),
        indices: new Uint32Array(this.words(indicesAt, 3 * triangleCount)),
      };
    }
  }

  /**
   * Runs sp_graph_build and keeps the graph.
   * @param {number} surface address of its record @param {number} kind @param {{ box: number[], cell: number, resolution: number, loose: number, level?: number, reach?: number }} options
   * @returns {Graph} of status CONVERGED; any other: nothing is kept
   */
  buildGraph(surface, kind, { box, cell, resolution, loose, level = 0, reach = 0 }) {
    const at = this.allocate(layout.sp_graph_bytes);
    this.writeDoubles(this.#options + layout.sp_graph_options_box, [...[...box, 0, 0].slice(0, 6), cell]);
    this.writeDoubles(this.#options + layout.sp_graph_options_reach, [reach]);
    this.words(this.#options + layout.sp_graph_options_resolution, 2).set([resolution, loose]);
    this.words(this.#options + layout.sp_graph_options_level, 1)[0] = level;
    let status = OUT_OF_MEMORY;
    for (let bytes = this.exports.sp_graph_build_bytes(kind, this.#options); status === OUT_OF_MEMORY; bytes *= 2) {
      if (!at || bytes > MOST_GRAPH_BYTES || !this.reserve(bytes)) break;
      status = this.exports.sp_graph_build(surface, this.#options, this.openArena(), at);
    }
    const bytes = status === CONVERGED ? this.exports.sp_graph_bytes(at) : 0;
    const block = status === CONVERGED ? this.allocate(bytes) : 0;
    if (block) this.exports.sp_graph_keep(at, block);
    else this.release(at);
    const word = (/** @type {number} */ offset) => (block ? this.words(at + offset, 1)[0] : 0);
    return {
      status: block ? CONVERGED : status || OUT_OF_MEMORY,
      at: block && at,
      block,
      isLoose: loose === 1,
      bytes,
      vertices: word(layout.sp_graph_vertex_count),
      spacing: block && this.doubles(at + layout.sp_graph_spacing, 1)[0],
      unique: word(layout.sp_graph_unique) !== 0,
      singular: word(layout.sp_graph_singular) !== 0,
      resolved: word(layout.sp_graph_resolved) !== 0,
      coarse: word(layout.sp_graph_coarse) !== 0,
      form: block ? Array.from(this.doubles(at + layout.sp_graph_form, 3)) : [],
    };
  }

  /** @param {Graph} graph */
  releaseGraph({ at, block }) {
    this.release(block);
    this.release(at);
  }

  /**
   * Runs sp_graph_search.
   * @param {number} surface address of its record @param {Graph} graph @param {number[]} from @param {number[]} to @param {number} points of a candidate
   * @param {boolean} all not only ways that may become the shortest path
   * @returns {{ status: number, distance: number, candidates: Float64Array[] }} distance: length of the shortest way; candidates: polylines of u v or x y z, shortest first
   */
  searchGraph(surface, graph, from, to, points, all) {
    const numbers = this.#request;
    const dimension = from.length;
    if (!this.reserve(this.exports.sp_graph_search_bytes(graph.at, points)))
      return { status: OUT_OF_MEMORY, distance: Number.NaN, candidates: [] };
    this.writePoint(numbers, from);
    this.writePoint(numbers + 24, to);
    const status = this.exports.sp_graph_search(surface, graph.at, numbers, points, Number(all), this.openArena(), this.#result);
    const [places, count, written] = this.words(this.#result + layout.sp_graph_answer_places, 3);
    const candidates = Array.from({ length: count }, (_, i) => this.copyDoubles(places + 8 * dimension * written * i, dimension * written));
    return { status, distance: this.allDoubles()[(this.#result + layout.sp_graph_answer_distance) >> 3], candidates };
  }

  /**
   * Runs sp_graph_field.
   * @param {number} surface address of its record @param {Graph} graph @param {number[]} from @param {ArrayLike<number>} places u v or x y z of each
   * @returns {{ status: number, lengths: Float64Array }} of the shortest way to each; infinite where there is none
   */
  measureField(surface, graph, from, places) {
    const count = places.length / from.length;
    const own = (8 * (places.length + count) + 15) & ~15;
    if (!this.reserve(own + this.exports.sp_graph_field_bytes(graph.at, count)))
      return { status: OUT_OF_MEMORY, lengths: new Float64Array(0) };
    const base = this.arenaBase;
    const lengths = base + 8 * places.length;
    this.writeDoubles(base, places);
    this.writePoint(this.#request, from);
    this.writeWords(this.#request + layout.sp_field_request_places, base, lengths, count);
    const status = this.exports.sp_graph_field(surface, graph.at, this.#request, this.openArena(own));
    return { status, lengths: this.copyDoubles(lengths, count) };
  }

  /** @param {SolveOptions} options */
  #writeOptions(options) {
    const at = this.#options;
    const doubles = this.allDoubles();
    doubles[(at + layout.sp_options_tolerance) >> 3] = options.tolerance;
    doubles[(at + layout.sp_options_gradient_tolerance) >> 3] = options.gradientTolerance;
    this.writeWords(at + layout.sp_options_algorithm, options.algorithm, options.points, options.maxIterations);
    this.allWords()[(at + layout.sp_options_record) >> 2] = options.record ? 1 : 0;
  }
}

/** @param {number} status */
function emptyMesh(status) {
  return { status, positions: new Float64Array(0), normals: new Float64Array(0), indices: new Uint32Array(0) };
}
