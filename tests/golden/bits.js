/** A hash of the bits of numbers, the same in JavaScript and, in native.c, in C. The bits of a NaN differ between engines: any NaN counts as one token. */

const number = new Float64Array(1);
const words = new Uint32Array(number.buffer);

/** @param {number} x @param {number} by */
const rotate = (x, by) => (x << by) | (x >>> (32 - by));

export class BitHash {
  #a = 0x243f6a88;
  #b = 0x85a308d3;

  /** @param {number} x */
  add(x) {
    number[0] = Number.isNaN(x) ? 0 : x;
    const [low, high] = Number.isNaN(x) ? [0, 0x7ff80000] : words;
    this.#a = rotate(Math.imul(this.#a ^ low, 0x9e3779b1), 13);
    this.#b = rotate(Math.imul(this.#b ^ high ^ this.#a, 0x85ebca6b), 17);
  }

  /** @param {ArrayLike<number>} numbers */
  addAll(numbers) {
    for (let i = 0; i < numbers.length; i++) this.add(numbers[i]);
  }

  /** @returns {string} 16 hexadecimal digits */
  toString() {
    return [this.#a, this.#b].map((word) => (word >>> 0).toString(16).padStart(8, '0')).join('');
  }
}

/** enum sp_status of wasm/status.h, from 0 and from -1. */
const STATUS = ['converged', 'iteration-limit', 'stalled', 'tolerance-not-met', 'ill-conditioned', 'saddle', 'edge-reached'];
const NO_PATH = ['disconnected', 'singular-metric', 'sheet-jump', 'off-surface', 'not-finite', 'out-of-memory'];

/** All numbers of a path. @param {BitHash} hash @param {import('../../web/path.js').Path} path */
export function addPath(hash, path) {
  const { status, length, lengthError, energy, gradientNorm, iterations, index, touchesBoundary, crossesSingularity } = path;
  const code = STATUS.includes(status) ? STATUS.indexOf(status) : -1 - NO_PATH.indexOf(status);
  hash.addAll([code, length, lengthError, energy, gradientNorm, iterations, index, Number(touchesBoundary), Number(crossesSingularity)]);
  hash.addAll(path.points);
  if (path.parameters) hash.addAll(path.parameters);
  for (const iterate of path.history) {
    hash.addAll([iterate.energy, iterate.gradientNorm, iterate.decrement, iterate.step]);
    if (iterate.points) hash.addAll(iterate.points);
  }
  if (path.conjugate !== null) hash.add(path.conjugate);
}
