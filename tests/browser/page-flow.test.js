// What the page computes, in which order: changes that overtake each other, long tasks with progress and cancel, workers that die. It always comes to rest.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { allowance } from '../helpers/allowance.js';
import { sketchOf } from '../../demo/state/sketch.js';
import { COARSE, hashOf, openBrowser, openEntry, openPage, openSettled, openSketch, settled } from '../helpers/page.js';

/** @type {Awaited<ReturnType<typeof openBrowser>>} */ let browser;
/** @type {import('playwright-core').Page} */ let page;
/** @type {string[]} */ let complaints;

before(async () => {
  ({ browser, page, complaints } = await openSettled([], COARSE));
});
after(() => browser?.close());

const text = async (/** @type {string} */ selector) => (await page.textContent(selector)) ?? '';
const status = () => page.getAttribute('#status', 'data-status');
const length = async () => Number.parseFloat(await text('#length'));

/** What follows from a change is computed. */
async function rest() {
  await page.waitForTimeout(300);
  await settled(page);
}

/** Writes into fields in one go, without a pause between. @param {Record<string, string>} values by id */
const writeAtOnce = (values) =>
  page.evaluate((given) => {
    for (const [id, value] of Object.entries(given)) {
      const input = /** @type {HTMLInputElement} */ (document.getElementById(id));
      input.focus();
      input.value = value;
      input.dispatchEvent(new Event('input', { bubbles: true }));
    }
  }, values);

/** Words that change a formula of x and y by nothing to speak of, and take their time. @param {number} count */
const babble = (count) => Array.from({ length: count }, (_, i) => `+(2+sin(${i + 1}x+y))^1.1/1e9`).join('');
/** Takes seconds to be drawn and to be solved on. */
const LONG = `x^2+y^2+z^2-1${babble(130)}`;

/** Follows a link, and waits for nothing. @param {object} sketch */
const followLink = (sketch) =>
  page.evaluate((hash) => {
    location.hash = hash;
  }, hashOf(sketch));

describe('changes that overtake each other', () => {
  test('ends that a new formula has left behind are put onto the surface', async () => {
    await openEntry(page, 'own-implicit');
    await page.fill('#field-f', 'x^2+y^2+z^2-0.04');
    await page.waitForTimeout(400);
    await settled(page);
    assert.equal(await status(), 'converged', await text('#advice'));
    const [x, y, z] = await Promise.all([0, 1, 2].map(async (i) => Number(await page.inputValue(`#end-0-${i}`))));
    assert.ok(Math.abs(Math.hypot(x, y, z) - 0.2) < 0.01, `A is at ${[x, y, z]}`);
  });

  test('so are those that a slider has', async () => {
    await openEntry(page, 'sphere');
    await page.fill('#value-r', '0.2');
    await page.waitForTimeout(500);
    await settled(page);
    assert.equal(await status(), 'converged', await text('#advice'));
    assert.match(await text('#advice'), /moved/);
    assert.equal(await page.locator('.surfpath-handle').count(), 2);
  });

  test('so are those that a slider has, whatever is changed before its path is there', async () => {
    const lengths = [];
    for (const [name, act] of /** @type {[string, () => Promise<unknown>][]} */ ([
      ['nothing', async () => {}],
      ['tolerance', () => page.selectOption('#tolerance', '1e-12')],
      ['points', () => page.fill('#points', '100')],
      ['start', () => page.selectOption('#start', 'straight')],
      ['swap', () => page.click('#swap-ends')],
      ['all', () => page.check('[name=task][value=all]', { force: true })],
      ['end', () => page.fill('#end-1-0', '0.88')],
    ])) {
      await openEntry(page, 'ellipsoid');
      await page.fill('#value-b', '0.39');
      await act();
      await rest();
      assert.equal(await status(), 'converged', `${name}: ${await text('#advice')}`);
      assert.match(await text('#advice'), /moved/, name);
      if (name !== 'end') lengths.push((await length()).toFixed(7));
    }
    assert.equal(new Set(lengths).size, 1, `${lengths}`);
  });

  test('a point on the way is added to the path of what was just written, or moved', async () => {
    const points = () => page.$$eval('#ends .end', (rows) => rows.length);
    await openEntry(page, 'saddle');
    await page.fill('#field-z', 'u^2-v^2+u');
    await page.click('#add-via');
    await rest();
    assert.deepEqual([await points(), await status()], [3, 'converged']);
    await openEntry(page, 'ellipsoid');
    await page.fill('#value-b', '0.39');
    await page.click('#add-via');
    await rest();
    assert.deepEqual([await points(), await status()], [3, 'converged'], await text('#advice'));
  });

  test('what is asked while a slider moves the surface is answered of where it goes, or stays', async () => {
    const asked = async (/** @type {string} */ entry, /** @type {Record<string, string>[]} */ ...writings) => {
      await openEntry(page, entry);
      for (const values of writings) {
        await writeAtOnce(values);
        await rest();
      }
      return text('#length');
    };
    assert.equal(
      await asked('parametricTorus', { 'value-a': '1.2', points: '100' }),
      await asked('parametricTorus', { 'value-a': '1.2' }, { points: '100' }),
    );
    assert.equal(await asked('sphere', { 'value-r': '50', points: '100' }), await asked('sphere', { points: '100' }));
  });

  test('one from which the solver gets nowhere downhill goes to the place nearby, not anywhere', async () => {
    const f = '(x^2+(9/4)y^2+z^2-1)^3-x^2z^3-(9/80)y^2z^3';
    const bounds = { 'x-from': '-1.5', 'x-to': '1.5', 'z-from': '-1.5', 'z-to': '1.5' };
    const ends = [
      [0.8, 0.3, 0.5],
      [-0.8, -0.3, 0.5],
    ];
    await openSketch(page, { entry: 'own-implicit', texts: { f, ...bounds }, ends });
    assert.equal(await status(), 'converged', await text('#advice'));
    for (const [i, end] of ends.entries())
      for (const [k, x] of end.entries()) {
        const now = Number(await page.inputValue(`#end-${i}-${k}`));
        assert.ok(Math.abs(now - x) < 0.15, `${x} became ${now}`);
      }
  });

  test('and those where it has no value', async () => {
    await openEntry(page, 'own-graph');
    await page.fill('#field-z', 'sqrt(4-x^2-y^2)');
    await page.waitForTimeout(300);
    await settled(page);
    assert.equal(await page.getAttribute('#status', 'data-status'), 'converged');
    assert.equal(await page.locator('.surfpath-handle').count(), 2);
  });

  test('but an end that has a place stays, the other one goes to the nearest, and the page says so', async () => {
    await openEntry(page, 'own-graph');
    const ends = () => page.$$eval('#ends input', (all) => all.map((one) => Number(/** @type {HTMLInputElement} */ (one).value)));
    const [ax, ay, ...b] = await ends();
    await page.fill('#field-z', 'sqrt(x)');
    await page.waitForTimeout(300);
    await settled(page);
    assert.equal(await status(), 'converged');
    const [x, y, ...other] = await ends();
    assert.deepEqual(other, b);
    assert.ok(ax < 0 && x >= 0 && x < 0.2 && Math.abs(y - ay) < 0.1, `A is at ${x}, ${y}`);
    assert.equal(await text('#advice'), 'A was moved: there is no surface where it was.');
    await page.fill('#field-z', 'sqrt(x)+y');
    await page.waitForTimeout(300);
    await settled(page);
    assert.doesNotMatch(await text('#advice'), /was moved/);
  });

  test('ends from which a formula has grown away are brought to where the surface is seen', async () => {
    await openEntry(page, 'own-graph');
    await page.fill('#field-z', 'exp(x^4)');
    await page.waitForTimeout(300);
    await settled(page);
    assert.equal(await status(), 'converged', await text('#advice'));
    assert.equal(await text('#advice'), 'A and B were moved to where the surface is seen: they lay far outside.');
    const outside = await page.evaluate(() => {
      const view = /** @type {HTMLElement} */ (document.getElementById('view')).getBoundingClientRect();
      return [...document.querySelectorAll('.surfpath-handle')].filter((handle) => {
        const { x, y, right, bottom } = handle.getBoundingClientRect();
        return x < view.x || y < view.y || right > view.right || bottom > view.bottom;
      }).length;
    });
    assert.equal(outside, 0);
  });

  test('of one that has no value there, or one too large, they are brought to the rest, and so is the view', async () => {
    for (const z of ['x^y', 'exp(x^2*9)']) {
      await openEntry(page, 'own-graph');
      for (const next of [z, 'x^2']) {
        await page.fill('#field-z', next);
        await rest();
        assert.equal(await status(), 'converged', await text('#advice'));
        const { view, heights } = await page.evaluate(() => {
          const { view, camera } = /** @type {any} */ (window).surfpathView;
          return {
            view: [...view, ...camera.position],
            heights: [...document.querySelectorAll('.surfpath-handle')].map((one) => one.getBoundingClientRect().y),
          };
        });
        assert.ok(view.every(Number.isFinite), `${next} after ${z}: ${view}`);
        assert.ok(heights.length === 2 && heights.every((y) => y > 0 && y < 500), `${next} after ${z}: ${heights}`);
      }
    }
  });

  test('ends beside which wide ranges make them one dot are moved apart; those that a link has so stay', async () => {
    await openEntry(page, 'own-graph');
    const ranges = { 'x-from': '-1000', 'x-to': '1000', 'y-from': '-1000', 'y-to': '1000' };
    await writeAtOnce(Object.fromEntries(Object.entries({ z: '0', ...ranges }).map(([name, value]) => [`field-${name}`, value])));
    await rest();
    assert.ok((await length()) > 20, await text('#length'));
    assert.match(await text('#advice'), /A and B were moved/);
    await openSketch(page, { entry: 'own-graph', texts: { z: '0', ...ranges } });
    assert.ok((await length()) < 5, await text('#length'));
    await page.fill('#field-z', 'x');
    await rest();
    assert.ok((await length()) < 8, 'nor does another formula move what the reader has put there');
  });

  test('an end in the middle of a sphere is too far from it', async () => {
    await openEntry(page, 'sphere');
    for (const i of [0, 1, 2]) await page.fill(`#end-0-${i}`, '0');
    await rest();
    assert.match(await text('#advice'), /^A lies too far from the surface/);
  });

  test('which point is too far from a surface is said', async () => {
    const sketch = { entry: 'sphere', via: [[0, 0, 1]] };
    await openSketch(page, sketch);
    await page.fill('#end-2-0', '40');
    await rest();
    assert.match(await text('#advice'), /^Point 1 lies too far from the surface/);
    await openSketch(page, { ...sketch, via: [] });
    await page.fill('#end-1-0', '40');
    await rest();
    assert.match(await text('#advice'), /^B lies too far from the surface/);
  });

  test('straight ahead asks for nothing but A', async () => {
    await openSketch(page, { entry: 'parametricTorus', via: [[1, 1]] });
    await page.fill('#end-1-0', '');
    await rest();
    assert.equal(await text('#status'), 'No path');
    await page.check('[name=task][value=trace]');
    await rest();
    assert.equal(await text('#status'), 'Converged');
    assert.equal(await text('#ends'), 'Auv');
    assert.equal(await page.locator('#plane .via').count(), 0);
  });

  test('but where a link says that they are, they stay', async () => {
    await openSketch(page, { entry: 'own-graph', texts: { z: 'x^9' } });
    assert.match(await text('#advice'), /far outside what is seen/);
    assert.deepEqual(
      await page.$$eval('#ends input', (all) => all.map((one) => Number(/** @type {HTMLInputElement} */ (one).value))),
      [-1.9, -1.2, 1.8, 1.4],
    );
  });

  test('that an end was moved is said beside why there is no path', async () => {
    await openSketch(page, { entry: 'own-graph', texts: { z: '0', 'x-from': '-1', 'x-to': '1' }, density: 'x' });
    assert.match(await text('#advice'), /^A and B were moved: .* the density must be greater than 0\.$/);
  });

  test('a mistake in a link is marked in its field, whose card opens', async () => {
    const { page: other } = await openPage(browser.context, browser.address + hashOf({ entry: 'saddle', density: '1+(x<0)' }));
    await other.waitForSelector('#problem-density pre');
    assert.equal(await other.getAttribute('#field-density', 'aria-invalid'), 'true');
    assert.equal(await other.isVisible('#formula-problem'), false);
    const z = `u^2${'+v/1000'.repeat(700)}`;
    await other.fill('#field-z', z);
    await other.waitForSelector('#problem-z pre');
    const complaint = await other.textContent('#problem-z');
    await other.reload();
    await other.waitForSelector('#problem-z pre');
    assert.equal(await other.textContent('#problem-z'), complaint);
    assert.equal(await other.inputValue('#field-z'), z);
    await other.close();
  });

  test('a mistake in a link leaves nothing that looks like its surface; mended, that is looked at', async () => {
    const texts = { x: '30+cos(u)*cos(v', y: 'sin(u)*cos(v)', z: 'sin(v)' };
    const { page: other } = await openPage(browser.context, browser.address + hashOf({ entry: 'parametricTorus', texts }));
    await other.waitForSelector('#problem-x pre');
    assert.equal(await other.locator('#poster').count(), 0);
    await other.fill('#field-x', `${texts.x})`);
    await other.waitForSelector('#problem-x', { state: 'hidden' });
    await settled(other);
    const target = await other.evaluate(() => /** @type {any} */ (window).surfpathView.controls.target.toArray());
    assert.ok(Math.abs(target[0] - 30) < 1, `looks at ${target}`);
    await other.close();
  });

  test('after a mistake in a link the surface seen before stays, but the ends of the link are not put onto it', async () => {
    await openEntry(page, 'genus2');
    const before = await text('#length');
    const { ends } = sketchOf('own-implicit');
    await openSketch(page, { entry: 'own-implicit', texts: { f: 'x^2+y^2+z^2-' } });
    assert.equal(await text('#status'), 'Last good surface');
    assert.equal(await page.locator('.surfpath-handle').count(), 0);
    for (const [k, x] of ends[0].entries()) assert.equal(Number(await page.inputValue(`#end-0-${k}`)), x);
    await page.fill('#end-0-0', '0.3');
    await rest();
    assert.equal(await text('#length'), before, 'nothing is computed on a surface of another entry');
    await page.fill('#field-f', 'x^2+y^2+z^2-1');
    await rest();
    assert.equal(await status(), 'converged', await text('#advice'));
    assert.equal(await page.locator('.surfpath-handle').count(), 2);
  });

  test('a formula is typeset as of before while what is written of it cannot be drawn', async () => {
    await openEntry(page, 'parametricTorus');
    const opacity = () => page.$eval('#typeset', (element) => getComputedStyle(element).opacity);
    const seen = [await opacity()];
    for (const [field, value] of [
      ['density', '1+'],
      ['density', ''],
      ['z', 'a*sin(v'],
      ['z', 'a*sin(v)'],
    ]) {
      await page.evaluate(() => document.querySelector('#measure-card')?.setAttribute('open', ''));
      await page.fill(`#field-${field}`, value);
      await rest();
      seen.push(await opacity());
    }
    assert.deepEqual(seen, ['1', '1', '1', '0.5', '1']);
  });

  test('where a density or a metric does not repeat beyond a seam, so that no path crosses it, the page says so', async () => {
    const said = async (/** @type {object} */ sketch) => {
      await openSketch(page, sketch);
      assert.equal(await status(), 'converged');
      return /Beyond its seam length is measured otherwise/.test(await text('#advice'));
    };
    assert.deepEqual(
      [
        await said({ entry: 'moebius', density: '1+exp(-(u-1.8)^2)' }),
        await said({ entry: 'moebius', density: '1+exp(-(x-1)^2)' }),
        await said({ entry: 'parametricTorus', tensor: ['1+u', '0', '1'] }),
        await said({ entry: 'parametricTorus', density: '1.5+cos(u)' }),
        await said({ entry: 'sphere', density: '1+x^2' }),
        await said({ entry: 'hyperbolicDisc' }),
      ],
      [true, false, true, false, false, false],
    );
  });

  test('a slow hill repeats where the surface closes: paths go on over the seam', async () => {
    const ends = [
      [0.3, 0.2],
      [6, 6.1],
    ];
    await openSketch(page, { entry: 'parametricTorus', ends });
    const before = await length();
    await page.evaluate(() => /** @type {HTMLElement} */ (document.querySelector('[data-preset=bump]')).click());
    await rest();
    assert.equal(await status(), 'converged', await text('#advice'));
    assert.ok(Math.abs((await length()) / before - 1) < 0.1, `${before} became ${await length()}`);
    assert.match(await page.inputValue('#field-density'), /^1\+3\*exp\(-\(2sin\(\(u-3\.15\)\/2\)\)\^2/);
  });

  test('a metric that is none has no ellipses', async () => {
    await openEntry(page, 'own-metric');
    await page.fill('#field-E', '-1');
    await page.fill('#field-F', '0');
    await page.fill('#field-G', '-1');
    await page.waitForTimeout(300);
    await settled(page);
    assert.equal(await page.locator('.indicatrix').count(), 0);
  });

  test('a slider that makes the surface vanish says so, the last good one stays, and the way back is open', async () => {
    await openEntry(page, 'sphere');
    const before = await text('#length');
    const name = (await page.locator('#sliders input[type=number]').first().getAttribute('id')) ?? '';
    const value = await page.inputValue(`#${name}`);
    for (const wrong of ['1.1', '1.05', '50']) await page.fill(`#${name}`, wrong);
    await rest();
    assert.match(await text('#formula-problem'), /f changes its sign nowhere/);
    assert.notEqual(await text('#length'), '–');
    await page.fill(`#${name}`, value);
    await rest();
    assert.equal(await page.isVisible('#formula-problem'), false);
    assert.equal(await text('#length'), before);
  });

  test('an end that is dragged, then written wrong, leaves the page at rest', async () => {
    await openEntry(page, 'saddle');
    await page.focus('#handle-B');
    await page.keyboard.press('ArrowRight');
    await writeAtOnce({ 'end-1-0': '7' });
    await rest();
    assert.match(await text('#ends-problem'), /must lie between/);
    assert.match(await text('#advice'), /must lie between/, 'also where a phone shows it');
  });

  test('a formula, then an end, before the surface is there: both count', async () => {
    await openEntry(page, 'saddle');
    await writeAtOnce({ 'field-z': 'u^2-v^2+u' });
    await page.waitForTimeout(152);
    await writeAtOnce({ 'end-0-0': '0.4' });
    await rest();
    const [both, typeset] = [await length(), await text('#typeset')];
    await openEntry(page, 'saddle');
    await page.fill('#end-0-0', '0.4');
    await rest();
    await page.fill('#field-z', 'u^2-v^2+u');
    await page.waitForTimeout(300);
    await settled(page);
    assert.equal(await length(), both);
    assert.equal(await text('#typeset'), typeset);
  });

  test('a slider, then a wrong formula: the last good surface stays, and its ends can be moved', async () => {
    await openEntry(page, 'parametricTorus');
    await page.fill('#value-a', '1.4');
    await writeAtOnce({ 'field-z': 'a*sin(v' });
    await rest();
    await page.waitForSelector('#problem-z pre');
    const before = await length();
    assert.ok(before > 0);
    await page.fill('#end-0-0', '1.6');
    await rest();
    assert.ok((await length()) > before + 0.01, 'the path follows on the last good surface');
    assert.equal(await text('#status'), 'Last good surface');
    assert.equal(await status(), 'converged');
    assert.ok(await page.isVisible('#problem-z pre'));
  });

  test('a link that is followed just after a change opens what it says', async () => {
    await openEntry(page, 'saddle');
    await page.fill('#end-0-0', '0.3');
    await page.waitForTimeout(330);
    // The page writes its own address 400 ms after a change: now, before the link has its turn.
    await page.evaluate(
      (hash) => {
        location.hash = hash;
        const end = performance.now() + 150;
        while (performance.now() < end);
      },
      hashOf({ entry: 'vase' }),
    );
    await rest();
    assert.equal(await text('#entry-title'), 'Vase');
  });

  test('many changes in a row end in the last one', async () => {
    await openEntry(page, 'parametricTorus');
    const values = Array.from({ length: process.env.EVERY_RELEASE ? 100 : 25 }, (_, i) => String(1 + (i % 10) / 20));
    await page.evaluate(async (all) => {
      const input = /** @type {HTMLInputElement} */ (document.getElementById('value-a'));
      for (const value of all) {
        input.value = value;
        input.dispatchEvent(new Event('input', { bubbles: true }));
        await new Promise((resolve) => setTimeout(resolve, 5));
      }
    }, values);
    await rest();
    const last = await text('#length');
    await openEntry(page, 'parametricTorus');
    await page.fill('#value-a', /** @type {string} */ (values.at(-1)));
    await rest();
    assert.equal(await text('#length'), last);
  });
});

describe('what takes long', () => {
  test('is said with a way to cancel it, which works at once', async () => {
    await openEntry(page, 'sphere');
    assert.equal(await page.isVisible('#progress'), false);
    await page.fill('#field-f', LONG);
    await page.waitForSelector('#progress:not([hidden])');
    assert.match(await text('#progress-words'), /^(?:Drawing the surface|Searching for paths)$/);
    assert.match(await text('#status'), /^(?:Drawing the surface|Looking for the shortest path)…$/);
    assert.equal(await status(), null, 'what is seen is not the answer');
    assert.equal(await text('#advice'), '');
    const isHidden = await page.evaluate(() => {
      document.getElementById('cancel')?.click();
      return document.getElementById('progress')?.hidden;
    });
    assert.equal(isHidden, true);
    await settled(page);
    assert.match(`${await text('#formula-problem')}${await text('#ends-problem')}`, /^Cancelled/);
  });

  test('is given up for another surface, at once', async () => {
    await openEntry(page, 'sphere');
    await page.fill('#field-f', LONG);
    await page.waitForSelector('#progress:not([hidden])');
    const begin = Date.now();
    await openEntry(page, 'saddle');
    assert.equal(await status(), 'converged');
    assert.equal(await page.isVisible('#progress'), false);
    const quick = Date.now() - begin;
    assert.ok(quick < allowance(6000), `${quick} ms`);
    assert.equal(await text('#entry-title'), 'Saddle');
  });

  test('a mistake in the formula is said at once, and another end is not waited for', async () => {
    const steep = { entry: 'own-graph', texts: { z: 'exp(x^4)' } };
    await followLink(steep);
    await page.waitForSelector('#progress:not([hidden])');
    await page.fill('#field-z', 'exp(x^4)+');
    await page.waitForFunction(() => /ends too early/.test(document.getElementById('advice')?.textContent ?? ''), null, {
      timeout: allowance(4000),
    });
    await openEntry(page, 'own-graph');
    await followLink(steep);
    await page.waitForFunction(() => /^Looking/.test(document.getElementById('status')?.textContent ?? ''));
    const begin = Date.now();
    await page.fill('#end-0-0', '1');
    await settled(page);
    assert.equal(await status(), 'converged');
    const quick = Date.now() - begin;
    assert.ok(quick < allowance(6000), `${quick} ms`);
  });

  test('plots say how far they are, and a cancelled one says so', async () => {
    await openEntry(page, 'own-graph');
    await page.fill('#field-z', `x*y/4${babble(130)}`);
    await rest();
    await page.click('#plots-card summary');
    await page.evaluate(() => {
      const seen = /** @type {any} */ (window);
      const bar = /** @type {HTMLProgressElement} */ (document.getElementById('progress-bar'));
      const cancel = /** @type {HTMLButtonElement} */ (document.getElementById('cancel'));
      /* From within the page: on a busy machine all is measured before a click from outside arrives. */
      new MutationObserver(() => {
        if (seen.cancelledAt || !(bar.value > 0 && bar.value < 1)) return;
        seen.cancelledAt = bar.value;
        seen.words = cancel.checkVisibility() && document.getElementById('progress-words')?.textContent;
        cancel.click();
      }).observe(bar, { attributes: true });
    });
    await page.selectOption('#plot-choice', 'time');
    await page.waitForFunction(() => /^Cancelled/.test(document.getElementById('plot')?.textContent ?? ''));
    assert.equal(await page.evaluate(() => /** @type {any} */ (window).words), 'Measuring paths');
    assert.equal(await page.isVisible('#progress'), false);
    assert.equal(await status(), 'converged', 'the path is still there');
    await page.selectOption('#plot-choice', 'convergence');
    await page.waitForSelector('#plot polyline.series');
    await page.click('#plots-card summary');
  });
});

test('the console stayed silent', () => {
  assert.deepEqual(complaints, []);
});

test('a worker that cannot be started is said, and started again with the next change', async () => {
  await page.route('**/worker.js', (route) => route.abort());
  await page.goto('about:blank');
  await page.goto(browser.address);
  await page.waitForFunction(() => /worker could not be started/.test(document.getElementById('advice')?.textContent ?? ''));
  await settled(page);
  await page.unroute('**/worker.js');
  await openEntry(page, 'saddle');
  assert.equal(await status(), 'converged');
});
