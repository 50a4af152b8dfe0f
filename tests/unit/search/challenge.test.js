// What becomes of the shortest path that was found where a way that no path was found along is shorter: on a plane, with a solver that is told what to answer.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { chordLengths } from '../../../web/manifold/chords.js';
import { emptyPath } from '../../../web/runtime/result.js';
import { CONVERGED, SHEET_JUMP, STALLED, TOLERANCE_NOT_MET } from '../../../web/runtime/status.js';
import { challenge } from '../../../web/search/challenge.js';
import { anything } from '../../helpers/refuses.js';

const OPTIONS = { tolerance: 1e-9, gradientTolerance: 0, algorithm: 0, points: 64, maxIterations: 200, record: false };
const [from, to] = [
  [0, 0],
  [3, 4],
];
/** By way of the corner, 7 long, and over a peak, 10.2 long. */
const [corner, peak] = [Float64Array.of(0, 0, 3, 0, 3, 4), Float64Array.of(0, 0, -2, 4, 3, 4)];

/** @param {number} status @param {number} length */
const path = (status, length) => ({ ...emptyPath(status), length });
/** A way, and what became of it roughly. @param {Float64Array} start @param {number} status @param {number} [length] */
const tried = (start, status, length = Number.NaN) => ({ to, start, path: path(status, length), coarse: path(status, length) });

/** A plane over u and v, stretched twofold or not; and a solver that answers this. @param {ReturnType<typeof path>} answer @param {number} [factor] @param {boolean} [isPlain] */
const plane = (answer, factor = 1, isPlain = false) => {
  /** @type {Float64Array[]} */
  const asked = [];
  /** How many chords were measured at a time. @type {number[]} */
  const counts = [];
  const chords = (/** @type {ArrayLike<number>} */ places) => {
    const form = Float64Array.from({ length: 1.5 * places.length }, (_, i) => [1, 0, 1][i % 3] * factor ** 2);
    const lengths = chordLengths(places, form, 'form');
    counts.push(lengths.length);
    return lengths;
  };
  const solve = (/** @type {number[]} */ _, /** @type {Float64Array} */ start) => {
    asked.push(start);
    return answer;
  };
  const domain = { poles: [], tips: [], around: [], periodic: [false, false] };
  return { problem: anything({ from, to, domain, branches: [], isPlain, chords, solve }), asked, counts };
};

describe('a way that was not followed', () => {
  const best = path(CONVERGED, 8);

  test('and is longer: the path stays', () => {
    const { problem, asked } = plane(path(CONVERGED, 5));
    assert.equal(challenge(problem, OPTIONS, best, [tried(peak, SHEET_JUMP)]), best);
    assert.equal(asked.length, 0);
  });

  test('and is shorter: it is solved, and the path along it is the shortest', () => {
    const shorter = path(CONVERGED, 5);
    const { problem, asked } = plane(shorter);
    assert.equal(challenge(problem, OPTIONS, best, [tried(peak, SHEET_JUMP), tried(corner, STALLED, 7)]), shorter);
    assert.deepEqual(asked, [corner]);
  });

  test('and is shorter, but cannot be solved: the path is only known not to be the shortest', () => {
    for (const answer of [path(STALLED, 6), path(CONVERGED, 9)]) {
      const { problem } = plane(answer);
      assert.deepEqual(challenge(problem, OPTIONS, best, [tried(corner, SHEET_JUMP)]), { ...best, status: STALLED });
    }
  });

  test('in space is measured in many chords only where it is not longer in few; by a metric these may be longer', () => {
    const few = (/** @type {Float64Array} */ way, /** @type {boolean} */ isPlain) => {
      const { problem, counts } = plane(path(STALLED, 6), 1, isPlain);
      challenge(problem, OPTIONS, best, [tried(way, SHEET_JUMP)]);
      return counts.map((count) => count < 1000);
    };
    assert.deepEqual(few(peak, true), [true]);
    assert.deepEqual(few(corner, true), [true, false]);
    assert.deepEqual(few(peak, false), [false]);
  });

  test('is measured on the surface, not in its parameters', () => {
    const { problem } = plane(path(STALLED, 6), 2);
    assert.equal(challenge(problem, OPTIONS, best, [tried(corner, SHEET_JUMP)]), best);
  });

  test('the straight line that few chords strayed from: its path, if that is shorter', () => {
    const straight = { ...tried(corner, STALLED, 7), start: null, path: { ...path(STALLED, 7), lengthError: 0 } };
    for (const [length, shortest] of [
      [6, 6],
      [9, 8],
    ]) {
      const { problem, asked } = plane(path(CONVERGED, length));
      assert.equal(challenge(problem, OPTIONS, best, [straight]).length, shortest);
      assert.equal(asked.length, 1);
    }
  });

  test('the straight line, where what may be shorter does not hold: its path, unless one that holds is known to be shorter', () => {
    const open = { ...path(TOLERANCE_NOT_MET, 5), lengthError: 4 };
    const { problem } = plane(path(CONVERGED, 8));
    const straight = { ...tried(corner, STALLED, 7), start: null };
    assert.equal(challenge(problem, OPTIONS, open, [straight]).length, 8);
    assert.equal(challenge(problem, OPTIONS, open, [straight], path(CONVERGED, 7)), open);
  });

  test('straight starts, and paths that hold, are none', () => {
    const { problem, asked } = plane(path(STALLED, 6));
    const straight = { ...tried(corner, SHEET_JUMP), start: null };
    assert.equal(challenge(problem, OPTIONS, best, [straight, tried(corner, CONVERGED, 8)]), best);
    assert.equal(asked.length, 0);
  });
});
