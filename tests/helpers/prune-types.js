/** Which .d.ts files of a folder no entry of the package leads to. Run as a program by `make`, it deletes them: they are of no use to who installs it. */

import { readdir, readFile, rm } from 'node:fs/promises';
import { dirname, join, normalize, relative } from 'node:path';
import { fileURLToPath } from 'node:url';

const ROOT = fileURLToPath(new URL('../..', import.meta.url));
const IMPORT = /(?:from|import\() ?['"](\.[^'"]+)\.js['"]/g;

/** The entries' types, as package.json names them. @returns {Promise<string[]>} */
async function entries() {
  const { exports } = JSON.parse(await readFile(join(ROOT, 'package.json'), 'utf8'));
  return Object.values(exports).flatMap(({ types }) => (types ? [join(ROOT, types)] : []));
}

/** @param {string} folder @returns {Promise<string[]>} paths from the folder */
export async function findUnreachable(folder) {
  const left = await entries();
  /** @type {Set<string>} */
  const reached = new Set();
  for (let file = left.pop(); file; file = left.pop()) {
    if (reached.has(file)) continue;
    reached.add(file);
    const text = await readFile(file, 'utf8');
    for (const [, name] of text.matchAll(IMPORT)) left.push(normalize(join(dirname(file), `${name}.d.ts`)));
  }
  const all = (await readdir(folder, { recursive: true })).filter((name) => name.endsWith('.d.ts'));
  return all.filter((name) => !reached.has(join(folder, name)));
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const folder = join(ROOT, relative(ROOT, process.argv[2]));
  for (const name of await findUnreachable(folder)) await rm(join(folder, name));
}
