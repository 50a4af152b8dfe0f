/* Text -> postfix program: an operator-precedence parser without recursion, so that no text can overflow anything.
 *
 * Knows which names are functions and which the caller's scope holds; knows nothing of graphs or derivatives. Where notation is ambiguous
 * (1/2u, sin^2(u), |x|y|z|) it refuses and says what to write. */

import { unexpected, unknown, wrongCount } from './advice.js';
import { ExpressionError } from './error.js';
import { functions } from './functions.js';
import { BINARY, IMPLICIT, NAME, NUMBER, POWER, RADICAL, SIGNS, SUPERSCRIPT, SYNONYMS, superscriptValue } from './notation.js';
import { Postfix } from './postfix.js';

/** @typedef {import('./notation.js').Operator} Operator */
/** @typedef {import('./postfix.js').Instruction} Instruction */
/** @typedef {import('./postfix.js').Entry} Entry */

/** The largest expression that is read. */
export const LIMITS = Object.freeze({ characters: 4096, nodes: 2000, nesting: 64 });

/** Also what text processors put between a function and its bracket, and between factors, where nothing is to be seen. */
const SPACE = /^[\s\u2061\u2062]+/u;

/**
 * What a name stands for: `value` is the number, or the index of the variable, parameter or known value.
 * @typedef {{ kind: 'number' | 'variable' | 'parameter' | 'known', value: number }} Meaning
 */
/**
 * Reads an expression.
 * @param {string} source
 * @param {Map<string, Meaning>} scope what names stand for
 * @param {string} [argument] name of the expression, for error messages
 * @returns {Instruction[]} operands before their operators; operators are calls of add, subtract, multiply, divide, negate, pow, sqrt, abs
 * @throws {ExpressionError}
 */
export function parse(source, scope, argument) {
  return new Parser(source, scope, argument).run();
}

class Parser {
  #output = new Postfix();
  #index = 0;
  #nesting = 0;
  #expectsOperand = true;
  /** What was read last; decides whether a number or an exponent may follow. */
  #last = '';
  #source;
  #scope;
  #argument;

  /** @param {string} source @param {Map<string, Meaning>} scope @param {string} [argument] */
  constructor(source, scope, argument) {
    this.#source = source;
    this.#scope = scope;
    this.#argument = argument;
  }

  run() {
    if (this.#source.length > LIMITS.characters) {
      this.#fail(`the expression is longer than ${LIMITS.characters} characters; write it shorter`, LIMITS.characters);
    }
    for (this.#skipSpace(); this.#index < this.#source.length; this.#skipSpace()) {
      if (this.#expectsOperand) this.#readOperand();
      else this.#readOperator();
      this.#checkSize();
    }
    this.#finish();
    this.#checkSize();
    return this.#output.program;
  }

  #readOperand() {
    const symbol = this.#symbol();
    const sign = SIGNS.get(symbol);
    if (/[\d.]/.test(symbol)) this.#readNumber();
    else if (symbol === 'π') this.#emitMeaning('pi', 1);
    else if (symbol === '(' || symbol === '|') this.#open(symbol, '');
    else if (symbol === '√') this.#push(RADICAL, 1);
    else if (sign) this.#pushSign(sign);
    else if (!this.#readName()) this.#failWithoutOperand(symbol);
  }

  #readOperator() {
    const symbol = this.#symbol();
    const operator = BINARY.get(symbol);
    const superscript = this.#match(SUPERSCRIPT);
    if (symbol === '^') this.#pushPower(1);
    else if (symbol === '*' && this.#source[this.#index + 1] === '*') this.#pushPower(2);
    else if (operator) this.#pushBinary(operator);
    else if (superscript) this.#readSuperscript(superscript);
    else if (symbol === ')') this.#close();
    else if (symbol === '|') this.#closeBar();
    else if (symbol === ',') this.#nextArgument();
    else this.#multiplyImplicitly(symbol);
  }

  #readNumber() {
    const text = this.#match(NUMBER);
    const end = this.#index + text.length;
    if (text === '') this.#fail('a number needs a digit beside its decimal point, as in 0.5');
    if (this.#source[end] === '.') this.#fail('a number has only one decimal point, as in 1.25', end);
    const value = Number(text);
    if (!Number.isFinite(value))
      this.#fail(`${text.length > 40 ? `${text.slice(0, 40)}…` : text} is too large; write numbers up to 1.79e308`);
    this.#output.emit('number', text, value, this.#index);
    this.#operandRead(text.length, 'number');
  }

  /** @returns {boolean} whether there was a name */
  #readName() {
    const name = this.#match(NAME);
    if (name === '') return false;
    const rest = this.#source.slice(this.#index + name.length).replace(SPACE, '');
    const isCall = rest[0] === '(';
    if (functions.has(name)) this.#readFunction(name, rest);
    else if (!this.#scope.has(name) && this.#isDefined(rest)) this.#fail('write only what stands behind "="; the name is known');
    else if (!this.#scope.has(name)) this.#fail(unknown(name, isCall, [...this.#scope.keys()]));
    else if (isCall) this.#fail(`${name} is not a function; write ${name}*(…) for a product`);
    else this.#emitMeaning(name, name.length);
    return true;
  }

  /** Whether the formula says what it is for: z = …, f(x, y) = … @param {string} rest the text after its first name */
  #isDefined(rest) {
    return this.#last === '' && /^(\([^()]*\)\s*)?=(?!=)/.test(rest);
  }

  /** @param {string} name @param {string} rest the text after it */
  #readFunction(name, rest) {
    if (/^(⁻¹|\^ ?\(?-1)/.test(rest) && functions.has(`a${name}`)) this.#fail(`for the inverse function write a${name}(…)`);
    if (/^(\^|\*\*|[⁻⁰¹²³⁴-⁹])/.test(rest)) this.#fail(`write the power after the brackets, as in ${name}(…)^2`);
    if (rest[0] !== '(') this.#fail(`${name} is a function; write ${name}(…) with brackets`);
    const start = this.#index;
    this.#index = this.#source.indexOf('(', start);
    this.#open('(', name, start);
  }

  /** @param {string} name @param {number} length */
  #emitMeaning(name, length) {
    const { kind, value } = /** @type {Meaning} */ (this.#scope.get(name));
    this.#output.emit(kind, name, value, this.#index);
    this.#operandRead(length, 'name');
  }

  /** @param {string} text */
  #readSuperscript(text) {
    this.#checkPower();
    this.#output.emit('number', text, superscriptValue(text), this.#index);
    this.#output.emit('call', POWER.name, 2, this.#index);
    this.#operandRead(text.length, 'superscript');
  }

  /** @param {'(' | '|'} bracket @param {string} name function it belongs to @param {number} [start] */
  #open(bracket, name, start = this.#index) {
    if (++this.#nesting > LIMITS.nesting) this.#fail(`brackets are nested more than ${LIMITS.nesting} deep; write the expression flatter`);
    this.#output.push({ name, precedence: 0, operands: 0, index: start, bracket, count: 0 });
    this.#index++;
    this.#expectsOperand = true;
    this.#last = 'open';
  }

  #close() {
    this.#output.reduce(1);
    const group = this.#output.pop();
    if (!group) return this.#fail('this ) has no opening bracket; remove it or write the ( before it');
    if (group.bracket === '|') this.#fail('the | before this ) is not closed; write abs(…)', group.index);
    if (group.name) this.#emitCall(group.name, group.count + 1, group.index);
    this.#closed();
  }

  #closeBar() {
    this.#output.reduce(1);
    const group = this.#output.pop();
    if (group?.bracket !== '|') return this.#fail('this | could open or close; write abs(…), and * for products');
    this.#output.emit('call', 'abs', 1, group.index);
    this.#closed();
  }

  #closed() {
    this.#nesting--;
    this.#operandRead(1, 'close');
  }

  #nextArgument() {
    this.#output.reduce(1);
    const group = this.#output.top;
    if (!group?.name) return this.#fail('a comma only separates the arguments of a function; write decimals with a point, as in 0.5');
    group.count++;
    this.#index++;
    this.#expectsOperand = true;
    this.#last = 'comma';
  }

  /** @param {string} written @param {number} count @param {number} index */
  #emitCall(written, count, index) {
    const { name, least, most } = /** @type {import('./functions.js').Callable} */ (functions.get(written));
    if (count < least || count > most) this.#fail(wrongCount(written, count), index);
    this.#output.emit('call', name, count, index);
  }

  /** @param {Operator} operator */
  #pushBinary(operator) {
    this.#output.reduce(operator.precedence);
    this.#push(operator, 1);
  }

  /** @param {Operator} sign */
  #pushSign(sign) {
    if (this.#afterRadical()) this.#fail('write √(…) around a signed number');
    this.#push(sign, 1);
  }

  /** @param {number} length of the operator's text */
  #pushPower(length) {
    this.#checkPower();
    this.#output.reduce(POWER.precedence + 1);
    this.#push(POWER, length);
  }

  /** @param {Operator} operator @param {number} length */
  #push(operator, length) {
    this.#output.push({ ...operator, index: this.#index, bracket: '', count: 0 });
    this.#index += length;
    this.#expectsOperand = true;
    this.#last = 'operator';
  }

  #checkPower() {
    if (this.#last === 'superscript') this.#fail('this could mean two powers; write (…)^… with brackets');
    if (this.#afterRadical()) this.#fail('this could be the root of a power or the power of a root; write √(…) or (√…)^…');
  }

  /** @param {string} symbol */
  #multiplyImplicitly(symbol) {
    const isNumber = /[\d.]/.test(symbol);
    if (!isNumber && symbol !== '(' && symbol !== 'π' && symbol !== '√' && this.#match(NAME) === '') this.#fail(unexpected(symbol));
    if (isNumber && this.#last !== 'name' && this.#last !== 'close')
      this.#fail('two numbers stand side by side; write * or another operator between them');
    if (this.#afterRadical()) this.#fail('this could belong under the root or not; write √(…) with brackets or * before it');
    this.#output.reduce(IMPLICIT.precedence);
    if (this.#output.top?.name === 'divide') {
      this.#fail('a product without * after / could mean two things; write a/(b*c) or a/b*c');
    }
    this.#push(IMPLICIT, 0);
  }

  #afterRadical() {
    return this.#output.top?.precedence === RADICAL.precedence;
  }

  #finish() {
    const end = this.#source.length;
    if (this.#last === '') this.#fail('the expression is empty; write a number or a formula', 0);
    if (this.#expectsOperand) this.#fail('the expression ends too early; write a number, a name or a bracket here', end);
    this.#output.reduce(1);
    const open = this.#output.top;
    if (!open) return;
    const index = this.#source.indexOf(open.bracket, open.index);
    this.#fail(`this ${open.bracket} is not closed; write ${open.bracket === '|' ? 'the second |' : 'a )'} after it`, index);
  }

  #checkSize() {
    if (this.#output.size > LIMITS.nodes) {
      this.#fail(`the expression has more than ${LIMITS.nodes} numbers, names and operations; write it shorter`);
    }
  }

  /** @param {number} length @param {string} kind */
  #operandRead(length, kind) {
    this.#index += length;
    this.#expectsOperand = false;
    this.#last = kind;
  }

  /** The text a pattern matches here, or ''. @param {RegExp} pattern */
  #match(pattern) {
    pattern.lastIndex = this.#index;
    return pattern.exec(this.#source)?.[0] ?? '';
  }

  /** The character here, with typographic operators written as on a keyboard. */
  #symbol() {
    const symbol = String.fromCodePoint(/** @type {number} */ (this.#source.codePointAt(this.#index)));
    return SYNONYMS.get(symbol) ?? symbol;
  }

  #skipSpace() {
    while (SPACE.test(this.#source[this.#index] ?? '')) this.#index++;
  }

  /** @param {string} symbol */
  #failWithoutOperand(symbol) {
    if (symbol === ')' && this.#last === 'open') {
      const open = /** @type {Entry} */ (this.#output.top);
      if (open.name) this.#emitCall(open.name, 0, open.index);
    }
    if (['//', '/*'].includes(this.#source.slice(this.#index - 1, this.#index + 1)))
      this.#fail('leave out the comment; for the whole part of a/b write floor(a/b)', this.#index - 1);
    if (symbol === ')' || symbol === ',' || symbol === '^' || BINARY.has(symbol) || this.#match(SUPERSCRIPT)) {
      this.#fail(`a number, a name or a bracket is missing before ${symbol}; write it here`);
    }
    this.#fail(unexpected(symbol));
  }

  /** @param {string} message @param {number} [index] @returns {never} */
  #fail(message, index = this.#index) {
    throw new ExpressionError(this.#source, index, message, this.#argument);
  }
}
