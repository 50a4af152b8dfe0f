/** A sketch as the text after # in an address, and back: versioned, and without trust in what stands there. */

import { readSketch, sketchOf } from './sketch.js';

/** @typedef {import('./sketch.js').Sketch} Sketch */

const VERSION = '1';
/** Characters: a sketch of the longest formulas that can be read, in every field and of every letter, is shorter. */
const LONGEST = 500_000;
/** Degrees, and radii of the surface. */
const FARTHEST = 360;

/** @param {unknown} a @param {unknown} b */
const same = (a, b) => JSON.stringify(a) === JSON.stringify(b);

/** Only what differs from the entry, in URL-safe base64 after the version. @param {Sketch} sketch @param {number[]} [view] see `Eye` */
export function toHash(sketch, view = []) {
  const given = sketchOf(sketch.entry);
  const entries = Object.entries(sketch).filter(([name, value]) => name === 'entry' || !same(value, /** @type {any} */ (given)[name]));
  const bytes = new TextEncoder().encode(JSON.stringify({ ...Object.fromEntries(entries), ...(view.length > 0 && { view }) }));
  const text = btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''));
  return `#${VERSION}.${text.replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '')}`;
}

/** @param {string} hash @returns {any} null: nothing of ours */
function read(hash) {
  const [version, text] = hash.replace(/^#/, '').split('.');
  if (version !== VERSION || !text || text.length > LONGEST) return null;
  try {
    const binary = atob(text.replaceAll('-', '+').replaceAll('_', '/'));
    return JSON.parse(new TextDecoder().decode(Uint8Array.from(binary, (character) => character.charCodeAt(0))));
  } catch {
    return null;
  }
}

/** @param {string} hash @returns {Sketch | null} null: no sketch of ours */
export const fromHash = (hash) => readSketch(read(hash));

/** Whence an address looks at its surface; nothing: as it is opened. @param {string} hash @returns {number[]} see `Eye` */
export function viewIn(hash) {
  const view = read(hash)?.view;
  const isView = Array.isArray(view) && [2, 6].includes(view.length) && view.every((x) => Number.isFinite(x) && Math.abs(x) <= FARTHEST);
  return isView ? view : [];
}
