// Random pairs on steep surfaces (tests/accuracy/measure/steep.js): how many paths converge, of which status the others are, and what that takes. Prints a table.
// `node tests/accuracy/steep.js [pairs on a surface [seed]]`.
import { load } from '../../web/index.js';
import { createRandom } from '../helpers/random.js';
import { STEEP } from './measure/steep.js';

const [pairs = 20, seed = 1] = process.argv.slice(2).map(Number);

const surfpath = await load();
console.log(`seed ${seed}\nheight           pairs  converged   mean ms  most ms  others`);
for (const [name, { z, side, across = side }] of Object.entries(STEEP)) {
  const surface = surfpath.parametric({ x: 'u', y: 'v', z, u: [-side, side], v: [-across, across] });
  const random = createRandom(seed);
  const place = () => [random.between(-side, side), random.between(-across, across)];
  surface.shortestPath(place(), place());
  const times = [];
  const counts = new Map();
  for (let i = 0; i < pairs; i++) {
    const [from, to] = [place(), place()];
    const start = performance.now();
    const { status } = surface.shortestPath(from, to);
    times.push(performance.now() - start);
    counts.set(status, (counts.get(status) ?? 0) + 1);
  }
  surface.dispose();
  const { converged = 0, ...others } = Object.fromEntries(counts);
  const mean = times.reduce((sum, time) => sum + time, 0) / pairs;
  const columns = [pairs, converged, mean.toFixed(0), Math.max(...times).toFixed(0)];
  const text = Object.entries(others).map(([status, count]) => `${count} ${status}`);
  console.log(`${name.padEnd(15)}${columns.map((column, i) => String(column).padStart([7, 11, 10, 9][i])).join('')}  ${text.join(', ')}`);
}
surfpath.dispose();
