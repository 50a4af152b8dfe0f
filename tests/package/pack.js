/** Packs the project into a tarball as npm would publish it, and runs the programs of those who install it. */

import { execFile } from 'node:child_process';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';

const root = fileURLToPath(new URL('../..', import.meta.url));
const execute = promisify(execFile);

/** @typedef {{ filename: string, size: number, files: { path: string }[] }} Packed */

/**
 * Runs a command and returns what it printed; what a failing one printed is in the error's message.
 * @param {string} directory
 * @param {string} command
 * @param {string[]} parameters
 */
export async function run(directory, command, ...parameters) {
  try {
    return (await execute(command, parameters, { cwd: directory, maxBuffer: 2 ** 26 })).stdout;
  } catch (error) {
    const { message, stdout } = /** @type {Error & { stdout: string }} */ (error);
    throw new Error(`${message}\n${stdout}`);
  }
}

/**
 * Packs what `make` built; touches no network.
 * @param {string} directory where the tarball goes
 * @returns {Promise<Packed>}
 */
export async function pack(directory) {
  const answer = JSON.parse(await run(root, 'npm', 'pack', '--json', '--ignore-scripts', '--pack-destination', directory));
  return answer[0] ?? answer.surfpath;
}
