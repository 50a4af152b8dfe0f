/** The paper's Fig. 3: how the time of a path to |grad E| <= 1e-6 depends on the number K of its points. */
import { load } from 'surfpath';
import { gallery } from 'surfpath/gallery';
import { STRAIGHT } from '../helpers/options.js';
import { createRandom } from '../helpers/random.js';
import { compete, quick, report, SEED, warmUp } from './bench.js';
import { randomPairs } from './pairs.js';

const PAIRS = quick ? 2 : 16;
const ROUNDS = quick ? 1 : 15;
const COUNTS = [50, 100, 200, 300, 400, 500];
/** What the paper reports, in milliseconds. @type {Record<number, number>} */
const PAPER = { 50: 7, 500: 91 };
const names = /** @type {const} */ (['saddle', 'parametricTorus', 'dini', 'torus']);

const surfpath = await load();
const pairsOf = names.map((name) => {
  const surface = surfpath.surface(gallery[name]);
  const isSound = (/** @type {[number[], number[]]} */ pair) =>
    COUNTS.every((points) => {
      const path = surface.shortestPath(...pair, { ...STRAIGHT, points, gradientTolerance: 1e-6 });
      return path.converged && !path.touchesBoundary;
    });
  return {
    name,
    surface,
    pairs: randomPairs(surface, createRandom(SEED), 30 * PAIRS)
      .filter(isSound)
      .slice(0, PAIRS),
  };
});

/** @param {number} points */
function measure(points) {
  const rivals = Object.fromEntries(
    pairsOf.map(({ name, surface, pairs }) => {
      const options = { ...STRAIGHT, points, gradientTolerance: 1e-6 };
      const solveAll = () => pairs.reduce((sum, pair) => sum + surface.shortestPath(...pair, options).length, 0);
      warmUp(solveAll);
      const sample = () => {
        const start = performance.now();
        for (let i = 0; i < 3; i++) solveAll();
        return (1e3 * (performance.now() - start)) / (3 * pairs.length);
      };
      return [name, sample];
    }),
  );
  const spreads = compete(rivals, ROUNDS);
  return {
    K: points,
    ...Object.fromEntries(
      names.flatMap((name) => [
        [`${name} µs median`, spreads[name].median],
        [`${name} minimum`, spreads[name].minimum],
      ]),
    ),
    'paper µs': PAPER[points] ? String(1000 * PAPER[points]) : '',
  };
}

report('fig3', `Fig. 3: microseconds a path to |grad E| <= 1e-6, ${PAIRS} random pairs, straight start`, COUNTS.map(measure), [
  'paper: on a surface and machine that it does not name',
]);
