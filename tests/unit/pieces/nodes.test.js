// Implicit surfaces whose sheets meet in points: paths that end there, or lead through, against closed forms and ways along a fine mesh.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { load } from '../../../web/index.js';
import { findNet } from '../../../web/pieces/nodes.js';
import { Heap } from '../../../web/runtime/heap.js';
import { distancesAlong } from '../../helpers/mesh-distances.js';
import { createRandom } from '../../helpers/random.js';
import { ofAll } from '../../helpers/sample.js';
import { anything, close } from '../../helpers/refuses.js';
import { simpson } from '../../helpers/simpson.js';

/** @typedef {[number, number]} Range */

const surfpath = await load();
const PAIRS = ofAll(6, 10);

/** @param {number} size @returns {[Range, Range, Range]} */
const within = (size) => [
  [-size, size],
  [-size, size],
  [-size, size],
];
const cone = { f: 'x^2 + y^2 - z^2', bounds: within(2) };
const cayley = { f: '4(x^3 + y^3 + z^3 + 1) - (x + y + z + 1)^3', bounds: within(3) };
const kummer = {
  f: '(x^2 + y^2 + z^2 - m)^2 - (3m - 1)/(3 - m) * ((1 - z)^2 - 2x^2) * ((1 + z)^2 - 2y^2)',
  parameters: { m: 1.5 },
  bounds: within(1.8),
};
const barth = {
  f: '4(a^2*x^2 - y^2)(a^2*y^2 - z^2)(a^2*z^2 - x^2) - (1 + 2a)(x^2 + y^2 + z^2 - 1)^2',
  parameters: { a: (1 + Math.sqrt(5)) / 2 },
  bounds: within(2),
};

/** A point of the cone. @param {number} height @param {number} angle */
const onCone = (height, angle) => [Math.abs(height) * Math.cos(angle), Math.abs(height) * Math.sin(angle), height];
const norm = (/** @type {ArrayLike<number>} */ x) => Math.hypot(x[0], x[1], x[2]);

for (const [f, apex, slope] of /** @type {const} */ ([
  ['z - hypot(x, y)', 0, 1],
  ['sqrt(x^2 + y^2) - (1 - z)/2', 1, -2],
  ['max(hypot(x, y) - z, z - 1)', 0, 1],
]))
  test(`${f} = 0, whose gradient is no number at the apex: straight from there`, () => {
    const surface = surfpath.implicit({ f, bounds: within(1.2) });
    const random = createRandom(12);
    for (let i = 0; i < 8; i++) {
      const [far, angle] = [random.between(0.1, 0.9), random.between(0, 2 * Math.PI)];
      const path = surface.shortestPath([0, 0, apex], [far * Math.cos(angle), far * Math.sin(angle), apex + slope * far]);
      assert.equal(path.status, 'converged', `${far} ${angle}`);
      close(path.length, far * Math.hypot(1, slope));
    }
  });

test('where there are no nodes few places are looked at besides those of the grid, and all are found where there are some', () => {
  for (const [level, count] of [
    [0.5, 0],
    [1, 6],
  ]) {
    let places = 0;
    /** T₄(x) + T₄(y) + T₄(z) = level. @param {ArrayLike<number>} points */
    const jets = (points) => {
      const jet = [];
      for (let i = 0; i < points.length; i += 3) {
        const [x, y, z] = [points[i], points[i + 1], points[i + 2]];
        const slopes = [x, y, z].map((a) => 32 * a ** 3 - 16 * a);
        const [xx, yy, zz] = [x, y, z].map((a) => 96 * a ** 2 - 16);
        const f = [x, y, z].reduce((sum, a) => sum + 8 * a ** 4 - 8 * a ** 2 + 1, -level);
        jet.push(f, ...slopes, xx, 0, 0, yy, 0, zz);
      }
      places += points.length / 3;
      return Float64Array.from(jet);
    };
    const net = findNet(/** @type {any} */ ({ jets, mesh: () => ({ positions: [], indices: [] }) }), within(1.1).flat(), 24);
    assert.equal(net.nodes.length, count);
    assert.ok(places < 1.5 * 24 ** 3, `${places}`);
  }
});

describe('a double cone', () => {
  const surface = surfpath.implicit(cone);

  test('from the apex, and to it: along a straight line', () => {
    const random = createRandom(51);
    for (let i = 0; i < PAIRS; i++) {
      const end = onCone(random.between(-1, 1), random.between(0, 7));
      for (const path of [surface.shortestPath([0, 0, 0], end), surface.shortestPath(end, [0, 0, 0])]) {
        assert.equal(path.status, 'converged');
        close(path.length, norm(end));
      }
    }
    const { status, length } = surface.shortestPath([0, 0, 0], [0, 0, 0]);
    assert.deepEqual([status, length], ['converged', 0]);
  });

  test('from beside the apex, however near, to the other half', () => {
    for (let beside = 1e-3; beside > 1e-14; beside /= 10) {
      const { status, length } = surface.shortestPath([beside, 0, beside], [1, 0, -1]);
      assert.equal(status, 'converged', `${beside}`);
      assert.ok(Math.abs(length - Math.SQRT2 * (1 + beside)) < 1e-10, `${beside}: ${length}`);
    }
  });

  for (const { name, other } of [
    { name: 'within bounds', other: surface },
    { name: 'without bounds', other: surfpath.implicit({ f: cone.f }) },
    { name: 'turned and moved, its apex no round number', other: null },
  ])
    test(`from one half to the other, ${name}: through the apex, as long as both slants`, () => {
      const [c, s] = [Math.cos(0.7), Math.sin(0.7)];
      const turned = `((x - 0.1)*${c} + (z - 1/3)*${s})^2 + (y - 0.2)^2 - ((z - 1/3)*${c} - (x - 0.1)*${s})^2`;
      const place = (/** @type {number[]} */ [x, y, z]) => (other ? [x, y, z] : [0.1 + c * x - s * z, 0.2 + y, 1 / 3 + s * x + c * z]);
      const own = other ?? surfpath.implicit({ f: turned, bounds: within(3) });
      const random = createRandom(53);
      for (let i = 0; i < PAIRS / 2; i++) {
        const ends = [onCone(random.between(0.01, 1), random.between(0, 7)), onCone(random.between(-1, -0.01), random.between(0, 7))];
        const [from, to] = ends.map(place);
        const path = own.shortestPath(from, to);
        assert.equal(path.status, 'converged');
        close(path.length, norm(ends[0]) + norm(ends[1]));
        const back = own.shortestPath(to, from);
        assert.equal(back.length, path.length);
        for (let k = 0; k < path.points.length; k += 3)
          assert.deepEqual(back.points.slice(k, k + 3), path.points.slice(-3 - k, path.points.length - k));
      }
    });

  test('from a line where planes cross, where ∇f = 0, too, within one of them', () => {
    const { status, length } = surfpath.implicit({ f: 'x*y' }).shortestPath([0, 0, 0], [1, 0, 1]);
    assert.equal(status, 'converged');
    close(length, Math.SQRT2);
  });

  test('within a half: never through the apex', () => {
    const flat = surfpath.implicit({ f: 'x^2 + y^2 - 9z^2', bounds: within(2) });
    const angle = 1.5;
    const path = flat.shortestPath([1.5, 0, 0.5], [1.5 * Math.cos(angle), 1.5 * Math.sin(angle), 0.5]);
    const slant = Math.hypot(1.5, 0.5);
    close(path.length, 2 * slant * Math.sin(((angle / 2) * 1.5) / slant));
  });

  test('as the other methods say it, and as the parameters move it', () => {
    const [from, to] = [onCone(1, 0), onCone(-0.5, 2)];
    const path = surface.shortestPath(from, to);
    assert.equal(surface.lengths([...from, ...to])[0], path.length);
    assert.deepEqual(surface.geodesics(from, to), [path]);
    assert.equal(surface.shortestPath(from, to, { points: 1 }).points.length, 9);
    const moved = surfpath.implicit({ ...cone, f: 'x^2 + y^2 - (z - c)^2', parameters: { c: 0 } });
    close(moved.shortestPath(from, to).length, path.length);
    moved.set({ c: 0.5 });
    close(moved.shortestPath([1, 0, 1.5], [0, 0.5, 0]).length, Math.SQRT2 * 1.5);
    const stretched = surfpath.implicit(anything({ ...cone, metric: { xx: 4, xy: 0, xz: 0, yy: 1, yz: 0, zz: 1 } }));
    close(stretched.shortestPath(onCone(1, 0), onCone(-1, Math.PI / 2)).length, Math.sqrt(5) + Math.SQRT2);
  });

  test('distances from a point of one half reach the other', () => {
    const from = onCone(1, 0);
    for (const exact of [false, true]) {
      const { mesh, distances } = surface.distanceField(from, { resolution: ofAll(4, 12), exact });
      for (const [i, distance] of distances.entries()) {
        const at = mesh.positions.subarray(3 * i, 3 * i + 3);
        const truth = norm(from) + norm(at);
        if (at[2] < -0.3) assert.ok(Math.abs(distance / truth - 1) < (exact ? 1e-9 : 0.05), `${distance} for ${truth}`);
      }
    }
  });

  test('halves that miss each other, or are joined by a neck, are what they are', () => {
    const between = (/** @type {string} */ f) => surfpath.implicit({ ...cone, f }).shortestPath([0, 1, 1], [0.6, 0.8, -1]);
    assert.equal(between('x^2 + y^2 - z^2 + 1e-6').status, 'disconnected');
    const neck = between('x^2 + y^2 - z^2 - 1e-6');
    assert.equal(neck.status, 'converged');
    assert.ok(neck.length < 2 * Math.SQRT2 && neck.length > 2 * Math.SQRT2 - 0.01);
  });
});

test('a lemniscate, revolved: from one lobe to the other, also straight on through the node, where curved legs tell roughly how they lead there', () => {
  const surface = surfpath.implicit({ f: '(x^2 + y^2 + z^2)^2 - x^2 + y^2 + z^2', bounds: within(1.2) });
  /** ∫ dr/√(1 − r⁴), with r = sin t. @param {number} radius */
  const arc = (radius) => simpson((t) => 1 / Math.sqrt(1 + Math.sin(t) ** 2), 0, Math.asin(radius));
  const at = (/** @type {number} */ radius, /** @type {number} */ angle) => {
    const aside = Math.sqrt((1 - radius ** 2) / 2);
    return [Math.sqrt((1 + radius ** 2) / 2), aside * Math.cos(angle), aside * Math.sin(angle)].map((x) => radius * x);
  };
  for (const [one, other] of [
    [0.6, 0.93],
    [0.9, 0.5],
    [0.95, 0.93],
  ])
    for (const turn of [0, 0.02, 0.05, 0.3, 2, 3]) {
      const path = surface.shortestPath(
        at(one, 0.4),
        at(other, 0.4 + turn).map((x) => -x),
      );
      assert.equal(path.status, 'converged', `${[one, other, turn]}`);
      close(path.length, arc(one) + arc(other));
    }
  surface.dispose();
});

describe('where f is a square, or a higher power, there is no normal', () => {
  for (const f of ['(x^2+y^2+z^2-1)^2', '(x^2+y^2+z^2-1)^3', '1e9*(x^2+y^2+z^2-1)^4'])
    for (const bounds of [undefined, within(1.5)])
      test(`${f}, ${bounds ? 'within' : 'without'} bounds`, () => {
        const surface = surfpath.implicit({ f, bounds });
        const start = /** @type {const} */ ('straight');
        for (const options of [undefined, { start }, { algorithm: /** @type {const} */ ('polyline') }])
          for (const from of [
            [1, 0, 0],
            [0.6, 0.48, 0.64],
            [1.01, 0, 0],
          ])
            assert.equal(surface.shortestPath(from, [0, -0.6, 0.8], options).status, 'singular-metric', `${from}`);
        assert.equal(surface.trace([1, 0, 0], [0, 1, 0], 1).status, 'singular-metric');
      });

  test('but not on the middle of a heart, in an edge or a pinch point: there paths end', () => {
    const heart = '(x^2 + 9/4*y^2 + z^2 - 1)^3 - x^2*z^3 - 9/80*y^2*z^3';
    for (const [f, from, to] of /** @type {[string, number[], number[]][]} */ ([
      [heart, [1, 0, 0], [-1, 0, 0]],
      [heart, [0, -2 / 3, 0], [-1, 0, 0]],
      ['z^2 - x^3', [0, 0.5, 0], [1, 0, 1]],
      ['x^2 - y^2*z', [0, 0, 0], [1, 1, 1]],
      ['x^2 + y^2 - z^3', [0, 0, 0], [1, 0, 1]],
      ['x*y*z', [0, 0, 0], [1, 0, 1]],
    ]))
      assert.equal(surfpath.implicit({ f, bounds: within(2) }).shortestPath(from, to).status, 'converged', `${f}, from ${from}`);
  });

  test('nor beside the tip of a cusp, where projection comes to rest 1e-13 … 1e-8 from it: as long as from the tip', () => {
    const heart = '(x^2 + 9/4*y^2 + z^2 - 1)^3 - x^2*z^3 - 9/80*y^2*z^3';
    for (const [f, tip, to] of /** @type {[string, number[], number[]][]} */ ([
      [heart, [0, 0, 1], [0, 2 / 3, 0]],
      [heart, [0, 0, -1], [1, 0, 0]],
      ['x^2 + z^2 - y^3*(1 - y)^3', [0, 0, 0], [0, 0.5, 0.125]],
    ])) {
      const surface = surfpath.implicit({ f, bounds: within(1.5) });
      const { length } = surface.shortestPath(tip, to);
      for (const gap of [1e-12, 1e-9, 1e-4]) {
        const from = Array.from(surface.project(tip.map((c, j) => c + gap * [0.6, 0.8, -0.3][j])));
        const path = surface.shortestPath(from, to);
        assert.equal(path.status, 'converged', `${f}, from ${from}`);
        assert.ok(Math.abs(path.length - length) <= Math.hypot(...tip.map((c, j) => c - from[j])) + path.lengthError, `${f}, from ${from}`);
      }
    }
  });
});

describe('cusps that meet in a point, where second derivatives do not tell how', () => {
  /** f, shifted along x, the place at a height and an angle, and how far that is from where the cusps meet. @type {Record<string, [string, (z: number, angle: number) => number[], (z: number) => number]>} */
  const cusps = {
    'a torus without a hole': [
      '((x - c)^2 + y^2 + z^2)^2 - ((x - c)^2 + y^2)',
      (z, angle) => [(0.5 - Math.sqrt(0.25 - z * z)) * Math.cos(angle), (0.5 - Math.sqrt(0.25 - z * z)) * Math.sin(angle), z],
      (z) => 0.5 * Math.asin(2 * Math.abs(z)),
    ],
    'x² + y² = z⁴': [
      '(x - c)^2 + y^2 - z^4',
      (z, angle) => [z * z * Math.cos(angle), z * z * Math.sin(angle), z],
      (z) => (2 * Math.abs(z) * Math.sqrt(1 + 4 * z * z) + Math.asinh(2 * Math.abs(z))) / 4,
    ],
  };
  for (const [name, [f, at, away]] of Object.entries(cusps))
    for (const bounds of [undefined, within(1.4)])
      test(`${name}, ${bounds ? 'within' : 'without'} bounds: from one to the other straight through the point`, () => {
        const random = createRandom(19);
        for (let i = 0; i < ofAll(2, 6); i++) {
          const c = i % 2 ? random.between(-0.2, 0.2) : 0;
          const surface = surfpath.implicit({ f, bounds, parameters: { c } });
          const [up, down] = [random.between(0.1, 0.45), random.between(-0.45, -0.1)];
          const [from, to] = [at(up, random.between(0, 7)), at(down, random.between(0, 7))].map(([x, y, z]) => [x + c, y, z]);
          const path = surface.shortestPath(from, to);
          assert.equal(path.status, 'converged', `${from} ${to}`);
          close(path.length, away(up) + away(down), 1e-9);
        }
      });
});

test('two bowls that touch: from one to the other through that point, however the path turns there', () => {
  const bowls = surfpath.implicit({ f: 'x^2 - (y^2 + z^2)^2', bounds: within(1.4) });
  const away = (/** @type {number} */ r) => (2 * r * Math.sqrt(1 + 4 * r * r) + Math.asinh(2 * r)) / 4;
  const at = (/** @type {number} */ side, /** @type {number} */ r, /** @type {number} */ angle) => [
    side * r * r,
    r * Math.cos(angle),
    r * Math.sin(angle),
  ];
  for (const turn of [0.2, 1.4, 3]) {
    const path = bowls.shortestPath(at(1, 0.8, 0.3), at(-1, 0.5, 0.3 + turn));
    assert.equal(path.status, 'converged', `${turn}`);
    close(path.length, away(0.8) + away(0.5), 1e-9);
  }
  bowls.dispose();
});

test('sheets that meet in a point to which each coordinate leads by a power of its own: through it, as far as it is from both ends', () => {
  const calypso = surfpath.implicit({ f: 'x^2 + y^2*z - z^2', bounds: within(1.5) });
  const at = (/** @type {number} */ side, /** @type {number} */ x, /** @type {number} */ y) => [
    x,
    y,
    (y * y + side * Math.sqrt(y ** 4 + 4 * x * x)) / 2,
  ];
  for (const [from, to] of [
    [at(1, 0.5, 0.3), at(-1, -0.6, 0.4)],
    [at(1, -0.6, -0.8), at(-1, 0.3, -0.7)],
  ]) {
    const path = calypso.shortestPath(from, to);
    assert.equal(path.status, 'converged', `${from} to ${to}`);
    const legs = [from, to].map((end) => calypso.shortestPath(end, [0, 0, 0], { start: 'straight' }));
    assert.ok(legs.every(({ converged }) => converged));
    close(path.length, legs[0].length + legs[1].length, 1e-9);
  }
  calypso.dispose();
});

test('a node around which angles sum up to 4π: through it where there are π on both sides, else past it', () => {
  const dromedary = surfpath.implicit({ f: 'x^4 - 3*x^2 + y^2 + z^3', bounds: within(1.8) });
  const at = (/** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ z) => [
    x * Math.sqrt((3 - Math.sqrt(9 - 4 * (y * y + z ** 3))) / 2),
    y,
    z,
  ];
  const away = (/** @type {number[]} */ end) => dromedary.shortestPath(end, [0, 0, 0], { start: 'straight' }).length;
  const high = at(1, -0.5, 0.3);
  const low = at(1, -0.5, -0.3);
  for (const [from, to, isThrough] of /** @type {[number[], number[], boolean][]} */ ([
    [high, at(-1, 0.6, 0.2), true],
    [high, at(-1, -0.6, 0.2), true],
    [high, at(1, 0.6, 0.2), false],
    [low, at(-1, 0.6, -0.25), true],
    [low, at(-1, -0.6, -0.25), false],
    [low, at(1, 0.6, -0.25), true],
  ])) {
    const path = dromedary.shortestPath(from, to);
    assert.equal(path.status, 'converged', `${from} to ${to}`);
    if (isThrough) close(path.length, away(from) + away(to), 1e-9);
    else assert.ok(path.length < 0.95 * (away(from) + away(to)));
  }
  dromedary.dispose();
});

test('where sheets cross along lines, the point where two of these meet is no passage: across one of them it is shorter', () => {
  const surface = surfpath.implicit({ f: '6x^2 - 2x^4 - y^2*z^2', bounds: within(1.5) });
  const from = [-0.5709723468826052, -1.4826763828390788, -0.8905609328418467];
  const to = [-1.4043054102757635, 1.398480973615414, -1.4397961128459233];
  assert.ok(surface.shortestPath(from, to).length < 3.77);
});

/** All points with these coordinates, in all orders and with all signs. @param {number[][]} points */
const turns = (points) =>
  points.flatMap(([x, y, z]) =>
    [
      [x, y, z],
      [y, z, x],
      [z, x, y],
      [x, z, y],
      [z, y, x],
      [y, x, z],
    ].flatMap((p) => Array.from({ length: 8 }, (_, k) => p.map((c, j) => ((k >> j) & 1 ? -c : c)))),
  );
const [golden, root] = [(1 + Math.sqrt(5)) / 2, Math.SQRT2];

for (const { name, definition, nodes, places } of [
  { name: 'Cayley’s cubic', definition: cayley, nodes: 4, places: [[1, 1, 1]] },
  {
    name: 'Kummer’s quartic',
    definition: kummer,
    nodes: 16,
    places: [
      [0.75 * root, 0.25 * root, 0.5],
      [0.5 * root, 0, 1],
      [0.25 * root, 0, 0.25],
    ],
  },
  {
    name: 'Barth’s sextic',
    definition: barth,
    nodes: 50,
    places: [
      [1, 0, 0],
      [1, 1, 1],
      [golden, 0, golden - 1],
      [golden / 2, golden / 2 - 0.5, 0.5],
    ],
  },
])
  test(`${name}, ${nodes} nodes: all paths are found, none longer than along a mesh joined at the nodes`, () => {
    const surface = surfpath.implicit(definition);
    const isNode = (/** @type {number[]} */ at) => surface.evaluate(at).every((x) => Math.abs(x) < 1e-12);
    const found = [
      ...new Map(
        turns(places)
          .filter(isNode)
          .map((at) => [
            at
              .map((x) => x.toFixed(6))
              .join()
              .replaceAll('-0.000000', '0.000000'),
            at,
          ]),
      ).values(),
    ];
    assert.equal(found.length, nodes);
    const resolution = 72;
    const mesh = surface.mesh({ resolution });
    const cell = (definition.bounds[0][1] - definition.bounds[0][0]) / resolution;
    const random = createRandom(57);
    const count = mesh.positions.length / 3;
    const at = (/** @type {number} */ i) => Array.from(mesh.positions.subarray(3 * i, 3 * i + 3));
    for (let i = 0; i < ofAll(1, 3); i++) {
      const from = random.integer(count);
      const along = distancesAlong(mesh, from, found, cell);
      for (let k = 0; k < ofAll(3, 4); k++) {
        const to = random.integer(count);
        const path = surface.shortestPath(at(from), at(to));
        if (along[to] === Infinity) assert.equal(path.status, 'disconnected');
        else {
          assert.equal(path.status, 'converged', `${at(from)} to ${at(to)}`);
          const ratio = path.length / along[to];
          assert.ok(ratio < 1.005 && ratio > 0.95, `${ratio} times along the mesh, ${at(from)} to ${at(to)}`);
        }
      }
    }
  });

test('a point by itself is no node: paths around a tooth, in whose middle ∇f = 0', () => {
  const tooth = surfpath.implicit({ f: 'x^4 + y^4 + z^4 - x^2 - y^2 - z^2', bounds: within(1.3) });
  const random = createRandom(58);
  const place = () => tooth.project([2, random.between(-2, 2), random.between(-2, 2)]);
  for (let i = 0; i < PAIRS; i++) assert.equal(tooth.shortestPath(place(), place()).status, 'converged');
  assert.equal(tooth.shortestPath([1, 0, 0], [0, 0.999, 0.05]).status, 'converged');
  tooth.dispose();
});

describe('where little tells which nodes hang together', () => {
  const [kummer13, cayley2] = [{ ...kummer, parameters: { m: 1.3 } }, { f: 'x^2 + y^2 - x^2*z + y^2*z + z^2 - 1' }];
  /* Lengths are those that other bounds give, to 1e-9, and polylines on a mesh, to 1e-3. */
  for (const { name, definition, from, to, length } of [
    {
      name: 'legs between nodes that bounds cut off from others',
      definition: { ...barth, bounds: within(1.6) },
      ...{
        from: [-0.23623861499257567, -0.5250437061229143, -0.9308479933050055],
        to: [0.546011446029579, 0.9237366980048216, 0.17449162987523534],
      },
      length: 2.34005262970205,
    },
    {
      name: 'a piece smaller than the cells around its nodes',
      definition: { ...kummer13, bounds: within(3) },
      ...{
        from: [0.6084130848434596, 0.036616842496378726, -0.2212269985613427],
        to: [-0.7132870380380958, -1.161541801392447, 0.4858338918108149],
      },
      length: 2.09109508382114,
    },
    {
      name: 'without bounds, a piece smaller than the cells around its nodes',
      definition: { ...kummer13, bounds: undefined },
      ...{
        from: [-0.9986780045866162, -0.173766704770605, -0.6984359181852247],
        to: [0.831010898670666, 1.4430683887760005, 0.5981073336926783],
      },
      length: 3.0196742549254,
    },
    {
      name: 'without bounds, a way through nodes far from both ends',
      definition: cayley2,
      ...{
        from: [-0.37645305131471796, 0.8247979856823952, 0.2312194258866734],
        to: [-0.33686029344379814, -1.9118950477002188, -1.1648073734165794],
      },
      length: 3.60940100182616,
    },
  ])
    test(name, () => {
      const path = surfpath.implicit(anything(definition)).shortestPath(from, to);
      assert.equal(path.status, 'converged');
      close(path.length, length, 1e-9);
    });

  test('between two nodes, where f rounds more than its coordinates', () => {
    const surface = surfpath.implicit(anything({ ...kummer13, bounds: undefined }));
    const [from, to] = [
      [-9.821007251739502e-17, 0.21213203435596423, 0.15000000000000005],
      [-0.2121320343559642, 5.885074138641357e-17, -0.14999999999999988],
    ];
    for (const points of [7, 31, 63]) {
      const path = surface.shortestPath(from, to, { start: 'straight', algorithm: 'polyline', points });
      assert.equal(path.status, 'converged', `${points}`);
    }
  });
});

test('to the dent of a heart: elements that close in on a node and go astray are given up soon', (context) => {
  const heart = surfpath.implicit({ f: '(x^2 + 9/4*y^2 + z^2 - 1)^3 - x^2*z^3 - 9/80*y^2*z^3', bounds: within(1.5) });
  let moved = 0;
  const { solve } = Heap.prototype;
  /** @this {Heap} @param {Parameters<Heap['solve']>} asked */
  function counted(...asked) {
    const result = solve.apply(this, asked);
    moved += this.work;
    return result;
  }
  context.mock.method(Heap.prototype, 'solve', counted);
  const path = heart.shortestPath(heart.project([0.5, 0.3, 1.2]), [0, 0, 1]);
  assert.equal(path.status, 'converged');
  assert.ok(moved < 1e6, `nodes were moved ${moved} times, once 2,981,025`);
});
