// The same bits everywhere: all golden cases in Node 20 and 22, Chromium, Firefox and WebKitGTK, those that C alone can solve in native builds by gcc and clang
// from -O0 to -O3, and the .wasm built again. Prints a table. `node tests/golden/golden.js [update]`: compare with, or store, golden.json.
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { gallery } from '../../web/gallery.js';
import { load } from '../../web/index.js';
import { askPage, BROWSERS } from '../helpers/any-browser.js';
import { PAIRS } from './cases.js';
import { buildGolden, coreSources, hashAllNatively, makeSurfaces } from './native.js';

/** @typedef {import('./cases.js').Golden} Golden */

/** Releases of Node, from npm. */
const NODES = ['20.20.0', '22.23.3'];
const STRAIGHT = PAIRS.straight;
const STORED = fileURLToPath(new URL('golden.json', import.meta.url));
const CHANGELOG = fileURLToPath(new URL('../../CHANGELOG.md', import.meta.url));
const root = fileURLToPath(new URL('../..', import.meta.url));
const run = fileURLToPath(new URL('run.js', import.meta.url));

/** @param {string} executable @returns {Golden} */
const inNode = (executable) => JSON.parse(execFileSync(executable, [run], { encoding: 'utf8', maxBuffer: 2 ** 26 }));

/** A release of Node, installed in build/. @param {string} version */
function installNode(version) {
  const folder = `${root}build/golden/node-${version}`;
  const name = `node-${process.platform}-${process.arch}`;
  const binary = `${folder}/node_modules/${name}/bin/node`;
  if (existsSync(binary)) return binary;
  mkdirSync(folder, { recursive: true });
  writeFileSync(`${folder}/package.json`, '{}\n');
  // What npm's package `node` installs by a script.
  execFileSync('npm', ['install', '--prefix', folder, '--no-audit', '--no-fund', '--loglevel=error', `${name}@${version}`], {
    stdio: 'pipe',
  });
  return binary;
}

/** What differs between two sets of groups. @param {Record<string, string>} groups @param {Record<string, string>} expected */
const differences = (groups, expected) => Object.keys(groups).filter((name) => groups[name] !== expected[name]);

/** @param {string} where @param {Record<string, string>} groups @param {Record<string, string>} expected @param {string} [hash] */
function report(where, groups, expected, hash = '') {
  const different = differences(groups, expected);
  const verdict = different.length === 0 ? 'the same' : `different: ${different.slice(0, 5).join(', ')} (${different.length})`;
  console.log([where.padEnd(16), String(Object.keys(groups).length).padStart(6), hash.padEnd(16), verdict].join('  '));
  if (different.length > 0) process.exitCode = 1;
}

/** Stores the present hashes, and the one over all in the newest entry of the changelog. @param {Golden} golden */
function store(golden) {
  writeFileSync(STORED, `${JSON.stringify(golden, null, 2)}\n`);
  const text = readFileSync(CHANGELOG, 'utf8');
  writeFileSync(CHANGELOG, text.replace(/golden hash of [\d,]+ solves: [0-9a-f]{16}/, nameOf(golden)));
}

/** What the changelog says. @param {Golden} golden */
const nameOf = ({ solves, hash }) => `golden hash of ${solves.toLocaleString('en')} solves: ${hash}`;

/** Builds the module a second time, elsewhere. */
function rebuildWasm() {
  const copy = `${root}build/golden/again`;
  execFileSync('rm', ['-rf', copy]);
  mkdirSync(copy, { recursive: true });
  execFileSync('cp', ['-r', ...['Makefile', 'wasm', 'tests', 'web', 'package.json', 'package-lock.json'].map((name) => root + name), copy]);
  execFileSync('make', ['-C', copy, 'dist/surfpath.wasm'], { stdio: 'pipe', env: { ...process.env, MAKEFLAGS: '', MAKELEVEL: '' } });
  const same = readFileSync(`${copy}/dist/surfpath.wasm`).equals(readFileSync(`${root}dist/surfpath.wasm`));
  console.log(`surfpath.wasm built again in another folder: ${same ? 'the same bytes' : 'other bytes'}`);
  if (!same) process.exitCode = 1;
}

const here = inNode(process.execPath);
if (process.argv[2] === 'update') {
  store(here);
  console.log(`${here.solves} solves, ${here.hash}`);
} else {
  console.log(`${here.solves} solves\nwhere             groups  hash`);
  report(`node ${process.versions.node}`, here.groups, here.groups, here.hash);
  for (const version of NODES) {
    const { groups, hash } = inNode(installNode(version));
    report(`node ${version}`, groups, here.groups, hash);
  }
  for (const browser of Object.keys(BROWSERS)) {
    const { groups = {}, hash, error } = await askPage(browser, '/tests/golden/page.html');
    if (error) throw new Error(`${browser}: ${error}`);
    report(browser, groups, here.groups, hash);
  }
  const surfpath = await load();
  const surfaces = makeSurfaces(surfpath, gallery);
  for (const compiler of ['gcc', 'clang'])
    for (const level of ['-O0', '-O1', '-O2', '-O3'])
      report(
        `${compiler} ${level}`,
        hashAllNatively(buildGolden(compiler, level, coreSources(), surfaces), surfaces, STRAIGHT),
        here.groups,
      );
  surfpath.dispose();
  rebuildWasm();
  if (existsSync(STORED)) report('golden.json', JSON.parse(readFileSync(STORED, 'utf8')).groups, here.groups);
}
