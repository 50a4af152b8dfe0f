/** How the reader's hands change the sketch: each change is kept for undo, then what depends on it is computed anew. */

import { ENTRIES } from './entries.js';
import { deform, follow, rebuild, recolour, solve, viewNow } from '../compute/flow.js';
import { History } from './history.js';
import { fromHash, toHash, viewIn } from './link.js';
import { sketchOf } from './sketch.js';
import { choiceOf, FIRST, render, state } from './state.js';

/** @typedef {import('./sketch.js').Sketch} Sketch */

/** @type {History<Sketch>} */
export const history = new History();

/** What can be changed while the paths stay those that are seen. */
const BESIDE_PATHS = ['chosen', 'colour'];

/** Browsers limit how often the address is rewritten, Safari to 100 times in half a minute: so many times in a row, then once in so many milliseconds. */
const [ROW, PAUSE] = [20, 400];
/** How often it may be now, as of the last time. */
let [left, rewritten] = [ROW, 0];
/** 0: the address holds what is seen; while the view moves. */
let [timer, resting] = [0, 0];

const OF_SURFACE = /** @type {const} */ (['entry', 'kind', 'texts', 'density', 'tensor']);
const OF_PATH = /** @type {const} */ (['task', 'algorithm', 'tolerance', 'points', 'start', 'angle', 'reach']);

/**
 * Changes a part of the sketch.
 * @param {Partial<Sketch>} part
 * @param {string} [key] changes of the same key in quick succession are undone together
 * @param {boolean} [isStep] whether the browser's Back takes it back
 */
export function change(part, key = Object.keys(part).join(), isStep = false) {
  history.keep(state.sketch, key);
  const isBeside = Object.keys(part).every((name) => BESIDE_PATHS.includes(name));
  return turnInto({ ...state.sketch, ...(isBeside ? {} : { chosen: 0 }), ...part }, isStep);
}

/** @param {Sketch} sketch @param {boolean} [isStep] */
function turnInto(sketch, isStep = false) {
  const before = state.sketch;
  const frame = sketch.entry !== before.entry;
  Object.assign(state, { sketch, note: null });
  writeAddress(before, isStep || frame);
  const differs = (/** @type {keyof Sketch} */ name) => JSON.stringify(before[name]) !== JSON.stringify(sketch[name]);
  if (OF_SURFACE.some(differs)) return rebuild({ frame, direction: frame ? ENTRIES[sketch.entry].camera : undefined });
  const names = Object.keys(sketch.parameters);
  if (differs('parameters')) {
    const same = names.join() === Object.keys(before.parameters).join();
    return same ? deform(sketch.parameters) : rebuild({ frame: false });
  }
  if (differs('ends') || differs('via')) return follow();
  if (OF_PATH.some(differs)) return solve(differs('task') || differs('algorithm') || differs('start'));
  state.chosen = choiceOf(sketch, state.solved);
  if (differs('colour')) return recolour();
  return render();
}

/** What was last written of each kind, until the page is left. @type {Partial<Record<import('./kinds.js').Kind, Sketch>>} */
const written = {};

/** Opens an entry of the gallery, or a formula of one's own. @param {string} name @param {Sketch} [sketch] what has been made of it before */
export function choose(name, sketch = sketchOf(name)) {
  const before = state.sketch;
  const isOwn = before.entry === `own-${before.kind}` || JSON.stringify(before.texts) !== JSON.stringify(sketchOf(before.entry).texts);
  if (isOwn) written[before.kind] = before;
  openSketch(sketch);
  writeAddress(before, before.entry !== name);
}

/** Opens what was last written of a kind, else a first formula to change. @param {import('./kinds.js').Kind} kind */
export const chooseKind = (kind) => choose(written[kind]?.entry ?? `own-${kind}`, written[kind]);

/** Opens what an address holds; without, or where that is not ours, the first scene. There the address stays until something is changed. @param {string} hash */
export function openAddress(hash) {
  const sketch = fromHash(hash);
  const isJunk = hash.length > 1 && !sketch;
  openSketch(sketch ?? sketchOf(FIRST), isJunk ? 'The link could not be read; this is the first scene.' : null, viewIn(hash));
  if (!isJunk) writeAddress();
}

/** @param {Sketch} sketch @param {string | null} [note] @param {number[]} [view] */
function openSketch(sketch, note = null, view) {
  // What was to be written was of the sketch before.
  forgetToWrite();
  if (state.surface) history.keep(state.sketch, `open ${sketch.entry}`);
  Object.assign(state, { sketch, note });
  return rebuild({ frame: true, direction: ENTRIES[sketch.entry].camera, view });
}

export function undo() {
  const sketch = history.undo(state.sketch);
  if (sketch) turnInto(sketch);
}

/** Takes the last change back for good: it was not meant. */
export function forget() {
  const sketch = history.forget();
  if (sketch) turnInto(sketch);
}

export function redo() {
  const sketch = history.redo(state.sketch);
  if (sketch) turnInto(sketch);
}

/**
 * The address always holds what is seen: copying it is sharing it. Another surface or measure of length is a step for the browser's Back and Forward, which
 * come as a change of the address; whatever else changes is none, or Back would lead through every place that an end was dragged over.
 * @param {Sketch} [before] what was seen until now @param {boolean} [isStep] away from that
 */
function writeAddress(before = state.sketch, isStep = false) {
  if (isStep && toHash(before) !== toHash(state.sketch)) {
    // Its last changes may not have been written yet.
    window.history.replaceState(null, '', toHash(before));
    window.history.pushState(null, '', toHash(state.sketch));
  }
  // At once: who loads the page anew right after it has not lost it, and while it is left it is too late.
  if (rewritesLeft() >= 1) rewriteAddress();
  else timer ||= window.setTimeout(rewriteAddress, PAUSE);
}

const rewritesLeft = () => Math.min(left + (performance.now() - rewritten) / PAUSE, ROW);

function forgetToWrite() {
  clearTimeout(timer);
  timer = 0;
}

function rewriteAddress() {
  forgetToWrite();
  [left, rewritten] = [rewritesLeft() - 1, performance.now()];
  window.history.replaceState(null, '', linkNow());
}

/** The end of an address that opens what is seen. */
export const linkNow = () => toHash(state.sketch, viewNow());

/** The address holds whence the surface is looked at, too, once that rests. It is nothing to undo. */
export function viewMoved() {
  clearTimeout(resting);
  resting = window.setTimeout(() => String(viewNow()) !== String(viewIn(location.hash)) && writeAddress(), PAUSE);
}
