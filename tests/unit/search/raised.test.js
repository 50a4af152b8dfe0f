// Steep surfaces: test functions of optimisation as they stand, on which paths are found along lines of equal height, or where heights are lower, and followed.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { load } from '../../../web/index.js';
import { freeName, steepnessOf } from '../../../web/manifold/lowered.js';
import { RIGHT, STEEP } from '../../accuracy/measure/steep.js';
import { createRandom } from '../../helpers/random.js';
import { ofAll } from '../../helpers/sample.js';
import { verifyPath } from '../../helpers/verify-path.js';

const surfpath = await load();
/** A start of many points is taken as it is, and is nearly right. */
const STEPS = 60;
/** Enough for lines between points to stay on the slopes. */
const POINTS = 16383;
/** Chords between so many are shorter than the path by this part at most; and where it turns within a thousandth of its length, what its places may be wrong by is this much curvature. */
const DEMANDS = { lengthTolerance: 1e-3, tolerance: 1e-2 };

for (const name of /** @type {const} */ (['Rastrigin', 'Himmelblau', 'egg box'])) {
  test(`${name}'s function as it stands: all paths converge, each a geodesic as long as finer elements say, seed 2`, () => {
    const { z, side } = STEEP[name];
    const definition = { kind: /** @type {const} */ ('parametric'), x: 'u', y: 'v', z, u: [-side, side], v: [-side, side] };
    const surface = surfpath.surface(/** @type {any} */ (definition));
    const random = createRandom(2);
    const place = () => [random.between(-side, side), random.between(-side, side)];
    for (let i = 0; i < ofAll(1, 5); i++) {
      const [from, to] = [place(), place()];
      const path = surface.shortestPath(from, to, { points: POINTS });
      assert.equal(path.status, 'converged', `${from} to ${to}`);
      const finer = surface.shortestPath(from, to, { start: path, points: POINTS, tolerance: 1e-12 });
      assert.ok(finer.iterations <= STEPS, `${from} to ${to}: ${finer.iterations} steps from many points of the path itself`);
      assert.ok(finer.converged && Math.abs(path.length / finer.length - 1) < RIGHT, `${from} to ${to}: ${path.length}, ${finer.length}`);
      const wrong = verifyPath(/** @type {any} */ (definition), path, { from, to, ...DEMANDS });
      assert.deepEqual(wrong, [], `${from} to ${to}`);
      if (i === 0) assert.equal(surface.shortestPath(from, to).length, path.length, 'however many points are wanted');
    }
    surface.dispose();
  });
}

/* The first rung gains too little in 16 steps, and tells the next better where elements should lie. */
test("a rung from many chords that wanders is not the last: a path on Rastrigin's function comes to rest on the next", () => {
  const { z, side } = STEEP.Rastrigin;
  const surface = surfpath.parametric({ x: 'u', y: 'v', z, u: [-side, side], v: [-side, side] });
  const path = surface.shortestPath([4.404894089698792, -1.519233732223511], [-4.401702032089234, 4.300845704078674]);
  assert.equal(path.status, 'converged');
  assert.ok(path.length < 60.3019, `${path.length}`);
  surface.dispose();
});

/** Jets of a surface, given X, its two slopes, by place. @param {(u: number, v: number) => number[]} jet */
const sampled = (jet) => (/** @type {number[]} */ places) => {
  const jets = new Float64Array(9 * places.length);
  for (let i = 0; 2 * i < places.length; i++) jets.set(jet(places[2 * i], places[2 * i + 1]), 18 * i);
  return jets;
};

test('how steep a surface is over x and y: its mean slope; none where it is no height field', () => {
  const square = { lower: [-1, -1], upper: [1, 1] };
  const plane = sampled((u, v) => [u, v, 30 * u + 40 * v, 1, 0, 30, 0, 1, 40]);
  assert.ok(Math.abs(steepnessOf(plane, square) - 50) < 1e-12);
  /* Of a cone in polar coordinates, whose apex has no normal. */
  const cone = sampled((u, v) => [
    v * Math.cos(u),
    v * Math.sin(u),
    7 * v,
    -v * Math.sin(u),
    v * Math.cos(u),
    0,
    Math.cos(u),
    Math.sin(u),
    7,
  ]);
  assert.ok(Math.abs(steepnessOf(cone, { lower: [0, 0], upper: [6, 1] }) - 7) < 1e-12);
  const cylinder = sampled((u, v) => [Math.cos(u), Math.sin(u), v, -Math.sin(u), Math.cos(u), 0, 0, 0, 1]);
  assert.equal(steepnessOf(cylinder, square), 0);
  const folded = sampled((u, v) => [u * u, v, u, 2 * u, 0, 1, 0, 1, 0]);
  assert.equal(steepnessOf(folded, square), 0);
});

test('a name that no parameter has', () => assert.equal(freeName({ height: 1, height_: 2 }), 'height__'));
