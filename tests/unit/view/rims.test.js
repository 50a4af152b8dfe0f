// Meshes of flat bodies and of creases, as they are drawn: finer where they bend within a cell, closed, on the surface.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { gallery } from '../../../web/gallery.js';
import { load } from '../../../web/index.js';
import { cross, dot } from '../../../web/vector.js';
import { drawableMesh } from '../../../web/view/drawable.js';
import { surfaceGeometry } from '../../../web/view/geometry.js';

const surfpath = await load();
const bounds = /** @type {[[number, number], [number, number], [number, number]]} */ ([1, 2, 3].map(() => [-1.2, 1.2]));
const bodyOf = (/** @type {string} */ f) => surfpath.implicit({ f, bounds });
const flat = (/** @type {number} */ by) => bodyOf(`x^2 + y^2 + ${by ** 2}*z^2 - 1`);

/** Area of the triangles that a corner's normal stands across, or on the other side of: they would be dark, seen from where the surface is light. @param {import('../../../web/mesh/mesh.js').Mesh} mesh */
function dark({ positions, normals, indices }) {
  const at = (/** @type {Float64Array} */ list, /** @type {number} */ i) => list.subarray(3 * i, 3 * i + 3);
  let area = 0;
  for (let i = 0; i < indices.length; i += 3) {
    const corners = indices.subarray(i, i + 3);
    const [a, b, c] = Array.from(corners, (corner) => at(positions, corner));
    const facing = cross(
      b.map((x, k) => x - a[k]),
      c.map((x, k) => x - a[k]),
    );
    const double = Math.hypot(...facing);
    if (corners.some((corner) => dot(at(normals, corner), facing) < 0.1 * double)) area += double / 2;
  }
  return area;
}

for (const by of [10, 30])
  test(`the rim of a body that is 1:${by} flat is closed and, where it is as thick as a cell, shaded as it bends`, () => {
    const body = flat(by);
    const mesh = body.mesh();
    const drawn = drawableMesh(body, mesh);
    if (by === 10) assert.ok(dark(drawn) < 0.1 * dark(mesh), `${dark(drawn)} of ${dark(mesh)}`);
    const values = body.evaluate(drawn.positions);
    // What six steps of Newton's method leave: of a pixel a thousandth.
    for (let i = 0; i < values.length; i += 4) assert.ok(Math.abs(values[i]) < 1e-6, `${values[i]}`);
    /** How often each edge is passed one way more than the other. @type {Map<string, number>} */ const passes = new Map();
    for (const [i, one] of drawn.indices.entries()) {
      const other = drawn.indices[i % 3 === 2 ? i - 2 : i + 1];
      const [key, way] = one < other ? [`${one} ${other}`, 1] : [`${other} ${one}`, -1];
      passes.set(key, (passes.get(key) ?? 0) + way);
    }
    assert.ok([...passes.values()].every((sum) => sum === 0));
  });

test('it begins with the vertices of the mesh, and those added are beside some of them', () => {
  const body = flat(10);
  const mesh = body.mesh();
  const { positions, twins = [] } = drawableMesh(body, mesh);
  assert.deepEqual(positions.subarray(0, mesh.positions.length), mesh.positions);
  assert.equal(positions.length, mesh.positions.length + 3 * twins.length);
  const first = mesh.positions.length;
  for (const [i, twin] of twins.entries()) {
    const gap = Math.hypot(...[0, 1, 2].map((k) => positions[first + 3 * i + k] - mesh.positions[3 * twin + k]));
    assert.ok(gap < 0.1, `${gap}`);
  }
  const { attributes } = surfaceGeometry(body, { colour: 'distance', from: [1, 0, 0] });
  assert.equal(attributes.color.count, attributes.position.count);
});

test('what bends little within a cell is as it was', () => {
  for (const name of /** @type {const} */ (['sphere', 'torus', 'genus2', 'threeTori'])) {
    const surface = surfpath.surface(gallery[name]);
    const mesh = surface.mesh();
    assert.equal(drawableMesh(surface, mesh), mesh);
  }
});

test('a crease is as sharp as its cells are fine, and what has no surface stays empty', () => {
  const cube = bodyOf('max(abs(x), abs(y), abs(z)) - 1');
  const mesh = cube.mesh();
  const { positions, normals, indices } = drawableMesh(cube, mesh);
  assert.ok(indices.length > mesh.indices.length);
  assert.ok(positions.every(Number.isFinite) && normals.every(Number.isFinite));
  const empty = bodyOf('x^2 + y^2 + z^2 + 1');
  assert.equal(drawableMesh(empty, empty.mesh()).indices.length, 0);
});
