// Random pairs on corrugated sheets, a sin(kx) over a square, against the plane that they unroll to. Prints a table.
// `node tests/accuracy/corrugated.js [pairs on a sheet]`.
import { load } from '../../web/index.js';
import { createRandom } from '../helpers/random.js';
import { acrossWaves, corrugated, unroll } from '../helpers/unroll.js';

const pairs = Number(process.argv[2] ?? 30);
/** Wave numbers, and slopes: of the first all paths converge. */
const [SOLVED, STEEPER] = [
  [
    [40, 6],
    [60, 6],
    [80, 3],
    [100, 2],
  ],
  [
    [80, 6],
    [100, 3],
    [150, 2],
  ],
];
/** A path that converged is as long as unrolled to this part of it: the default tolerance. */
const RIGHT = 1e-9;

const surfpath = await load();
console.log('   k  slope  pairs  converged    most  mean ms');
for (const [k, slope] of [...SOLVED, ...STEEPER]) {
  const random = createRandom(k);
  const sheet = surfpath.graph({ z: `${slope / k}*sin(${k}*x)`, x: [-1, 1], y: [-1, 1] });
  let [milliseconds, converged, most] = [0, 0, 0];
  for (let i = 0; i < pairs; i++) {
    const [from, to] = acrossWaves(random);
    const start = performance.now();
    const path = sheet.shortestPath(from, to);
    milliseconds += performance.now() - start;
    if (!path.converged) continue;
    most = Math.max(most, Math.abs(path.length / unroll(corrugated(k, slope), [from, to], 100_000) - 1));
    converged++;
  }
  sheet.dispose();
  const columns = [k, slope, pairs, converged, most.toExponential(1), (milliseconds / pairs).toFixed(0)];
  console.log(columns.map((text, i) => String(text).padStart([4, 7, 7, 11, 8, 9][i])).join(''));
  if (most > RIGHT || (converged < pairs && SOLVED.some(([waves, steepness]) => waves === k && steepness === slope))) process.exitCode = 1;
}
surfpath.dispose();
