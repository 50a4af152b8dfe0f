// Runs each native C test, tests/native/*_test.c, which make has compiled under the address and undefined-behaviour sanitizers.
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { readdirSync } from 'node:fs';
import { describe, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';

const path = (/** @type {string} */ relative) => fileURLToPath(new URL(relative, import.meta.url));
const run = promisify(execFile);
const names = readdirSync(path('.')).flatMap((file) => (file.endsWith('_test.c') ? [file.slice(0, -2)] : []));
const options = { env: { ...process.env, ASAN_OPTIONS: 'detect_stack_use_after_return=1', UBSAN_OPTIONS: 'print_stacktrace=1' } };

test('there are native tests', () => {
  assert.ok(names.length > 0);
});

describe('native', { concurrency: 2 }, () => {
  for (const name of names) {
    test(name, async () => {
      const said = await run(path(`../../build/sanitized/${name}`), [path('../data')], options).then(
        () => '',
        (error) => `${error.message}\n${error.stdout}`,
      );
      assert.equal(said, '');
    });
  }
});
