// Exact distances on a plane, with a solver that is told which paths there are: many are about as long, and each that is followed leads to one more.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { spread } from '../../../web/mesh/spread.js';
import { anything } from '../../helpers/refuses.js';

const CELLS = 24;
const NODES = 65;

/** A grid of a square, from one corner of which paths begin. */
function plane() {
  const vertices = Array.from({ length: (CELLS + 1) ** 2 }, (_, i) => [Math.floor(i / (CELLS + 1)), i % (CELLS + 1)].map((x) => x / CELLS));
  const corner = (/** @type {number} */ i, /** @type {number} */ j) => i * (CELLS + 1) + j;
  const indices = Array.from({ length: CELLS ** 2 }, (_, k) => [Math.floor(k / CELLS), k % CELLS]).flatMap(([i, j]) => [
    ...[corner(i, j), corner(i + 1, j), corner(i + 1, j + 1)],
    ...[corner(i, j), corner(i + 1, j + 1), corner(i, j + 1)],
  ]);
  return { vertices, positions: Float64Array.from(vertices.flatMap((vertex) => [...vertex, 0])), indices: Uint32Array.from(indices) };
}

/** A path of that length, bent aside by that much. @param {number[]} to @param {number} length @param {number} aside */
function path([x, y], length, aside) {
  const places = Array.from({ length: NODES }, (_, i) => {
    const t = i / (NODES - 1);
    return [t * x - 4 * aside * t * (1 - t) * y, t * y + 4 * aside * t * (1 - t) * x];
  });
  const points = Float64Array.from(places.flatMap((place) => [...place, 0]));
  return anything({ status: 'converged', length, points, parameters: Float64Array.from(places.flat()) });
}

for (const crowd of [0, 40])
  test(`${crowd ? 'crowded: vertices are searched for' : 'few paths: neighbours lead to each other'}`, () => {
    const { vertices, positions, indices } = plane();
    const direct = vertices.map(([x, y]) => Math.hypot(x, y));
    let [followed, searched] = [0, 0];
    const find = (/** @type {number} */ i, /** @type {Float32Array[]} */ lines) => {
      followed += lines.length;
      searched += Number(lines.length === 0);
      const others = lines.length
        ? Array.from({ length: crowd }, (_, k) => path(vertices[i], direct[i] * (1 + 1e-3 * (k + 1)), (k + 1) * (k % 2 ? 0.02 : -0.02)))
        : [];
      return [path(vertices[i], direct[i], 0), ...others];
    };
    const lengths = spread(
      anything({ positions, indices }),
      Float64Array.from(direct, (length) => 1.01 * length),
      find,
    );
    assert.deepEqual(Array.from(lengths), direct);
    if (crowd) assert.ok(searched >= vertices.length - 1 && followed < 20 * vertices.length, `${followed} lines, ${searched} searches`);
    else assert.ok(searched < 5 && followed < 4 * vertices.length, `${followed} lines, ${searched} searches`);
  });
