/** The golden cases that C alone can solve, straight starts on parametric and implicit surfaces, in native builds of the same sources. */
import { execFileSync } from 'node:child_process';
import { readdirSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { writeSources } from '../bench/native.js';
import { nativeEntries, straightProblems } from './cases.js';

/** @typedef {import('./cases.js').StraightProblem} StraightProblem */

const path = (/** @type {string} */ relative) => fileURLToPath(new URL(relative, import.meta.url));
const FLAGS = ['-std=c17', '-DNDEBUG', '-ffp-contract=off', '-fno-math-errno', '-Wall', '-Wextra', '-Werror'];
const INCLUDES = ['-I', path('../../wasm'), '-I', path('../native'), '-I', path('../bench')];
const ALGORITHMS = ['elements', 'polyline', 'paper'];

/**
 * Builds the native program.
 * @param {string} compiler gcc or clang @param {string} level -O0 … -O3 @param {string[]} core objects, or the sources, of wasm/
 * @param {Record<string, any>} surfaces of {@link nativeEntries}, by name: { entry, surface }
 */
export function buildGolden(compiler, level, core, surfaces) {
  const folder = path(`../../build/golden/${compiler}${level}/`);
  const sources = writeSources(folder, surfaces);
  const binary = `${folder}native`;
  execFileSync(compiler, [...FLAGS, level, ...INCLUDES, path('native.c'), ...sources, ...core, '-o', binary]);
  return binary;
}

/** The core's own sources. */
export const coreSources = () =>
  readdirSync(path('../../wasm'))
    .filter((name) => name.endsWith('.c'))
    .map((name) => path(`../../wasm/${name}`));

/** The surfaces of the native build, made. @param {import('../../web/index.js').Surfpath} surfpath @param {Record<string, any>} gallery */
export function makeSurfaces(surfpath, gallery) {
  return Object.fromEntries(nativeEntries(gallery).map(([name, entry]) => [name, { entry, surface: surfpath.surface(entry) }]));
}

/**
 * The hash of the straight problems of a surface.
 * @param {string} binary @param {string} name @param {StraightProblem[]} problems
 */
export function hashNatively(binary, name, problems) {
  const rows = problems.map(({ from, to, options }) =>
    [ALGORITHMS.indexOf(options.algorithm), options.points, options.maxIterations, ...from, ...to].map(literal).join(' '),
  );
  return execFileSync(binary, [name], { input: `${rows.length}\n${rows.join('\n')}\n`, encoding: 'utf8' }).trim();
}

/** @param {number} x */
const literal = (x) => (Object.is(x, -0) ? '-0' : String(x));

/** All groups. @param {string} binary @param {Record<string, any>} surfaces @param {number} count problems a surface @returns {Record<string, string>} */
export function hashAllNatively(binary, surfaces, count) {
  return Object.fromEntries(
    Object.entries(surfaces).map(([name, { entry, surface }]) => [
      `${name} straight`,
      hashNatively(binary, name, straightProblems(surface, entry, count)),
    ]),
  );
}
