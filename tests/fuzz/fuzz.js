// Runs one fuzzer and prints what it did: `node tests/fuzz/fuzz.js NAME SECONDS [SEED [COUNT]]`. Adds to the kept corpus where KEEP is set. Fails by the error that
// shows the input.
import { createRandom } from '../helpers/random.js';
import { fuzzDefinitions } from './definitions.js';
import { fuzzExpressions } from './expressions.js';
import { fuzzProblems } from './problems.js';

const [name, seconds = '10', given = String(Date.now() % 2 ** 31), most = 'Infinity'] = process.argv.slice(2);
const random = createRandom(Number(given));
const milliseconds = 1000 * Number(seconds);

/** @type {Record<string, () => Promise<{ count: number, notes: string }> | { count: number, notes: string }>} */
const FUZZERS = {
  expressions: () => fuzzExpressions(random, milliseconds, process.env.KEEP !== undefined),
  definitions: () => fuzzDefinitions(random, milliseconds),
  straight: () => fuzzProblems(random, milliseconds, 'straight', Number(most)),
  global: () => fuzzProblems(random, milliseconds, 'global', Number(most)),
};

console.log(`${name}, seed ${random.seed}`);
const { count, notes } = await FUZZERS[name]();
console.log(`${name}: ${count} inputs; ${notes}`);
