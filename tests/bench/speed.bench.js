/** How long a solve takes through the public API, and how long in a native build of the same core on the same pairs. */
import { load } from 'surfpath';
import { gallery } from 'surfpath/gallery';
import { STRAIGHT } from '../helpers/options.js';
import { createRandom } from '../helpers/random.js';
import { compete, quick, repeat, report, SEED, warmUp } from './bench.js';
import { buildNative } from './native.js';
import { randomPairs } from './pairs.js';

/** @typedef {import('./pairs.js').Pair} Pair */
/** @typedef {import('surfpath').Surface} Surface */

/** What the paper reports, in microseconds a path. @type {Record<number, number>} */
const PAPER = { 50: 7_000, 500: 91_000 };
/** At which norm of the gradient the paper stops. */
const PAPER_TOLERANCE = 1e-6;
const PAIRS = quick ? 4 : 32;
const ROUNDS = quick ? 1 : 15;
const NANOSECONDS_A_SAMPLE = quick ? 1e6 : 4e7;
const COUNTS = [50, 500];
const names = /** @type {const} */ (['saddle', 'parametricTorus', 'dini', 'torus']);

/**
 * Random pairs whose straight start converges as it stands, without a detour over a period, so that both sides solve the same.
 * @param {Surface} surface
 * @returns {Pair[]}
 */
function choosePairs(surface) {
  const candidates = randomPairs(surface, createRandom(SEED), 20 * PAIRS);
  const isDirect = (/** @type {Pair} */ [from, to], /** @type {number} */ points) => {
    const { converged, touchesBoundary, parameters } = surface.shortestPath(from, to, { ...STRAIGHT, points });
    const ends = parameters && [...parameters.slice(0, 2), ...parameters.slice(-2)];
    return converged && !touchesBoundary && (!ends || ends.every((x, i) => x === [...from, ...to][i]));
  };
  return candidates.filter((pair) => COUNTS.every((points) => isDirect(pair, points))).slice(0, PAIRS);
}

/** One pass over all pairs; the sum of the lengths. @param {Surface} surface @param {Pair[]} pairs @param {import('surfpath').PathOptions} options */
function solveAll(surface, pairs, options) {
  let sum = 0;
  for (const [from, to] of pairs) sum += surface.shortestPath(from, to, options).length;
  return sum;
}

const surfpath = await load();
const surfaces = Object.fromEntries(names.map((name) => [name, { entry: gallery[name], surface: surfpath.surface(gallery[name]) }]));
const native = buildNative('speed', surfaces);

/** @param {string} name @param {number} points */
function measure(name, points) {
  const { surface } = surfaces[name];
  const pairs = choosePairs(surface);
  const options = { ...STRAIGHT, points };
  const paper = { ...options, gradientTolerance: PAPER_TOLERANCE };
  warmUp(() => solveAll(surface, pairs, options));
  warmUp(() => solveAll(surface, pairs, paper));
  const before = performance.now();
  const expected = solveAll(surface, pairs, options);
  const repetitions = Math.max(1, Math.round(NANOSECONDS_A_SAMPLE / (1e6 * (performance.now() - before))));
  let same = true;
  const watch = (/** @type {number} */ sum) => {
    same &&= sum === expected;
  };
  const time = (/** @type {() => void} */ run) => (1e3 * repeat(run, repetitions)) / (repetitions * pairs.length);
  const { wasm, gcc, rough } = compete(
    {
      wasm: () => time(() => watch(solveAll(surface, pairs, options))),
      rough: () => time(() => solveAll(surface, pairs, paper)),
      gcc: () => {
        const { nanoseconds, sum } = native.solve(name, pairs, points, repetitions);
        watch(sum);
        return nanoseconds / 1e3;
      },
    },
    ROUNDS,
  );
  return {
    surface: name,
    K: points,
    'µs median': wasm.median,
    'µs minimum': wasm.minimum,
    'native µs median': gcc.median,
    'native µs minimum': gcc.minimum,
    ratio: wasm.minimum / gcc.minimum,
    'to 1e-6 µs median': rough.median,
    'to 1e-6 µs minimum': rough.minimum,
    'paper µs': PAPER[points],
    'same bits': same,
  };
}

report(
  'speed',
  `Microseconds a solve, ${PAIRS} random pairs, polyline, straight start: the public API in Node, and a native build (gcc -O3)`,
  names.flatMap((name) => COUNTS.map((points) => measure(name, points))),
  [
    'paper: 7 ms at K = 50 and 91 ms at K = 500, on a surface it does not name',
    'to 1e-6: with gradientTolerance 1e-6, as the paper; else to the default, which is finer, with a certificate at the end',
    'wanted at K = 500 to 1e-6: 25 µs saddle, 35 parametricTorus, 50 dini, 100 torus; at K = 50 8 µs saddle; ratio at most 1.25',
  ],
);
