/**
 * The bytes of a WebAssembly module by their kind: put together, bytes of one kind compress better than as they stand. What is looked at are only bytes that have
 * been moved, so one walk takes a module apart (wasm/pack.js) and puts it together (unpack.js). It knows what our build makes; of another module it would find
 * other kinds, and still put it together.
 */

/** Kinds: whatever else; opcodes and forms of instructions; locals read, and written; constant integers; offsets of addresses; functions called; types of locals. */
const [OTHER, FORM, READ, WRITTEN, INTEGER, OFFSET, CALLED, DECLARED] = [0, 1, 2, 3, 4, 5, 6, 7];
export const KINDS = 8;

const CODE_SECTION = 10;

/** What follows an opcode: an integer of that kind (OFFSET: with an alignment before it); nothing; a number of 4 or 8 bytes; a vector instruction. */
const [NOTHING, FLOAT, DOUBLE, VECTOR] = [8, 9, 10, 11];
const operands = new Uint8Array(256).fill(NOTHING);
for (const [operand, first, last] of [
  [FORM, 0x02, 0x04],
  [FORM, 0x0c, 0x0d],
  [CALLED, 0x10, 0x11],
  [READ, 0x20, 0x20],
  [WRITTEN, 0x21, 0x22],
  [FORM, 0x23, 0x24],
  [OFFSET, 0x28, 0x3e],
  [OTHER, 0x3f, 0x42],
  [INTEGER, 0x41, 0x41],
  [FLOAT, 0x43, 0x43],
  [DOUBLE, 0x44, 0x44],
  [FORM, 0xfc, 0xfc],
  [VECTOR, 0xfd, 0xfd],
])
  operands.fill(operand, first, last + 1);

/**
 * Moves all bytes from one side to the other.
 * @param {Uint8Array} module
 * @param {Uint8Array} heaps
 * @param {number[]} next of each kind, where in `heaps` its next byte is
 * @param {boolean} apart from the module to the heaps; else from the heaps to the module
 */
export function regroup(module, heaps, next, apart) {
  let at = 0;

  /** Moves the next byte, and returns it. @param {number} kind */
  const move = (kind) => {
    const from = next[kind]++;
    if (apart) heaps[from] = module[at];
    else module[at] = heaps[from];
    return module[at++];
  };

  /** @param {number} kind @param {number} count */
  const bytes = (kind, count) => {
    for (; count > 0; count--) move(kind);
  };

  /** An integer, LEB128. @param {number} kind */
  const integer = (kind) => {
    for (let value = 0, shift = 0; ; shift += 7) {
      const part = move(kind);
      value |= (part & 127) << shift;
      if (part < 128) return value;
    }
  };

  const instruction = () => {
    let operand = operands[move(FORM)];
    if (operand === NOTHING) return;
    if (operand === VECTOR) {
      const number = integer(FORM);
      if (number > 20 && number < 35) move(FORM);
      else if (number === 12 || number === 13) bytes(OTHER, 16);
      if (number > 11) return;
      operand = OFFSET;
    }
    if (operand > NOTHING) return bytes(OTHER, operand === FLOAT ? 4 : 8);
    if (operand === OFFSET) move(FORM);
    while (move(operand) > 127);
  };

  const functionBody = () => {
    const size = integer(OTHER);
    const end = at + size;
    for (let groups = integer(DECLARED); groups > 0; groups--) bytes(DECLARED, 2);
    while (at < end) instruction();
  };

  bytes(OTHER, 8);
  while (at < module.length) {
    const section = move(OTHER);
    const size = integer(OTHER);
    if (section !== CODE_SECTION) bytes(OTHER, size);
    else for (let count = integer(OTHER); count > 0; count--) functionBody();
  }
}
