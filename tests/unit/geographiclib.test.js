// A sample of `make accuracy`: lengths on ellipsoids against GeographicLib, to 1e-9 or with a status that promises less.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { load } from '../../web/index.js';
import { definitionOf, ELLIPSOIDS, solvePair, solvePairs } from '../accuracy/measure/geographiclib.js';
import { createRandom } from '../helpers/random.js';

const SEED = 3;
const PAIRS = 60;

/** Nearly antipodal: a path with a kink at the pole, up to 0.2 m too long, or one far from it, up to 3 % too long, was called converged. @type {[string, [number, number], [number, number]][]} */
const PAST_A_POLE = [
  ['wgs84', [-16.127399843379, 30.32535812817514], [16.127082422441152, 210.32454185438675]],
  ['oblate', [77.52353759466857, 154.09631087444723], [-77.50651103988271, 334.08792746003314]],
  ['oblate', [-38.554324590509275, 122.85257242619991], [38.55318268173095, 302.8554006206264]],
  ['wgs84', [31.048292483132055, 122.95298209413886], [-31.049460389331927, 302.951018361574]],
  ['oblate', [25.76706366215061, -26.505125630646944], [-22.906089376668497, 153.52747432319424]],
];

const surfpath = await load();

describe(`random pairs, seed ${SEED}`, () => {
  for (const name of Object.keys(ELLIPSOIDS))
    test(name, () => {
      const surface = surfpath.surface(definitionOf(name));
      const answers = solvePairs(name, surface, createRandom(SEED), PAIRS);
      surface.dispose();
      assert.deepEqual(
        answers.filter(({ verdict }) => verdict === 'wrong'),
        [],
      );
      assert.ok(answers.filter(({ verdict }) => verdict === 'right').length >= 0.95 * PAIRS);
    });
});

test('paths that pass a pole closely', () => {
  for (const [name, from, to] of PAST_A_POLE) {
    const surface = surfpath.surface(definitionOf(name));
    const [a, b] = [from, to].map(([latitude, longitude]) => ({ latitude, longitude }));
    const answer = solvePair(name, surface, a, b);
    surface.dispose();
    assert.equal(answer.verdict, 'right', JSON.stringify(answer));
  }
});
