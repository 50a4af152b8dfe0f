// Paths made of arcs, where length has a measure of its own, and what a result says of the whole: contacts, poles, cusps, steps, energy, history.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { gallery } from '../../web/gallery.js';
import { load } from '../../web/index.js';
import { loadCases } from '../helpers/cases.js';
import { createRandom } from '../helpers/random.js';
import { ofAll } from '../helpers/sample.js';

/** @typedef {import('../../web/path.js').Path} Path */

const surfpath = await load();
/** @type {any} */
const plane = { x: 'u', y: 'v', z: 0, u: [-3, 3], v: [0.5, 3] };
const wideDini = surfpath.parametric({ ...gallery.dini, v: [0.1, 2] });

/** @param {Path} path @param {number} length @param {number} tolerance */
function assertLength(path, length, tolerance) {
  assert.equal(path.status, 'converged');
  assert.ok(Math.abs(path.length - length) <= tolerance * length, `${path.length}, not ${length}`);
  assert.ok(Math.abs(path.length - length) <= path.lengthError + 4e-15 * length, `error ${path.length - length}, said ${path.lengthError}`);
}

/**
 * The shortest path from (-2, 1) to (2, 3/2) above v = 1/2 under the length element v ds, a soap film's: catenaries v = cosh(2 (u - u0))/2 down to the edge,
 * which they touch, and along it.
 */
function soapLength() {
  const [left, right] = [1, 1.5].map((v) => Math.acosh(2 * v));
  const film = (/** @type {number} */ t) => (t / 2 + Math.sinh(2 * t) / 4) / 4;
  return film(left) + film(right) + (4 - left / 2 - right / 2) / 2;
}

describe('contacts', () => {
  const forms = {
    density: surfpath.parametric({ ...plane, density: 'v' }),
    metric: surfpath.parametric({ ...plane, metric: { E: 'v^2', F: 0, G: 'v^2' } }),
    'E, F, G alone': surfpath.metric({ E: 'v^2', F: 0, G: 'v^2', u: [-3, 3], v: [0.5, 3] }),
  };
  for (const [name, surface] of Object.entries(forms))
    test(`${name}: down to the edge, along it, and up again`, () => {
      for (const tolerance of [1e-4, 1e-9, 1e-12]) {
        const path = surface.shortestPath([-2, 1], [2, 1.5], { tolerance });
        assertLength(path, soapLength(), tolerance);
        assert.ok(path.touchesBoundary);
        assert.equal(path.points.length, surface.kind === 'metric' ? 0 : 3 * 66);
        assert.equal(path.length, surface.shortestPath([2, 1.5], [-2, 1], { tolerance }).length);
      }
    });

  test('a skewed chart, where the direction across the edge is not that of its coordinate', () => {
    const skewed = surfpath.metric({ E: 'v^2', F: '-v^2/2', G: '5*v^2/4', u: [-3, 6], v: [0.5, 3] });
    assertLength(skewed.shortestPath([-1.5, 1], [2.75, 1.5], { tolerance: 1e-12 }), soapLength(), 1e-12);
  });

  test('many chords without arcs come to the same', () => {
    const chords = forms.density.shortestPath([-2, 1], [2, 1.5], { algorithm: 'polyline', points: 2047, maxIterations: 1000 });
    assert.equal(chords.status, 'converged');
    assert.ok(Math.abs(chords.length / soapLength() - 1) < 2e-6);
  });

  test('a field of 25 : 1 that turns by three radians, the open case', () => {
    const [one] = loadCases({ families: 'E' }).filter(({ id }) => id === 'E-rotating_strong-00');
    const surface = surfpath.surface(/** @type {any} */ (one.definition));
    for (const tolerance of [1e-9, 1e-12]) assertLength(surface.shortestPath(one.from, one.to, { tolerance }), one.expected.length, 1e-12);
  });
});

/** Length of the lower convex hull of v = 1 and the two ends, over arc length s and height u + v. @param {number[]} from @param {number[]} to */
function hullLength(from, to) {
  const count = 100_000;
  /** @type {number[][]} */
  const hull = [];
  for (let i = 0; i <= count; i++) {
    const u = from[0] + ((to[0] - from[0]) * i) / count;
    const v = i === 0 ? from[1] : i === count ? to[1] : 1;
    const point = [(Math.sign(u) * ((u * u + 4) ** 1.5 - 8)) / 3, u + v];
    while (hull.length > 1 && turns(hull[hull.length - 2], hull[hull.length - 1], point) <= 0) hull.pop();
    hull.push(point);
  }
  return hull.reduce((sum, [s, h], i) => (i === 0 ? 0 : sum + Math.hypot(s - hull[i - 1][0], h - hull[i - 1][1])), 0);
}

/** Positive where the way from a over b to c turns to the left. @param {number[]} a @param {number[]} b @param {number[]} c */
const turns = (a, b, c) => (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);

describe('across a cusp', () => {
  /* Lengths: the energy of 6,400 segments minimised over u and 2 log sin v, where the metric is regular at the edge, by another program; and the least
     over the crossing of two paths that end 1e-4 beside the edge. Right to that many digits. */
  for (const [name, from, to, length, accuracy] of /** @type {[string, number[], number[], number, number][]} */ ([
    ['an arc touches a wall', [-5.123157652169466, 1.9061641973392751], [6.2746488845720885, 0.21002939434823087], 10.335645998, 2e-7],
    [
      'an end is close to the edge',
      [-0.0070090188086036065, 1.939787828227527],
      [-4.130806662403048, 1.5198895898527471],
      6.833394026,
      4e-9,
    ],
  ]))
    test(name, () => {
      const path = wideDini.shortestPath(from, to);
      assert.deepEqual([path.status, path.crossesSingularity], ['converged', true]);
      const error = Math.abs(path.length - length);
      assert.ok(error <= accuracy * length && path.lengthError <= 1e-9 * length, `error ${error}, said ${path.lengthError}`);
      assert.equal(path.points.length, 3 * 66);
    });

  test('and along a wall: the length of a taut string, and never part of a path, however few steps', () => {
    // A cylinder over the curve (u^3/3, u^2), of arc length s, and u + v up it: flat, so the path below v = 1 is the lower hull of the wall and the ends.
    const surface = surfpath.parametric({ x: 'u^3/3', y: 'u^2', z: 'v + u', u: [-1, 1], v: [0, 1] });
    const [from, to] = [
      [-0.5662376605905592, 0.3650707225315273],
      [0.16097952658310533, 0.959310844540596],
    ];
    const taut = hullLength(from, to);
    assertLength(surface.shortestPath(from, to), taut, 1e-10);
    for (let maxIterations = 0; maxIterations < 240; maxIterations += 3) {
      const { status, length, points } = surface.shortestPath(from, to, { maxIterations });
      if (points.length === 0) assert.deepEqual([status, length], ['singular-metric', Number.NaN]);
      else assert.ok(length >= taut * (1 - 1e-9), `${maxIterations} steps: ${status}, ${length}`);
    }
  });

  test('a path across several, as the start of the same: as long, seed 9', () => {
    // Over cycloids, with a wave: a cusp every 2 pi.
    const waves = surfpath.parametric({ x: 'u - sin(u)', y: '1 - cos(u)', z: 'v + 0.3*sin(2u)', u: [-20, 20], v: [-3, 3] });
    const random = createRandom(9);
    let crossed = 0;
    for (let pair = 0; pair < 20; pair++) {
      const [from, to] = [1, 2].map(() => [random.between(-20, 20), random.between(-3, 3)]);
      const path = waves.shortestPath(from, to);
      if (!path.converged || !path.crossesSingularity) continue;
      crossed++;
      const again = waves.shortestPath(from, to, { start: path });
      assert.ok(
        again.converged && Math.abs(again.length / path.length - 1) < 1e-9,
        `${from} to ${to}: ${again.status}, ${again.length}, not ${path.length}`,
      );
    }
    assert.ok(crossed >= 12, `${crossed} of 20 cross cusps`);
    waves.dispose();
  });
});

describe('poles', () => {
  /** @type {any} */
  const sphere = { E: 'sin(v)^2', F: 0, G: 1, u: [0, '2*pi'], v: [0, 'pi'], periodic: { u: true } };
  test('a sphere of E, F and G alone: over the pole, and from it', () => {
    const surface = surfpath.metric(sphere);
    for (const tolerance of [1e-6, 1e-9, 1e-12])
      assertLength(surface.shortestPath([0.3, 0.5], [0.3 + Math.PI, 0.7], { tolerance }), 1.2, Math.max(tolerance, 1e-14));
    assertLength(surface.shortestPath([5, 0], [0.3, 0.7]), 0.7, 1e-12);
  });

  test('E, F and G over positions: these say nothing of how a path passes the pole', () => {
    const ball = {
      x: 'sin(u) cos(v)',
      y: 'sin(u) sin(v)',
      z: 'cos(u)',
      u: /** @type {[number, string]} */ ([0, 'pi']),
      v: /** @type {[number, string]} */ ([0, '2pi']),
    };
    const surface = surfpath.parametric({ ...ball, metric: { E: 1, F: 0, G: 'sin(u)^2' } });
    assertLength(surface.shortestPath([0.5, 0], [0.5, Math.PI]), 1, 1e-9);
  });

  test('longitude that is not proportional to the angle: straight through the centre of a disc', () => {
    const angle = '(v + 0.5 sin(v))';
    const disc = surfpath.parametric({ x: `u cos${angle}`, y: `u sin${angle}`, z: 0, u: [0, 2], v: ['-pi', 'pi'] });
    let opposite = -1.2;
    for (let i = 0; i < 30; i++)
      opposite -= (opposite + 0.5 * Math.sin(opposite) - (1 + 0.5 * Math.sin(1) - Math.PI)) / (1 + 0.5 * Math.cos(opposite));
    assertLength(disc.shortestPath([1, 1], [1, opposite]), 2, 1e-9);
    const turned = (/** @type {number} */ v) => v + 0.5 * Math.sin(v);
    const beside = opposite + 0.02;
    assertLength(disc.shortestPath([1, 1], [1, beside]), 2 * Math.sin((turned(1) - turned(beside)) / 2), 1e-9);
  });

  test('ends on a rim, opposite to each other: over the top', () => {
    const dome = surfpath.parametric({ x: 'sin(u) cos(v)', y: 'sin(u) sin(v)', z: 'cos(u)', u: [0, 1.3], v: [0, '2pi'] });
    for (const off of [0, 1e-4, 0.01]) {
      const angle = Math.PI - off;
      const length = Math.acos(Math.cos(1.3) ** 2 + Math.sin(1.3) ** 2 * Math.cos(angle));
      assertLength(dome.shortestPath([1.3, 0.1], [1.3, 0.1 + angle]), length, 1e-9);
    }
  });

  test('an edge on which E, F and G are constant is no pole', () => {
    const half = surfpath.metric({ E: '1/v^2', F: 0, G: '1/v^2', u: [-5, 5], v: [1, 5] });
    const path = half.shortestPath([-1, 1], [1, 2]);
    assertLength(path, Math.acosh(1 + (4 + 1) / 4), 1e-9);
    assert.deepEqual(Array.from(/** @type {Float64Array} */ (path.parameters).subarray(0, 2)), [-1, 1]);
  });

  /* Unrolled, the shortest path between two places of a cone is straight. Closed, or a sector hardly wider than the path, which then bends in space as
   * sharply as it passes the apex closely. */
  for (const steepness of [0, 0.2, 1, 5])
    test(`beside the apex of a cone of steepness ${steepness}`, () => {
      const slope = Math.sqrt(1 + steepness ** 2);
      const cone = (/** @type {number[]} */ [low, high]) =>
        surfpath.parametric({ x: 'v*cos(u)', y: 'v*sin(u)', z: 'k*v', u: [low, high], v: [0, 2], parameters: { k: steepness } });
      const [closed, sector] = [cone([-Math.PI, Math.PI]), cone([0, 3.2 * slope])];
      for (const away of ofAll([0.1, 1e-3, 1e-6], [0.1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6]))
        for (const [surface, angle] of /** @type {const} */ ([
          [closed, (Math.PI - away) / slope],
          [sector, Math.PI - away],
        ])) {
          const [a, b] = [0.6 * slope, 1.3 * slope];
          const path = surface.shortestPath([0.02, 0.6], [0.02 + angle * slope, 1.3]);
          const length = Math.sqrt((a - b) ** 2 + 4 * a * b * Math.sin(angle / 2) ** 2);
          if (surface === closed || steepness === 0 || path.converged || (steepness <= 1 && away >= 1e-4)) assertLength(path, length, 1e-9);
        }
    });

  test('a density: as on the same surface without poles', () => {
    const density = '1 + 0.2*x + 0.1*y*z';
    const chart = surfpath.parametric({
      ...gallery.globe,
      x: '2*cos(u)*sin(v)',
      y: '2*sin(u)*sin(v)',
      z: 'cos(v)',
      u: [0, '2*pi'],
      v: [0, 'pi'],
      density,
    });
    const space = surfpath.implicit({ f: 'x^2/4 + y^2/4 + z^2 - 1', density });
    for (const [a, b] of [
      [
        [0.3, 0.5],
        [0.3 + Math.PI, 0.7],
      ],
      [
        [1, 0.05],
        [1.1 + Math.PI, 0.06],
      ],
      [
        [1, 0.7],
        [1.001 + Math.PI, 0.4],
      ],
    ]) {
      const [from, to] = [a, b].map(([u, v]) => [2 * Math.cos(u) * Math.sin(v), 2 * Math.sin(u) * Math.sin(v), Math.cos(v)]);
      const known = space.shortestPath(from, to, { tolerance: 1e-12 });
      assert.equal(known.status, 'converged');
      assertLength(chart.shortestPath(a, b, { tolerance: 1e-10 }), known.length, 1e-10);
    }
  });
});

describe('what a path of arcs says of itself', () => {
  const annulus = surfpath.parametric({ x: 'v*cos(u)', y: 'v*sin(u)', z: 0, u: [-3, 3], v: [1, 3] });
  const globe = surfpath.surface(/** @type {any} */ (gallery.globe));
  /** @type {Record<string, (options?: object) => Path>} */
  const paths = {
    'along an edge': (options) => annulus.shortestPath([-1.5, 2], [1.5, 2], options),
    'over a pole': (options) => globe.shortestPath([0.3, 1.3], [0.3 + Math.PI, 1.2], options),
    'across a cusp': (options) => wideDini.shortestPath([0, 1.2], [1, 1.9], options),
    smooth: (options) => wideDini.shortestPath([0, 1.2], [1, 0.5], options),
  };
  for (const [name, solve] of Object.entries(paths))
    test(`${name}: energy is that of constant speed, the gradient is small, the history falls to both`, () => {
      for (const tolerance of [1e-6, 1e-9, 1e-12]) {
        const path = solve({ tolerance });
        assert.equal(path.status, 'converged');
        assert.ok(Math.abs(path.energy / path.length ** 2 - 1) <= tolerance, `energy ${path.energy}, length ${path.length}`);
        assert.ok(path.gradientNorm >= 0 && path.gradientNorm <= 0.1 * path.length ** 2, `${path.gradientNorm}`);
        const { history } = path;
        assert.deepEqual([history.at(-1)?.energy, history.at(-1)?.gradientNorm, history.at(-1)?.step], [path.energy, path.gradientNorm, 0]);
        for (const [i, { energy, step }] of history.entries())
          assert.ok(i === history.length - 1 || (step > 0 && energy >= history[i + 1].energy * (1 - 1e-13)), `entry ${i}`);
      }
    });

  for (const [name, solve] of Object.entries(paths))
    test(`${name}: maxIterations bounds the sum of all steps`, () => {
      const { iterations } = solve();
      for (const maxIterations of [0, 1, 5, iterations - 1, iterations]) {
        const path = solve({ maxIterations, start: 'straight' });
        assert.ok(path.iterations <= maxIterations, `${path.iterations} of ${maxIterations}`);
        if (maxIterations < 5) assert.notEqual(path.status, 'converged');
      }
      assert.equal(solve({ maxIterations: iterations }).status, 'converged');
    });

  test('record: the last polyline of the history is the path', () => {
    for (const solve of Object.values(paths)) {
      const path = solve({ record: true });
      assert.deepEqual(path.history.at(-1)?.points, path.points);
      for (const { points } of path.history) assert.ok(points?.every(Number.isFinite));
    }
  });
});

test('a path into a corner that touches a wall beside it, seen by the finest elements only', () => {
  const [one] = loadCases({ families: 'C' }).filter(({ id }) => id.startsWith('C-paraboloid'));
  const paraboloid = surfpath.surface(/** @type {any} */ (one.definition));
  const { u, v } = /** @type {{ u: number[], v: number[] }} */ (paraboloid.domain);
  const path = paraboloid.shortestPath([-0.4074405827559531, -0.2793148849937226], [u[1], v[0]]);
  assert.ok(path.converged, path.status);
  paraboloid.dispose();
});

test('a path that chords take for one along a wall: no edge is run backwards', () => {
  const path = wideDini.shortestPath([-5.492295252759976, 0.7137449670350179], [4.922743088671927, 0.9885680797277018]);
  assert.ok(path.converged && !path.touchesBoundary);
  // From the energy of 6,400 segments, minimised by another program; the way back and forth along the wall is 0.7 % longer.
  assert.ok(Math.abs(path.length - 11.5506361) < 1e-6, String(path.length));
});

describe('contacts that chords see and the path has not, and the other way round', () => {
  const moebius = surfpath.surface({ ...gallery.moebius, periodic: {} });
  const bowl = surfpath.surface(gallery.paraboloid);
  for (const { name, surface, from, to } of [
    { name: 'along one wall, and near the other one', surface: moebius, from: [0.3825, -0.2026], to: [5.3745, 0.2771] },
    { name: 'from a wall, along its beginning only', surface: moebius, from: [2.09108, -0.4], to: [1.057496, -0.174682] },
    { name: 'along a wall to its end', surface: bowl, from: [-0.25338754, -Math.PI / 3], to: [1, 0.7609787679802413] },
  ])
    test(name, () => {
      const path = surface.shortestPath(from, to, { tolerance: 1e-10 });
      assert.deepEqual([path.status, path.touchesBoundary], ['converged', true]);
      const options = /** @type {const} */ ({ algorithm: 'polyline', points: 2047, start: path, maxIterations: 1000 });
      const chords = surface.shortestPath(from, to, options);
      assert.equal(chords.status, 'converged');
      assert.ok(Math.abs(chords.length / path.length - 1) < 1e-6, `${path.length}, of chords ${chords.length}`);
    });
});

test('across a cusp from an end beside it: its arc is a millionth of the path, and asked for no more than that', () => {
  const dini = surfpath.parametric({ ...gallery.dini, u: [0, '4pi'], v: [0.3, 2.6] });
  const random = createRandom(31);
  for (let i = 0; i < 24; i++) {
    const [u, side] = [random.between(1, 11), i % 2 ? 1 : -1];
    const from = [u, Math.PI / 2 + side * 10 ** -random.between(2.7, 3.5)];
    const to = [u + random.between(-1, 1), Math.PI / 2 - side * random.between(0.1, 0.7)];
    const [path, fine] = [1e-9, 1e-12].map((tolerance) => dini.shortestPath(from, to, { tolerance, maxIterations: 1000 }));
    assert.equal(path.status, 'converged', `${from} to ${to}`);
    assert.ok(path.crossesSingularity);
    assert.ok(Math.abs(path.length / fine.length - 1) <= 1e-9, `${from} to ${to}: ${path.length}, ${fine.length}`);
  }
});

describe('the energy of a path that was joined is that of constant speed, however many points it has', () => {
  const square = { x: [-2, 2], y: [-2, 2] };
  /** @type {[string, any, number[], number[], number[][]][]} */
  const joined = [
    [
      'at points on the way',
      { kind: 'graph', z: 'x*y', ...square },
      [-1, -1],
      [1, 0.5],
      [
        [0, 0.5],
        [0.3, 0.3],
      ],
    ],
    ['across a crease', { kind: 'graph', z: 'abs(x)', ...square }, [-0.9, -0.8], [0.7, 0.9], []],
    ['along a shore', { kind: 'graph', z: 0, ...square, density: '3 - 2*sign(x^2 + y^2 - 1)' }, [-1.5, 0.2], [1.5, -0.1], []],
    [
      'in a node',
      {
        kind: 'implicit',
        f: 'x^2 + y^2 - z^2',
        bounds: [
          [-2, 2],
          [-2, 2],
          [-2, 2],
        ],
      },
      [1, 0, -1],
      [0, 1.5, 1.5],
      [],
    ],
  ];
  for (const [where, definition, from, to, via] of joined)
    test(where, () => {
      const surface = surfpath.surface(definition);
      for (const points of [5, 64]) {
        const path = surface.shortestPath(from, to, { points, via });
        assert.equal(path.status, 'converged');
        assert.ok(Math.abs(path.energy / path.length ** 2 - 1) < 1e-9, `energy ${path.energy}, length ${path.length}`);
      }
      surface.dispose();
    });
});

test('the error of a path along an edge is not below rounding', () => {
  const square = surfpath.graph({ z: 0, x: [0, 1], y: [0, 1] });
  const annulus = surfpath.parametric({ x: 'v cos(u)', y: 'v sin(u)', z: 0, u: [0, '2pi'], v: [1, 3] });
  for (const [surface, from, to] of /** @type {const} */ ([
    [square, [0.1, 0], [0.7, 0]],
    [annulus, [0, 1], [1, 1]],
  ])) {
    const path = surface.shortestPath(from, to);
    assert.deepEqual([path.status, path.touchesBoundary], ['converged', true]);
    const wrong = Math.abs(path.length - (to[0] - from[0]));
    assert.ok(wrong <= path.lengthError && path.lengthError < 1e-14, `${wrong}, said ${path.lengthError}`);
    surface.dispose();
  }
});
