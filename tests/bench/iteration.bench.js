/**
 * Where the time of a Newton iteration goes, at 50, 500 and 5,000 points: whole solves of a polyline under V8's sampling profiler, the samples sorted by
 * the C file that the function stands in. The straight line is given as a start, so that every step is one of so many points, none of a coarser
 * polyline. The module is that of dist/, linked once more with the names of its functions.
 */
import { readdirSync, readFileSync } from 'node:fs';
import { Session } from 'node:inspector/promises';
import { load } from 'surfpath';
import { gallery } from 'surfpath/gallery';
import { POLYLINE, STRAIGHT } from '../helpers/options.js';
import { createRandom } from '../helpers/random.js';
import { compete, quick, report, SEED, warmUp } from './bench.js';
import { buildNative } from './native.js';
import { randomPairs } from './pairs.js';

/** @typedef {import('./pairs.js').Pair} Pair */
/** @typedef {import('surfpath').Surface} Surface */

const COUNTS = [50, 500, 5000];
const PAIRS = quick ? 2 : 8;
const ROUNDS = quick ? 1 : 9;
const PROFILED_MILLISECONDS = quick ? 40 : 1500;
const MICROSECONDS_A_SAMPLE = 100;
const names = /** @type {const} */ (['saddle', 'parametricTorus', 'dini', 'torus']);

/** Stages, by the files that they are in; what is in no C file is the compiled surface, or JavaScript. */
const STAGES = /** @type {const} */ (['evaluation', 'assembly', 'block solve', 'the rest']);
/** @typedef {typeof STAGES[number]} Stage */
/** @type {[RegExp, Stage][]} */
const FILES = [
  [/^functions/, 'evaluation'],
  [/^(energy|system|elements|metric|parametric|implicit|kernel|sweep|fold)/, 'assembly'],
  [/^blocks/, 'block solve'],
];

const wasm = new URL('../../wasm/', import.meta.url);
/** @type {Map<string, Stage>} by function */
const stages = new Map();
for (const file of readdirSync(wasm).filter((name) => /\.[ch]$/.test(name))) {
  const stage = FILES.find(([pattern]) => pattern.test(file))?.[1] ?? 'the rest';
  const definitions = readFileSync(new URL(file, wasm), 'utf8').matchAll(/^(?!typedef)[a-z][\w *]*?\b(\w+)\([^;]*$/gm);
  for (const [, name] of definitions) if (!stages.has(name) || file.endsWith('.c')) stages.set(name, stage);
}

const surfpath = await load({ wasm: readFileSync(new URL('../../build/named.wasm', import.meta.url)) });
const surfaces = Object.fromEntries(names.map((name) => [name, { entry: gallery[name], surface: surfpath.surface(gallery[name]) }]));
const native = buildNative('iteration', surfaces);
const session = new Session();
session.connect();
await session.post('Profiler.enable');
await session.post('Profiler.setSamplingInterval', { interval: MICROSECONDS_A_SAMPLE });

/** @param {Surface} surface @returns {Pair[]} that converge as they stand, whatever the number of points */
function choosePairs(surface) {
  const isDirect = (/** @type {Pair} */ pair, /** @type {number} */ points) => {
    const { converged, touchesBoundary, parameters } = surface.shortestPath(...pair, { ...STRAIGHT, points });
    const ends = parameters && [...parameters.slice(0, 2), ...parameters.slice(-2)];
    return converged && !touchesBoundary && (!ends || ends.every((x, i) => x === pair.flat()[i]));
  };
  return randomPairs(surface, createRandom(SEED), 20 * PAIRS)
    .filter((pair) => COUNTS.every((points) => isDirect(pair, points)))
    .slice(0, PAIRS);
}

/** The share of each stage in the samples. @param {() => unknown} run @returns {Promise<Record<Stage, number>>} */
async function profile(run) {
  await session.post('Profiler.start');
  warmUp(run, PROFILED_MILLISECONDS);
  const { profile: taken } = await session.post('Profiler.stop');
  const counts = { evaluation: 0, assembly: 0, 'block solve': 0, 'the rest': 0 };
  for (const { callFrame, hitCount = 0 } of taken.nodes) {
    const isCompiled = callFrame.url.startsWith('wasm:');
    const stage =
      stages.get(callFrame.functionName) ?? (isCompiled && /^wasm-function/.test(callFrame.functionName) ? 'evaluation' : 'the rest');
    if (callFrame.functionName !== '(idle)') counts[isCompiled ? stage : 'the rest'] += hitCount;
  }
  const all = STAGES.reduce((sum, stage) => sum + counts[stage], 0) || 1;
  return /** @type {Record<Stage, number>} */ (Object.fromEntries(STAGES.map((stage) => [stage, counts[stage] / all])));
}

/** @param {string} name @param {Pair[]} pairs @param {number} points */
async function measure(name, pairs, points) {
  const { surface } = surfaces[name];
  const solve = (/** @type {Pair} */ pair) => surface.shortestPath(...pair, { ...POLYLINE, points, start: pair.flat() });
  const solveAll = () => pairs.reduce((sum, pair) => sum + solve(pair).length, 0);
  const steps = pairs.reduce((sum, pair) => sum + solve(pair).iterations, 0);
  warmUp(solveAll);
  const repetitions = quick ? 1 : Math.max(1, Math.round(20_000 / points));
  const { ours, gcc } = compete(
    {
      ours: () => {
        const start = performance.now();
        for (let i = 0; i < repetitions; i++) solveAll();
        return (1e6 * (performance.now() - start)) / (repetitions * steps);
      },
      gcc: () => (native.solveAtOnce(name, pairs, points, repetitions).nanoseconds * pairs.length) / steps,
    },
    ROUNDS,
  );
  const shares = await profile(solveAll);
  return {
    surface: name,
    n: points,
    'µs an iteration, median': ours.median / 1e3,
    'µs minimum': ours.minimum / 1e3,
    'native µs minimum': gcc.minimum / 1e3,
    ratio: ours.minimum / gcc.minimum,
    'ns a node': ours.minimum / points,
    ...Object.fromEntries(STAGES.map((stage) => [stage, (shares[stage] * ours.minimum) / points])),
  };
}

const rows = [];
for (const name of names) {
  const pairs = choosePairs(surfaces[name].surface);
  for (const points of COUNTS) rows.push(await measure(name, pairs, points));
}
session.disconnect();
report('iteration', 'A Newton iteration of the polyline: a whole solve through the public API, divided by its steps', rows, [
  'nanoseconds a node, split by where the profiler found it: the surface and its functions; assembly; the block solve; the rest (charts, retraction, line',
  'search, final check, copies, JavaScript). Wanted at n = 500: 8 µs saddle, 11 torus, 14 Dini; from 500 to 5,000 at most 10.5 times as long',
]);
