// The face of the library as a stranger would use and misuse it: every documented error, every status that can be provoked, shapes and copies.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { gallery } from '../../web/gallery.js';
import { ExpressionError, load } from '../../web/index.js';

const surfpath = await load();
const saddle = surfpath.surface(gallery.saddle);
const sphere = surfpath.surface(gallery.sphere);
const ring = surfpath.surface(gallery.parametricTorus);

/** @typedef {import('../../web/index.js').Path} Path */

/** Hands over what the types forbid. @param {unknown} value @returns {any} */
const anything = (value) => value;

/** @param {() => unknown} call @param {ErrorConstructor | typeof ExpressionError} kind @param {RegExp} message */
const refuses = (call, kind, message) =>
  assert.throws(call, (/** @type {any} */ error) => {
    assert.equal(error.constructor, kind, error.stack);
    assert.match(error.message, message);
    return true;
  });

/** @param {number} actual @param {number} expected @param {number} [tolerance] relative to 1 */
const close = (actual, expected, tolerance = 1e-12) =>
  assert.ok(Math.abs(actual - expected) <= tolerance * Math.max(1, Math.abs(expected)), `${actual}, not ${expected}`);

/** @param {number[]} actual @param {number[]} expected */
const assertNear = (actual, expected) => {
  assert.equal(actual.length, expected.length);
  for (const [i, x] of actual.entries()) close(x, expected[i]);
};

/** What a path without points looks like. @param {Path} path @param {string} status */
function assertNoPath(path, status) {
  assert.equal(path.status, status);
  assert.equal(path.converged, false);
  for (const number of [path.length, path.lengthError, path.energy, path.gradientNorm]) assert.ok(Number.isNaN(number));
  assert.deepEqual([path.points.length, path.parameters, path.history.length, path.index], [0, null, 0, -1]);
}

describe('definitions', () => {
  /** @type {[string, unknown, ErrorConstructor | typeof ExpressionError, RegExp][]} */
  const bad = [
    ['nothing', undefined, TypeError, /parametric: the definition must be an object, not undefined/],
    ['a missing range', { x: 'u', y: 'v', z: 0, u: [0, 1] }, TypeError, /v is missing/],
    ['a range that is no range', { ...gallery.saddle, u: 3 }, TypeError, /u must be a range \[from, to\], not 3/],
    ['a range of three', { ...gallery.saddle, u: [0, 1, 2] }, TypeError, /u must be a range/],
    ['a reversed range', { ...gallery.saddle, u: [1, 0] }, RangeError, /u must be a range of two numbers, the smaller first/],
    ['an empty range', { ...gallery.saddle, v: [1, 1] }, RangeError, /v must be a range/],
    ['an infinite range', { ...gallery.saddle, v: [0, Infinity] }, TypeError, /v must be a string or a finite number/],
    ['a range that is NaN', { ...gallery.saddle, v: ['sqrt(-1)', 1] }, RangeError, /v must be a range/],
    ['an unknown name in a range', { ...gallery.saddle, u: [0, '2*q'] }, ExpressionError, /u: unknown name q/],
    ['an unknown name', { ...gallery.saddle, z: 'w' }, ExpressionError, /z: unknown name w/],
    ['an empty formula', { ...gallery.saddle, z: '' }, ExpressionError, /z: the expression is empty/],
    [
      'null for a formula',
      { ...gallery.saddle, x: null },
      TypeError,
      /parametric: x must be a formula in a string, or a finite number, not null/,
    ],
    ['NaN for a formula', { ...gallery.saddle, x: NaN }, TypeError, /parametric: x must be .* not NaN/],
    ['a function for a formula', { ...gallery.saddle, x: Math.sin }, TypeError, /parametric: x must be/],
    ['a periodic that is a word', { ...gallery.saddle, periodic: 'yes' }, TypeError, /periodic must be 'auto' or .* not 'yes'/],
    ['a periodic that is a number', { ...gallery.saddle, periodic: { u: 1 } }, TypeError, /periodic must be .* not u: 1/],
    ['a parameter that is NaN', { ...gallery.saddle, parameters: { a: NaN } }, RangeError, /parameter a must be a finite number/],
    ['a parameter that is text', { ...gallery.saddle, parameters: { a: '1' } }, RangeError, /parameter a must be a finite number, not '1'/],
    ['parameters that are no object', { ...gallery.saddle, parameters: 3 }, TypeError, /parameters must be an object of numbers/],
    ['a parameter called like a function', { ...gallery.saddle, parameters: { sin: 1 } }, ExpressionError, /sin is a function/],
  ];
  for (const [what, definition, kind, message] of bad)
    test(`parametric refuses ${what}`, () => refuses(() => surfpath.parametric(anything(definition)), kind, message));

  test('implicit refuses bounds that are no box', () => {
    const f = 'x^2+y^2+z^2-1';
    refuses(() => surfpath.implicit(anything({ f, bounds: [[0, 1]] })), TypeError, /bounds must be \[\[x, x\], \[y, y\], \[z, z\]\]/);
    refuses(() => surfpath.implicit(anything({ f, bounds: [[0, 1], [0, 1], 2] })), TypeError, /bounds\[2\] must be a range/);
    const reversed = anything([
      [0, 1],
      [1, 0],
      [0, 1],
    ]);
    refuses(() => surfpath.implicit({ f, bounds: reversed }), RangeError, /bounds\[1\] must be two numbers, the smaller first/);
    refuses(() => surfpath.implicit(anything({})), TypeError, /f is missing/);
  });

  test('surface refuses kinds that do not exist, and says which are not built yet', () => {
    refuses(() => surfpath.surface(anything(null)), TypeError, /surface: the definition must be an object/);
    refuses(() => surfpath.surface(anything({ f: 'x' })), RangeError, /kind must be 'parametric', 'implicit' or 'metric', not undefined/);
    for (const kind of ['graph', 'revolution', 'tube', 'sweep'])
      refuses(() => surfpath.surface(anything({ kind })), RangeError, /is not built yet/);
  });

  test('names of Object.prototype are unknown like any other', () => {
    for (const name of ['constructor', '__proto__', 'toString', 'hasOwnProperty'])
      refuses(() => surfpath.implicit({ f: `${name}*x` }), ExpressionError, /unknown name/);
  });

  test('an ExpressionError says where', () => {
    try {
      surfpath.implicit({ f: 'x + sinus(y)' });
      assert.fail('accepted');
    } catch (error) {
      assert.ok(error instanceof ExpressionError && error instanceof Error);
      assert.deepEqual([error.name, error.source, error.index, error.argument], ['ExpressionError', 'x + sinus(y)', 4, 'f']);
      assert.match(error.message, /did you mean sin\?/);
    }
  });

  test('changing a definition afterwards changes nothing', () => {
    const definition = { x: 'u', y: 'v', z: 'h', u: [0, 1], v: [0, 1], parameters: { h: 1 }, periodic: { u: true } };
    const plane = surfpath.parametric(anything(definition));
    definition.u[1] = 5;
    definition.parameters.h = 7;
    definition.periodic.u = false;
    plane.set({ h: 2 });
    assert.deepEqual(plane.domain, { u: [0, 1], v: [0, 1], periodic: { u: true, v: false } });
    assert.equal(plane.evaluate([0, 0])[2], 2);
  });
});

describe('ends', () => {
  /** @type {[string, unknown, ErrorConstructor, RegExp][]} */
  const bad = [
    ['nothing', undefined, TypeError, /shortestPath: from must be \[u, v\], not undefined/],
    ['text', 'ab', TypeError, /from must be \[u, v\], not 'ab'/],
    ['a number', 3, TypeError, /from must be \[u, v\]/],
    ['three numbers', [0, 0, 0], RangeError, /from must be \[u, v\], 2 numbers, not 3/],
    ['NaN', [NaN, 0], RangeError, /from\[0\] must be a finite number, not NaN/],
    ['Infinity', [0, -Infinity], RangeError, /from\[1\] must be a finite number, not -Infinity/],
    ['numbers as text', ['0', '0'], RangeError, /from\[0\] must be a finite number, not '0'/],
    ['a point outside the range of u', [1.5, 0], RangeError, /from\[0\] = 1.5 lies outside the range of u, \[-1, 1\]/],
    ['a point outside the range of v', [0, -2], RangeError, /from\[1\] = -2 lies outside the range of v/],
  ];
  for (const [what, point, kind, message] of bad)
    test(`shortestPath refuses ${what}`, () => refuses(() => saddle.shortestPath(anything(point), [0, 0]), kind, message));

  test('the second end is checked too, and three numbers are wanted of an implicit surface', () => {
    refuses(() => saddle.shortestPath([0, 0], [0, 9]), RangeError, /to\[1\] = 9 lies outside/);
    refuses(() => sphere.shortestPath([1, 0, 0], [0, 1]), RangeError, /to must be \[x, y, z\], 3 numbers, not 2/);
  });

  test('an end outside by rounding alone is moved onto the edge', () => {
    const path = saddle.shortestPath([1 + 1e-13, 0], [0, 0]);
    assert.equal(path.parameters?.[0], 1);
  });

  test('typed arrays are taken', () => {
    assert.deepEqual(saddle.shortestPath(new Float64Array([0, 0]), new Float32Array([0.5, 0.5])), saddle.shortestPath([0, 0], [0.5, 0.5]));
  });

  test('equal ends give a path of length 0', () => {
    for (const path of [saddle.shortestPath([0.1, 0.2], [0.1, 0.2]), sphere.shortestPath([0, 1, 0], [0, 1, 0])]) {
      assert.deepEqual([path.status, path.converged, path.length, path.lengthError, path.index], ['converged', true, 0, 0, 0]);
      assert.deepEqual(Array.from(path.points.subarray(0, 3)), Array.from(path.points.subarray(-3)));
    }
  });

  test('an end beside an implicit surface is moved onto it, one far from it is off-surface', () => {
    const near = sphere.shortestPath([1.1, 0, 0], [0, 0.95, 0]);
    assert.equal(near.status, 'converged');
    assert.deepEqual(Array.from(near.points.subarray(0, 3)), [1, 0, 0]);
    assertNoPath(sphere.shortestPath([3, 0, 0], [0, 1, 0]), 'off-surface');
    assertNoPath(sphere.shortestPath([1, 0, 0], [0, 0, 3]), 'off-surface');
  });
});

describe('statuses', () => {
  test('singular-metric: a constant surface, a curve, grad f = 0 at an end, a cuspidal edge between the ends', () => {
    const constant = surfpath.parametric({ x: 1, y: 2, z: 3, u: [0, 1], v: [0, 1] });
    const curve = surfpath.parametric({ x: 'u', y: 'u^2', z: 0, u: [0, 1], v: [0, 1] });
    for (const surface of [constant, curve]) assertNoPath(surface.shortestPath([0, 0], [1, 1]), 'singular-metric');
    assertNoPath(surfpath.implicit({ f: 'x*y' }).shortestPath([0, 0, 0], [1, 0, 1]), 'singular-metric');
    assertNoPath(surfpath.implicit({ f: 1 }).shortestPath([0, 0, 0], [1, 1, 1]), 'singular-metric');
    assertNoPath(sphere.shortestPath([0, 0, 0], [1, 0, 0]), 'singular-metric');
    const dini = surfpath.parametric({ ...gallery.dini, v: [0.1, 2] });
    assertNoPath(dini.shortestPath([0, 1.2], [1, 1.9]), 'singular-metric');
  });

  test('not-finite: a formula outside its domain', () => {
    const half = surfpath.parametric({ x: 'u', y: 'v', z: 'sqrt(u-0.5)', u: [0, 1], v: [0, 1] });
    assertNoPath(half.shortestPath([0, 0], [1, 1]), 'not-finite');
    assertNoPath(surfpath.implicit({ f: 'sqrt(-1-x^2)' }).shortestPath([0, 0, 0], [1, 1, 1]), 'not-finite');
  });

  test('sheet-jump: two components', () => {
    const two = surfpath.implicit({ f: '((x-2)^2+y^2+z^2-1)*((x+2)^2+y^2+z^2-1)' });
    assertNoPath(two.shortestPath([-3, 0, 0], [3, 0, 0]), 'sheet-jump');
  });

  test('saddle: what the paper’s sign test accepts; the certified method leaves it', () => {
    const bumpy = surfpath.surface(gallery.bumpy);
    const [from, to] = [
      [-1, 0.5236],
      [2.5, 0.5236],
    ];
    const paper = bumpy.shortestPath(from, to, { algorithm: 'paper' });
    assert.deepEqual([paper.status, paper.converged], ['saddle', false]);
    assert.ok(paper.index > 0 && paper.points.length > 0);
    const path = bumpy.shortestPath(from, to);
    assert.deepEqual([path.status, path.index], ['converged', 0]);
    assert.ok(path.length < paper.length);
  });

  test('iteration-limit: a usable path that is no worse than its start', () => {
    const straight = ring.shortestPath([0.5, 0.6], [2.6, 1.2], { maxIterations: 0 });
    const short = ring.shortestPath([0.5, 0.6], [2.6, 1.2], { maxIterations: 2 });
    assert.deepEqual([straight.status, straight.iterations], ['iteration-limit', 0]);
    assert.deepEqual([short.status, short.iterations], ['iteration-limit', 2]);
    assert.ok(short.energy < straight.energy && short.points.length === straight.points.length);
  });

  test('antipodal points of a sphere, joined by infinitely many shortest paths, are not called converged', () => {
    const path = sphere.shortestPath([1, 0, 0], [-1, 0, 0]);
    assert.equal(path.converged, false);
    close(path.length + path.lengthError, Math.PI, 1e-5); // the estimate is good to fourth order
  });
});

describe('options', () => {
  /** @type {[unknown, ErrorConstructor, RegExp][]} */
  const bad = [
    [null, TypeError, /options must be an object, not null/],
    ['fast', TypeError, /options must be an object, not 'fast'/],
    [{ pionts: 3 }, TypeError, /there is no option 'pionts'; the options are algorithm, points/],
    [{ algorithm: 'elements' }, RangeError, /'elements' is not built yet/],
    [{ algorithm: 'fast' }, RangeError, /algorithm must be 'polyline' or 'paper', not 'fast'/],
    [{ start: 'global' }, RangeError, /'global' is not built yet/],
    [{ start: 'curved' }, TypeError, /start must be 'straight', a polyline .* not 'curved'/],
    [{ tolerance: 1e-9 }, RangeError, /tolerance is not built yet/],
    [{ via: [[0, 0]] }, RangeError, /via is not built yet/],
    [{ points: 0 }, RangeError, /points must be a whole number from 1 to 100000, not 0/],
    [{ points: 100_001 }, RangeError, /points must be/],
    [{ points: 2.5 }, RangeError, /points must be a whole number/],
    [{ points: NaN }, RangeError, /points must be a whole number/],
    [{ points: '64' }, TypeError, /points must be a number, not '64'/],
    [{ maxIterations: -1 }, RangeError, /maxIterations must be a whole number from 0 to 10000/],
    [{ gradientTolerance: 0 }, RangeError, /gradientTolerance must be a positive number, not 0/],
    [{ gradientTolerance: '1' }, RangeError, /gradientTolerance must be a positive number, not '1'/],
    [{ record: 1 }, TypeError, /record must be true or false, not 1/],
    [{ start: [0, 0, 1] }, RangeError, /start must be a flat array of u v, 2 to 1,000,000 points, not 3 numbers/],
    [{ start: [0, 0] }, RangeError, /start must be a flat array/],
    [{ start: [0, 0, NaN, 1] }, RangeError, /start\[2\] must be a finite number, not NaN/],
    [
      {
        start: [
          [0, 0],
          [0.5, 0.5],
          [1, 1],
          [1, 1],
        ],
      },
      RangeError,
      /start\[0\] must be a finite number, not an array of 2/,
    ],
  ];
  for (const [options, kind, message] of bad)
    test(`shortestPath refuses ${JSON.stringify(options)}`, () =>
      refuses(() => saddle.shortestPath([0, 0], [0.5, 0.5], anything(options)), kind, message));

  test('an option that is undefined counts as not given', () => {
    const path = saddle.shortestPath([0, 0], [0.5, 0.5], { algorithm: undefined, points: undefined, start: undefined });
    assert.deepEqual(path, saddle.shortestPath([0, 0], [0.5, 0.5]));
  });

  test('points: as many as asked, from 1 to 100,000', () => {
    for (const points of [1, 2, 3, 50, 100_000]) {
      const path = saddle.shortestPath([-0.9, 0.1], [0.5, 0.9], { points });
      assert.deepEqual([path.status, path.points.length, path.parameters?.length], ['converged', 3 * (points + 2), 2 * (points + 2)]);
    }
  });

  test('points: too few to see the surface between them is stalled, not converged', () => {
    assert.equal(ring.shortestPath([0.5, 0.6], [2.6, 1.2], { points: 1 }).status, 'stalled');
  });

  test('more points: closer to the geodesic, and lengthError says how close', () => {
    const fine = ring.shortestPath([0.5, 0.6], [2.6, 1.2], { points: 2000 });
    for (const points of [16, 64, 256]) {
      const path = ring.shortestPath([0.5, 0.6], [2.6, 1.2], { points });
      close(path.lengthError / (fine.length + fine.lengthError - path.length), 1, 0.05);
    }
  });

  test('gradientTolerance is the paper’s stopping rule', () => {
    const path = ring.shortestPath([0.5, 0.6], [2.6, 1.2], { gradientTolerance: 0.5 });
    assert.ok(path.converged && path.gradientNorm <= 0.5 && path.gradientNorm > 1e-6);
    assert.ok(path.history.slice(0, -1).every((entry) => entry.gradientNorm > 0.5));
  });

  test('history: one entry a step and one for the end; record keeps the polylines', () => {
    const [from, to, points] = [[0.5, 0.6], [2.6, 1.2], 7];
    const plain = ring.shortestPath(from, to, { points });
    const path = ring.shortestPath(from, to, { points, record: true });
    assert.equal(path.history.length, path.iterations + 1);
    assert.ok(plain.history.every((entry) => !('points' in entry)));
    for (const entry of path.history) {
      assert.deepEqual(Object.keys(entry), ['energy', 'gradientNorm', 'decrement', 'step', 'points']);
      assert.equal(entry.points?.length, 3 * (points + 2));
    }
    const last = /** @type {import('../../web/runtime/heap.js').Iterate} */ (path.history.at(-1));
    assert.deepEqual([last.step, last.energy, last.gradientNorm], [0, path.energy, path.gradientNorm]);
    assert.deepEqual(last.points, path.points);
    const energies = path.history.map((entry) => entry.energy);
    assert.deepEqual(
      [...energies].sort((a, b) => b - a),
      energies,
    );
  });

  test('start: a polyline, an earlier path, one of another number of points', () => {
    const [from, to] = [
      [0.5, 0.6],
      [2.6, 1.2],
    ];
    const path = ring.shortestPath(from, to);
    const bent = ring.shortestPath(from, to, { start: [0.5, 0.6, 1.5, 1.6, 2.6, 1.2] });
    assert.equal(bent.status, 'converged');
    close(bent.length, path.length, 1e-10);
    for (const start of [path, ring.shortestPath(from, to, { points: 500 }), path.parameters ?? []]) {
      const warm = ring.shortestPath(from, to, { start });
      assert.ok(warm.converged && warm.iterations <= 3, `${warm.status} after ${warm.iterations}`);
      close(warm.length, path.length, 1e-10);
    }
    const onSphere = sphere.shortestPath([1, 0, 0], [0, 1, 0], { start: sphere.shortestPath([1, 0, 0], [0, 1, 0]) });
    assert.ok(onSphere.converged && onSphere.iterations <= 3);
  });

  test('start: a path around the other side stays there', () => {
    const other = ring.shortestPath([0.2, 0.1], [6.1, 0.1], { start: [0.2, 0.1, 3, 0.1, 6.1, 0.1] });
    const near = ring.shortestPath([0.2, 0.1], [6.1, 0.1]);
    close(near.length, 2.1045, 1e-4);
    assert.ok(other.length > 10);
  });

  test('start: a path that has no points is refused', () => {
    const failed = sphere.shortestPath([3, 0, 0], [0, 1, 0]);
    refuses(
      () => sphere.shortestPath([1, 0, 0], [0, 1, 0], { start: failed }),
      RangeError,
      /a path without x y z, of status 'off-surface'/,
    );
    const implicit = sphere.shortestPath([1, 0, 0], [0, 1, 0]);
    refuses(() => saddle.shortestPath([0, 0], [0.5, 0.5], { start: implicit }), RangeError, /a path without u v/);
  });
});

describe('periodic directions', () => {
  /** @param {object} definition */
  const periodic = (definition) => surfpath.surface(anything({ kind: 'parametric', ...definition })).domain?.periodic;

  test('are found where the surface closes smoothly', () => {
    assert.deepEqual(periodic(gallery.parametricTorus), { u: true, v: true });
    assert.deepEqual(periodic(gallery.cylinder), { u: true, v: false });
    assert.deepEqual(periodic(gallery.globe), { u: true, v: false });
    assert.deepEqual(periodic(gallery.catenoid), { u: true, v: false });
    assert.deepEqual(periodic(gallery.saddle), { u: false, v: false });
  });

  test('are not where it only meets itself, turns over, or all but closes', () => {
    assert.deepEqual(periodic(gallery.moebius), { u: false, v: false });
    const crease = { x: 'sin(u)', y: 'sin(u/2)', z: 'v', u: [0, '2*pi'], v: [0, 1] };
    assert.deepEqual(periodic(crease), { u: false, v: false });
    assert.deepEqual(periodic({ ...gallery.cylinder, u: [0, '2*pi - 1e-5'] }), { u: false, v: false });
  });

  test('an explicit answer wins', () => {
    assert.deepEqual(periodic({ ...gallery.parametricTorus, periodic: { v: true } }), { u: false, v: true });
    assert.deepEqual(periodic({ ...gallery.parametricTorus, periodic: {} }), { u: false, v: false });
  });

  test('take any number, and the path goes the short way, its u and v continuous', () => {
    const path = ring.shortestPath([0.2, 0.1], [6.1, 0.1]);
    const turned = ring.shortestPath([0.2 + 2 * Math.PI, 0.1], [6.1 - 4 * Math.PI, 0.1]);
    close(turned.length, path.length);
    const u = Array.from(/** @type {Float64Array} */ (path.parameters)).filter((_, i) => i % 2 === 0);
    close(u[0], 0.2);
    close(/** @type {number} */ (u.at(-1)), 6.1 - 2 * Math.PI);
    for (let i = 1; i < u.length; i++) assert.ok(Math.abs(u[i] - u[i - 1]) < 0.1);
  });

  test('set moves the range and finds them anew', () => {
    const arc = surfpath.parametric({ x: 'cos(u)', y: 'sin(u)', z: 'v', u: [0, 'a'], v: [0, 1], parameters: { a: 3 } });
    assert.equal(arc.domain?.periodic.u, false);
    refuses(() => arc.shortestPath([4, 0], [1, 0]), RangeError, /outside the range of u, \[0, 3\]/);
    arc.set({ a: 2 * Math.PI });
    assert.deepEqual(arc.domain, { u: [0, 2 * Math.PI], v: [0, 1], periodic: { u: true, v: false } });
    assert.equal(arc.shortestPath([4, 0], [1, 0]).status, 'converged');
  });
});

describe('set', () => {
  const hill = surfpath.parametric({ x: 'u', y: 'v', z: 'h*exp(-4*(u^2+v^2))', u: [-1, 1], v: [-1, 'w'], parameters: { h: 0, w: 1 } });

  test('changes what it names, and the answers with it', () => {
    const flat = hill.shortestPath([-0.9, 0.1], [0.9, 0.1]).length;
    hill.set({ h: 0.5 });
    assert.deepEqual(hill.parameters, { h: 0.5, w: 1 });
    assert.ok(hill.shortestPath([-0.9, 0.1], [0.9, 0.1]).length > flat);
    hill.set({ h: 0 });
    assert.equal(hill.shortestPath([-0.9, 0.1], [0.9, 0.1]).length, flat);
  });

  test('refuses what does not exist or is no number, and then changes nothing', () => {
    refuses(() => hill.set({ height: 1 }), RangeError, /set: the surface has no parameter 'height'; it has h, w/);
    refuses(() => hill.set({ toString: 1 }), RangeError, /no parameter 'toString'/);
    refuses(() => hill.set({ h: NaN }), RangeError, /parameter h must be a finite number/);
    refuses(() => hill.set(anything(undefined)), TypeError, /parameters must be an object of numbers, not undefined/);
    refuses(() => hill.set({ h: 1, w: -2 }), RangeError, /v must be a range of two numbers/);
    assert.deepEqual(hill.parameters, { h: 0, w: 1 });
    assert.equal(hill.evaluate([0, 0])[2], 0);
  });

  test('parameters is a copy', () => {
    hill.parameters.h = 9;
    assert.equal(hill.parameters.h, 0);
  });
});

describe('evaluate', () => {
  test('parametric: position and unit normal', () => {
    const [x, y, z, nx, ny, nz] = saddle.evaluate([0.5, 0.25]);
    assert.deepEqual([x, y, z], [0.5, 0.25, 0.1875]);
    const length = Math.hypot(1, 0.5, 1);
    for (const difference of [nx + 1 / length, ny - 0.5 / length, nz - 1 / length]) close(difference, 0);
    assert.equal(saddle.evaluate(new Float32Array(20)).length, 60);
    assert.equal(saddle.evaluate([]).length, 0);
  });

  test('implicit: f and its gradient', () => {
    assert.deepEqual(Array.from(sphere.evaluate([1, 2, 3, 0, 0, 0])), [13, 2, 4, 6, -1, 0, 0, 0]);
  });

  test('knows the surface beyond the rectangle, NaN where the formula ends, no normal at a pole', () => {
    assert.equal(saddle.evaluate([5, 0])[2], 25);
    assert.ok(saddle.evaluate([NaN, 0]).every((x, i) => i === 1 || Number.isNaN(x)));
    assert.ok(surfpath.surface(gallery.enneper).evaluate([0, 0]).every(Number.isFinite));
    assert.ok(Number.isNaN(surfpath.parametric({ ...gallery.saddle, x: 'u^3', y: 'v', z: 0 }).evaluate([0, 0])[3]));
  });

  test('refuses what is no flat array', () => {
    refuses(() => saddle.evaluate([1, 2, 3]), RangeError, /evaluate: points must be a flat array of u v, 2 numbers a point, not 3 numbers/);
    refuses(() => saddle.evaluate(anything(undefined)), TypeError, /points must be a flat array .* not undefined/);
    refuses(
      () =>
        saddle.evaluate(
          anything([
            [0, 0],
            [1, 1],
          ]),
        ),
      TypeError,
      /it holds an array of 2/,
    );
    refuses(() => sphere.evaluate(anything(['1', 2, 3])), TypeError, /it holds '1'/);
  });
});

describe('project', () => {
  test('finds the closest point', () => {
    assertNear(sphere.project([3, 4, 0]), [0.6, 0.8, 0]);
    const [u, v] = ring.project([5.5 * Math.cos(2), 5.5 * Math.sin(2), 0.1]);
    close(u, 2, 1e-9);
    assert.ok(Math.abs(v - 0.0667) < 0.01, `${v}`);
  });

  test('stays in the rectangle, and may be told where to begin', () => {
    assert.deepEqual(surfpath.parametric({ ...gallery.saddle, z: 0 }).project([7, 0.5, 2]), [1, 0.5]);
    assertNear(sphere.project([0, 0, 0], [0, 0, 2]), [0, 0, 1]);
  });

  test('refuses misuse, and says so where there is nothing', () => {
    refuses(() => sphere.project([1, 2]), RangeError, /project: point must be \[x, y, z\], 3 numbers, not 2/);
    refuses(() => saddle.project([0, 0, 0], [5, 5]), RangeError, /project: near\[0\] = 5 lies outside/);
    refuses(
      () => sphere.project([0, 0, 0]),
      RangeError,
      /project: no point of the surface was found from there \(off-surface\); pass a point nearer/,
    );
  });
});

describe('mesh', () => {
  test('parametric: a grid with positions, unit normals, parameters, indices', () => {
    const { positions, normals, parameters, indices } = saddle.mesh({ resolution: 4 });
    assert.deepEqual([positions.length, normals.length, parameters?.length, indices.length], [75, 75, 50, 96]);
    for (let i = 0; i < 25; i++) close(Math.hypot(...normals.subarray(3 * i, 3 * i + 3)), 1);
    assert.ok(indices instanceof Uint32Array && indices.every((index) => index < 25));
  });

  test('implicit: every vertex on the surface, exact normals, no parameters', () => {
    const { positions, normals, parameters, indices } = sphere.mesh({ resolution: 10 });
    assert.equal(parameters, undefined);
    assert.ok(indices.length > 0 && indices.every((index) => 3 * index < positions.length));
    for (const [i, x] of positions.entries()) close(x, normals[i]);
  });

  test('poles get a normal', () => {
    const { normals } = surfpath.surface(gallery.globe).mesh({ resolution: 8 });
    assert.ok(normals.every(Number.isFinite));
  });

  test('refuses misuse', () => {
    for (const resolution of [0, 257, 1.5, NaN])
      refuses(() => saddle.mesh({ resolution }), RangeError, /resolution must be a whole number from 1 to 256/);
    refuses(() => saddle.mesh(anything({ reslution: 8 })), TypeError, /there is no option 'reslution'; the options are resolution/);
    refuses(() => saddle.mesh(anything(null)), TypeError, /options must be an object/);
    refuses(() => surfpath.implicit({ f: 'x' }).mesh(), RangeError, /inside its bounds; give them in its definition/);
  });
});

describe('results', () => {
  test('are plain data: a Path survives structuredClone', () => {
    for (const path of [ring.shortestPath([0.5, 0.6], [2.6, 1.2], { record: true }), sphere.shortestPath([3, 0, 0], [0, 1, 0])])
      assert.deepEqual(structuredClone(path), path);
  });

  test('are copies: nothing that is done to one reaches the next', () => {
    const [from, to] = [
      [0.5, 0.6],
      [2.6, 1.2],
    ];
    const path = ring.shortestPath(from, to, { record: true });
    const kept = structuredClone(path);
    for (const array of [path.points, path.parameters, path.history[0].points]) array?.fill(NaN);
    const again = ring.shortestPath(from, to, { record: true });
    assert.deepEqual(again, kept);
    ring.shortestPath([0, 0], [1, 1], { points: 5000 });
    assert.deepEqual(again, kept);
    const mesh = sphere.mesh({ resolution: 6 });
    const meshKept = structuredClone(mesh);
    sphere.mesh({ resolution: 20 });
    assert.deepEqual(mesh, meshKept);
    anything(ring.domain).u[1] = 1;
    assert.equal(ring.domain?.u[1], 2 * Math.PI);
  });

  test('exchanging the ends reverses the path to the bit', () => {
    for (const [surface, a, b] of /** @type {const} */ ([
      [ring, [0.5, 0.6], [2.6, 1.2]],
      [sphere, [1, 0, 0], [0, 0.6, 0.8]],
    ])) {
      const [there, back] = [surface.shortestPath(a, b), surface.shortestPath(b, a)];
      assert.equal(back.length, there.length);
      const turned = Array.from({ length: 66 }, (_, i) => Array.from(back.points.subarray(3 * (65 - i), 3 * (66 - i)))).flat();
      assert.deepEqual(turned, Array.from(there.points));
    }
  });
});

describe('dispose', () => {
  test('a disposed surface refuses to work, and may be disposed twice', () => {
    const surface = surfpath.surface(gallery.sphere);
    surface.dispose();
    surface.dispose();
    for (const call of [
      () => surface.shortestPath([1, 0, 0], [0, 1, 0]),
      () => surface.evaluate([1, 0, 0]),
      () => surface.project([1, 0, 0]),
      () => surface.mesh(),
      () => surface.set({ r: 2 }),
    ])
      refuses(call, Error, /this surface was disposed/);
  });

  test('a disposed instance takes its surfaces along, and no others', async () => {
    const other = await load();
    const surface = other.surface(gallery.saddle);
    other.dispose();
    other.dispose();
    refuses(() => surface.shortestPath([0, 0], [0.5, 0.5]), Error, /this surface was disposed/);
    refuses(() => other.surface(gallery.saddle), Error, /parametric: this instance was disposed/);
    assert.equal(saddle.shortestPath([0, 0], [0.5, 0.5]).status, 'converged');
  });

  test('other surfaces keep working when slots and memory are used again', () => {
    const before = saddle.shortestPath([-0.9, 0.1], [0.5, 0.9]);
    for (let i = 0; i < 50; i++) {
      const passing = surfpath.parametric({ ...gallery.saddle, z: `u^2 - ${i}*v^2` });
      passing.shortestPath([0, 0], [0.5, 0.5]);
      passing.dispose();
    }
    assert.deepEqual(saddle.shortestPath([-0.9, 0.1], [0.5, 0.9]), before);
  });
});

describe('load', () => {
  test('refuses misuse', async () => {
    await assert.rejects(load(anything(null)), /load: options must be an object, not null/);
    await assert.rejects(load(anything({ wsam: 1 })), /load: there is no option 'wsam'; the options are wasm/);
    await assert.rejects(
      load(anything({ wasm: 5 })),
      /load: options.wasm must be a URL, a string, a Response, bytes or a WebAssembly.Module/,
    );
    await assert.rejects(load({ wasm: new Uint8Array(4) }), WebAssembly.CompileError);
  });

  test('takes the module as bytes, a file: URL, or compiled', async () => {
    const url = new URL('../../dist/surfpath.wasm', import.meta.url);
    const module = new WebAssembly.Module((await import('../../dist/wasm.js')).default);
    for (const wasm of [url, url.href, module]) {
      const instance = await load({ wasm });
      const path = instance.surface(gallery.saddle).shortestPath([-0.9, 0.1], [0.5, 0.9]);
      assert.deepEqual(path, saddle.shortestPath([-0.9, 0.1], [0.5, 0.9]));
      instance.dispose();
    }
  });
});
