/* Sentences that say what to write instead. */

import { functions } from './functions.js';

/** What to write instead of characters that are no part of an expression. */
const ALTERNATIVES = [
  ['=', 'an expression has no "="; for an equation a = b write a - (b)'],
  ['<>≤≥', 'comparisons are not available; use min, max, abs or sign'],
  ['[]{}', 'write round brackets ( ) instead'],
  ['%', 'for the remainder of a/b write a - b*floor(a/b)'],
  ['°', 'angles are in radians; for degrees write *pi/180'],
  [';', 'write one expression without ";"'],
  ['‐‑‒–—', 'a dash is no minus sign; write -'],
];

/** What to write instead of names that other programs know. */
const TRANSLATIONS = new Map([
  ['Math', 'the name alone, as in sin(…)'],
  ['lg', 'log10(…)'],
  ['tg', 'tan(…)'],
  ['cot', '1/tan(…)'],
  ['ctg', '1/tan(…)'],
  ['coth', '1/tanh(…)'],
  ['sec', '1/cos(…)'],
  ['sech', '1/cosh(…)'],
  ['csc', '1/sin(…)'],
  ['cosec', '1/sin(…)'],
  ['csch', '1/sinh(…)'],
  ['mod', 'a - b*floor(a/b)'],
  ['ceil', '-floor(-(…))'],
  ['round', 'floor(… + 0.5)'],
  ['fract', 'a - floor(a)'],
  ['sqr', '(…)^2'],
  ['norm', 'hypot(…)'],
  ['clamp', 'min(max(…, low), high)'],
  ['mix', 'a + (b - a)*t'],
  ['smoothstep', 't^2*(3 - 2*t)'],
  ['length', 'hypot(…)'],
  ['if', 'it with min, max, abs or sign'],
]);

/** Longer names are not repeated in full, nor compared with others. */
const LONGEST_NAME = 24;

/** @param {string} symbol a character that no expression contains, or not here */
export function unexpected(symbol) {
  const code = /** @type {number} */ (symbol.codePointAt(0));
  if (/[\p{C}\p{Z}\p{M}]/u.test(symbol))
    return `here stands an invisible character, U+${code.toString(16).toUpperCase().padStart(4, '0')}; remove it`;
  const [, advice] = ALTERNATIVES.find(([symbols]) => symbols.includes(symbol)) ?? [];
  return advice ?? `"${symbol}" is no part of an expression; write it with + - * / ^ ( ), numbers and names`;
}

/** @param {string} name @param {number} count of arguments it was given */
export function wrongCount(name, count) {
  const { least, most } = /** @type {import('./functions.js').Callable} */ (functions.get(name));
  const wanted = most > 2 ? 'at least one argument' : least === 1 ? 'one argument' : 'two arguments';
  return `${name} takes ${wanted}, not ${count === 0 ? 'none' : count}; write ${name}(${least === 2 ? '…, …' : '…'})`;
}

/** @param {string} name @param {boolean} isCall whether a bracket follows @param {string[]} known names that may be used as numbers */
export function unknown(name, isCall, known) {
  const kind = isCall ? 'function' : 'name';
  const translation = TRANSLATIONS.get(name);
  if (translation) return `unknown ${kind} ${name}; write ${translation}`;
  const near = takeApart(name, isCall, known) || suggest(name, isCall ? [...functions.keys()] : [...known, ...functions.keys()]);
  const listed = (isCall ? [...functions.keys()] : known).join(', ');
  const shown = name.length > LONGEST_NAME ? `${name.slice(0, LONGEST_NAME)}…` : name;
  const others = `the ${kind}s here are ${listed}${isCall ? '' : '; or give it a value in parameters'}`;
  // Some of these look like others.
  const script = /[Ѐ-ӿ]/.test(shown) ? ' in Cyrillic' : '';
  return `unknown ${kind} ${shown}${script}; ${near ? `did you mean ${near}?` : others}`;
}

/**
 * What a name may be that was written without the signs between its parts: `sin(x)` for `sinx`, `pi*r` for `pir`, `x^2` for `x2`.
 * @param {string} name @param {boolean} isCall @param {string[]} known names that may be used as numbers
 * @returns {string} '' where it is no such thing
 */
function takeApart(name, isCall, known) {
  if (name.length > LONGEST_NAME) return '';
  for (let i = 1; i < name.length; i++) {
    const [head, tail] = [name.slice(0, i), name.slice(i)];
    if (isCall && known.includes(head) && functions.has(tail)) return `${head}*${tail}(…)`;
    if (isCall) continue;
    if (functions.has(head) && known.includes(tail)) return `${head}(${tail})`;
    if (known.includes(head) && known.includes(tail)) return `${head}*${tail}`;
    if (known.includes(head) && /^\d+$/.test(tail)) return `${head}^${tail} or ${tail}*${head}`;
  }
  return '';
}

/**
 * Finds the name nearest to a mistyped one, or the product it was probably meant as (`uv` for `u*v`).
 * @param {string} name
 * @param {string[]} known
 * @returns {string} '' where nothing is near
 */
function suggest(name, known) {
  if (name.length > LONGEST_NAME) return '';
  const letters = [...name];
  if (letters.length > 1 && letters.every((letter) => known.includes(letter))) return letters.join('*');
  let nearest = '';
  let least = name.length === 1 ? 1 : name.length <= 3 ? 2 : 3;
  for (const candidate of known) {
    // Of two that are as near the one that was gone beyond: sinn is sin, not sign.
    const distance = editDistance(name.toLowerCase(), candidate.toLowerCase()) - (name.startsWith(candidate) ? 0.5 : 0);
    if (distance >= Math.min(least, candidate.length)) continue;
    nearest = candidate;
    least = distance;
  }
  return nearest;
}

/**
 * How many characters have to be inserted, removed or replaced to make one word of the other (Levenshtein).
 * @param {string} a
 * @param {string} b
 */
export function editDistance(a, b) {
  let row = Array.from({ length: b.length + 1 }, (_, j) => j);
  for (let i = 1; i <= a.length; i++) {
    const next = [i];
    for (let j = 1; j <= b.length; j++) {
      next.push(Math.min(row[j] + 1, next[j - 1] + 1, row[j - 1] + Number(a[i - 1] !== b[j - 1])));
    }
    row = next;
  }
  return row[b.length];
}
