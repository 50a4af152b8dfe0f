/** The worker threads that a test's pools start: counted, and killed from outside. */

import threads from 'node:worker_threads';

/** A number at which the workers of fragile-worker.js die. */
export const MORTAL = 0.123456789;
export const FRAGILE = new URL('./fragile-worker.js', import.meta.url);

/** Alive, in the order in which they were started. @type {Set<import('node:worker_threads').Worker>} */
export const alive = new Set();
/** Of these, those that have said that they can work. @type {Set<import('node:worker_threads').Worker>} */
export const ready = new Set();
/** How many were started so far. */
export const started = { count: 0 };

threads.Worker = class extends threads.Worker {
  /** @param {ConstructorParameters<typeof threads.Worker>} given */
  constructor(...given) {
    super(...given);
    alive.add(this);
    started.count++;
  }

  /** Unlike a listener, nobody can remove this. @param {string | symbol} event @param {any[]} given */
  emit(event, ...given) {
    if (event === 'message' && given[0]?.ready) ready.add(this);
    if (event === 'exit') {
      alive.delete(this);
      ready.delete(this);
    }
    return super.emit(event, ...given);
  }
};

/** Ends a worker as nobody expects it. @param {import('./random.js').Random} random @returns when it has ended: until then it may be given work */
export async function killOne(random) {
  if (alive.size === 0) return;
  /* A pool that is done meanwhile lets Node.js exit before its workers have ended. */
  const keep = setInterval(() => {}, 1000);
  await random.pick([...alive]).terminate();
  clearInterval(keep);
}

/** @param {number} milliseconds */
export const wait = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));
