// Ways over the net of lines of equal height, on surfaces whose distances are known in closed form.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { load } from '../../web/index.js';
import { LevelNet } from '../../web/search/level-ways.js';
import { makeLevels } from '../../web/search/levels.js';
import { createRandom } from '../helpers/random.js';
import { corrugated, unroll } from '../helpers/unroll.js';
import { ofAll } from '../helpers/sample.js';

const RANGE = { lower: [-1, -1], upper: [1, 1] };

/** @param {(u: number, v: number) => number} height @param {number[][]} ends @param {import('../../web/search/levels.js').Jets} [jets] */
function netOver(height, ends, jets = (places) => new Float64Array(9 * places.length).fill(NaN)) {
  const positions = (/** @type {ArrayLike<number>} */ places) => {
    const points = new Float64Array(1.5 * places.length);
    for (let i = 0; 2 * i < places.length; i++)
      points.set([places[2 * i], places[2 * i + 1], height(places[2 * i], places[2 * i + 1])], 3 * i);
    return points;
  };
  const levels = makeLevels(positions, jets, RANGE, ends);
  assert.ok(levels);
  return new LevelNet(levels);
}

/** @param {Float64Array} way u, v and height of its points */
function lengthOf(way) {
  let length = 0;
  for (let i = 3; i < way.length; i += 3) length += Math.hypot(way[i] - way[i - 3], way[i + 1] - way[i - 2], way[i + 2] - way[i - 1]);
  return length;
}

test('ways over corrugated iron are as long as it is unrolled, to 6 %, and begin and end where they should, seed 3', () => {
  const random = createRandom(3);
  const place = () => [random.between(-1, 1), random.between(-1, 1)];
  const [high, waves] = [4, 9];
  const height = (/** @type {number} */ u) => high * Math.sin(waves * u);
  for (let i = 0; i < ofAll(5, 16); i++) {
    const ends = [place(), place()];
    const [[u, v], [s, t]] = ends;
    const way = netOver(height, ends).find(Infinity);
    assert.ok(way, `${ends.join(' to ')}: no way`);
    assert.deepEqual([...way.slice(0, 3), ...way.slice(-3)], [u, v, height(u), s, t, height(s)]);
    const exact = unroll(corrugated(waves, high * waves), ends);
    assert.ok(Math.abs(lengthOf(way) / exact - 1) < 0.06, `${ends.join(' to ')}: ${lengthOf(way)}, not ${exact}`);
  }
});

test('a way leads over the saddle between two hills, where no line of the grid is; the next one leads elsewhere', () => {
  const saddle = [0.1234, 0.2345];
  const height = (/** @type {number} */ u, /** @type {number} */ v) => 100 * ((u - saddle[0]) ** 2 - (v - saddle[1]) ** 2);
  const ends = [
    [0.1234 - 0.6, 0.2345],
    [0.1234 + 0.6, 0.2345],
  ];
  const net = netOver(height, ends, (places) => {
    const jets = new Float64Array(9 * places.length);
    for (let i = 0; 2 * i < places.length; i++) {
      const [x, y] = [places[2 * i] - saddle[0], places[2 * i + 1] - saddle[1]];
      for (const [k, value] of Object.entries({ 5: 200 * x, 8: -200 * y, 11: 200, 17: -200 })) jets[18 * i + Number(k)] = value;
    }
    return jets;
  });
  const way = net.find(Infinity);
  assert.ok(way);
  const lowest = Math.min(...way.filter((_, i) => i % 3 === 2));
  assert.ok(Math.abs(lowest) < 1e-9, `it leads down to the saddle and no farther: ${lowest}`);
  net.avoid(way, 3);
  const next = net.find(Infinity);
  assert.ok(!next || lengthOf(next) > lengthOf(way));
});

test('crossings are placed so many at a time as a processor has at hand: of 100,000 no more than 2,048', () => {
  /** @type {number[]} */
  const counts = [];
  const positions = (/** @type {ArrayLike<number>} */ places) => {
    counts.push(places.length / 2);
    const points = new Float64Array(1.5 * places.length);
    for (let i = 0; 2 * i < places.length; i++) points.set([places[2 * i], places[2 * i + 1], Math.sin(30 * places[2 * i])], 3 * i);
    return points;
  };
  const jets = (/** @type {ArrayLike<number>} */ places) => new Float64Array(9 * places.length).fill(NaN);
  const net = makeLevels(positions, jets, RANGE, [
    [-0.9, -0.8],
    [0.7, 0.6],
  ]);
  assert.ok(net && net.points.length / 3 - net.corners > 1e5);
  /* All corners, twice, and the middles of cells come before. */
  assert.ok(Math.max(...counts.slice(3)) <= 2048, `${Math.max(...counts.slice(3))}`);
});

test('a steep surface that has no height somewhere has no net, and its paths are found without', async () => {
  const surfpath = await load();
  const surface = surfpath.graph({ z: '30sqrt(1 - x^2 - y^2)*sin(5x)', x: [-1, 1], y: [-1, 1] });
  assert.ok(surface.shortestPath([0.1, 0.1], [0.3, 0.4]).converged);
  surfpath.dispose();
});

test('exchanged ends reverse a path that a net leads to, to the bit', async () => {
  const surfpath = await load();
  const surface = surfpath.graph({ z: '20 + x^2 + y^2 - 10cos(2pi*x) - 10cos(2pi*y)', x: [-5.12, 5.12], y: [-5.12, 5.12] });
  const [there, back] = [surface.shortestPath([0.74, 3.09], [2.78, -2.52]), surface.shortestPath([2.78, -2.52], [0.74, 3.09])];
  const turned = Array.from({ length: back.points.length / 3 }, (_, i) => [...back.points.slice(3 * i, 3 * i + 3)])
    .reverse()
    .flat();
  assert.ok(there.converged && there.length === back.length);
  assert.deepEqual([...there.points], turned);
  surfpath.dispose();
});

test('waves no wider than cells have no net: no way along its lines, which are not theirs, takes the place of a path', async () => {
  const surfpath = await load();
  const surface = surfpath.graph({ z: '0.3sin(30x)*sin(30y)', x: [-4, 4], y: [-4, 4] });
  const path = surface.shortestPath([0.5, 0.3], [2.1, 1.4]);
  assert.ok(path.length < 2.6, `${path.status}, ${path.length}`);
  surfpath.dispose();
});
