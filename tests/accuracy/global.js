// How often `start: 'global'` finds the globally shortest path, against exhaustive multistart: from the shortest path over each of many random points of the
// surface, solved again without that point. Prints a table. `node tests/accuracy/global.js [pairs [ways [surface]]]`
import { load } from '../../web/index.js';
import { loadCases } from '../helpers/cases.js';
import { createRandom } from '../helpers/random.js';

const [pairs, ways] = process.argv.slice(2, 4).map(Number);
const only = process.argv[4] ?? '';
const seed = 20;
/** Shorter by less is the same path, seen with other points. */
const MARGIN = 1e-6;

/** Surface of the open data, its kind, its least share of successes, inner points (Eq. 47: as many as its smallest curvature needs). @type {[string, string, number, number][]} */
const SURFACES = [
  ['saddle', 'parametric', 1, 63],
  ['ptorus', 'parametric', 1, 63],
  ['cylinder_periodic', 'parametric', 1, 63],
  ['bumpy', 'parametric', 0.995, 63],
  ['torus', 'implicit', 1, 63],
  ['metamorphosis', 'implicit', 0.995, 63],
  ['genus2', 'implicit', 0.995, 63],
  ['three_tori', 'implicit', 0.995, 63],
  ['bc_printed', 'implicit', 0.98, 255],
];

/** @typedef {import('../../web/index.js').Surface} Surface */
/** @typedef {import('../../web/index.js').Path} Path */

/** A source of random points of a surface. @param {Surface} surface @param {import('../helpers/random.js').Random} random @returns {() => number[]} */
function pointsOf(surface, random) {
  const { domain } = surface;
  if (domain) return () => [random.between(domain.u[0], domain.u[1]), random.between(domain.v[0], domain.v[1])];
  const { positions } = surface.mesh({ resolution: 64 });
  return () => {
    const vertex = 3 * random.integer(positions.length / 3);
    return Array.from(positions.subarray(vertex, vertex + 3));
  };
}

/** @param {Path} path */
const places = (path) => Array.from(path.parameters ?? path.points);

/** The length of the locally shortest path near the shortest one over a point; infinite without one. @param {Surface} surface @param {number[]} from @param {number[]} over @param {number[]} to @param {number} points */
function lengthOver(surface, from, over, to, points) {
  const first = surface.shortestPath(from, over, { points });
  const second = surface.shortestPath(over, to, { points });
  if (!(first.converged && second.converged)) return Number.POSITIVE_INFINITY;
  const width = from.length;
  const begin = places(first);
  const end = places(second);
  const shift = width === 2 ? [0, 1].map((j) => begin[begin.length - 2 + j] - end[j]) : [0, 0, 0];
  const start = [...begin, ...end.slice(width).map((x, i) => x + shift[i % width])];
  const path = surface.shortestPath(start.slice(0, width), start.slice(-width), { points, start });
  return path.converged ? path.length : Number.POSITIVE_INFINITY;
}

/** @param {Surface} surface @param {number} points */
function measure(surface, points) {
  const random = createRandom(seed);
  const point = pointsOf(surface, random);
  const result = { pairs: 0, found: 0, straight: 0, disconnected: 0, failed: 0, milliseconds: 0 };
  point();
  for (let i = 0; i < (pairs || 250); i++) {
    const [from, to] = [point(), point()];
    const begin = performance.now();
    const path = surface.shortestPath(from, to, { points });
    result.milliseconds += performance.now() - begin;
    if (path.status === 'disconnected') {
      result.disconnected++;
      continue;
    }
    result.pairs++;
    if (!path.converged) result.failed++;
    let best = path.converged ? path.length : Number.POSITIVE_INFINITY;
    for (let k = 0; k < (ways || 30); k++) best = Math.min(best, lengthOver(surface, from, point(), to, points));
    const straight = surface.shortestPath(from, to, { points, start: 'straight' });
    if (path.length <= best * (1 + MARGIN)) result.found++;
    else if (process.env.VERBOSE) console.log(JSON.stringify({ from, to, status: path.status, length: path.length, best }));
    if (straight.converged && straight.length <= best * (1 + MARGIN)) result.straight++;
  }
  return result;
}

const surfpath = await load();
console.log(`seed ${seed}`);
console.log('surface             pairs  global  straight  failed  disconnected  ms');
for (const [name, kind, least, points] of SURFACES.filter(([name]) => name.includes(only))) {
  const found = loadCases({ kinds: [kind] }).find(({ expected }) => expected.surface === name);
  if (!found) throw new Error(`no case on ${name}`);
  const surface = surfpath.surface(/** @type {any} */ (found.definition));
  const result = measure(surface, points);
  const share = result.found / result.pairs;
  const percent = (/** @type {number} */ count) => `${((100 * count) / result.pairs).toFixed(1)} %`;
  const columns = [
    name.padEnd(18),
    String(result.pairs).padStart(6),
    percent(result.found).padStart(7),
    percent(result.straight).padStart(9),
  ];
  const more = [
    String(result.failed).padStart(7),
    String(result.disconnected).padStart(13),
    (result.milliseconds / (pairs || 250)).toFixed(1).padStart(5),
  ];
  console.log([...columns, ...more].join(' '), share < least ? `below ${100 * least} %` : '');
  surface.dispose();
}
surfpath.dispose();
