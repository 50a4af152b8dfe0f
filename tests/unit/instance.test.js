// Loading, and what cannot be loaded.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { describe, test } from 'node:test';
import { gallery } from '../../web/gallery.js';
import { load } from '../../web/index.js';
import { anything } from '../helpers/refuses.js';

const surfpath = await load();
const saddle = surfpath.surface(gallery.saddle);

describe('load', () => {
  test('refuses misuse', async () => {
    await assert.rejects(load(anything(null)), /load: options must be an object, not null/);
    await assert.rejects(load(anything({ wsam: 1 })), /load: there is no option 'wsam'; the options are wasm/);
    await assert.rejects(
      load(anything({ wasm: 5 })),
      /load: options.wasm must be a URL, a string, a Response, bytes or a WebAssembly.Module/,
    );
    const empty = new Uint8Array([0, 0x61, 0x73, 0x6d, 1, 0, 0, 0]);
    for (const wasm of [new Uint8Array(4), empty])
      await assert.rejects(load({ wasm }), { name: 'TypeError', message: 'load: options.wasm is not surfpath.wasm' });
    const page = new Response('<!doctype html>');
    Object.defineProperty(page, 'url', { value: 'http://localhost/surfpath.wasm' });
    await assert.rejects(load({ wasm: page }), {
      name: 'TypeError',
      message: 'load: http://localhost/surfpath.wasm is not surfpath.wasm',
    });
    await assert.rejects(load({ wasm: page }), { message: 'load: http://localhost/surfpath.wasm was read before; pass the bytes' });
  });

  test('takes the module as bytes, a file: URL, or compiled', async () => {
    const url = new URL('../../dist/surfpath.wasm', import.meta.url);
    const module = new WebAssembly.Module(readFileSync(url));
    for (const wasm of [url, url.href, module]) {
      const instance = await load({ wasm });
      const path = instance.surface(gallery.saddle).shortestPath([-0.9, 0.1], [0.5, 0.9]);
      assert.deepEqual(path, saddle.shortestPath([-0.9, 0.1], [0.5, 0.9]));
      instance.dispose();
    }
  });
});
