// What a million solves, ten thousand surfaces and ten thousand instances leave behind: pages of WebAssembly memory, megabytes of the process.
// Prints a table, fails at one page, 5 MB of the process or 1 MB of live JavaScript objects. `node tests/endurance/memory.js [solves [surfaces [instances]]]`
import { execFile } from 'node:child_process';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';

/** @typedef {{ pages: number, megabytes: number, live: number, seconds: number }} Growth */

const LARGEST_GROWTH = 5;
const LARGEST_LIVE_GROWTH = 1;
/** The engine's nursery, else doubled up to 32 MB the longer a process is busy, whatever it keeps, stays as it is: growth is then what was kept. */
const FLAGS = ['--expose-gc', '--min-semi-space-size=1', '--max-semi-space-size=1'];
/** One heap of the C library for all threads of the engine: how it is cut up then depends less on which of them compiled what. */
const ENVIRONMENT = { ...process.env, MALLOC_ARENA_MAX: '1' };
const child = fileURLToPath(new URL('memory-child.js', import.meta.url));

/**
 * How much a process of its own grows in so many operations, after a fifth of that to warm up.
 * @param {'solves' | 'surfaces' | 'instances'} what @param {number} count
 * @returns {Promise<Growth>}
 */
export async function measureGrowth(what, count) {
  const { stdout } = await promisify(execFile)(process.execPath, [...FLAGS, child, what, String(count)], { env: ENVIRONMENT });
  return JSON.parse(stdout);
}

async function main() {
  const [solves = '1000000', surfaces = '10000', instances = '10000'] = process.argv.slice(2);
  console.log('operation    count    pages more  MB more  live MB more  seconds');
  for (const [what, count] of /** @type {const} */ ([
    ['solves', solves],
    ['surfaces', surfaces],
    ['instances', instances],
  ])) {
    const { pages, megabytes, live, seconds } = await measureGrowth(what, Number(count));
    console.log(
      [
        what.padEnd(9),
        count.padStart(8),
        String(pages).padStart(13),
        megabytes.toFixed(1).padStart(8),
        live.toFixed(2).padStart(13),
        seconds.toFixed(0).padStart(8),
      ].join(' '),
    );
    if (pages !== 0 || megabytes > LARGEST_GROWTH || live > LARGEST_LIVE_GROWTH) process.exitCode = 1;
  }
}

if (process.argv[1] === fileURLToPath(import.meta.url)) await main();
