/* Derivatives, operator by operator at awkward arguments, against second-order dual numbers and against finite differences. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { compile } from '../../../web/expression/compile.js';
import { solverFunctions } from '../../../web/expression/functions.js';
import { differentiateNodes } from '../../../web/expression/nodes.js';
import { parse } from '../../../web/expression/parse.js';
import { evaluateDual, evaluateNumber } from '../../helpers/dual.js';
import { evaluateGraph } from '../../helpers/evaluate-graph.js';
import { SURFACES } from '../../helpers/expressions.js';
import { createRandom } from '../../helpers/random.js';
import { randomExpression } from '../../helpers/random-expression.js';
import { instantiate } from '../../helpers/wasm.js';

const { apply } = instantiate();
const VARIABLES = ['u', 'v'];

/** @type {Map<string, import('../../../web/expression/parse.js').Meaning>} */
const scope = new Map([
  ['u', { kind: 'variable', value: 0 }],
  ['v', { kind: 'variable', value: 1 }],
  ['p', { kind: 'parameter', value: 0 }],
  ['pi', { kind: 'number', value: Math.PI }],
  ['e', { kind: 'number', value: Math.E }],
]);

/** f, f_u, f_v, f_uu, f_uv, f_vv by the graph. @param {string} source @param {number[]} point @param {number} [p] */
function byGraph(source, point, p = 2) {
  const { graph, jet } = compile({ outputs: [source], names: ['f'], variables: VARIABLES, parameters: { p }, apply });
  const values = evaluateGraph(graph, point, [p], apply);
  return jet.map((id) => values[id]);
}

/** The same by differentiating nodes, then those of f_u twice: f_uuu, f_uuv, f_uvv. @param {string} source @param {number[]} point @param {number} [p] */
function byNodes(source, point, p = 2) {
  const { graph, value } = compile({
    outputs: ({ read, slope }) => {
      const node = read(source, 'f', VARIABLES);
      return [node, slope(node, 'u')];
    },
    names: ['f', 'f_u'],
    variables: VARIABLES,
    parameters: { p },
    apply,
  });
  const [jet, next] = differentiateNodes(graph, value, 2, 2);
  const values = evaluateGraph(graph, point, [p], apply);
  return [jet.value, ...jet.first, ...jet.second, ...next.second].map((id) => values[id]);
}

/** The same by dual numbers. @param {string} source @param {number[]} point @param {number} [p] */
function byDual(source, point, p = 2) {
  const { value, gradient, hessian } = evaluateDual(parse(source, scope), point, [p]);
  return [value, ...gradient, hessian[0][0], hessian[0][1], hessian[1][1]];
}

/**
 * Central differences of a function of one number, extrapolated to step 0 (Richardson): first and second derivative.
 * @param {(t: number) => number} f
 * @param {number} step
 */
function differences(f, step) {
  const [first, second] = [
    (/** @type {number} */ h) => (f(h) - f(-h)) / (2 * h),
    (/** @type {number} */ h) => (f(h) - 2 * f(0) + f(-h)) / (h * h),
  ];
  return [first, second].map((derivative) => {
    let row = [0, 1, 2, 3].map((k) => derivative(step / 2 ** k));
    for (let order = 1; order < 4; order++) row = row.slice(1).map((fine, k) => fine + (fine - row[k]) / (4 ** order - 1));
    return row[0];
  });
}

/** The same by finite differences along u, v and u + v. @param {string} source @param {number[]} point @param {number} step @param {number} [p] */
function byDifferences(source, [u, v], step, p = 2) {
  const program = parse(source, scope);
  const along = (/** @type {number} */ a, /** @type {number} */ b) =>
    differences((t) => evaluateNumber(program, [u + a * t, v + b * t], [p]), step);
  const [[fu, fuu], [fv, fvv], [, both]] = [along(1, 0), along(0, 1), along(1, 1)];
  return [evaluateNumber(program, [u, v], [p]), fu, fv, fuu, (both - fuu - fvv) / 2, fvv];
}

/** @param {number[]} actual @param {number[]} expected @param {number} tolerance relative to the larger of 1 and the expected @param {string} what */
function assertNear(actual, expected, tolerance, what) {
  assert.equal(actual.length, expected.length);
  for (const [k, value] of actual.entries()) {
    const near = Math.abs(value - expected[k]) <= tolerance * Math.max(1, Math.abs(expected[k]));
    assert.ok(near, `${what}, derivative ${k}: ${value}, expected ${expected[k]}`);
  }
}

/** Smooth functions, and arguments where a careless rule fails. @type {[string, number[][]][]} */
const SMOOTH = [
  ['u+v', [[1, 2]]],
  ['u-v', [[1, 2]]],
  [
    'u*v',
    [
      [0, 0],
      [3, -2],
    ],
  ],
  ['u*u', [[0, 1]]],
  [
    'u/v',
    [
      [0, 2],
      [3, -0.5],
      [-1, 7],
    ],
  ],
  ['3/v', [[0, 2]]],
  ['u/3', [[0, 2]]],
  ['u/p', [[0, 2]]],
  ['-u', [[0, 0]]],
  [
    'u^2',
    [
      [0, 0],
      [-3, 0],
      [1e3, 0],
    ],
  ],
  [
    'u^3',
    [
      [0, 0],
      [-2, 0],
    ],
  ],
  [
    'u^7',
    [
      [0, 0],
      [-1.5, 0],
    ],
  ],
  [
    'u^-1',
    [
      [-2, 0],
      [0.5, 0],
    ],
  ],
  [
    'u^-3',
    [
      [-2, 0],
      [0.5, 0],
    ],
  ],
  ['u^0', [[0, 0]]],
  ['u^1', [[0, 0]]],
  [
    '(u v)^2',
    [
      [0, 0],
      [0, 3],
      [-1, 2],
    ],
  ],
  [
    'pow(u, 3)',
    [
      [-2, 0],
      [0, 0],
    ],
  ],
  [
    'pow(u, 2.5)',
    [
      [0.5, 0],
      [3, 0],
    ],
  ],
  [
    'u^p',
    [
      [0, 0],
      [2, 0],
      [-2, 0],
    ],
  ],
  [
    '(u-v)^p',
    [
      [1, 1],
      [3, -1],
    ],
  ],
  [
    'u^100',
    [
      [0, 0],
      [-1.01, 0],
    ],
  ],
  ['u^0.5', [[2, 0]]],
  [
    '2^u',
    [
      [0, 0],
      [-3, 0],
    ],
  ],
  [
    'p^(u v)',
    [
      [0, 0],
      [0.5, -2],
    ],
  ],
  [
    'pow(u, v)',
    [
      [2, 3],
      [0.5, -1],
      [1, 0],
      [3, 0.5],
    ],
  ],
  [
    '(u^2+1)^(v+u)',
    [
      [0, 0],
      [0.5, 1],
    ],
  ],
  [
    '√u',
    [
      [4, 0],
      [0.3, 0],
    ],
  ],
  [
    'sqrt(u^2+v^2)',
    [
      [3, 4],
      [0, 1],
      [-2, 0],
    ],
  ],
  [
    'cbrt(u)',
    [
      [8, 0],
      [-0.7, 0],
    ],
  ],
  [
    'exp(u v)',
    [
      [0, 0],
      [1, -2],
    ],
  ],
  [
    'exp(-u^2)',
    [
      [0, 0],
      [3, 0],
    ],
  ],
  [
    'ln(u)',
    [
      [0.5, 0],
      [3, 0],
    ],
  ],
  [
    'log(1+u^2)',
    [
      [0, 0],
      [-2, 0],
    ],
  ],
  [
    'sin(u)',
    [
      [0, 0],
      [1.5707963267948966, 0],
      [-4, 0],
    ],
  ],
  [
    'cos(u)',
    [
      [0, 0],
      [1.5707963267948966, 0],
      [-4, 0],
    ],
  ],
  [
    'sin(u v)*cos(u v)',
    [
      [0, 0],
      [2, 1],
    ],
  ],
  [
    'tan(u)',
    [
      [0, 0],
      [1.2, 0],
      [-1.2, 0],
    ],
  ],
  [
    'tan(v/2)*tan(0.5*(u+v))',
    [
      [0, 1],
      [1.2, 2.4],
      [-1.2, -2],
    ],
  ],
  [
    'asin(u)',
    [
      [0, 0],
      [0.7, 0],
      [-0.7, 0],
    ],
  ],
  [
    'acos(u)',
    [
      [0, 0],
      [0.7, 0],
      [-0.7, 0],
    ],
  ],
  [
    'atan(u)',
    [
      [0, 0],
      [2, 0],
      [-40, 0],
    ],
  ],
  [
    'atan2(u, v)',
    [
      [0, 1],
      [1, 0],
      [-1, 0],
      [1, 1],
      [-2, -3],
      [1, -2],
    ],
  ],
  [
    'atan2(v, 2)',
    [
      [0, 0],
      [0, 5],
    ],
  ],
  [
    'atan2(2, u)',
    [
      [0, 0],
      [-3, 0],
    ],
  ],
  [
    'sinh(u)',
    [
      [0, 0],
      [2, 0],
      [-2, 0],
    ],
  ],
  [
    'cosh(u)',
    [
      [0, 0],
      [2, 0],
      [-2, 0],
    ],
  ],
  [
    'tanh(u)',
    [
      [0, 0],
      [1, 0],
      [-9, 0],
    ],
  ],
  [
    'log2(u)',
    [
      [0.5, 0],
      [3, 0],
    ],
  ],
  [
    'log10(1+u^2)',
    [
      [0, 0],
      [-2, 0],
    ],
  ],
  [
    'asinh(u)',
    [
      [0, 0],
      [0.7, 0],
      [-40, 0],
    ],
  ],
  [
    'acosh(u)',
    [
      [1.5, 0],
      [40, 0],
    ],
  ],
  [
    'atanh(u)',
    [
      [0, 0],
      [0.7, 0],
      [-0.7, 0],
    ],
  ],
  [
    'hypot(u, v)',
    [
      [3, 4],
      [0, 1],
      [-2, 0],
    ],
  ],
  ['hypot(u, 2)', [[0, 0]]],
  [
    'hypot(u v, u, v)',
    [
      [3, 4],
      [-1, 0.5],
    ],
  ],
  ['hypot(u)', [[-3, 0]]],
  [
    '|u|',
    [
      [2, 0],
      [-3, 0],
    ],
  ],
  [
    '|u v|^3',
    [
      [2, 1],
      [-3, 1],
    ],
  ],
  [
    'min(u, v)',
    [
      [1, 2],
      [2, 1],
    ],
  ],
  [
    'max(u^2, v^2, 1)',
    [
      [1.5, 2],
      [3, 1],
      [0.1, 0.2],
    ],
  ],
  [
    'min(u^2, 3)',
    [
      [1.5, 2],
      [3, 1],
    ],
  ],
  [
    'sign(u)*v^2',
    [
      [2, 3],
      [-2, 3],
    ],
  ],
  [
    'floor(u)*v^2',
    [
      [0.5, 3],
      [-0.5, 3],
    ],
  ],
];

test('every function of the solver has points to be tried at', () => {
  for (const { name } of solverFunctions)
    assert.ok(
      SMOOTH.some(([source]) => source.includes(`${name}(`)),
      name,
    );
});

test('every operator against dual numbers', () => {
  for (const [source, points] of SMOOTH) {
    for (const point of points) {
      const [actual, expected] = [byGraph(source, point), byDual(source, point)];
      // Both round: a few ulp, more where a difference cancels.
      assertNear(actual, expected, 2e-14, `${source} at ${point}`);
    }
  }
});

test('nodes that are in the graph already against dual numbers, and their third derivatives against finite differences', () => {
  for (const [source, points] of SMOOTH) {
    for (const point of points) {
      const actual = byNodes(source, point);
      assertNear(actual.slice(0, 6), byDual(source, point), 2e-14, `${source} at ${point}`);
      const along = (/** @type {number} */ k, /** @type {number} */ t) => byGraph(source, [point[0] + t, point[1]])[k];
      const third = [3, 4, 5].map((k) => differences((t) => along(k, t), 0.006)[0]);
      // As below; the second derivatives are exact, so only one difference is taken.
      assertNear(actual.slice(6), third, 1e-8, `third derivatives of ${source} at ${point}`);
    }
  }
});

test('every operator against finite differences', () => {
  for (const [source, points] of SMOOTH) {
    for (const point of points) {
      const step = 0.006 * Math.max(1, Math.abs(point[0]) * 0.05);
      const [actual, expected] = [byGraph(source, point), byDifferences(source, point, step)];
      // Smallest step 0.006/8: rounding gives 4 * 2^-53 / 0.00075² = 8e-10, and the extrapolation enlarges it.
      assertNear(actual, expected, 1e-8, `${source} at ${point}`);
    }
  }
});

test('finite where the true derivative is', () => {
  /** Source, point, expected f f_u f_v f_uu f_uv f_vv, parameter. @type {[string, number[], number[], number?][]} */
  const awkward = [
    ['|u|', [0, 0], [0, 0, 0, 0, 0, 0]],
    ['|u|', [-0, 0], [0, 0, 0, 0, 0, 0]],
    ['sign(u)', [0, 0], [0, 0, 0, 0, 0, 0]],
    ['floor(u)', [2, 0], [2, 0, 0, 0, 0, 0]],
    ['tanh(u)', [1000, 0], [1, 0, 0, 0, 0, 0]],
    ['tanh(u)', [-1000, 0], [-1, 0, 0, 0, 0, 0]],
    ['atan(u)', [1e200, 0], [Math.PI / 2, 0, 0, 0, 0, 0]],
    ['asinh(u)', [-1e200, 0], [-Math.asinh(1e200), 1e-200, 0, 0, 0, 0]],
    ['acosh(u)', [1e200, 0], [Math.acosh(1e200), 1e-200, 0, 0, 0, 0]],
    ['log2(u)', [2 ** 900, 0], [900, 2 ** -900 / Math.LN2, 0, 0, 0, 0]],
    ['log10(u)', [1e300, 0], [300, 1e-300 / Math.LN10, 0, 0, 0, 0]],
    ['hypot(u, v)', [3e200, 4e200], [5e200, 0.6, 0.8, 0, 0, 0]],
    ['hypot(u, v)', [3, 4], [5, 0.6, 0.8, 0.128, -0.096, 0.072]],
    ['hypot(u)', [0, 0], [0, 0, 0, 0, 0, 0]],
    ['hypot(u, 0)', [1e-310, 0], [1e-310, 1, 0, 0, 0, 0]],
    // Where some operands are 0, on a sphere's axis and a rounded box's faces; a length that is 0 has no slope, that of it and the rest has.
    ['hypot(u, v, 2)', [0, 0], [2, 0, 0, 0.5, 0, 0.5]],
    ['hypot(2, hypot(u, v), 0)', [0, 0], [2, 0, 0, 0.5, 0, 0.5]],
    ['hypot(u, 0, v, 4, 3)', [0, 0], [5, 0, 0, 0.2, 0, 0.2]],
    ['hypot(max(|u| - 1, 0), max(|v| - 1, 0), 2)', [0.3, 0.2], [2, 0, 0, 0, 0, 0]],
    ['exp(-u^2)', [1e4, 0], [0, 0, 0, 0, 0, 0]],
    ['pow(u, p)', [0, 0], [0, 1, 0, 0, 0, 0], 1],
    ['pow(u, p)', [0, 0], [1, 0, 0, 0, 0, 0], 0],
    ['pow(u, p)', [0, 0], [0, 0, 0, 2, 0, 0], 2],
    ['pow(u, p)', [-3, 0], [9, -6, 0, 2, 0, 0], 2],
    ['pow(u, p)', [0, 0], [0, 0, 0, 0, 0, 0], 3],
    ['u^v', [0, 3], [0, 0, 0, 0, 0, 0]],
    ['u^v', [0, 2], [0, 0, 0, 2, 0, 0]],
    ['u^v', [1, 0], [1, 0, 0, 0, 1, 0]],
    ['atan2(u, v)', [0, -2], [Math.PI, -0.5, 0, 0, -0.25, 0]],
    ['atan2(u, v)', [3, 0], [Math.PI / 2, 0, -1 / 3, 0, 1 / 9, 0]],
    ['min(u, v)', [1, 1], [1, 0, 1, 0, 0, 0]],
    ['max(u, v)', [1, 1], [1, 0, 1, 0, 0, 0]],
    // Beside a piece of a root the root of 0, which is flat.
    ['sqrt(max(0, 1 - u^2 - v^2))', [1.1, 1.1], [0, 0, 0, 0, 0, 0]],
    ['u v + 3 max(-u, min(0, v - 1)^2 - 2, 0)^p', [1, 2], [2, 2, 1, 0, 1, 0], 0.5],
    ['sqrt(3 max(0, u v)/e - max(0, u v)^3)', [-1, 1], [0, 0, 0, 0, 0, 0]],
    ['cbrt(min(0, u))', [1, 0], [0, 0, 0, 0, 0, 0]],
    ['acos(u)', [0, 0], [Math.PI / 2, -1, 0, 0, 0, 0]],
    ['1/(1+exp(u))', [700, 0], [0, 0, 0, 0, 0, 0]],
    ['cosh(u)', [0, 0], [1, 0, 0, 1, 0, 0]],
  ];
  for (const [source, point, expected, p] of awkward) {
    assertNear(byGraph(source, point, p), expected, 1e-15, `${source} at ${point}`);
    assertNear(byNodes(source, point, p).slice(0, 6), expected, 1e-15, `nodes of ${source} at ${point}`);
  }
});

test('not finite where the true derivative is not', () => {
  for (const [source, first] of /** @type {[string, number][]} */ ([
    ['sqrt(u)', Infinity],
    ['cbrt(u)', Infinity],
    ['ln(u)', Infinity],
    ['1/u', -Infinity],
    ['log2(u)', Infinity],
    ['acosh(1+u)', Infinity],
    ['atanh(1-u)', -Infinity],
  ])) {
    const [, fu, fv, fuu] = byGraph(source, [0, 0]);
    assert.equal(fu, first, source);
    assert.ok(!Number.isFinite(fuu), source);
    assert.ok(fv === 0, source);
  }
  assert.ok(byGraph('sqrt(u)', [-1, 0]).slice(0, 2).every(Number.isNaN));
});

test('1,000 random formulas against dual numbers', () => {
  const random = createRandom(11);
  let compared = 0;
  for (let k = 0; k < 1000; k++) {
    const source = randomExpression(random, 1, ['u', 'v', 'p']);
    const point = [random.between(-2, 2), random.between(-2, 2)];
    const [actual, expected] = [byGraph(source, point), byDual(source, point)];
    const scale = Math.max(1, ...expected.map(Math.abs));
    if (!(scale < 1e6)) continue;
    compared++;
    // Relative to the largest derivative: cancellation in sums of terms of that size.
    assertNear(
      actual.map((value) => value / scale),
      expected.map((value) => value / scale),
      1e-11,
      `seed 11, formula ${k}: ${source} at ${point}`,
    );
  }
  assert.ok(compared > 400, `only ${compared} were finite`);
});

test('three variables: order and symmetry of the second derivatives', () => {
  const { outputs, variables, parameters, box } = SURFACES.genusTwo;
  const { graph, jet } = compile({ outputs, names: ['f'], variables, parameters, apply });
  const names = new Map(variables.map((name, value) => [name, /** @type {const} */ ({ kind: 'variable', value })]));
  const program = parse(outputs[0], names);
  const random = createRandom(5);
  for (let k = 0; k < 100; k++) {
    const point = box.map(([low, high]) => random.between(low, high));
    const values = evaluateGraph(graph, point, [], apply);
    const { value, gradient, hessian } = evaluateDual(program, point);
    const expected = [value, ...gradient, ...[0, 1, 2].flatMap((i) => hessian[i].slice(i))];
    assert.equal(jet.length, 10);
    assertNear(
      jet.map((id) => values[id]),
      expected,
      1e-12,
      `seed 5, ${point}`,
    );
  }
});
