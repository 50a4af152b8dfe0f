// 200 changes of the surface leave as much on the graphics card and in the page as one did.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { openBrowser, openEntry, openPage, settled } from '../helpers/page.js';

/** @type {Awaited<ReturnType<typeof openBrowser>>} */ let browser;
/** @type {import('playwright-core').Page} */ let page;

before(async () => {
  // A small window: most of the time goes into drawing without a graphics card.
  browser = await openBrowser(['--js-flags=--expose-gc'], { viewport: { width: 1000, height: 420 } });
  ({ page } = await openPage(browser.context, browser.address));
  await settled(page);
});
after(() => browser?.close());

/** Changes a parameter and waits for surface and path. @param {number} value */
async function set(value) {
  await page.fill('#value-a', String(value));
  await page.waitForTimeout(30);
}

/** What is held when nothing moves; without the scale of colours, which is filled when it is first needed. */
async function measure() {
  await page.waitForTimeout(400);
  await settled(page);
  await page.waitForTimeout(200);
  return page.evaluate(() => {
    const { gc, surfpathView, performance } = /** @type {any} */ (window);
    gc();
    return {
      card: { ...surfpathView.memory, programs: surfpathView.memory.programs.length },
      elements: document.querySelectorAll('*:not(#scale *)').length,
      heap: performance.memory.usedJSHeapSize,
    };
  });
}

const SURFACES = ['sphere', 'globe', 'hindered', 'vase'];

test('200 changes: 160 of a parameter, 40 of the surface', { timeout: 400_000 }, async () => {
  for (const name of [...SURFACES, 'parametricTorus']) await openEntry(page, name);
  for (let i = 0; i < 10; i++) await set(1 + 0.01 * i);
  const first = await measure();
  for (let i = 0; i < 40; i++) await openEntry(page, SURFACES[i % SURFACES.length]);
  await openEntry(page, 'parametricTorus');
  for (let i = 0; i < 160; i++) await set(1 + 0.005 * (i % 80));
  await set(1.09);
  const last = await measure();
  assert.deepEqual(last.card, first.card);
  assert.equal(last.elements, first.elements);
  // A mesh is 1 MB at least: forty of them kept would show.
  assert.ok(last.heap < first.heap + 20e6, `${first.heap} bytes have become ${last.heap}`);
});
