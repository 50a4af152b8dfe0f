// Nothing leaks, instances share nothing, and what was disposed of stays so.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';
import { gallery } from '../../web/gallery.js';
import { ExpressionError, load } from '../../web/index.js';
import { randomPairs } from '../bench/pairs.js';
import { STRAIGHT } from '../helpers/options.js';
import { createRandom } from '../helpers/random.js';
import { ofAll } from '../helpers/sample.js';
import { footprint, loadWatched } from '../helpers/watched.js';
import { measureGrowth } from '../endurance/memory.js';

/** @typedef {import('../../web/instance.js').Surfpath} Surfpath */

const SEED = 424242;
const SOLVES = 100_000;
const GLOBAL_SOLVES = ofAll(500, 1500);
const SURFACES = ofAll(1000, 3000);

/** Two footprints are the same, but for a few blocks that differ in how free memory is cut up. @param {ReturnType<typeof footprint>} after @param {ReturnType<typeof footprint>} before */
function assertSame(after, before) {
  assert.deepEqual({ ...after, blocks: 0 }, { ...before, blocks: 0 });
  assert.ok(Math.abs(after.blocks - before.blocks) <= 4, `${before.blocks} blocks were free, ${after.blocks} are`);
}

/** Random pairs, over and over. @param {import('../../web/surface.js').Surface} surface @param {number} solves @param {number} points */
function solveMany(surface, solves, points) {
  const pairs = randomPairs(surface, createRandom(SEED), 500);
  let length = 0;
  for (let i = 0; i < solves; i++)
    length += surface.shortestPath(pairs[i % 500][0], pairs[i % 500][1], { ...STRAIGHT, points }).length || 0;
  return length;
}

/** Runs the garbage collector. */
const collect = () => {
  setFlagsFromString('--expose-gc');
  runInNewContext('gc')();
};

/** What is left after some work in a new instance. @param {(surfpath: Surfpath) => void} work */
async function footprintAfter(work) {
  const { surfpath, solver } = await loadWatched();
  work(surfpath);
  return footprint(solver);
}

describe('memory', () => {
  test(`${SOLVES} solves leave it as it was, seed ${SEED}`, async () => {
    const work = (/** @type {number} */ solves) => (/** @type {Surfpath} */ surfpath) => {
      for (const entry of [gallery.saddle, gallery.parametricTorus, gallery.torus, gallery.threeTori])
        assert.ok(solveMany(surfpath.surface(entry), solves, 16) > 0);
    };
    assertSame(await footprintAfter(work(SOLVES / 4)), await footprintAfter(work(500)));
  });

  test(`${GLOBAL_SOLVES} solves with the default options too, once the graphs are built, seed ${SEED}`, async () => {
    const work = (/** @type {number} */ solves) => (/** @type {Surfpath} */ surfpath) => {
      for (const entry of [gallery.saddle, gallery.parametricTorus, gallery.torus]) {
        const surface = surfpath.surface(entry);
        const [first, ...pairs] = randomPairs(surface, createRandom(SEED), 500);
        for (const [from, to] of [first, ...pairs.slice(0, solves - 1)])
          assert.ok(surface.shortestPath(from, to, { points: 16 }).length > 0);
      }
    };
    assertSame(await footprintAfter(work(Math.floor(GLOBAL_SOLVES / 3))), await footprintAfter(work(20)));
  });

  test(`${SURFACES} surfaces made and disposed of leave it as it was, and their table slots are used again`, async () => {
    const work = (/** @type {number} */ count) => (/** @type {Surfpath} */ surfpath) => {
      for (let i = 0; i < count; i++) {
        const surface = surfpath.surface(i % 2 ? gallery.saddle : gallery.sphere);
        surface.evaluate(i % 2 ? [0, 0] : [0, 0, 1]);
        surface.dispose();
      }
    };
    assertSame(await footprintAfter(work(SURFACES)), await footprintAfter(work(2)));
  });

  test('surfaces that are refused leave it as it was', async () => {
    const work = (/** @type {number} */ count) => (/** @type {Surfpath} */ surfpath) => {
      surfpath.surface(gallery.saddle).dispose();
      for (let i = 0; i < count; i++) {
        assert.throws(() => surfpath.surface({ ...gallery.saddle, z: 'u+' }), ExpressionError);
        assert.throws(() => surfpath.surface({ ...gallery.saddle, u: [1, 0] }), /range/);
        assert.throws(() => surfpath.surface({ ...gallery.sphere, parameters: { r: Number.NaN } }), /finite/);
      }
    };
    assertSame(await footprintAfter(work(1000)), await footprintAfter(work(0)));
  });

  test('a tube that takes another frame, or finds none, leaves it as it was', async () => {
    const centreline = /** @type {[string, string, string]} */ (['t*cos(a)', 'b*t^2', 't*sin(a)']);
    const work = (/** @type {number} */ count) => (/** @type {Surfpath} */ surfpath) => {
      const tube = surfpath.tube({ centreline, radius: 0.2, t: [0, 1], parameters: { a: 0, b: 0 } });
      for (let i = 0; i < count; i++) {
        tube.set({ a: i % 2 === 0 ? Math.PI / 2 : 0 });
        assert.throws(() => tube.set({ b: Number.MAX_VALUE }), /centreline stands still/);
        assert.throws(() => surfpath.tube({ centreline: [1, 2, 3], radius: 1, t: [0, 1] }), /centreline stands still/);
      }
    };
    assertSame(await footprintAfter(work(ofAll(150, 500))), await footprintAfter(work(2)));
  });

  // How large the process stays is for `make endurance`: over so few operations the engine's own growth is more than what could be lost.
  test('no page of memory more in a process of its own: solves, surfaces, instances', async () => {
    for (const [what, count] of /** @type {const} */ ([
      ['solves', ofAll(3_000, 10_000)],
      ['surfaces', ofAll(100, 300)],
      ['instances', ofAll(30, 100)],
    ]))
      assert.equal((await measureGrowth(what, count)).pages, 0, what);
  });

  test('a surface that was disposed of is garbage', async () => {
    const { surfpath } = await loadWatched();
    const make = () => {
      const surface = surfpath.surface(gallery.saddle);
      surface.dispose();
      return new WeakRef(surface);
    };
    const gone = make();
    // An engine that compiles beside may hold what it saw for a while: a leak is what never goes.
    for (let turn = 0; turn < 200 && gone.deref() !== undefined; turn++) {
      await new Promise((resolve) => setTimeout(resolve, turn));
      collect();
    }
    assert.equal(gone.deref(), undefined, 'something still holds it');
    assert.ok(surfpath.surface(gallery.saddle).evaluate([0, 0]).length === 6);
  });

  test('a path is a copy: later solves do not change it', async () => {
    const { surfpath } = await loadWatched();
    const surface = surfpath.surface(gallery.saddle);
    const solve = (/** @type {import('../../web/path.js').PathOptions} */ options) =>
      surface.shortestPath([-0.9, 0.1], [0.5, 0.9], { ...options, record: true });
    const paths = [STRAIGHT, {}].map(solve);
    const kept = structuredClone(paths);
    solveMany(surface, 10, 300);
    surface.dispose();
    assert.deepEqual(paths, kept);
  });
});

describe('instances', () => {
  test('50 work independently, with the same bits', async () => {
    const instances = await Promise.all(Array.from({ length: 50 }, () => load()));
    const surfaces = instances.map((surfpath) => surfpath.surface(gallery.parametricTorus));
    surfaces.forEach((surface, i) => {
      if (i % 2) surface.set({ R: 5 });
    });
    instances[0].dispose();
    const paths = surfaces.slice(1).map((surface) => surface.shortestPath([0.5, 0.6], [2.6, 1.2], STRAIGHT));
    for (const [i, path] of paths.entries()) assert.deepEqual(path, paths[i % 2], `instance ${i + 1}`);
    assert.ok(paths[0].length > paths[1].length);
  });

  test('what was disposed of throws, in words; disposing twice does not', async () => {
    const surfpath = await load();
    const [surface, other] = [surfpath.surface(gallery.saddle), surfpath.surface(gallery.sphere)];
    surface.dispose();
    surface.dispose();
    /** @type {(() => void)[]} */
    const uses = [
      () => surface.shortestPath([0, 0], [1, 1]),
      () => surface.evaluate([0, 0]),
      () => surface.project([0, 0, 0]),
      () => surface.mesh(),
      () => surface.set({}),
    ];
    for (const use of uses) assert.throws(use, /disposed/);
    assert.ok(other.shortestPath([1, 0, 0], [0, 1, 0]).converged);
    surfpath.dispose();
    surfpath.dispose();
    assert.throws(() => other.shortestPath([1, 0, 0], [0, 1, 0]), /disposed/);
    assert.throws(() => surfpath.surface(gallery.saddle), /disposed/);
  });
});
