// 200 changes of the surface leave as much on the graphics card and in the page as one did.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { openBrowser, openEntry, openPage, settled } from '../helpers/page.js';

/** @type {Awaited<ReturnType<typeof openBrowser>>} */ let browser;
/** @type {import('playwright-core').Page} */ let page;

before(async () => {
  browser = await openBrowser(['--js-flags=--expose-gc']);
  ({ page } = await openPage(browser.context, browser.address));
  await settled(page);
});
after(() => browser?.close());

/** Changes a parameter and waits for surface and path. @param {number} value */
async function set(value) {
  await page.fill('#value-a', String(value));
  await page.waitForTimeout(30);
}

/** What is held when nothing moves. */
async function measure() {
  await page.waitForTimeout(400);
  await settled(page);
  await page.waitForTimeout(200);
  return page.evaluate(() => {
    const { gc, surfpathView, performance } = /** @type {any} */ (window);
    gc();
    return { card: surfpathView.memory, elements: document.querySelectorAll('*').length, heap: performance.memory.usedJSHeapSize };
  });
}

test('200 changes of a parameter, and 40 of the surface', { timeout: 200_000 }, async () => {
  await openEntry(page, 'parametricTorus');
  for (let i = 0; i < 20; i++) await set(1 + 0.01 * i);
  await openEntry(page, 'sphere');
  await openEntry(page, 'parametricTorus');
  const first = await measure();
  for (let i = 0; i < 200; i++) await set(1 + 0.004 * (i % 100));
  for (let i = 0; i < 20; i++) for (const name of ['sphere', 'parametricTorus']) await openEntry(page, name);
  const last = await measure();
  assert.deepEqual(last.card, first.card);
  assert.equal(last.elements, first.elements);
  // One mesh of the sphere is 5 MB: forty of them kept would show.
  assert.ok(last.heap < first.heap + 20e6, `${first.heap} bytes have become ${last.heap}`);
});
