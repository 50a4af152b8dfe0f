/** Node 20 and 22, Deno and Bun, without a network where the kernel lets a process do without. */
import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { join } from 'node:path';

const RUNTIMES = [
  ['Node 20', ['node20/bin/node']],
  ['Node 22', ['node22/bin/node']],
  ['Deno', ['@deno/linux-x64-glibc/deno'], 'run', '--no-remote', '--allow-read', '--allow-sys'],
  ['Bun', ['@oven/bun-linux-x64/bin/bun', '@oven/bun-linux-x64-baseline/bin/bun'], 'run'],
];

export async function* check({ folder, expected, run }) {
  const alone = await run('unshare', '-rn', 'true').then(
    () => ['unshare', '-rn'],
    () => [],
  );
  for (const [name, places, ...parameters] of RUNTIMES) {
    const program = places.map((place) => join(folder, 'node_modules', place)).find(existsSync);
    if (!program) {
      yield `${name} skipped: npm has no such program for ${process.platform} ${process.arch}`;
      continue;
    }
    const [first, ...others] = [...alone, program, ...parameters, 'program.js'];
    assert.equal((await run(first, ...others)).trim(), expected, name);
    const version = (await run(program, '--version')).split('\n')[0];
    yield `${name} (${version}) ok${alone.length > 0 ? ', without a network' : ''}`;
  }
}
