import assert from 'node:assert/strict';
import { cpSync } from 'node:fs';
import { join } from 'node:path';
import { nodeResolve } from '@rollup/plugin-node-resolve';
import { rollup } from 'rollup';

export async function* check({ folder, expected, visitFolder }) {
  const output = join(folder, 'built');
  const bundle = await rollup({ input: join(folder, 'main.js'), plugins: [nodeResolve()], external: /^node:/ });
  await bundle.write({ dir: output, format: 'es' });
  await bundle.close();
  cpSync(join(folder, 'index.html'), join(output, 'index.html'));
  // Rollup leaves new URL(…, import.meta.url) as it is: the file goes beside the bundle.
  cpSync(join(folder, 'node_modules/surfpath/dist/surfpath.wasm'), join(output, 'surfpath.wasm'));
  assert.equal(await visitFolder(output), expected);
  yield 'build ok, under a strict policy; /slim with surfpath.wasm copied beside the bundle';
}
