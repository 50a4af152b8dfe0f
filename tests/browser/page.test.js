// The demo page in headless Chromium: first scene, formulas, ends, options, playing. The sites of the page that need other hands have files of their own.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { ENTRIES } from '../../demo/state/entries.js';
import { KINDS } from '../../demo/state/kinds.js';
import { fromHash } from '../../demo/state/link.js';
import { load } from '../../web/index.js';
import {
  COARSE,
  measurePicture,
  openBrowser,
  openEntry,
  openPage,
  openSettled,
  openSketch,
  pictureOfView,
  settled,
} from '../helpers/page.js';

/** @type {Awaited<ReturnType<typeof openBrowser>>} */ let browser;
/** @type {import('playwright-core').Page} */ let page;
/** @type {string[]} */ let complaints;

const text = async (/** @type {string} */ selector) => (await page.textContent(selector)) ?? '';
const status = () => page.getAttribute('#status', 'data-status');
const length = async () => Number.parseFloat(await text('#length'));

/** Does something, and waits until what follows from it is computed. @param {() => Promise<unknown>} act */
async function doing(act) {
  const before = await text('#length');
  await act();
  await page.waitForTimeout(50);
  await settled(page);
  return before;
}

before(async () => {
  ({ browser, page, complaints } = await openSettled([], COARSE));
});

after(() => browser?.close());

test('the first scene is the torus, its path shorter than the straight start', async () => {
  assert.equal(await text('#entry-title'), 'Torus, parametric');
  assert.equal(await status(), 'converged');
  assert.ok((await length()) < Number.parseFloat(await text('#start-length')));
  assert.match(await text('#time'), /^[\d.]+ ms$/);
  // One number of steps, in the strip and in the player.
  const steps = await text('#iterations');
  assert.ok(Number(steps) > 2);
  assert.equal(await text('#moment-words'), `Newton step ${steps} of ${steps}`);
  assert.deepEqual(await Promise.all(['#algorithm', '#tolerance', '#start', '#points'].map((id) => page.inputValue(id))), [
    'elements',
    '1e-9',
    'global',
    '64',
  ]);
  assert.equal(await page.locator('#poster').count(), 0, 'the picture that stood in for the scene is gone');
});

test('the formula stands typeset above its fields', async () => {
  assert.equal(await page.locator('#typeset math').count(), 3);
  assert.match(await text('#typeset'), /R\s*\+\s*a/);
});

test('numbers with powers of ten are typeset as such, and no two beside each other as one', async () => {
  const texts = { x: '1e12*cos(u)', y: '2.5e-9*v', z: '2*3^2*u' };
  await openSketch(page, { entry: 'own-parametric', texts });
  const rows = await page.$$eval('#typeset .equation', (all) => all.map(({ textContent }) => textContent));
  assert.deepEqual(rows, ['x=1012\u2009cos\u2061(u)', 'y=2.5·10−9\u2009v', 'z=2·32\u2009u']);
  assert.equal(await page.locator('#typeset msup').count(), 3);
  await openEntry(page, 'parametricTorus');
});

test('an equation stands typeset as it is written; what is 0 is said to be', async () => {
  for (const [f, words] of [
    ['x^2+y^2+z^2=1', 'x2+y2+z2=1'],
    ['x^2+y^2+z^2-1', 'x2+y2+z2−1=0'],
  ]) {
    await openSketch(page, { entry: 'own-implicit', texts: { f } });
    assert.equal(await text('#typeset'), words);
  }
  // Each side may be broken, and none is cut.
  await openSketch(page, { entry: 'own-implicit', texts: { f: '(x^2+y^2+z^2+0.7^2-0.3^2)^2=4*0.7^2*(x^2+y^2)' } });
  assert.equal(await page.$eval('#typeset', ({ scrollWidth, clientWidth }) => scrollWidth - clientWidth), 0);
  await openEntry(page, 'parametricTorus');
});

test('the length has the digits that it is known to, and its error estimate', async () => {
  await doing(() => page.selectOption('#tolerance', '1e-12'));
  assert.match(await text('#length'), /^\d\.\d{8}$/);
  assert.equal(await text('#length-error'), 'error < 10⁻⁸');
  assert.match((await page.getAttribute('#length-error', 'title')) ?? '', /± \d × 10⁻\S+$/);
  await doing(() => page.selectOption('#algorithm', 'polyline'));
  assert.match(await text('#length'), /^\d\.\d{4,6}$/);
  assert.match(await text('#length-error'), /^± 0\.000\d+$/);
  await doing(() => page.selectOption('#algorithm', 'elements'));
  await doing(() => page.selectOption('#tolerance', '1e-9'));
});

describe('each kind of surface has its own fields', () => {
  for (const [kind, { title, formulas, ranges, coordinates }] of Object.entries(KINDS)) {
    test(title, async () => {
      await doing(() => page.check(`input[name=kind][value=${kind}]`));
      assert.equal(await status(), 'converged', await text('#advice'));
      const names = await page.$$eval('#fields textarea', (fields) => fields.map(({ id }) => id));
      assert.deepEqual(
        names,
        Object.keys(formulas).map((name) => `field-${name}`),
      );
      assert.equal(await page.locator('#fields .range').count(), ranges.length);
      assert.equal(await page.locator('#ends input').count(), 2 * coordinates.length);
      const last = page.locator('#fields textarea').last();
      const formula = await last.inputValue();
      const before = await text('#length');
      await last.fill(`${formula}+oops`);
      await page.waitForSelector(`[id="problem-${Object.keys(formulas).at(-1)}"] pre`);
      assert.equal(await text('#length'), before);
      const [, variable] = /\((\w)/.exec(Object.values(formulas).at(-1) ?? '') ?? [];
      await last.fill(`${formula}+0.01*${variable}^2`);
      await page.waitForFunction((old) => ![old, '–'].includes(document.getElementById('length')?.textContent ?? ''), before);
      await settled(page);
      assert.equal(await status(), 'converged', await text('#advice'));
      const { warm } = await measurePicture(page, await pictureOfView(page));
      assert.ok(warm > 60, `only ${warm} pixels of the path are seen`);
    });
  }
});

test('all that the gallery has comes to rest; across creases, whose names the build made short, too', async () => {
  for (const name of process.env.EVERY_RELEASE ? Object.keys(ENTRIES) : ['lake']) {
    await openEntry(page, name);
    assert.equal(await status(), 'converged', name);
  }
});

test('where abs, min, max and sign leave creases the built page finds what the library does', async () => {
  const surfpath = await load();
  const [across, around] = [
    [
      [-1.9, -1.2],
      [1.8, 1.4],
    ],
    [
      [1, 0.2, -0.3],
      [-0.4, 1, 0.3],
    ],
  ];
  /** @type {[object, number[][]][]} */
  const asked = [
    [{ kind: 'graph', z: 'abs(x)-abs(y)' }, across],
    [{ kind: 'graph', z: '0', density: '2 + sign(sin(3x)*sin(3y))' }, across],
    [{ kind: 'implicit', f: 'max(abs(x),abs(y),abs(z))-1' }, around],
  ];
  for (const [{ kind, density, ...formula }, ends] of /** @type {[any, number[][]][]} */ (asked)) {
    const { title: _, ...own } = ENTRIES[`own-${kind}`];
    const path = surfpath.surface(/** @type {any} */ ({ ...own, ...formula, density })).shortestPath(ends[0], ends[1]);
    await openSketch(page, { entry: `own-${kind}`, texts: formula, density, ends });
    assert.equal(await status(), 'converged', JSON.stringify(formula));
    assert.ok(path.converged && Math.abs((await length()) - path.length) <= 1e-7, `${await length()}, not ${path.length}`);
  }
});

test('what is written of a kind is there again after a look at another one', async () => {
  await openEntry(page, 'own-graph');
  await doing(() => page.fill('#field-z', 'x^3'));
  for (const kind of ['tube', 'graph']) await doing(() => page.check(`[name=kind][value=${kind}]`));
  assert.equal(await page.inputValue('#field-z'), 'x^3');
});

test('an element of a list of formulas is marked in its own field, and so is a range', async () => {
  await openEntry(page, 'trefoil');
  await page.locator('[id="field-centreline[1]"]').fill('cos(t)-2*kos(2*t)');
  await page.waitForSelector('[id="problem-centreline[1]"] pre');
  const [formula, caret] = (await text('[id="problem-centreline[1]"] pre')).split('\n');
  assert.equal(caret.indexOf('^'), formula.indexOf('kos'));
  assert.match(await text('[id="problem-centreline[1]"] p'), /^[^[]*kos/);
  await openEntry(page, 'vase');
  await page.fill('#field-t-to', '4*');
  await page.waitForSelector('#problem-t-to pre');
  await openEntry(page, 'sphere');
  await page.fill('#field-x-from', 'left');
  await page.waitForSelector('#problem-x-from p');
});

test('a mistake in a formula is marked at its character, and the last good surface stays', async () => {
  await openEntry(page, 'saddle');
  const [before, picture] = [await text('#length'), await pictureOfView(page)];
  await page.fill('#field-z', 'u^2-foo(v)');
  await page.waitForSelector('#problem-z pre');
  const [formula, caret] = (await text('#problem-z pre')).split('\n');
  assert.equal(formula, 'u^2-foo(v)');
  assert.equal(caret.indexOf('^'), formula.indexOf('foo'));
  assert.match(await text('#problem-z p'), /foo/);
  assert.equal(await page.getAttribute('#field-z', 'aria-invalid'), 'true');
  assert.equal(await page.evaluate(() => document.activeElement?.id), 'field-z');
  assert.equal(await text('#length'), before);
  assert.ok(picture.equals(await pictureOfView(page)), 'the picture changed');
  assert.equal(await text('#entry-title'), 'Saddle', 'the gallery speaks of the surface that is shown');
  await doing(() => page.fill('#field-z', 'u^2-v'));
  await page.waitForSelector('#problem-z', { state: 'hidden' });
  await page.waitForFunction((old) => ![old, '–'].includes(document.getElementById('length')?.textContent ?? ''), before);
  await settled(page);
  assert.equal(await page.getAttribute('#field-z', 'aria-invalid'), null);
  assert.equal(await text('#entry-title'), 'Saddle, changed');
  assert.equal(await status(), 'converged');
});

test('a mistake in a long formula is shown with what is around it', async () => {
  await openEntry(page, 'threeTori');
  await page.fill('#field-f', `${await page.inputValue('#field-f')}+nonsense`);
  await page.waitForSelector('#problem-f pre');
  const [formula, caret] = (await text('#problem-f pre')).split('\n');
  assert.ok(formula.slice(caret.indexOf('^')).startsWith('nonsense'));
});

test('an unknown name becomes a slider, and the slider deforms surface and path', async () => {
  await openEntry(page, 'saddle');
  await page.fill('#field-z', 'k*u^2-v^2');
  await page.click('#problem-z .offer');
  await page.waitForSelector('#parameter-k');
  await settled(page);
  const before = await length();
  assert.equal(await status(), 'converged');
  const picture = await pictureOfView(page);
  await page.fill('#parameter-k', '0.2');
  await page.waitForTimeout(400);
  await settled(page);
  assert.ok((await length()) < before, 'a flatter saddle has shorter paths');
  assert.equal(await page.inputValue('#value-k'), '0.2');
  assert.ok(!picture.equals(await pictureOfView(page)), 'the surface is drawn anew');
});

test('a slider reaches as far as its number, which is never left empty, and can go once no formula has it', async () => {
  await openEntry(page, 'parametricTorus');
  await doing(() => page.fill('#value-a', '7.3'));
  assert.equal(Number(await page.inputValue('#parameter-a')), 7.3);
  await page.fill('#value-a', '');
  assert.equal(await text('#sliders-problem'), 'Write a number for a.');
  await page.focus('#points');
  assert.equal(await page.isVisible('#sliders-problem'), false);
  assert.equal(await page.inputValue('#value-a'), '7.3');
  await doing(() => page.fill('#value-a', '1.5'));
  assert.equal(await page.isVisible('#remove-a'), false);
  for (const [field, formula] of [
    ['x', 'R*cos(u)'],
    ['y', 'R*sin(u)'],
    ['z', 'v'],
  ])
    await page.fill(`#field-${field}`, formula);
  await page.waitForTimeout(250);
  await settled(page);
  await doing(() => page.click('#remove-a'));
  assert.equal(await page.locator('#sliders .slider').count(), 1);
  assert.equal(await status(), 'converged');
});

test('end points are numbers: a wrong one is said in words, a right one moves the path', async () => {
  await openEntry(page, 'saddle');
  const before = await text('#length');
  await page.fill('#end-1-0', '7');
  assert.match(await text('#ends-problem'), /u of B must lie between -1 and 1/);
  assert.equal(await page.getAttribute('#end-1-0', 'aria-invalid'), 'true');
  // What stands there would be in the air beside the surface.
  assert.equal(await page.locator('#handle-B').count(), 0);
  // Of no picture of the plane: SVG would complain on the console.
  await page.fill('#end-1-0', '1e40');
  assert.equal(await page.locator('#plane .end-handle').count(), 1);
  await page.fill('#end-1-0', '');
  assert.match(await text('#ends-problem'), /B needs a number for u/);
  // What is written is not read as other digits, and stays.
  await page.locator('#end-1-0').pressSequentially('0,5');
  await page.locator('#points').focus();
  assert.match(await text('#ends-problem'), /B needs a number for u, such as/);
  assert.equal(await page.inputValue('#end-1-0'), '0,5');
  await page.fill('#end-1-0', '');
  await page.locator('#end-1-0').pressSequentially('pi/8');
  assert.equal(await text('#ends-problem'), '');
  assert.equal(await page.inputValue('#end-1-0'), 'pi/8');
  assert.equal(fromHash(await page.evaluate(() => location.hash))?.ends[1][0], Math.PI / 8);
  await page.fill('#end-1-0', '0.5');
  await page.waitForTimeout(300);
  await settled(page);
  assert.equal(await status(), 'converged');
  assert.notEqual(await text('#length'), before);
  await doing(() => page.click('#random-ends'));
  assert.match(await text('#status'), /\w/);
});

test('algorithm and points change what is solved', async () => {
  await openEntry(page, 'parametricTorus');
  const exact = await length();
  await doing(() => page.selectOption('#algorithm', 'polyline'));
  assert.equal(await page.isVisible('#tolerance'), false);
  const chords = await text('#length');
  assert.ok(Number.parseFloat(chords) < exact, 'chords are shorter than the arc');
  await doing(() => page.fill('#points', '9'));
  assert.ok((await length()) < Number.parseFloat(chords));
  await page.fill('#points', '0');
  assert.match(await text('#points-problem'), /whole number/);
  await page.focus('#start');
  await doing(() => page.selectOption('#start', 'straight'));
  await doing(() => page.selectOption('#start', 'global'));
  assert.equal(await page.inputValue('#points'), '9', 'once it is left, the field has the number that counts');
  assert.equal(await page.isVisible('#points-problem'), false);
  assert.equal(await page.getAttribute('#points', 'aria-invalid'), null);
  await doing(() => page.fill('#points', '64'));
  assert.equal(await text('#length'), chords);
  await doing(() => page.selectOption('#algorithm', 'paper'));
  assert.match(await text('#status'), /\w/);
  await doing(() => page.selectOption('#algorithm', 'elements'));
  assert.equal(await length(), exact);
});

test('the straight start is as long however many points the path has', async () => {
  const starts = [];
  for (const points of [3, 64]) {
    await openSketch(page, { entry: 'parametricTorus', points });
    starts.push(await text('#start-length'));
  }
  assert.equal(starts[0], starts[1]);
});

test('all geodesics are listed with their lengths, and one can be chosen', async () => {
  await openEntry(page, 'parametricTorus');
  const shortest = await text('#length');
  await doing(() => page.check('[name=task][value=all]'));
  const lengths = (await page.locator('#paths strong').allTextContents()).map(Number);
  assert.ok(lengths.length >= 3, `${lengths.length} geodesics`);
  assert.deepEqual(
    lengths,
    [...lengths].sort((a, b) => a - b),
  );
  await page.locator('#paths button').nth(1).click();
  assert.ok(Math.abs((await length()) - lengths[1]) < 1e-6);
  assert.equal(await page.locator('.length-label').count(), lengths.length);
  for (const label of await page.locator('.length-label').all())
    assert.ok((await label.getAttribute('aria-label'))?.includes((await label.textContent()) ?? '?'));
  await doing(() => page.check('[name=task][value=path]'));
  assert.equal(await text('#length'), shortest);
});

test('straight ahead from A: the length is the one that was asked for', async () => {
  await openEntry(page, 'parametricTorus');
  await doing(() => page.check('[name=task][value=trace]'));
  assert.ok(Math.abs((await length()) - 6) < 1e-9);
  assert.equal(await page.locator('.surfpath-handle').count(), 1);
  await doing(() => page.fill('#reach', '11'));
  assert.ok(Math.abs((await length()) - 11) < 0.05, 'a step of the slider away at most');
});

test('straight ahead on a metric, and at a tip, where the reader is told that there is no direction', async () => {
  await openSketch(page, { entry: 'hyperbolicDisc', task: 'trace', angle: 0, reach: 1 });
  assert.equal(await status(), 'converged', await text('#advice'));
  assert.ok(Math.abs((await length()) - 1) < 1e-9);
  const cone = { r: 't', z: 't', 't-from': '0', 't-to': '2' };
  await openSketch(page, { entry: 'own-revolution', texts: cone, ends: [[1, 0]], task: 'trace' });
  assert.equal(await text('#ends-problem'), 'There is no direction at A, as at a tip: move it.');
});

test('straight ahead it goes as far as the surface is large', async () => {
  const range = { 'x-from': '499900', 'x-to': '500100', 'y-from': '4599900', 'y-to': '4600100' };
  const ends = [
    [499920, 4599930],
    [500070, 4600080],
  ];
  await openSketch(page, { entry: 'own-graph', texts: { z: '20sin((x - 500000)/30)', ...range }, ends });
  await doing(() => page.check('[name=task][value=trace]'));
  const reach = () =>
    page.$eval('#reach', (input) => [/** @type {HTMLInputElement} */ (input).valueAsNumber, Number(input.getAttribute('max'))]);
  assert.deepEqual(await reach(), [600, 4000]);
  await openEntry(page, 'parametricTorus');
  await doing(() => page.check('[name=task][value=trace]'));
  assert.deepEqual(await reach(), [6, 40]);
});

test('several starts converge to one path, and the straight one alone may miss the shortest', async () => {
  await openEntry(page, 'hills');
  const [global, start] = [await length(), await text('#start-length')];
  assert.equal(await page.isVisible('#player'), false, 'the straight start leads elsewhere: there is nothing to play');
  await doing(() => page.selectOption('#start', 'straight'));
  assert.equal(await status(), 'converged');
  assert.ok((await length()) > 1.005 * global);
  assert.match(await text('#moment-words'), /^Newton step (\d+) of \1$/);
  assert.equal(Number.parseFloat(await text('#start-length')), Number.parseFloat(start));
  await doing(() => page.selectOption('#start', 'several'));
  assert.match(await text('#moment-words'), /^Newton step (\d+) of \1$/);
  assert.ok((await length()) < 1.0001 * global, 'one of five starts leads to the shortest');
  // View, plane and strip tell of the same starts.
  assert.equal(await page.locator('#plane .straight').count(), 5);
  assert.equal(await page.isVisible('#start-figure'), false);
  assert.match(await text('#legend'), /^Geodesic\s*Starts/);
  const isOffered = () => page.$eval('#start [value=several]', (option) => !(/** @type {HTMLOptionElement} */ (option).disabled));
  assert.equal(await isOffered(), true);
  await doing(() => page.click('#add-via'));
  assert.equal(await page.inputValue('#start'), 'global');
  assert.equal(await isOffered(), false, 'they lead from end to end');
  await doing(() => page.click('[aria-label="Remove point 1"]'));
  assert.equal(await isOffered(), true);
});

test('the last good surface is told of alone, while a measure is half written', async () => {
  await openEntry(page, 'parametricTorus');
  await page.evaluate(() => document.querySelector('#measure-card')?.setAttribute('open', ''));
  await page.fill('#field-density', '1/(1+x^2)');
  await page.waitForTimeout(250);
  await settled(page);
  const before = await text('#length');
  await page.evaluate(() => {
    for (const [id, value] of [
      ['field-density', ''],
      ['field-metric.E', '1'],
    ]) {
      const field = /** @type {HTMLTextAreaElement} */ (document.getElementById(id));
      field.value = value;
      field.dispatchEvent(new InputEvent('input', { bubbles: true }));
    }
  });
  await page.waitForSelector('#status[data-old]');
  await settled(page);
  assert.deepEqual([await text('#length'), await page.isVisible('#start-figure')], [before, false]);
  await doing(() => page.click('#undo'));
});

test('a density and a metric change the path, and the presets fit any rectangle', async () => {
  await openEntry(page, 'hindered');
  const hindered = await length();
  await page.evaluate(() => document.querySelector('#measure-card')?.setAttribute('open', ''));
  await doing(() => page.click('[data-preset=none]'));
  const plain = await length();
  assert.ok(Math.abs(plain - Math.hypot(2.6, 2.15)) < 1e-8, 'on a bare plane, the straight line');
  assert.ok(hindered > plain);
  await doing(() => page.click('[data-preset=grain]'));
  assert.equal(await status(), 'converged');
  assert.ok((await length()) > plain);
  await page.fill('#field-density', '1+sin(');
  await page.waitForSelector('#problem-density pre');
});

test('what the reader colours by stays while a measure is written', async () => {
  await openEntry(page, 'saddle');
  await page.evaluate(() => document.querySelector('#measure-card')?.setAttribute('open', ''));
  const write = async (/** @type {string} */ density) => {
    await page.fill('#field-density', density);
    await page.waitForTimeout(250);
    await settled(page);
    return page.inputValue('#colour');
  };
  assert.equal(await write('1+u^2'), 'density');
  await page.selectOption('#colour', 'plain');
  assert.equal(await write('1+v^2'), 'plain');
  await page.selectOption('#colour', 'curvature');
  assert.equal(await write(''), 'curvature');
  assert.equal(await write('2'), 'curvature');
});

test('a metric over space on an implicit surface: presets, six fields, a mistake marked, a link that keeps it', async () => {
  await openEntry(page, 'own-implicit');
  const plain = await length();
  await page.evaluate(() => document.querySelector('#measure-card')?.setAttribute('open', ''));
  await doing(() => page.click('[data-preset=climb]'));
  assert.equal(await status(), 'converged', await text('#advice'));
  assert.ok((await length()) > plain, 'what counts more is longer');
  assert.equal(await page.inputValue('[id="field-metric.zz"]'), '9');
  const strokes = () => page.evaluate(() => /** @type {any} */ (window).surfpathView.strokes);
  assert.ok((await strokes()) > 100, 'the metric is drawn');
  await doing(() => page.click('[data-preset=grain]'));
  assert.equal(await status(), 'converged', await text('#advice'));
  const turning = await length();
  await doing(() => page.click('[data-preset=none]'));
  assert.equal(await length(), plain);
  assert.equal(await strokes(), 0);
  // Entries off the diagonal are 0 where nothing is written.
  for (const [name, value] of Object.entries({ xx: '4', yy: '4', zz: '4' })) await page.fill(`[id="field-metric.${name}"]`, value);
  const isTwice = async () => Math.abs((await length()) / (2 * plain) - 1) < 1e-8;
  // The page waits for the end of what is typed, on a busy machine for long.
  for (let i = 0; i < 50 && !(await isTwice()); i++) await page.waitForTimeout(100);
  await settled(page);
  assert.ok(await isTwice(), 'four times the metric is twice the length');
  assert.equal(await page.inputValue('[id="field-metric.xy"]'), '0');
  await page.waitForSelector('#scale:not([hidden])');
  assert.match(await text('#scale'), /Length counts/);
  await page.fill('[id="field-metric.zz"]', '4+k');
  await page.waitForSelector('[id="problem-metric.zz"] pre');
  assert.match(await text('[id="problem-metric.zz"] p'), /^Unknown name k/);
  assert.notEqual(turning, plain);
});

test('a surface that is small in its box is drawn as it is', async () => {
  await openEntry(page, 'own-implicit');
  await page.fill('#field-f', 'x^2+y^2+z^2-1');
  for (const axis of ['x', 'y', 'z'])
    for (const [end, value] of [
      ['from', '-1e6'],
      ['to', '1e6'],
    ])
      await page.fill(`#field-${axis}-${end}`, value);
  await page.waitForTimeout(400);
  await settled(page);
  assert.equal(await status(), 'converged');
  const { count, radius } = await page.evaluate(() => {
    const { geometry } = /** @type {any} */ (window).surfpathView.surface;
    return { count: geometry.getAttribute('position').count, radius: geometry.boundingSphere.radius };
  });
  assert.ok(count > 1000, `${count} vertices`);
  assert.ok(radius > 0.99 && radius < 1.2, `radius ${radius}`);
});

test('the iterates play in about a second, and can be scrubbed', async () => {
  await openEntry(page, 'parametricTorus');
  await page.emulateMedia({ reducedMotion: 'no-preference' });
  const last = Number(await page.getAttribute('#moment', 'max'));
  assert.ok(last >= 2);
  /* The quickest of a few looks counts: a machine may stand still for seconds. */
  let quickest = Infinity;
  for (let look = 0; look < 5 && quickest >= 4000; look++) {
    const begin = Date.now();
    await page.click('#play');
    assert.ok(Number(await page.inputValue('#moment')) < last);
    await page.waitForFunction((end) => /** @type {any} */ (document.getElementById('moment')).valueAsNumber === end, last);
    quickest = Math.min(quickest, Date.now() - begin);
  }
  assert.ok(quickest < 4000, `${quickest} ms`);
  await page.fill('#moment', '0');
  assert.equal(await text('#moment-words'), `Newton step 0 of ${last}`);
  await page.emulateMedia({ reducedMotion: 'reduce' });
});

test('an arrow key plays one step', async () => {
  await openEntry(page, 'parametricTorus');
  const last = Number(await page.getAttribute('#moment', 'max'));
  await page.focus('#moment');
  await page.keyboard.press('ArrowLeft');
  assert.equal(await text('#moment-words'), `Newton step ${last - 1} of ${last}`);
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press('ArrowUp');
  assert.equal(await text('#moment-words'), `Newton step ${last} of ${last}`);
});

test('plots are measured on the path that is seen', async () => {
  await openEntry(page, 'parametricTorus');
  await page.click('#plots-card summary');
  for (const [plot, series] of /** @type {[string, number][]} */ ([
    ['convergence', 2],
    ['error', 2],
    ['time', 2],
    ['curvature', 1],
  ])) {
    await page.selectOption('#plot-choice', plot);
    await page.waitForFunction(
      ([name, count]) => document.querySelectorAll('#plot polyline.series').length === count && name,
      [plot, series],
    );
    await page.waitForFunction(() => /** @type {HTMLElement} */ (document.getElementById('progress')).hidden);
  }
  await page.selectOption('#plot-choice', 'error');
  await page.waitForFunction(() => document.querySelectorAll('#plot .series-0').length === 10);
  const titles = await page.locator('#plot circle title').allTextContents();
  const errors = titles.map((title) => Number(title.split('→')[1]));
  assert.equal(errors.length, 9);
  assert.ok(errors[4] / errors[6] > 12 && errors[4] / errors[6] < 20, 'four times the points, a sixteenth of the error');
  await page.click('#plots-card summary');
});

test('that a path in the plane of a metric is not curved in space is said, and nothing plotted before comes in its place', async () => {
  await openEntry(page, 'own-metric');
  await page.click('#plots-card summary');
  await page.evaluate(() => {
    const select = /** @type {HTMLSelectElement} */ (document.getElementById('plot-choice'));
    for (const name of ['convergence', 'curvature']) {
      select.value = name;
      select.dispatchEvent(new Event('change', { bubbles: true }));
    }
  });
  await page.waitForFunction(() => !document.documentElement.hasAttribute('data-measuring'));
  assert.equal(await text('#plot'), 'This path has no place in space, and so no curvature there.');
  await page.click('#plots-card summary');
});

test('by keys the view is turned, and comes nearer', async () => {
  /** From what is looked at to the camera: the angle around the axis, above the ground, and the distance. */
  const place = () =>
    page.evaluate(() => {
      const { camera, controls } = /** @type {any} */ (window).surfpathView;
      const { x, y, z } = camera.position.clone().sub(controls.target);
      return [Math.atan2(y, x), Math.atan2(z, Math.hypot(x, y)), Math.hypot(x, y, z)];
    });
  for (const [k, key, sign] of /** @type {const} */ ([
    [0, 'ArrowRight', -1],
    [0, 'ArrowLeft', 1],
    [1, 'ArrowDown', 1],
    [1, 'ArrowUp', -1],
    [2, '+', -1],
    [2, '-', 1],
  ])) {
    // It comes to rest softly, over many frames: this ends that.
    await page.click('#reframe');
    const before = (await place())[k];
    await page.focus('#canvas');
    await page.keyboard.press(key);
    let change = 0;
    for (let look = 0; look < 100 && !(sign * change > 0.05); look++) {
      await page.waitForTimeout(50);
      change = (await place())[k] - before;
    }
    assert.ok(sign * change > 0.05, `${key}: ${change}`);
  }
  await page.click('#reframe');
});

test('nothing is drawn when nothing moves', async () => {
  await page.waitForTimeout(500);
  const frames = await page.evaluate(async () => {
    let count = 0;
    const request = window.requestAnimationFrame;
    window.requestAnimationFrame = (callback) => {
      count++;
      return request.call(window, callback);
    };
    await new Promise((resolve) => setTimeout(resolve, 300));
    window.requestAnimationFrame = request;
    return count;
  });
  assert.equal(frames, 0);
});

test('without WebGL the page says so, and still computes', async () => {
  const other = await openBrowser(['--disable-3d-apis']);
  try {
    const { page: plain } = await openPage(other.context, other.address);
    await plain.waitForSelector('#notice:not([hidden])');
    assert.match((await plain.textContent('#notice')) ?? '', /WebGL/);
    await plain.waitForFunction(() => document.getElementById('status')?.dataset.status === 'converged');
  } finally {
    await other.close();
  }
});

test('without WebAssembly the page says so', async () => {
  const own = await openBrowser([], COARSE);
  const plain = await own.context.newPage();
  await plain.addInitScript(() => {
    // @ts-expect-error a browser without it
    delete window.WebAssembly;
  });
  await plain.goto(own.address);
  await plain.waitForSelector('#notice:not([hidden])');
  assert.match((await plain.textContent('#notice')) ?? '', /WebAssembly/);
  await own.close();
});

test('the console stayed silent', () => {
  assert.deepEqual(complaints, []);
});
