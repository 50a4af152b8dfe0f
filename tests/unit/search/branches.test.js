// Parametric surfaces that branch: S_u = S_v = 0 at a point around which they go more than once. Paths that end there, or lead through, against closed forms, another chart, and
// ways along a fine mesh.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { load } from '../../../web/index.js';
import { distancesAlong } from '../../helpers/mesh-distances.js';
import { createRandom } from '../../helpers/random.js';
import { ofAll } from '../../helpers/sample.js';

/** @typedef {[number, number]} Range */

const surfpath = await load();
/** @type {Range} */
const RANGE = [-1, 1];

/** (u + iv)^m in the plane: a plane that goes m times around 0. */
const COVERS = [
  { times: 2, x: 'u^2 - v^2', y: '2u*v' },
  { times: 3, x: 'u^3 - 3u*v^2', y: '3u^2*v - v^3' },
];

for (const { times, x, y } of COVERS)
  describe(`a plane that goes ${times} times around a point`, () => {
    const surface = surfpath.parametric({ x, y, z: 0, u: RANGE, v: RANGE });
    const end = (/** @type {import('../../helpers/random.js').Random} */ random) => [random.between(-1, 1), random.between(-1, 1)];

    test('to the point: as far as it is in the plane', () => {
      const random = createRandom(71);
      for (let i = 0; i < 12; i++) {
        const from = end(random);
        const { status, length } = surface.shortestPath(from, [0, 0]);
        assert.equal(status, 'converged');
        assert.ok(Math.abs(length / Math.hypot(...from) ** times - 1) < 1e-12, `${from}`);
      }
    });

    test('from side to side: through the point where they are more than half a turn apart', () => {
      const random = createRandom(72);
      let through = 0;
      const pairs = ofAll(20, 60);
      for (let i = 0; i < pairs; i++) {
        const [from, to] = [end(random), end(random)];
        const [a, b] = [from, to].map((place) => Math.hypot(...place) ** times);
        const apart = Math.abs(Math.atan2(from[1], from[0]) - Math.atan2(to[1], to[0]));
        const angle = times * Math.min(apart, 2 * Math.PI - apart);
        const wanted = angle < Math.PI ? Math.sqrt(a * a + b * b - 2 * a * b * Math.cos(angle)) : a + b;
        const path = surface.shortestPath(from, to);
        assert.equal(path.status, 'converged', `${from} to ${to}`);
        assert.ok(Math.abs(path.length / wanted - 1) < 1e-12, `${from} to ${to}: ${path.length} for ${wanted}`);
        assert.equal(path.points.length, 3 * 66);
        assert.deepEqual(
          [path.parameters?.subarray(0, 2), path.parameters?.subarray(-2)],
          [Float64Array.from(from), Float64Array.from(to)],
        );
        assert.equal(surface.shortestPath(to, from).length, path.length);
        if (angle < Math.PI) continue;
        through++;
        const nearest = Math.min(...Array.from({ length: 66 }, (_, k) => Math.hypot(path.points[3 * k], path.points[3 * k + 1])));
        assert.ok(nearest < 1e-12, `${nearest}`);
      }
      assert.ok(3 * through > pairs && 6 * through < 5 * pairs, `${through} through the point`);
    });

    test('an end that is dragged around the point, each path the start of the next', () => {
      let path = surface.shortestPath([0.8, 0.1], [0.7, 0]);
      for (let k = 1; k <= 24; k++) {
        const to = [0.7 * Math.cos((k * Math.PI) / 12), 0.7 * Math.sin((k * Math.PI) / 12)];
        path = surface.shortestPath([0.8, 0.1], to, { start: path });
        const best = surface.shortestPath([0.8, 0.1], to);
        assert.equal(path.status, 'converged', `${to}`);
        assert.ok(Math.abs(path.length / best.length - 1) < 1e-9, `${to}: ${path.length}, the shortest ${best.length}`);
      }
    });

    test('with as many points as are asked for', () => {
      for (const points of [1, 2, 200]) {
        const path = surface.shortestPath([0.5, 0.1], [-0.6, 0.1], { points, record: true });
        assert.equal(path.status, 'converged');
        assert.equal(path.points.length, 3 * (points + 2));
      }
    });
  });

/** Bour's surface around its branch point, and as most write it, by a radius of which the second derivatives are infinite there. */
describe('one surface in two charts', () => {
  const branched = surfpath.parametric({
    x: '(u^2 - v^2) - (u^4 - 6u^2*v^2 + v^4)/2',
    y: '-2u*v - (2u^3*v - 2u*v^3)',
    z: '4/3*(u^3 - 3u*v^2)',
    u: RANGE,
    v: RANGE,
  });
  const polar = surfpath.parametric({
    x: 'u cos(v) - u^2/2*cos(2v)',
    y: '-u sin(v) - u^2/2*sin(2v)',
    z: '4/3*sqrt(u)^3*cos(3v/2)',
    u: [0, 1],
    v: [0, '4pi'],
  });

  test('the same lengths', () => {
    const random = createRandom(73);
    for (let i = 0; i < ofAll(15, 40); i++) {
      const ends = [0, 1].map(() => [random.between(0.05, 0.7), random.between(0, 4 * Math.PI)]);
      const [a, b] = ends.map(([r, angle]) => [r * Math.cos(angle / 2), r * Math.sin(angle / 2)]);
      const [c, d] = ends.map(([r, angle]) => [r * r, angle]);
      const [one, other] = [branched.shortestPath(a, b), polar.shortestPath(c, d)];
      assert.deepEqual([one.status, other.status], ['converged', 'converged'], `${ends.join(' to ')}`);
      assert.ok(Math.abs(one.length / other.length - 1) < 1e-9, `${ends.join(' to ')}: ${one.length} and ${other.length}`);
    }
  });
});

/** Length of what lies over a polyline of the rectangle, each of its chords halved. @param {import('../../../web/surface.js').Surface} surface @param {Float64Array} parameters */
function lengthAlong(surface, parameters) {
  const count = parameters.length / 2;
  const halved = Float64Array.from({ length: 4 * count - 2 }, (_, i) => {
    const at = 2 * (i >> 2) + (i & 1);
    return i & 2 ? (parameters[at] + parameters[at + 2]) / 2 : parameters[at];
  });
  const seen = surface.evaluate(halved);
  return Array.from({ length: halved.length / 2 - 1 }, (_, i) =>
    Math.hypot(...[0, 1, 2].map((j) => seen[6 * i + 6 + j] - seen[6 * i + j])),
  ).reduce((sum, chord) => sum + chord, 0);
}

describe('minimal surfaces that branch', () => {
  /** @type {Record<string, { x: string, y: string, z: string, u: Range, v: Range }>} */
  const surfaces = {
    "Catalan's": { x: 'u - sin(u)*cosh(v)', y: '1 - cos(u)*cosh(v)', z: '4sin(u/2)*sinh(v/2)', u: [-1.5, 1.5], v: [-1.5, 1.5] },
    "Henneberg's": {
      x: '2cos(v)*sinh(u) - 2/3*cos(3v)*sinh(3u)',
      y: '2sin(v)*sinh(u) + 2/3*sin(3v)*sinh(3u)',
      z: '2cos(2v)*cosh(2u)',
      u: [-0.6, 0.6],
      v: [-0.7, 2.2],
    },
  };
  for (const [name, definition] of Object.entries(surfaces))
    test(`${name}: on the surface, and no longer than a way along a mesh`, () => {
      const surface = surfpath.parametric(definition);
      const mesh = surface.mesh({ resolution: 96 });
      const parameters = /** @type {Float64Array} */ (mesh.parameters);
      const random = createRandom(74);
      const count = mesh.positions.length / 3;
      for (let i = 0; i < 4; i++) {
        const from = random.integer(count);
        const distances = distancesAlong(mesh, from, [], 0.1);
        for (let k = 0; k < 5; k++) {
          const to = random.integer(count);
          const [a, b] = [from, to].map((vertex) => Array.from(parameters.subarray(2 * vertex, 2 * vertex + 2)));
          const path = surface.shortestPath(a, b, { points: 2000 });
          assert.equal(path.status, 'converged', `${a} to ${b}`);
          // The mesh's triangles lie by less than a thousandth beside the surface.
          assert.ok(path.length < 1.001 * distances[to], `${a} to ${b}: ${path.length}, along the mesh ${distances[to]}`);
          // Chords of a two-thousandth of the path, halved on the surface: those beside the point, whose parameters turn, bow out by a part of their own.
          const along = lengthAlong(surface, /** @type {Float64Array} */ (path.parameters));
          assert.ok(Math.abs(along / path.length - 1) < 1e-5, `${a} to ${b}: ${path.length}, along its parameters ${along}`);
        }
      }
    });
});

describe('tips at which all derivatives vanish', () => {
  test('to the tip: along a meridian', () => {
    // Twice around in the plane, a flat disc, a cone: all of radius u².
    for (const [x, y, z, turns, slant] of /** @type {[string, string, string, string, number][]} */ ([
      ['u^2*cos(v)', 'u^2*sin(v)', '0', '4pi', 1],
      ['u^2*cos(v)', 'u^2*sin(v)', '0', '2pi', 1],
      ['u^2*cos(v)', 'u^2*sin(v)', 'u^2', '2pi', Math.SQRT2],
    ])) {
      const surface = surfpath.parametric({ x, y, z, u: [0, 1], v: [0, turns] });
      for (const [u, v] of [
        [0.3, 1],
        [0.9, 4],
      ]) {
        const path = surface.shortestPath([u, v], [0, 0]);
        assert.equal(path.status, 'converged');
        assert.ok(Math.abs(path.length / (slant * u * u) - 1) < 1e-12, `${path.length}`);
      }
    }
  });

  test('over the tip where the surface goes twice around it', () => {
    const surface = surfpath.parametric({ x: 'u^2*cos(v)', y: 'u^2*sin(v)', z: 0, u: [0, 1], v: [0, '4pi'] });
    const path = surface.shortestPath([0.5, 1], [0.7, 6]);
    assert.equal(path.status, 'converged');
    assert.ok(Math.abs(path.length - 0.74) < 1e-12, `${path.length}`);
  });
});
