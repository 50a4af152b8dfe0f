// Rewrites the text of a WebAssembly module, in place, to what takes fewer bytes: without the exports that the linker adds and nobody calls, functions in another
// order, constants in other words. A double takes 9, of which a small integer, converted,
// needs 3 and a float, promoted, 6; engines fold it when they compile. Loaded from a pool in memory it takes 5 or 6, and a vector so many instead of 18, which is
// also faster: V8 rebuilds a constant in three or four instructions wherever it is used. The pool lies below the linker's data, where else nothing is.
import { readFileSync, writeFileSync } from 'node:fs';

/** Where the pool may lie: short offsets first. The first eight bytes stay zero, as they are where a pointer is NULL. */
const [POOL, POOL_END] = [8, 1024];

/** As WebAssembly's text, of which `String` knows no -0. @param {number} value */
const write = (value) => (Object.is(value, -0) ? '-0' : String(value).replace('Infinity', 'inf'));

/** From so many times on a number is worth its 8 bytes in the pool. */
const OFTEN = 3;
/** Numbers of 64 bits, as text of two words. @type {string[]} */
const pool = [];
/** How often numbers of the pool, or two next to each other, are wanted. @type {Map<string, { numbers: string[], times: number }>} */
const wanted = new Map();

/** Counts, so that what is wanted most comes first. @param {string[]} numbers */
function want(...numbers) {
  const key = numbers.join();
  const times = (wanted.get(key)?.times ?? 0) + 1;
  wanted.set(key, { numbers, times });
  return '';
}

/** Where these are in the pool; −1: nowhere. @param {string[]} numbers */
const find = (...numbers) => pool.findIndex((_, i) => numbers.every((number, j) => pool[i + j] === number));

/** As an operand. @param {string[]} numbers */
const load = (...numbers) => `offset=${POOL + 8 * find(...numbers)}`;

/** @param {string} sign @param {string} size @param {(number: string) => string} place of the number in the pool, as an operand @returns {string} */
function shorten(sign, size, place) {
  const value = Number(sign + size.replace('inf', 'Infinity'));
  const text = write(value);
  if (Number.isInteger(value) && Math.abs(value) < 2 ** 20 && text !== '-0') return `(f64.convert_i32_s (i32.const ${text}))`;
  if (Math.fround(value) === value) return `(f64.promote_f32 (f32.const ${text}))`;
  const at = place(new Uint32Array(new Float64Array([value]).buffer).join(' '));
  return at ? `(f64.load ${at} (i32.const 0))` : `(f64.const ${text})`;
}

/** The bits of a double that is only stored. @param {string} bits @param {(number: string) => string} place */
function shortenBits(bits, place) {
  const at = place(new Uint32Array(new BigUint64Array([BigInt(bits)]).buffer).join(' '));
  return at ? `(i64.load ${at} (i32.const 0))` : `(i64.const ${bits})`;
}

/** @param {string} lanes four words, the lowest first @param {(...numbers: string[]) => string} place */
function shortenVector(lanes, place) {
  const [a, b, c, d] = lanes.split(' ').map((word) => String(Number(word)));
  const [low, high] = [`${a} ${b}`, `${c} ${d}`];
  // What one instruction makes from nothing.
  if (low === high && a === b && (a === '0' || a === '4294967295')) return `(i32x4.splat (i32.const ${a === '0' ? 0 : -1}))`;
  if (low === high) return `(v128.load64_splat ${place(low)} (i32.const 0))`;
  return `(v128.load ${place(low, high)} align=8 (i32.const 0))`;
}

/** The pool as a data segment. */
function segment() {
  if (POOL + 8 * pool.length > POOL_END) throw new Error(`${pool.length} vector constants do not fit below ${POOL_END}`);
  const bytes = new Uint8Array(new Uint32Array(pool.flatMap((number) => number.split(' ').map(Number))).buffer);
  return `(data (i32.const ${POOL}) "${Array.from(bytes, (byte) => `\\${byte.toString(16).padStart(2, '0')}`).join('')}")`;
}

/** An index below takes one byte. */
const SHORT = 128;

/**
 * Puts the functions that are called most often before the others. Within each group they stay as they were, those of a file together: sorted by calls alone
 * the module compresses less well.
 * @param {string} text
 */
function callFirst(text) {
  const items = text.split(/^(?= \()/m);
  const name = (/** @type {string} */ item) => /^ \(func (\S+)/.exec(item)?.[1] ?? '';
  /** @type {Map<string, number>} */
  const calls = new Map(items.map((item) => [name(item), 0]));
  for (const [, called] of text.matchAll(/\bcall (\S+)/g)) calls.set(called, (calls.get(called) ?? 0) + 1);
  const times = (/** @type {string} */ item) => calls.get(name(item)) ?? 0;
  const functions = items.filter(name);
  const often = new Set([...functions].sort((a, b) => times(b) - times(a)).slice(0, SHORT));
  const ordered = [...functions.filter((item) => often.has(item)), ...functions.filter((item) => !often.has(item))];
  return items.map((item) => (name(item) ? ordered.shift() : item)).join('');
}

/** Leaves out the exports that are not ours. wasm-opt removes what only they were for. @param {string} text */
function withoutOthers(text) {
  const ours = readFileSync(new URL('surfpath.exports', import.meta.url), 'utf8').split('\n');
  return text.replace(/^ \(export "(\w+)" \(func .*\n/gm, (line, name) => (ours.includes(name) ? line : ''));
}

const file = process.argv[2];
const text = readFileSync(file, 'utf8');

/** @param {(...numbers: string[]) => string} vectors @param {(number: string) => string} doubles where in the pool what numbers are */
const rewrite = (vectors, doubles) =>
  text
    .replace(/\(v128\.const i32x4 ([0-9a-fx ]+)\)/g, (_, lanes) => shortenVector(lanes, vectors))
    .replace(/\(i64\.const (\d{17,})\)/g, (_, bits) => shortenBits(bits, doubles))
    .replace(/\(f64\.const (-?)([\d.e+-]+|inf|(?<!-)nan:0x8000000000000)\)/g, (_, sign, size) => shorten(sign, size, doubles));

rewrite(want, () => '');
const inVectors = new Set([...wanted.values()].flatMap(({ numbers }) => numbers));
rewrite(() => '', want);
for (const { numbers, times } of [...wanted.values()].sort((a, b) => b.times - a.times))
  if ((times >= OFTEN || numbers.some((number) => inVectors.has(number))) && find(...numbers) < 0) pool.push(...numbers);
const shortened = rewrite(load, (number) => (find(number) < 0 ? '' : load(number)));
writeFileSync(file, callFirst(withoutOthers(shortened)).replace(/\)\s*$/, ` ${segment()}\n)\n`));
