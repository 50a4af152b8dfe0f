/** The native rival: the solver's C compiled by gcc, the surfaces written as C from the same graph, one process a sample. */
import { execFileSync } from 'node:child_process';
import { mkdirSync, readdirSync, statSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { compile } from '../../web/expression/compile.js';
import { instantiate } from '../helpers/wasm.js';
import { writeC } from '../helpers/write-c.js';

/** @typedef {Pick<import('../../web/surface.js').Surface, 'domain'>} Surface */
/** @typedef {import('../../web/gallery.js').GalleryEntry} GalleryEntry */
/** @typedef {{ nanoseconds: number, sum: number }} NativeSample `sum` of all that was computed in a pass */

const path = (/** @type {string} */ relative) => fileURLToPath(new URL(relative, import.meta.url));
/** By the folder of its objects: for every processor, or for the one that runs this. */
const MARCH = { native: [], march: ['-march=native'] };
const flags = ['-std=c17', '-O3', '-DNDEBUG', '-ffp-contract=off', '-fno-math-errno', '-Wall', '-Wextra', '-Werror'];
const includes = ['-I', path('../../wasm'), '-I', path('../native'), '-I', path('.')];

/**
 * The expressions of a gallery entry, compiled by themselves.
 * @param {GalleryEntry} entry
 * @param {import('../../web/expression/graph.js').Apply} [apply]
 */
export function compileEntry(entry, apply = instantiate().apply) {
  if (entry.kind !== 'parametric' && entry.kind !== 'implicit') throw new RangeError(`no native build of a ${entry.kind}`);
  const implicit = entry.kind === 'implicit';
  const variables = implicit ? ['x', 'y', 'z'] : ['u', 'v'];
  const outputs = implicit ? [entry.f] : [entry.x, entry.y, entry.z];
  const names = implicit ? ['f'] : ['x', 'y', 'z'];
  const compiled = compile({ outputs, names, variables, parameters: { ...entry.parameters }, apply, valueOrder: implicit ? 1 : 0 });
  return { compiled, variableCount: variables.length };
}

/** Whether a file is missing, or older than the solver's sources. @param {string} file */
function isStale(file) {
  const changed = (/** @type {string} */ name) => statSync(name, { throwIfNoEntry: false })?.mtimeMs ?? 0;
  const sources = readdirSync(path('../../wasm')).filter((name) => /\.[ch]$/.test(name));
  return changed(file) < Math.max(...sources.map((name) => changed(path(`../../wasm/${name}`))));
}

/**
 * Builds the native program with some surfaces.
 * @param {string} program its name: each benchmark has its own
 * @param {Record<string, { entry: GalleryEntry, surface: Surface }>} surfaces by C name
 * @param {'native' | 'march'} [build] march: with all instructions of this processor
 */
export function buildNative(program, surfaces, build = 'native') {
  const core = path(`../../build/${build}/core.o`);
  if (isStale(core)) throw new Error(`${core} is missing, or older than wasm/; it is built by: make build/${build}/core.o`);
  const folder = path(`../../build/bench/${program}-${build}/`);
  const sources = writeSources(folder, surfaces);
  const binary = `${folder}native`;
  execFileSync('gcc', [...flags, ...MARCH[build], ...includes, path('native.c'), ...sources, core, '-o', binary]);
  return {
    /** @param {string} name @param {[number[], number[]][]} pairs @param {number} points or, below 1, tolerance @param {number} repetitions @returns {NativeSample} */
    solve: (name, pairs, points, repetitions) =>
      sample(
        binary,
        ['solve', name, points, repetitions],
        pairs.map(([from, to]) => [...from, ...to]),
      ),
    /** From the straight line given as a start. @param {string} name @param {[number[], number[]][]} pairs @param {number} points @param {number} repetitions @param {number} steps at most @returns {NativeSample} */
    solveAtOnce: (name, pairs, points, repetitions, steps) =>
      sample(
        binary,
        ['at-once', name, points, repetitions, steps],
        pairs.map(([from, to]) => [...from, ...to]),
      ),
    /** @param {string} name @param {number[][]} points @param {number} repetitions @returns {NativeSample} */
    evaluate: (name, points, repetitions) => sample(binary, ['evaluate', name, points.length, repetitions], points),
  };
}

/** @param {string} binary @param {(string | number)[]} parameters @param {number[][]} numbers */
function sample(binary, parameters, numbers) {
  const input = `${numbers.length}\n${numbers.map((row) => row.join(' ')).join('\n')}\n`;
  return JSON.parse(execFileSync(binary, parameters.map(String), { input, encoding: 'utf8' }));
}

/**
 * Writes surfaces as C, one file each, and the table of them.
 * @param {string} folder made if it is missing; ends in a slash @param {Record<string, { entry: GalleryEntry, surface: Surface }>} surfaces by C name
 * @returns {string[]} the files
 */
export function writeSources(folder, surfaces) {
  mkdirSync(folder, { recursive: true });
  const texts = Object.entries(surfaces).map(([name, { entry }]) => {
    const { compiled, variableCount } = compileEntry(entry);
    return [name, writeC(compiled, name, variableCount)];
  });
  return [...texts, ['table', writeTable(surfaces)]].map(([name, text]) => {
    writeFileSync(`${folder}${name}.c`, text);
    return `${folder}${name}.c`;
  });
}

/** @param {Record<string, { entry: GalleryEntry, surface: Surface }>} surfaces */
function writeTable(surfaces) {
  const names = Object.keys(surfaces);
  const declarations = names.map(
    (name) => `void ${name}_jet(int32_t, const sp_pair *, sp_pair *);\nvoid ${name}_value(int32_t, const sp_pair *, sp_pair *);`,
  );
  const rows = names.map((name) => `    {"${name}", {${name}_jet, ${name}_value, ${writeRecord(surfaces[name])}}},`);
  return `#include "native.h"

${declarations.join('\n')}

const struct named_surface named_surfaces[] = {
${rows.join('\n')}
};
const int named_surface_count = ${names.length};
`;
}

/** The other fields of struct sp_surface. @param {{ entry: GalleryEntry, surface: Surface }} surface */
function writeRecord({ entry, surface: { domain } }) {
  if (!domain) {
    const bounds = /** @type {[number, number][]} */ (entry.kind === 'implicit' ? entry.bounds : []);
    return `SP_IMPLICIT, 0, {0, 0}, {0, 0}, ${Math.sqrt(bounds.reduce((sum, [low, high]) => sum + (high - low) ** 2, 0))}`;
  }
  const { u, v, periodic } = domain;
  const ends = (/** @type {number} */ k, /** @type {string} */ open) => `{${periodic.u ? open : u[k]}, ${periodic.v ? open : v[k]}}`;
  return `SP_PARAMETRIC, 0, ${ends(0, '-__builtin_inf()')}, ${ends(1, '__builtin_inf()')}, 0`;
}
