// `lengths` and `shortestPaths`: the answers of one by one, bad pairs among good ones, misuse.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { gallery } from '../../web/gallery.js';
import { load } from '../../web/index.js';
import { randomPairs } from '../bench/pairs.js';
import { createRandom } from '../helpers/random.js';

const SEED = 77;

/** @type {import('../../web/instance.js').Surfpath} */
let surfpath;
before(async () => {
  surfpath = await load();
});
after(() => surfpath.dispose());

const make = (/** @type {keyof typeof gallery} */ name) => surfpath.surface(/** @type {any} */ (gallery[name]));

for (const name of /** @type {const} */ (['saddle', 'parametricTorus', 'genus2', 'globe']))
  for (const options of [
    undefined,
    { tolerance: 1e-6, points: 9 },
    { algorithm: /** @type {const} */ ('polyline'), start: /** @type {const} */ ('straight') },
  ])
    test(`${name}, ${JSON.stringify(options) ?? 'defaults'}: one by one to the bit, seed ${SEED}`, () => {
      const surface = make(name);
      const pairs = randomPairs(surface, createRandom(SEED), 5);
      const alone = pairs.map(([from, to]) => surface.shortestPath(from, to, options));
      assert.deepEqual(surface.shortestPaths(pairs.flat(2), options), alone);
      assert.deepEqual(
        surface.lengths(Float64Array.from(pairs.flat(2)), options),
        Float64Array.from(alone, ({ length }) => length),
      );
      surface.dispose();
    });

test('under a density whose rough paths are found twice: to the bit, however many points are asked for, seed 3', () => {
  const density = '0.08 + 2.56x^2 + 0.82sin(4.71y)^2';
  const surface = surfpath.graph({ z: '0.22*x*y', x: [-1, 1], y: [-1, 1], density });
  const random = createRandom(3);
  const pairs = Array.from({ length: 16 }, () => Array.from({ length: 4 }, () => random.between(-1, 1)));
  const lengths = surface.lengths([0, 0, 0.76, 0.57, ...pairs.flat()]);
  for (const [i, [a, b, c, d]] of [[0, 0, 0.76, 0.57], ...pairs].entries())
    for (const points of [64, 10, 1])
      assert.equal(surface.shortestPath([a, b], [c, d], { points }).length, lengths[i], `${i}, ${points} points`);
  surface.dispose();
});

test('a bad pair does not stop the others: parametric', () => {
  const surface = make('saddle');
  const pairs = [0, 0, 0.5, 0.5, Number.NaN, 0, 0.5, 0.5, 0, 0, 0.5, Infinity, 0, 0, 1.5, 0, 0.1, 0.2, 0.3, 0.4];
  const paths = surface.shortestPaths(pairs);
  assert.deepEqual(
    paths.map(({ status }) => status),
    ['converged', 'not-finite', 'not-finite', 'off-surface', 'converged'],
  );
  assert.deepEqual([paths[1].converged, paths[1].length, paths[1].points.length, paths[1].parameters], [false, Number.NaN, 0, null]);
  const lengths = surface.lengths(pairs);
  assert.ok(lengths instanceof Float64Array);
  assert.deepEqual(
    Array.from(lengths),
    paths.map(({ length }) => length),
  );
  surface.dispose();
});

test('a bad pair does not stop the others: implicit', () => {
  const surface = surfpath.implicit({
    f: 'x^2+y^2+z^2-1',
    bounds: [
      [-1.2, 1.2],
      [-1.2, 1.2],
      [-1.2, 1.2],
    ],
  });
  const paths = surface.shortestPaths([1, 0, 0, 0, 1, 0, 5, 0, 0, 0, 1, 0, 1, 0, 0, 0, Number.NaN, 0, 0, 0, 1, 0, 1, 0]);
  assert.deepEqual(
    paths.map(({ status }) => status),
    ['converged', 'off-surface', 'not-finite', 'converged'],
  );
  for (const i of [0, 3]) assert.ok(Math.abs(paths[i].length - Math.PI / 2) < 1e-9);
  surface.dispose();
});

test('periodic directions take any number; no pairs give nothing', () => {
  const surface = make('cylinder');
  const [length] = surface.lengths([0.5 + 20 * Math.PI, 0, 0.5, 1]);
  assert.ok(Math.abs(length - 1) < 1e-9, String(length));
  assert.equal(surface.lengths([]).length, 0);
  assert.deepEqual(surface.shortestPaths(new Float64Array(0)), []);
  surface.dispose();
});

test('mistakes throw, and say which', () => {
  const surface = make('saddle');
  /** @type {[any, any, ErrorConstructor, RegExp][]} */
  const mistakes = [
    [[0, 0, 1], undefined, RangeError, /pairs must be a flat array of u v u v, 4 numbers a pair, not 3 numbers/],
    [[[0, 0, 1, 1]], undefined, TypeError, /pairs must be .*; it holds an array of 1|it holds an array of 4/],
    [['0', 0, 1, 1], undefined, TypeError, /it holds '0'/],
    ['0011', undefined, TypeError, /pairs must be/],
    [null, undefined, TypeError, /pairs must be/],
    [[0, 0, 1, 1], { via: [[0, 0]] }, TypeError, /no option 'via'; the options are (?!.*via)/],
    [[0, 0, 1, 1], { start: [0, 0, 1, 1] }, RangeError, /options.start must be 'global' or 'straight'/],
    [[0, 0, 1, 1], { tolerance: 1 }, RangeError, /options.tolerance/],
    [[0, 0, 1, 1], { exact: true }, TypeError, /no option 'exact'/],
  ];
  for (const [pairs, options, kind, message] of mistakes)
    for (const caller of /** @type {const} */ (['lengths', 'shortestPaths']))
      assert.throws(
        () => surface[caller](pairs, options),
        (error) => error instanceof kind && message.test(error.message) && error.message.startsWith(`${caller}: `),
        `${caller} ${message}`,
      );
  surface.dispose();
  assert.throws(() => surface.lengths([]), /lengths: this surface was disposed/);
});
