/**
 * The package as strangers use it: packed once, installed beside each consumer of tests/package/ with the tools of its own lockfile, then built
 * and run. Works in build/packages/, where what was installed stays, so that a second run needs no network. Prints a line a check.
 *
 * Usage: node tests/package/packages.js [consumer …]; exits with 1 if anything failed.
 */
import { cpSync, existsSync, mkdirSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { openPages } from './pages.js';
import { pack, run } from './pack.js';

const here = fileURLToPath(new URL('.', import.meta.url));
const work = fileURLToPath(new URL('../../build/packages/', import.meta.url));

/**
 * What the check.js of a consumer gets. It returns, or yields, a line for each thing that works, and throws where one does not.
 *
 * @typedef {object} Consumer
 * @property {string} folder where it stands, with its sources, the files of app/, and node_modules
 * @property {string} tarball
 * @property {string} expected what the sample says
 * @property {(command: string, ...parameters: string[]) => Promise<string>} run in its folder; gives the output
 * @property {(address: string) => Promise<string>} visit what the sample says on a page
 * @property {(folder: string, policy?: string) => Promise<string>} visitFolder the same for files served under a strict policy
 */

/** Installs the tools of a consumer, unless its lockfile is that of the last time, then the package. @param {string} name @param {string} tarball */
async function install(name, tarball) {
  const folder = join(work, name);
  const lock = join(here, name, 'package-lock.json');
  const stamp = join(folder, 'installed-lock.json');
  mkdirSync(folder, { recursive: true });
  for (const file of readdirSync(folder))
    if (file !== 'node_modules' && file !== 'installed-lock.json') rmSync(join(folder, file), { recursive: true });
  for (const source of ['app', name]) cpSync(join(here, source), folder, { recursive: true });
  const isNew = !existsSync(stamp) || !existsSync(lock) || readFileSync(stamp, 'utf8') !== readFileSync(lock, 'utf8');
  if (existsSync(lock) && isNew) {
    await run(folder, 'npm', 'install', '--no-save', '--ignore-scripts', '--no-audit', '--no-fund', '--loglevel=error');
    cpSync(lock, stamp);
  }
  rmSync(join(folder, 'node_modules', 'surfpath'), { recursive: true, force: true });
  await run(folder, 'npm', 'install', '--offline', '--no-save', '--ignore-scripts', '--no-audit', '--no-fund', tarball);
  return folder;
}

/** @param {string} name @param {string} tarball @param {string} expected @param {Awaited<ReturnType<typeof openPages>>} pages */
async function checkConsumer(name, tarball, expected, pages) {
  const folder = await install(name, tarball);
  const { check } = await import(join(folder, 'check.js'));
  const consumer = {
    folder,
    tarball,
    expected,
    run: run.bind(null, folder),
    visit: pages.visit,
    visitFolder: pages.visitFolder,
  };
  for await (const line of check(/** @type {Consumer} */ (consumer))) console.log(`${name.padEnd(12)}${line}`);
}

const all = readdirSync(here).filter((name) => existsSync(join(here, name, 'check.js')));
const names = process.argv.length > 2 ? process.argv.slice(2) : all;
rmSync(join(work, 'tarball'), { recursive: true, force: true });
mkdirSync(join(work, 'tarball'), { recursive: true });
const { filename, size } = await pack(join(work, 'tarball'));
const tarball = join(work, 'tarball', filename);
console.log(`${'tarball'.padEnd(12)}${filename}, ${(size / 1024).toFixed(1)} KB`);

const { sample } = await import('./app/sample.js');
const expected = await sample();
const pages = await openPages();
let failures = statSync(tarball).size > 454.8 * 1024 ? 1 : 0;
if (failures > 0) console.log(`${'tarball'.padEnd(12)}FAILED: more than 454.8 KB`);
for (const name of names) {
  try {
    await checkConsumer(name, tarball, expected, pages);
  } catch (error) {
    failures++;
    console.log(`${name.padEnd(12)}FAILED: ${/** @type {Error} */ (error).message}`);
  }
}
await pages.close();
writeFileSync(join(work, 'result.txt'), `${failures} failures\n`);
process.exitCode = failures > 0 ? 1 : 0;
