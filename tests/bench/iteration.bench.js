/**
 * What a Newton iteration costs at 50, 500 and 5,000 points, and where its time goes: solves of a polyline that may take three steps, less solves that may take
 * one, so that what comes once (start, checks, copies, JavaScript) is left out. The shares are by V8's sampling profiler, the samples sorted by the C file that the
 * function stands in. The straight line is given as a start, so that every step is one of so many points, none of a coarser polyline. The module is that of dist/,
 * linked once more with the names of its functions.
 */
import { readdirSync, readFileSync } from 'node:fs';
import { Session } from 'node:inspector/promises';
import { load } from 'surfpath';
import { gallery } from 'surfpath/gallery';
import { POLYLINE } from '../helpers/options.js';
import { createRandom } from '../helpers/random.js';
import { compete, quick, report, SEED, sumLeast, warmUp } from './bench.js';
import { buildNative } from './native.js';
import { randomPairs } from './pairs.js';

/** @typedef {import('./pairs.js').Pair} Pair */
/** @typedef {import('surfpath').Surface} Surface */

const COUNTS = [50, 500, 5000];
/** Steps of the two solves whose difference is taken. */
const [LEAST, MOST] = [1, 3];
const PAIRS = quick ? 2 : 8;
const ROUNDS = quick ? 1 : 9;
const PROFILED_MILLISECONDS = quick ? 40 : 1500;
const MICROSECONDS_A_SAMPLE = 100;
/** Of either kind one suffices to see that it runs. */
const names = quick ? /** @type {const} */ (['saddle', 'torus']) : /** @type {const} */ (['saddle', 'parametricTorus', 'dini', 'torus']);

/** Stages, by the files that they are in; what is in no C file is the compiled surface, or JavaScript. */
const STAGES = /** @type {const} */ (['evaluation', 'assembly', 'block solve', 'the rest']);
/** @typedef {typeof STAGES[number]} Stage */
/** @type {[RegExp, Stage][]} */
const FILES = [
  [/^functions/, 'evaluation'],
  [/^(energy|system|elements|metric|parametric|implicit)/, 'assembly'],
  [/^blocks/, 'block solve'],
];

const wasm = new URL('../../wasm/', import.meta.url);
/** @type {Map<string, Stage>} by function; the one of newton.c holds those that it calls */
const stages = new Map([['assemble', /** @type {Stage} */ ('assembly')]]);
for (const file of readdirSync(wasm).filter((name) => /\.[ch]$/.test(name))) {
  const stage = FILES.find(([pattern]) => pattern.test(file))?.[1] ?? 'the rest';
  const text = readFileSync(new URL(file, wasm), 'utf8').replace(/__attribute__\(\(.*?\)\) /g, '');
  const definitions = text.matchAll(/^(?!typedef)[a-z][\w *]*?\b(\w+)\([^;]*$/gm);
  for (const [, name] of definitions) if (!stages.has(name) || (file.endsWith('.c') && name !== 'assemble')) stages.set(name, stage);
}

const surfpath = await load({ wasm: readFileSync(new URL('../../build/named.wasm', import.meta.url)) });
const surfaces = Object.fromEntries(names.map((name) => [name, { entry: gallery[name], surface: surfpath.surface(gallery[name]) }]));
const native = buildNative('iteration', surfaces);
const session = new Session();
session.connect();
await session.post('Profiler.enable');
await session.post('Profiler.setSamplingInterval', { interval: MICROSECONDS_A_SAMPLE });

/** Pairs whose first three steps are full ones, whatever the number of points. @param {Surface} surface @returns {Pair[]} */
function choosePairs(surface) {
  const isDirect = (/** @type {Pair} */ pair, /** @type {number} */ points) => {
    const { history, iterations, touchesBoundary } = surface.shortestPath(...pair, { ...POLYLINE, points, start: pair.flat() });
    return iterations > MOST && !touchesBoundary && history.slice(0, MOST).every(({ step }) => step === 1);
  };
  return randomPairs(surface, createRandom(SEED), 60 * PAIRS)
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
    if (!/^\((idle|program)\)$/.test(callFrame.functionName)) counts[isCompiled ? stage : 'the rest'] += hitCount;
  }
  const all = STAGES.reduce((sum, stage) => sum + counts[stage], 0) || 1;
  return /** @type {Record<Stage, number>} */ (Object.fromEntries(STAGES.map((stage) => [stage, counts[stage] / all])));
}

/** @param {string} name @param {Pair[]} pairs @param {number} points */
async function measure(name, pairs, points) {
  const { surface } = surfaces[name];
  const tasks = (/** @type {number} */ maxIterations) =>
    pairs.map((pair) => {
      const options = { ...POLYLINE, points, maxIterations, start: pair.flat() };
      return () => surface.shortestPath(...pair, options);
    });
  const [many, few] = [tasks(MOST), tasks(LEAST)];
  const runAll = (/** @type {typeof many} */ solves) => () => solves.forEach((solve) => void solve());
  warmUp(runAll(many));
  const { most, least } = sumLeast({ most: many, least: few }, quick ? 20 : Math.round(400_000 / points));
  const repetitions = quick ? 1 : Math.max(1, Math.round(2_000 / points));
  const timeNative = (/** @type {number} */ steps) => () => native.solveAtOnce(name, pairs, points, repetitions, steps).nanoseconds;
  const gcc = compete({ most: timeNative(MOST), least: timeNative(LEAST) }, quick ? 4 : 10 * ROUNDS);
  const shares = await profile(runAll(many));
  const iterations = (MOST - LEAST) * pairs.length;
  // A busy machine may hide the difference of a few samples: then nothing is claimed.
  const perIteration = (/** @type {number} */ nanoseconds, /** @type {number} */ count) => Math.max(0, nanoseconds) / count;
  const ours = perIteration(most - least, iterations);
  const theirs = perIteration(gcc.most.minimum - gcc.least.minimum, MOST - LEAST);
  const stages = STAGES.map((stage) => [stage, shares[stage]]);
  return {
    surface: name,
    n: points,
    'µs an iteration': ours / 1e3,
    'native µs': theirs / 1e3,
    ratio: theirs && ours / theirs,
    'ns a node': ours / points,
    ...Object.fromEntries(stages),
    'µs once': Math.max(0, least / pairs.length - LEAST * ours) / 1e3,
  };
}

const rows = [];
for (const name of names) {
  const pairs = choosePairs(surfaces[name].surface);
  for (const points of COUNTS) rows.push(await measure(name, pairs, points));
}
session.disconnect();
report('iteration', 'A Newton iteration of the polyline: half of what two more steps take, minima of many samples', rows, [
  'µs once: what a solve takes besides, a sweep among it. Shares of a solve of three steps, by where the profiler found it: the surface and its functions;',
  'assembly, retraction and elimination; the rest of the block solve; the rest (line search, final check, copies, JavaScript).',
  'wanted at n = 500: 8 µs saddle, 11 torus, 14 Dini; from 500 to 5,000 at most 10.5 times as long',
]);
