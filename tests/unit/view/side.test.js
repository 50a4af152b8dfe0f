// From which side a surface is looked at: that of the curve, but never along it.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Sphere, Vector3 } from 'three';
import { sideOf } from '../../../web/view/side.js';

const BOUNDS = new Sphere(new Vector3(1, 2, 3), 2);
const UP = Math.sin(Math.PI / 6);

/** @param {Vector3} side @param {number[]} expected horizontal direction */
function assertSide(side, expected) {
  const [x, y] = new Vector3(expected[0], expected[1], 0).setLength(Math.cos(Math.PI / 6)).toArray();
  assert.ok(side.distanceTo(new Vector3(x, y, UP)) < 1e-12, String(side.toArray()));
}

test('that of the middle of the curve, 30 degrees above', () => {
  assertSide(sideOf([2, 1, 3, 3, 2, 3, 2, 3, 3], BOUNDS), [1, 0]);
});

test('one of its own where there is no curve, or it is in the middle', () => {
  for (const curve of [[], [0, 2, 3, 1, 2, 3, 1, 3, 3]]) assertSide(sideOf(curve, BOUNDS), [0.6, -1]);
});

test('a curve that leads straight away is seen from aside', () => {
  const side = sideOf([1, 2, 3, 2, 2, 3.5, 3, 2, 4], BOUNDS);
  assertSide(side, [Math.cos(Math.PI / 3), Math.sin(Math.PI / 3)]);
  assert.ok(Math.abs(side.dot(new Vector3(2, 0, 1).normalize())) < 0.7);
});
