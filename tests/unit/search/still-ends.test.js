// Ends at which a density or a metric is zero: a potential in its well, from where instantons lead.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { load } from '../../../web/index.js';
import { createRandom } from '../../helpers/random.js';
import { ofAll } from '../../helpers/sample.js';

const surfpath = await load();
const plane = /** @type {const} */ ({ x: 'u', y: 'v', z: 0, u: [-2, 2], v: [-2, 2] });

/** @param {import('../../../web/path.js').Path} path @param {number} exact @param {string} [what] */
function holds(path, exact, what = '') {
  assert.equal(path.status, 'converged', what);
  assert.ok(
    Math.abs(path.length - exact) <= Math.max(path.lengthError, 1e-12 * exact),
    `${what} ${path.length}, not ${exact}; ${path.lengthError}`,
  );
}

test('from the zero of a density that grows as a power of the distance paths are straight, seed 3', () => {
  const random = createRandom(3);
  for (const power of [0.25, 0.5, 1, 2, 3]) {
    const well = [random.between(-1, 1), random.between(-1, 1)];
    const surface = surfpath.parametric({ ...plane, density: `hypot(u - (${well[0]}), v - (${well[1]}))^${power}` });
    /* Of the last power, 3, a path takes seconds. */
    for (let i = 0; i < (power < 3 ? 3 : ofAll(1, 3)); i++) {
      const to = [random.between(-2, 2), random.between(-2, 2)];
      const path = surface.shortestPath(well, to);
      holds(path, Math.hypot(to[0] - well[0], to[1] - well[1]) ** (power + 1) / (power + 1), `power ${power}, to ${to}:`);
      assert.deepEqual([...(path.parameters?.slice(0, 2) ?? []), ...path.points.slice(0, 2)], [...well, ...well]);
      const back = surface.shortestPath(to, well);
      assert.deepEqual([back.length, back.parameters?.slice(-2)], [path.length, Float64Array.from(well)]);
    }
    surface.dispose();
  }
});

test('from a well whose axes differ, slanted, by E, F and G: by the equation of Hamilton and Jacobi, seed 5', () => {
  const random = createRandom(5);
  const slanted = surfpath.parametric({ ...plane, density: 'sqrt((0.8x + 0.6y)^2 + 9(0.6x - 0.8y)^2)' });
  const metric = surfpath.metric({ E: 'u^2 + 4v^2', F: 0, G: 'u^2 + 4v^2', u: [-2, 2], v: [-2, 2] });
  for (let i = 0; i < 6; i++) {
    const [x, y] = [random.between(-2, 2), random.between(-2, 2)];
    holds(slanted.shortestPath([0, 0], [x, y]), ((0.8 * x + 0.6 * y) ** 2 + 3 * (0.6 * x - 0.8 * y) ** 2) / 2, `slanted, to ${[x, y]}:`);
    holds(metric.shortestPath([x, y], [0, 0]), (x * x + 2 * y * y) / 2, `from ${[x, y]}:`);
  }
});

test('in a corner of the rectangle', () => {
  const quarter = surfpath.parametric({ ...plane, u: [0, 2], v: [0, 2], density: 'hypot(x, y)' });
  for (const to of [
    [1, 0.3],
    [2, 2],
    [0.1, 1.5],
  ])
    holds(quarter.shortestPath([0, 0], to), (to[0] ** 2 + to[1] ** 2) / 2, `to ${to}:`);
});

test('from well to well, with any tolerance, and over a mesh', () => {
  const double = surfpath.parametric({ ...plane, density: 'sqrt((x^2 - 1)^2 + y^2)' });
  for (const tolerance of [1e-3, 1e-6, 1e-9]) {
    const path = double.shortestPath([-1, 0], [1, 0], { tolerance });
    holds(path, 4 / 3);
    assert.ok(path.lengthError <= tolerance * path.length);
  }
  const ball = surfpath.parametric({
    x: 'cos(u)cos(v)',
    y: 'sin(u)cos(v)',
    z: 'sin(v)',
    u: [0, '2pi'],
    v: ['-pi/2', 'pi/2'],
    density: 'sqrt(2 - 2x)',
  });
  for (const to of [
    [3, 0.2],
    [5.5, -1],
  ]) {
    const away = Math.acos(Math.cos(to[0]) * Math.cos(to[1]));
    for (const from of [0, 2 * Math.PI]) holds(ball.shortestPath([from, 0], to), 4 * (1 - Math.cos(away / 2)), `to ${to}:`);
  }
  const bowl = surfpath.parametric({ ...plane, density: 'hypot(x, y)' });
  const { mesh, distances } = bowl.distanceField([0, 0], { resolution: 4, exact: true });
  for (const [i, distance] of distances.entries()) {
    const [u, v] = mesh.parameters?.slice(2 * i, 2 * i + 2) ?? [];
    assert.ok(Math.abs(distance - (u * u + v * v) / 2) <= 1e-9, `to ${u}, ${v}: ${distance}`);
  }
});

test('where it vanishes along a line an end is as any other', () => {
  const valley = surfpath.parametric({ ...plane, density: 'abs(x)' });
  /* To the second one it takes half a minute. */
  for (const to of ofAll(
    [[0.5, 0.1]],
    [
      [0.5, 0.1],
      [1, 1],
    ],
  ))
    assert.notEqual(valley.shortestPath([0, 0], to).status, 'converged');
});
