/** Fuzzes the solver with random problems: surfaces of the gallery and of random formulas, random ends and options. Every one ends in a status. */
import { gallery } from '../../web/gallery.js';
import { load } from '../../web/index.js';
import { randomExpression } from '../helpers/random-expression.js';
import { checkPath } from './definitions.js';

/** @typedef {import('../helpers/random.js').Random} Random */

const PAIRS = { straight: 200, global: 8 };
const ALGORITHMS = ['elements', 'polyline', 'polyline', 'paper'];
/** Milliseconds that no path may take, on a machine that does other things too. */
const HANG = 60_000;

/** A surface of a random formula, as often as not one that is not smooth, or NaN in places. @param {Random} random @returns {any} */
function drawDefinition(random) {
  const choice = random.integer(10);
  // Random exponents are of u.
  const formula = (/** @type {string[]} */ ...names) => randomExpression(random, 1, names).replaceAll(/\bu\b/g, names[0]);
  if (choice < 3) return random.pick(Object.values(gallery));
  if (choice < 5) return { kind: 'graph', z: formula('x', 'y'), x: [-1, 1], y: [-1, 1] };
  if (choice < 6) return { kind: 'revolution', r: `1.5+${formula('t')}`, z: 't', t: [-1, 1] };
  if (choice < 8)
    return { kind: 'implicit', f: `x^2+y^2+z^2-1+0.2*(${formula('x', 'y', 'z')})`, bounds: [-2, -2, -2].map((low) => [low, -low]) };
  const density = random.next() < 0.3 ? { density: `1+${formula('u', 'v')}^2` } : {};
  return { kind: 'parametric', x: 'u', y: 'v', z: formula('u', 'v'), u: [-1, 1], v: [-1, 1], ...density };
}

/** @param {import('../../web/index.js').Surface} surface @param {any} definition @param {Random} random @returns {number[]} */
function drawPoint({ domain }, definition, random) {
  if (domain) return [random.between(domain.u[0], domain.u[1]), random.between(domain.v[0], domain.v[1])];
  return definition.bounds.map((/** @type {[number, number]} */ [low, high]) => 0.7 * random.between(low, high));
}

/**
 * @param {Random} random @param {number} milliseconds @param {'straight' | 'global'} start
 * @param {number} [most] paths, instead of a time
 * @returns {Promise<{ count: number, notes: string }>}
 */
export async function fuzzProblems(random, milliseconds, start, most = Infinity) {
  /** @type {Record<string, number>} */ const counts = {};
  let [count, surfaces, slowest] = [0, 0, 0];
  let surfpath = await load();
  for (const end = performance.now() + milliseconds; performance.now() < end && count < most; surfaces++) {
    if (surfaces % 500 === 499) {
      surfpath.dispose();
      surfpath = await load();
    }
    const definition = drawDefinition(random);
    const surface = surfpath.surface(definition);
    for (let i = 0; i < PAIRS[start] && count < most && performance.now() < end; i++, count++) {
      const [from, to] = [drawPoint(surface, definition, random), drawPoint(surface, definition, random)];
      const algorithm = random.pick(ALGORITHMS);
      const options = /** @type {any} */ ({ start, algorithm, points: 1 + random.integer(40), maxIterations: random.integer(60) });
      const problem = () => JSON.stringify({ definition, from, to, options });
      const begin = performance.now();
      try {
        const path = surface.shortestPath(from, to, options);
        checkPath(path);
        counts[path.status] = (counts[path.status] ?? 0) + 1;
      } catch (error) {
        throw new Error(`${problem()}: ${/** @type {Error} */ (error).stack}`);
      }
      slowest = Math.max(slowest, performance.now() - begin);
      if (slowest > HANG) throw new Error(`${problem()}: took ${slowest} ms`);
    }
    surface.dispose();
  }
  surfpath.dispose();
  const words = Object.entries(counts).map(([status, times]) => `${status} ${times}`);
  return { count, notes: `${words.join(', ')}; slowest ${slowest.toFixed(0)} ms` };
}
