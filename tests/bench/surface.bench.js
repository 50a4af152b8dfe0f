/** How long a compiled surface takes a point for its values, first and second derivatives: the emitted module, and the same graph as C. */
import { load } from 'surfpath';
import { gallery } from 'surfpath/gallery';
import { createRandom } from '../helpers/random.js';
import { instantiate } from '../helpers/wasm.js';
import { compete, quick, report, SEED, warmUp } from './bench.js';
import { buildNative, compileEntry } from './native.js';
import { pointSource } from './pairs.js';

const POINTS = 500;
const ROUNDS = quick ? 1 : 15;
const NANOSECONDS_A_SAMPLE = quick ? 5e5 : 2e7;
const names = /** @type {const} */ (['saddle', 'dini', 'threeTori']);

const surfpath = await load();
const surfaces = Object.fromEntries(names.map((name) => [name, { entry: gallery[name], surface: surfpath.surface(gallery[name]) }]));
const native = buildNative('surface', surfaces);
const march = buildNative('surface', surfaces, 'march');
const solver = instantiate();

/**
 * The points in the solver's memory, two by two, and the emitted module's `jet` on them.
 * @param {string} name @param {number[][]} points
 */
function installPoints(name, points) {
  const { compiled, variableCount } = compileEntry(surfaces[name].entry, solver.apply);
  const { jet } = solver.link(compiled, variableCount).functions;
  const pairs = points.length >> 1;
  const reserve = (/** @type {number} */ numbers) => (solver.exports.malloc(8 * numbers + 16) + 15) & ~15;
  const [input, output] = [reserve(points.length * variableCount), reserve(points.length * compiled.jet.length)];
  const numbers = new Float64Array(solver.exports.memory.buffer, input, points.length * variableCount);
  points.forEach((point, k) => {
    point.forEach((x, j) => {
      numbers[2 * (variableCount * (k >> 1) + j) + (k & 1)] = x;
    });
  });
  return {
    outputs: compiled.jet.length,
    evaluate: () => jet(pairs, input, output),
    sum: () => new Float64Array(solver.exports.memory.buffer, output, points.length * compiled.jet.length),
  };
}

/** Adds up in the order of the native program, to the bit. @param {Float64Array} results */
function sumPairs(results) {
  let sum = 0;
  for (let i = 0; i < results.length; i += 2) sum += results[i] + results[i + 1];
  return sum;
}

/** @param {string} name */
function measure(name) {
  const source = pointSource(surfaces[name].surface, createRandom(SEED));
  const points = Array.from({ length: POINTS }, source);
  const { outputs, evaluate, sum } = installPoints(name, points);
  warmUp(evaluate);
  const before = performance.now();
  for (let i = 0; i < 10; i++) evaluate();
  const repetitions = Math.max(1, Math.round(NANOSECONDS_A_SAMPLE / (1e5 * (performance.now() - before))));
  let same = true;
  const sampleNative = (/** @type {typeof native} */ build) => () => {
    const sample = build.evaluate(name, points, repetitions);
    same &&= sample.sum === sumPairs(sum());
    return sample.nanoseconds;
  };
  const { wasm, gcc, tuned } = compete(
    {
      wasm: () => {
        const start = performance.now();
        for (let i = 0; i < repetitions; i++) evaluate();
        return (1e6 * (performance.now() - start)) / (repetitions * POINTS);
      },
      gcc: sampleNative(native),
      tuned: sampleNative(march),
    },
    ROUNDS,
  );
  return {
    surface: name,
    outputs,
    'ns median': wasm.median,
    'ns minimum': wasm.minimum,
    'native ns median': gcc.median,
    'native ns minimum': gcc.minimum,
    'march=native ns minimum': tuned.minimum,
    ratio: wasm.minimum / gcc.minimum,
    'same bits': same,
  };
}

report('surface', `Nanoseconds a point for position, first and second derivatives, ${POINTS} points`, names.map(measure), [
  'native: gcc -O3, two doubles a register, like the WebAssembly',
]);
