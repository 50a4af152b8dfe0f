// Creases on which the surface stands upright, as a root does where what it is taken of is 0. What is exact is known by unrolling, or from an implicit body.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { load } from '../../../web/index.js';
import { createRandom } from '../../helpers/random.js';
import { ofAll } from '../../helpers/sample.js';
import { simpson } from '../../helpers/simpson.js';

const surfpath = await load();
/** Two tolerances of 1e-9, relative. */
const RIGHT = 2e-9;

test('on the ground beside a dome that stands upright on it, a root of what is 0 there, paths are straight', () => {
  const dome = surfpath.graph({ z: 'sqrt(max(0, 1 - x^2 - y^2))', x: [-1.2, 1.2], y: [-1.2, 1.2] });
  assert.deepEqual([...dome.evaluate([1.1, 1.1])], [1.1, 1.1, 0, 0, 0, 1]);
  const path = dome.shortestPath([-0.349, 1.2], [-1.187, 1.192]);
  assert.equal(path.status, 'converged');
  assert.ok(Math.abs(path.length - Math.hypot(0.838, 0.008)) <= 1e-12);
  dome.dispose();
});

test('over the upright rim of a half cylinder that lies on the ground: as long as unrolled, seed 8', () => {
  const radius = 0.5;
  const half = surfpath.graph({ z: `sqrt(max(0, ${radius ** 2} - x^2))`, x: [-1, 1], y: [-1, 1] });
  const unrolled = (/** @type {number} */ x) =>
    Math.sign(x) * (radius * Math.asin(Math.min(1, Math.abs(x) / radius)) + Math.max(0, Math.abs(x) - radius));
  const random = createRandom(8);
  for (let i = 0; i < 8; i++) {
    const [from, to] = [0, 1].map(() => [random.between(-1, 1), random.between(-1, 1)]);
    const exact = Math.hypot(unrolled(to[0]) - unrolled(from[0]), to[1] - from[1]);
    const path = half.shortestPath(from, to);
    assert.equal(path.status, 'converged', `${from} to ${to}`);
    assert.ok(
      Math.abs(path.length - exact) <= Math.min(path.lengthError + RIGHT * exact, 1e-6),
      `${from} to ${to}: ${path.length}, exact ${exact}`,
    );
  }
  half.dispose();
});

test('across a crease on which slopes are infinite on both sides: as long as unrolled, seed 3', () => {
  const root = surfpath.graph({ z: 'sqrt(abs(x))', x: [-1, 1], y: [-1, 1] });
  /* As a function of z x is smooth up to the crease. */
  const unrolled = (/** @type {number} */ x) => Math.sign(x) * simpson((z) => Math.hypot(1, 2 * z), 0, Math.sqrt(Math.abs(x)));
  const random = createRandom(3);
  for (let i = 0; i < ofAll(8, 40); i++) {
    const [from, to] = [-1, 1].map((side) => [side * random.between(0.01, 1), random.between(-1, 1)]);
    const exact = Math.hypot(unrolled(to[0]) - unrolled(from[0]), to[1] - from[1]);
    const path = root.shortestPath(from, to);
    assert.equal(path.status, 'converged', `${from} to ${to}`);
    assert.ok(Math.abs(path.length - exact) <= RIGHT * exact, `${from} to ${to}: ${path.length}, exact ${exact}`);
  }
  root.dispose();
});

test('over a roof of roots along both axes, and to its edge: as long as mirrored, seed 5', () => {
  const roof = surfpath.graph({ z: 'sqrt(abs(x)) + sqrt(abs(y))', x: [-1, 1], y: [-1, 1] });
  const random = createRandom(5);
  const mirrored = (/** @type {number[]} */ [x, y]) => [y, x];
  const toEdge = [
    [0.7, 0.825],
    [0.953, -0.763],
  ];
  assert.ok(roof.shortestPath(toEdge[0], toEdge[1]).touchesBoundary);
  const others = Array.from({ length: ofAll(4, 20) }, () => [0, 1].map(() => [random.between(-1, 1), random.between(-1, 1)]));
  for (const [from, to] of [toEdge, ...others]) {
    const [path, other] = [roof.shortestPath(from, to), roof.shortestPath(mirrored(from), mirrored(to))];
    assert.equal(path.status, 'converged', `${from} to ${to}`);
    assert.ok(Math.abs(path.length - other.length) <= RIGHT * path.length, `${from} to ${to}: ${path.length}, ${other.length}`);
  }
  roof.dispose();
});

test('from a place to itself, and by a start that goes nowhere, the path has length 0', () => {
  const fold = surfpath.graph({ z: 'abs(x)', x: [-1, 1], y: [-1, 1] });
  const place = [0.3, 0.2];
  for (const start of ['global', [...place, ...place, ...place]]) {
    const path = fold.shortestPath(place, place, { start: /** @type {'global' | number[]} */ (start) });
    assert.deepEqual([path.status, path.length], ['converged', 0]);
  }
  fold.dispose();
});

test('over the upright rim of a dome, and around it: as long as on the body that is half space and ellipsoid, seed 7', () => {
  const [radius, height] = [0.6, 0.5];
  const rise = (/** @type {number[]} */ [x, y]) => height * Math.sqrt(Math.max(0, 1 - (x * x + y * y) / radius ** 2));
  const dome = surfpath.graph({ z: `${height}*sqrt(max(0, 1 - (x^2 + y^2)/${radius ** 2}))`, x: [-1, 1], y: [-1, 1] });
  const body = surfpath.implicit({
    f: `min(z, (x^2 + y^2)/${radius ** 2} + z^2/${height ** 2} - 1)`,
    bounds: [
      [-1.1, 1.1],
      [-1.1, 1.1],
      [-0.3, 0.8],
    ],
  });
  const random = createRandom(7);
  const pairs = ofAll(8, 30);
  let converged = 0;
  for (let i = 0; i < pairs; i++) {
    const [from, to] = [0, 1].map(() => [random.between(-1, 1), random.between(-1, 1)]);
    const path = dome.shortestPath(from, to);
    const other = body.shortestPath([...from, rise(from)], [...to, rise(to)]);
    if (!path.converged) continue;
    converged++;
    assert.equal(other.status, 'converged', `${from} to ${to}`);
    assert.ok(
      Math.abs(path.length - other.length) <= path.lengthError + RIGHT * path.length,
      `${from} to ${to}: ${path.length}, not ${other.length}`,
    );
  }
  /* Where a path touches the rim for a moment it may come to no rest. */
  assert.ok(converged >= 0.9 * pairs, `${converged} of ${pairs}`);
  for (const surface of [dome, body]) surface.dispose();
});

test('a step beside an upright crease stays one, however steep the surface is there', () => {
  const torn = surfpath.graph({ z: 'sqrt(max(0, x)) + 0.001*sign(x)', x: [-1, 1], y: [-1, 1] });
  assert.notEqual(torn.shortestPath([-0.5, 0.1], [0.5, 0.3]).status, 'converged');
  torn.dispose();
});
