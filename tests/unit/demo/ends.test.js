// What is wrong with the ends of a path and the points on its way, and which of them have a place on the surface.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { findBadEnd, isOnSurface } from '../../../demo/state/ends.js';
import { gallery } from 'surfpath/gallery';
import { load } from 'surfpath';

const surfpath = await load();

test('a number that is missing or outside is named with its point', () => {
  const surface = surfpath.surface(gallery.saddle);
  const [a, b, via] = [
    [0, 0],
    [0.5, 0.5],
    [0.1, 0.2],
  ];
  const check = (/** @type {number[][]} */ ...points) => findBadEnd('parametric', surface, points);
  assert.equal(check(a, b, via), null);
  assert.deepEqual(check(a, [Number.NaN, 0]), { end: 1, coordinate: 0, message: 'B needs a number for u.' });
  assert.deepEqual(check(a, b, via, [0, Number.NaN]), { end: 3, coordinate: 1, message: 'Point 2 needs a number for v.' });
  assert.match(check(a, b, [99, 0])?.message ?? '', /^u of Point 1 must lie between /);
});

test('a point far from an implicit surface has no place on it, as the solver has it', () => {
  const definition = gallery.ellipsoid;
  const surface = surfpath.surface(definition);
  const { from, to } = definition;
  for (const factor of [1, 1.05, 1.2, 1.5, 2, 4]) {
    const point = from.map((x) => factor * x);
    const isOff = surface.shortestPath(point, [...to], { start: 'straight' }).status === 'off-surface';
    assert.equal(isOnSurface(surface, definition, point), !isOff, `${factor}`);
  }
  assert.equal(isOnSurface(surface, definition, [Number.NaN, 0, 0]), false);
});
