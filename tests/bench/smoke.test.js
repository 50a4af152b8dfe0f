// Every benchmark runs, on a tiny sample, and its figures make sense. Times are not judged.
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { readdirSync, readFileSync } from 'node:fs';
import { before, describe, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';

/** @typedef {import('./bench.js').Row} Row */

const run = promisify(execFile);
const path = (/** @type {string} */ relative) => fileURLToPath(new URL(relative, import.meta.url));
const result = (/** @type {string} */ name) => path(`../../build/bench/quick/${name}.json`);
const names = readdirSync(path('.')).flatMap((file) => (file.endsWith('.bench.js') ? [file.slice(0, -'.bench.js'.length)] : []));

/** @param {string} name @returns {Row[]} */
const rowsOf = (name) => JSON.parse(readFileSync(result(name), 'utf8')).rows;

test('there are benchmarks', () => {
  assert.deepEqual(names.sort(), [
    'batch',
    'cold',
    'creases',
    'field',
    'fig2',
    'fig3',
    'iteration',
    'metrics',
    'solves',
    'speed',
    'starts',
    'surface',
    'table1',
    'tolerance',
  ]);
});

describe('benchmarks, quickly', { concurrency: 2 }, () => {
  for (const name of names) {
    test(`${name} prints its table`, async () => {
      const { stdout, stderr } = await run(process.execPath, [path(`${name}.bench.js`), '--quick']);
      assert.equal(stderr, '');
      const rows = rowsOf(name);
      assert.ok(rows.length > 0);
      for (const row of rows) {
        assert.deepEqual(Object.keys(row), Object.keys(rows[0]));
        for (const [heading, figure] of Object.entries(row)) {
          assert.ok(stdout.includes(heading), heading);
          if (typeof figure === 'number') assert.ok(Number.isFinite(figure) && figure >= 0, `${heading} ${figure}`);
        }
      }
    });
  }
});

describe('their figures', () => {
  /** @type {Row[]} */ let solves;

  before(() => {
    solves = rowsOf('speed');
  });

  test('the native build computes the same bits as the WebAssembly', () => {
    assert.equal(solves.length, 8);
    for (const row of [...solves, ...rowsOf('surface'), ...rowsOf('solves')]) assert.equal(row['same bits'], true, String(row.surface));
  });

  test('the pools compute the same bits as the main thread', () => {
    for (const row of rowsOf('batch')) assert.equal(row['same bits'], true, String(row.surface));
  });

  test('a path by elements is as exact as was asked', () => {
    for (const row of rowsOf('solves'))
      assert.ok(Number(row['largest true error']) <= Math.max(Number(row.tolerance), 1e-12), `${row.surface}, ${row.tolerance}`);
  });

  test('a path near an earlier one converges, of however many points that is; so do those under metrics, and across creases', () => {
    for (const name of ['starts', 'metrics', 'creases'])
      for (const row of rowsOf(name)) assert.equal(row.converged, true, String(row.surface));
  });

  /* Chords are too short by an error of second order: four times the points, a sixteenth of it. */
  test('the error of a polyline falls as the square of its points', () => {
    const errors = rowsOf('fig2').filter(({ surface }) => surface === 'dini');
    const [few, many] = [errors[1], errors[3]].map((row) => Number(row['mean error %']));
    assert.ok(few / many > 14 && few / many < 18, `${few} % at 64 points, ${many} % at 256`);
  });

  test('a profile tells the stages of an iteration apart', () => {
    const rows = rowsOf('iteration');
    for (const stage of ['evaluation', 'assembly', 'block solve', 'the rest'])
      assert.ok(
        rows.some((row) => Number(row[stage]) > 0),
        stage,
      );
  });

  test('a result goes where --json says', async () => {
    const file = path('../../build/bench/quick/elsewhere.json');
    await run(process.execPath, [path('fig2.bench.js'), '--quick', '--json', file]);
    assert.equal(JSON.parse(readFileSync(file, 'utf8')).name, 'fig2');
  });

  test('two results can be compared', async () => {
    const { stdout } = await run(process.execPath, [path('compare.js'), result('speed'), result('speed')]);
    assert.ok(stdout.startsWith('Microseconds a solve'));
    await assert.rejects(run(process.execPath, [path('compare.js'), result('speed'), result('cold')]), /is of speed/);
  });
});
