// Random pairs on steep surfaces (tests/accuracy/measure/steep.js): how many paths converge, of which status the others are, and what that takes. Prints a table.
// With a file, which keeps the least length of each pair: how many converge that are longer, and by how much at most. `node tests/accuracy/steep.js [pairs on a surface [seed [file]]]`.
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { load } from '../../web/index.js';
import { createRandom } from '../helpers/random.js';
import { RIGHT, STEEP } from './measure/steep.js';

const [pairs = 20, seed = 1] = process.argv.slice(2, 4).map(Number);
const file = process.argv[4];

/** @type {Record<string, number>} */
const known = file && existsSync(file) ? JSON.parse(readFileSync(file, 'utf8')) : {};
const surfpath = await load();
console.log(`seed ${seed}\nheight           pairs  converged  longer  by %   mean ms  most ms  others`);
for (const [name, { z, side, across = side }] of Object.entries(STEEP)) {
  const surface = surfpath.parametric({ x: 'u', y: 'v', z, u: [-side, side], v: [-across, across] });
  const random = createRandom(seed);
  const place = () => [random.between(-side, side), random.between(-across, across)];
  surface.shortestPath(place(), place());
  const times = [];
  const counts = new Map();
  let [longer, most] = [0, 0];
  for (let i = 0; i < pairs; i++) {
    const [from, to] = [place(), place()];
    const start = performance.now();
    const { status, converged: isRight, length } = surface.shortestPath(from, to);
    times.push(performance.now() - start);
    counts.set(status, (counts.get(status) ?? 0) + 1);
    const pair = JSON.stringify([name, from, to]);
    const excess = isRight ? length / (known[pair] ?? length) - 1 : 0;
    if (excess > RIGHT) longer++;
    most = Math.max(most, excess);
    if (isRight) known[pair] = Math.min(length, known[pair] ?? length);
  }
  surface.dispose();
  const { converged = 0, ...others } = Object.fromEntries(counts);
  const mean = times.reduce((sum, time) => sum + time, 0) / pairs;
  const columns = [pairs, converged, longer, (100 * most).toFixed(1), mean.toFixed(0), Math.max(...times).toFixed(0)];
  const text = Object.entries(others).map(([status, count]) => `${count} ${status}`);
  console.log(
    `${name.padEnd(15)}${columns.map((column, i) => String(column).padStart([7, 11, 8, 6, 10, 9][i])).join('')}  ${text.join(', ')}`,
  );
}
surfpath.dispose();
if (file) writeFileSync(file, JSON.stringify(known));
