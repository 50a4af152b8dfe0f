/** Between the texts of the form and the definitions of surfaces: both translations, and whose fault an error is. */

import { KINDS, tensorNames } from './kinds.js';

/** @typedef {import('./kinds.js').Kind} Kind */
/** @typedef {Record<string, string>} Texts what the fields hold, by name */
/** @typedef {{ field: string | null, source: string, index: number, message: string }} Problem field null: no single field is at fault */
/** @typedef {import('surfpath').AnyDefinition} Definition */

/** Coordinates of an end point. @param {Kind} kind */
export const coordinates = (kind) => KINDS[kind].coordinates;

/** @param {Kind} kind @returns {string[]} names of its fields in the order of the form */
export const fieldNames = (kind) => [
  ...Object.keys(KINDS[kind].formulas),
  ...KINDS[kind].ranges.flatMap((name) => [`${name}-from`, `${name}-to`]),
];

/** The part of a definition that a field holds, and which element of it, if it is a list. @param {string} field @returns {[string, number | null]} */
function placeInDefinition(field) {
  const [name, index] = field.split(/[[\]]/);
  return [name, index === undefined ? null : Number(index)];
}

/** @param {{ kind: Kind, bounds?: any } & Record<string, any>} definition @returns {Texts} */
export function textsOf(definition) {
  /** @type {Texts} */
  const texts = {};
  const { formulas, ranges } = KINDS[definition.kind];
  for (const field of Object.keys(formulas)) {
    const [name, index] = placeInDefinition(field);
    texts[field] = String(index === null ? definition[name] : definition[name][index]);
  }
  for (const [i, name] of ranges.entries()) {
    const range = definition.kind === 'implicit' ? definition.bounds?.[i] : definition[name];
    [texts[`${name}-from`], texts[`${name}-to`]] = (range ?? [-1, 1]).map(String);
  }
  return texts;
}

/** The sides of an equation a = b, as people write them, or what is 0; f = …, f(x, y, z) = … is none. @param {string} text */
export function sidesOf(text) {
  const sides = text.split('=');
  const isEquation = sides.length === 2 && sides.every((side) => side.trim()) && !/^\s*f\s*[(=]/.test(text);
  const isWhole = sides[0].split('(').length === sides[0].split(')').length;
  return isEquation && isWhole ? sides : [text];
}

/**
 * @param {Kind} kind @param {Texts} texts @param {Readonly<Record<string, number>>} parameters
 * @returns {Definition}
 */
export function definitionOf(kind, texts, parameters) {
  /** @type {Record<string, any>} */
  const definition = { kind, parameters };
  const { formulas, ranges } = KINDS[kind];
  for (const field of Object.keys(formulas)) {
    const [name, index] = placeInDefinition(field);
    if (index === null) definition[name] = texts[field];
    else definition[name] = [...(definition[name] ?? []), texts[field]];
  }
  const pairs = ranges.map((name) => [texts[`${name}-from`], texts[`${name}-to`]]);
  if (kind === 'implicit') {
    const [left, right] = sidesOf(definition.f);
    definition.f = right ? `${left}-(${right})` : left;
    definition.bounds = pairs.map((pair) => pair.map(Number));
  } else for (const [i, name] of ranges.entries()) definition[name] = pairs[i];
  return /** @type {Definition} */ (definition);
}

/** The fields of an implicit surface's box hold numbers, not formulas. @param {Kind} kind @param {Texts} texts @returns {Problem | null} */
export function findBadBound(kind, texts) {
  if (kind !== 'implicit') return null;
  for (const name of KINDS.implicit.ranges) {
    const [from, to] = [`${name}-from`, `${name}-to`];
    for (const field of [from, to])
      if (!texts[field].trim() || !Number.isFinite(Number(texts[field])))
        return { field, source: '', index: 0, message: 'Write a number here, such as -1.5.' };
    if (Number(texts[from]) >= Number(texts[to]))
      return { field: to, source: '', index: 0, message: 'Write a number greater than the one before it.' };
  }
  return null;
}

/** Names that a message may begin with, which mean something else as capitals. */
const NAMES = new Set(
  Object.values(KINDS).flatMap(({ formulas, ranges, coordinates }) => [...Object.keys(formulas), ...ranges, ...coordinates]),
);

/** So begins what is said of any other name: of a function, of a parameter. */
const OF_NAME = /^\S+ (?:is (?:not )?a|takes) /;

/** What the library advises those who write programs, and what a reader of the page does instead. */
const [FOR_PROGRAMS, FOR_READERS] = ['or give it a value in parameters', 'or make it a slider'];
/** What it advises of an equation; and what to do where the formula of a coordinate was to be written. */
const [EQUATION, INSTEAD] = ['write a - (b)', 'choose Implicit'];

/** A number in six digits, at most. @param {number} x */
export const brief = (x) => String(Number(x.toPrecision(6)));

/** A message of the library as a sentence, without the name of the function or field before it; names of the reader's formula stay as they are; numbers are short. @param {string} message */
export function sentence(message) {
  const text = message
    .replace(/^(?:[a-z.]+(?:\[\d\])?: )+/i, '')
    .replace(FOR_PROGRAMS, FOR_READERS)
    .replace(/\[([^,]+), ?([^,]+)\]/, '$1 to $2')
    .replace(/\d+\.\d{6,}/g, (number) => brief(Number(number)));
  const [word] = text.split(' ');
  const first = NAMES.has(word) || OF_NAME.test(text) ? text[0] : text[0].toUpperCase();
  return `${first}${text.slice(1)}${/[.!?]$/.test(text) ? '' : '.'}`;
}

/** What an error says about the form. @param {unknown} error @param {Kind} kind @param {Texts} texts @returns {Problem} */
export function problemOf(error, kind, texts) {
  const message = sentence(error instanceof Error ? error.message : String(error));
  const { argument, source, index } = /** @type {{ argument?: string, source?: string, index?: number }} */ (error);
  if (source === undefined || index === undefined) return { field: null, source: '', index: 0, message };
  const names = [...fieldNames(kind), 'density', ...tensorNames(kind).map((name) => `metric.${name}`)];
  const ends = [`${argument}-from`, `${argument}-to`];
  const field = names.find((name) => name === argument) ?? ends.find((name) => texts[name] === source) ?? null;
  const isCoordinate = kind !== 'implicit' && field !== null && fieldNames(kind).includes(field);
  return { field, source, index, message: isCoordinate ? message.replace(EQUATION, INSTEAD) : message };
}
