// `start: 'global'` and `geodesics`, mostly of polylines: the globally shortest paths of the open data, reversal, seams, floods, disconnected ends, memory, misuse.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { load } from '../../../web/index.js';
import { Heap } from '../../../web/runtime/heap.js';
import { loadCases } from '../../helpers/cases.js';
import { POLYLINE } from '../../helpers/options.js';
import { createRandom } from '../../helpers/random.js';
import { ofAll } from '../../helpers/sample.js';
import { simpson } from '../../helpers/simpson.js';
import { acrossWaves, corrugated, unroll } from '../../helpers/unroll.js';
import { verifyPath } from '../../helpers/verify-path.js';

/** @typedef {import('../../../web/index.js').Path} Path */

/** Of a polyline with 64 inner points. */
const CHORDS = 2e-3;
/** Cases whose path goes over a pole of its chart: the right length, but a chord across a pole is not certified. */
const OVER_A_POLE = /12p$/;

/** @type {import('../../../web/instance.js').Surfpath} */
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

/** By definition: a graph is built once. @type {Map<string, import('../../../web/index.js').Surface>} */
const surfaces = new Map();

/** @param {any} definition */
function surfaceOf(definition) {
  const key = JSON.stringify(definition);
  const surface = surfaces.get(key) ?? make(definition);
  surfaces.set(key, surface);
  return surface;
}

describe('open data', () => {
  for (const name of new Set(cases.map(({ expected, definition }) => `${expected.surface} ${definition.kind}`))) {
    test(name, () => {
      const own = cases.filter(({ expected, definition }) => `${expected.surface} ${definition.kind}` === name);
      for (const { id, definition, from, to, expected } of own) {
        const path = surfaceOf(definition).shortestPath(from, to, { ...POLYLINE, points: 64 });
        const excess = path.length / expected.length - 1;
        assert.ok(path.converged || OVER_A_POLE.test(id), `${id}: ${path.status}`);
        assert.ok(Math.abs(excess) < CHORDS, `${id}: length ${path.length}, expected ${expected.length}`);
        const gap = expected.unique && expected.second_length ? expected.second_length / expected.length - 1 : CHORDS;
        assert.ok(estimate(path) / expected.length - 1 < gap / 2, `${id}: longer than the shortest by ${excess}`);
        if (path.converged) assert.deepEqual(verifyPath(definition, path, { from, to }), [], id);
      }
    });
  }
});

test('A to B is B to A, to the bit', () => {
  const chosen = cases.filter(({ id, definition }) => /-0[0-5]/.test(id) && !OVER_A_POLE.test(id) && definition.kind !== 'metric');
  for (const { id, definition, from, to } of chosen) {
    const surface = surfaceOf(definition);
    const [there, back] = [
      surface.shortestPath(from, to, { ...POLYLINE, points: 21 }),
      surface.shortestPath(to, from, { ...POLYLINE, points: 21 }),
    ];
    assert.equal(there.length, back.length, id);
    for (let i = 0; i < there.points.length; i++) {
      const mirrored = back.points.length - 3 - i + 2 * (i % 3);
      assert.equal(there.points[i], back.points[mirrored], `${id}, number ${i}`);
    }
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

test('geodesics: the first is the shortest path, though that is found in another way than they are', () => {
  const ripples = surfpath.graph({ z: '0.69*cos(4.36*(x^2+y^2))', x: [-1, 1], y: [-1, 1] });
  const ends = /** @type {const} */ ([
    [-1, 1],
    [0.55, 0.05],
  ]);
  const [first, second] = ripples.geodesics(...ends);
  assert.equal(first.length, ripples.shortestPath(...ends).length);
  assert.ok(first.length < 4.19 && second.length > 5, `${first.length}, ${second.length}`);
  assert.equal(ripples.geodesics(...ends, { max: 1 }).length, 1);
  ripples.dispose();
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

test('without bounds no flood goes farther than the ways of one before it ask for', (context) => {
  const flood = context.mock.method(Heap.prototype, 'buildGraph');
  const gyroid = surfpath.implicit({ f: 'sin(x)*cos(y) + sin(y)*cos(z) + sin(z)*cos(x)' });
  const path = gyroid.shortestPath([0, 0, 0], [Math.PI / 2, Math.PI / 2, Math.PI / 2]);
  assert.equal(path.status, 'converged');
  const graphs = flood.mock.calls.map(({ result }) => /** @type {import('../../../web/runtime/heap.js').Graph} */ (result));
  assert.ok(graphs.length >= 2 && graphs.every(({ vertices }) => vertices < 15_000), `${graphs.map(({ vertices }) => vertices)}`);
  gyroid.dispose();
});

test('from an apex only one path is solved finely, and it goes straight up', (context) => {
  const cone = surfpath.revolution({ r: 't', z: 't', t: [0, 1] });
  const solve = context.mock.method(Heap.prototype, 'solve');
  const path = cone.shortestPath([0, 0], [3, 1]);
  assert.ok(path.converged && Math.abs(path.length - Math.SQRT2) < 1e-12);
  const fine = solve.mock.calls.filter((call) => /** @type {any} */ (call.arguments[2]).algorithm === 0);
  assert.equal(fine.length, 1);
});

test('where all starts lead to one path few are tried, unless several are wanted', (context) => {
  const egg = make({ f: 'x^2 + y^2/1.4 + z^2/0.8 - 1', bounds: cube(1.3), density: '1 + 0.5*exp(-x^2 - y^2)' });
  const ends = [egg.project([0.3, 0.1, 1]), egg.project([-0.4, 0.2, 1])];
  const solve = context.mock.method(Heap.prototype, 'solve');
  const path = egg.shortestPath(ends[0], ends[1]);
  const few = solve.mock.callCount();
  const [shortest] = egg.geodesics(ends[0], ends[1], { max: 2 });
  assert.ok(path.converged && Math.abs(path.length - shortest.length) < 1e-9 && few <= 13 && solve.mock.callCount() > 3 * few, `${few}`);
  egg.dispose();
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
    const many = Array.from({ length: 40 }, (_, i) => [0.02 * (i + 1), 0.5]);
    const path = surface.shortestPath([0, 0.5], [1, 0.5], { via: many });
    assert.ok(path.converged && path.points.length === 3 * 83, `${path.status} ${path.points.length / 3} points`);
    assert.throws(() => surface.geodesics([0, 0], [1, 1], /** @type {any} */ ({ via: [[1, 0]] })), /geodesics: there is no option 'via'/);
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

/** @type {any} */
const dini = {
  x: '2*cos(u)*sin(v)',
  y: '2*sin(u)*sin(v)',
  z: '2*(cos(v) + log(tan(v/2)) + 0.4*u)',
  u: ['-2*pi', '2*pi'],
  v: [0.1, 2],
};

test('two ends beyond a cusp: the shortest path crosses it twice', () => {
  const surface = make(dini);
  const [from, to] = [
    [4.795361300721137, 1.8774924020261037],
    [-2.4873834935722763, 1.8146692353626248],
  ];
  const [path, round] = surface.geodesics(from, to);
  assert.ok(path.converged && path.crossesSingularity && !path.touchesBoundary);
  // Along the wall v = 2 it is half as long again. In between is a way that starts from a given crossing of v < pi/2.
  assert.ok(round.touchesBoundary && round.length > 1.45 * path.length);
  const start = [...from, 1, 1, ...to];
  assert.ok(Math.abs(surface.shortestPath(from, to, { start }).length - path.length) < 1e-9 * path.length);
  surface.dispose();
});

describe('across a cusp and along a wall', () => {
  // Lengths by minimising the energy of 6,400 segments over u and 2 log sin v, in which the metric is regular at the cusp, by another program.
  for (const { from, to, relaxed } of [
    { from: [4.192669470495284, 0.13609194888267667], to: [-2 * Math.PI, 2], relaxed: 8.785465902 },
    { from: [1.1736778105404122, 2], to: [-0.45106699099071523, 1.409163585258648], relaxed: 3.308442735 },
    { from: [-2 * Math.PI, 1.1199486588127912], to: [-2 * Math.PI, 2], relaxed: 0.400515544 },
    { from: [-3.8131209953606793, 0.1], to: [4.094127931878949, 1.6272836345480755], relaxed: 11.078969634 },
  ])
    test(`${from} to ${to}`, () => {
      const surface = make(dini);
      const path = surface.shortestPath(from, to, { points: 199 });
      assert.ok(path.converged && path.crossesSingularity && path.touchesBoundary);
      assert.ok(Math.abs(path.length - relaxed) < 2e-7 * relaxed, `${path.length}, not ${relaxed}`);
      const parameters = /** @type {Float64Array} */ (path.parameters);
      // Its parts are shortest, too: those from the middle of where it runs along a wall.
      const inner = Array.from({ length: 199 }, (_, i) => Array.from(parameters.subarray(2 * i + 2, 2 * i + 4)));
      const along = inner.filter(([u, v]) => Math.abs(u) === 2 * Math.PI || v === 0.1 || v === 2);
      const middle = along[along.length >> 1];
      const parts = [surface.shortestPath(from, middle), surface.shortestPath(middle, to)];
      assert.ok(parts.every(({ converged }) => converged));
      assert.ok(Math.abs(parts[0].length + parts[1].length - path.length) < 1e-8 * path.length);
      surface.dispose();
    });
});

describe('a surface with more detail than its graph has', () => {
  const surface = () => make(/** @type {any} */ (cases.find(({ expected }) => expected.surface === 'bc_printed')).definition);

  // The shortest known, found by exhaustive multistart (tests/accuracy/global.js) from another mesh.
  for (const { from, to, known } of [
    {
      from: [0.437048214252527, 0.359821943359998, 0.8754339331355235],
      to: [1.0096938056675344, 0.1166940145051134, 0.9132729219451433],
      known: 1.0304488778343575,
    },
    {
      from: [0.9829503354252677, -0.3337799831116453, -0.8377082559703201],
      to: [0.4374938128987541, -0.3972861595398495, -0.5409276550066953],
      known: 0.8049650987913071,
    },
    {
      from: [0.9065483343518143, 0.5315371918474328, 0.7658836060622063],
      to: [0.3199869703927145, 0.03877544237915018, -0.1487309900277899],
      known: 1.3358236492307418,
    },
  ])
    test(`a way that seven shorter ones of the graph hide, ${known}`, () => {
      const eq47 = surface();
      const path = eq47.shortestPath(from, to);
      assert.ok(path.converged && path.length < known * (1 + 1e-8));
      eq47.dispose();
    });

  // One turns by a radian within a two-hundredth of its length: equally spread elements leave 2e-9 and 7e-9.
  for (const [from, to] of [
    [
      [0.9996046266992197, -0.15586883085134973, -0.3597557695486259],
      [-0.9487694658939032, -0.17618609319517106, -0.9731072604290322],
    ],
    [
      [0.8815817170546718, 0.4453107285927626, 0.3515704887971923],
      [-0.9940509041529135, 0.27159314161851167, -0.8534061435547244],
    ],
  ])
    test(`elements lie closer where a path turns, ${from}`, () => {
      const eq47 = surface();
      const path = eq47.shortestPath(from, to, { tolerance: 1e-11, points: 999 });
      assert.ok(path.converged && path.lengthError < 1e-11 * path.length);
      const part = (/** @type {number} */ first, /** @type {number} */ last) =>
        eq47.shortestPath(
          Array.from(path.points.subarray(3 * first, 3 * first + 3)),
          Array.from(path.points.subarray(3 * last, 3 * last + 3)),
          {
            start: path.points.slice(3 * first, 3 * last + 3),
          },
        );
      const parts = [part(0, 300), part(300, 700), part(700, 1000)];
      const sum = parts.reduce((length, one) => length + one.length, 0);
      assert.ok(Math.abs(sum - path.length) < 1e-10 * path.length);
      eq47.dispose();
    });
});

test('breather, kin of Dini’s surface: from end to end, across several cusps, seed 8', () => {
  const denominator = '(0.4*((1-0.16)*cosh(0.4*u)^2+0.16*sin(w*v)^2))';
  const breather = surfpath.parametric({
    x: `-u+2*(1-0.16)*cosh(0.4*u)*sinh(0.4*u)/${denominator}`,
    y: `2*w*cosh(0.4*u)*(-(w*cos(v)*cos(w*v))-sin(v)*sin(w*v))/${denominator}`,
    z: `2*w*cosh(0.4*u)*(-(w*sin(v)*cos(w*v))+cos(v)*sin(w*v))/${denominator}`,
    parameters: { w: Math.sqrt(0.84) },
    u: [-5, 5],
    v: [-10, 10],
  });
  const random = createRandom(8);
  for (let i = 0; i < ofAll(8, 20); i++) {
    const [from, to] = [-9.9, 9].map((v) => [random.between(-5, 5), v + random.between(0, 0.9)]);
    const path = breather.shortestPath(from, to, { maxIterations: 400 });
    assert.ok(path.crossesSingularity && (path.converged || path.status === 'tolerance-not-met'), `${from} to ${to}: ${path.status}`);
    // However few the steps, it is a path, which arcs that are still rough take for too short by a millionth at most, or none.
    const short = breather.shortestPath(from, to, { maxIterations: 60 + 5 * i });
    if (short.status === 'singular-metric') assert.equal(short.points.length, 0);
    else assert.ok(short.length >= path.length * (1 - 1e-6), `${from} to ${to}, ${60 + 5 * i} steps: ${short.status}, ${short.length}`);
  }
  breather.dispose();
});

test('Boy’s surface, cut open: where it is shorter, through the line within the rectangle that is one point, seed 9', () => {
  const boy = surfpath.parametric({
    x: '2/3*(cos(u)*cos(2*v)+sqrt(2)*sin(u)*cos(v))*cos(u)/(sqrt(2)-sin(2*u)*sin(3*v))',
    y: '2/3*(cos(u)*sin(2*v)-sqrt(2)*sin(u)*sin(v))*cos(u)/(sqrt(2)-sin(2*u)*sin(3*v))',
    z: 'sqrt(2)*cos(u)^2/(sqrt(2)-sin(2*u)*sin(3*v))',
    u: [0, 'pi'],
    v: [0, 'pi'],
    periodic: { u: true },
  });
  /** Along v as it is, to u = π/2. @param {number[]} place */
  const toMiddle = ([u, v]) => {
    const points = boy.evaluate(Array.from({ length: 1001 }, (_, i) => [u + ((Math.PI / 2 - u) * i) / 1000, v]).flat());
    let length = 0;
    for (let i = 6; i < points.length; i += 6)
      length += Math.hypot(points[i] - points[i - 6], points[i + 1] - points[i - 5], points[i + 2] - points[i - 4]);
    return length;
  };
  const random = createRandom(9);
  let converged = 0;
  for (let i = 0; i < ofAll(20, 60); i++) {
    const [from, to] = [0, 1].map(() => [random.between(0.3, 2.8), random.between(0, Math.PI)]);
    const path = boy.shortestPath(from, to);
    // The search lets 1e-3 pass, and ways of its graph to the middle are hardly longer than these.
    const through = toMiddle(from) + toMiddle(to);
    assert.ok(!path.converged || path.length <= through * 1.002, `${from} to ${to}: ${path.length}, through the middle ${through}`);
    converged += Number(path.converged);
  }
  assert.ok(converged >= ofAll(19, 55), `${converged} converged`);
  boy.dispose();
});

describe('cones of more than a full turn around the apex: through it, or past it, as unrolled, seed 10', () => {
  for (const [name, height, slope, period] of /** @type {[string, (u: number) => number, (u: number) => number, number][]} */ ([
    ['cos(2*u)', (u) => Math.cos(2 * u), (u) => -2 * Math.sin(2 * u), 2 * Math.PI],
    ['2*cos(3*u)', (u) => 2 * Math.cos(3 * u), (u) => -6 * Math.sin(3 * u), 2 * Math.PI],
    ['0.5*sin(5*u)', (u) => 0.5 * Math.sin(5 * u), (u) => 2.5 * Math.cos(5 * u), 2 * Math.PI],
    ['0.3*sin(u/2)', (u) => 0.3 * Math.sin(u / 2), (u) => 0.15 * Math.cos(u / 2), 4 * Math.PI],
  ]))
    test(`z = v ${name}`, () => {
      const cone = surfpath.parametric({ x: 'v*cos(u)', y: 'v*sin(u)', z: `v*${name}`, u: [0, period], v: [0, 1] });
      /** How far rays turn. @param {number} from @param {number} to */
      const angleBetween = (from, to) =>
        simpson((u) => Math.sqrt(1 + height(u) ** 2 + slope(u) ** 2) / (1 + height(u) ** 2), from, to, 1000);
      const whole = angleBetween(0, period);
      const random = createRandom(10);
      let [through, past] = [0, 0];
      for (let i = 0; i < 40; i++) {
        const [from, to] = [0, 1].map(() => [random.between(0, period), random.between(0.05, 1)]);
        const turned = angleBetween(Math.min(from[0], to[0]), Math.max(from[0], to[0]));
        const angle = Math.min(turned, whole - turned, Math.PI);
        const [a, b] = [from, to].map(([u, v]) => v * Math.hypot(1, height(u)));
        const unrolled = Math.sqrt(a * a + b * b - 2 * a * b * Math.cos(angle));
        const path = cone.shortestPath(from, to);
        assert.equal(path.status, 'converged', `${from} to ${to}`);
        const isBent = path.length > unrolled * (1 + 1e-7);
        assert.ok(
          path.length >= unrolled * (1 - 1e-7) && (!isBent || path.touchesBoundary),
          `${from} to ${to}: ${path.length}, ${unrolled}`,
        );
        through += Number(angle === Math.PI);
        past += Number(angle < Math.PI && !isBent);
      }
      assert.ok(through >= 5 && past >= 5, `${through} through the apex, ${past} past it`);
      cone.dispose();
    });
});

test('a surface so large in places that chords are rounded to more than edges are long is searched to an end', () => {
  const surface = surfpath.revolution({
    r: '1.5+sign(t) atan2((t) - t ^ -2, 0.5 ^ 3+cosh(t) t * t^2)*sinh(t^-2 + min(t, t) sinh(t)*3^0.5*sinh(t)^-1 + 1e-1) t^2',
    z: 't',
    t: [-1, 1],
  });
  const options = /** @type {const} */ ({ start: 'straight', algorithm: 'polyline', points: 3, maxIterations: 22 });
  const path = surface.shortestPath([0.5555716645784134, 0.9326746980659664], [4.711128916377966, -0.06660764012485743], options);
  assert.equal(path.status, 'singular-metric');
  surface.dispose();
});

describe('corrugated sheets, along which chords do not come to rest: as long as unrolled, in a few solves', () => {
  for (const [waves, slope] of [
    [40, 6],
    [60, 6],
    [80, 3],
  ])
    test(`sin(${waves} u), slopes of ${slope}`, (context) => {
      const sheet = make({ x: 'u', y: 'v', z: `${slope / waves}*sin(${waves}*u)`, u: [-1, 1], v: [-1, 1] });
      const solve = context.mock.method(Heap.prototype, 'solve');
      const random = createRandom(waves);
      for (let i = 0; i < 3; i++) {
        const [from, to] = acrossWaves(random);
        solve.mock.resetCalls();
        const path = sheet.shortestPath(from, to);
        const length = unroll(corrugated(waves, slope), [from, to], 100_000);
        assert.equal(path.status, 'converged', `${from} to ${to}`);
        assert.ok(Math.abs(path.length - length) <= 1e-9 * length, `${from} to ${to}: ${path.length}, ${length}`);
        assert.ok(solve.mock.callCount() < 10, `${solve.mock.callCount()} solves`);
      }
      sheet.dispose();
    });
});

describe('paths across waves that do not come to rest', () => {
  const sheets = [
    [20, 2],
    [40, 3],
    [60, 6],
  ];
  test('are off by no more than three times their errors, most by less than these', () => {
    let [stalled, within] = [0, 0];
    for (const [waves, slope] of sheets) {
      const sheet = make({ x: 'u', y: 'v', z: `${slope / waves}*sin(${waves}*u)`, u: [-1, 1], v: [-1, 1] });
      const random = createRandom(waves);
      for (let i = 0; i < 20; i++) {
        const [from, to] = acrossWaves(random);
        const length = unroll(corrugated(waves, slope), [from, to], 20_000);
        for (const maxIterations of [1, 3, 10, 30, 100]) {
          const path = sheet.shortestPath(from, to, { start: 'straight', maxIterations });
          if (path.status !== 'stalled') continue;
          const off = Math.abs(path.length - length) / path.lengthError;
          assert.ok(off <= 3, `${waves} ${from} to ${to}, ${maxIterations} steps: off by ${off} errors`);
          stalled++;
          within += Number(off <= 1);
        }
      }
      sheet.dispose();
    }
    assert.ok(stalled > 200 && within > 0.9 * stalled, `${within} of ${stalled}`);
  });

  test('under a density more chords lead on where some do not follow the surface', () => {
    const sheet = make({ x: 'u', y: 'v', z: '3/40*sin(40*u)', u: [-1, 1], v: [-1, 1], density: '1+u^2+v^2/2' });
    const random = createRandom(40);
    const paths = Array.from({ length: 8 }, () => acrossWaves(random)).map(([from, to]) =>
      sheet.shortestPath(from, to, { start: 'straight' }),
    );
    assert.ok(paths.filter(({ converged }) => converged).length >= 3, `${paths.map(({ status }) => status)}`);
    sheet.dispose();
  });

  test('are not taken for the shortest', () => {
    /** @type {{ kind: 'parametric', x: string, y: string, z: string, u: [number, number], v: [number, number] }} */
    const definition = { kind: 'parametric', x: 'u', y: 'v', z: 'sin(60*u)/10+0.05*v^2', u: [-1, 1], v: [-1, 1] };
    const ends = { from: [-0.8414071883267756, 0.3469289594082763], to: [0.6329958450202811, 0.19416372067954568] };
    const sheet = make(definition);
    const path = sheet.shortestPath(ends.from, ends.to, { points: 4095 });
    assert.equal(path.status, 'converged');
    assert.deepEqual(verifyPath(definition, path, { ...ends, lengthTolerance: 1e-3 }), []);
    sheet.dispose();
  });
});
