/* Formulas written for one side of each crease: there they are the formulas themselves, and beyond they go on as the branch that was chosen. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { compile } from '../../../web/expression/compile.js';
import { Creases } from '../../../web/expression/creases.js';
import { parse } from '../../../web/expression/parse.js';
import { evaluateDual } from '../../helpers/dual.js';
import { evaluateGraph } from '../../helpers/evaluate-graph.js';
import { createRandom } from '../../helpers/random.js';
import { instantiate } from '../../helpers/wasm.js';

const { apply } = instantiate();
const VARIABLES = ['u', 'v'];
const SEED = 13;
/** Sums of products round, in another order here and there. */
const ROUNDING = 1e-11;

/** @param {string} source @param {Creases} creases */
const compiled = (source, creases) => compile({ outputs: [source], names: ['f'], variables: VARIABLES, apply, creases });

/** f, f_u, f_v, f_uu, f_uv, f_vv on given sides. @param {string} source @param {number[]} sides @param {number[]} point */
function onSides(source, sides, point) {
  const { graph, jet } = compiled(source, new Creases({ sides }));
  const values = evaluateGraph(graph, point, [], apply);
  return jet.map((id) => values[id]);
}

/** What vanishes on each crease, there. @param {string} source @param {number[]} point */
function vanishing(source, point) {
  const creases = new Creases();
  const { graph } = compiled(source, creases);
  const values = evaluateGraph(graph, point, [], apply);
  return creases.nodes.map((node) => values[node]);
}

/** The same derivatives by dual numbers. @param {string} source @param {number[]} point */
function byDual(source, point) {
  const names = new Map(VARIABLES.map((name, value) => [name, /** @type {const} */ ({ kind: 'variable', value })]));
  const { value, gradient, hessian } = evaluateDual(parse(source, names), point);
  return [value, ...gradient, hessian[0][0], hessian[0][1], hessian[1][1]];
}

/** @param {number[]} actual @param {number[]} expected @param {string} what */
function assertNear(actual, expected, what) {
  assert.equal(actual.length, expected.length);
  const size = Math.max(1, ...expected.map(Math.abs));
  for (const [k, value] of actual.entries())
    assert.ok(Math.abs(value - expected[k]) <= ROUNDING * size, `${what}, derivative ${k}: ${value}, expected ${expected[k]}`);
}

/** A side that was drawn, but where a formula is a number: then that is its sign. @param {string} chosen @param {number} side */
function sideOf(chosen, side) {
  const { graph, jet } = compiled(chosen, new Creases());
  return Math.sign(graph.numberOf(jet[0])) || side;
}

/**
 * A formula full of creases, and the same on sides that are drawn, written by hand; factors: of a product, so written.
 * @param {import('../../helpers/random.js').Random} random @param {number} depth
 * @returns {{ source: string, sides: number[], chosen: string, factors: string[] }}
 */
function drawFormula(random, depth) {
  if (depth === 0) {
    const source = random.pick(['u', 'v', 'u*v', '(u-v/2)', 'sin(u+v)', '(v^2-0.3)', 'exp(u/2)', `(${random.between(-1, 1)}+u)`]);
    return { source, sides: [], chosen: source, factors: source === 'u*v' ? ['u', 'v'] : [source] };
  }
  const operands = (/** @type {number} */ count) => Array.from({ length: count }, () => drawFormula(random, depth - 1));
  const draw = () => random.pick([1, -1]);
  const name = random.pick(['abs', 'sign', 'min', 'max', 'add', 'multiply']);
  if (name === 'add' || name === 'multiply') {
    const [a, b] = operands(2);
    const write = (/** @type {string} */ x, /** @type {string} */ y) => (name === 'add' ? `(${x}+${y})` : `(${x})*(${y})`);
    const chosen = write(a.chosen, b.chosen);
    const factors = name === 'add' ? [chosen] : [...a.factors, ...b.factors];
    return { source: write(a.source, b.source), sides: [...a.sides, ...b.sides], chosen, factors };
  }
  if (name === 'abs' || name === 'sign') {
    const [a] = operands(1);
    /* The sign, or the size, of a product is that of its factors. */
    const own = a.factors.map(draw);
    const taken = a.factors.map((factor, k) => `(${sideOf(factor, own[k])}${name === 'sign' ? '' : `*(${factor})`})`);
    const chosen = taken.join('*');
    return { source: `${name}(${a.source})`, sides: [...a.sides, ...own], chosen, factors: [chosen] };
  }
  const all = operands(2 + random.integer(2));
  const own = all.slice(1).map(draw);
  /* One after the other: on side 1 the first of two is larger. */
  const chosen = all.reduce((one, other, k) =>
    sideOf(`(${one.chosen})-(${other.chosen})`, own[k - 1]) > 0 === (name === 'max') ? one : other,
  ).chosen;
  return {
    source: `${name}(${all.map(({ source }) => source).join(', ')})`,
    sides: [...all.flatMap(({ sides }) => sides), ...own],
    chosen,
    factors: [chosen],
  };
}

test(`written for the sides that hold at a point, a formula is itself there, with first and second derivatives, seed ${SEED}`, () => {
  const random = createRandom(SEED);
  let compared = 0;
  for (let k = 0; k < 600; k++) {
    const { source } = drawFormula(random, 1 + random.integer(3));
    const point = [random.between(-1, 1), random.between(-1, 1)];
    const values = vanishing(source, point);
    if (values.length === 0 || values.some((value) => !(Math.abs(value) > 1e-9))) continue;
    assertNear(onSides(source, values.map(Math.sign), point), byDual(source, point), `formula ${k}: ${source} at ${point}`);
    compared++;
  }
  assert.ok(compared > 200, `only ${compared} were compared`);
});

test(`on sides that are drawn, it is the branch written by hand, wherever the point lies, seed ${SEED}`, () => {
  const random = createRandom(SEED);
  let beyond = 0;
  for (let k = 0; k < 600; k++) {
    const { source, sides, chosen } = drawFormula(random, 1 + random.integer(3));
    const point = [random.between(-1, 1), random.between(-1, 1)];
    const values = vanishing(source, point);
    assert.equal(values.length, sides.length, source);
    assertNear(onSides(source, sides, point), byDual(chosen, point), `formula ${k}: ${source} on ${sides} at ${point}, by hand ${chosen}`);
    beyond += Number(values.some((value, i) => value * sides[i] < 0));
  }
  assert.ok(beyond > 200, `only ${beyond} points lie beyond a crease`);
});

test('beyond a crease the side goes on, to the bit', () => {
  assert.deepEqual(onSides('abs(u)', [1], [-0.3, 0]), [-0.3, 1, 0, 0, 0, 0]);
  assert.deepEqual(onSides('max(0, u)', [-1], [-0.3, 0]), [-0.3, 1, 0, 0, 0, 0]);
  assert.deepEqual(onSides('sign(u)*v', [-1], [2, 3]), [-3, 0, -1, 0, 0, 0]);
  assert.deepEqual(onSides('min(u, v, 2)', [1, 1], [-5, -7]).slice(0, 1), [2]);
});

test('rounded, |g| is √(g² + w²), of which min and max are made, and sign rises on the side that the sign of w tells, with first and second derivatives', () => {
  const creases = new Creases({ widths: [0, 1, 2, 3] });
  const { graph, jet, data } = compiled('abs(u) + sign(v) + max(u, v^2) - min(u*v, 0.3)', creases);
  for (const side of [1, -1]) {
    const widths = [0.3, side * 0.2, 0.4, 0.1];
    assert.ok(data.length >= widths.length);
    const point = [0.2, -0.4];
    const values = evaluateGraph(graph, point, widths, apply);
    const rounded = (/** @type {string} */ g, /** @type {number} */ w) => `sqrt((${g})^2 + ${w * w})`;
    const risen = `((1 + ${side}*v/${rounded('v', 0.2)})/2)^4`;
    const byHand = `${rounded('u', 0.3)} + ${side}*(2*${risen} - 1) + (u + v^2 + ${rounded('u - v^2', 0.4)})/2 - (u*v + 0.3 - ${rounded('u*v - 0.3', 0.1)})/2`;
    const actual = jet.map((id) => values[id]);
    assertNear(actual, byDual(byHand, point), 'rounded');
  }
});
