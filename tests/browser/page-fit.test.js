// The page fits every size and every reader: no sideways scroll, nothing that axe-core finds, no long pause, a first path within a second, few bytes.
import assert from 'node:assert/strict';
import { mkdir, readdir, readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { after, before, describe, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { COARSE, followLink, nextFrame, openBrowser, openEntry, openPage, openSettled, openSketch, settled } from '../helpers/page.js';

const SCREENSHOTS = fileURLToPath(new URL('../../build/screenshots/', import.meta.url));
const SITE = fileURLToPath(new URL('../../build/site/', import.meta.url));
const AXE = createRequire(import.meta.url).resolve('axe-core/axe.min.js');
const SIZES = /** @type {const} */ ([
  [1440, 900],
  [820, 1180],
  [390, 844],
  [844, 390],
]);
const THEMES = /** @type {const} */ (['light', 'dark']);

/** @type {Awaited<ReturnType<typeof openBrowser>>} */ let browser;
/** @type {import('playwright-core').Page} */ let page;
/** @type {string[]} */ let complaints;

before(async () => {
  await mkdir(SCREENSHOTS, { recursive: true });
  ({ browser, page, complaints } = await openSettled([], COARSE));
});
after(() => browser?.close());

/** What axe-core finds. @param {import('playwright-core').Page} page */
async function violations(page) {
  await page.evaluate(await readFile(AXE, 'utf8'));
  return page.evaluate(async () => {
    const { violations: found } = await /** @type {any} */ (window).axe.run(document, { resultTypes: ['violations'] });
    return found.map(
      (/** @type {any} */ { id, nodes }) => `${id}: ${nodes.map((/** @type {any} */ node) => node.target.join(' ')).join(', ')}`,
    );
  });
}

describe('sizes and themes', () => {
  for (const [width, height] of SIZES)
    for (const colorScheme of THEMES.slice(0, width === 1440 || process.env.EVERY_RELEASE ? undefined : 1))
      test(`${width} × ${height}, ${colorScheme}`, async () => {
        await page.setViewportSize({ width, height });
        await page.emulateMedia({ colorScheme });
        await openEntry(page, 'parametricTorus');
        await nextFrame(page);
        const sizes = await page.evaluate(() => ({
          content: document.documentElement.scrollWidth,
          window: innerWidth,
          canvas: /** @type {HTMLCanvasElement} */ (document.getElementById('canvas')).width,
          shown: devicePixelRatio * (document.getElementById('canvas')?.clientWidth ?? 0),
          low: document.documentElement.scrollHeight,
        }));
        assert.ok(sizes.content <= sizes.window, 'the page scrolls sideways');
        assert.ok(sizes.low <= height, 'the page scrolls');
        assert.equal(sizes.canvas, Math.floor(sizes.shown));
        await page.screenshot({ path: `${SCREENSHOTS}page-${width}x${height}-${colorScheme}.png` });
        // Structure is that of the size, colours are those of the theme: every one of both is looked at once.
        if (colorScheme === 'light' || width === 1440) assert.deepEqual(await violations(page), []);
      });

  test('on a screen with finer pixels the view is drawn with these', async () => {
    const session = await browser.context.newCDPSession(page);
    const ratios = [];
    const resize = (/** @type {string} */ width) => page.$eval('#view', (view, size) => Object.assign(view.style, { width: size }), width);
    await resize('400px');
    for (const deviceScaleFactor of [2, 1]) {
      // Chromium tells of no other pixels where the window, too, stays the same.
      const width = 848 - 4 * deviceScaleFactor;
      await session.send('Emulation.setDeviceMetricsOverride', { width, height: 390, deviceScaleFactor, mobile: false });
      await nextFrame(page);
      ratios.push(await page.$eval('#canvas', (canvas) => /** @type {HTMLCanvasElement} */ (canvas).width / canvas.clientWidth));
    }
    await resize('');
    await session.detach();
    assert.deepEqual(ratios, [2, 1]);
  });

  test('on a phone every card is behind a tab, and none scrolls sideways', async () => {
    await page.setViewportSize({ width: 390, height: 844 });
    for (const name of ['path', 'plane', 'plots', 'share', 'surface']) {
      await page.click(`#tabs [data-tab=${name}]`);
      assert.ok(await page.locator(`.panel [data-in=${name}]`).last().isVisible(), name);
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), name);
      const panel = await page.evaluate(() => {
        const { scrollWidth = 0, clientWidth = 0 } = document.getElementById('panel') ?? {};
        return scrollWidth - clientWidth;
      });
      assert.ok(panel <= 0, `${name} scrolls sideways by ${panel}`);
    }
  });

  test('on a narrow phone all digits of coordinates are seen', async () => {
    const cut = [];
    for (const [width, height] of [
      [390, 844],
      [320, 568],
    ]) {
      await page.setViewportSize({ width, height });
      await openSketch(page, {
        entry: 'genus2',
        ends: [
          [-0.123456789, -1.01234567, 0.5],
          [1.23456789, 0.3, 0.1],
        ],
        via: [[0.123456789, 0.9, -0.3]],
      });
      await page.click('#tabs [data-tab=path]');
      await nextFrame(page);
      cut.push(
        ...(await page.$$eval('#ends input', (inputs) =>
          inputs.filter((input) => input.scrollWidth > input.clientWidth).map((input) => /** @type {HTMLInputElement} */ (input).value),
        )),
      );
    }
    assert.deepEqual(cut, []);
  });

  test('at 400 % it is one column, which scrolls down alone: nothing is cut off or covered', async () => {
    await page.setViewportSize({ width: 320, height: 256 });
    await openEntry(page, 'parametricTorus');
    for (const name of ['surface', 'path', 'plane', 'plots', 'share']) {
      await page.click(`#tabs [data-tab=${name}]`);
      await nextFrame(page);
      const boxes = await page.$$eval(`#view, #result, #tabs, .panel [data-in=${name}]`, (all) =>
        all.map((one) => {
          const { left, right, top, bottom } = one.getBoundingClientRect();
          return { left, right, top, bottom, cut: one.scrollWidth - one.clientWidth };
        }),
      );
      for (const [i, { left, right, top, cut }] of boxes.entries()) {
        assert.ok(left >= 0 && right <= 320 && cut <= 0, `${name}: ${left} … ${right}, ${cut} cut off`);
        assert.ok(i === 0 || top >= boxes[i - 1].bottom, `${name}: ${i} begins at ${top}`);
      }
      assert.ok(boxes[0].bottom <= 0.8 * 256, 'room beside the view for the wheel and the finger that scroll');
      const { content, scrolled } = await page.evaluate((bottom) => {
        scrollTo(0, bottom);
        const end = [...document.querySelectorAll('.panel .card')].filter((card) => card.checkVisibility()).at(-1);
        return { content: document.documentElement.scrollWidth, scrolled: end?.getBoundingClientRect().bottom ?? Infinity };
      }, 1e5);
      assert.ok(content <= 320 && scrolled <= 256, `${name}: ${content}, ${scrolled}`);
      await page.evaluate(() => scrollTo(0, 0));
    }
    const wheel = async (/** @type {number} */ by) => {
      const from = await page.evaluate(() => scrollY);
      await page.mouse.wheel(0, by);
      await page.waitForTimeout(300);
      return (await page.evaluate(() => scrollY)) - from;
    };
    await page.mouse.move(40, 70);
    assert.equal(await wheel(60), 60, 'on its way past the view the wheel scrolls the page');
    await page.mouse.click(40, 40);
    assert.equal(await wheel(-60), 0, 'pressed, the view takes it');
    await page.evaluate(() => scrollTo(0, 0));
    await page.click('#tabs [data-tab=plane]');
    assert.ok(await page.$eval('#plane svg', (plane) => plane.clientHeight > 120), 'the plane is large enough to be seen');
    await page.setViewportSize({ width: 360, height: 225 });
    const player = await page.locator('#player').boundingBox();
    assert.ok(player && player.width < 60, 'what plays the steps is in its corner, not over the path');
    await page.click('#tabs [data-tab=surface]');
    await page.setViewportSize({ width: 1440, height: 900 });
  });

  test('on a tablet the panel opens beside the view, and Escape closes it', async () => {
    await page.setViewportSize({ width: 820, height: 1180 });
    assert.equal(await page.isVisible('#panel'), false);
    await page.click('#toggle-panel');
    await page.waitForTimeout(300);
    assert.equal(await page.isVisible('#colour'), true);
    const [view, panel] = await Promise.all(['#view', '#panel'].map((id) => page.locator(id).boundingBox()));
    assert.ok(view && panel && view.x + view.width <= panel.x, 'nothing of the view is covered');
    await page.screenshot({ path: `${SCREENSHOTS}page-820x1180-panel.png` });
    assert.deepEqual(await violations(page), []);
    await page.keyboard.press('Escape');
    await page.waitForTimeout(300);
    assert.equal(await page.isVisible('#panel'), false);
    assert.equal(await page.evaluate(() => document.activeElement?.id), 'toggle-panel');
    await page.setViewportSize({ width: 1440, height: 900 });
  });

  /** In how many rows elements stand. @param {string} selector */
  const rowsOf = (selector) => page.$$eval(selector, (all) => new Set(all.map((one) => one.getBoundingClientRect().top)).size);

  test('on a narrow phone the legend is two lines', async () => {
    await page.setViewportSize({ width: 360, height: 640 });
    await openEntry(page, 'parametricTorus');
    assert.equal(await rowsOf('#legend li'), 2);
  });

  test('a phone on its side has the whole legend, and the kinds of surfaces in two rows', async () => {
    await page.setViewportSize({ width: 844, height: 390 });
    await openEntry(page, 'parametricTorus');
    assert.equal(await rowsOf('#kinds label'), 2);
    const cut = await page.$$eval('#kinds span', (all) => all.filter((one) => one.scrollWidth > one.clientWidth).length);
    assert.equal(cut, 0);
    assert.deepEqual(await page.$$eval('#legend li', (all) => all.filter((one) => one.checkVisibility()).map((one) => one.textContent)), [
      'Shortest path',
      'Straight start',
      'Hidden part',
      'Drag A and B',
    ]);
    const [player, button] = await Promise.all(['#player', '#play'].map((id) => page.locator(id).boundingBox()));
    assert.deepEqual(player, button, 'in its corner the player is its button');
    await page.setViewportSize({ width: 1440, height: 900 });
  });

  test('on a phone what is wrong with a formula is seen while it is written', async () => {
    await page.setViewportSize({ width: 390, height: 844 });
    for (const [name, formula, problem] of [
      ['own-graph', 'foo(x)', '#problem-z'],
      ['own-graph', '1e30*x', '#formula-problem'],
    ]) {
      await openEntry(page, name);
      await page.fill('#field-z', formula);
      await page.waitForSelector(`${problem}:not([hidden])`);
      await nextFrame(page);
      const box = await page.locator(problem).boundingBox();
      assert.ok(box && box.y + box.height < 845, `${formula}: down to ${(box?.y ?? 0) + (box?.height ?? 0)}`);
    }
    await page.setViewportSize({ width: 1440, height: 900 });
  });

  test('on a phone with large type no word of the status is cut off', async () => {
    const session = await browser.context.newCDPSession(page);
    await page.setViewportSize({ width: 390, height: 844 });
    await session.send('Page.setFontSizes', { fontSizes: { standard: 24 } });
    await openEntry(page, 'parametricTorus');
    const [inner, outer] = await Promise.all(['#advice', '#result'].map((id) => page.locator(id).boundingBox()));
    assert.ok(inner && outer && inner.x + inner.width <= 390 && inner.y + inner.height <= outer.y + outer.height);
    const cut = await page.$eval('.status', ({ scrollWidth, clientWidth }) => scrollWidth - clientWidth);
    assert.ok(cut <= 0, `${cut} pixels`);
    await session.send('Page.setFontSizes', { fontSizes: { standard: 16 } });
    await page.setViewportSize({ width: 1440, height: 900 });
  });

  const height = () => page.evaluate(() => document.getElementById('view')?.clientHeight);

  test('words of any length leave the view as large as it is', async () => {
    await openEntry(page, 'parametricTorus');
    const before = await height();
    await page.fill('#field-z', 'a*sine(v)');
    await page.waitForSelector('#problem-z:not([hidden])');
    assert.equal(await height(), before);
    await page.fill('#field-z', 'a*sin(v)');
    await page.check('[name=task][value=trace]');
    await page.waitForTimeout(300);
    await settled(page);
    assert.equal(await height(), before);
  });

  test('long formulas of the gallery are broken into lines, none is cut off', async () => {
    const lengths = new Set();
    for (const name of ['banchoffChmutov', 'metamorphosis', 'printed47', 'threeTori', 'genus2']) {
      /* They are there before what is computed of them, but for the mesh. */
      const before = await page.textContent('#typeset');
      await followLink(page, { entry: name });
      await page.waitForFunction((text) => document.getElementById('typeset')?.textContent !== text, before, { polling: 100 });
      for (const width of [1440, 1000]) {
        await page.setViewportSize({ width, height: 800 });
        await nextFrame(page);
        const cut = await page.$eval('#typeset', ({ scrollWidth, clientWidth }) => scrollWidth - clientWidth);
        assert.ok(cut <= 0, `${name}, ${width}: ${cut} pixels`);
      }
      lengths.add(await page.$eval('#typeset', ({ textContent }) => textContent?.length));
    }
    assert.equal(lengths.size, 5, 'each was seen');
    await settled(page);
    await page.setViewportSize({ width: 1440, height: 900 });
  });

  test('so do figures', async () => {
    await openEntry(page, 'parametricTorus');
    for (const width of [1240, 1000, 940]) {
      await page.setViewportSize({ width, height: 700 });
      const heights = new Set();
      for (const time of ['2 ms', '0.067 ms', '12345 ms']) {
        await page.$eval('#time', (figure, text) => figure.replaceChildren(text), time);
        heights.add(await height());
      }
      assert.equal(heights.size, 1, `${width}: ${[...heights]}`);
    }
    await page.setViewportSize({ width: 1440, height: 900 });
  });

  test('a figure that has no room is left out whole, the words beside it are two lines', async () => {
    const tiny = { z: '1e-5*sin(x*1e5)*cos(y*1e5)', 'x-from': '-3e-5', 'x-to': '3e-5', 'y-from': '-3e-5', 'y-to': '3e-5' };
    /** Of each figure, the share that is seen. */
    const seen = () =>
      page.evaluate(() => {
        const frame = /** @type {Element} */ (document.querySelector('.figures')).getBoundingClientRect();
        return [...document.querySelectorAll('.figures div')].map((figure) => {
          const { left, right, top, width } = figure.getBoundingClientRect();
          return top >= frame.bottom || width === 0 ? 0 : (Math.min(right, frame.right) - Math.max(left, frame.left)) / width;
        });
      });
    for (const [width, height, entry, least] of /** @type {const} */ ([
      [1440, 900, 'parametricTorus', 3],
      [1280, 800, 'own-graph', 1],
      [390, 844, 'parametricTorus', 1],
      [360, 640, 'parametricTorus', 0],
    ])) {
      await page.setViewportSize({ width, height });
      await openSketch(
        page,
        entry === 'own-graph'
          ? {
              entry,
              texts: tiny,
              ends: [
                [-2e-5, -1e-5],
                [2e-5, 1e-5],
              ],
            }
          : { entry },
      );
      const shares = await seen();
      assert.ok(
        shares.every((share) => share < 0.01 || share > 0.99),
        `${width}: ${shares}`,
      );
      assert.ok(shares.filter((share) => share > 0.99).length >= least, `${width}: ${shares}`);
      const lines = await page.$eval(
        '.status',
        (words) => words.getBoundingClientRect().height / parseFloat(getComputedStyle(words).lineHeight),
      );
      assert.ok(lines < 2.5, `${width}: ${lines} lines`);
    }
    await page.setViewportSize({ width: 1440, height: 900 });
  });
});

test('the gallery opens with a picture of each surface, and is accessible', async () => {
  await page.click('#open-gallery');
  const pictures = page.locator('#gallery img');
  await pictures.last().scrollIntoViewIfNeeded();
  await page.waitForFunction(() =>
    [...document.querySelectorAll('#gallery img')].every((image) => /** @type {HTMLImageElement} */ (image).naturalWidth === 320),
  );
  assert.ok((await pictures.count()) >= 24);
  await page.screenshot({ path: `${SCREENSHOTS}gallery.png` });
  assert.deepEqual(await violations(page), []);
  await page.click('[data-entry=vase]');
  await settled(page);
  assert.equal(await page.textContent('#entry-title'), 'Vase');
});

test('all that is loaded is 353.2 KB gzipped at most', async () => {
  let sum = 0;
  for (const name of await readdir(SITE)) {
    if (!/\.(?:js|css|html|wasm|svg)$/.test(name) || name.startsWith('gltf')) continue;
    sum += gzipSync(await readFile(SITE + name), { level: 9 }).length;
  }
  sum += (await readFile(`${SITE}thumbnails/poster.webp`)).length;
  assert.ok(sum <= 353.2 * 1024, `${sum} bytes`);
});

test('nothing but the page itself is asked for, and no picture of the gallery before it opens', async () => {
  await page.goto('about:blank');
  /** @type {string[]} */
  const asked = [];
  page.on('request', (request) => asked.push(request.url()));
  await page.goto(browser.address);
  await settled(page);
  assert.ok(asked.every((url) => url.startsWith(browser.address)));
  assert.deepEqual(
    asked.filter((url) => url.endsWith('.webp') && !url.endsWith('poster.webp')),
    [],
  );
});

test('the console stayed silent', () => {
  assert.deepEqual(complaints, []);
});

test('what a finger touches is at least 44 pixels high', async () => {
  const phone = await openBrowser([], { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  try {
    const opened = await openPage(phone.context, phone.address);
    await settled(opened.page);
    for (const name of ['surface', 'path', 'plane', 'plots', 'share']) {
      await opened.page.tap(`#tabs [data-tab=${name}]`);
      const small = await opened.page.evaluate(() =>
        [...document.querySelectorAll('button, select, summary, textarea, input:not([type=radio]), .choice label, .surfpath-handle')]
          .filter((element) => element.checkVisibility())
          .map((element) => [element.id || element.textContent?.trim(), element.getBoundingClientRect().height])
          // What is placed by a transform has parts of a pixel.
          .filter(([, height]) => Number(height) < 43.99),
      );
      assert.deepEqual(small, [], name);
    }
    assert.deepEqual(opened.complaints, []);
  } finally {
    await phone.close();
  }
});
