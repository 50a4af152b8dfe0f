// What a sketch says of its formulas, and what the library's messages become.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { sentence } from '../../../demo/state/definition.js';
import { namesIn, sketchOf } from '../../../demo/state/sketch.js';

test('a name is used by any formula: of the surface, its ranges, the density, the metric', () => {
  const sketch = { ...sketchOf('own-parametric'), density: '1+k₁', tensor: ['1', '0', 'π*q'] };
  sketch.texts = { ...sketch.texts, z: 'sin(w*u)', 'u-to': '2*p' };
  const used = namesIn(sketch);
  for (const name of ['w', 'p', 'k₁', 'q', 'sin']) assert.ok(used.has(name), name);
  for (const name of ['k', 'i', 'πq', 'W']) assert.ok(!used.has(name), name);
});

test('a message begins with a capital, unless it begins with a name', () => {
  assert.equal(sentence('parametric: u must be a range'), 'u must be a range.');
  assert.equal(sentence('x: unknown name w; write it'), 'Unknown name w; write it.');
  assert.equal(
    sentence('x: unknown name w; the names here are u, v; or give it a value in parameters'),
    'Unknown name w; the names here are u, v; or make it a slider.',
  );
  assert.equal(sentence('the formula has no value'), 'The formula has no value.');
  for (const message of [
    'sin is a function; write sin(…) with brackets.',
    'sin is a function; give the parameter another name.',
    'k is not a function; write k*(…) for a product.',
    'sqrt takes one argument, not 2; write sqrt(…).',
  ])
    assert.equal(sentence(`x: ${message}`), message);
});
