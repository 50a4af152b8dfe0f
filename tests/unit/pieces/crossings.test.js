// Implicit surfaces that cross themselves along curves: paths that go on in one sheet or another, against closed forms, and legs on sheets that are given by u and v.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { load } from '../../../web/index.js';
import { createRandom } from '../../helpers/random.js';
import { ofAll } from '../../helpers/sample.js';
import { close } from '../../helpers/refuses.js';

const surfpath = await load();

/** @param {number} size @returns {[[number, number], [number, number], [number, number]]} */
const within = (size) => [
  [-size, size],
  [-size, size],
  [-size, size],
];

/** The least value of a function of one number that has one minimum. @param {(x: number) => number} f @param {number} low @param {number} high */
function least(f, low, high) {
  const golden = (Math.sqrt(5) - 1) / 2;
  let [a, b] = [low, high];
  for (let i = 0; i < 90; i++) {
    const [left, right] = [b - golden * (b - a), a + golden * (b - a)];
    if (f(left) < f(right)) b = right;
    else a = left;
  }
  return f((a + b) / 2);
}

describe('two planes that cross', () => {
  const random = createRandom(7);
  const planes = { f: 'x^2 - y^2', bounds: within(1.5) };
  const draw = () => {
    const [r, side] = [random.between(-1.4, 1.4), random.between(0, 1) < 0.5 ? -1 : 1];
    return [r, side * r, random.between(-1, 1)];
  };
  for (const [where, definition] of Object.entries({ 'in a box': planes, 'without bounds': { f: planes.f } }))
    test(`${where}: as long as unfolded, from any half plane to any, both ways to the bit`, () => {
      const surface = surfpath.implicit(definition);
      const pairs = Array.from({ length: 6 }, () => [draw(), draw()]);
      for (const [from, to] of pairs.slice(0, ofAll(3, 6))) {
        const isOne = [0, 1].every((j) => Math.sign(from[j]) === Math.sign(to[j]));
        const [a, b] = [from, to].map(([x, y]) => Math.hypot(x, y));
        const path = surface.shortestPath(from, to);
        assert.equal(path.status, 'converged', `${from} to ${to}`);
        close(path.length, Math.hypot(isOne ? a - b : a + b, from[2] - to[2]), 1e-9);
        assert.equal(surface.shortestPath(to, from).length, path.length);
      }
      surface.dispose();
    });
});

test('three planes: over one of the lines in which they cross, though ways of the graph lead by the point where all meet', () => {
  const surface = surfpath.implicit({ f: 'x*y*z', bounds: within(1.5) });
  const [from, to] = [
    [0.84, 0.19, 0],
    [0, -0.75, 0.63],
  ];
  const path = surface.shortestPath(from, to);
  assert.equal(path.status, 'converged');
  close(path.length, Math.hypot(0.84 + 0.63, 0.19 + 0.75), 1e-9);
  surface.dispose();
});

test('two spheres: over the circle in which they cross, as long as trigonometry says', () => {
  const surface = surfpath.implicit({ f: '((x - 0.5)^2 + y^2 + z^2 - 1)*((x + 0.5)^2 + y^2 + z^2 - 1)', bounds: within(1.8) });
  const [a, b] = [0.9, 2.3];
  const [from, to] = [
    [0.5 + Math.cos(a), Math.sin(a), 0],
    [-0.5 + Math.cos(b) * 0.6, Math.sin(b) * 0.6, 0.8],
  ];
  const along = (/** @type {number} */ side, /** @type {number[]} */ place, /** @type {number} */ t) => {
    const on = [-side / 2, Math.sqrt(0.75) * Math.cos(t), Math.sqrt(0.75) * Math.sin(t)];
    return Math.acos(on[0] * (place[0] - side / 2) + on[1] * place[1] + on[2] * place[2]);
  };
  const path = surface.shortestPath(from, to);
  assert.equal(path.status, 'converged');
  close(
    path.length,
    least((t) => along(1, from, t) + along(-1, to, t), 0, Math.PI / 2),
    1e-9,
  );
  surface.dispose();
});

test('Whitney’s umbrella: over its handle to the other side of the sheet, and to the other sheet', () => {
  const umbrella = surfpath.implicit({ f: 'x^2 - y^2*z', bounds: within(2) });
  const sheet = surfpath.parametric({ x: 'u*v', y: 'u', z: 'v^2', u: [-1, 1], v: [0.1, 1.5] });
  const at = (/** @type {number} */ u, /** @type {number} */ v) => [u * v, u, v * v];
  const half = (/** @type {number} */ u, /** @type {number} */ v, /** @type {number} */ to) => sheet.shortestPath([u, v], [0, to]).length;
  for (const side of [-1, 1]) {
    const path = umbrella.shortestPath(at(0.5, 1), side < 0 ? at(-0.6, 0.8) : at(0.6, -0.8));
    assert.equal(path.status, 'converged');
    /* The other sheet is the mirror image of this one. */
    close(
      path.length,
      least((to) => half(0.5, 1, to) + half(0.6, 0.8, to), 0.5, 1.2),
      1e-9,
    );
  }
  for (const surface of [umbrella, sheet]) surface.dispose();
});

test('Steiner’s Roman surface: a path is no longer than through a place on a line where it crosses itself', () => {
  const roman = surfpath.implicit({ f: 'y^2*z^2 + z^2*x^2 + x^2*y^2 - 1.5*x*y*z', bounds: within(1) });
  const random = createRandom(3);
  const draw = () => {
    const [z, angle] = [random.between(-1, 1), random.between(-3, 3)];
    const r = Math.sqrt(1 - z * z);
    const [x, y] = [r * Math.cos(angle), r * Math.sin(angle)];
    return [1.5 * y * z, 1.5 * z * x, 1.5 * x * y];
  };
  for (let i = 0; i < ofAll(1, 2); i++) {
    const [from, to] = [draw(), draw()];
    const path = roman.shortestPath(from, to);
    assert.equal(path.status, 'converged', `${from} to ${to}`);
    for (let j = 0; j < 3; j++) {
      const place = [0, 1, 2].map((k) => (k === j % 3 ? random.between(-0.7, 0.7) : 0));
      const through = roman.shortestPath(from, to, { via: [place] });
      assert.ok(!(through.length < path.length * (1 - 1e-6)), `${from} to ${to} through ${place}: ${through.length} < ${path.length}`);
    }
  }
  roman.dispose();
});

test('straight over a crossing a path is one, from face to face of a plate however thin it is none', () => {
  const planes = surfpath.implicit({ f: 'x*y*z', bounds: within(1.5) });
  for (const options of [{}, { algorithm: /** @type {'polyline'} */ ('polyline') }]) {
    const path = planes.shortestPath([-0.7, 0.4, 0], [0.84, 0.193, 0], { start: 'straight', ...options });
    assert.equal(path.status, 'converged');
    close(path.length, Math.hypot(1.54, 0.207), 1e-9);
    for (const half of [1e-2, 1e-5, 1e-7, 1e-9]) {
      const plate = surfpath.implicit({ f: `z^2 - ${half ** 2}`, bounds: within(1.5) });
      assert.equal(plate.shortestPath([0, 0, half], [1, 0.3, -half], { start: 'straight', ...options }).status, 'sheet-jump', `${half}`);
      plate.dispose();
    }
  }
  planes.dispose();
});

test('a Klein bottle: over the circle in which it crosses itself, no path is longer than through a place on it', () => {
  const bottle = surfpath.implicit({
    f: '(x^2 + y^2 + z^2 + 2y - 1)*((x^2 + y^2 + z^2 - 2y - 1)^2 - 8z^2) + 16x*z*(x^2 + y^2 + z^2 - 2y - 1)',
    bounds: within(4.5),
  });
  const pairs = [
    [
      [-2.039778892, -1.681465229, 1.278023895],
      [0.367406241, 2.737411734, 0.56692585],
    ],
    [
      [1.055513402, -2.047075724, -1.703030937],
      [0.613010401, 2.787483712, 1.270164979],
    ],
    [
      [-2.339696173, 1.685264972, 1.03831902],
      [2.207790778, -1.119180816, -2.441087334],
    ],
  ];
  const lengths = pairs.map(([from, to], i) => {
    const path = bottle.shortestPath(from, to);
    assert.equal(path.status, 'converged', `pair ${i}`);
    for (const angle of [0.3, 2.8, 4.3]) {
      const place = [Math.SQRT2 * Math.cos(angle), 1 + Math.SQRT2 * Math.sin(angle), 0];
      const through = bottle.shortestPath(from, to, { via: [place] });
      assert.ok(!(through.length < path.length * (1 - 1e-6)), `pair ${i} through ${place}: ${through.length} < ${path.length}`);
    }
    return path.length;
  });
  /* Over two places of the circle: one way that was followed over one of these alone is 0.0545 longer. */
  close(lengths[0], 5.998956561377724, 1e-9);
  bottle.dispose();
});
