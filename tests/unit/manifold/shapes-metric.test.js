// Densities and metrics of graphs, surfaces of revolution, tubes and sweeps: the same as of the parametric surface they write.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { load } from '../../../web/index.js';

const surfpath = await load();
const make = (/** @type {any} */ definition) => surfpath.surface(definition);

/** What every shape is weighted with, over u, v, x, y, z. */
const weights = [
  { density: '1 + 0.5*exp(-(x - 0.5)^2 - y^2) + 0.1*z + 0.1*sin(u)*v*(k - v)' },
  { metric: { E: '2 + sin(u)', F: '0.3*cos(u)', G: '1 + 0.1*v*(k - v)' } },
  { density: '1 + 0.1*x', metric: { E: '2 + sin(u)', F: 0.2, G: '1 + 0.1*k' } },
];
const parameters = { k: 2 };

/** A shape, the parametric surface it writes, and two places. @type {[any, any, number[], number[]][]} */
const shapes = [
  [
    { kind: 'graph', z: '0.3*x*y', x: [-1, 1], y: [0, 'k'] },
    { x: 'u', y: 'v', z: '0.3*u*v', u: [-1, 1], v: [0, 'k'] },
    [-0.7, 0.4],
    [0.8, 1.7],
  ],
  [
    { kind: 'revolution', r: '2 + cos(t)', z: 'sin(t)', t: [0, 'k'] },
    { x: '(2 + cos(v))*cos(u)', y: '(2 + cos(v))*sin(u)', z: 'sin(v)', u: [0, '2pi'], v: [0, 'k'] },
    [0.4, 0.3],
    [5.8, 1.6],
  ],
  [
    { kind: 'tube', centreline: [0, 0, 't'], radius: '1 + 0.1*t', t: [0, 'k'] },
    { x: '(1 + 0.1*v)*cos(u)', y: '(1 + 0.1*v)*sin(u)', z: 'v', u: [0, '2pi'], v: [0, 'k'] },
    [0.4, 0.3],
    [2.8, 1.6],
  ],
  [
    { kind: 'sweep', profile: ['s', '0.2*s^2'], path: [0, 0, 't'], s: [-1, 1], t: [0, 'k'] },
    { x: 'u', y: '0.2*u^2', z: 'v', u: [-1, 1], v: [0, 'k'] },
    [-0.7, 0.4],
    [0.8, 1.7],
  ],
];

describe('a shape with a weight is the parametric surface with it', () => {
  for (const [shape, written, from, to] of shapes)
    for (const weight of weights)
      test(`${shape.kind}, ${Object.keys(weight)}`, () => {
        const [one, other] = [{ ...shape }, { kind: 'parametric', ...written }].map((own) => make({ ...own, ...weight, parameters }));
        assert.deepEqual(one.domain, other.domain);
        const [path, expected] = [one, other].map((surface) => surface.shortestPath(from, to));
        assert.ok(path.converged && expected.converged, `${path.status} ${expected.status}`);
        assert.ok(Math.abs(path.length / expected.length - 1) < 1e-9, `${path.length}, written out ${expected.length}`);
        const [traced, way] = [one, other].map((surface) => surface.trace(from, [1, 1], 0.5));
        for (const [i, x] of way.points.entries()) assert.ok(Math.abs(traced.points[i] - x) < 1e-10);
        for (const surface of [one, other]) surface.set({ k: 1.9 });
        const [later, wanted] = [one, other].map((surface) => surface.shortestPath(from, to));
        assert.ok(Math.abs(later.length / wanted.length - 1) < 1e-9 && later.length !== path.length, 'parameters change the weight, too');
        for (const surface of [one, other]) surface.dispose();
      });
});

test('formulas know the own variables of a shape, too', () => {
  for (const [shape, own, general] of /** @type {const} */ ([
    [{ kind: 'graph', z: 0, x: [0, 1], y: [0, 1] }, '1 + x*y', '1 + u*v'],
    [{ kind: 'revolution', r: 1, z: 't', t: [0, 1] }, '1 + t', '1 + v'],
    [{ kind: 'tube', centreline: [0, 0, 't'], radius: 1, t: [0, 1] }, '1 + t', '1 + v'],
    [{ kind: 'sweep', profile: ['s', 0], path: [0, 0, 't'], s: [0, 1], t: [0, 1] }, '1 + s*t', '1 + u*v'],
  ])) {
    const [one, other] = [own, general].map((density) => make({ ...shape, density }).shortestPath([0.1, 0.2], [0.9, 0.7]).length);
    assert.equal(one, other, shape.kind);
    const [first, second] = [own, general].map(
      (E) => make({ ...shape, metric: { E, F: 0, G: 1 } }).shortestPath([0.1, 0.2], [0.9, 0.7]).length,
    );
    assert.equal(first, second, shape.kind);
  }
});

test('a tube whose frame needs another reference, because a parameter changed: its density follows', () => {
  const bent = { kind: 'tube', centreline: ['a*t', 0, '(1 - a)*t'], radius: 1, t: [0, 1], density: '1 + z^2' };
  const surface = make({ ...bent, parameters: { a: 0 } });
  for (const a of [1, 0.5, 0]) {
    surface.set({ a });
    const fresh = make({ ...bent, parameters: { a } });
    assert.equal(surface.shortestPath([0.3, 0.1], [2, 0.9]).length, fresh.shortestPath([0.3, 0.1], [2, 0.9]).length, `a = ${a}`);
  }
});
