// Starts that are given: however many points they have, they lead where a start of a few points does; and past poles, where no step in the rectangle does.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { gallery } from '../../../web/gallery.js';
import { load } from '../../../web/index.js';
import { createRandom } from '../../helpers/random.js';
import { verifyPath } from '../../helpers/verify-path.js';

const surfpath = await load();
const PAIRS = 20;
/** Both are right to the default tolerance. */
const TWO_TOLERANCES = 2e-9;

/** The straight line of the parameters. @param {number[]} from @param {number[]} to @param {number} count */
const lineOf = (from, to, count) =>
  Float64Array.from({ length: 2 * count }, (_, i) => {
    const t = Math.floor(i / 2) / (count - 1);
    return (1 - t) * from[i % 2] + t * to[i % 2];
  });

/* Newton on 512 chords and more frees about one of them a step where they lie on a wall that the path does not follow. */
for (const name of /** @type {const} */ (['moebius', 'vase']))
  test(`${name}: a start of 256 points and more converges where one of 64 does, walls or not`, () => {
    const surface = surfpath.surface(gallery[name]);
    const { domain } = surface;
    assert.ok(domain);
    const random = createRandom(5);
    const point = () => [random.between(domain.u[0], domain.u[1]), random.between(domain.v[0], domain.v[1])];
    let touching = 0;
    for (let i = 0; i < PAIRS; i++) {
      const [from, to] = [point(), point()];
      const few = surface.shortestPath(from, to, { start: lineOf(from, to, 64) });
      touching += Number(few.touchesBoundary);
      assert.equal(few.status, 'converged');
      for (const count of [256, 700, 3000]) {
        const many = surface.shortestPath(from, to, { start: lineOf(from, to, count) });
        assert.equal(many.status, 'converged', `${from} to ${to}, ${count} points`);
        assert.ok(Math.abs(many.length / few.length - 1) <= TWO_TOLERANCES, `${from} to ${to}, ${count} points`);
      }
      const far = surface.shortestPath(from, point(), { points: 1000 });
      const moved = surface.shortestPath(from, to, { start: far });
      assert.equal(moved.status, 'converged', `${from} to ${to}, from a path of 1,002 points to elsewhere`);
    }
    assert.ok(touching > 0, 'no pair touches a wall');
    surface.dispose();
  });

describe('an end that is dragged past poles, each path the start of the next', () => {
  const FRAMES = 180;
  /** 65 chords are shorter than the path between their ends by so much, at most. */
  const CHORDS = 1e-2;
  /** Where a point on a tilted great circle lies, by longitude and latitude. @param {number} angle @param {number} tilt */
  const onCircle = (angle, tilt) => {
    const [x, y, z] = [Math.cos(angle), Math.sin(angle) * Math.cos(tilt), Math.sin(angle) * Math.sin(tilt)];
    return [Math.atan2(y, x), Math.asin(z)];
  };
  /** Where a point on a circle in the plane lies, by angle and distance. @param {number} angle */
  const inPlane = (angle) => {
    const [x, y] = [0.3 + Math.cos(angle), 0.7 * Math.sin(angle)];
    return [(Math.atan2(y, x) + 2 * Math.PI) % (2 * Math.PI), Math.hypot(x, y)];
  };
  /** @param {import('../../../web/index.js').Surface} surface @param {number[]} from @param {(angle: number) => number[]} placeAt */
  function drag(surface, from, placeAt) {
    let last = surface.shortestPath(from, placeAt(0.1));
    return Array.from({ length: FRAMES }, (_, frame) => {
      const to = placeAt(0.1 + (2 * Math.PI * frame) / FRAMES);
      last = surface.shortestPath(from, to, { start: last });
      assert.equal(last.status, 'converged', `${from} to ${to}`);
      return { to, path: last };
    });
  }

  test('on a globe: all as long as trigonometry says, whichever way the path was before', () => {
    const surface = surfpath.surface(gallery.globe);
    const unit = (/** @type {readonly number[]} */ [u, v]) => [Math.cos(v) * Math.cos(u), Math.cos(v) * Math.sin(u), Math.sin(v)];
    for (const [tilt, from] of /** @type {const} */ ([
      [1.2, [-0.817, -0.744]],
      [0.3, [2.431, -1.35]],
      [1.5, [0.5, 1.2]],
    ]))
      for (const { to, path } of drag(surface, [...from], (angle) => onCircle(angle, tilt))) {
        const [p, q] = [unit(from), unit(to)];
        const length = 2 * Math.asin(Math.min(1, Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) / 2));
        // Between nearly antipodal ends the arcsine loses half of the digits.
        assert.ok(Math.abs(path.length - length) <= 1e-7, `${from} to ${to}: ${path.length}, not ${length}`);
      }
    surface.dispose();
  });

  test('from a pole of a globe: along the meridians, and where the path is says so', () => {
    const surface = surfpath.surface(gallery.globe);
    for (const pole of [Math.PI / 2, -Math.PI / 2])
      for (const { to, path } of drag(surface, [0.3, pole], (angle) => onCircle(angle, 0.7))) {
        assert.ok(Math.abs(path.length - Math.abs(pole - to[1])) <= TWO_TOLERANCES, `${to}: ${path.length}`);
        for (const { parameters } of [path, surface.shortestPath([0.3, pole], to)]) {
          const [u, v] = parameters?.slice(-2) ?? [];
          // Whole periods apart, up to their rounding.
          assert.ok(Math.abs(Math.sin((u - to[0]) / 2)) <= 1e-15 && v === to[1], `${to}: the end is ${u}, ${v}`);
        }
      }
    surface.dispose();
  });

  test('a start that takes long but arrives is not given up for a shorter path', () => {
    const waves = surfpath.parametric({ x: 'v cos(u)', y: 'v sin(u)', z: '0.5*sin(5v)', u: [0, '2pi'], v: [0, 4] });
    const slow = waves.shortestPath([5.385963839218369, 3.453447437286377], [3.231859333605052, 0.29984254837036134], {
      start: 'straight',
    });
    assert.ok(slow.converged && slow.iterations > 40, `${slow.status}, ${slow.iterations} steps`);
    const radius = '(1+0.3*sin(5v)*sin(v))';
    const ball = { x: `${radius}*sin(v)*cos(u)`, y: `${radius}*sin(v)*sin(u)`, z: `${radius}*cos(v)` };
    const bumpy = surfpath.parametric({ ...ball, u: [0, '2pi'], v: [0, 'pi'] });
    const [from, to] = [
      [1.9752371400981579, 0.9507714414719871],
      [2.601100365287929, 2.140658467424427],
    ];
    const wound = bumpy.shortestPath(from, to, { start: [...from, -3.995, 2.175, to[0] - 4 * Math.PI, to[1]] });
    assert.ok(wound.converged && wound.length > 8, `${wound.status}, ${wound.length}`);
  });

  test('on a cone and a paraboloid by angle and distance: geodesics that hit, on the cone as long as unrolled', () => {
    const polar = /** @type {const} */ ({ x: 'v cos(u)', y: 'v sin(u)', u: [0, '2pi'], v: [0, 2] });
    for (const z of ['v', 'v^2']) {
      const definition = { ...polar, z };
      const surface = surfpath.parametric(definition);
      for (const { to, path } of drag(surface, [2.324, 0.513], inPlane)) {
        const turned = Math.abs(to[0] - 2.324);
        const ways = [turned, 2 * Math.PI - turned].map((angle) => {
          const unrolled = angle / Math.SQRT2;
          return Math.SQRT2 * Math.sqrt(0.513 ** 2 + to[1] ** 2 - 2 * 0.513 * to[1] * Math.cos(Math.min(unrolled, Math.PI)));
        });
        if (z === 'v')
          assert.ok(
            ways.some((length) => Math.abs(path.length / length - 1) <= TWO_TOLERANCES),
            `${to}: ${path.length}`,
          );
        else assert.deepEqual(verifyPath({ kind: 'parametric', ...definition }, path, { to, lengthTolerance: CHORDS }), [], `${to}`);
      }
      surface.dispose();
    }
  });
});

test('geodesics: the straight line to a neighbouring turn leads to its path, also where 32 chords stall', () => {
  const [r, h] = ['(2 + cos(u/2)*sin(v) - sin(u/2)*sin(2v))', 'sin(u/2)*sin(v) + cos(u/2)*sin(2v)'];
  const bottle = surfpath.parametric({ x: `${r}*cos(u)`, y: `${r}*sin(u)`, z: h, u: [0, '2pi'], v: [0, '2pi'] });
  const { length } = bottle.shortestPath([1, 2], [2.5, 4.2], { start: [1, 2, 2.5, 4.2 - 2 * Math.PI] });
  const lengths = bottle.geodesics([1, 2], [2.5, 4.2]).map((path) => path.length);
  assert.ok(
    lengths.some((one) => Math.abs(one / length - 1) < TWO_TOLERANCES),
    `${length} of ${lengths}`,
  );
});
