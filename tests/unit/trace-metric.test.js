// Traced geodesics where length has a density or a metric: shortest paths traced from their start, closed forms, the open data, conjugate points.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { load } from '../../web/index.js';
import { loadCases } from '../helpers/cases.js';
import { createRandom } from '../helpers/random.js';

const surfpath = await load();
const make = (/** @type {any} */ definition) => surfpath.surface(definition);

const ring = {
  kind: 'parametric',
  x: '(4 + 1.5*cos(v))*cos(u)',
  y: '(4 + 1.5*cos(v))*sin(u)',
  z: '1.5*sin(v)',
  u: [0, '2pi'],
  v: [0, '2pi'],
};
const torus = { kind: 'implicit', f: '(x^2 + y^2 + z^2 + 13.75)^2 - 64*(x^2 + y^2)', bounds: [0, 1, 2].map(() => [-5.7, 5.7]) };
const density = '1 + 0.5*exp(-(x - 1)^2 - y^2) + 0.1*z';
const tensor = { xx: '1 + 0.3*sin(x)', xy: '0.1*y', xz: 0.1, yy: '1.5 + 0.2*cos(z)', yz: '0.1*sin(x*y)', zz: '2 + 0.1*x' };
/** ds² with axes k : 1 that turn by a. @param {number} k @param {string} a */
const turning = (k, a) => ({
  E: `${k}*cos(${a})^2 + sin(${a})^2`,
  F: `(${k} - 1)*sin(${a})*cos(${a})`,
  G: `${k}*sin(${a})^2 + cos(${a})^2`,
});
const halfPlane = { kind: 'metric', E: '1/v^2', F: 0, G: '1/v^2', u: [-9, 9], v: [1e-3, 99] };
const stereographic = '2/(1 + x^2 + y^2)';

const onRing = (/** @type {number} */ u, /** @type {number} */ v) => [
  (4 + 1.5 * Math.cos(v)) * Math.cos(u),
  (4 + 1.5 * Math.cos(v)) * Math.sin(u),
  1.5 * Math.sin(v),
];

/** @param {ArrayLike<number>} a @param {ArrayLike<number>} b */
const apart = (a, b) => Math.hypot(...Array.from(a, (x, i) => x - b[i]));

/** The places of a path: u v, or x y z. @param {import('../../web/index.js').Path} path */
const placesOf = ({ parameters, points }) => Array.from(parameters ?? points);

/** The slope at the first of equally spaced points, by the polynomial through the first twelve. @param {number[]} places @param {number} width */
function slopeAtStart(places, width) {
  const slope = Array(width).fill(0);
  for (let k = 1; k < 12; k++) {
    let weight = 1 / k;
    for (let j = 1; j < 12; j++) if (j !== k) weight *= j / (j - k);
    for (let i = 0; i < width; i++) slope[i] += weight * (places[width * k + i] - places[i]);
  }
  return slope;
}

describe('the start of a shortest path, traced for its length, lands on its end', () => {
  const [near, far, far3] = [[0.3, 0.4], [1.3, 1.9], onRing(1.8, 2.9)];
  /** @type {[string, any, number[], number[]][]} */
  const surfaces = [
    ['density, parametric', { ...ring, density }, near, far],
    ['density over u, v', { ...ring, density: '1 + 0.3*sin(u - v)' }, near, far],
    ['metric, parametric', { ...ring, metric: turning(5, 'u + v') }, near, far],
    ['both, parametric', { ...ring, density, metric: turning(5, 'u + v') }, near, far],
    ['no positions', { kind: 'metric', ...turning(9, '2*u'), u: [-3, 3], v: [-3, 3] }, near, far],
    ['half-plane', halfPlane, [-1.5, 0.14], [2.7, 0.5]],
    ['density, implicit', { ...torus, density }, onRing(0.3, 0.4), far3],
    ['metric, implicit', { ...torus, metric: tensor }, onRing(0.3, 0.4), far3],
    ['both, implicit', { ...torus, density, metric: tensor }, onRing(0.3, 0.4), far3],
  ];
  for (const [what, definition, from, to] of surfaces)
    test(what, () => {
      const surface = make(definition);
      const path = surface.shortestPath(from, to, { start: 'straight', tolerance: 1e-12, points: 255 });
      assert.ok(path.converged, path.status);
      const traced = surface.trace(from, slopeAtStart(placesOf(path), from.length), path.length, { points: 3 });
      assert.ok(traced.converged, traced.status);
      const miss = apart(placesOf(traced).slice(-from.length), placesOf(path).slice(-from.length));
      /* The slope is good to about 1e-10, more or less of which arrives. */
      assert.ok(miss <= 1e-8, `misses by ${miss}`);
      surface.dispose();
    });
});

test('the open data, traced from their start', () => {
  let count = 0;
  for (const { id, definition: own, from, to, expected } of loadCases({ families: 'E' })) {
    const definition = /** @type {any} */ (own);
    const { start_angle: angle, touches_boundary } = /** @type {any} */ (expected);
    if (angle === undefined || touches_boundary) continue;
    const surface = make(definition);
    const form =
      surface.kind === 'metric'
        ? surface
        : definition.metric && make({ ...definition.metric, kind: 'metric', u: definition.u, v: definition.v });
    const [first, second] = form ? [null, null] : tangents(surface, from);
    const [E, F, G] = form ? form.evaluate(from) : [dot(first, first), dot(first, second), dot(second, second)];
    const area = Math.sqrt(E * G - F * F);
    const direction = [
      Math.cos(angle) / Math.sqrt(E) - (Math.sin(angle) * F) / (Math.sqrt(E) * area),
      (Math.sin(angle) * Math.sqrt(E)) / area,
    ];
    const path = surface.trace(from, direction, expected.length, { points: 3 });
    const miss = apart(to, placesOf(path).slice(-2));
    /* The error estimate is of lengths in the metric, the miss in u and v. */
    assert.ok(path.converged && miss <= 1e-9, `${id}: ${path.status}, misses by ${miss}`);
    assert.equal(path.conjugate, null, `${id}: a shortest path has no conjugate point inside`);
    surface.dispose();
    count++;
  }
  assert.ok(count > 30, `${count} cases`);
});

const dot = (/** @type {any} */ a, /** @type {any} */ b) =>
  a.reduce((/** @type {number} */ sum, /** @type {number} */ x, /** @type {number} */ k) => sum + x * b[k], 0);

/** S_u and S_v by central differences of high order. @param {any} surface @param {number[]} place */
function tangents(surface, place) {
  const at = (/** @type {number} */ j, /** @type {number} */ by) =>
    Array.from(surface.evaluate(place.map((x, i) => (i === j ? x + by : x)))).slice(0, 3);
  const h = 1e-3;
  return [0, 1].map((j) => at(j, h).map((_, k) => (8 * (at(j, h)[k] - at(j, -h)[k]) - (at(j, 2 * h)[k] - at(j, -2 * h)[k])) / (12 * h)));
}

test('the hyperbolic plane: rays and half circles in the half-plane, diameters of the disc', () => {
  const half = make(halfPlane);
  const [, height] = placesOf(half.trace([0.5, 1], [0, 1], 3)).slice(-2);
  assert.ok(Math.abs(height / Math.exp(3) - 1) < 1e-11, `a ray ends at ${height}`);
  const circle = half.trace([0.5, 1], [1, 0], 2);
  const [u, v] = placesOf(circle).slice(-2);
  assert.ok(Math.abs(u - 0.5 - Math.tanh(2)) < 1e-11 && Math.abs(v - 1 / Math.cosh(2)) < 1e-11, `a circle ends at ${u}, ${v}`);
  assert.deepEqual([circle.points.length, circle.conjugate, circle.converged], [0, null, true]);
  const disc = make({ kind: 'parametric', x: 'u', y: 'v', z: 0, u: [-1, 1], v: [-1, 1], density: '2/(1 - x^2 - y^2)' });
  const [x, y] = disc.trace([0, 0], [3, 4], 1.5).points.subarray(-3);
  assert.ok(Math.abs(x - 0.6 * Math.tanh(0.75)) < 1e-11 && Math.abs(y - 0.8 * Math.tanh(0.75)) < 1e-11, `a diameter ends at ${x}, ${y}`);
});

test('the sphere by its metric, and by the density of a plane: conjugate at pi', () => {
  const cube = [0, 1, 2].map(() => [-20, 20]);
  /** @type {[any, number[], number[]][]} */
  const spheres = [
    [{ kind: 'metric', E: 'cos(v)^2', F: 0, G: 1, u: [-9, 9], v: [-1.5, 1.5] }, [0, 0.4], [1, 0.3]],
    [{ kind: 'parametric', x: 'u', y: 'v', z: 0, u: [-20, 20], v: [-20, 20], density: stereographic }, [0.4, 0.2], [-0.5, 1]],
    [{ kind: 'implicit', f: 'z', bounds: cube, density: stereographic }, [0.4, 0.2, 0], [-0.5, 1, 0]],
  ];
  for (const [definition, from, direction] of spheres) {
    const path = make(definition).trace(from, direction, 4);
    assert.ok(path.converged && Math.abs(Number(path.conjugate) - Math.PI) < 1e-10, `${definition.kind}: ${path.status} ${path.conjugate}`);
  }
});

test('the same density in parametric and implicit form: the same way, the same conjugate point', () => {
  const [chart, level] = [make({ ...ring, density }), make({ ...torus, density })];
  const one = chart.trace([0.3, 0.4], [1, 1], 25);
  const jet = tangents(chart, [0.3, 0.4]);
  const other = level.trace(
    onRing(0.3, 0.4),
    [0, 1, 2].map((k) => jet[0][k] + jet[1][k]),
    25,
  );
  assert.ok(apart(one.points.subarray(-3), other.points.subarray(-3)) < 1e-7);
  assert.ok(one.conjugate !== null && Math.abs(one.conjugate - Number(other.conjugate)) < 1e-7, `${one.conjugate} ${other.conjugate}`);
});

test('four times the metric of space: twice as long; conjugate points are not looked for', () => {
  const sphere = { kind: 'implicit', f: 'x^2 + y^2 + z^2 - 1' };
  const scaled = make({ ...sphere, metric: { xx: '4 + 0x', xy: 0, xz: 0, yy: 4, yz: 0, zz: 4 } });
  const [long, short] = [scaled.trace([1, 0, 0], [0, 1, 1], 8), make(sphere).trace([1, 0, 0], [0, 1, 1], 4)];
  assert.ok(apart(long.points.subarray(-3), short.points.subarray(-3)) < 1e-11);
  assert.deepEqual([long.conjugate, short.conjugate && short.conjugate < 4], [null, true]);
});

test('a metric that is none, at the start and ahead, is singular', () => {
  const plane = { kind: 'parametric', x: 'u', y: 'v', z: 0, u: [-1, 1], v: [-1, 1] };
  for (const own of [{ density: 'x' }, { density: '-1' }, { metric: { E: 'u', F: 0, G: 1 } }])
    assert.equal(make({ ...plane, ...own }).trace([-0.5, 0.1], [1, 0.1], 1).status, 'singular-metric', JSON.stringify(own));
  assert.equal(make({ ...plane, metric: { E: 'u', F: 0, G: 1 } }).trace([0.5, 0.1], [-1, 0], 2).status, 'singular-metric');
});

test('a hyperboloid in the space of special relativity, whose metric is one on the surface only: the hyperbolic plane, seed 4', () => {
  const random = createRandom(4);
  const metric = { xx: 1, xy: 0, xz: 0, yy: 1, yz: 0, zz: -1 };
  const plane = make({
    kind: 'implicit',
    f: 'x^2 + y^2 - z^2 + 1',
    bounds: [
      [-9, 9],
      [-9, 9],
      [0.5, 13],
    ],
    metric,
  });
  for (let i = 0; i < 20; i++) {
    const [x, y, angle, length] = [
      random.between(-2, 2),
      random.between(-2, 2),
      random.between(-Math.PI, Math.PI),
      random.between(0.1, 1.2),
    ];
    const [z, p, q] = [Math.sqrt(1 + x * x + y * y), Math.cos(angle), Math.sin(angle)];
    const direction = [p, q, (x * p + y * q) / z];
    const speed = Math.sqrt(1 - direction[2] ** 2);
    const path = plane.trace([x, y, z], direction, length);
    const end = [x, y, z].map((at, j) => at * Math.cosh(length) + (direction[j] / speed) * Math.sinh(length));
    assert.ok(path.converged && apart(path.points.slice(-3), end) <= 1e-9, `${path.status} ${path.points.slice(-3)}, not ${end}`);
    const back = plane.shortestPath([x, y, z], end);
    assert.ok(back.converged && Math.abs(back.length - length) <= 1e-8, `${back.status} ${back.length}, not ${length}`);
  }
  plane.dispose();
});
