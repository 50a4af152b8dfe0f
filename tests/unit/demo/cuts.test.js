// Meshes that are cut where a formula has no value any more, and where it jumps: a smooth rim, no walls.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { meshOf } from '../../../demo/compute/drawable.js';
import { shade } from '../../../demo/compute/shade.js';
import { load } from 'surfpath';

const surfpath = await load();

/** @param {string} z @param {number} [size] */
function open(z, size = 2.5) {
  const definition = { kind: /** @type {const} */ ('graph'), z, x: [-size, size], y: [-size, size] };
  const surface = surfpath.surface(/** @type {any} */ (definition));
  return { surface, drawn: surface, definition };
}

/** The corners of each triangle. @param {import('../../../web/view/drawable.js').SurfaceMesh} mesh */
function trianglesOf({ positions, indices }) {
  const corners = Array.from(indices, (i) => Array.from(positions.subarray(3 * i, 3 * i + 3)));
  return Array.from({ length: corners.length / 3 }, (_, i) => corners.slice(3 * i, 3 * i + 3));
}

/** Signed, seen from above. @param {number[][]} triangle */
const area = ([a, b, c]) => ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;

/** Of all triangles together. @param {number[][][]} triangles */
const areaOf = (triangles) => triangles.reduce((sum, triangle) => sum + area(triangle), 0);

test('the rim of a hemisphere is its circle, and nothing is missing inside', () => {
  const mesh = meshOf(open('sqrt(1-x^2-y^2)'), 96, surfpath);
  /** @type {Map<string, number>} */ const uses = new Map();
  for (let i = 0; i < mesh.indices.length; i++) {
    const key = [mesh.indices[i], mesh.indices[i % 3 === 2 ? i - 2 : i + 1]].sort().join();
    uses.set(key, (uses.get(key) ?? 0) + 1);
  }
  const rim = [...uses].filter(([, count]) => count === 1).flatMap(([key]) => key.split(',').map(Number));
  assert.ok(rim.length > 100);
  for (const i of rim) assert.ok(mesh.positions[3 * i + 2] < 2e-3, `${mesh.positions.subarray(3 * i, 3 * i + 3)}`);
  const triangles = trianglesOf(mesh);
  assert.ok(triangles.every((triangle) => area(triangle) > -1e-12));
  // Chords of a twentieth of the radius.
  assert.ok(Math.abs(areaOf(triangles) / Math.PI - 1) < 2e-3, String(areaOf(triangles)));
});

test('steps have no walls between them, and their whole width', () => {
  // Where two steps cross, edges leap twice.
  for (const z of ['floor(x)', 'floor(2x+y)', 'sign(x*y)', 'floor(x)+floor(y)']) {
    const triangles = trianglesOf(meshOf(open(z, 2.45), 48, surfpath));
    for (const [a, b, c] of triangles) assert.ok(Math.abs(a[2] - b[2]) + Math.abs(a[2] - c[2]) < 1e-9, `${z}: ${[a, b, c].join(' | ')}`);
    assert.ok(Math.abs(areaOf(triangles) / 4.9 ** 2 - 1) < 5e-3, `${z}: ${areaOf(triangles)}`);
  }
});

test('nothing leads across a pole', () => {
  for (const [z, size] of /** @type {[string, number][]} */ ([
    ['1/x', 2.5],
    ['1/x', 2.47],
    ['1/(x-0.013)', 2.5],
  ])) {
    const pole = z === '1/x' ? 0 : 0.013;
    for (const triangle of trianglesOf(meshOf(open(z, size), 48, surfpath)))
      assert.ok(new Set(triangle.map(([x]) => x > pole)).size === 1, `${z}: ${triangle.join(' | ')}`);
  }
});

test('what is only steep is left as it is', () => {
  for (const z of ['tanh(200*(x^2+y^2-2))', 'exp(x^4)', 'x*y', 'abs(x)']) assert.equal(meshOf(open(z), 48, surfpath).twins, undefined, z);
});

test('every colour has a number for each vertex', async () => {
  const opened = open('sqrt(1-x^2-y^2)');
  const { positions, twins } = meshOf(opened, undefined, surfpath);
  assert.ok(twins && twins.length > 100);
  const job = { report: () => {}, isStopped: () => true };
  for (const colour of ['curvature', 'density']) {
    const values = await shade(opened, { colour, from: [0, 0] }, job, surfpath);
    assert.equal(values?.length, positions.length / 3, colour);
  }
  /** @type {number[]} */ const lengths = [];
  await shade(
    opened,
    { colour: 'distance', from: [0, 0] },
    { ...job, report: (/** @type {any} */ { shade: rough }) => lengths.push(rough.length) },
    surfpath,
  );
  assert.deepEqual(lengths, [positions.length / 3]);
});
