// Lengths from A to the points of a path, as the page's table has them: those of the measure, on every leg of a path that passes points.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { legsOf, runsOf } from '../../../demo/compute/legs.js';
import { gallery } from 'surfpath/gallery';
import { load } from 'surfpath';
import { anything } from '../../helpers/refuses.js';

const surfpath = await load();

/** @param {any} definition @param {number[][]} via @param {import('surfpath').PathOptions} options */
function solve(definition, via, options) {
  const surface = surfpath.surface(anything(definition));
  const { from, to } = definition;
  const path = surface.shortestPath(from, to, { ...options, via });
  const legs = via.length > 0 ? legsOf({ surface, drawn: surface, definition }, path, [from, ...via, to], anything(options)) : [];
  return { surface, path, legs, runs: runsOf(path, legs) };
}

test('few points: the last run is the length of the path, not of its chords', () => {
  const { path, runs } = solve(gallery.parametricTorus, [], { points: 4 });
  assert.equal(runs.length, 6);
  assert.equal(runs.at(-1), path.length);
});

test('under a density: as long as the path from A to each point', () => {
  const slow = { ...gallery.saddle, density: '1+10*exp(-4*(u^2+v^2))' };
  const { surface, path, runs } = solve(slow, [], { points: 8 });
  const parameters = /** @type {Float64Array} */ (path.parameters);
  for (const i of [2, 5]) {
    const { length } = surface.shortestPath([...slow.from], Array.from(parameters.subarray(2 * i, 2 * i + 2)), { start: 'straight' });
    assert.ok(Math.abs(length - runs[i]) < 1e-6 * path.length, `${i}: ${length}, ${runs[i]}`);
  }
});

for (const [name, via] of /** @type {[keyof typeof gallery, number[][]][]} */ ([
  [
    'parametricTorus',
    [
      [2, 3],
      [1, 1],
    ],
  ],
  [
    'parametricTorus',
    [
      [2, 3],
      [2, 3],
    ],
  ],
  ['ellipsoid', [[0.3, -0.9, 0.6]]],
]))
  for (const algorithm of /** @type {const} */ (['elements', 'polyline']))
    test(`${name} through ${JSON.stringify(via)}, ${algorithm}: each leg has the length of its own path`, () => {
      const { surface, path, legs, runs } = solve(gallery[name], via, { points: 9, algorithm });
      const stops = [gallery[name].from, ...via, gallery[name].to];
      assert.equal(runs.length, 11);
      assert.equal(runs.at(-1), path.length);
      for (const [i, { segments, length }] of legs.entries()) {
        const alone = surface.shortestPath([...stops[i]], [...stops[i + 1]], { points: segments - 1, algorithm });
        assert.ok(Math.abs(alone.length - length) <= 1e-9 * path.length, `${alone.length}, ${length}`);
      }
    });
