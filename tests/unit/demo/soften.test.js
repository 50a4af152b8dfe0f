// Colours where what is drawn jumps between two vertices.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { soften } from '../../../demo/compute/soften.js';

test('beside a jump vertices have the mean of the cell around them, elsewhere their own value; twins what theirs have', () => {
  const row = 5;
  const jump = (/** @type {number} */ u) => (u < 0.3 ? 1 : 5);
  const places = Float64Array.from(Array.from({ length: row * row }, (_, i) => [Math.floor(i / row) / 4, (i % row) / 4]).flat());
  const values = Float64Array.from([...Array.from({ length: row * row }, (_, i) => jump(places[2 * i])), jump(0.25)]);
  const ranges = { u: [0, 1], v: [0, 1] };
  const softened = soften(values, places, [row], ranges, (there) => {
    assert.ok(
      there.every((x) => x >= 0 && x <= 1),
      'inside the rectangle',
    );
    return Float64Array.from({ length: there.length / 2 }, (_, k) => jump(there[2 * k]));
  });
  /* u = 0.25: cells reach from 0.125 to 0.375, one place of four lies beyond 0.3. */
  for (const [line, expected] of [1, 2, 5, 5, 5].entries()) assert.equal(softened[row * line + 2], expected, `line ${line}`);
  assert.equal(softened[row * row], 2);
  assert.equal(values[row], 1);
});
