// Meshes of the gallery's implicit surfaces: closed, of the right topology, on the surface, and facing the way their exact normals do.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { gallery } from '../../../web/gallery.js';
import { load } from '../../../web/index.js';

/** Euler characteristics, and resolutions besides the default whose cells are small against the surface's thinnest wall. */
const SURFACES = /** @type {const} */ ({
  threeTori: { euler: 0, cells: [76, 96, 128] },
  metamorphosis: { euler: 2, cells: [32, 48, 96, 128] },
  genus2: { euler: -2, cells: [32, 48, 96] },
  torus: { euler: 0, cells: [32, 48, 96] },
  printed47: { euler: -30, cells: [128] },
  banchoffChmutov: { euler: -8, cells: [32, 48] },
  sphere: { euler: 2, cells: [32, 48] },
  ellipsoid: { euler: 2, cells: [32, 48, 96, 128] },
});

const surfpath = await load();

/** @typedef {ReturnType<import('../../../web/surface.js').Surface['mesh']>} Mesh */

/** Edges, of a mesh in which each must be in two triangles, once in each direction. @param {Mesh} mesh */
function countEdges({ indices }) {
  const passed = Float64Array.from(indices, (a, i) => {
    const b = indices[i - (i % 3) + ((i + 1) % 3)];
    return 2 * (Math.min(a, b) * 2 ** 25 + Math.max(a, b)) + Number(a < b);
  }).sort();
  for (let i = 0; i < passed.length; i += 2)
    assert.ok(passed[i] % 2 === 0 && passed[i + 1] === passed[i] + 1 && passed[i + 2] !== passed[i + 1], `edge ${passed[i]}`);
  return passed.length / 2;
}

/** The least cosine between a triangle and the mean of its corners' normals, and the least angle in degrees. @param {Mesh} mesh */
function measureTriangles({ positions, normals, indices }) {
  let [facing, angle] = [1, 180];
  const vector = (/** @type {number} */ from, /** @type {number} */ to) =>
    [0, 1, 2].map((k) => positions[3 * to + k] - positions[3 * from + k]);
  for (let i = 0; i < indices.length; i += 3) {
    const corners = indices.subarray(i, i + 3);
    const [p, q, r] = [0, 1, 2].map((k) => vector(corners[k], corners[(k + 1) % 3]));
    const area = [q[1] * r[2] - q[2] * r[1], q[2] * r[0] - q[0] * r[2], q[0] * r[1] - q[1] * r[0]];
    const mean = [0, 1, 2].map((k) => normals[3 * corners[0] + k] + normals[3 * corners[1] + k] + normals[3 * corners[2] + k]);
    const size = Math.hypot(...area);
    facing = Math.min(facing, area.reduce((sum, x, k) => sum + x * mean[k], 0) / size / Math.hypot(...mean));
    const sides = [p, q, r].map((side) => Math.hypot(...side)).sort((a, b) => a - b);
    angle = Math.min(angle, (Math.asin(Math.min(1, size / sides[1] / sides[2])) * 180) / Math.PI);
  }
  return { facing, angle };
}

/** The largest |f|/|∇f| over the vertices. @param {Float64Array} evaluated */
function worstResidual(evaluated) {
  let worst = 0;
  for (let i = 0; i < evaluated.length; i += 4)
    worst = Math.max(worst, Math.abs(evaluated[i]) / Math.hypot(...evaluated.subarray(i + 1, i + 4)));
  return worst;
}

test('every implicit surface of the gallery is here', () => {
  const implicit = Object.entries(gallery).filter(([, entry]) => entry.kind === 'implicit');
  assert.deepEqual(implicit.map(([name]) => name).sort(), Object.keys(SURFACES).sort());
});

for (const [name, { euler, cells }] of Object.entries(SURFACES))
  test(`${name} at the default resolution, ${cells.join(', ')}`, (context) => {
    const surface = surfpath.surface(gallery[/** @type {keyof typeof SURFACES} */ (name)]);
    for (const resolution of [undefined, ...cells]) {
      const mesh = surface.mesh({ resolution });
      const [vertices, triangles] = [mesh.positions.length / 3, mesh.indices.length / 3];
      const { facing, angle } = measureTriangles(mesh);
      context.diagnostic(
        `${resolution ?? 'default'}: ${triangles} triangles, facing ${facing.toFixed(3)}, least angle ${angle.toFixed(1)}`,
      );
      assert.equal(vertices - countEdges(mesh) + triangles, euler, `${name} at ${resolution}`);
      assert.ok(facing > 0, `${name} at ${resolution}: a triangle at cosine ${facing} to its normals`);
      assert.ok(angle > 1, `${name} at ${resolution}: an angle of ${angle} degrees`);
      // Rounding of f, for coordinates up to 5.7; measured 4.4e-15.
      assert.ok(worstResidual(surface.evaluate(mesh.positions)) < 2e-14, `${name} at ${resolution}`);
    }
    surface.dispose();
  });

test('a wall far thinner than any cell is meshed all the same, with its holes', () => {
  const shell = surfpath.implicit({
    f: '(x^2+y^2+z^2-1)^2-1e-4',
    bounds: [
      [-1.2, 1.2],
      [-1.2, 1.2],
      [-1.2, 1.2],
    ],
  });
  const [usual, finer] = [shell.mesh(), shell.mesh({ resolution: 96 })];
  assert.deepEqual(usual.indices, finer.indices, 'the default is finer where 64 cells bridge sheets');
  assert.ok(worstResidual(shell.evaluate(usual.positions)) < 2e-14);
  shell.dispose();
});

test('slivers that face away where normals hardly differ are no reason for more cells', () => {
  const [f, side] = ['sin(x)*cos(y) + sin(y)*cos(z) + sin(z)*cos(x)', /** @type {[number, number]} */ ([-3.2, 3.2])];
  const gyroid = surfpath.implicit({ f, bounds: [side, side, side] });
  assert.equal(gyroid.mesh().indices.length, gyroid.mesh({ resolution: 64 }).indices.length);
  gyroid.dispose();
});

// Vertices went along their gradients as far as a third of a cell out of the bounds, and triangles back over the rim.
test('where bounds cut a surface its mesh ends on them, and no triangle is folded back', () => {
  const f = 'sin(2.931x)*cos(2.571y) + sin(2.571y)*cos(3.3z) + sin(3.3z)*cos(2.931x) - 0.007';
  const side = /** @type {[number, number]} */ ([-1.5, 1.5]);
  const gyroid = surfpath.implicit({ f, bounds: [side, side, side] });
  for (const resolution of [16, 64, 128]) {
    const mesh = gyroid.mesh({ resolution });
    assert.ok(mesh.positions.every((x) => Math.abs(x) <= 1.5));
    const { facing } = measureTriangles(mesh);
    assert.ok(facing > 0, `${resolution}: a triangle at cosine ${facing} to its normals`);
    assert.ok(worstResidual(gyroid.evaluate(mesh.positions)) < 2e-14);
  }
  gyroid.dispose();
});

// Once there were walls of triangles: lids where the formula ends, sheets along poles.
for (const f of ['sqrt(z) + x^2 + y^2 - 1', 'acos(x) - y - 1', 'y - 1/x', 'tan(2x) + y', 'floor(x + 0.3) + y', 'log(x) + y*z'])
  test(`${f} = 0: nothing but surface where f jumps, is infinite or no number`, () => {
    const side = /** @type {const} */ ([-2, 2]);
    const surface = surfpath.implicit({ f, bounds: [side, side, side] });
    const { positions, normals, indices } = surface.mesh();
    const values = surface.evaluate(positions);
    let count = 0;
    for (let i = 0; i < positions.length / 3; i++) {
      const numbers = [...positions.subarray(3 * i, 3 * i + 3), ...normals.subarray(3 * i, 3 * i + 3)];
      if (numbers.every(Number.isNaN)) continue;
      assert.ok(numbers.every(Number.isFinite) && Math.abs(values[4 * i]) < 1e-12, `f = ${values[4 * i]} at ${numbers}`);
      count++;
    }
    assert.ok(count > 4000 && count < positions.length / 3, `${count} of ${positions.length / 3} vertices`);
    assert.ok(indices.every((vertex) => vertex < positions.length / 3));
    surface.dispose();
  });

test('a fifth root of f has the mesh of f', () => {
  const side = /** @type {const} */ ([-1.2, 1.2]);
  const meshes = ['x^2 + y^2 + z^2 - 1', 'sign(x^2 + y^2 + z^2 - 1)*abs(x^2 + y^2 + z^2 - 1)^0.2'].map((f) => {
    const surface = surfpath.implicit({ f, bounds: [side, side, side] });
    const { positions, indices } = surface.mesh({ resolution: 24 });
    assert.ok(positions.every(Number.isFinite));
    surface.dispose();
    return indices.length;
  });
  assert.equal(meshes[0], meshes[1]);
});
