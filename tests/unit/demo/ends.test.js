// What is wrong with the ends of a path and the points on its way, and which of them have a place on the surface.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { chooseEnds, describeMoved, findBadEnd, isOnSurface, mendEnds, shorten } from '../../../demo/state/ends.js';
import { gallery } from 'surfpath/gallery';
import { load } from 'surfpath';

const surfpath = await load();

test('a number that is missing or outside is named with its point', () => {
  const surface = surfpath.surface(gallery.saddle);
  const [a, b, via] = [
    [0, 0],
    [0.5, 0.5],
    [0.1, 0.2],
  ];
  const check = (/** @type {number[][]} */ ...points) => findBadEnd('parametric', surface, points);
  assert.equal(check(a, b, via), null);
  assert.deepEqual(check(a, [Number.NaN, 0]), { end: 1, coordinate: 0, message: 'B needs a number for u, such as 0.5 or pi/2.' });
  assert.deepEqual(check(a, b, via, [0, Number.NaN]), {
    end: 3,
    coordinate: 1,
    message: 'Point 2 needs a number for v, such as 0.5 or pi/2.',
  });
  assert.match(check(a, b, [99, 0])?.message ?? '', /^u of Point 1 must lie between /);
  const torus = surfpath.surface(gallery.parametricTorus);
  assert.equal(findBadEnd('parametric', torus, [a, [99, 0]]), null);
  // As near as the library takes it for rounding.
  const [low, high] = /** @type {import('../../../web/surface.js').ParameterDomain} */ (surface.domain).u;
  assert.equal(check([high + 1e-13 * (high - low), 0.2]), null);
  assert.match(check([high + 1e-11 * (high - low), 0.2])?.message ?? '', /^u of A must lie between /);
  assert.match(findBadEnd('parametric', torus, [a, [1e12, 0]])?.message ?? '', /^u of B must lie between /);
});

test('a number is written with five digits that tell places of its range apart', () => {
  assert.equal(shorten(1.234567, [-2, 2]), '1.2346');
  assert.equal(shorten(4599930.123456, [4599900, 4600100]), '4599930.123');
  assert.equal(shorten(-2.34567e-5, [-3e-5, 3e-5]), '-0.000023457');
  assert.deepEqual([shorten(0, [-1, 1]), shorten(12345.678, [-Infinity, Infinity]), shorten(2, [2, 2])], ['0', '12346', '2']);
});

test('ends at random are two places, however small the surface is', () => {
  const f = 'x^2 + y^2 + z^2 - 1e-8';
  for (const surface of [
    surfpath.graph({ z: '1e-5*sin(x*1e5)', x: [-3e-5, 3e-5], y: [-3e-5, 3e-5] }),
    surfpath.implicit({ f, bounds: /** @type {any} */ ([1, 2, 3].map(() => [-2e-4, 2e-4])) }),
  ]) {
    const [from, to] = chooseEnds(surface, surface.mesh());
    assert.notDeepEqual(from, to);
    assert.ok(surface.shortestPath(from, to).converged);
  }
});

test('ends that would be one dot on what is seen are chosen anew, others stay', () => {
  const definition = /** @type {const} */ ({ kind: 'graph', z: '0', x: [-1000, 1000], y: [-1000, 1000] });
  const surface = surfpath.surface(definition);
  const shown = { surface, drawn: surface, mesh: surface.mesh() };
  const before = [
    [-1.9, -1.2],
    [1.8, 1.4],
  ];
  const [[x, y], [otherX, otherY]] = mendEnds('graph', shown, definition, before);
  assert.ok(Math.hypot(x - otherX, y - otherY) > 28, `${[x, y, otherX, otherY]}`);
  const apart = [before[0], [30, 20]];
  assert.deepEqual(mendEnds('graph', shown, definition, apart), apart);
  assert.equal(describeMoved(before, [apart[1], apart[0]], 'near'), 'A and B were moved apart: they were one dot.');
});

test('where no vertex is seen, ends are points of the surface all the same', () => {
  const surface = surfpath.graph({ z: 'x', x: [-1, 1], y: [-1, 1] });
  for (const end of chooseEnds(surface, surface.mesh(), [[2, 2]])) assert.equal(findBadEnd('graph', surface, [end]), null);
});

test('a point far from an implicit surface has no place on it, as the solver has it', () => {
  const definition = gallery.ellipsoid;
  const surface = surfpath.surface(definition);
  const { from, to } = definition;
  for (const factor of [1, 1.05, 1.2, 1.5, 2, 4]) {
    const point = from.map((x) => factor * x);
    const isOff = surface.shortestPath(point, [...to], { start: 'straight' }).status === 'off-surface';
    assert.equal(isOnSurface(surface, definition, point), !isOff, `${factor}`);
  }
  assert.equal(isOnSurface(surface, definition, [Number.NaN, 0, 0]), false);
});

test('an end far from what is seen goes to the nearest place that is, the other one stays; and that is said', () => {
  const definition = /** @type {const} */ ({ kind: 'graph', z: 'exp(x^4)', x: [-2.5, 2.5], y: [-2.5, 2.5] });
  const surface = surfpath.surface(definition);
  const shown = { surface, drawn: surface, mesh: surface.mesh() };
  const [before, seen] = [
    [
      [-1.9, -1.2],
      [0.5, 1],
    ],
    [
      [-3, 3],
      [-3, 3],
      [0, 6],
    ],
  ];
  const now = mendEnds('graph', shown, definition, before, seen);
  assert.deepEqual(now[1], before[1]);
  assert.ok(Math.exp(now[0][0] ** 4) <= 6 && now[0][0] < -1.05 && Math.abs(now[0][1] + 1.2) < 0.06, `${now[0]}`);
  assert.equal(describeMoved(before, now, 'far'), 'A was moved to where the surface is seen: it lay far outside.');
  assert.equal(describeMoved(before, now), 'A was moved: there is no surface where it was.');
  assert.equal(describeMoved(before, before), null);
});
