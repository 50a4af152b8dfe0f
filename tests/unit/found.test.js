// What the fuzzers of tests/fuzz found in problems, one test each.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { load } from '../../web/index.js';
import { anything, refuses } from '../helpers/refuses.js';

const surfpath = await load();

test('a path of a Morse index above 0 is no converged one', () => {
  const surface = surfpath.graph({
    z: 'asinh((x)^2 / (y) * max(x, x) y*min(y, y) y^2 + y * -(x))*-(abs(y) y^2*1.5e1 (y)^2+asinh(y) / 7)^3 / y - atan(1.5e1 ^ -x) atan(x * 0.5 * 0.5 y - cos(x) cos(x) + (y))',
    x: [-1, 1],
    y: [-1, 1],
  });
  const path = surface.shortestPath([-0.89741275832057, -0.6666707620024681], [-0.6258635744452477, 0.18552244966849685], {
    start: 'straight',
    points: 19,
    maxIterations: 34,
  });
  assert.equal(path.converged, path.status === 'converged');
  assert.ok(!path.converged || path.index === 0, `${path.status}, index ${path.index}`);
});

test('a length that is not true of what is handed over costs no memory', () => {
  const surface = surfpath.graph({ z: 0, x: [-1, 1], y: [-1, 1] });
  /* No list has a length that is no whole number. */
  refuses(() => surface.shortestPath(anything({ length: Infinity }), [0, 0]), TypeError, /from must be \[x, y\], not an object/);
  for (const ask of [surface.evaluate, surface.lengths])
    refuses(() => ask.call(surface, anything({ length: Infinity })), TypeError, /must be .*, not an object/);
  for (const length of [1e9, 2 ** 40]) {
    refuses(() => surface.shortestPath(anything({ length }), [0, 0]), RangeError, /2 numbers, not/);
    refuses(() => surface.evaluate(anything({ length })), TypeError, /it holds undefined/);
    refuses(() => surface.lengths(anything({ length })), TypeError, /it holds undefined/);
  }
  surface.dispose();
});
