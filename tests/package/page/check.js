/** No tools at all: files, an import map, and a policy that names the map by its hash. */
import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';

export async function* check({ folder, expected, visitFolder }) {
  const [, map] = /<script type="importmap">([\s\S]*?)<\/script>/.exec(readFileSync(join(folder, 'index.html'), 'utf8'));
  const hash = createHash('sha256').update(map).digest('base64');
  const policy = `default-src 'none'; script-src 'self' 'wasm-unsafe-eval' 'sha256-${hash}'; worker-src 'self'; connect-src 'self'`;
  assert.equal(await visitFolder(folder, policy), expected);
  yield 'import map ok, under a strict policy';
}
