/** Fuzzes the expression compiler with text: formulas from the grammar, kept texts changed, raw characters. */
import { readFileSync, writeFileSync } from 'node:fs';
import { compile } from '../../web/expression/compile.js';
import { ExpressionError } from '../../web/expression/error.js';
import { randomExpression } from '../helpers/random-expression.js';
import { instantiate } from '../helpers/wasm.js';

/** @typedef {import('../helpers/random.js').Random} Random */

const KEPT = new URL('corpus/expressions.json', import.meta.url);
const NAMES = ['u', 'v', 'R', 'pi', 'e'];
const PIECES = [
  ...'uvxyzRe0123456789.()|,+-*/^²³√π·×−=<>[]{}%°!;:#"\'\\\u0000\u200b\u00a0\t\n😀ａ',
  ...[
    'sin',
    'max',
    'atan2',
    '**',
    '__proto__',
    'constructor',
    'toString',
    '1e400',
    '1e-400',
    '0x10',
    'NaN',
    'Infinity',
    'pi',
    '\ud800',
    'ｓｉｎ',
    'ѕin',
    ' u',
  ],
];
/** Milliseconds of the processor, more than any text that is read may take: a hang. */
const HANG = 2000;
const POINTS = [
  [0, 0],
  [0.3, -0.7],
  [1e9, -1e-9],
  [Number.NaN, Infinity],
];

/** What changes a text. @type {((text: string, random: Random, other: string) => string)[]} */
const CHANGES = [
  (text, random) => insert(text, random, random.pick(PIECES)),
  (text, random) => insert(text, random, String.fromCodePoint(random.integer(0xd800))),
  (text, random) => text.slice(0, random.integer(text.length + 1)),
  (text, random) => text.slice(random.integer(text.length + 1)),
  (text, random, other) => insert(text, random, other),
  (text, random) => insert(text, random, '('.repeat(random.integer(80))),
  (text, random) => text.repeat(1 + random.integer(40)),
];

/** @param {string} text @param {Random} random @param {string} piece */
function insert(text, random, piece) {
  const at = random.integer(text.length + 1);
  return text.slice(0, at) + piece + text.slice(at + random.integer(2));
}

/** @param {Random} random @param {string[]} kept */
function drawText(random, kept) {
  const choice = random.integer(3);
  if (choice === 0) return randomExpression(random, 3, NAMES);
  if (choice === 1) return Array.from({ length: random.integer(60) }, () => random.pick(PIECES)).join('');
  let text = kept.length > 0 ? random.pick(kept) : 'u';
  for (let i = 0; i <= random.integer(4); i++) text = random.pick(CHANGES)(text, random, random.pick(kept));
  return text;
}

/** What became of a text, in words that are the same for texts of its sort. @param {unknown} error */
const sortOf = (error) =>
  error instanceof ExpressionError ? error.message.replaceAll(/"[^"]*"|[\d.]+|unknown (name|function) .*/g, '…').slice(0, 80) : 'read';

/**
 * Compiles one text, and runs what comes of it.
 * @param {string} source @param {ReturnType<typeof instantiate>} solver
 * @returns {string} its sort
 */
function tryText(source, solver) {
  const start = process.cpuUsage();
  let sort = 'read';
  try {
    const compiled = compile({ outputs: [source], names: ['f'], variables: ['u', 'v'], parameters: { R: 2 }, apply: solver.apply });
    const { jet } = solver.link(compiled, 2);
    if (jet(POINTS).some((numbers) => numbers.length !== 6)) throw new Error('not six numbers');
  } catch (error) {
    if (!(error instanceof ExpressionError)) throw new Error(`${JSON.stringify(source)}: ${/** @type {Error} */ (error).stack}`);
    if (!(Number.isInteger(error.index) && error.index >= 0 && error.index <= source.length && error.source === source))
      throw new Error(`${JSON.stringify(source)}: points at ${error.index}`);
    sort = sortOf(error);
  }
  const { user, system } = process.cpuUsage(start);
  if (user + system > 1000 * HANG) throw new Error(`${JSON.stringify(source)}: took ${(user + system) / 1000} ms`);
  return sort;
}

/**
 * @param {Random} random @param {number} milliseconds @param {boolean} keep adds texts of new sorts to the corpus
 * @returns {{ count: number, notes: string }}
 */
export function fuzzExpressions(random, milliseconds, keep) {
  /** @type {Record<string, string>} */ const corpus = JSON.parse(readFileSync(KEPT, 'utf8'));
  let solver = instantiate();
  for (const text of Object.values(corpus)) tryText(text, solver);
  let count = Object.keys(corpus).length;
  for (const end = performance.now() + milliseconds; performance.now() < end; count++) {
    // Tests never give memory back.
    if (count % 2000 === 0) solver = instantiate();
    const text = drawText(random, Object.values(corpus));
    const sort = tryText(text, solver);
    if (!(sort in corpus) || text.length < corpus[sort].length) corpus[sort] = text;
  }
  if (keep) writeFileSync(KEPT, `${JSON.stringify(corpus, Object.keys(corpus).sort(), 2)}\n`);
  return { count, notes: `${Object.keys(corpus).length} sorts of answers` };
}
