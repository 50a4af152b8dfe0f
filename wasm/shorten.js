// Rewrites constants in the text of a WebAssembly module, in place, to what takes fewer bytes: a double takes 9, of which a
// small integer, converted, needs 3 and a float, promoted, 6; a vector takes 18, and 3 to 11 as a scalar in both lanes. Engines fold it when they compile.
import { readFileSync, writeFileSync } from 'node:fs';

/** As WebAssembly's text, of which `String` knows no -0. @param {number} value */
const write = (value) => (Object.is(value, -0) ? '-0' : String(value).replace('Infinity', 'inf'));

/** @param {number} value */
function shorten(value) {
  const text = write(value);
  if (Number.isInteger(value) && Math.abs(value) < 2 ** 20 && text !== '-0') return `(f64.convert_i32_s (i32.const ${text}))`;
  if (Math.fround(value) === value) return `(f64.promote_f32 (f32.const ${text}))`;
  return `(f64.const ${text})`;
}

/** @param {string} all the constant @param {string} lanes four words, the lowest first */
function shortenVector(all, lanes) {
  const [a, b, c, d] = lanes.split(' ').map(Number);
  if (a !== c || b !== d) return all;
  if (a === b) return `(i32x4.splat (i32.const ${a}))`;
  const value = new Float64Array(new Uint32Array([a, b]).buffer)[0];
  return Number.isNaN(value) ? all : `(f64x2.splat ${shorten(value)})`;
}

const file = process.argv[2];
const text = readFileSync(file, 'utf8');
const doubles = text.replace(/\(f64\.const (-?)([\d.e+-]+|inf)\)/g, (_, sign, size) =>
  shorten(Number(sign + size.replace('inf', 'Infinity'))),
);
writeFileSync(file, doubles.replace(/\(v128\.const i32x4 ([0-9a-fx ]+)\)/g, shortenVector));
