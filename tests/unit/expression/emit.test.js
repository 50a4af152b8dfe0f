/* The emitted module: the same bits as the graph evaluated in JavaScript, on every surface, in both lanes, for any number of points. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { compile } from '../../../web/expression/compile.js';
import { evaluateGraph } from '../../helpers/evaluate-graph.js';
import { SURFACES } from '../../helpers/expressions.js';
import { createRandom } from '../../helpers/random.js';
import { randomExpression } from '../../helpers/random-expression.js';
import { instantiate } from '../../helpers/wasm.js';

const { apply, link } = instantiate();

/** @param {ArrayLike<number>} actual @param {ArrayLike<number>} expected @param {string} name */
function assertSameBits(actual, expected, name) {
  assert.equal(actual.length, expected.length);
  for (let k = 0; k < actual.length; k++)
    assert.ok(Object.is(actual[k], expected[k]), `${name}, output ${k}: ${actual[k]}, not ${expected[k]}`);
}

/** @param {import('../../../web/expression/compile.js').Compiled} compiled @param {number[][]} points @param {string} name @param {number[]} [parameters] */
function check(compiled, points, name, parameters = [...compiled.data].slice(0, compiled.parameterNames.length)) {
  const linked = link(compiled, points[0].length);
  linked.data().set(parameters);
  const [jets, values] = [linked.jet(points), linked.value(points)];
  points.forEach((point, k) => {
    const nodes = evaluateGraph(compiled.graph, point, parameters, apply);
    const at = `${name} at ${point}, point ${k} of ${points.length}`;
    assertSameBits(
      jets[k],
      compiled.jet.map((id) => nodes[id]),
      `jet of ${at}`,
    );
    assertSameBits(
      values[k],
      compiled.value.map((id) => nodes[id]),
      `value of ${at}`,
    );
  });
}

test('every surface, every number of points, parameters changed afterwards', () => {
  const random = createRandom(3);
  for (const [name, { outputs, names, variables, parameters, box }] of Object.entries(SURFACES)) {
    const compiled = compile({ outputs, names, variables, parameters, apply });
    for (const count of [1, 2, 3, 8, 33]) {
      const points = Array.from({ length: count }, () => box.map(([low, high]) => random.between(low, high)));
      check(compiled, points, name);
      check(
        compiled,
        points,
        name,
        compiled.parameterNames.map(() => random.between(0.5, 1.5)),
      );
    }
  }
});

test('layout: values, then first derivatives by variable, then second', () => {
  const parametric = compile({ outputs: ['u', 'v', 'u^2 v'], names: ['x', 'y', 'z'], variables: ['u', 'v'], apply });
  const surface = link(parametric, 2);
  assert.deepEqual([...surface.jet([[3, 5]])[0]], [3, 5, 45, 1, 0, 30, 0, 1, 9, 0, 0, 10, 0, 0, 6, 0, 0, 0]);
  assert.deepEqual([...surface.value([[3, 5]])[0]], [3, 5, 45]);
  const implicit = link(compile({ outputs: ['x^2 y z'], names: ['f'], variables: ['x', 'y', 'z'], apply }), 3);
  assert.deepEqual([...implicit.jet([[3, 5, 7]])[0]], [315, 210, 63, 45, 70, 42, 30, 0, 9, 0]);
  assert.deepEqual([...implicit.value([[3, 5, 7]])[0]], [315, 210, 63, 45]);
  const values = compile({ outputs: ['x^2 y z'], names: ['f'], variables: ['x', 'y', 'z'], valueOrder: 0, apply });
  assert.deepEqual([...link(values, 3).value([[3, 5, 7]])[0]], [315]);
});

test('no points, or fewer, write nothing', () => {
  const { jet, value } = link(compile({ outputs: ['u'], names: ['f'], variables: ['u'], apply }), 1).functions;
  for (const count of [0, -1, -(2 ** 31)]) {
    jet(count, 2 ** 31, 2 ** 31);
    value(count, 2 ** 31, 2 ** 31);
  }
});

test('one lane does not see the other', () => {
  const { outputs, names, variables, parameters } = SURFACES.everything;
  const linked = link(compile({ outputs, names, variables, parameters, apply }), 2);
  const point = [0.3, -0.7];
  const [alone] = linked.jet([point]);
  for (const other of [
    [NaN, NaN],
    [Infinity, 0],
    [0, 0],
    [1e300, -1e300],
    [1, 2],
  ]) {
    assertSameBits(linked.jet([point, other])[0], alone, `beside ${other}`);
    assertSameBits(linked.jet([other, point])[1], alone, `beside ${other}`);
  }
});

test('awkward numbers through every instruction', () => {
  const awkward = [0, -0, 1, -1, 0.5, -1.5, 2 ** 52, 2 ** 53 + 2, 5e-324, 1e308, Infinity, -Infinity, NaN];
  const points = awkward.flatMap((u) => awkward.map((v) => [u, v]));
  const outputs = [
    'min(u,v)',
    'max(u,v)',
    'floor(u)',
    '|u|',
    'sign(u)',
    'sqrt(u)',
    'u+v',
    'u-v',
    'u*v',
    'u/v',
    '-u',
    'pow(u,v)',
    'atan2(u,v)',
    'sign(u)*floor(v)',
  ];
  check(compile({ outputs, names: outputs, variables: ['u', 'v'], apply }), points, 'instructions');
});

test('300 random formulas', () => {
  const random = createRandom(13);
  for (let k = 0; k < 300; k++) {
    const outputs = [0, 1].map(() => randomExpression(random, 1, ['u', 'v', 'p', 'e']));
    const compiled = compile({ outputs, names: ['x', 'y'], variables: ['u', 'v'], parameters: { p: 1.25 }, apply });
    const points = Array.from({ length: 3 }, () => [random.between(-2, 2), random.between(-2, 2)]);
    check(compiled, points, `seed 13, formula ${k}: ${outputs}`);
  }
});

test('imports are what is used, sines and cosines of one angle or of two are one call', () => {
  const imported = (/** @type {string[]} */ outputs, names = outputs) => {
    const { module } = compile({ outputs, names, variables: ['u', 'v'], apply });
    const called = WebAssembly.Module.imports(new WebAssembly.Module(module)).map(({ name }) => name);
    assert.deepEqual(called.slice(0, 2), ['memory', 'data']);
    return called.slice(2).sort();
  };
  assert.deepEqual(imported(['u', 'v', 'u v']), []);
  assert.deepEqual(imported(['sin(u)']), ['sp_sincos']);
  assert.deepEqual(imported(['tan(u)*exp(v)']), ['sp_exp', 'sp_sincos']);
  assert.deepEqual(imported(['sin(u)*cos(v)*exp(u)']), ['sp_exp', 'sp_sincos_two']);
  assert.deepEqual(imported(['tan(u/2)*tan(3*v)*sin(u+v)']), ['sp_sincos', 'sp_sincos_two']);
  // One angle needs the sine of the other.
  assert.deepEqual(imported(['sin(u+cos(v))']), ['sp_sincos']);
  assert.deepEqual(imported(['sin(u)', 'cos(v)', '0'], ['x', 'y', 'z']), ['sp_cos', 'sp_sin', 'sp_sincos_two']);
});

test('the data block: parameters in the order of their keys, constants, room for scratch', () => {
  const parameters = { R: 3, a: 0.5, unused: 7 };
  const compiled = compile({
    outputs: ['R cos(u)', 'a sin(u)', '0.3*v'],
    names: ['x', 'y', 'z'],
    variables: ['u', 'v'],
    parameters,
    apply,
  });
  assert.deepEqual(compiled.parameterNames, ['R', 'a', 'unused']);
  assert.deepEqual([...compiled.data.subarray(0, 3)], [3, 0.5, 7]);
  assert.deepEqual([...compiled.data.subarray(3)].sort(), [0, 0.3]);
  assert.ok(compiled.dataBytes % 16 === 0 && compiled.dataBytes >= compiled.data.byteLength + 16);
});

test('constants and parameters alone', () => {
  check(
    compile({ outputs: ['2', 'p', 'sin(p)+cos(p)*sqrt(p)'], names: ['x', 'y', 'z'], variables: ['u', 'v'], parameters: { p: 0.7 }, apply }),
    [
      [1, 2],
      [3, 4],
      [5, 6],
    ],
    'constant',
  );
});

test('the largest formulas compile', () => {
  const largest = [
    Array.from({ length: 270 }, (_, k) => `sin(u+${k}v)`).join('*'),
    Array.from({ length: 390 }, (_, k) => `sin(u)^${(k % 60) + 2}`)
      .join('+')
      .slice(0, 4090)
      .replace(/[^\d)]*$/, ''),
    `${'sin(u*cos(v+'.repeat(32)}u${'))'.repeat(32)}`,
    Array(999).fill('u').join('^'),
    Array.from({ length: 150 }, (_, k) => `(u+${k}v)/(v-${k}u)`).join('*'),
  ];
  for (const source of largest) {
    const start = performance.now();
    const compiled = compile({ outputs: [source, 'u+v', 'v*u'], names: ['x', 'y', 'z'], variables: ['u', 'v'], apply });
    const linked = link(compiled, 2);
    const time = performance.now() - start;
    console.log(`${source.slice(0, 24)}…: ${compiled.graph.size} nodes, ${compiled.module.length} bytes, ${time.toFixed(1)} ms`);
    assertSameBits(linked.value([[0.3, 0.4]])[0].slice(1), [0.7, 0.12], 'value');
  }
});
