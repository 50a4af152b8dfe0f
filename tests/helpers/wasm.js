/* The solver's module without its JavaScript face: for tests of what compiled expressions alone compute. */

import { readFileSync } from 'node:fs';

/** @typedef {import('../../web/expression/compile.js').Compiled} Compiled */

const BUILT = new URL('../../dist/surfpath.wasm', import.meta.url);

/**
 * Instantiates the solver's module.
 * @param {URL | string} [path] which file; default: what `make` built
 */
export function instantiate(path = BUILT) {
  const module = new WebAssembly.Module(readFileSync(path));
  const { exports } = new WebAssembly.Instance(module);
  const solver = /** @type {Record<string, any>} */ (exports);
  return {
    exports: solver,
    apply: /** @type {import('../../web/expression/graph.js').Apply} */ (solver.sp_apply_function),
    /** @param {Compiled} compiled @param {number} inputCount how many variables there are */
    link: (compiled, inputCount) => link(solver, compiled, inputCount),
  };
}

/**
 * Makes a compiled expression callable from tests, which hand over and get plain numbers.
 * @param {Record<string, any>} solver
 * @param {Compiled} compiled
 * @param {number} inputCount how many variables there are
 */
function link(solver, compiled, inputCount) {
  const data = allocate(solver, compiled.dataBytes);
  new Float64Array(solver.memory.buffer, data, compiled.data.length).set(compiled.data);
  const env = { memory: solver.memory, data, ...Object.fromEntries(Object.entries(solver).filter(([name]) => name.startsWith('sp_'))) };
  const instance = new WebAssembly.Instance(new WebAssembly.Module(compiled.module), { env });
  const { jet, value } = /** @type {Record<string, any>} */ (instance.exports);
  return {
    data: () => new Float64Array(solver.memory.buffer, data, compiled.data.length),
    /** @param {ArrayLike<number>[]} points @returns {Float64Array[]} */
    jet: (points) => evaluate(solver, jet, points, inputCount, compiled.jet.length),
    /** @param {ArrayLike<number>[]} points @returns {Float64Array[]} */
    value: (points) => evaluate(solver, value, points, inputCount, compiled.value.length),
    functions: { jet, value },
  };
}

/**
 * Lays the points out in pairs, calls the function, and takes the results apart again. An odd last point shares its pair with a NaN.
 * @param {Record<string, any>} solver
 * @param {(pairCount: number, input: number, output: number) => void} call
 * @param {ArrayLike<number>[]} points
 * @param {number} inputCount
 * @param {number} outputCount
 */
function evaluate(solver, call, points, inputCount, outputCount) {
  const pairCount = Math.ceil(points.length / 2);
  const input = allocate(solver, 16 * pairCount * inputCount);
  const output = allocate(solver, 16 * pairCount * outputCount + 16);
  const numbers = new Float64Array(solver.memory.buffer, input, 2 * pairCount * inputCount).fill(Number.NaN);
  points.forEach((point, k) => {
    for (let j = 0; j < inputCount; j++) numbers[place(k, j, inputCount)] = point[j];
  });
  const guard = new Float64Array(solver.memory.buffer, output + 16 * pairCount * outputCount, 2).fill(-12345);
  call(pairCount, input, output);
  if (guard.some((number) => number !== -12345)) throw new Error('wrote past the end of its output');
  const results = new Float64Array(solver.memory.buffer, output, 2 * pairCount * outputCount);
  return points.map((_, k) => Float64Array.from({ length: outputCount }, (_, j) => results[place(k, j, outputCount)]));
}

/** @param {number} point @param {number} column @param {number} columns */
function place(point, column, columns) {
  return 2 * (columns * (point >> 1) + column) + (point & 1);
}

/** Memory for a test, aligned to 16 (malloc promises 8) and never given back. @param {Record<string, any>} solver @param {number} bytes */
function allocate(solver, bytes) {
  const address = solver.malloc(bytes + 16);
  if (address === 0) throw new Error('out of memory');
  return (address + 15) & ~15;
}
