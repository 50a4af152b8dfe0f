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
  // Rollup leaves new URL(…, import.meta.url) as it is: the files go beside the bundle.
  for (const file of ['surfpath.wasm', 'worker.js']) cpSync(join(folder, 'node_modules/surfpath/dist', file), join(output, file));
  assert.equal(await visitFolder(output), expected);
  yield 'build ok, under a strict policy; /slim and the pool with surfpath.wasm and worker.js copied beside the bundle';
}
