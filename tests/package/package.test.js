// The package as a stranger gets it: packed, installed without a network, imported by Node and type-checked by TypeScript.
import assert from 'node:assert/strict';
import { access, cp, mkdir, mkdtemp, readFile, rm, symlink, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { pruned } from '../helpers/prune-types.js';
import { pack, run } from './pack.js';

const here = fileURLToPath(new URL('.', import.meta.url));
const root = fileURLToPath(new URL('../..', import.meta.url));

/** Every file that package.json promises under `exports`. @param {unknown} target @returns {string[]} */
function promisedFiles(target) {
  if (typeof target === 'string') return [target.replace('./', '')];
  return Object.values(/** @type {object} */ (target)).flatMap(promisedFiles);
}

describe('the package', () => {
  /** @type {string} */ let project;
  /** @type {import('./pack.js').Packed} */ let packed;

  before(async () => {
    project = await mkdtemp(join(tmpdir(), 'surfpath-package-'));
    packed = await pack(project);
    await writeFile(join(project, 'package.json'), '{ "name": "consumer", "private": true, "type": "module" }');
    await run(project, 'npm', 'install', '--offline', '--ignore-scripts', '--no-audit', '--no-fund', `./${packed.filename}`);
    await cp(join(here, 'consumer.js'), join(project, 'consumer.js'));
    for (const name of ['consumer.ts', 'consumer-three.ts']) await cp(join(here, 'typescript', name), join(project, name));
  });

  after(() => rm(project, { recursive: true, force: true }));

  test('holds what was built and the papers, and nothing else', () => {
    const expected =
      /^(dist\/(index|slim|gallery|pool|worker|three|element)\.js|dist\/surfpath\.wasm|dist\/types\/.+\.d\.ts|(README|SECURITY)\.md|LICENSE|package\.json)$/;
    const unexpected = packed.files.map((file) => file.path).filter((path) => !expected.test(path));
    assert.deepEqual(unexpected, []);
  });

  test('holds every file that its exports name', async () => {
    const { exports } = JSON.parse(await readFile(join(root, 'package.json'), 'utf8'));
    const paths = packed.files.map((file) => file.path);
    const missing = promisedFiles(exports).filter((path) => !paths.includes(path));
    assert.deepEqual(missing, []);
  });

  test('holds no types that no entry leads to, and all that one leads to', async () => {
    for (const [file, text] of await pruned(join(root, 'dist/types'))) assert.equal(text, await readFile(file, 'utf8'), file);
  });

  test('is at most 454.8 KB', () => {
    assert.ok(packed.size <= 454.8 * 1024, `${packed.size} bytes`);
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
