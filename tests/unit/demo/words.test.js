// What the page says of outcomes, and its numbers: one notation for all sizes, and no digit beyond the error.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import {
  describeNoMeasure,
  describeStatus,
  formatEstimate,
  formatEstimateOf,
  formatLonger,
  formatNumber,
  formatTo,
  namePath,
} from '../../../demo/panels/words.js';
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

test('fewer points are advised where there are fewer, and they count', () => {
  for (const status of ['stalled', 'iteration-limit', 'out-of-memory']) {
    const polyline = { ...sketchOf('saddle'), algorithm: /** @type {const} */ ('polyline') };
    assert.match(describeStatus(status, polyline)[1], /fewer points/);
    for (const sketch of [sketchOf('saddle'), { ...sketchOf('saddle'), points: 1 }]) {
      const [, advice] = describeStatus(status, sketch);
      assert.doesNotMatch(advice, /fewer points/);
      assert.match(advice, /^[A-Z][^:]*(?:: (?:try another algorithm or a less|move the ends)[^:]*)?\.$/, status);
    }
  }
});

test('of a polyline of few points more are advised', () => {
  const sketch = { ...sketchOf('saddle'), algorithm: /** @type {const} */ ('polyline') };
  assert.match(describeStatus('stalled', { ...sketch, points: 5 }, { leaps: true })[1], /choose more of them/);
  assert.match(describeStatus('stalled', { ...sketch, points: 64 }, { leaps: true })[1], /too wavy/);
});

test('while an end moves no other path was looked for', () => {
  assert.match(describeStatus('converged', sketchOf('saddle'))[1], /No shorter path was found/);
  assert.match(describeStatus('converged', sketchOf('saddle'), { isFollowed: true })[1], /No path nearby is shorter/);
});

test('a measure of length that is none is told as what it is', () => {
  const advice = (/** @type {string} */ entry) => describeStatus('singular-metric', sketchOf(entry))[1];
  assert.match(advice('saddle'), /crease or a tip/);
  assert.doesNotMatch(advice('saddle'), /density|E, F and G/);
  assert.match(advice('hindered'), /crease or a tip.*density must be greater than 0/);
  assert.match(advice('own-metric'), /E, F and G must be positive definite/);
  assert.doesNotMatch(advice('own-metric'), /crease/);
  const first = (/** @type {string} */ density) => describeStatus('singular-metric', { ...sketchOf('saddle'), density })[1];
  for (const density of ['-1', ' 0']) assert.match(first(density), /^The density must be greater than 0/);
  for (const density of ['', ' ', 'x']) assert.match(first(density), /^The surface has a crease/);
  assert.match(describeNoMeasure(sketchOf('hindered')), /nowhere: the density must be/);
});

test('where a formula bends or jumps, that is why a path is stuck', () => {
  const advice = (
    /** @type {string} */ z,
    status = 'stalled',
    leaps = false,
    /** @type {'elements' | 'polyline'} */ algorithm = 'elements',
  ) => {
    const sketch = sketchOf('own-graph');
    return describeStatus(status, { ...sketch, algorithm, texts: { ...sketch.texts, z } }, { leaps })[1];
  };
  assert.match(advice('x+abs(y)'), /where edges meet as abs makes them, .*sqrt\(x\^2\+0\.01\)/);
  assert.match(advice('abs(x)+abs(y)', 'tolerance-not-met'), /as abs makes them/);
  assert.match(advice('x*y', 'tolerance-not-met'), /larger tolerance/);
  assert.match(advice('max(x,y)'), /as max makes them.*\+sqrt\(\(x-y\)\^2\+0\.01\)\)\/2/);
  assert.match(advice('abs(x)', 'stalled', false, 'polyline'), /as abs makes one, only elements are exact: choose that algorithm/);
  assert.match(advice('2*floor (x)'), /as floor makes one.*tanh/);
  assert.match(advice('1e9*x*y'), /less steep/);
  assert.match(advice('absorb*x'), /less steep/);
  assert.match(advice('1/x', 'stalled', true), /gap between the ends/);
  assert.match(advice('floor(x)', 'stalled', true), /as floor makes one/);
});

test('of a surface that is smooth by its formula no gap is told, but that it is wavy', () => {
  const advice = (/** @type {string} */ z) => {
    const sketch = sketchOf('own-graph');
    return describeStatus('iteration-limit', { ...sketch, texts: { ...sketch.texts, z } }, { leaps: true })[1];
  };
  for (const z of ['sin(20*x)*sin(20y)', '1e3x^2 - y^10', 'exp(-x) + k*(x + 1)']) assert.match(advice(z), /too wavy/, z);
  for (const z of ['1/x', 'x^0.5', 'x^-1', 'x^y', 'sqrt(x)', 'asin (x)', 'tan(x)']) assert.match(advice(z), /gap/, z);
});

test('a trace that runs out of steps is too long', () => {
  const sketch = { ...sketchOf('parametricTorus'), task: /** @type {const} */ ('trace') };
  assert.match(describeStatus('iteration-limit', sketch)[1], /shorten the length/);
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

test('a number has the digits that are asked for, and a power of ten where zeros would be many', () => {
  assert.equal(formatNumber(8.44729481, 4), '8.447');
  assert.equal(formatNumber(-0.5, 3), '−0.500');
  assert.equal(formatNumber(0, 3), '0');
  assert.equal(formatNumber(1234, 3), '1230');
  assert.equal(formatNumber(9.996, 3), '10.0');
  assert.equal(formatNumber(0.0001234, 2), '0.00012');
  assert.equal(formatNumber(0.000001, 1), '1 × 10⁻⁶');
  assert.equal(formatNumber(4.6e30, 4), '4.600 × 10³⁰');
  assert.equal(formatNumber(-2.5e-12, 2), '−2.5 × 10⁻¹²');
  assert.equal(formatNumber(12345678.9, 9), '12345678.9');
  assert.equal(formatNumber(Number.NaN), '–');
});

test('a length ends with the digit that is uncertain, nine digits at most', () => {
  assert.equal(formatTo(8.447294813, 3e-14), '8.44729481');
  assert.equal(formatTo(8.447294813, 3.2e-4), '8.4473');
  assert.equal(formatTo(1234.5, 30), '1230');
  assert.equal(formatTo(42, 872.5), '≈ 42');
  assert.equal(formatTo(4.599999999999998e30, 18927999999999996), '4.60000000 × 10³⁰');
  assert.equal(formatTo(97.9, 46), '98');
  assert.equal(formatTo(0, 0), '0');
  assert.equal(formatTo(1.5, Number.NaN), '1.500000');
  assert.equal(formatTo(1.5, Number.POSITIVE_INFINITY), '1.500000');
});

test('a path is so much longer than the shortest, or as long but for rounding', () => {
  assert.equal(formatLonger(1.5, 1), '+50.0 %');
  for (const rounding of [0, 2e-16, -1e-16]) assert.equal(formatLonger(Math.PI * (1 + rounding), Math.PI), 'as long');
});

test('an error has one digit, written as the length is', () => {
  assert.equal(formatEstimate(872.5), '± 900');
  assert.equal(formatEstimate(0.00032), '± 0.0003');
  assert.equal(formatEstimate(0.000001), '± 1 × 10⁻⁶');
  assert.equal(formatEstimate(2e-8), '± 2 × 10⁻⁸');
  assert.equal(formatEstimate(18927999999999996), '± 2 × 10¹⁶');
  assert.equal(formatEstimate(0), '');
});

test('below the last digit that is shown, only that it is', () => {
  assert.equal(formatEstimateOf(8.447294813, 3e-14), 'error < 10⁻⁸');
  assert.equal(formatEstimateOf(8.447294813, 2e-8), '± 2 × 10⁻⁸');
  assert.equal(formatEstimateOf(12345678.9, 0.001), 'error < 10⁻¹');
  assert.equal(formatEstimateOf(9.9999999996, 1e-9), 'error < 10⁻⁷');
  assert.equal(formatEstimateOf(4.6e30, 7), 'error < 10²²');
  assert.equal(formatEstimateOf(1, 0), '');
});
