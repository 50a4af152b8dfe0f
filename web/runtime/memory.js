/**
 * The solver's linear memory: blocks of it, an arena for one call at a time, and numbers in and out. The only file that makes views of it. They are
 * asked for right before use, because memory may grow in any call; what leaves `web/runtime/` is a copy.
 */

import { sp_arena_bytes } from './layout.js';

export class Memory {
  /** Of the solver. @type {any} */ exports;
  /** Address of the arena's struct. */
  #arena;
  /** Where the arena begins. */
  arenaBase = 0;
  #arenaSize = 0;
  #float64 = new Float64Array(0);
  #int32 = new Int32Array(0);

  /** @param {WebAssembly.Exports} exports */
  constructor(exports) {
    this.exports = exports;
    this.#arena = this.allocate(sp_arena_bytes);
  }

  /** A block aligned to 16 bytes; 0 if memory is exhausted. Free it with {@link release}. @param {number} bytes @returns {number} */
  allocate(bytes) {
    const raw = this.exports.malloc(bytes + 16);
    if (!raw) return 0;
    const block = (raw + 16) & ~15;
    this.words(block - 4, 1)[0] = raw;
    return block;
  }

  /** @param {number} block of {@link allocate}, or 0 */
  release(block) {
    if (block) this.exports.free(this.words(block - 4, 1)[0]);
  }

  /** @param {number} at @param {ArrayLike<number>} numbers */
  writeDoubles(at, numbers) {
    this.doubles(at, numbers.length).set(numbers);
  }

  /** Two or three numbers, as three. @param {number} at @param {number[]} point */
  writePoint(at, point) {
    const doubles = this.allDoubles();
    for (let j = 0; j < 3; j++) doubles[(at >> 3) + j] = point[j] ?? 0;
  }

  /** @param {number} at @param {number} a @param {number} b @param {number} c */
  writeWords(at, a, b, c) {
    const words = this.allWords();
    const i = at >> 2;
    words[i] = a;
    words[i + 1] = b;
    words[i + 2] = c;
  }

  /** A copy. @param {number} at @param {number} count */
  copyDoubles(at, count) {
    return this.allDoubles().slice(at >> 3, (at >> 3) + count);
  }

  /** Makes the arena at least this large; false if memory is exhausted (the arena is then gone, and made anew by the next call). @param {number} bytes */
  reserve(bytes) {
    if (bytes <= this.#arenaSize) return true;
    if (bytes > 0x7fff0000) return false;
    this.release(this.arenaBase);
    this.#arenaSize = 0;
    const rounded = (bytes + 0xffff) & ~0xffff;
    this.arenaBase = this.allocate(rounded);
    if (this.arenaBase) this.#arenaSize = rounded;
    return this.arenaBase !== 0;
  }

  /** An arena for the next call, all but its first bytes; the address of its struct. */
  openArena(taken = 0) {
    this.writeWords(this.#arena, this.arenaBase + taken, this.#arenaSize - taken, 0);
    return this.#arena;
  }

  /** All memory; made anew where it grew, which detaches the last view. */
  allDoubles() {
    if (this.#float64.length === 0) this.#float64 = new Float64Array(this.exports.memory.buffer);
    return this.#float64;
  }

  allWords() {
    if (this.#int32.length === 0) this.#int32 = new Int32Array(this.exports.memory.buffer);
    return this.#int32;
  }

  /** @param {number} at @param {number} count */
  doubles(at, count) {
    return new Float64Array(this.exports.memory.buffer, at, count);
  }

  /** @param {number} at @param {number} count */
  words(at, count) {
    return new Int32Array(this.exports.memory.buffer, at, count);
  }
}
