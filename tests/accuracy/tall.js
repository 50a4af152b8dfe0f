// Random pairs on heights over a square as implicit surfaces in a tall box, against the same heights over x and y, for which there is a net of ways of its own: how many paths converge, how many are
// longer than there, and by how much. Prints a table. `node tests/accuracy/tall.js [pairs on a surface [seed]]`.
import { load } from '../../web/index.js';
import { createRandom } from '../helpers/random.js';
import { RIGHT } from './measure/steep.js';

const [pairs = 30, seed = 1] = process.argv.slice(2).map(Number);
const rastrigin = '(20 + x^2 + y^2 - 10cos(2pi*x) - 10cos(2pi*y))';
/** Heights, half the side of the square, and from where to where they lead. @type {Record<string, [string, number, [number, number]]>} */
const HEIGHTS = {
  'Rastrigin / 10': [`${rastrigin}/10`, 2, [-0.5, 6]],
  'Rastrigin / 5': [`${rastrigin}/5`, 2, [-0.5, 11]],
  'Rastrigin / 4': [`${rastrigin}/4`, 2, [-0.5, 14]],
  'Rastrigin / 3': [`${rastrigin}/3`, 2, [-0.5, 18]],
  'Rastrigin / 2': [`${rastrigin}/2`, 2, [-0.5, 28]],
  peaks: ['3(1 - x)^2*exp(-x^2 - (y + 1)^2) - 10(x/5 - x^3 - y^5)*exp(-x^2 - y^2) - exp(-(x + 1)^2 - y^2)/3', 3, [-8, 9]],
  ripples: ['cos(3(x^2 + y^2))', 2, [-1.2, 1.2]],
  'egg box': ['3sin(3x)*sin(3y)', 2, [-3.3, 3.3]],
};

const surfpath = await load();
console.log(`seed ${seed}\nheight           pairs  converged  longer  by %   mean ms  most ms`);
for (const [name, [z, side, high]] of Object.entries(HEIGHTS)) {
  const over = surfpath.graph({ z, x: [-side, side], y: [-side, side] });
  const body = surfpath.implicit({ f: `z - (${z})`, bounds: [[-side, side], [-side, side], high] });
  const random = createRandom(seed);
  const place = () => [random.between(-side, side), random.between(-side, side)];
  const times = [];
  let [converged, longer, most] = [0, 0, 0];
  for (let i = 0; i < pairs; i++) {
    const [from, to] = [place(), place()];
    const known = over.shortestPath(from, to);
    const [a, b] = [from, to].map((at) => over.evaluate(at).slice(0, 3));
    const start = performance.now();
    const path = body.shortestPath(a, b);
    times.push(performance.now() - start);
    const excess = path.converged && known.converged ? path.length / known.length - 1 : 0;
    if (path.converged) converged++;
    if (excess > RIGHT) longer++;
    most = Math.max(most, excess);
  }
  over.dispose();
  body.dispose();
  const mean = times.reduce((sum, time) => sum + time, 0) / pairs;
  const columns = [pairs, converged, longer, (100 * most).toFixed(1), mean.toFixed(0), Math.max(...times).toFixed(0)];
  console.log(`${name.padEnd(15)}${columns.map((column, i) => String(column).padStart([7, 11, 8, 6, 10, 9][i])).join('')}`);
}
surfpath.dispose();
