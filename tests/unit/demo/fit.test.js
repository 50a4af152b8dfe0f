// The camera of the page: it stands where all points just fill the view, and how much of the view they take is told.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { BufferAttribute, Matrix4, PerspectiveCamera, Vector3 } from 'three';
import { shareOfView } from '../../../demo/stage/fit.js';
import { drawableMesh } from '../../../web/view/drawable.js';
import { fitView } from '../../../web/view/fit.js';
import { pointsWithin, rangesWithoutSpikes } from '../../../web/view/spikes.js';
import { load } from 'surfpath';

const SLOPES = [0.4, 0.3];
const CUBE = new BufferAttribute(Float32Array.from([-1, 1].flatMap((x) => [-1, 1].flatMap((y) => [-1, 1].flatMap((z) => [x, y, z])))), 3);

/** To the camera that looks at a place from a distance. @param {Vector3} target @param {Vector3} towards @param {number} distance */
function matrixFrom(target, towards, distance) {
  const camera = new PerspectiveCamera();
  camera.up.set(0, 0, 1);
  camera.position.copy(target).addScaledVector(towards, distance);
  camera.lookAt(target);
  camera.updateMatrixWorld();
  return camera.matrixWorldInverse;
}

test('what is fitted reaches the edge of the view, and not beyond', () => {
  const towards = new Vector3(0.5, -0.7, 0.4).normalize();
  const { target, distance } = fitView(CUBE, new Vector3(), towards, new Vector3(0, 0, 1), SLOPES);
  const { reach, extent } = shareOfView(CUBE, matrixFrom(target, towards, distance), SLOPES);
  // The target moves a last time after the distance is known.
  assert.ok(reach > 0.99 && reach < 1.01, String(reach));
  assert.ok(extent > 0.98 && extent < 1.01, String(extent));
});

test('from afar it takes less, in parts of the view', () => {
  const { reach, extent } = shareOfView(CUBE, new Matrix4().makeTranslation(0, 0, -101), SLOPES);
  assert.ok(Math.abs(reach - 1 / (100 * 0.3)) < 1e-12);
  assert.ok(Math.abs(extent - reach) < 1e-12);
});

test('behind the camera nothing is seen', () => {
  assert.equal(shareOfView(CUBE, new Matrix4(), SLOPES).reach, Infinity);
});

/** Points of a graph over the square of 5. @param {(x: number, y: number) => number} z */
const graphOf = (z) =>
  new BufferAttribute(
    Float32Array.from(
      Array.from({ length: 50 * 50 }, (_, i) => [(i % 50) / 10 - 2.45, Math.floor(i / 50) / 10 - 2.45]).flatMap(([x, y]) => [
        x,
        y,
        z(x, y),
      ]),
    ),
    3,
  );

/** @param {import('three').BufferAttribute} points @param {number[][]} [ends] */
const withoutSpikes = (points, ends) => pointsWithin(points, rangesWithoutSpikes(points, ends, 6), ends);

test('spikes beside a pole are not looked at, all of what is only steep is', () => {
  for (const [low, high, z] of /** @type {[number, number, (x: number, y: number) => number][]} */ ([
    [-5, 5, (x) => 1 / x],
    [0, 8, (x, y) => 1 / (x * x + y * y)],
    [-20, 20, (x) => Math.tan(x)],
  ])) {
    const points = withoutSpikes(graphOf(z));
    assert.ok(points, String(z));
    const heights = Array.from({ length: points.count }, (_, i) => points.getZ(i));
    assert.ok(points.count > 0.9 * 50 * 50, `${z}: ${points.count}`);
    assert.ok(Math.min(...heights) >= low && Math.max(...heights) <= high, `${z}: ${Math.min(...heights)} … ${Math.max(...heights)}`);
  }
  for (const z of /** @type {((x: number, y: number) => number)[]} */ ([
    (x, y) => 60 * x * y,
    (x) => 2 * x ** 3,
    (x) => 100 * x,
    (x) => Math.exp(x),
    (x, y) => 3 * Math.exp(-4 * (x * x + y * y)),
  ]))
    assert.equal(withoutSpikes(graphOf(z)), null, String(z));
});

test('of what is so steep that all of it would be a thread, the part is looked at that is as high as wide', () => {
  for (const z of /** @type {((x: number, y: number) => number)[]} */ ([
    (x) => Math.exp(x ** 4),
    (x, y) => Math.exp(x ** 4 + y ** 4),
    (x) => Math.exp(5 * x),
    (x) => x ** 9,
  ])) {
    const points = withoutSpikes(graphOf(z), [[2, 0, z(2, 0)]]);
    assert.ok(points, String(z));
    const heights = Array.from({ length: points.count }, (_, i) => points.getZ(i));
    assert.ok(Math.max(...heights) - Math.min(...heights) <= 4.9 && points.count > 0.15 * 50 * 50, `${z}: ${points.count}`);
  }
});

test('of what is as steep everywhere, and would be a thread, a part near its middle is looked at', () => {
  for (const z of /** @type {((x: number, y: number) => number)[]} */ ([(x) => 1e4 * x, (x, y) => 1e9 * x * y])) {
    const [low, high] = rangesWithoutSpikes(graphOf(z))[2];
    assert.ok(high - low < 6 && Math.abs(low) < 0.05 * z(2.45, 2.45), `${z}: ${low} … ${high}`);
  }
});

test('but all of what is as long as it was asked for', () => {
  const points = graphOf((x) => 0.3 * Math.sin(1000 * x));
  for (let i = 0; i < points.count; i++) points.setX(i, 1000 * points.getX(i));
  assert.equal(pointsWithin(points, rangesWithoutSpikes(points, [], 6, 2)), null);
  const [low, high] = rangesWithoutSpikes(
    graphOf((x) => 1e4 * x),
    [],
    6,
    2,
  )[2];
  assert.ok(high - low < 6, `its height was not: ${low} … ${high}`);
});

test('what is too high to be drawn, or has no value, does not tell which part is looked at', async () => {
  const surfpath = await load();
  for (const z of ['exp(9*x^2)', 'x^y', 'exp(20*x)']) {
    const surface = surfpath.graph({ z, x: [-2.5, 2.5], y: [-2.5, 2.5] });
    const [low, high] = rangesWithoutSpikes(new BufferAttribute(drawableMesh(surface, surface.mesh()).positions, 3))[2];
    assert.ok(low >= 0 && low <= 1 && high > 4 && high < 12, `${z}: ${low} … ${high}`);
    surface.dispose();
  }
});

test('of a single place the camera is there, not nowhere', () => {
  const point = new BufferAttribute(Float32Array.of(1, 2, 3), 3);
  const { target, distance } = fitView(point, new Vector3(1, 2, 3), new Vector3(1, 0, 0), new Vector3(0, 0, 1), SLOPES);
  assert.deepEqual([...target, distance], [1, 2, 3, 0]);
});

test('spikes may be along two axes', () => {
  const points = graphOf((x) => x);
  for (let i = 0; i < points.count; i++) points.setXY(i, Math.tan(0.64 * points.getX(i)), Math.tan(0.64 * points.getY(i)));
  const ranges = rangesWithoutSpikes(points);
  for (const [low, high] of ranges.slice(0, 2)) assert.ok(high - low > 10 && high - low < 40, `${low} … ${high}`);
  assert.deepEqual(ranges[2], [-Infinity, Infinity]);
});

test('but where an end of the path is on one, it is seen', () => {
  const points = withoutSpikes(
    graphOf((x) => 1 / x),
    [[0.05, 0, 20]],
  );
  assert.ok(points && Math.max(...Array.from({ length: points.count }, (_, i) => points.getZ(i))) > 19);
});

test('an end outside the bounds of an implicit surface is seen, too; not one far out', () => {
  const many = new BufferAttribute(
    Float32Array.from({ length: 3 * 20_000 }, (_, i) => CUBE.array[i % 24]),
    3,
  );
  for (const points of [CUBE, many]) {
    const ends = [
      [1, 0, 0.5],
      [0, 2.5, 0],
    ];
    const towards = new Vector3(1, 0, 0);
    const { target, distance } = fitView(withoutSpikes(points, ends) ?? points, new Vector3(), towards, new Vector3(0, 0, 1), SLOPES);
    const seen = new BufferAttribute(Float32Array.from(ends.flat()), 3);
    assert.ok(shareOfView(seen, matrixFrom(target, towards, distance), SLOPES).reach < 1.01);
    assert.deepEqual(rangesWithoutSpikes(points, [[0, 99, 0]], 6)[1], [-1, 1]);
    assert.equal(withoutSpikes(points, [[1, 1, 1]]), null);
  }
});
