/** What goes between a pool and its workers, where it is more than structured cloning carries: definitions as text, errors with their class. */

import { allFields, isNamed } from '../arguments.js';

/** Marks what JSON has no word for. No definition has a field of this name. */
const MARK = '\0';

/**
 * A definition as text, equal for equal ones, so that workers know a surface again.
 * @param {unknown} definition
 * @returns {string} throws a TypeError for what text cannot hold: functions, cycles, a BigInt, a Map
 */
export function writeDefinition(definition) {
  if (!isNamed(definition)) throw new TypeError('a definition is an object');
  const fields = Object.entries(allFields(definition)).filter(([_, value]) => value !== undefined);
  const texts = fields.map(([name, value]) => {
    try {
      return `${JSON.stringify(name)}:${JSON.stringify(value, replace)}`;
    } catch {
      throw new TypeError(`the definition's ${name} cannot be posted to a worker; leave it out`);
    }
  });
  return `{${texts}}`;
}

/** What JSON has no word for, as it can be read again; throws where that cannot be. @this {any} @param {string} _ @param {any} value */
function replace(_, value) {
  if (typeof value === 'number' && (!Number.isFinite(value) || Object.is(value, -0)))
    return { [MARK]: Object.is(value, -0) ? '-0' : String(value) };
  if (ArrayBuffer.isView(value)) return Array.from(/** @type {Float64Array} */ (value));
  const isList = Array.isArray(value) || typeof value === 'string';
  if (
    ['function', 'symbol'].includes(typeof value) ||
    (value === undefined && Array.isArray(this)) ||
    (!isList && value?.[Symbol.iterator])
  )
    throw new TypeError();
  return value;
}

/** @param {string} text of {@link writeDefinition} @returns {any} */
export function readDefinition(text) {
  return JSON.parse(text, (_, value) => (typeof value?.[MARK] === 'string' ? Number(value[MARK]) : value));
}

/** @typedef {{ name: string, message: string, stack: string | undefined, source?: string, index?: number, argument?: string }} PackedError */

/** An error as plain data. @param {any} error @returns {PackedError} */
export function packError(error) {
  const { name = 'Error', message = String(error), stack, source, index, argument } = error ?? {};
  return { name, message, stack, source, index, argument };
}

/**
 * The error that was packed, of the same class.
 * @param {PackedError} packed @param {typeof import('../expression/error.js').ExpressionError} ExpressionError
 * @returns {Error}
 */
export function unpackError({ name, message, stack, source = '', index = 0, argument = '' }, ExpressionError) {
  const Class = { TypeError, RangeError }[name] ?? Error;
  const error = name === 'ExpressionError' ? new ExpressionError(source, index, '', argument) : new Class(message);
  if (error.name !== name) error.name = name;
  error.message = message;
  if (stack) error.stack = stack;
  return error;
}
