// Traces across creases: against unfolded faces, Snell's law and arcs of circles; no shortest path is longer; backwards they return; what they cannot pass ends them.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { load } from '../../../web/index.js';
import { createRandom } from '../../helpers/random.js';
import { ofAll } from '../../helpers/sample.js';
import { dot, norm, subtract } from '../../helpers/reference.js';

const surfpath = await load();
const SQUARE = /** @type {const} */ ({ x: [-3, 3], y: [-3, 3] });
const side = /** @type {const} */ ([-2, 2]);
const BOX = { bounds: /** @type {const} */ ([side, side, side]) };

/** @typedef {ReturnType<typeof surfpath.surface>} Surface */
/** @typedef {import('../../../web/path.js').Path} Path */

/** @param {number[]} p @param {number[]} d @param {number} by */
const ahead = (p, d, by) => p.map((x, j) => x + by * d[j]);
/** @param {number[]} d @param {number} by */
const times = (d, by) => d.map((x) => by * x);
/** @param {number[]} d */
const unit = (d) => times(d, 1 / Math.hypot(...d));

/** @param {Path} path @param {number} i from the end if negative */
function placeOf({ parameters, points }, i) {
  const [all, width] = parameters ? [parameters, 2] : [points, 3];
  return Array.from(all.slice(width * i, width * (i + 1) || undefined));
}

/** The end is where it should be, within what the path says and what rounding does. @param {Path} path @param {number[]} end @param {string} about */
function endsAt(path, end, about) {
  assert.equal(path.status, 'converged', about);
  const miss = Math.hypot(...subtract(placeOf(path, -1), end));
  assert.ok(miss <= 1e-15 + path.lengthError && path.lengthError < 1e-9, `${about}: misses by ${miss}, says ${path.lengthError}`);
}

/** Slopes between folds. @type {[string, number[], number[]][]} */
const ROOFS = [
  ['max(0, x)', [0], [0, 1]],
  ['abs(x - 0.123)', [0.123], [-1, 1]],
  ['abs(abs(x) - 0.4)', [-0.4, 0, 0.4], [-1, 1, -1, 1]],
  ['max(0, x, 3x - 1)', [0, 0.5], [0, 1, 3]],
];

for (const [z, folds, slopes] of ROOFS)
  test(`${z}: straight when unfolded, seed 1`, () => {
    const surface = surfpath.graph({ z, ...SQUARE });
    const random = createRandom(1);
    const lengths = slopes.map((slope) => Math.hypot(1, slope));
    for (let i = 0; i < 40; i++) {
      const [from, direction] = [0, 1].map(() => [random.between(-1, 1), random.between(-1, 1)]);
      let piece = folds.filter((x) => x < from[0]).length;
      const [dx, dy] = unit([direction[0] * lengths[piece], direction[1]]);
      const sense = Math.sign(dx);
      let [x, left] = [from[0], 1.7 * Math.abs(dx)];
      for (; ; piece += sense) {
        const fold = folds[sense > 0 ? piece : piece - 1] ?? sense * Infinity;
        const reach = Math.abs(fold - x) * lengths[piece];
        if (reach >= left) break;
        [x, left] = [fold, left - reach];
      }
      endsAt(surface.trace(from, direction, 1.7), [x + (sense * left) / lengths[piece], from[1] + 1.7 * dy], `${from} ${direction}`);
    }
    surface.dispose();
  });

/** Over the faces of a cube of half edge 1: what leads out of a face leads into the next. @param {number[]} p @param {number[]} d of length 1 @param {number} left */
function roll(p, d, left) {
  let face = p.findIndex((x) => Math.abs(x) > 1 - 1e-12);
  for (;;) {
    const reaches = p.map((x, j) => (j === face || !d[j] ? Infinity : (Math.sign(d[j]) - x) / d[j]));
    const reach = Math.min(...reaches);
    if (reach >= left) return ahead(p, d, left);
    const next = reaches.indexOf(reach);
    p = ahead(p, d, reach);
    const out = Math.abs(d[next]);
    d = d.map((x, j) => (j === face ? -Math.sign(p[face]) * out : j === next ? 0 : x));
    [face, left] = [next, left - reach];
  }
}

test('a cube: face after face, also where formulas know creases that are none, seed 2', () => {
  const cube = surfpath.implicit({ f: 'max(abs(x), abs(y), abs(z)) - 1', ...BOX });
  const random = createRandom(2);
  const starts = Array.from({ length: 30 }, () => [0, 1, 2, 3].map(() => random.between(-1, 1)));
  for (const [x, y, dx, dy] of [...starts, [0.2, 0.1, 1, 0.3], [0, 0, 0, 1], [0.2, 0.1, 1, 0]])
    endsAt(cube.trace([x, y, 1], [dx, dy, 0], 5), roll([x, y, 1], unit([dx, dy, 0]), 5), `${[x, y, dx, dy]}`);
  /* From an edge, down: only one of the faces has that direction. */
  endsAt(cube.trace([1, 0.3, 1], [0, 0, -1], 0.5), [1, 0.3, 0.5], 'from an edge');
  cube.dispose();
});

/** Straight rays through the plane, refracted where the density jumps. @param {number[]} p @param {number[]} d of length 1 @param {number} left @param {(p: number[]) => number} density @param {(p: number[], d: number[]) => { reach: number, normal: number[] }} meet */
function shine(p, d, left, density, meet) {
  for (;;) {
    const { reach, normal } = meet(p, d);
    const here = density(ahead(p, d, Math.min(reach, 1) / 2));
    if (!(reach * here < left)) return ahead(p, d, left / here);
    p = ahead(p, d, reach);
    left -= reach * here;
    const across = dot([...d, 0], [...normal, 0]);
    const there = density(ahead(p, normal, Math.sign(across) * 1e-9));
    const tangent = ahead(d, normal, -across);
    const squared = 1 - (here / there) ** 2 * norm([...tangent, 0]) ** 2;
    d = squared < 0 ? ahead(tangent, normal, -across) : ahead(times(tangent, here / there), normal, Math.sign(across) * Math.sqrt(squared));
  }
}

test('banks: Snell, over two in turn, and total reflection, seed 3', () => {
  const plane = surfpath.graph({ z: '0', density: '2 - 0.7*sign(x) + 0.4*sign(x - 0.5)', ...SQUARE });
  const density = (/** @type {number[]} */ [x]) => 2 - 0.7 * Math.sign(x) + 0.4 * Math.sign(x - 0.5);
  const meet = (/** @type {number[]} */ [x], /** @type {number[]} */ [dx]) => {
    const reaches = [0, 0.5].map((bank) => (bank - x) / dx).filter((reach) => reach > 1e-9);
    return { reach: Math.min(...reaches), normal: [1, 0] };
  };
  const random = createRandom(3);
  let reflected = 0;
  for (let i = 0; i < 60; i++) {
    const [from, direction] = [0, 1].map(() => [random.between(-1, 1), random.between(-1, 1)]);
    const end = shine(from, unit(direction), 4, density, meet);
    if (Math.max(...end.map(Math.abs)) > 3) continue;
    endsAt(plane.trace(from, direction, 4), end, `${from} ${direction}`);
    if ((end[0] - from[0]) * direction[0] < 0) reflected++;
  }
  assert.ok(reflected > 5, `${reflected} reflected`);
  const half = surfpath.graph({ z: '0', density: '3 - 2*sign(x)', ...SQUARE });
  endsAt(half.trace([-1, 0], [1, 0], 6), [1, 0], 'straight across');
  plane.dispose();
  half.dispose();
});

for (const [inside, outside] of [
  [2, 1],
  [1, 2],
])
  test(`a round lake of density ${inside} in ${outside}: Snell, seed 4`, () => {
    const [middle, step] = [(inside + outside) / 2, (inside - outside) / 2];
    const plane = surfpath.graph({ z: '0', density: `${middle} + ${step}*sign(1 - x^2 - y^2)`, ...SQUARE });
    const meet = (/** @type {number[]} */ p, /** @type {number[]} */ d) => {
      const [b, c] = [p[0] * d[0] + p[1] * d[1], p[0] ** 2 + p[1] ** 2 - 1];
      const root = Math.sqrt(b * b - c);
      const reach = [-b - root, -b + root].find((x) => x > 1e-7) ?? Infinity;
      return { reach, normal: reach < Infinity ? unit(ahead(p, d, reach)) : [1, 0] };
    };
    const random = createRandom(4);
    for (let i = 0; i < 60; i++) {
      const [from, direction] = [1.5, 1].map((most) => [random.between(-most, most), random.between(-most, most)]);
      const density = (/** @type {number[]} */ p) => (Math.hypot(...p) < 1 ? inside : outside);
      const end = shine(from, unit(direction), 2.5, density, meet);
      if (Math.max(...end.map(Math.abs)) > 3) continue;
      endsAt(plane.trace(from, direction, 2.5), end, `${from} ${direction}`);
    }
    plane.dispose();
  });

test('two balls joined: arcs of great circles, turned at the seam, seed 5', () => {
  const balls = surfpath.implicit({ f: 'min((x-0.5)^2 + y^2 + z^2, (x+0.5)^2 + y^2 + z^2) - 1', ...BOX });
  const random = createRandom(5);
  let crossing = 0;
  for (let i = 0; i < 40; i++) {
    const towards = unit([random.between(0, 1), random.between(-1, 1), random.between(-1, 1)]);
    const from = ahead([0.5, 0, 0], towards, 1);
    const given = [random.between(-1, 0), random.between(-1, 1), random.between(-1, 1)];
    let [centre, p, left] = [0.5, towards, 2];
    let q = unit(ahead(given, p, -dot(given, p)));
    for (;;) {
      /* p cos s + q sin s comes to the plane x = 0, where that is −centre, from its own side. */
      const [size, phase] = [Math.hypot(p[0], q[0]), Math.atan2(q[0], p[0])];
      const swing = Math.acos(Math.max(-1, Math.min(1, -centre / size)));
      const turns = [phase + swing, phase - swing].map((s) => s - 2 * Math.PI * Math.floor((s - 1e-9) / (2 * Math.PI)));
      const leaves = turns.filter((s) => centre * (q[0] * Math.cos(s) - p[0] * Math.sin(s)) < 0);
      const reach = size > 0.5 ? Math.min(...leaves) : Infinity;
      const at = (/** @type {number} */ s) => ahead(times(p, Math.cos(s)), q, Math.sin(s));
      if (!(reach < left)) {
        endsAt(balls.trace(from, given, 2), ahead([centre, 0, 0], at(left), 1), `${from} ${given}`);
        break;
      }
      crossing++;
      const d = ahead(times(q, Math.cos(reach)), p, -Math.sin(reach));
      const place = ahead([centre, 0, 0], at(reach), 1);
      const seam = unit([0, -place[2], place[1]]);
      const along = dot(d, seam);
      [centre, left] = [-centre, left - reach];
      p = subtract(place, [centre, 0, 0]);
      /* At right angles to the seam, into the other ball's own side. */
      const into = unit([seam[1] * p[2] - seam[2] * p[1], seam[2] * p[0] - seam[0] * p[2], seam[0] * p[1] - seam[1] * p[0]]);
      q = ahead(times(seam, along), into, (Math.sign(into[0]) === Math.sign(centre) ? 1 : -1) * Math.sqrt(1 - along * along));
    }
  }
  assert.ok(crossing > 15, `${crossing} cross the seam`);
  balls.dispose();
});

test('a density that is continuous: density times the cosine along its crease is the same all the way', () => {
  const plane = surfpath.graph({ z: '0', density: '1 + abs(x)', ...SQUARE });
  const path = plane.trace([-1, 0], [1, 0.5], 3, { points: 2000 });
  assert.ok(path.converged && path.lengthError < 1e-9);
  const momentum = 2 * (0.5 / Math.hypot(1, 0.5));
  for (let i = 10; i < 1990; i += 20) {
    const [a, b] = [i, i + 1].map((k) => placeOf(path, k));
    const cosine = (b[1] - a[1]) / Math.hypot(...subtract(b, a));
    /* Of a chord of a thousandth and its middle: its square. */
    assert.ok(Math.abs((1 + Math.abs((a[0] + b[0]) / 2)) * cosine - momentum) < 1e-5, `${a}`);
  }
  plane.dispose();
});

/** Of 60 traces so many converge. @type {[string, () => Surface, number][]} */
const SURFACES = [
  ['a hip roof', () => surfpath.graph({ z: '2 - max(abs(x), abs(y))', ...SQUARE }), 60],
  ['a clamped hill', () => surfpath.graph({ z: 'max(0, 0.5 - x^2 - y^2)', ...SQUARE }), 60],
  ['a cube', () => surfpath.implicit({ f: 'max(abs(x), abs(y), abs(z)) - 1', ...BOX }), 55],
  ['a lake on hills', () => surfpath.graph({ z: '0.2*sin(x)*cos(y)', density: '2 + sign(1 - x^2 - y^2)', ...SQUARE }), 40],
  ['two balls', () => surfpath.implicit({ f: 'min((x-0.5)^2 + y^2 + z^2, (x+0.5)^2 + y^2 + z^2) - 1', ...BOX }), 55],
  ['a bent roof with a bank', () => surfpath.graph({ z: 'abs(x + 0.3*y^2)', density: '1.5 - 0.5*sign(y)', ...SQUARE }), 50],
  [
    'E, F and G that jump',
    () => surfpath.metric({ E: '1 + abs(u)', F: '0.2*sign(v)', G: '1.5 + 0.5*sign(u - v)', u: [-3, 3], v: [-3, 3] }),
    50,
  ],
];

const TRACES = ofAll(20, 60);

for (const [name, make, least] of SURFACES)
  test(`${name}: no shortest path to the end is longer, and the way back returns, seed 6`, () => {
    const surface = make();
    const random = createRandom(6);
    const isImplicit = surface.kind === 'implicit';
    const numbers = (/** @type {number} */ most) => [0, 1, 2].slice(0, isImplicit ? 3 : 2).map(() => random.between(-most, most));
    let converged = 0;
    for (let i = 0; i < TRACES; i++) {
      const [place, direction] = [numbers(1.4), numbers(1)];
      const from = isImplicit ? surface.project(/** @type {any} */ (place)) : place;
      const path = surface.trace(from, direction, 1.2, { points: 4000 });
      if (!path.converged) continue;
      converged++;
      const end = placeOf(path, -1);
      const shortest = surface.shortestPath(placeOf(path, 0), end);
      /* Twice the tolerance of a shortest path. */
      const most = 1.2 + path.lengthError + 2e-9;
      assert.ok(!shortest.converged || shortest.length <= most, `${from} ${direction}: ${shortest.length}`);
      /* By five points in a row, to the fourth power of what is between them, which crosses a crease rarely. */
      const [a, b, c, d] = [-2, -3, -4, -5].map((k) => placeOf(path, k));
      const back = end.map((x, j) => -(25 * x - 48 * a[j] + 36 * b[j] - 16 * c[j] + 3 * d[j]));
      const returned = surface.trace(end, back, 1.2);
      if (!returned.converged) continue;
      const miss = Math.hypot(...subtract(placeOf(returned, -1), placeOf(path, 0)));
      assert.ok(miss < 1e-9, `${from} ${direction}: the way back misses by ${miss}`);
    }
    assert.ok(60 * converged >= least * TRACES, `${converged} of ${TRACES}`);
    surface.dispose();
  });

test('what is not clear ends a trace where it is, and says how much is left', () => {
  /** @type {[string, () => Surface, number[], number[], number][]} */
  const cases = [
    ['a cliff', () => surfpath.graph({ z: 'sign(x)', ...SQUARE }), [-1, 0], [1, 0], 1],
    ['a step', () => surfpath.graph({ z: 'floor(x)', ...SQUARE }), [-0.5, 0], [1, 0], 0.5],
    ['steps of a density', () => surfpath.graph({ z: '0', density: '2 + floor(x)', ...SQUARE }), [-0.5, 0], [1, 0], 0.5],
    ['along a fold', () => surfpath.graph({ z: 'abs(x)', ...SQUARE }), [0, -1], [0, 1], 0],
    ['a corner', () => surfpath.implicit({ f: 'max(abs(x), abs(y), abs(z)) - 1', ...BOX }), [0, 0, 1], [1, 1, 0], Math.SQRT2],
    ['grazing', () => surfpath.graph({ z: '0', density: '2 - sign(1 - x^2 - y^2)', ...SQUARE }), [1, -0.5], [0, 1], 1.5],
  ];
  for (const [name, make, from, direction, at] of cases) {
    const surface = make();
    const path = surface.trace(from, direction, 2.5, { points: 9 });
    assert.equal(path.status, 'tolerance-not-met', name);
    assert.ok(Math.abs(path.length - at) < 1e-6, `${name}: ${path.length}`);
    assert.ok(path.length + path.lengthError >= 2.5 && path.points.length === 33, name);
    assert.ok(path.points.every(Number.isFinite));
    surface.dispose();
  }
});

test('a floor that makes no jump does not end a trace', () => {
  const [broken, whole] = ['x - floor(x)', 'x'].map((x) => surfpath.graph({ z: `sin(2*pi*(${x}))/8`, ...SQUARE }));
  const [one, other] = [broken, whole].map((surface) => surface.trace([-0.5, 0], [1, 0.2], 3));
  assert.ok(one.converged);
  assert.ok(Math.hypot(...subtract(placeOf(one, -1), placeOf(other, -1))) < one.lengthError + other.lengthError);
  broken.dispose();
  whole.dispose();
});

test('points are equally spaced over all sides, on the surface, and begin where they should', () => {
  const roof = surfpath.graph({ z: 'abs(x)', ...SQUARE });
  for (const points of [1, 2, 3, 64, 500]) {
    const path = roof.trace([-1, 0.1], [1, 0.3], 2.5, { points });
    assert.deepEqual(placeOf(path, 0), [-1, 0.1]);
    assert.equal(path.points.length, 3 * (points + 2));
    const positions = roof.evaluate(/** @type {Float64Array} */ (path.parameters));
    for (let i = 0; i < points + 2; i++) {
      assert.deepEqual(Array.from(positions.slice(6 * i, 6 * i + 3)), Array.from(path.points.slice(3 * i, 3 * i + 3)));
      const [x, y] = placeOf(path, i);
      /* Unfolded, from the start. */
      const away = Math.hypot((x + 1) * Math.SQRT2, y - 0.1);
      assert.ok(Math.abs(away - (2.5 * i) / (points + 1)) < 1e-14, `point ${i} of ${points}`);
    }
    assert.equal(path.conjugate, null);
    assert.ok(path.iterations > 0 && path.index === -1 && path.history.length === 0);
  }
  roof.dispose();
});

const TORUS = { x: '(4+1.5*cos(v))*cos(u)', y: '(4+1.5*cos(v))*sin(u)', z: '1.5*sin(v)', u: [0, '2pi'], v: [0, '2pi'] };

test('a crease that is never met changes nothing, however long the trace', () => {
  const [plain, creased] = [{}, { density: 'max(1, 0.5 + 0.1*cos(u))' }].map((more) =>
    surfpath.parametric(/** @type {any} */ ({ ...TORUS, ...more })),
  );
  const [one, other] = [plain, creased].map((surface) => surface.trace([0.3, 0.4], [1, 0.37], 300));
  assert.equal(other.status, 'converged');
  assert.ok(Math.hypot(...subtract(placeOf(one, -1), placeOf(other, -1))) <= one.lengthError);
  assert.ok(Math.abs(Number(one.conjugate) - Number(other.conjugate)) < 1e-9);
  plain.dispose();
  creased.dispose();
});

test('a crease that is met seldom is not stepped over: the ends of what was traced in parts are the same', () => {
  const bump = '1 + max(0, exp(-300*((cos(u)-cos(1))^2 + (sin(u)-sin(1))^2 + (v-0.2)^2)) - 0.5)';
  const surface = surfpath.parametric(/** @type {any} */ ({ ...TORUS, v: [-1, 1], density: bump }));
  const long = surface.trace([0.3, 0.4], [1, 0.37], 200, { points: 39_999 });
  assert.equal(long.status, 'converged');
  const plain = surfpath.parametric(/** @type {any} */ ({ ...TORUS, v: [-1, 1] }));
  const missed = plain.trace([0.3, 0.4], [1, 0.37], 200);
  assert.ok(Math.hypot(...subtract(placeOf(missed, -1), placeOf(long, -1))) > 0.01, 'it is met');
  for (let k = 0; k < 40; k++) {
    const [from, next, third, end] = [0, 1, 2, 1000].map((i) => placeOf(long, 1000 * k + i));
    /* Of chords of a two-hundredth, to the second power of that. */
    const part = surface.trace(
      from,
      from.map((x, j) => -3 * x + 4 * next[j] - third[j]),
      5,
    );
    assert.ok(Math.hypot(...subtract(placeOf(part, -1), end)) < 1e-3, `part ${k}`);
  }
  plain.dispose();
  surface.dispose();
});

test('along a bank, thrown back again and again: no end of which nothing is known is converged', () => {
  const lake = surfpath.graph({ z: '0', density: '1.5 + 0.5*sign(1 - x^2 - y^2)', ...SQUARE });
  assert.equal(lake.trace([0.9, 0], [0, 1], 10).status, 'converged');
  assert.equal(lake.trace([0.9999, 0], [0, 1], 20).status, 'tolerance-not-met');
  const most = lake.trace([0.999999, 0], [0, 1], 20);
  assert.ok(most.status === 'iteration-limit' && most.length < 20);
  lake.dispose();
});

test('where a surface hangs together in a point traces hold as far as they meet no crease', () => {
  const cone = surfpath.parametric({ x: 'v*cos(u)', y: 'v*sin(u)', z: 'v', u: [0, '2pi'], v: [-2, 2], density: '1.5 + 0.5*sign(y)' });
  assert.equal(cone.trace([1, 1], [1, 0], 0.5).status, 'converged');
  const across = cone.trace([3, 1], [1, 0], 0.5);
  assert.deepEqual([across.status, across.lengthError], ['tolerance-not-met', 0.5]);
  cone.dispose();
  const stepped = surfpath.parametric({ x: 'v*cos(u)', y: 'v*sin(u)', z: 'v', u: [0, '2pi'], v: [-2, 2], density: '1 + floor(2v)^2' });
  assert.deepEqual(
    [0.4, 0.6].map((v) => stepped.trace([1, v], [0, 1], 0.2).status),
    ['tolerance-not-met', 'converged'],
  );
  stepped.dispose();
});

for (const [name, x0, size, unit] of /** @type {[string, number, number, number][]} */ ([
  ['slowness of ten kilometres', 0, 5000, 1 / 6000],
  ['a density of 1e-5', 0, 3, 1e-5],
  ['the same in metres of a map', 4e6, 5000, 1e-5],
]))
  test(`in units of any size a jump is seen, by traces and by paths: ${name}`, () => {
    const surface = surfpath.graph({
      z: 0,
      x: [x0 - size, x0 + size],
      y: [-size, size],
      density: 'slow*(1.5 + 0.5*sign(x - at))',
      parameters: { slow: unit, at: x0 },
    });
    /* From a density of 1 to one of 2: sines are halved. */
    const random = createRandom(8);
    for (let i = 0; i < 8; i++) {
      const [before, after, angle] = [random.between(0.1, 0.6) * size, random.between(0.1, 0.6) * size, random.between(-0.6, 0.6)];
      const [sine, refracted] = [Math.sin(angle), Math.sin(angle) / 2];
      const [one, two] = [before / Math.cos(angle), after / Math.sqrt(1 - refracted * refracted)];
      const [from, to] = [
        [x0 - before, 0],
        [x0 + after, one * sine + two * refracted],
      ];
      const length = unit * (one + 2 * two);
      const path = surface.shortestPath(from, to);
      assert.equal(path.status, 'converged');
      assert.ok(Math.abs(path.length / length - 1) < 2e-9, `${path.length}, not ${length}`);
      const trace = surface.trace(from, [Math.cos(angle), sine], length);
      assert.equal(trace.status, 'converged');
      const miss = Math.hypot(...subtract(placeOf(trace, -1), to));
      assert.ok(unit * miss <= trace.lengthError && trace.lengthError < 1e-9 * length, `${miss * unit}, says ${trace.lengthError}`);
    }
    surface.dispose();
  });

test('where what vanishes jumps itself, as an angle does, a trace ends', () => {
  const surface = surfpath.graph({ z: 0, x: [-30, 30], y: [-30, 30], density: '1.5 - 0.5*sign(atan2(y, x))' });
  const random = createRandom(9);
  for (let i = 0; i < 20; i++) {
    const from = [random.between(-5, -1), random.between(-0.5, -0.1)];
    const path = surface.trace(from, [random.between(-0.3, 0.3), 1], 3);
    assert.equal(path.status, 'tolerance-not-met');
    assert.ok(
      Math.hypot(...subtract(placeOf(path, -1), from)) <= path.length && path.length + path.lengthError >= 3,
      `${path.lengthError}`,
    );
  }
  surface.dispose();
});

test('creases that follow each other closely are not stepped over in a long rectangle', () => {
  const surface = surfpath.graph({ z: 0, x: [0, 1000], y: [-1000, 1000], density: '1 + 0.1*sign(sin(3x + 0.5))' });
  const densityAt = (/** @type {number} */ at) => 1 + 0.1 * Math.sign(Math.sin(3 * at + 0.5));
  const edges = Array.from({ length: 1000 }, (_, k) => (k * Math.PI - 0.5) / 3);
  const random = createRandom(10);
  let known = 0;
  for (let i = 0; i < ofAll(2, 4); i++) {
    let [at, across, left] = [random.between(0, 1), 0, random.between(150, 400)];
    const direction = unit([1, random.between(-0.5, 0.5)]);
    const path = surface.trace([at, 0], direction, left);
    /* By Snell's law from stripe to stripe. */
    const momentum = densityAt(at) * direction[1];
    for (const edge of edges.filter((one) => one > at)) {
      const density = densityAt((at + edge) / 2);
      const [sine, cosine] = [momentum / density, Math.sqrt(1 - (momentum / density) ** 2)];
      const reach = Math.min((edge - at) / cosine, left / density);
      [at, across, left] = [at + reach * cosine, across + reach * sine, left - reach * density];
      if (left <= 0) break;
    }
    const [x, y] = placeOf(path, -1);
    const miss = Math.hypot(x - at, y - across);
    assert.ok(miss <= path.lengthError + 1e-10, `${path.status}: ${miss}, ${path.lengthError}`);
    if (path.converged) known++;
  }
  assert.ok(known > 0);
  surface.dispose();
});

test('as many points as can be asked for', () => {
  const roof = surfpath.graph({ z: 'abs(x)', ...SQUARE });
  assert.equal(roof.trace([-1, 0], [1, 0.5], 3, { points: 100_000 }).points.length, 3 * 100_002);
  roof.dispose();
});

test('a side that ends where its crease does: where the path leads is not known, but there is one', () => {
  const ramp = surfpath.graph({ z: 'max(0, x)^2.5', ...SQUARE });
  const path = ramp.trace([1, 0], [-1, 0.2], 2);
  assert.equal(path.status, 'tolerance-not-met');
  assert.ok(path.points.length > 0 && path.lengthError >= 1);
  ramp.dispose();
});
