import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { load } from '../../../web/index.js';
import { SIDE, shortestBeside } from '../../accuracy/measure/waves.js';
import { createRandom } from '../../helpers/random.js';
import { ofAll } from '../../helpers/sample.js';
import { verifyPath } from '../../helpers/verify-path.js';

/** Heights, ends, and the length of a path between them that was found by bending others aside at random: a graph alone leads to longer ones, by 4e-6 to 7e-3. @type {[string, number[], number[], number][]} */
const KNOWN = [
  ['0.15*sin(14x)*cos(12y)', [-1.64, -0.07], [0.46, -1.61], 3.08183776125],
  ['0.15*sin(14x)*cos(12y)', [-1.6, -0.57], [0.2, 1.97], 3.6253051992],
  ['0.15*sin(14x)*cos(12y)', [-1.01, -1.83], [1.1, -1.13], 2.54411160091],
  ['0.2*sin(10x)*cos(10y)', [-1.52, 1.82], [1.29, -1.81], 5.38153671786],
  ['0.1*sin(20x)*sin(20y)', [1.67, -1.16], [0.31, 1.35], 3.32852707349],
  ['0.1*sin(20x)*sin(20y)', [1.28, -1.75], [1.73, -0.56], 1.45760773785],
  ['0.1*sin(20x)*sin(20y)', [-0.96, -0.18], [1.49, 0.87], 3.07951335178],
  ['0.1*sin(20x)*sin(20y)', [0.49, -1.86], [-1.46, -1.5], 2.18997397703],
  ['0.25*sin(12x + 3y)*cos(9y - 2x)', [1.18, 1.01], [-0.54, -1.09], 3.39408647757],
  ['0.07*sin(16x)*cos(16y)', [-0.34, 1.87], [1.43, -1.08], 3.78178923611],
  ['0.07*sin(16x)*cos(16y)', [0.53, -0.55], [-1.66, 1.16], 3.06318288361],
];
/** The same on a torus, closed both ways, and on a sphere with poles. */
const RIPPLED = '0.6 + 0.1*sin(20u)*cos(7v)';
const TORUS = /** @type {const} */ ({
  x: `(2 + (${RIPPLED})*cos(v))*cos(u)`,
  y: `(2 + (${RIPPLED})*cos(v))*sin(u)`,
  z: `(${RIPPLED})*sin(v)`,
  u: [0, '2pi'],
  v: [0, '2pi'],
});
const BUMPY = '1 + 0.1*sin(12u)*sin(12v)';
const SPHERE = /** @type {const} */ ({
  x: `(${BUMPY})*sin(v)*cos(u)`,
  y: `(${BUMPY})*sin(v)*sin(u)`,
  z: `(${BUMPY})*cos(v)`,
  u: [0, '2pi'],
  v: [0, 'pi'],
});
/** @type {[typeof TORUS | typeof SPHERE, number[], number[], number][]} */
const CLOSED = [
  [TORUS, [6.19, 2.94], [3.08, 0.47], 5.53128166267],
  [TORUS, [0.24, 1.91], [3.19, 1.3], 5.18581651255],
  [TORUS, [5.68, 0.13], [2.35, 4.22], 5.90204509436],
  [SPHERE, [4.83, 0.86], [2.9, 2.45], 2.5424431161],
  [SPHERE, [1.07, 0.25], [2.48, 1.76], 1.84098076113],
];
/** Lengths above have twelve digits. */
const DIGITS = 1e-10;
/** @typedef {Parameters<import('../../../web/index.js').Surfpath['parametric']>[0]} Definition */
/** @param {number} v @returns {Definition} */
const tube = (v) => ({
  x: '(1 + 0.2sin(2v)*cos(3u))*cos(u)',
  y: '(1 + 0.2sin(2v)*cos(3u))*sin(u)',
  z: 'v',
  u: [0, '2pi'],
  v: [0, v],
});
/** Long ones, whose shortest rough paths are of few nodes for their waves: elements from there came to others, 4e-4 to 2e-3 longer. @type {[Definition, number[], number[], number][]} */
const LONG = [
  [{ x: 'u', y: 'v', z: '0.4sin(2u)*cos(2.5v)', u: [0, 50], v: [-3, 3] }, [3.542, 0.328], [44.647, -0.808], 41.4845849616],
  [tube(25), [1.605, 0.737], [0.647, 18.709], 18.1428754445],
  [tube(50), [5.063, 1.274], [3.239, 16.747], 15.7629659796],
  [tube(100), [2.412, 17.537], [3.491, 40.057], 22.6969016555],
  [
    { x: 'u', y: 'v', z: '0.4sin(2u)*cos(2.5v)', u: [0, 80], v: [-3, 3] },
    [24.87257471308112, -1.5972482557408512],
    [77.84899139776826, 0.49025367479771376],
    53.7555982319,
  ],
];
/** @param {[string, string, string]} centreline @param {number} end @returns {Parameters<import('../../../web/index.js').Surfpath['tube']>[0]} */
const pipe = (centreline, end) => ({ centreline, radius: 0.3, t: [0, end] });
const FOUR_WAVES = pipe(['t', 'sin(1.1t)+0.5*sin(0.53t+1)', 'cos(0.9t)+0.4*sin(1.7t)'], 40);
/** Pipes with bends, past each of which there are two ways. What was pushed aside by waves, which are longer than these are round, came to others, up to 6e-4 longer. @type {[typeof FOUR_WAVES, number[], number[], number][]} */
const PIPES = [
  [FOUR_WAVES, [2.449745, 31.53316], [5.406479, 10.00047], 27.9945724019],
  [FOUR_WAVES, [6.0390492, 8.634072], [2.8521637, 31.141977], 29.1069431374],
  [FOUR_WAVES, [4.97399560288201, 10.676306569948792], [1.7823372478547925, 32.425650395452976], 28.050015344],
  [pipe(['t', '1.5*sin(t)', '0'], 25), [3.799484, 20.42712], [1.523792, 4.948725], 20.1966492566],
  [
    pipe(['t', '1.5*sin(t)', '0.3cos(t/2)'], 50),
    [1.554604183344271, 5.170133197680116],
    [3.327911918992208, 30.644888221286237],
    33.2419994512,
  ],
];
/** What a thousand chords are shorter by. */
const CHORDS = 1e-3;

describe('past bumps', () => {
  /** @type {import('../../../web/index.js').Surfpath} */ let surfpath;
  before(async () => {
    surfpath = await load();
  });
  after(() => surfpath.dispose());

  for (const [z, from, to, length] of KNOWN)
    test(`the shortest path of many on ${z}, from ${from}`, () => {
      const waves = surfpath.graph({ z, x: [-SIDE, SIDE], y: [-SIDE, SIDE] });
      const path = waves.shortestPath(from, to, { points: 999 });
      assert.equal(path.status, 'converged');
      assert.ok(path.length < length * (1 + DIGITS), `${path.length}`);
      assert.ok(waves.geodesics(from, to, { max: 3 })[0].length < length * (1 + DIGITS));
      assert.deepEqual(
        verifyPath(
          { kind: 'parametric', x: 'u', y: 'v', z: z.replaceAll('x', 'u').replaceAll('y', 'v'), u: [-SIDE, SIDE], v: [-SIDE, SIDE] },
          path,
          { from, to, lengthTolerance: CHORDS },
        ),
        [],
      );
      waves.dispose();
    });

  for (const [definition, from, to, length] of [...CLOSED, ...LONG])
    test(`on a closed or long surface, from ${from}`, () => {
      const closed = surfpath.parametric(definition);
      const path = closed.shortestPath(from, to);
      assert.equal(path.status, 'converged');
      assert.ok(path.length < length * (1 + DIGITS), `${path.length}`);
      closed.dispose();
    });

  for (const [definition, from, to, length] of PIPES)
    test(`in a pipe with bends, from ${from}`, () => {
      const bent = surfpath.tube(definition);
      const path = bent.shortestPath(from, to);
      assert.equal(path.status, 'converged');
      assert.ok(path.length < length * (1 + DIGITS), `${path.length}`);
      assert.ok(bent.geodesics(from, to, { max: 3 })[0].length < length * (1 + DIGITS));
      bent.dispose();
    });

  test('of implicit surfaces as of graphs', () => {
    const [z, from, to, length] = KNOWN[0];
    const waves = surfpath.implicit({
      f: `z - ${z}`,
      bounds: [
        [-SIDE, SIDE],
        [-SIDE, SIDE],
        [-0.3, 0.3],
      ],
    });
    const ends = [from, to].map(([x, y]) => [x, y, 0.15 * Math.sin(14 * x) * Math.cos(12 * y)]);
    const path = waves.shortestPath(ends[0], ends[1]);
    assert.equal(path.status, 'converged');
    assert.ok(path.length < length * (1 + DIGITS), `${path.length}`);
    waves.dispose();
  });

  test('none is longer than one that bending it aside at random leads to', () => {
    const waves = surfpath.graph({ z: '0.25*sin(12x + 3y)*cos(9y - 2x)', x: [-SIDE, SIDE], y: [-SIDE, SIDE] });
    const random = createRandom(1);
    const place = () => [random.between(-SIDE, SIDE), random.between(-SIDE, SIDE)];
    for (let i = 0; i < ofAll(4, 12); i++) {
      const path = waves.shortestPath(place(), place());
      assert.ok(path.length < shortestBeside(waves, path, random, 30).length * (1 + DIGITS), `${path.length}`);
    }
    waves.dispose();
  });
});
