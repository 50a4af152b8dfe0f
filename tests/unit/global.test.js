// `start: 'global'` and `geodesics`, of polylines: the globally shortest paths of the open data, reversal, seams, floods, disconnected ends, memory, misuse.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { load } from '../../web/index.js';
import { Heap } from '../../web/runtime/heap.js';
import { loadCases } from '../helpers/cases.js';
import { POLYLINE } from '../helpers/options.js';
import { createRandom } from '../helpers/random.js';
import { verifyPath } from '../helpers/verify-path.js';

/** @typedef {import('../../web/index.js').Path} Path */
/** @typedef {import('../../web/index.js').Surface} Surface */

/** Of a polyline with 64 inner points. */
const CHORDS = 2e-3;
/** Cases whose path goes over a pole of its chart: the right length, but a chord across a pole is not certified. */
const OVER_A_POLE = /12p$/;

/** @type {import('../../web/instance.js').Surfpath} */
let surfpath;
before(async () => {
  surfpath = await load();
});
after(() => surfpath.dispose());

const cases = loadCases({ families: 'ABCDF', kinds: ['parametric', 'implicit'] }).filter(
  ({ expected, definition }) => !expected.crosses_cusp && definition.density === undefined,
);

/** What the geodesic under a polyline is long, to fourth order. @param {Path} path */
const estimate = (path) => path.length + path.lengthError;

/** @type {{ x: string, y: string, z: string, u: [number, string], v: [number, string] }} */
const torus = { x: '(2+cos(v))*cos(u)', y: '(2+cos(v))*sin(u)', z: 'sin(v)', u: [0, '2*pi'], v: [0, '2*pi'] };
const twoSpheres = '((x-1.5)^2+y^2+z^2-1)*((x+1.5)^2+y^2+z^2-1)';
const cube = (/** @type {number} */ half) => [0, 1, 2].map(() => [-half, half]);
const make = (/** @type {any} */ definition) => surfpath.surface({ kind: definition.f ? 'implicit' : 'parametric', ...definition });

describe('open data', () => {
  for (const name of new Set(cases.map(({ expected, definition }) => `${expected.surface} ${definition.kind}`))) {
    test(name, () => {
      const own = cases.filter(({ expected, definition }) => `${expected.surface} ${definition.kind}` === name);
      const surface = make(own[0].definition);
      for (const { id, definition, from, to, expected } of own) {
        const path = surface.shortestPath(from, to, { ...POLYLINE, points: 64 });
        const excess = path.length / expected.length - 1;
        assert.ok(path.converged || OVER_A_POLE.test(id), `${id}: ${path.status}`);
        assert.ok(Math.abs(excess) < CHORDS, `${id}: length ${path.length}, expected ${expected.length}`);
        const gap = expected.unique && expected.second_length ? expected.second_length / expected.length - 1 : CHORDS;
        assert.ok(estimate(path) / expected.length - 1 < gap / 2, `${id}: longer than the shortest by ${excess}`);
        if (path.converged) assert.deepEqual(verifyPath(definition, path, { from, to }), [], id);
      }
      surface.dispose();
    });
  }
});

test('A to B is B to A, to the bit', () => {
  const chosen = cases.filter(({ id, definition }) => /-0[0-5]/.test(id) && !OVER_A_POLE.test(id) && definition.kind !== 'metric');
  for (const { id, definition, from, to } of chosen) {
    const surface = make(definition);
    const [there, back] = [
      surface.shortestPath(from, to, { ...POLYLINE, points: 21 }),
      surface.shortestPath(to, from, { ...POLYLINE, points: 21 }),
    ];
    assert.equal(there.length, back.length, id);
    for (let i = 0; i < there.points.length; i++) {
      const mirrored = back.points.length - 3 - i + 2 * (i % 3);
      assert.equal(there.points[i], back.points[mirrored], `${id}, number ${i}`);
    }
    surface.dispose();
  }
});

test('lifts: any number in a periodic direction, and parameters that start where asked', () => {
  const surface = make(torus);
  const near = surface.shortestPath([0.1, 0.2], [6.1, 6.2], POLYLINE);
  const far = surface.shortestPath([0.1 + 4 * Math.PI, 0.2], [6.1, 6.2 - 6 * Math.PI], POLYLINE);
  assert.ok(Math.abs(near.length / far.length - 1) < 1e-12, `${near.length} ${far.length}`);
  const parameters = /** @type {Float64Array} */ (far.parameters);
  assert.equal(parameters[0], 0.1 + 4 * Math.PI);
  for (let i = 2; i < parameters.length; i++) assert.ok(Math.abs(parameters[i] - parameters[i - 2]) < 0.1);
  surface.dispose();
});

test('geodesics: distinct, sorted, the shortest path first', () => {
  const surface = make(torus);
  const found = surface.geodesics([0.3, 0.4], [2.9, 3.3], POLYLINE);
  assert.ok(found.length >= 3, `${found.length} found`);
  assert.equal(found[0].length, surface.shortestPath([0.3, 0.4], [2.9, 3.3], POLYLINE).length);
  for (const [i, path] of found.entries()) {
    assert.equal(path.index, 0);
    assert.ok(i === 0 || path.length >= found[i - 1].length);
    assert.deepEqual(verifyPath({ kind: 'parametric', ...torus, periodic: 'auto' }, path), []);
  }
  assert.equal(surface.geodesics([0.3, 0.4], [2.9, 3.3], { ...POLYLINE, max: 2 }).length, 2);
  surface.dispose();
});

test('geodesics: mirror images are different paths, and do not displace the others', () => {
  const surface = make(torus);
  const found = surface.geodesics([0, 0], [Math.PI, 0], POLYLINE);
  const lengths = found.map(({ length }) => length);
  assert.ok(new Set(lengths.map((length) => length.toFixed(3))).size >= 3, `lengths ${lengths}`);
  assert.deepEqual(
    lengths,
    [...lengths].sort((a, b) => a - b),
  );
  for (const [i, { points }] of found.entries())
    for (const other of found.slice(0, i))
      assert.ok(
        points.some((x, k) => Math.abs(x - other.points[k]) > 0.01),
        `path ${i} twice`,
      );
  assert.deepEqual(
    surface.geodesics([0, 0], [Math.PI, 0], { ...POLYLINE, max: 5 }).map(({ length }) => length),
    lengths.slice(0, 5),
  );
  surface.dispose();
});

test('geodesics: both paths of an exact tie', () => {
  for (const { id, definition, from, to, expected } of cases.filter(
    ({ expected }) => !expected.unique && expected.surface === 'bumpy_tie',
  )) {
    const surface = make(definition);
    const [first, second] = surface.geodesics(from, to, POLYLINE);
    assert.ok(Math.abs(first.length / second.length - 1) < 1e-9, id);
    assert.ok(Math.abs(estimate(first) / expected.length - 1) < 1e-4, id);
    surface.dispose();
  }
});

test('geodesics: one, where there is only one', () => {
  const surface = make({ x: 'u', y: 'v', z: 'u^2-v^2', u: [-1, 1], v: [-1, 1] });
  assert.equal(surface.geodesics([-0.9, 0.1], [0.8, -0.7], POLYLINE).length, 1);
  surface.dispose();
});

test('ends on different pieces are disconnected; on one piece they are not', () => {
  for (const bounds of [cube(3), undefined]) {
    const surface = make({ f: twoSpheres, bounds });
    const apart = surface.shortestPath([0.5, 0, 0], [-2.5, 0, 0], POLYLINE);
    assert.equal(apart.status, 'disconnected');
    assert.equal(apart.converged, false);
    assert.ok(Number.isNaN(apart.length) && apart.points.length === 0);
    const same = surface.shortestPath([0.5, 0, 0], [1.5, 0.6, 0.8], POLYLINE);
    assert.ok(same.converged && Math.abs(estimate(same) - Math.PI / 2) < 1e-5, `${same.status} ${same.length}`);
    assert.deepEqual(surface.geodesics([0.5, 0, 0], [-2.5, 0, 0], POLYLINE), []);
    surface.dispose();
  }
});

test('what is wrong with an end, or with the surface, is said rather than disconnected', () => {
  for (const [f, status] of /** @type {const} */ ([
    ['x^2+y^2+z^2+1', 'off-surface'],
    ['sqrt(-1-x^2)', 'not-finite'],
    ['0*x', 'singular-metric'],
  ]))
    for (const bounds of [cube(2), undefined]) {
      const surface = make({ f, bounds });
      assert.equal(surface.shortestPath([1, 0, 0], [0, 1, 0], POLYLINE).status, status, f);
      assert.deepEqual(surface.geodesics([1, 0, 0], [0, 1, 0], POLYLINE), []);
      surface.dispose();
    }
});

test('bounds are no wall, and not needed', () => {
  const f = 'x^2+y^2+z^2-1';
  for (const bounds of [
    undefined,
    [
      [-2, 0.5],
      [-2, 2],
      [-2, 2],
    ],
  ]) {
    const surface = make({ f, bounds });
    const path = surface.shortestPath([0.8, 0.6, 0], [0.6, -0.48, 0.64], POLYLINE);
    const angle = Math.acos(0.48 - 0.288);
    assert.ok(path.converged && Math.abs(estimate(path) - angle) < 1e-5, `${path.status} ${path.length} ${angle}`);
    surface.dispose();
  }
});

test('changed parameters give another graph', () => {
  const surface = make({ x: 'cos(u)', y: 'sin(u)', z: 'h*v', u: [0, '2*pi'], v: [0, 1], parameters: { h: 1 } });
  const length = (/** @type {number} */ h) => Math.hypot(2 * Math.PI - 6, 0.8 * h);
  assert.ok(Math.abs(surface.shortestPath([0.1, 0.1], [6.1, 0.9], POLYLINE).length / length(1) - 1) < CHORDS);
  surface.set({ h: 5 });
  assert.ok(Math.abs(surface.shortestPath([0.1, 0.1], [6.1, 0.9], POLYLINE).length / length(5) - 1) < CHORDS);
  surface.dispose();
});

test('from an apex only one path is solved finely, and it goes straight up', (context) => {
  const cone = surfpath.revolution({ r: 't', z: 't', t: [0, 1] });
  const solve = context.mock.method(Heap.prototype, 'solve');
  const path = cone.shortestPath([0, 0], [3, 1]);
  assert.ok(path.converged && Math.abs(path.length - Math.SQRT2) < 1e-12);
  const fine = solve.mock.calls.filter((call) => /** @type {any} */ (call.arguments[2]).algorithm === 0);
  assert.equal(fine.length, 1);
});

test('ends that coincide', () => {
  for (const [definition, point] of /** @type {const} */ ([
    [torus, [1, 2]],
    [{ f: 'x^2+y^2+z^2-1', bounds: cube(1.3) }, [1, 0, 0]],
    [{ f: 'x^2+y^2+z^2-1' }, [1, 0, 0]],
  ])) {
    const surface = make(definition);
    const path = surface.shortestPath([...point], [...point], POLYLINE);
    assert.ok(path.converged && path.length === 0, `${path.status} ${path.length}`);
    surface.dispose();
  }
});

test('random pairs on the sphere in both forms: the great circle, seed 7', () => {
  const random = createRandom(7);
  const [chart, level] = [
    make({ x: 'cos(v)*cos(u)', y: 'cos(v)*sin(u)', z: 'sin(v)', u: ['-pi', 'pi'], v: ['-pi/2', 'pi/2'] }),
    make({ f: 'x^2+y^2+z^2-1', bounds: cube(1.3) }),
  ];
  for (let i = 0; i < 60; i++) {
    const places = [0, 1].map(() => [random.between(-Math.PI, Math.PI), Math.asin(random.between(-0.99, 0.99))]);
    const points = places.map(([u, v]) => [Math.cos(v) * Math.cos(u), Math.cos(v) * Math.sin(u), Math.sin(v)]);
    const angle = Math.acos(points[0].reduce((sum, x, k) => sum + x * points[1][k], 0));
    for (const path of [chart.shortestPath(places[0], places[1], POLYLINE), level.shortestPath(points[0], points[1], POLYLINE)])
      assert.ok(Math.abs(estimate(path) / angle - 1) < 1e-4, `seed 7, pair ${i}: ${path.status} ${path.length}, ${angle}`);
  }
  chart.dispose();
  level.dispose();
});

test('graphs are freed with their surface and by set', (context) => {
  let blocks = 0;
  const { allocate, release } = Heap.prototype;
  /** @this {Heap} @param {number} bytes */
  function counted(bytes) {
    blocks++;
    return allocate.call(this, bytes);
  }
  /** @this {Heap} @param {number} block */
  function uncounted(block) {
    if (block) blocks--;
    release.call(this, block);
  }
  context.mock.method(Heap.prototype, 'allocate', counted);
  context.mock.method(Heap.prototype, 'release', uncounted);
  const shapes = [
    { ...torus, x: '(R+cos(v))*cos(u)', parameters: { R: 2 } },
    { f: 'x^2+y^2+z^2-R^2', parameters: { R: 1 } },
  ];
  for (const definition of [...shapes, { ...shapes[1], bounds: cube(2) }]) {
    const before = blocks;
    const surface = make(definition);
    const ends =
      definition === shapes[0]
        ? [
            [0.1, 0.2],
            [3, 3],
          ]
        : [
            [1, 0, 0],
            [0, 0, -1],
          ];
    surface.shortestPath(ends[0], ends[1], { ...POLYLINE, points: 9 });
    const held = blocks;
    for (let i = 0; i < 5; i++) {
      surface.set({ R: 2 - i / 4 });
      surface.shortestPath(ends[0], ends[1], { ...POLYLINE, points: 9 });
    }
    assert.ok(held > before && blocks === held, `${blocks} blocks, not ${held}`);
    surface.dispose();
    assert.equal(blocks, before);
  }
});

describe('via', () => {
  test('passes the points by the shortest pieces', () => {
    const surface = make(torus);
    const places = [
      [0.1, 0.2],
      [5.9, 1.5],
      [9, 6],
    ];
    const path = surface.shortestPath(places[0], places[2], { via: [places[1]], points: 99, ...POLYLINE });
    const pieces = [0, 1].map((i) => surface.shortestPath(places[i], places[i + 1], { points: 99, ...POLYLINE }));
    assert.ok(path.converged && path.points.length === 3 * 101, `${path.status}, ${path.points.length}`);
    assert.ok(Math.abs(estimate(path) / (estimate(pieces[0]) + estimate(pieces[1])) - 1) < 1e-5);
    const [x, y, z] = surface.evaluate(places[1]);
    const distances = Array.from({ length: 101 }, (_, i) =>
      Math.hypot(path.points[3 * i] - x, path.points[3 * i + 1] - y, path.points[3 * i + 2] - z),
    );
    assert.ok(Math.min(...distances) < 1e-12);
    const parameters = /** @type {Float64Array} */ (path.parameters);
    for (let i = 2; i < parameters.length; i++) assert.ok(Math.abs(parameters[i] - parameters[i - 2]) < 0.3, `jump at ${i}`);
    assert.equal(surface.shortestPath(places[2], places[0], { via: [places[1]], points: 99, ...POLYLINE }).length, path.length);
    surface.dispose();
  });

  test('on an implicit surface, and straight', () => {
    const surface = make({ f: 'x^2+y^2+z^2-1', bounds: cube(1.2) });
    for (const start of /** @type {const} */ (['global', 'straight'])) {
      const path = surface.shortestPath([1, 0, 0], [-1, 0, 0], {
        via: [
          [0, 1, 0],
          [0, 0, 1],
        ],
        start,
        ...POLYLINE,
      });
      assert.ok(path.converged && Math.abs(estimate(path) / (1.5 * Math.PI) - 1) < 1e-5, `${path.status} ${path.length}`);
    }
    surface.dispose();
  });

  test('misuse', () => {
    const surface = make(torus);
    for (const [options, pattern] of /** @type {[any, RegExp][]} */ ([
      [{ via: 3 }, /options.via must be an array/],
      [{ via: [[1, Number.NaN]] }, /options.via\[0\]\[1\]/],
      [
        {
          via: [
            [1, 1],
            [2, 2],
          ],
          points: 4,
        },
        /options.points must be at least 5/,
      ],
      [{ via: [[1, 1]], start: [0, 0, 1, 1] }, /options.start must be/],
    ]))
      assert.throws(() => surface.shortestPath([0, 0], [1, 1], options), pattern);
    assert.throws(() => surface.geodesics([0, 0], [1, 1], { via: [[1, 0]] }), /geodesics: options.via/);
    surface.dispose();
  });
});

test('misuse of geodesics', () => {
  const surface = make(torus);
  for (const [options, pattern] of /** @type {[any, RegExp][]} */ ([
    [{ max: 0 }, /geodesics: options.max/],
    [{ max: 2.5 }, /geodesics: options.max/],
    [{ start: 'straight' }, /geodesics: options.start/],
    [{ nonsense: 1 }, /geodesics: there is no option 'nonsense'/],
    [null, /geodesics: options must be an object/],
  ]))
    assert.throws(() => surface.geodesics([0, 0], [1, 1], options), pattern);
  surface.dispose();
  assert.throws(() => surface.geodesics([0, 0], [1, 1]), /disposed/);
});

test('two ends beyond a cusp: the shortest path crosses it twice', () => {
  const dini = surfpath.parametric({
    x: '2*cos(u)*sin(v)',
    y: '2*sin(u)*sin(v)',
    z: '2*(cos(v) + log(tan(v/2)) + 0.4*u)',
    u: ['-2*pi', '2*pi'],
    v: [0.1, 2],
  });
  const [from, to] = [
    [4.795361300721137, 1.8774924020261037],
    [-2.4873834935722763, 1.8146692353626248],
  ];
  const [path, round] = dini.geodesics(from, to);
  assert.ok(path.converged && path.crossesSingularity && !path.touchesBoundary);
  // Along the wall v = 2 it is half as long again. In between is a way that starts from a given crossing of v < pi/2.
  assert.ok(round.touchesBoundary && round.length > 1.45 * path.length);
  const start = [...from, 1, 1, ...to];
  assert.ok(Math.abs(dini.shortestPath(from, to, { start }).length - path.length) < 1e-9 * path.length);
  dini.dispose();
});
