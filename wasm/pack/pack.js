// Writes a WebAssembly module as the text of a JavaScript module: its bytes by kind, which saves 13 %, behind the module that puts them together again
// (regroup.c), gzip, base64. web/runtime/unpack.js is the way back.
import { execFileSync } from 'node:child_process';
import { readFileSync, rmSync, writeFileSync } from 'node:fs';
import { FIRST, KINDS } from '../../web/runtime/unpack.js';

const [input, regrouper, output] = process.argv.slice(2);
const module = readFileSync(input);
const { exports } = new WebAssembly.Instance(new WebAssembly.Module(readFileSync(regrouper)));
const { memory, regroup } = /** @type {any} */ (exports);

// One behind the other: where each heap is written next, the module, and as much room for each kind.
const place = FIRST + 4 * KINDS;
memory.grow(1 + (((KINDS + 1) * module.length) >> 16));
const starts = Array.from({ length: KINDS }, (_, kind) => place + (kind + 1) * module.length);
const next = new Uint32Array(memory.buffer, FIRST, KINDS);
next.set(starts);
new Uint8Array(memory.buffer).set(module, place);
regroup(place, module.length, FIRST, 1);
const heaps = starts.map((start, kind) => new Uint8Array(memory.buffer).subarray(start, next[kind]));

// zopfli divides a file into blocks of deflate where its frequencies change, as they do from heap to heap: 6 % less than zlib with a block for each heap.
const scratch = `${output}.bytes`;
const code = readFileSync(regrouper);
const lengths = new Uint8Array(Uint32Array.from([code, ...heaps], ({ length }) => length).buffer);
writeFileSync(scratch, Buffer.concat([lengths, code, ...heaps]));
const text = execFileSync('zopfli', ['--i100', '-c', scratch]).toString('base64');
rmSync(scratch);
// A tagged template is a call, which minifiers leave where it stands: a string is moved to its only use, amid a line of code.
writeFileSync(output, `// Generated: surfpath.wasm by kinds of bytes, gzip in base64.\nexport default String.raw\`${text}\`;\n`);
