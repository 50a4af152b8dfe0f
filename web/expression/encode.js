/* Bytes of WebAssembly: numbers, sections and the instructions that compiled expressions need. Knows nothing of expressions. */

/** Value types. */
export const I32 = 0x7f;
export const V128 = 0x7b;

/** An unsigned integer, LEB128. @param {number} value @returns {number[]} */
export function unsigned(value) {
  const bytes = [];
  for (; value >= 0x80; value >>>= 7) bytes.push((value & 0x7f) | 0x80);
  bytes.push(value);
  return bytes;
}

/** A signed integer, LEB128. @param {number} value @returns {number[]} */
export function signed(value) {
  const bytes = [];
  for (; value < -0x40 || value >= 0x40; value >>= 7) bytes.push((value & 0x7f) | 0x80);
  bytes.push(value & 0x7f);
  return bytes;
}

/** @typedef {ArrayLike<number>} Bytes */

/** Bytes one after the other, in an array of bytes: an array of numbers is eight times as large, and what is that large is slow to copy. @param {Bytes[]} parts */
function join(parts) {
  const bytes = new Uint8Array(parts.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const part of parts) {
    bytes.set(part, at);
    at += part.length;
  }
  return bytes;
}

/** A vector: the number of items, then the items. @param {Bytes[]} items */
const vector = (items) => join([unsigned(items.length), ...items]);

/** Bytes preceded by their number. @param {Bytes} bytes */
const sized = (bytes) => join([unsigned(bytes.length), bytes]);

/** @param {string} text in ASCII */
const name = (text) => sized([...text].map((character) => character.charCodeAt(0)));

/** @param {number} id @param {Bytes[]} items */
const section = (id, items) => join([[id], sized(vector(items))]);

/** @param {number[]} parameters @param {number[]} results types */
export const functionType = (parameters, results) => [0x60, ...sized(parameters), ...sized(results)];

/** @param {string} field @param {Bytes} description */
const imported = (field, description) => join([name('env'), name(field), description]);

/** @param {string} field */
export const importMemory = (field) => imported(field, [0x02, 0x00, 0x00]);

/** @param {string} field @param {number} type */
export const importConstant = (field, type) => imported(field, [0x03, type, 0x00]);

/** @param {string} field @param {number} typeIndex */
export const importFunction = (field, typeIndex) => imported(field, [0x00, ...unsigned(typeIndex)]);

/** @param {string} field @param {number} functionIndex */
export const exportFunction = (field, functionIndex) => [...name(field), 0x00, ...unsigned(functionIndex)];

/** The body of a function. @param {[count: number, type: number][]} locals @param {Bytes[]} code in parts, without the closing end */
export const body = (locals, code) => sized(join([vector(locals.map(([count, type]) => [...unsigned(count), type])), ...code, [END]]));

/**
 * A whole module.
 * @param {{ types: Bytes[], imports: Bytes[], functionTypes: number[], exports: Bytes[], bodies: Bytes[] }} parts
 */
export const module = ({ types, imports, functionTypes, exports, bodies }) =>
  join([
    [0x00, 0x61, 0x73, 0x6d, 0x01, 0x00, 0x00, 0x00],
    section(1, types),
    section(2, imports),
    section(3, functionTypes.map(unsigned)),
    section(7, exports),
    section(10, bodies),
  ]);

const END = 0x0b;
const EMPTY_BLOCK = 0x40;

/** @param {number} index */
export const localGet = (index) => [0x20, ...unsigned(index)];

/** @param {number} index */
export const localSet = (index) => [0x21, ...unsigned(index)];

/** @param {number} index */
export const globalGet = (index) => [0x23, ...unsigned(index)];

/** @param {number} functionIndex */
export const call = (functionIndex) => [0x10, ...unsigned(functionIndex)];

/** Adds a constant to an integer local. @param {number} index @param {number} amount */
export const advance = (index, amount) => [...localGet(index), ...addConstant(amount), ...localSet(index)];

/** @param {number} amount */
export const addConstant = (amount) => [0x41, ...signed(amount), 0x6a];

/** Runs code as often as an integer local says, counting it down to 0; not at all if it is not positive. @param {number} index @param {Bytes} code @returns {Bytes[]} parts of a body */
export const repeat = (index, code) => [
  [0x02, EMPTY_BLOCK, ...localGet(index), 0x41, 0x00, 0x4c, 0x0d, 0x00], // block; leave it if count <= 0
  [0x03, EMPTY_BLOCK], // loop
  code,
  [...advance(index, -1), ...localGet(index), 0x0d, 0x00, END], // again if count != 0
  [END],
];

/** A SIMD instruction. @param {number} opcode */
const simd = (opcode) => [0xfd, ...unsigned(opcode)];

/** Loads two doubles; the address is on the stack. @param {number} offset in bytes */
export const load = (offset) => [...simd(0x00), 4, ...unsigned(offset)];

/** Loads one double into both lanes. @param {number} offset */
export const loadSplat = (offset) => [...simd(0x0a), 3, ...unsigned(offset)];

/** Stores two doubles; address and value are on the stack. @param {number} offset */
export const store = (offset) => [...simd(0x0b), 4, ...unsigned(offset)];

/** The instructions of the operations from `add` to `or`, in their order (operation.js). */
export const arithmetic = [0xf0, 0xf1, 0xf2, 0xf3, 0xed, 0xec, 0xef, 0x75, 0xf4, 0xf5, 0x49, 0x4e, 0x4f, 0x50].map(simd);
