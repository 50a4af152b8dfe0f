/** How long paths to a tolerance of 1e-9 take through the public API: by elements from a straight start, by the defaults, warm, an end moved by 1 %, and the first of a surface, with its graph. */
import { load } from 'surfpath';
import { gallery } from 'surfpath/gallery';
import { createRandom } from '../helpers/random.js';
import { compete, quick, report, SEED, warmUp } from './bench.js';
import { randomPairs } from './pairs.js';

const PAIRS = quick ? 2 : 32;
const ROUNDS = quick ? 1 : 9;

const surfpath = await load();

const names = /** @type {const} */ ([
  'saddle',
  'parametricTorus',
  'globe',
  'dini',
  'torus',
  'threeTori',
  'genus2',
  'bumpy',
  'trefoil',
  'printed47',
]);

/** @param {typeof names[number]} name */
function measure(name) {
  const surface = surfpath.surface(gallery[name]);
  const pairs = randomPairs(surface, createRandom(SEED), 4 * PAIRS)
    .filter(([from, to]) => surface.shortestPath(from, to, { start: 'straight' }).converged)
    .slice(0, PAIRS);
  const earlier = pairs.map(([from, to]) => surface.shortestPath(from, to, { start: 'straight' }));
  /** @param {readonly number[]} from @param {readonly number[]} to @param {number} i */
  const warmLength = (from, to, i) => {
    const moved = to.map((x, j) => x + 0.01 * (from[j] - x));
    return surface.shortestPath([...from], moved, { start: earlier[i] }).length;
  };
  let sum = 0;
  const time = (/** @type {(from: number[], to: number[], i: number) => number} */ solve) => () => {
    const start = performance.now();
    pairs.forEach(([from, to], i) => {
      sum += solve([...from], [...to], i);
    });
    return (1e3 * (performance.now() - start)) / pairs.length;
  };
  const tasks = {
    straight: time((from, to) => surface.shortestPath(from, to, { start: 'straight' }).length),
    usual: time((from, to) => surface.shortestPath(from, to).length),
    warm: time((from, to, i) => {
      return warmLength(from, to, i);
    }),
  };
  for (const task of Object.values(tasks)) warmUp(task);
  const { straight, usual, warm } = compete(tasks, ROUNDS);
  const single = pairs.map(([from, to], i) => {
    const times = Array.from({ length: ROUNDS }, () => {
      const start = performance.now();
      sum += warmLength(from, to, i);
      return 1e3 * (performance.now() - start);
    });
    return times.sort((a, b) => a - b)[ROUNDS >> 1];
  });
  const first = Array.from({ length: ROUNDS }, () => {
    const fresh = surfpath.surface(gallery[name]);
    const start = performance.now();
    sum += fresh.shortestPath([...pairs[0][0]], [...pairs[0][1]]).length;
    const taken = performance.now() - start;
    fresh.dispose();
    return 1e3 * taken;
  });
  return {
    surface: name,
    'first µs median': first.sort((a, b) => a - b)[ROUNDS >> 1],
    'straight µs median': straight.median,
    'default µs median': usual.median,
    'warm µs median': warm.median,
    'warm µs, half of the pairs at most': single.sort((a, b) => a - b)[pairs.length >> 1],
    'length, summed': sum,
  };
}

report(
  'tolerance',
  `Microseconds a path to 1e-9, mean of ${PAIRS} random pairs`,
  names.filter((_, i) => !quick || i % 4 === 0).map(measure),
  ['wanted: warm in at most 300 µs; of the pairs on one surface some are harder than most'],
);
