/**
 * What all benchmarks share: samples of rivals taken in turn, their minimum and median, a table, and a JSON file: in build/bench/, or where
 * `--json file` says.
 *
 * With `--quick` a benchmark takes few samples and writes to build/bench/quick/: enough to see that it runs, not to believe its times.
 */
import { mkdirSync, writeFileSync } from 'node:fs';
import { arch, cpus } from 'node:os';

export const quick = process.argv.includes('--quick');

/** What every benchmark draws its random numbers from. */
export const SEED = 7;

/** @typedef {{ minimum: number, median: number }} Spread of the samples of a rival */
/** @typedef {Record<string, number | string | boolean>} Row of a table: heading and figure */

/**
 * Lets rivals run in turn, so that whatever else the machine does meets all of them alike.
 * @template {string} Name
 * @param {Record<Name, () => number>} rivals each takes one sample and returns it
 * @param {number} rounds how many samples of each; the first of all is for warming up and not counted
 * @returns {Record<Name, Spread>}
 */
export function compete(rivals, rounds) {
  const names = /** @type {Name[]} */ (Object.keys(rivals));
  const samples = /** @type {Record<string, number[]>} */ (Object.fromEntries(names.map((name) => [name, []])));
  for (let round = 0; round <= rounds; round++) {
    for (const name of names) {
      const sample = rivals[name]();
      if (round > 0) samples[name].push(sample);
    }
  }
  return /** @type {Record<Name, Spread>} */ (Object.fromEntries(names.map((name) => [name, spread(samples[name])])));
}

/**
 * Milliseconds that a task takes, so many times; as often before, unmeasured: where a rival is a process it began by fork, and from then on each page of this one's memory costs a fault
 * when it is first written, which is half of a short solve on some machines.
 * @param {() => unknown} run @param {number} times
 */
export function repeat(run, times) {
  for (let i = 0; i < times; i++) run();
  const start = performance.now();
  for (let i = 0; i < times; i++) run();
  return performance.now() - start;
}

/**
 * Nanoseconds of all tasks of each rival: the sum of the least that each took. For tasks of less than a millisecond, which other work of the machine now and then misses.
 * @template {string} Name
 * @param {Record<Name, (() => unknown)[]>} rivals take turns, task by task
 * @param {number} rounds
 * @returns {Record<Name, number>}
 */
export function sumLeast(rivals, rounds) {
  const names = /** @type {Name[]} */ (Object.keys(rivals));
  const least = names.map((name) => rivals[name].map(() => Infinity));
  for (let round = 0; round < rounds; round++) {
    for (let task = 0; task < least[0].length; task++) {
      for (const [i, name] of names.entries()) {
        const start = performance.now();
        rivals[name][task]();
        least[i][task] = Math.min(least[i][task], 1e6 * (performance.now() - start));
      }
    }
  }
  const sums = names.map((name, i) => [name, least[i].reduce((sum, time) => sum + time)]);
  return /** @type {Record<Name, number>} */ (Object.fromEntries(sums));
}

/** @param {number[]} samples @returns {Spread} */
export function spread(samples) {
  const sorted = [...samples].sort((a, b) => a - b);
  const middle = sorted.length >> 1;
  return { minimum: sorted[0], median: sorted.length % 2 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2 };
}

/**
 * Runs something for a while, until the engine has optimised it.
 * @param {() => unknown} run
 * @param {number} milliseconds
 */
export function warmUp(run, milliseconds = quick ? 20 : 400) {
  const end = performance.now() + milliseconds;
  do run();
  while (performance.now() < end);
}

/**
 * Prints a table and keeps its figures.
 * @param {string} name of the benchmark
 * @param {string} title
 * @param {Row[]} rows
 * @param {string[]} [notes] printed below
 */
export function report(name, title, rows, notes = []) {
  const headings = Object.keys(rows[0]);
  const lines = [headings, ...rows.map((row) => headings.map((heading) => show(row[heading])))];
  const widths = headings.map((_, j) => Math.max(...lines.map((line) => line[j].length)));
  const numeric = headings.map((heading) => typeof rows[0][heading] === 'number');
  const pad = (/** @type {string} */ text, /** @type {number} */ j) => (numeric[j] ? text.padStart(widths[j]) : text.padEnd(widths[j]));
  console.log(
    [title, ...lines.map((line) => `  ${line.map(pad).join('  ').trimEnd()}`), ...notes.map((note) => `  ${note}`), ''].join('\n'),
  );
  const folder = new URL(quick ? '../../build/bench/quick/' : '../../build/bench/', import.meta.url);
  mkdirSync(folder, { recursive: true });
  const wanted = process.argv.indexOf('--json');
  const file = wanted > 0 ? process.argv[wanted + 1] : new URL(`${name}.json`, folder);
  const machine = { node: process.version, arch: arch(), processor: cpus()[0]?.model ?? '' };
  writeFileSync(file, `${JSON.stringify({ name, title, seed: SEED, machine, rows, notes }, null, 1)}\n`);
}

/** Four digits, without an exponent where that is short. @param {number | string | boolean} figure */
function show(figure) {
  if (typeof figure !== 'number') return String(figure);
  return Number.isInteger(figure) || figure === 0 ? String(figure) : String(Number(figure.toPrecision(3)));
}
