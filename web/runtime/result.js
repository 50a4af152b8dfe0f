/** What the solver wrote of a path: the structs of a result and of a trace, copied out of its memory. */

import {
  sp_iterate_bytes,
  sp_iterate_energy,
  sp_result_crosses_singularity,
  sp_result_energy,
  sp_result_gradient_norm,
  sp_result_history,
  sp_result_history_count,
  sp_result_index,
  sp_result_iterations,
  sp_result_length,
  sp_result_length_error,
  sp_result_parameters,
  sp_result_points,
  sp_result_record,
  sp_result_rounding,
  sp_result_status,
  sp_result_touches_boundary,
  sp_trace_result_length,
  sp_trace_result_points,
} from './layout.js';

/** @typedef {import('./memory.js').Memory} Memory */

/**
 * One Newton step, or where the path came to rest.
 * @typedef {object} Iterate
 * @property {number} energy E = (n + 1) Σ |chord|², that of elements put on the scale of the last ones
 * @property {number} gradientNorm ‖∇E‖
 * @property {number} decrement √(gᵀH⁻¹g / E), scale-free; NaN where nobody needed it
 * @property {number} step 1: a full Newton step; 0 where the path came to rest
 * @property {Float64Array} [points] with `record`: x y z of that path
 */

/**
 * @typedef {object} RawPath what sp_solve_path or sp_trace_path wrote, copied
 * @property {number} status
 * @property {number} length
 * @property {number} lengthError
 * @property {number} energy
 * @property {number} gradientNorm
 * @property {number} [rounding] what rounding of the coordinates alone may do to the length
 * @property {number} iterations
 * @property {number} index
 * @property {boolean} touchesBoundary
 * @property {boolean} crossesSingularity
 * @property {number | null} conjugate
 * @property {Float64Array} points
 * @property {Float64Array | null} parameters
 * @property {Iterate[]} history
 * @property {(options: import('./heap.js').SolveOptions) => RawPath} [again] solves it as asked, where so far it was as others can be compared with
 * @property {string} [turns] how often it leads around, where paths that differ in that are not the same
 * @property {{ velocity: number[], turn: number, field: number, slope: number }} [end] of a trace: turn: error of the velocity's direction; field, slope: of the Jacobi field that vanishes at the start
 */

/** @param {number} status @returns {RawPath} */
export function emptyPath(status) {
  return {
    status,
    length: Number.NaN,
    lengthError: Number.NaN,
    energy: Number.NaN,
    gradientNorm: Number.NaN,
    iterations: 0,
    index: -1,
    touchesBoundary: false,
    crossesSingularity: false,
    conjugate: null,
    points: new Float64Array(0),
    parameters: null,
    history: [],
  };
}

/** Copies a struct sp_result and its arrays. @param {Memory} memory @param {number} at its address @param {number} count points of a polyline @returns {RawPath} */
export function readResult(memory, at, count) {
  const words = memory.allWords();
  const word = (/** @type {number} */ offset) => words[(at + offset) >> 2];
  const doubles = memory.allDoubles();
  const parametersAt = word(sp_result_parameters);
  return {
    status: word(sp_result_status),
    length: doubles[(at + sp_result_length) >> 3],
    lengthError: doubles[(at + sp_result_length_error) >> 3],
    energy: doubles[(at + sp_result_energy) >> 3],
    gradientNorm: doubles[(at + sp_result_gradient_norm) >> 3],
    rounding: doubles[(at + sp_result_rounding) >> 3],
    iterations: word(sp_result_iterations),
    index: word(sp_result_index),
    touchesBoundary: word(sp_result_touches_boundary) !== 0,
    crossesSingularity: word(sp_result_crosses_singularity) !== 0,
    conjugate: null,
    points: word(sp_result_points) ? memory.copyDoubles(word(sp_result_points), 3 * count) : new Float64Array(0),
    parameters: parametersAt ? memory.copyDoubles(parametersAt, 2 * count) : null,
    history: readHistory(memory, word(sp_result_history), word(sp_result_record), word(sp_result_history_count), count),
  };
}

/** @param {Memory} memory @param {number} at @param {number} recordAt @param {number} entries @param {number} count @returns {Iterate[]} */
function readHistory(memory, at, recordAt, entries, count) {
  const doubles = memory.allDoubles();
  /** @type {Iterate[]} */
  const history = [];
  for (let i = 0; i < entries; i++) {
    const k = (at + sp_iterate_bytes * i + sp_iterate_energy) >> 3;
    /** @type {Iterate} */
    const iterate = { energy: doubles[k], gradientNorm: doubles[k + 1], decrement: doubles[k + 2], step: doubles[k + 3] };
    if (recordAt) iterate.points = memory.copyDoubles(recordAt + 24 * count * i, 3 * count);
    history.push(iterate);
  }
  return history;
}

/** Copies a struct sp_trace_result and its arrays. @param {Memory} memory @param {number} at its address @param {number} count points of the path @returns {RawPath | null} null: the direction is normal to the surface */
export function readTrace(memory, at, count) {
  const [length, lengthError, conjugate, x, y, z, turn, field, slope] = memory.doubles(at + sp_trace_result_length, 9);
  const [pointsAt, parametersAt, status, steps, touches, normal] = memory.words(at + sp_trace_result_points, 6);
  if (normal) return null;
  if (!pointsAt && !parametersAt) return emptyPath(status);
  return {
    ...emptyPath(status),
    length,
    lengthError,
    iterations: steps,
    touchesBoundary: touches !== 0,
    conjugate: Number.isNaN(conjugate) ? null : conjugate,
    points: pointsAt ? memory.copyDoubles(pointsAt, 3 * count) : new Float64Array(0),
    parameters: parametersAt ? memory.copyDoubles(parametersAt, 2 * count) : null,
    end: { velocity: parametersAt ? [x, y] : [x, y, z], turn, field, slope },
  };
}
