// The ends of the path in the page are moved by mouse, finger and keys, in the view and in the plane, and the path follows at once.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { COARSE, nextFrame, openBrowser, openEntry, openSettled, settled } from '../helpers/page.js';

/** @type {Awaited<ReturnType<typeof openBrowser>>} */ let browser;
/** @type {import('playwright-core').Page} */ let page;
/** @type {string[]} */ let complaints;

before(async () => {
  ({ browser, page, complaints } = await openSettled([], { ...COARSE, hasTouch: true }));
});
after(() => browser?.close());

const length = async () => Number.parseFloat((await page.textContent('#length')) ?? '');
const ends = async () => Promise.all(['0-0', '0-1', '1-0', '1-1'].map(async (name) => Number(await page.inputValue(`#end-${name}`))));

/** The middle of an element. @param {string} selector */
async function middleOf(selector) {
  const box = await page.locator(selector).boundingBox();
  assert.ok(box, selector);
  return [box.x + box.width / 2, box.y + box.height / 2];
}

/** Counts the lengths that were shown since. */
const countLengths = () =>
  page.evaluate(() => {
    const seen = /** @type {any} */ (window);
    seen.lengths = new Set();
    new MutationObserver(() => seen.lengths.add(document.getElementById('length')?.textContent)).observe(
      /** @type {Node} */ (document.getElementById('length')),
      { childList: true, characterData: true, subtree: true },
    );
  });

test('by mouse: the path follows during the drag, the camera stays', async () => {
  await openEntry(page, 'saddle');
  assert.equal(await page.textContent('.legend-drag'), 'Drag A and B');
  await countLengths();
  const [before, start] = [await length(), await ends()];
  const other = await middleOf('#handle-A');
  const [x, y] = await middleOf('#handle-B');
  await page.mouse.move(x, y);
  await page.mouse.down();
  // Towards A: there is surface all the way.
  const [dx, dy] = [0.03 * (other[0] - x), 0.03 * (other[1] - y)];
  for (let i = 1; i <= 10; i++) await page.mouse.move(x + i * dx, y + i * dy);
  const during = await page.evaluate(() => /** @type {any} */ (window).lengths.size);
  await page.mouse.up();
  await page.waitForTimeout(250);
  await settled(page);
  assert.equal(await page.locator('.legend-drag').count(), 0, 'who has dragged needs no hint');
  assert.ok(during >= 5, `${during} lengths were shown during the drag`);
  assert.notEqual(await length(), before);
  const end = await ends();
  assert.deepEqual(end.slice(0, 2), start.slice(0, 2), 'A stays');
  assert.notDeepEqual(end.slice(2), start.slice(2), 'B has moved');
  await nextFrame(page);
  const [bx, by] = await middleOf('#handle-B');
  assert.ok(Math.hypot(bx - (x + 10 * dx), by - (y + 10 * dy)) < 4, 'B is under the pointer');
  assert.deepEqual(await middleOf('#handle-A'), other, 'the camera stays');
  assert.equal(await page.getAttribute('#status', 'data-status'), 'converged');
});

test('beside a rim the path follows, too', async () => {
  await openEntry(page, 'own-graph');
  await page.fill('#field-z', 'sqrt(1-x^2-y^2)');
  await page.waitForTimeout(300);
  await settled(page);
  const before = await length();
  const [x, y] = await middleOf('#handle-B');
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let step = 1; step <= 12; step++) await page.mouse.move(x - 13 * step, y + 6 * step);
  await nextFrame(page);
  assert.notEqual(await length(), before);
  await page.mouse.up();
  await page.waitForTimeout(250);
  await settled(page);
});

test('Escape puts back what is dragged, and what the hand does then moves nothing', async () => {
  await openEntry(page, 'saddle');
  const start = await ends();
  const [x, y] = await middleOf('#handle-B');
  const other = await middleOf('#handle-A');
  const toward = (/** @type {number} */ share) => page.mouse.move(x + share * (other[0] - x), y + share * (other[1] - y));
  await page.mouse.move(x, y);
  await page.mouse.down();
  await toward(0.1);
  await toward(0.2);
  assert.notDeepEqual(await ends(), start);
  await page.keyboard.press('Escape');
  await toward(0.3);
  await toward(0.4);
  await page.mouse.up();
  await page.waitForTimeout(250);
  await settled(page);
  assert.deepEqual(await ends(), start);
  await nextFrame(page);
  assert.deepEqual(await middleOf('#handle-B'), [x, y]);
  assert.equal(await page.isDisabled('#redo'), true);
});

/** A finger on a handle, and what it does next. @param {string} handle */
async function fingerOn(handle) {
  const [x, y] = await middleOf(handle);
  const session = await browser.context.newCDPSession(page);
  const touch = (/** @type {string} */ type, /** @type {number} */ step) =>
    session.send('Input.dispatchTouchEvent', {
      type: /** @type {any} */ (type),
      touchPoints: type === 'touchEnd' ? [] : [{ x: x + 7 * step, y: y + 2 * step }],
    });
  await touch('touchStart', 0);
  return touch;
}

test('by finger, Escape and the end of a drag leave no ring', async () => {
  await openEntry(page, 'ellipsoid');
  for (const key of ['Escape', '']) {
    const touch = await fingerOn('#handle-A');
    for (let step = 1; step <= 3; step++) await touch('touchMove', step);
    if (key) await page.keyboard.press(key);
    await touch('touchMove', 4);
    await touch('touchEnd', 4);
    await nextFrame(page);
    assert.equal(await page.evaluate(() => document.activeElement?.tagName), 'BODY', key);
  }
  await settled(page);
});

test('by finger, on an implicit surface', async () => {
  await openEntry(page, 'ellipsoid');
  const before = await length();
  const touch = await fingerOn('#handle-A');
  for (let step = 1; step <= 6; step++) await touch('touchMove', step);
  await touch('touchEnd', 6);
  await page.waitForTimeout(250);
  await settled(page);
  assert.notEqual(await length(), before);
  assert.equal(await page.getAttribute('#status', 'data-status'), 'converged');
  assert.equal(await page.evaluate(() => document.scrollingElement?.scrollTop), 0, 'the page does not scroll');
});

test('written beside an implicit surface, an end stays as it is written until its fields are left, then is said where it is', async () => {
  await openEntry(page, 'sphere');
  const written = () => Promise.all([0, 1, 2].map(async (i) => Number(await page.inputValue(`#end-0-${i}`))));
  const away = (/** @type {number[]} */ place) => Math.abs(Math.hypot(...place) - Math.hypot(...radius));
  const radius = await written();
  for (const [i, share] of [1.02, 0.97, 1.03].entries()) await page.fill(`#end-0-${i}`, (share * radius[i] + 0.01).toFixed(3));
  await page.waitForTimeout(300);
  await settled(page);
  assert.deepEqual(
    await written(),
    [1.02, 0.97, 1.03].map((share, i) => Number((share * radius[i] + 0.01).toFixed(3))),
  );
  assert.ok(away(await written()) > 1e-3, String(await written()));
  const found = await length();
  await page.focus('#points');
  await page.waitForTimeout(100);
  assert.ok(away(await written()) < 5e-5, String(await written()));
  // One coordinate more goes with the others as they are read.
  const [, y, z] = await written();
  await page.fill('#end-0-0', '0.2');
  assert.deepEqual(await written(), [0.2, y, z]);
  await page.waitForTimeout(300);
  await settled(page);
  assert.notEqual(await length(), found);
});

test('by keys, and back by undo', async () => {
  await openEntry(page, 'parametricTorus');
  const before = await length();
  await page.focus('#handle-B');
  // Both at once: a busy machine would take its time between them.
  await Promise.all([page.keyboard.press('ArrowRight'), page.keyboard.press('ArrowUp')]);
  await page.waitForTimeout(250);
  await settled(page);
  const after_ = await length();
  assert.ok(Math.abs(after_ - before) > 1e-3 && Math.abs(after_ - before) < 1, 'two steps of some pixels');
  await page.keyboard.press('Control+z');
  await page.waitForTimeout(250);
  await settled(page);
  assert.equal(await length(), before, 'quick steps of one handle are undone together');
  await page.keyboard.press('Control+Shift+z');
  await page.waitForTimeout(250);
  await settled(page);
  assert.equal(await length(), after_);
});

test('a drag is one step of undo, however long the hand rests in it, and the next one another', async () => {
  await openEntry(page, 'saddle');
  const start = await ends();
  const drag = async (/** @type {number} */ rest) => {
    const [x, y] = await middleOf('#handle-B');
    const other = await middleOf('#handle-A');
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 0.05 * (other[0] - x), y + 0.05 * (other[1] - y));
    await page.waitForTimeout(rest);
    await page.mouse.move(x + 0.1 * (other[0] - x), y + 0.1 * (other[1] - y));
    await page.mouse.up();
    await nextFrame(page);
    return ends();
  };
  const first = await drag(1100);
  await drag(0);
  for (const expected of [first, start]) {
    await page.click('#undo');
    await page.waitForTimeout(250);
    await settled(page);
    assert.deepEqual(await ends(), expected);
  }
});

test('the path that follows is called shortest only once the others were looked for', async () => {
  await openEntry(page, 'parametricTorus');
  await page.check('[name=task][value=all]');
  await page.waitForTimeout(300);
  await settled(page);
  await page.locator('#paths button').nth(2).click();
  const name = () => page.textContent('.legend-path');
  assert.equal(await name(), 'Geodesic');
  // In one go: nothing has time to settle.
  const during = await page.evaluate(() => {
    const input = /** @type {HTMLInputElement} */ (document.getElementById('end-1-0'));
    input.value = String(Number(input.value) + 0.01);
    input.dispatchEvent(new InputEvent('input', { bubbles: true }));
    return document.querySelector('.legend-path')?.textContent;
  });
  assert.equal(during, 'Geodesic');
  await page.waitForTimeout(250);
  await settled(page);
  assert.equal(await name(), 'Shortest path');
});

test('in the plane of the parameters', async () => {
  await openEntry(page, 'saddle');
  const start = await ends();
  await page.locator('#plane').scrollIntoViewIfNeeded();
  const [x, y] = await middleOf('[data-end="0"] .target');
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 30, y + 20, { steps: 5 });
  await page.mouse.up();
  await page.waitForTimeout(250);
  await settled(page);
  const end = await ends();
  assert.ok(end[0] > start[0] && end[1] < start[1], 'A went to the right and down');
  assert.deepEqual(end.slice(2), start.slice(2));
});

test('a point on the way is added, moved by keys, and removed', async () => {
  await openEntry(page, 'saddle');
  const shortest = await length();
  await page.click('#add-via');
  await settled(page);
  await page.waitForSelector('#handle-1');
  const handles = await page.$$eval('.surfpath-handle', (all) => all.map(({ id }) => id));
  assert.deepEqual(handles, ['handle-A', 'handle-1', 'handle-B'], 'in the order of the way');
  await page.focus('#handle-1');
  for (let i = 0; i < 3; i++) await page.keyboard.press('Shift+ArrowUp');
  await page.waitForTimeout(300);
  await settled(page);
  assert.ok((await length()) > shortest + 1e-3, 'a detour is longer');
  await page.focus('#handle-1');
  await page.keyboard.press('Delete');
  await page.waitForTimeout(300);
  await settled(page);
  assert.equal(await page.locator('.surfpath-handle').count(), 2);
  assert.ok(Math.abs((await length()) - shortest) < 1e-8);
});

test('points on the way that are added in a hurry are as many, each elsewhere', async () => {
  await openEntry(page, 'lake');
  await page.evaluate(() => {
    for (let i = 0; i < 3; i++) document.getElementById('add-via')?.click();
  });
  await page.waitForSelector('#handle-3');
  await settled(page);
  const all = await page.$$eval('#ends .end', (rows) =>
    rows.map((row) => [...row.querySelectorAll('input')].map(({ value }) => value).join()),
  );
  assert.equal(new Set(all).size, 5, all.join(' '));
});

test('points on the way divide its longest leg, eight at most; a number that is missing is said, and its point not drawn', async () => {
  await openEntry(page, 'saddle');
  const add = page.locator('#add-via');
  for (let i = 0; i < 8; i++) {
    await add.click();
    await page.waitForTimeout(100);
    await settled(page);
  }
  assert.equal(await add.isDisabled(), true);
  assert.match((await add.getAttribute('title')) ?? '', /8 points at most/);
  const across = await page.$$eval('#ends input[name$="-0"]', (all) =>
    all.map((one) => Number(/** @type {HTMLInputElement} */ (one).value)),
  );
  const [a, b, ...via] = across;
  assert.deepEqual(
    via,
    [...via].sort((one, other) => Math.sign(b - a) * (one - other)),
    'in the order of the way',
  );
  await page.fill('#end-3-0', '');
  await page.waitForTimeout(250);
  await settled(page);
  assert.match((await page.textContent('#ends-problem')) ?? '', /^Point 2 needs a number for u,/);
  assert.equal(await page.locator('.surfpath-handle').count(), 9);
  assert.equal(await page.locator('#plane .via').count(), 7);
});

test('the console stayed silent', () => {
  assert.deepEqual(complaints, []);
});
