/** Renders the pictures of the gallery and of the manual with the page itself, in headless Chromium: `make thumbnails`. The ground is left transparent, for both themes. */

import { writeFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import { nextFrame, openBrowser, openPage, settled } from '../tests/helpers/page.js';
import { ENTRIES } from './state/entries.js';
import { FIRST } from './state/state.js';

const FOLDER = fileURLToPath(new URL('thumbnails/', import.meta.url));
const [WIDTH, HEIGHT] = [320, 240];
const QUALITY = 0.8;
/** The picture that stands in for the first scene, blurred, until that is drawn: it counts among what is loaded. */
const POSTER = { width: WIDTH / 2, height: HEIGHT / 2, quality: 0.6 };
/** What is left of the page, whatever layout a window so small has: the canvas, half as wide again as the picture, with nothing over it. */
const BARE = `.panel, .result, .tabs, .view > :not(canvas) { display: none !important }
body { grid-template: 1fr / 1fr !important } .stage { display: block !important }
.view { position: fixed !important; inset: 0; padding: 0 !important }
html, body, .view { background: none !important }`;

const { context, address, close } = await openBrowser([], {
  bypassCSP: true,
  deviceScaleFactor: 2,
  viewport: { width: 1.5 * WIDTH, height: 1.5 * HEIGHT },
});
try {
  const { page } = await openPage(context, address);
  await settled(page);
  await page.addStyleTag({ content: BARE });
  const wanted = process.argv.slice(2);
  for (const name of wanted.length > 0 ? wanted : Object.keys(ENTRIES)) {
    const sketch = Buffer.from(JSON.stringify({ entry: name })).toString('base64url');
    await page.evaluate((hash) => location.replace(hash), `#1.${sketch}`);
    await page.waitForTimeout(100);
    await settled(page);
    await page.waitForTimeout(150);
    await page.waitForSelector('html:not([data-measuring])');
    await nextFrame(page);
    const picture = await page.screenshot({ omitBackground: true });
    await writeFile(`${FOLDER}${name}.webp`, await shrink(page, picture));
    if (name === FIRST) await writeFile(`${FOLDER}poster.webp`, await shrink(page, picture, POSTER));
  }
} finally {
  await close();
}

await takePicture('light', 'picture.webp');
await takePicture('dark', 'picture-dark.webp');

/** A picture of the manual: the page as it is, with the distances from A. @param {'light' | 'dark'} colorScheme @param {string} file */
async function takePicture(colorScheme, file) {
  const [width, height] = [1280, 800];
  const browser = await openBrowser([], { viewport: { width, height }, bypassCSP: true, colorScheme });
  try {
    const sketch = Buffer.from(JSON.stringify({ entry: 'parametricTorus', colour: 'distance' })).toString('base64url');
    const { page } = await openPage(browser.context, `${browser.address}#1.${sketch}`);
    await settled(page);
    await page.waitForSelector('html:not([data-measuring]) #scale:not([hidden])');
    await nextFrame(page);
    await writeFile(fileURLToPath(new URL(file, import.meta.url)), await shrink(page, await page.screenshot(), { width, height }));
  } finally {
    await browser.close();
  }
}

/** @param {import('playwright-core').Page} page @param {Buffer} picture PNG @param {{ width?: number, height?: number, quality?: number }} [options] @returns {Promise<Buffer>} WebP */
async function shrink(page, picture, { width = WIDTH, height = HEIGHT, quality = QUALITY } = {}) {
  const text = await page.evaluate(
    async ({ png, width, height, quality }) => {
      const bytes = Uint8Array.from(atob(png), (character) => character.charCodeAt(0));
      const options = /** @type {const} */ ({ resizeWidth: width, resizeHeight: height, resizeQuality: 'high' });
      const image = await createImageBitmap(new Blob([bytes], { type: 'image/png' }), options);
      const canvas = new OffscreenCanvas(width, height);
      canvas.getContext('2d')?.drawImage(image, 0, 0);
      const blob = await canvas.convertToBlob({ type: 'image/webp', quality });
      return btoa(Array.from(new Uint8Array(await blob.arrayBuffer()), (byte) => String.fromCharCode(byte)).join(''));
    },
    { png: picture.toString('base64'), width, height, quality },
  );
  return Buffer.from(text, 'base64');
}
