// A sample of `make accuracy`: the tolerance that a caller asks for is kept, as a finer solve and traced geodesics see it.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { gallery } from '../../web/gallery.js';
import { load } from '../../web/index.js';
import { askAcross, randomCreases, SURFACES } from '../accuracy/measure/creases.js';
import { askAbout } from '../accuracy/measure/random-pairs.js';
import { pointSource } from '../bench/pairs.js';
import { createRandom } from '../helpers/random.js';

const SEED = 31;
const PAIRS = 6;

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
