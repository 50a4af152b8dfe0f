// The distances that the page draws contours of: those of shortest paths, to what a pixel shows.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { measureDistances } from '../../../demo/compute/distances.js';
import { gallery } from 'surfpath/gallery';
import { load } from 'surfpath';

const surfpath = await load();

/** @param {import('surfpath').AnyDefinition & { from: readonly number[] }} definition @param {number} resolution */
function measure(definition, resolution) {
  const { from } = definition;
  const surface = surfpath.surface(definition);
  const { mesh, distances: rough } = surface.distanceField(from, { resolution });
  const steps = measureDistances(surface, [...from], mesh, rough);
  let [step, last] = [steps.next(), 0];
  for (; !step.done; step = steps.next()) {
    assert.ok(step.value >= last && step.value < 1, 'shares of what is done rise');
    last = step.value;
  }
  const size = rough.reduce((most, x) => Math.max(most, x), 0);
  return { surface, from, mesh, rough, size, distances: step.value };
}

/** Errors at some vertices, in parts of the greatest distance. @param {ReturnType<typeof measure>} measured @param {Float64Array} values @param {number} [count] */
function errors({ surface, from, mesh, size }, values, count = 40) {
  const width = from.length;
  const places = width === 2 ? (mesh.parameters ?? new Float64Array(0)) : mesh.positions;
  return Array.from({ length: count }, (_, k) => {
    const i = Math.floor((k * values.length) / count);
    const { length } = surface.shortestPath(from, Array.from(places.subarray(width * i, width * (i + 1))));
    return Math.abs(values[i] - length) / size;
  }).sort((a, b) => a - b);
}

describe('distances of paths', () => {
  // A seam, two seams, poles, walls; and sheets that chords may leave.
  for (const name of /** @type {const} */ (['cylinder', 'parametricTorus', 'globe', 'saddle', 'genus2']))
    test(`${name}: a hundredth of what the graph is wrong by`, () => {
      const measured = measure(gallery[name], name === 'genus2' ? 24 : 32);
      const [exact, rough] = [measured.distances, measured.rough].map((values) => errors(measured, values));
      assert.ok(exact[20] < 1e-5, `median ${exact[20]}`);
      assert.ok(exact[37] < 1e-3 && exact[37] < rough[37] / 10, `${exact[37]}, the graph ${rough[37]}`);
    });

  // Waves that few chords cut off; a jump, on which polylines do not come to rest.
  const square = /** @type {const} */ ({ kind: 'graph', x: [-1, 1], y: [-1, 1], from: [-0.7, -0.3] });
  for (const [name, definition] of /** @type {[string, Parameters<typeof measure>[0]][]} */ ([
    ['waves', { ...square, z: '0.1sin(20x)*sin(20y)' }],
    ['a shore', { ...square, z: 0, density: '3 - 2sign(x)' }],
  ]))
    test(`${name}: where paths are not known better the graph's ways stay`, () => {
      const measured = measure(definition, 10);
      const [exact, rough] = [measured.distances, measured.rough].map((values) => errors(measured, values, 15));
      assert.ok(
        exact[7] <= rough[7] && exact[14] <= 1.2 * rough[14],
        `${exact[7]} and ${exact[14]}, the graph ${rough[7]} and ${rough[14]}`,
      );
    });

  test('both sides of a seam are as far, and so is every corner at a pole', () => {
    const { distances, mesh } = measure(gallery.globe, 16);
    const row = (/** @type {number} */ j) => Array.from(distances.subarray(17 * j, 17 * (j + 1)));
    assert.equal(mesh.positions.length / 3, 17 * 17);
    for (let j = 0; j <= 16; j++) assert.equal(row(j)[0], row(j)[16]);
    for (const pole of [0, 16]) assert.equal(new Set(row(pole)).size, 1);
  });
});
