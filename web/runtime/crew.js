/** The workers of a pool: hired when there is work, given as much as they can swallow, replaced when they die. Does not know what they compute. */

/** @typedef {import('./thread.js').Thread} Thread */
/** @typedef {import('./job.js').Job} Job */
/** @typedef {{ job: Job, chunk: import('./job.js').Chunk }} Load */

/** Milliseconds that a worker may go on with what nobody wants any more. With a chunk before it (see job.js) and its end, that stays below 50. */
const GRACE = 30;
/** How many workers may die in a row before they were ready. */
const MOST_STILLBORN = 40;

class Hand {
  /** @type {Thread | null} */ thread = null;
  ready = false;
  /** What it works on, and what it finds next, in the order in which it will answer. @type {Load[]} */
  queue = [];
  /** @type {ReturnType<typeof setTimeout> | undefined} */ timer;

  end() {
    clearTimeout(this.timer);
    return this.thread?.end();
  }
}

export class Crew {
  #plan;
  /** @type {Set<Hand>} */ #hands = new Set();
  /** The one whose turn it is first. @type {Job[]} */ #jobs = [];
  #stillborn = 0;
  #most = Infinity;

  /**
   * @param {object} plan
   * @param {() => Promise<{ module: WebAssembly.Module, most: number }>} plan.prepare gives the compiled solver, and how many workers there may be
   * @param {(listener: import('./thread.js').Listener) => Thread} plan.start
   */
  constructor(plan) {
    this.#plan = plan;
  }

  /** Works on a job until it is settled. @param {Job} job */
  async add(job) {
    this.#jobs.push(job);
    if (this.#jobs.length === 1) this.#hold(true);
    await this.#assign();
  }

  /** Stops work on a job that is settled. @param {Job} job */
  drop(job) {
    const place = this.#jobs.indexOf(job);
    if (place < 0) return;
    this.#jobs.splice(place, 1);
    if (this.#jobs.length === 0) this.#hold(false);
    for (const hand of this.#hands) this.#watch(hand);
  }

  /** Ends all workers, and rejects all jobs. @param {Error} reason */
  async dispose(reason) {
    const hands = [...this.#hands];
    this.#hands.clear();
    this.#fail(reason);
    await Promise.all(hands.map((hand) => hand.end()));
  }

  /** Gives work to all who can take some, and hires if there is more. */
  async #assign() {
    const hands = [...this.#hands].filter(({ ready }) => ready);
    for (const hand of hands) if (hand.queue.length === 0) this.#give(hand, this.#next());
    /* A second chunk waits at the worker, so that the worker need not wait for this thread: unless a question wants the next one that is free. */
    const isAsked = this.#jobs.some(({ isBatch, remaining }) => !isBatch && remaining > 0);
    for (const hand of isAsked ? [] : hands) if (hand.queue.length === 1 && hand.queue[0].job.isBatch) this.#give(hand, this.#next());
    if (this.#waiting > 0 && this.#hands.size < this.#most) await this.#hire();
  }

  /** How many chunks wait, at most. */
  get #waiting() {
    return this.#jobs.reduce((sum, { remaining }) => sum + remaining, 0);
  }

  async #hire() {
    try {
      const { module, most } = await this.#plan.prepare();
      this.#most = Math.min(this.#most, most);
      const starting = [...this.#hands].filter(({ ready }) => !ready).length;
      const count = Math.min(this.#most - this.#hands.size, this.#waiting - starting);
      for (let i = 0; i < count; i++) this.#begin(module);
    } catch (error) {
      this.#fail(error);
    }
  }

  /** @param {WebAssembly.Module} module */
  #begin(module) {
    const hand = new Hand();
    hand.thread = this.#plan.start({
      message: (message) => this.#hear(hand, message),
      death: (error) => this.#bury(hand, error),
    });
    hand.thread.post({ module });
    this.#hands.add(hand);
  }

  /** The next chunk of the job whose turn it is. @returns {Load | null} */
  #next() {
    const place = this.#jobs.findIndex(({ remaining }) => remaining > 0);
    if (place < 0) return null;
    const [job] = this.#jobs.splice(place, 1);
    this.#jobs.push(job);
    return { job, chunk: job.take(this.#hands.size) };
  }

  /** @param {Hand} hand @param {Load | null} load */
  #give(hand, load) {
    if (!load) return;
    hand.queue.push(load);
    hand.thread?.post(load.job.ask(load.chunk));
  }

  /** @param {Hand} hand @param {any} message */
  #hear(hand, message) {
    if (!this.#hands.has(hand)) return;
    if (message.ready) {
      hand.ready = true;
      this.#stillborn = 0;
    } else {
      const { job, chunk } = /** @type {Load} */ (hand.queue.shift());
      clearTimeout(hand.timer);
      hand.timer = undefined;
      job.answer(chunk, message);
      this.#watch(hand);
      if (job.settled) this.drop(job);
    }
    this.#assign();
  }

  /** A worker died: of what it was working on, if it was ready. @param {Hand} hand @param {Error | null} error */
  #bury(hand, error) {
    if (!this.#hands.delete(hand)) return;
    clearTimeout(hand.timer);
    if (hand.ready) {
      const [load, ...others] = hand.queue;
      load?.job.bury(load.chunk);
      if (load?.job.settled) this.drop(load.job);
      for (const { job, chunk } of others) job.giveBack(chunk);
    } else if (error || ++this.#stillborn > MOST_STILLBORN) {
      /* Those that can be started have to do; where none can, the next job tries again. */
      this.#most = this.#hands.size || Infinity;
      if (this.#hands.size === 0) {
        const why = error?.message ?? 'it ends before it is ready';
        return this.#fail(new Error(`surfpath: no worker can be started: ${why}`, { cause: error }));
      }
    }
    this.#assign();
  }

  /** Sets a time by which a worker must be done with what nobody wants any more. @param {Hand} hand */
  #watch(hand) {
    if (hand.timer !== undefined || !hand.queue[0]?.job.settled) return;
    hand.timer = setTimeout(() => {
      this.#hands.delete(hand);
      hand.end();
      for (const { job, chunk } of hand.queue) job.giveBack(chunk);
      this.#assign();
    }, GRACE);
    /** @type {any} */ (hand.timer).unref?.();
  }

  /** @param {unknown} reason */
  #fail(reason) {
    for (const job of [...this.#jobs]) {
      job.reject(reason);
      this.drop(job);
    }
  }

  /** Whether Node.js has to wait for the workers. @param {boolean} wanted */
  #hold(wanted) {
    for (const { thread } of this.#hands) thread?.hold(wanted);
  }
}
