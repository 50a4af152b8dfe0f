/** A path near an earlier one, whose end has moved, by how many points that has; beside a straight start and the global search. */
import { load } from 'surfpath';
import { gallery } from 'surfpath/gallery';
import { createRandom } from '../helpers/random.js';
import { quick, report, SEED, sumLeast } from './bench.js';
import { randomPairs } from './pairs.js';

const [PAIRS, ROUNDS] = quick ? [2, 1] : [16, 25];
const POINTS = [64, 250, 1000, 4000];
/** What the end moves by, in parts of u and v. */
const MOVED = 1e-3;

const surfpath = await load();

/** @param {'saddle' | 'parametricTorus'} name */
function measure(name) {
  const surface = surfpath.surface(gallery[name]);
  const pairs = randomPairs(surface, createRandom(SEED), PAIRS);
  const moved = pairs.map(([from, to]) => ({ from, to: to.map((x) => x * (1 - MOVED)) }));
  const starts = POINTS.map((points) => [String(points), pairs.map(([from, to]) => surface.shortestPath(from, to, { points }))]);
  const ask = (/** @type {number} */ i, /** @type {import('surfpath').PathOptions} */ options) =>
    surface.shortestPath(moved[i].from, moved[i].to, options);
  const converged = moved.every((_, i) => starts.every(([, paths]) => ask(i, { start: /** @type {any} */ (paths)[i] }).converged));
  const rivals = Object.fromEntries([
    ['global', moved.map((_, i) => () => ask(i, {}))],
    ['straight', moved.map((_, i) => () => ask(i, { start: 'straight' }))],
    ...starts.map(([points, paths]) => [points, moved.map((_, i) => () => ask(i, { start: /** @type {any} */ (paths)[i] }))]),
  ]);
  const sums = sumLeast(rivals, ROUNDS);
  surface.dispose();
  const columns = Object.entries(sums).map(([rival, sum]) => [
    Number.isNaN(Number(rival)) ? `µs ${rival}` : `from ${rival} points`,
    (1e-3 * sum) / PAIRS,
  ]);
  return { surface: name, ...Object.fromEntries(columns), converged };
}

report('starts', 'A path near an earlier one, µs', [measure('saddle'), measure('parametricTorus')]);
surfpath.dispose();
