// Chromium, Firefox and WebKit show the same: every surface of the gallery draws, converges, and has the same length to the last digit.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { ENTRIES } from '../../demo/entries.js';
import { serve } from '../../demo/serve.js';
import { openFirefox, openWebKit } from '../helpers/engines.js';
import { openBrowser, openPage } from '../helpers/page.js';

/** @typedef {import('../helpers/engines.js').Engine} Engine */

/** @returns {Promise<Engine>} */
async function openChromium() {
  const { context, address, close } = await openBrowser();
  const { page } = await openPage(context, address);
  return {
    name: 'Chromium',
    open: async (url) => void (await page.goto(url)),
    evaluate: (script) => page.evaluate(script),
    async drag([[x, y], ...path]) {
      await page.mouse.move(x, y);
      await page.mouse.down();
      for (const [toX, toY] of path) await page.mouse.move(toX, toY);
      await page.mouse.up();
    },
    close,
  };
}

/** Lengths by entry, as the first engine shows them. @type {Map<string, string>} */
const lengths = new Map();
/** @type {Awaited<ReturnType<typeof serve>>} */ let server;
before(async () => {
  server = await serve();
});
after(() => server.close());

/** Waits, in the page, until all is computed and drawn. */
const SETTLED = `new Promise((resolve) => {
  const look = () => document.getElementById('status')?.dataset.status && !document.documentElement.hasAttribute('data-busy')
    ? requestAnimationFrame(() => requestAnimationFrame(() => resolve(document.getElementById('status').dataset.status)))
    : setTimeout(look, 30);
  look();
})`;

/** How many different colours the view has, among some hundred places: a surface in light has many, an empty view one. */
const COLOURS = `(() => {
  const { camera } = window.surfpathView;
  window.surfpathView.draw();
  const canvas = document.getElementById('canvas');
  const small = Object.assign(document.createElement('canvas'), { width: 40, height: 30 });
  const drawing = small.getContext('2d');
  drawing.drawImage(canvas, 0, 0, 40, 30);
  const { data } = drawing.getImageData(0, 0, 40, 30);
  return new Set(Array.from({ length: 1200 }, (_, i) => data.slice(4 * i, 4 * i + 3).join())).size;
})()`;

/** @param {Engine} engine @param {string} name */
async function openEntry(engine, name) {
  const hash = `1.${Buffer.from(JSON.stringify({ entry: name })).toString('base64url')}`;
  await engine.evaluate(
    `(history.replaceState(null, '', '#'), delete document.getElementById('status').dataset.status, location.hash = '${hash}', 0)`,
  );
  return engine.evaluate(SETTLED);
}

for (const open of [openChromium, openFirefox, openWebKit])
  describe(open.name.slice(4), () => {
    /** @type {Engine} */ let engine;
    before(async () => {
      engine = await open();
      await engine.open(server.address);
      await engine.evaluate(SETTLED);
    });
    after(() => engine?.close());

    for (const name of Object.keys(ENTRIES))
      test(name, async () => {
        assert.equal(await openEntry(engine, name), 'converged');
        const exact = await engine.evaluate(`document.getElementById('length').dataset.exact`);
        assert.match(exact, /^\d+\.\d+/);
        if (!lengths.has(name)) lengths.set(name, exact);
        assert.equal(exact, lengths.get(name));
        const colours = await engine.evaluate(COLOURS);
        assert.ok(colours > 20, `${colours} colours: the surface is not drawn`);
      });

    test('an end is dragged by mouse', async () => {
      await openEntry(engine, 'saddle');
      const middle = `(id) => { const { left, top, width, height } = document.getElementById(id).getBoundingClientRect(); return [left + width / 2, top + height / 2]; }`;
      const [a, b] = await engine.evaluate(`['handle-A', 'handle-B'].map(${middle})`);
      const before = lengths.get('saddle');
      const place = (/** @type {number} */ t) => /** @type {[number, number]} */ ([b[0] + t * (a[0] - b[0]), b[1] + t * (a[1] - b[1])]);
      await engine.drag([0, 0.1, 0.2, 0.3].map(place));
      await engine.evaluate(`new Promise((resolve) => setTimeout(resolve, 400))`);
      await engine.evaluate(SETTLED);
      const exact = await engine.evaluate(`document.getElementById('length').dataset.exact`);
      assert.ok(Number(exact) < Number(before) - 0.1, `${before} has become ${exact}`);
    });

    test('a mistake in a formula is shown, and the surface stays', async () => {
      await openEntry(engine, 'saddle');
      const words = await engine.evaluate(`(async () => {
        const field = document.getElementById('field-z');
        field.focus();
        field.value = 'u^2-sine(v)';
        field.dispatchEvent(new Event('input', { bubbles: true }));
        await new Promise((resolve) => setTimeout(resolve, 400));
        return document.getElementById('problem-z').textContent;
      })()`);
      assert.match(words, /\^.*sin/s);
      assert.equal(await engine.evaluate(`document.getElementById('length').dataset.exact`), lengths.get('saddle'));
    });
  });
