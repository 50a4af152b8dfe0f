// How the page looks: labels that stand apart, a view that follows the surface, colours that are forced, a sheet of paper.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { COARSE, nextFrame, openBrowser, openEntry, openSettled, settled } from '../helpers/page.js';

/** @type {Awaited<ReturnType<typeof openBrowser>>} */ let browser;
/** @type {import('playwright-core').Page} */ let page;
/** @type {string[]} */ let complaints;

before(async () => {
  ({ browser, page, complaints } = await openSettled([], COARSE));
});
after(() => browser?.close());

describe('lengths of all geodesics', () => {
  /** The boxes of what stands over the view, by their words. */
  const boxes = () =>
    page.evaluate(() =>
      [...document.querySelectorAll('.length-label span, .letter-tag, #legend, #scale, #player, .corner')]
        .filter((element) => element.checkVisibility())
        .map((element) => ({ name: element.textContent ?? '', box: element.getBoundingClientRect().toJSON() })),
    );

  for (const [width, height] of [
    [320, 568],
    [390, 844],
    [640, 360],
    [1280, 800],
  ])
    test(`${width} × ${height}: they cover neither each other nor anything else, the shortest is there`, async () => {
      await page.setViewportSize({ width, height });
      await openEntry(page, 'parametricTorus');
      await page.evaluate(() => /** @type {HTMLInputElement} */ (document.querySelector('[name=task][value=all]')).click());
      await settled(page);
      await nextFrame(page);
      const found = await boxes();
      assert.ok(found.some(({ name }) => name.startsWith('8.447')));
      for (const [i, { name, box: a }] of found.entries())
        for (const { name: other, box: b } of found.slice(0, i))
          if (/\d\.\d/.test(name + other))
            assert.ok(a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top, `${name} covers ${other}`);
    });
});

test('the console stayed silent', () => {
  assert.deepEqual(complaints, []);
});
