// How much linear memory the largest questions take: WebAssembly memory never shrinks, so that what a page holds is its largest question's.
import assert from 'node:assert/strict';
import { afterEach, describe, test } from 'node:test';
import { gallery } from '../../web/gallery.js';
import { Heap } from '../../web/runtime/heap.js';
import { loadWatched } from '../helpers/watched.js';

/** @typedef {import('../../web/instance.js').Surfpath} Surfpath */

const MEGABYTE = 2 ** 20;
const POINTS = 5000;
const { saddle, sphere } = gallery;
const density = { parametric: '1+u^2+v^2', implicit: '1+x^2' };

/** Megabytes that an instance has grown to by some work. @param {(surfpath: Surfpath) => void} [work] */
async function memoryAfter(work) {
  const { surfpath, solver } = await loadWatched();
  work?.(surfpath);
  const { byteLength } = solver.memory.buffer;
  surfpath.dispose();
  return byteLength / MEGABYTE;
}

test('an instance begins with at most 2 MB', async () => {
  assert.ok((await memoryAfter()) <= 2);
});

describe(`${POINTS} points take at most 8 MB, without a graph`, () => {
  const shapes = { ...gallery, dense: { ...saddle, density: density.parametric }, denseSphere: { ...sphere, density: density.implicit } };
  for (const algorithm of /** @type {const} */ (['elements', 'polyline', 'paper']))
    test(algorithm, async () => {
      for (const [name, entry] of Object.entries(shapes)) {
        const memory = await memoryAfter((surfpath) => {
          const { points } = surfpath
            .surface(entry)
            .shortestPath(entry.from, entry.to, { start: 'straight', points: POINTS, algorithm, maxIterations: 20 });
          assert.equal(points.length, 3 * (POINTS + 2), name);
        });
        assert.ok(memory <= 8, `${name}: ${memory} MB`);
      }
    });
});

describe('the graph of a global start', () => {
  const { buildGraph } = Heap.prototype;
  afterEach(() => {
    Heap.prototype.buildGraph = buildGraph;
  });

  /* With so many cells a direction, joined as the last graphs are, whatever the surface would take itself. The first path asks for one graph or, of ends that it separates, for two. */
  for (const [kind, resolution, most] of /** @type {const} */ ([
    ['parametric', 128, 16],
    ['implicit', 80, 48],
  ]))
    test(`${kind}: ${resolution} cells a direction take at most ${most} MB`, async () => {
      let built = 0;
      Heap.prototype.buildGraph = function (surface, number, options) {
        built++;
        return buildGraph.call(this, surface, number, { ...options, resolution, level: 2 });
      };
      const entries = Object.entries(gallery).filter(([, entry]) => (entry.kind === 'implicit') === (kind === 'implicit'));
      for (const [name, entry] of entries) {
        const memory = await memoryAfter((surfpath) => {
          assert.ok(surfpath.surface(entry).shortestPath(entry.from, entry.to).converged, name);
        });
        assert.ok(memory <= most, `${name}: ${memory} MB`);
      }
      assert.ok(built >= entries.length);
    });

  test('parametric: of steep land with waves shorter than three cells at most 56 MB, two graphs and the arena in which 16,383 chords are relaxed', async () => {
    const resolutions = new Set();
    Heap.prototype.buildGraph = function (surface, number, options) {
      resolutions.add(options.resolution);
      return buildGraph.call(this, surface, number, options);
    };
    const memory = await memoryAfter((surfpath) => {
      const land = surfpath.graph({ z: 'sin(9x)*cos(8y) + 0.5sin(17x + y)', x: [-4, 4], y: [-4, 4] });
      assert.ok(land.shortestPath([-3, -3], [3, 2], { tolerance: 1e-4 }).length > 7);
    });
    assert.deepEqual([...resolutions].slice(0, 2), [64, 128]);
    assert.ok(memory <= 56, `${memory} MB`);
  });
});
