// Surfaces whose u and v are far from orthogonal: the nearest lift of an end is many turns from the one that is nearest in u and v.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { load } from '../../../web/index.js';
import { createRandom } from '../../helpers/random.js';

const surfpath = await load();
/** Two tolerances of 1e-9, relative: one of each path. */
const RIGHT = 2e-9;

for (const [name, shear, height] of /** @type {const} */ ([
  ['a hundredth and a half', 0.006, 0.02],
  ['20', 20, 1],
  ['100.3', 100.3, 1],
]))
  for (const isTorus of [true, false])
    test(`a flat ${isTorus ? 'torus' : 'cylinder'}, sheared by ${name}: the shortest of the straight lines to all lifts, seed 1`, () => {
      const [F, G] = [shear, shear ** 2 + height ** 2];
      const surface = surfpath.metric({ E: 1, F, G, u: [0, 1], v: [0, 1], periodic: { u: true, v: isTorus } });
      const random = createRandom(1);
      for (let i = 0; i < 30; i++) {
        const [from, to] = [0, 1].map(() => [random.between(0, 1), random.between(0, 1)]);
        let square = Infinity;
        const most = isTorus ? Math.ceil(1 / height) + 1 : 0;
        for (let n = -most; n <= most; n++) {
          const v = to[1] - from[1] + n;
          const u = to[0] - from[0] + F * v;
          square = Math.min(square, (u - Math.round(u)) ** 2 + (height * v) ** 2);
        }
        const path = surface.shortestPath(from, to);
        assert.equal(path.status, 'converged', `${from} to ${to}`);
        assert.ok(Math.abs(path.length / Math.sqrt(square) - 1) < RIGHT, `${from} to ${to}: ${path.length}, not ${Math.sqrt(square)}`);
      }
      surface.dispose();
    });

test('a torus whose v turns twenty times with u: paths as long as on the same torus without, seed 2', () => {
  const range = /** @type {const} */ ({ u: [0, '2pi'], v: [0, '2pi'] });
  const torus = (/** @type {string} */ v) => ({ x: `(2+cos(${v}))*cos(u)`, y: `(2+cos(${v}))*sin(u)`, z: `sin(${v})`, ...range });
  const [plain, sheared] = [torus('v'), torus('(v+20u)')].map((definition) => surfpath.parametric(definition));
  const random = createRandom(2);
  for (let i = 0; i < 40; i++) {
    const ends = [0, 1].map(() => [random.between(0, 2 * Math.PI), random.between(0, 2 * Math.PI)]);
    const [from, to] = ends.map(([u, v]) => [u, v - 20 * u]);
    const [a, b] = [plain.shortestPath(ends[0], ends[1]), sheared.shortestPath(from, to)];
    assert.equal(b.status, 'converged', `${from} to ${to}`);
    assert.ok(Math.abs(b.length / a.length - 1) < RIGHT, `${from} to ${to}: ${b.length}, not ${a.length}`);
  }
});
