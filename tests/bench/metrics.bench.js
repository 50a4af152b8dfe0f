/** What a density and a metric cost: a step of Newton's on a polyline, and whole paths, beside the same surface as space measures it. */
import { load } from 'surfpath';
import { createRandom } from '../helpers/random.js';
import { quick, report, SEED, sumLeast } from './bench.js';

const [PAIRS, ROUNDS] = quick ? [2, 1] : [12, 25];
/** Inner points of the polylines. */
const POINTS = 500;

const saddle = { kind: 'graph', z: '0.3*x*y', x: [-1.5, 1.5], y: [-1.5, 1.5] };
const egg = { kind: 'implicit', f: 'x^2 + y^2/1.4 + z^2/0.8 - 1', bounds: Array(3).fill([-1.3, 1.3]) };
const bump = '1 + 0.5*exp(-x^2 - y^2)';
/** @type {Record<string, any>} */
const surfaces = {
  graph: saddle,
  'graph, density': { ...saddle, density: bump },
  'graph, E F G': { ...saddle, metric: { E: '1 + x^2', F: '0.1*x', G: '1 + y^2' } },
  implicit: egg,
  'implicit, density': { ...egg, density: bump },
  'implicit, tensor': { ...egg, metric: { xx: '1 + z^2', xy: '0', xz: '0', yy: '1', yz: '0.1*x', zz: '2' } },
};
const surfpath = await load();

/** Pairs not far from each other: places in the rectangle, or on the egg. @param {import('surfpath').Surface} surface @returns {[number[], number[]][]} */
function choosePairs(surface) {
  const random = createRandom(SEED);
  const place = () => {
    const [x, y] = [random.between(-1, 1), random.between(-1, 1)];
    return surface.domain ? [x, y] : surface.project([0.5 * x, 0.5 * y, 1]);
  };
  return Array.from({ length: PAIRS }, () => [place(), place()]);
}

/** @param {string} name */
function measure(name) {
  const surface = surfpath.surface(surfaces[name]);
  const pairs = choosePairs(surface);
  const chords = /** @type {const} */ ({ algorithm: 'polyline', start: 'straight', points: POINTS });
  const steps = pairs.map(([from, to]) => surface.shortestPath(from, to, chords)).reduce((sum, path) => sum + path.iterations + 1, 0);
  const converged = pairs.every(([from, to]) => surface.shortestPath(from, to).converged);
  const ask = (/** @type {import('surfpath').PathOptions} */ options) =>
    pairs.map(
      ([from, to]) =>
        () =>
          surface.shortestPath(from, to, options),
    );
  const sums = sumLeast({ chords: ask(chords), straight: ask({ start: 'straight' }), global: ask({}) }, ROUNDS);
  surface.dispose();
  return {
    surface: name,
    'ns a node and step': sums.chords / steps / POINTS,
    'µs polyline': (1e-3 * sums.chords) / PAIRS,
    'µs straight': (1e-3 * sums.straight) / PAIRS,
    'µs default': (1e-3 * sums.global) / PAIRS,
    converged,
  };
}

report('metrics', `What densities and metrics cost, ${PAIRS} random pairs`, Object.keys(surfaces).map(measure), [
  `polyline: ${POINTS} points, straight start; straight, default: elements to 1e-9`,
]);
surfpath.dispose();
