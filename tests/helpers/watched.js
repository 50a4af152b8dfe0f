/** An instance of the library with the solver behind it in view: its memory measured, its allocations refused, its calls made to trap. */
import { load } from '../../web/index.js';

/** @typedef {import('../../web/instance.js').Surfpath} Surfpath */
/**
 * @typedef {{ memory: WebAssembly.Memory, __indirect_function_table: WebAssembly.Table, malloc: (bytes: number) => number }} Solver
 */

/**
 * Loads an instance and watches what it instantiates.
 * @param {(exports: any) => any} [change] what the library gets to see of the solver's exports
 * @param {{ wasm?: Uint8Array<ArrayBuffer> }} [options] of `load`
 * @returns {Promise<{ surfpath: Surfpath, solver: Solver }>}
 */
export async function loadWatched(change = (exports) => exports, options = {}) {
  const { Instance } = WebAssembly;
  /** @type {any} */ let solver;
  WebAssembly.Instance = class extends Instance {
    #seen;
    /** @param {WebAssembly.Module} module @param {WebAssembly.Imports} [imports] */
    constructor(module, imports) {
      super(module, imports);
      const exports = /** @type {any} */ (super.exports);
      if (exports.malloc) solver = exports;
      this.#seen = exports.malloc ? change({ ...exports }) : exports;
    }

    get exports() {
      return this.#seen;
    }
  };
  try {
    const surfpath = await load(options);
    return { surfpath, solver };
  } finally {
    WebAssembly.Instance = Instance;
  }
}

/** Loads an instance whose allocations can be refused, and are counted. */
export async function loadRefusing() {
  const state = { allocations: 0, from: Infinity, to: Infinity };
  /** @type {Set<number>} */ const live = new Set();
  const { surfpath, solver } = await loadWatched((exports) => ({
    ...exports,
    malloc: (/** @type {number} */ bytes) => {
      const number = state.allocations++;
      const address = number >= state.from && number < state.to ? 0 : exports.malloc(bytes);
      if (address) live.add(address);
      return address;
    },
    free: (/** @type {number} */ address) => {
      if (!live.delete(address)) throw new Error(`${address} is freed, but not allocated`);
      exports.free(address);
    },
  }));
  return {
    surfpath,
    /** How many blocks are allocated, and slots of the table in use. */
    held() {
      const table = solver.__indirect_function_table;
      let slots = 0;
      for (let i = 0; i < table.length; i++) if (table.get(i)) slots++;
      return { blocks: live.size, slots };
    },
    /** From now on, refuses allocations `first` … `first` + `count` - 1. @param {number} first @param {number} [count] */
    refuse(first, count = Infinity) {
      Object.assign(state, { allocations: 0, from: first, to: first + count });
    },
    /** Refuses nothing any more. @returns {boolean} whether anything was refused */
    allow() {
      const refused = state.allocations > state.from;
      state.from = state.to = Infinity;
      return refused;
    },
  };
}

/**
 * How much memory and table there are, and how many blocks of 256 bytes still fit: what the tests compare. Fills the memory until it grows, so
 * an instance can be asked once.
 * @param {Solver} solver
 */
export function footprint({ memory, __indirect_function_table: table, malloc }) {
  const { byteLength } = memory.buffer;
  let blocks = 0;
  while (memory.buffer.byteLength === byteLength && malloc(256)) blocks++;
  return { byteLength, slots: table.length, blocks };
}

/** @param {number[]} bytes @param {number} value appended as unsigned LEB128 */
function appendLeb(bytes, value) {
  for (; value > 127; value = Math.floor(value / 128)) bytes.push((value % 128) | 128);
  bytes.push(value);
}

/** @param {Uint8Array} bytes @param {number} at @returns {[number, number]} an unsigned LEB128 number and where it ends */
function readLeb(bytes, at) {
  let [value, factor] = [0, 1];
  for (; ; factor *= 128) {
    const byte = bytes[at++];
    value += (byte & 127) * factor;
    if (byte < 128) return [value, at];
  }
}

/**
 * The solver's module with another limit of its memory, at which `memory.grow` is refused.
 * @param {Uint8Array} module @param {number} pages of 64 KB
 * @returns {Uint8Array<ArrayBuffer>}
 */
export function limitMemory(module, pages) {
  const MEMORY = 5;
  for (let at = 8; at < module.length; ) {
    const [size, start] = readLeb(module, at + 1);
    if (module[at] === MEMORY) {
      const [initial] = readLeb(module, start + 2);
      /** @type {number[]} */ const content = [1, 1];
      for (const number of [initial, pages]) appendLeb(content, number);
      /** @type {number[]} */ const head = [MEMORY];
      appendLeb(head, content.length);
      return Uint8Array.from([...module.subarray(0, at), ...head, ...content, ...module.subarray(start + size)]);
    }
    at = start + size;
  }
  throw new Error('the module has no memory of its own');
}
