// The demo page in headless Chromium: every surface of the gallery is drawn and solved, mistakes are shown where they are, nothing is said on the console.
import assert from 'node:assert/strict';
import { mkdir } from 'node:fs/promises';
import { after, before, describe, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { KINDS } from '../../demo/kinds.js';
import { describeStatus } from '../../demo/words.js';
import { gallery } from '../../web/gallery.js';
import { STATUS } from '../../web/path.js';
import { measurePicture, nextFrame, openBrowser, openPage } from '../helpers/page.js';

const SCREENSHOTS = fileURLToPath(new URL('../../build/screenshots/', import.meta.url));

/** @type {Awaited<ReturnType<typeof openBrowser>>} */ let browser;
/** @type {import('playwright-core').Page} */ let page;
/** @type {string[]} */ let complaints;

const text = async (/** @type {string} */ selector) => (await page.textContent(selector)) ?? '';
const status = () => page.getAttribute('#status', 'data-status');
const solved = () => page.waitForFunction(() => document.getElementById('status')?.dataset.status, null, { timeout: 20000 });

/** The middle of the view, without legend and player. */
async function pictureOfView() {
  await nextFrame(page);
  const box = await page.locator('#canvas').boundingBox();
  assert.ok(box);
  const left = Math.min(0.2 * box.width, 180);
  return page.screenshot({ clip: { x: box.x + left, y: box.y, width: box.width - 2 * left, height: box.height - 70 } });
}

before(async () => {
  await mkdir(SCREENSHOTS, { recursive: true });
  browser = await openBrowser();
  ({ page, complaints } = await openPage(browser.context, browser.address));
  await solved();
});

after(() => browser?.close());

test('the first scene is the torus, its path shorter than the straight start', async () => {
  assert.equal(await page.inputValue('#entry'), 'parametricTorus');
  assert.equal(await status(), 'converged');
  assert.ok(Number.parseFloat(await text('#length')) < Number.parseFloat(await text('#start-length')));
  assert.match(await text('#time'), /^[\d.]+ ms$/);
  assert.match(await text('#moment-words'), /^Iteration (\d+) of \1$/);
  assert.deepEqual(await Promise.all(['#algorithm', '#tolerance', '#start', '#points'].map((id) => page.inputValue(id))), [
    'elements',
    '1e-9',
    'global',
    '64',
  ]);
});

test('the length has the digits that it is known to, and its error estimate', async () => {
  await page.selectOption('#tolerance', '1e-12');
  assert.match(await text('#length'), /^\d\.\d{8}$/);
  assert.match(await text('#length-error'), /^± \d × 10⁻\S+$/);
  await page.selectOption('#algorithm', 'polyline');
  assert.match(await text('#length'), /^\d\.\d{4,6}$/);
  assert.match(await text('#length-error'), /^± 0\.000\d+$/);
  await page.selectOption('#algorithm', 'elements');
  await page.selectOption('#tolerance', '1e-9');
});

describe('each surface of the gallery is drawn and converges', () => {
  for (const [name, { title }] of Object.entries(gallery)) {
    test(title, async () => {
      await page.selectOption('#entry', name);
      assert.equal(await status(), 'converged', await text('#advice'));
      const { lit, deviation, warm, darkest } = await measurePicture(page, await pictureOfView());
      assert.ok(lit > 0.1, `only ${(100 * lit).toFixed(1)} % of the view is covered`);
      assert.ok(deviation > 5, `the surface is flat: its brightness deviates by ${deviation.toFixed(1)}`);
      assert.ok(warm > 60, `only ${warm} pixels of the path are seen`);
      assert.ok(darkest > 12, `pure black: ${darkest}`);
    });
  }
});

describe('each kind of surface has its own fields', () => {
  for (const [kind, { title, formulas, ranges, coordinates }] of Object.entries(KINDS)) {
    test(title, async () => {
      await page.check(`input[name=kind][value=${kind}]`);
      assert.equal(await page.inputValue('#entry'), `own-${kind}`);
      assert.equal(await status(), 'converged', await text('#advice'));
      const names = await page.$$eval('#fields textarea', (fields) => fields.map(({ id }) => id));
      assert.deepEqual(
        names,
        Object.keys(formulas).map((name) => `field-${name}`),
      );
      assert.equal(await page.locator('#fields .range').count(), ranges.length);
      assert.equal(await page.locator('#ends input').count(), 2 * coordinates.length);
      const { warm } = await measurePicture(page, await pictureOfView());
      assert.ok(warm > 60, `only ${warm} pixels of the path are seen`);
      const [before, last] = [await text('#length'), page.locator('#fields textarea').last()];
      const formula = await last.inputValue();
      await last.fill(`${formula}+oops`);
      await page.waitForSelector(`[id="problem-${Object.keys(formulas).at(-1)}"] pre`);
      assert.equal(await text('#length'), before);
      const [, variable] = /\((\w)/.exec(Object.values(formulas).at(-1) ?? '') ?? [];
      await last.fill(`${formula}+0.01*${variable}^2`);
      await page.waitForFunction((old) => document.getElementById('length')?.textContent !== old, before);
      assert.equal(await status(), 'converged', await text('#advice'));
    });
  }
});

test('an element of a list of formulas is marked in its own field', async () => {
  await page.selectOption('#entry', 'trefoil');
  await page.locator('[id="field-centreline[1]"]').fill('cos(t)-2*kos(2*t)');
  await page.waitForSelector('[id="problem-centreline[1]"] pre');
  const [formula, caret] = (await text('[id="problem-centreline[1]"] pre')).split('\n');
  assert.equal(caret.indexOf('^'), formula.indexOf('kos'));
  assert.match(await text('[id="problem-centreline[1]"] p'), /^[^[]*kos/);
  await page.selectOption('#entry', 'vase');
  await page.fill('#field-t-to', '4*');
  await page.waitForSelector('#problem-t-to pre');
});

test('a mistake in a formula is marked at its character, and the last good surface stays', async () => {
  await page.selectOption('#entry', 'saddle');
  const [length, picture] = [await text('#length'), await pictureOfView()];
  await page.fill('#field-z', 'u^2-foo*v');
  await page.waitForSelector('#problem-z pre');
  const [formula, caret] = (await text('#problem-z pre')).split('\n');
  assert.equal(formula, 'u^2-foo*v');
  assert.equal(caret.indexOf('^'), formula.indexOf('foo'));
  assert.match(await text('#problem-z p'), /foo/);
  assert.equal(await page.getAttribute('#field-z', 'aria-invalid'), 'true');
  assert.equal(await page.evaluate(() => document.activeElement?.id), 'field-z');
  assert.equal(await text('#length'), length);
  assert.ok(picture.equals(await pictureOfView()), 'the picture changed');

  assert.ok(await page.isVisible('#typeset'), 'the gallery speaks of the surface that is shown');
  await page.fill('#field-z', 'u^2-v');
  await page.waitForSelector('#problem-z', { state: 'hidden' });
  assert.equal(await page.getAttribute('#field-z', 'aria-invalid'), null);
  assert.ok(await page.isHidden('#typeset'), 'the gallery knows nothing of a formula that was changed');
  assert.notEqual(await text('#length'), length);
  assert.equal(await status(), 'converged');
});

test('a mistake in a long formula, in a range and in bounds is marked too', async () => {
  await page.selectOption('#entry', 'threeTori');
  const long = `${await page.inputValue('#field-f')}+nonsense`;
  await page.fill('#field-f', long);
  await page.waitForSelector('#problem-f pre');
  const [formula, caret] = (await text('#problem-f pre')).split('\n');
  assert.ok(formula.slice(caret.indexOf('^')).startsWith('nonsense'));
  await page.selectOption('#entry', 'sphere');
  await page.fill('#field-x-from', 'left');
  await page.waitForSelector('#problem-x-from p');
  await page.selectOption('#entry', 'cylinder');
  await page.fill('#field-u-to', '2*');
  await page.waitForSelector('#problem-u-to pre');
  assert.equal(await status(), 'converged');
});

test('end points are numbers: a wrong one is said in words, a right one moves the path', async () => {
  await page.selectOption('#entry', 'saddle');
  const length = await text('#length');
  await page.fill('#end-1-0', '7');
  assert.match(await text('#ends-problem'), /u of B must lie between -1 and 1/);
  assert.equal(await page.getAttribute('#end-1-0', 'aria-invalid'), 'true');
  await page.fill('#end-1-0', '');
  assert.match(await text('#ends-problem'), /B needs a number for u/);
  await page.fill('#end-1-0', '0.5');
  assert.equal(await status(), 'converged');
  assert.notEqual(await text('#length'), length);
  await page.click('#random-ends');
  assert.match(await text('#status'), /\w/);
});

test('algorithm, points, tolerance and parameters change what is solved', async () => {
  await page.selectOption('#entry', 'parametricTorus');
  const exact = Number.parseFloat(await text('#length'));
  await page.selectOption('#algorithm', 'polyline');
  assert.equal(await page.isVisible('#tolerance'), false);
  const length = await text('#length');
  assert.ok(Number.parseFloat(length) < exact, 'chords are shorter than the arc');
  await page.fill('#points', '9');
  assert.ok(Number.parseFloat(await text('#length')) < Number.parseFloat(length));
  await page.fill('#points', '0');
  assert.match(await text('#points-problem'), /whole number/);
  await page.fill('#points', '64');
  assert.equal(await text('#length'), length);
  await page.selectOption('#algorithm', 'paper');
  assert.match(await text('#status'), /\w/);
  await page.selectOption('#algorithm', 'elements');
  assert.equal(await page.isVisible('#tolerance'), true);
  assert.equal(Number.parseFloat(await text('#length')), exact);
  await page.fill('#parameter-a', '1');
  assert.notEqual(Number.parseFloat(await text('#length')), exact);
  assert.equal(await text('#value-a'), '1');
});

test('the globally shortest path is shorter than the one near the straight line, and only the latter has iterates to play', async () => {
  await page.selectOption('#entry', 'hills');
  const [length, start] = [Number.parseFloat(await text('#length')), await text('#start-length')];
  assert.equal(await text('#moment-words'), 'Path alone');
  assert.equal(await page.isDisabled('#play'), true);
  await page.selectOption('#start', 'straight');
  assert.equal(await status(), 'converged');
  assert.ok(Number.parseFloat(await text('#length')) > 1.005 * length);
  assert.match(await text('#moment-words'), /^Iteration (\d+) of \1$/);
  assert.equal(Number.parseFloat(await text('#start-length')), Number.parseFloat(start));
  await page.selectOption('#start', 'global');
});

test('each status is said in words', () => {
  for (const name of STATUS.values()) {
    const [words, advice] = describeStatus(name, 'straight');
    assert.notEqual(words, name);
    assert.match(advice, /^[A-Z].*\.$/, name);
  }
});

test('the iterates play in about a second, and can be scrubbed', async () => {
  await page.selectOption('#entry', 'parametricTorus');
  await page.emulateMedia({ reducedMotion: 'no-preference' });
  const last = Number(await page.getAttribute('#moment', 'max'));
  assert.ok(last >= 2);
  const begin = Date.now();
  await page.click('#play');
  assert.ok(Number(await page.inputValue('#moment')) < last);
  await page.waitForFunction((end) => /** @type {any} */ (document.getElementById('moment')).valueAsNumber === end, last);
  assert.ok(Date.now() - begin < 4000);
  await page.fill('#moment', '0');
  assert.equal(await text('#moment-words'), `Iteration 0 of ${last}`);
  await page.emulateMedia({ reducedMotion: 'reduce' });
});

test('nothing is drawn when nothing moves', async () => {
  await page.waitForTimeout(300);
  const frames = await page.evaluate(async () => {
    let count = 0;
    const request = window.requestAnimationFrame;
    window.requestAnimationFrame = (callback) => {
      count++;
      return request.call(window, callback);
    };
    await new Promise((resolve) => setTimeout(resolve, 300));
    window.requestAnimationFrame = request;
    return count;
  });
  assert.equal(frames, 0);
});

describe('it fits', () => {
  for (const [width, height] of [
    [1440, 900],
    [900, 700],
    [390, 844],
  ])
    for (const colorScheme of /** @type {const} */ (['light', 'dark']))
      test(`${width} × ${height}, ${colorScheme}`, async () => {
        await page.setViewportSize({ width, height });
        await page.emulateMedia({ colorScheme });
        await page.selectOption('#entry', 'parametricTorus');
        await nextFrame(page);
        const sizes = await page.evaluate(() => ({
          content: document.documentElement.scrollWidth,
          window: innerWidth,
          canvas: /** @type {HTMLCanvasElement} */ (document.getElementById('canvas')).width,
          shown: document.getElementById('canvas')?.clientWidth,
        }));
        assert.ok(sizes.content <= sizes.window, 'the page scrolls sideways');
        assert.equal(sizes.canvas, sizes.shown);
        await page.evaluate(() => document.querySelector('#panel')?.scrollTo(0, 0));
        await page.screenshot({ path: `${SCREENSHOTS}page-${width}x${height}-${colorScheme}.png` });
      });
});

test('without WebGL the page says so, and still computes', async () => {
  const other = await openBrowser(['--disable-3d-apis']);
  try {
    const { page: plain } = await openPage(other.context, other.address);
    await plain.waitForSelector('#notice:not([hidden])');
    assert.match((await plain.textContent('#notice')) ?? '', /WebGL/);
    await plain.waitForFunction(() => document.getElementById('status')?.dataset.status === 'converged');
  } finally {
    await other.close();
  }
});

test('without WebAssembly the page says so', async () => {
  const { page: plain } = await openPageWithout(browser);
  assert.match((await plain.textContent('#notice')) ?? '', /WebAssembly/);
  await plain.close();
});

/** @param {typeof browser} from */
async function openPageWithout({ context, address }) {
  const plain = await context.newPage();
  await plain.addInitScript(() => {
    // @ts-expect-error a browser without it
    delete window.WebAssembly;
  });
  await plain.goto(address);
  await plain.waitForSelector('#notice:not([hidden])');
  return { page: plain };
}

test('the console stayed silent', () => {
  assert.deepEqual(complaints, []);
});
