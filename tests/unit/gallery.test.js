/** The gallery is data: that it is well-formed, frozen, and that its numbers are true is checked with mathjs. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { parse } from 'mathjs';
import { gallery } from '../../web/gallery.js';
import { createRandom } from '../helpers/random.js';
import { compileExpression, cross, norm, referenceSurface } from '../helpers/reference.js';

/** @typedef {import('../../web/gallery.js').GalleryEntry} Entry */

const entries = /** @type {[string, Entry][]} */ (Object.entries(gallery));
const random = createRandom(4);

const definitionFields = {
  parametric: ['kind', 'x', 'y', 'z', 'u', 'v', 'parameters'],
  implicit: ['kind', 'f', 'bounds', 'parameters'],
  graph: ['kind', 'z', 'x', 'y', 'parameters'],
  revolution: ['kind', 'r', 'z', 't', 'parameters'],
  tube: ['kind', 'centreline', 'radius', 't', 'parameters'],
  sweep: ['kind', 'profile', 'path', 's', 't', 'parameters'],
};
const descriptionFields = ['title', 'formula', 'source', 'from', 'to', 'camera'];
const functions = ['sin', 'cos', 'tan', 'exp', 'log', 'sqrt', 'sinh', 'cosh'];

/**
 * The names that an expression uses.
 *
 * @param {string|number} expression
 * @returns {string[]}
 */
function namesIn(expression) {
  /** @type {string[]} */
  const names = [];
  parse(String(expression)).traverse((node) => {
    if ('name' in node && node.type === 'SymbolNode') names.push(String(node.name));
  });
  return names;
}

/**
 * The expressions of an entry, and the variables that they may use.
 *
 * @param {Entry} entry
 * @returns {[(string|number)[], string[]]}
 */
function expressionsOf(entry) {
  switch (entry.kind) {
    case 'implicit':
      return [[entry.f], ['x', 'y', 'z']];
    case 'parametric':
      return [
        [entry.x, entry.y, entry.z],
        ['u', 'v'],
      ];
    case 'graph':
      return [[entry.z], ['x', 'y']];
    case 'revolution':
      return [[entry.r, entry.z], ['t']];
    case 'tube':
      return [
        [...entry.centreline, entry.radius],
        ['u', 't'],
      ];
    case 'sweep':
      return [
        [...entry.profile, ...entry.path],
        ['s', 't'],
      ];
  }
}

test('has every surface of the paper, and more', () => {
  const sources = entries.map(([, { source }]) => source).join('\n');
  for (const equation of [39, 40, 41, 42, 43, 44, 45, 46, 47, 48]) assert.match(sources, new RegExp(`Eq\\. ${equation}\\b`));
  assert.ok(entries.length >= 18);
  const titles = entries.map(([, { title }]) => title);
  assert.equal(new Set(titles).size, titles.length, 'titles are unique');
});

test('entries have the fields that a definition and a picture need, and no others', () => {
  for (const [name, entry] of entries) {
    const allowed = [...definitionFields[entry.kind], ...descriptionFields];
    assert.deepEqual(
      Object.keys(entry).filter((field) => !allowed.includes(field)),
      [],
      name,
    );
    for (const field of /** @type {const} */ (['title', 'formula', 'source'])) assert.ok(entry[field].length > 3, `${name}.${field}`);
    const width = entry.kind === 'implicit' ? 3 : 2;
    assert.equal(entry.from.length, width, name);
    assert.equal(entry.to.length, width, name);
    if (entry.camera) assert.ok(Math.abs(norm([...entry.camera]) - 1) < 0.02, `${name}.camera`);
  }
});

test('is frozen all the way down and survives structuredClone', () => {
  /** @param {unknown} value */
  const frozen = (value) => Object.isFrozen(value) && (typeof value !== 'object' || Object.values(value ?? {}).every(frozen));
  assert.ok(frozen(gallery));
  assert.deepEqual(structuredClone(gallery), gallery);
});

test('expressions use the plain syntax, known functions, their variables and every parameter', () => {
  for (const [name, entry] of entries) {
    const [expressions, variables] = expressionsOf(entry);
    const parameters = Object.keys(entry.parameters ?? {});
    const used = expressions.flatMap(namesIn);
    const known = [...variables, ...parameters, ...functions, 'pi'];
    assert.deepEqual(
      used.filter((one) => !known.includes(one)),
      [],
      name,
    );
    assert.deepEqual(
      parameters.filter((one) => !used.includes(one)),
      [],
      name,
    );
    for (const expression of expressions) assert.doesNotMatch(String(expression), /[0-9)][a-z(]|\*\*|[^\x20-\x7e]/, `${name}: explicit *`);
  }
});

test('entries with a rectangle: it is one, finite and regular inside, the points well inside', () => {
  for (const [name, entry] of entries) {
    const surface = referenceSurface(/** @type {any} */ (entry));
    if (surface.kind !== 'parametric') continue;
    for (const place of [entry.from, entry.to]) {
      surface.rectangle.forEach(([low, high], i) => {
        assert.ok(low < high && place[i] > low && place[i] < high, `${name} at ${place}`);
      });
    }
    for (let trial = 0; trial < 50; trial++) {
      const place = surface.rectangle.map(([low, high]) => random.between(low, high));
      const area = norm(cross(...surface.tangents(place)));
      assert.ok(area > 1e-6 && Number.isFinite(norm(surface.position(place))), `${name} at ${place}, seed ${random.seed}`);
    }
  }
});

test('implicit entries: the points lie on the surface, inside the box', () => {
  for (const [name, entry] of entries) {
    const surface = entry.kind === 'implicit' ? referenceSurface(entry) : null;
    if (entry.kind !== 'implicit' || surface?.kind !== 'implicit') continue;
    for (const point of [entry.from, entry.to]) {
      const distance = Math.abs(surface.value(point)) / norm(surface.gradient(point));
      assert.ok(distance < 1e-12, `${name}: ${point} is ${distance} off`);
      assert.ok(
        point.every((x, i) => x > entry.bounds[i][0] && x < entry.bounds[i][1]),
        `${name}: ${point}`,
      );
    }
  }
});

test('implicit entries: the box holds the whole surface, positive all over its faces', () => {
  for (const [name, entry] of entries) {
    if (entry.kind !== 'implicit') continue;
    const value = compileExpression(entry.f, ['x', 'y', 'z'], entry.parameters);
    const at = (/** @type {number} */ axis, /** @type {number} */ part) => {
      const [low, high] = entry.bounds[axis];
      return low + part * (high - low);
    };
    const parts = Array.from({ length: 25 }, (_, i) => i / 24);
    for (const axis of [0, 1, 2]) {
      for (const [side, a, b] of [0, 1].flatMap((end) => parts.flatMap((one) => parts.map((two) => [end, one, two])))) {
        const point = [0, 0, 0];
        point[axis] = at(axis, side);
        point[(axis + 1) % 3] = at((axis + 1) % 3, a);
        point[(axis + 2) % 3] = at((axis + 2) % 3, b);
        assert.ok(value(point) > 0, `${name} at ${point}`);
      }
    }
  }
});

test('formulas that were rewritten say the same', () => {
  const at = () => [random.between(-1.5, 1.5), random.between(-1.5, 1.5), random.between(-1.5, 1.5)];
  const chebyshev = (/** @type {number} */ t) => Math.cos(4 * Math.acos(t));
  const tori = (/** @type {number[]} */ [x, y, z]) => {
    const s = (x * x + y * y + z * z + 1 - 0.04) ** 2;
    return (s - 4 * (x * x + y * y)) * (s - 4 * (x * x + z * z)) * (s - 4 * (y * y + z * z)) - 0.01;
  };
  const distances = (/** @type {number[]} */ [x, y, z]) =>
    Math.hypot(x - 1, y, z) * Math.hypot(x + 1, y, z) * Math.hypot(x, y - 1, z) * Math.hypot(x, y + 1, z) - 1.1;
  /** @param {import('../../web/gallery.js').ImplicitDefinition} entry */
  const valuesOf = (entry) => compileExpression(entry.f, ['x', 'y', 'z'], entry.parameters);
  for (let trial = 0; trial < 20; trial++) {
    const point = at();
    const small = point.map((x) => x / 1.5);
    const sum = small.map(chebyshev).reduce((a, b) => a + b);
    for (const [found, wanted] of [
      [valuesOf(gallery.banchoffChmutov)(small), sum],
      [valuesOf(gallery.threeTori)(point), tori(point)],
      [valuesOf(gallery.metamorphosis)(point), distances(point)],
    ]) {
      assert.ok(Math.abs(found - wanted) <= 1e-12 * Math.max(1, Math.abs(wanted)), `${found}, not ${wanted}, seed ${random.seed}`);
    }
  }
});

test('it is frozen, and its types say so', () => {
  assert.throws(() => {
    // @ts-expect-error for reading only
    gallery.saddle.title = '';
  }, TypeError);
  assert.throws(() => {
    // @ts-expect-error for reading only
    gallery.saddle.u[0] = 0;
  }, TypeError);
});
