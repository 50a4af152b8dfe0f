// What the page says of outcomes.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { describeNoMeasure, describeStatus, namePath } from '../../../demo/panels/words.js';
import { sketchOf } from '../../../demo/state/sketch.js';
import { STATUS } from '../../../web/runtime/status.js';

test('each status is said in words', () => {
  for (const name of STATUS.values())
    for (const entry of ['saddle', 'own-metric', 'hindered', 'grained']) {
      const [words, advice] = describeStatus(name, { ...sketchOf(entry), start: 'straight' });
      assert.notEqual(words, name);
      assert.match(advice, /^[A-Z].*\.$/, name);
    }
});

test('a measure of length that is none is told as what it is', () => {
  const advice = (/** @type {string} */ entry) => describeStatus('singular-metric', sketchOf(entry))[1];
  assert.match(advice('saddle'), /crease or a tip/);
  assert.doesNotMatch(advice('saddle'), /density|E, F and G/);
  assert.match(advice('hindered'), /crease or a tip.*density must be greater than 0/);
  assert.match(advice('own-metric'), /E, F and G must be positive definite/);
  assert.doesNotMatch(advice('own-metric'), /crease/);
  assert.match(describeNoMeasure(sketchOf('hindered')), /nowhere: the density must be/);
});

test('only what was looked for among all is called the shortest path', () => {
  const name = (/** @type {any} */ part, status = 'converged', isFirst = true) =>
    namePath(status, { ...sketchOf('saddle'), ...part }, isFirst);
  assert.equal(name({}), 'Shortest path');
  assert.equal(name({ task: 'all' }), 'Shortest path');
  assert.equal(name({ task: 'all' }, 'converged', false), 'Geodesic');
  for (const start of ['straight', 'several']) assert.equal(name({ start }), 'Geodesic');
  assert.equal(name({ task: 'trace' }, 'edge-reached'), 'Geodesic');
  assert.equal(name({}, 'saddle'), 'Geodesic');
  for (const status of ['stalled', 'iteration-limit']) assert.equal(name({}, status), 'Path, not at rest');
  assert.equal(name({}, 'tolerance-not-met'), 'Path');
  assert.equal(name({ via: [[0, 0]] }), 'Shortest path');
  assert.equal(name({ via: [[0, 0]], start: 'straight' }), 'Path');
});
