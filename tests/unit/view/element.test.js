// <surface-path> where there is no document, and what its attributes say.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { gallery } from '../../../web/gallery.js';
import { load } from '../../../web/index.js';
import { readDefinition, readLook, readNumbers, readOptions } from '../../../web/view/element/attributes.js';
import { filmOf } from '../../../web/view/element/film.js';
import { describePath, describeProblem } from '../../../web/view/element/words.js';

/** @param {Record<string, string>} values */
const attributes = (values) => (/** @type {string} */ name) => values[name] ?? null;
/** @param {Record<string, string>} values */
const define = (values) => readDefinition(attributes(values));
const surfpath = await load();

test('importing it in Node defines nothing and throws nothing', async () => {
  const { SurfacePathElement } = await import('../../../web/view/element.js');
  assert.equal(typeof SurfacePathElement, 'function');
  assert.equal('customElements' in globalThis, false);
});

describe('attributes', () => {
  test('name a surface of the gallery, and change it', () => {
    assert.deepEqual(define({ surface: 'parametricTorus' }), gallery.parametricTorus);
    const { parameters, density } = /** @type {any} */ (define({ surface: 'parametricTorus', parameters: 'R = 3', density: '1+u^2' }));
    assert.deepEqual([parameters, density], [{ R: 3, a: 1.5 }, '1+u^2']);
    assert.throws(() => define({ surface: 'toString' }), {
      name: 'RangeError',
      message: /no surface 'toString' in the gallery; it has saddle, /,
    });
  });

  test('are formulas, whose names tell the kind', () => {
    const range = '-1, 1';
    const sphere = { f: 'x^2+y^2+z^2-r^2', bounds: '-2,2', parameters: 'r=1' };
    const path = 'cos(t); sin(t); 0';
    const definitions = [
      define({ x: 'u', y: 'v', z: 'a u v', u: range, v: '0, pi/2', parameters: 'a=2, b=1e-3' }),
      define(sphere),
      define({ z: 'x y', x: range, y: range }),
      define({ r: '1', z: 't', t: range }),
      define({ centreline: path, radius: '0.2', t: '0, 2pi' }),
      define({ profile: 'cos(s); sin(s)', path: '5cos(t); 5sin(t); t', s: range, t: '0; 3' }),
    ];
    assert.deepEqual(
      definitions.map(({ kind }) => kind),
      ['parametric', 'implicit', 'graph', 'revolution', 'tube', 'sweep'],
    );
    for (const definition of definitions) surfpath.surface(definition).dispose();
    const bounds = [-2, 2];
    assert.deepEqual(definitions[1], { kind: 'implicit', f: sphere.f, bounds: [bounds, bounds, bounds], parameters: { r: 1 } });
    assert.deepEqual(/** @type {any} */ (definitions[0]).parameters, { a: 2, b: 1e-3 });
    assert.deepEqual(/** @type {any} */ (define({ ...sphere, bounds: '-1 1; -2 2; -3 3' })).bounds[2], [-3, 3]);
  });

  test('that are missing are told by the kind that was meant', () => {
    const range = '-1, 1';
    const missing = (/** @type {Record<string, string>} */ values) => surfpath.surface(define(values));
    assert.throws(() => missing({ x: 'u', y: 'v', z: 'u v' }), /^TypeError: parametric: the definition needs x, y, z, u, v; u is missing$/);
    assert.throws(() => missing({ x: 'cos(t)', y: 'sin(t)', z: 'v', v: range }), /^TypeError: parametric: .*; u is missing$/);
    assert.throws(
      () => missing({ centerline: 'cos(t); sin(t); 0', radius: '0.2', t: '0, 2pi' }),
      /^TypeError: tube: .*; centreline is missing$/,
    );
    assert.throws(() => missing({ z: 'x', x: range }), /^TypeError: graph: .*; y is missing$/);
    for (const x of ['-1..1', '-1 1', '-1; 0; 1'])
      assert.throws(() => missing({ z: 'x', x, y: range }), {
        name: 'TypeError',
        message: `surface-path: x must be a range as '-1, 1', not '${x}'`,
      });
  });

  test('are a metric, and which directions close', () => {
    const plate = { x: 'u', y: 'v', z: '0', u: '-2,2', v: '-2,2' };
    const { metric } = /** @type {any} */ (define({ ...plate, metric: '9; atan2(u, 2); 1' }));
    assert.deepEqual(metric, { E: '9', F: 'atan2(u, 2)', G: '1' });
    const names = ['xx', 'xy', 'xz', 'yy', 'yz', 'zz'];
    assert.deepEqual(Object.keys(/** @type {any} */ (define({ surface: 'sphere', metric: '1;0;0;1;0;1' })).metric), names);
    assert.throws(() => define({ ...plate, metric: '1; 2' }), /metric must be 3 formulas, E; F; G, not 2/);
    const periodic = (/** @type {string} */ text) => /** @type {any} */ (define({ ...plate, periodic: text })).periodic;
    assert.deepEqual([periodic('auto'), periodic('none'), periodic('u v')], ['auto', { u: false, v: false }, { u: true, v: true }]);
    assert.throws(() => periodic('w'), TypeError);
  });

  test('are options of shortestPath', () => {
    assert.deepEqual(readOptions(attributes({})), {});
    const given = attributes({ tolerance: '1e-6', points: '20', algorithm: 'paper', start: 'straight', via: '1,2; 3 4' });
    assert.deepEqual(readOptions(given), {
      tolerance: 1e-6,
      points: 20,
      algorithm: 'paper',
      start: 'straight',
      via: [
        [1, 2],
        [3, 4],
      ],
    });
    assert.deepEqual(readOptions(attributes({ start: '0,0; 0.5,1; 1,1' })), { start: [0, 0, 0.5, 1, 1, 1] });
    for (const tolerance of ['1e-6, 1e-7', '', 'exact'])
      assert.throws(() => readOptions(attributes({ tolerance })), {
        name: 'TypeError',
        message: /^surface-path: tolerance must be a number, not '/,
      });
  });

  test('are a look', () => {
    const { camera } = gallery.sphere;
    assert.deepEqual(readLook(attributes({}), gallery.sphere, [1, 0, 0]), { colour: 'none', camera });
    const look = attributes({ colour: 'distance', resolution: '12', camera: '0,-1,1' });
    const wanted = { colour: 'distance', from: [1, 0, 0], resolution: 12, camera: [0, -1, 1] };
    assert.deepEqual(readLook(look, gallery.sphere, [1, 0, 0]), wanted);
  });

  test('that are wrong are said in words', () => {
    for (const text of ['', 'a,b', '1,,2', '1, Infinity'])
      assert.throws(() => readNumbers('from', text), { name: 'TypeError', message: /^surface-path: from must be numbers/ });
    assert.throws(() => define({}), /name a surface of the gallery/);
    assert.throws(() => define({ surface: 'parametrictorus' }), /in the gallery; did you mean parametricTorus\?$/);
    assert.throws(() => define({ f: 'x^2+y^2+z^2-1' }), /^TypeError: surface-path: f is drawn inside bounds; give them, as in bounds="/);
    assert.throws(() => define({ kind: 'constructor' }), { name: 'RangeError', message: /kind must be one of parametric/ });
    for (const parameters of ['R', 'R=x', 'R=1=2', '=1'])
      assert.throws(() => define({ surface: 'torus', parameters }), { name: 'TypeError', message: /name=number/ });
    assert.throws(() => surfpath.surface(define({ x: 'u', y: 'v', u: '0,1', v: '0,1' })), /z is missing/);
  });
});

describe('words', () => {
  const torus = surfpath.surface(gallery.parametricTorus);

  test('of paths and problems', () => {
    const path = torus.shortestPath([0.5, 0.6], [2.6, 1.2]);
    assert.match(describePath(path), /^Length \d\.\d{3,4}$/);
    assert.equal(describePath({ ...path, length: 1251039.27 }), 'Length 1251039');
    assert.match(describePath({ ...path, status: 'tolerance-not-met', converged: false }), /^Length about \d\.\d+ \(tolerance not met\)$/);
    assert.match(describePath({ ...path, status: 'off-surface', converged: false, length: NaN }), /^No path: an end/);
    const minkowski = surfpath.graph({ z: 0, x: [0, 1], y: [0, 1], metric: { E: 1, F: 0, G: -1 } });
    assert.match(describePath(minkowski.shortestPath([0, 0], [0.5, 1])), /^No path: .*, or its metric not positive definite/);
    assert.match(describeProblem(new Error('Error creating WebGL context.'), path), /^Length .*\. No picture/);
    assert.match(describeProblem(new Error('WebAssembly SIMD is missing'), null), /cannot run the solver/);
    assert.equal(describeProblem(new RangeError('to[0] lies outside'), null), 'to[0] lies outside');
  });

  test('the film ends in the path, or is the path alone where the straight line leads elsewhere', () => {
    const [from, to] = [
      [1.77, 1.76],
      [3.91, 0.52],
    ];
    const film = filmOf(torus, [from, to], torus.shortestPath(from, to));
    assert.ok(film.history.some(({ points }) => points && points.length === film.points.length));
    const hills = surfpath.surface(gallery.hills);
    const path = hills.shortestPath(gallery.hills.from, gallery.hills.to);
    assert.equal(filmOf(hills, [[...gallery.hills.from], [...gallery.hills.to]], path), path);
  });
});
