// Random pairs on surfaces with creases, judged by what is known of each (tests/accuracy/measure/creases.js), and on a plane whose density jumps, by brute force (measure/plane.js). Prints a table, and each pair that is called converged
// but is not right: longer, one of several ways that is not the shortest, or wrong. `node tests/accuracy/creases.js [pairs on a graph [pairs on a body [random surfaces [surface [seed]]]]]`; with VERBOSE, those that are refused, too.
import { load } from '../../web/index.js';
import { createRandom } from '../helpers/random.js';
import { askAcross, randomCreases, SURFACES } from './measure/creases.js';
import { askOnPlane, JUMPS } from './measure/plane.js';

const [onGraph = '40', onBody = '20', surfaces = '24', only = '', given = '1'] = process.argv.slice(2);
const seed = Number(given);
const PAIRS_OF_RANDOM = 4;
/** No search promises the shortest way, but it is rarely missed. */
const MOST_LONGER = 0.05;
const RANDOM = 'two creases, a wave';

/** @typedef {import('./measure/creases.js').Answer} Answer */
/** @typedef {import('./measure/creases.js').Creased} Creased */

const surfpath = await load();

/** @param {Creased} creased @param {import('../helpers/random.js').Random} random @param {number} pairs */
function ask(creased, random, pairs) {
  const surface = surfpath.surface(creased.definition);
  surface.shortestPath(...(creased.height ? warm([-1.5, -1.3], [1.4, 1.1]) : warm([1, 0.1, 0.2], [-0.1, 1, 0.3])));
  const answers = askAcross(creased, surface, random, pairs);
  surface.dispose();
  return answers;
}

/** Ends of a path that is not timed: it builds what is kept. @param {number[]} from @param {number[]} to @returns {[number[], number[]]} */
const warm = (from, to) => [from, to];

/** @param {string} name @param {Answer[]} answers */
function print(name, answers) {
  const of = (/** @type {string} */ verdict) => answers.filter((answer) => answer.verdict === verdict);
  const times = answers.map(({ milliseconds }) => milliseconds).sort((a, b) => a - b);
  const worst = Math.max(0, ...of('right').map(({ error }) => error));
  const counts = [answers.length, of('right').length, of('longer').length, of('refused').length, of('wrong').length].map((count, i) =>
    String(count).padStart([5, 7, 8, 9, 7][i]),
  );
  const columns = [
    worst.toExponential(0).padStart(8),
    times[times.length >> 1].toFixed(1).padStart(11),
    times[times.length - 1].toFixed(0).padStart(8),
  ];
  console.log([name.padEnd(20), ...counts, ...columns].join(''));
  for (const answer of [...of('longer'), ...of('wrong'), ...(process.env.VERBOSE ? of('refused') : [])])
    console.log(`  ${JSON.stringify(answer)}`);
  if (of('wrong').length > 0 || of('longer').length > MOST_LONGER * answers.length) process.exitCode = 1;
}

console.log(`seed ${seed}`);
console.log('surface             pairs  right  longer  refused  wrong  error  median ms  max ms');
for (const [name, make] of Object.entries(SURFACES).filter(([name]) => name.includes(only))) {
  const creased = make();
  print(name, ask(creased, createRandom(seed), Number(creased.height ? onGraph : onBody)));
}
for (const [name, [density, measure]] of Object.entries(JUMPS).filter(([name]) => name.includes(only))) {
  const surface = surfpath.graph({ z: '0', x: [-2, 2], y: [-2, 2], density });
  surface.shortestPath(...warm([-1.5, -1.3], [1.4, 1.1]));
  print(name, askOnPlane(surface, measure, createRandom(seed), Number(onGraph)));
  surface.dispose();
}
if (RANDOM.includes(only)) {
  const random = createRandom(seed);
  print(RANDOM, Array.from({ length: Number(surfaces) }, () => ask(randomCreases(random), random, PAIRS_OF_RANDOM)).flat());
}
surfpath.dispose();
