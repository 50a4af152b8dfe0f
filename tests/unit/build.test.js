// What was built keeps its promises: sizes, imports, exports, symbols, dependencies.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readdirSync, readFileSync } from 'node:fs';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { compileFunction } from 'node:vm';
import { gzipSync } from 'node:zlib';
import { build } from 'esbuild';
import inlined from '../../dist/wasm.js';
import { unpack } from '../../web/runtime/unpack.js';

const root = fileURLToPath(new URL('../..', import.meta.url));
const wasm = readFileSync(`${root}/dist/surfpath.wasm`);
const module = new WebAssembly.Module(wasm);

/* The first slice, polylines alone, was 54 KB and 16 KB; elements, arcs, the graph, tracing, shapes and metrics doubled both. Both must come down. */
test('surfpath.wasm is at most 150.4 KB', () => {
  assert.ok(wasm.length <= 150.4 * 1024, `${wasm.length} bytes`);
});

test('the JavaScript without the wasm is at most 80.6 KB gzipped', () => {
  const text = readFileSync(`${root}/dist/index.js`, 'utf8');
  assert.ok(text.includes(inlined));
  const bytes = gzipSync(text.replace(inlined, ''), { level: 9 }).length;
  assert.ok(bytes <= 80.6 * 1024, `${bytes} bytes`);
});

test('surfpath.wasm imports nothing', () => {
  assert.deepEqual(WebAssembly.Module.imports(module), []);
});

test('surfpath.wasm exports the names in surfpath.exports, its memory and its table, and nothing else', () => {
  const exported = WebAssembly.Module.exports(module).map((entry) => entry.name);
  const wanted = readFileSync(`${root}/wasm/surfpath.exports`, 'utf8').trim().split('\n');
  assert.deepEqual(exported.sort(), [...wanted, 'memory', '__indirect_function_table'].sort());
});

test('the inlined bytes are surfpath.wasm, unpacked by zlib or by a stream', async () => {
  assert.ok(wasm.equals(await unpack(inlined)));
  const { getBuiltinModule } = process;
  process.getBuiltinModule = /** @type {any} */ (undefined);
  try {
    assert.ok(wasm.equals(await unpack(inlined)));
  } finally {
    process.getBuiltinModule = getBuiltinModule;
  }
});

test('the whole default entry is at most 143.2 KB gzipped', () => {
  const bytes = gzipSync(readFileSync(`${root}/dist/index.js`), { level: 9 }).length;
  assert.ok(bytes <= 143.2 * 1024, `${bytes} bytes`);
});

test('the core calls no library function but memcpy, memmove and memset, so no libm', () => {
  const core = `${root}/build/native/core.o`;
  const names = execFileSync('nm', ['--undefined-only', '--format=just-symbols', core], { encoding: 'utf8' }).trim().split('\n');
  const foreign = names.filter((name) => !/^(memcpy|memmove|memset|_GLOBAL_OFFSET_TABLE_|)$/.test(name));
  assert.deepEqual(foreign, []);
});

test('what has a short name in the build is told by no string, which would keep the long one', () => {
  const makefile = readFileSync(`${root}/Makefile`, 'utf8');
  const [inner, few] = ['INNER', 'FEW'].map((list) => new RegExp(`^${list} = (.*)$`, 'm').exec(makefile)?.[1]);
  const short = new RegExp(`^(is[A-Z].*|${few}|${inner})$`);
  assert.ok(short.test('sides') && short.test('writePoint'));
  for (const folder of ['web', 'demo'])
    for (const file of /** @type {string[]} */ (readdirSync(`${root}/${folder}`, { recursive: true })).filter((name) =>
      name.endsWith('.js'),
    )) {
      const code = readFileSync(`${root}/${folder}/${file}`, 'utf8').replace(/\/\*[\s\S]*?\*\//g, '');
      for (const [, , word] of code.matchAll(/(['"`])([a-z]\w*)\1/gi)) assert.doesNotMatch(word, short, `${folder}/${file}`);
    }
});

test('bundlers keep what is imported for its effect alone: the element, and the script of the workers', () => {
  const { sideEffects, exports } = JSON.parse(readFileSync(`${root}/package.json`, 'utf8'));
  for (const entry of ['./element', './worker.js']) assert.ok(sideEffects.includes(exports[entry].default), entry);
});

test('in a CommonJS bundle, which does not know where it lies, slim and the pool say what to pass', async () => {
  const contents = "export { load } from './dist/slim.js'; export { createPool } from './dist/pool.js';";
  const stdin = { contents, resolveDir: root };
  const { outputFiles } = await build({ stdin, bundle: true, format: 'cjs', platform: 'node', write: false, logLevel: 'silent' });
  /** @type {any} */ const bundle = { exports: {} };
  compileFunction(outputFiles[0].text, ['module'])(bundle);
  const { load, createPool } = bundle.exports;
  await assert.rejects(load(), /^TypeError: surfpath\/slim: no import\.meta\.url here; pass \{ wasm \}/);
  const plane = { kind: 'graph', z: 0, x: [0, 3], y: [0, 4] };
  const ask = (/** @type {any} */ asked) => asked.shortestPath(plane, [0, 0], [3, 4]);
  await assert.rejects(ask(createPool()), /^TypeError: createPool: no import\.meta\.url here; pass \{ worker \}/);
  const pool = createPool({ worker: new URL('../../dist/worker.js', import.meta.url) });
  assert.equal((await ask(pool)).status, 'converged');
  await pool.dispose();
  assert.equal((await load({ wasm })).surface(plane).kind, 'parametric');
});

test('there are no run-time dependencies', () => {
  const { dependencies, peerDependencies = {}, peerDependenciesMeta = {} } = JSON.parse(readFileSync(`${root}/package.json`, 'utf8'));
  assert.equal(dependencies, undefined);
  const required = Object.keys(peerDependencies).filter((name) => !peerDependenciesMeta[name]?.optional);
  assert.deepEqual(required, []);
});

test('surfpath/three is at most 14.1 KB gzipped, the element 8.3 KB on top of it', () => {
  for (const [name, kilobytes] of /** @type {const} */ ([
    ['three', 14.1],
    ['element', 8.3],
  ])) {
    const bytes = gzipSync(readFileSync(`${root}/dist/${name}.js`), { level: 9 }).length;
    assert.ok(bytes <= kilobytes * 1024, `${name}.js: ${bytes} bytes`);
  }
});
