// Rims of implicit surfaces: where f has no more value, against great circles; and of flat bodies, sharper than chords, against the same body in u and v.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { load } from '../../web/index.js';
import { createRandom } from '../helpers/random.js';
import { ofAll } from '../helpers/sample.js';
import { anything, close } from '../helpers/refuses.js';

const surfpath = await load();
const RADIUS = Math.SQRT2;
const PAIRS = 6;

describe('between ends beside the rim of a hemisphere, where a step of the projection leads beyond it', () => {
  for (const f of ['z - sqrt(2 - x^2 - y^2)', 'sqrt(2 - x^2 - y^2) - z'])
    for (const bounds of [anything(Array(3).fill([-1.5, 1.5])), undefined])
      test(`${f}, ${bounds ? 'within' : 'without'} bounds`, () => {
        const surface = surfpath.implicit({ f, bounds });
        const random = createRandom(61);
        for (const beside of [0.99, 0.999, 0.9999])
          for (let i = 0; i < PAIRS; i++) {
            const [from, to] = [0, 1].map(() => {
              const angle = random.between(0, 2 * Math.PI);
              const out = RADIUS * beside;
              return [out * Math.cos(angle), out * Math.sin(angle), Math.sqrt(2 - out ** 2)];
            });
            const { status, length } = surface.shortestPath(from, to);
            assert.equal(status, 'converged', `${from} to ${to}`);
            const cosine = from.reduce((sum, x, j) => sum + (x * to[j]) / 2, 0);
            close(length, RADIUS * Math.acos(cosine), 1e-9);
          }
      });
});

test('around the rim of an ellipsoid of half axes 3, 3 and 0.06, no jump', () => {
  const flat = surfpath.implicit({
    f: 'x^2/9 + y^2/9 + z^2/0.0036 - 1',
    bounds: anything([
      [-3.2, 3.2],
      [-3.2, 3.2],
      [-0.3, 0.3],
    ]),
  });
  const same = surfpath.parametric({ x: '3cos(v)cos(u)', y: '3cos(v)sin(u)', z: '0.06sin(v)', u: [0, '2pi'], v: ['-pi/2', 'pi/2'] });
  const random = createRandom(62);
  for (let i = 0; i < ofAll(2, 5); i++) {
    const places = [1, -1].map((side) => [random.between(0, 2 * Math.PI), side * Math.acos(Math.sqrt(random.between(0, 1)))]);
    const [from, to] = places.map(([u, v]) => [3 * Math.cos(v) * Math.cos(u), 3 * Math.cos(v) * Math.sin(u), 0.06 * Math.sin(v)]);
    const { length, lengthError } = flat.shortestPath(from, to);
    const known = same.shortestPath(places[0], places[1]);
    assert.equal(known.status, 'converged');
    assert.ok(Math.abs(length - known.length) <= Math.max(lengthError, 1e-9), `${length} ± ${lengthError}, not ${known.length}`);
  }
});

/* Cells of what looks for ways are wider than the rim is sharp; and ends on both of its sides are near each other in space alone. */
for (const [flat, ends] of /** @type {[number, number[][]][]} */ ([
  [
    10,
    [
      [0.0582, -0.8569, -0.3854, 0.5589],
      [-0.279, 0.323, -0.333, 0.28],
      [0.5, 0.1, 0.5, 0.12],
    ],
  ],
  [
    30,
    [
      [-0.279, 0.323, -0.333, 0.28],
      [0.351, 0.62, 0.32, 0.615],
    ],
  ],
]))
  test(`an ellipsoid ${flat} times as wide as it is thick, without bounds: the shortest way around its rim`, () => {
    const surface = surfpath.implicit({ f: `x^2 + y^2 + (${flat}*z)^2 - 1` });
    const same = surfpath.revolution({ r: 'cos(t)', z: `sin(t)/${flat}`, t: ['-pi/2', 'pi/2'] });
    for (const [x, y, p, q] of ends) {
      const [above, below] = [
        [Math.atan2(y, x), Math.acos(Math.hypot(x, y))],
        [Math.atan2(q, p), -Math.acos(Math.hypot(p, q))],
      ];
      const { status, length } = surface.shortestPath([x, y, Math.sin(above[1]) / flat], [p, q, Math.sin(below[1]) / flat]);
      assert.equal(status, 'converged', `${x}, ${y} to ${p}, ${q}`);
      close(length, same.shortestPath(above, below).length, 1e-8);
    }
  });

test('over the rim of a vase whose walls are thinner than cells are wide, as on the same vase in u and v', () => {
  const bounds = anything(Array(3).fill([-2.2, 2.2]));
  const vase = surfpath.implicit({ f: '(sqrt(x^2 + y^2) - (0.5 + 0.3sin(3z)))^2 - 0.0025(4 - z^2)', bounds });
  const profile = surfpath.revolution({ r: '0.5 + 0.3sin(6cos(t)) + 0.1sin(t)', z: '2cos(t)', t: [0, '2pi'] });
  for (const [u, from, v, to] of [
    [0.3, 0.8, 1.1, -0.7],
    [1, 0.9, 0.2, -0.4],
    [0, 1.2, 3, -0.6],
    [0, 2.6, 1, -2.4],
  ]) {
    const known = profile.shortestPath([u, from], [v, to]);
    const [a, b] = [profile.evaluate([u, from]), profile.evaluate([v, to])].map((seen) => Array.from(seen.slice(0, 3)));
    const { status, length } = vase.shortestPath(a, b);
    assert.deepEqual([known.status, status], ['converged', 'converged']);
    close(length, known.length, 1e-9);
  }
});

test('over the rim of a dish, sharper than cells are wide and than chords that a search begins with, as long as on the same dish in u and v', () => {
  const bounds = anything(Array(3).fill([-1.2, 1.2]));
  const dish = surfpath.implicit({ f: '(z - (x^2 + y^2)/2)^2 - 0.0009(1 - x^2 - y^2)', bounds });
  const at = (/** @type {number} */ angle, /** @type {number} */ t) => {
    const r = Math.cos(t);
    return [r * Math.cos(angle), r * Math.sin(angle), r ** 2 / 2 + 0.03 * Math.sin(t)];
  };
  const first = dish.shortestPath(at(2.6, -1.52), at(-2.3, 1.31));
  const second = dish.shortestPath(at(0, -1.3), at(0.4, 1.3));
  assert.deepEqual([first.status, second.status], ['converged', 'converged']);
  close(first.length, 2.024388422647867, 1e-9);
  close(second.length, 1.76924854008267, 1e-9);
});

test('a cube rounded by max(0, …), within which f is constant: over its edges, as unfolded', () => {
  const bounds = anything(Array(3).fill([-2.3, 2.3]));
  const rounded = surfpath.implicit({ f: 'hypot(max(|x| - 0.95, 0), max(|y| - 0.95, 0), max(|z| - 0.95, 0)) - 0.05', bounds });
  const { status, length } = rounded.shortestPath([1, 0.2, 0.1], [-1, 0.2, 0.1]);
  assert.equal(status, 'converged');
  close(length, 4 * 0.95 - 2 * 0.2 + Math.PI * 0.05, 1e-9);
});

test('over the rim of a shell cut by max(0, …)², thinner than cells are wide: no longer than by way of another point', () => {
  const g = 'x^2 + y^2 + z^2 - 1 - 0.0952*sin(0.33*x + 2.1*y - 0.133*z + 2.93) - 0.0644*cos(-2.11*x - 0.217*y + 2.52*z + 0.478)';
  const shell = surfpath.implicit({
    f: `(${g})^2 + 0.118*max(0, z - 0.578 + 0.2*sin(3*x))^2 - 0.028`,
    bounds: anything(Array(3).fill([-1.8, 1.8])),
  });
  const [from, by, to] = [
    [-0.12, 0.24, 0.986],
    [-0.046, 0.145, 1.006],
    [0.42, -0.865, 0.24],
  ].map((place) => shell.project(place));
  const [whole, ...legs] = [
    [from, to],
    [from, by],
    [by, to],
  ].map(([a, b]) => shell.shortestPath(a, b));
  assert.equal(whole.status, 'converged');
  assert.ok(
    whole.length <= legs[0].length + legs[1].length + 1e-9,
    `${whole.length}, by way of a point ${legs[0].length + legs[1].length}`,
  );
});
