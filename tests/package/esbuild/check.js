import assert from 'node:assert/strict';
import { cpSync } from 'node:fs';
import { join } from 'node:path';
import { build } from 'esbuild';

export async function* check({ folder, expected, visitFolder }) {
  const output = join(folder, 'built');
  const options = { absWorkingDir: folder, entryPoints: ['main.js'], outdir: 'built', bundle: true, minify: true, format: 'esm' };
  const { warnings } = await build({ ...options, target: 'es2022', external: ['node:*'], logLevel: 'silent' });
  assert.deepEqual(warnings, []);
  cpSync(join(folder, 'index.html'), join(output, 'index.html'));
  // esbuild leaves new URL(…, import.meta.url) as it is: the files go beside the bundle.
  for (const file of ['surfpath.wasm', 'worker.js']) cpSync(join(folder, 'node_modules/surfpath/dist', file), join(output, file));
  assert.equal(await visitFolder(output), expected);
  yield 'build ok, under a strict policy; /slim and the pool with surfpath.wasm and worker.js copied beside the bundle';
}
