/** What callers pass: checked, with errors that name the function and the argument, and say what it must be. */

/** A value as an error message shows it. @param {unknown} value */
export function describe(value) {
  if (value === null) return 'null';
  if (typeof value === 'string') return `'${value.length > 40 ? `${value.slice(0, 40)}…` : value}'`;
  if (typeof value === 'bigint') return `${value}n`;
  if (Array.isArray(value)) return `an array of ${value.length}`;
  if (typeof value !== 'object') return typeof value === 'function' ? 'a function' : String(value);
  const type = Object.prototype.toString.call(value).slice(8, -1);
  return type === 'Object' ? 'an object' : `an object of type ${type}`;
}

/** Throws. @param {string} name function and argument @param {string} what it must be @param {unknown} value @param {ErrorConstructor} [Kind] @returns {never} */
export function refuse(name, what, value, Kind = TypeError) {
  throw new Kind(`${name} must be ${what}, not ${describe(value)}`);
}

/** Throws where a number is wanted: a RangeError if it is one. @param {string} name @param {string} what @param {unknown} value @returns {never} */
export function refuseNumber(name, what, value) {
  refuse(name, what, value, typeof value === 'number' ? RangeError : TypeError);
}

/** Throws where one of some names is wanted: a RangeError if it is a name. @param {string} name @param {string} what @param {unknown} value @returns {never} */
export function refuseName(name, what, value) {
  refuse(name, what, value, typeof value === 'string' ? RangeError : TypeError);
}

/** Throws where a method has lost what it belongs to, or sees it through a Proxy, which has no private fields. @param {string} caller @param {string} owner @param {string} name as in the manual @returns {never} */
export function refuseReceiver(caller, owner, name) {
  throw new TypeError(`${caller} belongs to ${owner}: call it as ${name}.${caller}, not through a Proxy (in Vue: markRaw or shallowRef)`);
}

/** Whether it holds named values: no array, and no Map, whose entries would go unnoticed. @param {unknown} value @returns {value is Record<string, any>} */
export const isNamed = (value) => typeof value === 'object' && value !== null && !(Symbol.iterator in value);

/** Named values. @param {string} name @param {unknown} value @param {string} [what] */
export function checkObject(name, value, what = 'an object') {
  if (!isNamed(value)) refuse(name, what, value);
}

/**
 * All fields of an object as its own, inherited ones too, but for what every object has: as who reads them one by one finds them.
 * @param {any} given @returns {Record<string, any>}
 */
export function allFields(given) {
  /** @type {Record<string, any>} */
  const fields = {};
  for (const name in given) if (Object.hasOwn(given, name) || !(name in Object.prototype)) fields[name] = given[name];
  return fields;
}

/** Options, none where they are absent; refuses those that do not exist, and so a URL or a Response in their place. @param {string} caller @param {any} options @param {string[]} known @returns {any} */
export function checkOptions(caller, options = {}, known) {
  checkObject(`${caller}: options`, options);
  for (const name in options)
    if (!known.includes(name) && !(name in Object.prototype) && options[name] !== undefined)
      throw new TypeError(`${caller}: there is no option '${name}'; the options are ${known.join(', ')}`);
  return options;
}

/** @param {string} caller @param {string} name @param {unknown} value @param {number} least @param {number} most @returns {number} */
export function wholeNumber(caller, name, value, least, most) {
  if (!Number.isInteger(value) || /** @type {number} */ (value) < least || /** @type {number} */ (value) > most)
    refuseNumber(`${caller}: options.${name}`, `a whole number from ${least} to ${most}`, value);
  return /** @type {number} */ (value);
}

/** @param {string} caller @param {unknown} tolerance @param {number} least @param {number} most @returns {number} */
export function readTolerance(caller, tolerance, least, most) {
  if (typeof tolerance !== 'number' || !(tolerance >= least && tolerance <= most))
    refuseNumber(`${caller}: options.tolerance`, `a number between ${least} and ${most}`, tolerance);
  return tolerance;
}

/** @param {string} caller @param {string} name @param {unknown} value */
export function checkBoolean(caller, name, value) {
  if (typeof value !== 'boolean') refuse(`${caller}: options.${name}`, 'true or false', value);
}

/** @param {string} caller @param {string} name of the argument @param {ArrayLike<number>} numbers each of which must be finite @returns {number[]} a copy */
export function readFinite(caller, name, numbers) {
  const copy = Array.from(numbers);
  for (let i = 0; i < copy.length; i++) if (!Number.isFinite(copy[i])) refuseNumber(`${caller}: ${name}[${i}]`, 'a finite number', copy[i]);
  return copy;
}
