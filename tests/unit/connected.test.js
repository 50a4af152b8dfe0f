// What one piece is, and what two: `disconnected` is said of pieces that a fine grid separates, not of creases, thin bodies or flat boxes.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { gallery } from '../../web/gallery.js';
import { load } from '../../web/index.js';
import { createRandom } from '../helpers/random.js';

const surfpath = await load();
const PAIRS = 5;

/** @param {number[]} half sides from the middle @returns {[[number, number], [number, number], [number, number]]} */
const box = ([x, y, z]) => [
  [-x, x],
  [-y, y],
  [-z, z],
];

/** A point of the unit sphere, or where its ray meets the cube. @param {import('../helpers/random.js').Random} random @param {(p: number[]) => number} norm */
function direction(random, norm) {
  const p = [0, 0, 0].map(() => random.between(-1, 1));
  return p.map((x) => x / norm(p));
}

const round = (/** @type {number[]} */ p) => Math.hypot(...p);
const square = (/** @type {number[]} */ p) => Math.max(...p.map(Math.abs));
const CUBE = 'max(abs(x), max(abs(y), abs(z))) - 1';

/** Formula, bounds, what its points are measured by, and what the axes are stretched by.
 * @type {Record<string, [string, [[number, number], [number, number], [number, number]] | undefined, (p: number[]) => number, number[]]>} */
const ONE_PIECE = {
  cube: [CUBE, box([1.2, 1.2, 1.2]), square, [1, 1, 1]],
  'cube without bounds': [CUBE, undefined, square, [1, 1, 1]],
  'ellipsoid of 1e3 : 1e-3 : 1': ['x^2/1e6 + y^2*1e6 + z^2 - 1', box([1100, 1.1e-3, 1.1]), round, [1000, 1e-3, 1]],
  'ellipsoid of 10 : 0.1 : 1': ['x^2/100 + y^2*100 + z^2 - 1', box([11, 0.11, 1.1]), round, [10, 0.1, 1]],
  'disc of 1 : 1 : 0.01': ['x^2 + y^2 + z^2*1e4 - 1', box([1.1, 1.1, 0.011]), round, [1, 1, 0.01]],
};

for (const [name, [f, bounds, norm, stretch]] of Object.entries(ONE_PIECE))
  test(`${name}: one piece, seed 4`, () => {
    const surface = surfpath.implicit({ f, bounds });
    const random = createRandom(4);
    for (let i = 0; i < PAIRS; i++) {
      const [from, to] = [0, 1].map(() => direction(random, norm).map((x, j) => x * stretch[j]));
      const { status } = surface.shortestPath(from, to);
      assert.notEqual(status, 'disconnected', `${from} to ${to}`);
      assert.notEqual(status, 'off-surface', `${from} to ${to}`);
    }
    surface.dispose();
  });

test('across an edge of a cube a path is as long as unfolded', () => {
  const cube = surfpath.implicit({ f: CUBE, bounds: box([1.2, 1.2, 1.2]) });
  const path = cube.shortestPath([0.2, 1, 0.5], [0.3, -0.1, 1]);
  const exact = Math.hypot(0.1, 0.5 + 1.1);
  assert.equal(path.status, 'converged');
  assert.ok(Math.abs(path.length - exact) <= 1e-12, `${path.length}, exact ${exact}`);
  for (let i = 0; i < path.points.length; i += 3) assert.ok(Math.abs(square([...path.points.subarray(i, i + 3)]) - 1) <= 1e-9);
  cube.dispose();
});

test('a thin ellipsoid is solved where its rim is not in between', () => {
  const [f, bounds] = ONE_PIECE['ellipsoid of 10 : 0.1 : 1'];
  const surface = surfpath.implicit({ f, bounds });
  const at = (/** @type {number} */ x, /** @type {number} */ z) => [x, Math.sqrt((1 - (x * x) / 100 - z * z) / 100), z];
  const path = surface.shortestPath(at(-6, -0.3), at(5, 0.4));
  assert.equal(path.status, 'converged');
  const chord = Math.hypot(...at(-6, -0.3).map((x, j) => x - at(5, 0.4)[j]));
  assert.ok(path.length > chord && path.length < 1.01 * chord);
  surface.dispose();
});

test('pieces that lie within each other, a cell apart, are still two', () => {
  const surface = surfpath.surface(gallery.threeTori);
  assert.equal(surface.shortestPath([0, 0, 1.2166683], [0.0208436, 0.0500302, -0.8539475]).status, 'disconnected');
  surface.dispose();
});

test('pieces of what is inside the bounds that hang together outside: the shortest way there, not any', () => {
  const f = 'cos(x)*cos(y)*cos(z) - sin(x)*sin(y)*sin(z)';
  const [narrow, wide] = [2.5, 4].map((half) => surfpath.implicit({ f, bounds: box([half, half, half]) }));
  const ends = /** @type {const} */ ([
    [-1.62, 0.18, 0.26],
    [2.34, 2.3, -2.42],
  ]);
  const [path, shortest] = [narrow, wide].map((surface) => surface.shortestPath(...ends));
  assert.ok(path.converged && Math.max(...path.points.map(Math.abs)) > 2.5);
  assert.ok(Math.abs(path.length / shortest.length - 1) <= 1e-9, `${path.length}, ${shortest.length}`);
  assert.ok(narrow.geodesics(...ends).length > 1);
  for (const surface of [narrow, wide]) surface.dispose();
});

test('a cylinder without bounds, its ends far apart beside its width: one piece, right to the closed form', () => {
  const cylinder = surfpath.implicit({ f: 'x^2 + y^2 - 1' });
  for (const height of [3, 15, 30, 100, 400]) {
    // The straight line nearly meets the axis, from which nothing leads to the surface: nodes there are put between those that settle.
    const angle = Math.PI - 1e-3;
    const [from, to] = [
      [1, 0, 0],
      [Math.cos(angle), Math.sin(angle), height],
    ];
    for (const start of /** @type {const} */ (['straight', 'global'])) {
      const { status, length } = cylinder.shortestPath(from, to, { start });
      assert.equal(status, 'converged', `${start}, height ${height}`);
      assert.ok(Math.abs(length / Math.hypot(angle, height) - 1) < 1e-9, `${start}, height ${height}: ${length}`);
    }
  }
  cylinder.dispose();
});
