/** Lengths of many pairs: on the main thread, and in pools of one worker and of two. */
import { load } from 'surfpath';
import { gallery } from 'surfpath/gallery';
import { createPool } from 'surfpath/pool';
import { createRandom } from '../helpers/random.js';
import { quick, report, SEED, spread } from './bench.js';
import { randomPairs } from './pairs.js';

const ROUNDS = quick ? 1 : 9;
/** @type {{ name: 'parametricTorus' | 'saddle', count: number, options: import('surfpath').PairOptions }[]} */
const TASKS = [
  { name: 'parametricTorus', count: quick ? 200 : 10_000, options: { start: 'straight', tolerance: 1e-6 } },
  { name: 'parametricTorus', count: quick ? 20 : 400, options: {} },
  { name: 'saddle', count: quick ? 200 : 10_000, options: {} },
];

const surfpath = await load();
const pools = { one: createPool({ workers: 1 }), two: createPool({ workers: 2 }) };

/** Milliseconds that something takes. @param {() => unknown} run */
async function time(run) {
  const start = performance.now();
  await run();
  return performance.now() - start;
}

/** @param {typeof TASKS[number]} task */
async function measure({ name, count, options }) {
  const surface = surfpath.surface(gallery[name]);
  const pairs = Float64Array.from(randomPairs(surface, createRandom(SEED), count).flat(2));
  const expected = surface.lengths(pairs, options);
  let same = true;
  const ask = async (/** @type {import('surfpath/pool').WorkerPool} */ pool) => {
    const lengths = await pool.lengths(gallery[name], pairs, options);
    same &&= lengths.every((length, i) => Object.is(length, expected[i]));
  };
  /** @type {Record<string, number[]>} */ const samples = { main: [], one: [], two: [] };
  for (let round = 0; round <= ROUNDS; round++) {
    const taken = {
      main: await time(() => surface.lengths(pairs, options)),
      one: await time(() => ask(pools.one)),
      two: await time(() => ask(pools.two)),
    };
    if (round > 0) for (const [rival, milliseconds] of Object.entries(taken)) samples[rival].push((1e3 * milliseconds) / count);
  }
  const { main, one, two } = Object.fromEntries(Object.entries(samples).map(([rival, taken]) => [rival, spread(taken)]));
  surface.dispose();
  return {
    surface: name,
    options: JSON.stringify(options),
    pairs: count,
    'µs a pair, median': main.median,
    'µs a pair, minimum': main.minimum,
    'one worker': one.minimum,
    'two workers': two.minimum,
    'two against one': one.minimum / two.minimum,
    'two against none': main.minimum / two.minimum,
    'same bits': same,
  };
}

const rows = [];
for (const task of TASKS) rows.push(await measure(task));
await Promise.all(Object.values(pools).map((pool) => pool.dispose()));
report('batch', 'Microseconds a pair in batches: the main thread, a pool of one worker, a pool of two', rows, [
  'pools: minima; wanted, with two idle processors: two against one at least 1.7, and at most 40 µs for the first row without a pool',
]);
