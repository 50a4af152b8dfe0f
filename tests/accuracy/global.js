// How often `start: 'global'` finds the globally shortest path, against exhaustive multistart that knows nothing of its graph (tests/helpers/multistart.js).
// Prints a table. `node tests/accuracy/global.js [pairs [starts [surface]]]`; with VERBOSE, the pairs that fail, too.
import { load } from '../../web/index.js';
import { loadCases } from '../helpers/cases.js';
import { multistart, startMaker } from '../helpers/multistart.js';
import { createRandom } from '../helpers/random.js';

const [pairs = 250, starts = 60] = process.argv.slice(2, 4).map(Number);
const only = process.argv[4] ?? '';
const seed = 20;
/** Shorter by less is the same path: the default tolerance twice, and more where one ends beside a conjugate point. */
const MARGIN = 1e-7;

/** Surface of the open data, its kind, its least share of successes, inner points of the polylines (Eq. 47: as many as its smallest curvature needs), resolution
 * of the mesh. @type {[string, string, number, number, number][]} */
const SURFACES = [
  ['saddle', 'parametric', 1, 63, 0],
  ['ptorus', 'parametric', 1, 63, 0],
  ['cylinder_periodic', 'parametric', 1, 63, 0],
  ['bumpy', 'parametric', 0.995, 127, 0],
  ['torus', 'implicit', 1, 63, 32],
  ['metamorphosis', 'implicit', 0.995, 63, 48],
  ['genus2', 'implicit', 0.995, 63, 40],
  ['three_tori', 'implicit', 0.995, 127, 64],
  ['bc_printed', 'implicit', 0.98, 255, 80],
];

/** @typedef {import('../../web/index.js').Surface} Surface */

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

/** @param {Surface} surface @param {number} points @param {number} resolution */
function measure(surface, points, resolution) {
  const random = createRandom(seed);
  const point = pointsOf(surface, random);
  const make = startMaker(surface, random, resolution);
  const result = { pairs: 0, found: 0, shorter: 0, straight: 0, failed: 0, disconnected: 0, milliseconds: 0 };
  surface.shortestPath(point(), point());
  for (let i = 0; i < pairs; i++) {
    const [from, to] = [point(), point()];
    const begin = performance.now();
    const path = surface.shortestPath(from, to);
    result.milliseconds += performance.now() - begin;
    if (path.status === 'disconnected') {
      result.disconnected++;
      continue;
    }
    const best = multistart(surface, make, from, to, { starts, points });
    const straight = surface.shortestPath(from, to, { start: 'straight' });
    result.pairs++;
    if (!path.converged) result.failed++;
    if (path.length <= best * (1 + MARGIN)) result.found++;
    else if (process.env.VERBOSE) console.log(JSON.stringify({ from, to, status: path.status, length: path.length, best }));
    if (path.length < best * (1 - MARGIN)) result.shorter++;
    if (straight.converged && straight.length <= Math.min(best, path.length) * (1 + MARGIN)) result.straight++;
  }
  return result;
}

const surfpath = await load();
console.log(
  `seed ${seed}, ${starts} starts a pair. found: no start leads to a shorter path; shorter: than all of them; straight: so is the straight start`,
);
console.log('surface             pairs   found  shorter  straight  failed  disconnected    ms');
let below = 0;
for (const [name, kind, least, points, resolution] of SURFACES.filter(([name]) => name.includes(only))) {
  const found = loadCases({ kinds: [kind] }).find(({ expected }) => expected.surface === name);
  if (!found) throw new Error(`no case on ${name}`);
  const surface = surfpath.surface(/** @type {any} */ (found.definition));
  const result = measure(surface, points, resolution);
  const percent = (/** @type {number} */ count) => `${((100 * count) / result.pairs).toFixed(1)} %`;
  const isBelow = result.found < least * result.pairs;
  below += Number(isBelow);
  const columns = [
    name.padEnd(18),
    String(result.pairs).padStart(6),
    percent(result.found).padStart(7),
    percent(result.shorter).padStart(8),
    percent(result.straight).padStart(9),
    String(result.failed).padStart(7),
    String(result.disconnected).padStart(13),
    (result.milliseconds / pairs).toFixed(1).padStart(5),
  ];
  console.log(columns.join(' '), isBelow ? `below ${100 * least} %` : '');
  surface.dispose();
}
surfpath.dispose();
process.exitCode = below > 0 ? 1 : 0;
