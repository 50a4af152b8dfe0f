// The package as a stranger gets it: packed, installed without a network, imported by Node and type-checked by TypeScript.
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { access, cp, mkdir, mkdtemp, readFile, rm, symlink, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';

const here = fileURLToPath(new URL('.', import.meta.url));
const root = fileURLToPath(new URL('../..', import.meta.url));
const execute = promisify(execFile);

/** @typedef {{ filename: string, size: number, files: { path: string }[] }} Packed */

/**
 * Runs a command and returns what it printed; what a failing one printed is in the error's message.
 * @param {string} directory
 * @param {string} command
 * @param {string[]} parameters
 */
async function run(directory, command, ...parameters) {
  try {
    return (await execute(command, parameters, { cwd: directory })).stdout;
  } catch (error) {
    const { message, stdout } = /** @type {Error & { stdout: string }} */ (error);
    throw new Error(`${message}\n${stdout}`);
  }
}

/** Every file that package.json promises under `exports`. @param {unknown} target @returns {string[]} */
function promisedFiles(target) {
  if (typeof target === 'string') return [target.replace('./', '')];
  return Object.values(/** @type {object} */ (target)).flatMap(promisedFiles);
}

describe('the package', () => {
  /** @type {string} */ let project;
  /** @type {Packed} */ let packed;

  before(async () => {
    project = await mkdtemp(join(tmpdir(), 'surfpath-package-'));
    const answer = JSON.parse(await run(root, 'npm', 'pack', '--json', '--ignore-scripts', '--pack-destination', project));
    packed = answer[0] ?? answer.surfpath;
    await writeFile(join(project, 'package.json'), '{ "name": "consumer", "private": true, "type": "module" }');
    await run(project, 'npm', 'install', '--offline', '--ignore-scripts', '--no-audit', '--no-fund', `./${packed.filename}`);
    await cp(join(here, 'consumer.js'), join(project, 'consumer.js'));
    await cp(join(here, 'consumer.ts'), join(project, 'consumer.ts'));
    await cp(join(here, 'consumer-three.ts'), join(project, 'consumer-three.ts'));
  });

  after(() => rm(project, { recursive: true, force: true }));

  test('holds what was built and the papers, and nothing else', () => {
    const expected =
      /^(dist\/(index|slim|gallery|pool|worker|three)\.js|dist\/surfpath\.wasm|dist\/types\/.+\.d\.ts|(README|CHANGELOG)\.md|LICENSE|package\.json)$/;
    const unexpected = packed.files.map((file) => file.path).filter((path) => !expected.test(path));
    assert.deepEqual(unexpected, []);
  });

  test('holds every file that its exports name', async () => {
    const { exports } = JSON.parse(await readFile(join(root, 'package.json'), 'utf8'));
    const paths = packed.files.map((file) => file.path);
    const missing = promisedFiles(exports).filter((path) => !paths.includes(path));
    assert.deepEqual(missing, []);
  });

  test('is at most 256 KB', () => {
    assert.ok(packed.size <= 256 * 1024, `${packed.size} bytes`);
  });

  test('works in Node', async () => {
    assert.equal(await run(project, process.execPath, 'consumer.js'), 'ok\n');
  });

  for (const [module, resolution] of [
    ['node16', 'node16'],
    ['esnext', 'bundler'],
  ]) {
    test(`has types for TypeScript with ${resolution} resolution`, async () => {
      const target = ['--target', 'es2022', '--module', module, '--moduleResolution', resolution];
      await run(project, join(root, 'node_modules/.bin/tsc'), '--noEmit', '--strict', '--types', '', ...target, 'consumer.ts');
    });
  }

  test('has types for surfpath/three where three is installed, and does without where it is not', async () => {
    const target = ['--noEmit', '--strict', '--types', '', '--target', 'es2022', '--module', 'node16', '--lib', 'es2022,dom'];
    await assert.rejects(access(join(project, 'node_modules/three')));
    await mkdir(join(project, 'node_modules/@types'), { recursive: true });
    for (const name of ['three', '@types/three']) await symlink(join(root, 'node_modules', name), join(project, 'node_modules', name));
    await run(project, join(root, 'node_modules/.bin/tsc'), ...target, 'consumer-three.ts');
  });
});
