// How the length of legs changes with the joints between them: against derivatives of straight ones.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { changes, LEG, solveLeg } from '../../../web/creases/legs.js';
import { emptyPath } from '../../../web/runtime/result.js';
import { ITERATION_LIMIT } from '../../../web/runtime/status.js';

/** A straight leg, which pulls at its ends along itself. @param {number[]} from @param {number[]} to */
function straight(from, to) {
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
  const along = [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
  return { pulls: [along.map((x) => -x), along] };
}

test('first and second derivatives of three straight legs by two joints on lines, whichever way these are said to lead where a joint has moved', () => {
  const places = [
    [0, 1],
    [0.4, 0],
    [1.1, -1],
    [2, -1.6],
  ];
  const heights = [1, 1, 0.6];
  const across = places.slice(1).map(([x], i) => x - places[i][0]);
  const slopeOf = (/** @type {number} */ i) => across[i] / Math.hypot(across[i], heights[i]);
  const bendOf = (/** @type {number} */ i) => heights[i] ** 2 / Math.hypot(across[i], heights[i]) ** 3;
  for (const sense of [1, -1]) {
    const { slopes, matrix } = changes(
      places.slice(1).map((to, i) => straight(places[i], to)),
      places,
      [
        [1, 0],
        [1, 0],
      ],
      [1e-6, 1e-6],
      (j, by) => ({ place: [places[j + 1][0] + by, places[j + 1][1]], along: [sense, 0] }),
      (_, from, to) => straight(from, to),
    );
    const expected = [
      [bendOf(0) + bendOf(1), -bendOf(1)],
      [-bendOf(1), bendOf(1) + bendOf(2)],
    ];
    for (const j of [0, 1]) {
      assert.ok(Math.abs(slopes[j] - (slopeOf(j) - slopeOf(j + 1))) < 1e-14, `slope ${j}: ${slopes[j]}`);
      for (const k of [0, 1])
        assert.ok(Math.abs(matrix[j][k] - expected[j][k]) < 1e-5, `${j} ${k}: ${matrix[j][k]}, not ${expected[j][k]}`);
    }
  }
});

test('where a joint cannot move, or a leg does not hold, second derivatives are not known', () => {
  const legs = [straight([0, 1], [0.4, 0]), straight([0.4, 0], [1, -1])];
  const places = [
    [0, 1],
    [0.4, 0],
    [1, -1],
  ];
  const there = { place: [0.5, 0], along: [1, 0] };
  assert.deepEqual(changes(legs, places, [[1, 0]], [0.1], () => null, straightOf).matrix, [[Number.NaN]]);
  assert.deepEqual(
    changes(
      legs,
      places,
      [[1, 0]],
      [0.1],
      () => there,
      () => null,
    ).matrix,
    [[Number.NaN]],
  );
});

const straightOf = (/** @type {number} */ _, /** @type {number[]} */ from, /** @type {number[]} */ to) => straight(from, to);

test('legs are charged by their steps and by how often nodes were moved, tenfold where length is not that of space; after a dear one they are less exact', () => {
  /** @type {number[]} */
  const asked = [];
  const ask = (/** @type {{ steps: number }} */ budget, /** @type {number} */ work, isPlain = true) => {
    const heap = {
      pulls: () => [],
      work,
      solve(/** @type {number} */ _record, /** @type {unknown} */ _request, /** @type {typeof LEG} */ options) {
        asked.push(options.tolerance);
        return { ...emptyPath(ITERATION_LIMIT), iterations: 9 };
      },
    };
    const run = (/** @type {any} */ call) => call(heap, 0);
    const question = /** @type {any} */ ({ field: { kind: 1, domain: null, run, isPlain }, sides: { on: () => ({ run }) }, budget });
    const leg = { signs: [1], line: Float64Array.of(0, 0, 0, 1, 0, 0), length: 0, shore: null };
    assert.equal(solveLeg(question, leg, [0, 0, 0], [1, 0, 0], LEG), null);
    return budget.steps;
  };
  const budget = { steps: 1000 };
  assert.equal(ask(budget, 500), 989);
  assert.equal(ask(budget, 500, false), 969);
  assert.equal(ask(budget, 50_000), 859);
  assert.equal(ask(budget, 50_000, false), -151);
  assert.equal(ask(budget, 500), -151, 'nothing is left');
  assert.deepEqual(asked, [1e-12, 1e-12, 1e-12, 1e-9]);
});
