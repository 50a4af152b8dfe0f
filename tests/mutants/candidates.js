/** What can be changed in a source by one small mistake: every place and every mistake, found in the text. Knows no grammar: what does not compile is no mutant. */

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
 */

/** Comments blanked, so that nothing is found there. @param {string} text */
const withoutComments = (text) => text.replace(/\/\*[\s\S]*?\*\/|(?<=^|\s)\/\/.*/g, (comment) => comment.replace(/[^\n]/g, ' '));

/** Names and sizes of C variables, no values: room for more than is used is no mistake. @param {string} code */
const isDeclaration = (code) => /^\s*(?!return\b)(?:\w+ )+\*?\w+(?:\[[^\]]*\])*(?:, \*?\w+(?:\[[^\]]*\])*)*;$/.test(code);

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
        const changed = line.slice(0, at) + by + line.slice(at + length);
        const [before, after] = [line.trim(), changed.trim()];
        const key = createHash('sha256').update(`${seed} ${file} ${before} ${after}`).digest('hex');
        return {
          file,
          line: number + 1,
          before,
          after,
          key,
          text: [...lines.slice(0, number), changed, ...lines.slice(number + 1)].join('\n'),
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
