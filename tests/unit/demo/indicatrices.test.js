// The ellipses in the plane of the parameters: how large the largest may be drawn.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { longestRadius } from '../../../demo/plots/indicatrices.js';

test('the longest radius of an ellipse is that of its smaller eigenvalue, however far apart the two are', () => {
  assert.equal(longestRadius([4, 0, 9]), 0.5);
  assert.equal(longestRadius([1e300, 0, 1]), 1);
  // [[2, 1], [1, 2]]: 1 and 3; to the rounding of a few operations.
  assert.ok(Math.abs(longestRadius([2, 1, 2]) - 1) < 1e-15);
});

test('a metric that is infinite has no ellipse', () => {
  assert.ok(!Number.isFinite(longestRadius([Infinity, 0, 1])));
});
