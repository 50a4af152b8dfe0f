/** The demo page in headless Chromium for a test: served, opened, listened to, and closed again with everything it left behind. */

import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { chromium } from 'playwright-core';
import { serve } from '../../demo/serve.js';

export const ARGUMENTS = [
  '--no-sandbox',
  '--disable-gpu',
  '--enable-unsafe-swiftshader',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
];

/** Where nobody looks at a picture it has a quarter of the pixels, of one sample each: drawing in software takes most of the time. `make browsers` draws them all. */
export const COARSE = process.env.EVERY_RELEASE ? {} : { deviceScaleFactor: 0.5, args: ['--webgl-antialiasing-mode=none'] };

/** Taking a screenshot reads the canvas back: the software renderer remarks on that, and nothing else, as the driver. */
const OF_THE_SCREENSHOT = /GL Driver Message .*GPU stall due to ReadPixels/;

/** @typedef {import('playwright-core').BrowserContextOptions & { args?: string[] }} BrowserOptions */

/**
 * Opens a browser and the server of the page.
 * @param {string[]} [more] arguments for the browser
 * @param {BrowserOptions} [options]
 */
export async function openBrowser(more = [], options = {}) {
  const folder = await mkdtemp(join(tmpdir(), 'surfpath-browser-'));
  const server = await serve();
  const context = await chromium.launchPersistentContext(folder, {
    executablePath: '/usr/bin/chromium',
    headless: true,
    viewport: { width: 1040, height: 640 },
    reducedMotion: 'reduce',
    ...options,
    args: [...ARGUMENTS, ...(options.args ?? []), ...more],
  });
  const close = async () => {
    await context.close();
    await server.close();
    await rm(folder, { recursive: true, force: true });
  };
  return { context, address: server.address, close };
}

/**
 * Opens the page and keeps what its console says.
 * @param {import('playwright-core').BrowserContext} context @param {string} address
 */
export async function openPage(context, address) {
  const page = await context.newPage();
  page.setDefaultTimeout(60000);
  /** @type {string[]} errors and warnings, since the page was opened */
  const complaints = [];
  page.on('console', (message) => {
    const isIcon = message.location().url.endsWith('/favicon.ico');
    if (['error', 'warning'].includes(message.type()) && !isIcon && !OF_THE_SCREENSHOT.test(message.text()))
      complaints.push(message.text());
  });
  page.on('pageerror', (error) => complaints.push(String(error.stack)));
  page.on('requestfailed', (request) => complaints.push(`${request.url()} failed`));
  page.on('response', (response) => {
    if (response.status() >= 400) complaints.push(`${response.url()}: ${response.status()}`);
  });
  await page.goto(address);
  return { page, complaints };
}

/**
 * The page as the tests of a file share it: opened, with its first scene solved.
 * @param {string[]} [more] @param {BrowserOptions} [options] both as for `openBrowser`
 */
export async function openSettled(more, options) {
  const browser = await openBrowser(more, options);
  const { page, complaints } = await openPage(browser.context, browser.address);
  await settled(page);
  return { browser, page, complaints };
}

/** Waits until everything is computed that was asked for; looks by the clock, as a busy machine may not draw for long. @param {import('playwright-core').Page} page @param {number} [timeout] milliseconds */
export async function settled(page, timeout = 60000) {
  await page.waitForFunction(
    () => document.getElementById('status')?.dataset.status && !document.documentElement.hasAttribute('data-busy'),
    null,
    { timeout, polling: 100 },
  );
}

/** A link's end. @param {unknown} sketch */
export const hashOf = (sketch) => `#1.${Buffer.from(JSON.stringify(sketch)).toString('base64url')}`;

/** Opens an entry of the gallery, and waits until it is solved. @param {import('playwright-core').Page} page @param {string} name */
export const openEntry = (page, name) => openSketch(page, { entry: name });

/** Follows a link, and waits until all of it is computed. @param {import('playwright-core').Page} page @param {object} sketch */
export async function openSketch(page, sketch) {
  await followLink(page, sketch);
  await settled(page);
}

/** Follows a link, and waits until the page has heard of it. @param {import('playwright-core').Page} page @param {object} sketch */
export async function followLink(page, sketch) {
  await page.evaluate((hash) => {
    // The same address again would change nothing; in one go, as the page rewrites the address by itself.
    history.replaceState(null, '', '#');
    // Once the page has heard of it, it is busy.
    const heard = new Promise((resolve) => addEventListener('hashchange', resolve, { once: true }));
    location.hash = hash;
    return heard.then(() => {});
  }, hashOf(sketch));
}

/** The middle of the view, without legend and player. @param {import('playwright-core').Page} page */
export async function pictureOfView(page) {
  await nextFrame(page);
  const box = await page.locator('#canvas').boundingBox();
  if (!box) throw new Error('the page has no view');
  const left = Math.min(0.2 * box.width, 180);
  return page.screenshot({ clip: { x: box.x + left, y: box.y + 60, width: box.width - 2 * left, height: box.height - 130 } });
}

/** Waits until what was changed is drawn: two frames. @param {import('playwright-core').Page} page */
export async function nextFrame(page) {
  await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
}

/**
 * Measures a picture, in the browser, which can decode it.
 * @param {import('playwright-core').Page} page @param {Buffer} picture PNG
 * @returns {Promise<{ lit: number, deviation: number, warm: number, darkest: number }>} lit: share of pixels unlike the corner's; deviation: of the
 *   brightness of these, 0 … 255; warm: number of pixels in the path's colour, as many as there would be at a scale of 1; darkest: brightness
 */
export async function measurePicture(page, picture) {
  return page.evaluate(async (text) => {
    const bytes = Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
    const image = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
    const drawing = /** @type {OffscreenCanvasRenderingContext2D} */ (new OffscreenCanvas(image.width, image.height).getContext('2d'));
    drawing.drawImage(image, 0, 0);
    const { data } = drawing.getImageData(0, 0, image.width, image.height);
    const corner = data[0] + data[1] + data[2];
    let [lit, sum, squares, warm, darkest] = [0, 0, 0, 0, 255];
    for (let i = 0; i < data.length; i += 4) {
      const brightness = (data[i] + data[i + 1] + data[i + 2]) / 3;
      darkest = Math.min(darkest, brightness);
      if (data[i] > 200 && data[i + 1] < 130 && data[i + 2] < 80) warm++;
      if (Math.abs(3 * brightness - corner) < 60) continue;
      lit++;
      sum += brightness;
      squares += brightness * brightness;
    }
    const deviation = Math.sqrt(Math.max(squares / lit - (sum / lit) ** 2, 0));
    return { lit: (4 * lit) / data.length, deviation, warm: warm / devicePixelRatio ** 2, darkest };
  }, picture.toString('base64'));
}

/** How many pixels of two pictures of one size differ to the eye. @param {import('playwright-core').Page} page @param {Buffer} one PNG @param {Buffer} other */
export async function countDifferent(page, one, other) {
  return page.evaluate(
    async (texts) => {
      const [a, b] = await Promise.all(
        texts.map(async (text) => {
          const bytes = Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
          const image = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
          const drawing = /** @type {OffscreenCanvasRenderingContext2D} */ (
            new OffscreenCanvas(image.width, image.height).getContext('2d')
          );
          drawing.drawImage(image, 0, 0);
          return drawing.getImageData(0, 0, image.width, image.height).data;
        }),
      );
      let count = 0;
      for (let i = 0; i < a.length; i += 4) if ([0, 1, 2].some((k) => Math.abs(a[i + k] - b[i + k]) > 24)) count++;
      return count;
    },
    [one, other].map((picture) => picture.toString('base64')),
  );
}
