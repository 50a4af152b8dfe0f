/**
 * Branch coverage of wasm/ from what `llvm-cov export` says of it: each outcome of each condition counts once, however often a header is included.
 *
 * Usage: llvm-cov export … | node tests/coverage/c.js 95; exits with 1 below that many percent.
 */
import { readFileSync } from 'node:fs';
import { relative } from 'node:path';
import { fileURLToPath } from 'node:url';

const wanted = Number(process.argv[2]);
const root = fileURLToPath(new URL('../..', import.meta.url));

/** One entry of `branches`: line, column, end line, end column, times true, times false, file, expanded file, kind. @typedef {number[]} Branch */

const { functions } = JSON.parse(readFileSync(0, 'utf8')).data[0];
/** By file and place, how often either way. @type {Map<string, Map<string, [number, number]>>} */
const files = new Map();
for (const { branches, filenames } of functions) {
  for (const [line, column, , , taken, passed, at] of /** @type {Branch[]} */ (branches)) {
    const name = relative(root, filenames[at]);
    const places = files.get(name) ?? new Map();
    const [before, after] = places.get(`${line}:${column}`) ?? [0, 0];
    places.set(`${line}:${column}`, [before + taken, after + passed]);
    files.set(name, places);
  }
}

let [all, allMissed] = [0, 0];
for (const [name, places] of [...files].sort()) {
  const missed = [...places].flatMap(([place, [taken, passed]]) => [
    ...(taken ? [] : [`${place} is never true`]),
    ...(passed ? [] : [`${place} is never false`]),
  ]);
  all += 2 * places.size;
  allMissed += missed.length;
  console.log(`${name.padEnd(34)}${percent(2 * places.size - missed.length, 2 * places.size)}  ${missed.join(', ')}`);
}
console.log(`${'branches of C'.padEnd(34)}${percent(all - allMissed, all)}  (wanted: ${wanted})`);
process.exitCode = (100 * (all - allMissed)) / all >= wanted ? 0 : 1;

/** @param {number} part @param {number} whole */
function percent(part, whole) {
  return ((100 * part) / whole).toFixed(2).padStart(6);
}
