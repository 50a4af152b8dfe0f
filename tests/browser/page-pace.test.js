// How quick the page is: its first path (printed), no script that keeps it for 50 ms, shaders compiled once; and what is pointed at is marked everywhere.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { allowance } from '../helpers/allowance.js';
import { COARSE, nextFrame, openBrowser, openEntry, openPage, settled } from '../helpers/page.js';
import { watchTasks } from '../helpers/pace.js';

/** Milliseconds of the processor that a script may keep the page, on one that is not slow. */
const MOST = 50;

/** @type {Awaited<ReturnType<typeof openBrowser>>} */ let browser;
/** @type {import('playwright-core').Page} */ let page;
/** @type {string[]} */ let complaints;
before(async () => {
  browser = await openBrowser([], COARSE);
  ({ page, complaints } = await openPage(browser.context, 'about:blank'));
});
after(() => browser?.close());

/** Looks, and looks at most, of which the quickest counts: other work on the machine slows a script even by the processor's own clock. */
const [LOOKS, MOST_LOOKS] = [process.env.EVERY_RELEASE ? 3 : 1, 20];
/** What is opened: `make browsers` opens all of these. */
const OPENED = ['threeTori', 'printed47', 'trefoil', 'halfPlane'].slice(0, process.env.EVERY_RELEASE ? undefined : 1);

/** @param {() => Promise<void>} act */
async function checkTasks(act) {
  for (let look = 1; ; look++) {
    const tasks = await watchTasks(page, act);
    assert.ok(tasks.length > 3, 'tasks are seen');
    const [{ name, milliseconds, at }] = tasks;
    if (milliseconds < allowance(MOST)) return;
    assert.ok(look < MOST_LOOKS, `${name} ${at} kept the page for ${milliseconds} ms of the processor`);
  }
}

test('how soon the first path is there, in a tab that is open', async (t) => {
  const times = [];
  for (let look = 0; look < LOOKS; look++) {
    await page.goto('about:blank');
    await page.goto(browser.address);
    await settled(page);
    assert.equal(await page.getAttribute('#status', 'data-status'), 'converged');
    await page.waitForFunction(() => performance.getEntriesByName('first path drawn').length === 1, null, { polling: 100 });
    const marks = await page.evaluate(() => performance.getEntriesByType('mark').map(({ startTime }) => startTime));
    assert.equal(marks.length, 2, 'when the first path was known, and when it had been drawn');
    times.push(marks.map(Math.round).join(' and '));
  }
  t.diagnostic(`first path known and drawn after ${times.join('; ')} ms (wanted on two idle processors: 1000)`);
});

describe('no script keeps the page for 50 ms', () => {
  test('while it opens', () =>
    checkTasks(async () => {
      await page.goto(browser.address);
      await settled(page);
    }));

  for (const name of OPENED) test(`while it opens ${name}`, () => checkTasks(() => openEntry(page, name)));

  test('while a slider moves, an end is dragged by keys, the surface is coloured, and all geodesics are found', async () => {
    await checkTasks(async () => {
      await openEntry(page, 'parametricTorus');
      for (let i = 0; i < 8; i++) await page.fill('#value-a', String(1 + i / 20));
      await page.focus('#handle-B');
      for (let i = 0; i < 8; i++) await page.keyboard.press('ArrowRight');
      await page.selectOption('#colour', 'distance');
      await page.waitForSelector('#scale:not([hidden])');
      await page.check('[name=task][value=all]');
      await page.waitForTimeout(300);
      await settled(page);
    });
  });

  test('while a slider takes an implicit surface away from its ends', async () => {
    await openEntry(page, 'sphere');
    await checkTasks(async () => {
      for (let i = 1; i <= 6; i++) await page.fill('#value-r', String(1 + i / 40));
      await page.waitForTimeout(300);
      await settled(page);
    });
  });
});

test('a surface that changes keeps its shaders', async () => {
  await openEntry(page, 'parametricTorus');
  await nextFrame(page);
  const programs = () => page.evaluate(() => /** @type {any} */ (window).surfpathView.memory.programs);
  const before = await programs();
  assert.ok(before.length > 2);
  for (const value of ['1.2', '1.3', '1.4']) {
    await page.fill('#value-a', value);
    await page.waitForTimeout(250);
    await nextFrame(page);
  }
  await settled(page);
  await nextFrame(page);
  assert.deepEqual(await programs(), before);
});

describe('what is pointed at is marked', () => {
  const dotInPlane = () =>
    page.evaluate(() => {
      const dot = document.querySelector('#plane .hover');
      return dot?.hasAttribute('hidden') ? null : ['cx', 'cy'].map((name) => Number(dot?.getAttribute(name)));
    });
  const dotInSpace = () => page.evaluate(() => /** @type {any} */ (window).surfpathView.dot);

  before(async () => {
    await openEntry(page, 'parametricTorus');
    await page.locator('#plane').scrollIntoViewIfNeeded();
  });

  test('in the plane: on the surface', async () => {
    const place = await page.evaluate(() => {
      const { left, top, width, height } = /** @type {Element} */ (document.querySelector('#plane .ground')).getBoundingClientRect();
      return [left + 0.25 * width, top + 0.5 * height];
    });
    await page.mouse.move(place[0], place[1]);
    const [x, y, z] = await dotInSpace();
    // A quarter of the way around, half around the tube: (0, R − a, 0).
    assert.ok(Math.hypot(x, y - 2.5, z) < 0.1, `${[x, y, z]}`);
    assert.ok(await dotInPlane());
  });

  test('on the surface: in the plane, and nowhere once the mouse has left', async () => {
    const box = await page.locator('#handle-A').boundingBox();
    assert.ok(box);
    const handle = await page.evaluate(() => {
      const dot = /** @type {Element} */ (document.querySelector('#plane [data-end="0"] .dot'));
      return ['cx', 'cy'].map((name) => Number(dot.getAttribute(name)));
    });
    // Beside the handle, which the pointer would press.
    await page.mouse.move(box.x + box.width / 2 + 20, box.y + box.height / 2 + 4);
    await page.waitForFunction(() => !document.querySelector('#plane .hover')?.hasAttribute('hidden'));
    const dot = await dotInPlane();
    assert.ok(dot && Math.hypot(dot[0] - handle[0], dot[1] - handle[1]) < 40, `${dot} beside ${handle}`);
    await page.mouse.move(page.viewportSize()?.width ?? 0, 0);
    await page.waitForFunction(() => document.querySelector('#plane .hover')?.hasAttribute('hidden'));
    assert.equal(await dotInSpace(), null);
  });

  test('along a plot: on the path, in space and in the plane', async () => {
    await page.click('#plots-card summary');
    await page.selectOption('#plot-choice', 'curvature');
    await page.waitForSelector('#plot polyline.series');
    await page.locator('#plot').scrollIntoViewIfNeeded();
    const box = await page.locator('#plot svg').boundingBox();
    assert.ok(box);
    // The left end of the axis across, where A is: 46 of 320 units.
    await page.mouse.move(box.x + (46.5 / 320) * box.width, box.y + 80);
    await page.waitForSelector('#plot .guide:not([hidden])', { state: 'attached' });
    const [u, v] = await Promise.all([0, 1].map(async (i) => Number(await page.inputValue(`#end-0-${i}`))));
    const [x, y, z] = await dotInSpace();
    const away = Math.hypot(x - (4 + 1.5 * Math.cos(v)) * Math.cos(u), y - (4 + 1.5 * Math.cos(v)) * Math.sin(u), z - 1.5 * Math.sin(v));
    assert.ok(away < 0.1, `${away} from A`);
    assert.ok(await dotInPlane());
    await page.click('#plots-card summary');
  });
});

test('the console stayed silent', () => {
  assert.deepEqual(complaints, []);
});
