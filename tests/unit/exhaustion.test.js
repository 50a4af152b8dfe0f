// Memory that runs out at every place where it can: said so, nothing lost, and the next call gives the bits it always gives. And traps.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { describe, test } from 'node:test';
import { gallery } from '../../web/gallery.js';
import { load } from '../../web/index.js';
import { anything } from '../helpers/refuses.js';
import { limitMemory, loadRefusing, loadWatched } from '../helpers/watched.js';
import { ofAll } from '../helpers/sample.js';

/** @typedef {import('../../web/instance.js').Surfpath} Surfpath */
/** @typedef {import('../../web/index.js').Surface} Surface */

const bytes = readFileSync(new URL('../../dist/surfpath.wasm', import.meta.url));
const { saddle, sphere } = gallery;
const dense = { ...saddle, density: '1+u^2' };
const tube = /** @type {const} */ ({
  kind: 'tube',
  centreline: ['t*cos(a)', 't^2', 't*sin(a)'],
  radius: 0.2,
  t: [0, 1],
  parameters: { a: 0 },
});
const solve = (/** @type {Surface} */ surface, options = {}) => {
  const [from, to] = surface.kind === 'implicit' ? [sphere.from, sphere.to] : [saddle.from, saddle.to];
  return surface.shortestPath(from, to, options);
};

/** What is asked, on a surface made before: what it gives is compared with what it gives when there is memory. @type {Record<string, [any, (surface: Surface, surfpath: Surfpath) => any]>} */
const QUESTIONS = {
  'a surface': [saddle, (_, surfpath) => solve(surfpath.surface(saddle), { start: 'straight' })],
  'a surface with a density': [saddle, (_, surfpath) => solve(surfpath.surface(dense), { start: 'straight' })],
  'a path': [saddle, (surface) => solve(surface)],
  'a straight start': [saddle, (surface) => solve(surface, { start: 'straight', points: 20_000, algorithm: 'polyline', maxIterations: 1 })],
  'a given start': [saddle, (surface) => solve(surface, { start: [...saddle.from, 0.1, 0.2, ...saddle.to] })],
  'an implicit path': [sphere, (surface) => solve(surface)],
  'an implicit path without bounds': [{ ...sphere, bounds: undefined }, (surface) => solve(surface)],
  geodesics: [gallery.parametricTorus, (surface) => surface.geodesics([0, 0], [2, 1])],
  trace: [saddle, (surface) => surface.trace([0, 0], [1, 1], 0.5, { points: 30_000 })],
  evaluate: [saddle, (surface) => surface.evaluate(new Float64Array(60_000))],
  project: [saddle, (surface) => surface.project([0.1, 0.2, 0.3])],
  mesh: [sphere, (surface) => surface.mesh({ resolution: 30 })],
  field: [sphere, (surface) => surface.distanceField(sphere.from, { resolution: 8 })],
  batch: [saddle, (surface) => surface.lengths([...saddle.from, ...saddle.to, 0, 0, 1, 1])],
  set: [
    tube,
    (surface) => {
      surface.set({ a: Math.PI / 2 });
      return surface.evaluate([0, 0.5]);
    },
  ],
};

/** What a question gave: `value`, or nothing where memory was missing and that was said. @param {() => any} ask */
function outcomeOf(ask) {
  try {
    const value = ask();
    const without = [value].flat().filter(({ status }) => status === 'out-of-memory');
    assert.ok(without.every(({ length, points }) => Number.isNaN(length) && points.length === 0));
    return { exhausted: without.length > 0, value };
  } catch (error) {
    assert.ok(error instanceof RangeError, /** @type {any} */ (error).stack);
    assert.match(error.message, /memory/);
    return { exhausted: true, value: undefined };
  }
}

/** Asks in an instance of its own, once without memory from some allocation on, and once with it. */
async function askWithout(
  /** @type {any} */ definition,
  /** @type {(surface: Surface, surfpath: Surfpath) => any} */ ask,
  first = Infinity,
  count = Infinity,
) {
  const { surfpath, held, refuse, allow } = await loadRefusing();
  const surface = surfpath.surface(definition);
  refuse(first, count);
  const without = outcomeOf(() => ask(surface, surfpath));
  const refused = allow();
  const value = ask(surface, surfpath);
  surfpath.dispose();
  return { without, refused, value, left: held() };
}

describe('every allocation refused in turn', () => {
  for (const [name, [definition, ask]] of Object.entries(QUESTIONS))
    test(name, async () => {
      const reference = await askWithout(definition, ask);
      for (const count of [1, Infinity])
        for (let first = 0; ; first++) {
          const { without, refused, value, left } = await askWithout(definition, ask, first, count);
          if (!refused) {
            assert.ok(first > 0 || name === 'project', 'nothing was allocated');
            break;
          }
          // A batch says NaN for what is not there.
          if (!without.exhausted && name !== 'batch') assert.deepEqual(without.value, reference.value, `allocation ${first}`);
          assert.deepEqual(value, reference.value, `after allocation ${first}`);
          assert.deepEqual(left, reference.left, `held after allocation ${first}`);
        }
    });
});

test('a flat body for which there is no room stretched goes without once, not from then on', async () => {
  const flat = { f: 'x^2 + y^2 + 2500z^2 - 1', bounds: anything(Array(3).fill([-1.2, 1.2])) };
  const ask = (/** @type {Surface} */ surface) =>
    surface.shortestPath([0.9, 0.1, 0.0085], [0.9, -0.1, -0.0085], { start: 'straight', tolerance: 0.1 });
  const reference = ask((await load()).implicit(flat));
  assert.ok(reference.converged);
  for (let first = 0; ; first++) {
    const { surfpath, refuse, allow } = await loadRefusing();
    const surface = surfpath.implicit(flat);
    refuse(first, 1);
    const { value } = outcomeOf(() => ask(surface));
    assert.ok(allow(), 'it always finds room');
    if (value?.status !== 'iteration-limit') continue;
    assert.deepEqual(ask(surface), reference);
    break;
  }
});

describe('memory that does not grow', () => {
  test('at every limit: out-of-memory or the same bits', async () => {
    const ask = (/** @type {Surfpath} */ surfpath) => {
      const [one, other] = [surfpath.surface(saddle), surfpath.surface(gallery.torus)];
      return [
        solve(one),
        solve(one, { start: 'straight', points: 5000 }),
        other.shortestPath(gallery.torus.from, gallery.torus.to),
        one.mesh(),
      ];
    };
    const reference = ask(await load());
    let [exhausted, solved] = [0, 0];
    for (let pages = 16; pages < 600 && solved < 3; pages += pages < 64 ? 4 : 32) {
      const surfpath = await load({ wasm: limitMemory(bytes, pages) });
      const without = outcomeOf(() => ask(surfpath));
      if (without.exhausted) exhausted++;
      else {
        solved++;
        assert.deepEqual(without.value, reference, `${pages} pages`);
      }
      const surface = surfpath.surface(gallery.sphere);
      assert.deepEqual(surface.evaluate([0, 0, 1]).length, 4, `${pages} pages`);
      surfpath.dispose();
    }
    assert.ok(exhausted > 0 && solved === 3, `${exhausted} exhausted, ${solved} solved`);
  });
});

describe('a trap', () => {
  test('drops the instance; the next call gives the same bits, on all its surfaces', async () => {
    const { surfpath, solver } = await loadWatched();
    const surfaces = [surfpath.surface(saddle), surfpath.surface(dense), surfpath.surface(sphere), surfpath.surface(tube)];
    const [straight, paths] = [{ start: 'straight' }, surfaces.slice(0, 3).map((surface) => solve(surface))];
    const table = solver.__indirect_function_table;
    for (let i = 1; i < table.length; i++) table.set(i, null);
    assert.throws(() => solve(surfaces[0], straight), WebAssembly.RuntimeError);
    surfaces[3].set({ a: 1 });
    assert.deepEqual(
      surfaces.slice(0, 3).map((surface) => solve(surface)),
      paths,
    );
    for (const surface of surfaces) surface.dispose();
    assert.throws(() => solve(surfaces[0]), /disposed/);
    assert.deepEqual(solve(surfpath.surface(saddle)), paths[0]);
  });

  test('a stack that is full in the caller leaves nothing in disorder', async () => {
    const surfpath = await load();
    const surface = surfpath.surface(saddle);
    const [path, straight] = [solve(surface), solve(surface, { start: 'straight' })];
    let [refused, solved] = [0, 0];
    /** Calls itself until the stack is full, then solves on the way back until that works. @param {number} left @returns {void} */
    const dive = (left) => {
      try {
        dive(left);
      } catch {
        refused++;
        assert.deepEqual(solve(surface, { start: 'straight' }), straight);
        solved++;
      }
    };
    const dives = ofAll(8, 25);
    for (let i = 0; i < dives; i++) dive(i);
    assert.ok(refused > 10 * dives && solved >= dives, `${refused} refused, ${solved} solved`);
    assert.deepEqual(solve(surface), path);
  });
});
