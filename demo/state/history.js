/**
 * What was there before, to go back to: a list of sketches. Changes of the same thing are one while the mouse or a finger is held down, however long, and,
 * without a hand on anything, in quick succession, as arrow keys make them.
 */

const MOST = 100;
const PAUSE = 900;

/** @template T plain data, not changed in place */
export class History {
  /** @type {T[]} */ #past = [];
  /** @type {T[]} */ #future = [];
  #key = '';
  #time = -Infinity;
  #isHeld = false;
  /** What could be done again before the last change that was kept. @type {T[]} */ #undone = [];

  /** @param {T} before what is about to change @param {string} key what changes */
  keep(before, key) {
    const now = performance.now();
    const goesOn = key === this.#key && (this.#isHeld || now - this.#time < PAUSE);
    [this.#key, this.#time] = [key, now];
    if (goesOn) return;
    [this.#undone, this.#future] = [this.#future, []];
    this.#past.push(before);
    if (this.#past.length > MOST) this.#past.shift();
  }

  /** What changes from now on is one gesture. */
  hold() {
    [this.#isHeld, this.#key] = [true, ''];
  }

  /** The gesture is over: whatever changes next is another one. */
  release() {
    [this.#isHeld, this.#key] = [false, ''];
  }

  /** @param {T} now @returns {T | undefined} */
  undo(now) {
    return this.#move(this.#past, this.#future, now);
  }

  /** Takes the last change back as if it had not been. @returns {T | undefined} */
  forget() {
    [this.#future, this.#undone, this.#key] = [this.#undone, [], ''];
    return this.#past.pop();
  }

  /** @param {T} now @returns {T | undefined} */
  redo(now) {
    return this.#move(this.#future, this.#past, now);
  }

  get canUndo() {
    return this.#past.length > 0;
  }

  get canRedo() {
    return this.#future.length > 0;
  }

  /** @param {T[]} from @param {T[]} to @param {T} now */
  #move(from, to, now) {
    const found = from.pop();
    if (found !== undefined) to.push(now);
    this.#key = '';
    return found;
  }
}
