/** What the attributes of <surface-path> say, as the library takes it. Pure: reads strings, knows no document. */

import { describe, refuse } from '../../arguments.js';
import { gallery } from '../../gallery.js';

/** @typedef {(name: string) => string | null} Attributes the value of an attribute, null where it is absent */
/** @typedef {import('../../instance.js').AnyDefinition} AnyDefinition */

/** Of each kind: attributes that are a formula, several of them, ranges. @type {Record<string, { formulas: string[], lists: string[], ranges: string[] }>} */
const KINDS = {
  parametric: { formulas: ['x', 'y', 'z'], lists: [], ranges: ['u', 'v'] },
  implicit: { formulas: ['f'], lists: [], ranges: [] },
  graph: { formulas: ['z'], lists: [], ranges: ['x', 'y'] },
  revolution: { formulas: ['r', 'z'], lists: [], ranges: ['t'] },
  tube: { formulas: ['radius'], lists: ['centreline'], ranges: ['t'] },
  sweep: { formulas: [], lists: ['profile', 'path'], ranges: ['s', 't'] },
};
/** An attribute that only one kind has, or that decides between those left. */
const SIGNS = /** @type {const} */ ([
  ['f', 'implicit'],
  ['centreline', 'tube'],
  ['profile', 'sweep'],
  ['r', 'revolution'],
  ['u', 'parametric'],
  ['v', 'parametric'],
  ['z', 'graph'],
  ['radius', 'tube'],
]);
const COLOURS = ['none', 'curvature', 'distance'];
const METRIC = { implicit: ['xx', 'xy', 'xz', 'yy', 'yz', 'zz'], other: ['E', 'F', 'G'] };

const named = [...new Set(Object.values(KINDS).flatMap(({ formulas, lists, ranges }) => [...formulas, ...lists, ...ranges]))];
/** What makes another surface, … */
export const SURFACE_ATTRIBUTES = ['surface', 'kind', 'bounds', 'parameters', 'periodic', 'density', 'metric', ...named];
/** … another path on it, … */
export const PATH_ATTRIBUTES = ['from', 'to', 'via', 'tolerance', 'points', 'algorithm', 'start'];
/** … or the same, drawn otherwise. */
export const LOOK_ATTRIBUTES = ['colour', 'controls', 'animate', 'camera', 'resolution'];

/** Parts between semicolons, or, where there is none, between commas. @param {string} text */
const split = (text) => text.split(text.includes(';') ? ';' : ',').map((part) => part.trim());

/** Numbers between commas or spaces. @param {string} name @param {string} text @returns {number[]} */
export function readNumbers(name, text) {
  const numbers = text
    .trim()
    .split(/\s*,\s*|\s+/)
    .map((part) => (part === '' ? Number.NaN : Number(part)));
  if (numbers.every(Number.isFinite)) return numbers;
  refuse(`surface-path: ${name}`, 'numbers between commas', text);
}

/** @param {string} name @param {string} text */
function readNumber(name, text) {
  const number = text.trim() ? Number(text) : Number.NaN;
  return Number.isFinite(number) ? number : refuse(`surface-path: ${name}`, 'a number', text);
}

/** @param {string} text 'R = 3, r = 1' @returns {Record<string, number>} */
function readParameters(text) {
  /** @type {[string, number][]} */
  const entries = split(text)
    .filter(Boolean)
    .map((part) => {
      const [name, value, ...rest] = part.split('=').map((side) => side.trim());
      if (!name || !value || rest.length > 0 || !Number.isFinite(Number(value)))
        refuse('surface-path: parameters', 'name=number between commas', part);
      return [name, Number(value)];
    });
  return Object.fromEntries(entries);
}

/** @param {string} text 'none', or names of directions @returns {'auto' | { u: boolean, v: boolean }} */
function readPeriodic(text) {
  const names = text.trim().split(/[\s,]+/);
  if (names.join() === 'auto') return 'auto';
  if (!names.every((name) => ['u', 'v', 'none'].includes(name)))
    refuse('surface-path: periodic', "'auto', 'none', 'u', 'v' or 'u v'", text);
  return { u: names.includes('u'), v: names.includes('v') };
}

/** The formulas that the attributes hold. @param {Attributes} attribute @returns {Record<string, any> & { kind: string }} */
function readFormulas(attribute) {
  const sign = SIGNS.find(([name]) => attribute(name) !== null)?.[1];
  // A range of x has no u or v: ranges of these are missing.
  const kind = attribute('kind') ?? (sign === 'graph' && /^[^,;]*[uv]/.test(attribute('x') ?? '') ? 'parametric' : sign);
  if (kind === undefined)
    throw new TypeError('surface-path: name a surface of the gallery (surface="torus"), or give formulas (x, y, z, u, v or f, bounds)');
  const fields = Object.hasOwn(KINDS, kind) ? KINDS[kind] : null;
  if (!fields) refuse('surface-path: kind', `one of ${Object.keys(KINDS).join(', ')}`, kind, RangeError);
  /** @type {Record<string, any> & { kind: string }} */
  const definition = { kind };
  for (const name of fields.formulas) definition[name] = attribute(name) ?? undefined;
  for (const name of [...fields.lists, ...fields.ranges]) {
    const text = attribute(name);
    if (text === null) continue;
    definition[name] = split(text);
    if (fields.ranges.includes(name) && definition[name].length !== 2) refuse(`surface-path: ${name}`, "a range as '-1, 1'", text);
  }
  return definition;
}

/** @param {string} text 'x, x; y, y; z, z' or one range for all three @returns {number[][]} */
function readBounds(text) {
  const ranges = text.split(';').map((range) => readNumbers('bounds', range));
  return ranges.length === 1 ? [ranges[0], ranges[0], ranges[0]] : ranges;
}

/** @param {string} name */
function findEntry(name) {
  if (Object.hasOwn(gallery, name)) return /** @type {Record<string, any>} */ (gallery)[name];
  const names = Object.keys(gallery);
  const meant = names.find((one) => one.toLowerCase() === name.toLowerCase());
  const advice = meant ? `did you mean ${meant}?` : `it has ${names.join(', ')}`;
  throw new RangeError(`surface-path: there is no surface ${describe(name)} in the gallery; ${advice}`);
}

/**
 * The definition of the surface: an entry of the gallery or formulas, with what the other attributes change of it.
 * @param {Attributes} attribute
 * @returns {AnyDefinition & { title?: string, from?: readonly number[], to?: readonly number[], camera?: readonly number[] }}
 */
export function readDefinition(attribute) {
  const name = attribute('surface');
  const definition = name === null ? readFormulas(attribute) : { ...findEntry(name.trim()) };
  const [bounds, parameters, periodic] = ['bounds', 'parameters', 'periodic'].map(attribute);
  const [density, metric] = ['density', 'metric'].map(attribute);
  if (bounds !== null) definition.bounds = readBounds(bounds);
  if (definition.kind === 'implicit' && !definition.bounds)
    throw new TypeError('surface-path: f is drawn inside bounds; give them, as in bounds="-2,2; -2,2; -1,1", or one range for all three');
  if (parameters !== null) definition.parameters = { ...definition.parameters, ...readParameters(parameters) };
  if (periodic !== null) definition.periodic = readPeriodic(periodic);
  if (density !== null) definition.density = density;
  if (metric !== null) {
    const names = definition.kind === 'implicit' ? METRIC.implicit : METRIC.other;
    const formulas = split(metric);
    if (formulas.length !== names.length)
      throw new TypeError(`surface-path: metric must be ${names.length} formulas, ${names.join('; ')}, not ${formulas.length}`);
    definition.metric = Object.fromEntries(names.map((key, i) => [key, formulas[i]]));
  }
  return /** @type {any} */ (definition);
}

/**
 * Both ends: the attributes, else the pair that the gallery suggests. The first alone: where distances are measured from; none: the surface alone.
 * @param {Attributes} attribute @param {Record<string, any>} definition
 * @returns {number[][]}
 */
export function readEnds(attribute, definition) {
  const [from, to] = ['from', 'to'].map((name) => {
    const text = attribute(name);
    const point = text === null ? definition[name] : readNumbers(name, text);
    return point && Array.from(point);
  });
  if (to && !from) throw new TypeError('surface-path: a path needs both ends; from is missing');
  return [from, to].filter(Boolean);
}

/** Options for `shortestPath`; only those that are given. @param {Attributes} attribute @returns {import('../../path.js').PathOptions} */
export function readOptions(attribute) {
  /** @type {Record<string, any>} */
  const options = {};
  for (const name of ['tolerance', 'points']) {
    const text = attribute(name);
    if (text !== null) options[name] = readNumber(name, text);
  }
  const algorithm = attribute('algorithm');
  if (algorithm !== null) options.algorithm = algorithm;
  const [via, start] = ['via', 'start'].map(attribute);
  const points = (/** @type {string} */ name, /** @type {string} */ text) => text.split(';').map((point) => readNumbers(name, point));
  if (via !== null) options.via = points('via', via);
  if (start !== null) options.start = start.includes(';') ? points('start', start).flat() : start;
  return options;
}

/**
 * How the surface is drawn.
 * @param {Attributes} attribute @param {Record<string, any>} definition @param {number[] | undefined} from the first end
 * @returns {import('../geometry.js').GeometryOptions & { camera?: readonly number[] }} camera: the direction to look from; absent: none is asked for
 */
export function readLook(attribute, definition, from) {
  const [colour, resolution, camera] = ['colour', 'resolution', 'camera'].map(attribute);
  if (colour !== null && !COLOURS.includes(colour))
    throw new RangeError(
      `surface-path: colour must be one of ${COLOURS.join(', ')}, not ${describe(colour)}; the surface's own is the custom property --surfpath-surface`,
    );
  const towards = camera === null ? definition.camera : readNumbers('camera', camera);
  if (towards && !(towards.length === 3 && towards.some((/** @type {number} */ x) => x !== 0)))
    refuse('surface-path: camera', 'a direction x, y, z to look from', camera, RangeError);
  return {
    colour: /** @type {any} */ (colour ?? 'none'),
    ...(colour === 'distance' ? { from } : {}),
    ...(resolution === null ? {} : { resolution: readNumber('resolution', resolution) }),
    camera: towards,
  };
}
