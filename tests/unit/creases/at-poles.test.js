// Creases that pass poles of polar coordinates, or near them: as long as where the same surface is written without a pole.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { load } from '../../../web/index.js';
import { createRandom } from '../../helpers/random.js';
import { close } from '../../helpers/refuses.js';
import { ofAll } from '../../helpers/sample.js';

const surfpath = await load();

/** @param {number[]} place an angle, and how far from the pole */
const unrolled = ([u, v]) => [v * Math.cos(u), v * Math.sin(u)];

test('a sheet folded beside the pole: as long as unfolded, and not through the pole', () => {
  const disc = {
    x: 'v*cos(u)',
    y: 'v*sin(u)',
    u: /** @type {[number, string]} */ ([0, '2pi']),
    v: /** @type {[number, number]} */ ([0, 2]),
  };
  const sheet = surfpath.parametric({ ...disc, z: 'abs(v*cos(u) + x0)', parameters: { x0: 0 } });
  for (const x0 of [0, 0.05]) {
    sheet.set({ x0 });
    for (const [from, to] of [
      [
        [1.22, 0.7],
        [4.39, 0.1],
      ],
      [
        [4.86, 1.4],
        [8.01, 0.2],
      ],
    ]) {
      const [a, b] = [unrolled(from), unrolled(to)];
      const length = Math.hypot(Math.SQRT2 * (a[0] - b[0]), a[1] - b[1]);
      const paths = [sheet.shortestPath(from, to), ...sheet.geodesics(from, to)];
      assert.equal(paths.length, 2, `${from} to ${to}`);
      for (const path of paths) {
        assert.equal(path.status, 'converged');
        close(path.length, length, 1e-12);
      }
    }
  }
  sheet.dispose();
});

test('a density with creases around a pole, however it is written: as long as over x and y, both ways to the bit', () => {
  const density = '(1 + abs(v*cos(u) - 0.1) + abs(v*sin(u)))';
  const u = /** @type {[number, string]} */ ([0, '2pi']);
  const v = /** @type {[number, number]} */ ([0, 2]);
  const disc = { x: 'v*cos(u)', y: 'v*sin(u)', z: 0, u, v };
  const tensor = { E: `(v*${density})^2`, F: 0, G: `${density}^2` };
  const inSpace = '1 + abs(x - 0.1) + abs(y)';
  const plane = surfpath.graph({ z: 0, x: [-2, 2], y: [-2, 2], density: inSpace });
  const same = (/** @type {number[]} */ place) => place;
  /** @type {[import('../../../web/index.js').Surface, (place: number[]) => number[]][]} */
  const written = [
    [surfpath.parametric({ ...disc, density }), same],
    [surfpath.parametric({ ...disc, metric: tensor, periodic: { u: true } }), same],
    [surfpath.metric({ ...tensor, u, v, periodic: { u: true } }), same],
    [surfpath.revolution({ r: 't', z: 0, t: [0, 2], density: '1 + abs(t*cos(u) - 0.1) + abs(y)' }), same],
    [surfpath.parametric({ x: '-u*cos(v)', y: '-u*sin(v)', z: 0, u: [-2, 0], v: u, density: inSpace }), ([angle, away]) => [-away, angle]],
    [
      surfpath.parametric({ x: 'v*cos(u*pi/180)', y: 'v*sin(u*pi/180)', z: 0, u: [-180, 180], v, density: inSpace }),
      ([angle, away]) => [(180 * angle) / Math.PI, away],
    ],
  ];
  const random = createRandom(11);
  for (let i = 0; i < ofAll(2, 8); i++) {
    const angle = random.between(0, 2);
    const from = [angle, random.between(0.1, 1.3)];
    const to = [angle + random.between(2.9, 3.4), random.between(0.1, 1.3)];
    const { status, length } = plane.shortestPath(unrolled(from), unrolled(to));
    assert.equal(status, 'converged');
    for (const [k, [surface, at]] of written.entries()) {
      const [a, b] = [at(from), at(to)];
      const path = surface.shortestPath(a, b);
      assert.equal(path.status, 'converged', `${k}: ${a} to ${b}`);
      close(path.length, length, 1e-9);
      assert.equal(surface.shortestPath(b, a).length, path.length);
      assert.deepEqual([...(path.parameters ?? []).slice(0, 2)], a);
    }
  }
  for (const surface of [plane, ...written.map(([surface]) => surface)]) surface.dispose();
});

test('a globe: past either pole as long as on the sphere where it is implicit', () => {
  const v = /** @type {[string, string]} */ (['-pi/2', 'pi/2']);
  const globe = surfpath.parametric({ x: 'cos(u)*cos(v)', y: 'sin(u)*cos(v)', z: 'sin(v)', u: [0, '2pi'], v, density: '1 + abs(y)' });
  const side = /** @type {[number, number]} */ ([-1.1, 1.1]);
  const sphere = surfpath.implicit({ f: 'x^2 + y^2 + z^2 - 1', bounds: [side, side, side], density: '1 + abs(y)' });
  const inSpace = (/** @type {number[]} */ [u, v]) => [Math.cos(u) * Math.cos(v), Math.sin(u) * Math.cos(v), Math.sin(v)];
  const random = createRandom(5);
  for (let i = 0; i < 4; i++) {
    const [angle, up] = [random.between(0, 3), i % 2 ? -1 : 1];
    const from = [angle, up * random.between(0.6, 1.5)];
    const to = [angle + random.between(3.06, 3.22), up * random.between(0.6, 1.5)];
    const path = globe.shortestPath(from, to);
    assert.equal(path.status, 'converged', `${from} to ${to}`);
    close(path.length, sphere.shortestPath(inSpace(from), inSpace(to)).length, 1e-9);
  }
  for (const surface of [globe, sphere]) surface.dispose();
});
