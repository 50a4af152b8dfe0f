/* malloc and free of wasm/memory.c. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { createRandom } from '../../helpers/random.js';
import { instantiate } from '../../helpers/wasm.js';

const PAGE = 65_536;

test('blocks hold what is written to them while others come and go', () => {
  const { malloc, free, memory } = instantiate().exports;
  const { next: random } = createRandom(7);
  const begin = malloc(1);
  free(begin);
  /** @type {{ at: number, bytes: number, mark: number }[]} */
  const blocks = [];
  const fill = (/** @type {number} */ at, /** @type {number} */ bytes) => new Uint8Array(memory.buffer, at, bytes);
  for (let round = 0; round < 3_000; round++) {
    if (blocks.length > 40 || (blocks.length > 0 && random() < 0.45)) {
      const [{ at, bytes, mark }] = blocks.splice(Math.floor(random() * blocks.length), 1);
      assert.ok(fill(at, bytes).every((byte) => byte === mark));
      free(at);
    } else {
      const bytes = Math.floor(10 ** (random() * 5));
      const at = malloc(bytes);
      assert.equal(at % 8, 0);
      const mark = round & 255;
      fill(at, bytes).fill(mark);
      blocks.push({ at, bytes, mark });
    }
  }
  for (const { at } of blocks) free(at);
  const pages = memory.buffer.byteLength / PAGE;
  // Given back, all is one block again: the largest that there was room for fits, and nothing grows.
  const whole = malloc((pages - 1) * PAGE - begin);
  assert.ok(whole > 0);
  free(whole);
  assert.equal(memory.buffer.byteLength / PAGE, pages);
});

test('memory grows by what is missing, and not where a freed block is large enough', () => {
  const { malloc, free, memory } = instantiate().exports;
  const large = malloc(100 * PAGE);
  const pages = memory.buffer.byteLength / PAGE;
  assert.ok(pages <= 118, `${pages} pages`);
  free(large);
  assert.equal(malloc(100 * PAGE), large);
  free(large);
  assert.equal(malloc(110 * PAGE), large);
  assert.ok(memory.buffer.byteLength / PAGE <= 128);
});

test('what memory cannot hold is refused, and leaves it in order', () => {
  const { malloc, free } = instantiate().exports;
  for (const bytes of [2 ** 31, 2 ** 32 - 24, 2 ** 32 - 1]) assert.equal(malloc(bytes), 0, `${bytes}`);
  const at = malloc(1000);
  assert.ok(at > 0);
  free(at);
  assert.equal(malloc(1000), at);
});
