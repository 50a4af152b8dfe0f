// How often a tolerance is kept: random pairs on the surfaces of the gallery at tolerances 1e-4 … 1e-10, each answer checked by a finer solve and by
// tracing. Prints a table, and each failure with as few digits as show it.
// `node tests/accuracy/random.js [pairs a surface [seconds a surface [surface [seed]]]]`; all 10,000 pairs: 455 a surface.
import { gallery } from '../../web/gallery.js';
import { load } from '../../web/index.js';
import { pointSource } from '../bench/pairs.js';
import { createRandom } from '../helpers/random.js';
import { askAbout, shorten } from './measure/random-pairs.js';

const [pairs = '40', seconds = '60', only = '', given = '7'] = process.argv.slice(2);
const seed = Number(given);
const MUST = 0.999;
const VERDICTS = ['right', 'wrong', 'astray', 'unchecked', 'refused', 'slow', 'unclassified'];

/** @type {Record<string, number>} */
const total = Object.fromEntries(VERDICTS.map((verdict) => [verdict, 0]));
/** Answers whose error is no larger than lengthError. */
let estimated = 0;
const surfpath = await load();
console.log(`seed ${seed}`);
console.log(['surface'.padEnd(16), 'pairs', ...VERDICTS, 'traced', 'owned', 'median ms', 'max ms'].join('  '));
for (const [name, definition] of Object.entries(gallery).filter(([name]) => name.includes(only))) {
  const surface = surfpath.surface(/** @type {any} */ (definition));
  const random = createRandom(seed);
  surface.shortestPath(definition.from, definition.to);
  const answers = askAbout(surface, random, pointSource(surface, random), Number(pairs), Number(seconds));
  const counts = VERDICTS.map((verdict) => answers.filter((answer) => answer.verdict === verdict).length);
  for (const [i, verdict] of VERDICTS.entries()) total[verdict] += counts[i];
  const times = answers.map(({ milliseconds }) => milliseconds).sort((a, b) => a - b);
  const owned = answers.filter((answer) => answer.owned).length;
  estimated += owned;
  const numbers = [answers.length, ...counts, answers.filter(({ traced }) => traced).length, owned].map(String);
  const widths = [5, ...VERDICTS.map(({ length }) => length), 6, 5];
  const columns = numbers.map((number, i) => number.padStart(widths[i]));
  console.log(
    [name.padEnd(16), ...columns, times[times.length >> 1].toFixed(2).padStart(9), (times.at(-1) ?? 0).toFixed(0).padStart(6)].join('  '),
  );
  for (const failure of answers.filter(({ verdict }) => verdict !== 'right'))
    console.log(`  ${JSON.stringify(failure.verdict === 'slow' ? failure : shorten(surface, failure))}`);
  surface.dispose();
}
const checked = total.right + total.wrong + total.astray;
const share = total.right / checked;
const bounded = estimated / checked;
console.log(
  `${VERDICTS.map((verdict) => `${verdict} ${total[verdict]}`).join(', ')}; the tolerance is kept by ${(100 * share).toFixed(3)} %, and lengthError by ${(100 * bounded).toFixed(3)} %`,
);
if (!(share >= MUST && bounded >= MUST) || total.slow + total.unclassified > 0) process.exitCode = 1;
surfpath.dispose();
