/** Traced geodesics through the public face: the known paths of tests/data, shortest paths, both kinds of surface, every refusal. (Closed forms: tests/native.) */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { load } from '../../web/index.js';
import { loadCases } from '../helpers/cases.js';
import { STRAIGHT } from '../helpers/options.js';
import { dot, norm, referenceSurface, subtract } from '../helpers/reference.js';
import { verifyPath } from '../helpers/verify-path.js';

const surfpath = await load();
const sphere = surfpath.implicit({ f: 'x^2+y^2+z^2-4' });
const torus = /** @type {const} */ ({
  kind: 'parametric',
  x: '(4+1.5*cos(v))*cos(u)',
  y: '(4+1.5*cos(v))*sin(u)',
  z: '1.5*sin(v)',
  u: [0, '2pi'],
  v: [0, '2pi'],
});
const saddle = surfpath.parametric({ x: 'u', y: 'v', z: 'u^2-v^2', u: [-1, 1], v: [-1, 1] });

/** @param {{ points: ArrayLike<number> }} path @param {number} i from the end if negative */
const pointOf = (path, i) => Array.from(path.points).slice(3 * i, 3 * i + 3 || undefined);

/** The direction of a known path: of space, or the angle from S_u in the tangent plane. @param {any} stored @param {import('../helpers/verify-path.js').Definition} definition */
function directionOf(stored, definition) {
  if (stored.start_direction) return stored.start_direction;
  const surface = /** @type {import('../helpers/reference.js').ParametricReference} */ (referenceSurface(definition));
  const [first, second] = surface.tangents(stored.from);
  const [E, F, G] = [dot(first, first), dot(first, second), dot(second, second)];
  const area = Math.sqrt(E * G - F * F);
  const [along, across] = [Math.cos(stored.start_angle), Math.sin(stored.start_angle)];
  return [along / Math.sqrt(E) - (across * F) / (Math.sqrt(E) * area), (across * Math.sqrt(E)) / area];
}

test('known paths, traced from their start, end where they end', () => {
  let count = 0;
  for (const { id, definition, from, to, expected } of loadCases({ kinds: ['parametric', 'implicit'] })) {
    const stored = /** @type {any} */ (expected);
    const known = stored.start_direction !== undefined || stored.start_angle !== undefined;
    if (!known || definition.density !== undefined || stored.touches_boundary || stored.crosses_cusp) continue;
    const surface = surfpath.surface(/** @type {any} */ (definition));
    const path = surface.trace(from, directionOf(stored, definition), expected.length, { points: 10 });
    const target = to.length === 2 ? Array.from(surface.evaluate(expected.to_lift ?? to)).slice(0, 3) : to;
    const miss = norm(subtract(target, pointOf(path, -1)));
    assert.ok(path.converged, `${id}: ${path.status}`);
    /* The data's own start is exact to about 1e-15, which grows along the path as our rounding does. */
    assert.ok(miss <= 10 * path.lengthError && path.lengthError < 1e-6, `${id}: misses by ${miss}, estimate ${path.lengthError}`);
    assert.equal(path.conjugate, null, `${id}: a shortest path has no conjugate point inside`);
    surface.dispose();
    count++;
  }
  assert.ok(count > 80, `${count} cases`);
});

test('the start of a shortest path, traced, lands on its end, the nearer the finer the path', () => {
  const surface = surfpath.parametric(torus);
  const [from, to] = [
    [0.3, 0.4],
    [1.8, 2.9],
  ];
  const misses = [64, 128, 256, 512].map((points) => {
    const path = surface.shortestPath(from, to, { ...STRAIGHT, points });
    const q = /** @type {Float64Array} */ (path.parameters);
    const direction = [0, 1].map((j) => -25 * q[j] + 48 * q[2 + j] - 36 * q[4 + j] + 16 * q[6 + j] - 3 * q[8 + j]);
    return subtract(pointOf(path, -1), pointOf(surface.trace(from, direction, path.length + path.lengthError), -1));
  });
  /* A path of chords leaves in a direction that is off by a series in 1/K^2, whose first term the last two cancel. */
  for (let i = 1; i < misses.length; i++) assert.ok(norm(misses[i]) < 0.3 * norm(misses[i - 1]), `misses ${misses.map(norm)}`);
  const extrapolated = norm(misses[3].map((x, j) => (513 ** 2 * x - 257 ** 2 * misses[2][j]) / (513 ** 2 - 257 ** 2)));
  assert.ok(extrapolated < 1e-7, `misses ${extrapolated}`);
});

test('a path is plain data, on the surface, equally spaced, continuous across seams', () => {
  const surface = surfpath.parametric(torus);
  const path = surface.trace([6.2, 0.1], [3, 1], 60, { points: 500 });
  assert.deepEqual([path.status, path.converged, path.length, path.index, path.history], ['converged', true, 60, -1, []]);
  assert.ok(Number.isNaN(path.energy) && Number.isNaN(path.gradientNorm) && path.lengthError < 1e-9);
  assert.deepEqual(structuredClone(path), path);
  const q = /** @type {Float64Array} */ (path.parameters);
  assert.ok(q[2 * 501] > 2 * Math.PI + 6, `u goes on: ${q[2 * 501]}`);
  for (let i = 0; i < 501; i++) assert.ok(Math.abs(q[2 * i + 2] - q[2 * i]) < 0.1 && Math.abs(q[2 * i + 3] - q[2 * i + 1]) < 0.1);
  const chords = Array.from({ length: 501 }, (_, i) => norm(subtract(pointOf(path, i + 1), pointOf(path, i))));
  const sum = chords.reduce((a, b) => a + b);
  assert.deepEqual(verifyPath(torus, { ...path, length: sum }, { from: [6.2, 0.1] }), []);
});

test('the sphere in both forms: great circles, conjugate at half of one', () => {
  const globe = surfpath.parametric({ x: '2cos(v)cos(u)', y: '2cos(v)sin(u)', z: '2sin(v)', u: [0, '2pi'], v: ['-pi/2', 'pi/2'] });
  for (const path of [globe.trace([0, 0], [1, 1], 9), sphere.trace([2, 0, 0], [0, 1, 1], 9)]) {
    assert.ok(Math.abs(/** @type {number} */ (path.conjugate) - 2 * Math.PI) < 1e-10, `conjugate ${path.conjugate}`);
    const [s, c] = [Math.sin(4.5) * Math.SQRT2, 2 * Math.cos(4.5)];
    assert.ok(norm(subtract(pointOf(path, -1), [c, s, s])) < 1e-10);
  }
  assert.equal(sphere.trace([2, 0, 0], [0, 1, 1], 6).conjugate, null);
  assert.deepEqual(sphere.trace([2, 0, 0], [5, 1, 1], 3), sphere.trace([2, 0, 0], [0, 1, 1], 3), 'the tangent part counts');
});

test('ends on the edge of the rectangle', () => {
  const path = saddle.trace([-0.5, -0.3], [1, 0.4], 10, { points: 20 });
  assert.deepEqual([path.status, path.converged, path.points.length], ['edge-reached', false, 66]);
  const [u, v] = /** @type {Float64Array} */ (path.parameters).subarray(-2);
  assert.ok(Math.abs(u - 1) < 1e-12 && Math.abs(v) < 1 && path.length > 1.5 && path.length < 3, `ends at ${u}, ${v}, ${path.length}`);
  const again = saddle.trace([-0.5, -0.3], [1, 0.4], 0.999999 * path.length);
  assert.equal(again.status, 'converged');
});

test('past a pole, again and again, however closely: a great circle', () => {
  const globe = surfpath.parametric({ x: 'cos(v) cos(u)', y: 'cos(v) sin(u)', z: 'sin(v)', u: ['-pi', 'pi'], v: ['-pi/2', 'pi/2'] });
  for (const [below, direction, length] of /** @type {[number, number[], number][]} */ ([
    [1e-3, [0.3, -1], 7],
    [1e-2, [0.01, -1], 20],
    [0.1, [1e-5, -1], 6.5],
    [1, [1e-9, 1], 13],
  ])) {
    const v = Math.PI / 2 - below;
    const [sin, cos] = [Math.sin(v), Math.cos(v)];
    const speed = Math.sqrt((direction[0] * cos) ** 2 + direction[1] ** 2);
    const [east, north] = [(direction[0] * cos) / speed, direction[1] / speed];
    const path = globe.trace([0, v], direction, length);
    const start = [cos, 0, sin];
    const end = start.map((x, k) => x * Math.cos(length) + [-sin * north, east, cos * north][k] * Math.sin(length));
    const miss = norm(subtract(end, pointOf(path, -1)));
    assert.ok(
      path.converged && miss <= path.lengthError && path.lengthError < 1e-4,
      `${below}: ${path.status}, ${miss}, ${path.lengthError}`,
    );
  }
  globe.dispose();
});

// Only where rounding had put the pole beside itself, as at sin(π), had there been a path.
test('from a pole along its meridian, as on the same body without one', () => {
  const [X, Y, Z] = ['sin(v)*cos(u)', 'sin(v)*sin(u)', 'cos(v)'];
  const radius = (/** @type {string[]} */ [x, y, z]) => `(1 + 0.2*${x}*${y} + 0.15*${x} - 0.1*${z}*(${y})^2 + 0.1*sin(2*${x} + ${y}))`;
  const [x, y, z] = [X, Y, Z].map((part) => `${radius([X, Y, Z])}*${part}`);
  const globe = surfpath.parametric({ x, y, z, u: [0, '2pi'], v: [0, 'pi'] });
  const size = 'sqrt(x^2 + y^2 + z^2)';
  const body = surfpath.implicit({ f: `${size} - ${radius(['x', 'y', 'z'].map((part) => `(${part}/${size})`))}` });
  for (const [v, inwards] of [
    [0, 1],
    [Math.PI, -1],
  ])
    for (const u of [0, 0.7, 2.9, 4.4])
      for (const length of [1e-3, 0.5, 3, 10]) {
        const away = [Math.cos(u), Math.sin(u)];
        const path = globe.trace([u, v], [1, inwards], length);
        const same = body.trace([0, 0, inwards], [...away, inwards * (0.35 * away[0] + 0.1 * away[1])], length);
        const miss = norm(subtract(pointOf(same, -1), pointOf(path, -1)));
        assert.ok(path.converged && miss <= path.lengthError + same.lengthError, `${u}, ${v}, ${length}: ${path.status}, ${miss}`);
        assert.deepEqual(Array.from(/** @type {Float64Array} */ (path.parameters).subarray(0, 2)), [u, v]);
      }
  assert.throws(() => globe.trace([1, 0], [1, 0], 1), /^RangeError: trace: direction is normal to the surface at from/);
  for (const surface of [globe, body]) surface.dispose();
});

test('a trace that comes to rest at a line where its formulas are not smooth says how much is left', () => {
  const plane = /** @type {const} */ ({ x: 'u', y: 'v', z: 0, u: [-2, 2], v: [-2, 2] });
  for (const definition of [
    { ...plane, z: '(u^2)^0.6' },
    { ...plane, density: '1 + (u^2)^0.25' },
  ]) {
    const surface = surfpath.parametric(definition);
    let early = 0;
    for (let i = 0; i < 20; i++) {
      const path = surface.trace([0.3 + 0.025 * i, 0.1], [-1, 0.02 * i - 0.2], 6, { tolerance: 1e-9 });
      if (path.status !== 'tolerance-not-met') continue;
      early++;
      assert.ok(path.length + path.lengthError >= 6, `${i}: ${path.length}, ${path.lengthError}`);
    }
    assert.ok(early > 0);
    surface.dispose();
  }
});

test('into a pole, or to a rim, with any tolerance: it ends there, as nearly as it says', () => {
  const long = surfpath.parametric({ x: 'cos(v) cos(u)', y: 'cos(v) sin(u)', z: '3 sin(v)', u: ['-pi', 'pi'], v: ['-pi/2', 'pi/2'] });
  const bell = surfpath.parametric({ x: 'v cos(u)', y: 'v sin(u)', z: 'exp(-v^2)', u: ['-pi', 'pi'], v: [0, 2] });
  const throat = surfpath.parametric({ x: 'v cos(u)', y: 'v sin(u)', z: '2 sqrt(v - 1)', u: ['-pi', 'pi'], v: [1, 4] });
  for (const tolerance of [1e-2, 1e-6, 1e-9, 1e-12])
    for (let i = 0; i < 6; i++) {
      for (const [surface, v, up, tip] of /** @type {const} */ ([
        [long, 0.2 * i - 0.5, 1, [0, 0, 3]],
        [bell, 0.3 + 0.25 * i, -1, [0, 0, 1]],
      ])) {
        const path = surface.trace([i - 2.6, v], [0, up], 20, { tolerance });
        const miss = norm(subtract([...tip], pointOf(path, -1)));
        assert.equal(path.status, 'edge-reached', `${tolerance}, ${v}`);
        assert.ok(miss <= path.lengthError, `${tolerance}, ${v}: misses by ${miss}, estimate ${path.lengthError}`);
      }
      const v = 1.3 + 0.4 * i;
      const path = throat.trace([i - 2.6, v], [0, -1], 9, { tolerance });
      const length = Math.sqrt(v * (v - 1)) + Math.asinh(Math.sqrt(v - 1));
      assert.ok(path.status === 'edge-reached' || path.status === 'tolerance-not-met', `${tolerance}, ${v}: ${path.status}`);
      const miss = Math.abs(path.length - length);
      assert.ok(miss <= path.lengthError, `${tolerance}, ${v}: ${path.status}, misses by ${miss}, estimate ${path.lengthError}`);
    }
  for (const surface of [long, bell, throat]) surface.dispose();
});

test('a step that leaps over the rim of a formula is taken back where other steps end there', () => {
  const pipe = surfpath.parametric({ x: 'u', y: 'v', z: 'sqrt(1 - u^2)', u: [-1, 1], v: [-5, 5] });
  const arc = Math.PI / 2 - Math.asin(0.2);
  const length = arc * Math.sqrt(1 + 0.2 ** 2 * (1 - 0.2 ** 2));
  for (const tolerance of [1e-2, 1e-4, 1e-6, 1e-12, 1e-14]) {
    const path = pipe.trace([0.2, 0.3], [1, 0.2], 20, { tolerance });
    assert.equal(path.status, 'edge-reached');
    assert.ok(Math.abs(path.length - length) <= path.lengthError && path.lengthError < 0.02, `${tolerance}: ${path.length}`);
  }
  pipe.dispose();
});

test('the length of a direction does not matter, as long as it is a number', () => {
  const flat = surfpath.graph({ z: 0, x: [-3, 3], y: [-3, 3] });
  for (const size of [1e-307, 1, 1.7e308]) assert.deepEqual(flat.trace([0, 0], [size, size], 1), flat.trace([0, 0], [1, 1], 1));
  flat.dispose();
});

test('a trace of length 0 stays', () => {
  const path = saddle.trace([0.5, 0.25], [1, 0], 0, { points: 2 });
  assert.deepEqual([path.status, path.length, ...path.points], ['converged', 0, ...Array(4).fill([0.5, 0.25, 0.1875]).flat()]);
});

test('across a curve where the gradient vanishes: at once, within the error that is told', () => {
  // The unit sphere, each of whose points on the equator has no gradient.
  const ball = surfpath.implicit({ f: '(x^2+y^2+z^2-1)*((x^2+y^2+z^2-1)^2+z^2)' });
  for (let i = 0; i < 8; i++) {
    const [c, s] = [Math.cos(i), Math.sin(i)];
    const [from, forward, aside] = [
      [0.6 * c, 0.6 * s, 0.8],
      [0.8 * c, 0.8 * s, -0.6],
      [-s, c, 0],
    ];
    const direction = forward.map((x, k) => x * Math.cos(0.1 * i) + aside[k] * Math.sin(0.1 * i));
    const path = ball.trace(from, direction, 2);
    assert.equal(path.status, 'tolerance-not-met');
    const end = from.map((x, k) => x * Math.cos(2) + direction[k] * Math.sin(2));
    const error = norm(subtract(end, pointOf(path, -1)));
    assert.ok(
      error <= path.lengthError && error <= 1e-7 && path.iterations < 1000,
      `${i}: ${error}, ${path.lengthError}, ${path.iterations} steps`,
    );
  }
  // Taubin's heart, whose middle is such a curve.
  const heart = surfpath.implicit({ f: '(x^2+9/4*y^2+z^2-1)^3-x^2*z^3-9/80*y^2*z^3' });
  const path = heart.trace([-0.56, 0.56, 0.025], [0.5, -0.1, -0.8], 1);
  assert.deepEqual([path.status, path.length], ['tolerance-not-met', 1]);
  for (const surface of [ball, heart]) surface.dispose();
});

test('past the rim of its formula it does not know where it is, and says so', () => {
  const dome = surfpath.graph({ z: 'sqrt(1 - x^2 - y^2)', x: [-1, 1], y: [-1, 1] });
  for (const aside of [0.001, 0.01, 0.3]) assert.equal(dome.trace([0.5, 0], [-1, aside], 3).status, 'tolerance-not-met');
  const within = dome.trace([0.5, 0], [-1, 0.01], 2);
  assert.ok(within.converged && within.lengthError < 1e-8, `${within.lengthError}`);
  dome.dispose();
});

test('what cannot be traced has a status and no path', () => {
  const [cone, blunt] = ['z^2', '25*z^2'].map((square) => surfpath.implicit({ f: `x^2+y^2-${square}` }));
  const root = surfpath.parametric({ x: 'u', y: 'v', z: 'sqrt(u)', u: [-1, 1], v: [-1, 1] });
  for (const [path, status] of /** @type {const} */ ([
    [cone.trace([3, 4, 5], [-3, -4, -5], 20), 'singular-metric'],
    [blunt.trace([3, 4, 1], [-3, -4, -1], 20), 'singular-metric'],
    [root.trace([-0.5, 0], [1, 0], 1), 'not-finite'],
    [sphere.trace([2.5, 0, 0], [0, 1, 0], 1), 'off-surface'],
  ])) {
    assert.equal(path.status, status);
    assert.deepEqual([path.converged, path.length, path.points.length, path.parameters], [false, Number.NaN, 0, null]);
  }
});

test('mistakes throw, and say which', () => {
  /** @type {[any[], ErrorConstructor, RegExp][]} */
  const mistakes = [
    [[[0, 0], [0, 0], 1], RangeError, /^trace: direction must not be zero/],
    [[[0, 0], [1, 0, 0], 1], RangeError, /^trace: direction must be \[du, dv\]/],
    [[[0, 0], [1, Number.NaN], 1], RangeError, /^trace: direction\[1\] must be a finite number/],
    [[[0, 0], 'north', 1], TypeError, /^trace: direction must be/],
    [[[2, 0], [1, 0], 1], RangeError, /^trace: from\[0\] = 2 lies outside/],
    [[[0, 0], [1, 0], -1], RangeError, /^trace: length must be .*not -1$/],
    [[[0, 0], [1, 0], Number.NaN], RangeError, /^trace: length must be/],
    [[[0, 0], [1, 0], Infinity], RangeError, /^trace: length must be/],
    [[[0, 0], [1, 0], '1'], TypeError, /^trace: length must be a finite number that is not negative/],
    [
      [
        [0, 0],
        [1, 0],
      ],
      TypeError,
      /^trace: length must be a finite number that is not negative/,
    ],
    [[[0, 0], [1, 0], 1, 7], TypeError, /^trace: options must be an object/],
    [[[0, 0], [1, 0], 1, { start: 'straight' }], TypeError, /no option 'start'/],
    [[[0, 0], [1, 0], 1, { points: 0 }], RangeError, /options.points/],
    [[[0, 0], [1, 0], 1, { tolerance: 1e-16 }], RangeError, /options.tolerance/],
    [[[0, 0], [1, 0], 1, { tolerance: '1' }], TypeError, /options.tolerance/],
  ];
  for (const [given, kind, message] of mistakes) {
    assert.throws(
      () => saddle.trace(.../** @type {[any, any, any, any]} */ (given)),
      (error) => error instanceof kind && message.test(/** @type {Error} */ (error).message),
      String(message),
    );
  }
  assert.throws(() => sphere.trace([2, 0, 0], [-3, 0, 0], 1), /^RangeError: trace: direction is normal to the surface at from/);
  const gone = surfpath.implicit({ f: 'x' });
  gone.dispose();
  assert.throws(() => gone.trace([0, 0, 0], [0, 1, 0], 1), /^Error: trace: this surface was disposed/);
});
