/** The layout of structs in web/runtime/layout.js against the offsets that the compiler asserts in wasm/surfpath.h, and the status words against wasm/status.h. */
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { MOST_STRUCT_BYTES } from '../../../web/runtime/heap.js';
import { STATUS } from '../../../web/runtime/status.js';
import * as layout from '../../../web/runtime/layout.js';

const read = (/** @type {string} */ name) => readFileSync(new URL(`../../../wasm/${name}`, import.meta.url), 'utf8');

test('structs lie where the compiler puts them', () => {
  /** @type {Record<string, number>} */
  const asserted = {};
  for (const [, name, bytes] of read('surfpath.h').matchAll(/^SP_SIZE\((\w+), (\d+)\);/gm)) asserted[`${name}_bytes`] = Number(bytes);
  for (const [, name, field, offset] of read('surfpath.h').matchAll(/^SP_AT\((\w+), (\w+), (\d+)\);/gm))
    asserted[`${name}_${field}`] = Number(offset);
  assert.deepEqual({ ...layout }, asserted);
});

test('every struct fits into the room that calls share', () => {
  for (const [name, bytes] of Object.entries(layout)) if (name.endsWith('_bytes')) assert.ok(bytes <= MOST_STRUCT_BYTES, name);
});

test('statuses have the numbers and the words of the core', () => {
  const words = [...read('status.h').matchAll(/SP_(\w+) = (-?\d+)/g)].map(([, word, code]) => [
    Number(code),
    word.toLowerCase().replaceAll('_', '-'),
  ]);
  assert.deepEqual(new Map([...STATUS].sort()), new Map(/** @type {[number, any][]} */ (words).sort()));
});
