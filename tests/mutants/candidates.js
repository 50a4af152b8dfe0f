/**
 * What can be changed in a source by one small mistake: every place and every mistake, found in the text. Knows no grammar: what does not compile is no mutant, and
 * the compiler tells which comparisons are of doubles (`asEqual`).
 */

import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';

/** Each: what it looks like, and the mistakes that could stand there. @type {[RegExp, (found: string) => string[]][]} */
const MISTAKES = [
  [/(?<= )<(?= )/g, () => ['<=', '>']],
  [/(?<= )<=(?= )/g, () => ['<', '>=']],
  [/(?<= )>(?= )/g, () => ['>=', '<']],
  [/(?<= )>=(?= )/g, () => ['>', '<=']],
  [/(?<= )===?(?= )/g, (found) => [found.replace('=', '!')]],
  [/(?<= )!==?(?= )/g, (found) => [found.replace('!', '=')]],
  [/(?<= )&&(?= )/g, () => ['||']],
  [/(?<= )\|\|(?= )/g, () => ['&&']],
  [/(?<= )\+(?= )/g, () => ['-']],
  [/(?<= )-(?= )/g, () => ['+']],
  [/(?<= )\*(?= )/g, () => ['/']],
  [/(?<= )\/(?= )/g, () => ['*']],
  [/(?<= )\+=(?= )/g, () => ['-=']],
  [/(?<= )-=(?= )/g, () => ['+=']],
  [/(?<=\bif \()(?=\w)/g, () => ['!']],
  [/(?<=\breturn )(0|1|true|false)(?=;)/g, (found) => [{ 0: '1', 1: '0', true: 'false', false: 'true' }[found] ?? found]],
  [/(?<=[ ([])\d+(?=[ ,;)\]])/g, (found) => [String(Number(found) + 1)]],
  [/(?<=[ (-])\d+\.\d+(?=[ ,;)])/g, (found) => [String(Number(found) * 1.01 + 0.001)]],
];

/**
 * @typedef {object} Mutant
 * @property {string} file
 * @property {number} line from 1
 * @property {string} before the line, trimmed
 * @property {string} after
 * @property {string} key of its place in the order: moves no more than the line itself does when other lines change
 * @property {string} text of the whole file
 * @property {string | null} asEqual where only the boundary of a comparison moves, and one side is a result of arithmetic: the text with == in its place
 * @property {number} column of the change, from 1
 */

/** Comments blanked, so that nothing is found there. @param {string} text */
const withoutComments = (text) => text.replace(/\/\*[\s\S]*?\*\/|(?<=^|\s)\/\/.*/g, (comment) => comment.replace(/[^\n]/g, ' '));

/** Names and sizes of C variables, no values: room for more than is used is no mistake. @param {string} code */
const isDeclaration = (code) => /^\s*(?!return\b)(?:\w+ )+\*?\w+(?:\[[^\]]*\])*(?:, \*?\w+(?:\[[^\]]*\])*)*;$/.test(code);

/** From < to <=, and the like. @param {string} found @param {string} by */
const movesBoundary = (found, by) => /^[<>]=?$/.test(found) && /^[<>]=?$/.test(by) && found[0] === by[0];

/** What stands beside an operator, up to the next weaker one or the bracket that both are in. @param {string} text away from it, so backwards on its left @param {RegExp} opening a bracket that begins a part @param {RegExp} closing */
function operandIn(text, opening, closing) {
  let depth = 0;
  for (let i = 0; i < text.length; i++) {
    if (opening.test(text[i])) depth++;
    else if (closing.test(text[i])) depth--;
    if (depth < 0 || (depth === 0 && /[&|?:;,={}]/.test(text[i]))) return text.slice(0, i);
  }
  return text;
}

/** Whether a result of arithmetic, outside of indices, is compared with something that is no literal. @param {string} code @param {number} at @param {number} length of the operator */
function comparesArithmetic(code, at, length) {
  const left = [...operandIn([...code.slice(0, at)].reverse().join(''), /[)\]]/, /[([]/)].reverse().join('').replace('return ', '');
  const right = operandIn(code.slice(at + length), /[([]/, /[)\]]/);
  const sides = [left, right].map((side) => side.replace(/\[[^\]]*\]/g, ''));
  return !sides.some((side) => /^\s*-?[\d.]+\s*$/.test(side)) && sides.some((side) => / [-+*/] /.test(side));
}

/**
 * Every mutant of a file.
 * @param {string} folder @param {string} file in it
 * @param {number} seed
 * @returns {Mutant[]}
 */
export function findMutants(folder, file, seed) {
  const lines = readFileSync(`${folder}/${file}`, 'utf8').split('\n');
  return withoutComments(lines.join('\n'))
    .split('\n')
    .flatMap((code, number) => {
      if (/^\s*(#|import|export \{)/.test(code) || isDeclaration(code)) return [];
      return changesOf(code).map(({ at, length, by }) => {
        const line = lines[number];
        const replaced = (/** @type {string} */ text) => line.slice(0, at) + text + line.slice(at + length);
        const whole = (/** @type {string} */ text) => [...lines.slice(0, number), text, ...lines.slice(number + 1)].join('\n');
        const changed = replaced(by);
        const rounds = movesBoundary(code.slice(at, at + length), by) && comparesArithmetic(code, at, length);
        const [before, after] = [line.trim(), changed.trim()];
        const key = createHash('sha256').update(`${seed} ${file} ${before} ${after}`).digest('hex');
        return {
          file,
          line: number + 1,
          before,
          after,
          key,
          text: whole(changed),
          asEqual: rounds ? whole(replaced('==')) : null,
          column: at + 1,
        };
      });
    });
}

/** @param {string} code @returns {{ at: number, length: number, by: string }[]} */
function changesOf(code) {
  return MISTAKES.flatMap(([pattern, mistakes]) =>
    [...code.matchAll(pattern)].flatMap((match) => mistakes(match[0]).map((by) => ({ at: match.index, length: match[0].length, by }))),
  );
}
