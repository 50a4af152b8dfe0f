/** Whole solves by elements, by surface and tolerance: through the public API, and in native builds of the same core, with the true error beside. */
import { load } from 'surfpath';
import { gallery } from 'surfpath/gallery';
import { createRandom } from '../helpers/random.js';
import { compete, quick, repeat, report, SEED, warmUp } from './bench.js';
import { loadClocked } from './core.js';
import { buildNative } from './native.js';
import { randomPairs } from './pairs.js';

/** @typedef {import('./pairs.js').Pair} Pair */
/** @typedef {import('surfpath').Surface} Surface */

const PAIRS = quick ? 2 : 24;
const ROUNDS = quick ? 1 : 11;
const MILLISECONDS_A_SAMPLE = quick ? 1 : 30;
const TOLERANCES = [1e-2, 1e-4, 1e-6, 1e-9, 1e-12];
const EXACT = 1e-13;
const names = /** @type {const} */ (['saddle', 'parametricTorus', 'dini', 'torus']);

const surfpath = await load();
const surfaces = Object.fromEntries(names.map((name) => [name, { entry: gallery[name], surface: surfpath.surface(gallery[name]) }]));
const clocked = await loadClocked();
const native = buildNative('solves', surfaces);
const march = buildNative('solves', surfaces, 'march');

/**
 * Random pairs whose straight start converges at every tolerance to the same path, without walls or a detour over a period: both sides solve the same.
 * @param {Surface} surface
 * @returns {{ pair: Pair, length: number }[]}
 */
function choosePairs(surface) {
  const chosen = [];
  for (const pair of randomPairs(surface, createRandom(SEED), 20 * PAIRS)) {
    const exact = surface.shortestPath(...pair, { start: 'straight', tolerance: EXACT });
    const { parameters } = exact;
    const ends = parameters && [...parameters.slice(0, 2), ...parameters.slice(-2)];
    const isDirect = !exact.touchesBoundary && (!ends || ends.every((x, i) => x === pair.flat()[i]));
    const isKnown = TOLERANCES.every((tolerance) => {
      const { converged, length } = surface.shortestPath(...pair, { start: 'straight', tolerance });
      return converged && Math.abs(length / exact.length - 1) < 1e-2;
    });
    if (isDirect && isKnown && exact.lengthError < 1e-11 * exact.length) chosen.push({ pair, length: exact.length });
    if (chosen.length === PAIRS) break;
  }
  return chosen;
}

/** @param {typeof names[number]} name @param {{ pair: Pair, length: number }[]} known @param {number} tolerance */
function measure(name, known, tolerance) {
  const { surface } = surfaces[name];
  const pairs = known.map(({ pair }) => pair);
  const options = /** @type {const} */ ({ start: 'straight', tolerance });
  const other = clocked.surfpath.surface(gallery[name]);
  const solveOn = (/** @type {Surface} */ one) => pairs.reduce((sum, pair) => sum + one.shortestPath(...pair, options).length, 0);
  const solveAll = () => solveOn(surface);
  warmUp(solveAll);
  warmUp(() => solveOn(other));
  const before = performance.now();
  const expected = solveAll();
  const repetitions = Math.max(1, Math.round(MILLISECONDS_A_SAMPLE / (performance.now() - before)));
  let same = true;
  const sampleNative = (/** @type {typeof native} */ build) => () => {
    const { nanoseconds, sum } = build.solve(name, pairs, tolerance, repetitions);
    same &&= sum === expected;
    return nanoseconds / 1e3;
  };
  const microseconds = (/** @type {number} */ milliseconds) => (1e3 * milliseconds) / (repetitions * pairs.length);
  const solveClocked = () => {
    for (let i = 0; i < repetitions; i++) solveOn(other);
  };
  const { wasm, core, gcc, tuned } = compete(
    {
      wasm: () => microseconds(repeat(solveAll, repetitions)),
      core: () => microseconds(clocked.measure(solveClocked)),
      gcc: sampleNative(native),
      tuned: sampleNative(march),
    },
    ROUNDS,
  );
  other.dispose();
  const errors = known.map(({ pair, length }) => Math.abs(surface.shortestPath(...pair, options).length / length - 1));
  return {
    surface: name,
    tolerance: String(tolerance),
    'largest true error': Math.max(...errors),
    'µs median': wasm.median,
    'µs minimum': wasm.minimum,
    'in WASM µs minimum': core.minimum,
    'native µs median': gcc.median,
    'native µs minimum': gcc.minimum,
    'march=native µs minimum': tuned.minimum,
    ratio: wasm.minimum / gcc.minimum,
    'in WASM': core.minimum / gcc.minimum,
    'same bits': same,
  };
}

report(
  'solves',
  `Microseconds a path by elements, ${PAIRS} random pairs, straight start: the public API in Node, the solver's part of that, and native builds (gcc -O3)`,
  names.flatMap((name) => {
    const known = choosePairs(surfaces[name].surface);
    return TOLERANCES.map((tolerance) => measure(name, known, tolerance));
  }),
  [
    'true error: of the length, against a tolerance of 1e-13',
    'wanted: ratio (of the minima) at most 1.25; in WASM: the same without JavaScript',
  ],
);
