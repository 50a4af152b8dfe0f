// A stranger's program: the same path through both entries, and the gallery. Run by package.test.js where the package is installed.
import assert from 'node:assert/strict';
import { inspect } from 'node:util';
import { ExpressionError, load } from 'surfpath';
import * as gallery from 'surfpath/gallery';
import { createPool } from 'surfpath/pool';
import { load as loadSlim } from 'surfpath/slim';

/** @param {import('surfpath').Surfpath} surfpath */
function saddlePath(surfpath) {
  const surface = surfpath.parametric({ x: 'u', y: 'v', z: 'u^2 - v^2', u: [-1, 1], v: [-1, 1] });
  return surface.shortestPath([-0.5, -0.5], [0.5, 0.7], { points: 50 });
}

const path = saddlePath(await load());
assert.equal(path.status, 'converged');
assert.equal(path.points.length, 3 * 52);
assert.ok(path.length > Math.hypot(1, 1.2, 0.24) && path.length < 2, `length ${path.length}`);
assert.deepEqual(saddlePath(await loadSlim()), path);
assert.ok(Object.keys(gallery).length > 0);
const pool = createPool({ workers: 1 });
const [length] = await pool.lengths(
  { kind: 'parametric', x: 'u', y: 'v', z: 'u^2 - v^2', u: [-1, 1], v: [-1, 1] },
  [-0.5, -0.5, 0.5, 0.7],
  { points: 50 },
);
assert.equal(length, path.length);

// What a console prints of a mistake begins with its class's name, whatever minification made of that.
const surfpath = await load();
assert.throws(
  () => surfpath.implicit({ f: 'x +' }),
  (error) => error instanceof ExpressionError && inspect(error).startsWith('ExpressionError: f: '),
);
console.log('ok');
