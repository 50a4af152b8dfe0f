// <surface-path> in headless Chromium, on pages with a strict policy: events, attributes, handles, many on a page, off screen, removed, without WebGL.
import assert from 'node:assert/strict';
import { mkdir, readFile } from 'node:fs/promises';
import { after, before, describe, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { load } from '../../web/index.js';
import { COARSE, countDifferent, measurePicture, nextFrame, openBrowser, openPage } from '../helpers/page.js';
import { RELEASES } from '../helpers/scene.js';
import { serveSite } from '../helpers/site.js';

const SCREENSHOTS = fileURLToPath(new URL('../../build/screenshots/', import.meta.url));
const TORUS = '<surface-path id="torus" surface="parametricTorus" from="0.5,0.6" to="2.6,1.2" controls></surface-path>';
const HILL =
  '<surface-path id="hill" x="u" y="v" z="h exp(-4(u^2 + v^2))" u="-1,1" v="-1,1" parameters="h=0.5" from="-0.9,-0.2" to="0.8,0.1"></surface-path>';

/** @param {string} body @param {string} [three] */
const pageOf = (body, three = 'three') => `<!doctype html><html lang="en"><meta charset="utf-8"><title>Elements</title>
<script type="importmap">{ "imports": { "three": "/node_modules/${three}/build/three.module.js", "three/addons/": "/node_modules/${three}/examples/jsm/" } }</script>
<script type="module" src="/dist/element.js"></script>
<main>${body}</main>`;

/** Counts contexts, shader programs and pictures, and keeps events, from before the first script. */
function watch() {
  const seen = { contexts: /** @type {any[]} */ ([]), programs: 0, pictures: 0, events: /** @type {any[]} */ ([]) };
  Object.assign(window, { seen });
  const { linkProgram } = WebGL2RenderingContext.prototype;
  WebGL2RenderingContext.prototype.linkProgram = function (program) {
    seen.programs++;
    return linkProgram.call(this, program);
  };
  const { getContext } = HTMLCanvasElement.prototype;
  HTMLCanvasElement.prototype.getContext = /** @type {any} */ (
    function (/** @type {string} */ kind, /** @type {any} */ options) {
      // @ts-expect-error `this` is the canvas
      const context = getContext.call(this, kind, options);
      if (/webgl/.test(kind) && context && !seen.contexts.includes(context)) seen.contexts.push(context);
      return context;
    }
  );
  const { drawImage } = CanvasRenderingContext2D.prototype;
  CanvasRenderingContext2D.prototype.drawImage = /** @type {any} */ (
    function (/** @type {any[]} */ ...given) {
      seen.pictures++;
      // @ts-expect-error `this` is the context
      return drawImage.apply(this, given);
    }
  );
  for (const type of ['path', 'error'])
    window.addEventListener(
      type,
      (event) => {
        const { detail, target } = /** @type {any} */ (event);
        if (target?.localName === 'surface-path')
          seen.events.push([target.id, type, type === 'path' ? detail.length : `${detail.name}: ${detail.message}`]);
      },
      true,
    );
}

/** @type {Awaited<ReturnType<typeof openBrowser>>} */ let browser;
/** @type {Awaited<ReturnType<typeof serveSite>>} */ let site;
/** @type {import('playwright-core').Page} */ let page;
/** @type {string[]} */ let complaints;

before(async () => {
  await mkdir(SCREENSHOTS, { recursive: true });
  const spacer = '<div id="spacer"></div>';
  const far = '<surface-path id="far" surface="sphere" colour="curvature"></surface-path>';
  const late = pageOf(
    '<surface-path id="late"></surface-path><surface-path id="sweep" s="-pi,0" t="0,3" profile="cos(s);sin(s)" from="-3,0.2" to="-0.2,2.8"></surface-path>',
  );
  site = await serveSite({
    ...{
      page: pageOf(TORUS + HILL + spacer + far),
      empty: pageOf(''),
      many: pageOf('<surface-path surface="vase"></surface-path>'.repeat(6)),
    },
    late: late.replace(/<script type="module".*<\/script>/, ''),
  });
  browser = await openBrowser([], COARSE);
  await browser.context.addInitScript(watch);
  ({ page, complaints } = await openPage(browser.context, `${site.address}/page`));
  await page.evaluate(() => {
    for (const element of document.querySelectorAll('surface-path'))
      Object.assign(/** @type {any} */ (element).style, { width: '400px', height: '300px' });
    Object.assign(/** @type {any} */ (document.getElementById('spacer')).style, { height: '3000px' });
  });
  await page.waitForFunction(() => /** @type {any} */ (window).seen.events.length >= 3);
});
after(async () => {
  await browser?.close();
  await site?.close();
});

const words = (/** @type {string} */ id) => page.$eval(`#${id}`, (element) => element.shadowRoot?.querySelector('p')?.textContent);
const pictures = () => page.evaluate(() => /** @type {any} */ (window).seen.pictures);
const lastEvent = () => page.evaluate(() => /** @type {any} */ (window).seen.events.at(-1));
/** Changes an attribute and waits for what comes of it. @param {string} id @param {string} name @param {string | null} value */
const change = async (id, name, value) => {
  const before = await page.evaluate(() => /** @type {any} */ (window).seen.events.length);
  await page.$eval(
    `#${id}`,
    (element, [key, text]) => (text === null ? element.removeAttribute(String(key)) : element.setAttribute(String(key), text)),
    [name, value],
  );
  await page.waitForFunction((count) => /** @type {any} */ (window).seen.events.length > count, before);
  await nextFrame(page);
  return lastEvent();
};
/** Whether the page shows a path there. @param {string} id */
const warmth = async (id) => (await measurePicture(page, await page.locator(`#${id}`).screenshot())).warm;

test('terrain in metres of a map looks as it does at the origin', async () => {
  const looks = [];
  for (const [x, y] of [
    [0, 0],
    [500000, 4600000],
  ]) {
    const { page: other } = await openPage(browser.context, `${site.address}/empty`);
    await other.evaluate(
      async ([a, b]) => {
        await customElements.whenDefined('surface-path');
        const element = /** @type {any} */ (document.createElement('surface-path'));
        Object.assign(element.style, { width: '400px', height: '300px' });
        const z = `20sin((x - ${a})/30)cos((y - ${b})/40)`;
        element.definition = { kind: 'graph', z, x: [a - 100, a + 100], y: [b - 100, b + 100] };
        Object.assign(element, { from: [a - 80, b - 70], to: [a + 70, b + 80] });
        const solved = new Promise((resolve) => element.addEventListener('path', resolve, { once: true }));
        document.querySelector('main')?.append(element);
        await solved;
      },
      [x, y],
    );
    await nextFrame(other);
    looks.push(await other.locator('surface-path').screenshot());
    await other.close();
  }
  const differ = await countDifferent(page, looks[0], looks[1]);
  // Edges are not the same to the last hair.
  assert.ok(differ < 15, `${differ} pixels`);
});

test('each says its path, to the digits of the library', async () => {
  const events = await page.evaluate(() => /** @type {any} */ (window).seen.events);
  const torus = (await load()).parametric({
    x: '(4+1.5cos(v))cos(u)',
    y: '(4+1.5cos(v))sin(u)',
    z: '1.5sin(v)',
    u: [0, '2pi'],
    v: [0, '2pi'],
  });
  const { length } = torus.shortestPath([0.5, 0.6], [2.6, 1.2]);
  const own = Object.fromEntries(events.map((/** @type {any[]} */ [id, type, detail]) => [id, [type, detail]]));
  assert.ok(Math.abs(own.torus[1] / length - 1) < 1e-12, `${own.torus}`);
  assert.equal(own.hill[1].toFixed(8), '1.94018519');
  assert.deepEqual([await words('torus'), await words('hill')], ['Length 8.8198', 'Length 1.9402']);
  const label = await page.$eval('#torus', (element) => element.shadowRoot?.querySelector('canvas')?.getAttribute('aria-label'));
  assert.equal(label, 'Torus, parametric. Length 8.8198');
  assert.equal(await page.$eval('#torus', (element) => /** @type {any} */ (element).path.length), own.torus[1]);
});

test('what it says of a path stands on one line in a small one, too', async () => {
  const heights = await page.$eval('#torus', (element) => {
    const { style } = /** @type {HTMLElement} */ (element);
    const caption = /** @type {Element} */ (element.shadowRoot?.querySelector('p'));
    const tall = () => caption.getBoundingClientRect().height;
    const large = tall();
    style.width = '120px';
    const small = tall();
    style.width = '400px';
    return [large, small];
  });
  assert.ok(heights[1] > 0 && heights[1] <= heights[0], `${heights}`);
});

test('an end is at once what was asked for, right or wrong', async () => {
  const { page: other } = await openPage(browser.context, `${site.address}/empty`);
  const seen = await other.evaluate(async () => {
    await customElements.whenDefined('surface-path');
    const element = /** @type {any} */ (document.createElement('surface-path'));
    const next = (/** @type {string} */ type) => new Promise((resolve) => element.addEventListener(type, resolve, { once: true }));
    Object.assign(element, { definition: { kind: 'graph', z: 'x*y', x: [-1, 1], y: [-1, 1] }, from: [-1, 0], to: [1, 0.5] });
    const ends = [element.from, element.to];
    document.querySelector('main')?.append(element);
    await next('path');
    element.from = [0, 0];
    ends.push(element.from);
    element.setAttribute('to', '0.5,0.25');
    ends.push(element.to);
    await next('path');
    ends.push(element.from, element.to);
    element.from = 5;
    ends.push(element.from);
    const { detail } = /** @type {any} */ (await next('error'));
    ends.push(element.from);
    Object.assign(element, { from: [9, 0], to: null });
    const { detail: alone } = /** @type {any} */ (await next('error'));
    return [...ends, detail.message, alone.message];
  });
  await other.close();
  assert.deepEqual(seen, [
    ...[[-1, 0], [1, 0.5], [0, 0], [0.5, 0.25], [0, 0], [0.5, 0.25], [5], [5]],
    'shortestPath: from must be [x, y], 2 numbers, not 1',
    'shortestPath: from[0] = 9 lies outside the range of x, [-1, 1]',
  ]);
});

test('that it computes is seen before it does, and holds the page', async () => {
  const fresh = await browser.context.newPage();
  await fresh.addInitScript(() => {
    /** @type {(string | null | undefined)[]} */ const frames = [];
    Object.assign(window, { frames });
    const look = () => {
      const element = document.querySelector('surface-path');
      if (element) frames.push(element.shadowRoot?.textContent);
      requestAnimationFrame(look);
    };
    requestAnimationFrame(look);
  });
  await fresh.goto(`${site.address}/late`);
  await fresh.evaluate(async () => {
    const element = document.createElement('surface-path');
    element.setAttribute('surface', 'torus');
    document.querySelector('main')?.replaceChildren(element);
    await import(/** @type {any} */ ('/dist/element.js'));
  });
  await fresh.waitForFunction(() => /** @type {any} */ (window).frames.at(-1)?.startsWith('Length'));
  const frames = /** @type {string[]} */ (await fresh.evaluate(() => /** @type {any} */ (window).frames));
  assert.deepEqual([...new Set(frames.filter((text) => text))], ['Computing…', 'Length 10.028']);
  await fresh.close();
});

test('all are drawn with one WebGL context', async () => {
  await nextFrame(page);
  assert.ok((await warmth('torus')) > 60 && (await warmth('hill')) > 60);
  assert.equal(await page.evaluate(() => /** @type {any} */ (window).seen.contexts.length), 1);
});

test('nothing is drawn while nothing changes, nor what is off screen', async () => {
  await nextFrame(page);
  const before = await pictures();
  await page.waitForTimeout(300);
  await change('far', 'parameters', 'r=0.9');
  await page.$eval('#far', (element) => element.setAttribute('colour', 'none'));
  await nextFrame(page);
  assert.equal(await pictures(), before);
  await page.$eval('#far', (element) => element.scrollIntoView());
  await page.waitForFunction((count) => /** @type {any} */ (window).seen.pictures > count, before);
  assert.ok((await warmth('far')) > 60);
  await page.evaluate(() => scrollTo(0, 0));
  await nextFrame(page);
});

describe('attributes', () => {
  test('move an end', async () => {
    const [, type, length] = await change('torus', 'to', '2.6,2');
    assert.equal(type, 'path');
    assert.notEqual(length.toFixed(4), '8.8198');
    assert.deepEqual(await page.$eval('#torus', (element) => /** @type {any} */ (element).to), [2.6, 2]);
  });

  test('change parameters, tolerance and algorithm', async () => {
    const [, , higher] = await change('hill', 'parameters', 'h=1');
    assert.equal(higher.toFixed(5), '2.11182');
    const [, , chords] = await change('hill', 'algorithm', 'polyline');
    assert.ok(chords < higher && chords > 0.99 * higher);
    await change('hill', 'algorithm', null);
    const [, type, message] = await change('hill', 'tolerance', '7');
    assert.deepEqual(
      [type, message],
      ['error', 'RangeError: shortestPath: options.tolerance must be a number between 1e-15 and 0.1, not 7'],
    );
    await change('hill', 'tolerance', null);
  });

  test('that are wrong are said in the element and as an event; right ones mend it', async () => {
    const [, type, message] = await change('hill', 'z', 'h exp(-4(u^2 + w^2))');
    assert.deepEqual([type, /^ExpressionError: .*w/.test(message)], ['error', true]);
    assert.match((await words('hill')) ?? '', /w/);
    // What is seen is not what was asked for.
    const opacity = () =>
      page.$eval('#hill', ({ shadowRoot }) => Number(getComputedStyle(/** @type {any} */ (shadowRoot).firstChild).opacity));
    assert.ok((await opacity()) < 0.5);
    assert.equal(await page.$eval('#hill', (element) => /** @type {any} */ (element).path), null);
    // Another attribute than the wrong one: the old surface is not asked for a path.
    assert.equal((await change('hill', 'to', '0.8,0.2'))[1], 'error');
    assert.equal((await change('hill', 'z', 'h exp(-4(u^2 + v^2))'))[1], 'path');
    assert.equal(await opacity(), 1);
    // A number alone is no point, as in the attribute.
    await page.$eval('#hill', (element) => {
      /** @type {any} */ (element).to = 0;
    });
    await page.waitForFunction(() => /** @type {any} */ (window).seen.events.at(-1)[1] === 'error');
    assert.match((await words('hill')) ?? '', /to must be/);
    await change('hill', 'to', '0.8,0.1');
    await change('hill', 'parameters', 'h=0.5');
    assert.equal(await words('hill'), 'Length 1.9402');
  });

  test('give way to a definition, and come back', async () => {
    const before = await page.evaluate(() => /** @type {any} */ (window).seen.events.length);
    await page.$eval('#hill', (element) => {
      /** @type {any} */ (element).definition = { kind: 'graph', z: 0, x: [-1, 1], y: [-1, 1] };
    });
    await page.waitForFunction((count) => /** @type {any} */ (window).seen.events.length > count, before);
    assert.equal((await lastEvent())[2].toFixed(9), Math.hypot(1.7, 0.3).toFixed(9));
    await page.$eval('#hill', (element) => {
      /** @type {any} */ (element).definition = null;
    });
    await page.waitForFunction((count) => /** @type {any} */ (window).seen.events.length > count + 1, before);
    assert.equal(await words('hill'), 'Length 1.9402');
  });
});

test('a complaint that is longer than its element is tall begins at the top, and can be scrolled', async () => {
  const small = await browser.context.newPage();
  await small.goto(`${site.address}/empty`);
  await small.evaluate(() => {
    const element = document.createElement('surface-path');
    element.setAttribute('surface', 'nowhere');
    element.style.width = '140px';
    document.body.append(element);
  });
  await small.waitForFunction(() => document.querySelector('surface-path')?.shadowRoot?.textContent);
  const place = await small.$eval('surface-path', (element) => {
    const text = /** @type {Element} */ (element.shadowRoot?.querySelector('p'));
    return {
      above: text.getBoundingClientRect().top - element.getBoundingClientRect().top,
      x: 40,
      y: element.getBoundingClientRect().top + 50,
    };
  });
  assert.ok(place.above >= 0, `${-place.above} pixels are cut off`);
  await small.mouse.move(place.x, place.y);
  await small.mouse.wheel(0, 1000);
  await small.waitForFunction(() => {
    const {
      scrollTop = 0,
      scrollHeight = 0,
      clientHeight = 0,
    } = document.querySelector('surface-path')?.shadowRoot?.querySelector('p') ?? {};
    return scrollTop > 0 && scrollTop + clientHeight >= scrollHeight - 1;
  });
  await small.close();
});

test('a look that is wrong is said, and what is right again mends it', async () => {
  for (const [name, wrong, right] of [
    ['colour', 'blue', 'none'],
    ['resolution', 'abc', '48'],
    ['camera', '0,0,0', '1,-1,1'],
  ]) {
    const [, type, message] = await change('torus', name, wrong);
    assert.deepEqual([type, message.includes(`surface-path: ${name} must be`)], ['error', true], message);
    assert.match((await words('torus')) ?? '', new RegExp(name));
    await page.$eval('#torus', (element, [key, text]) => element.setAttribute(key, text), [name, right]);
    await page.waitForFunction(() => /^Length/.test(document.querySelector('#torus')?.shadowRoot?.querySelector('p')?.textContent ?? ''));
  }
  await page.$eval('#torus', (element) => {
    for (const name of ['colour', 'resolution', 'camera']) element.removeAttribute(name);
  });
});

test('where there is no surface it says so; an end that is nowhere is no reason not to draw the others', async () => {
  const { page: other, complaints: said } = await openPage(browser.context, `${site.address}/empty`);
  const looks = await other.evaluate(async () => {
    await customElements.whenDefined('surface-path');
    const looks = [];
    for (const attributes of [
      { f: 'x^2 + y^2 + z^2 - 9', bounds: '-1,1' },
      { z: 'sqrt(x)', x: '-1,1', y: '-1,1', from: '-0.5,0', to: '0.5,0' },
    ]) {
      const element = document.createElement('surface-path');
      Object.assign(element.style, { width: '200px', height: '150px' });
      for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
      document.querySelector('main')?.append(element);
      await new Promise((resolve) => setTimeout(resolve, 600));
      const canvas = element.shadowRoot?.querySelector('canvas');
      const drawing = new OffscreenCanvas(200, 150).getContext('2d');
      drawing?.drawImage(/** @type {HTMLCanvasElement} */ (canvas), 0, 0, 200, 150);
      const data = drawing?.getImageData(0, 0, 200, 150).data ?? [];
      looks.push([element.shadowRoot?.querySelector('p')?.textContent, Array.from(data).some((x, i) => i % 4 === 3 && x > 0)]);
      element.remove();
    }
    return looks;
  });
  assert.deepEqual(looks, [
    ['surface-path: nothing to draw: inside its bounds f is nowhere zero, or formulas have no value', false],
    ['No path: the formula has no value on the way.', true],
  ]);
  assert.deepEqual(said, []);
  await other.close();
});

test('it can be looked at from straight above', async () => {
  await page.$eval('#torus', (element) => element.setAttribute('camera', '0,0,1'));
  await nextFrame(page);
  assert.ok((await warmth('torus')) > 100);
  await page.$eval('#torus', (element) => element.removeAttribute('camera'));
});

describe('with controls', () => {
  const handle = () => page.locator('#torus').getByRole('button', { name: 'End of the path' });

  test('an end is dragged, and each path is told', async () => {
    await nextFrame(page);
    const box = await handle().boundingBox();
    assert.ok(box);
    const before = await page.evaluate(() => /** @type {any} */ (window).seen.events.length);
    const to = await page.$eval('#torus', (element) => /** @type {any} */ (element).to);
    await page.mouse.move(box.x + 12, box.y + 12);
    await page.mouse.down();
    await page.mouse.move(box.x + 42, box.y + 22, { steps: 5 });
    await page.mouse.up();
    await nextFrame(page);
    const events = await page.evaluate((count) => /** @type {any} */ (window).seen.events.slice(count), before);
    assert.ok(events.length >= 5 && events.every((/** @type {any[]} */ [id, type]) => id === 'torus' && type === 'path'));
    assert.notDeepEqual(await page.$eval('#torus', (element) => /** @type {any} */ (element).to), to);
    const moved = await handle().boundingBox();
    assert.ok(moved && Math.abs(moved.x - box.x - 30) < 1.5 && Math.abs(moved.y - box.y - 10) < 1.5);
  });

  test('where it was dragged it stays, whatever else changes, until another place or surface is asked for', async () => {
    const to = () => page.$eval('#torus', (element) => /** @type {any} */ (element).to);
    const dragged = await to();
    await change('torus', 'parameters', 'a=1.4');
    await change('torus', 'points', '20');
    await change('torus', 'from', '0.5,0.7');
    await change('torus', 'density', '1 + 0.1u');
    await change('torus', 'periodic', 'v');
    assert.deepEqual(await to(), dragged);
    await page.$eval('#torus', (element) => element.parentElement?.prepend(element));
    await nextFrame(page);
    assert.deepEqual(await to(), dragged);
    for (const [name, value] of [
      ['parameters', null],
      ['points', null],
      ['density', ''], // empty is absent
      ['periodic', ''],
      ['from', '0.5,0.6'],
    ])
      await change('torus', String(name), value);
    const asked = await page.$eval('#torus', (element) => {
      const torus = /** @type {any} */ (element);
      torus.to = torus.getAttribute('to');
      return torus.getAttribute('to');
    });
    await page.waitForFunction((text) => String(/** @type {any} */ (document.querySelector('#torus')).to) === text, asked);
  });

  test('where it was dragged it stays while formulas change that have such a place; else it is where it was asked for', async () => {
    const ends = await page.$eval('#torus', async (element) => {
      const torus = /** @type {any} */ (element);
      const held = { surface: torus.getAttribute('surface'), from: torus.getAttribute('from'), to: torus.getAttribute('to') };
      const set = (/** @type {Record<string, string | null>} */ values) => {
        for (const [name, value] of Object.entries(values))
          if (value === null) torus.removeAttribute(name);
          else torus.setAttribute(name, value);
        return new Promise((resolve) => torus.addEventListener('path', () => setTimeout(() => resolve(torus.to), 100), { once: true }));
      };
      await set({ surface: null, x: 'u', y: 'v', z: '0', u: '-1,1', v: '-1,1', from: '-0.5,0', to: '0.5,0.1' });
      const button = torus.shadowRoot.querySelector('[aria-label="End of the path"]');
      button.dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowRight', shiftKey: true }));
      const seen = [torus.to, await set({ z: 'u v' }), await set({ z: '0' }), await set({ u: '-1,0.51' })];
      const none = { x: null, y: null, z: null, u: null, v: null };
      await set({ ...none, ...held });
      return seen;
    });
    assert.ok(ends[0][0] > 0.52, 'it was moved');
    assert.deepEqual([ends[1], ends.at(-1)], [ends[0], [0.5, 0.1]]);
  });

  test('set anew to the same place it computes nothing, set to null it is not asked for, as frameworks do', async () => {
    const said = await page.$eval('#torus', async (element) => {
      const torus = /** @type {any} */ (element);
      const text = torus.getAttribute('to');
      let paths = 0;
      torus.addEventListener('path', () => paths++);
      const later = () => new Promise((resolve) => setTimeout(resolve, 300));
      const { to } = torus;
      torus.to = to;
      await later();
      const again = paths;
      torus.to = null;
      const isThere = torus.hasAttribute('to');
      torus.to = text;
      await later();
      return { again, isThere, paths, isBack: torus.getAttribute('to') === text && torus.path.converged };
    });
    assert.deepEqual(said, { again: 0, isThere: false, paths: 1, isBack: true });
  });

  test('while the surface is none, nothing can be dragged on the last one', async () => {
    assert.equal((await change('torus', 'surface', 'nope'))[1], 'error');
    assert.equal(await handle().count(), 0);
    assert.equal((await change('torus', 'surface', 'parametricTorus'))[1], 'path');
    await handle().waitFor();
  });

  test('and an end that is nowhere is said, and leaves no handles behind', async () => {
    const definition = { kind: 'graph', z: 'sqrt(1 - x^2 - y^2)', x: [-1, 1], y: [-1, 1] };
    const counts = await page.$eval(
      '#torus',
      async (element, given) => {
        const torus = /** @type {any} */ (element);
        const later = () => new Promise((resolve) => setTimeout(resolve, 200));
        const held = { definition: torus.definition, from: torus.getAttribute('from'), to: torus.getAttribute('to') };
        const buttons = [];
        torus.definition = given;
        torus.setAttribute('from', '0,0');
        for (const to of ['0.9,0.9', '0.95,0.95', '0.5,0.5']) {
          torus.setAttribute('to', to);
          await later();
          buttons.push(torus.shadowRoot.querySelectorAll('button').length);
        }
        torus.definition = null;
        torus.setAttribute('from', held.from);
        torus.setAttribute('to', held.to);
        await later();
        return [...buttons, torus.shadowRoot.querySelectorAll('button').length];
      },
      definition,
    );
    assert.deepEqual(counts, [0, 0, 2, 2]);
  });

  test('and moved by keys; the other element has no handles', async () => {
    await handle().focus();
    const length = (await lastEvent())[2];
    await page.keyboard.press('ArrowLeft');
    assert.notEqual((await lastEvent())[2], length);
    assert.equal(await page.locator('#hill').getByRole('button').count(), 0);
  });

  test('colours are distances from where the start is let go', async () => {
    const colour = (/** @type {string} */ name) => page.$eval('#torus', (element, value) => element.setAttribute('colour', value), name);
    const picture = async () => {
      await page.waitForTimeout(500);
      return page.locator('#torus').screenshot();
    };
    const start = page.locator('#torus').getByRole('button', { name: 'Start of the path' });
    await colour('distance');
    for (const move of [
      () => Promise.all(Array.from({ length: 4 }, () => start.press('ArrowLeft'))),
      async () => {
        const { x, y } = /** @type {{ x: number, y: number }} */ (await start.boundingBox());
        await page.mouse.move(x + 12, y + 12);
        await page.mouse.down();
        await page.mouse.move(x + 42, y + 12, { steps: 3 });
        await page.mouse.up();
        await page.mouse.move(0, 0);
      },
    ]) {
      await move();
      const moved = await picture();
      await colour('none');
      await nextFrame(page);
      await colour('distance');
      const changed = await countDifferent(page, moved, await picture());
      assert.ok(changed < 20, `${changed} pixels`);
    }
    await colour('none');
    await nextFrame(page);
  });

  test('the view is turned by keys, and comes nearer; the other element is no stop of the tabulator', async () => {
    const picture = () => page.locator('#torus').screenshot();
    const canvas = (/** @type {string} */ id) => page.locator(`#${id} canvas`);
    await canvas('torus').focus();
    for (const key of ['ArrowRight', 'ArrowDown', '+']) {
      const before = await picture();
      await page.keyboard.press(key);
      await nextFrame(page);
      const changed = await countDifferent(page, before, await picture());
      assert.ok(changed > 300, `${key}: ${changed} pixels`);
    }
    for (const key of ['-', 'ArrowUp', 'ArrowLeft']) await page.keyboard.press(key);
    assert.equal(await canvas('hill').getAttribute('tabindex'), null);
  });
});

test('a parameter that changes moves what is there: no new shaders, no new surface, the same handles, the focus where it is', async () => {
  const handle = page.locator('#torus').getByRole('button', { name: 'End of the path' });
  await change('torus', 'to', '2.6,1.2');
  await handle.focus();
  const before = await page.evaluate(() => /** @type {any} */ (window).seen.programs);
  assert.ok(before > 0);
  const [, , first] = await lastEvent();
  for (const a of ['1.2', '1.3', '1.4']) assert.ok((await change('torus', 'parameters', `a=${a}`))[2] < first);
  assert.equal(await page.evaluate(() => /** @type {any} */ (window).seen.programs), before);
  const focused = await page.$eval('#torus', (element) => element.shadowRoot?.activeElement?.getAttribute('aria-label') ?? null);
  assert.match(focused ?? '', /^End of the path/);
  assert.equal((await change('torus', 'parameters', null))[2], first);
});

test('the path is seen to converge, once, unless less motion is asked for', async () => {
  /** Pictures that a change takes, until none has come for a while. @param {() => Promise<any>} doing */
  const drawn = async (doing) => {
    const before = await pictures();
    await doing();
    for (let last = -1; last !== (await pictures()); await page.waitForTimeout(1000)) last = await pictures();
    return (await pictures()) - before;
  };
  const still = await drawn(() => page.$eval('#hill', (element) => element.setAttribute('animate', '')));
  assert.ok(still <= 2, `${still} pictures`);
  await page.emulateMedia({ reducedMotion: 'no-preference' });
  const played = await drawn(() => change('hill', 'to', '0.8,0.15'));
  // It takes a second, in which a machine that draws in software, and is busy, draws few.
  assert.ok(played > still + 1, `${played} pictures, ${still} without motion`);
  await page.emulateMedia({ reducedMotion: 'reduce' });
});

test('it follows the theme of the reader and the colours of the page', async () => {
  for (const colorScheme of /** @type {const} */ (['dark', 'light'])) {
    await page.emulateMedia({ colorScheme });
    await nextFrame(page);
    await page.screenshot({ path: `${SCREENSHOTS}element-${colorScheme}.png` });
    assert.ok((await warmth('torus')) > 60);
  }
  const warm = [];
  // Also in notations that three.js does not read.
  for (const colour of [
    '#0000ff',
    'color(srgb 1 0.25 0)',
    'hsl(240 100% 50%)',
    'color-mix(in srgb, #f40 95%, red)',
    '#0000ff',
    '#ff4000cc',
    '#0000ff',
  ]) {
    await page.evaluate((line) => document.documentElement.style.setProperty('--surfpath-line', line), colour);
    await page.waitForTimeout(50);
    await nextFrame(page);
    warm.push((await warmth('torus')) > 60);
  }
  assert.deepEqual(warm, [false, true, false, true, false, true, false]);
});

test('on a screen with finer pixels it is drawn with these', async () => {
  const pixels = () =>
    page.$eval('#torus', (element) => /** @type {HTMLCanvasElement} */ (element.shadowRoot?.querySelector('canvas'))?.width);
  const session = await browser.context.newCDPSession(page);
  const widths = [];
  for (const deviceScaleFactor of [2, 1.5]) {
    // Chromium tells of no other pixels where the window, too, stays the same.
    const width = 1040 - 4 * deviceScaleFactor;
    await session.send('Emulation.setDeviceMetricsOverride', { width, height: 640, deviceScaleFactor, mobile: false });
    await nextFrame(page);
    widths.push(await pixels());
  }
  await session.send('Emulation.clearDeviceMetricsOverride');
  await session.detach();
  assert.deepEqual(widths, [800, 600]);
});

test('many on a page take turns: between two of them the browser is at hand', async () => {
  const many = await browser.context.newPage();
  await many.addInitScript(() => {
    const { port1, port2 } = new MessageChannel();
    let tasks = 0;
    port1.onmessage = () => {
      tasks++;
      if (/** @type {any} */ (window).seen.events.length < 6) port2.postMessage(null);
    };
    port2.postMessage(null);
    /** @type {number[]} */ const turns = [];
    addEventListener('path', () => turns.push(tasks), true);
    Object.assign(window, { turns });
  });
  await many.goto(`${site.address}/many`);
  await many.waitForFunction(() => /** @type {any} */ (window).seen.events.length === 6);
  const turns = /** @type {number[]} */ (await many.evaluate(() => /** @type {any} */ (window).turns));
  assert.equal(new Set(turns).size, 6, `in tasks ${turns}`);
  await many.close();
});

test('removed elements leave nothing behind: no context, no element', async () => {
  const own = await openBrowser([], COARSE);
  await own.context.addInitScript(watch);
  const { page: other } = await openPage(own.context, `${site.address}/empty`);
  await other.waitForFunction(() => customElements.get('surface-path'));
  const drawn = await other.evaluate(async () => {
    const { seen } = /** @type {any} */ (window);
    const main = /** @type {HTMLElement} */ (document.querySelector('main'));
    seen.elements = [];
    for (let turn = 0; turn < 4; turn++) {
      const before = seen.pictures;
      for (const name of ['saddle', 'sphere', 'bumpy']) {
        const element = document.createElement('surface-path');
        element.setAttribute('surface', name);
        element.toggleAttribute('controls', name === 'saddle');
        Object.assign(element.style, { width: '200px' });
        main.append(element);
        seen.elements.push(new WeakRef(element));
      }
      while (seen.pictures < before + 3) await new Promise(requestAnimationFrame);
      main.replaceChildren();
    }
    return seen.contexts.length;
  });
  assert.equal(drawn, 4, 'a context each time that elements come back');
  const session = await other.context().newCDPSession(other);
  const countLeft = async () => {
    await session.send('HeapProfiler.collectGarbage');
    return other.evaluate(() => {
      const { contexts, elements } = /** @type {any} */ (window).seen;
      return [
        contexts.filter((/** @type {any} */ context) => !context.isContextLost()).length,
        elements.filter((/** @type {WeakRef<Element>} */ element) => element.deref()).length,
      ];
    });
  };
  let left = await countLeft();
  // An engine that compiles beside may hold what it saw for a while: a leak is what never goes.
  for (let turn = 0; turn < 50 && left.some(Boolean); turn++) left = await countLeft();
  await own.close();
  assert.deepEqual(left, [0, 0]);
});

test('removed while the browser has taken its context, it complains of nothing', async () => {
  const own = await openBrowser([], COARSE);
  await own.context.addInitScript(watch);
  const { page: other, complaints: said } = await openPage(own.context, `${site.address}/empty`);
  await other.evaluate(async () => {
    const { seen } = /** @type {any} */ (window);
    await customElements.whenDefined('surface-path');
    const element = document.createElement('surface-path');
    element.setAttribute('surface', 'saddle');
    document.querySelector('main')?.append(element);
    while (seen.pictures === 0) await new Promise(requestAnimationFrame);
    const [context] = seen.contexts;
    const lost = new Promise((resolve) => context.canvas.addEventListener('webglcontextlost', resolve));
    context.getExtension('WEBGL_lose_context').loseContext();
    await lost;
    element.remove();
  });
  await own.close();
  assert.deepEqual(said, []);
});

test('moved in the page it goes on', async () => {
  const before = await page.evaluate(() => /** @type {any} */ (window).seen.events.length);
  await page.$eval('#hill', (element) => element.parentElement?.prepend(element));
  await page.waitForFunction((count) => /** @type {any} */ (window).seen.events.length > count, before);
  await nextFrame(page);
  assert.equal((await lastEvent())[1], 'path');
});

test('moved to another document, and back, it looks as before', async () => {
  const before = await page.locator('#hill').screenshot();
  const styles = await page.$eval('#hill', async (element) => {
    const { seen } = /** @type {any} */ (window);
    const home = /** @type {Element} */ (element.parentElement);
    const frame = document.createElement('iframe');
    Object.assign(frame.style, { position: 'fixed', inset: '0', width: '420px', height: '320px' });
    document.body.append(frame);
    const drawn = async (/** @type {Element} */ place) => {
      const pictures = seen.pictures;
      place.prepend(element);
      while (seen.pictures === pictures) await new Promise(requestAnimationFrame);
      const { display, position, height } = getComputedStyle(element);
      return [display, position, height, getComputedStyle(/** @type {Element} */ (element.shadowRoot?.querySelector('p'))).position];
    };
    const there = await drawn(/** @type {Document} */ (frame.contentDocument).body);
    const back = await drawn(home);
    frame.remove();
    return [there, back];
  });
  for (const style of styles) assert.deepEqual(style, ['block', 'relative', '300px', 'absolute']);
  await nextFrame(page);
  assert.equal(await countDifferent(page, before, await page.locator('#hill').screenshot()), 0);
});

test('properties set before the element is defined, and those that have the names of attributes, as React sets them', async () => {
  const late = await browser.context.newPage();
  await late.goto(`${site.address}/late`);
  const answer = await late.evaluate(async () => {
    const [plain, sweep] = /** @type {any[]} */ ([...document.querySelectorAll('surface-path')]);
    Object.assign(plain, { definition: { kind: 'graph', z: 'x*y', x: [-1, 1], y: [-1, 1] }, from: [-1, 0], to: [1, 0.5], animate: true });
    sweep.path = '5cos(t);5sin(t);t';
    const both = [plain, sweep].map((element) => new Promise((resolve) => element.addEventListener('path', resolve, { once: true })));
    // @ts-expect-error a file of the page's
    await import('/dist/element.js');
    const [length] = (await Promise.all(both)).map(({ detail }) => detail.length);
    plain.animate = false;
    return [
      ...[length === plain.path.length, plain.hasAttribute('animate'), typeof plain.animate, Object.keys(plain).length],
      ...[sweep.getAttribute('path'), sweep.path.converged],
    ];
  });
  await late.close();
  assert.deepEqual(answer, [true, false, 'function', 0, '5cos(t);5sin(t);t', true]);
});

test('the tabulator goes from the start to the end', async () => {
  const labels = await page.$eval('#torus', (element) =>
    Array.from(element.shadowRoot?.querySelectorAll('button') ?? [], (button) => button.getAttribute('aria-label')),
  );
  assert.deepEqual(labels, ['Start of the path', 'End of the path']);
});

test('a wheel on its way past scrolls the page; pressed before, it turns the view larger; a finger scrolls, too', async () => {
  await page.evaluate(() => scrollTo(0, 0));
  await page.$eval('#torus', (element) => element.scrollIntoView());
  const box = await page.locator('#torus').boundingBox();
  assert.ok(box);
  const wheel = async () => {
    const from = await page.evaluate(() => scrollY);
    await page.mouse.wheel(0, 60);
    await page.waitForTimeout(300);
    return (await page.evaluate(() => scrollY)) - from;
  };
  await page.mouse.move(box.x + 20, box.y + 40);
  assert.ok((await wheel()) > 0);
  await page.evaluate(() => scrollBy(0, -60));
  await page.mouse.click(box.x + 20, box.y + 40);
  assert.equal(await wheel(), 0);
  await page.mouse.move(0, 0);
  assert.equal(
    await page.$eval(
      '#torus',
      (element) => getComputedStyle(/** @type {Element} */ (element.shadowRoot?.querySelector('canvas'))).touchAction,
    ),
    'pan-y',
  );
});

test('what was never on screen is printed', async () => {
  const printed = await browser.context.newPage();
  await printed.goto(`${site.address}/page`);
  await printed.$eval('#spacer', (element) => {
    element.setAttribute('style', 'height: 3000px');
    scrollTo(0, 0);
  });
  await printed.waitForFunction(() => /** @type {any} */ (window).seen.events.length >= 3);
  await nextFrame(printed);
  const isDrawn = () =>
    printed.$eval('#far', (element) => {
      const canvas = /** @type {HTMLCanvasElement} */ (element.shadowRoot?.querySelector('canvas'));
      const context = canvas.getContext('2d');
      return context?.getImageData(0, 0, canvas.width, canvas.height).data.some((x) => x > 0);
    });
  const before = await isDrawn();
  await printed.evaluate(() => dispatchEvent(new Event('beforeprint')));
  assert.deepEqual([before, await isDrawn()], [false, true]);
  await printed.close();
});

test('the console stayed silent', () => {
  assert.deepEqual(complaints, []);
});

test('without WebGL it says the length, and that there is no picture', async () => {
  const other = await openBrowser(['--disable-3d-apis']);
  try {
    const { page: plain } = await openPage(other.context, `${site.address}/page`);
    await plain.waitForFunction(() => /picture/.test(document.querySelector('#torus')?.shadowRoot?.textContent ?? ''));
    assert.match(
      (await plain.$eval('#torus', (element) => element.shadowRoot?.textContent)) ?? '',
      /^Length 8\.8198\. No picture: .*WebGL/,
    );
  } finally {
    await other.close();
  }
});

test('without WebAssembly it says so', async () => {
  const own = await openBrowser([], COARSE);
  const plain = await own.context.newPage();
  await plain.addInitScript(() => {
    // @ts-expect-error a browser without it
    delete window.WebAssembly;
  });
  await plain.goto(`${site.address}/page`);
  await plain.waitForFunction(() => /WebAssembly/.test(document.querySelector('#torus')?.shadowRoot?.textContent ?? ''));
  await own.close();
});

for (const [title, name] of Object.entries(RELEASES))
  test(`the page of README.md shows both of its elements, ${title} of three.js`, async () => {
    const readme = await readFile(new URL('../../README.md', import.meta.url), 'utf8');
    const html = [...readme.matchAll(/^```html\n(.*?)^```$/gms)].map(([, text]) => text).find((text) => text.includes('<surface-path'));
    assert.ok(html);
    const served = await serveSite({ 'page.html': html.replaceAll('node_modules/three/', `node_modules/${name}/`) });
    const other = await openBrowser([], COARSE);
    try {
      const { page: opened, complaints: said } = await openPage(other.context, `${served.address}/page.html`);
      const texts = () => opened.$$eval('surface-path', (elements) => elements.map((element) => element.shadowRoot?.textContent));
      await opened.waitForFunction(() =>
        [...document.querySelectorAll('surface-path')].every((element) => element.shadowRoot?.textContent),
      );
      assert.deepEqual(await texts(), ['Length 8.8198', 'Length 1.9402']);
      await nextFrame(opened);
      const { warm } = await measurePicture(opened, await opened.locator('surface-path').first().screenshot());
      assert.ok(warm > 60, `only ${warm} pixels of the path are seen`);
      assert.deepEqual(said, []);
    } finally {
      await other.close();
      await served.close();
    }
  });
