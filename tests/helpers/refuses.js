/** What tests of misuse and of numbers say often. */
import assert from 'node:assert/strict';

/** Hands over what the types forbid. @param {unknown} value @returns {any} */
export const anything = (value) => value;

/**
 * Demands that a call throws an error of exactly this class, with a message that says what is wrong.
 * @param {() => unknown} call
 * @param {Function} kind
 * @param {RegExp} message
 */
export function refuses(call, kind, message) {
  assert.throws(call, (/** @type {any} */ error) => {
    assert.equal(error.constructor, kind, error.stack);
    assert.match(error.message, message);
    return true;
  });
}

/** @param {number} actual @param {number} expected @param {number} [tolerance] relative, absolute below 1 */
export function close(actual, expected, tolerance = 1e-12) {
  assert.ok(Math.abs(actual - expected) <= tolerance * Math.max(1, Math.abs(expected)), `${actual}, not ${expected}`);
}

/** @param {ArrayLike<number>} actual @param {number[]} expected */
export function allClose(actual, expected) {
  assert.equal(actual.length, expected.length);
  for (const [i, x] of expected.entries()) close(actual[i], x);
}

/** What a path without points looks like. @param {import('../../web/index.js').Path} path @param {string} status */
export function assertNoPath(path, status) {
  assert.equal(path.status, status);
  assert.equal(path.converged, false);
  for (const number of [path.length, path.lengthError, path.energy, path.gradientNorm]) assert.ok(Number.isNaN(number));
  assert.deepEqual([path.points.length, path.parameters, path.history.length, path.index], [0, null, 0, -1]);
}
