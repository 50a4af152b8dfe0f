// The pool under fire: workers killed at random times, calls aborted at every stage, pairs that kill. No pair is lost, none is double, the pool goes on.
import assert from 'node:assert/strict';
import { getEventListeners } from 'node:events';
import { after, before, describe, test } from 'node:test';
import threads from 'node:worker_threads';
import { gallery } from '../../../web/gallery.js';
import { load } from '../../../web/index.js';
import { createPool } from '../../../web/pool.js';
import { randomPairs } from '../../bench/pairs.js';
import { allowance } from '../../helpers/allowance.js';
import { createRandom } from '../../helpers/random.js';
import { ofAll } from '../../helpers/sample.js';
import { alive, FRAGILE, killOne, MORTAL, ready, started, wait } from '../../helpers/workers.js';

const SEED = 97;
const COUNT = 600;
const random = createRandom(SEED);
const OPTIONS = /** @type {const} */ ({ start: 'straight', tolerance: 1e-6, points: 3 });
const definition = gallery.dini;

/** @type {number[]} */ let pairs;
/** @type {Float64Array} */ let expected;
before(async () => {
  const surfpath = await load();
  const surface = surfpath.surface(definition);
  pairs = randomPairs(surface, random, COUNT).flat(2);
  expected = surface.lengths(pairs, OPTIONS);
  surfpath.dispose();
});

/** Whether the pool still works. @param {import('../../../web/runtime/pool.js').Pool} pool */
async function works(pool) {
  const few = pairs.slice(0, 40);
  assert.deepEqual(await pool.lengths(definition, few, OPTIONS), expected.slice(0, 10));
}

describe(`workers that are killed, seed ${SEED}`, () => {
  /** @type {import('../../../web/runtime/pool.js').Pool} */ let pool;
  before(() => {
    pool = createPool({ workers: 2 });
  });
  after(() => pool.dispose());

  for (let round = 0; round < ofAll(3, 8); round++)
    test(`once, at a random time, ${round}`, async () => {
      let sum = 0;
      const batch = pool.lengths(definition, pairs, {
        ...OPTIONS,
        onProgress({ done, total }) {
          assert.ok(done > sum && done <= total);
          sum = done;
        },
      });
      await wait(random.between(0, 150));
      const ended = killOne(random);
      assert.deepEqual(await batch, expected);
      assert.equal(sum, COUNT);
      // Else it might still be given the next round's pairs, and they would die twice.
      await ended;
    });

  test('when all is done, before the answer', async () => {
    let ended;
    const onProgress = (/** @type {{ done: number, total: number }} */ { done, total }) => {
      if (done === total) ended = killOne(random);
    };
    assert.deepEqual(await pool.lengths(definition, pairs, { ...OPTIONS, onProgress }), expected);
    await ended;
    await works(pool);
  });

  test('again and again: every pair is solved, or lost for two workers', async () => {
    let [kills, last] = [0, 0];
    const timer = setInterval(() => {
      /* On a machine so slow that none starts in that time, there would be none ever. */
      if (ready.size === 0) return;
      kills++;
      killOne(random);
    }, 150);
    const batch = pool.lengths(definition, pairs, {
      ...OPTIONS,
      onProgress({ done }) {
        assert.ok(done > last);
        last = done;
      },
    });
    const lengths = await batch.finally(() => clearInterval(timer));
    assert.equal(last, COUNT);
    const lost = lengths.filter((length, i) => !Object.is(length, expected[i]));
    assert.ok(lost.every(Number.isNaN) && lost.length <= kills / 2, `${lost.length} of ${COUNT} pairs lost to ${kills} kills`);
    await works(pool);
  });

  test('while they start', async () => {
    for (let i = 0; i < ofAll(2, 4); i++) {
      const batch = pool.lengths(definition, pairs, OPTIONS);
      for (const worker of alive) worker.terminate();
      await wait(random.between(0, 40));
      for (const worker of alive) worker.terminate();
      assert.deepEqual(await batch, expected);
    }
  });
});

describe('pairs that kill', () => {
  /** @type {import('../../../web/runtime/pool.js').Pool} */ let pool;
  before(() => {
    pool = createPool({ workers: 2, worker: FRAGILE });
  });
  after(() => pool.dispose());

  test('give NaN, and the others their lengths', async () => {
    const mortal = Float64Array.from(pairs);
    const places = [0, 300, 301, COUNT - 1];
    for (const i of places) mortal[4 * i] = MORTAL;
    const before = started.count;
    let last = 0;
    const lengths = await pool.lengths(definition, mortal, {
      ...OPTIONS,
      onProgress({ done }) {
        assert.ok(done > last);
        last = done;
      },
    });
    const wanted = expected.map((length, i) => (places.includes(i) ? Number.NaN : length));
    assert.deepEqual(lengths, wanted);
    assert.equal(last, COUNT);
    assert.ok(started.count - before <= 2 + 2 * places.length, `${started.count - before} workers`);
  });

  test('give a path that says so', async () => {
    const [path, other] = await pool.shortestPaths(definition, [MORTAL, 0.5, 1, 1, ...pairs.slice(0, 4)], OPTIONS);
    const { status, converged, length, points } = path;
    assert.deepEqual([status, converged, length, points.length], ['worker-died', false, Number.NaN, 0]);
    assert.equal(other.length, expected[0]);
  });

  test('reject a single question', async () => {
    await assert.rejects(pool.shortestPath(definition, [MORTAL, 0.5], [1, 1]), /shortestPath: two workers ended while they computed this/);
    await works(pool);
  });
});

describe(`calls that are aborted, seed ${SEED}`, () => {
  /** @type {import('../../../web/runtime/pool.js').Pool} */ let pool;
  before(() => {
    pool = createPool({ workers: 2 });
  });
  after(() => pool.dispose());

  test('before they begin: nothing is started', async () => {
    const idle = createPool();
    const before = started.count;
    const reason = new Error('not needed');
    await assert.rejects(idle.lengths(definition, pairs, { signal: AbortSignal.abort(reason) }), reason);
    assert.equal(started.count, before);
    await idle.dispose();
  });

  for (const delay of ofAll([0, 5, 40, 160], [0, 1, 5, 20, 40, 60, 80, 120, 160]))
    test(`after ${delay} ms`, async () => {
      const controller = new AbortController();
      let calls = 0;
      const signal = controller.signal;
      const batch = pool.lengths(definition, [...pairs, ...pairs, ...pairs], { signal, onProgress: () => calls++ });
      const other = pool.lengths(definition, pairs.slice(0, 400), OPTIONS);
      await wait(delay);
      controller.abort();
      const calledBefore = calls;
      await assert.rejects(batch, { name: 'AbortError' });
      await works(pool);
      assert.deepEqual(await other, expected.slice(0, 100));
      assert.equal(calls, calledBefore);
    });

  test('all at once, by one signal: with one listener, and none that stays', async () => {
    for (const isAborted of [true, false]) {
      const controller = new AbortController();
      const { signal } = controller;
      const settled = Promise.allSettled(
        Array.from({ length: 20 }, () => pool.lengths(definition, pairs.slice(0, 40), { ...OPTIONS, signal })),
      );
      assert.equal(getEventListeners(signal, 'abort').length, 1);
      if (isAborted) controller.abort();
      for (const { status } of await settled) assert.equal(status, isAborted ? 'rejected' : 'fulfilled');
      assert.equal(getEventListeners(signal, 'abort').length, 0);
    }
    await works(pool);
  });

  describe('a long question', () => {
    /** @type {import('../../../web/runtime/pool.js').Pool} */ let single;
    /* Nothing of an aborted call keeps Node.js from exiting, so the test does. */
    /** @type {ReturnType<typeof setInterval>} */ let keep;
    before(() => {
      single = createPool({ workers: 1 });
      keep = setInterval(() => {}, 1000);
    });
    after(() => {
      clearInterval(keep);
      return single.dispose();
    });

    /** Milliseconds from the abort of a long question until it is rejected, and until its worker has ended. */
    async function cutShort() {
      await works(single);
      const controller = new AbortController();
      const long = single.distanceField(definition, [1, 1], { exact: true, signal: controller.signal });
      const [busy] = [...alive].slice(-1);
      const ended = new Promise((resolve) => busy.once('exit', () => resolve(performance.now())));
      await wait(100);
      const aborted = performance.now();
      controller.abort();
      await assert.rejects(long, { name: 'AbortError' });
      const rejected = performance.now() - aborted;
      const end = /** @type {number} */ (await ended) - aborted;
      await works(single);
      assert.ok(!alive.has(busy));
      return [rejected, end];
    }

    test('is cut short, and its worker ended and replaced, within 50 ms', async () => {
      /* 30 ms of grace and the end of the thread: 35 to 45 ms on an idle machine. Of a busy one the least of many tells. */
      let least = [Infinity, Infinity];
      let most = 50;
      for (let round = 0; round < 3 || (Math.max(...least) > most && round < 30); round++) {
        const times = await cutShort();
        least = least.map((time, i) => Math.min(time, times[i]));
        most = allowance(50);
      }
      assert.ok(Math.max(...least) <= most, `rejected after ${least[0]} ms, ended after ${least[1]} ms at least`);
    });
  });
});

test('without its script a pool says so, every time', async () => {
  const lost = createPool({ workers: 2, worker: new URL('./nowhere.js', import.meta.url) });
  for (let i = 0; i < 2; i++) {
    const before = started.count;
    await assert.rejects(lost.lengths(definition, pairs), /no worker can be started: .*nowhere\.js/s);
    /* It does not make do with fewer from then on. */
    assert.equal(started.count - before, 2);
  }
  await lost.dispose();
});

test('workers that cannot be started leave the work to the others', async () => {
  const Usual = threads.Worker;
  let count = 0;
  threads.Worker = class extends Usual {
    /** @param {string | URL} script @param {import('node:worker_threads').WorkerOptions} [options] */
    constructor(script, options) {
      super(count++ === 1 ? script : new URL('./nowhere.js', import.meta.url), options);
    }
  };
  const pool = createPool({ workers: 3 });
  try {
    assert.deepEqual(await pool.lengths(definition, pairs, OPTIONS), expected);
    assert.equal(count, 3);
    await works(pool);
    assert.equal(count, 3);
  } finally {
    threads.Worker = Usual;
    await pool.dispose();
  }
});
