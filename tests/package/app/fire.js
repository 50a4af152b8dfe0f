/* The pool under fire: workers that die in the middle, a call that is aborted, a pair and a formula that are none. What it says is the same everywhere. */

import { load } from 'surfpath';
import { gallery } from 'surfpath/gallery';
import { createPool } from 'surfpath/pool';

const { dini } = gallery;
const COUNT = 300;
const OPTIONS = { start: 'straight', tolerance: 1e-6, points: 3 };

/** Where the pool finds the class of its workers: of Node.js, Deno and Bun, or of the page. */
const threads = typeof document === 'undefined' ? process.getBuiltinModule('node:worker_threads') : globalThis;

/** Pairs of points spread over the rectangle; the eighth is not finite. */
function spread({ u, v }) {
  const at = ([low, high], part) => low + (high - low) * (0.1 + 0.8 * (part % 1));
  const pairs = Array.from({ length: 4 * COUNT }, (_, i) => at(i % 2 ? v : u, 0.618 * i + 0.3 * (i >> 2)));
  pairs[29] = Number.NaN;
  return pairs;
}

/** Ends a worker as nobody expects it: a thread without a word, a page's worker with an error. */
function kill(worker) {
  if (threads === globalThis) worker.dispatchEvent(new ErrorEvent('error', { message: 'killed' }));
  else worker.terminate();
}

/** Runs something while workers are counted as they are started, and listed once they say that they are ready: one killed before that would count as none. */
async function watchWorkers(run) {
  const { Worker } = threads;
  const crew = { started: 0, ready: [] };
  threads.Worker = class extends Worker {
    constructor(...given) {
      super(...given);
      crew.started++;
      const hear = () => crew.ready.push(this);
      if (this.once) this.once('message', hear);
      else this.addEventListener('message', hear, { once: true });
    }
  };
  try {
    return await run(crew);
  } finally {
    threads.Worker = Worker;
  }
}

/** @returns {Promise<string>} */
export async function stayUnderFire() {
  const surfpath = await load();
  const surface = surfpath.surface(dini);
  const pairs = spread(surface.domain);
  const alone = surface.lengths(pairs, OPTIONS);
  surfpath.dispose();
  const count = (lengths) => lengths.filter((length, i) => Object.is(length, alone[i])).length;

  return watchWorkers(async (crew) => {
    const pool = createPool({ workers: 2 });
    try {
      /* The second when what the first worked on has long been solved: a pair that two workers die of counts as the one that kills. */
      const shots = [1, COUNT / 2];
      const onProgress = ({ done }) => {
        if (!(done >= shots[0])) return;
        shots.shift();
        kill(crew.ready.at(-1));
      };
      const shot = await pool.lengths(dini, pairs, { ...OPTIONS, onProgress });
      const replaced = crew.started > 2;
      const signal = AbortSignal.timeout(50);
      const aborted = await pool.distanceField(dini, [1, 1], { exact: true, signal }).catch(({ name }) => name);
      const refused = await pool.lengths({ ...dini, z: 'sin u' }, pairs).catch(({ name }) => name);
      const afterwards = await pool.lengths(dini, pairs, OPTIONS);
      const missing = alone.filter(Number.isNaN).length;
      return `under fire: ${replaced ? count(shot) : 'nobody was replaced'}, ${aborted}, ${refused}, ${count(afterwards)} of ${COUNT} as alone, ${missing} without a path`;
    } finally {
      await pool.dispose();
    }
  });
}
