// A few seconds of each fuzzer of `make fuzz`, with the kept corpus (of the C functions a third of it), from one seed: what fails here fails again. `make fuzz` takes a new one.
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { cpSync, mkdtempSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { describe, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { ofAll } from '../helpers/sample.js';

const SECONDS = ofAll(2, 5);
const SEED = 2088936430;
const path = (/** @type {string} */ relative) => fileURLToPath(new URL(relative, import.meta.url));
const run = promisify(execFile);

/** What a fuzzer said, if it failed. @param {string} file @param {string[]} parameters */
const complaint = (file, parameters) =>
  run(file, parameters, { maxBuffer: 2 ** 26 }).then(
    () => '',
    ({ stdout, stderr }) => `${stdout}\n${stderr.slice(-5000)}`,
  );

describe('fuzz', { concurrency: 2 }, () => {
  for (const name of ['expressions', 'definitions', 'straight', 'global'])
    test(name, async () => {
      assert.equal(await complaint(process.execPath, [path('fuzz.js'), name, String(SECONDS), String(SEED)]), '');
    });

  test('the C functions, under sanitizers', async () => {
    const corpus = mkdtempSync(join(tmpdir(), 'surfpath-fuzz-'));
    /* A third of what was kept: under sanitizers all of it takes half a minute. */
    for (const [i, name] of readdirSync(path('corpus/core')).sort().entries())
      if (i % 3 === 0) cpSync(path(`corpus/core/${name}`), join(corpus, name));
    const options = [
      `-max_total_time=${SECONDS}`,
      '-timeout=250',
      '-max_len=400',
      '-len_control=0',
      `-seed=${SEED}`,
      `-artifact_prefix=${corpus}/`,
    ];
    const said = await complaint(path('../../build/fuzz/core'), [...options, corpus]);
    rmSync(corpus, { recursive: true });
    assert.equal(said, '');
  });
});
