// Rewrites constants in the text of a WebAssembly module, in place, to what takes fewer bytes. A double takes 9, of which a small integer, converted,
// needs 3 and a float, promoted, 6; engines fold it when they compile. A vector takes 18, and 6 where it is loaded from a pool in memory, which is also
// faster: V8 rebuilds a constant in three or four instructions wherever it is used. The pool lies below the linker's data, where else nothing is.
import { readFileSync, writeFileSync } from 'node:fs';

/** Where the pool may lie: short offsets first. The first eight bytes stay zero, as they are where a pointer is NULL. */
const [POOL, POOL_END] = [8, 1024];

/** As WebAssembly's text, of which `String` knows no -0. @param {number} value */
const write = (value) => (Object.is(value, -0) ? '-0' : String(value).replace('Infinity', 'inf'));

/** @param {number} value */
function shorten(value) {
  const text = write(value);
  if (Number.isInteger(value) && Math.abs(value) < 2 ** 20 && text !== '-0') return `(f64.convert_i32_s (i32.const ${text}))`;
  if (Math.fround(value) === value) return `(f64.promote_f32 (f32.const ${text}))`;
  return `(f64.const ${text})`;
}

/** Numbers of 64 bits, as text of two words. @type {string[]} */
const pool = [];

/** The address of neighbouring numbers of the pool. @param {string[]} numbers */
function place(numbers) {
  let first = pool.findIndex((_, i) => numbers.every((number, j) => pool[i + j] === number));
  if (first < 0) first = pool.push(...numbers) - numbers.length;
  return POOL + 8 * first;
}

/** @param {string} _ the constant @param {string} lanes four words, the lowest first */
function shortenVector(_, lanes) {
  const [a, b, c, d] = lanes.split(' ').map((word) => String(Number(word)));
  const [low, high] = [`${a} ${b}`, `${c} ${d}`];
  // What one instruction makes from nothing.
  if (low === high && a === b && (a === '0' || a === '4294967295')) return `(i32x4.splat (i32.const ${a === '0' ? 0 : -1}))`;
  if (low === high) return `(v128.load64_splat offset=${place([low])} (i32.const 0))`;
  return `(v128.load offset=${place([low, high])} align=8 (i32.const 0))`;
}

/** The pool as a data segment. */
function segment() {
  if (POOL + 8 * pool.length > POOL_END) throw new Error(`${pool.length} vector constants do not fit below ${POOL_END}`);
  const bytes = new Uint8Array(new Uint32Array(pool.flatMap((number) => number.split(' ').map(Number))).buffer);
  return `(data (i32.const ${POOL}) "${Array.from(bytes, (byte) => `\\${byte.toString(16).padStart(2, '0')}`).join('')}")`;
}

const file = process.argv[2];
const text = readFileSync(file, 'utf8');
const vectors = text.replace(/\(v128\.const i32x4 ([0-9a-fx ]+)\)/g, shortenVector);
const doubles = vectors.replace(/\(f64\.const (-?)([\d.e+-]+|inf)\)/g, (_, sign, size) =>
  shorten(Number(sign + size.replace('inf', 'Infinity'))),
);
writeFileSync(file, doubles.replace(/\)\s*$/, ` ${segment()}\n)\n`));
