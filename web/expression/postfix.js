/* The two stacks of operator precedence: what is written already, and the operators and brackets that wait for their operands. */

/**
 * One step of a postfix program. `value`: the number, the index of the variable, parameter or known value, or how many arguments a call takes
 * from the stack.
 * @typedef {{ kind: 'number' | 'variable' | 'parameter' | 'known' | 'call', name: string, value: number, index: number }} Instruction
 */
/**
 * A waiting operator, or an open bracket (precedence 0) with the function it belongs to and the number of arguments before this one.
 * @typedef {{ name: string, precedence: number, operands: number, index: number, bracket: '' | '(' | '|', count: number }} Entry
 */

/** A postfix program in the making. */
export class Postfix {
  /** @type {Instruction[]} */ program = [];
  /** @type {Entry[]} */ #waiting = [];
  /** How many steps it has, or will have once all that waits is written. */
  size = 0;

  /** What was pushed last. @returns {Entry | undefined} */
  get top() {
    return this.#waiting.at(-1);
  }

  /** @param {Entry} entry */
  push(entry) {
    if (entry.name) this.size++;
    this.#waiting.push(entry);
  }

  pop() {
    const entry = this.#waiting.pop();
    if (entry?.name) this.size--;
    return entry;
  }

  /** Appends a step. @param {Instruction['kind']} kind @param {string} name @param {number} value @param {number} index of its text in the source */
  emit(kind, name, value, index) {
    this.size++;
    this.program.push({ kind, name, value, index });
  }

  /** Emits the waiting operators that bind at least this tightly, up to the innermost bracket. @param {number} precedence at least 1 */
  reduce(precedence) {
    for (let top = this.top; top && top.precedence >= precedence; top = this.top) {
      this.pop();
      if (top.name) this.emit('call', top.name, top.operands, top.index);
    }
  }
}
