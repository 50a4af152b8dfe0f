// Numbers as the page writes them: one notation for all sizes, and no digit beyond the error.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { formatEstimate, formatNumber, formatTo } from '../../../demo/panels/words.js';

test('a number has the digits that are asked for, and a power of ten where zeros would be many', () => {
  assert.equal(formatNumber(8.44729481, 4), '8.447');
  assert.equal(formatNumber(-0.5, 3), '−0.500');
  assert.equal(formatNumber(0, 3), '0.00');
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
  assert.equal(formatTo(42, 872.5), '40');
  assert.equal(formatTo(4.599999999999998e30, 18927999999999996), '4.60000000 × 10³⁰');
  assert.equal(formatTo(1.5, Number.NaN), '1.500000');
  assert.equal(formatTo(1.5, Number.POSITIVE_INFINITY), '1.500000');
});

test('an error has one digit, written as the length is', () => {
  assert.equal(formatEstimate(872.5), '± 900');
  assert.equal(formatEstimate(0.00032), '± 0.0003');
  assert.equal(formatEstimate(0.000001), '± 1 × 10⁻⁶');
  assert.equal(formatEstimate(2e-8), '± 2 × 10⁻⁸');
  assert.equal(formatEstimate(18927999999999996), '± 2 × 10¹⁶');
  assert.equal(formatEstimate(0), '');
});
