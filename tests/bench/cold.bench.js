/** The first path of a fresh Node process, step by step, and text to compiled surface, cold and warm. */
import { execFileSync } from 'node:child_process';
import { fileURLToPath } from 'node:url';
import { quick, report, spread } from './bench.js';

/** @typedef {{ first: Record<string, number>, total: number, cold: Record<string, number>, warm: Record<string, number>, length: number }} Sample */

const script = fileURLToPath(new URL('cold-process.js', import.meta.url));
const PROCESSES = quick ? 1 : 11;

/** @type {Sample[]} */
const samples = Array.from({ length: PROCESSES }, () => JSON.parse(execFileSync(process.execPath, [script], { encoding: 'utf8' })));

/** @param {string} step @param {(sample: Sample) => number} read */
function row(step, read) {
  const { median, minimum } = spread(samples.map(read));
  return { step, 'ms median': median, 'ms minimum': minimum };
}

const [{ first, cold, length }] = samples;
report(
  'cold',
  `Milliseconds in a fresh Node process, ${PROCESSES} processes`,
  [
    ...Object.keys(first).map((step) => row(step, (sample) => sample.first[step])),
    row('first path after import', ({ total }) => total),
    ...Object.keys(cold).map((name) => row(`${name}: text to surface, cold`, (sample) => sample.cold[name])),
    ...Object.keys(cold).map((name) => row(`${name}: text to surface, warm`, (sample) => sample.warm[name])),
  ],
  ['wanted: the first path at most 50 ms after import', `the path: saddle, default options, length ${length}`],
);
