// Seams where the surface comes back turned over or shifted, against strips that are unrolled by hand; and formulas that close but go on to somewhere else.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { gallery } from '../../../web/gallery.js';
import { load } from '../../../web/index.js';
import { createRandom } from '../../helpers/random.js';
import { ofAll } from '../../helpers/sample.js';
import { anything, close, refuses } from '../../helpers/refuses.js';
import { verifyPath } from '../../helpers/verify-path.js';

/** @typedef {import('../../../web/index.js').Surface} Surface */
/** @typedef {import('../../../web/index.js').Path} Path */

const surfpath = await load();
const TURN = 2 * Math.PI;
const PAIRS = ofAll(12, 40);

/**
 * Every kind of seam, where (u + one turn, v) is, one turn before, and of how many pairs some are shorter across it, if not of the fewest.
 * @type {Record<string, { definition: any, span: number, folds: number, before: (v: number) => number, period: number, pairs?: number }>}
 */
const surfaces = {
  'a Möbius strip': { definition: gallery.moebius, span: TURN, folds: 2, before: (v) => -v, period: 0 },
  'a Möbius strip that turns along v, off the middle': {
    definition: {
      x: '(1 + (u - 3) cos(v/2)) cos(v)',
      y: '(1 + (u - 3) cos(v/2)) sin(v)',
      z: '(u - 3) sin(v/2)',
      u: [2.7, 3.3],
      v: ['-pi', 'pi'],
    },
    span: TURN,
    folds: 2,
    before: (u) => 6 - u,
    period: 0,
    pairs: ofAll(24, 40),
  },
  'Klein’s bottle as a figure eight': {
    definition: {
      x: '(3 + cos(u/2) sin(v) - sin(u/2) sin(2v)) cos(u)',
      y: '(3 + cos(u/2) sin(v) - sin(u/2) sin(2v)) sin(u)',
      z: 'sin(u/2) sin(v) + cos(u/2) sin(2v)',
      u: [0, '2pi'],
      v: [0, '2pi'],
    },
    span: TURN,
    folds: 2,
    before: (v) => -v,
    period: TURN,
  },
  'the same, its origin moved: turned over about any place': {
    definition: {
      x: '(3 + cos(u/2) sin(v - 0.7) - sin(u/2) sin(2v - 1.4)) cos(u)',
      y: '(3 + cos(u/2) sin(v - 0.7) - sin(u/2) sin(2v - 1.4)) sin(u)',
      z: 'sin(u/2) sin(v - 0.7) + cos(u/2) sin(2v - 1.4)',
      u: [0, '2pi'],
      v: [0, '2pi'],
    },
    span: TURN,
    folds: 2,
    before: (v) => 1.4 - v,
    period: TURN,
  },
  'a tube whose section of three lobes turns by a third on its way round': {
    definition: {
      x: '(3 + (0.6 + 0.1cos(3(v + u/3))) cos(v)) cos(u)',
      y: '(3 + (0.6 + 0.1cos(3(v + u/3))) cos(v)) sin(u)',
      z: '(0.6 + 0.1cos(3(v + u/3))) sin(v)',
      u: [0, '2pi'],
      v: [0, '2pi'],
    },
    span: TURN,
    folds: 1,
    before: (v) => v,
    period: TURN,
  },
  'the same tube, v along its lobes: shifted by a third': {
    definition: {
      x: '(3 + (0.6 + 0.1cos(3v)) cos(v - u/3)) cos(u)',
      y: '(3 + (0.6 + 0.1cos(3v)) cos(v - u/3)) sin(u)',
      z: '(0.6 + 0.1cos(3v)) sin(v - u/3)',
      u: [0, '2pi'],
      v: [0, '2pi'],
    },
    span: TURN,
    folds: 3,
    before: (v) => v - TURN / 3,
    period: TURN,
  },
};

/** @param {any} definition */
const make = (definition) => surfpath.surface(anything({ kind: 'parametric', ...definition }));

/** @param {Surface} surface @param {ReturnType<typeof createRandom>} random */
function randomPlace({ domain }, random) {
  assert.ok(domain);
  return [random.between(...domain.u), random.between(...domain.v)];
}

/** @param {Surface} surface @param {number[]} place @returns {number[]} */
const pointAt = (surface, place) => Array.from(surface.evaluate(place).slice(0, 3));

/** @param {Path} path */
const chordsOf = ({ points }) =>
  Array.from({ length: points.length / 3 - 1 }, (_, i) => apart(points.slice(3 * i), points.slice(3 * i + 3)));

/** @param {ArrayLike<number>} a @param {ArrayLike<number>} b */
const apart = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);

for (const [name, { definition, span, before, period, folds, pairs = PAIRS }] of Object.entries(surfaces))
  describe(`${name}`, () => {
    const surface = make(definition);
    const isAlongV = name.includes('along v, off');
    /** The same point, a turn on. @param {number[]} place */
    const turned = ([u, v]) => (isAlongV ? [before(u), v + span] : [u + span, folds === 3 ? v + TURN / 3 : before(v)]);

    test('is closed, its range as it is written, any number taken for u and v', () => {
      const { domain } = surface;
      assert.ok(domain);
      const [own, other] = isAlongV ? ['v', 'u'] : ['u', 'v'];
      const periodic = /** @type {Record<string, boolean>} */ (domain.periodic);
      assert.deepEqual([periodic[own], periodic[other]], [true, period > 0]);
      close(domain[/** @type {'u'} */ (own)][1] - domain[/** @type {'u'} */ (own)][0], span);
      const { turn } = domain;
      assert.equal(turn?.along, name.includes('by a third on its way') ? undefined : own);
      // The place one turn on, as `turn` has it; there, where the other coordinate is closed, up to its period, which is a turn, too.
      const at = isAlongV ? 0 : 1;
      const [place, on] = [isAlongV ? [2.9, 1.1] : [1.1, 0.4], turned(isAlongV ? [2.9, 1.1] : [1.1, 0.4])];
      if (turn) assert.ok(Math.abs(Math.sin((turn.sign * on[at] + turn.offset - place[at]) / 2)) < 1e-12);
      const random = createRandom(3);
      for (let i = 0; i < 10; i++) {
        const place = randomPlace(surface, random);
        assert.ok(apart(pointAt(surface, place), pointAt(surface, turned(place))) < 1e-12);
      }
      assert.deepEqual(make({ ...definition, periodic: { [own]: true, [other]: period > 0 } }).domain, domain);
      assert.deepEqual(make({ ...definition, periodic: {} }).domain?.periodic, { u: false, v: false });
    });

    test('paths: geodesics by the verifier, the same backwards and from any copy of an end, never longer than on the surface cut open', () => {
      const cut = make({ ...definition, periodic: { u: period > 0 && isAlongV, v: period > 0 && !isAlongV } });
      const glued = { kind: 'parametric', ...definition, periodic: surface.domain?.periodic };
      const random = createRandom(17);
      let shorter = 0;
      for (let i = 0; i < pairs; i++) {
        const [from, to] = [randomPlace(surface, random), randomPlace(surface, random)];
        const path = surface.shortestPath(from, to);
        assert.equal(path.status, 'converged', `${from} to ${to}`);
        assert.ok(apart(path.points, pointAt(surface, from)) < 1e-12 && apart(path.points.slice(-3), pointAt(surface, to)) < 1e-12);
        assert.ok(path.parameters && Math.hypot(path.parameters[0] - from[0], path.parameters[1] - from[1]) < 1e-12);
        for (let k = 0; k < path.points.length / 3; k++)
          assert.ok(apart(pointAt(surface, Array.from(path.parameters.slice(2 * k, 2 * k + 2))), path.points.slice(3 * k)) < 1e-12);
        if (i % 4 === 0) {
          const fine = surface.shortestPath(from, to, { points: 1023 });
          const length = chordsOf(fine).reduce((sum, chord) => sum + chord);
          assert.deepEqual(verifyPath(glued, { ...fine, length }, {}), [], `${from} to ${to}`);
        }
        close(surface.shortestPath(to, from).length, path.length);
        close(surface.shortestPath(turned(from), to).length, path.length);
        close(surface.shortestPath(from, turned(turned(to))).length, path.length);
        const open = cut.shortestPath(from, to);
        assert.ok(!open.converged || path.length <= open.length * (1 + 1e-9), `${from} to ${to}: ${path.length}, cut open ${open.length}`);
        shorter += Number(path.length < open.length * (1 - 1e-6));
      }
      assert.ok(shorter >= pairs / 8, `${shorter} shorter`);
    });
  });

/** The shortest of all lifts in the plane. @param {number[]} from @param {number[]} to @param {(v: number) => number} before @param {number} period */
function unrolled([u, v], [x, y], before, period) {
  let least = Infinity;
  for (let turns = -3; turns <= 3; turns++)
    for (let around = period ? -3 : 0; around <= (period ? 3 : 0); around++)
      least = Math.min(least, Math.hypot(x + turns * TURN - u, (turns % 2 ? before(y) : y) + around * period - v));
  return least;
}

describe('with the metric of the plane, against the plane: all lifts', () => {
  for (const name of ['a Möbius strip', 'Klein’s bottle as a figure eight', 'the same, its origin moved: turned over about any place']) {
    const { definition, before, period } = surfaces[name];
    const surface = make({ ...definition, metric: { E: 1, F: 0, G: 1 } });
    test(`${name}: lengths`, () => {
      const random = createRandom(29);
      for (let i = 0; i < PAIRS; i++) {
        const [from, to] = [randomPlace(surface, random), randomPlace(surface, random)];
        const path = surface.shortestPath(from, to);
        assert.equal(path.status, 'converged');
        close(path.length, unrolled(from, to, before, period));
      }
    });

    test(`${name}: the distance field, rough and exact`, () => {
      const from = [0.4, 0.1];
      for (const [exact, within] of /** @type {const} */ ([
        [false, 0.05],
        [true, 1e-9],
      ])) {
        const { mesh, distances } = surface.distanceField(from, { resolution: 12, exact });
        const places = /** @type {Float64Array} */ (mesh.parameters);
        for (const [i, distance] of distances.entries()) {
          const truth = unrolled(from, [places[2 * i], places[2 * i + 1]], before, period);
          assert.ok(Math.abs(distance - truth) <= within * truth + 1e-12, `${places.slice(2 * i, 2 * i + 2)}: ${distance}, not ${truth}`);
        }
      }
    });
  }

  test('half of a sphere’s meridians, each all the way round; a disc by signed radii', () => {
    const random = createRandom(31);
    const sphere = make({ x: 'sin(v) cos(u)', y: 'sin(v) sin(u)', z: 'cos(v)', u: [0, 'pi'], v: [0, '2pi'] });
    const disc = make({ x: 'v cos(u)', y: 'v sin(u)', z: 0, u: [0, 'pi'], v: [-1, 1] });
    for (let i = 0; i < PAIRS; i++) {
      const [from, to] = [randomPlace(sphere, random), randomPlace(sphere, random)];
      const chord = apart(pointAt(sphere, from), pointAt(sphere, to));
      const [path, across] = [sphere.shortestPath(from, to), disc.shortestPath([from[0], from[1] / TURN], [to[0], -to[1] / TURN])];
      assert.deepEqual([path.status, across.status], ['converged', 'converged']);
      close(path.length, 2 * Math.asin(chord / 2));
      close(across.length, apart(across.points, across.points.slice(-3)));
    }
  });
});

describe('what follows a path across such a seam', () => {
  const strip = surfpath.surface(gallery.moebius);

  test('an end dragged once around, from frame to frame, is on the same point with another path', () => {
    /** @type {Path | undefined} */
    let path;
    for (let i = 0; i <= 40; i++) {
      // As picked on the drawn surface: always in its rectangle.
      const u = 1 + (TURN * i) / 40;
      const to = u < TURN ? [u, 0.2] : [u - TURN, -0.2];
      path = strip.shortestPath([0.5, 0.1], to, { start: path ?? 'straight' });
      assert.equal(path.status, 'converged');
    }
    const short = strip.shortestPath([0.5, 0.1], [1, -0.2]);
    assert.ok(path && path.length > 5 * short.length);
    close(/** @type {Float64Array} */ (path.parameters)[130], 1 + TURN);
  });

  test('straight: the nearer of the two ways round', () => {
    const path = strip.shortestPath([0.2, 0.1], [6.1, -0.1], { start: 'straight' });
    close(path.length, strip.shortestPath([0.2, 0.1], [6.1, -0.1]).length);
    assert.ok(path.length < 0.5);
  });

  test('geodesics: both ways round, each once', () => {
    const lengths = strip.geodesics([0.3, 0.05], [3.3, 0.05]).map(({ length }) => length);
    const open = surfpath.surface(anything({ ...gallery.moebius, periodic: {} }));
    const cut = open.geodesics([0.3, 0.05], [3.3, 0.05]).map(({ length }) => length);
    assert.equal(cut.length, 1);
    assert.ok(lengths.length > 1 && lengths.filter((length) => Math.abs(length / cut[0] - 1) < 1e-9).length === 1);
  });

  test('trace goes on across the seam; twice around along the middle comes back', () => {
    const flat = make({ ...gallery.moebius, metric: { E: 1, F: 0, G: 1 } });
    const [once, twice] = [1, 2].map((turns) => flat.trace([1, 0.3], [1, 0], turns * TURN));
    assert.deepEqual([once.status, twice.status], ['converged', 'converged']);
    assert.ok(apart(once.points.slice(-3), pointAt(flat, [1, -0.3])) < 1e-9);
    assert.ok(apart(twice.points.slice(-3), pointAt(flat, [1, 0.3])) < 1e-9);
  });
});

describe('what measures length must be turned over too', () => {
  /** @param {object} measure */
  const isClosed = (measure) => make({ ...gallery.moebius, ...measure }).domain?.periodic.u;

  test('densities', () => {
    assert.equal(isClosed({ density: '1 + v^2' }), true);
    assert.equal(isClosed({ density: '1 + v cos(u/2)' }), true);
    assert.equal(isClosed({ density: '1 + v/2' }), false);
    assert.equal(isClosed({ density: '1 + 0.1sin(u/2)' }), false);
  });

  test('metrics: F changes its sign', () => {
    assert.equal(isClosed({ metric: { E: 1, F: 0.3, G: 1 } }), false);
    assert.equal(isClosed({ metric: { E: 1, F: '0.3cos(u/2)', G: 1 } }), true);
    assert.equal(isClosed({ metric: { E: '1 + v', F: 0, G: 1 } }), false);
  });
});

describe('formulas that close, but go on to somewhere else', () => {
  // Bernoulli's polynomials: both ends meet, in the same direction, and what comes after is another curve.
  const drop = { x: 'u^3 - 1.5u^2 + 0.5u', y: 'u^4 - 2u^3 + u^2', z: 'v', u: [0, 1], v: [-1, 1] };

  test('stay open: a path never leaves the surface', () => {
    const surface = make(drop);
    assert.deepEqual(surface.domain?.periodic, { u: false, v: false });
    const path = surface.shortestPath([0.1, 0], [0.9, 0]);
    assert.ok(/** @type {Float64Array} */ (path.parameters).every((x, i) => i % 2 === 1 || (x >= 0.1 - 1e-12 && x <= 0.9 + 1e-12)));
  });

  test('are refused where they are said to close, and what the message says to write closes', () => {
    refuses(
      () => make({ ...drop, periodic: { u: true } }),
      RangeError,
      /do not repeat beyond the ends of u; .* write u - 1\*floor\(\(u - 0\)\/1\)/,
    );
    const again = '(u - 1*floor((u - 0)/1))';
    const surface = make({ ...drop, x: drop.x.replaceAll('u', again), y: drop.y.replaceAll('u', again) });
    assert.deepEqual(surface.domain?.periodic, { u: true, v: false });
    let length = 0;
    const at = (/** @type {number} */ u) => [u ** 3 - 1.5 * u ** 2 + 0.5 * u, u ** 4 - 2 * u ** 3 + u ** 2, 0];
    for (let i = 0; i < 20000; i++) length += apart(at((1.1 - (0.2 * i) / 20000) % 1), at((1.1 - (0.2 * (i + 1)) / 20000) % 1));
    const path = surface.shortestPath([0.1, 0], [0.9, 0]);
    assert.ok(Math.abs(path.length - length) < 1e-6, `${path.length}, not ${length}`);
  });

  test('a cusp on the seam, where the derivative is zero up to rounding: an astroid as long as unrolled, the shorter way round', () => {
    const surface = make({ x: 'cos(u)^3', y: 'sin(u)^3', z: 'v', u: [0, '2pi'], v: [-1, 1] });
    assert.deepEqual(surface.domain?.periodic, { u: true, v: false });
    const path = surface.shortestPath([0.5, -0.2], [5.5, 0.6]);
    assert.equal(path.status, 'converged');
    close(path.length, Math.hypot(1.5 * Math.sin(0.5) ** 2 + 1.5 * Math.sin(2 * Math.PI - 5.5) ** 2, 0.8), 1e-9);
  });

  test('a crease in the middle of a figure eight, a density, E, F and G', () => {
    const eight = { x: 'sin(u)', y: 'sin(u/2)', z: 'v', u: [0, '2pi'], v: [0, 1] };
    refuses(() => make({ ...eight, periodic: { u: true } }), RangeError, /do not repeat/);
    const dense = { ...gallery.cylinder, density: '1 + (u*(u - 2pi))^2/10' };
    assert.deepEqual(make(dense).domain?.periodic, { u: false, v: false });
    const metric = { E: '2 + u', F: 0, G: 1, u: /** @type {const} */ ([0, 1]), v: /** @type {const} */ ([0, 1]) };
    refuses(() => surfpath.metric({ ...metric, periodic: { u: true } }), RangeError, /E, F and G do not repeat beyond the ends of u/);
    assert.deepEqual(surfpath.metric({ ...metric, E: '2 + v', periodic: { u: true } }).domain?.periodic, { u: true, v: false });
  });
});
