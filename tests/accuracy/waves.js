// Random pairs on fields of waves, long sheets and pipes with bends, whose shortest paths are as many as there are ways past bumps, against what these paths become when they are bent aside at random
// (tests/accuracy/measure/waves.js). Prints a table. `node tests/accuracy/waves.js [pairs on a field [bends a pair [seed]]]`.
import { load } from '../../web/index.js';
import { createRandom } from '../helpers/random.js';
import { LONG, SIDE, shortestBeside, WAVES } from './measure/waves.js';

const [pairs = 60, bends = 100, seed = 1] = process.argv.slice(2).map(Number);
/** Longer by less is what the tolerance explains, and what nobody will miss. */
const SHORTER = [1e-8, 1e-5, 1e-4];
/** No search promises the shortest way past some forty bumps. */
const MOST = 0.1;

const surfpath = await load();
console.log(
  `seed ${seed}; longer than a path beside it by 1e-8, 1e-5, 1e-4\nsurface                           pairs  refused  1e-8  1e-5  1e-4     most  mean ms`,
);
/** @type {typeof LONG} */
const fields = WAVES.map((z) => [z, { kind: 'graph', z, x: [-SIDE, SIDE], y: [-SIDE, SIDE] }]);
for (const [name, definition] of [...fields, ...LONG]) {
  const surface = surfpath.surface(definition);
  const { u, v } = /** @type {NonNullable<typeof surface.domain>} */ (surface.domain);
  const random = createRandom(seed);
  const place = () => [random.between(u[0], u[1]), random.between(v[0], v[1])];
  surface.shortestPath(place(), place());
  let milliseconds = 0;
  const over = Array.from({ length: pairs }, () => {
    const [from, to] = [place(), place()];
    const start = performance.now();
    const path = surface.shortestPath(from, to);
    milliseconds += performance.now() - start;
    return path.converged ? path.length / shortestBeside(surface, path, random, bends).length - 1 : NaN;
  });
  surface.dispose();
  const refused = over.filter(Number.isNaN).length;
  const counts = SHORTER.map((least) => over.filter((by) => by > least).length);
  const most = Math.max(...over.filter((by) => by >= 0), 0);
  const columns = [pairs, refused, ...counts, most.toExponential(1), (milliseconds / pairs).toFixed(1)];
  console.log(name.padEnd(33) + columns.map((text, i) => String(text).padStart([6, 9, 6, 6, 6, 9, 9][i])).join(''));
  if (refused + counts[1] > MOST * pairs) process.exitCode = 1;
}
surfpath.dispose();
