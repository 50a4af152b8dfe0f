// Surfaces that hang together in points, where a line within the rectangle is one: through the points from piece to piece, against closed forms.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { load } from '../../../web/index.js';
import { createRandom } from '../../helpers/random.js';
import { anything, close } from '../../helpers/refuses.js';

/** @typedef {import('../../../web/index.js').Surface} Surface */
/** @typedef {import('../../../web/index.js').Path} Path */

const surfpath = await load();
const TURN = 2 * Math.PI;
const PAIRS = 12;

/** @param {Record<string, unknown>} definition */
const make = (definition) => surfpath.surface(anything({ kind: 'parametric', u: [0, '2pi'], ...definition }));
const doubleCone = { x: 'v cos(u)', y: 'v sin(u)', z: 'v', v: [-1, 1] };
const spindle = { x: '(1 + 2cos(v)) cos(u)', y: '(1 + 2cos(v)) sin(u)', z: '2sin(v)', v: [0, '2pi'] };

/** That a path begins and ends where asked, and that its points are those of its parameters. @param {Surface} surface @param {Path} path @param {number[]} from @param {number[]} to */
function assertFits(surface, path, from, to) {
  const parameters = /** @type {Float64Array} */ (path.parameters);
  const [places, ends] = [surface.evaluate(parameters), surface.evaluate([...from, ...to])];
  const apart = (/** @type {number} */ i, /** @type {Float64Array} */ others, /** @type {number} */ k) =>
    Math.hypot(...[0, 1, 2].map((c) => path.points[3 * i + c] - others[6 * k + c]));
  const last = path.points.length / 3 - 1;
  for (let i = 0; i <= last; i++) assert.ok(apart(i, places, i) < 1e-12, `point ${i}`);
  assert.ok(apart(0, ends, 0) < 1e-12 && apart(last, ends, 1) < 1e-12);
  assert.ok(Math.hypot(parameters[0] - from[0], parameters[1] - from[1]) < 1e-12);
}

describe('a double cone', () => {
  const surface = make(doubleCone);
  const slant = (/** @type {number} */ v) => Math.SQRT2 * v;

  test(`from one half to the other: through the apex, as long as both slants, ${PAIRS} pairs`, () => {
    const random = createRandom(41);
    for (let i = 0; i < PAIRS; i++) {
      const [from, to] = [
        [random.between(-9, 9), random.between(-1, -0.01)],
        [random.between(-9, 9), random.between(0.01, 1)],
      ];
      const [path, back] = [surface.shortestPath(from, to), surface.shortestPath(to, from)];
      assert.equal(path.status, 'converged');
      close(path.length, slant(to[1] - from[1]));
      close(back.length, path.length);
      assertFits(surface, path, from, to);
      assertFits(surface, back, to, from);
    }
  });

  test('within a half: as on that half alone', () => {
    const half = make({ ...doubleCone, v: [0, 1] });
    const random = createRandom(43);
    for (let i = 0; i < PAIRS; i++) {
      const [from, to] = [0, 1].map(() => [random.between(0, TURN), random.between(0.01, 1)]);
      const path = surface.shortestPath(from, to);
      assert.equal(path.status, 'converged');
      close(path.length, half.shortestPath(from, to).length);
    }
  });

  test('from the apex, and to it', () => {
    for (const [from, to] of [
      [
        [1, 0],
        [2, 0.5],
      ],
      [
        [1, 0],
        [2, -0.5],
      ],
      [
        [4, 0.5],
        [0, 0],
      ],
      [
        [4, -0.5],
        [0, 0],
      ],
    ]) {
      const path = surface.shortestPath(from, to);
      assert.equal(path.status, 'converged');
      close(path.length, slant(0.5));
    }
  });

  test('from the apex to itself, whatever the angle: a point', () => {
    for (const path of [surface.shortestPath([1, 0], [2, 0]), ...surface.geodesics([1, 0], [1, 0])]) {
      assert.deepEqual([path.status, path.length, path.lengthError, path.points.length], ['converged', 0, 0, 198]);
      assert.ok(path.points.every((x) => x === 0));
    }
  });

  test('as many points as asked for, and the same however it is asked', () => {
    const [from, to] = [
      [1, -0.5],
      [2, 0.4],
    ];
    const { length } = surface.shortestPath(from, to);
    for (const points of [1, 2, 3, 4, 64, 1000]) assert.equal(surface.shortestPath(from, to, { points }).points.length, 3 * (points + 2));
    close(surface.lengths([...from, ...to])[0], length);
    close(surface.shortestPaths([...from, ...to])[0].length, length);
    close(surface.shortestPath(from, to, { start: 'straight' }).length, length);
    close(surface.shortestPath(from, to, { start: surface.shortestPath(from, [1, -0.2]) }).length, length);
    close(
      surface.shortestPath(from, to, { via: [[1, 0.2]] }).length,
      surface.shortestPath(from, [1, 0.2]).length + surface.shortestPath([1, 0.2], to).length,
    );
    assert.deepEqual(
      surface.geodesics(from, to).map((path) => path.length.toFixed(12)),
      [length.toFixed(12)],
    );
    assert.ok(surface.shortestPath(from, to, { record: true }).history.every(({ points }) => points));
  });

  test('the distance field, rough and exact', () => {
    for (const [exact, within] of /** @type {const} */ ([
      [false, 0.05],
      [true, 1e-9],
    ])) {
      const { mesh, distances } = surface.distanceField([1, -0.5], { resolution: 8, exact });
      const places = /** @type {Float64Array} */ (mesh.parameters);
      for (const [i, distance] of distances.entries())
        if (places[2 * i + 1] > 0) assert.ok(Math.abs(distance / slant(0.5 + places[2 * i + 1]) - 1) < within);
    }
  });

  test('a trace ends at the apex, as at any pole', () => {
    const path = surface.trace([1, -0.5], [0, 1], 3);
    assert.equal(path.status, 'edge-reached');
    close(path.length, slant(0.5));
    const beside = surface.trace([1, -0.5], [0.1, 1], 1);
    assert.equal(beside.status, 'converged');
    const parameters = /** @type {Float64Array} */ (beside.parameters);
    assert.ok(parameters[0] === 1 && parameters[1] === -0.5 && parameters.every((v, i) => i % 2 === 0 || v < 0));
  });

  test('from the apex a trace leads into the half that its direction points to', () => {
    for (const way of [1, -1]) {
      const path = surface.trace([1, 0], [0, way], slant(0.5));
      assert.equal(path.status, 'converged');
      const [u, v] = /** @type {Float64Array} */ (path.parameters).slice(-2);
      assert.equal(u, 1);
      close(v, way * 0.5);
    }
  });

  test('set moves the apex', () => {
    const moved = make({ x: '(v - a) cos(u)', y: '(v - a) sin(u)', z: 'v', v: [-1, 1], parameters: { a: 0 } });
    close(moved.shortestPath([0, -0.5], [3, 0.5]).length, slant(1));
    moved.set({ a: 0.3 });
    close(moved.shortestPath([0, -0.5], [3, 0.5]).length, slant(1));
    const within = moved.shortestPath([0, -0.5], [3, 0.2]);
    assert.ok(within.converged && within.length < slant(1.1));
    moved.set({ a: 2 });
    assert.ok(moved.shortestPath([0, -0.5], [3, 0.5]).length > slant(1));
    moved.dispose();
  });
});

describe('a spindle torus, whose pieces form a ring', () => {
  const surface = make(spindle);
  const [first, second] = [TURN / 3, (2 * TURN) / 3];

  test(`from the outer piece to the inner one: along meridians, through the nearer point, ${PAIRS} pairs`, () => {
    const random = createRandom(47);
    for (let i = 0; i < PAIRS; i++) {
      const inner = [random.between(-9, 9), random.between(first, second)];
      const outer = [random.between(-9, 9), random.between(second, first + TURN) - TURN * (i % 2)];
      const path = surface.shortestPath(inner, outer);
      assert.equal(path.status, 'converged');
      const lifted = outer[1] + TURN * (i % 2);
      close(path.length, 2 * Math.min(inner[1] - first + first + TURN - lifted, second - inner[1] + lifted - second));
      assertFits(surface, path, inner, outer);
      close(surface.shortestPath(outer, inner).length, path.length);
    }
  });

  test('from the top of the outer piece to its bottom the way leads through the inner one, if that is shorter: one of many', () => {
    const [from, to] = [
      [0.3, first - 0.1],
      [2, second + 0.15],
    ];
    const path = surface.shortestPath(from, to);
    assert.equal(path.status, 'ill-conditioned');
    close(path.length, 2 * (second - first + 0.25));
    const long = surface.shortestPath([0.3, first - 0.9], [0.3, second + 0.95]);
    assert.equal(long.status, 'converged');
    close(long.length, 2 * (first - 0.9 + TURN - second - 0.95));
  });
});

test('across a whole bead, from pole to pole, geodesics gives the one way that shortestPath gives, whatever sign rounding gives its index', () => {
  const beads = surfpath.revolution({ r: 'sin(t)', z: 't', t: [-1, 4] });
  for (const [from, to] of [
    [-0.5, 3.7],
    [0, Math.PI],
    [0.2, 3],
  ]) {
    const path = beads.shortestPath([0, from], [1, to]);
    const all = beads.geodesics([0, from], [1, to]);
    assert.ok(['converged', 'ill-conditioned'].includes(path.status));
    assert.ok(all.length > 0, `${from} to ${to}`);
    close(all[0].length, path.length);
  }
  beads.dispose();
});

describe('both edges are one and the same point', () => {
  test('a horn torus: through it, or around, whichever is shorter', () => {
    const horn = make({ x: '(1 + cos(v)) cos(u)', y: '(1 + cos(v)) sin(u)', z: 'sin(v)', v: ['-pi', 'pi'] });
    for (const [from, to] of [
      [
        [1, 0.2 - Math.PI],
        [2, Math.PI - 0.3],
      ],
      [
        [2, Math.PI - 0.3],
        [1, 0.2 - Math.PI],
      ],
    ]) {
      const path = horn.shortestPath(from, to);
      assert.equal(path.status, 'converged');
      close(path.length, 0.5);
      assertFits(horn, path, from, to);
    }
    const around = horn.shortestPath([1, -1], [1, 1.2]);
    assert.equal(around.status, 'converged');
    close(around.length, 2.2);
  });

  for (const [sign, at] of /** @type {const} */ ([
    ['+', Math.PI],
    ['-', 0],
  ]))
    test(`a horn torus whose radius 1 ${sign} cos v touches zero at v = ${at.toFixed(2)}: never longer than through that point`, () => {
      const horn = make({ x: `(1 ${sign} cos(v)) cos(u)`, y: `(1 ${sign} cos(v)) sin(u)`, z: 'sin(v)', v: [0, '2pi'] });
      const random = createRandom(29);
      const away = (/** @type {number[]} */ [, v]) => Math.min(Math.abs(v - at), TURN - Math.abs(v - at));
      let through = 0;
      for (let i = 0; i < PAIRS; i++) {
        const [from, to] = [0, 1].map(() => [random.between(0, TURN), random.between(0, TURN)]);
        const path = horn.shortestPath(from, to);
        const both = away(from) + away(to);
        assert.equal(path.status, 'converged', `${from} to ${to}`);
        assert.ok(path.length <= both * (1 + 1e-9), `${from} to ${to}: ${path.length}, not ${both}`);
        through += Number(path.length >= both * (1 - 1e-9));
        assertFits(horn, path, from, to);
      }
      assert.ok(through >= PAIRS / 4, `${through}`);
    });

  test('a sphere twice: through the nearer pole from one sheet to the other', () => {
    const twice = surfpath.revolution({ r: 'sin(t)', z: 'cos(t)', t: [0, '2pi'] });
    for (const [from, to] of [
      [1, 5],
      [5, 1],
      [2, 4],
      [1, 4],
      [0, 1],
      [TURN, 4],
      [0, 4],
      [TURN, 1],
    ]) {
      const path = twice.shortestPath([0, from], [1, to]);
      assert.equal(path.status, 'converged');
      const inward = Math.abs(from - to);
      close(path.length, Math.min(inward, TURN - inward));
      /* At that point the angle is free, and the path begins at the edge beside it. */
      const begin = from % TURN === 0 ? [1, to < Math.PI ? 0 : TURN] : [0, from];
      assertFits(twice, path, begin, [1, to]);
    }
  });
});

describe('a radius that touches zero in a kink', () => {
  for (const radius of ['abs(t - a)', 'sqrt((t - a)^2)'])
    test(`a double cone of radius ${radius}, wherever its apex: as long as both slants, ${PAIRS} pairs`, () => {
      const surface = surfpath.revolution({ r: radius, z: 't', t: [-1, 1], parameters: { a: 0 } });
      const random = createRandom(53);
      for (let i = 0; i < PAIRS; i++) {
        const a = random.between(-0.9, 0.9);
        surface.set({ a });
        const [from, to] = [
          [random.between(-9, 9), random.between(-1, a)],
          [random.between(-9, 9), random.between(a, 1)],
        ];
        const path = surface.shortestPath(from, to);
        assert.equal(path.status, 'converged', `${a}: ${from} to ${to}`);
        close(path.length, Math.SQRT2 * (to[1] - from[1]));
        assertFits(surface, path, from, to);
      }
      surface.dispose();
    });

  test('the two balls of an orbital, r = |cos v|, which touch each other: an arc of each, along meridians', () => {
    const orbital = make({ x: 'abs(cos(v)) sin(v) cos(u)', y: 'abs(cos(v)) sin(v) sin(u)', z: 'abs(cos(v)) cos(v)', v: [0, 'pi'] });
    const random = createRandom(59);
    for (let i = 0; i < PAIRS; i++) {
      const [from, to] = [0, Math.PI / 2].map((low) => [random.between(0, TURN), random.between(low + 0.01, low + Math.PI / 2 - 0.01)]);
      const path = orbital.shortestPath(from, to);
      assert.equal(path.status, 'converged', `${from} to ${to}`);
      close(path.length, to[1] - from[1]);
      assertFits(orbital, path, from, to);
    }
    orbital.dispose();
  });
});

describe('poles whose radius is zero up to rounding, on either side', () => {
  for (const v of [
    ['2pi/3', '4pi/3'],
    ['-2pi/3', '2pi/3'],
  ])
    test(`v in ${v.join(' … ')}: along a meridian`, () => {
      const surface = make({ ...spindle, v });
      const [low, high] = /** @type {{ v: number[] }} */ (surface.domain).v;
      for (const pole of [low, high]) {
        const to = [1, low + 0.3 * (high - low)];
        for (const path of [surface.shortestPath([0.3, pole], to), surface.shortestPath(to, [0.3, pole])]) {
          assert.equal(path.status, 'converged');
          close(path.length, 2 * Math.abs(to[1] - pole));
        }
      }
    });

  test('from pole to pole each meridian is as good', () => {
    const lemon = make({ ...spindle, v: ['2pi/3', '4pi/3'] });
    const { domain } = lemon;
    const path = lemon.shortestPath([0.3, /** @type {any} */ (domain).v[0]], [2, /** @type {any} */ (domain).v[1]]);
    assert.equal(path.status, 'ill-conditioned');
    close(path.length, (2 * TURN) / 3);
  });
});

for (const low of [-Math.PI, -1, 0])
  test(`a horn torus from v = ${low}: from its point, and from as near as can be told, never the long way round`, () => {
    const surface = surfpath.parametric({
      x: '(1 + cos(v)) cos(u)',
      y: '(1 + cos(v)) sin(u)',
      z: 'sin(v)',
      u: [0, TURN],
      v: [low, low + TURN],
    });
    for (const away of [0, 1e-15, -1e-15, 1e-13, 1e-9, 1e-6, -1e-6, 1e-4]) {
      const v = Math.PI + away > low + TURN ? away - Math.PI : Math.PI + away;
      const path = surface.shortestPath([0, v], [1, 1]);
      /* Beside the point the radius is all rounding. */
      assert.ok(path.converged || (away !== 0 && Math.abs(away) < 1e-5), `${away}: ${path.status}`);
      if (path.converged) assert.ok(Math.abs(path.length - (Math.PI - 1 + away)) <= 1e-12, `${away}: ${path.length}`);
    }
    surface.dispose();
  });
