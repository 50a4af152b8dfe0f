// What the fields of the page say, as definitions.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { definitionOf } from '../../../demo/state/definition.js';
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
  for (const text of ['x = y = z', '= 1', 'x =', 'x == 1', 'f(x, y, z) = x', 'x^2 + (y = 1)']) {
    assert.equal(functionOf(text), text);
    assert.throws(() => surfpath.implicit({ f: functionOf(text) }), { name: 'ExpressionError' }, text);
  }
});
