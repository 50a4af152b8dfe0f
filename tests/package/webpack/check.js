import assert from 'node:assert/strict';
import { cpSync } from 'node:fs';
import { join } from 'node:path';
import { promisify } from 'node:util';
import webpack from 'webpack';

export async function* check({ folder, expected, visitFolder }) {
  const output = join(folder, 'built');
  const stats = await promisify(webpack)({
    context: folder,
    mode: 'production',
    entry: './main.js',
    output: { path: output, filename: 'main.js' },
  });
  assert.deepEqual(
    stats.toJson({ all: false, errors: true }).errors.map(({ message }) => message),
    [],
  );
  cpSync(join(folder, 'index.html'), join(output, 'index.html'));
  assert.equal(await visitFolder(output), expected);
  yield 'production build ok, under a strict policy';
}
