/** A job of a pool: a call, cut into chunks that workers answer, and put together again. Knows what is handed out, but not to whom. */

/** Milliseconds that a chunk should take: long against the way of a message, short against the wait for an abort. */
const CHUNK = 8;
/** Chunks grow by this factor at most: the first pairs tell little of the others. */
const GROWTH = 4;
const MOST_UNITS = 4096;
/** Nothing takes less, whatever a coarse clock says. */
const LEAST_MILLISECONDS = 0.05;

/**
 * @typedef {object} Task what a call asks for: a row of independent units, such as pairs
 * @property {number} total how many, ≥ 1
 * @property {boolean} isBatch false: one unit, that cannot be cut
 * @property {(first: number, count: number) => import('./worker.js').Question} ask
 * @property {(first: number, value: any) => void} store what a worker answered, from that unit on
 * @property {(unit: number) => void} lose a unit that two workers died of; may throw
 * @property {() => any} result when all is stored
 * @property {(error: import('./wire.js').PackedError) => Error} unpack
 * @property {((progress: { done: number, total: number }) => void) | undefined} onProgress
 */

/** @typedef {{ first: number, count: number, again: boolean }} Chunk again: a worker died of it before */

export class Job {
  #task;
  /** @type {Chunk[]} come back unanswered */ #waiting = [];
  #next = 0;
  #size = 1;
  #done = 0;
  /** @type {(value: any) => void} */ #resolve = () => {};
  /** @type {(error: unknown) => void} */ #reject = () => {};
  /** No answer is wanted any more. */
  settled = false;

  /** @param {Task} task */
  constructor(task) {
    this.#task = task;
    /** @type {Promise<any>} */
    this.promise = new Promise((resolve, reject) => {
      this.#resolve = resolve;
      this.#reject = reject;
    });
  }

  get isBatch() {
    return this.#task.isBatch;
  }

  /** How many chunks could be handed out now, at most. */
  get remaining() {
    if (this.settled) return 0;
    return this.#waiting.length + this.#task.total - this.#next;
  }

  /**
   * Hands out the next chunk; there must be one.
   * @param {number} workers how many share the job: towards its end chunks become smaller, so that all end together
   * @returns {Chunk}
   */
  take(workers) {
    const waiting = this.#waiting.shift();
    if (waiting) return waiting;
    const rest = this.#task.total - this.#next;
    const chunk = { first: this.#next, count: Math.min(rest, this.#size, Math.ceil(rest / (2 * workers))), again: false };
    this.#next += chunk.count;
    return chunk;
  }

  /** @param {Chunk} chunk */
  ask({ first, count }) {
    return this.#task.ask(first, count);
  }

  /** @param {Chunk} chunk @param {import('./worker.js').Answer} answer */
  answer({ first, count }, { value, error, milliseconds }) {
    if (this.settled) return;
    if (error) return this.reject(this.#task.unpack(error));
    this.#task.store(first, value);
    const pace = Math.max(milliseconds, LEAST_MILLISECONDS) / count;
    this.#size = Math.max(1, Math.min(Math.floor(CHUNK / pace), GROWTH * count, MOST_UNITS));
    this.#advance(count);
  }

  /** A chunk that was not begun comes back. @param {Chunk} chunk */
  giveBack(chunk) {
    if (!this.settled) this.#waiting.push(chunk);
  }

  /** The worker died of a chunk: its units are asked for once more, each by itself, so that one of them that kills takes no other with it. @param {Chunk} chunk */
  bury({ first, count, again }) {
    if (this.settled) return;
    for (let unit = first; unit < first + count; unit++)
      if (!again) this.#waiting.push({ first: unit, count: 1, again: true });
      else this.#lose(unit);
  }

  /** @param {unknown} error */
  reject(error) {
    this.settled = true;
    this.#waiting = [];
    this.#reject(error);
  }

  /** @param {number} unit */
  #lose(unit) {
    try {
      this.#task.lose(unit);
    } catch (error) {
      return this.reject(error);
    }
    this.#advance(1);
  }

  /** @param {number} count */
  #advance(count) {
    const { total, onProgress, result } = this.#task;
    this.#done += count;
    try {
      onProgress?.({ done: this.#done, total });
    } catch (error) {
      return this.reject(error);
    }
    if (this.settled || this.#done < total) return;
    this.settled = true;
    this.#resolve(result());
  }
}
