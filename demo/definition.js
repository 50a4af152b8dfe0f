/** Between the texts of the form and the definitions of surfaces: which fields a kind of surface has, both translations, whose fault an error is. */

import { ExpressionError } from 'surfpath';

/** @typedef {'parametric' | 'implicit'} Kind */
/** @typedef {Record<string, string>} Texts what the fields hold, by name */
/** @typedef {{ field: string | null, source: string, index: number, message: string }} Problem field null: no single field is at fault */
/** @typedef {import('surfpath').ParametricDefinition & { kind: 'parametric' }} Parametric */
/** @typedef {import('surfpath').ImplicitDefinition & { kind: 'implicit' }} Implicit */

/** Formulas of a kind, and the variables that have a range. */
export const FIELDS = {
  parametric: { formulas: ['x', 'y', 'z'], ranges: ['u', 'v'] },
  implicit: { formulas: ['f'], ranges: ['x', 'y', 'z'] },
};

/** What a formula of one's own starts from. @type {Record<Kind, { texts: Texts, ends: number[][] }>} */
export const OWN = {
  parametric: {
    texts: { x: 'u', y: 'v', z: 'sin(u)*cos(v)', 'u-from': '-pi', 'u-to': 'pi', 'v-from': '-pi', 'v-to': 'pi' },
    ends: [
      [-2.2, -1.5],
      [2.4, 1.2],
    ],
  },
  implicit: {
    texts: { f: 'x^4+y^4+z^4-1', 'x-from': '-1.2', 'x-to': '1.2', 'y-from': '-1.2', 'y-to': '1.2', 'z-from': '-1.2', 'z-to': '1.2' },
    ends: [
      [0.2, -0.9, 0.6],
      [0.9, 0.3, 0.6],
    ],
  },
};

/** Coordinates of an end point. @param {Kind} kind */
export const coordinates = (kind) => FIELDS[kind].ranges;

/** @param {Kind} kind @returns {string[]} names of its fields in the order of the form */
export const fieldNames = (kind) => [...FIELDS[kind].formulas, ...FIELDS[kind].ranges.flatMap((name) => [`${name}-from`, `${name}-to`])];

/** @param {Parametric | Implicit} definition @returns {Texts} */
export function textsOf(definition) {
  /** @type {Texts} */
  const texts = {};
  const { formulas, ranges } = FIELDS[definition.kind];
  const given = /** @type {Record<string, any>} */ (definition);
  for (const name of formulas) texts[name] = String(given[name]);
  for (const [i, name] of ranges.entries()) {
    const range = definition.kind === 'implicit' ? definition.bounds?.[i] : given[name];
    [texts[`${name}-from`], texts[`${name}-to`]] = (range ?? [-1, 1]).map(String);
  }
  return texts;
}

/**
 * @param {Kind} kind @param {Texts} texts @param {Readonly<Record<string, number>>} parameters
 * @returns {Parametric | Implicit}
 */
export function definitionOf(kind, texts, parameters) {
  const range = (/** @type {string} */ name) => /** @type {[string, string]} */ ([texts[`${name}-from`], texts[`${name}-to`]]);
  if (kind === 'parametric') return { kind, x: texts.x, y: texts.y, z: texts.z, u: range('u'), v: range('v'), parameters };
  const bounds = /** @type {any} */ (FIELDS.implicit.ranges.map((name) => range(name).map(Number)));
  return { kind, f: texts.f, bounds, parameters };
}

/** The fields of an implicit surface's box hold numbers, not formulas. @param {Kind} kind @param {Texts} texts @returns {Problem | null} */
export function findBadBound(kind, texts) {
  if (kind !== 'implicit') return null;
  for (const name of FIELDS.implicit.ranges) {
    const [from, to] = [`${name}-from`, `${name}-to`];
    for (const field of [from, to])
      if (!texts[field].trim() || !Number.isFinite(Number(texts[field])))
        return { field, source: '', index: 0, message: 'Write a number here, such as -1.5.' };
    if (Number(texts[from]) >= Number(texts[to]))
      return { field: to, source: '', index: 0, message: 'Write a number greater than the one before it.' };
  }
  return null;
}

/** A message of the library as a sentence, without the name of the function or field before it. @param {string} message */
export function sentence(message) {
  const text = message.replace(/^(?:[a-z]+: )+/i, '');
  return `${text[0].toUpperCase()}${text.slice(1)}${/[.!?]$/.test(text) ? '' : '.'}`;
}

/** What an error says about the form. @param {unknown} error @param {Kind} kind @param {Texts} texts @returns {Problem} */
export function problemOf(error, kind, texts) {
  const message = sentence(error instanceof Error ? error.message : String(error));
  if (!(error instanceof ExpressionError)) return { field: null, source: '', index: 0, message };
  const { argument, source, index } = error;
  const field = fieldNames(kind).find((name) => name === argument) ?? fieldNames(kind).find((name) => texts[name] === source) ?? null;
  return { field, source, index, message };
}
