/** A formula as MathML: the parser's postfix program put together again, with fractions, roots, powers and only the brackets that are needed. */

import { LIMITS, parse } from '../../web/expression/parse.js';

/** @typedef {import('../../web/expression/postfix.js').Instruction} Instruction */
/** A piece of MathML and how tightly it binds. @typedef {{ element: Element, precedence: number }} Piece */

const NAMESPACE = 'http://www.w3.org/1998/Math/MathML';
const SUM = 1;
const PRODUCT = 2;
const SIGN = 3;
const POWER = 4;
const ATOM = 5;
/** Characters that fit into a line as they are typeset, also where they are wide or under roots; and a factor that may begin one. */
const [ONE_LINE, BULKY] = [20, 7];
/** Longer formulas are not typeset: their beginning is shown as it was written, so many characters of it. */
const MOST_STEPS = 400;
const BEGINNING = 80;
/** @type {Record<string, string>} */
const GREEK = {
  alpha: 'α',
  beta: 'β',
  gamma: 'γ',
  delta: 'δ',
  theta: 'θ',
  lambda: 'λ',
  mu: 'μ',
  omega: 'ω',
  phi: 'φ',
  pi: 'π',
  rho: 'ρ',
  sigma: 'σ',
  tau: 'τ',
};

/** @param {string} tag @param {(Element | string)[]} children */
export function math(tag, ...children) {
  const element = document.createElementNS(NAMESPACE, tag);
  element.append(...children);
  return element;
}

const operator = (/** @type {string} */ text) => math('mo', text);

/** What stands in brackets that is taller than a line. */
const TALL = 'mfrac, msup, msqrt, mroot';

/** A bracket, as tall as what it is around. @param {string} text @param {Element[]} inner */
function bracket(text, inner) {
  const element = operator(text);
  // Around letters that reach below the line engines would stretch it too.
  if (!inner.some((one) => one.matches(TALL) || one.querySelector(TALL))) element.setAttribute('stretchy', 'false');
  return element;
}

/** @param {Piece} piece @param {number} least */
function bracketed({ element, precedence }, least) {
  return precedence >= least ? element : math('mrow', bracket('(', [element]), element, bracket(')', [element]));
}

/** @param {Element} element @param {number} [precedence] @returns {Piece} */
const piece = (element, precedence = ATOM) => ({ element, precedence });

/** Between factors: none after a number, as in 2π. @param {Piece} before */
const gap = ({ element }) => (element.localName === 'mn' ? math('mo', '\u2062') : math('mtext', '\u2009'));

/** @type {Record<string, (...operands: Piece[]) => Piece>} */
const BUILD = {
  add: (a, b) => piece(math('mrow', bracketed(a, SUM), operator('+'), bracketed(b, SUM)), SUM),
  subtract: (a, b) => piece(math('mrow', bracketed(a, SUM), operator('−'), bracketed(b, PRODUCT)), SUM),
  multiply: (a, b) => {
    const right = bracketed(b, b.precedence === SIGN ? POWER : PRODUCT);
    // Digits side by side would be one number.
    const between = /^\d/.test(right.textContent ?? '') ? operator('·') : gap(a);
    return piece(math('mrow', bracketed(a, PRODUCT), between, right), PRODUCT);
  },
  divide: (a, b) => piece(math('mfrac', a.element, b.element), PRODUCT),
  negate: (a) => piece(math('mrow', operator('−'), bracketed(a, PRODUCT)), SIGN),
  pow: (a, b) => piece(math('msup', bracketed(a, ATOM), b.element), POWER),
  sqrt: (a) => piece(math('msqrt', a.element)),
  cbrt: (a) => piece(math('mroot', a.element, math('mn', '3'))),
  abs: (a) => piece(math('mrow', operator('|'), a.element, operator('|'))),
};

/** @param {string} name @param {Piece[]} operands */
function call(name, operands) {
  if (Object.hasOwn(BUILD, name)) return BUILD[name](...operands);
  const list = operands.flatMap(({ element }, i) => (i > 0 ? [operator(','), element] : [element]));
  return piece(math('mrow', math('mi', name), operator('\u2061'), bracket('(', list), ...list, bracket(')', list)));
}

/** @param {Instruction} instruction */
function leaf({ kind, name, value }) {
  if (kind !== 'number' || /^[\p{L}_]/u.test(name)) return piece(math('mi', GREEK[name] ?? name));
  const [digits, order] = (/e/i.test(name) ? name : String(value)).split(/e/i);
  const number = piece(math('mn', digits));
  if (!order) return number;
  const power = piece(math('msup', math('mn', '10'), math('mn', String(Number(order)).replace('-', '−'))), POWER);
  return digits === '1' ? power : BUILD.multiply(number, power);
}

/**
 * Where a long formula may be broken: before the signs of a sum, and between long factors; inside of brackets too, where they are long.
 * @param {Element} element of `typeset`, taken apart
 * @returns {Element[][]} pieces in their order
 */
export function breakable(element) {
  const isLong = (element.textContent?.length ?? 0) > ONE_LINE;
  const [left, middle, right] = isLong && element.localName === 'mrow' && element.children.length === 3 ? element.children : [];
  if (!middle) return [[element]];
  const text = middle.textContent ?? '';
  if (left.textContent === '(') return joined([[left]], breakable(middle), [[right]]);
  // At the beginning of its piece it would be taken for a sign, without room around it.
  if (middle.localName === 'mo') middle.setAttribute('form', 'infix');
  if (middle.localName === 'mo' && ['+', '−'].includes(text)) return [...breakable(left), ...joined([[middle]], breakable(right))];
  const isProduct = middle.localName === 'mtext' || ['\u2062', '·'].includes(text);
  const isBulky = (right.textContent?.length ?? 0) > BULKY;
  return isProduct && isBulky ? [...breakable(left), ...joined([[middle]], breakable(right))] : [[element]];
}

/** Lists of pieces one after the other, each sticking to the one before it. @param {Element[][][]} lists */
export const joined = (...lists) =>
  lists.reduce((all, [first, ...rest]) => [...all.slice(0, -1), [...(all.at(-1) ?? []), ...first], ...rest]);

/** A formula as it was written, as far as it is worth reading. @param {string} source */
const beginningOf = (source) => math('mtext', source.length > BEGINNING ? `${source.slice(0, BEGINNING).trimEnd()} …` : source);

/**
 * @param {string} source
 * @param {readonly string[]} names that it may use besides functions and constants
 * @returns {Element | null} null: it has a mistake
 */
export function typeset(source, names) {
  if (source.length > LIMITS.characters) return null;
  try {
    const scope = new Map([...['pi', 'e', 'tau'], ...names].map((name) => [name, { kind: /** @type {const} */ ('parameter'), value: 0 }]));
    const program = parse(source, scope);
    if (program.length > MOST_STEPS) return beginningOf(source);
    /** @type {Piece[]} */
    const stack = [];
    for (const step of program) stack.push(step.kind === 'call' ? call(step.name, stack.splice(-step.value)) : leaf(step));
    return stack[0].element;
  } catch {
    return null;
  }
}
