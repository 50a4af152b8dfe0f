// Options in, Path out: every option, every status that can be provoked, and that results are plain data and copies.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { runInNewContext } from 'node:vm';
import { gallery } from '../../web/gallery.js';
import { load } from '../../web/index.js';
import { POLYLINE, STRAIGHT } from '../helpers/options.js';
import { createRandom } from '../helpers/random.js';
import { anything, assertNoPath, close, refuses } from '../helpers/refuses.js';

const surfpath = await load();
const saddle = surfpath.surface(gallery.saddle);
const sphere = surfpath.surface(gallery.sphere);
const ring = surfpath.surface(gallery.parametricTorus);

/** @typedef {import('../../web/index.js').Path} Path */

test('a start that leads out of the rectangle leads along its edge', () => {
  const arch = surfpath.graph({ z: 'sqrt(x*(1 - x) + 0.1)', x: [0, 1], y: [0, 1] });
  const [outside, within] = [
    [5, 5],
    [1, 1],
  ].map((middle) => arch.shortestPath([0, 0], [1, 1], { start: [0, 0, ...middle, 1, 1] }));
  assert.equal(outside.status, 'converged');
  assert.deepEqual(outside, within);
  arch.dispose();
});

describe('options', () => {
  /** @type {[unknown, Function, RegExp][]} */
  const bad = [
    [null, TypeError, /options must be an object, not null/],
    ['fast', TypeError, /options must be an object, not 'fast'/],
    [{ pionts: 3 }, TypeError, /there is no option 'pionts'; the options are algorithm, points/],
    [{ algorithm: 'fast', tolerance: 1e-6 }, RangeError, /options.algorithm must be 'elements', 'polyline' or 'paper', not 'fast'/],
    [{ algorithm: 'elements', gradientTolerance: 1e-6 }, RangeError, /is no option of 'elements', which takes tolerance$/],
    [{ algorithm: 'fast' }, RangeError, /algorithm must be 'elements', 'polyline' or 'paper', not 'fast'/],
    [{ start: 'curved' }, RangeError, /start must be 'global', 'straight', a polyline .* not 'curved'/],
    [
      { algorithm: 'polyline', tolerance: 1e-9 },
      RangeError,
      /tolerance is no option of 'polyline', which takes points and gradientTolerance$/,
    ],
    [{ gradientTolerance: 1e-6, tolerance: 1e-9 }, RangeError, /tolerance is no option of 'polyline', /],
    [{ tolerance: 0 }, RangeError, /between 1e-15 and 0.1, not 0/],
    [{ tolerance: 0.2 }, RangeError, /between 1e-15 and 0.1, not 0.2/],
    [{ tolerance: NaN }, RangeError, /between 1e-15 and 0.1, not NaN/],
    [{ algorithm: 'elements', tolerance: 0 }, RangeError, /between 1e-15 and 0.1/],
    [{ algorithm: 'elements', tolerance: '1e-9' }, TypeError, /tolerance must be a number/],
    [{ via: 3 }, TypeError, /via must be an array of points, not 3/],
    // biome-ignore lint/suspicious/noSparseArray: what a stranger may write
    [{ via: [[0, 0], , [1, 1]] }, TypeError, /options.via\[1\] must be .* not undefined/],
    [{ via: [[0, 9]] }, RangeError, /via\[0\]\[1\] = 9 lies outside the range of v/],
    [{ via: [[0, 0]], start: [0, 0, 1, 1] }, RangeError, /start must be 'global' or 'straight' where options.via is given/],
    [{ points: 0 }, RangeError, /points must be a whole number from 1 to 100000, not 0/],
    [{ points: 100_001 }, RangeError, /points must be/],
    [{ points: 2.5 }, RangeError, /points must be a whole number/],
    [{ points: NaN }, RangeError, /points must be a whole number/],
    [{ points: '64' }, TypeError, /points must be a whole number from 1 to 100000, not '64'/],
    [{ maxIterations: -1 }, RangeError, /maxIterations must be a whole number from 0 to 10000/],
    [{ gradientTolerance: 0 }, RangeError, /gradientTolerance must be a positive number, not 0/],
    [{ gradientTolerance: '1' }, TypeError, /gradientTolerance must be a positive number, not '1'/],
    [{ record: 1 }, TypeError, /record must be true or false, not 1/],
    [{ start: [0, 0, 1] }, RangeError, /start must be a flat array of u v, 2 to 1,000,000 points, not 3 numbers/],
    [{ start: [0, 0] }, RangeError, /start must be a flat array/],
    [{ start: [0, 0, NaN, 1] }, RangeError, /start\[2\] must be a finite number, not NaN/],
    [{ start: ['0', 0, 0.5, 0.5] }, TypeError, /start\[0\] must be a finite number, not '0'/],
    [{ start: [0, 0, null, 1] }, TypeError, /start\[2\] must be a finite number, not null/],
    [
      {
        start: [
          [0, 0],
          [0.5, 0.5],
          [1, 1],
          [1, 1],
        ],
      },
      TypeError,
      /start must be a flat array of u v, not one of arrays; write points\.flat\(\)/,
    ],
  ];
  for (const [options, kind, message] of bad)
    test(`shortestPath refuses ${JSON.stringify(options)}`, () =>
      refuses(() => saddle.shortestPath([0, 0], [0.5, 0.5], anything(options)), kind, message));

  test('a path out of JSON is no start, and the message says what is', () => {
    const path = saddle.shortestPath([0, 0], [0.5, 0.5]);
    const start = JSON.parse(JSON.stringify(path));
    refuses(
      () => saddle.shortestPath([0, 0], [0.5, 0.5], { start }),
      TypeError,
      /options\.start has lost its arrays to JSON; give Array\.from\(path\.parameters\)$/,
    );
    const flat = JSON.parse(JSON.stringify(Array.from(/** @type {Float64Array} */ (path.parameters))));
    assert.equal(saddle.shortestPath([0, 0], [0.5, 0.5], { start: flat }).status, 'converged');
  });

  test('a path whose arrays are plain ones, or of another realm, is a start as any', () => {
    const path = saddle.shortestPath([0, 0], [0.5, 0.5]);
    const parameters = Array.from(/** @type {Float64Array} */ (path.parameters));
    const foreign = runInNewContext('Float64Array.from(numbers)', { numbers: parameters });
    const [own, ...others] = [path.parameters, parameters, foreign].map((one) =>
      saddle.shortestPath([0, 0], [0.5, 0.4], { start: anything({ ...path, points: one, parameters: one }) }),
    );
    for (const other of others) assert.deepEqual(other, own);
  });

  test('an option that is undefined counts as not given', () => {
    const path = saddle.shortestPath([0, 0], [0.5, 0.5], { algorithm: undefined, points: undefined, start: undefined });
    assert.deepEqual(path, saddle.shortestPath([0, 0], [0.5, 0.5]));
  });

  test('gradientTolerance without an algorithm asks for the polyline', () => {
    const options = { gradientTolerance: 1e-6 };
    assert.deepEqual(
      saddle.shortestPath([0, 0], [0.5, 0.3], options),
      saddle.shortestPath([0, 0], [0.5, 0.3], { ...options, algorithm: 'polyline', start: 'global' }),
    );
  });

  test('the defaults: elements, from everywhere, to 1e-9, 64 points', () => {
    assert.deepEqual(
      ring.shortestPath([0.5, 0.6], [2.6, 1.2]),
      ring.shortestPath([0.5, 0.6], [2.6, 1.2], { algorithm: 'elements', start: 'global', tolerance: 1e-9, points: 64 }),
    );
  });

  test('points: as many as asked, from 1 to 100,000', () => {
    for (const points of [1, 2, 3, 50, 100_000])
      for (const options of [STRAIGHT, {}]) {
        const path = saddle.shortestPath([-0.9, 0.1], [0.5, 0.9], { ...options, points });
        assert.deepEqual([path.status, path.points.length, path.parameters?.length], ['converged', 3 * (points + 2), 2 * (points + 2)]);
      }
  });

  test('points: as many as asked, and all of them recorded, also of a path that is cut short', () => {
    const ends = /** @type {const} */ ([
      [0.5, 0.6],
      [2.6, 1.2],
    ]);
    for (const points of [1, 11, 63, 64, 100]) {
      const path = ring.shortestPath(...ends, { points, record: true, maxIterations: 2 });
      assert.deepEqual([path.status, path.points.length], ['iteration-limit', 3 * (points + 2)], `${points}`);
      assert.ok(path.history.every((entry) => (entry.points?.length ?? 0) > 0));
      const through = ring.shortestPath(...ends, { points: points + 2, maxIterations: 2, via: [[1, 3]] });
      assert.equal(through.points.length, 3 * (points + 4), `${points}, via`);
    }
  });

  test('points: too few to see the surface between them is stalled, not converged', () => {
    assert.equal(ring.shortestPath([0.5, 0.6], [2.6, 1.2], { ...STRAIGHT, points: 1 }).status, 'stalled');
  });

  test('more points: closer to the geodesic, and lengthError says how close', () => {
    const fine = ring.shortestPath([0.5, 0.6], [2.6, 1.2], { ...STRAIGHT, points: 2000 });
    for (const points of [16, 64, 256]) {
      const path = ring.shortestPath([0.5, 0.6], [2.6, 1.2], { ...STRAIGHT, points });
      close(path.lengthError / (fine.length + fine.lengthError - path.length), 1, 0.05);
    }
  });

  test('gradientTolerance is the paper’s stopping rule', () => {
    const path = ring.shortestPath([0.5, 0.6], [2.6, 1.2], { ...STRAIGHT, gradientTolerance: 0.5 });
    assert.ok(path.converged && path.gradientNorm <= 0.5 && path.gradientNorm > 1e-6);
    assert.ok(path.history.slice(0, -1).every((entry) => entry.gradientNorm > 0.5));
  });

  for (const { points, to } of [
    { points: 7, to: [2.6, 1.2] },
    { points: 200, to: [2.6, 1.2] },
    { points: 200, to: [0.52, 0.63] },
  ])
    test(`history of ${points} points to ${to}: one entry a step and one for the end; record keeps the polylines`, () => {
      const from = [0.5, 0.6];
      const plain = ring.shortestPath(from, to, { ...STRAIGHT, points });
      const path = ring.shortestPath(from, to, { ...STRAIGHT, points, record: true });
      assert.equal(path.history.length, path.iterations + 1);
      assert.ok(plain.history.every((entry) => !('points' in entry)));
      for (const entry of path.history) {
        assert.deepEqual(Object.keys(entry), ['energy', 'gradientNorm', 'decrement', 'step', 'points']);
        assert.equal(entry.points?.length, 3 * (points + 2));
        assert.deepEqual([entry.points?.slice(0, 3), entry.points?.slice(-3)], [path.points.slice(0, 3), path.points.slice(-3)]);
      }
      const last = /** @type {import('../../web/runtime/result.js').Iterate} */ (path.history.at(-1));
      assert.deepEqual([last.step, last.energy, last.gradientNorm], [0, path.energy, path.gradientNorm]);
      assert.deepEqual(last.points, path.points);
      for (const { history } of [plain, path]) {
        const energies = history.map((entry) => entry.energy);
        assert.deepEqual(
          [...energies].sort((a, b) => b - a),
          energies,
        );
      }
      assert.deepEqual(plain.points, path.points);
    });

  test('start: a polyline, an earlier path, one of another number of points', () => {
    const [from, to] = [
      [0.5, 0.6],
      [2.6, 1.2],
    ];
    const path = ring.shortestPath(from, to, STRAIGHT);
    const bent = ring.shortestPath(from, to, { ...POLYLINE, start: [0.5, 0.6, 1.5, 1.6, 2.6, 1.2] });
    assert.equal(bent.status, 'converged');
    close(bent.length, path.length, 1e-10);
    for (const start of [path, ring.shortestPath(from, to, { ...STRAIGHT, points: 500 }), path.parameters ?? []]) {
      const warm = ring.shortestPath(from, to, { ...POLYLINE, start });
      assert.ok(warm.converged && warm.iterations <= 3, `${warm.status} after ${warm.iterations}`);
      close(warm.length, path.length, 1e-10);
    }
    const cold = sphere.shortestPath([1, 0, 0], [0, 1, 0], STRAIGHT);
    const onSphere = sphere.shortestPath([1, 0, 0], [0, 1, 0], { ...POLYLINE, start: cold });
    assert.ok(onSphere.converged && onSphere.iterations <= 3);
  });

  test('start: a path around the other side stays there', () => {
    const other = ring.shortestPath([0.2, 0.1], [6.1, 0.1], { ...POLYLINE, start: [0.2, 0.1, 3, 0.1, 6.1, 0.1] });
    const near = ring.shortestPath([0.2, 0.1], [6.1, 0.1], STRAIGHT);
    close(near.length, 2.1045, 1e-4);
    assert.ok(other.length > 10);
  });

  test('start: thousands of points that lie unevenly lead where others of that line do, however many they are', () => {
    const hill = surfpath.graph({ z: '40*sin(x*y)', x: [-1, 1], y: [-1, 1] });
    for (const count of [4096, 4097, 4098]) {
      const along = Array.from({ length: count }, (_, i) => (i / (count - 1)) ** 16);
      const start = along.flatMap((t) => [1.8 * t - 0.9, 0.9 * t - 0.5 + (t < 1 ? 0.2 * Math.sin(9 * Math.PI * t) : 0)]);
      const path = hill.shortestPath([-0.9, -0.5], [0.9, 0.4], { start });
      assert.equal(path.status, 'converged', `${count} points`);
      close(path.length, 31.621165361527, 1e-9);
    }
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

describe('statuses', () => {
  test('steps that led to no path are counted', () => {
    const vanishing = surfpath.parametric({ x: 'u', y: 'v', z: 0, u: [-2, 2], v: [-2, 2], density: 'u^2' });
    for (const most of [0, 5, 20]) {
      const path = vanishing.shortestPath([0, 0], [1, 1], { algorithm: 'polyline', start: 'straight', maxIterations: most });
      assertNoPath(path, 'singular-metric');
      assert.equal(path.iterations, most);
    }
    vanishing.dispose();
  });

  test('singular-metric: a constant surface, a curve, no surface at all, a cuspidal edge between the ends', () => {
    const constant = surfpath.parametric({ x: 1, y: 2, z: 3, u: [0, 1], v: [0, 1] });
    const curve = surfpath.parametric({ x: 'u', y: 'u^2', z: 0, u: [0, 1], v: [0, 1] });
    for (const options of [STRAIGHT, { start: STRAIGHT.start }, {}]) {
      for (const surface of [constant, curve]) assertNoPath(surface.shortestPath([0, 0], [1, 1], options), 'singular-metric');
      assertNoPath(surfpath.implicit({ f: '0*x' }).shortestPath([0, 0, 0], [1, 0, 1], options), 'singular-metric');
      assertNoPath(surfpath.implicit({ f: 1 }).shortestPath([0, 0, 0], [1, 1, 1], options), 'singular-metric');
      assertNoPath(sphere.shortestPath([0, 0, 0], [1, 0, 0], options), 'singular-metric');
    }
    const dini = surfpath.parametric({ ...gallery.dini, v: [0.1, 2] });
    assertNoPath(dini.shortestPath([0, 1.2], [1, 1.9], STRAIGHT), 'singular-metric');
    const across = dini.shortestPath([0, 1.2], [1, 1.9]);
    assert.deepEqual([across.status, across.crossesSingularity], ['converged', true]);
  });

  test('not-finite: a formula outside its domain', () => {
    const half = surfpath.parametric({ x: 'u', y: 'v', z: 'sqrt(u-0.5)', u: [0, 1], v: [0, 1] });
    for (const options of [STRAIGHT, { start: STRAIGHT.start }, {}]) {
      assertNoPath(half.shortestPath([0, 0], [1, 1], options), 'not-finite');
      assertNoPath(surfpath.implicit({ f: 'sqrt(-1-x^2)' }).shortestPath([0, 0, 0], [1, 1, 1], options), 'not-finite');
    }
  });

  test('a place so far away that rounding is all there is: not converged, and its squares no numbers: not-finite', () => {
    const sheet = (/** @type {string} */ z) => surfpath.graph({ z, x: [-1, 1], y: [-1, 1] }).shortestPath([-0.5, -0.5], [0.6, 0.5]);
    for (const [z, status] of [
      ['1e3 + x*y', 'converged'],
      ['1e18 + x*y', 'tolerance-not-met'],
      ['1e100', 'tolerance-not-met'],
    ]) {
      const path = sheet(z);
      assert.equal(path.status, status);
      assert.ok(Number.isFinite(path.length) && Number.isFinite(path.lengthError) && path.lengthError > 2e-16 * Number.parseFloat(z));
    }
    assertNoPath(sheet('e^700'), 'not-finite');
  });

  test('sheet-jump: two components, from a straight start; searched from everywhere, they are disconnected', () => {
    const two = surfpath.implicit({ f: '((x-2)^2+y^2+z^2-1)*((x+2)^2+y^2+z^2-1)' });
    for (const options of [STRAIGHT, { start: STRAIGHT.start }])
      assertNoPath(two.shortestPath([-3, 0, 0], [3, 0, 0], options), 'sheet-jump');
    assertNoPath(two.shortestPath([-3, 0, 0], [3, 0, 0]), 'disconnected');
  });

  test('saddle: what the paper’s sign test accepts; the certified method leaves it', () => {
    const bumpy = surfpath.surface(gallery.bumpy);
    const [from, to] = [
      [-1, 0.5236],
      [2.5, 0.5236],
    ];
    const paper = bumpy.shortestPath(from, to, { ...STRAIGHT, algorithm: 'paper' });
    assert.deepEqual([paper.status, paper.converged], ['saddle', false]);
    assert.ok(paper.index > 0 && paper.points.length > 0);
    const path = bumpy.shortestPath(from, to, STRAIGHT);
    assert.deepEqual([path.status, path.index], ['converged', 0]);
    assert.ok(path.length < paper.length);
  });

  test('iteration-limit: a usable path that is no worse than its start', () => {
    const straight = ring.shortestPath([0.5, 0.6], [2.6, 1.2], { ...STRAIGHT, maxIterations: 0 });
    const short = ring.shortestPath([0.5, 0.6], [2.6, 1.2], { ...STRAIGHT, maxIterations: 2 });
    assert.deepEqual([straight.status, straight.iterations], ['iteration-limit', 0]);
    assert.deepEqual([short.status, short.iterations], ['iteration-limit', 2]);
    assert.ok(short.energy < straight.energy && short.points.length === straight.points.length);
  });

  test('antipodal points of a sphere, joined by infinitely many shortest paths, are not called converged', () => {
    const path = sphere.shortestPath([1, 0, 0], [-1, 0, 0], STRAIGHT);
    assert.equal(path.converged, false);
    close(path.length + path.lengthError, Math.PI, 1e-5); // the estimate is good to fourth order
    const found = sphere.shortestPath([1, 0, 0], [-1, 0, 0]);
    assert.equal(found.converged, false);
    close(found.length + found.lengthError, Math.PI, 1e-5);
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
    const cone = surfpath.parametric({ x: 'v cos(u)', y: 'v sin(u)', z: 'v', u: [0, '2pi'], v: [-1, 1] });
    const via = [
      [5.4, 3.2],
      [1.2, 4.9],
    ];
    for (const [surface, a, b, through] of /** @type {const} */ ([
      [ring, [0.5, 0.6], [2.6, 1.2], null],
      [sphere, [1, 0, 0], [0, 0.6, 0.8], null],
      [cone, [1, -0.5], [2, 0.5], null],
      [ring, [0.5, 0.6], [2.6, 1.2], via],
    ])) {
      for (const options of [STRAIGHT, {}]) {
        const [forth, round] = through ? [{ via: [...through] }, { via: [...through].reverse() }] : [{}, {}];
        const [there, back] = [surface.shortestPath(a, b, { ...options, ...forth }), surface.shortestPath(b, a, { ...options, ...round })];
        assert.equal(back.length, there.length);
        const turned = Array.from({ length: 66 }, (_, i) => Array.from(back.points.subarray(3 * (65 - i), 3 * (66 - i)))).flat();
        assert.deepEqual(turned, Array.from(there.points));
      }
    }
  });
});

test('parameters begin exactly at the first end, however many turns away', () => {
  const random = createRandom(17);
  const turn = () => random.between(-20, 20);
  for (let i = 0; i < 40; i++) {
    const from = [turn(), turn()];
    assert.deepEqual(Array.from(ring.shortestPath(from, [turn(), turn()]).parameters?.subarray(0, 2) ?? []), from);
  }
});

test('geodesics gives paths at rest only', () => {
  const crease = surfpath.graph({ z: 'abs(x) + abs(y)', x: [-1, 1], y: [-1, 1] });
  for (const { status } of crease.geodesics([-0.5, -0.4], [0.6, 0.3])) assert.ok(!/stalled|iteration-limit/.test(status), status);
  assert.deepEqual(saddle.geodesics([-0.9, 0.1], [0.8, -0.4], { maxIterations: 1 }), []);
});

test('gradientNorm of a polyline is that of its energy, by differences', () => {
  const surface = surfpath.parametric({ x: 'u', y: 'v', z: 'u^2-v^2+u*v', u: [-2, 2], v: [-2, 2] });
  const [from, to, points] = [[-1, 0.3], [1.2, -0.8], 6];
  const nodes = Array.from({ length: points + 2 }, (_, i) => from.map((x, j) => x + ((to[j] - x) * i) / (points + 1))).flat();
  /** (K + 1) Σ |X_i+1 − X_i|² @param {number[]} places */
  const energy = (places) => {
    let sum = 0;
    for (let i = 2; i < places.length; i += 2) {
      const [u, v, a, b] = [places[i], places[i + 1], places[i - 2], places[i - 1]];
      sum += (u - a) ** 2 + (v - b) ** 2 + (u * u - v * v + u * v - (a * a - b * b + a * b)) ** 2;
    }
    return (points + 1) * sum;
  };
  const moved = (/** @type {number} */ k, /** @type {number} */ by) => energy(nodes.map((x, i) => (i === k ? x + by : x)));
  let squared = 0;
  for (let k = 2; k < nodes.length - 2; k++) squared += ((moved(k, 1e-5) - moved(k, -1e-5)) / 2e-5) ** 2;
  const path = surface.shortestPath(from, to, { algorithm: 'polyline', start: 'straight', points });
  assert.ok(Math.abs(path.history[0].energy / energy(nodes) - 1) < 1e-13);
  assert.ok(
    Math.abs(path.history[0].gradientNorm / Math.sqrt(squared) - 1) < 1e-7,
    `${path.history[0].gradientNorm}, not ${Math.sqrt(squared)}`,
  );
  surface.dispose();
});
