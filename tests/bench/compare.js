/**
 * Compares two results of a benchmark: node tests/bench/compare.js before.json after.json
 *
 * Prints every figure of both that differs, with its ratio; a row is known by its texts and by its whole numbers that both share.
 */
import { readFileSync } from 'node:fs';

/** @typedef {import('./bench.js').Row} Row */

const files = process.argv.slice(2);
if (files.length !== 2) {
  console.error('usage: node tests/bench/compare.js before.json after.json');
  process.exit(2);
}
const [before, after] = files.map((file) => JSON.parse(readFileSync(file, 'utf8')));
if (before.name !== after.name) {
  console.error(`${files[0]} is of ${before.name}, ${files[1]} of ${after.name}`);
  process.exit(2);
}

console.log(`${after.title}\nbefore: ${before.machine.processor}, after: ${after.machine.processor}`);
before.rows.forEach((/** @type {Row} */ old, /** @type {number} */ i) => {
  /** @type {Row} */ const row = after.rows[i] ?? {};
  const label = Object.values(old)
    .filter((figure) => typeof figure === 'string')
    .join(' ');
  for (const [heading, figure] of Object.entries(old)) {
    const now = row[heading];
    if (figure === now) continue;
    const ratio = typeof figure === 'number' && typeof now === 'number' ? `× ${(now / figure).toFixed(3)}` : '';
    console.log(`  ${label.padEnd(34)} ${heading.padEnd(22)} ${figure} → ${now} ${ratio}`.trimEnd());
  }
});
