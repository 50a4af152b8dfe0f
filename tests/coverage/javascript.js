/**
 * Line coverage of web/ from V8's own counts, as NODE_V8_COVERAGE leaves them: a line counts as run if every character of code on it was, in
 * some process. Comments, blank lines and lines of brackets alone are not counted.
 *
 * Usage: node tests/coverage/javascript.js build/coverage/v8 95; exits with 1 below that many percent.
 */
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const [folder, wanted] = process.argv.slice(2);
const root = fileURLToPath(new URL('../..', import.meta.url));

/** @typedef {{ startOffset: number, endOffset: number, count: number }} Range */
/** @typedef {{ url: string, functions: { ranges: Range[] }[] }} Script */

/** By file, 1 where a character was run by some process. @type {Map<string, Uint8Array>} */
const runBy = new Map();
const sources = readdirSync(join(root, 'web'), { recursive: true, encoding: 'utf8' })
  .filter((name) => name.endsWith('.js'))
  .map((name) => join(root, 'web', name))
  .sort();

for (const report of readdirSync(folder)) {
  const scripts = /** @type {Script[]} */ (JSON.parse(readFileSync(join(folder, report), 'utf8')).result);
  for (const { url, functions } of scripts) {
    if (!url.startsWith('file:')) continue;
    const file = fileURLToPath(url);
    if (sources.includes(file)) add(file, functions);
  }
}

/** Ranges nest: an inner one, which follows, overrides the outer. @param {string} file @param {Script['functions']} functions */
function add(file, functions) {
  const size = readFileSync(file, 'utf8').length;
  const counts = new Uint8Array(size);
  for (const { startOffset, endOffset, count } of functions.flatMap(({ ranges }) => ranges))
    counts.fill(count > 0 ? 1 : 0, startOffset, endOffset);
  const sum = runBy.get(file) ?? new Uint8Array(size);
  runBy.set(
    file,
    sum.map((run, i) => run | counts[i]),
  );
}

/** Blanks comments, keeping every character's place. @param {string} text */
const withoutComments = (text) => text.replace(/\/\*[\s\S]*?\*\/|(?<=^|\s)\/\/.*/g, (comment) => comment.replace(/[^\n]/g, ' '));

/** The lines of code of a file and those that were not run, from 1. @param {string} file */
function countLines(file) {
  const run = runBy.get(file);
  /** @type {number[]} */
  const missed = [];
  let [at, lines] = [0, 0];
  for (const [number, line] of withoutComments(readFileSync(file, 'utf8')).split('\n').entries()) {
    const code = [...line].flatMap((character, i) => (/\w/.test(character) ? [at + i] : []));
    at += line.length + 1;
    if (code.length === 0) continue;
    lines++;
    if (!code.every((place) => run?.[place])) missed.push(number + 1);
  }
  return { lines, missed };
}

let [all, allMissed] = [0, 0];
for (const file of sources) {
  const { lines, missed } = countLines(file);
  all += lines;
  allMissed += missed.length;
  const name = file.slice(root.length).padEnd(34);
  if (lines > 0) console.log(`${name}${percent(lines - missed.length, lines)}  ${missed.length > 0 ? `not run: ${missed.join(' ')}` : ''}`);
}
console.log(`${'lines of JavaScript'.padEnd(34)}${percent(all - allMissed, all)}  (wanted: ${wanted})`);
process.exitCode = (100 * (all - allMissed)) / all >= Number(wanted) ? 0 : 1;

/** @param {number} part @param {number} whole */
function percent(part, whole) {
  return ((100 * part) / whole).toFixed(2).padStart(6);
}
