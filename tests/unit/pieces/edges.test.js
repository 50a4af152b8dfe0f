// Cuspidal edges of implicit surfaces: paths that lead over them, against cylinders that are unrolled, and surfaces of u and v.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { load } from '../../../web/index.js';
import { createRandom } from '../../helpers/random.js';
import { ofAll } from '../../helpers/sample.js';
import { close } from '../../helpers/refuses.js';

const surfpath = await load();

/** @param {number} size @returns {[[number, number], [number, number], [number, number]]} */
const within = (size) => [
  [-size, size],
  [-size, size],
  [-size, size],
];

/** A point of a cylinder whose curve is that far around, and how far that is along the curve. @typedef {{ at: number[], along: number }} Drawn */

/** @param {ReturnType<typeof surfpath.implicit>} surface @param {Drawn} from @param {Drawn} to @param {number} around the whole curve, infinite where it is open */
function checkUnrolled(surface, from, to, around) {
  const straight = Math.abs(from.along - to.along);
  const length = Math.hypot(Math.min(straight, around - straight), from.at[2] - to.at[2]);
  const path = surface.shortestPath(from.at, to.at);
  assert.equal(path.status, 'converged', `${from.at} to ${to.at}`);
  close(path.length, length, 1e-9);
  assert.ok(Math.abs(path.length - length) <= path.lengthError, `${path.length} ± ${path.lengthError}, not ${length}`);
  assert.equal(surface.shortestPath(to.at, from.at).length, path.length);
}

describe('a cylinder over y² = x³', () => {
  const random = createRandom(5);
  const draw = (/** @type {number} */ side) => {
    const [x, z] = [random.between(0.02, 1.2), random.between(-1.2, 1.2)];
    return { at: [x, side * Math.sqrt(x ** 3), z], along: (side * (Math.sqrt(4 + 9 * x) ** 3 - 8)) / 27 };
  };
  test('over its edge as long as unrolled, both ways to the bit', () => {
    const surface = surfpath.implicit({ f: 'y^2 - x^3', bounds: within(1.5) });
    for (let i = 0; i < ofAll(3, 24); i++) checkUnrolled(surface, draw(1), draw(-1), Infinity);
    surface.dispose();
  });
  test('without bounds', () => {
    const surface = surfpath.implicit({ f: 'y^2 - x^3' });
    checkUnrolled(surface, draw(1), draw(-1), Infinity);
    surface.dispose();
  });
  test('moved and turned, where places on its edge are no round numbers', () => {
    const [cos, sin, aside] = [0.8, 0.6, [0.31, -0.22]];
    const surface = surfpath.implicit({
      f: `(${cos}*(y - ${aside[1]}) - ${sin}*(x - ${aside[0]}))^2 - (${cos}*(x - ${aside[0]}) + ${sin}*(y - ${aside[1]}))^3`,
      bounds: within(2),
    });
    const moved = (/** @type {Drawn} */ { at: [x, y, z], along }) => ({
      at: [cos * x - sin * y + aside[0], sin * x + cos * y + aside[1], z],
      along,
    });
    for (let i = 0; i < ofAll(1, 6); i++) checkUnrolled(surface, moved(draw(1)), moved(draw(-1)), Infinity);
    surface.dispose();
  });
});

test('a cylinder over an astroid: over one edge, over two, and the shorter way round', () => {
  const surface = surfpath.implicit({ f: '(x^2 + y^2 - 1)^3 + 27*x^2*y^2', bounds: within(1.5) });
  const draw = (/** @type {number} */ angle, /** @type {number} */ z) => {
    const turns = Math.floor(angle / (Math.PI / 2));
    return { at: [Math.cos(angle) ** 3, Math.sin(angle) ** 3, z], along: 1.5 * (turns + Math.sin(angle - (turns * Math.PI) / 2) ** 2) };
  };
  const random = createRandom(2);
  const pairs = [
    [0.6, 2.4],
    [1.2, 3.7],
    [0.5, 5.9],
    ...Array.from({ length: ofAll(0, 12) }, () => [0, 0].map(() => random.between(0.1, 6.2))),
  ];
  for (const [from, to] of pairs) checkUnrolled(surface, draw(from, random.between(-1, 1)), draw(to, random.between(-1, 1)), 6);
  surface.dispose();
});

test('a lens whose rim is an edge, against the same of u and v', () => {
  const lens = surfpath.implicit({ f: 'z^2 - (1 - x^2 - y^2)^3', bounds: within(1.3) });
  const other = surfpath.parametric({ x: 'sin(v)*cos(u)', y: 'sin(v)*sin(u)', z: 'cos(v)^3', u: [0, '2pi'], v: [0, 'pi'] });
  const random = createRandom(4);
  for (let i = 0; i < ofAll(2, 10); i++) {
    const ends = [0, Math.PI / 2].map((low) => [random.between(0, 6.2), random.between(low + 0.15, low + 1.4)]);
    const [path, known] = [lens.shortestPath(...pointsOf(other, ends)), other.shortestPath(ends[0], ends[1])];
    assert.ok(path.converged && known.converged, `${ends}: ${path.status}, ${known.status}`);
    close(path.length, known.length, 1e-9);
  }
  for (const surface of [lens, other]) surface.dispose();
});

test('a deltoid, of which rounding leaves no edges: a path is converged, and as long as unrolled, or says how far it may be off', () => {
  const surface = surfpath.implicit({ f: '(x^2 + y^2)^2 + 18*(x^2 + y^2) - 27 - 8*(x^3 - 3*x*y^2)', bounds: within(4) });
  const draw = (/** @type {number} */ angle, /** @type {number} */ z) => {
    const third = Math.floor(angle / ((2 * Math.PI) / 3));
    const rest = angle - (third * 2 * Math.PI) / 3;
    return {
      at: [2 * Math.cos(angle) + Math.cos(2 * angle), 2 * Math.sin(angle) - Math.sin(2 * angle), z],
      along: (8 / 3) * (2 * third + 1 - Math.cos(1.5 * rest)),
    };
  };
  for (const [from, to] of [
    [draw(1, 0.4), draw(3.2, -1)],
    [draw(0.7, 1), draw(5.2, 2)],
  ].slice(0, ofAll(1, 2))) {
    const straight = Math.abs(from.along - to.along);
    const length = Math.hypot(Math.min(straight, 16 - straight), from.at[2] - to.at[2]);
    const path = surface.shortestPath(from.at, to.at);
    assert.ok(Math.abs(path.length - length) <= path.lengthError, `${path.status} ${path.length} ± ${path.lengthError}, not ${length}`);
    assert.ok(path.lengthError <= 5e-3 * length);
  }
  surface.dispose();
});

/** @param {ReturnType<typeof surfpath.parametric>} surface @param {number[][]} ends @returns {[number[], number[]]} */
function pointsOf(surface, ends) {
  const [from, to] = ends.map((place) => Array.from(surface.evaluate(place)).slice(0, 3));
  return [from, to];
}
