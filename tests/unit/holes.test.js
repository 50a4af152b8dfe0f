// Edges that are almost a point, as where 3.14 stands for π: paths wind around them, pass them, and cross a pole that lies within the rectangle. Against spherical
// trigonometry, and against the same surface in its own range.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { load } from '../../web/index.js';
import { allowance } from '../helpers/allowance.js';
import { createRandom } from '../helpers/random.js';

const surfpath = await load();
/** The tolerance that is asked for by default. */
const RIGHT = 1e-9;
const PAIRS = 24;

/** A unit sphere by colatitude and longitude. @param {number} least of the colatitude @param {number} most @param {number} around the longitude's range */
const sphere = (least, most, around) =>
  surfpath.parametric({ x: 'sin(u) cos(v)', y: 'sin(u) sin(v)', z: 'cos(u)', u: [least, most], v: [0, around] });

/**
 * The shortest way on the unit sphere between two places, colatitude and longitude, that winds by an angle around caps cut off at both poles.
 * @param {number[]} from @param {number[]} to @param {number} angle @param {number[]} radii of the caps
 */
function wayBetween([a], [b], angle, radii) {
  const apart = Math.abs(angle);
  const around = radii.flatMap((radius, end) => {
    const away = [a, b].map((colatitude) => (end ? Math.PI - colatitude : colatitude));
    const turned = away.map((x) => Math.acos(Math.tan(radius) / Math.tan(x)));
    const rest = apart - turned[0] - turned[1];
    const tangents = away.map((x) => Math.acos(Math.cos(x) / Math.cos(radius)));
    return rest > 0 ? [tangents[0] + tangents[1] + rest * Math.sin(radius)] : [];
  });
  const cosine = Math.cos(a) * Math.cos(b) + Math.sin(a) * Math.sin(b) * Math.cos(apart);
  return around.length > 0 ? Math.min(...around) : Math.acos(cosine);
}

/** @param {number} seed @param {number[]} low @param {number[]} high */
function* randomPairs(seed, low, high) {
  const random = createRandom(seed);
  const place = () => low.map((x, j) => random.between(x, high[j]));
  for (let i = 0; i < PAIRS; i++) yield [place(), place()];
}

describe('a sphere whose range is not quite that of a sphere', () => {
  for (const [most, around] of [
    [3.14, 6.28],
    [3.14, 6.2],
    [3.1, 6.2],
    [Math.PI - 2.7e-6, 2 * Math.PI - 5.3e-6],
    [3, 5],
  ])
    test(`colatitude up to ${most}, longitude up to ${around}: every path converges, to the length that trigonometry gives, seed 1`, () => {
      const surface = sphere(0.002, most, around);
      for (const [from, to] of randomPairs(1, [0.01, 0], [most - 1e-4, around])) {
        const path = surface.shortestPath(from, to);
        const length = wayBetween(from, to, to[1] - from[1], [0.002, Math.PI - most]);
        assert.equal(path.status, 'converged', `${from} to ${to}`);
        assert.ok(Math.abs(path.length / length - 1) <= RIGHT, `${from} to ${to}: ${path.length}, not ${length}`);
        // 1e-14: the rounding of the trigonometry.
        assert.ok(Math.abs(path.length - length) <= path.lengthError + 1e-14, `${from} to ${to}: an error of ${path.length - length}`);
        assert.equal(surface.shortestPath(to, from).length, path.length);
      }
    });

  test('closed around: a path between places opposite to each other touches the hole or passes it, seed 2', () => {
    const surface = sphere(0.002, Math.PI - 0.002, 2 * Math.PI);
    const random = createRandom(2);
    let touching = 0;
    for (let i = 0; i < PAIRS; i++) {
      const [from, to] = [
        [random.between(0.1, 1.2), random.between(0, 3)],
        [random.between(0.1, 1.2), 0],
      ];
      const angle = Math.PI - random.between(0, 0.02);
      to[1] = from[1] + angle;
      const path = surface.shortestPath(from, to);
      const length = wayBetween(from, to, angle, [0.002, 0.002]);
      assert.equal(path.status, 'converged', `${from} to ${to}`);
      assert.ok(Math.abs(path.length / length - 1) <= RIGHT, `${from} to ${to}: ${path.length}, not ${length}`);
      touching += Number(path.touchesBoundary);
    }
    assert.ok(touching > 5 && touching < PAIRS - 5, `${touching} touch`);
  });

  test('closed around: exactly half a turn apart it goes around the hole, not through its middle', () => {
    const surface = sphere(0.002, Math.PI - 0.002, 2 * Math.PI);
    for (const [a, b] of [
      [0.5, 0.7],
      [1, 1.2],
      [2.1, 2.9],
    ]) {
      const path = surface.shortestPath([a, 0.3], [b, 0.3 + Math.PI]);
      const length = wayBetween([a], [b], Math.PI, [0.002, 0.002]);
      assert.equal(path.touchesBoundary, true);
      assert.ok(Math.abs(path.length / length - 1) <= RIGHT, `${path.length}, not ${length}`);
    }
  });

  test('the pole within the rectangle: over it where a slit is in the way, seed 3', () => {
    const surface = sphere(0, Math.PI + 7e-6, 6.28);
    for (const [from, to] of randomPairs(3, [0.1, 0], [3, 6.28])) {
      const path = surface.shortestPath(from, to);
      const length = wayBetween(from, to, to[1] - from[1], [0, 0]);
      assert.equal(path.status, 'converged', `${from} to ${to}`);
      assert.ok(Math.abs(path.length / length - 1) <= RIGHT, `${from} to ${to}: ${path.length}, not ${length}`);
    }
  });
});

/** By positions, and as lengths alone: its contacts with the rim are shorter than the chords that first look for them. @type {Record<string, import('../../web/instance.js').AnyDefinition>} */
const MERCATOR = {
  'of space': { kind: 'parametric', x: 'cos(u)/cosh(v)', y: 'sin(u)/cosh(v)', z: 'tanh(v)', u: ['-pi', 'pi'], v: [-5, 5] },
  'by E, F, G': { kind: 'metric', E: '1/cosh(v)^2', F: 0, G: '1/cosh(v)^2', u: ['-pi', 'pi'], v: [-5, 5], periodic: { u: true } },
};
for (const [name, definition] of Object.entries(MERCATOR))
  test(`a sphere by Mercator, cut off far from its poles, ${name}: the shorter way past the hole, which rough chords cannot tell from the other, seed 5`, () => {
    const surface = surfpath.surface(definition);
    const radius = Math.asin(1 / Math.cosh(5));
    const random = createRandom(5);
    let touching = 0;
    for (let i = 0; i < PAIRS; i++) {
      const from = [random.between(-Math.PI, Math.PI), random.between(-2, 2)];
      const angle = Math.PI - random.between(0, 0.03);
      const to = [from[0] + (i % 2 ? angle : -angle), random.between(-2, 2)];
      const path = surface.shortestPath(from, to);
      const [a, b] = [from, to].map(([, v]) => [Math.acos(Math.tanh(v)), 0]);
      const length = wayBetween(a, b, angle, [radius, radius]);
      assert.equal(path.status, 'converged', `${from} to ${to}`);
      assert.ok(Math.abs(path.length / length - 1) <= RIGHT, `${from} to ${to}: ${path.length}, not ${length}`);
      touching += Number(path.touchesBoundary);
    }
    assert.ok(touching > PAIRS / 4, `${touching} touch the hole`);
  });

test('an ellipsoid with tips cut off: as the whole one, where its paths pass them, seed 4', () => {
  const axes = { x: '3 cos(v) cos(u)', y: '2 cos(v) sin(u)', z: 'sin(v)' };
  const cut = surfpath.parametric({ ...axes, u: ['-pi', 'pi'], v: [-1.57, 1.57] });
  const whole = surfpath.parametric({ ...axes, u: ['-pi', 'pi'], v: ['-pi/2', 'pi/2'] });
  for (const [from, to] of randomPairs(4, [-3, -1.5], [3, 1.5])) {
    const [path, other] = [cut, whole].map((surface) => surface.shortestPath(from, to));
    assert.equal(path.status, 'converged', `${from} to ${to}`);
    // Around a hole of 8e-4 a path is longer than over the pole by its square over the ends' distances from it, 0.07 and more.
    if (path.touchesBoundary) assert.ok(path.length >= other.length && path.length < other.length * (1 + 1e-5), `${from} to ${to}`);
    else assert.ok(Math.abs(path.length / other.length - 1) <= RIGHT, `${from} to ${to}: ${path.length}, not ${other.length}`);
  }
});

test('a cone with its tip cut off and a slit: as in the plane into which it unrolls', () => {
  const tip = 0.001;
  const surface = surfpath.parametric({ x: 'v cos(u)', y: 'v sin(u)', z: '0.1 v', u: [0, 6.28], v: [tip, 2] });
  const slant = Math.sqrt(1.01);
  for (const [from, to] of randomPairs(5, [0, 0.01], [6.28, 2])) {
    const [a, b, radius] = [from[1] * slant, to[1] * slant, tip * slant];
    const angle = Math.abs(to[0] - from[0]) / slant;
    const rest = angle - Math.acos(radius / a) - Math.acos(radius / b);
    const straight = Math.sqrt(a * a + b * b - 2 * a * b * Math.cos(angle));
    const length = rest > 0 ? Math.sqrt(a * a - radius * radius) + Math.sqrt(b * b - radius * radius) + rest * radius : straight;
    const path = surface.shortestPath(from, to);
    assert.equal(path.status, 'converged', `${from} to ${to}`);
    assert.ok(Math.abs(path.length / length - 1) <= RIGHT, `${from} to ${to}: ${path.length}, not ${length}`);
  }
});

test('a plane with a slit and a small hole, where no curvature is positive: around the hole as the tangents say, at once, seed 8', () => {
  const hole = 0.003;
  const plane = surfpath.parametric({ x: 'v cos(u)', y: 'v sin(u)', z: 0, u: [0, 6.28], v: [hole, 1] });
  plane.shortestPath([0, 1], [1, 1]);
  const random = createRandom(8);
  const start = performance.now();
  for (let i = 0; i < PAIRS / 2; i++) {
    const [from, to] = [
      [random.between(0, 1), random.between(0.2, 1)],
      [random.between(4.5, 6.28), random.between(0.2, 1)],
    ];
    const turned = [from, to].map(([, v]) => Math.acos(hole / v));
    const tangents = [from, to].map(([, v]) => Math.sqrt(v ** 2 - hole ** 2));
    const length = tangents[0] + tangents[1] + hole * (to[0] - from[0] - turned[0] - turned[1]);
    const path = plane.shortestPath(from, to);
    assert.deepEqual([path.status, path.touchesBoundary], ['converged', true], `${from} to ${to}`);
    assert.ok(Math.abs(path.length / length - 1) <= RIGHT, `${from} to ${to}: ${path.length}, not ${length}`);
  }
  const milliseconds = performance.now() - start;
  assert.ok(milliseconds < allowance(1000), `${milliseconds} ms`);
  plane.dispose();
});

test('a density around a hole: the plane measured as a sphere, seed 6', () => {
  const tip = 0.001;
  const surface = surfpath.parametric({ x: 'v cos(u)', y: 'v sin(u)', z: '0', u: [0, 6.28], v: [tip, 2], density: '2/(1 + x^2 + y^2)' });
  const radius = 2 * Math.atan(tip);
  for (const [from, to] of randomPairs(6, [0, 0.01], [6.28, 0.9])) {
    const [a, b] = [from, to].map(([u, v]) => [2 * Math.atan(v), u]);
    const path = surface.shortestPath(from, to);
    const length = wayBetween(a, b, b[1] - a[1], [radius, radius]);
    assert.equal(path.status, 'converged', `${from} to ${to}`);
    assert.ok(Math.abs(path.length / length - 1) <= RIGHT, `${from} to ${to}: ${path.length}, not ${length}`);
  }
});

test('from a place on the edge of a hole: along it, and away at a tangent, seed 7', () => {
  const [low, high] = [0.0016, Math.PI - 0.0016];
  const surface = sphere(low, high, 6.28);
  for (const [edge, to] of randomPairs(7, [0, 0], [Math.PI, 6.28])) {
    const from = [edge[0] < 1.5 ? low : high, edge[1]];
    const place = [Math.min(Math.max(to[0], 0.01), 3.13), to[1]];
    const path = surface.shortestPath(from, place);
    const length = wayBetween(from, place, place[1] - from[1], [low, Math.PI - high]);
    assert.equal(path.status, 'converged', `${from} to ${place}`);
    assert.ok(Math.abs(path.length / length - 1) <= RIGHT, `${from} to ${place}: ${path.length}, not ${length}`);
  }
});

test('of two holes the one around which the way is shorter, though the way over its middle is not', () => {
  const path = sphere(0.1, Math.PI - 0.002, 6.28).shortestPath([1.5, 0.1], [1.5, 6.2]);
  const length = wayBetween([1.5], [1.5], 6.1, [0.1, 0.002]);
  assert.ok(Math.abs(path.length / length - 1) <= RIGHT, `${path.length}, not ${length}`);
});
