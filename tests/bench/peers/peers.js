/**
 * What a user would take instead, on the same task, with the true error beside the time: scipy's solve_bvp on the geodesic equations, CGAL's exact
 * paths on meshes, GeographicLib on the Earth. Run by `make bench-peers`, which installs them. Each side gets the loosest of its tolerances that
 * meets the wanted true error, pair by pair; starting Python, and compiling formulas, are not counted.
 */
import { execFileSync } from 'node:child_process';
import { createRequire } from 'node:module';
import { fileURLToPath } from 'node:url';
import { load } from 'surfpath';
import { gallery } from 'surfpath/gallery';
import { createRandom } from '../../helpers/random.js';
import { quick, report, SEED, spread, warmUp } from '../bench.js';
import { randomPairs } from '../pairs.js';

/** @typedef {import('surfpath').Surface} Surface */
/** @typedef {import('../pairs.js').Pair} Pair */
/** @typedef {{ tolerance: number, seconds: number, error: number }} Try how long one side took at a tolerance, and the true relative error */

const PAIRS = quick ? 2 : 12;
const ROUNDS = quick ? 1 : 3;
const EXACT = 1e-13;
const OUR_TOLERANCES = [1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9];
const SCIPY_TOLERANCES = [1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7];

const here = (/** @type {string} */ relative) => fileURLToPath(new URL(relative, import.meta.url));
const surfpath = await load();

/**
 * Random pairs whose locally shortest path near the straight line is known and free of walls.
 * @param {Surface} surface @param {number} count @returns {{ pair: Pair, length: number }[]}
 */
function choosePairs(surface, count) {
  const chosen = [];
  for (const pair of randomPairs(surface, createRandom(SEED), 50 * count)) {
    const path = surface.shortestPath(...pair, { start: 'straight', tolerance: EXACT });
    const isKnown = path.length > 0 && path.lengthError < 1e-11 * path.length && path.index === 0;
    if (isKnown && !path.touchesBoundary && chosen.length < count) chosen.push({ pair, length: path.length });
  }
  return chosen;
}

/** Seconds of one of our paths, the least of several rounds. @param {() => { length: number }} solve */
function timeOurs(solve) {
  warmUp(solve, quick ? 5 : 60);
  let least = Infinity;
  for (let round = 0; round < (quick ? 2 : 20); round++) {
    const start = performance.now();
    for (let i = 0; i < 5; i++) solve();
    least = Math.min(least, (performance.now() - start) / 5e3);
  }
  return { seconds: least, length: solve().length };
}

/** @param {Surface} surface @param {{ pair: Pair, length: number }} known @returns {Try[]} */
function tryOurs(surface, { pair, length: truth }) {
  return OUR_TOLERANCES.map((tolerance) => {
    const { seconds, length } = timeOurs(() => surface.shortestPath(...pair, { start: 'straight', tolerance }));
    return { tolerance, seconds, error: Math.abs(length / truth - 1) };
  });
}

/** The quickest that is good enough. @param {Try[]} tries @param {number} wanted */
const quickest = (tries, wanted) => tries.filter(({ error }) => error <= wanted).sort((one, other) => one.seconds - other.seconds)[0];

const median = (/** @type {number[]} */ numbers) => (numbers.length > 0 ? spread(numbers).median : Number.NaN);
const largest = (/** @type {Try[]} */ tries) => Math.max(...tries.map(({ error }) => error));

/** A row of the table. @param {string} task @param {string} peer @param {(Try | undefined)[]} ours @param {(Try | undefined)[]} theirs by pair */
function compare(task, peer, ours, theirs) {
  const both = ours.flatMap((our, i) => (our && theirs[i] ? [{ our, their: theirs[i] }] : []));
  return {
    task,
    peer,
    'our µs': 1e6 * median(both.map(({ our }) => our.seconds)),
    'our error': largest(both.map(({ our }) => our)),
    'their µs': 1e6 * median(both.map(({ their }) => their.seconds)),
    'their error': largest(both.map(({ their }) => their)),
    'times as fast': median(both.map(({ our, their }) => their.seconds / our.seconds)),
    'solved by us': ours.filter(Boolean).length,
    'by them': theirs.filter(Boolean).length,
    pairs: ours.length,
  };
}

/** @param {'saddle' | 'dini'} name */
function compareScipy(name) {
  const wanted = 1e-6;
  const surface = surfpath.surface(gallery[name]);
  const known = choosePairs(surface, PAIRS);
  const task = { surface: name, pairs: known.map(({ pair }) => pair.flat()), tolerances: SCIPY_TOLERANCES, rounds: ROUNDS };
  const said = execFileSync('/usr/bin/python3', ['-W', 'ignore', here('solve_bvp.py')], { input: JSON.stringify(task), encoding: 'utf8' });
  const rows = /** @type {{ pair: number, tolerance: number, seconds: number, length: number | null }[]} */ (JSON.parse(said));
  const theirs = known.map(({ length: truth }, i) => {
    const tries = rows.filter(({ pair, length }) => pair === i && length !== null);
    return quickest(
      tries.map(({ tolerance, seconds, length }) => ({ tolerance, seconds, error: Math.abs(Number(length) / truth - 1) })),
      wanted,
    );
  });
  const ours = known.map((one) => quickest(tryOurs(surface, one), wanted));
  surface.dispose();
  return compare(`${name}, true error ≤ 1e-6`, 'scipy solve_bvp', ours, theirs);
}

/** The paper's section VI.F: the saddle against exact paths on a mesh, which has to be fine enough. */
function compareMesh() {
  const wanted = quick ? 1e-2 : 1e-4;
  const surface = surfpath.surface(gallery.saddle);
  const known = choosePairs(surface, quick ? 1 : 5);
  const input = `${known.length}\n${known.map(({ pair }) => pair.flat().join(' ')).join('\n')}\n`;
  const binary = here('../../../build/peers/mesh');
  /** @type {Try[][]} */ const tries = known.map(() => []);
  for (const cells of quick ? [8, 16] : [16, 24, 32, 48, 64, 96]) {
    const { mesh, pairs } = JSON.parse(execFileSync(binary, [String(cells), '1'], { input, encoding: 'utf8' }));
    for (const [i, { seconds, length }] of pairs.entries())
      tries[i].push({ tolerance: cells, seconds: seconds + mesh, error: Math.abs(length / known[i].length - 1) });
  }
  const theirs = tries.map((some) => quickest(some, wanted));
  const ours = known.map((one) => quickest(tryOurs(surface, one), wanted));
  surface.dispose();
  return compare(`saddle, true error ≤ ${wanted}`, 'CGAL exact mesh path', ours, theirs);
}

/** Distances on the Earth in metres; ours from longitude and reduced latitude. @param {'global' | 'straight'} start */
function compareEarth(start) {
  const { Geodesic } = createRequire(new URL('../../../build/peers/', import.meta.url))('geographiclib-geodesic');
  const random = createRandom(SEED);
  const flattening = 1 / 298.257223563;
  const definition = /** @type {const} */ ({
    kind: 'parametric',
    x: 'a cos(v)*cos(u)',
    y: 'a cos(v)*sin(u)',
    z: 'a*(1 - f)*sin(v)',
    u: ['-pi', 'pi'],
    v: ['-pi/2', 'pi/2'],
    parameters: { a: 6378137, f: flattening },
  });
  const surface = surfpath.surface(definition);
  const ground = () => [random.between(-180, 180), (Math.asin(random.between(-1, 1)) * 180) / Math.PI];
  const reduce = (/** @type {number[]} */ [longitude, latitude]) => {
    const angle = (latitude * Math.PI) / 180;
    return [(longitude * Math.PI) / 180, Math.atan((1 - flattening) * Math.tan(angle))];
  };
  const pairs = Array.from({ length: PAIRS }, () => [ground(), ground()]);
  const inverse = (/** @type {number[][]} */ [[lon1, lat1], [lon2, lat2]]) => ({
    length: Geodesic.WGS84.Inverse(lat1, lon1, lat2, lon2).s12,
  });
  const theirs = pairs.map((pair) => ({ tolerance: 0, seconds: timeOurs(() => inverse(pair)).seconds, error: 0 }));
  const ours = pairs.map((pair) => {
    const { seconds, length } = timeOurs(() => surface.shortestPath(reduce(pair[0]), reduce(pair[1]), { start }));
    return { tolerance: 1e-9, seconds, error: Math.abs(length / inverse(pair).length - 1) };
  });
  surface.dispose();
  return compare(`WGS84, ${start}`, 'GeographicLib (is the truth)', ours, theirs);
}

const rows = [compareScipy('saddle'), compareScipy('dini'), compareMesh(), compareEarth('straight'), compareEarth('global')];
report('peers', `A path by others and by us, ${PAIRS} random pairs: medians, and the largest true relative error`, rows, [
  "ours: straight starts but for WGS84, global; there to 1e-9; times as fast: the ratios' median",
  "their tolerance, mesh and grid are the quickest that meet the error, ours too; the mesh's time is in theirs",
  'the paper (VI.F): 0.09 s for its method, 2.60 s for paths on a mesh of the saddle',
]);
