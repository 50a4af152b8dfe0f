// Surfaces that turn within a small part of a path: a landscape of many steep hills, and bodies with a rim that is sharper than the first chords.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { load } from '../../web/index.js';
import { Heap } from '../../web/runtime/heap.js';
import { CONVERGED, STALLED } from '../../web/runtime/status.js';
import { ELEMENTS } from '../../web/search/candidates.js';
import { createRandom } from '../helpers/random.js';
import { ofAll } from '../helpers/sample.js';
import { simpson } from '../helpers/simpson.js';
import { corrugated, unroll } from '../helpers/unroll.js';
import { verifyPath } from '../helpers/verify-path.js';

const surfpath = await load();

/** What the solver is asked for, and what it answers. @param {() => void} ask */
function solvesOf(ask) {
  const { solve } = Heap.prototype;
  /** @type {{ asked: string, algorithm: number, status: number, length: number }[]} */
  const solves = [];
  Heap.prototype.solve = function (surface, request, options) {
    const result = solve.call(this, surface, request, options);
    const { status, iterations, length } = result;
    solves.push({ asked: JSON.stringify([request, options, iterations, length]), algorithm: options.algorithm, status, length });
    return result;
  };
  try {
    ask();
  } finally {
    Heap.prototype.solve = solve;
  }
  return solves;
}

/** Two tolerances of 1e-9, relative: one of each path. */
const RIGHT = 2e-9;

test('a landscape with slopes of 2.6: every path converges, to the length that polylines extrapolate to, seed 1', () => {
  const z = '0.15*sin(5*x)*cos(4*y)+0.1*sin(9*x+3*y)+0.05*cos(17*y-5*x)';
  const definition = { kind: /** @type {const} */ ('graph'), z, x: /** @type {const} */ ([-2, 2]), y: /** @type {const} */ ([-2, 2]) };
  const surface = surfpath.surface(definition);
  const random = createRandom(1);
  const point = () => [random.between(-1.9, 1.9), random.between(-1.9, 1.9)];
  let told = 0;
  for (let i = 0; i < 40; i++) {
    const [from, to] = [point(), point()];
    const path = surface.shortestPath(from, to);
    assert.equal(path.status, 'converged', `${from} to ${to}`);
    if (path.touchesBoundary) continue;
    const [half, all] = [1023, 2047].map((points) => surface.shortestPath(from, to, { algorithm: 'polyline', start: path, points }));
    assert.equal(all.status, 'converged', `${from} to ${to}, as a polyline`);
    const extrapolated = all.length + (all.length - half.length) / 3;
    assert.ok(Math.abs(path.length / extrapolated - 1) < 1e-8, `${from} to ${to}: ${path.length}, polylines ${extrapolated}`);
    told++;
  }
  assert.ok(told > 20, `${told} that touch no edge`);
});

for (const [name, z, x] of /** @type {const} */ ([
  ["Rastrigin's function at a fifth of its height, slopes of 18", '0.2*(20 + x^2 + y^2 - 10cos(2pi*x) - 10cos(2pi*y))', [-5.12, 5.12]],
  ['waves of 8 with slopes of 32', '8sin(4x)*sin(4y)', [-2, 2]],
]))
  test(`${name}: every path converges, to the length that finer elements have, seed 3`, () => {
    const surface = surfpath.graph({ z, x, y: x });
    const random = createRandom(3);
    const [low, high] = x;
    const point = () => [random.between(low, high), random.between(low, high)];
    for (let i = 0; i < ofAll(5, 16); i++) {
      const [from, to] = [point(), point()];
      const path = surface.shortestPath(from, to);
      assert.equal(path.status, 'converged', `${from} to ${to}`);
      const finer = surface.shortestPath(from, to, { start: path, tolerance: 1e-12 });
      assert.equal(finer.status, 'converged', `${from} to ${to}, finer`);
      assert.ok(Math.abs(path.length / finer.length - 1) < RIGHT, `${from} to ${to}: ${path.length}, finer ${finer.length}`);
    }
    surface.dispose();
  });

test('steep heights in a tall box: the graph of the implicit surface is as fine as hills are wide, so that its paths are those of the same graph over x and y', () => {
  const z = '(20 + x^2 + y^2 - 10cos(2pi*x) - 10cos(2pi*y))/4';
  const hills = surfpath.graph({ z, x: [-2, 2], y: [-2, 2] });
  const body = surfpath.implicit({
    f: `z - (${z})`,
    bounds: [
      [-2, 2],
      [-2, 2],
      [-0.5, 14],
    ],
  });
  for (const [from, to] of [
    [
      [-1.256, 1.579],
      [1.579, -0.454],
    ],
    [
      [1.698, -0.947],
      [-1.136, -1.789],
    ],
    [
      [0.508, -1.989],
      [0.11, 1.924],
    ],
    [
      [-0.787, 1.576],
      [-0.84, -1.425],
    ],
  ]) {
    const over = hills.shortestPath(from, to);
    const path = body.shortestPath(over.points.slice(0, 3), over.points.slice(-3));
    assert.equal(path.status, 'converged', `${from} to ${to}`);
    assert.ok(path.length < over.length * (1 + RIGHT), `${from} to ${to}: ${path.length}, over x and y ${over.length}`);
  }
  body.dispose();
  hills.dispose();
});

const POINTS = 65535;
/** Test functions of optimisation, half the side of a square, and ends whose path is pressed onto edges of it. @type {[string, string, number, number[], number[]][]} */
const pressed = [
  ["Booth's", '(x + 2y - 7)^2 + (2x + y - 5)^2', 10, [0.442, -8.062], [2.212, 9.18]],
  ["Booth's", '(x + 2y - 7)^2 + (2x + y - 5)^2', 10, [-7.05, 3.62], [2.54, 9.95]],
  ["the camel's", '2x^2 - 1.05x^4 + x^6/6 + x*y + y^2', 5, [0.66, 4.56], [-2.7, -4.4]],
  ["Bohachevsky's", 'x^2 + 2y^2 - 0.3cos(3pi*x) - 0.4cos(4pi*y) + 0.7', 5, [1.73, 4.18], [0.97, -3.45]],
];
for (const [name, z, side, from, to] of pressed)
  test(`${name} function, from ${from} to ${to}: along edges, as long as its chords, as finer elements say, and no longer than ways by other places`, () => {
    const surface = surfpath.graph({ z, x: [-side, side], y: [-side, side] });
    const path = surface.shortestPath(from, to, { points: POINTS });
    assert.ok(path.converged && path.touchesBoundary, `${path.status}`);
    let chords = 0;
    for (let i = 3; i < path.points.length; i += 3)
      chords += Math.hypot(...[0, 1, 2].map((k) => path.points[i + k] - path.points[i + k - 3]));
    /* Where it turns within a chord they are shorter by half of one at most. */
    const shorter = 1 - chords / path.length;
    assert.ok(shorter > -1e-12 && shorter < 0.5 / POINTS, `${path.length}, chords ${chords}`);
    const finer = surface.shortestPath(from, to, { start: path, tolerance: 1e-11 });
    assert.ok(finer.converged && Math.abs(path.length / finer.length - 1) < RIGHT, `${path.length}, finer ${finer.length}`);
    let solved = 0;
    for (let k = 1; k <= 8; k++) {
      const place = [0.754877, 0.569841].map((step) => side * (2 * ((k * step) % 1) - 1));
      const { converged, length } = surface.shortestPath(from, to, { via: [place], start: 'straight', tolerance: 1e-6 });
      assert.ok(!converged || length > path.length * (1 - 1e-6), `by ${place}: ${length}, not ${path.length}`);
      solved += Number(converged);
    }
    assert.ok(solved > 0);
    surface.dispose();
  });

test("Rosenbrock's function, across its valley where that is highest, at an edge: no longer than 28 ways along slopes to other places of it", () => {
  const surface = surfpath.graph({ z: '(1 - x)^2 + 100(y - x^2)^2', x: [-2, 2], y: [-2, 2] });
  const ends = [
    [0.69, 1.67],
    [0.39, -1.38],
  ];
  const path = surface.shortestPath(ends[0], ends[1]);
  assert.ok(path.converged && path.touchesBoundary, path.status);
  const height = (/** @type {number[]} */ [x, y]) => (1 - x) ** 2 + 100 * (y - x * x) ** 2;
  /* From an end down to the valley at x = to, as fast as it goes aside. */
  const leg = (/** @type {number[]} */ [x, y], /** @type {number} */ to) => {
    const places = Array.from({ length: 4001 }, (_, i) => {
      const at = x + ((to - x) * i) / 4000;
      return [at, at * at + (y - x * x) * (1 - i / 4000)];
    });
    let sum = 0;
    for (let i = 1; i < places.length; i++) {
      const [a, b] = [places[i - 1], places[i]];
      sum += Math.hypot(b[0] - a[0], b[1] - a[1], height(b) - height(a));
    }
    return sum;
  };
  const ways = Array.from({ length: 28 }, (_, k) => ends.reduce((sum, end) => sum + leg(end, 0.1 * k - 1.4), 0));
  assert.ok(path.length < Math.min(...ways), `${path.length}, ${Math.min(...ways)}`);
  surface.dispose();
});

test('waves whose crests paths ride to an edge: 255 chords stall, and all of 8 converge to what polylines extrapolate to, seed 6', () => {
  const surface = surfpath.graph({ z: 'sin(6x) + 0.3y^2', x: [-4, 4], y: [-1, 1] });
  const random = createRandom(6);
  for (let i = 0; i < 8; i++) {
    const [from, to] = [random.between(0.5, 2.5), random.between(-3, -1)].map((x) => [x, random.between(-0.9, 0.9)]);
    const path = surface.shortestPath(from, to);
    assert.ok(path.converged && path.touchesBoundary, `${from} to ${to}: ${path.status}`);
    const polylines = (/** @type {any} */ start) => {
      const [half, all] = [2047, 4095].map((points) =>
        surface.shortestPath(from, to, { algorithm: 'polyline', points, maxIterations: 300, start }),
      );
      assert.ok(all.converged, `${from} to ${to}, as a polyline: ${all.status}`);
      return all.length + (all.length - half.length) / 3;
    };
    const [same, straight] = [polylines(path), polylines('straight')];
    assert.ok(Math.abs(path.length / same - 1) < 1e-6, `${from} to ${to}: ${path.length}, polylines ${same}`);
    assert.ok(path.length < straight * (1 + 1e-6), `${from} to ${to}: ${path.length}, from the straight line ${straight}`);
  }
  surface.dispose();
});

test('land of many scales, waves shorter than three cells of the first graph: none of 16 bent starts leads to a shorter path, seed 5', () => {
  const waves = [
    'sin(x + 0.3)*cos(1.3y)',
    '0.6sin(2.1x + 1)*cos(2.3y - x)',
    '0.35sin(4.3x + y)*cos(4.7y)',
    '0.2sin(9.1x - 3y)*cos(8.3y + x)',
    '0.1sin(19x)*cos(17y + 2x)',
  ];
  const surface = surfpath.graph({ z: waves.join(' + '), x: [-4, 4], y: [-4, 4] });
  const random = createRandom(5);
  const point = () => [random.between(-4, 4), random.between(-4, 4)];
  const [from, to] = [
    [-2.746, 3.884],
    [2.425, -3.662],
  ];
  const path = surface.shortestPath(from, to);
  assert.equal(path.status, 'converged');
  let compared = 0;
  for (let i = 0; i < 16; i++) {
    const bends = i % 3 ? point() : [...point(), ...point()];
    const { converged, length } = surface.shortestPath(from, to, { start: [...from, ...bends, ...to], tolerance: 1e-6 });
    assert.ok(!converged || path.length <= length * (1 + 2e-6), `${path.length}, by ${bends} ${length}`);
    compared += Number(converged);
  }
  assert.ok(compared > 8, `${compared} that converge`);
  surface.dispose();
});

test('across a line where a formula has no derivative, but the surface a tangent plane: as unrolled, seed 3', () => {
  const random = createRandom(3);
  const point = () => [random.between(-1, 1), random.between(-1, 1)];
  /* Over z, on which x = z^3 depends smoothly. */
  const along = (/** @type {number} */ x) => simpson((z) => Math.sqrt(1 + 9 * z ** 4), 0, Math.cbrt(x), 4000);
  const surface = surfpath.graph({ z: 'cbrt(x)', x: [-1, 1], y: [-1, 1] });
  for (let i = 0; i < 40; i++) {
    const [from, to] = [point(), point()];
    const truth = Math.hypot(along(to[0]) - along(from[0]), to[1] - from[1]);
    for (const start of /** @type {const} */ (['global', 'straight'])) {
      const path = surface.shortestPath(from, to, { start });
      assert.equal(path.status, 'converged', `${from} to ${to}, ${start}`);
      assert.ok(Math.abs(path.length / truth - 1) < RIGHT, `${from} to ${to}: ${path.length}, not ${truth}`);
    }
  }
});

test('where it is torn no path converges across', () => {
  for (const z of ['atan(1/x)', 'x + floor(2x + 2y)/5']) {
    const surface = surfpath.graph({ z, x: [-1, 1], y: [-1, 1] });
    for (const start of /** @type {const} */ (['global', 'straight']))
      assert.equal(surface.shortestPath([-0.6, -0.32], [0.5, 0.41], { start }).converged, false, `${z}, ${start}`);
  }
});

test('a torus whose density has waves: paths that speed up and slow down along them, as long as polylines extrapolate to, seed 3', () => {
  const [x, y] = ['(3 + cos(v))*cos(u)', '(3 + cos(v))*sin(u)'];
  const density = '1.5 + sin(7x)*cos(7y)';
  const surface = surfpath.parametric({ x, y, z: 'sin(v)', u: [0, '2pi'], v: [0, '2pi'], density });
  const random = createRandom(3);
  const point = () => [random.between(0, 6), random.between(0, 6)];
  for (let i = 0; i < ofAll(4, 12); i++) {
    const [from, to] = [point(), point()];
    const path = surface.shortestPath(from, to);
    assert.equal(path.status, 'converged', `${from} to ${to}`);
    assert.ok(path.iterations < 100, `${from} to ${to}: ${path.iterations} steps`);
    const [half, all] = [2047, 4095].map((points) => surface.shortestPath(from, to, { algorithm: 'polyline', start: path, points }));
    const extrapolated = all.length + (all.length - half.length) / 3;
    assert.ok(Math.abs(path.length / extrapolated - 1) < 1e-7, `${from} to ${to}: ${path.length}, polylines ${extrapolated}`);
  }
});

test('two thin walls of density with a gap each: between few nodes they are not seen, and the error says so; the path leads through the gaps', () => {
  const wall = (/** @type {string} */ u, /** @type {string} */ gap) => `exp(-100*(${u})^2)*(1 - exp(-30*(${gap})^2))`;
  const density = `1 + 30*(${wall('u + 1', 'v - 2.5')} + ${wall('u - 1', 'v + 2.5')})`;
  const surface = surfpath.parametric({ x: 'u', y: 'v', z: 0, u: [-4, 4], v: [-4, 4], density });
  const [from, to] = [
    [-2.5, 0],
    [2.5, 0],
  ];
  const path = surface.shortestPath(from, to);
  assert.equal(path.status, 'converged');
  const [half, all] = [2047, 4095].map((points) => surface.shortestPath(from, to, { algorithm: 'polyline', start: path, points }));
  const extrapolated = all.length + (all.length - half.length) / 3;
  assert.ok(Math.abs(path.length / extrapolated - 1) < 1e-7, `${path.length}, polylines ${extrapolated}`);
  assert.equal(surface.geodesics(from, to)[0].length, path.length);
  for (const points of [31, 63]) {
    const rough = surface.shortestPath(from, to, { algorithm: 'polyline', start: 'straight', points });
    assert.ok(rough.length + rough.lengthError > path.length, `${points}: ${rough.length} ± ${rough.lengthError}, for ${path.length}`);
  }
});

test('a sphere by Mercator, given by E, F and G alone: great circles, also near its poles, seed 4', () => {
  const surface = surfpath.metric({ E: '1/cosh(v)^2', F: 0, G: '1/cosh(v)^2', u: [0, '2pi'], v: [-9, 9], periodic: { u: true } });
  const random = createRandom(4);
  const onSphere = (/** @type {number[]} */ [u, v]) => [Math.cos(u) / Math.cosh(v), Math.sin(u) / Math.cosh(v), Math.tanh(v)];
  for (let i = 0; i < 20; i++) {
    const from = [random.between(0, 4), random.between(-7, 7)];
    const to = [from[0] + random.between(0.5, 1), random.between(-7, 7)];
    const [p, q] = [onSphere(from), onSphere(to)];
    const angle = 2 * Math.asin(Math.hypot(...p.map((x, k) => x - q[k])) / 2);
    const path = surface.shortestPath(from, to);
    assert.ok(path.converged && Math.abs(path.length - angle) < 1e-12, `${from} to ${to}: ${path.status} ${path.length}, not ${angle}`);
    assert.ok(path.iterations < 20, `${from} to ${to}: ${path.iterations} steps`);
  }
});

for (const steepness of [5, 20, 40])
  test(`rays through a layer of ${1 / steepness}: refracted as Snell's law says, seed 3`, () => {
    const density = (/** @type {number} */ v) => 1.5 + 0.5 * Math.tanh(steepness * v);
    const surface = surfpath.parametric({
      x: 'u',
      y: 'v',
      z: '0',
      u: [-5, 5],
      v: [-3, 3],
      density: '1.5+0.5*tanh(k*v)',
      parameters: { k: steepness },
    });
    const random = createRandom(3);
    const point = (/** @type {number} */ side) => [random.between(-2, 2), side * random.between(0.5, 2.5)];
    for (let i = 0; i < 12; i++) {
      const [from, to] = [point(-1), point(1)];
      const path = surface.shortestPath(from, to, { points: 400 });
      assert.equal(path.status, 'converged', `${from} to ${to}`);
      // Where a ray crosses lines of equal density, density times the sine of its angle to their normal stays the same: so does its mean over a chord.
      const places = /** @type {Float64Array} */ (path.parameters);
      const invariants = [];
      for (let k = 0; k + 3 < places.length; k += 2) {
        const [u, v] = [places[k + 2] - places[k], places[k + 3] - places[k + 1]];
        const [low, high] = [density(places[k + 1]), density(places[k + 3])];
        if (Math.abs(high - low) < 0.001) invariants.push(((low + high) / 2) * (u / Math.hypot(u, v)));
      }
      assert.ok(invariants.length > 100);
      const spread = Math.max(...invariants) - Math.min(...invariants);
      // What the mean of a chord's ends may be wrong by, a tenth of how they may differ.
      assert.ok(spread < 1e-4, `${from} to ${to}: density times sine from ${Math.min(...invariants)} to ${Math.max(...invariants)}`);
    }
  });

for (const height of [0.2, 0.1])
  test(`an ellipsoid of half axes 3, 2 and ${height}: a formula in x, y, z finds what one in u and v finds, seed 2`, () => {
    const body = surfpath.implicit({
      f: 'x^2/9 + y^2/4 + (z/c)^2 - 1',
      bounds: [
        [-3.2, 3.2],
        [-2.2, 2.2],
        [-2 * height, 2 * height],
      ],
      parameters: { c: height },
    });
    const chart = surfpath.parametric({
      x: '3*sin(v)*cos(u)',
      y: '2*sin(v)*sin(u)',
      z: 'c*cos(v)',
      u: [0, 2 * Math.PI],
      v: [0, Math.PI],
      parameters: { c: height },
    });
    const random = createRandom(2);
    let around = 0;
    for (let i = 0; i < ofAll(12, 24); i++) {
      const ends = [0, 1].map(() => [random.between(0, 2 * Math.PI), Math.acos(random.between(-1, 1))]);
      const [from, to] = ends.map((end) => Array.from(chart.evaluate(end).subarray(0, 3)));
      const path = body.shortestPath(from, to);
      const other = chart.shortestPath(ends[0], ends[1]);
      assert.ok(['converged', 'tolerance-not-met'].includes(path.status), `${from} to ${to}: ${path.status}`);
      if (!path.converged || !other.converged) continue;
      assert.ok(
        Math.abs(path.length - other.length) <= RIGHT * other.length,
        `${from} to ${to}: ${path.length}, in u and v ${other.length}`,
      );
      if (from[2] * to[2] < 0) around++;
    }
    assert.ok(around >= ofAll(4, 8), `${around} around the rim`);
  });

test('a body of which every edge is sharp: its path is a geodesic', () => {
  const definition = {
    kind: 'implicit',
    f: 'x^2/9 + y^2/4 + z^2/0.01 - 1',
    bounds: [
      [-3.2, 3.2],
      [-2.2, 2.2],
      [-0.2, 0.2],
    ],
  };
  const surface = surfpath.surface(/** @type {any} */ (definition));
  const path = surface.shortestPath([0.94335, 0.27668, 0.093914], [2.4566, -0.14333, -0.056947], { points: 2000 });
  assert.equal(path.status, 'converged');
  assert.deepEqual(verifyPath(/** @type {any} */ (definition), path, { lengthTolerance: 1e-3 }), []);
});

const manyWaves = '0.3*sin(3*x+1)*cos(2*y)+0.2*sin(7*x-2*y)+0.1*cos(5*y+3*x)+0.05*sin(11*y)';
const strip = '0.16*sin(3.66*x+4.51)*cos(3.24*y+3.53)+0.36*sin(2.03*x+5.21)*cos(2.61*y+1.75)+0.25*sin(2.93*x+3.51)*cos(1.31*y+2.47)';

test('where rough lengths are wrong by more than paths differ, it is the shortest of those that were solved', () => {
  for (const [z, x, y, from, to, length] of /** @type {const} */ ([
    [manyWaves, [-3, 3], [-3, 3], [-2.6317, 0.8479], [2.074, 0.221], 6.259647587],
    [manyWaves, [-3, 3], [-3, 3], [-2.3771, -0.5774], [2.074, 0.221], 5.689741297],
    [manyWaves, [-3, 3], [-3, 3], [-2.0057, 1.2822], [1.7174, -1.5751], 5.954437265],
    ['2*sin(2*x)*sin(2*y)', [-4, 4], [-4, 4], [0.35, -3.72], [-2.37, 1.86], 8.580796217],
    [strip, [0, 25], [0, 3], [22.183, 1.222], [4.485, 1.951], 18.679121201],
    [strip, [0, 25], [0, 3], [22.856, 1.052], [5.721, 2.035], 18.174996939],
  ])) {
    const surface = surfpath.graph({ z, x, y });
    const path = surface.shortestPath(from, to);
    assert.equal(path.status, 'converged');
    assert.ok(path.length < length + 1e-8, `${from} to ${to}: ${path.length}, there is one of ${length}`);
    /* From other starts, so not to the bit. */
    assert.ok(path.length <= surface.geodesics(from, to)[0].length * (1 + 1e-12), `${path.length}`);
    surface.dispose();
  }
});

test('a way that looked shortest and is not solved does not stand before one that is, where a fine polyline tells that it is longer', () => {
  const density = '2-1.8*exp(-40*(v-sin(u))^2)';
  const surface = surfpath.parametric({ x: 'u', y: 'v', z: 0, u: [-3, 3], v: [-3, 3], density });
  const path = surface.shortestPath([2.799579775, -2.073769796], [-0.987253825, -1.591489941]);
  assert.equal(path.status, 'converged');
  assert.ok(Math.abs(path.length - 6.371262562) < 1e-8, `${path.length}`);
});

test('an implicit surface without bounds, with details smaller than the first cells: as short as its graph', () => {
  for (const [z, from, to] of /** @type {const} */ ([
    [manyWaves, [-2.7883, 0.3743, -0.335275322], [1.5748, -0.5249, -0.199912056]],
    ['sin(2*x)*sin(2*y)', [-3.8, -0.1041, 0.200068132], [2.5687, -3.0179, -0.223084676]],
  ])) {
    const path = surfpath.implicit({ f: `z - (${z})` }).shortestPath(from, to);
    const { length } = surfpath.graph({ z, x: [-4, 4], y: [-4, 4] }).shortestPath(from.slice(0, 2), to.slice(0, 2));
    assert.ok(path.length < length + 1e-6, `${path.length}, not ${length}`);
  }
});

test('corrugated iron, 26 waves with slopes of 4: every path is as long as unrolled, seed 5', () => {
  const surface = surfpath.graph({ z: '0.2*sin(20*x)', x: [-2, 2], y: [-2, 2] });
  const random = createRandom(5);
  for (let i = 0; i < ofAll(10, 30); i++) {
    const [from, to] = Array.from({ length: 2 }, () => [random.between(-2, 2), random.between(-2, 2)]);
    const path = surface.shortestPath(from, to);
    assert.equal(path.status, 'converged', `${from} to ${to}`);
    const length = unroll(corrugated(20, 4), [from, to], 4000);
    assert.ok(Math.abs(path.length / length - 1) < RIGHT, `${from} to ${to}: ${path.length}, not ${length}`);
  }
});

test('half axes 20, 20 and 1: chords that cut through the body lead nowhere, what passes the pole is solved to the end', () => {
  const body = surfpath.parametric({ x: '20sin(v)cos(u)', y: '20sin(v)sin(u)', z: 'cos(v)', u: [0, '2pi'], v: [0, 'pi'] });
  const path = body.shortestPath([1.780235837034216, 0.36651914291880916], [1.9896753472735356, 3.089232776029963]);
  // As the implicit form, and elements from 1,000 chords, have it.
  assert.ok(path.converged && Math.abs(path.length / 32.00172170121 - 1) < RIGHT, `${path.status} ${path.length}`);
});

test('half axes 3, 3 and 0.2, ends nearly opposite through the body: where no chords hold that are longer than the rim is sharp, E, F and G lead around it', () => {
  const body = surfpath.parametric({ x: '3cos(u)cos(v)', y: '3sin(u)cos(v)', z: '0.2sin(v)', u: [0, '2pi'], v: ['-pi/2', 'pi/2'] });
  const path = body.shortestPath([1, -1.3], [1 + Math.PI + 0.1, 1.3]);
  // As elements have it from 3,000 chords.
  assert.ok(path.converged && Math.abs(path.length / 6.040415879733 - 1) < RIGHT, `${path.status} ${path.length}`);
});

test('half axes 3, 3 and 0.1: a path given as start is found again, of however many points', () => {
  const body = surfpath.parametric({ x: '3cos(u)cos(v)', y: '3sin(u)cos(v)', z: '0.1sin(v)', u: [0, '2pi'], v: ['-pi/2', 'pi/2'] });
  const ends = /** @type {const} */ ([
    [3.72404526013881, 1.183720142720267],
    [3.2150153271309723, -0.9687466478039995],
  ]);
  const path = body.shortestPath(...ends);
  assert.equal(path.status, 'converged');
  for (const points of [64, 250, 2000]) {
    const again = body.shortestPath(...ends, { start: body.shortestPath(...ends, { points }) });
    assert.ok(again.converged && Math.abs(again.length / path.length - 1) < RIGHT, `${points}: ${again.status} ${again.length}`);
  }
});

test('a twisted tube of half axes 2 and 0.2: what rough chords lead to in too many steps, finer ones do', () => {
  const [x, y] = ['cos(.8v)*2cos(u) - sin(.8v)*.2sin(u)', 'sin(.8v)*2cos(u) + cos(.8v)*.2sin(u)'];
  const tube = surfpath.parametric({ x, y, z: 'v', u: [0, '2pi'], v: [-4, 4] });
  const path = tube.shortestPath([3.168683043142399, 1.0598910441622147], [0.6129039571922414, -2.8155434338375924]);
  assert.ok(path.converged && Math.abs(path.length / 6.04374011770085 - 1) < RIGHT, `${path.status} ${path.length}`);
});

test('waves with slopes of 8: no path is longer than what the straight line leads to, seed 6', () => {
  const random = createRandom(6);
  const pairs = [{ z: '0.999*sin(10.72x+2.81)*cos(12.71y)', from: [0.612, -0.72], to: [0.26, -0.13] }];
  while (pairs.length < ofAll(6, 16)) {
    const [k, l] = [random.between(4, 13), random.between(4, 13)];
    const place = () => [random.between(-1, 1), random.between(-1, 1)];
    pairs.push({ z: `${8 / Math.max(k, l)}*sin(${k}x + ${random.between(0, 6)})*cos(${l}y)`, from: place(), to: place() });
  }
  for (const { z, from, to } of pairs) {
    const waves = surfpath.graph({ z, x: [-1, 1], y: [-1, 1] });
    const [path, straight] = [waves.shortestPath(from, to), waves.shortestPath(from, to, { start: 'straight' })];
    const isLonger = straight.converged && path.length > straight.length + path.lengthError + straight.lengthError;
    assert.ok(!isLonger, `${z} from ${from} to ${to}: ${path.status} ${path.length}, straight ${straight.length}`);
    waves.dispose();
  }
});

test('egg boxes of slopes 6 to 7, among whose bumps ways are many: none is shorter than the path, by bent starts either', () => {
  /** Height and wave number, the ends, and a place that the start of a path leads over: these had been shorter by one to two per cent. @type {[number, number, number[], number[], number[]][]} */
  const boxes = [
    [
      0.894,
      6.246,
      [-0.9835246838629246, -0.48013504315167665],
      [0.1615698467940092, 1.993506689555943],
      [0.06987343309447169, 1.7286973854061216],
    ],
    [1.041, 6.914, [0.9915124531835318, -1.7895927904173732], [-0.9951975867152214, 1.6812447374686599], [0, 0]],
    [1.041, 6.914, [-0.564333213493228, -1.7979179238900542], [1.612008798867464, 1.8902067570015788], [0.5, 0]],
  ];
  for (const [height, waves, from, to, over] of boxes) {
    const surface = surfpath.graph({ z: `${height}*sin(${waves}*x)*cos(${waves}*y)`, x: [-2, 2], y: [-2, 2] });
    const path = surface.shortestPath(from, to);
    assert.equal(path.status, 'converged');
    for (const start of [/** @type {const} */ ('straight'), [...from, ...over, ...to]]) {
      const { length } = surface.shortestPath(from, to, { start });
      assert.ok(path.length <= length * (1 + RIGHT), `${from} to ${to}: ${path.length}, from ${start} ${length}`);
    }
  }
});

/** Test functions as steep as they stand, ends, and places that a way leads through which is shorter than what is found without lines of equal height. */
for (const [name, z, side, from, to, via] of /** @type {[string, string, number, number[], number[], number[][]][]} */ ([
  [
    "Rastrigin's",
    '20 + x^2 + y^2 - 10cos(2pi*x) - 10cos(2pi*y)',
    5.12,
    [3.14, 2.64],
    [-0.44, -4.06],
    // biome-ignore format: places
    [[3.43, 1.9], [3.59, 1.14], [4.34, 0.93], [4.36, 0.06], [4.26, -0.81], [3.73, -1.24], [3.26, -1.73], [2.95, -2.55], [2.16, -3.33], [1.28, -3.27], [1.29, -4.16], [0.42, -4.07]],
  ],
  [
    'peaks, a hundred times as high,',
    '100(3(1 - x)^2*exp(-x^2 - (y + 1)^2) - 10(x/5 - x^3 - y^5)*exp(-x^2 - y^2) - exp(-(x + 1)^2 - y^2)/3)',
    3,
    [-2.92, 1.9],
    [2.92, 2.7],
    // biome-ignore format: places
    [[-1.64, 1.34], [-0.76, 0.77], [-0.86, -0.18], [-1.84, -1.12], [-2.06, -2.17], [-1.01, -1.54], [0.26, -0.74], [1.06, -0.99], [2.42, -1.49], [3, -0.13], [2.95, 0.8], [2.82, 1.57]],
  ],
]))
  test(`${name} function, from ${from} to ${to}: no longer than a way along lines of equal height`, () => {
    const surface = surfpath.graph({ z, x: [-side, side], y: [-side, side] });
    const path = surface.shortestPath(from, to);
    const way = surface.shortestPath(from, to, { via, start: 'straight' });
    assert.ok(way.converged, `${way.status}`);
    assert.ok(path.length + path.lengthError < way.length, `${path.status}, ${path.length} ± ${path.lengthError}, the way ${way.length}`);
    surface.dispose();
  });

test("Rosenbrock's function: a path that is locally shortest, where a way across the valley at its far end is 1 % shorter, is not taken for the shortest", () => {
  const surface = surfpath.graph({ z: '(1 - x)^2 + 100(y - x^2)^2', x: [-2, 2], y: [-2, 2] });
  const { converged, length } = surface.shortestPath([1.13, 1.82], [1.31, -1.06]);
  assert.ok(length < (converged ? 792.06 : 793), `${length}`);
  surface.dispose();
});

test('where a net leads to a path no elements are solved from chords that stall', () => {
  const surface = surfpath.graph({ z: '20 + x^2 + y^2 - 10cos(2pi*x) - 10cos(2pi*y)', x: [-5.12, 5.12], y: [-5.12, 5.12] });
  const solves = solvesOf(() => assert.ok(surface.shortestPath([-4.15, 3.36], [-4.3, -4.59]).converged));
  const stalled = solves.filter(({ algorithm, status }) => algorithm === ELEMENTS && status === STALLED).length;
  assert.equal(stalled, 0, 'three, of 400 steps each, were most of the search');
  surface.dispose();
});

test('a path that comes to where another one was raised from is not raised again', () => {
  const surface = surfpath.graph({ z: '30cos(3sqrt(x^2 + y^2 + 0.01))', x: [-4, 4], y: [-4, 4] });
  const [from, to] = [
    [-2.795387864112854, -2.8528351224958897],
    [2.99929591268301, -3.1166963800787926],
  ];
  const solves = solvesOf(() => assert.ok(surface.shortestPath(from, to).converged));
  const raised = solves.filter(({ algorithm, asked, status }) => algorithm === ELEMENTS && status === CONVERGED && asked.length > 1e5);
  const paths = new Set(raised.map(({ length }) => length.toPrecision(8))).size;
  /* From each of two lower heights one path is met, and the shortest is solved as it was asked for. */
  assert.ok(paths > 5 && raised.length - paths <= 3, `${raised.length} solves of ${paths} paths`);
  surface.dispose();
});

test('a steep plane, and a steep saddle: geodesics are unique there, so nothing else is looked for', () => {
  for (const z of ['5x', '50x + 3y', '2(x^2 - y^2)']) {
    const surface = surfpath.graph({ z, x: [-2, 2], y: [-2, 2] });
    const path = surface.shortestPath([-1.8, 0.6], [1.4, -1.2]);
    assert.equal(path.status, 'converged', z);
    const solves = solvesOf(() => surface.shortestPath([-1.8, 0.5], [1.4, -1.2]));
    assert.ok(solves.length <= 3, `${z}: ${solves.length} solves`);
    surface.dispose();
  }
});

test('across a smooth dear band: by Snell, where chords of few points leave all ways as long as each other', () => {
  for (const [height, narrow] of [
    [1000, 10],
    [500, 30],
    [300, 10],
  ]) {
    const density = (/** @type {number} */ x) => 1 + height * Math.exp(-narrow * x * x);
    const surface = surfpath.parametric({
      ...{ x: 'u', y: 'v', z: 0, u: [-2, 2], v: [-2, 2] },
      density: `1 + ${height}exp(-${narrow}x^2)`,
    });
    /* Where ρ sin θ = c everywhere, y changes by ∫ c / √(ρ² − c²) dx. */
    const over = (/** @type {(rho: number) => number} */ of) => simpson((x) => of(density(x)), -1, 1.5, 20000);
    let [low, high] = [0, Math.min(density(-1), density(1.5))];
    for (let halving = 0; halving < 60; halving++) {
      const c = (low + high) / 2;
      if (over((rho) => c / Math.sqrt(rho * rho - c * c)) < 0.7) low = c;
      else high = c;
    }
    const exact = over((rho) => (rho * rho) / Math.sqrt(rho * rho - low * low));
    const path = surface.shortestPath([-1, 0.3], [1.5, -0.4]);
    assert.ok(path.converged, `${height}, ${narrow}: ${path.status}`);
    assert.ok(Math.abs(path.length - exact) < 1e-9 * exact, `${height}, ${narrow}: ${path.length} ${exact}`);
    surface.dispose();
  }
});
