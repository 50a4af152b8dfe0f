// Implicit bodies much wider than thick: meshes without holes, and paths around rims as sharp as the square of what the bodies are thick. Against bodies of the same shape that are turned,
// bounds that are not theirs, a surface of revolution, and areas by quadrature.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { load } from '../../web/index.js';
import { boxOf, findExtent, flatnessOf, isCrossed } from '../../web/manifold/extent.js';
import { createRandom } from '../helpers/random.js';
import { ofAll } from '../helpers/sample.js';
import { verifyPath } from '../helpers/verify-path.js';

const surfpath = await load();
/** Two tolerances of 1e-9, relative: one of each path. */
const RIGHT = 2e-9;
const EVERYWHERE = 1.2;
/** Ends nearly opposite to each other through the middle have a circle of ways around the rim that are nearly as long: these need not be solved to the tolerance, but to this. */
const ROUGHLY = 1e-4;
const NEARLY = ['tolerance-not-met', 'ill-conditioned', 'iteration-limit'];

/** @typedef {import('../../web/mesh/mesh.js').Mesh} Mesh */
/** @typedef {import('../../web/definition.js').ImplicitDefinition['bounds']} Bounds */

/** @param {number[]} half @returns {Bounds} */
const within = (half) => /** @type {any} */ (half.map((x) => [-x, x]));

/** What is of each body: f, half extents, Euler characteristic, area, if it is known, and of how many ends paths are few. */
const BODIES = [
  { title: 'an ellipsoid, 30:1', f: 'x^2 + y^2 + 900z^2 - 1', half: [1, 1, 1 / 30], euler: 2, area: areaOfEllipsoid(1 / 30) },
  /* Its second pair, nearly opposite, takes seconds; that of the coin is as hard. */
  { title: 'an ellipsoid, 100:1', f: 'x^2 + y^2 + 10000z^2 - 1', half: [1, 1, 0.01], euler: 2, area: areaOfEllipsoid(0.01), few: 2 },
  { title: 'a coin, 100:1', f: '(x^2 + y^2)^4 + 10000z^2 - 1', half: [1, 1, 0.01], euler: 2 },
  { title: 'a plate, 120:1', f: '(x/2)^8 + (y/2)^8 + (60z)^2 - 1', half: [2, 2, 1 / 60], euler: 2 },
  { title: 'a flat ring', f: '(sqrt(x^2 + y^2) - 1)^2/0.09 + (50z/0.3)^2 - 1', half: [1.3, 1.3, 0.006], euler: 0 },
];

/** Of half axes 1, 1 and c. @param {number} c */
function areaOfEllipsoid(c) {
  const e = Math.sqrt(1 - c * c);
  return 2 * Math.PI * (1 + ((c * c) / e) * Math.atanh(e));
}

/** Edges in one triangle alone, vertices − edges + triangles, and the area. @param {Mesh} mesh */
function measure({ positions, indices }) {
  /** @type {Map<number, number>} */
  const edges = new Map();
  const vertices = new Set(indices);
  let area = 0;
  for (let i = 0; i < indices.length; i += 3) {
    for (let k = 0; k < 3; k++) {
      const [a, b] = [indices[i + k], indices[i + ((k + 1) % 3)]];
      const edge = Math.min(a, b) * 2 ** 25 + Math.max(a, b);
      edges.set(edge, (edges.get(edge) ?? 0) + 1);
    }
    const [p, q, r] = [0, 1, 2].map((k) => positions.subarray(3 * indices[i + k], 3 * indices[i + k] + 3));
    const [u, v] = [q, r].map((to) => [0, 1, 2].map((j) => to[j] - p[j]));
    area += Math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2;
  }
  return { open: [...edges.values()].filter((count) => count !== 2).length, euler: vertices.size - edges.size + indices.length / 3, area };
}

/** Points of a body z = ±h(x, y), on either side. @param {import('../../web/surface.js').Surface} surface @param {number[]} half @param {number} seed @param {number} count */
function randomPlaces(surface, half, seed, count) {
  const random = createRandom(seed);
  /** @type {number[][]} */
  const places = [];
  while (places.length < count) {
    const [x, y, side] = [random.between(-half[0], half[0]), random.between(-half[1], half[1]), random.between(-1, 1)];
    const f = (/** @type {number} */ z) => surface.evaluate([x, y, z])[0];
    let [low, high] = [0, 2 * half[2]];
    if (f(low) > 0) continue;
    for (let i = 0; i < 60; i++) [low, high] = f((low + high) / 2) < 0 ? [(low + high) / 2, high] : [low, (low + high) / 2];
    places.push([x, y, Math.sign(side) * low]);
  }
  return places;
}

for (const { title, f, half, euler, area, few = 4 } of BODIES) {
  describe(title, () => {
    const [longest] = half;
    const cubes = within([longest, longest, longest].map((x) => EVERYWHERE * x));
    for (const [name, bounds] of /** @type {const} */ ([
      ['its own bounds', within(half.map((x) => EVERYWHERE * x))],
      ['bounds of a ball', cubes],
    ]))
      test(`a mesh within ${name} is closed, of its topology, on the surface and as large`, () => {
        const surface = surfpath.implicit({ f, bounds });
        const mesh = surface.mesh();
        const found = measure(mesh);
        assert.equal(found.open, 0);
        assert.equal(found.euler, euler);
        if (area) assert.ok(Math.abs(found.area / area - 1) < 1e-3, `${found.area} for ${area}`);
        const values = surface.evaluate(mesh.positions);
        for (let i = 0; i < values.length; i += 4) {
          const slope = Math.hypot(...values.subarray(i + 1, i + 4));
          const cosine = mesh.normals.subarray((3 * i) / 4, (3 * i) / 4 + 3).reduce((sum, x, j) => sum + x * values[i + 1 + j], 0) / slope;
          assert.ok(Math.abs(values[i]) / slope < 1e-12 * longest && cosine > 1 - 1e-9);
        }
        surface.dispose();
      });

    test('paths from side to side converge, within whatever bounds and without, both ways', () => {
      const own = surfpath.implicit({ f, bounds: within(half.map((x) => EVERYWHERE * x)) });
      const others = [surfpath.implicit({ f, bounds: cubes }), surfpath.implicit({ f })];
      const places = randomPlaces(own, half, 7, ofAll(few, 12));
      let converged = 0;
      for (let i = 0; i < places.length; i += 2) {
        const path = own.shortestPath(places[i], places[i + 1]);
        const back = own.shortestPath(places[i + 1], places[i]);
        assert.equal(back.length, path.length);
        assert.deepEqual(back.points.slice(0, 3), path.points.slice(-3));
        for (const { status, length } of [path, ...others.map((other) => other.shortestPath(places[i], places[i + 1]))]) {
          if (status === 'converged') converged++;
          assert.ok(status === 'converged' || NEARLY.includes(status), `pair ${i / 2}: ${status}`);
          const right = status === 'converged' && path.converged ? RIGHT : ROUGHLY;
          assert.ok(Math.abs(length / path.length - 1) < right, `pair ${i / 2}: ${length} for ${path.length}`);
        }
      }
      const solved = (3 * places.length) / 2;
      // All but those of one pair; of one pair all.
      assert.ok(converged >= Math.max(solved - 3, 3), `${converged} of ${solved}`);
      for (const surface of [own, ...others]) surface.dispose();
    });
  });
}

test('as on the surface of revolution, by its angles', () => {
  const body = surfpath.implicit({ f: 'x^2 + y^2 + 10000z^2 - 1', bounds: within([1.1, 1.1, 0.011]) });
  const turned = surfpath.revolution({ r: 'cos(t)', z: 'sin(t)/100', t: ['-pi/2', 'pi/2'] });
  const random = createRandom(4);
  let compared = 0;
  for (let i = 0; i < ofAll(3, 6); i++) {
    const ends = [1, -1].map((side) => [random.between(0, 6), side * random.between(0.3, 1.2)]);
    const path = turned.shortestPath(ends[0], ends[1]);
    if (!path.converged) continue;
    const [from, to] = ends.map(([u, t]) => [Math.cos(t) * Math.cos(u), Math.cos(t) * Math.sin(u), Math.sin(t) / 100]);
    const { status, length } = body.shortestPath(from, to);
    assert.ok(status === 'converged' || status === 'ill-conditioned', status);
    assert.ok(Math.abs(length / path.length - 1) < RIGHT, `${length} for ${path.length}`);
    compared++;
  }
  assert.ok(compared >= ofAll(2, 3), String(compared));
});

describe('an ellipsoid that lies obliquely, 100:1', () => {
  const f = '((x + y)/sqrt(2))^2 + ((x - y + z)/sqrt(3))^2 + (100*(x - y - 2z)/sqrt(6))^2 - 1';
  const oblique = surfpath.implicit({ f, bounds: within([1.2, 1.2, 1.2]) });
  const straight = surfpath.implicit({ f: 'x^2 + y^2 + 10000z^2 - 1', bounds: within([1.2, 1.2, 1.2]) });
  const turn = (/** @type {number[]} */ [x, y, z]) => [
    x / Math.SQRT2 + y / Math.sqrt(3) + z / Math.sqrt(6),
    x / Math.SQRT2 - y / Math.sqrt(3) - z / Math.sqrt(6),
    y / Math.sqrt(3) - (2 * z) / Math.sqrt(6),
  ];

  test('has the mesh and the paths of one that does not', () => {
    const { open, euler, area } = measure(oblique.mesh());
    assert.deepEqual([open, euler], [0, 2]);
    assert.ok(Math.abs(area / areaOfEllipsoid(0.01) - 1) < 1e-3);
    const places = randomPlaces(straight, [1, 1, 0.01], 11, ofAll(4, 10));
    for (let i = 0; i < places.length; i += 2) {
      const [path, other] = [straight.shortestPath(places[i], places[i + 1]), oblique.shortestPath(turn(places[i]), turn(places[i + 1]))];
      assert.equal(other.status, 'converged');
      assert.ok(Math.abs(other.length / path.length - 1) < RIGHT, `${other.length} for ${path.length}`);
    }
  });
});

test('a path around the rim is a geodesic on the surface that was given', () => {
  const definition = { kind: 'implicit', f: '(x/2)^8 + (y/2)^8 + (60z)^2 - 1', bounds: within([2.2, 2.2, 0.02]) };
  const plate = surfpath.implicit(definition);
  const [from, to] = [
    [0.8, 1.7, -0.01],
    [1.2, -0.4, 0.016],
  ].map((place) => plate.project(place));
  const path = plate.shortestPath(from, to, { points: 2000 });
  assert.ok(path.converged);
  const violations = verifyPath(/** @type {any} */ (definition), path, {
    from,
    to,
    lengthTolerance: 1e-4,
    equalChords: false,
    tolerance: Infinity,
  });
  assert.deepEqual(violations, []);
});

test('under a density of 2 paths are twice as long; a parameter that changes makes another body', () => {
  const f = 'x^2 + y^2 + (k*z)^2 - 1';
  const bounds = within([1.2, 1.2, 1.2]);
  const [body, dense] = [{}, { density: '2 + 0x' }].map((more) => surfpath.implicit({ f, bounds, parameters: { k: 100 }, ...more }));
  const ends = [
    [0.6307, 0.704, -1],
    [-0.3066, -0.1419, 1],
  ];
  /* The flatter, the slower. */
  for (const k of ofAll([30, 25], [30, 25, 100, 80])) {
    for (const surface of [body, dense]) surface.set({ k });
    const [from, to] = ends.map(([x, y, side]) => [x, y, (side * Math.sqrt(1 - x * x - y * y)) / k]);
    const [path, twice] = [body, dense].map((surface) => surface.shortestPath(from, to));
    assert.deepEqual([path.status, twice.status], ['converged', 'converged']);
    assert.ok(Math.abs(twice.length / path.length / 2 - 1) < RIGHT);
  }
});

test('two wavy sheets 0.02 apart have a mesh of two pieces without holes', () => {
  const surface = surfpath.implicit({ f: '(z - 0.2*sin(3x)*cos(2y))^2 - 0.0001', bounds: within([1.2, 1.2, 0.26]) });
  assert.equal(measure(surface.mesh()).euler, 2);
});

test('a flat body that its bounds cut ends at them, and nowhere else', () => {
  const surface = surfpath.implicit({
    f: 'x^2 + y^2 + 10000z^2 - 1',
    bounds: /** @type {any} */ ([[-1.2, 0.3], ...(within([1.2, 1.2]) ?? [])]),
  });
  const mesh = surface.mesh();
  assert.equal(measure(mesh).euler, 1);
  assert.ok(mesh.positions.every((x, k) => k % 3 > 0 || x <= 0.3));
});

test('extents: along the axes of space or of the body, also where no lattice point lies in it', () => {
  const box = [-1.2, 1.25, -1.2, 1.2, -1.1, 1.3];
  const find = (/** @type {string} */ f) => findExtent((places) => surfpath.implicit({ f }).evaluate(places), box);
  const flat = find('x^2 + y^2 + (1000*(z - 0.0301))^2 - 1');
  assert.ok(flat && flatnessOf(flat) > 900 && Math.abs(flat.middle[2] - 0.0301) < 1e-5);
  assert.ok(boxOf(flat, box).every((x, k) => (k % 2 ? x >= [1, 1, 0.0311][k >> 1] : x <= [-1, -1, 0.0291][k >> 1])));
  assert.ok(flatnessOf(/** @type {any} */ (find('x^2 + y^2 + z^2 - 1'))) < 1.1);
  const oblique = find('(x + y)^2/2 + z^2 + 1250*(x - y)^2 - 1');
  assert.ok(oblique && flatnessOf(oblique) > 40);
  assert.equal(find('x^2 + y^2 + z^2 + 1'), null);
});

test('what crosses the faces of a box goes on beyond, what lies within does not', () => {
  const box = [-1.2, 1.25, -1.2, 1.2, -1.1, 1.3];
  const crosses = (/** @type {string} */ f) => isCrossed((places) => surfpath.implicit({ f }).evaluate(places), box);
  for (const f of ['z - 0.9*x', 'x^2 + y^2 + z^2 - 1.5', 'sin(5x)*cos(5y) + sin(5y)*cos(5z) + sin(5z)*cos(5x)']) assert.ok(crosses(f), f);
  for (const f of ['x^2 + y^2 + z^2 - 1', 'x^2 + y^2 + (1000*(z - 0.0301))^2 - 1', 'x^2 + y^2 + z^2 + 1']) assert.ok(!crosses(f), f);
});
