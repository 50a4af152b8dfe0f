/**
 * Sums the counters that preload.js wrote and prints them as a profile in the text format of llvm-profdata.
 *
 * Usage: node tests/coverage/merge.js build/coverage/counters > wasm.proftext
 */
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';

const folder = process.argv[2];
/** @type {Map<string, number[]>} */
const sums = new Map();
for (const name of readdirSync(folder)) {
  for (const [key, counts] of JSON.parse(readFileSync(join(folder, name), 'utf8'))) {
    const sum = sums.get(key);
    sums.set(
      key,
      counts.map((/** @type {number} */ count, /** @type {number} */ i) => count + (sum?.[i] ?? 0)),
    );
  }
}
for (const [key, counts] of sums) {
  const space = key.indexOf(' ');
  console.log(`${key.slice(space + 1)}\n${key.slice(0, space)}\n${counts.length}\n${counts.join('\n')}\n`);
}
