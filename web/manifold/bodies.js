/** What boxes hold of an implicit surface: how far it extends there, and it stretched, where it is flat. Each is found once. */

import { gap } from '../vector.js';
import { findExtent, flatnessOf, isCrossed, isCut } from './extent.js';
import { Stretched } from './stretched.js';

/** @typedef {import('./extent.js').Extent} Extent */
/** @typedef {import('./stretched.js').Given & { values: (places: ArrayLike<number>) => Float64Array }} Given values: f and ∇f */
/** @typedef {{ extent: Extent | null, stretched?: Stretched | null }} Body */

/** Bodies that are so many times as long as thick are flat. */
const FLAT = 8;
/** So many are kept. */
const MOST = 4;
/** Without bounds a body is looked for in cubes around the ends, of at least so many times their distance, each twice as wide as the one before, so many. */
const [WIDE, CUBES] = [4, 8];
/** Not for ends nearer than this, or as far as its inverse. */
const SMALLEST = 1e-100;

export class Bodies {
  #given;
  /** @type {Map<string, Body>} by box */ #known = new Map();

  /** @param {Given} given */
  constructor(given) {
    this.#given = given;
  }

  /** How far the surface extends in a box; null: too little of it is there. @param {number[]} box */
  extentIn(box) {
    return this.#find(box).extent;
  }

  /** What a box holds, stretched; null: it is not flat, or there is no room. @param {number[]} box @returns {Stretched | null} */
  stretchedIn(box) {
    const body = this.#find(box);
    body.stretched ??= this.#stretch(body.extent);
    return body.stretched;
  }

  /** The body around two ends, stretched; null: none is flat that ends near them. @param {number[][]} ends */
  stretchedAround([from, to]) {
    const least = WIDE * gap(from, to);
    if (!(least > SMALLEST && least < 1 / SMALLEST)) return null;
    /* A power of two, in steps of half its width: other ends lie in the same cubes. */
    let width = 1;
    while (width < least) width *= 2;
    while (width >= 2 * least) width /= 2;
    for (let i = 0; i < CUBES; i++, width *= 2) {
      const box = from.flatMap((x, j) => {
        const low = (Math.round((x + to[j]) / width) / 2 - 0.5) * width;
        return [low, low + width];
      });
      if (isCrossed(this.#given.values, box)) continue;
      const { extent } = this.#find(box);
      if (extent && !isCut(extent, box)) return this.stretchedIn(box);
    }
    return null;
  }

  /** @param {import('../runtime/heap.js').Heap | null} heap null: the memory is gone already */
  drop(heap) {
    for (const { stretched } of this.#known.values()) stretched?.drop(heap);
    this.#known.clear();
  }

  /** @param {number[]} box @returns {Body} */
  #find(box) {
    const key = box.join();
    const known = this.#known.get(key);
    if (known) return known;
    const body = { extent: findExtent(this.#given.values, box) };
    const [oldest] = this.#known.keys();
    if (this.#known.size >= MOST) {
      this.#known.get(oldest)?.stretched?.drop(this.#given.solver.heap);
      this.#known.delete(oldest);
    }
    this.#known.set(key, body);
    return body;
  }

  /** @param {Extent | null} extent */
  #stretch(extent) {
    if (!extent || !(flatnessOf(extent) > FLAT) || this.#given.measure.metric) return null;
    try {
      return new Stretched(this.#given, extent);
    } catch {
      /* No memory, or more than a module may hold: it goes without, this time. */
      return null;
    }
  }
}
