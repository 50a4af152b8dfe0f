// Writes a WebAssembly module as the text of a JavaScript module: its bytes by kind, which saves 13 %, gzip, base64. web/runtime/unpack.js is the way back.
import { execFileSync } from 'node:child_process';
import { readFileSync, rmSync, writeFileSync } from 'node:fs';
import { KINDS, regroup } from '../web/runtime/kinds.js';

const [input, output] = process.argv.slice(2);
const module = readFileSync(input);
const room = new Uint8Array(KINDS * module.length);
const starts = Array.from({ length: KINDS }, (_, kind) => kind * module.length);
const ends = [...starts];
regroup(module, room, ends, true);
const heaps = starts.map((start, kind) => room.subarray(start, ends[kind]));
const lengths = new Uint8Array(Uint32Array.from(heaps, ({ length }) => length).buffer);

// zopfli divides a file into blocks of deflate where its frequencies change, as they do from heap to heap: 6 % less than zlib with a block for each heap.
const scratch = `${output}.bytes`;
writeFileSync(scratch, Buffer.concat([lengths, ...heaps]));
const text = execFileSync('zopfli', ['--i100', '-c', scratch]).toString('base64');
rmSync(scratch);
// A tagged template is a call, which minifiers leave where it stands: a string is moved to its only use, amid a line of code.
writeFileSync(output, `// Generated: surfpath.wasm by kinds of bytes, gzip in base64.\nexport default String.raw\`${text}\`;\n`);
