/** Definitions of surfaces, and points on them, as callers write them: checked, with errors that name what is wrong. */

import { checkObject, describe, isNamed, readFinite, refuse, refuseNumber } from './arguments.js';
import { editDistance } from './expression/advice.js';

/** @typedef {string | number} Expression a formula, or a number */

/**
 * @typedef {object} ParametricDefinition S(u, v) over a closed rectangle
 * @property {Expression} x over u, v and the parameters; so are y and z
 * @property {Expression} y
 * @property {Expression} z
 * @property {readonly [Expression, Expression]} u range of u, constants and parameters only
 * @property {readonly [Expression, Expression]} v range of v
 * @property {'auto' | { u?: boolean, v?: boolean }} [periodic] which directions are closed; default 'auto': where S and its first derivatives agree on both edges, straight, turned over or shifted, and the formulas repeat
 * @property {Readonly<Record<string, number>>} [parameters] named constants; `set` changes them without recompiling
 * @property {Expression} [density] ρ > 0 over u, v, x, y, z and the parameters: the length element is ρ ds, so that paths avoid where it is large
 * @property {{ E: Expression, F: Expression, G: Expression }} [metric] over u, v and the parameters: replaces the metric that space induces;
 *   positions are then only drawn. With a density: ρ² times this
 */

/**
 * @typedef {object} MetricDefinition ds² = E du² + 2F du dv + G dv² over a closed rectangle, without positions in space
 * @property {Expression} E over u, v and the parameters; so are F and G; EG − F² > 0 and E > 0 wherever paths go
 * @property {Expression} F
 * @property {Expression} G
 * @property {readonly [Expression, Expression]} u range of u, constants and parameters only
 * @property {readonly [Expression, Expression]} v range of v
 * @property {'auto' | { u?: boolean, v?: boolean }} [periodic] which directions are closed; default 'auto': none, for a metric does not tell
 * @property {Readonly<Record<string, number>>} [parameters]
 */

/**
 * @typedef {object} ImplicitDefinition f(x, y, z) = 0
 * @property {Expression} f over x, y, z and the parameters; smooth, with ∇f ≠ 0 on the surface
 * @property {readonly [readonly [number, number], readonly [number, number], readonly [number, number]]} [bounds] where the surface is searched, no wall; needed by `mesh`
 * @property {Readonly<Record<string, number>>} [parameters]
 * @property {Expression} [density] ρ > 0 over x, y, z and the parameters: the length element is ρ ds
 * @property {{ xx: Expression, xy: Expression, xz: Expression, yy: Expression, yz: Expression, zz: Expression }} [metric] a symmetric tensor T over x, y, z
 *   and the parameters, positive definite on the tangent planes: the length element is √(dxᵀ T dx). With a density: ρ² times this
 */

/** @param {string} caller @param {string} name @param {unknown} value */
export function checkExpression(caller, name, value) {
  if (typeof value !== 'string' && !(typeof value === 'number' && Number.isFinite(value)))
    refuseNumber(`${caller}: ${name}`, 'a formula in a string, or a finite number', value);
}

/** Several formulas in an array. @param {string} caller @param {string} name @param {unknown} value @param {number} count */
export function checkExpressions(caller, name, value, count) {
  if (!Array.isArray(value) || value.length !== count)
    refuse(`${caller}: ${name}`, `${count} formulas, ${count === 2 ? '[x, y]' : '[x, y, z]'}`, value);
  for (const [i, one] of value.entries()) checkExpression(caller, `${name}[${i}]`, one);
}

/** Names that the optional fields have elsewhere, in small letters and without what stands between them. @type {Record<string, string[]>} */
const SYNONYMS = {
  periodic: ['period', 'periods', 'closed', 'cyclic', 'wrap'],
  parameters: ['params', 'param', 'constants', 'variables', 'args'],
  density: ['weight', 'weights', 'rho', 'ρ', 'cost'],
  metric: ['tensor', 'metrictensor'],
  bounds: ['bbox', 'box', 'boundingbox', 'aabb', 'extent', 'extents', 'limits', 'domain'],
  reference: ['up', 'upvector'],
};

/** What to tell those who give such a field to a kind that has none. @type {Record<string, string>} */
const ELSEWHERE = {
  periodic: 'an implicit surface closes where its formula does',
  bounds: 'the ranges of its parameters bound it',
  reference: 'tube and sweep do',
};

/** Fields that a definition may do without; of density and metric `readMeasure` has more to say. @param {string} kind */
const optionalOf = (kind) => [
  ...['parameters', 'density', 'metric', kind === 'implicit' ? 'bounds' : 'periodic'],
  ...(kind === 'tube' || kind === 'sweep' ? ['reference'] : []),
];

/** @param {string} name @param {string} field */
function isLike(name, field) {
  const letters = name.slice(0, 12).toLowerCase();
  const synonym = letters.replace(/[^\p{L}]/gu, '');
  return SYNONYMS[field].includes(synonym) || editDistance(letters, field) <= (field.length > 6 ? 2 : 1);
}

/**
 * Other fields are ignored, as a title or a source is, but not where they look like one that the kind may have and this definition has not, or are known to other
 * kinds alone: its absence would go unnoticed.
 * @param {string} kind @param {any} definition @param {string[]} required
 */
function checkSpelling(kind, definition, required) {
  const optional = optionalOf(kind);
  for (const [name, value] of Object.entries(definition)) {
    if (value === undefined || required.includes(name) || optional.includes(name)) continue;
    if (Object.hasOwn(ELSEWHERE, name)) throw new TypeError(`${kind}: the definition takes no ${name}; ${ELSEWHERE[name]}`);
    const meant = optional.find((field) => definition[field] === undefined && isLike(name, field));
    if (meant) throw new TypeError(`${kind}: the definition has no field '${name.slice(0, 12)}'; did you mean ${meant}?`);
  }
}

/** @param {string} caller @param {any} definition @param {string[]} required @param {string[]} expressions those of them that are formulas */
export function checkDefinition(caller, definition, required, expressions) {
  checkObject(`${caller}: the definition`, definition);
  for (const name of required)
    if (definition[name] === undefined)
      throw new TypeError(
        `${caller}: the definition needs ${required.join(', ')}; ${name} is missing${definition.metric?.E ? '; surfpath.metric takes E, F and G alone' : ''}`,
      );
  for (const name of expressions) checkExpression(caller, name, definition[name]);
  checkSpelling(caller, definition, required);
}

/** @param {string} caller @param {any} periodic @returns {'auto' | { u?: boolean, v?: boolean }} a copy */
export function checkPeriodic(caller, periodic = 'auto') {
  if (periodic === 'auto') return periodic;
  const isChoice = isNamed(periodic);
  const bad = isChoice
    ? Object.entries(periodic).find(([name, value]) => !['u', 'v'].includes(name) || !(typeof value === 'boolean' || value === undefined))
    : [];
  if (bad)
    throw new TypeError(
      `${caller}: periodic must be 'auto' or { u, v } of true or false, not ${isChoice ? `${bad[0]}: ${describe(bad[1])}` : describe(periodic)}`,
    );
  return { ...periodic };
}

/** Whether it may be a list: what has a length that counts, as that of a Path does not. @param {any} value @returns {value is ArrayLike<number>} */
const isList = (value) => typeof value === 'object' && Number.isInteger(value?.length);

/** Points or pairs as a flat list; looked at one by one, as its length may be anything. @param {string} name for messages, of points @param {any} list @param {string[]} variables of one @param {string} one what one is @returns {Float64Array} a copy, which no getter can change */
export function readList(name, list, variables, one) {
  const what = `a flat array of ${variables.join(' ')}, ${variables.length} numbers a ${one}`;
  if (!isList(list)) refuse(name, what, list);
  for (let i = 0; i < list.length; i++)
    if (typeof list[i] !== 'number') throw new TypeError(`${name} must be ${what}; it holds ${describe(list[i])}`);
  if (list.length % variables.length) throw new RangeError(`${name} must be ${what}, not ${list.length} numbers`);
  return new Float64Array(list);
}

/** @param {string} caller @param {unknown} given @returns {Record<string, number>} a copy without prototype */
export function checkParameters(caller, given) {
  /** @type {Record<string, number>} */
  const parameters = Object.create(null);
  checkObject(`${caller}: parameters`, given, 'an object of numbers');
  for (const [name, value] of Object.entries(/** @type {Record<string, number>} */ (given))) {
    if (!Number.isFinite(value)) refuseNumber(`${caller}: parameter ${name}`, 'a finite number', value);
    parameters[name] = value;
  }
  return parameters;
}

/** @param {string} caller @param {any} range an array of any type @param {string} name @returns {[Expression, Expression]} a copy */
export function readRange(caller, range, name) {
  if (typeof range !== 'object' || range?.length !== 2) refuse(`${caller}: ${name}`, 'a range [from, to]', range);
  const ends = /** @type {[Expression, Expression]} */ (Array.from(range));
  for (const [i, end] of ends.entries()) checkExpression(caller, `${name}[${i}]`, end);
  return ends;
}

/** @param {string} caller @param {any} bounds @returns {number[] | null} xmin xmax ymin ymax zmin zmax */
export function checkBounds(caller, bounds) {
  if (bounds === undefined) return null;
  if (!Array.isArray(bounds) || bounds.length !== 3)
    refuse(`${caller}: bounds`, 'three ranges, [[xmin, xmax], [ymin, ymax], [zmin, zmax]]', bounds);
  const box = [];
  for (const [i, range] of bounds.entries()) {
    const ends = readNumbers(caller, `bounds[${i}]`, range, ['min', 'max']);
    if (!(ends[0] < ends[1])) throw new RangeError(`${caller}: bounds[${i}] must be two numbers, the smaller first, not ${ends}`);
    box.push(...ends);
  }
  return box;
}

/** @param {string} caller @param {string} name @param {unknown} given @param {string[]} variables one a number @returns {number[]} */
export function readNumbers(caller, name, given, variables) {
  /* Messages are put together only where one is needed: every question reads two points. */
  const what = () => `[${variables.join(', ')}]`;
  const count = variables.length;
  if (!isList(given)) refuse(`${caller}: ${name}`, what(), given);
  if (given.length !== count) throw new RangeError(`${caller}: ${name} must be ${what()}, ${count} numbers, not ${given.length}`);
  return readFinite(caller, name, given);
}
