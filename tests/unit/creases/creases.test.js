// Surfaces with creases, across which derivatives jump: no wrong path is called converged, and lengthError says how wrong. What is exact is known by unfolding.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { load } from '../../../web/index.js';
import { createRandom } from '../../helpers/random.js';
import { ofAll } from '../../helpers/sample.js';
import { simpson } from '../../helpers/simpson.js';

const surfpath = await load();
const PAIRS = 24;
/** Two tolerances of 1e-9, relative. */
const RIGHT = 2e-9;

/** z of folded planes over x, what z is at both sides of each fold, and the folds. @type {[string, (x: number) => number, number[]][]} */
const FOLDED = [
  ['max(0, x)', (x) => Math.max(0, x), [0]],
  ['max(0, x - 0.3)', (x) => Math.max(0, x - 0.3), [0.3]],
  ['0.1*abs(x)', (x) => 0.1 * Math.abs(x), [0]],
  ['0.3*abs(x)', (x) => 0.3 * Math.abs(x), [0]],
  ['0.7*abs(x)', (x) => 0.7 * Math.abs(x), [0]],
  ['abs(x - 0.123)', (x) => Math.abs(x - 0.123), [0.123]],
  ['min(x, 0.2 - x)', (x) => Math.min(x, 0.2 - x), [0.1]],
  ['abs(abs(x) - 0.4)', (x) => Math.abs(Math.abs(x) - 0.4), [-0.4, 0, 0.4]],
];

for (const [z, height, folds] of FOLDED)
  test(`${z}: right, or not called converged, seed 4`, () => {
    const surface = surfpath.graph({ z, x: [-1, 1], y: [-1, 1] });
    const random = createRandom(4);
    const point = () => [random.between(-1, 1), random.between(-1, 1)];
    let [crossing, covered] = [0, 0];
    for (let i = 0; i < PAIRS; i++) {
      const [from, to] = [point(), point()];
      const [low, high] = from[0] < to[0] ? [from[0], to[0]] : [to[0], from[0]];
      const inner = folds.filter((x) => x > low && x < high);
      const stops = [low, ...inner, high];
      const along = stops.slice(1).reduce((sum, x, k) => sum + Math.hypot(x - stops[k], height(x) - height(stops[k])), 0);
      const exact = Math.hypot(along, to[1] - from[1]);
      const path = surface.shortestPath(from, to);
      if (path.touchesBoundary) continue;
      const error = Math.abs(path.length - exact);
      // Found roughly, but a path.
      assert.ok(path.points.length > 0 && error < 0.01 * exact, `${from} to ${to}: ${path.status}, ${path.length}, exact ${exact}`);
      assert.ok(!path.converged || error <= RIGHT * exact, `${from} to ${to}: ${path.length}, exact ${exact}`);
      if (inner.length === 0) assert.equal(path.status, 'converged', `${from} to ${to} crosses no fold`);
      else crossing++;
      if (inner.length > 0 && error <= path.lengthError) covered++;
    }
    assert.ok(crossing > PAIRS / 4, `only ${crossing} cross a fold`);
    assert.ok(covered >= 0.8 * crossing, `lengthError covers ${covered} of ${crossing}`);
    surface.dispose();
  });

test('a step, where the surface is torn: no path across it converges', () => {
  const stairs = surfpath.graph({ z: '0.3*floor(2x)', x: [-1, 1], y: [-1, 1] });
  assert.equal(stairs.shortestPath([0.1, -0.5], [0.4, 0.5]).status, 'converged');
  for (const to of [0.6, -0.2, -0.9]) assert.notEqual(stairs.shortestPath([0.1, -0.5], [to, 0.5]).status, 'converged');
  stairs.dispose();
  const cliff = surfpath.graph({ z: 'sign(x)', x: [-1, 1], y: [-1, 1] });
  assert.notEqual(cliff.shortestPath([-0.5, 0.1], [0.5, 0.3]).status, 'converged');
  assert.equal(cliff.shortestPath([0.1, 0.1], [0.5, 0.3]).status, 'converged');
  cliff.dispose();
});

test('the error of a polyline that crosses a crease is not that of a smooth one', () => {
  const bent = surfpath.graph({ z: 'max(0, x)', x: [-1, 1], y: [-1, 1] });
  const path = bent.shortestPath([-0.7, -0.3], [0.6, 0.8], { algorithm: 'polyline' });
  const exact = Math.hypot(0.7 + 0.6 * Math.SQRT2, 1.1);
  assert.ok(Math.abs(path.length - exact) > 1e-4, 'chords have become exact: a case for other numbers');
  assert.ok(Math.abs(path.length - exact) <= path.lengthError, `${path.length}, exact ${exact}, said ${path.lengthError}`);
  bent.dispose();
});

test('where curvature alone jumps there is no crease: the path is right', () => {
  const joined = surfpath.graph({ z: 'max(0, x)^3', x: [-1, 1], y: [-1, 1] });
  const path = joined.shortestPath([-0.7, -0.3], [0.6, 0.8], { tolerance: 1e-6 });
  const profile = 0.7 + simpson((x) => Math.sqrt(1 + 9 * x ** 4), 0, 0.6);
  assert.equal(path.status, 'converged');
  assert.ok(Math.abs(path.length / Math.hypot(profile, 1.1) - 1) <= 1e-6);
  joined.dispose();
});

test('a superellipsoid of powers 1.5, curved infinitely along six lines: rungs that wander end, with an error that covers what 16,000 chords extrapolate to', () => {
  const power = (/** @type {string} */ value) => `sign(${value})*abs(${value})^1.5`;
  const surface = surfpath.parametric({
    x: `${power('cos(v)')}*${power('cos(u)')}`,
    y: `${power('cos(v)')}*${power('sin(u)')}`,
    z: power('sin(v)'),
    u: ['-pi', 'pi'],
    v: ['-pi/2', 'pi/2'],
  });
  /* Length and error of a polyline of 16,000 points. */
  for (const [from, to, length, error] of /** @type {[number[], number[], number, number][]} */ ([
    [[1.195492, 0.30393], [0.588988, -0.854456], 1.1086865849059, 2.4e-8],
    [[-1.456915, 0.193128], [2.869923, 0.679367], 1.4096839529841, 2.8e-8],
  ])) {
    const path = surface.shortestPath(from, to);
    assert.ok(path.converged || path.status === 'tolerance-not-met', path.status);
    assert.ok(path.iterations < 200, `${path.iterations} steps`);
    assert.ok(Math.abs(path.length - length) <= path.lengthError + 2 * error, `${path.length}, not ${length}`);
    assert.ok(path.lengthError < 1e-5);
  }
  surface.dispose();
});

for (const f of [
  'hypot(max(|x|-0.7,0), max(|y|-0.5,0), max(|z|-0.3,0)) - 0.2',
  'hypot(max(|x|-0.7,0), max(|y|-0.5,0), max(|z|-0.3,0)) + min(max(|x|-0.7, |y|-0.5, |z|-0.3), 0) - 0.2',
])
  test(`around the edge of a rounded box, where curvature jumps twice: ${f}, seed 5`, () => {
    const side = /** @type {const} */ ([-1.4, 1.4]);
    const box = surfpath.implicit({ f, bounds: [side, side, side] });
    const random = createRandom(5);
    let converged = 0;
    for (let i = 0; i < PAIRS; i++) {
      const from = [random.between(0, 0.7), random.between(-0.4, 0.4), 0.5];
      const to = [0.9, random.between(-0.4, 0.4), random.between(-0.1, 0.3)];
      const exact = Math.hypot(to[1] - from[1], 0.7 - from[0] + 0.1 * Math.PI + 0.3 - to[2]);
      const path = box.shortestPath(from, to);
      assert.ok(path.converged || path.status === 'tolerance-not-met', `${from} to ${to}: ${path.status}`);
      assert.ok(Math.abs(path.length / exact - 1) <= RIGHT, `${from} to ${to}: ${path.length}, exact ${exact}`);
      converged += Number(path.converged);
    }
    assert.ok(converged >= (2 * PAIRS) / 3);
  });

test('a fold is as long as unfolded, there and back, in batches and near a given start, seed 3', () => {
  const fold = surfpath.graph({ z: 'max(0, x)', x: [-2, 2], y: [-2, 2] });
  const random = createRandom(3);
  const flat = (/** @type {number[]} */ [x, y]) => [x > 0 ? x * Math.SQRT2 : x, y];
  for (let i = 0; i < 100; i++) {
    const [from, to] = [0, 1].map(() => [random.between(-2, 2), random.between(-2, 2)]);
    const [a, b] = [flat(from), flat(to)];
    const exact = Math.hypot(a[0] - b[0], a[1] - b[1]);
    const path = fold.shortestPath(from, to);
    assert.equal(path.status, 'converged', `${from} to ${to}`);
    assert.ok(Math.abs(path.length - exact) <= 1e-9 * exact, `${from} to ${to}: ${path.length}, unfolded ${exact}`);
    assert.deepEqual(Array.from(path.parameters?.subarray(0, 2) ?? []), from);
    assert.deepEqual(Array.from(path.parameters?.subarray(-2) ?? []), to);
    assert.equal(fold.shortestPath(to, from).length, path.length);
    assert.equal(fold.lengths([...from, ...to])[0], path.length);
    if (i % 10 === 0) assert.ok(Math.abs(fold.shortestPath(from, to, { start: path }).length / exact - 1) <= 1e-9);
  }
  fold.dispose();
});

/** Height, waves, and how many of six paths converge. */
const PLEATED = [
  [1, 5, 6],
  [0.5, 9, 6],
  [1, 9, 6],
  [0.1, 20, 6],
  [0.3, 20, 5],
];

for (const [height, waves, least] of PLEATED)
  test(`${height} abs(sin(${waves} x)), steep on both sides of up to thirteen creases: as long as unrolled, seed 3`, () => {
    const surface = surfpath.graph({ z: `${height}*abs(sin(${waves}*x))`, x: [-1, 1], y: [-1, 1] });
    const random = createRandom(3);
    let converged = 0;
    for (let i = 0; i < 6; i++) {
      const [from, to] = [-1, 0.2].map((x) => [random.between(x, x + 0.8), random.between(-1, 1)]);
      const path = surface.shortestPath(from, to);
      if (!path.converged) continue;
      converged++;
      const inner = Array.from({ length: 2 * waves }, (_, k) => ((k - waves) * Math.PI) / waves).filter((x) => x > from[0] && x < to[0]);
      const stops = [from[0], ...inner, to[0]];
      const slope = (/** @type {number} */ x) => height * waves * Math.cos(waves * x);
      const along = inner.concat(to[0]).reduce((sum, x, k) => sum + simpson((at) => Math.hypot(1, slope(at)), stops[k], x, 2000), 0);
      const exact = Math.hypot(along, to[1] - from[1]);
      assert.ok(Math.abs(path.length - exact) <= RIGHT * exact, `${from} to ${to}: ${path.length}, exact ${exact}`);
    }
    assert.ok(converged >= least, `${converged} converged`);
    surface.dispose();
  });

test('a density that jumps: paths are refracted by the law of Snell, or follow the jump on its cheap side, left and joined at the critical angle, seed 5', () => {
  const halves = surfpath.graph({
    z: 0,
    x: [-2, 2],
    y: [-2, 2],
    density: 'inside + (outside - inside)*(1 + sign(x))/2',
    parameters: { inside: 1, outside: 3 },
  });
  const random = createRandom(5);
  let followed = 0;
  for (let i = 0; i < 60; i++) {
    const [from, to] = [0, 1].map(() => [random.between(-2, 2), random.between(-2, 2)]);
    const path = halves.shortestPath(from, to);
    const [left, right] = [from, to].sort((a, b) => a[0] - b[0]);
    const straight = 3 * Math.hypot(left[0] - right[0], left[1] - right[1]);
    let exact = Number.NaN;
    if (left[0] < 0 && right[0] > 0) {
      const by = (/** @type {number} */ y) => Math.hypot(left[0], y - left[1]) + 3 * Math.hypot(right[0], y - right[1]);
      let [low, high] = [Math.min(left[1], right[1]), Math.max(left[1], right[1])];
      for (let k = 0; k < 200; k++) {
        const [a, b] = [low + (high - low) / 3, high - (high - low) / 3];
        if (by(a) < by(b)) high = b;
        else low = a;
      }
      exact = by(low);
    } else if (left[0] > 0) {
      const along = Math.abs(left[1] - right[1]) - (left[0] + right[0]) / Math.sqrt(8);
      exact = along > 0 ? Math.min(straight, (3 * (left[0] + right[0])) / Math.sqrt(8 / 9) + along) : straight;
      followed += Number(exact < straight);
    } else exact = Math.hypot(left[0] - right[0], left[1] - right[1]);
    assert.equal(path.status, 'converged', `${from} to ${to}`);
    assert.ok(Math.abs(path.length - exact) <= 1e-9 * exact, `${from} to ${to}: ${path.length}, exact ${exact}`);
  }
  assert.ok(followed > 2);
  halves.set({ outside: 1 });
  assert.ok(Math.abs(halves.shortestPath([-1, -1], [1, 1]).length - Math.sqrt(8)) <= 1e-12);
  halves.dispose();
});

test('E, F and G may jump, positions may not: a metric is refracted as a density is', () => {
  const density = surfpath.graph({ z: 0, x: [-1, 1], y: [-1, 1], density: '2 + sign(x)' });
  const scale = '(2 + sign(u))^2';
  const metric = surfpath.metric({ E: scale, F: 0, G: scale, u: [-1, 1], v: [-1, 1] });
  const one = density.shortestPath([-0.6, -0.5], [0.5, 0.7]);
  const other = metric.shortestPath([-0.6, -0.5], [0.5, 0.7]);
  assert.deepEqual([one.status, other.status], ['converged', 'converged']);
  assert.ok(Math.abs(one.length - other.length) <= 1e-9 * one.length, `${one.length} and ${other.length}`);
  density.dispose();
  metric.dispose();
});

test('a lake is walked round: straight to the shore, along it, and straight on; there and back, with the points that were asked for, seed 7', () => {
  const lake = surfpath.graph({ z: 0, x: [-2, 2], y: [-2, 2], density: '3 - 2*sign(x^2 + y^2 - 1)' });
  const random = createRandom(7);
  const ashore = () => {
    for (;;) {
      const place = [random.between(-2, 2), random.between(-2, 2)];
      if (Math.hypot(...place) > 1.02) return place;
    }
  };
  let walked = 0;
  for (let i = 0; i < 16; i++) {
    const [from, to] = [ashore(), ashore()];
    const turn = Math.abs(Math.atan2(from[1], from[0]) - Math.atan2(to[1], to[0]));
    const [a, b] = [Math.hypot(...from), Math.hypot(...to)];
    const arc = Math.min(turn, 2 * Math.PI - turn) - Math.acos(1 / a) - Math.acos(1 / b);
    const exact = arc > 0 ? Math.sqrt(a * a - 1) + arc + Math.sqrt(b * b - 1) : Math.hypot(from[0] - to[0], from[1] - to[1]);
    const path = lake.shortestPath(from, to, { points: 40 });
    assert.equal(path.status, 'converged', `${from} to ${to}`);
    assert.ok(Math.abs(path.length - exact) <= 1e-9 * exact, `${from} to ${to}: ${path.length}, exact ${exact}`);
    assert.equal(path.points.length, 3 * 42);
    for (let k = 0; k < 42; k++) assert.ok(Math.hypot(path.points[3 * k], path.points[3 * k + 1]) > 1 - 1e-6);
    if (arc <= 0) continue;
    walked++;
    assert.equal(lake.shortestPath(to, from).length, lake.shortestPath(from, to).length);
  }
  assert.ok(walked >= 5);
  const [quarter] = lake.lengths([-1, 0, 0, 1]);
  assert.ok(Math.abs(quarter - Math.PI / 2) <= 1e-9, `along the shore alone: ${quarter}`);
  lake.dispose();
});

test("Luneburg's lens: parallel rays meet in the focus, at once; those near its rim do not follow it, a geodesic of the inside past its conjugate point", () => {
  const lens = surfpath.graph({ z: 0, x: [-3, 3], y: [-3, 3], density: 'sqrt(max(1, 2 - x^2 - y^2))' });
  for (const height of [0.5, 0.9, 0.93, -0.95, 0.97, 0.99, 0.995, 1]) {
    const { status, length } = lens.shortestPath([-2, height], [1, 0]);
    assert.equal(status, 'converged', `${height}`);
    assert.ok(Math.abs(length - 2 - Math.PI / 2) <= 1e-9, `${height}: ${length}`);
  }
  lens.dispose();
});

test('all geodesics across creases: both ways round a lake, one through a coast, and over the faces of a cube, as they unfold', () => {
  const lake = surfpath.graph({ z: 0, x: [-2, 2], y: [-2, 2], density: '3 - 2*sign(x^2 + y^2 - 1)' });
  const coast = surfpath.graph({ z: 0, x: [-2, 2], y: [-2, 2], density: '2 + sign(x)' });
  const cube = surfpath.implicit({ f: 'max(abs(x), abs(y), abs(z)) - 1' });
  const round = (/** @type {number} */ turn) =>
    Math.sqrt(1.26) + turn - Math.acos(1 / Math.hypot(1.5, 0.1)) - Math.acos(1 / 1.5) + Math.sqrt(1.25);
  const beyond = Math.PI - Math.atan2(0.1, 1.5);
  const lengthsOf = (/** @type {import('../../../web/index.js').Path[]} */ found) =>
    found.map(({ status, length }) => {
      assert.equal(status, 'converged');
      return length;
    });
  const shores = lengthsOf(lake.geodesics([-1.5, 0.1], [1.5, 0]));
  assert.equal(shores.length, 2);
  for (const [k, turn] of [beyond, 2 * Math.PI - beyond].entries())
    assert.ok(Math.abs(shores[k] - round(turn)) <= 1e-9, `${shores}, not ${round(turn)}`);
  assert.deepEqual(lengthsOf(coast.geodesics([-1, 0.5], [1, -0.5])), lengthsOf([coast.shortestPath([-1, 0.5], [1, -0.5])]));
  /* By the cheap side, and straight on the dear one. */
  const beside = lengthsOf(coast.geodesics([0.05, -1], [1.2, 1]));
  assert.equal(beside.length, 2);
  assert.ok(beside[0] < beside[1] && Math.abs(beside[1] - 3 * Math.hypot(1.15, 2)) <= 1e-9, `${beside}`);
  const faces = lengthsOf(cube.geodesics([1, 0.1, 0.2], [-1, 0.1, 0.3]));
  for (const exact of [3.5, Math.hypot(3.8, 0.1), Math.hypot(4.2, 0.1)])
    assert.ok(
      faces.some((length) => Math.abs(length - exact) <= 1e-9),
      `${faces}: no ${exact}`,
    );
  for (const surface of [lake, coast, cube]) surface.dispose();
});

for (const height of [0.2, 0.7])
  test(`a lake on a hill ${height} high is walked round as the wall of a ring is, seed 101`, () => {
    const hill = (/** @type {string} */ x, /** @type {string} */ y) => `${height}*exp(-2((${x})^2 + (${y})^2))`;
    const density = '1.5 - 0.5*sign((x - 0.5)^2 + (y - 0.2)^2 - 0.5)';
    const lake = surfpath.graph({ z: hill('x', 'y'), x: [-2, 2], y: [-2, 2], density });
    const [x, y] = ['0.5 + v*cos(u)', '0.2 + v*sin(u)'];
    const ring = surfpath.parametric({ x, y, z: hill(x, y), u: [0, '2pi'], v: ['sqrt(0.5)', 4] });
    const polar = (/** @type {number[]} */ [x, y]) => [Math.atan2(y - 0.2, x - 0.5), Math.hypot(x - 0.5, y - 0.2)];
    const random = createRandom(101);
    let round = 0;
    for (let pair = 0; pair < 20; pair++) {
      const [from, to] = [-1, 1].map((side) => [0.5 + side * random.between(0.75, 1.4), random.between(-1.4, 1.8)]);
      const [path, around] = [lake.shortestPath(from, to), ring.shortestPath(polar(from), polar(to))];
      assert.ok(path.converged && around.converged, `${from} to ${to}: ${path.status}, ${around.status}`);
      assert.ok(path.length <= around.length * (1 + 1e-9), `${from} to ${to}: ${path.length}, around ${around.length}`);
      if (around.touchesBoundary && path.length >= around.length * (1 - 1e-9)) round++;
    }
    assert.ok(round >= 10, `${round} lead along the shore`);
    for (const surface of [lake, ring]) surface.dispose();
  });

test('on an implicit sphere a dear cap is walked round', () => {
  const globe = surfpath.implicit({ f: 'x^2 + y^2 + z^2 - 1', density: '3 + 2*sign(z - 0.8)' });
  const [cap, end] = [Math.acos(0.8), Math.acos(0.6)];
  for (const turn of [Math.PI, 3, 2.5]) {
    const path = globe.shortestPath([0.8, 0, 0.6], [0.8 * Math.cos(turn), 0.8 * Math.sin(turn), 0.6]);
    const arc = turn - 2 * Math.acos(Math.tan(cap) / Math.tan(end));
    const exact = 2 * Math.acos(Math.cos(end) / Math.cos(cap)) + arc * Math.sin(cap);
    assert.equal(path.status, 'converged');
    assert.ok(Math.abs(path.length - exact) <= 1e-9 * exact, `${path.length}, exact ${exact}`);
  }
  globe.dispose();
});

test('a way that was seen to be shorter, and could not be followed, leaves no other one converged', () => {
  const shore = surfpath.graph({ z: 0, x: [-2, 2], y: [-2, 2], density: '2 + sign(y - 0.3*sin(3x))' });
  /* Straight it is 10.80; by the cheap half 8 and a bit. */
  const path = shore.shortestPath([-1.8, 0.8], [1.8, 0.9]);
  assert.ok(path.length < 9 || (path.status === 'stalled' && path.length - path.lengthError < 9), `${path.status} ${path.length}`);
  shore.dispose();
  /* Faces in planes of the graph's cells: it finds no way. */
  const side = /** @type {const} */ ([-2, 2]);
  const cube = surfpath.implicit({ f: 'max(abs(x), abs(y), abs(z)) - 1', bounds: [side, side, side] });
  const across = cube.shortestPath([1, 0.6435940746483158, 0.2706766278670202], [0.5679616616550117, 0.7195988337613317, -1]);
  const exact = 1.704410449266898;
  assert.ok(Math.abs(across.length - exact) <= (across.converged ? 1e-9 : across.lengthError), `${across.status} ${across.length}`);
  cube.dispose();
});

test('on a cube, a body of formulas joined by max, paths are as long as on its net, seed 3', () => {
  const cube = surfpath.implicit({
    f: 'max(abs(x), abs(y), abs(z)) - 1',
    bounds: [
      [-1.5, 1.5],
      [-1.5, 1.5],
      [-1.5, 1.5],
    ],
  });
  const random = createRandom(3);
  const place = () => random.between(-1, 1);
  for (let i = 0; i < 40; i++) {
    const [from, to] = [
      [place(), place(), 1],
      [1, place(), place()],
    ];
    /* Straight over the edge between both faces, or over a third face, on either side. */
    const nets = [-1, 1].map((side) => Math.hypot(2 - side * to[1] - from[0], 2 - to[2] - side * from[1]));
    const exact = Math.min(Math.hypot(2 - from[0] - to[2], from[1] - to[1]), ...nets);
    const path = cube.shortestPath(from, to);
    assert.equal(path.status, 'converged', `${from} to ${to}`);
    assert.ok(Math.abs(path.length - exact) <= 1e-9 * exact, `${from} to ${to}: ${path.length}, on the net ${exact}`);
  }
  cube.dispose();
});

/** Lakes with corners: the density, by how much a place is inside, corners. @type {[string, string, (place: number[]) => number, number[][]][]} */
const LAKES = [
  [
    'square',
    '3 + 2*sign(0.8 - max(abs(x), abs(y)))',
    ([x, y]) => 0.8 - Math.max(Math.abs(x), Math.abs(y)),
    [-0.8, 0.8].flatMap((x) => [-0.8, 0.8].map((y) => [x, y])),
  ],
  [
    'triangular',
    '5 + 4*sign(min(y + 0.6, 0.8 - y - 1.2*abs(x)))',
    ([x, y]) => Math.min(y + 0.6, 0.8 - y - 1.2 * Math.abs(x)),
    [[0, 0.8], ...[-1, 1].map((side) => [(side * 1.4) / 1.2, -0.6])],
  ],
];

for (const [name, density, inside, corners] of LAKES)
  test(`a ${name} lake is walked round from corner to corner, seed 3`, () => {
    const lake = surfpath.graph({ z: '0', x: [-2, 2], y: [-2, 2], density });
    const random = createRandom(3);
    const place = () => [random.between(-1.9, 1.9), random.between(-1.9, 1.9)];
    const gap = (/** @type {number[]} */ a, /** @type {number[]} */ b) => Math.hypot(a[0] - b[0], a[1] - b[1]);
    /* Whether what is straight between two places stays out of the lake: looked at in so many places. */
    const isDry = (/** @type {number[]} */ a, /** @type {number[]} */ b) =>
      Array.from({ length: 400 }, (_, i) => (i + 0.5) / 400).every((t) => inside(a.map((x, j) => x + t * (b[j] - x))) < 1e-9);
    let around = 0;
    for (let i = 0; i < 30; i++) {
      const [from, to] = [place(), place()];
      if (inside(from) > -0.05 || inside(to) > -0.05) continue;
      /* Over no, one or two corners. */
      const ways = [[], ...corners.map((a) => [a]), ...corners.flatMap((a) => corners.filter((b) => b !== a).map((b) => [a, b]))]
        .map((stops) => [from, ...stops, to])
        .filter((stops) => stops.slice(1).every((stop, k) => isDry(stops[k], stop)))
        .map((stops) => stops.slice(1).reduce((sum, stop, k) => sum + gap(stops[k], stop), 0));
      const exact = Math.min(...ways);
      const path = lake.shortestPath(from, to);
      assert.equal(path.status, 'converged', `${from} to ${to}`);
      assert.ok(Math.abs(path.length - exact) <= 1e-9 * exact, `${from} to ${to}: ${path.length}, exact ${exact}`);
      if (exact > gap(from, to) * (1 + 1e-9)) around++;
    }
    assert.ok(around >= 5, `${around} paths around corners`);
    lake.dispose();
  });

test('dear lakes are passed on the right side, and through the gap between them, though the graph sees none', () => {
  const square = /** @type {const} */ ([-1, 1]);
  /** @param {string} density @param {number[]} from @param {number[]} to @param {...number} by */
  const pass = (density, from, to, ...by) => {
    const lakes = surfpath.graph({ z: 0, x: square, y: square, density });
    const path = lakes.shortestPath(from, to, by.length > 0 ? { start: [...from, ...by, ...to] } : {});
    lakes.dispose();
    assert.equal(path.status, 'converged', density);
    return path.length;
  };
  const isNear = (/** @type {number} */ length, /** @type {number} */ exact) =>
    assert.ok(Math.abs(length - exact) <= 1e-9, `${length}, exact ${exact}`);
  const two = 'max(0.2 - hypot(x, y - 0.3), 0.1 - hypot(x - 0.4, y - 0.3))';
  /* A string drawn taut. */
  for (const dear of [50, 1000])
    isNear(pass(`${(dear + 1) / 2} + ${(dear - 1) / 2}*sign(${two})`, [-0.2, 0], [0.4, 0.5]), 0.8065008196603698);
  const one = '25.5 + 24.5*sign(1 - (0.95x + 0.2y)^2/0.36 - (0.95y - 0.2x + 0.25)^2/0.034)';
  isNear(pass(one, [-0.63, 0.27], [0.53, -0.48]), pass(one, [-0.63, 0.27], [0.53, -0.48], 0.62, -0.3));
});

test('three lakes in one sign, of a maximum: where the lakes inside it are equally far nothing is bent', () => {
  const lakes = [
    [0.11546404, -0.0705, -0.6095],
    [0.10106041, 0.5371, -0.2017],
    [0.01077444, 0.4516, -0.684],
  ].map(([r, x, y]) => `${r} - (x - ${x})^2 - (y - ${y})^2`);
  const plane = surfpath.implicit({
    f: 'z',
    bounds: [
      [-1, 1],
      [-1, 1],
      [-0.5, 0.5],
    ],
    density: `6 + 5*sign(max(${lakes}))`,
  });
  const path = plane.shortestPath([0.8288, -0.5906, 0], [-0.7495, -0.3529, 0]);
  assert.equal(path.status, 'converged');
  assert.ok(Math.abs(path.length - 1.65046107925) <= 1e-9, `${path.length}`);
  plane.dispose();
});

test('a maximum of 0 and a sign has the crease of the sign alone', () => {
  const [asked, plain] = ['1 + 3*max(0, sign(0.6 - hypot(x, y)))', '2.5 + 1.5*sign(0.6 - hypot(x, y))'].map((density) =>
    surfpath.graph({ z: '0', x: [-2, 2], y: [-2, 2], density }),
  );
  for (const [from, to] of /** @type {[number[], number[]][]} */ ([
    [
      [1.221, 1.028],
      [-0.172, -1.579],
    ],
    [
      [1.513, 0.163],
      [0.06, -0.074],
    ],
  ])) {
    const [path, expected] = [asked, plain].map((surface) => surface.shortestPath(from, to));
    assert.equal(path.status, 'converged');
    assert.ok(Math.abs(path.length / expected.length - 1) < 1e-9);
  }
  asked.dispose();
  plain.dispose();
});

test('on a narrow road that winds, along an edge of a lake and past its corner: no longer than what brute force finds', () => {
  const [road, lake] = ['2 - sign(0.1 - abs(y - 0.3*sin(2x)))', '2 + sign(min(y + 0.6, 0.8 - y - 1.2*abs(x)))'].map((density) =>
    surfpath.graph({ z: '0', x: [-2, 2], y: [-2, 2], density }),
  );
  /* Of tests/accuracy/measure/plane.js: lengths of polylines. */
  for (const [plane, from, to, brute] of /** @type {[typeof road, number[], number[], number][]} */ ([
    [road, [1.721, -0.593], [-1.719, 1.68], 9.3041],
    [road, [0.872, -0.72], [-1.454, 1.345], 8.564],
    [road, [-1.918, -0.296], [0.372, -0.736], 4.8648],
    [lake, [1.65405, 1.73031], [-1.46511, -0.62792], 3.9465],
  ])) {
    const path = plane.shortestPath(from, to);
    assert.equal(path.status, 'converged', `${from} to ${to}`);
    assert.ok(path.length <= brute * 1.001 && path.length >= brute * 0.99, `${from} to ${to}: ${path.length}, brute force ${brute}`);
  }
  for (const plane of [road, lake]) plane.dispose();
});

test('by a winding bank, and on a narrow road: a path converges, and none is longer than a polyline that was drawn by hand', () => {
  /* Ends, and stops of a way that is nearly the shortest. */
  /** @type {[string, (x: number, y: number) => number, number[], number[], number[][]][]} */
  const cases = [
    [
      '2 + sign(y - 0.3*sin(3x))',
      (x, y) => 2 + Math.sign(y - 0.3 * Math.sin(3 * x)),
      [-1.639, 1.839],
      [1.797, 0.119],
      [
        [-1.489, 0.29],
        [-0.831, -0.2],
        [-0.68, -0.29],
        [-0.6, -0.305],
        [-0.524, -0.31],
        [1.571, -0.305],
        [1.7, -0.282],
        [1.8, -0.235],
        [1.885, -0.178],
      ],
    ],
    [
      '2 - sign(0.1 - abs(y - 0.3*sin(2x)))',
      (x, y) => 2 - Math.sign(0.1 - Math.abs(y - 0.3 * Math.sin(2 * x))),
      [-1.22, 1.831],
      [1.27, -0.539],
      [
        [0.272, 0.255],
        [0.869, 0.203],
        [0.95, 0.195],
        [1.03, 0.176],
        [1.1, 0.152],
        [1.18, 0.119],
        [1.25, 0.089],
        [1.31, 0.056],
        [1.361, 0.026],
      ],
    ],
    /* Pressed against the edge of the rectangle, where it comes to the bank. */
    [
      '3 - 2*sign(y - 0.5*sin(3x))',
      (x, y) => 3 - 2 * Math.sign(y - 0.5 * Math.sin(3 * x)),
      [-1.918, -0.2957],
      [0.3717, -0.736],
      [...Array.from({ length: 400 }, (_, i) => -2 + (0.57 * i) / 399).map((x) => [x, 0.5 * Math.sin(3 * x) + 1e-4]), [-0.207, -0.29]],
    ],
  ];
  for (const [density, at, from, to, stops] of cases) {
    const plane = surfpath.graph({ z: '0', x: [-2, 2], y: [-2, 2], density });
    const path = plane.shortestPath(from, to);
    const places = [from, ...stops, to];
    let drawn = 0;
    for (let k = 1; k < places.length; k++)
      for (let i = 0; i < 4000; i++) {
        const [[a, b], [c, d]] = [places[k - 1], places[k]];
        const t = (i + 0.5) / 4000;
        drawn += (Math.hypot(c - a, d - b) / 4000) * at(a + t * (c - a), b + t * (d - b));
      }
    assert.equal(path.status, 'converged', density);
    assert.ok(path.length <= drawn && path.length > 0.97 * drawn, `${density}: ${path.length}, drawn ${drawn}`);
    assert.equal(plane.shortestPath(to, from).length, path.length);
    plane.dispose();
  }
});

test('along the bottom of a valley of cost, where only its slope jumps: catenaries down to it, along it, and up again; there and back, seed 5', () => {
  for (const bottom of [0.2, 0.1]) {
    const surface = surfpath.graph({ z: 0, x: [-2, 2], y: [-1, 1], density: `${bottom} + abs(y)` });
    const random = createRandom(5);
    // y + c = c cosh(x/c) touches the bottom; its length is the integral of c cosh² (x/c).
    const arc = (/** @type {number} */ y) => {
      const x = bottom * Math.acosh((Math.abs(y) + bottom) / bottom);
      return { x, length: (bottom * x) / 2 + ((bottom * bottom) / 4) * Math.sinh((2 * x) / bottom) };
    };
    let count = 0;
    for (let i = 0; i < ofAll(5, 10); i++) {
      const [a, b] = [-1, 1].map((side) => [side * random.between(0.8, 2), random.between(-1, 1)]);
      const [down, up] = [arc(a[1]), arc(b[1])];
      const flat = b[0] - a[0] - down.x - up.x;
      if (flat <= 0) continue;
      const path = surface.shortestPath(a, b);
      assert.equal(path.status, 'converged', `${bottom} ${a} ${b}`);
      const exact = down.length + up.length + bottom * flat;
      assert.ok(Math.abs(path.length - exact) <= RIGHT * exact, `${bottom} ${a} ${b}: ${path.length}, ${exact}`);
      assert.ok(
        path.parameters?.some((y, k) => k % 2 === 1 && Math.abs(y) <= 1e-9),
        'it lies at the bottom',
      );
      assert.equal(surface.shortestPath(b, a).length, path.length);
      count++;
    }
    assert.ok(count >= ofAll(4, 8), `${count}`);
  }
});

test('from the side of a round hill of cost to its foot, where only its slope jumps, and along that: as long as a ray by quadrature, an arc and a tangent', () => {
  const surface = surfpath.graph({ z: 0, x: [-1, 1], y: [-1, 1], density: 'max(1, 5 - 16*(x^2 + y^2))' });
  const path = surface.shortestPath([0.21115359469567083, 0.21310598172528233], [-0.6716895055439785, -0.2592936716198171]);
  assert.equal(path.status, 'converged');
  assert.ok(Math.abs(path.length - 1.8732861) <= 1e-7, `${path.length}`);
});

test('coordinates in other units, one of them in degrees or in thousandths: the same paths', () => {
  const [flat, bent, saddle] = ['0', '0.45*(u + 0.1*v)^2', '0.3*u*v'];
  /** @type {[string, string, number[], number[]][]} */
  const questions = [
    [flat, '1.5 - sign(x^2 + y^2 - 0.5)', [-0.52, 0.107], [0.46, -0.484]],
    [bent, '2 + sign(x - 0.2)', [0.5216, -0.4358], [0.0929, -0.4865]],
    [saddle, '1 + abs(y)', [0.02, 0.9], [0.65, -0.98]],
  ];
  for (const [z, density, from, to] of questions) {
    const lengths = [
      [1, 1],
      [57.3, 1],
      [1, 1000],
      [0.001, 1],
    ].map((units) => {
      const [u, v] = ['u', 'v'].map((name, j) => `(${name}/${units[j]})`);
      const within = (/** @type {string} */ text) => text.replaceAll('u', u).replaceAll('v', v);
      const range = units.map((unit) => /** @type {[number, number]} */ ([-unit, unit]));
      const surface = surfpath.parametric({ x: u, y: v, z: within(z), u: range[0], v: range[1], density });
      const [a, b] = [from, to].map((end) => end.map((x, j) => x * units[j]));
      const path = surface.shortestPath(a, b);
      assert.equal(path.status, 'converged', `${density} in ${units}`);
      return path.length;
    });
    for (const length of lengths) assert.ok(Math.abs(length - lengths[0]) <= RIGHT * length, `${density}: ${lengths}`);
  }
});

test('two valleys of cost that cross: paths along one through the crossing, and past it, no longer than where they are rounded from above, seed 5', () => {
  for (const z of ['0', '0.4*sin(x)*cos(1.3*y)']) {
    const valleys = (/** @type {(of: string) => string} */ size) =>
      surfpath.graph({ z, x: [-2, 2], y: [-2, 2], density: `0.2 + ${size('x')} + ${size('y')}` });
    const [sharp, rounded] = [valleys((of) => `abs(${of})`), valleys((of) => `hypot(${of}, 1e-3)`)];
    const random = createRandom(5);
    let converged = 0;
    for (let i = 0; i < ofAll(3, 12); i++) {
      const [a, b] = [1, 2].map(() => [random.between(-2, 2), random.between(-2, 2)]);
      const path = sharp.shortestPath(a, b);
      if (!path.converged) continue;
      converged++;
      const above = rounded.shortestPath(a, b, { start: path });
      assert.ok(!above.converged || path.length <= above.length * (1 + RIGHT), `${z} ${a} ${b}: ${path.length}, ${above.length}`);
    }
    assert.ok(converged >= ofAll(3, 10), `${converged}`);
  }
});

test('by the bank of a lake whose coordinates are as large as a map has them: as long as at the origin, seed 3', () => {
  const lakeAt = (/** @type {number} */ x, /** @type {number} */ y) =>
    surfpath.graph({ z: `max(0.3(x - ${x})^2 + 0.2(y - ${y}), 0.1)`, x: [x - 2, x + 2], y: [y - 2, y + 2] });
  const [east, north] = [500000, 4649776];
  const [here, there] = [lakeAt(0, 0), lakeAt(east, north)];
  const random = createRandom(3);
  const place = () => [random.between(-1.9, 1.9), random.between(-1.9, 1.9)];
  for (let i = 0; i < ofAll(10, PAIRS); i++) {
    const ends = [place(), place()];
    const { length } = here.shortestPath(ends[0], ends[1]);
    const [from, to] = ends.map(([x, y]) => [east + x, north + y]);
    const path = there.shortestPath(from, to);
    assert.ok(path.converged, `${ends}: ${path.status}`);
    assert.ok(Math.abs(path.length - length) <= 1e-8 * length, `${ends}: ${path.length}, not ${length}`);
  }
});

test('past a corner where roots meet on four sides: a path that Newton could not better than rounding has come to rest', () => {
  const roofs = surfpath.graph({ z: 'sqrt(max(0, sin(2x)*cos(y)))', x: [-2, 2], y: [-2, 2] });
  const path = roofs.shortestPath([-1.4535271383821964, 1.6771294080186636], [1.597036890918389, 0.17654810389503828]);
  assert.equal(path.status, 'converged');
  assert.ok(path.lengthError <= 1e-6, String(path.lengthError));
});
