// The distances that the page draws contours of: those of shortest paths, to what a pixel shows.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { measureDistances } from '../../../demo/compute/distances.js';
import { gallery } from 'surfpath/gallery';
import { load } from 'surfpath';

const surfpath = await load();

/** @param {keyof typeof gallery} name @param {number} resolution */
function measure(name, resolution) {
  const { from } = gallery[name];
  const surface = surfpath.surface(gallery[name]);
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

/** Errors at some vertices, in parts of the greatest distance. @param {ReturnType<typeof measure>} measured @param {Float64Array} values */
function errors({ surface, from, mesh, size }, values) {
  const width = from.length;
  const places = width === 2 ? (mesh.parameters ?? new Float64Array(0)) : mesh.positions;
  return Array.from({ length: 40 }, (_, k) => {
    const i = Math.floor((k * values.length) / 40);
    const { length } = surface.shortestPath(from, Array.from(places.subarray(width * i, width * (i + 1))));
    return Math.abs(values[i] - length) / size;
  }).sort((a, b) => a - b);
}

describe('distances of paths', () => {
  // A seam, two seams, poles, walls; and sheets that chords may leave.
  for (const name of /** @type {const} */ (['cylinder', 'parametricTorus', 'globe', 'saddle', 'genus2']))
    test(`${name}: a hundredth of what the graph is wrong by`, () => {
      const measured = measure(name, name === 'genus2' ? 24 : 32);
      const [exact, rough] = [measured.distances, measured.rough].map((values) => errors(measured, values));
      assert.ok(exact[20] < 1e-5, `median ${exact[20]}`);
      assert.ok(exact[37] < 1e-3 && exact[37] < rough[37] / 10, `${exact[37]}, the graph ${rough[37]}`);
    });

  test('both sides of a seam are as far, and so is every corner at a pole', () => {
    const { distances, mesh } = measure('globe', 16);
    const row = (/** @type {number} */ j) => Array.from(distances.subarray(17 * j, 17 * (j + 1)));
    assert.equal(mesh.positions.length / 3, 17 * 17);
    for (let j = 0; j <= 16; j++) assert.equal(row(j)[0], row(j)[16]);
    for (const pole of [0, 16]) assert.equal(new Set(row(pole)).size, 1);
  });
});
