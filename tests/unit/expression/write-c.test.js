/* Surfaces written as C and compiled natively give the bits of the WebAssembly module. */

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { compile } from '../../../web/expression/compile.js';
import { SURFACES } from '../../helpers/expressions.js';
import { createRandom } from '../../helpers/random.js';
import { instantiate } from '../../helpers/wasm.js';
import { writeC } from '../../helpers/write-c.js';

const { apply, link } = instantiate();
const root = fileURLToPath(new URL('../../../', import.meta.url));
const folder = mkdtempSync(join(tmpdir(), 'surfpath-'));
after(() => rmSync(folder, { recursive: true }));

const FLAGS = '-std=c17 -O2 -Wall -Wextra -Wconversion -Wdouble-promotion -Werror -ffp-contract=off'.split(' ');
const INCLUDES = ['-I', join(root, 'wasm'), '-I', join(root, 'tests/native')];
const functions = readdirSync(join(root, 'wasm'))
  .filter((name) => /^functions.*\.c$/.test(name))
  .map((name) => compileC(join(root, 'wasm', name), name));

/** @param {string} source path @param {string} name @returns {string} path of the object */
function compileC(source, name) {
  const object = join(folder, `${name}.o`);
  execFileSync('gcc', [...FLAGS, ...INCLUDES, '-c', source, '-o', object]);
  return object;
}

/** Reads pairs of points from standard input and writes jets, then values, to standard output, as raw doubles. @param {string} name @param {[number, number, number]} widths */
const program = (name, [inputs, jet, value]) => `#include <stdio.h>
static sp_pair input[64 * ${inputs}], output[64 * ${jet + value}];
int main(void) {
    int32_t count = (int32_t)(fread(input, 16, sizeof input / 16, stdin) / ${inputs});
    ${name}_jet(count, input, output);
    ${name}_value(count, input, output + ${jet} * count);
    fwrite(output, 16, (size_t)count * ${jet + value}, stdout);
    return 0;
}
`;

/** Point k of an array of pairs. @param {Float64Array} numbers @param {number} k @param {number} width */
const pick = (numbers, k, width) => Array.from({ length: width }, (_, j) => numbers[2 * (width * (k >> 1) + j) + (k & 1)]);

/**
 * Builds the surface as C and runs it.
 * @param {string} name
 * @param {import('../../../web/expression/compile.js').Compiled} compiled
 * @param {number[][]} points
 * @returns {{ jets: number[][], values: number[][] }}
 */
function runNatively(name, compiled, points) {
  const inputs = points[0].length;
  const file = join(folder, `${name}.c`);
  const [jet, value] = [compiled.jet.length, compiled.value.length];
  writeFileSync(file, writeC(compiled, name, inputs) + program(name, [inputs, jet, value]));
  execFileSync('gcc', [compileC(file, name), ...functions, '-o', join(folder, name)]);
  const input = new Float64Array(points.length * inputs);
  for (const [k, point] of points.entries()) {
    for (let j = 0; j < inputs; j++) input[2 * (inputs * (k >> 1) + j) + (k & 1)] = point[j];
  }
  const bytes = execFileSync(join(folder, name), { input: new Uint8Array(input.buffer) });
  const output = new Float64Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
  assert.equal(output.length, points.length * (jet + value));
  return {
    jets: points.map((_, k) => pick(output, k, jet)),
    values: points.map((_, k) => pick(output.subarray(points.length * jet), k, value)),
  };
}

test('bit for bit', () => {
  const random = createRandom(17);
  for (const [name, surface] of Object.entries(SURFACES)) {
    const compiled = compile({ ...surface, apply });
    const points = Array.from({ length: 64 }, () => surface.box.map(([low, high]) => random.between(low, high)));
    const linked = link(compiled, surface.variables.length);
    const native = runNatively(name, compiled, points);
    const plain = (/** @type {Float64Array[]} */ results) => results.map((numbers) => [...numbers]);
    assert.deepEqual(native.jets, plain(linked.jet(points)), `seed 17: jets of ${name}`);
    assert.deepEqual(native.values, plain(linked.value(points)), `seed 17: values of ${name}`);
  }
});
