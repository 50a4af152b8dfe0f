// What the fields of the page say, as definitions.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { definitionOf, problemOf } from '../../../demo/state/definition.js';
import { load } from '../../../web/index.js';

const surfpath = await load();
const BOX = Object.fromEntries(['x', 'y', 'z'].flatMap((name) => ['from', 'to'].map((end, i) => [`${name}-${end}`, i ? '2' : '-2'])));
/** @param {string} f */
const functionOf = (f) => /** @type {any} */ (definitionOf('implicit', { f, ...BOX }, {})).f;

test('an equation is where both sides are equal', () => {
  for (const [text, meant] of [
    ['x^2+y^2+z^2=1', 'x^2+y^2+z^2-1'],
    ['z = x*y - 1', 'z - x*y + 1'],
    ['1 = x^2 + y^2', '1 - x^2 - y^2'],
    ['x^2 - y = 0', 'x^2 - y'],
    ['x*y*z', 'x*y*z'],
  ]) {
    const [written, known] = [functionOf(text), meant].map((f) => surfpath.implicit({ f }));
    const place = [0.3, -0.7, 1.1];
    assert.ok(Math.abs(written.evaluate(place)[0] - known.evaluate(place)[0]) < 1e-15, text);
  }
});

test('what is none stays as it was written, and is refused by the library', () => {
  for (const text of ['x = y = z', '= 1', 'x =', 'x == 1', 'f(x, y, z) = x', 'f = x', 'x^2 + (y = 1)']) {
    assert.equal(functionOf(text), text);
    assert.throws(() => surfpath.implicit({ f: functionOf(text) }), { name: 'ExpressionError' }, text);
  }
});

test('a mistake is marked in the field where it is, and says what a reader of the page can do', () => {
  const ranges = { 'x-from': '-1', 'x-to': '1', 'y-from': '-1', 'y-to': '1' };
  /** @param {'graph' | 'implicit'} kind @param {import('../../../demo/state/definition.js').Texts} texts */
  const problem = (kind, texts) => {
    try {
      surfpath.surface(definitionOf(kind, texts, {}));
    } catch (error) {
      return problemOf(error, kind, texts);
    }
    throw new Error('there is no mistake');
  };
  const { field, message } = problem('graph', { ...ranges, z: 'y = x^2' });
  assert.equal(field, 'z');
  assert.match(message, /for an equation a = b choose Implicit\.$/);
  assert.match(problem('implicit', { ...BOX, f: 'x = y = z' }).message, /write a - \(b\)\.$/);
  const turned = problem('graph', { ...ranges, z: 'x', 'x-from': '10', 'x-to': 'pi' });
  assert.equal(turned.message, 'x must be a range of two numbers, the smaller first, not 10 to 3.14159.');
  // As the formula of another field.
  assert.equal(problem('graph', { ...ranges, z: 'x', 'y-to': 'x' }).field, 'y-to');
});
