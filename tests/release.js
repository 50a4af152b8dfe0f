/**
 * Everything that a release must pass, one make target after the other, and a table of how each ended. What they print goes to
 * build/release/TARGET.log.
 *
 * Usage: node tests/release.js target …; exits with 1 if any failed. Run by `make release-check`.
 */
import { spawn } from 'node:child_process';
import { mkdirSync, openSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('..', import.meta.url));
const logs = fileURLToPath(new URL('../build/release/', import.meta.url));

/** @param {string} target @returns {Promise<{ target: string, code: number | null, seconds: number }>} code: null where a signal ended it */
function run(target) {
  const start = performance.now();
  const log = openSync(`${logs}${target}.log`, 'w');
  return new Promise((resolve) => {
    const child = spawn('make', [target], { cwd: root, stdio: ['ignore', log, log] });
    child.on('exit', (code) => resolve({ target, code, seconds: (performance.now() - start) / 1000 }));
  });
}

mkdirSync(logs, { recursive: true });
const outcomes = [];
for (const target of process.argv.slice(2)) {
  console.log(`make ${target} …`);
  outcomes.push(await run(target));
}
const table = [
  `${'target'.padEnd(12)}${'status'.padEnd(10)}${'seconds'.padStart(8)}${'exit code'.padStart(12)}`,
  ...outcomes.map(({ target, code, seconds }) =>
    [target.padEnd(12), (code === 0 ? 'ok' : 'FAILED').padEnd(10), seconds.toFixed(0).padStart(8), String(code).padStart(12)].join(''),
  ),
].join('\n');
const failed = outcomes.filter(({ code }) => code !== 0).map(({ target }) => target);
console.log(`\n${table}\n${failed.length > 0 ? `failed: ${failed.join(', ')}; see build/release/` : 'all passed'}`);
writeFileSync(`${logs}table.txt`, `${table}\n`);
process.exitCode = failed.length > 0 ? 1 : 0;
