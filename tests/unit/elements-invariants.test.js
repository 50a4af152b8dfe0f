// What must not change a path of the defaults: the unit, where the surface stands, how it is written down, where the solver begins.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { gallery } from '../../web/gallery.js';
import { load } from '../../web/index.js';
import { randomPairs } from '../bench/pairs.js';
import { loadCases } from '../helpers/cases.js';
import { createRandom } from '../helpers/random.js';
import { ofAll } from '../helpers/sample.js';
import { MOTION, mapPoint, transform } from '../helpers/space-map.js';

/** @typedef {import('../../web/index.js').Path} Path */
/** @typedef {import('../../web/index.js').Surface} Surface */
/** @typedef {keyof typeof gallery} Name */

const SEED = 27182;
const PAIRS = ofAll(3, 10);
/** Of two lengths, each right to the default tolerance. */
const TWO_TOLERANCES = 2e-9;

const surfpath = await load();

/** The surface of a test, with its pairs. @param {any} definition */
function prepare(definition) {
  const surface = surfpath.surface(definition);
  return { surface, pairs: randomPairs(surface, createRandom(SEED), PAIRS) };
}

/** @param {Path} path @param {number} expected @param {string} what */
function assertLength(path, expected, what) {
  assert.equal(path.status, 'converged', what);
  assert.ok(Math.abs(path.length - expected) <= TWO_TOLERANCES * expected, `${what}: ${path.length}, not ${expected}`);
}

/** The same ends on the image of a surface: parameters stay. @param {Surface} surface @param {number[][]} ends @param {import('../helpers/space-map.js').SpaceMap} map */
const mapEnds = ({ kind }, ends, map) => (kind === 'parametric' ? ends : ends.map((end) => mapPoint(end, map)));

describe(`default options, ${PAIRS} random pairs, seed ${SEED}`, () => {
  /** @type {[string, import('../helpers/space-map.js').SpaceMap][]} */
  const maps = [
    ['a million times as large', { factor: 1e6 }],
    ['a million times as small', { factor: 1e-6 }],
    ['moved rigidly', MOTION],
  ];
  /** @type {Name[]} */
  const mapped = ['saddle', 'dini', 'parametricTorus', 'torus', 'genus2', 'metamorphosis'];
  for (const name of mapped) {
    for (const [what, map] of maps) {
      test(`${name}, ${what}: so are its paths`, () => {
        const { surface, pairs } = prepare(gallery[name]);
        const image = surfpath.surface(transform(gallery[name], map));
        for (const ends of pairs) {
          const path = surface.shortestPath(ends[0], ends[1]);
          const [from, to] = mapEnds(surface, ends, map);
          assert.equal(path.status, 'converged', `${ends}`);
          assertLength(image.shortestPath(from, to), (map.factor ?? 1) * path.length, `${ends}`);
        }
        surface.dispose();
        image.dispose();
      });
    }
  }

  const bounds = [
    [-3.5, 3.5],
    [-2.5, 2.5],
    [-1.5, 1.5],
  ];
  const ellipsoid = { kind: 'parametric', x: '3*cos(v)*cos(u)', y: '2*cos(v)*sin(u)', z: 'sin(v)', u: ['-pi', 'pi'], v: ['-pi/2', 'pi/2'] };
  for (const [name, chart, equation] of /** @type {const} */ ([
    ['sphere', gallery.globe, gallery.sphere],
    ['torus', gallery.parametricTorus, gallery.torus],
    ['ellipsoid', ellipsoid, { kind: 'implicit', f: 'x^2/9+y^2/4+z^2-1', bounds }],
  ])) {
    test(`${name}: the parametric and the implicit form agree`, () => {
      const { surface, pairs } = prepare(chart);
      const implicit = surfpath.surface(/** @type {any} */ (equation));
      for (const [from, to] of pairs) {
        const path = surface.shortestPath(from, to);
        assert.equal(path.status, 'converged', `${from} to ${to}`);
        assertLength(implicit.shortestPath(path.points.subarray(0, 3), path.points.subarray(-3)), path.length, `${from} to ${to}`);
      }
      surface.dispose();
      implicit.dispose();
    });
  }

  /** @type {Name[]} */
  const warm = ['saddle', 'paraboloid', 'dini', 'parametricTorus', 'bumpy', 'torus', 'genus2', 'metamorphosis', 'printed47'];
  for (const name of warm) {
    test(`${name}: begun at the path to an end 1 % away, the same path as begun anew`, () => {
      const { surface, pairs } = prepare(gallery[name]);
      let same = 0;
      for (const [from, to] of pairs) {
        const last = surface.shortestPath(from, to);
        const moved = moveEnd(surface, from, to);
        const [again, anew] = [surface.shortestPath(from, moved, { start: last }), surface.shortestPath(from, moved)];
        assert.equal(again.status, 'converged', `${from} to ${moved}`);
        /* Where the path around the other side has become the shorter one, the old one stays on its side. */
        assert.ok(again.length >= anew.length * (1 - TWO_TOLERANCES), `${from} to ${moved}: ${again.length}, anew ${anew.length}`);
        if (again.length <= anew.length * (1 + TWO_TOLERANCES)) same++;
      }
      assert.ok(same >= 0.9 * PAIRS, `only ${same} of ${PAIRS} are the same`);
      surface.dispose();
    });
  }
});

describe('other ways to ask, default options', () => {
  const torus = surfpath.surface(gallery.parametricTorus);

  test('geodesics: distinct, sorted, the shortest path first', () => {
    const found = torus.geodesics([0.3, 0.4], [2.9, 3.3]);
    assert.ok(found.length >= 3, `${found.length} found`);
    assert.deepEqual(found[0], torus.shortestPath([0.3, 0.4], [2.9, 3.3]));
    for (const [i, path] of found.entries()) {
      assert.deepEqual([path.status, path.index], ['converged', 0]);
      assert.ok(i === 0 || path.length > found[i - 1].length);
    }
  });

  test('geodesics: both paths of an exact tie, as long to the tolerance', () => {
    const ties = loadCases({ families: 'F', kinds: ['parametric'] }).filter(({ expected }) => expected.surface === 'bumpy_tie');
    assert.ok(ties.length > 0);
    for (const { id, definition, from, to, expected } of ties.filter((one) => !one.expected.unique)) {
      const surface = surfpath.surface(/** @type {any} */ (definition));
      const [first, second] = surface.geodesics(from, to);
      for (const path of [first, second]) assertLength(path, expected.length, id);
      assert.ok(Math.max(...first.points.map((x, i) => Math.abs(x - second.points[i]))) > 0.01 * first.length, `${id}: they are apart`);
      surface.dispose();
    }
  });

  test('via: as long as its pieces, and through the points', () => {
    const [from, by, to] = [
      [0.1, 0.2],
      [5.9, 1.5],
      [3, 6],
    ];
    const path = torus.shortestPath(from, to, { via: [by], points: 99 });
    assertLength(path, torus.shortestPath(from, by).length + torus.shortestPath(by, to).length, 'via');
    const passed = torus.evaluate(by).subarray(0, 3);
    const away = (/** @type {number} */ i) => Math.hypot(...[0, 1, 2].map((k) => path.points[3 * i + k] - passed[k]));
    assert.ok(Math.min(...Array.from({ length: 101 }, (_, i) => away(i))) < 1e-12);
  });

  test('trace: the end of a path, from its beginning, is where its direction leads', () => {
    const path = torus.shortestPath([0.3, 0.4], [1.8, 2.9], { points: 2000 });
    const q = /** @type {Float64Array} */ (path.parameters);
    const direction = [0, 1].map((j) => -25 * q[j] + 48 * q[2 + j] - 36 * q[4 + j] + 16 * q[6 + j] - 3 * q[8 + j]);
    const end = torus.trace([0.3, 0.4], direction, path.length).points.subarray(-3);
    /* The direction is a difference of fourth order over two thousandths of the path. */
    assert.ok(Math.hypot(...[0, 1, 2].map((k) => end[k] - path.points[6003 + k])) < 1e-8 * path.length);
  });
});

/** An end moved by a hundredth of the way to the other, and as much across. @param {Surface} surface @param {number[]} from @param {number[]} to */
function moveEnd(surface, from, to) {
  const [x, y, z] = [0, 1, 2].map((i) => ((from[i] ?? 0) - (to[i] ?? 0)) / 100);
  const moved = [to[0] + x - y, to[1] + y + x, ...to.slice(2).map((end) => end + z)];
  if (surface.kind === 'implicit') return surface.project(moved);
  const { u, v } = /** @type {NonNullable<Surface['domain']>} */ (surface.domain);
  return moved.map((end, i) => Math.min(Math.max(end, [u, v][i][0]), [u, v][i][1]));
}
