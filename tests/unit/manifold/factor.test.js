// A density without coordinates, and a metric that is a multiple of that of space: paths are those in space, all lengths so many times as long.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { load } from '../../../web/index.js';

/** @typedef {import('../../../web/path.js').Path} Path */

const surfpath = await load();
const make = (/** @type {any} */ definition) => surfpath.surface(definition);
const box = (/** @type {number} */ half) => [0, 1, 2].map(() => [-half, half]);
const turn = [0, '2pi'];
const drum = { kind: 'implicit', f: 'max(x^2 + y^2 - 1, abs(z) - 0.5)', bounds: box(1.3) };
const ellipsoid = { kind: 'implicit', f: 'x^2 + y^2/2 + 3z^2 - 1', bounds: box(1.6) };
const cone = { kind: 'parametric', x: 'u*cos(v)', y: 'u*sin(v)', z: 'u', u: [-1, 1], v: turn };
const torus = { kind: 'parametric', x: '(3 + cos(v))*cos(u)', y: '(3 + cos(v))*sin(u)', z: 'sin(v)', u: turn, v: turn };
const [top, below] = [
  [-0.593, -0.296, -0.5],
  [0.857, 0.516, 0.5],
];

/** To the last digit or the one before. @param {number} number @param {number} other @param {string} what */
const isSame = (number, other, what) =>
  assert.ok(Object.is(number, other) || Math.abs(number / other - 1) <= 5e-16, `${what}: ${number}, not ${other}`);

/** @param {{ energy: number, gradientNorm: number }} one @param {{ energy: number, gradientNorm: number }} plain @param {number} factor */
function isSquared(one, plain, factor) {
  isSame(one.energy, factor ** 2 * plain.energy, 'energy');
  isSame(one.gradientNorm, factor ** 2 * plain.gradientNorm, 'gradient');
}

/** @param {Path} path @param {Path} plain @param {number} factor */
function isMultiple(path, plain, factor) {
  isSame(path.length, factor * plain.length, 'length');
  isSame(path.lengthError, factor * plain.lengthError, 'error');
  isSame(path.conjugate ?? Number.NaN, factor * (plain.conjugate ?? Number.NaN), 'conjugate');
  isSquared(path, plain, factor);
  for (const [i, step] of path.history.entries()) isSquared(step, plain.history[i], factor);
  const bare = (/** @type {any} */ one) => ({ ...one, length: 0, lengthError: 0, conjugate: 0, energy: 0, gradientNorm: 0 });
  const rest = (/** @type {Path} */ one) => ({ ...bare(one), history: one.history.map(bare) });
  assert.deepEqual(rest(path), rest(plain));
}

for (const { name, definition, from, by, to, direction } of [
  { name: 'a drum, across its edges', definition: drum, from: top, by: [0, 0, 0.5], to: below, direction: [1, 0.3, 0] },
  { name: 'an ellipsoid', definition: ellipsoid, from: [1, 0, 0], by: [0, 1.41, 0.04], to: [-0.6, 0.8, 0.3], direction: [0, 1, 0.2] },
  { name: 'a double cone, through its apex', definition: cone, from: [-0.6, 1], by: [0.2, 1], to: [0.7, 2], direction: [-1, 0.3] },
  { name: 'a torus', definition: torus, from: [0.3, 2.8], by: [1, 3], to: [2.9, 3.4], direction: [1, 0.1] },
])
  describe(name, () => {
    for (const density of ['k/3', 2.5])
      test(`the density ${density}`, () => {
        const factor = 2.5;
        const [plain, dense] = [{}, { density, parameters: { k: 7.5 } }].map((more) => make({ ...definition, ...more }));
        const pathsOf = (/** @type {any} */ surface, /** @type {number} */ times) => [
          surface.shortestPath(from, to),
          surface.shortestPath(from, to, { start: 'straight', tolerance: 1e-6, points: 5, record: true }),
          surface.shortestPath(from, to, { gradientTolerance: 1e-8 * times ** 2, points: 20 }),
          surface.shortestPath(from, to, { via: [by] }),
          ...surface.geodesics(from, to),
          ...surface.shortestPaths([...from, ...to]),
          surface.trace(from, direction, 4 * times),
        ];
        const [paths, multiples] = [pathsOf(plain, 1), pathsOf(dense, factor)];
        assert.equal(multiples.length, paths.length);
        for (const [i, path] of paths.entries()) isMultiple(multiples[i], path, factor);
        const pairs = [...from, ...to, ...to, ...by];
        for (const [i, length] of plain.lengths(pairs).entries()) isSame(dense.lengths(pairs)[i], factor * length, 'lengths');
        const [near, far] = [plain, dense].map((surface) => surface.distanceField(from, { resolution: 8 }).distances);
        for (const [i, distance] of near.entries()) isSame(far[i], factor * distance, 'distances');
        for (const surface of [plain, dense]) surface.dispose();
      });
  });

test('a parameter that changes: as many times as long, and without a path while it is not positive, as under any such density', () => {
  const [plain, dense, negative] = [{}, { density: 'k', parameters: { k: -1 } }, { density: '-1 + 0x' }].map((more) =>
    make({ ...drum, ...more }),
  );
  const path = plain.shortestPath(top, below);
  assert.ok(path.converged);
  for (const k of [-1, 3, 0.7, 0, 3]) {
    dense.set({ k });
    const now = dense.shortestPath(top, below);
    if (k > 0) isMultiple(now, path, k);
    else assert.deepEqual(now, negative.shortestPath(top, below));
  }
  for (const surface of [plain, dense, negative]) surface.dispose();
});

test('a multiple of the metric of space, times a density: as many times as long', () => {
  const metric = { xx: 'a + 1', xy: 0, xz: 0, yy: 'a + 1', yz: 0, zz: 4 };
  const [plain, dense] = [{}, { metric, density: 0.75, parameters: { a: 3 } }].map((more) => make({ ...drum, ...more }));
  isMultiple(dense.shortestPath(top, below), plain.shortestPath(top, below), 1.5);
  const [traced, multiple] = [plain, dense].map((surface, i) => surface.trace([0, 0, 0.5], [1, 0.3, 0], i ? 3 : 2));
  isMultiple(multiple, traced, 1.5);
  dense.set({ a: 5 });
  assert.ok(dense.shortestPath(top, [0.5, 0.2, -0.5]).length > 0.75 * Math.sqrt(6) * Math.hypot(1.093, 0.496) - 1e-9);
  for (const surface of [plain, dense]) surface.dispose();
});

test('what a formula of constants says wrongly is told as ever', () => {
  assert.throws(() => make({ ...drum, density: 'w' }), /density: unknown name w/);
  assert.throws(() => make({ ...torus, density: 'x', parameters: { x: 2 } }), /variable of the surface/);
});
