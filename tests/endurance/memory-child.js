// One measurement of memory.js, in a process of its own: `node --expose-gc memory-child.js
// OPERATION COUNT`. Prints JSON.
import { gallery } from '../../web/gallery.js';
import { load } from '../../web/index.js';
import { randomPairs } from '../bench/pairs.js';
import { createRandom } from '../helpers/random.js';
import { loadWatched } from '../helpers/watched.js';

const [what, count] = [process.argv[2], Number(process.argv[3])];
const { surfpath, solver } = await loadWatched();
const surfaces = [gallery.saddle, gallery.parametricTorus, gallery.torus].map((entry) => surfpath.surface(entry));
const pairs = surfaces.map((surface) => randomPairs(surface, createRandom(5), 100));

/** What may leave something behind, number i of them. @type {Record<string, (i: number) => unknown>} */
const OPERATIONS = {
  // Every hundredth by the graph search, the others from the straight line.
  solves(i) {
    const [from, to] = pairs[i % 3][i % 100];
    return surfaces[i % 3].shortestPath(
      from,
      to,
      i % 100 === 0 ? {} : { start: 'straight', algorithm: i % 10 ? 'polyline' : 'elements', points: 16 },
    );
  },
  // Every tenth with a graph.
  surfaces(i) {
    const entry = i % 2 ? gallery.saddle : gallery.sphere;
    const surface = surfpath.surface(entry);
    const path = surface.shortestPath(entry.from, entry.to, i % 10 ? { start: 'straight' } : {});
    surface.dispose();
    return path;
  },
  async instances(i) {
    const instance = await load();
    instance.surface(gallery.saddle).evaluate([0, 0]);
    if (i % 2) instance.dispose();
  },
};

/** Garbage is collected every so many operations: only a full collection lets compiled modules go, which would pile up meanwhile. @type {Record<string, number>} */
const PAUSE = { solves: 1000, surfaces: 100, instances: 100 };

/** @param {number} first @param {number} last */
async function run(first, last) {
  for (let i = first; i < last; i++) {
    const done = OPERATIONS[what](i);
    if (what === 'instances') await done;
    if (i % PAUSE[what] === 0) await settle();
  }
}

/** Lets finalizers run and collects garbage. */
async function settle() {
  await new Promise((resolve) => setTimeout(resolve, 5));
  globalThis.gc?.();
}

/** The least of several looks: the process shrinks a while after its garbage is gone. */
async function look() {
  let [rss, live] = [Infinity, Infinity];
  for (let i = 0; i < 8; i++) {
    await settle();
    const usage = process.memoryUsage();
    rss = Math.min(rss, usage.rss);
    live = Math.min(live, usage.heapUsed);
  }
  return { rss, live, bytes: solver.memory.buffer.byteLength };
}

const warm = Math.max(300, Math.ceil(count / 5));
await run(0, warm);
const before = await look();
const start = performance.now();
await run(warm, warm + count);
const seconds = (performance.now() - start) / 1000;
const after = await look();
const more = (/** @type {'rss' | 'live'} */ kind) => (after[kind] - before[kind]) / 2 ** 20;
console.log(JSON.stringify({ pages: (after.bytes - before.bytes) / 65536, megabytes: more('rss'), live: more('live'), seconds }));
