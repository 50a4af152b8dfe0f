// A sample of `make accuracy`: the tolerance that a caller asks for is kept, as a finer solve and traced geodesics see it.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { gallery } from '../../web/gallery.js';
import { load } from '../../web/index.js';
import { askAcross, randomCreases, SURFACES } from '../accuracy/measure/creases.js';
import { askAbout } from '../accuracy/measure/random-pairs.js';
import { pointSource, randomPairs } from '../bench/pairs.js';
import { createRandom } from '../helpers/random.js';
import { ofAll } from '../helpers/sample.js';

const SEED = 31;
const PAIRS = ofAll(4, 6);

/** @type {import('../../web/instance.js').Surfpath} */
let surfpath;
before(async () => {
  surfpath = await load();
});
after(() => surfpath.dispose());

describe(`random pairs, seed ${SEED}`, () => {
  for (const name of /** @type {const} */ ([
    'saddle',
    'helicoid',
    'cylinder',
    'dini',
    'genus2',
    'torus',
    'parametricTorus',
    'bumpy',
    'vase',
    'trefoil',
  ])) {
    test(name, () => {
      const surface = surfpath.surface(/** @type {any} */ (gallery[name]));
      const random = createRandom(SEED);
      const answers = askAbout(surface, random, pointSource(surface, random), PAIRS);
      assert.deepEqual(
        answers.filter(({ verdict }) => verdict !== 'right'),
        [],
      );
      assert.ok(answers.filter(({ traced }) => traced).length > PAIRS / 2, 'most paths can be traced');
      surface.dispose();
    });
  }
});

/** Largest distance of points that should be the same. @param {import('../../web/path.js').Path} path @param {import('../../web/path.js').Path} other */
function apart({ points }, other) {
  let largest = 0;
  for (let i = 0; i < points.length; i += 3)
    largest = Math.max(largest, Math.hypot(...[0, 1, 2].map((k) => points[i + k] - other.points[i + k])));
  return largest;
}

describe(`loose tolerances, seed ${SEED}: kept in length and positions, in fewer steps than tight ones`, () => {
  /** Beside the pole longitudes are wrong between nodes that are right. @type {Record<string, import('../bench/pairs.js').Pair[]>} */
  const known = {
    globe: [
      [
        [-2.5665775174441734, -0.3074253301161185],
        [0.5233622475897675, -0.9479719021033639],
      ],
    ],
  };
  for (const name of /** @type {const} */ (['saddle', 'dini', 'genus2', 'torus', 'globe', 'bumpy', 'trefoil', 'printed47'])) {
    test(name, () => {
      const surface = surfpath.surface(/** @type {any} */ (gallery[name]));
      const pairs = [...randomPairs(surface, createRandom(SEED), 2 * PAIRS), ...(known[name] ?? [])];
      const steps = { loose: 0, tight: 0 };
      for (const tolerance of [0.1, 0.01, 1e-3])
        for (const [from, to] of pairs) {
          const loose = surface.shortestPath(from, to, { start: 'straight', tolerance });
          if (!loose.converged) continue;
          const tight = surface.shortestPath(from, to, { start: loose, tolerance: 1e-11 });
          const error = Math.abs(loose.length - tight.length);
          assert.ok(error <= Math.min(tolerance * tight.length, loose.lengthError + tight.lengthError), `${from} ${to}: ${error}`);
          assert.ok(apart(loose, tight) <= tolerance * tight.length, `${from} ${to} at ${tolerance}: ${apart(loose, tight)}`);
          steps.loose += loose.iterations;
          steps.tight += surface.shortestPath(from, to, { start: 'straight', tolerance: 1e-6 }).iterations;
        }
      assert.ok(steps.loose > 0 && steps.loose < steps.tight, JSON.stringify(steps));
      surface.dispose();
    });
  }
});

describe(`random pairs across creases, seed ${SEED}: as long as unfolded, or as the shortest crossings of circles, or as what bent starts lead to`, () => {
  /** @param {import('../accuracy/measure/creases.js').Creased} creased @param {ReturnType<typeof createRandom>} random */
  const check = (creased, random) => {
    const surface = surfpath.surface(creased.definition);
    const answers = askAcross(creased, surface, random, PAIRS);
    const of = (/** @type {string} */ verdict) => answers.filter((answer) => answer.verdict === verdict);
    assert.deepEqual([...of('wrong'), ...of('longer')], []);
    assert.ok(of('right').length > PAIRS / 2, `only ${of('right').length} converge`);
    surface.dispose();
  };
  for (const [name, make] of Object.entries(SURFACES)) test(name, () => check(make(), createRandom(SEED)));
  test('two creases, a wave', () => {
    const random = createRandom(SEED);
    for (let k = 0; k < 4; k++) check(randomCreases(random), random);
  });
});
