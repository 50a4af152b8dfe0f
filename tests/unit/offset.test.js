/** Surfaces far from the origin, and far from u = 0: what the coordinates' rounding leaves of the tolerance. */
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { load } from '../../web/index.js';
import { createRandom } from '../helpers/random.js';

const surfpath = await load();
after(() => surfpath.dispose());

const near = surfpath.graph({ z: 'sin(3x)*cos(2y)/2', x: [-1.5, 1.5], y: [-1, 1] });

test('far parameters of a surface near the origin round its paths, seed 17', () => {
  const random = createRandom(17);
  for (const offset of [1e3, 1e6, 1e8]) {
    const far = surfpath.parametric({
      x: `u - ${offset}`,
      y: 'v',
      z: `sin(3*(u - ${offset}))*cos(2v)/2`,
      u: [offset - 1.5, offset + 1.5],
      v: [-1, 1],
    });
    for (let i = 0; i < 10; i++) {
      const [a, b] = [0, 1].map(() => [offset + random.between(-1.2, 1.2), random.between(-0.8, 0.8)]);
      const path = far.shortestPath(a, b);
      const { length } = near.shortestPath([a[0] - offset, a[1]], [b[0] - offset, b[1]]);
      assert.ok(
        path.converged && Math.abs(path.length - length) <= path.lengthError,
        `${offset} ${i}: ${path.status} ${path.length} ${length}`,
      );
    }
    far.dispose();
  }
});

test('an implicit body in bounds far from the origin, seed 18', () => {
  const random = createRandom(18);
  const ball = surfpath.implicit({
    f: '(x - 1e6)^2 + (y + 2e6)^2 + (z - 5e5)^2 - 1',
    bounds: [
      [1e6 - 2, 1e6 + 2],
      [-2e6 - 2, 2 - 2e6],
      [5e5 - 2, 5e5 + 2],
    ],
  });
  for (let i = 0; i < 20; i++) {
    const [a, b] = [0, 1].map(() => [0, 1, 2].map((k) => [1e6, -2e6, 5e5][k] + random.between(-0.6, 0.6)));
    const path = ball.shortestPath(ball.project(a), ball.project(b));
    assert.ok(path.converged, `${i}: ${path.status}`);
  }
  ball.dispose();
});
