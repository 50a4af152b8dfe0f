// What is taken away from the page opens elsewhere and holds what is shown: links, pictures, tables, models.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { after, before, describe, test } from 'node:test';
import { fromHash, toHash, viewIn } from '../../demo/state/link.js';
import { sketchOf } from '../../demo/state/sketch.js';
import { COARSE, hashOf, openBrowser, openEntry, openSettled, openSketch, settled } from '../helpers/page.js';

/** @type {Awaited<ReturnType<typeof openBrowser>>} */ let browser;
/** @type {import('playwright-core').Page} */ let page;
/** @type {string[]} */ let complaints;

before(async () => {
  ({ browser, page, complaints } = await openSettled([], COARSE));
});
after(() => browser?.close());

const text = async (/** @type {string} */ selector) => (await page.textContent(selector)) ?? '';

/** @param {string} name of the button @returns {Promise<Buffer>} the file that it saves */
async function take(name) {
  const saved = page.waitForEvent('download');
  await page.click(`[data-export=${name}]`);
  return readFile(await (await saved).path());
}

/** Opens an address as a new page, in the same tab: beside another tab the browser may not draw, on which the page waits. @param {string} address */
async function open(address) {
  await page.goto('about:blank');
  await page.goto(address);
  await settled(page);
}

test('a link holds the whole state: another page that opens it shows the same', async () => {
  await openEntry(page, 'parametricTorus');
  await page.fill('#value-a', '1.2');
  await page.fill('#end-0-0', '1.25');
  await page.selectOption('#algorithm', 'polyline');
  await page.fill('#points', '33');
  await page.fill('#field-z', 'a*sin(v)+0.2*cos(3*u)');
  await page.waitForTimeout(600);
  await settled(page);
  await page.click('[data-export=link]');
  const link = page.url();
  const shown = async () => [
    ...(await Promise.all(['#length', '#iterations', '#entry-title'].map(text))),
    ...(await Promise.all(['#value-a', '#end-0-0', '#points', '#algorithm', '#field-z'].map((id) => page.inputValue(id)))),
  ];
  const expected = await shown();
  await open(link);
  assert.deepEqual(await shown(), expected);
});

describe('a link holds the view', () => {
  const place = () =>
    page.evaluate(() => {
      const { camera, controls } = /** @type {any} */ (window).surfpathView;
      return [camera.position.clone().sub(controls.target), controls.target].flatMap((vector) => vector.toArray());
    });
  /** The address is written once the view rests: where keys come late, more than once. @param {string} key */
  async function press(key) {
    const before = page.url();
    await page.focus('#canvas');
    for (let i = 0; i < 4; i++) await page.keyboard.press(key);
    await page.waitForURL((url) => url.href !== before);
    const state = async () => `${page.url()} ${await place()}`;
    for (let last = ''; last !== (await state()); await page.waitForTimeout(1000)) last = await state();
  }
  for (const [title, key] of [
    ['turned', 'ArrowLeft'],
    ['near', '+'],
  ])
    test(title, async () => {
      await openEntry(page, 'parametricTorus');
      const [before, first] = [page.url(), await place()];
      await press(key);
      const expected = await place();
      await open(page.url());
      const found = await place();
      // Of the degrees, and radii of 5.5, two digits are kept; what is only turned is fitted from its side.
      const within = (/** @type {number} */ i) => (i < 3 || key === '+' ? 0.03 : 0.5);
      for (const [i, x] of found.entries()) assert.ok(Math.abs(x - expected[i]) < within(i), `${found}, not ${expected}`);
      assert.ok(Math.hypot(...first.map((x, i) => x - expected[i])) > 1);
      await page.click('#reframe');
      await page.waitForURL(before);
    });

  test('but not whence another surface was looked at, and there is nothing to undo', async () => {
    await openEntry(page, 'vase');
    const vase = page.url();
    await press('ArrowLeft');
    // While the vase still turns.
    for (let i = 0; i < 4; i++) await page.keyboard.press('ArrowLeft');
    await openEntry(page, 'parametricTorus');
    assert.deepEqual(await page.evaluate(() => /** @type {any} */ (window).surfpathView.view), []);
    await page.click('#undo');
    await settled(page);
    assert.equal(await text('#entry-title'), 'Vase');
    await page.waitForURL(vase);
  });

  test('what is no view is none', () => {
    for (const view of [null, 'up', [1], [1, 2, 3], ['x', 0], [1e9, 0], [Number.NaN, 1], {}])
      assert.deepEqual(viewIn(hashOf({ entry: 'vase', view })), [], String(view));
    assert.deepEqual(viewIn('#junk'), []);
    assert.deepEqual(viewIn(toHash(sketchOf('vase'), [10, 20.5])), [10, 20.5]);
  });
});

test('Back and Forward lead from surface to surface and from measure to measure, not through what was changed on them', async () => {
  const a = () => page.inputValue('#end-0-0');
  const title = () => text('#entry-title');
  const density = () => page.inputValue('#field-density');
  const go = async (/** @type {'goBack' | 'goForward'} */ way) => {
    const heard = page.evaluate(() => new Promise((resolve) => addEventListener('hashchange', () => resolve(true), { once: true })));
    await page[way]();
    await heard;
    await settled(page);
  };
  await openEntry(page, 'own-graph');
  const first = await title();
  for (const x of ['-1.5', '-1.25']) {
    await page.fill('#end-0-0', x);
    await page.waitForTimeout(600);
  }
  await page.fill('#end-0-0', '-1');
  // At once: what was changed last has not been written yet.
  await page.evaluate(() => /** @type {HTMLElement} */ (document.querySelector('input[name=kind][value=sweep]')).click());
  await settled(page);
  const second = await title();
  assert.notEqual(second, first);
  await page.evaluate(() => /** @type {HTMLElement} */ (document.querySelector('[data-preset=bump]')).click());
  await settled(page);
  assert.notEqual(await density(), '');
  await go('goBack');
  assert.equal(await density(), '');
  assert.equal(await title(), second);
  await go('goBack');
  assert.equal(await title(), first);
  assert.equal(await a(), '-1');
  await go('goForward');
  assert.equal(await title(), second);
  // The page's own undo takes the step back, too.
  await page.click('#undo');
  await settled(page);
  assert.equal(await title(), first);
  assert.equal(await a(), '-1');
  assert.deepEqual(complaints, []);
});

test('who loads the page anew right after a change has not lost it', async () => {
  await openEntry(page, 'parametricTorus');
  // What opening it had to write is written.
  await page.waitForTimeout(600);
  await page.fill('#end-0-0', '1.25');
  await page.fill('#end-1-0', '4.5');
  await page.reload();
  await settled(page);
  assert.deepEqual([await page.inputValue('#end-0-0'), await page.inputValue('#end-1-0')], ['1.25', '4.5']);
});

test('the address is rewritten less often than browsers allow, and holds the last change soon', async () => {
  await openEntry(page, 'parametricTorus');
  const count = await page.evaluate(async () => {
    const { replaceState } = History.prototype;
    let calls = 0;
    window.history.replaceState = (...given) => {
      calls++;
      return replaceState.apply(window.history, given);
    };
    const input = /** @type {HTMLInputElement} */ (document.getElementById('end-0-0'));
    const end = performance.now() + 2000;
    for (let i = 0; performance.now() < end; i++) {
      input.value = String(1 + (i % 100) / 100);
      input.dispatchEvent(new Event('input', { bubbles: true }));
      await new Promise((resolve) => setTimeout(resolve, 10));
    }
    input.value = '2.5';
    input.dispatchEvent(new Event('input', { bubbles: true }));
    await new Promise((resolve) => setTimeout(resolve, 500));
    delete (/** @type {any} */ (window.history).replaceState);
    return calls;
  });
  // 20 in a row, then one in 0.4 s.
  assert.ok(count <= 20 + 7, `${count} times in 2.5 s`);
  assert.equal(fromHash(await page.evaluate(() => location.hash))?.ends[0][0], 2.5);
  await settled(page);
});

test('every sketch comes back from its link', () => {
  const implicit = sketchOf('own-implicit');
  const longest = 'ξ'.repeat(4096);
  const long = {
    ...implicit,
    texts: { ...implicit.texts, f: longest },
    density: longest,
    tensor: Array.from({ length: 6 }, () => longest),
    parameters: Object.fromEntries(Array.from({ length: 40 }, (_, i) => [`of_quite_a_long_name_k₁_${i}`, i])),
  };
  assert.deepEqual(fromHash(toHash(long)), long);
  const sketch = {
    ...sketchOf('own-implicit'),
    density: '1+x^2',
    colour: /** @type {const} */ ('density'),
    via: [[0, 1, 0.2]],
    points: 12,
  };
  assert.deepEqual(fromHash(toHash(sketch)), sketch);
  const tooLong = { ...sketchOf('saddle'), texts: { ...sketchOf('saddle').texts, z: 'u+'.repeat(2500) } };
  assert.deepEqual(fromHash(toHash(tooLong)), tooLong, 'and is complained of as when it was written');
  const lessOne = { ...sketchOf('parametricTorus'), parameters: { R: 4 } };
  assert.deepEqual(fromHash(toHash(lessOne)), lessOne, 'without a slider that was removed');
});

test('a link with points on the way and several starts has what is computed of them', () => {
  assert.equal(fromHash(hashOf({ entry: 'saddle', via: [[0, 0]], start: 'several' }))?.start, 'straight');
  assert.equal(fromHash(hashOf({ entry: 'saddle', start: 'several' }))?.start, 'several');
});

test('a link of another version, or junk, is refused or repaired, never believed', () => {
  for (const junk of ['', '#', '#1', '#1.', '#2.e30', '#1.%%%', '#1.bm9uc2Vuc2U', hashOf(null), hashOf([]), hashOf({ entry: '__proto__' })])
    assert.equal(fromHash(junk), null, junk);
  const repaired = fromHash(
    hashOf({
      entry: 'saddle',
      texts: { z: 7, nothing: 'x' },
      parameters: { __proto__: 1, 'a b': 2, k: 'x' },
      ends: [
        ['a', 0],
        [0.1, 0.2, 0.3],
      ],
      algorithm: 'magic',
      points: 1e9,
      tolerance: -1,
      via: [[NaN, 1]],
      tensor: ['1'],
    }),
  );
  assert.deepEqual(repaired, sketchOf('saddle'));
});

test('a page with a link of junk opens the first scene and says so on every screen; the link stays until something is changed', async () => {
  await open(`${browser.address}#1.junk`);
  assert.equal(await text('#entry-title'), 'Torus, parametric');
  for (const width of [360, 1040]) {
    await page.setViewportSize({ width, height: 640 });
    assert.match(await page.innerText('#advice'), /could not be read/);
  }
  await page.waitForTimeout(600);
  assert.equal(new URL(page.url()).hash, '#1.junk');
  await page.fill('#points', '32');
  await page.waitForTimeout(600);
  await settled(page);
  assert.doesNotMatch(await text('#advice'), /could not be read/);
  assert.equal(fromHash(new URL(page.url()).hash)?.points, 32);
});

test('the geodesic that is looked at comes back from its link', async () => {
  await openEntry(page, 'parametricTorus');
  await page.check('[name=task][value=all]');
  await page.waitForTimeout(100);
  await settled(page);
  await page.click('#paths li:nth-child(3) button');
  const shown = await text('#length');
  await page.waitForTimeout(600);
  await open(page.url());
  assert.equal(await text('#length'), shown);
  assert.equal(await page.getAttribute('#paths li:nth-child(3) button', 'aria-pressed'), 'true');
});

test('that a link was copied is told until something changes', async () => {
  await openEntry(page, 'parametricTorus');
  await page.click('[data-export=link]');
  await page.waitForFunction(() => /link/.test(document.getElementById('export-words')?.textContent ?? ''));
  await page.fill('#points', '40');
  await page.waitForTimeout(100);
  await settled(page);
  assert.equal(await text('#export-words'), '');
});

describe('exports', () => {
  before(() => openEntry(page, 'parametricTorus'));

  test('PNG: the picture that is seen', async () => {
    const png = await take('png');
    assert.equal(png.subarray(1, 4).toString(), 'PNG');
    const canvas = await page.evaluate(() => {
      const { width, height } = /** @type {HTMLCanvasElement} */ (document.getElementById('canvas'));
      return [width, height];
    });
    assert.deepEqual([png.readUInt32BE(16), png.readUInt32BE(20)], canvas);
    assert.ok(png.length > 10_000, 'not an empty picture');
  });

  test('CSV: a line a point, as long as the path', async () => {
    const [head, ...lines] = (await take('csv')).toString().trim().split('\n');
    assert.equal(head, 's,x,y,z,u,v');
    assert.equal(lines.length, 66);
    const numbers = lines.map((line) => line.split(',').map(Number));
    assert.ok(numbers.flat().every(Number.isFinite));
    assert.equal(numbers.at(-1)?.[0], Number(await page.getAttribute('#length', 'data-exact')));
  });

  test('CSV of a graph: x and y once', async () => {
    await openEntry(page, 'own-graph');
    const [head, first] = (await take('csv')).toString().split('\n');
    assert.equal(head, 's,x,y,z');
    assert.deepEqual(first.split(',').slice(0, 3), ['0', '-1.9', '-1.2']);
    await openEntry(page, 'parametricTorus');
  });

  test('CSV: without a path there is none', async () => {
    await page.fill('#end-0-0', '');
    await page.click('[data-export=csv]');
    assert.equal(await text('#export-words'), 'There is no path.');
    await page.click('#undo');
    await page.waitForTimeout(250);
    await settled(page);
  });

  test('JSON: formulas, ends, options and the path', async () => {
    const document = JSON.parse((await take('json')).toString());
    assert.equal(document.surface.x, '(R+a*cos(v))*cos(u)');
    assert.deepEqual(document.surface.parameters, { R: 4, a: 1.5 });
    assert.deepEqual(document.from, [1.77, 1.76]);
    assert.ok(Math.abs(document.path.length - Number.parseFloat(await text('#length'))) < 1e-7);
    assert.equal(document.path.points.length, 3 * 66);
  });

  test('JSON: where a formula is wrong, the surface that is seen; straight ahead, whither and how far', async () => {
    await page.fill('#field-z', 'a*sin(w)');
    await page.waitForSelector('#status[data-old]');
    assert.equal(JSON.parse((await take('json')).toString()).surface.z, 'a*sin(v)');
    await openSketch(page, { entry: 'parametricTorus', task: 'trace', angle: 40, reach: 3 });
    const { angle, reach } = JSON.parse((await take('json')).toString()).options;
    assert.deepEqual([angle, reach], [40, 3]);
    await openEntry(page, 'parametricTorus');
  });

  test('SVG: the plane with the path', async () => {
    const svg = (await take('svg')).toString().replace(/<style>.*<\/style>/s, '');
    const points = await page.evaluate((source) => {
      const parsed = new DOMParser().parseFromString(source, 'image/svg+xml');
      return parsed.querySelector('parsererror') ? '' : (parsed.querySelector('polyline.path')?.getAttribute('points') ?? '');
    }, svg);
    assert.equal(points.split(' ').length, 66);
  });

  test('no SVG where there is no plane, with the reason', async () => {
    const button = page.locator('[data-export=svg]');
    assert.equal(await button.isDisabled(), false);
    await openEntry(page, 'ellipsoid');
    assert.equal(await button.isDisabled(), true);
    assert.match((await button.getAttribute('title')) ?? '', /no parameters/);
    await openEntry(page, 'parametricTorus');
    assert.equal(await button.isDisabled(), false);
    assert.match((await button.getAttribute('title')) ?? '', /plane/);
  });

  test('GLTF: surface and path', async () => {
    const { meshes, nodes, accessors, buffers, asset } = JSON.parse((await take('gltf')).toString());
    assert.equal(asset.version, '2.0');
    assert.equal(meshes.length, 2);
    assert.deepEqual(nodes.flatMap((/** @type {any} */ { name }) => name ?? []).sort(), ['path', 'surface']);
    assert.match(buffers[0].uri, /^data:application\/octet-stream;base64,/);
    assert.ok(
      accessors.some((/** @type {any} */ { count }) => count === 66),
      'the points of the path',
    );
    assert.ok(
      accessors.some((/** @type {any} */ { count }) => count === 97 * 97),
      'the vertices of the surface',
    );
  });

  test('GLTF of terrain in metres of a map: places near to those of their nodes', async () => {
    const range = { 'x-from': '499900', 'x-to': '500100', 'y-from': '4599900', 'y-to': '4600100' };
    const ends = [
      [499920, 4599930],
      [500070, 4600080],
    ];
    await openSketch(page, { entry: 'own-graph', texts: { z: 'x - 500000', ...range }, ends });
    const { nodes, meshes, accessors } = JSON.parse((await take('gltf')).toString());
    for (const [name, middle] of /** @type {[string, number[]][]} */ ([
      ['surface', [500000, 4600000, 0]],
      ['path', [499995, 4600005, -5]],
    ])) {
      const { mesh, matrix } = nodes.find((/** @type {any} */ node) => node.name === name);
      const { min, max } = accessors[meshes[mesh].primitives[0].attributes.POSITION];
      for (const [k, x] of middle.entries())
        assert.ok(Math.abs(matrix[12 + k] - x) < 1e-6 && max[k] <= 100 && Math.abs(min[k] + max[k]) < 1e-3);
    }
  });
});

test('the console stayed silent', () => {
  assert.deepEqual(complaints, []);
});
