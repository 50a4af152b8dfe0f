// Chromium, Firefox and WebKit show the same: every surface of the gallery draws, converges, and has the same length to the last digit.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { ENTRIES } from '../../demo/state/entries.js';
import { serve } from '../../demo/serve.js';
import { openFirefox, openWebKit } from '../helpers/engines.js';
import { openBrowser, openPage } from '../helpers/page.js';
import { serveSite } from '../helpers/site.js';

/** @typedef {import('../helpers/engines.js').Engine} Engine */

/** @param {string} body */
const elementPage = (body) => `<!doctype html><html lang="en"><meta charset="utf-8"><title>Elements</title>
<script type="importmap">{ "imports": { "three": "/node_modules/three/build/three.module.js", "three/addons/": "/node_modules/three/examples/jsm/" } }</script>
<script type="module" src="/dist/element.js"></script>
<main>${body}</main>`;

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

/** Follows a link, until the page has heard of it: then it is busy. @param {Engine} engine @param {string} hash */
async function follow(engine, hash) {
  await engine.evaluate(`new Promise((resolve) => {
    history.replaceState(null, '', '#');
    addEventListener('hashchange', () => resolve(0), { once: true });
    location.hash = '${hash}';
  })`);
  return engine.evaluate(SETTLED);
}

/** @param {Engine} engine @param {string} name */
const openEntry = (engine, name) => follow(engine, `1.${Buffer.from(JSON.stringify({ entry: name })).toString('base64url')}`);

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

    const length = () => engine.evaluate(`Number(document.getElementById('length').dataset.exact)`);
    /** Does something in the page, and waits until what follows from it is computed. @param {string} script */
    const act = (script) =>
      engine.evaluate(`(async () => { ${script}; await new Promise((resolve) => setTimeout(resolve, 500)); return ${SETTLED}; })()`);
    const write = (/** @type {string} */ id, /** @type {string} */ value) =>
      `(() => { const input = document.getElementById('${id}'); input.value = '${value}'; input.dispatchEvent(new Event('input', { bubbles: true })); })()`;

    test('an end is moved by arrow keys, and back by undo', async () => {
      await openEntry(engine, 'parametricTorus');
      const before = await length();
      const press = `document.getElementById('handle-B').dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowRight', bubbles: true, cancelable: true }))`;
      await act(`for (let i = 0; i < 3; i++) ${press}`);
      assert.ok(Math.abs((await length()) - before) > 1e-3);
      await act(`document.getElementById('undo').click()`);
      assert.equal(await length(), before);
    });

    test('a slider deforms surface and path; a link brings both back', async () => {
      await openEntry(engine, 'parametricTorus');
      await act(write('value-a', '1.2'));
      const moved = await length();
      assert.notEqual(String(moved), lengths.get('parametricTorus'));
      if (!lengths.has('moved')) lengths.set('moved', String(moved));
      assert.equal(String(moved), lengths.get('moved'));
      await engine.evaluate(`new Promise((resolve) => setTimeout(resolve, 500))`);
      const link = await engine.evaluate('location.hash.slice(1)');
      await openEntry(engine, 'saddle');
      await follow(engine, link);
      assert.equal(await length(), moved);
      assert.equal(await engine.evaluate(`document.getElementById('value-a').value`), '1.2');
    });

    test('exports hold what is shown', async () => {
      await openEntry(engine, 'parametricTorus');
      const files = await engine.evaluate(`(async () => {
        const { createObjectURL } = URL;
        const { click } = HTMLAnchorElement.prototype;
        HTMLAnchorElement.prototype.click = () => {};
        const files = {};
        for (const name of ['png', 'svg', 'csv', 'json', 'gltf']) {
          const blob = await new Promise((resolve) => {
            URL.createObjectURL = (given) => (resolve(given), 'about:blank');
            document.querySelector('[data-export=' + name + ']').click();
          });
          files[name] = name === 'png' ? Array.from(new Uint8Array(await blob.slice(0, 8).arrayBuffer())).concat(blob.size) : await blob.text();
        }
        Object.assign(URL, { createObjectURL });
        HTMLAnchorElement.prototype.click = click;
        return files;
      })()`);
      assert.deepEqual(files.png.slice(1, 4), [80, 78, 71]);
      assert.ok(files.png.at(-1) > 10_000, 'not an empty picture');
      assert.match(files.svg, /<polyline[^>]*class="path"/);
      assert.equal(files.csv.trim().split('\n').length, 67);
      assert.equal(String(JSON.parse(files.json).path.length), lengths.get('parametricTorus'));
      assert.equal(JSON.parse(files.gltf).meshes.length, 2);
    });

    test('a metric over space on an implicit surface', async () => {
      await openEntry(engine, 'own-implicit');
      await act(`document.querySelector('[data-preset=grain]').click()`);
      const exact = String(await length());
      if (!lengths.has('grain')) lengths.set('grain', exact);
      assert.equal(exact, lengths.get('grain'));
      assert.ok((await engine.evaluate('window.surfpathView.strokes')) > 100);
    });

    test('several elements on one page, under a strict policy, one context', async () => {
      const body = ['saddle', 'sphere', 'vase'].map((name) => `<surface-path surface="${name}" controls></surface-path>`).join('');
      const site = await serveSite({ page: elementPage(body) });
      try {
        await engine.open(`${site.address}/page`);
        const found = await engine.evaluate(`new Promise((resolve) => {
          const all = [...document.querySelectorAll('surface-path')];
          const tell = ({ path, shadowRoot }) => path ? String(path.length) : 'no path, but ' + shadowRoot?.textContent;
          const look = () => all.every(({ path }) => path) || performance.now() > 50_000 ? resolve(all.map(tell)) : setTimeout(look, 50);
          look();
        })`);
        assert.deepEqual(
          found,
          ['saddle', 'sphere', 'vase'].map((name) => lengths.get(name)),
        );
        const colours = await engine.evaluate(`(async () => {
          const all = [...document.querySelectorAll('surface-path')];
          for (const element of all) element.style.width = '300px';
          const count = (element) => {
            const small = Object.assign(document.createElement('canvas'), { width: 40, height: 30 });
            const drawing = small.getContext('2d');
            drawing.drawImage(element.shadowRoot.querySelector('canvas'), 0, 0, 40, 30);
            const { data } = drawing.getImageData(0, 0, 40, 30);
            return new Set(Array.from({ length: 1200 }, (_, i) => data.slice(4 * i, 4 * i + 3).join())).size;
          };
          // Without a graphics card a first picture may take seconds.
          for (let i = 0; i < 200 && all.some((element) => count(element) < 21); i++) await new Promise((resolve) => setTimeout(resolve, 100));
          return all.map(count);
        })()`);
        for (const count of colours) assert.ok(count > 20, `${count} colours: an element is not drawn`);
      } finally {
        await site.close();
      }
    });
  });
