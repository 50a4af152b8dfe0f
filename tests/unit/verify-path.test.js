/** The judge is judged: true geodesics pass, each way of being wrong is named. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { loadCases } from '../helpers/cases.js';
import { createRandom } from '../helpers/random.js';
import { cross, norm, referenceSurface, subtract, unit } from '../helpers/reference.js';
import { verifyPath } from '../helpers/verify-path.js';

/** @typedef {import('../helpers/verify-path.js').Definition} Definition */

/** @type {Definition} */
const saddle = { kind: 'parametric', x: 'u', y: 'v', z: 'u^2-v^2', u: [-1, 1], v: ['-pi/3', 'pi/3'] };
/** @type {Definition} */
const cylinder = { kind: 'parametric', x: 'R*cos(u)', y: 'R*sin(u)', z: 'v', u: [0, '2*pi'], v: [-1, 1], parameters: { R: 1 } };
/** @type {Definition} */
const globe = { kind: 'parametric', x: 'cos(v)*cos(u)', y: 'cos(v)*sin(u)', z: 'sin(v)', u: ['-pi', 'pi'], v: ['-pi/2', 'pi/2'] };
/** @type {Definition} */
const sphere = { kind: 'implicit', f: 'x^2+y^2+z^2-1' };
/** @type {Definition} */
const annulus = {
  kind: 'parametric',
  x: 'v*cos(u)',
  y: 'v*sin(u)',
  z: 0,
  u: ['-pi', 'pi'],
  v: [0.5, 2],
  periodic: { u: false, v: false },
};

/**
 * A path through points, its length the sum of the chords.
 *
 * @param {number[][]} points
 * @param {number[][]} [places]
 */
function pathThrough(points, places) {
  const length = points.slice(1).reduce((sum, point, i) => sum + norm(subtract(point, points[i])), 0);
  return { points: Float64Array.from(points.flat()), parameters: places ? Float64Array.from(places.flat()) : null, length };
}

/**
 * A path from its parameters.
 *
 * @param {Definition} definition
 * @param {number[][]} places
 */
function pathOver(definition, places) {
  const surface = referenceSurface(definition);
  if (surface.kind !== 'parametric') throw new Error('not parametric');
  return pathThrough(places.map(surface.position), places);
}

/** @type {(from: number[], to: number[], count: number) => number[][]} */
const line = (from, to, count) => Array.from({ length: count + 1 }, (_, i) => from.map((x, j) => x + (i / count) * (to[j] - x)));

/**
 * Equally spaced points of an arc of a great circle.
 *
 * @param {number[]} start unit vector
 * @param {number[]} direction unit vector normal to it
 * @param {number} angle
 * @param {number} count
 */
const arc = (start, direction, angle, count) =>
  line([0], [angle], count).map(([t]) => start.map((x, i) => x * Math.cos(t) + direction[i] * Math.sin(t)));

/** @type {(violations: { check: string }[]) => string[]} */
const names = (violations) => [...new Set(violations.map(({ check }) => check))].sort();

test('accepts great circles, implicit and in latitude and longitude', () => {
  const random = createRandom(11);
  for (let trial = 0; trial < 20; trial++) {
    const start = unit([random.normal(), random.normal(), random.normal()]);
    const direction = unit(cross(start, [random.normal(), random.normal(), random.normal()]));
    const count = random.pick([2, 3, 10, 65, 500]);
    const points = arc(start, direction, random.between(0.01, Math.min(3, 0.5 * count)), count);
    const demands = { from: points[0], to: points[points.length - 1] };
    assert.deepEqual(verifyPath(sphere, pathThrough(points), demands), [], `seed ${random.seed}, trial ${trial}`);
    const places = unwrapped(points.map(([x, y, z]) => [Math.atan2(y, x), Math.atan2(z, Math.hypot(x, y))]));
    const ends = { from: places[0], to: places[places.length - 1] };
    assert.deepEqual(verifyPath(globe, pathThrough(points, places), ends), [], `seed ${random.seed}, trial ${trial}, chart`);
  }
});

/** @type {(places: number[][]) => number[][]} */
function unwrapped(places) {
  let last = places[0][0];
  return places.map(([u, v]) => {
    last = u + 2 * Math.PI * Math.round((last - u) / (2 * Math.PI));
    return [last, v];
  });
}

test('accepts helices on a cylinder, across the seam too', () => {
  for (const [from, to] of [
    [
      [0.2, -0.9],
      [3, 0.8],
    ],
    [
      [-1, 0.5],
      [1, -0.5],
    ],
    [
      [1, 0.3],
      [1, -0.3],
    ],
    [
      [5, 0],
      [8, 0],
    ],
  ]) {
    assert.deepEqual(verifyPath(cylinder, pathOver(cylinder, line(from, to, 50)), { from, to }), []);
  }
});

/** @type {(points: number[][]) => number} */
function largestTurn(points) {
  const chords = points.slice(1).map((point, i) => unit(subtract(point, points[i])));
  return Math.max(...chords.slice(1).map((chord, i) => norm(subtract(chord, chords[i]))));
}

test('accepts the sampled paths of known length', () => {
  let judged = 0;
  for (const { id, definition, expected } of loadCases({ families: 'ABCDF', kinds: ['parametric', 'implicit'] })) {
    if (!expected.path || definition.density) continue;
    const surface = referenceSurface(definition);
    const places = surface.kind === 'parametric' ? expected.path : undefined;
    const points = surface.kind === 'parametric' ? expected.path.map(surface.position) : expected.path;
    if (largestTurn(points) > 0.25) continue;
    const ends = { from: expected.from, to: expected.to_lift ?? expected.to };
    assert.deepEqual(verifyPath(definition, pathThrough(points, places), ends), [], id);
    judged++;
  }
  assert.ok(judged >= 80, `${judged} paths`);
});

test('accepts a taut string around the rim of an annulus, and no slack one', () => {
  /* From (1, 0) straight to the rim, along it, and straight away: tangent points at angles ±(π/2 − φ) from the middle, cos φ = 1/2. */
  const free = Math.sqrt(0.75);
  const rim = 0.5 * (2.6 - (2 * Math.PI) / 3);
  const places = line([0], [2 * free + rim], 100).map(([s]) => {
    const t = Math.min(s, 2 * free + rim - s) - free;
    const half = t >= 0 ? [Math.PI / 3 + t / 0.5, 0.5] : [Math.PI / 3 + Math.atan(t / 0.5), Math.hypot(t, 0.5)];
    return s <= free + rim / 2 ? half : [2.6 - half[0], half[1]];
  });
  const ends = { from: places[0], to: places[100] };
  assert.deepEqual(verifyPath(annulus, pathOver(annulus, places), ends), []);
  const outer = pathOver(annulus, line([0, 2], [1, 2], 40));
  assert.deepEqual(names(verifyPath(annulus, outer)), ['edge'], 'the outer rim pulls inwards');
  assert.deepEqual(names(verifyPath({ ...annulus, v: [0.4, 2] }, pathOver(annulus, places))), ['curvature'], 'no edge there');
});

test('rejects a straight line of the parameters on the saddle', () => {
  const from = [-0.9, 0.1];
  const to = [0.5, 0.9];
  const wrong = verifyPath(saddle, pathOver(saddle, line(from, to, 64)), { from, to });
  assert.ok(names(wrong).includes('curvature'));
  assert.ok(!names(wrong).includes('surface') && !names(wrong).includes('start'));
});

test('rejects a small circle, however fine', () => {
  for (const count of [8, 64, 1000]) {
    const places = line([0, 0.3], [1, 0.3], count);
    assert.deepEqual(names(verifyPath(globe, pathOver(globe, places))), ['curvature'], `${count} chords`);
  }
});

test('rejects one kink, and chords of unequal length', () => {
  const bent = line([0.2, -0.9], [3, 0.8], 50);
  bent[20] = [bent[20][0] + 1e-5, bent[20][1] - 1e-5];
  assert.deepEqual(names(verifyPath(cylinder, pathOver(cylinder, bent))), ['curvature']);
  const uneven = line([0], [1], 50).map(([t]) => [0.2 + 2.8 * (t + 0.2 * t * t), 0.1]);
  assert.deepEqual(names(verifyPath(cylinder, pathOver(cylinder, uneven))), ['spacing']);
  assert.deepEqual(verifyPath(cylinder, pathOver(cylinder, uneven), { equalChords: false }), []);
});

test('rejects shifted ends', () => {
  const places = line([0.2, -0.9], [3, 0.8], 50);
  const path = pathOver(cylinder, places);
  assert.deepEqual(names(verifyPath(cylinder, path, { from: [0.2, -0.9 + 1e-9], to: [3, 0.8] })), ['start']);
  assert.deepEqual(names(verifyPath(cylinder, path, { from: [0.2, -0.9], to: [3 + 1e-9, 0.8] })), ['end']);
  assert.deepEqual(names(verifyPath(sphere, path, { from: [1, 0, 0] })).includes('start'), true);
});

test('rejects points off the surface and outside the rectangle', () => {
  const points = arc([1, 0, 0], [0, 1, 0], 1, 20).map((point) => point.map((x) => x * (1 + 1e-8)));
  assert.deepEqual(names(verifyPath(sphere, pathThrough(points))), ['surface']);
  const high = pathOver(cylinder, line([0.2, 0.9], [3, 1.1], 50));
  assert.deepEqual(names(verifyPath(cylinder, high)), ['rectangle']);
});

test('rejects a chord through the air between two sheets', () => {
  /** @type {Definition} */
  const planes = { kind: 'implicit', f: '(z-0.02)*(z+0.01)' };
  const across = line([0, 0], [1, 0], 20).map(([x], i) => [x, 0, i < 10 ? -0.01 : 0.02]);
  assert.ok(names(verifyPath(planes, pathThrough(across))).includes('sheet'));
  /** @type {Definition} */
  const torus = { kind: 'implicit', f: '(x^2+y^2+z^2+3)^2-16*(x^2+y^2)' };
  const hole = [...line([2, 0, 1], [1, 0, 0], 1), ...line([-1, 0, 0], [-2, 0, 1], 1)];
  assert.ok(names(verifyPath(torus, pathThrough(hole))).includes('sheet'));
});

test('rejects a lift jump: a chord that cuts what the parameters go around', () => {
  const places = [...line([-3, 0], [-2.9, 0], 4), ...line([2.9, 0], [2.8, 0], 4)];
  const open = { ...cylinder, u: /** @type {[number, number]} */ ([-3.2, 3.2]), periodic: { u: false, v: false } };
  assert.ok(names(verifyPath(open, pathOver(open, places))).includes('lift'));
});

test('rejects NaN, a wrong length, wrong counts', () => {
  const path = pathOver(cylinder, line([0.2, -0.9], [3, 0.8], 50));
  const broken = Float64Array.from(path.points);
  broken[7] = Number.NaN;
  assert.deepEqual(names(verifyPath(cylinder, { ...path, points: broken })), ['finite']);
  assert.deepEqual(names(verifyPath(cylinder, { ...path, length: Number.NaN })), ['finite']);
  assert.deepEqual(names(verifyPath(cylinder, { ...path, length: path.length * (1 + 1e-11) })), ['length']);
  assert.deepEqual(names(verifyPath(cylinder, { ...path, points: path.points.subarray(3) })), ['count']);
  assert.deepEqual(names(verifyPath(cylinder, { ...path, parameters: null })), ['count']);
});

test('accepts a path of length zero and refuses what it cannot judge', () => {
  const still = pathThrough([
    [1, 0, 0],
    [1, 0, 0],
    [1, 0, 0],
  ]);
  assert.deepEqual(verifyPath(sphere, still, { from: [1, 0, 0], to: [1, 0, 0] }), []);
  assert.throws(() => verifyPath({ ...cylinder, density: '1' }, still), RangeError);
  assert.throws(() => verifyPath({ kind: 'metric', E: 1, F: 0, G: 1 }, still), RangeError);
});
