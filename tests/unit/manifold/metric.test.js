// Densities, metric tensors and surfaces without positions: what is refused, what is returned, and lengths against closed forms, stored paths and each other.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { ExpressionError, load } from '../../../web/index.js';
import { loadCases } from '../../helpers/cases.js';
import { createRandom } from '../../helpers/random.js';

/** @typedef {import('../../../web/path.js').Path} Path */

const surfpath = await load();
const { seed, between } = createRandom(31);
const anything = (/** @type {unknown} */ value) => /** @type {any} */ (value);

const plane = { x: 'u', y: 'v', z: 0, u: [-3, 3], v: [-3, 3], periodic: {} };
const bump = '1 + 3*exp(-(x^2 + y^2)/0.32)';
const torus = '(x^2 + y^2 + z^2 + 13.75)^2 - 64*(x^2 + y^2)';
const bounds = [
  [-5.7, 5.7],
  [-5.7, 5.7],
  [-5.7, 5.7],
];
const ring = { x: '(4 + 1.5*cos(v))*cos(u)', y: '(4 + 1.5*cos(v))*sin(u)', z: '1.5*sin(v)', u: [0, '2*pi'], v: [0, '2*pi'] };
/** ds² with axes k : 1 that turn by a. @param {number} k @param {string} a */
const turning = (k, a) => ({
  E: `${k}*cos(${a})^2 + sin(${a})^2`,
  F: `(${k} - 1)*sin(${a})*cos(${a})`,
  G: `${k}*sin(${a})^2 + cos(${a})^2`,
});
/* With a coordinate: else it is left out. */
const identity = { xx: '1 + 0x', xy: 0, xz: 0, yy: 1, yz: 0, zz: 1 };

/** @param {any} definition @param {number[]} from @param {number[]} to @param {object} [options] */
function solve(definition, from, to, options = {}) {
  const surface = surfpath.surface({ kind: 'parametric', ...definition });
  const accuracy = anything(options).algorithm ? {} : { tolerance: 1e-12 };
  const path = surface.shortestPath(from, to, anything({ start: 'straight', ...accuracy, ...options }));
  surface.dispose();
  return path;
}

/** @param {Path} path @param {Path | number} other @param {number} tolerance @param {string} what */
function sameLength(path, other, tolerance, what) {
  if (typeof other !== 'number') assert.equal(other.status, 'converged', what);
  const length = typeof other === 'number' ? other : other.length;
  assert.equal(path.status, 'converged', `${what}, seed ${seed}`);
  assert.ok(Math.abs(path.length - length) <= tolerance * length, `${what}: ${path.length}, not ${length}`);
}

const pairIn = (/** @type {number} */ half) => [0, 1].map(() => [between(-half, half), between(-half, half)]);

describe('definitions', () => {
  /** @type {[string, object, ErrorConstructor | typeof ExpressionError, RegExp][]} */
  const bad = [
    ['a density that is null', { ...plane, density: null }, TypeError, /parametric: density must be a formula .* not null/],
    ['an unknown name in a density', { ...plane, density: 'w' }, ExpressionError, /density: unknown name w/],
    ['a parameter that hides x', { ...plane, density: 'x', parameters: { x: 1 } }, ExpressionError, /x is a variable of the surface/],
    ['a metric that is a number', { ...plane, metric: 1 }, TypeError, /metric must be \{ E, F, G \}, not 1/],
    ['a metric without G', { ...plane, metric: { E: 1, F: 0 } }, TypeError, /metric must be \{ E, F, G \}; G is missing/],
    ['positions in a metric', { ...plane, metric: { E: 'x', F: 0, G: 1 } }, ExpressionError, /metric.E: unknown name x/],
    ['u in an implicit density', { kind: 'implicit', f: 'x', density: 'u' }, ExpressionError, /density: unknown name u/],
    ['half an implicit metric', { kind: 'implicit', f: 'x', metric: { xx: 1 } }, TypeError, /xy is missing/],
    ['a metric surface without E', { kind: 'metric', F: 0, G: 1, u: [0, 1], v: [0, 1] }, TypeError, /metric: .* E is missing/],
    [
      'a metric surface with a density',
      { kind: 'metric', E: 1, F: 0, G: 1, u: [0, 1], v: [0, 1], density: 2 },
      RangeError,
      /multiply E, F and G/,
    ],
  ];
  for (const [what, definition, error, message] of bad)
    test(`refuses ${what}`, () =>
      assert.throws(
        () => surfpath.surface(anything({ kind: 'parametric', ...definition })),
        (thrown) => thrown instanceof error && message.test(thrown.message),
      ));

  test('a surface without positions evaluates E, F and G, and has nothing to draw', () => {
    const surface = surfpath.metric({ E: '1/v^2', F: 'u*v', G: 'k', u: [-3, 3], v: [0.05, 5], parameters: { k: 2 } });
    assert.deepEqual([...surface.evaluate([1, 2, 3, 4])], [0.25, 2, 2, 0.0625, 12, 2]);
    assert.deepEqual([surface.kind, surface.domain], ['metric', { u: [-3, 3], v: [0.05, 5], periodic: { u: false, v: false } }]);
    assert.throws(() => surface.mesh(), /mesh: .* has no positions/);
    assert.throws(() => surface.project([0, 0, 0]), /project: .* has no positions/);
  });

  test('positions of a surface with a metric are drawn as they are', () => {
    const definition = { ...ring, periodic: { u: true, v: true } };
    const [bare, dressed] = [{}, { metric: { E: 9, F: 0, G: 4 } }].map((more) => surfpath.parametric(anything({ ...definition, ...more })));
    assert.deepEqual(dressed.mesh({ resolution: 8 }), bare.mesh({ resolution: 8 }));
    assert.deepEqual(dressed.project([6, 1, 2]), bare.project([6, 1, 2]));
    const path = dressed.shortestPath([0, 0], [1, 2], anything({ algorithm: 'elements', points: 3 }));
    assert.ok(Math.abs(path.length - 5) <= 1e-12, `${path.length}`);
    assert.deepEqual(
      Array.from(anything(path.parameters), (/** @type {number} */ x) => Number(x.toFixed(12))),
      [0, 0, 0.25, 0.5, 0.5, 1, 0.75, 1.5, 1, 2],
    );
    const drawn = bare.evaluate(anything(path.parameters));
    for (const [i, x] of path.points.entries()) assert.ok(Math.abs(x - drawn[6 * Math.floor(i / 3) + (i % 3)]) <= 1e-14);
  });
});

describe('paths without positions', () => {
  const surface = surfpath.metric({ E: '1/v^2', F: 0, G: '1/v^2', u: [-3, 3], v: [0.05, 5] });
  for (const algorithm of ['elements', 'polyline', 'paper'])
    test(`${algorithm}: parameters and no points, recorded or not`, () => {
      const path = surface.shortestPath([-1, 0.5], [1, 1], anything({ algorithm, points: 9, record: true, start: 'straight' }));
      assert.deepEqual([path.status, path.points.length, path.parameters?.length, path.index], ['converged', 0, 22, 0]);
      assert.deepEqual([...anything(path.parameters)].slice(0, 2), [-1, 0.5]);
      assert.ok(path.history.length > 1 && path.history.every((iterate) => iterate.points === undefined));
      const again = surface.shortestPath([-1, 0.5], [1, 1], anything({ algorithm, points: 9, start: path }));
      assert.ok(again.iterations <= path.iterations && Math.abs(again.length - path.length) <= 1e-12 * path.length);
    });
});

describe('the open data, straight start', () => {
  const cases = loadCases({ families: 'EF' }).filter(({ family, id }) => family === 'E' || id.startsWith('F-tie'));
  for (const tolerance of [1e-9, 1e-12])
    test(`tolerance ${tolerance}: every length is within what is said of it`, (t) => {
      for (const { id, definition, from, to, expected } of cases) {
        const path = solve(definition, from, to, { tolerance });
        const error = Math.abs(path.length - expected.length);
        t.diagnostic(
          `${id.padEnd(22)} ${path.status.padEnd(10)} ${String(path.iterations).padStart(3)} iterations, relative error ${(error / expected.length).toExponential(1)}, said ${(path.lengthError / path.length).toExponential(1)}`,
        );
        assert.ok(
          error <= 10 * path.lengthError + 4 * expected.relerr_bound * expected.length,
          `${id}: ${path.length}, not ${expected.length}`,
        );
        if (!expected.touches_boundary)
          assert.ok(path.converged && error <= 1e-11 * expected.length, `${id}: ${path.status}, error ${error}`);
      }
      assert.ok(cases.length >= 36, `${cases.length} cases`);
    });

  test('a density gives the length of its metric, with positions or without', () => {
    for (const { id, definition, from, to, expected } of cases.filter((one) => one.expected.density)) {
      const { E = '', F = '', G = '' } = expected;
      const path = solve(definition, from, to);
      sameLength(solve({ ...definition, density: undefined, metric: { E, F, G } }, from, to), path, 1e-12, id);
      const { u, v, periodic } = definition;
      sameLength(solve({ kind: 'metric', E, F, G, u, v, periodic }, from, to), path, 1e-12, id);
    }
  });
});

describe('closed forms', () => {
  test('the hyperbolic half-plane', () => {
    for (let i = 0; i < 100; i++) {
      const [from, to] = [0, 1].map(() => [between(-3, 3), between(0.2, 5)]);
      const path = solve({ kind: 'metric', E: '1/v^2', F: 0, G: '1/v^2', u: [-9, 9], v: [0.001, 20] }, from, to, { tolerance: 1e-11 });
      const exact = 2 * Math.asinh(Math.hypot(to[0] - from[0], to[1] - from[1]) / (2 * Math.sqrt(from[1] * to[1])));
      sameLength(path, exact, 1e-10, `${from} ${to}`);
    }
  });

  test("Poincaré's disc", () => {
    const metric = '4/(1 - u^2 - v^2)^2';
    for (let i = 0; i < 100; i++) {
      const [from, to] = pairIn(0.6);
      const path = solve({ kind: 'metric', E: metric, F: 0, G: metric, u: [-0.69, 0.69], v: [-0.69, 0.69] }, from, to, {
        tolerance: 1e-11,
      });
      const [a, b] = [from, to].map(([u, v]) => 1 - u * u - v * v);
      sameLength(path, 2 * Math.asinh(Math.hypot(to[0] - from[0], to[1] - from[1]) / Math.sqrt(a * b)), 1e-10, `${from} ${to}`);
    }
  });

  test('a sphere by its metric, from pole to equator', () => {
    const sphere = { kind: 'metric', E: 'sin(v)^2', F: 0, G: 1, u: [-3, 3], v: [0, 'pi'] };
    sameLength(solve(sphere, [0.3, 0], [0.3, Math.PI / 2]), Math.PI / 2, 1e-12, 'along a meridian');
    sameLength(
      solve(sphere, [0, 1], [1, 1.5]),
      Math.acos(Math.cos(1) * Math.cos(1.5) + Math.sin(1) * Math.sin(1.5) * Math.cos(1)),
      1e-11,
      'across',
    );
  });
});

describe('metrics among each other', () => {
  test('a field of 1 : 100 that turns: chords always converge, elements agree with them', () => {
    const surface = surfpath.metric({ ...turning(100, '(u + 0.7*v)'), u: [-20, 20], v: [-20, 20] });
    for (let i = 0; i < 60; i++) {
      const [from, to] = pairIn(1.5);
      const [coarse, fine] = [255, 511].map((points) => surface.shortestPath(from, to, anything({ algorithm: 'polyline', points })));
      assert.deepEqual([coarse.status, fine.status], ['converged', 'converged'], `${from} ${to}`);
      const path = surface.shortestPath(from, to, anything({ algorithm: 'elements', start: fine }));
      sameLength(path, (4 * fine.length - coarse.length) / 3, 0.1 * (fine.lengthError / fine.length) + 1e-9, `${from} ${to}`);
    }
  });

  test('the error of chords is a third of what halving them changes', () => {
    for (let i = 0; i < 40; i++) {
      const [from, to] = pairIn(1.5);
      const [path, chords] = ['elements', 'polyline'].map((algorithm) =>
        solve({ ...plane, density: bump }, from, to, { algorithm, points: 255 }),
      );
      if (Math.abs(path.length / chords.length - 1) > 0.01) continue; /* another geodesic */
      const error = Math.abs(chords.length - path.length);
      assert.ok(
        Math.abs(error - chords.lengthError) <= 0.1 * chords.lengthError + 1e-13,
        `${from} ${to}: error ${error}, said ${chords.lengthError}`,
      );
    }
  });

  test('a torus with a density, by its chart and by its equation', () => {
    const density = '1 + 2*exp(-((x - 4)^2 + y^2 + (z - 1)^2))';
    for (let i = 0; i < 25; i++) {
      const [from, to] = [0, 1].map(() => [between(-1.5, 1.5), between(-2, 2)]);
      const chart = solve({ ...ring, density }, from, to);
      const ends = [chart.points.slice(0, 3), chart.points.slice(-3)].map((end) => Array.from(end));
      sameLength(
        solve({ kind: 'implicit', f: torus, density, bounds }, ends[0], ends[1], { start: chart.points }),
        chart,
        1e-12,
        `${from} ${to}`,
      );
    }
  });

  test('a tensor that is the identity, or a density squared times it, changes nothing', () => {
    const [from, to] = [
      [5.5, 0, 0],
      [0, 4, 1.5],
    ];
    const [bare, dense] = [{}, { density: '2 + sin(x)' }].map((more) => solve({ kind: 'implicit', f: torus, bounds, ...more }, from, to));
    sameLength(solve({ kind: 'implicit', f: torus, bounds, metric: identity }, from, to), bare, 1e-12, 'identity');
    sameLength(solve({ kind: 'implicit', f: torus, bounds, metric: identity, density: '2 + sin(x)' }, from, to), dense, 1e-12, 'density');
    const metric = turning(4, '(u - v)');
    const scaled = Object.fromEntries(Object.entries(metric).map(([name, formula]) => [name, `(1 + u^2)^2*(${formula})`]));
    const both = solve({ ...plane, metric, density: '1 + x^2' }, [-1, -1], [1, 0.5]);
    sameLength(both, solve({ ...plane, metric: scaled }, [-1, -1], [1, 0.5]), 1e-12, 'both');
  });

  test('a tensor over space that is a quadratic form stretches it: an ellipsoid for a sphere', () => {
    const [from, to] = [
      [1, 0, 0],
      [0, 0.6, 0.8],
    ];
    const metric = { xx: 9, xy: 0, xz: 0, yy: 4, yz: 0, zz: 1 };
    const stretched = solve({ kind: 'implicit', f: 'x^2 + y^2 + z^2 - 1', bounds, metric }, from, to);
    sameLength(stretched, solve({ kind: 'implicit', f: 'x^2/9 + y^2/4 + z^2 - 1', bounds }, [3, 0, 0], [0, 1.2, 0.8]), 1e-11, 'ellipsoid');
  });

  test('exchanged ends give the same bits, and twice the density twice the length', () => {
    const definition = { ...plane, density: bump };
    const [there, back] = [solve(definition, [-1, -0.4], [1.2, 0.3]), solve(definition, [1.2, 0.3], [-1, -0.4])];
    assert.equal(there.length, back.length);
    const twice = solve({ ...plane, density: `2*(${bump})` }, [-1, -0.4], [1.2, 0.3]);
    assert.deepEqual([twice.length, twice.points], [2 * there.length, there.points]);
  });
});

describe('what is no metric', () => {
  /** @type {[string, object][]} */
  const bad = [
    ['a density that changes sign', { density: 'u - 0.1' }],
    ['a density that is negative', { density: -1 }],
    ['a density that vanishes', { density: 'u^2' }],
    ['a metric that is indefinite', { metric: { E: 1, F: '2*u', G: 1 } }],
    ['a metric that is negative', { metric: { E: -1, F: 0, G: -1 } }],
    ['a metric that vanishes', { metric: { E: 'u^2', F: 0, G: 1 } }],
    ['a metric times a density that changes sign', { metric: { E: 1, F: 0, G: 1 }, density: 'u - 0.1' }],
  ];
  for (const [what, more] of bad)
    for (const algorithm of ['elements', 'polyline', 'paper'])
      test(`${what}, ${algorithm}`, () => {
        const path = solve({ ...plane, ...more }, [-1, -0.4], [1.2, 0.3], { algorithm });
        assert.deepEqual([path.status, path.points.length], ['singular-metric', 0]);
      });

  test('a density that is no number where the path goes', () => {
    assert.equal(solve({ ...plane, density: 'sqrt(u)' }, [-1, 0], [1, 0]).status, 'not-finite');
    assert.equal(solve({ ...plane, density: '1/(u + 3)' }, [-3, 0], [1, 1]).status, 'not-finite');
  });
});

describe('parameters and seams', () => {
  test('set() reaches the density and the metric', () => {
    const definition = anything({ ...plane, density: 'a + x^2', metric: { E: 'b', F: 0, G: 1 }, parameters: { a: 1, b: 1 } });
    const surface = surfpath.parametric(definition);
    surface.set({ a: 3, b: 4 });
    const wanted = solve({ ...plane, density: '3 + x^2', metric: { E: 4, F: 0, G: 1 } }, [-1, 0.2], [1, 0.7]);
    sameLength(surface.shortestPath([-1, 0.2], [1, 0.7], anything({ algorithm: 'elements', tolerance: 1e-12 })), wanted, 1e-13, 'set');
  });

  test("periodic 'auto' wants the density and the metric to close, too", () => {
    const closes = (/** @type {object} */ more) => anything(surfpath.parametric(anything({ ...ring, ...more })).domain).periodic;
    assert.deepEqual(closes({}), { u: true, v: true });
    assert.deepEqual(closes({ density: '2 + x' }), { u: true, v: true });
    assert.deepEqual(closes({ density: '2 + u' }), { u: false, v: true });
    assert.deepEqual(closes({ metric: { E: 1, F: 0, G: '1 + v' } }), { u: true, v: false });
    assert.throws(() => closes({ density: '2 + u', periodic: { u: true } }), /its formulas do not repeat beyond the ends of u/);
  });

  test('a metric without positions wraps only where asked', () => {
    const flat = { kind: 'metric', E: 1, F: 0, G: 1, u: [0, 1], v: [0, 1] };
    sameLength(solve(flat, [0.1, 0.5], [0.9, 0.5]), 0.8, 1e-14, 'open');
    sameLength(solve({ ...flat, periodic: { u: true } }, [0.1, 0.5], [0.9, 0.5]), 0.2, 1e-14, 'closed');
  });
});

test('a start that leads where the metric is none is singular-metric there, not another mistake', () => {
  const ends = [
    [0.5, 0],
    [0.6, 0.5],
  ];
  const start = [...ends[0], -0.5, 0.2, ...ends[1]];
  for (const surface of [
    surfpath.metric({ E: 'u', F: 0, G: 1, u: [-1, 1], v: [-1, 1] }),
    surfpath.graph({ z: 0, x: [-1, 1], y: [-1, 1], density: 'x' }),
  ])
    assert.equal(surface.shortestPath(ends[0], ends[1], { start }).status, 'singular-metric');
});
