// Labels of the lines in the view: beside their own line, over nothing else, the first ones before the others.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { boxOf, LEADER, placeLabels } from '../../../demo/stage/place-labels.js';

const FRAME = { left: 0, top: 0, right: 400, bottom: 300 };
const SIZE = [50, 20];

/** A bow from (50, 150) to (350, 150). @param {number} height */
const bow = (height) => Array.from({ length: 61 }, (_, i) => [50 + 5 * i, 150 - height * Math.sin((Math.PI * i) / 60)]);

/** @param {number[]} heights */
const labelsOf = (...heights) => heights.map((height) => ({ line: bow(height), size: SIZE }));

/** @param {import('../../../demo/stage/place-labels.js').Place | null} place */
function boxAt(place) {
  assert.ok(place);
  return boxOf(place.x, place.y, place.side, SIZE);
}

/** @param {ReturnType<typeof boxOf>} a @param {ReturnType<typeof boxOf>} b */
const isApart = (a, b) => a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top;

test('each stands beside a point of its own line, over no other label and no obstacle, inside the frame', () => {
  const labels = labelsOf(120, 60, 0, -60, -120);
  const obstacle = { left: 150, top: 0, right: 250, bottom: 200 };
  const places = placeLabels(labels, [obstacle], FRAME);
  const boxes = places.map(boxAt);
  for (const [i, box] of boxes.entries()) {
    const place = places[i];
    assert.deepEqual([place?.x, place?.y], labels[i].line[place?.at ?? -1]);
    assert.ok(isApart(box, obstacle), `${i} covers the obstacle`);
    assert.ok(box.left >= 0 && box.top >= 0 && box.right <= 400 && box.bottom <= 300, `${i} leaves the frame`);
    for (const other of boxes.slice(0, i)) assert.ok(isApart(box, other), `${i} covers another label`);
  }
});

test('a label stands off its point by the leader', () => {
  assert.deepEqual(boxOf(100, 100, 'right', SIZE), { left: 100 + LEADER, right: 150 + LEADER, top: 90, bottom: 110 });
  assert.deepEqual(boxOf(100, 100, 'above', SIZE), { left: 75, right: 125, top: 80 - LEADER, bottom: 100 - LEADER });
});

test('the first ones have the room that there is', () => {
  const narrow = { left: 0, top: 100, right: 400, bottom: 150 };
  const places = placeLabels(labelsOf(20, 25, 30, 35, 40, 10, 15, 12), [], narrow);
  assert.ok(places[0]);
  assert.ok(places.some((place) => place === null));
});

test('a line that cannot be told from another one has no label, except the first', () => {
  const [first, second] = placeLabels(labelsOf(50, 51), [], FRAME);
  assert.ok(first);
  assert.equal(second, null);
});

test('a label stays where it was while another place is hardly better', () => {
  const [label] = labelsOf(100);
  const [before] = placeLabels([label], [], FRAME);
  const moved = { ...label, line: label.line.map(([x, y], i) => [x, y - (i < 30 ? 1 : 0)]), last: before };
  const [after] = placeLabels([moved], [], FRAME);
  assert.deepEqual([after?.at, after?.side], [before?.at, before?.side]);
});

test('nowhere on the screen there is no label', () => {
  const away = bow(10).map(([x, y]) => [x + 1000, y]);
  assert.deepEqual(placeLabels([{ line: away, size: SIZE }], [], FRAME), [null]);
  assert.deepEqual(placeLabels([{ line: [], size: SIZE }], [], FRAME), [null]);
});
