/* How formulas are written: the spelling of numbers, names and operators, and what binds tighter than what. */

/**
 * A function written as an operator. Higher precedence binds tighter.
 * @typedef {{ name: string, precedence: number, operands: number }} Operator
 */

/** @param {string} name @param {number} precedence @param {number} operands @returns {Operator} */
const operator = (name, precedence, operands) => Object.freeze({ name, precedence, operands });

/** Operators between two operands, left-associative. @type {Map<string, Operator>} */
export const BINARY = new Map([
  ['+', operator('add', 1, 2)],
  ['-', operator('subtract', 1, 2)],
  ['*', operator('multiply', 2, 2)],
  ['/', operator('divide', 2, 2)],
]);

/** The product of two operands side by side. */
export const IMPLICIT = operator('multiply', 3, 2);

/** Signs before an operand; a plus does nothing. @type {Map<string, Operator>} */
export const SIGNS = new Map([
  ['-', operator('negate', 4, 1)],
  ['+', operator('', 4, 1)],
]);

/** Right-associative. */
export const POWER = operator('pow', 5, 2);

export const RADICAL = operator('sqrt', 6, 1);

export const NUMBER = /(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?/y;

/** Letters of any script, with their marks, but π is always a word of its own, as in 2πr. */
export const NAME = /(?!π)[\p{L}_](?:(?!π)[\p{L}\p{M}\w₀-₉])*/uy;

export const SUPERSCRIPT = /⁻?[⁰¹²³⁴-⁹]+/y;

const SUPERSCRIPT_DIGITS = '⁰¹²³⁴⁵⁶⁷⁸⁹';

/** Typographic operators and what they are on a keyboard. */
export const SYNONYMS = new Map([
  ['×', '*'],
  ['·', '*'],
  ['⋅', '*'],
  ['∙', '*'],
  ['∗', '*'],
  ['÷', '/'],
  ['−', '-'],
]);

/** Whether a text is a whole name. @param {string} text */
export function isName(text) {
  NAME.lastIndex = 0;
  return NAME.exec(text)?.[0] === text;
}

/** The number that superscript digits write. @param {string} text */
export function superscriptValue(text) {
  const digits = Number([...text.replace('⁻', '')].map((digit) => SUPERSCRIPT_DIGITS.indexOf(digit)).join(''));
  return text[0] === '⁻' ? -digits : digits;
}
