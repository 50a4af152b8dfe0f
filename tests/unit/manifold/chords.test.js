// Lengths of chords from what is measured at their ends: straight ones by hand, fine ones against the lengths of paths.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { load } from 'surfpath';
import { chordLengths } from '../../../web/manifold/chords.js';

const surfpath = await load();

test('in space, by a density, by E, F and G', () => {
  const places = [0, 0, 3, 4, 3, 4];
  assert.deepEqual(chordLengths(places, Float64Array.of(0, 0, 1, 2, 3, 7, 2, 3, 7), 'space'), Float64Array.of(7, 0));
  assert.deepEqual(chordLengths(places, Float64Array.of(0, 0, 1, 4, 2, 3, 7, 16, 2, 3, 7, 16), 'density'), Float64Array.of(21, 0));
  // √(E du² + 2 F du dv + G dv²) at both ends: √(9 + 24 + 64) and √(36 + 16).
  const form = Float64Array.of(1, 1, 4, 4, 0, 1, 4, 0, 1);
  assert.deepEqual(chordLengths(places, form, 'form'), Float64Array.of((Math.sqrt(97) + Math.sqrt(52)) / 2, 0));
});

test('where length is not real it is not known', () => {
  assert.ok(Number.isNaN(chordLengths([0, 0, 1, 0], Float64Array.of(0, 0, 0, -1, 1, 0, 0, 4), 'density')[0]));
  assert.ok(Number.isNaN(chordLengths([0, 0, 1, 0], Float64Array.of(-1, 0, 1, 1, 0, 1), 'form')[0]));
});

test('along a path they add up to its length', () => {
  const z = 'sin(u)*v';
  const [E, F, G] = ['1 + (cos(u)*v)^2', 'cos(u)*v*sin(u)', '1 + sin(u)^2'];
  const surface = surfpath.parametric({ x: 'u', y: 'v', z, u: [-2, 2], v: [-2, 2], density: '1 + u^2' });
  const { parameters, length } = surface.shortestPath([-1, 0.5], [1.5, 1], { points: 2000 });
  assert.ok(parameters);
  const phi = Array.from({ length: parameters.length / 2 }, (_, i) => (1 + parameters[2 * i] ** 2) ** 2);
  const positions = surface.evaluate(parameters);
  const measured = Float64Array.from(phi.flatMap((square, i) => [...positions.subarray(6 * i, 6 * i + 3), square]));
  const sum = (/** @type {Float64Array} */ lengths) => lengths.reduce((all, one) => all + one, 0);
  assert.ok(Math.abs(sum(chordLengths(parameters, measured, 'density')) / length - 1) < 1e-6);
  surface.dispose();
  const abstract = surfpath.metric({ E, F, G, u: [-2, 2], v: [-2, 2] });
  const path = abstract.shortestPath([-1, 0.5], [1.5, 1], { points: 2000 });
  assert.ok(path.parameters);
  assert.ok(Math.abs(sum(chordLengths(path.parameters, abstract.evaluate(path.parameters), 'form')) / path.length - 1) < 1e-6);
  abstract.dispose();
});
