/** publint and are-the-types-wrong find nothing, not even something to suggest; the manifest asks for nothing. */
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { formatMessage } from 'publint/utils';
import { publint } from 'publint';

export async function* check({ folder, tarball, run }) {
  const installed = join(folder, 'node_modules/surfpath');
  const manifest = JSON.parse(readFileSync(join(installed, 'package.json'), 'utf8'));
  const { messages } = await publint({ pkgDir: installed, strict: true });
  assert.deepEqual(
    messages.map((message) => formatMessage(message, manifest)),
    [],
  );
  yield 'publint ok';
  await run('node_modules/.bin/attw', tarball, '--profile', 'esm-only', '--exclude-entrypoints', './surfpath.wasm');
  yield 'are the types wrong? no';
  assert.equal(manifest.dependencies, undefined);
  const hooks = Object.keys(manifest.scripts ?? {}).filter((name) => /^(pre|post)?install$|^prepare$/.test(name));
  assert.deepEqual(hooks, []);
  yield 'no dependency, no install script';
}
