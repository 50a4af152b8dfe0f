// Random pairs on both sides of boxes whose edges are rounded by less than a cell of the graph, against the way over one edge (tests/accuracy/measure/rounded.js). Prints a table.
// `node tests/accuracy/rounded.js [pairs on a body [seed]]`.
import { load } from '../../web/index.js';
import { createRandom } from '../helpers/random.js';
import { FORMS, pickOver } from './measure/rounded.js';

const [pairs, seed] = [Number(process.argv[2] ?? 100), Number(process.argv[3] ?? 7)];
/** Longer than the way over one edge is what the tolerance does not explain. */
const RIGHT = 1e-9;
/** No search promises the shortest way, but it is rarely missed. */
const MOST_LONGER = 0.1;

/** Half sides, rounding, bounds (0: none). @type {[import('./measure/rounded.js').Half, number, number][]} */
const BODIES = [
  [[0.82, 0.52, 0.12], 0.02, 1],
  [[0.82, 0.52, 0.12], 0.02, 0],
  [[0.81, 0.51, 0.11], 0.01, 1],
  [[0.805, 0.505, 0.105], 0.005, 1],
  [[0.51, 0.51, 0.51], 0.01, 0.6],
  [[0.505, 0.505, 0.505], 0.005, 0.6],
];

const surfpath = await load();
console.log(`seed ${seed}\nhalf sides            r      bounds  pairs  not longer  longer  most, %  refused  median ms  max ms`);
for (const [half, r, bound] of BODIES) {
  const side = /** @type {const} */ ([-bound, bound]);
  const body = surfpath.implicit({ f: FORMS.clamped(half, r), ...(bound ? { bounds: [side, side, side] } : {}) });
  const random = createRandom(seed);
  const answers = Array.from({ length: pairs }, () => {
    const { from, to, over } = pickOver(half, r, random);
    const start = performance.now();
    const { converged, length } = body.shortestPath(from, to);
    return { converged, off: length / over - 1, milliseconds: performance.now() - start };
  });
  body.dispose();
  const longer = answers.filter(({ converged, off }) => converged && off > RIGHT);
  const refused = answers.filter(({ converged }) => !converged);
  const most = longer.reduce((largest, { off }) => Math.max(largest, off), 0);
  const times = answers.map(({ milliseconds }) => milliseconds).sort((a, b) => a - b);
  const columns = [
    ...[r, bound || 'none', pairs, pairs - longer.length - refused.length, longer.length, (100 * most).toFixed(1), refused.length],
    ...[times[pairs >> 1].toFixed(0), times[pairs - 1].toFixed(0)],
  ];
  console.log(half.join(' × ').padEnd(22) + columns.map((text, i) => String(text).padStart([5, 8, 7, 12, 8, 9, 9, 11, 8][i])).join(''));
  if (longer.length + refused.length > MOST_LONGER * pairs) process.exitCode = 1;
}
surfpath.dispose();
