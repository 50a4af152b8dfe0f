// Shortest paths on three ellipsoids against GeographicLib: 10,000 random pairs, nearly antipodal ones among them. Prints a table, and each pair that is
// called converged but is not right to 1e-9. `node tests/accuracy/geographiclib.js [pairs [seed]]`
import { load } from '../../web/index.js';
import { createRandom } from '../helpers/random.js';
import { definitionOf, ELLIPSOIDS, solvePairs } from './measure/geographiclib.js';

const [pairs = '10000', given = '11'] = process.argv.slice(2);
const seed = Number(given);
const names = Object.keys(ELLIPSOIDS);
const surfpath = await load();
console.log(`seed ${seed}`);
console.log('ellipsoid  sort        pairs  right  refused  wrong');
for (const name of names) {
  const surface = surfpath.surface(definitionOf(name));
  const answers = solvePairs(name, surface, createRandom(seed), Math.ceil(Number(pairs) / names.length));
  surface.dispose();
  for (const sort of new Set(answers.map((answer) => answer.sort))) {
    const of = answers.filter((answer) => answer.sort === sort);
    const count = (/** @type {string} */ verdict) => of.filter((answer) => answer.verdict === verdict).length;
    const columns = [of.length, count('right'), count('refused'), count('wrong')].map((number, i) =>
      String(number).padStart([6, 7, 9, 7][i]),
    );
    console.log([name.padEnd(10), sort.padEnd(10), ...columns].join(''));
  }
  for (const answer of answers.filter(({ verdict }) => verdict === 'refused').slice(0, 5))
    console.log(`  ${answer.status}: ${JSON.stringify(answer)}`);
  for (const wrong of answers.filter(({ verdict }) => verdict === 'wrong')) {
    console.log(`  ${JSON.stringify(wrong)}`);
    process.exitCode = 1;
  }
}
surfpath.dispose();
