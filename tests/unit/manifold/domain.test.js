// Periodic directions: found where the surface closes smoothly, and crossed by paths.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { gallery } from '../../../web/gallery.js';
import { load } from '../../../web/index.js';
import { anything, close, refuses } from '../../helpers/refuses.js';

const surfpath = await load();
const ring = surfpath.surface(gallery.parametricTorus);

describe('periodic directions', () => {
  /** @param {object} definition */
  const periodic = (definition) => surfpath.surface(anything({ kind: 'parametric', ...definition })).domain?.periodic;

  test('are found where the surface closes smoothly', () => {
    assert.deepEqual(periodic(gallery.parametricTorus), { u: true, v: true });
    assert.deepEqual(periodic(gallery.cylinder), { u: true, v: false });
    assert.deepEqual(periodic(gallery.globe), { u: true, v: false });
    assert.deepEqual(periodic(gallery.catenoid), { u: true, v: false });
    assert.deepEqual(periodic(gallery.saddle), { u: false, v: false });
  });

  test('are found where a density repeats, with a crease or a jump on the seam, too: the path is the one that a seam elsewhere leaves alone', () => {
    for (const density of ['0.3 + abs(sin(u))', '1.5 + 0.5*sign(sin(u))']) {
      const [on, off] = [0, -1].map((from) => surfpath.surface({ ...gallery.cylinder, u: [from, `2pi + ${from}`], density }));
      assert.deepEqual(on.domain?.periodic, { u: true, v: false });
      for (const [a, b] of [
        [5.3, 0.3, 0.96, 0.9],
        [6, 0.2, 0.3, -0.4],
      ].map(([u, v, s, t]) => [
        [u, v],
        [s, t],
      ])) {
        const [path, other] = [on, off].map((surface) => surface.shortestPath(a, b));
        assert.ok(path.converged && other.converged, density);
        assert.ok(Math.abs(path.length - other.length) <= 1e-9 * path.length, `${density}: ${path.length}, ${other.length}`);
      }
    }
    assert.deepEqual(periodic({ ...gallery.cylinder, density: '1 + u' }), { u: false, v: false });
  });

  test('are not where it only meets itself, or all but closes', () => {
    const crease = { x: 'sin(u)', y: 'sin(u/2)', z: 'v', u: [0, '2*pi'], v: [0, 1] };
    assert.deepEqual(periodic(crease), { u: false, v: false });
    assert.deepEqual(periodic({ ...gallery.cylinder, u: [0, '2*pi - 1e-5'] }), { u: false, v: false });
  });

  // Once the size of the whole surface was what edges were compared with: here they were all points, and y was closed.
  test('are judged by what lies beside them, however large the surface is elsewhere', () => {
    const steep = surfpath.graph({ z: 'exp(x)', x: [-5, 25], y: [-1, 1] });
    assert.deepEqual(steep.domain?.periodic, { u: false, v: false });
    close(steep.shortestPath([-4, -0.9], [-4, 0.9]).length, 1.8);
    const peak = surfpath.graph({ z: '0.1/(x^2 + y^2)', x: [-1, 1], y: [-1, 1] });
    assert.ok(peak.shortestPath([-0.9, -0.9], [0.9, -0.9]).length >= 1.8);
    const split = surfpath.graph({ z: '1/x', x: [-1, 1], y: [-1, 1] });
    assert.ok(split.shortestPath([0.1, 0.5], [0.9, -0.5]).length > 8.9);
    const infinite = surfpath.metric({ E: '1/v^2', F: 0, G: 1, u: [-3, 3], v: [0, 5] });
    close(infinite.shortestPath([-3, 5], [3, 5]).length, 1.2);
  });

  test('are found where an edge lies at infinity', () => {
    const funnel = surfpath.parametric({ x: 'v cos(u)', y: 'v sin(u)', z: 'log(v)', u: [0, '2pi'], v: [0, 1] });
    assert.deepEqual(funnel.domain?.periodic, { u: true, v: false });
    assert.ok(funnel.shortestPath([0.1, 0.5], [6.2, 0.5]).length < 0.1);
  });

  test('a crease counts beside a long direction', () => {
    const creased = { x: 'sin(u)', y: 'sin(u/2)', z: '1e9 v', u: [0, '2*pi'], v: [0, 1] };
    assert.deepEqual(periodic(creased), { u: false, v: false });
  });

  test('an explicit answer wins', () => {
    assert.deepEqual(periodic({ ...gallery.parametricTorus, periodic: { v: true } }), { u: false, v: true });
    assert.deepEqual(periodic({ ...gallery.parametricTorus, periodic: {} }), { u: false, v: false });
  });

  test('take any number, and the path goes the short way, its u and v continuous', () => {
    const path = ring.shortestPath([0.2, 0.1], [6.1, 0.1]);
    const turned = ring.shortestPath([0.2 + 2 * Math.PI, 0.1], [6.1 - 4 * Math.PI, 0.1]);
    close(turned.length, path.length);
    const u = Array.from(/** @type {Float64Array} */ (path.parameters)).filter((_, i) => i % 2 === 0);
    close(u[0], 0.2);
    close(/** @type {number} */ (u.at(-1)), 6.1 - 2 * Math.PI);
    for (let i = 1; i < u.length; i++) assert.ok(Math.abs(u[i] - u[i - 1]) < 0.1);
  });

  test('set moves the range and finds them anew', () => {
    const arc = surfpath.parametric({ x: 'cos(u)', y: 'sin(u)', z: 'v', u: [0, 'a'], v: [0, 1], parameters: { a: 3 } });
    assert.equal(arc.domain?.periodic.u, false);
    refuses(() => arc.shortestPath([4, 0], [1, 0]), RangeError, /outside the range of u, \[0, 3\]/);
    arc.set({ a: 2 * Math.PI });
    assert.deepEqual(arc.domain, { u: [0, 2 * Math.PI], v: [0, 1], periodic: { u: true, v: false } });
    assert.equal(arc.shortestPath([4, 0], [1, 0]).status, 'converged');
  });
});

test('a place so many turns away that its digits tell none is refused', async () => {
  const surfpath = await load();
  const ring = surfpath.parametric({ x: 'cos(u)', y: 'sin(u)', z: 'v', u: [0, '2pi'], v: [0, 1] });
  assert.equal(ring.shortestPath([1e6, 0], [1e6 + 1, 0]).status, 'converged');
  assert.throws(
    () => ring.shortestPath([1e18, 0], [1, 0]),
    /^RangeError: shortestPath: from\[0\] = 1000000000000000000 lies over 1e9 turns outside/,
  );
  surfpath.dispose();
});
