// The stored shortest paths: whatever is called converged is a geodesic of known length, and lengthError is the truth.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { load } from '../../web/index.js';
import { loadCases } from '../helpers/cases.js';
import { POLYLINE, STRAIGHT } from '../helpers/options.js';
import { verifyPath } from '../helpers/verify-path.js';

/** @typedef {import('../helpers/cases.js').Case} Case */
/** @typedef {import('../../web/path.js').Path} Path */

/** One case with what was found: the path, and the path continued to K = 2,048. @typedef {Case & { path: Path, fine: Path }} Outcome */

/** A path of 65 chords is this much shorter than its geodesic at most, relatively: the roughest, on Eq. 47, by 1.6e-3. */
const CHORDS = 2e-3;
/** One of 2,049 chords is a thousand times closer. */
const FINE_CHORDS = 5e-6;
const FINE = 2048;

const surfpath = await load();

/** @param {Case} one @returns {Outcome} */
function solve(one) {
  const surface = surfpath.surface(/** @type {any} */ (one.definition));
  const path = surface.shortestPath(one.from, one.to, { ...STRAIGHT, ...one.options });
  const fine = path.converged ? surface.shortestPath(one.from, one.to, { ...POLYLINE, points: FINE, start: path }) : path;
  surface.dispose();
  return { ...one, path, fine };
}

const outcomes = loadCases({ families: 'ABCD', kinds: ['parametric', 'implicit'] }).map(solve);
const converged = outcomes.filter(({ path }) => path.converged);

/** @param {number} length @param {number | null} known @param {number} tolerance */
const agrees = (length, known, tolerance) => known !== null && Math.abs(length - known) <= tolerance * known;

/** @param {Outcome} outcome */
function isKnown({ path, expected: { length, second_length: second, naive_length: naive } }) {
  return [length, second, naive].some((known) => agrees(path.length, known, CHORDS));
}

/** @param {Outcome} outcome @param {Path} path */
const violations = ({ definition, from, to }, path) => verifyPath(definition, path, { from, to });

/** What rounding the coordinates of its ends may change a path's length by. @param {Path} path */
const roundingOf = ({ points }) => 2.3e-16 * Math.max(...points.map(Math.abs));

describe('the open data, polyline, K = 64, straight start', () => {
  test('nine in ten converge; the others say why not', (t) => {
    const keys = outcomes.map(({ family, definition, path }) => `${family} ${definition.kind}: ${path.status}`);
    const table = [...new Set(keys)].map((key) => `${key} ${keys.filter((other) => other === key).length}`);
    t.diagnostic(table.join(' · '));
    assert.ok(converged.length >= 0.9 * outcomes.length, `${converged.length} of ${outcomes.length}`);
    const weaker = outcomes.filter(({ path }) => !path.converged);
    for (const { id, path } of weaker)
      assert.ok(['stalled', 'singular-metric', 'sheet-jump'].includes(path.status), `${id}: ${path.status}`);
  });

  test('every converged path has a known length, or continues to a geodesic of its own length', (t) => {
    const unknown = converged.filter((outcome) => !isKnown(outcome));
    t.diagnostic(`geodesics that the data do not list: ${unknown.map(({ id }) => id).join(', ') || 'none'}`);
    for (const outcome of unknown) {
      const { id, path, fine } = outcome;
      assert.equal(fine.status, 'converged', `${id}: the continuation`);
      assert.ok(agrees(path.length, fine.length, CHORDS), `${id}: length ${path.length}, continued ${fine.length}`);
      assert.deepEqual(violations(outcome, fine), [], id);
    }
  });

  test('every converged path is a geodesic', () => {
    for (const outcome of converged) assert.deepEqual(violations(outcome, outcome.path), [], outcome.id);
  });

  /* The estimate is of fourth order: what it leaves of the error is that times the squared turn of a chord, 2 % at most here. Where a path
   * joins an edge between two points, the chord there adds an error of the same order as all others' (measured: 7.2 %). */
  test('lengthError is the error, to a tenth, of every path that is the shortest', (t) => {
    const right = converged.filter(({ fine, expected }) => fine.converged && agrees(fine.length, expected.length, FINE_CHORDS));
    assert.ok(right.length >= 0.9 * converged.length, `only ${right.length} of ${converged.length} are the shortest`);
    const ratios = right.map(({ id, path, expected }) => {
      const error = Math.abs(expected.length - path.length);
      assert.ok(
        error <= 1.1 * path.lengthError + expected.relerr_bound * expected.length,
        `${id}: error ${error}, said ${path.lengthError}`,
      );
      return error / path.lengthError;
    });
    t.diagnostic(`${right.length} shortest paths, largest error / lengthError ${Math.max(...ratios).toFixed(3)}`);
  });

  test('lengthError does not exaggerate: at least four fifths of it is error, of every free path that chords make shorter', () => {
    const free = converged.filter(({ path, fine, expected }) => !path.touchesBoundary && agrees(fine.length, expected.length, FINE_CHORDS));
    const curved = free.filter(({ path }) => path.lengthError > 1000 * roundingOf(path));
    assert.ok(curved.length > 0.5 * converged.length, `only ${curved.length}`);
    for (const { id, path, expected } of curved)
      assert.ok(
        expected.length - path.length >= 0.8 * path.lengthError,
        `${id}: error ${expected.length - path.length}, said ${path.lengthError}`,
      );
  });
});
