// How the page looks: labels that stand apart, a view that follows the surface, colours that are forced, a sheet of paper.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import {
  COARSE,
  countDifferent,
  measurePicture,
  nextFrame,
  openBrowser,
  openEntry,
  openSettled,
  openSketch,
  pictureOfView,
  settled,
} from '../helpers/page.js';

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

  before(async () => {
    await page.check('[name=task][value=all]');
    await page.waitForTimeout(300);
    await settled(page);
  });

  for (const [width, height] of [
    [320, 568],
    [390, 844],
    [640, 360],
    [844, 390],
    [1280, 800],
  ])
    test(`${width} × ${height}: they cover neither each other nor anything else, the shortest is there`, async () => {
      await page.setViewportSize({ width, height });
      await nextFrame(page);
      const found = await boxes();
      assert.ok(found.some(({ name }) => name.startsWith('8.447')));
      for (const [i, { name, box: a }] of found.entries())
        for (const { name: other, box: b } of found.slice(0, i))
          if (/\d\.\d/.test(name + other))
            assert.ok(a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top, `${name} covers ${other}`);
    });
});

test('letters stand beside their points, however large the type is', async () => {
  const session = await browser.context.newCDPSession(page);
  const setType = (/** @type {number} */ standard) => session.send('Page.setFontSizes', { fontSizes: { standard } });
  await page.setViewportSize({ width: 390, height: 844 });
  for (const size of [16, 24]) {
    await setType(size);
    for (const name of ['parametricTorus', 'saddle', 'vase']) {
      await openEntry(page, name);
      await nextFrame(page);
      const gaps = await page.$$eval('.surfpath-handle', (handles) =>
        handles.map((handle) => {
          const [{ x, y, width, height }, letter] = [handle, /** @type {Element} */ (handle.lastElementChild)].map((one) =>
            one.getBoundingClientRect(),
          );
          const [across, down] = [x + width / 2, y + height / 2];
          const beside = Math.max(letter.left - across, across - letter.right, 0);
          return Math.hypot(beside, Math.max(letter.top - down, down - letter.bottom, 0));
        }),
      );
      for (const gap of gaps) assert.ok(gap > 10.5 && gap < 20, `${name}: ${gap} pixels from point to letter`);
    }
  }
  await setType(16);
  await page.setViewportSize({ width: 1040, height: 640 });
});

test('ends at the same place are seen, and both letters beside them', async () => {
  await openSketch(page, { entry: 'saddle', ends: [0, 1].map(() => [0.3, 0.4]) });
  await nextFrame(page);
  const [ball, ...letters] = await page.evaluate(() =>
    ['#handle-A', '#handle-A .letter-tag', '#handle-B .letter-tag'].map((selector) => {
      const { top, bottom } = /** @type {Element} */ (document.querySelector(selector)).getBoundingClientRect();
      return { middle: (top + bottom) / 2, top, bottom };
    }),
  );
  assert.ok(letters[0].bottom < ball.middle - 8 && letters[1].top > ball.middle + 8, JSON.stringify({ ball, letters }));
});

test('letters stand beside what is over the view', async () => {
  for (const [name, width, height] of /** @type {[string, number, number][]} */ ([
    ['ellipsoid', 820, 520],
    ['torus', 1024, 600],
  ])) {
    await page.setViewportSize({ width, height });
    await openEntry(page, name);
    await nextFrame(page);
    const boxes = (/** @type {string} */ selector) =>
      page.$$eval(selector, (elements) => elements.map((element) => element.getBoundingClientRect().toJSON()));
    for (const a of await boxes('.letter-tag'))
      for (const b of await boxes('#legend, #player, .corner'))
        assert.ok(a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top, `${name}: a letter is covered`);
  }
  await page.setViewportSize({ width: 1040, height: 640 });
});

test('letters of points near to each other stand beside each other', async () => {
  await page.setViewportSize({ width: 1280, height: 800 });
  const via = [
    [1, 1],
    [2, 2],
    [3, 3],
  ];
  await openSketch(page, { entry: 'parametricTorus', via });
  await nextFrame(page);
  const boxes = await page.$$eval('.letter-tag', (letters) => letters.map((letter) => letter.getBoundingClientRect().toJSON()));
  assert.equal(boxes.length, 5);
  for (const [i, a] of boxes.entries())
    for (const b of boxes.slice(0, i))
      assert.ok(a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top, 'a letter covers another one');
  await page.setViewportSize({ width: 1040, height: 640 });
});

describe('the view follows a surface that changes its size', () => {
  const doing = async (/** @type {() => Promise<unknown>} */ work) => {
    await work();
    await page.waitForTimeout(300);
    await settled(page);
    await nextFrame(page);
  };
  /** How much of the view's height and width the surface takes, from the middle: at most 1 if it is all seen. */
  const reach = () =>
    page.evaluate(() => {
      const { surface, camera } = /** @type {any} */ (window).surfpathView;
      const points = surface.geometry.getAttribute('position');
      const place = surface.position.clone();
      let most = 0;
      for (let i = 0; i < points.count; i++) {
        place.fromBufferAttribute(points, i).project(camera);
        most = Math.max(most, Math.abs(place.x), Math.abs(place.y));
      }
      return most;
    });
  const isFitted = async () => {
    const share = await reach();
    return share > 0.5 && share < 1;
  };
  const wheel = async (/** @type {number} */ by) => {
    await page.mouse.move(300, 250);
    await page.mouse.wheel(0, by);
    await page.waitForTimeout(500);
    await nextFrame(page);
  };

  before(async () => {
    await page.setViewportSize({ width: 1040, height: 640 });
    await openEntry(page, 'own-graph');
    await page.fill('#field-z', 'c*x*y');
    await doing(() => page.click('#problem-z .offer'));
  });

  test('by a formula, tenfold and back', async () => {
    for (const formula of ['10*c*x*y', '60*c*x*y', '0.1*c*x*y']) {
      await doing(() => page.fill('#field-z', formula));
      assert.ok(await isFitted(), `${formula}: ${await reach()}`);
    }
  });

  test('to where it has moved, though the view was pressed; but not for a little', async () => {
    await doing(() => page.fill('#field-z', 'c*x*y'));
    await page.mouse.click(300, 120);
    const camera = () => page.evaluate(() => /** @type {any} */ (window).surfpathView.camera.position.z);
    const before = await camera();
    await doing(() => page.fill('#field-z', '1.02*c*x*y'));
    assert.ok(Math.abs((await camera()) - before) < 1e-6);
    await doing(() => page.fill('#field-z', 'c*x*y+3'));
    assert.ok(Math.abs((await camera()) - before - 3) < 0.5, `${before} ${await camera()}`);
    await doing(() => page.fill('#field-z', '0.1*c*x*y'));
  });

  test('though it was turned: what is written then stands in the middle, seen from that side; but a little change moves nothing', async () => {
    await doing(() => page.fill('#field-z', 'c*x*y'));
    await page.mouse.move(300, 120);
    await page.mouse.down();
    await page.mouse.move(420, 150, { steps: 4 });
    await page.mouse.up();
    const side = () =>
      page.evaluate(() => {
        const { camera, controls } = /** @type {any} */ (window).surfpathView;
        const [x, y, z] = ['x', 'y', 'z'].map((axis) => camera.position[axis] - controls.target[axis]);
        return [Math.atan2(y, x), Math.atan2(z, Math.hypot(x, y)), camera.position.z];
      });
    // It goes on for a while, ever more slowly.
    let before = await side();
    for (let moved = 1; moved > 1e-4; ) {
      await page.waitForTimeout(200);
      const now = await side();
      moved = Math.abs(now[2] - before[2]);
      before = now;
    }
    await doing(() => page.fill('#field-z', '1.02*c*x*y'));
    assert.ok(Math.abs((await side())[2] - before[2]) < 1e-2, `${before} ${await side()}`);
    for (const formula of ['c*x*y+1.5', '0.4*c*x*y-1.5']) {
      await doing(() => page.fill('#field-z', formula));
      const [azimuth, elevation] = await side();
      assert.ok(Math.abs(azimuth - before[0]) + Math.abs(elevation - before[1]) < 1e-3, formula);
      assert.ok(await isFitted(), `${formula}: ${await reach()}`);
    }
    await page.click('#reframe');
    await doing(() => page.fill('#field-z', '0.1*c*x*y'));
  });

  test('by ranges, little by little', async () => {
    for (const bound of [3.2, 4, 5.2, 6.8, 9, 12]) await doing(() => page.fill('#field-x-to', String(bound)));
    assert.ok(await isFitted(), String(await reach()));
    await doing(() => page.fill('#field-x-to', '2.5'));
  });

  test('by a slider, once it rests', async () => {
    await doing(() => page.fill('#value-c', '100'));
    assert.ok(await isFitted(), String(await reach()));
    await doing(() => page.fill('#value-c', '1'));
    assert.ok(await isFitted(), String(await reach()));
  });

  test('but not where the reader has come near, while it stays about as large', async () => {
    await wheel(-800);
    const near = await reach();
    assert.ok(near > 1.2, String(near));
    await doing(() => page.fill('#value-c', '1.1'));
    assert.ok((await reach()) > 1.2);
    await doing(() => page.fill('#value-c', '100'));
    assert.ok(await isFitted(), String(await reach()));
  });

  test('nor where the reader has stepped back, while it fits', async () => {
    await wheel(600);
    // The controls write it anew with each frame, from angles.
    const camera = () =>
      page.evaluate(() =>
        /** @type {any} */ (window).surfpathView.camera.position.toArray().map((/** @type {number} */ x) => x.toPrecision(6)),
      );
    const before = await camera();
    await doing(() => page.fill('#value-c', '110'));
    assert.deepEqual(await camera(), before);
  });
});

test('all of the surface is looked at again as when it was opened, or from where the path is', async () => {
  const towards = () =>
    page.evaluate(() => {
      const { camera, controls } = /** @type {any} */ (window).surfpathView;
      return camera.position.clone().sub(controls.target).normalize().toArray();
    });
  await openEntry(page, 'genus2');
  const before = await towards();
  await page.click('#reframe');
  const after = await towards();
  assert.ok(Math.hypot(...before.map((/** @type {number} */ x, /** @type {number} */ k) => x - after[k])) < 1e-3, `${before} ${after}`);
  await openEntry(page, 'own-graph');
  await page.fill('#field-z', 'sqrt(6-x^2-y^2)');
  await page.waitForTimeout(300);
  await settled(page);
  await page.click('#reframe');
  // The middle of a great circle is over that of its chord, (-1.9, -1.2) to (1.8, 1.4).
  const [x, y] = await towards();
  assert.ok((y - x / 2) / Math.hypot(x, y) > 0.95 * Math.hypot(1, 0.5), `${x}, ${y}`);
});

test('a path that leads straight away from the middle is not looked at end on', async () => {
  await openSketch(page, {
    entry: 'own-graph',
    texts: { z: 'x^2' },
    ends: [
      [0.5, 0],
      [2.2, 0],
    ],
  });
  const [a, b] = await Promise.all(['#handle-A', '#handle-B'].map((id) => page.locator(id).boundingBox()));
  const apart = Math.hypot((a?.x ?? 0) - (b?.x ?? 0), (a?.y ?? 0) - (b?.y ?? 0));
  assert.ok(apart > 100, `${apart} pixels from A to B`);
});

test('terrain in metres of a map looks as it does at the origin', async () => {
  const pictureAt = async (/** @type {number} */ x, /** @type {number} */ y) => {
    const range = { 'x-from': `${x - 100}`, 'x-to': `${x + 100}`, 'y-from': `${y - 100}`, 'y-to': `${y + 100}` };
    const ends = [
      [x - 80, y - 70],
      [x + 70, y + 80],
    ];
    await openSketch(page, { entry: 'own-graph', texts: { z: `20sin((x - ${x})/30)cos((y - ${y})/40)`, ...range }, ends });
    return pictureOfView(page);
  };
  const differ = await countDifferent(page, await pictureAt(0, 0), await pictureAt(500000, 4600000));
  // Edges are not the same to the last hair.
  assert.ok(differ < 30, `${differ} pixels`);
});

test('a surface in nanometres or picometres fills the view as one in metres', async () => {
  const pictureIn = async (/** @type {number} */ unit) => {
    const range = Object.fromEntries(
      ['x', 'y'].flatMap((name) => [`${name}-from`, `${name}-to`].map((end, k) => [end, `${k ? unit : -unit}`])),
    );
    const ends = [
      [-0.8 * unit, -0.7 * unit],
      [0.7 * unit, 0.8 * unit],
    ];
    await openSketch(page, { entry: 'own-graph', texts: { z: `${unit}*0.2sin(4x/${unit})`, ...range }, ends });
    return pictureOfView(page);
  };
  const inMetres = await pictureIn(1);
  for (const unit of [1e-9, 1e-12]) {
    const differ = await countDifferent(page, inMetres, await pictureIn(unit));
    // Edges are not the same to the last hair.
    assert.ok(differ < 30, `${differ} pixels`);
  }
});

test('a surface that is asked for a thousand times as long as wide is seen whole', async () => {
  const long = { x: 'cos(u)', y: 'sin(u)', z: 'v', 'u-to': '2pi', 'v-to': '1000' };
  const wide = { z: '0.3sin(x)', 'x-from': '-1000', 'x-to': '1000', 'y-from': '-1', 'y-to': '1' };
  for (const [entry, texts, ...ends] of /** @type {[string, object, ...number[][]][]} */ ([
    ['own-parametric', { ...long, 'u-from': '0', 'v-from': '0' }, [1, 50], [3, 950]],
    ['own-graph', wide, [-900, 0], [900, 0]],
  ])) {
    await openSketch(page, { entry, texts, ends });
    await nextFrame(page);
    assert.doesNotMatch((await page.textContent('#advice')) ?? '', /moved|outside/, entry);
    const [a, b] = await Promise.all(['A', 'B'].map((letter) => page.locator(`#handle-${letter}`).boundingBox()));
    assert.ok(a && b && Math.hypot(a.x - b.x, a.y - b.y) > 300, `${entry}: ${JSON.stringify([a, b])}`);
  }
});

test('what can be seen of a formula that grows by twenty orders is drawn', async () => {
  for (const z of ['exp(12*x)', 'exp(20*x)', 'exp(x^2*6)']) {
    await openSketch(page, { entry: 'own-graph', texts: { z } });
    const { lit } = await measurePicture(page, await pictureOfView(page));
    assert.ok(lit > 0.15, `${z}: ${lit}`);
  }
});

test('a scale has the numbers of its surface, however large that is and wherever', async () => {
  const ball = (/** @type {number[]} */ middle, /** @type {number} */ radius) => {
    const f = ['x', 'y', 'z'].map((name, k) => `(${name} - ${middle[k]})^2`).join(' + ');
    const ranges = ['x', 'y', 'z'].flatMap((name, k) => [
      [`${name}-from`, `${middle[k] - 1.2 * radius}`],
      [`${name}-to`, `${middle[k] + 1.2 * radius}`],
    ]);
    const ends = [0, 1].map((k) => middle.map((x, i) => (i === k ? x + radius : x)));
    return { entry: 'own-implicit', texts: { f: `${f} - ${radius}^2`, ...Object.fromEntries(ranges) }, ends, colour: 'curvature' };
  };
  for (const [middle, radius, words] of /** @type {const} */ ([
    [[0, 0, 0], 6371000, '2.46 × 10⁻¹⁴ everywhere'],
    [[1e6, 2e6, 3e6], 100, '0.000100 everywhere'],
  ])) {
    await openSketch(page, ball([...middle], radius));
    await page.waitForFunction((text) => document.querySelector('#scale b')?.textContent === text, words, { timeout: 10000 });
  }
  await openSketch(page, { entry: 'own-graph', texts: { z: '1000x - 2y' }, colour: 'curvature' });
  await page.waitForFunction(() => document.querySelector('#scale b')?.textContent === '0 everywhere', null, { timeout: 10000 });
});

describe('colours that the system forces', () => {
  before(async () => {
    await page.setViewportSize({ width: 1040, height: 640 });
    await page.emulateMedia({ forcedColors: 'active' });
    await openEntry(page, 'parametricTorus');
  });
  after(() => page.emulateMedia({ forcedColors: null }));

  /** What the browser paints. @param {string} selector @param {string} property @param {string} [part] */
  const painted = (selector, property, part = '') =>
    page.evaluate(
      ([find, name, pseudo]) => getComputedStyle(/** @type {Element} */ (document.querySelector(find)), pseudo).getPropertyValue(name),
      [selector, property, part],
    );

  test('leave the lines of the legend apart', async () => {
    const [path, start] = await Promise.all(['path', 'start'].map((name) => painted(`.legend-${name}`, 'border-top-color', '::before')));
    assert.notEqual(path, start);
  });

  test('show what is selected, and where the focus is', async () => {
    const [chosen, other] = await Promise.all(
      ['path', 'all'].map((task) => painted(`[name=task][value=${task}] + span`, 'background-color')),
    );
    assert.notEqual(chosen, other);
    await page.focus('#points');
    assert.deepEqual([await painted('#points', 'outline-style'), await painted('#points', 'outline-width')], ['solid', '2px']);
  });

  test('leave the scale its colours', async () => {
    await page.selectOption('#colour', 'curvature');
    await settled(page);
    await page.waitForSelector('#scale:not([hidden])');
    assert.match(await painted('.scale i', 'background-image'), /gradient/);
    await page.selectOption('#colour', 'plain');
  });
});

describe('on paper', () => {
  /** What is seen of the page as the sheet has it. */
  const printed = () =>
    page.evaluate(() => {
      dispatchEvent(new Event('beforeprint'));
      const { theme, size } = /** @type {any} */ (window).surfpathView;
      return { halo: theme.halo, size };
    });
  const finished = () => page.evaluate(() => dispatchEvent(new Event('afterprint')));

  test('it is one sheet with a picture, from any screen, and the page is as it was', async () => {
    for (const [width, height] of [
      [1040, 640],
      [390, 844],
    ]) {
      await page.setViewportSize({ width, height });
      await openEntry(page, 'parametricTorus');
      const size = () => page.evaluate(() => /** @type {any} */ (window).surfpathView.size);
      const before = await size();
      const sheet = (await page.pdf({ format: 'A4' })).toString('latin1');
      assert.equal(sheet.match(/\/Type\s*\/Page\b/g)?.length, 1);
      assert.match(sheet, /\/Subtype\s*\/Image/);
      await nextFrame(page);
      assert.deepEqual(await size(), before);
    }
  });

  test('light, whatever the theme', async () => {
    await page.emulateMedia({ colorScheme: 'light' });
    const light = await page.evaluate(() => /** @type {any} */ (window).surfpathView.theme.halo);
    await page.emulateMedia({ colorScheme: 'dark' });
    assert.equal((await printed()).halo, light);
    await finished();
    assert.notEqual(await page.evaluate(() => /** @type {any} */ (window).surfpathView.theme.halo), light);
    await page.emulateMedia({ colorScheme: 'light' });
  });

  test('formula, ranges, measure, ends and result are there, though their cards are closed; nothing to press is', async () => {
    await openEntry(page, 'grained');
    await page.evaluate(() => {
      /** @type {HTMLDetailsElement} */ (document.getElementById('formula-card')).open = false;
    });
    await printed();
    await page.emulateMedia({ media: 'print' });
    const isSeen = (/** @type {string} */ selector) => page.locator(selector).first().isVisible();
    for (const selector of ['#canvas', '#length', '#status', '#typeset', '#field-u-from', '[id="field-metric.E"]', '#end-0-0', '#value-k'])
      assert.ok(await isSeen(selector), selector);
    for (const selector of ['.panel button', '#player', '#colour', '#parameter-k', '#field-density', '#tabs', '#plane'])
      assert.ok(!(await isSeen(selector)), selector);
    await page.emulateMedia({ media: null });
    await finished();
    assert.equal(await page.getAttribute('#formula-card', 'open'), null);
    await page.setViewportSize({ width: 1040, height: 640 });
  });
});

test('a scale of one number says that number', async () => {
  await openEntry(page, 'sphere');
  await page.selectOption('#colour', 'curvature');
  await page.waitForFunction(() => document.querySelector('#scale b')?.textContent === '1.00 everywhere');
});

test('a scale covers nothing of a surface that fills the view', async () => {
  await openEntry(page, 'halfPlane');
  for (const [width, height] of [
    [1440, 900],
    [1260, 700],
    [1024, 768],
    [940, 600],
    [844, 390],
    [390, 844],
  ]) {
    await page.setViewportSize({ width, height });
    await nextFrame(page);
    const [lowest, scale] = await page.evaluate(() => {
      const { surface, camera, size } = /** @type {any} */ (window).surfpathView;
      const points = surface.geometry.getAttribute('position');
      const place = surface.position.clone();
      let least = Infinity;
      for (let i = 0; i < points.count; i++) least = Math.min(least, place.fromBufferAttribute(points, i).project(camera).y);
      return [((1 - least) / 2) * size.height, /** @type {HTMLElement} */ (document.getElementById('scale')).offsetTop];
    });
    assert.ok(lowest < scale, `${width} × ${height}: down to ${lowest}, the scale begins at ${scale}`);
  }
  await page.setViewportSize({ width: 1040, height: 640 });
});

test('a context that the browser has taken away is missed in words; given back it is drawn into at once', async () => {
  await openEntry(page, 'sphere');
  const warm = async () => (await measurePicture(page, await page.locator('canvas').first().screenshot())).warm;
  const before = await warm();
  const notice = await page.evaluate(async () => {
    const context = /** @type {HTMLCanvasElement} */ (document.querySelector('canvas')).getContext('webgl2');
    const loss = context?.getExtension('WEBGL_lose_context');
    loss?.loseContext();
    await new Promise((resolve) => setTimeout(resolve, 200));
    const words = document.getElementById('notice')?.textContent;
    loss?.restoreContext();
    await new Promise((resolve) => setTimeout(resolve, 500));
    return words;
  });
  await nextFrame(page);
  assert.match(notice ?? '', /3D graphics/);
  assert.equal(await page.isVisible('#notice'), false);
  assert.ok(before > 0);
  assert.ok((await warm()) > 0.95 * before);
});

test('the console stayed silent', () => {
  assert.deepEqual(complaints, []);
});
