// What must not change a path: the order of its ends, the unit, where the surface stands, how it is written down, solving again.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { gallery } from '../../web/gallery.js';
import { load } from '../../web/index.js';
import { randomPairs } from '../bench/pairs.js';
import { POLYLINE, STRAIGHT } from '../helpers/options.js';
import { createRandom } from '../helpers/random.js';
import { MOTION, mapPoint, transform } from '../helpers/space-map.js';

/** @typedef {import('../../web/path.js').Path} Path */
/** @typedef {import('../../web/surface.js').Surface} Surface */
/** @typedef {keyof typeof gallery} Name */

const SEED = 31415;
const PAIRS = 16;
/** Newton's last full step leaves an error of the order of rounding; measured 1.2e-15 at most. */
const ROUNDING = 1e-14;

const surfpath = await load();

/** The surfaces of a test, with their pairs; disposed of by the caller. @param {Name} name */
function prepare(name) {
  const surface = surfpath.surface(gallery[name]);
  return { surface, pairs: randomPairs(surface, createRandom(SEED), PAIRS) };
}

/** Points in the opposite order. @param {Float64Array} numbers @param {number} width */
function backwards(numbers, width) {
  return numbers.map((_, i) => numbers[numbers.length - width * (Math.floor(i / width) + 1) + (i % width)]);
}

/** @param {number} length @param {number} expected @param {number} tolerance @param {string} what */
function assertClose(length, expected, tolerance, what) {
  assert.ok(
    Math.abs(length - expected) <= tolerance * expected,
    `${what}: ${length}, not ${expected}, a relative ${length / expected - 1}`,
  );
}

/** Enough pairs took part. @param {unknown[]} compared */
function assertMost(compared) {
  assert.ok(compared.length > 0.7 * PAIRS, `only ${compared.length} of ${PAIRS} pairs were compared`);
}

describe(`invariants of straight polylines over ${PAIRS} random pairs, seed ${SEED}`, () => {
  /** @type {Name[]} */
  const reversed = [
    'saddle',
    'paraboloid',
    'dini',
    'cylinder',
    'parametricTorus',
    'catenoid',
    'bumpy',
    'torus',
    'genus2',
    'threeTori',
    'metamorphosis',
  ];
  for (const name of reversed) {
    test(`${name}: B to A is A to B backwards, to the bit`, () => {
      const { surface, pairs } = prepare(name);
      for (const [i, [from, to]] of pairs.entries()) {
        const points = 1 + ((7 * i) % 80);
        const [there, back] = [
          surface.shortestPath(from, to, { ...STRAIGHT, points }),
          surface.shortestPath(to, from, { ...STRAIGHT, points }),
        ];
        assert.deepEqual({ ...back, points: backwards(back.points, 3), parameters: null }, { ...there, parameters: null });
        assertShifted(surface, there, back);
      }
      surface.dispose();
    });
  }

  /** @type {Name[]} */
  const scaled = ['saddle', 'dini', 'parametricTorus', 'torus', 'genus2', 'metamorphosis'];
  for (const name of scaled) {
    for (const factor of [1e6, 1e-6]) {
      test(`${name}, ${factor} times as large: so are its paths`, () => {
        const { surface, pairs } = prepare(name);
        const large = surfpath.surface(transform(gallery[name], { factor }));
        assertMost(pairs.filter(([from, to]) => compareMapped(surface, large, from, to, { factor })));
        surface.dispose();
        large.dispose();
      });
    }

    test(`${name}, moved rigidly: its paths are as long`, () => {
      const { surface, pairs } = prepare(name);
      const moved = surfpath.surface(transform(gallery[name], MOTION));
      assertMost(pairs.filter(([from, to]) => compareMapped(surface, moved, from, to, MOTION)));
      surface.dispose();
      moved.dispose();
    });
  }

  /** @type {[Name, Name][]} */
  const twins = [
    ['globe', 'sphere'],
    ['parametricTorus', 'torus'],
  ];
  for (const [chart, equation] of twins) {
    test(`${chart} and ${equation}: the parametric and the implicit form agree`, () => {
      const { surface, pairs } = prepare(chart);
      const implicit = surfpath.surface(gallery[equation]);
      const solved = pairs.map(([from, to]) => surface.shortestPath(from, to, STRAIGHT));
      const free = solved.filter((path) => path.converged && !path.touchesBoundary);
      assertMost(free);
      for (const path of free) {
        const [first, last] = [path.points.slice(0, 3), path.points.slice(-3)];
        const twin = implicit.shortestPath(first, last, { ...POLYLINE, start: path });
        assert.equal(twin.status, 'converged');
        assert.ok(Math.abs(twin.length - path.length) <= Math.min(twin.lengthError, path.lengthError));
        assertClose(twin.length, path.length, ROUNDING, 'two polylines of least energy');
      }
      surface.dispose();
      implicit.dispose();
    });
  }

  /** @type {Name[]} */
  const warm = ['saddle', 'paraboloid', 'dini', 'parametricTorus', 'bumpy', 'torus', 'genus2'];
  for (const name of warm) {
    test(`${name}: a path that is its own start takes one step at most, and stays`, () => {
      const { surface, pairs } = prepare(name);
      const solved = pairs
        .map(([from, to]) => ({ from, to, path: surface.shortestPath(from, to, STRAIGHT) }))
        .filter(({ path }) => path.converged);
      assertMost(solved);
      for (const { from, to, path } of solved) {
        const again = surface.shortestPath(from, to, { ...POLYLINE, start: path });
        assert.equal(again.status, 'converged');
        assert.ok(again.iterations <= 1, `${again.iterations} iterations`);
        assertClose(again.length, path.length, ROUNDING, 'length');
      }
      surface.dispose();
    });
  }
});

/** The parameters of the way back are those of the way there, moved by whole periods. @param {Surface} surface @param {Path} there @param {Path} back */
function assertShifted({ domain }, there, back) {
  if (!there.parameters || !back.parameters || !domain) return;
  const turned = backwards(back.parameters, 2);
  for (const j of [0, 1]) {
    const [low, high] = j === 0 ? domain.u : domain.v;
    const period = (j === 0 ? domain.periodic.u : domain.periodic.v) ? high - low : 0;
    const turns = period && Math.round((turned[j] - there.parameters[j]) / period);
    for (let i = j; i < turned.length; i += 2) {
      /** @type {number} */ const expected = there.parameters[i] + turns * period;
      if (turns === 0) assert.equal(turned[i], expected);
      else assert.ok(Math.abs(turned[i] - expected) <= 1e-15 * (Math.abs(expected) + 4 * period), `${turned[i]}, not ${expected}`);
    }
  }
}

/** Two paths, one on the image of the other's surface; whether they converged. @param {Surface} surface @param {Surface} image @param {number[]} from @param {number[]} to @param {import('../helpers/space-map.js').SpaceMap} map */
function compareMapped(surface, image, from, to, map) {
  const path = surface.shortestPath(from, to, STRAIGHT);
  const ends = surface.kind === 'parametric' ? [from, to] : [mapPoint(from, map), mapPoint(to, map)];
  const mapped = image.shortestPath(ends[0], ends[1], STRAIGHT);
  assert.equal(mapped.status, path.status);
  if (!path.converged) return false;
  assertClose(mapped.length, (map.factor ?? 1) * path.length, ROUNDING, `length from ${from} to ${to}`);
  return true;
}

test('ends that are almost conjugate: the two copies of a middle node stay one, and polylines come to rest', () => {
  const sphere = surfpath.implicit({ f: 'x^2 + y^2 + z^2 - 1' });
  const angle = Math.PI - 1e-4;
  const to = [0.6 * Math.cos(angle) + 0.8 * Math.sin(angle), 0, 0.8 * Math.cos(angle) - 0.6 * Math.sin(angle)];
  for (const points of [31, 32, 63, 64]) {
    // Another half of a great circle, which hardly is another length.
    const start = Array.from({ length: points + 2 }, (_, i) => {
      const t = (Math.PI * i) / (points + 1);
      const [along, aside] = [Math.cos(1) * Math.sin(t), Math.sin(1) * Math.sin(t)];
      return [0.6 * Math.cos(t) + 0.8 * along, aside, 0.8 * Math.cos(t) - 0.6 * along];
    });
    start[points + 1] = to;
    const path = sphere.shortestPath([0.6, 0, 0.8], to, { algorithm: 'polyline', points, start: start.flat() });
    const chords = 2 * (points + 1) * Math.sin(angle / (2 * points + 2));
    assert.equal(path.status, 'ill-conditioned', `${points} points`);
    assert.ok(Math.abs(path.length - chords) < 1e-9, `${path.length} is not ${chords}`);
  }
  sphere.dispose();
});
