/**
 * The paper's Table I beside ours: average iterations to |grad E| <= 1e-6 and relative error of the length.
 *
 * True lengths: each path continued to 1,024 and 2,048 chords, and extrapolated; that is good to about 1e-12.
 */
import { load } from 'surfpath';
import { gallery } from 'surfpath/gallery';
import { POLYLINE, STRAIGHT } from '../helpers/options.js';
import { createRandom } from '../helpers/random.js';
import { quick, report, SEED } from './bench.js';
import { randomPairs } from './pairs.js';

/** @typedef {import('surfpath').Surface} Surface */
/** @typedef {import('surfpath').Path} Path */
/** @typedef {import('./pairs.js').Pair} Pair */

const PAIRS = quick ? 5 : 200;
const POINTS = 50;
const FINE = 1023;

/** Rows of the paper in its order: iterations, relative error in per mille. */
const PAPER = [
  [2.4, 0.017],
  [6.9, 0.0051],
  [6, 0.018],
  [4.7, 0.012],
  [7.1, 0.079],
  [4.3, 0.024],
  [4.9, 0.0069],
  [5.4, 0.087],
];
const names = /** @type {const} */ (['saddle', 'paraboloid', 'helicoid', 'cylinder', 'threeTori', 'metamorphosis', 'genus2', 'torus']);

/** The length of the geodesic that a path approximates; NaN if its continuations do not converge. @param {Surface} surface @param {Pair} pair @param {Path} path */
function trueLength(surface, [from, to], path) {
  const coarse = surface.shortestPath(from, to, { ...POLYLINE, points: FINE, start: path });
  const fine = surface.shortestPath(from, to, { ...POLYLINE, points: 2 * FINE + 1, start: coarse });
  return coarse.converged && fine.converged ? (4 * fine.length - coarse.length) / 3 : Number.NaN;
}

const mean = (/** @type {number[]} */ numbers) => numbers.reduce((sum, x) => sum + x, 0) / numbers.length;

/**
 * Iterations and errors over the pairs that converge without touching an edge.
 * @param {Surface} surface @param {Pair[]} pairs @param {'polyline' | 'paper'} algorithm
 */
function measure(surface, pairs, algorithm) {
  const options = { ...STRAIGHT, algorithm, points: POINTS, gradientTolerance: 1e-6 };
  const solved = pairs.map((pair) => ({ pair, path: surface.shortestPath(...pair, options) }));
  const free = solved.filter(({ path }) => path.converged && !path.touchesBoundary);
  const errors = free.map(({ pair, path }) => Math.abs(path.length / trueLength(surface, pair, path) - 1));
  return {
    iterations: mean(free.map(({ path }) => path.iterations)),
    error: 1000 * mean(errors.filter((error) => !Number.isNaN(error))),
    converged: free.length,
    unknown: errors.filter(Number.isNaN).length,
  };
}

const surfpath = await load();
const rows = names.map((name, i) => {
  const surface = surfpath.surface(gallery[name]);
  const pairs = randomPairs(surface, createRandom(SEED), PAIRS);
  const [ours, theirs] = [measure(surface, pairs, 'polyline'), measure(surface, pairs, 'paper')];
  surface.dispose();
  return {
    surface: name,
    iterations: ours.iterations,
    'error ‰': ours.error,
    converged: ours.converged,
    "iterations, 'paper'": theirs.iterations,
    "error ‰, 'paper'": theirs.error,
    "converged, 'paper'": theirs.converged,
    "paper's row": 'ABCDEFGH'[i],
    'iterations, printed': PAPER[i][0],
    'error ‰, printed': PAPER[i][1],
    'no true length': ours.unknown + theirs.unknown,
  };
});

report('table1', `Table I: ${PAIRS} random pairs a surface, K = ${POINTS}, |grad E| <= 1e-6, straight start`, rows, [
  "the printed rows lost their names: A to H are in the table's order, ours in that of the paper's Fig. 1, and one need not be the other",
  'converged: of all pairs, and touching no edge; the others jump sheets from a straight start, touch an edge, or (paper) end at saddles',
  "'paper': its own method in this library; no true length: the finer continuation of the path jumps sheets, so its error is left out",
]);
