// Where a smooth surface is thinner than cells of its graph it is torn there: what still hangs together by a longer way is no reason to stop at that graph.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { load } from '../../../web/index.js';

const surfpath = await load();
/** A tube along a trefoil. */
const KNOT =
  '(((8x^3 - 24x*y^2) + (x^2+y^2+z^2+1)*(4z^2 - (x^2+y^2+z^2-1)^2))^2 + ((24x^2*y - 8y^3) + 4(x^2+y^2+z^2+1)*z*(x^2+y^2+z^2-1))^2)/(x^2+y^2+z^2+1)^6 - c';

test('a path on the tube of a knot is the same in every box', () => {
  for (const [c, half, from, to, length] of /** @type {const} */ ([
    [0.0388, 3.5, [-0.96, -1.92, -0.5858], [-0.72, 2.2251, 0.48], 5.674447869],
    [0.0388, 3.6, [-0.96, -1.92, -0.5858], [-0.72, 2.2251, 0.48], 5.674447869],
    [0.0388, 5.5, [-0.96, -1.92, -0.5858], [-0.72, 2.2251, 0.48], 5.674447869],
    [0.0425, 5.4, [-0.967965, 1.8, -0.3], [-1.2, -1.5, 0.784391], 7.069954226],
  ])) {
    const bounds = /** @type {[number, number][]} */ ([0, 1, 2].map(() => [-half, half]));
    const surface = surfpath.implicit({ f: KNOT, bounds: /** @type {any} */ (bounds), parameters: { c } });
    const path = surface.shortestPath([...from], [...to]);
    surface.dispose();
    assert.equal(path.status, 'converged');
    assert.ok(Math.abs(path.length - length) <= 1e-8, `c = ${c}, half a side ${half}: ${path.length}`);
  }
});
