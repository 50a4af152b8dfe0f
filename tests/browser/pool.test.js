// The pool in headless Chromium, from what was built, under the strict policy of the page's server: the bits of Node.js, aborts, deaths, no complaints.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { gallery } from '../../web/gallery.js';
import { load } from '../../web/index.js';
import { randomPairs } from '../bench/pairs.js';
import { allowance } from '../helpers/allowance.js';
import { openBrowser, openPage } from '../helpers/page.js';
import { createRandom } from '../helpers/random.js';
import { serveSite } from '../helpers/site.js';

const SEED = 12;
const OPTIONS = /** @type {const} */ ({ start: 'straight', tolerance: 1e-6, points: 3 });

/** @type {Awaited<ReturnType<typeof openBrowser>>} */ let browser;
/** @type {Awaited<ReturnType<typeof serveSite>>} */ let site;
/** @type {import('playwright-core').Page} */ let page;
/** @type {string[]} */ let complaints;
/** @type {number[]} */ let pairs;
/** @type {number[]} */ let expected;

before(async () => {
  const surfpath = await load();
  const surface = surfpath.surface(gallery.dini);
  pairs = randomPairs(surface, createRandom(SEED), 300).flat(2);
  expected = Array.from(surface.lengths(pairs, OPTIONS));
  surfpath.dispose();
  browser = await openBrowser();
  site = await serveSite({ plain: '<!doctype html><title>A page that runs nothing of its own</title>' });
  ({ page, complaints } = await openPage(browser.context, `${site.address}/plain`));
});

after(async () => {
  await browser?.close();
  await site?.close();
});

/** Runs in the page: `pool` of two workers, whose constructors leave the workers in `workers`. @param {string} body */
function play(body) {
  const given = JSON.stringify({ dini: gallery.dini, pairs, options: OPTIONS });
  return page.evaluate(`(async () => {
    const { createPool } = await import('/dist/pool.js');
    const { ExpressionError, load } = await import('/dist/index.js');
    const { dini, pairs, options } = ${given};
    const workers = [];
    const Plain = globalThis.Worker;
    globalThis.Worker = class extends Plain {
      constructor(...given) {
        super(...given);
        workers.push(this);
      }
    };
    const pool = createPool({ workers: 2 });
    try {
      ${body}
    } finally {
      globalThis.Worker = Plain;
      await pool.dispose();
    }
  })()`);
}

test(`lengths have the bits of Node.js, and progress is reported, seed ${SEED}`, async () => {
  const { lengths, progress } = /** @type {any} */ (
    await play(`const progress = [];
      const lengths = Array.from(await pool.lengths(dini, pairs, { ...options, onProgress: ({ done }) => progress.push(done) }));
      return { lengths, progress };`)
  );
  assert.deepEqual(lengths, expected);
  assert.equal(progress.at(-1), 300);
  assert.ok(progress.length > 1);
});

test('an aborted call rejects at once, and the pool goes on', async () => {
  const { name, milliseconds, lengths } = /** @type {any} */ (
    await play(`const controller = new AbortController();
      const long = pool.distanceField(dini, [1, 1], { exact: true, signal: controller.signal });
      await new Promise((resolve) => setTimeout(resolve, 300));
      const start = performance.now();
      controller.abort();
      const { name } = await long.catch((error) => error);
      return { name, milliseconds: performance.now() - start, lengths: Array.from(await pool.lengths(dini, pairs, options)) };`)
  );
  assert.equal(name, 'AbortError');
  assert.ok(milliseconds < allowance(50), `${milliseconds} ms`);
  assert.deepEqual(lengths, expected);
});

test('a worker that fails is replaced, and no pair is lost', async () => {
  const { lengths, count } = /** @type {any} */ (
    await play(`const kill = () => workers[0].dispatchEvent(new ErrorEvent('error', { message: 'killed' }));
      const one = createPool({ workers: 1 });
      let killed = false;
      const batch = one.lengths(dini, pairs, { ...options, onProgress() {
        if (!killed) kill();
        killed = true;
      } });
      await batch.finally(() => one.dispose());
      return { lengths: Array.from(await batch), count: workers.length };`)
  );
  assert.deepEqual(lengths, expected);
  assert.equal(count, 2);
});

test('formulas are refused by the class of the default entry', async () => {
  const said = await play(`const error = await pool.lengths({ ...dini, z: 'sin u' }, pairs).catch((error) => error);
    return [error instanceof ExpressionError, error.source, error.index, error.argument];`);
  assert.deepEqual(said, [true, 'sin u', 0, 'z']);
});

test('a script that is missing is named', async () => {
  const said = await play(`const lost = createPool({ worker: '/dist/nowhere.js' });
    const { message } = await lost.lengths(dini, pairs).catch((error) => error);
    await lost.dispose();
    return message;`);
  assert.match(String(said), /no worker can be started: the script .*nowhere\.js cannot be loaded/);
  const others = complaints.filter((text) => !/nowhere|404/.test(text));
  assert.deepEqual(others, []);
});
