// Writes a WebAssembly module as the text of a JavaScript module: its bytes by kind, which saves 13 %, gzip, base64. web/runtime/unpack.js is the way back.
import { readFileSync, writeFileSync } from 'node:fs';
import { constants, createGzip } from 'node:zlib';
import { KINDS, regroup } from '../web/runtime/kinds.js';

const [input, output] = process.argv.slice(2);
const module = readFileSync(input);
const room = new Uint8Array(KINDS * module.length);
const starts = Array.from({ length: KINDS }, (_, kind) => kind * module.length);
const ends = [...starts];
regroup(module, room, ends, true);
const heaps = starts.map((start, kind) => room.subarray(start, ends[kind]));
const lengths = new Uint8Array(Uint32Array.from(heaps, ({ length }) => length).buffer);

/** @type {Buffer[]} */
const parts = [];
const gzip = createGzip({ level: 9, memLevel: 9 });
gzip.on('data', (part) => parts.push(part));
gzip.on('end', () => {
  const text = Buffer.concat(parts).toString('base64');
  writeFileSync(output, `// Generated: surfpath.wasm by kinds of bytes, gzip in base64.\nexport default '${text}';\n`);
});
for (const heap of [lengths, ...heaps]) {
  gzip.write(heap);
  // A heap has its own frequencies: a block of deflate starts with it.
  gzip.flush(constants.Z_FULL_FLUSH);
}
gzip.end();
