// Random pairs on bodies of boxes, whose shortest paths turn at corners, judged by unfolding (tests/accuracy/measure/boxes.js). Prints a table, and each pair that is called converged but is not right; with
// VERBOSE, those that are refused, too. `node tests/accuracy/boxes.js [pairs on a body [random bodies [body [seed]]]]`.
import { load } from '../../web/index.js';
import { createRandom } from '../helpers/random.js';
import { askOnBoxes, BODIES, randomBoxes } from './measure/boxes.js';

const [onBody = '40', bodies = '60', only = '', given = '1'] = process.argv.slice(2);
const seed = Number(given);
const PAIRS_OF_RANDOM = 4;
const RANDOM = 'random boxes';
const AROUND = 'round a corner';
/** Right is what is as long as the shortest to the default tolerance. */
const RIGHT = 1e-9;
/** No search promises the shortest way, but it is rarely missed. */
const MOST_LONGER = 0.02;

/** @typedef {import('./measure/boxes.js').Answer} Answer */

const surfpath = await load();
/** @param {Answer} answer */
const offOf = ({ path, exact }) => path.length / exact - 1;

/** @param {string} name @param {Answer[]} answers */
function print(name, answers) {
  const converged = answers.filter(({ path }) => path.converged);
  const longer = converged.filter((answer) => offOf(answer) > RIGHT);
  const wrong = converged.filter((answer) => offOf(answer) < -RIGHT);
  const refused = answers.filter(({ path }) => !path.converged);
  const times = answers.map(({ milliseconds }) => milliseconds).sort((a, b) => a - b);
  const counts = [answers.length, converged.length - longer.length - wrong.length, longer.length, refused.length, wrong.length];
  const columns = [...counts.map(String), times[times.length >> 1].toFixed(0), times[times.length - 1].toFixed(0)];
  console.log(name.padEnd(14) + columns.map((text, i) => text.padStart([5, 7, 8, 9, 7, 11, 8][i])).join(''));
  for (const answer of [...longer, ...wrong, ...(process.env.VERBOSE ? refused : [])]) {
    const { from, to, path } = answer;
    console.log(
      `  ${path.status}, ${(100 * offOf(answer)).toFixed(4)} % longer, error ${path.lengthError.toExponential(1)}: ${JSON.stringify([from, to])}`,
    );
  }
  if (wrong.length > 0 || longer.length > MOST_LONGER * answers.length) process.exitCode = 1;
}

console.log(`seed ${seed}`);
console.log('body          pairs  right  longer  refused  wrong  median ms  max ms');
for (const [name, boxes] of Object.entries(BODIES).filter(([name]) => name.includes(only)))
  print(name, askOnBoxes(surfpath, boxes, createRandom(seed), Number(onBody)));
if (AROUND.includes(only)) {
  const random = createRandom(seed);
  print(
    AROUND,
    Object.values(BODIES).flatMap((boxes) => askOnBoxes(surfpath, boxes, random, Number(onBody), true)),
  );
}
if (RANDOM.includes(only)) {
  const random = createRandom(seed);
  print(RANDOM, Array.from({ length: Number(bodies) }, () => askOnBoxes(surfpath, randomBoxes(random), random, PAIRS_OF_RANDOM)).flat());
}
surfpath.dispose();
