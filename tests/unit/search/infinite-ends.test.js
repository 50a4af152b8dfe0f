// Ends at which a density or a metric is infinite, and lengths are not: what falls from rest, what leaves the line where a plane is singular.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { load } from '../../../web/index.js';
import { createRandom } from '../../helpers/random.js';

const surfpath = await load();
const plane = /** @type {const} */ ({ x: 'u', y: 'v', z: 0, u: [0, 4], v: [-3, 0] });
const fall = surfpath.parametric({ ...plane, density: '1/sqrt(-v)' });

/** ∫ ds/√y from rest to a place so far aside and down: along the cycloid x = a (t − sin t), y = a (1 − cos t) that is √(2a) t. @param {number} x @param {number} y */
function timeOfFall(x, y) {
  if (x === 0) return 2 * Math.sqrt(y);
  let [low, high] = [1e-6, 2 * Math.PI];
  for (let i = 0; i < 100; i++) {
    const t = (low + high) / 2;
    if ((t - Math.sin(t)) * y < (1 - Math.cos(t)) * x) low = t;
    else high = t;
  }
  return Math.sqrt((2 * y) / (1 - Math.cos(low))) * low;
}

/** @param {import('../../../web/path.js').Path} path @param {number} exact @param {number} [rounding] in parts of it */
function holds(path, exact, rounding = 1e-14) {
  assert.equal(path.status, 'converged');
  assert.ok(Math.abs(path.length - exact) <= path.lengthError + rounding * exact, `${path.length}, not ${exact}; ${path.lengthError}`);
}

test('a body that falls from rest takes the cycloid, to the tolerance', () => {
  for (const tolerance of [1e-3, 1e-6, 1e-9, 1e-12]) {
    const path = fall.shortestPath([0, 0], [3, -1], { tolerance });
    holds(path, timeOfFall(3, 1));
    assert.ok(path.lengthError <= tolerance * path.length);
    assert.deepEqual([...(path.parameters?.slice(0, 2) ?? [])], [0, 0]);
    assert.deepEqual([...path.points.slice(0, 3), ...path.points.slice(-3)], [0, 0, 0, 3, -1, 0]);
    const back = fall.shortestPath([3, -1], [0, 0], { tolerance });
    assert.deepEqual([back.length, back.parameters?.[0]], [path.length, 3]);
  }
  holds(fall.shortestPath([0, 0], [3, -1], { start: 'straight' }), timeOfFall(3, 1));
  const lower = surfpath.parametric({ ...plane, v: [-3, 2], density: '1/sqrt(2 - v)' });
  holds(lower.shortestPath([0, 2], [3, 1]), timeOfFall(3, 1));
  assert.equal(fall.geodesics([0, 0], [3, -1]).length, 1);
  assert.equal(fall.lengths([0, 0, 3, -1])[0], fall.shortestPath([0, 0], [3, -1]).length);
});

test('short falls, into less than a thousandth of the rectangle, are as right as deep ones', () => {
  for (const radius of [0.3, 1])
    for (const angle of [0.01, 0.05, 0.1, 1]) {
      const [x, y] = [radius * (angle - Math.sin(angle)), radius * (1 - Math.cos(angle))];
      holds(fall.shortestPath([0, 0], [x, -y]), Math.sqrt(2 * radius) * angle, 1e-13);
    }
  for (const x of [0.01, 0.1]) holds(fall.shortestPath([1, 0], [1 + x, 0]), 2 * Math.sqrt(Math.PI * x), 1e-13);
});

test('of random falls all are right, also between two places of rest, by E, F and G, and with slanted coordinates', () => {
  const random = createRandom(4);
  const metric = surfpath.metric({ u: plane.u, v: plane.v, E: '-1/v', F: 0, G: '-1/v' });
  const slanted = surfpath.parametric({ ...plane, x: 'u + v/2', density: '1/sqrt(-v)' });
  for (let i = 0; i < 8; i++) {
    const [from, x, y] = [random.between(0, 1), random.between(0, 2), random.between(0.1, 2)];
    for (const surface of [fall, metric]) holds(surface.shortestPath([from, 0], [from + x, -y]), timeOfFall(x, y));
    holds(slanted.shortestPath([from, 0], [from + x + y / 2, -y]), timeOfFall(x, y));
    holds(fall.shortestPath([from, 0], [from + 1 + x, 0]), 2 * Math.sqrt(Math.PI * (1 + x)));
  }
});

test('straight ways have the length of their power; where that is infinite there is none', () => {
  for (const power of [0.25, 0.5, 0.75, 0.9]) {
    const surface = surfpath.parametric({ ...plane, v: [0, 3], density: `v^(-${power})` });
    holds(surface.shortestPath([1, 0], [1, 2]), 2 ** (1 - power) / (1 - power));
    surface.dispose();
  }
  for (const density of ['1/v', 'v^(-1.5)']) {
    const surface = surfpath.parametric({ ...plane, v: [0, 3], density });
    assert.equal(surface.shortestPath([1, 0], [2, 2]).status, 'not-finite');
    surface.dispose();
  }
});

test("Grushin's plane: paths leave the line on which it is singular, within the rectangle or at its edge", () => {
  for (const u of /** @type {const} */ ([
    [0, 2],
    [-2, 2],
  ])) {
    const surface = surfpath.metric({ u: [...u], v: [-2, 2], E: 1, F: 0, G: '1/u^2' });
    holds(surface.shortestPath([0, 0], [0, 0.5]), Math.sqrt(Math.PI));
    holds(surface.shortestPath([0, 1], [1.5, 1]), 1.5);
    surface.dispose();
  }
});

test('a point at which a density is infinite in all directions: the error says what is not known', () => {
  const surface = surfpath.parametric({ ...plane, u: [-1, 4], v: [-3, 3], density: '(u^2 + v^2)^(-1/4)' });
  const path = surface.shortestPath([0, 0], [3, -1]);
  assert.equal(path.status, 'tolerance-not-met');
  assert.ok(Math.abs(path.length - 2 * 10 ** 0.25) <= 1.1 * path.lengthError && path.lengthError < 1e-5);
});

test('along an edge of the rectangle lengths are as right as inside, where a density grows towards its end, or is infinite there', () => {
  for (const from of [-3e-3, -3e-5, -3e-7]) holds(fall.shortestPath([0, from], [0, -3]), 2 * (Math.sqrt(3) - Math.sqrt(-from)), 3e-14);
  holds(fall.shortestPath([0, 0], [0, -3]), 2 * Math.sqrt(3));
});

test('a distance field from such a place, and to such places: exact, and by the graph as far as its cells tell', () => {
  const errorsOf = (/** @type {import('../../../web/mesh/field.js').DistanceField} */ { mesh, distances }) =>
    Array.from(distances, (distance, i) => {
      const [u, v] = mesh.parameters?.slice(2 * i, 2 * i + 2) ?? [];
      const time = v === 0 ? 2 * Math.sqrt(Math.PI * Math.abs(u - 1)) : timeOfFall(Math.abs(u - 1), -v);
      return time > 0 ? distance / time - 1 : distance;
    });
  const exact = errorsOf(fall.distanceField([1, 0], { resolution: 4, exact: true }));
  assert.ok(Math.max(...exact.map(Math.abs)) <= 1e-9, `${exact}`);
  const rough = errorsOf(fall.distanceField([1, 0], { resolution: 16 }));
  /* Beside the edge, where lengths grow within a cell, it is too long. */
  assert.ok(Math.min(...rough) >= -0.01 && rough.reduce((sum, x) => sum + x, 0) <= 0.03 * rough.length, `${Math.max(...rough)}`);
});

test('to where lengths are infinite no way leads; the other vertices are as exact as ever', () => {
  const halfPlane = surfpath.parametric({ ...plane, u: [-1, 1], v: [0, 2], metric: { E: '1/v^2', F: 0, G: '1/v^2' } });
  const { mesh, distances } = halfPlane.distanceField([0, 1], { resolution: 4, exact: true });
  for (const [i, distance] of distances.entries()) {
    const [u, v] = mesh.parameters?.slice(2 * i, 2 * i + 2) ?? [];
    const length = v === 0 ? Infinity : Math.acosh(1 + (u * u + (v - 1) ** 2) / (2 * v));
    assert.ok(distance === length || Math.abs(distance - length) <= 1e-9, `to ${u}, ${v}: ${distance}, not ${length}`);
  }
});
