/**
 * Do the tests notice? Puts one small mistake at a time into a copy of the sources, builds what depends on it, and runs the tests until one
 * fails. The mistakes are drawn by seed: from wasm/*.c, where the native tests look first, under sanitizers, then those of the built library,
 * and from web/expression/*.js.
 *
 * Usage: node tests/mutants/mutants.js [count, default 45] [seed, default 1]; exits with 1 if fewer than 90 % are noticed, or if one that is
 * not noticed is missing from survivors.md. SANITIZED is the command that compiles native tests; `make mutants` passes it.
 */
import { execFileSync, spawn, spawnSync } from 'node:child_process';
import { cpSync, mkdirSync, readdirSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { findMutants } from './candidates.js';

const root = fileURLToPath(new URL('../..', import.meta.url));
const tree = join(root, 'build/mutants');
const [count, seed] = [Number(process.argv[2] ?? 45), Number(process.argv[3] ?? 1)];
const WANTED = 0.9;
/** Of three mutants this many are C. */
const C_SHARE = 2 / 3;
/** A warning is no failure: a mutant may leave a variable unused. */
const GCC = process.env.SANITIZED ?? 'gcc -std=c17 -O1 -ffp-contract=off -fno-math-errno -Iwasm';
const COMPILE = `${GCC} -w`;
const WASM_FLAGS = 'CFLAGS=-std=c17 -w -ffp-contract=off -fno-math-errno -Iwasm -MMD -MP';
/** They test what is packed, written, drawn or sent to workers, not what is computed; or by the clock, which says how busy the machine is. */
const NOT_RUN = /\/(build|readme|memory|hostile)\.test\.js$|\/(view|runtime)\//;
const AT_A_TIME = 2;

/** @typedef {import('./candidates.js').Mutant} Mutant */
/** hung: it was ended, its time over. @typedef {{ name: string, command: string[], milliseconds: number, noticed: number, hung: boolean }} Test */

/** A copy of what is compiled and run, as it was built; what is only read is linked to. */
function makeTree() {
  rmSync(tree, { recursive: true, force: true });
  mkdirSync(tree, { recursive: true });
  for (const name of ['Makefile', 'package.json', 'package-lock.json', 'wasm', 'web', 'demo', 'build/wasm', 'build/sanitized', 'dist'])
    cpSync(join(root, name), join(tree, name), { recursive: true, preserveTimestamps: true });
  const isData = (/** @type {string} */ path) => path === join(root, 'tests/data') || path.includes('/tests/package/');
  cpSync(join(root, 'tests'), join(tree, 'tests'), { recursive: true, preserveTimestamps: true, filter: (path) => !isData(path) });
  symlinkSync(join(root, 'tests/data'), join(tree, 'tests/data'));
  symlinkSync(join(root, 'node_modules'), join(tree, 'node_modules'));
}

/** @param {string} command @param {string[]} parameters */
const build = (command, ...parameters) => execFileSync(command, parameters, { cwd: tree, stdio: 'pipe' });

/** @param {string[]} parameters */
const compile = (...parameters) => build('sh', '-c', `${COMPILE} "$@"`, 'sh', ...parameters);

/** @param {string} source */
const objectOf = (source) => `build/sanitized/wasm/${basename(source, '.c')}.o`;
const sources = readdirSync(join(root, 'wasm')).filter((name) => name.endsWith('.c'));

/** Each links itself with the objects of the core: most mutants are noticed before the last has to. @returns {Test[]} */
function nativeTests() {
  const names = readdirSync(join(root, 'tests/native')).filter((name) => name.endsWith('.c'));
  const objects = names.map((name) => `build/sanitized/tests/${basename(name, '.c')}.o`);
  const [programs, helpers] = [objects.filter((name) => name.endsWith('_test.o')), objects.filter((name) => !name.endsWith('_test.o'))];
  return programs.map((object) => {
    const program = object.replace('/tests/', '/').replace(/\.o$/, '');
    const link = [COMPILE, object, ...helpers, ...sources.map(objectOf), '-lm', '-o', program].join(' ');
    return {
      name: basename(program),
      command: ['sh', '-c', `${link} && exec ${program} tests/data`],
      milliseconds: 0,
      noticed: 0,
      hung: false,
    };
  });
}

/** @param {string} under @returns {Test[]} */
function unitTests(under) {
  return readdirSync(join(tree, under), { recursive: true, encoding: 'utf8' })
    .filter((name) => name.endsWith('.test.js') && !NOT_RUN.test(`/${name}`))
    .map((name) => ({ name, command: [process.execPath, join(under, name)], milliseconds: 0, noticed: 0, hung: false }));
}

/** Runs a test; resolves to whether it passed. One that takes five times as long as it did before has failed. @param {Test} test @param {AbortSignal} [signal] @returns {Promise<boolean>} */
function run(test, signal) {
  const [program, ...parameters] = test.command;
  const timeout = test.milliseconds > 0 ? Math.ceil(20_000 + 5 * test.milliseconds) : 300_000;
  const start = performance.now();
  return new Promise((resolve) => {
    const child = spawn(program, parameters, { cwd: tree, stdio: 'ignore', timeout, killSignal: 'SIGKILL', signal });
    child.on('error', () => resolve(false));
    child.on('exit', (code, killer) => {
      test.hung = killer === 'SIGKILL' && !signal?.aborted;
      if (code === 0) test.milliseconds = Math.max(test.milliseconds, performance.now() - start);
      resolve(code === 0);
    });
  });
}

/** Those first that are named like the file, then those that have noticed most, then the fast ones. @param {Test[]} tests @param {string} file */
function inOrder(tests, file) {
  const words = basename(file)
    .replace(/\.\w+$/, '')
    .split('_');
  const isNamesake = (/** @type {Test} */ { name }) => (words.some((word) => name.includes(word)) ? 0 : 1);
  return [...tests].sort((a, b) => isNamesake(a) - isNamesake(b) || b.noticed - a.noticed || a.milliseconds - b.milliseconds);
}

/** Runs tests until one fails. @param {Test[]} tests @returns {Promise<Test | null>} the one that failed */
async function firstFailure(tests) {
  const waiting = [...tests];
  const stop = new AbortController();
  /** @type {Test | null} */
  let failed = null;
  const work = async () => {
    for (let test = waiting.shift(); test && !failed; test = waiting.shift()) {
      if ((await run(test, stop.signal)) || failed) continue;
      failed = test;
      stop.abort();
    }
  };
  await Promise.all(Array.from({ length: AT_A_TIME }, work));
  return failed;
}

/** A test that fails without any mutant notices nothing. Says too how long each takes, so that the quick ones come first. @param {Test[]} tests */
async function checkSound(tests) {
  const failed = await firstFailure(tests);
  if (failed) throw new Error(`${failed.name} fails without any mutant`);
}

/** Puts a mutant into the tree and looks which test fails; null: none does. @param {Mutant} mutant @param {{ native: Test[], compiler: Test[], others: Test[] }} tests */
async function judge(mutant, { native, compiler, others }) {
  const path = join(tree, mutant.file);
  const sound = readFileSync(path);
  writeFileSync(path, mutant.text);
  try {
    if (!mutant.file.endsWith('.c')) return await firstFailure([...inOrder(compiler, mutant.file), ...inOrder(others, mutant.file)]);
    const object = objectOf(mutant.file);
    cpSync(join(tree, object), join(tree, 'sound.o'));
    try {
      compile('-c', mutant.file, '-o', object);
      const failed = await firstFailure(inOrder(native, mutant.file));
      if (failed) return failed;
    } finally {
      cpSync(join(tree, 'sound.o'), join(tree, object));
    }
    build('make', WASM_FLAGS, 'dist/wasm.js');
    return await firstFailure(inOrder(others, mutant.file));
  } finally {
    writeFileSync(path, sound);
  }
}

/** The first of a seeded order that compile, and could be noticed. @param {Mutant[]} all @param {number} wanted */
function draw(all, wanted) {
  const drawn = [];
  for (const mutant of all.sort((a, b) => (a.key < b.key ? -1 : 1))) {
    if (drawn.length === wanted) break;
    if (compiles(mutant) && !comparesRounded(mutant)) drawn.push(mutant);
  }
  return drawn;
}

/** @param {Mutant} mutant */
function compiles({ file, text }) {
  return file.endsWith('.c') ? complaints(text) !== null : isSound(text);
}

/** Whether only the boundary moves between two doubles of which one was rounded: that they are equal is chance, and either answer is right. @param {Mutant} mutant */
function comparesRounded({ file, line, column, asEqual }) {
  if (asEqual === null || !file.endsWith('.c')) return false;
  return complaints(asEqual)?.includes(`:${line}:${column}: warning: comparing floating-point`) ?? false;
}

/** What the compiler warns of in a C file of the core, compared doubles among it; null: it does not compile. @param {string} text */
function complaints(text) {
  const copy = join(tree, 'wasm/mutant.c');
  writeFileSync(copy, text);
  const { status, stderr } = spawnSync('sh', ['-c', `${GCC} -Wno-error -Wfloat-equal -fsyntax-only "$@"`, 'sh', copy], {
    cwd: tree,
    encoding: 'utf8',
  });
  rmSync(copy);
  return status === 0 ? stderr : null;
}

/** @param {string} text of a module */
function isSound(text) {
  const copy = join(tree, 'mutant.mjs');
  writeFileSync(copy, text);
  const { status } = spawnSync(process.execPath, ['--check', copy]);
  rmSync(copy);
  return status === 0;
}

makeTree();
const unit = unitTests('tests/unit');
const isCompiler = (/** @type {Test} */ { name }) => name.startsWith('expression/');
const tests = { native: nativeTests(), compiler: unit.filter(isCompiler), others: unit.filter((test) => !isCompiler(test)) };
await checkSound([...tests.native, ...unit]);
const cCount = Math.round(count * C_SHARE);
// The compiler's first: a mutant of the C stays in the library until the next one is built.
const mutants = [
  ...draw(
    readdirSync(join(root, 'web/expression')).flatMap((name) => findMutants(tree, `web/expression/${name}`, seed)),
    count - cCount,
  ),
  ...draw(
    sources.flatMap((name) => findMutants(tree, `wasm/${name}`, seed)),
    cCount,
  ),
];

const explained = readFileSync(new URL('survivors.md', import.meta.url), 'utf8');
let [noticed, unexplained] = [0, 0];
for (const mutant of mutants) {
  const failed = await judge(mutant, tests);
  const isExplained = explained.includes(`\`${mutant.after}\``);
  if (failed) {
    noticed++;
    failed.noticed++;
  } else if (!isExplained) unexplained++;
  const verdict = failed ? `noticed by ${failed.name}${failed.hung ? ', which hangs' : ''}` : `SURVIVED${isExplained ? ', explained' : ''}`;
  console.log(`${mutant.file}:${mutant.line}: ${mutant.before}  =>  ${mutant.after}\n    ${verdict}`);
}
console.log(
  `seed ${seed}: ${noticed} of ${mutants.length} mutants noticed (wanted: ${100 * WANTED} %), ${unexplained} survivors not explained`,
);
process.exitCode = noticed >= WANTED * mutants.length && unexplained === 0 ? 0 : 1;
