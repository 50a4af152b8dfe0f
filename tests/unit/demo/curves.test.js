// Curves as they are drawn: a polyline is cut where it leaps over what is no surface, and nowhere else.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { load } from 'surfpath';
import { mayLeap, unbroken } from '../../../demo/compute/curves.js';

const surfpath = await load();

/** How many pieces a path over a graph is drawn in. @param {string} z */
const piecesOver = (z) => {
  const { points } = surfpath.graph({ z, x: [-2.5, 2.5], y: [-2.5, 2.5] }).shortestPath([-1.9, -1.2], [1.8, 1.4]);
  const pieces = unbroken(points);
  assert.equal(
    pieces.reduce((sum, { length }) => sum + length, 0),
    points.length,
  );
  return pieces.length;
};

test('a path over a pole or a jump is in pieces', () => {
  assert.equal(piecesOver('1/x'), 2);
  assert.equal(piecesOver('floor(x)'), 4);
});

test('over edges and slopes it is whole', () => {
  for (const z of ['x*y', 'abs(x)+abs(y)', 'atan(1000*x)', '100*x^3']) assert.equal(piecesOver(z), 1, z);
});

test('only a path that came to no rest, of many points evenly apart in space, may leap', () => {
  const sketch = { density: '', tensor: [] };
  const path = (/** @type {number} */ count, converged = false) => /** @type {any} */ ({ converged, points: new Float64Array(3 * count) });
  assert.equal(mayLeap(path(66), sketch), true);
  assert.equal(mayLeap(path(66, true), sketch), false);
  assert.equal(mayLeap(path(5), sketch), false);
  assert.equal(mayLeap(path(66), { ...sketch, density: '1 - 0.95exp(-30y^2)' }), false);
});
