// What one undo takes back: a gesture from press to release, or quick steps of the same thing.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { History } from '../../../demo/state/history.js';

/** Lets the time pass after which two changes are two. @param {import('node:test').TestContext} context */
function clock(context) {
  let now = 0;
  context.mock.method(performance, 'now', () => now);
  return { wait: (/** @type {number} */ milliseconds) => (now += milliseconds) };
}

test('quick changes of the same thing are one step, slow ones and those of others are not', (context) => {
  const { wait } = clock(context);
  /** @type {History<number>} */ const history = new History();
  history.keep(0, 'a');
  wait(300);
  history.keep(1, 'a');
  wait(300);
  history.keep(2, 'b');
  wait(2000);
  history.keep(3, 'b');
  assert.deepEqual([history.undo(4), history.undo(3), history.undo(2), history.canUndo], [3, 2, 0, false]);
  assert.deepEqual([history.redo(0), history.redo(2), history.redo(3)], [2, 3, 4]);
});

test('a gesture is one step, however long it rests, and the next one another, however soon', (context) => {
  const { wait } = clock(context);
  /** @type {History<number>} */ const history = new History();
  history.hold();
  history.keep(0, 'a');
  wait(5000);
  history.keep(1, 'a');
  history.release();
  history.hold();
  history.keep(2, 'a');
  history.release();
  history.keep(3, 'a');
  assert.deepEqual([history.undo(4), history.undo(3), history.undo(2), history.canUndo], [3, 2, 0, false]);
});

test('a change that is forgotten was never there: what could be done again before it still can', () => {
  const history = new History();
  history.keep('a', 'end');
  assert.equal(history.undo('b'), 'a');
  history.keep('a', 'end');
  assert.equal(history.forget(), 'a');
  assert.equal(history.canUndo, false);
  assert.equal(history.redo('a'), 'b');
});
