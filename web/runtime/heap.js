/**
 * Traffic with the solver's linear memory: the only file that touches it. Views are made right before use, because memory may grow in any call,
 * and results are copies. Mirrors the structs of wasm/surfpath.h; a test compares the two.
 */

/** Byte offsets in WebAssembly of the structs of wasm/surfpath.h and wasm/surface.h. */
export const LAYOUT = {
  sp_surface: { bytes: 56, jet: 0, value: 4, kind: 8, metric: 12, lower: 16, upper: 32, extent: 48 },
  sp_options: { bytes: 32, tolerance: 0, gradient_tolerance: 8, algorithm: 16, point_count: 20, max_iterations: 24, record: 28 },
  sp_request: { bytes: 64, from: 0, to: 24, start: 48, start_count: 52 },
  sp_iterate: { bytes: 32, energy: 0, gradient_norm: 8, decrement: 16, step: 24 },
  sp_result: {
    bytes: 72,
    length: 0,
    length_error: 8,
    energy: 16,
    gradient_norm: 24,
    points: 32,
    parameters: 36,
    history: 40,
    record: 44,
    status: 48,
    iterations: 52,
    index: 56,
    touches_boundary: 60,
    history_count: 64,
  },
  sp_arena: { bytes: 12, base: 0, size: 4, used: 8 },
  sp_mesh: { bytes: 20, positions: 0, normals: 4, indices: 8, vertex_count: 12, triangle_count: 16 },
};

const OUT_OF_MEMORY = -6;

/** @typedef {{ kind: number, metric: number, jet: number, value: number, lower: number[], upper: number[], extent: number }} SurfaceRecord */
/** @typedef {{ tolerance: number, gradientTolerance: number, algorithm: number, points: number, maxIterations: number, record: boolean }} SolveOptions */
/** @typedef {{ energy: number, gradientNorm: number, decrement: number, step: number, points?: Float64Array }} Iterate */
/**
 * @typedef {object} RawPath what sp_solve_path wrote, copied
 * @property {number} status
 * @property {number} length
 * @property {number} lengthError
 * @property {number} energy
 * @property {number} gradientNorm
 * @property {number} iterations
 * @property {number} index
 * @property {boolean} touchesBoundary
 * @property {Float64Array} points
 * @property {Float64Array | null} parameters
 * @property {Iterate[]} history
 */

export class Heap {
  /** @type {any} */ #exports;
  /** Addresses of one of each struct that a call needs, kept for the life of the instance. */
  #structs;
  #arenaBase = 0;
  #arenaSize = 0;

  /** @param {WebAssembly.Exports} exports of the solver */
  constructor(exports) {
    this.#exports = exports;
    this.#structs = {
      options: this.allocate(LAYOUT.sp_options.bytes),
      request: this.allocate(LAYOUT.sp_request.bytes),
      result: this.allocate(LAYOUT.sp_result.bytes),
      arena: this.allocate(LAYOUT.sp_arena.bytes),
      mesh: this.allocate(LAYOUT.sp_mesh.bytes),
      numbers: this.allocate(64),
    };
  }

  /** A block aligned to 16 bytes; 0 if memory is exhausted. Free it with {@link release}. @param {number} bytes @returns {number} */
  allocate(bytes) {
    const raw = this.#exports.malloc(bytes + 16);
    if (!raw) return 0;
    const block = (raw + 16) & ~15;
    this.#words(block - 4, 1)[0] = raw;
    return block;
  }

  /** @param {number} block of {@link allocate}, or 0 */
  release(block) {
    if (block) this.#exports.free(this.#words(block - 4, 1)[0]);
  }

  /** @param {number} at @param {ArrayLike<number>} numbers */
  writeDoubles(at, numbers) {
    this.#doubles(at, numbers.length).set(numbers);
  }

  /** @param {number} at @param {SurfaceRecord} surface */
  writeSurface(at, surface) {
    const layout = LAYOUT.sp_surface;
    this.#words(at, 4).set([surface.jet, surface.value, surface.kind, surface.metric]);
    this.writeDoubles(at + layout.lower, surface.lower);
    this.writeDoubles(at + layout.upper, surface.upper);
    this.writeDoubles(at + layout.extent, [surface.extent]);
  }

  /**
   * Evaluates a compiled surface at `count` points.
   * @param {(pairs: number, input: number, output: number) => void} evaluate
   * @param {ArrayLike<number>} points `inputs` numbers a point
   * @param {number} inputs @param {number} outputs
   * @returns {Float64Array} `outputs` numbers a point
   */
  evaluate(evaluate, points, inputs, outputs) {
    const count = points.length / inputs;
    const pairs = (count + 1) >> 1;
    const bytes = pairs * 16 * (inputs + outputs);
    if (!this.#reserve(bytes)) throw new RangeError(`surfpath: no memory to evaluate ${count} points; pass fewer at a time`);
    const input = this.#doubles(this.#arenaBase, 2 * pairs * inputs);
    for (let i = 0; i < 2 * pairs; i++) {
      const point = Math.min(i, count - 1) * inputs;
      for (let j = 0; j < inputs; j++) input[2 * (inputs * (i >> 1) + j) + (i & 1)] = points[point + j];
    }
    const at = this.#arenaBase + pairs * 16 * inputs;
    evaluate(pairs, this.#arenaBase, at);
    const output = this.#doubles(at, 2 * pairs * outputs);
    const result = new Float64Array(count * outputs);
    for (let i = 0; i < count; i++)
      for (let j = 0; j < outputs; j++) result[outputs * i + j] = output[2 * (outputs * (i >> 1) + j) + (i & 1)];
    return result;
  }

  /**
   * Runs sp_solve_path.
   * @param {number} surface address of its record
   * @param {{ kind: number, from: number[], to: number[], start: ArrayLike<number> | null }} request
   * @param {SolveOptions} options
   * @returns {RawPath}
   */
  solve(surface, request, options) {
    const { options: optionsAt, request: requestAt, result: resultAt, arena } = this.#structs;
    this.#writeOptions(options);
    const dimension = request.kind === 1 ? 3 : 2;
    const start = request.start;
    const startCount = start ? start.length / dimension : 0;
    const startBytes = (8 * (start ? start.length : 0) + 15) & ~15;
    const bytes = this.#exports.sp_solve_bytes(surface, optionsAt, startCount);
    if (!this.#reserve(startBytes + bytes)) return emptyPath(OUT_OF_MEMORY);
    if (start) this.writeDoubles(this.#arenaBase, start);
    this.writeDoubles(requestAt, [...request.from, 0].slice(0, 3));
    this.writeDoubles(requestAt + LAYOUT.sp_request.to, [...request.to, 0].slice(0, 3));
    this.#words(requestAt + LAYOUT.sp_request.start, 2).set([start ? this.#arenaBase : 0, startCount]);
    this.#words(arena, 3).set([this.#arenaBase + startBytes, this.#arenaSize - startBytes, 0]);
    this.#exports.sp_solve_path(surface, requestAt, optionsAt, arena, resultAt);
    return this.#readResult(options.points + 2);
  }

  /**
   * Runs sp_project_point from `place` downhill.
   * @param {number} surface address of its record @param {number[]} point @param {number[]} place
   * @returns {{ status: number, place: number[] }}
   */
  project(surface, point, place) {
    const at = this.#structs.numbers;
    this.writeDoubles(at, point);
    this.writeDoubles(at + 24, place);
    const status = this.#exports.sp_project_point(surface, at, at + 24);
    return { status, place: Array.from(this.#doubles(at + 24, place.length)) };
  }

  /**
   * Runs sp_mesh_implicit, with as much arena as it asks for.
   * @param {number} value table slot of the surface's value function
   * @param {number[]} box @param {number} resolution
   * @returns {{ status: number, positions: Float64Array, normals: Float64Array, indices: Uint32Array }}
   */
  meshImplicit(value, box, resolution) {
    const { numbers, arena, mesh } = this.#structs;
    this.writeDoubles(numbers, box);
    let vertices = 0;
    let triangles = 0;
    for (let attempt = 0; ; attempt++) {
      const bytes = this.#exports.sp_mesh_bytes(numbers, resolution, vertices, triangles);
      if (!this.#reserve(bytes)) return emptyMesh(OUT_OF_MEMORY);
      this.#words(arena, 3).set([this.#arenaBase, this.#arenaSize, 0]);
      const status = this.#exports.sp_mesh_implicit(value, numbers, resolution, arena, mesh);
      const [positionsAt, normalsAt, indicesAt, vertexCount, triangleCount] = this.#words(mesh, 5);
      if (status === OUT_OF_MEMORY && attempt === 0) {
        [vertices, triangles] = [vertexCount, triangleCount];
        continue;
      }
      if (status !== 0) return emptyMesh(status);
      return {
        status,
        positions: this.#doubles(positionsAt, 3 * vertexCount).slice(),
        normals: this.#doubles(normalsAt, 3 * vertexCount).slice(),
        indices: new Uint32Array(this.#words(indicesAt, 3 * triangleCount)),
      };
    }
  }

  /** @param {SolveOptions} options */
  #writeOptions(options) {
    const at = this.#structs.options;
    this.writeDoubles(at, [options.tolerance, options.gradientTolerance]);
    this.#words(at + 16, 4).set([options.algorithm, options.points, options.maxIterations, options.record ? 1 : 0]);
  }

  /** Copies the result struct and its arrays. @param {number} count points of a polyline @returns {RawPath} */
  #readResult(count) {
    const at = this.#structs.result;
    const [length, lengthError, energy, gradientNorm] = this.#doubles(at, 4);
    const [pointsAt, parametersAt, historyAt, recordAt, status, iterations, index, touches, entries] = this.#words(at + 32, 9);
    const history = this.#readHistory(historyAt, recordAt, entries, count);
    return {
      status,
      length,
      lengthError,
      energy,
      gradientNorm,
      iterations,
      index,
      touchesBoundary: touches !== 0,
      points: pointsAt ? this.#doubles(pointsAt, 3 * count).slice() : new Float64Array(0),
      parameters: parametersAt ? this.#doubles(parametersAt, 2 * count).slice() : null,
      history,
    };
  }

  /** @param {number} at @param {number} recordAt @param {number} entries @param {number} count @returns {Iterate[]} */
  #readHistory(at, recordAt, entries, count) {
    const numbers = this.#doubles(at, 4 * entries);
    const recorded = recordAt ? this.#doubles(recordAt, 3 * count * entries) : null;
    return Array.from({ length: entries }, (_, i) => {
      const [energy, gradientNorm, decrement, step] = numbers.subarray(4 * i, 4 * i + 4);
      /** @type {Iterate} */
      const iterate = { energy, gradientNorm, decrement, step };
      if (recorded) iterate.points = recorded.slice(3 * count * i, 3 * count * (i + 1));
      return iterate;
    });
  }

  /** Makes the arena at least this large; false if memory is exhausted (the arena is then gone, and made anew by the next call). @param {number} bytes */
  #reserve(bytes) {
    if (bytes <= this.#arenaSize) return true;
    if (bytes > 0x7fff0000) return false;
    this.release(this.#arenaBase);
    this.#arenaSize = 0;
    const rounded = (bytes + 0xffff) & ~0xffff;
    this.#arenaBase = this.allocate(rounded);
    if (this.#arenaBase) this.#arenaSize = rounded;
    return this.#arenaBase !== 0;
  }

  /** @param {number} at @param {number} count */
  #doubles(at, count) {
    return new Float64Array(this.#exports.memory.buffer, at, count);
  }

  /** @param {number} at @param {number} count */
  #words(at, count) {
    return new Int32Array(this.#exports.memory.buffer, at, count);
  }
}

/** @param {number} status @returns {RawPath} */
export function emptyPath(status) {
  const none = { length: Number.NaN, lengthError: Number.NaN, energy: Number.NaN, gradientNorm: Number.NaN };
  return { status, ...none, iterations: 0, index: -1, touchesBoundary: false, points: new Float64Array(0), parameters: null, history: [] };
}

/** @param {number} status */
function emptyMesh(status) {
  return { status, positions: new Float64Array(0), normals: new Float64Array(0), indices: new Uint32Array(0) };
}
