/**
 * One instance of the solver: instantiates the module, installs compiled surfaces in its function table, reuses freed slots.
 * After a trap the instance is dropped and made anew from the same module; surfaces then install themselves again (see `generation`).
 */

import { Heap } from './heap.js';

/** A module of a few bytes that is valid only where f64x2 arithmetic is. */
const SIMD_PROBE = new Uint8Array([
  0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11,
]);

/** @typedef {URL | string | Response | BufferSource | WebAssembly.Module} WasmSource */

/** Throws, in words, where the solver cannot run. */
function checkEngine() {
  if (typeof WebAssembly !== 'object') throw new Error('surfpath needs WebAssembly, which this browser does not have or a policy forbids');
  if (!WebAssembly.validate(SIMD_PROBE)) throw new Error('surfpath needs WebAssembly SIMD: use a browser or Node.js of 2022 or later');
}

/**
 * The bytes behind a URL: fetched, or, as Node.js does not fetch files, read. Not by `import`, behind which every bundler for browsers would look.
 * @param {URL | string} url
 * @returns {Promise<Response | BufferSource>}
 */
async function open(url) {
  const target = String(url);
  const files = target.startsWith('file:') && globalThis.process?.getBuiltinModule?.('node:fs/promises');
  return files ? files.readFile(new URL(target)) : fetch(target);
}

/**
 * Compiles the solver's module.
 * @param {WasmSource | Promise<WasmSource>} given the module, its bytes, or where they are
 * @returns {Promise<WebAssembly.Module>}
 */
export async function compileSolver(given) {
  checkEngine();
  const source = await given;
  if (source instanceof WebAssembly.Module) return source;
  const found = typeof source === 'string' || source instanceof URL ? await open(source) : source;
  if (typeof Response === 'function' && found instanceof Response) {
    if (!found.ok) throw new Error(`surfpath: ${found.url} answered ${found.status}; it should be the file surfpath.wasm`);
    return WebAssembly.compile(await found.arrayBuffer());
  }
  if (!(found instanceof ArrayBuffer) && !ArrayBuffer.isView(found))
    throw new TypeError('load: options.wasm must be a URL, a string, a Response, bytes or a WebAssembly.Module');
  return WebAssembly.compile(/** @type {BufferSource} */ (found));
}

/** What a compiled surface needs from the solver: table slots and the address of its data. @typedef {{ jet: number, value: number, data: number }} Slots */

export class Solver {
  #module;
  /** @type {any} */ #exports;
  /** @type {Heap} */ #heap;
  /** @type {number[]} */ #freeSlots = [];
  /** Counts instances: what was installed in an earlier one is gone. */
  generation = 0;

  /** @param {WebAssembly.Module} module */
  constructor(module) {
    this.#module = module;
    this.#exports = null;
    this.#heap = this.#instantiate();
  }

  get heap() {
    return this.#heap;
  }

  /** One elementary function of one or two numbers, with the bits that compiled surfaces get. @type {(code: number, x: number, y: number) => number} */
  apply = (code, x, y) => this.#exports.sp_apply_function(code, x, y);

  /** Runs a call into the instance. A trap (which only a bug can cause) drops the instance, so that the next call finds a sound one. @template T @param {() => T} call @returns {T} */
  run(call) {
    try {
      return call();
    } catch (error) {
      if (error instanceof WebAssembly.RuntimeError) this.#heap = this.#instantiate();
      throw error;
    }
  }

  /**
   * Installs a compiled surface.
   * @param {Uint8Array} bytes its module @param {Float64Array} data its parameters and constants @param {number} dataBytes room it wants for them and its scratch
   * @returns {Slots & { call: { jet: (pairs: number, input: number, output: number) => void, value: (pairs: number, input: number, output: number) => void } }}
   */
  install(bytes, data, dataBytes) {
    const address = this.#heap.allocate(dataBytes);
    if (!address) throw new RangeError('surfpath: WebAssembly memory is exhausted; dispose() surfaces that are no longer needed');
    this.#heap.writeDoubles(address, data);
    const env = { ...this.#exports, data: new WebAssembly.Global({ value: 'i32' }, address) };
    const instance = new WebAssembly.Instance(new WebAssembly.Module(/** @type {BufferSource} */ (bytes)), { env });
    const call = /** @type {any} */ (instance.exports);
    return { jet: this.#occupy(call.jet), value: this.#occupy(call.value), data: address, call };
  }

  /** @param {Slots} slots of {@link install} */
  remove({ jet, value, data }) {
    for (const slot of [jet, value]) {
      this.#exports.__indirect_function_table.set(slot, null);
      this.#freeSlots.push(slot);
    }
    this.#heap.release(data);
  }

  /** @param {Function} compiled @returns {number} the slot */
  #occupy(compiled) {
    const table = this.#exports.__indirect_function_table;
    const slot = this.#freeSlots.pop() ?? table.grow(1);
    table.set(slot, compiled);
    return slot;
  }

  #instantiate() {
    const env = { emscripten_notify_memory_growth() {} };
    this.#exports = new WebAssembly.Instance(this.#module, { env }).exports;
    this.#exports._initialize();
    this.#freeSlots = [];
    this.generation++;
    return new Heap(this.#exports);
  }
}
