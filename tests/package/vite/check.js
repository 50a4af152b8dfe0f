import assert from 'node:assert/strict';
import { readdirSync } from 'node:fs';
import { join } from 'node:path';
import { build, createServer } from 'vite';

export async function* check({ folder, expected, visit, visitFolder }) {
  const server = await createServer({ root: folder, configFile: false, logLevel: 'error', server: { host: '127.0.0.1', port: 0 } });
  try {
    await server.listen();
    const { port } = server.httpServer.address();
    assert.equal(await visit(`http://127.0.0.1:${port}/`), expected);
  } finally {
    await server.close();
  }
  yield 'dev ok';
  await build({ root: folder, configFile: false, logLevel: 'error', base: './', build: { outDir: 'built', target: 'es2022' } });
  assert.equal(await visitFolder(join(folder, 'built')), expected);
  const scripts = readdirSync(join(folder, 'built', 'assets')).filter((name) => name.endsWith('.js'));
  assert.equal(scripts.filter((name) => name.startsWith('worker')).length, 1, `one file of the workers: ${scripts}`);
  yield 'build ok, under a strict policy';
}
