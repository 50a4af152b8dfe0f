// Graphs, surfaces of revolution, tubes and sweeps: against closed forms, against themselves by differences, and what is refused.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { compile } from '../../../web/expression/compile.js';
import { gallery } from '../../../web/gallery.js';
import { ExpressionError, load } from '../../../web/index.js';
import { readShape } from '../../../web/manifold/shapes.js';
import { STRAIGHT } from '../../helpers/options.js';
import { createRandom } from '../../helpers/random.js';
import { dot, norm, scale, subtract, unit } from '../../helpers/reference.js';
import { allClose, anything, close, refuses } from '../../helpers/refuses.js';
import { positionOnShape } from '../../helpers/shape-reference.js';
import { verifyPath } from '../../helpers/verify-path.js';
import { instantiate } from '../../helpers/wasm.js';

const surfpath = await load();

/** @typedef {import('../../../web/index.js').Surface} Surface */
/** @typedef {import('../../../web/instance.js').AnyDefinition} AnyDefinition */
/** @typedef {number[]} Vector */

/** @param {Surface} surface @param {number[]} place */
const positionAt = (surface, place) => Array.from(surface.evaluate(place).subarray(0, 3));

/** @param {Surface} surface @param {number[]} place */
const normalAt = (surface, place) => Array.from(surface.evaluate(place).subarray(3));

/** Random places in the rectangle, always the same. @param {Surface} surface @param {number} count */
function placesOn(surface, count) {
  const { u, v } = /** @type {NonNullable<Surface['domain']>} */ (surface.domain);
  const random = createRandom(17);
  return Array.from({ length: count }, () => [random.between(u[0], u[1]), random.between(v[0], v[1])]);
}

/** That a surface is where a function says. @param {Surface} surface @param {(u: number, v: number) => Vector} expected */
function assertPositions(surface, expected) {
  for (const [u, v] of placesOn(surface, 40)) allClose(positionAt(surface, [u, v]), expected(u, v));
}

/** Of every kind one or more, with parameters. @type {Record<string, AnyDefinition>} */
const SHAPES = {
  hills: gallery.hills,
  vase: gallery.vase,
  trefoil: gallery.trefoil,
  helix: { kind: 'tube', centreline: ['cos(t)', 'sin(t)', 'h*t'], radius: 0.3, t: [0, '4pi'], parameters: { h: 0.4 } },
  inflection: { kind: 'tube', centreline: ['t', 't^3', 0], radius: 0.1, t: [-1, 1] },
  fluted: { kind: 'tube', centreline: ['4cos(t)', '4sin(t)', 'sin(3t)'], radius: '0.5+0.1cos(5u)sin(2t)', t: [0, '2pi'] },
  straight: { kind: 'tube', centreline: ['t', '2t', '-t'], radius: '1+t^2', t: [-1, 1] },
  ribbon: { kind: 'sweep', profile: ['s', '0.2s^2'], path: ['t', 'sin(t)', 'cos(t)'], s: [-0.3, 0.3], t: [-2, 2] },
  twisted: {
    kind: 'sweep',
    profile: ['0.3cos(s)', '0.2sin(s)'],
    path: ['2cos(t)', '2sin(t)', '0.5sin(2t)'],
    s: [0, '2pi'],
    t: [0, '2pi'],
    reference: ['-sin(t)cos(t)', 'cos(t)^2', '2+sin(t)'],
  },
};

describe('closed forms', () => {
  test('a graph is the saddle', () => {
    const definition = {
      z: 'x^2-y^2',
      x: /** @type {[number, number]} */ ([-1, 1]),
      y: /** @type {[string, string]} */ (['-pi/3', 'pi/3']),
    };
    const [graph, saddle] = [surfpath.graph(definition), surfpath.surface(gallery.saddle)];
    assert.equal(graph.kind, 'parametric');
    assert.deepEqual(graph.domain, saddle.domain);
    const [found, expected] = [graph, saddle].map((surface) => surface.shortestPath([-0.86, 0.58], [0.86, 0.83]));
    close(found.length, expected.length, 1e-14);
    assert.deepEqual(found.points.length, expected.points.length);
  });

  test('revolution: sphere, cone, torus', () => {
    const sphere = surfpath.revolution({ r: 'R*cos(t)', z: 'R*sin(t)', t: ['-pi/2', 'pi/2'], parameters: { R: 3 } });
    assertPositions(sphere, (u, v) => [3 * Math.cos(v) * Math.cos(u), 3 * Math.cos(v) * Math.sin(u), 3 * Math.sin(v)]);
    assert.deepEqual(sphere.domain?.periodic, { u: true, v: false });
    const [from, to] = [
      [0.3, -0.4],
      [2, 0.7],
    ];
    const [a, b] = [from, to].map((place) => positionAt(sphere, place));
    close(sphere.shortestPath(from, to, { ...STRAIGHT, points: 400 }).length, 3 * Math.acos(dot(a, b) / 9), 1e-5);

    const cone = surfpath.revolution({ r: 't', z: '2t', t: [0.1, 2] });
    for (const place of placesOn(cone, 20)) {
      const [x, y, z] = positionAt(cone, place);
      close(z, 2 * Math.sqrt(x * x + y * y));
      allClose(normalAt(cone, place), unit([2 * x, 2 * y, -z / 2]));
    }

    const torus = surfpath.revolution({ r: '4+1.5cos(t)', z: '1.5sin(t)', t: [0, '2pi'] });
    assert.deepEqual(torus.domain?.periodic, { u: true, v: true });
    const expected = surfpath.surface(gallery.parametricTorus);
    assertPositions(torus, (u, v) => positionAt(expected, [u, v]));
  });

  /** The same torus: the tube's angle begins on the left of the circle, where the centre is. */
  const torus = surfpath.parametric({
    x: '(4-1.5cos(u))*cos(v)',
    y: '(4-1.5cos(u))*sin(v)',
    z: '1.5sin(u)',
    u: [0, '2pi'],
    v: [0, '2pi'],
  });
  const circle = /** @type {[string, string, number]} */ (['4cos(t)', '4sin(t)', 0]);

  test('a tube around a circle is a torus, and has its geodesics', () => {
    const tube = surfpath.tube({ centreline: circle, radius: 1.5, t: [0, '2pi'] });
    assert.deepEqual(tube.domain, torus.domain);
    assertPositions(tube, (u, v) => positionAt(torus, [u, v]));
    for (const place of placesOn(tube, 20)) allClose(normalAt(tube, place), normalAt(torus, place));
    const places = placesOn(tube, 20);
    let converged = 0;
    for (let i = 0; i < places.length; i += 2) {
      const [found, expected] = [tube, torus].map((surface) => surface.shortestPath(places[i], places[i + 1]));
      assert.equal(found.status, expected.status);
      converged += Number(found.converged);
      close(found.length, expected.length, 1e-12);
    }
    assert.ok(converged > 5, `only ${converged} of 10 converged`);
  });

  test('a circle carried along a circle is the same torus', () => {
    const sweep = surfpath.sweep({ profile: ['1.5cos(s)', '1.5sin(s)'], path: circle, s: [0, '2pi'], t: [0, '2pi'] });
    assert.deepEqual(sweep.domain, torus.domain);
    assertPositions(sweep, (u, v) => positionAt(torus, [u, v]));
  });

  test('along the z axis a profile keeps its x and y; along others it stands upright', () => {
    const [s, t] = /** @type {[number, number][]} */ ([
      [-1, 1],
      [0, 2],
    ]);
    const profile = /** @type {[string, string]} */ (['s', 's^3']);
    assertPositions(surfpath.sweep({ profile, path: [0, 0, 't'], s, t }), (u, v) => [u, u ** 3, v]);
    assertPositions(surfpath.sweep({ profile, path: ['t', 0, 0], s, t }), (u, v) => [v, u, u ** 3]);
    assertPositions(surfpath.sweep({ profile, path: [0, 't', 0], s, t }), (u, v) => [-u, v, u ** 3]);
  });

  test('a segment carried along a line is a plane', () => {
    const plane = surfpath.sweep({ profile: ['s', '2s'], path: ['t', 't', 't'], s: [-1, 1], t: [0, 3] });
    const [from, to] = [
      [-0.8, 0.2],
      [0.9, 2.7],
    ];
    close(plane.shortestPath(from, to).length, norm(subtract(positionAt(plane, from), positionAt(plane, to))), 1e-13);
    for (const place of placesOn(plane, 10)) allClose(normalAt(plane, place), normalAt(plane, [0, 1]));
  });

  test('around a helix: at the radius from the centreline, with a radial normal', () => {
    const helix = surfpath.surface(SHAPES.helix);
    for (const place of placesOn(helix, 60)) {
      const t = place[1];
      const across = subtract(positionAt(helix, place), [Math.cos(t), Math.sin(t), 0.4 * t]);
      close(norm(across), 0.3, 1e-14);
      close(dot(across, [-Math.sin(t), Math.cos(t), 0.4]), 0, 1e-14);
      allClose(normalAt(helix, place), scale(across, 1 / 0.3));
    }
  });
});

describe('frames', () => {
  test('every shape is where its definition says', () => {
    for (const [name, definition] of Object.entries(SHAPES)) {
      const position = positionOnShape(definition);
      const surface = surfpath.surface(definition);
      for (const place of placesOn(surface, 30))
        assert.ok(norm(subtract(positionAt(surface, place), position(place))) < 1e-12, `${name} at ${place}`);
    }
  });

  test('paths are geodesics by a reference that knows nothing of the frame', () => {
    for (const [name, definition] of Object.entries(SHAPES)) {
      const surface = surfpath.surface(definition);
      const [from, to] = placesOn(surface, 2);
      const path = surface.shortestPath(from, to, { ...STRAIGHT, points: 200 });
      assert.equal(path.status, 'converged', name);
      assert.deepEqual(verifyPath(anything(definition), path, { from, to }), [], name);
    }
  });

  test('nothing jumps or turns at an inflection, on a straight piece, or where the curvature vanishes', () => {
    /** @type {[string, string, string][]} */
    const curves = [
      ['t', 't^3', '0'],
      ['t', 't^3', 't^5'],
      ['t', '2t', '-t'],
      ['0', '0', 't'],
      ['t', 'sin(t)', '0'],
      ['t', '0', 't^4'],
      ['t', 'max(0,t)^4', 'max(0,-t)^4'],
    ];
    for (const centreline of curves) {
      const surface = surfpath.tube({ centreline, radius: 0.2, t: [-1.5, 1.5] });
      for (const u of [0.1, 2, 4.4]) {
        const along = Array.from({ length: 61 }, (_, i) => positionAt(surface, [u, (i - 30) * 0.01]));
        const third = along
          .slice(3)
          .map((point, i) => norm([0, 1, 2].map((k) => point[k] - 3 * along[i + 2][k] + 3 * along[i + 1][k] - along[i][k])));
        // Steps of 0.01: a smooth curve of this size has third differences of some 1e-6 times its third derivative; a flip or a kink 1e-2.
        assert.ok(Math.max(...third) < 6e-5, `${centreline} at u = ${u}: ${Math.max(...third)}`);
      }
    }
  });

  test('a closed knot closes smoothly', () => {
    for (const definition of [SHAPES.trefoil, SHAPES.fluted, SHAPES.twisted]) {
      const surface = surfpath.surface(definition);
      assert.deepEqual(surface.domain?.periodic, { u: true, v: true });
      for (const u of [0.3, 1.9, 5]) {
        allClose(surface.evaluate([u, 0]), Array.from(surface.evaluate([u, 2 * Math.PI])));
        const across = surface.shortestPath([u, 0.2], [u, 2 * Math.PI - 0.2]);
        assert.ok(across.converged && across.length < 5, `${across.status} ${across.length}`);
      }
    }
    assert.deepEqual(surfpath.surface(SHAPES.helix).domain?.periodic, { u: true, v: false });
  });

  test('an axis is chosen, or else a direction between them, or else one is asked for', () => {
    const t = /** @type {[number, string]} */ ([0, '2pi']);
    const coil = (/** @type {number} */ turns) =>
      /** @type {[string, string, string]} */ ([`(3+cos(${turns}t))*cos(t)`, `(3+cos(${turns}t))*sin(t)`, `sin(${turns}t)`]);
    const loose = surfpath.tube({ centreline: coil(4), radius: 0.2, t });
    assert.deepEqual(loose.domain?.periodic, { u: true, v: true });
    const axes = surfpath.tube({ centreline: ['cos(t)', 'sin(2t)', 'cos(t)+sin(t)'], radius: 0.1, t });
    for (const place of placesOn(axes, 40)) {
      const centre = [Math.cos(place[1]), Math.sin(2 * place[1]), Math.cos(place[1]) + Math.sin(place[1])];
      close(norm(subtract(positionAt(axes, place), centre)), 0.1, 1e-14);
    }
    refuses(
      () => surfpath.tube({ centreline: coil(40), radius: 0.2, t }),
      RangeError,
      /tube: centreline runs in too many .* give reference: \[x, y, z\]/,
    );
    const core = /** @type {[string, string, number]} */ (['-sin(t)', 'cos(t)', 0]);
    const tight = surfpath.tube({ centreline: coil(40), radius: 0.01, t, reference: core });
    assert.deepEqual(tight.domain?.periodic, { u: true, v: true });
  });
});

/**
 * First and second derivatives of a function of one number, by central differences of order four.
 * @param {(t: number) => Vector} f
 * @returns {Vector[]}
 */
function differences(f) {
  const step = 2e-3;
  const [a, b, c, d, e] = [-2, -1, 0, 1, 2].map((k) => f(k * step));
  return [
    a.map((_, k) => (8 * (d[k] - b[k]) - (e[k] - a[k])) / (12 * step)),
    a.map((_, k) => (16 * (b[k] + d[k]) - 30 * c[k] - (a[k] + e[k])) / (12 * step * step)),
  ];
}

test('first and second derivatives against differences of the reference', () => {
  const solver = instantiate();
  let worst = 0;
  for (const [name, definition] of Object.entries(SHAPES)) {
    const { variables, names, outputs } = readShape(definition.kind, definition);
    const found = anything(definition).reference ? null : [0, 0, 1];
    const build = typeof outputs === 'function' ? (/** @type {any} */ formulas) => outputs(formulas, found) : outputs;
    const parameters = definition.parameters ?? {};
    const compiled = compile({ outputs: build, names, variables, parameters, valueOrder: 0, apply: solver.apply });
    const places = placesOn(surfpath.surface(definition), 30);
    const position = positionOnShape(definition);
    const jets = solver.link(compiled, 2).jet(places);
    for (const [i, [u, v]] of places.entries()) {
      const [su, suu] = differences((t) => position([u + t, v]));
      const [sv, svv] = differences((t) => position([u, v + t]));
      const [, both] = differences((t) => position([u + t, v + t]));
      const suv = both.map((x, k) => (x - suu[k] - svv[k]) / 2);
      const expected = [...position([u, v]), ...su, ...sv, ...suu, ...suv, ...svv];
      // The step of 2e-3 leaves 2e-11 times a sixth derivative, which is large where the frame turns fast, and rounding of 1e-10.
      const size = Math.max(1, ...expected.map(Math.abs));
      for (const [k, x] of expected.entries()) worst = Math.max(worst, Math.abs(jets[i][k] - x) / size);
      assert.ok(worst < 1e-7, `${name} at ${u}, ${v}: ${worst}`);
    }
  }
  console.log('derivatives of shapes against differences: at most', worst);
});

describe('set', () => {
  test('changes parameters, and the reference direction where it must', () => {
    const parameters = { a: 0 };
    const definition = {
      centreline: /** @type {[string, string, string]} */ (['t*cos(a)', 0, 't*sin(a)'].map(String)),
      radius: 0.2,
      t: /** @type {[number, number]} */ ([0, 1]),
    };
    const tube = surfpath.tube({ ...definition, parameters });
    for (const a of [0.5, Math.PI / 2, 0.1, 1.5, 0]) {
      tube.set({ a });
      const fresh = surfpath.tube({ ...definition, parameters: { a } });
      assert.deepEqual(tube.evaluate([1, 0.3, 2, 0.9]), fresh.evaluate([1, 0.3, 2, 0.9]), `a = ${a}`);
      assert.equal(tube.shortestPath([0, 0.1], [2, 0.8]).length, fresh.shortestPath([0, 0.1], [2, 0.8]).length);
    }
  });

  test('refuses what leaves no frame, and stays as it was', () => {
    const tube = surfpath.tube({ centreline: ['t', 'a*t^2', 'b*t'], radius: 0.2, t: [-1, 1], parameters: { a: 1, b: 0 } });
    const before = tube.evaluate([1, 0.3]);
    refuses(() => tube.set({ a: Number.MAX_VALUE, b: Number.MAX_VALUE }), RangeError, /centreline stands still or turns back near t = /);
    assert.deepEqual(tube.evaluate([1, 0.3]), before);
    assert.deepEqual(tube.parameters, { ...tube.parameters, a: 1, b: 0 });
  });
});

describe('misuse', () => {
  const tube = { centreline: ['t', 't^2', 0], radius: 0.1, t: [0, 1] };
  const sweep = { profile: ['s', 0], path: ['t', 0, 0], s: [0, 1], t: [0, 1] };
  /** @type {[string, 'graph' | 'revolution' | 'tube' | 'sweep', unknown, Function, RegExp][]} */
  const bad = [
    ['no definition', 'graph', undefined, TypeError, /graph: the definition must be an object/],
    ['a missing range', 'graph', { z: 'x', x: [0, 1] }, TypeError, /graph: .* y is missing/],
    ['a variable it has not', 'graph', { z: 'u', x: [0, 1], y: [0, 1] }, ExpressionError, /z: unknown name u; .* x, y,/],
    [
      'a reversed range',
      'revolution',
      { r: 1, z: 't', t: [1, 0] },
      RangeError,
      /revolution: t must be a range of two numbers, the smaller first/,
    ],
    ['the angle in a profile', 'revolution', { r: 'u', z: 't', t: [0, 1] }, ExpressionError, /r: unknown name u/],
    ['a centreline of two', 'tube', { ...tube, centreline: ['t', 0] }, TypeError, /centreline must be 3 formulas, \[x, y, z\]/],
    ['a centreline that is text', 'tube', { ...tube, centreline: 't' }, TypeError, /centreline must be 3 formulas, \[x, y, z\], not 't'/],
    ['null in a centreline', 'tube', { ...tube, centreline: ['t', null, 0] }, TypeError, /tube: centreline\[1\] must be a formula/],
    ['the angle in a centreline', 'tube', { ...tube, centreline: ['t', 'u', 0] }, ExpressionError, /centreline\[1\]: unknown name u/],
    ['a bad radius', 'tube', { ...tube, radius: 'sin(' }, ExpressionError, /radius: the expression ends too early/],
    [
      'a cusp',
      'tube',
      { ...tube, centreline: ['t^2', 't^3', 0], t: [-1, 1.37] },
      RangeError,
      /centreline stands still or turns back near t = 0.00/,
    ],
    ['a point', 'tube', { ...tube, centreline: [1, 2, 3] }, RangeError, /centreline stands still or turns back near t = 0;/],
    [
      'an undefined piece',
      'tube',
      { ...tube, centreline: ['t', 'sqrt(t)', 0], t: [-1, 1] },
      RangeError,
      /stands still or turns back near t = -1;/,
    ],
    [
      'a reference along it',
      'tube',
      { ...tube, reference: [1, 1, 0] },
      RangeError,
      /tube: reference is zero or along centreline somewhere/,
    ],
    ['no reference direction', 'tube', { ...tube, reference: [0, 0, 0] }, RangeError, /tube: reference is zero/],
    ['a reference that is a word', 'tube', { ...tube, reference: 'up' }, TypeError, /reference must be 3 formulas/],
    ['a reference over u', 'tube', { ...tube, reference: [0, 'u', 1] }, ExpressionError, /reference\[1\]: unknown name u/],
    ['a profile of three', 'sweep', { ...sweep, profile: ['s', 0, 0] }, TypeError, /profile must be 2 formulas, \[x, y\]/],
    [
      'the path\u2019s variable misspelt',
      'sweep',
      { ...sweep, path: ['T', 0, 0] },
      ExpressionError,
      /path\[0\]: unknown name T; did you mean t\?/,
    ],
    ['a parameter called s', 'sweep', { ...sweep, parameters: { s: 1 } }, ExpressionError, /s is a variable of the surface/],
    ['an unknown name in a density', 'tube', { ...tube, density: 's' }, ExpressionError, /density: unknown name s/],
    ['a metric over positions', 'sweep', { ...sweep, metric: { E: 'x', F: 0, G: 1 } }, ExpressionError, /metric.E: unknown name x/],
    [
      'a parameter v beside a density',
      'revolution',
      { r: 1, z: 't', t: [0, 1], parameters: { v: 1 }, density: 1 },
      ExpressionError,
      /v is a variable/,
    ],
    ['a periodic that is a word', 'graph', { z: 0, x: [0, 1], y: [0, 1], periodic: 'no' }, TypeError, /graph: periodic must be/],
  ];
  for (const [what, kind, definition, error, message] of bad)
    test(`${kind} refuses ${what}`, () => {
      refuses(() => surfpath[kind](anything(definition)), error, message);
      if (definition) refuses(() => surfpath.surface(anything({ ...definition, kind })), error, message);
    });

  test('an ExpressionError says in which formula, and where', () => {
    try {
      surfpath.sweep({ profile: ['s', '1+cot(s)'], path: ['t', 0, 0], s: [0, 1], t: [0, 1] });
      assert.fail('accepted');
    } catch (error) {
      assert.ok(error instanceof ExpressionError);
      assert.deepEqual([error.source, error.index, error.argument], ['1+cot(s)', 2, 'profile[1]']);
    }
  });

  test('changing a definition afterwards changes nothing', () => {
    const definition = { centreline: ['t', 'c*t', 0], radius: 1, t: [0, 1], parameters: { c: 0 }, reference: [0, 0, 1] };
    const surface = surfpath.tube(anything(definition));
    definition.centreline[1] = 't^3';
    definition.reference[1] = 5;
    definition.t[1] = 7;
    surface.set({ c: 1 });
    assert.deepEqual(surface.domain?.v, [0, 1]);
    allClose(positionAt(surface, [Math.PI / 2, 0.5]), [0.5, 0.5, 1]);
  });
});
