// Why there is nothing to draw, and where a measure of length is none.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { meshOf } from '../../../demo/compute/drawable.js';
import { shade } from '../../../demo/compute/shade.js';
import { load } from 'surfpath';
import { gallery } from 'surfpath/gallery';

const surfpath = await load();
const SQUARE = { u: [-1, 1], v: [-1, 1] };
const BOX = { bounds: [1, 2, 3].map(() => [-1.5, 1.5]) };

/** @param {any} definition */
function open(definition) {
  const surface = surfpath.surface(definition);
  const drawn = definition.kind === 'metric' ? surfpath.parametric({ x: 'u', y: 'v', z: 0, ...definition }) : surface;
  return { surface, drawn, definition };
}

for (const [what, definition, words] of /** @type {[string, any, RegExp][]} */ ([
  ['a point', { kind: 'parametric', x: 0, y: 0, z: 0, ...SQUARE }, /a point or a curve/],
  ['a line', { kind: 'parametric', x: 'u', y: 'u', z: 'u', ...SQUARE }, /a point or a curve/],
  ['an axis', { kind: 'revolution', r: '0', z: 't', t: [0, 1] }, /a point or a curve/],
  ['a centreline', { kind: 'tube', centreline: ['cos(t)', 'sin(t)', 't'], radius: '0', t: [0, 3] }, /a point or a curve/],
  ['what is too large but on a line', { kind: 'graph', z: '1e30*x', x: [-2, 2], y: [-2, 2] }, /too large to draw/],
  ['nothing', { kind: 'parametric', x: 'u', y: 'v', z: 'log(-1-u^2)', ...SQUARE }, /no value anywhere/],
  ['a square', { kind: 'implicit', f: '(x^2+y^2+z^2-1)^2', ...BOX }, /f changes its sign/],
  ['f > 0', { kind: 'implicit', f: 'x^2+1', ...BOX }, /f changes its sign/],
  ['no f', { kind: 'implicit', f: 'log(-1-x^2)', ...BOX }, /no value anywhere/],
]))
  test(`${what} is no surface, and is said to be that`, () => {
    assert.throws(() => meshOf(open(definition), 16, surfpath), words);
  });

for (const [what, definition] of /** @type {[string, any][]} */ ([
  ['E < 0', { kind: 'metric', E: '-1', F: '0', G: '1', ...SQUARE }],
  ['E < 0, G < 0', { kind: 'metric', E: '-1', F: '0', G: '-1', ...SQUARE }],
  ['EG < F²', { kind: 'metric', E: '1', F: '5', G: '1', ...SQUARE }],
  ['density 0', { kind: 'parametric', x: 'u', y: 'v', z: 0, density: '0', ...SQUARE }],
  ['density −1', { kind: 'parametric', x: 'u', y: 'v', z: 0, density: '-1', ...SQUARE }],
]))
  test(`${what}: length counts nowhere, which is not 0`, async () => {
    const job = { report: () => {}, isStopped: () => false };
    const values = await shade(open(definition), { colour: 'density', from: [0, 0], resolution: 8 }, job, surfpath);
    assert.ok(values && values.length > 0 && values.every(Number.isNaN));
  });

test('where a formula has no value there are no vertices either: what is fitted into the view is what is seen', () => {
  const definition = { kind: 'parametric', x: 'u', y: 'v', z: 'sqrt(1-u^2-v^2)', u: [-5, 5], v: [-5, 5] };
  const { positions, indices } = meshOf(open(definition), 64, surfpath);
  assert.ok(indices.length > 0);
  for (let i = 0; i < positions.length; i += 3) assert.ok(Math.hypot(...positions.subarray(i, i + 3)) < 1 + 1e-9);
});

test('what is too large for graphics is not drawn, and the rest is', () => {
  const { positions, indices } = meshOf(open({ kind: 'graph', z: 'exp(20x)', x: [-2.5, 2.5], y: [-1, 1] }), 32, surfpath);
  assert.ok(indices.length > 0 && positions.every((x) => Math.abs(x) <= 1e18));
});

test('many waves have cells enough, along one direction too, and shores, and a number for each vertex', async () => {
  const graph = { kind: 'graph', x: [-2.5, 2.5], y: [-2.5, 2.5] };
  const cellsOf = (/** @type {any} */ definition) => {
    const { positions, twins = [] } = meshOf(open(definition), undefined, surfpath);
    return Math.sqrt(positions.length / 3 - twins.length) - 1;
  };
  for (const z of ['sin(20x)*sin(20y)', 'sin(40x)', 'sin(40y)']) assert.equal(cellsOf({ ...graph, z }), 160, z);
  assert.deepEqual(
    ['1+sign(x)', '1+abs(x)'].map((density) => cellsOf({ ...graph, z: 'x', density })),
    [160, 96],
  );
  for (const z of ['sin(x)*sin(y)', 'abs(x)', 'floor(x)', '1/(x*y)', 'sqrt(1-x^2-y^2)']) assert.equal(cellsOf({ ...graph, z }), 96, z);
  for (const [name, entry] of Object.entries(gallery)) if (entry.kind === 'parametric') assert.equal(cellsOf(entry), 96, name);
  /** @type {number[]} */ const lengths = [];
  const job = { report: (/** @type {any} */ { shade }) => lengths.push(shade.length), isStopped: () => true };
  await shade(open({ ...graph, z: 'sin(40x)/9' }), { colour: 'distance', from: [0, 0] }, job, surfpath);
  assert.deepEqual(lengths, [161 ** 2]);
});
