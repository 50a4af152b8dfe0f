/* The hash-consed graph of all the arithmetic of a surface: every distinct operation exists once, operands always before their users.
 *
 * Nodes are small integers into parallel arrays. Constants are folded as they appear: arithmetic by IEEE doubles, elementary functions by the
 * solver's own (never Math.sin, whose last bits differ between engines). Simplifications are exact for finite numbers up to the sign of a
 * zero: x*0 is 0 even where x would turn out infinite at run time, and x+0 is x. Nothing is reassociated or distributed. Knows no derivatives. */

import { POW, solverFunctions } from './functions.js';
import * as Operation from './operation.js';

/** @typedef {(functionNumber: number, x: number, y: number) => number} Apply one elementary function of numbers, `sp_apply_function` of the solver */

const ID_RANGE = 2 ** 21;
/** Integer exponents up to this size are products. */
const LARGEST_INTEGER_POWER = 64;

/** @param {number} operation @param {number} a @param {number} b */
const keyOf = (operation, a, b) => (operation * ID_RANGE + a) * ID_RANGE + b;

/** Builds nodes; every method takes and returns node numbers. */
export class Graph {
  /** @type {number[]} */ operations = [];
  /** @type {number[]} */ left = [];
  /** @type {number[]} */ right = [];
  /** @type {number[]} the numbers of the constants */ values = [];
  /** @type {Map<number, number>} */ #known = new Map();
  /** @type {Map<number, number>} */ #constants = new Map();
  #apply;

  /** @param {Apply} apply folds elementary functions of constants */
  constructor(apply) {
    this.#apply = apply;
    this.zero = this.constant(0);
    this.one = this.constant(1);
    this.negativeZero = this.#append(Operation.constant, this.values.push(-0) - 1, 0);
  }

  /** @returns {number} how many nodes there are */
  get size() {
    return this.operations.length;
  }

  /** @param {number} value */
  constant(value) {
    if (Object.is(value, -0)) return this.negativeZero;
    let id = this.#constants.get(value);
    if (id === undefined) {
      id = this.#append(Operation.constant, this.values.push(value) - 1, 0);
      this.#constants.set(value, id);
    }
    return id;
  }

  /** @param {number} index */
  variable(index) {
    return this.#node(Operation.variable, index, 0);
  }

  /** @param {number} index */
  parameter(index) {
    return this.#node(Operation.parameter, index, 0);
  }

  /** @param {number} a @param {number} b @returns {number} */
  add(a, b) {
    const folded = this.#fold((x, y) => x + y, a, b);
    if (folded !== undefined) return folded;
    if (this.#isZero(a)) return b;
    if (this.#isZero(b)) return a;
    if (this.#is(b, Operation.negate)) return this.subtract(a, this.left[b]);
    if (this.#is(a, Operation.negate)) return this.subtract(b, this.left[a]);
    if (this.#isPiece(a, b)) return this.#within(a, this.add(this.left[a], this.left[b]));
    return this.#commutative(Operation.add, a, b);
  }

  /** @param {number} a @param {number} b @returns {number} */
  subtract(a, b) {
    const folded = this.#fold((x, y) => x - y, a, b);
    if (folded !== undefined) return folded;
    if (this.#isZero(b)) return a;
    if (this.#isZero(a)) return this.negate(b);
    if (a === b) return this.zero;
    if (this.#is(b, Operation.negate)) return this.add(a, this.left[b]);
    if (this.#is(a, Operation.negate)) return this.negate(this.add(this.left[a], b));
    if (this.#isPiece(a, b)) return this.#within(a, this.subtract(this.left[a], this.left[b]));
    return this.#node(Operation.subtract, a, b);
  }

  /** @param {number} a @param {number} b @returns {number} */
  multiply(a, b) {
    if (this.#isConstant(a)) return this.#isConstant(b) ? this.constant(this.numberOf(a) * this.numberOf(b)) : this.#scale(b, a);
    if (this.#isConstant(b)) return this.#scale(a, b);
    if (this.#is(a, Operation.negate)) return this.negate(this.multiply(this.left[a], b));
    if (this.#is(b, Operation.negate)) return this.negate(this.multiply(a, this.left[b]));
    if (this.#isPiece(a)) return this.#within(a, this.multiply(this.left[a], b));
    if (this.#isPiece(b)) return this.#within(b, this.multiply(this.left[b], a));
    return this.#commutative(Operation.multiply, a, b);
  }

  /** Whether both are 0 but on one side of a comparison, the same of both. There what they are multiplied with may be infinite, as the slope of a root. @param {number} a @param {number} [b] */
  #isPiece(a, b = a) {
    const isOne = this.#is(a, Operation.and) || this.#is(a, Operation.andNot);
    return isOne && this.#is(b, this.operations[a]) && this.right[a] === this.right[b] && this.#is(this.right[a], Operation.less);
  }

  /** What a node is where a piece is not 0. @param {number} piece @param {number} a */
  #within(piece, a) {
    return a === this.zero || this.#isPiece(a, piece) ? a : this.#node(this.operations[piece], a, this.right[piece]);
  }

  /** Multiplies by a constant. @param {number} a @param {number} factor @returns {number} */
  #scale(a, factor) {
    const value = this.numberOf(factor);
    if (value === 0) return this.zero;
    if (value === 1) return a;
    if (value === -1) return this.negate(a);
    if (this.#is(a, Operation.negate)) return this.#scale(this.left[a], this.constant(-value));
    if (this.#isPiece(a)) return this.#within(a, this.#scale(this.left[a], factor));
    return this.#commutative(Operation.multiply, a, factor);
  }

  /** @param {number} a @param {number} b @returns {number} */
  divide(a, b) {
    if (this.#isConstant(b)) {
      const value = this.numberOf(b);
      if (this.#isConstant(a)) return this.constant(this.numberOf(a) / value);
      if (isPowerOfTwo(value)) return this.#scale(a, this.constant(1 / value));
    }
    if (this.#is(a, Operation.negate)) return this.negate(this.divide(this.left[a], b));
    if (this.#is(b, Operation.negate)) return this.negate(this.divide(a, this.left[b]));
    return this.#node(Operation.divide, a, b);
  }

  /** @param {number} a @returns {number} */
  negate(a) {
    if (this.#isConstant(a)) return this.constant(-this.numberOf(a));
    if (this.#is(a, Operation.negate)) return this.left[a];
    if (this.#is(a, Operation.subtract)) return this.subtract(this.right[a], this.left[a]);
    return this.#node(Operation.negate, a, 0);
  }

  /** @param {number} a */
  absolute(a) {
    return this.#fold(Math.abs, a) ?? this.#node(Operation.absolute, this.#is(a, Operation.negate) ? this.left[a] : a, 0);
  }

  /** @param {number} a */
  squareRoot(a) {
    return this.#fold(Math.sqrt, a) ?? this.#node(Operation.squareRoot, a, 0);
  }

  /** @param {number} a */
  floor(a) {
    return this.#fold(Math.floor, a) ?? this.#node(Operation.floor, a, 0);
  }

  /** -1, 1, or the argument itself where it is 0 or NaN. @param {number} a */
  sign(a) {
    const folded = this.#fold(Math.sign, a);
    if (folded !== undefined) return folded;
    const unit = this.or(this.and(a, this.negativeZero), this.one);
    return this.select(this.zero, this.absolute(a), unit, a);
  }

  /** @param {number} a @param {number} b */
  minimum(a, b) {
    return this.#fold(Math.min, a, b) ?? (a === b ? a : this.#commutative(Operation.minimum, a, b));
  }

  /** @param {number} a @param {number} b */
  maximum(a, b) {
    return this.#fold(Math.max, a, b) ?? (a === b ? a : this.#commutative(Operation.maximum, a, b));
  }

  /** `a < b ? yes : no`. @param {number} a @param {number} b @param {number} yes @param {number} no */
  select(a, b, yes, no) {
    if (yes === no) return yes;
    if (this.#isConstant(a) && this.#isConstant(b)) return this.numberOf(a) < this.numberOf(b) ? yes : no;
    const mask = this.#node(Operation.less, a, b);
    return this.or(this.and(yes, mask), this.andNot(no, mask));
  }

  /** The bits that both have: of a number and a mask, the number or 0. @param {number} a @param {number} b */
  and(a, b) {
    return a === this.zero ? a : this.#node(Operation.and, a, b);
  }

  /** The bits of the first that the second has not. @param {number} a @param {number} b */
  andNot(a, b) {
    return a === this.zero ? a : this.#node(Operation.andNot, a, b);
  }

  /** The bits that either has. @param {number} a @param {number} b */
  or(a, b) {
    if (a === this.zero) return b;
    return b === this.zero ? a : this.#node(Operation.or, a, b);
  }

  /** `condition != 0 ? a : 0`: keeps 0 times infinity from becoming NaN. @param {number} condition @param {number} a */
  whereNonzero(condition, a) {
    return this.select(this.zero, this.absolute(condition), a, this.zero);
  }

  /** An elementary function, by its number in functions.js. @param {number} functionNumber @param {number} a @param {number} [b] */
  call(functionNumber, a, b = 0) {
    return this.#fold((x, y) => this.#apply(functionNumber, x, y), a, b) ?? this.#node(Operation.call + functionNumber, a, b);
  }

  /** What a node is half of, if that is how it is written. @param {number} a @returns {number | undefined} */
  doubled(a) {
    if (!this.#is(a, Operation.multiply)) return undefined;
    const [left, right] = [this.left[a], this.right[a]];
    if (this.numberOf(left) === 0.5) return right;
    return this.numberOf(right) === 0.5 ? left : undefined;
  }

  /** a^b: products where b is a small integer, a root where it is 1/2, else the function pow. @param {number} a @param {number} b */
  power(a, b) {
    if (this.integerExponent(b) !== undefined) return this.integerPower(a, this.numberOf(b));
    return this.#isConstant(b) && this.numberOf(b) === 0.5 ? this.squareRoot(a) : this.call(POW, a, b);
  }

  /** The exponent if powers to it are products. @param {number} b @returns {number | undefined} */
  integerExponent(b) {
    if (!this.#isConstant(b)) return undefined;
    const value = this.numberOf(b);
    return Number.isInteger(value) && Math.abs(value) <= LARGEST_INTEGER_POWER ? value : undefined;
  }

  /** a to an integer power, by squaring from the exponent's highest bit down. @param {number} a @param {number} exponent @returns {number} */
  integerPower(a, exponent) {
    if (exponent === 0) return this.one;
    if (exponent < 0) return this.divide(this.one, this.integerPower(a, -exponent));
    let power = a;
    for (let bit = 30 - Math.clz32(exponent); bit >= 0; bit--) {
      power = this.multiply(power, power);
      if ((exponent >> bit) & 1) power = this.multiply(power, a);
    }
    return power;
  }

  /** Whether a node is an operation on others; constants, variables and parameters are not. @param {number} id */
  isOperation(id) {
    return this.operations[id] > Operation.parameter;
  }

  /** The nodes that a node is computed from: none, one or two. @param {number} id */
  operands(id) {
    const operation = this.operations[id];
    if (operation <= Operation.parameter) return [];
    const isOne = operation >= Operation.negate && operation <= Operation.floor;
    const count = operation < Operation.call ? 2 - Number(isOne) : solverFunctions[operation - Operation.call].arity;
    return [this.left[id], this.right[id]].slice(0, count);
  }

  /** The number of a constant; NaN for any other node. @param {number} id */
  numberOf(id) {
    return this.#isConstant(id) ? this.values[this.left[id]] : Number.NaN;
  }

  /** @param {number} id @param {number} operation */
  #is(id, operation) {
    return this.operations[id] === operation;
  }

  /** @param {number} id */
  #isConstant(id) {
    return this.operations[id] === Operation.constant;
  }

  /** What an operation makes of constants; undefined where one of its operands is none. @param {(x: number, y: number) => number} operate @param {number} a @param {number} [b] */
  #fold(operate, a, b = a) {
    return this.#isConstant(a) && this.#isConstant(b) ? this.constant(operate(this.numberOf(a), this.numberOf(b))) : undefined;
  }

  /** @param {number} id */
  #isZero(id) {
    return id === this.zero || id === this.negativeZero;
  }

  /** @param {number} operation @param {number} a @param {number} b */
  #commutative(operation, a, b) {
    return a < b ? this.#node(operation, a, b) : this.#node(operation, b, a);
  }

  /** From now on what builds a node gives another, whose value is the same. @param {number} node @param {number} other */
  equate(node, other) {
    if (node !== other) this.#known.set(keyOf(this.operations[node], this.left[node], this.right[node]), other);
  }

  /** The node with this operation and these operands, made only if there is none yet. @param {number} operation @param {number} a @param {number} b */
  #node(operation, a, b) {
    const key = keyOf(operation, a, b);
    const known = this.#known.get(key);
    if (known !== undefined) return known;
    const id = this.#append(operation, a, b);
    this.#known.set(key, id);
    return id;
  }

  /** @param {number} operation @param {number} left @param {number} right */
  #append(operation, left, right) {
    this.left.push(left);
    this.right.push(right);
    return this.operations.push(operation) - 1;
  }
}

const bits = new DataView(new ArrayBuffer(8));

/** Whether dividing by `value` is the same as multiplying by its inverse. @param {number} value */
function isPowerOfTwo(value) {
  bits.setFloat64(0, value);
  const mantissaIsZero = (bits.getUint32(0) & 0xfffff) === 0 && bits.getUint32(4) === 0;
  return mantissaIsZero && Number.isFinite(value) && Number.isFinite(1 / value);
}
