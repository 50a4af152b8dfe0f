/**
 * One instance of the solver: instantiates the module, installs compiled surfaces in its function table, reuses freed slots.
 * After a trap, or where the engine's own stack was full, the instance is dropped and made anew from the same module; surfaces then install
 * themselves again (see `generation`).
 */

import { Heap } from './heap.js';
import { sp_surface_bytes } from './layout.js';

/** A module of a few bytes that is valid only where f64x2 arithmetic is. */
const SIMD_PROBE = new Uint8Array([
  0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11,
]);

/** What is said where the memory has run out, after who says it. */
export const EXHAUSTED = 'WebAssembly memory is exhausted; dispose() surfaces you no longer need';

/** @typedef {URL | string | Response | BufferSource | WebAssembly.Module} WasmSource */

/** Throws, in words, where the solver cannot run. */
function checkEngine() {
  if (typeof WebAssembly !== 'object') throw new Error('surfpath needs WebAssembly; this browser has none, or a policy forbids it');
  if (!WebAssembly.validate(SIMD_PROBE)) throw new Error('surfpath needs WebAssembly SIMD: use a browser or Node of 2022 or later');
}

/**
 * The bytes behind a URL: fetched, or, as Node.js does not fetch files, read. Not by `import`, behind which every bundler for browsers would look.
 * @param {string} caller @param {URL | string} url
 * @returns {Promise<Response | BufferSource>}
 */
async function open(caller, url) {
  const target = String(url);
  if (!globalThis.location && !URL.canParse(target))
    throw new TypeError(`${caller}: options.wasm '${target}' has no base here: pass new URL('${target}', import.meta.url), or the bytes`);
  const files = target.startsWith('file:') && globalThis.process?.getBuiltinModule?.('node:fs/promises');
  try {
    return await (files ? files.readFile(new URL(target)) : fetch(target));
  } catch (error) {
    throw new Error(`${caller}: options.wasm '${target}' failed: ${/** @type {Error} */ (error).message}`);
  }
}

/** @param {BufferSource} bytes @param {string} name of what they are @returns {Promise<WebAssembly.Module>} */
const compile = (bytes, name) =>
  WebAssembly.compile(bytes).catch((error) => {
    // A policy may forbid it, too. A server that answers every address with its start page does not.
    throw WebAssembly.validate(bytes) ? error : new TypeError(`${name} is not surfpath.wasm`);
  });

/**
 * Compiles the solver's module.
 * @param {string} caller
 * @param {() => WasmSource | Promise<WasmSource>} find gives the module, its bytes, or where they are, once WebAssembly is known to be there
 * @returns {Promise<WebAssembly.Module>}
 */
export async function compileSolver(caller, find) {
  checkEngine();
  const source = await find();
  if (source instanceof WebAssembly.Module) return source;
  const found = typeof source === 'string' || source instanceof URL ? await open(caller, source) : source;
  // Bytes first: to name Response takes Node.js 10 ms of a cold process.
  if (found instanceof ArrayBuffer || ArrayBuffer.isView(found))
    return compile(/** @type {BufferSource} */ (found), `${caller}: options.wasm`);
  if (typeof Response !== 'function' || !(found instanceof Response))
    throw new TypeError(`${caller}: options.wasm must be a URL, a string, a Response, bytes or a WebAssembly.Module`);
  const name = `${caller}: ${found.url || 'options.wasm'}`;
  if (!found.ok) throw new Error(`${name} answered ${found.status}; it should be the file surfpath.wasm`);
  if (found.bodyUsed) throw new TypeError(`${name} was read before; pass the bytes`);
  return compile(await found.arrayBuffer(), name);
}

/** What a surface is compiled to: its parameters and constants, and the room it wants for them and its scratch. @typedef {{ module: Uint8Array, data: Float64Array, dataBytes: number }} Module */
/** What a compiled surface needs from the solver: table slots, the addresses of its data and of a struct sp_surface, and where: see `generation`. @typedef {{ jet: number, value: number, data: number, record: number, generation: number }} Slots */

export class Solver {
  #module;
  /** The present instance; null: the next call makes one. @type {{ exports: any, heap: Heap } | null} */ #instance = null;
  /** @type {number[]} */ #freeSlots = [];
  /** Counts instances, from 1: what was installed in an earlier one is gone. */
  generation = 1;

  /** @param {WebAssembly.Module} module */
  constructor(module) {
    this.#module = module;
    this.#instance = this.#instantiate();
  }

  get heap() {
    return this.#present.heap;
  }

  /** One elementary function of one or two numbers, with the bits that compiled surfaces get. @type {(code: number, x: number, y: number) => number} */
  apply = (code, x, y) => this.run(() => this.#present.exports.sp_apply_function(code, x, y));

  /**
   * Runs a call into the instance. An error is a trap, which only a bug can cause, or a stack that the caller has filled: both leave the instance's
   * own stack in disorder. It is dropped, and the next call finds a sound one.
   * @template T @param {() => T} call @returns {T}
   */
  run(call) {
    try {
      return call();
    } catch (error) {
      this.#instance = null;
      this.generation++;
      throw error;
    }
  }

  /**
   * Evaluates a compiled surface at points, as {@link Heap.evaluate}.
   * @param {(pairs: number, input: number, output: number) => void} compiled @param {ArrayLike<number>} points @param {number} inputs @param {number} outputs
   * @returns {Float64Array}
   */
  evaluate(compiled, points, inputs, outputs) {
    const numbers = this.run(() => this.heap.evaluate(compiled, points, inputs, outputs));
    if (numbers) return numbers;
    throw new RangeError(`surfpath: no memory to evaluate ${points.length / inputs} points; pass fewer at a time`);
  }

  /**
   * Installs a compiled surface; all of it or, with an error, nothing.
   * @param {Module} compiled
   * @returns {Slots & { call: { jet: (pairs: number, input: number, output: number) => void, value: (pairs: number, input: number, output: number) => void } }}
   */
  install({ module, data, dataBytes }) {
    const { heap, exports } = this.#present;
    const blocks = { data: heap.allocate(dataBytes), record: heap.allocate(sp_surface_bytes) };
    try {
      if (!blocks.data || !blocks.record) throw new RangeError(`surfpath: ${EXHAUSTED}`);
      heap.writeDoubles(blocks.data, data);
      const env = { ...exports, data: new WebAssembly.Global({ value: 'i32' }, blocks.data) };
      const instance = new WebAssembly.Instance(new WebAssembly.Module(/** @type {BufferSource} */ (module)), { env });
      const call = /** @type {any} */ (instance.exports);
      return { jet: this.#occupy(call.jet), value: this.#occupy(call.value), ...blocks, generation: this.generation, call };
    } catch (error) {
      for (const block of [blocks.data, blocks.record]) heap.release(block);
      throw error;
    }
  }

  /** Installs what belongs together: all or, with an error, nothing. @param {Module[]} modules */
  installAll(modules) {
    /** @type {ReturnType<Solver['install']>[]} */
    const installed = [];
    try {
      for (const compiled of modules) installed.push(this.install(compiled));
    } catch (error) {
      for (const slots of installed) this.remove(slots);
      throw error;
    }
    return installed;
  }

  /** @param {Slots} slots of {@link install}; those of an earlier instance are gone already */
  remove({ jet, value, data, record, generation }) {
    if (generation !== this.generation) return;
    const { heap, exports } = this.#present;
    for (const slot of [jet, value]) {
      exports.__indirect_function_table.set(slot, null);
      this.#freeSlots.push(slot);
    }
    for (const block of [data, record]) heap.release(block);
  }

  /** @param {Function} compiled @returns {number} the slot */
  #occupy(compiled) {
    const table = this.#present.exports.__indirect_function_table;
    const slot = this.#freeSlots.pop() ?? table.grow(1);
    table.set(slot, compiled);
    return slot;
  }

  get #present() {
    this.#instance ??= this.#instantiate();
    return this.#instance;
  }

  #instantiate() {
    const exports = /** @type {any} */ (new WebAssembly.Instance(this.#module).exports);
    if (!exports.sp_solve_path) throw new TypeError('load: options.wasm is not surfpath.wasm');
    this.#freeSlots = [];
    return { exports, heap: new Heap(exports) };
  }
}
