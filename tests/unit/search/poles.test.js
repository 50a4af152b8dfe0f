// Paths that end in a pole, where a coordinate says nothing, or beside a point around which a turn is hardly a way: against closed forms and the verifier.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { load } from '../../../web/index.js';
import { findPoles } from '../../../web/manifold/tips.js';
import { allowance } from '../../helpers/allowance.js';
import { createRandom } from '../../helpers/random.js';
import { close } from '../../helpers/refuses.js';
import { verifyPath } from '../../helpers/verify-path.js';

/** @typedef {import('../../../web/index.js').Path} Path */

const surfpath = await load();
const TURN = 2 * Math.PI;
const PAIRS = 16;

/** @param {string} x @param {string} y @param {string} z @param {[number, number]} v */
const definitionOf = (x, y, z, v) => ({ kind: /** @type {const} */ ('parametric'), x, y, z, u: /** @type {const} */ ([0, '2pi']), v });

const sphereByHeight = definitionOf('sqrt(v) sqrt(2 - v) cos(u)', 'sqrt(v) sqrt(2 - v) sin(u)', '1 - v', [0, 2]);

describe('from a pole, given any longitude', () => {
  /** Paths from the pole v = 0, and from what other longitudes of it are. @param {ReturnType<typeof definitionOf>} definition @param {(path: Path, to: number[]) => void} check */
  function leave(definition, check) {
    const surface = surfpath.surface(definition);
    const random = createRandom(7);
    let steps = 0;
    for (let i = 0; i < PAIRS; i++) {
      const to = [random.between(0, TURN), random.between(0.01, 0.95) * definition.v[1]];
      const paths = [0, 1].map(() => surface.shortestPath([random.between(0, TURN), 0], to));
      for (const path of paths) {
        assert.equal(path.status, 'converged', `${to}`);
        steps += path.iterations / 2 / PAIRS;
        check(path, to);
      }
      close(paths[0].length, paths[1].length);
    }
    return steps;
  }

  test('ellipsoid of three axes: geodesics, in few steps', () => {
    const ellipsoid = definitionOf('3cos(u) sin(v)', '2sin(u) sin(v)', 'cos(v)', [0, Math.PI]);
    const steps = leave(ellipsoid, (path, to) => {
      assert.deepEqual(verifyPath(ellipsoid, path, { to, lengthTolerance: 1e-3 }), [], `${to}`);
    });
    assert.ok(steps <= 6, `${steps} steps`);
  });

  test('cusp of a paraboloid on its head: as long as its meridian', () => {
    const steps = leave(definitionOf('v^2 cos(u)', 'v^2 sin(u)', 'v', [0, 1]), ({ length }, [, v]) => {
      close(length, (v * Math.sqrt(1 + 4 * v * v)) / 2 + Math.asinh(2 * v) / 4);
    });
    assert.ok(steps <= 4, `${steps} steps`);
  });

  test('a sphere and a paraboloid by height, whose derivatives are infinite there: as long as the meridian', () => {
    const steps = leave(sphereByHeight, ({ length }, [, v]) => close(length, Math.acos(1 - v)));
    assert.ok(steps <= 5, `${steps} steps`);
    leave(definitionOf('2sqrt(v) cos(u)', '2sqrt(v) sin(u)', 'v', [0, 1]), ({ length }, [, v]) => {
      close(length, Math.sqrt(v * v + v) + Math.asinh(Math.sqrt(v)));
    });
  });

  test('wherever that height counts from', () => {
    for (const at of [1, -1, 1000]) {
      const definition = definitionOf('sqrt(1 - (v - c)^2) cos(u)', 'sqrt(1 - (v - c)^2) sin(u)', 'v', [at - 1, at + 1]);
      const sphere = surfpath.surface({ ...definition, parameters: { c: at } });
      for (const [pole, height] of [
        [1, 0.3],
        [1, -0.7],
        [-1, 0.2],
      ]) {
        const path = sphere.shortestPath([2, at + pole], [1, at + height]);
        assert.equal(path.status, 'converged');
        assert.ok(Math.abs(path.length - Math.acos(pole * height)) <= path.lengthError, `${path.length}`);
      }
    }
  });

  test('the top of a vessel, half a ball on a cylinder: as long as the meridian; that rounding moves points far there is no bend', () => {
    const vessel = surfpath.revolution({ r: 'sqrt(1 - max(0, t - 2)^2)', z: 't', t: [0, 3] });
    const random = createRandom(11);
    const start = performance.now();
    for (let i = 0; i < 10; i++) {
      const [u, longitude, t] = [random.between(0, TURN), random.between(0, TURN), random.between(0, 1.9)];
      const path = vessel.shortestPath([longitude, 3], [u, t]);
      assert.equal(path.status, 'converged');
      close(path.length, Math.PI / 2 + 2 - t);
    }
    const milliseconds = performance.now() - start;
    assert.ok(milliseconds < allowance(1000), `${milliseconds} ms`);
  });

  test('about as fast as from elsewhere: ways that wind around it are seen to be longer in few chords', () => {
    const random = createRandom(5);
    const sphere = surfpath.revolution({ r: 'cos(t)', z: 'sin(t)', t: ['-pi/2', 'pi/2'] });
    sphere.shortestPath([0, 0], [1, 1]);
    const start = performance.now();
    for (let i = 0; i < 40; i++) {
      const t = random.between(-1.4, 1.4);
      close(sphere.shortestPath([random.between(0, TURN), Math.PI / 2], [random.between(0, TURN), t]).length, Math.PI / 2 - t);
    }
    const milliseconds = performance.now() - start;
    assert.ok(milliseconds < allowance(500), `${milliseconds} ms`);
    sphere.dispose();
  });

  test('polylines say by how much they are too short there, too', () => {
    const sphere = surfpath.surface(sphereByHeight);
    for (const points of [31, 200]) {
      const path = sphere.shortestPath([1, 0], [1, 0.7], { algorithm: 'polyline', points });
      const ratio = path.lengthError / (Math.acos(0.3) - path.length);
      assert.ok(ratio > 0.9 && ratio < 1.1, `${ratio}`);
    }
  });

  for (const [name, x] of [
    ['bent', 'v^2 cos(u) + v/2 + v^3'],
    ['leaning', 'v^2 cos(u) + v^2/2'],
  ])
    test(`${name} cusp that is not round: all converge, none shorter than its chord`, () => {
      const steps = leave(definitionOf(x, '2v^2 sin(u)', 'v', [0, 1]), ({ points, length }) => {
        assert.ok(length >= Math.hypot(...points.slice(-3)) * (1 - 1e-12));
      });
      assert.ok(steps <= 8, `${steps} steps`);
    });
});

test('from a pole to itself, whatever the longitude: a point', () => {
  const plane = surfpath.metric({ E: 1, F: 0, G: 'u^2', u: [0, 1], v: [0, '2pi'], periodic: { v: true } });
  for (const [surface, from, to] of /** @type {const} */ ([
    [surfpath.surface(sphereByHeight), [1, 0], [4, 0]],
    [surfpath.parametric({ x: 'v cos(u)', y: 'v sin(u)', z: 'v', u: [0, '2pi'], v: [0, 1] }), [0, 0], [0, 0]],
    [plane, [0, 1], [0, 2]],
  ]))
    for (const start of /** @type {const} */ (['global', 'straight'])) {
      const path = surface.shortestPath([...from], [...to], { start, points: 5 });
      assert.deepEqual([path.status, path.length, path.lengthError, path.points.length], ['converged', 0, 0, surface === plane ? 0 : 21]);
      assert.deepEqual([...(path.parameters ?? [])].slice(-4), [...from, ...to]);
    }
});

describe('from beside an apex or the tip of a cusp, as near as can be', () => {
  for (const radius of [2, 0.5, 0.02])
    test(`cone of radius ${radius} at height 1: as long as unrolled, within what they say`, () => {
      const cone = surfpath.surface(definitionOf(`${radius} v cos(u)`, `${radius} v sin(u)`, 'v', [0, 1]));
      const random = createRandom(23);
      const slant = Math.hypot(1, radius);
      for (let i = 0; i < 2 * PAIRS; i++) {
        const from = [random.between(0, TURN), 10 ** -random.between(1, 10)];
        const to = [random.between(0, TURN), random.between(0.3, 1)];
        const around = Math.abs(from[0] - to[0]);
        const angle = (Math.min(around, TURN - around) * radius) / slant;
        const [a, b] = [slant * from[1], slant * to[1]];
        const length = Math.hypot(a - b, 2 * Math.sqrt(a * b) * Math.sin(angle / 2));
        for (const path of [cone.shortestPath(from, to), cone.shortestPath(to, from)]) {
          assert.equal(path.status, 'converged', `${from} to ${to}`);
          /* The last bits of the formula. */
          assert.ok(Math.abs(path.length - length) <= path.lengthError + 4e-16, `${from} to ${to}: ${path.length}, not ${length}`);
        }
      }
    });

  for (const [name, x, z] of [
    ['round cusp', 'v^2 cos(u)', 'v'],
    ['lemon', '(cos(v - 2.0943951023931953) + .5) cos(u)', 'sin(v - 2.0943951023931953)'],
  ])
    test(`${name}: converged, and the longer the farther around, but never longer than by the tip`, () => {
      const surface = surfpath.surface(definitionOf(x, x.replace('cos(u)', 'sin(u)'), z, [0, 1]));
      const random = createRandom(29);
      for (let i = 0; i < PAIRS; i++) {
        const away = 10 ** -random.between(1, 10);
        const height = random.between(0.3, 1);
        const [tip, far] = [surface.shortestPath([0, 0], [0, away]).length, surface.shortestPath([0, 0], [0, height]).length];
        let least = far - tip;
        for (const angle of [0.5, 1.5, 2.5, 3]) {
          const path = surface.shortestPath([1, away], [1 + angle, height]);
          assert.equal(path.status, 'converged', `${away} from the tip, ${angle} around`);
          assert.ok(
            path.length >= least - 2e-15 && path.length <= far + tip + 2e-15,
            `${away} from the tip, ${angle} around: ${path.length}`,
          );
          least = path.length;
        }
      }
    });
});

describe('from beside the apex of a cone within the surface, 1e-2 to 1e-8 away, where no node sees the path turn', () => {
  const bounds = /** @type {[[number, number], [number, number], [number, number]]} */ ([-2, -2, -2].map((least) => [least, 2]));
  for (const [name, surface, hasHeight, most] of /** @type {const} */ ([
    ['a height field', surfpath.graph({ z: 'hypot(x - 1/3, y + .2)', x: [-2, 2], y: [-2, 2] }), false, Math.PI],
    ['implicit, with a root', surfpath.implicit({ f: 'hypot(x - 1/3, y + .2) - z', bounds }), true, 2.2],
    ['implicit, both halves', surfpath.implicit({ f: '(x - 1/3)^2 + (y + .2)^2 - z^2', bounds }), true, 2.2],
  ]))
    test(`${name}: as long as unrolled, to the tolerance`, () => {
      const random = createRandom(31);
      const place = (/** @type {number} */ away, /** @type {number} */ angle) => [
        ...[1 / 3 + away * Math.cos(angle), away * Math.sin(angle) - 0.2],
        ...(hasHeight ? [away] : []),
      ];
      for (let i = 0; i < PAIRS / 2; i++) {
        const [near, far] = [10 ** -random.between(2, 8), random.between(0.3, 1.3)];
        const [angle, turned] = [random.between(0, TURN), random.between(-most, most)];
        for (const tolerance of [1e-6, 1e-9, 1e-11]) {
          const path = surface.shortestPath(place(near, angle), place(far, angle + turned), { tolerance });
          const length = Math.SQRT2 * Math.hypot(near - far, 2 * Math.sqrt(near * far) * Math.sin(turned / Math.SQRT2 / 2));
          assert.equal(path.status, 'converged', `${near}, ${turned} around`);
          assert.ok(Math.abs(path.length / length - 1) <= tolerance, `${near}, ${turned} around: ${path.length}, not ${length}`);
        }
      }
    });
});

test('a cone as thin as a needle: as long as unrolled, on the side that is nearer', () => {
  const needle = surfpath.surface(definitionOf('.02v cos(u)', '.02v sin(u)', 'v', [0, 1]));
  const random = createRandom(19);
  const slant = Math.hypot(1, 0.02);
  for (let i = 0; i < 4 * PAIRS; i++) {
    const [from, to] = [0, 1].map(() => [random.between(0, TURN), random.between(0, 1)]);
    const around = Math.abs(from[0] - to[0]);
    const angle = (Math.min(around, TURN - around) * 0.02) / slant;
    const [a, b] = [slant * from[1], slant * to[1]];
    const path = needle.shortestPath(from, to);
    assert.equal(path.status, 'converged', `${from} to ${to}`);
    close(path.length, Math.hypot(a - b, 2 * Math.sqrt(a * b) * Math.sin(angle / 2)));
  }
});

test('a hemisphere as a height field, not a number beyond its rim, from ends on the rim: as long as great circles', () => {
  const hemisphere = surfpath.graph({ z: 'sqrt(1 - x^2 - y^2)', x: [-1, 1], y: [-1, 1] });
  const random = createRandom(31);
  const place = (/** @type {number} */ radius) => {
    const angle = random.between(0, TURN);
    return [radius * Math.cos(angle), radius * Math.sin(angle)];
  };
  for (let i = 0; i < PAIRS; i++) {
    /* The last bits of a place on the rim may lie beyond it. */
    const [from, to] = [place(1 - 2 ** -52), place(0.95 * random.between(0, 1))];
    const path = hemisphere.shortestPath(from, to);
    const [p, q] = [from, to].map((at) => [...hemisphere.evaluate(at)].slice(0, 3));
    assert.equal(path.status, 'converged', `${from} to ${to}`);
    close(path.length, 2 * Math.asin(Math.hypot(...p.map((x, j) => x - q[j])) / 2));
  }
});

// Once its edges across were: ways beside them were tried for seconds.
test('a line, which no second coordinate moves along, has no edges that are points', () => {
  const jets = (/** @type {number[]} */ places) => {
    const sampled = new Float64Array(9 * places.length);
    for (let i = 0; i < places.length / 2; i++) sampled.set([places[2 * i + 1], 0, 0, 0, 0, 0, 1], 18 * i);
    return sampled;
  };
  assert.deepEqual(findPoles({ jets, metrics: () => [], tensors: null }, { lower: [0, 0], upper: [1, 1] }), []);
});

test('past the pole of a metric globe, however near: what the coordinate across leaves is known, and in few steps', () => {
  for (const edge of [0, -Math.PI / 2, 1000]) {
    const globe = surfpath.metric({
      E: 'sin(v - p)^2',
      F: 0,
      G: 1,
      u: [0, '2pi'],
      v: ['p', 'p + 2'],
      parameters: { p: edge },
      periodic: { u: true },
    });
    for (const height of [1e-2, 1e-4, 1e-6, 1e-8])
      for (const angle of [Math.PI, 3.1, 2]) {
        const [a, b] = [edge + height, edge + 1.3 * height];
        const path = globe.shortestPath([0.5, a], [0.5 + angle, b]);
        /* Haversines, of the distances as they are rounded. */
        const [p, q] = [a - edge, b - edge];
        const squared = Math.sin((p - q) / 2) ** 2 + Math.sin(p) * Math.sin(q) * Math.sin(angle / 2) ** 2;
        const truth = 2 * Math.asin(Math.sqrt(squared));
        const what = `${height} from the pole at ${edge}, ${angle} apart: ${path.length}, not ${truth}`;
        assert.equal(path.status, 'converged', what);
        assert.ok(Math.abs(path.length - truth) <= path.lengthError + 3e-16 * truth, what);
        assert.ok(path.iterations <= 30, `${path.iterations} steps`);
      }
  }
});

describe('from an edge on which the first derivatives are infinite', () => {
  test('half a cylinder as a graph: unrolled', () => {
    const half = surfpath.graph({ z: 'sqrt(1 - x^2)', x: [-1, 1], y: [0, 2] });
    const random = createRandom(8);
    for (let i = 0; i < PAIRS; i++) {
      const [rim, x, y, z] = [i % 2 ? 1 : -1, random.between(-1, 1), random.between(0, 2), random.between(0, 2)];
      const path = half.shortestPath([rim, y], [x, z]);
      assert.equal(path.status, 'converged', `${rim} ${y} ${x} ${z}`);
      assert.ok(Math.abs(path.length - Math.hypot(Math.asin(rim) - Math.asin(x), y - z)) <= 3 * path.lengthError, `${path.length}`);
    }
  });

  test("the throat of Flamm's paraboloid, by the distance from its axis: as by its height", () => {
    const byRadius = surfpath.parametric(definitionOf('v cos(u)', 'v sin(u)', '2sqrt(v - 1)', [1, 10]));
    const byHeight = surfpath.revolution({ r: '1 + t^2/4', z: 't', t: [0, 6] });
    const random = createRandom(9);
    for (let i = 0; i < PAIRS; i++) {
      const [from, turn, height] = [random.between(0, TURN), random.between(-1.5, 1.5), random.between(1, 6)];
      const to = from + turn; // no farther: else it runs along the throat first
      const path = byRadius.shortestPath([from, 1], [to, 1 + (height * height) / 4]);
      const other = byHeight.shortestPath([from, 0], [to, height]);
      assert.equal(path.status, 'converged', `${from} ${to} ${height}`);
      assert.ok(Math.abs(path.length - other.length) <= path.lengthError + other.lengthError, `${path.length} ${other.length}`);
    }
  });
});

describe('around an apex of more than a turn, by E, F and G', () => {
  const between = (/** @type {number} */ a, /** @type {number} */ b, /** @type {number} */ angle) =>
    Math.hypot(a - b * Math.cos(angle), b * Math.sin(angle));
  const arc = (/** @type {number} */ a, /** @type {number} */ b, /** @type {number} */ angle) =>
    2 * Math.asin(Math.sqrt(Math.sin((a - b) / 2) ** 2 + Math.sin(a) * Math.sin(b) * Math.sin(angle / 2) ** 2));
  for (const [name, size, G, free] of /** @type {const} */ ([
    ['a cone', 2, '(k*v)^2', between],
    ['a bulge of curvature 1', Math.PI / 2, '(k*sin(v))^2', arc],
  ]))
    test(`${name}: as long as unrolled, or over the apex; rough paths that cut its corner are not followed`, () => {
      const k = 1.4;
      const surface = surfpath.metric({ E: G, F: 0, G: 1, u: [0, '2pi'], v: [0, size], periodic: { u: true }, parameters: { k } });
      surface.shortestPath([1, 1], [2, 1]);
      const random = createRandom(10);
      const start = performance.now();
      for (let i = 0; i < PAIRS; i++) {
        const [from, to] = [0, 1].map(() => [random.between(0, TURN), random.between(0, size)]);
        const turn = Math.abs(from[0] - to[0]);
        const angle = k * Math.min(turn, TURN - turn);
        const path = surface.shortestPath(from, to);
        assert.equal(path.status, 'converged', `${from} ${to}`);
        const truth = angle < Math.PI ? free(from[1], to[1], angle) : from[1] + to[1];
        assert.ok(Math.abs(path.length - truth) <= 3 * path.lengthError, `${from} ${to}: ${path.length}, not ${truth}`);
      }
      const milliseconds = performance.now() - start;
      assert.ok(milliseconds < allowance(1500), `${milliseconds} ms`);
    });
});
