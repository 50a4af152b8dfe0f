/* Sharing, folding and simplification in the graph. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { compile, evaluateConstant } from '../../../web/expression/compile.js';
import { solverFunctions } from '../../../web/expression/functions.js';
import { Graph } from '../../../web/expression/graph.js';
import * as Operation from '../../../web/expression/operation.js';
import { plan } from '../../../web/expression/plan.js';
import { SURFACES } from '../../helpers/expressions.js';
import { instantiate } from '../../helpers/wasm.js';

const { apply } = instantiate();

/** @param {(string | number)[]} outputs @param {string[]} variables @param {Record<string, number>} [parameters] */
const build = (outputs, variables, parameters) => compile({ outputs, names: outputs.map(String), variables, parameters, apply });

/** An elementary function is some twenty times an addition. */
const CALL = 20;

/** Operations that are carried out per pair of points. @param {import('../../../web/expression/compile.js').Compiled} compiled */
function liveOperations({ graph, jet }) {
  const { uses } = plan(graph, jet);
  const live = graph.operations.filter((_, id) => uses[id] > 0 && graph.isOperation(id));
  return live.reduce((sum, operation) => sum + (operation < Operation.call ? 1 : CALL), 0);
}

test('the surfaces of the paper need no more operations than they did', () => {
  /** Live operations for values and first and second derivatives; they may only fall. @type {Record<string, number>} */
  const most = {
    saddle: 6,
    paraboloid: 5,
    helicoid: 45,
    cylinder: 42,
    dini: 144,
    threeTori: 151,
    metamorphosis: 259,
    genusTwo: 67,
    torus: 43,
    everything: 876,
  };
  const counted = Object.fromEntries(
    Object.entries(SURFACES).map(([name, { outputs, variables, parameters }]) => [
      name,
      liveOperations(build(outputs, variables, parameters)),
    ]),
  );
  console.log('live operations:', JSON.stringify(counted));
  for (const [name, count] of Object.entries(counted)) assert.ok(count <= most[name], `${name}: ${count} operations, ${most[name]} before`);
});

test('equal expressions are one, however they are written', () => {
  const once = build(['sin(u)*v + sin(u)*v'], ['u', 'v']);
  assert.equal(once.graph.operations.filter((operation) => operation === Operation.call).length, 1);
  const swapped = build(['(u+v)*(v+u)'], ['u', 'v']);
  assert.equal(swapped.graph.operations.filter((operation) => operation === Operation.add).length <= 2, true);
  const graph = new Graph(apply);
  const [u, v] = [graph.variable(0), graph.variable(1)];
  assert.equal(graph.add(u, v), graph.add(v, u));
  assert.equal(graph.minimum(u, v), graph.minimum(v, u));
  assert.notEqual(graph.subtract(u, v), graph.subtract(v, u));
  assert.notEqual(graph.constant(0), graph.constant(-0));
  assert.equal(graph.constant(Number.NaN), graph.constant(Number.NaN));
});

test('the graph grows linearly with the formula', () => {
  const sum = (/** @type {number} */ terms) => Array.from({ length: terms }, (_, k) => `sin(${k + 1}u)*cos(${k + 2}v)`).join('+');
  const sizes = [40, 80, 160].map((terms) => build([sum(terms)], ['u', 'v']).graph.size);
  console.log('nodes of sums of 40, 80, 160 terms:', sizes.join(' '));
  assert.ok(sizes[1] < 2.1 * sizes[0] && sizes[2] < 2.1 * sizes[1]);
  const nested = (/** @type {number} */ depth) => `${'sin('.repeat(depth)}u v${')'.repeat(depth)}`;
  const depths = [15, 30, 60].map((depth) => build([nested(depth)], ['u', 'v']).graph.size);
  console.log('nodes of 15, 30, 60 nested sines:', depths.join(' '));
  assert.ok(depths[1] < 2.1 * depths[0] && depths[2] < 2.1 * depths[1]);
});

test('simplifications', () => {
  const g = new Graph(apply);
  const [u, v] = [g.variable(0), g.variable(1)];
  const minus = g.negate(u);
  const same = /** @type {[string, number, number][]} */ ([
    ['u+0', g.add(u, g.zero), u],
    ['0+u', g.add(g.zero, u), u],
    ['u-0', g.subtract(u, g.zero), u],
    ['0-u', g.subtract(g.zero, u), minus],
    ['u-u', g.subtract(u, u), g.zero],
    ['u*1', g.multiply(u, g.one), u],
    ['u*0', g.multiply(u, g.zero), g.zero],
    ['-1*u', g.multiply(g.constant(-1), u), minus],
    ['--u', g.negate(minus), u],
    ['u+(-v)', g.add(u, g.negate(v)), g.subtract(u, v)],
    ['(-u)+v', g.add(minus, v), g.subtract(v, u)],
    ['u-(-v)', g.subtract(u, g.negate(v)), g.add(u, v)],
    ['(-u)-v', g.subtract(minus, v), g.negate(g.add(u, v))],
    ['-(u-v)', g.negate(g.subtract(u, v)), g.subtract(v, u)],
    ['(-u)*(-v)', g.multiply(minus, g.negate(v)), g.multiply(u, v)],
    ['(-u)*3', g.multiply(minus, g.constant(3)), g.multiply(u, g.constant(-3))],
    ['u/4', g.divide(u, g.constant(4)), g.multiply(u, g.constant(0.25))],
    ['u/-1', g.divide(u, g.constant(-1)), minus],
    ['(-u)/(-v)', g.divide(minus, g.negate(v)), g.divide(u, v)],
    ['|-u|', g.absolute(minus), g.absolute(u)],
    ['u^1', g.power(u, g.one), u],
    ['u^0', g.power(u, g.zero), g.one],
    ['u^0.5', g.power(u, g.constant(0.5)), g.squareRoot(u)],
    ['min(u,u)', g.minimum(u, u), u],
    ['u<v ? u : u', g.select(u, v, u, u), u],
    ['1<2 ? u : v', g.select(g.one, g.constant(2), u, v), u],
  ]);
  for (const [name, actual, expected] of same) assert.equal(actual, expected, name);
});

test('division by what is no power of two stays a division', () => {
  const g = new Graph(apply);
  const u = g.variable(0);
  for (const divisor of [3, 10, 0.1, 0, -0, Infinity, NaN, 5e-324, 1e308]) {
    assert.equal(g.operations[g.divide(u, g.constant(divisor))], Operation.divide, String(divisor));
  }
  for (const divisor of [2, -8, 2 ** -1000, 2 ** 1022]) {
    assert.equal(g.operations[g.divide(u, g.constant(divisor))], Operation.multiply, String(divisor));
  }
});

test('integer powers are few products', () => {
  const products = [2, 3, 4, 8, 15, 64, -2].map((n) => {
    const g = new Graph(apply);
    g.integerPower(g.variable(0), n);
    return g.operations.filter((operation) => operation === Operation.multiply || operation === Operation.divide).length;
  });
  assert.deepEqual(products, [1, 2, 2, 3, 6, 6, 2]);
});

test('powers are products up to the 64th and down to its inverse', () => {
  const isProduct = [64, 65, -64, -65, 2.5].map((n) => {
    const g = new Graph(apply);
    g.power(g.variable(0), g.constant(n));
    return g.operations.every((operation) => operation < Operation.call);
  });
  assert.deepEqual(isProduct, [true, false, true, false, false]);
});

test('constants fold by IEEE arithmetic, functions by the solver alone', () => {
  const value = (/** @type {string} */ source) => evaluateConstant(source, {}, apply);
  const exact = /** @type {[string, number][]} */ ([
    ['0.1+0.2', 0.1 + 0.2],
    ['10^-3', 0.001],
    ['2^64', 2 ** 64],
    ['sqrt(2)', Math.SQRT2],
    ['min(1, 2, -3)', -3],
    ['max(1, 2, -3)', 2],
    ['sign(-2)', -1],
    ['floor(-0.5)', -1],
    ['|-2|', 2],
    ['1/0', Number.POSITIVE_INFINITY],
    ['1/(-0)', Number.NEGATIVE_INFINITY],
    ['sqrt(-1)', Number.NaN],
    ['0^0', 1],
    ['-2*pi', -2 * Math.PI],
    ['cbrt(-8)', -2],
  ]);
  for (const [source, expected] of exact) assert.ok(Object.is(value(source), expected), `${source} = ${value(source)}`);
  solverFunctions.forEach(({ name, arity }, number) => {
    const expected = apply(number, 0.625, 0.375);
    if (Math.abs(expected - apply(number, 0.625, 0)) > 0) assert.equal(arity, 2, name);
    assert.ok(Object.is(value(`${name}(0.625${arity === 2 ? ', 0.375' : ''})`), expected), name);
  });
});

test('folding asks no Math function whose bits differ between engines', () => {
  const asked = /** @type {number[][]} */ ([]);
  const spy = (/** @type {number[]} */ ...call) => asked.push(call) && 0.5;
  const formula = `${solverFunctions.map(({ name, arity }) => `${name}(2${arity === 2 ? ', 3.5' : ''})`).join('+')}+u`;
  compile({ outputs: [formula], names: ['f'], variables: ['u'], apply: spy });
  assert.deepEqual(
    asked.map(([number]) => number).sort((a, b) => a - b),
    solverFunctions.map((_, number) => number),
  );
});
