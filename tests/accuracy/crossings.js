// Random pairs on implicit surfaces that cross themselves along curves, or end in edges: how many paths converge, and how many are longer than over some random place, the legs to which the same search finds:
// distances obey the triangle inequality. Prints a table. `node tests/accuracy/crossings.js [pairs on a surface [places a pair [seed]]]`.
import { load } from '../../web/index.js';
import { createRandom } from '../helpers/random.js';

const [pairs = 20, places = 6, seed = 1] = process.argv.slice(2).map(Number);
/** Longer by this part is longer. */
const LONGER = 1e-6;
/** Formulas, and half the side of the box. @type {Record<string, [string, number]>} */
const SURFACES = {
  'two planes': ['x^2 - y^2', 1.5],
  'three planes': ['x*y*z', 1.5],
  'two spheres': ['((x - 0.5)^2 + y^2 + z^2 - 1)*((x + 0.5)^2 + y^2 + z^2 - 1)', 1.6],
  'two cylinders': ['(x^2 + y^2 - 1)*(x^2 + z^2 - 0.5)', 1.5],
  'Roman surface': ['y^2*z^2 + z^2*x^2 + x^2*y^2 - 1.5*x*y*z', 1],
  'semicubical edge': ['y^2 - x^3', 1.5],
  'astroid’s edges': ['(x^2 + y^2 - 1)^3 + 27*x^2*y^2', 1.5],
  'lens’s edge': ['z^2 - (1 - x^2 - y^2)^3', 1.3],
  'cross-cap': ['4*x^2*(x^2 + y^2 + z^2 + z) + y^2*(y^2 + z^2 - 1)', 1.3],
  'Klein bottle': ['(x^2 + y^2 + z^2 + 2*y - 1)*((x^2 + y^2 + z^2 - 2*y - 1)^2 - 8*z^2) + 16*x*z*(x^2 + y^2 + z^2 - 2*y - 1)', 4],
};

const surfpath = await load();
console.log(`seed ${seed}\nsurface        pairs  converged  longer  by %   mean ms  most ms`);
for (const [name, [f, half]] of Object.entries(SURFACES)) {
  const side = /** @type {[number, number]} */ ([-half, half]);
  const surface = surfpath.implicit({ f, bounds: [side, side, side] });
  const random = createRandom(seed);
  /** @returns {number[]} */
  const draw = () => {
    try {
      const place = Array.from(surface.project([0, 1, 2].map(() => random.between(-half, half))));
      if (place.every((x) => Math.abs(x) < half)) return place;
    } catch {
      /* Nowhere near. */
    }
    return draw();
  };
  const times = [];
  let [converged, longer, most] = [0, 0, 0];
  for (let i = 0; i < pairs; i++) {
    const [from, to] = [draw(), draw()];
    const start = performance.now();
    const path = surface.shortestPath(from, to);
    times.push(performance.now() - start);
    if (!path.converged) continue;
    converged++;
    const over = Array.from({ length: places }, () => draw()).map((place) => {
      const legs = [surface.shortestPath(from, place), surface.shortestPath(place, to)];
      return legs.every((leg) => leg.converged) ? legs[0].length + legs[1].length : Infinity;
    });
    const excess = path.length / Math.min(...over) - 1;
    if (excess > LONGER) longer++;
    most = Math.max(most, excess);
  }
  surface.dispose();
  const mean = times.reduce((sum, time) => sum + time, 0) / pairs;
  const columns = [pairs, converged, longer, (100 * most).toFixed(1), mean.toFixed(0), Math.max(...times).toFixed(0)];
  console.log(`${name.padEnd(13)}${columns.map((column, i) => String(column).padStart([7, 11, 8, 6, 10, 9][i])).join('')}`);
}
surfpath.dispose();
