// Surfaces whose sheets cross, or lie nearer to each other than chords are long: paths found by E, F and G where chords in space jump from sheet to sheet. Against E, F and G written
// by hand, closed forms, and traced geodesics.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { load } from '../../web/index.js';
import { createRandom } from '../helpers/random.js';
import { ofAll } from '../helpers/sample.js';
import { simpson } from '../helpers/simpson.js';

/** @typedef {import('../../web/definition.js').ParametricDefinition} ParametricDefinition */

const surfpath = await load();
/** Two tolerances of 1e-9, relative: one of each path. */
const RIGHT = 2e-9;
/** A traced path ends this near to where it should, in parts of its length; beside a pinch point neighbours part by a millionfold. */
const LANDED = 1e-3;
/** So much of the range, from its edges, is left free of ends. */
const MARGIN = 0.02;
/** Random pairs on a surface. */
const PAIRS = ofAll(5, 20);

/** @param {import('../../web/surface.js').Surface} surface @param {number} seed @param {number} count @returns {number[][][]} */
function randomPairs(surface, seed, count) {
  const random = createRandom(seed);
  const { u, v } = /** @type {NonNullable<typeof surface.domain>} */ (surface.domain);
  const place = () => [u, v].map(([low, high]) => random.between(low + MARGIN * (high - low), high - MARGIN * (high - low)));
  return Array.from({ length: count }, () => [place(), place()]);
}

/** The direction in u and v in which a path begins, by five of its points. @param {import('../../web/path.js').Path} path */
function slopeOf({ parameters }) {
  const at = /** @type {Float64Array} */ (parameters);
  return [0, 1].map((j) => -25 * at[j] + 48 * at[j + 2] - 36 * at[j + 4] + 16 * at[j + 6] - 3 * at[j + 8]);
}

/** Pinch points, from which double lines begin, with E, F and G by hand; least: the part of paths that converge. @type {{ title: string, surface: ParametricDefinition, metric: { E: string, F: string, G: string }, least: number }[]} */
const PINCHED = [
  {
    title: "Whitney's umbrella",
    surface: { x: 'u*v', y: 'u', z: 'v^2', u: [-1, 1], v: [-1, 1] },
    metric: { E: 'v^2 + 1', F: 'u*v', G: 'u^2 + 4v^2' },
    least: 1,
  },
  {
    title: "Plücker's conoid",
    surface: { x: 'v*cos(u)', y: 'v*sin(u)', z: 'sin(2u)', u: [0, '2pi'], v: [-1, 1] },
    metric: { E: 'v^2 + 4cos(2u)^2', F: '0', G: '1' },
    least: 0.95,
  },
  {
    title: 'the sine surface',
    surface: { x: 'sin(u)', y: 'sin(v)', z: 'sin(u + v)', u: [0, '2pi'], v: [0, '2pi'] },
    metric: { E: 'cos(u)^2 + cos(u + v)^2', F: 'cos(u + v)^2', G: 'cos(v)^2 + cos(u + v)^2' },
    least: 0.9,
  },
];

for (const { title, surface: definition, metric, least } of PINCHED)
  describe(title, () => {
    const surface = surfpath.parametric(definition);
    const { periodic } = /** @type {NonNullable<typeof surface.domain>} */ (surface.domain);
    const abstract = surfpath.metric({ ...metric, u: definition.u, v: definition.v, periodic });
    const pairs = randomPairs(surface, 81, PAIRS);
    const paths = pairs.map(([from, to]) => surface.shortestPath(from, to));

    test('nearly all paths converge, are geodesics, and as long as E, F and G say', () => {
      let count = 0;
      for (const [i, path] of paths.entries()) {
        if (!path.converged) continue;
        const [from, to] = pairs[i];
        const other = abstract.shortestPath(from, to);
        if (other.converged)
          assert.ok(Math.abs(path.length / other.length - 1) < RIGHT, `${from} to ${to}: ${path.length}, not ${other.length}`);
        if (!path.touchesBoundary) {
          const end = surface.trace(from, slopeOf(surface.shortestPath(from, to, { points: 4095 })), path.length).points.slice(-3);
          const missed = Math.hypot(
            ...surface
              .evaluate(to)
              .subarray(0, 3)
              .map((x, j) => x - end[j]),
          );
          assert.ok(missed < LANDED * path.length, `${from} to ${to}: traced, it misses the end by ${missed}`);
        }
        count++;
      }
      assert.ok(count >= least * paths.length, `${count} of ${paths.length}`);
    });

    test('the same both ways, in bulk, and with however many points', () => {
      const few = pairs.slice(0, 5);
      assert.deepEqual(
        surface.lengths(few.flat(2)),
        Float64Array.from(few, (_, i) => paths[i].length),
      );
      for (const [i, [from, to]] of few.entries()) {
        assert.equal(surface.shortestPath(to, from).length, paths[i].length);
        assert.equal(surface.shortestPath(from, to, { points: 9 }).length, paths[i].length);
      }
    });
  });

describe('a sheet with waves that are steeper than chords can follow', () => {
  /* Unrolled it is a plane. */
  const [height, waves] = [0.2, 30];
  const definition = {
    x: 'u',
    y: 'v',
    z: 'h*sin(k*u)',
    u: /** @type {const} */ ([-2, 2]),
    v: /** @type {const} */ ([-2, 2]),
    parameters: { h: height, k: waves },
  };
  /** Arc length of a wave. @param {number} low @param {number} high @param {number} k */
  const unroll = (low, high, k) => simpson((u) => Math.sqrt(1 + (height * k * Math.cos(k * u)) ** 2), low, high, 40_000);

  /** @param {import('../../web/surface.js').Surface} surface @param {number} k @param {number} seed */
  const check = (surface, k, seed) => {
    let count = 0;
    for (const [from, to] of randomPairs(surface, seed, ofAll(3, 12))) {
      const path = surface.shortestPath(from, to);
      if (!path.converged) continue;
      const wanted = Math.hypot(unroll(from[0], to[0], k), to[1] - from[1]);
      assert.ok(Math.abs(path.length / wanted - 1) < RIGHT, `${from} to ${to}: ${path.length}, not ${wanted}`);
      count++;
    }
    return count;
  };

  test('as long as unrolled, also after a parameter has changed', () => {
    const surface = surfpath.parametric(definition);
    assert.ok(check(surface, waves, 82) >= ofAll(3, 10));
    surface.set({ k: 25 });
    assert.ok(check(surface, 25, 83) >= ofAll(3, 10));
    surface.dispose();
  });
});

test('a hollow cylinder whose walls are 0.04 apart: all paths converge, none through a wall', () => {
  const surface = surfpath.parametric({
    x: 'cos(u)*(1 + 0.02cos(v))',
    y: 'sin(u)*(1 + 0.02cos(v))',
    z: 'sin(v)',
    u: [0, '2pi'],
    v: [0, '2pi'],
  });
  for (const [from, to] of randomPairs(surface, 84, PAIRS)) {
    const path = surface.shortestPath(from, to, { points: 500 });
    assert.equal(path.status, 'converged', `${from} to ${to}`);
    const { points } = path;
    let chords = 0;
    for (let i = 3; i < points.length; i += 3) chords += Math.hypot(...[0, 1, 2].map((j) => points[i + j] - points[i + j - 3]));
    assert.ok(Math.abs(chords / path.length - 1) < 1e-3, `${from} to ${to}: ${path.length}, its chords ${chords}`);
  }
});

test('with a density: as E, F and G with it', () => {
  const [x, y, z] = ['v*cos(u)', 'v*sin(u)', 'sin(2u)'];
  const range = /** @type {const} */ ({ u: [0, '2pi'], v: [-1, 1] });
  const surface = surfpath.parametric({ x, y, z, ...range, density: '1 + x^2' });
  const factor = '(1 + v^2*cos(u)^2)^2';
  const abstract = surfpath.metric({ E: `(v^2 + 4cos(2u)^2)*${factor}`, F: 0, G: factor, ...range, periodic: { u: true } });
  let count = 0;
  for (const [from, to] of randomPairs(surface, 85, ofAll(3, 6))) {
    const [path, other] = [surface, abstract].map((one) => one.shortestPath(from, to));
    if (!path.converged || !other.converged) continue;
    assert.ok(Math.abs(path.length / other.length - 1) < RIGHT, `${from} to ${to}: ${path.length}, not ${other.length}`);
    count++;
  }
  assert.ok(count >= ofAll(2, 5), `${count} converged`);
});

test('through a coin of 1:100: no chord of the body, but a path around its rim, with its error', () => {
  const surface = surfpath.parametric({ x: 'cos(u)*cos(v)', y: 'sin(u)*cos(v)', z: 'sin(v)/100', u: [0, '2pi'], v: ['-pi/2', 'pi/2'] });
  for (const start of /** @type {const} */ (['global', 'straight'])) {
    const path = surface.shortestPath([0, Math.acos(0.3)], [Math.atan2(0.2, -0.3), -Math.acos(Math.hypot(0.2, 0.3))], { start });
    assert.ok(['converged', 'ill-conditioned', 'tolerance-not-met'].includes(path.status), path.status);
    /* At rest: Clairaut's constant is 0.213404 on both of its sides. */
    if (path.status !== 'tolerance-not-met') assert.ok(Math.abs(path.length - 1.87472667519) < 1e-10, `${path.length}`);
    /* Of a plate, the way from (0.3, 0) by the best point of the rim to (-0.3, 0.2). */
    const flat = Math.min(
      ...Array.from({ length: 6000 }, (_, i) => {
        const [x, y] = [Math.cos(i / 900), Math.sin(i / 900)];
        return Math.hypot(x - 0.3, y) + Math.hypot(x + 0.3, y - 0.2);
      }),
    );
    assert.ok(path.length > flat && path.length < flat + 2e-3, `${start}: ${path.length}, of a plate ${flat}`);
    assert.ok(path.lengthError < 1e-5, `${path.lengthError}`);
  }
});

test('from pole to pole of a coin of 1:20, and from near by: along a meridian, ill-conditioned as on a ball', () => {
  const height = 0.05;
  const coin = surfpath.parametric({ x: 'sin(u)cos(v)', y: 'sin(u)sin(v)', z: `${height}cos(u)`, u: [0, 'pi'], v: [0, '2pi'] });
  /* By the trapezoidal rule, exact to rounding over half an ellipse. */
  const steps = 2000;
  let half = 0;
  for (let i = 0; i < steps; i++)
    half += (Math.PI / steps) * Math.hypot(Math.cos((Math.PI * i) / steps), height * Math.sin((Math.PI * i) / steps));
  for (const [from, to, cut] of /** @type {[number[], number[], number][]} */ ([
    [[0, 2.09], [Math.PI, 1.454], 0],
    [[1e-6, 1], [Math.PI, 5], 1e-6],
  ])) {
    const path = coin.shortestPath(from, to);
    assert.equal(path.status, 'ill-conditioned');
    assert.ok(Math.abs(path.length - (half - cut)) <= 1e-9, `${path.length}, expected ${half - cut}`);
  }
  assert.deepEqual(
    coin.geodesics([0, 0], [Math.PI, 0]).map(({ status }) => status),
    ['ill-conditioned'],
  );
  coin.dispose();
});

test('over a strip folded many times: as unfolded, whatever chords stall on', () => {
  const surface = surfpath.parametric({ x: 'u/50 + 0.5sin(u)', y: '0.02cos(u)', z: 'v', u: [0, 40], v: [-1, 1] });
  const between = (/** @type {number} */ from, /** @type {number} */ to) => {
    const step = (to - from) / 20000;
    let sum = 0;
    for (let i = 0; i < 20000; i++) {
      const u = from + (i + 0.5) * step;
      sum += step * Math.hypot(0.02 + 0.5 * Math.cos(u), 0.02 * Math.sin(u));
    }
    return sum;
  };
  for (const [from, to] of randomPairs(surface, 86, ofAll(3, 8))) {
    const path = surface.shortestPath(from, to);
    const truth = Math.hypot(between(from[0], to[0]), to[1] - from[1]);
    assert.notEqual(path.status, 'stalled', `${from} to ${to}`);
    assert.ok(Math.abs(path.length / truth - 1) < 1e-5, `${from} to ${to}: ${path.length}, not ${truth}`);
  }
});

test('a plane in logarithms of the distance, cut off at e^-8 of it, with a slit: around the hole as the tangents say', () => {
  const plane = surfpath.parametric({ x: 'exp(u) cos(v)', y: 'exp(u) sin(v)', z: 0, u: [-8, 2], v: [0, 6] });
  const hole = Math.exp(-8);
  for (const ends of [
    [
      [1.53, 1.54],
      [-0.37, 5.6],
    ],
    [
      [0.747, 3.893],
      [-0.135, 0.374],
    ],
    [
      [0.142, 5.789],
      [0.603, 1.99],
    ],
    [
      [1.903, 1.353],
      [0.523, 4.975],
    ],
  ]) {
    const path = plane.shortestPath(ends[0], ends[1]);
    const away = ends.map(([u]) => Math.exp(u));
    const tangents = away.map((x) => Math.sqrt(x ** 2 - hole ** 2));
    const along = Math.abs(ends[1][1] - ends[0][1]) - Math.acos(hole / away[0]) - Math.acos(hole / away[1]);
    const length = tangents[0] + tangents[1] + hole * along;
    assert.equal(path.status, 'converged', `${ends}`);
    assert.ok(along > 0 && Math.abs(path.length / length - 1) <= RIGHT, `${ends}: ${path.length}, not ${length}`);
  }
  plane.dispose();
});

test('who allows few steps learns where they end', () => {
  const surface = surfpath.parametric(PINCHED[1].surface);
  const [from, to] = [
    [2.4, -0.4],
    [5, -0.37],
  ];
  assert.equal(surface.shortestPath(from, to).status, 'converged');
  assert.notEqual(surface.shortestPath(from, to, { maxIterations: 60 }).status, 'converged');
});

test('where a way along a singular line is shorter, and neither space nor E, F and G lead to it, there is no path that is converged', () => {
  /* A seashell: along v = π it is its own axis, on which S_u and S_v are parallel. What E, F and G led to was 5.5 % longer than the axis, and 'converged'. */
  const surface = surfpath.parametric({
    x: '2(1 - exp(u/(6pi)))*cos(u)*cos(v/2)^2',
    y: '2(exp(u/(6pi)) - 1)*sin(u)*cos(v/2)^2',
    z: '1 - exp(u/(3pi)) - sin(v) + exp(u/(6pi))*sin(v)',
    u: [0.5, '6pi'],
    v: [0, '2pi'],
  });
  const path = surface.shortestPath([9.105, 1.1204], [17.9238, 3.4336]);
  assert.ok(!path.converged, `${path.status} ${path.length}`);
});
