/** A sketch: everything that the reader has chosen, as plain data. It is what undo, a link and a saved file hold; all else is computed from it. */

import { definitionOf, fieldNames, textsOf } from './definition.js';
import { ENTRIES } from './entries.js';
import { KINDS, tensorNames } from './kinds.js';
import { isName, NAMES } from './names.js';

/** @typedef {import('./kinds.js').Kind} Kind */
/** @typedef {import('./definition.js').Texts} Texts */
/**
 * @typedef {object} Sketch
 * @property {string} entry name of what it began with
 * @property {Kind} kind
 * @property {Texts} texts of the formula fields
 * @property {Record<string, number>} parameters
 * @property {string} density ρ, or ''
 * @property {string[]} tensor E, F, G, or, of an implicit surface, xx … zz, in place of the metric of space; or none
 * @property {number[][]} ends
 * @property {number[][]} via
 * @property {'path' | 'all' | 'trace'} task
 * @property {number} angle of a traced geodesic, degrees from the direction of u towards the normal's left
 * @property {number} reach length of a traced geodesic
 * @property {'elements' | 'polyline' | 'paper'} algorithm
 * @property {number} tolerance
 * @property {number} points
 * @property {'global' | 'straight' | 'several'} start
 * @property {number} chosen which of all geodesics is looked at
 * @property {'plain' | 'curvature' | 'distance' | 'density'} colour
 */

/** The choices of each field that has few. @type {Record<string, readonly string[]>} */
const CHOICES = {
  task: ['path', 'all', 'trace'],
  algorithm: ['elements', 'polyline', 'paper'],
  start: ['global', 'straight', 'several'],
  colour: ['plain', 'curvature', 'distance', 'density'],
};
/** Least and most of each number. @type {Record<string, [number, number]>} */
const NUMBERS = { angle: [-3600, 3600], reach: [0, 1e12], tolerance: [1e-15, 0.1], points: [1, 2000], chosen: [0, 100] };
export const MOST_VIA = 8;
/** More sliders than anyone makes by hand. */
const MOST_PARAMETERS = 1000;
/** Characters: no formula that can be read has more. */
const LONGEST_NAME = 4096;
const WHOLE = /** @type {const} */ (['points', 'chosen']);
export const MOST_POINTS = NUMBERS.points[1];

/** @param {string} name of an entry @returns {Sketch} */
export function sketchOf(name) {
  const entry = ENTRIES[name];
  return {
    entry: name,
    kind: entry.kind,
    texts: textsOf(entry),
    parameters: { ...entry.parameters },
    density: entry.density ?? '',
    tensor: Object.values(entry.metric ?? {}),
    ends: [[...entry.from], [...entry.to]],
    via: [],
    task: 'path',
    angle: 30,
    reach: 6,
    algorithm: 'elements',
    tolerance: 1e-9,
    points: 64,
    start: 'global',
    chosen: 0,
    colour: entry.density || entry.kind === 'metric' ? 'density' : 'plain',
  };
}

/** The definition of the sketch's surface, as the library takes it. @param {Sketch} sketch */
export function surfaceOf({ kind, texts, parameters, density, tensor }) {
  const definition = /** @type {Record<string, any>} */ (definitionOf(kind, texts, parameters));
  if (density.trim() && kind !== 'metric') definition.density = density;
  if (tensor.length > 0) definition.metric = Object.fromEntries(tensorNames(kind).map((name, i) => [name, tensor[i]]));
  return definition;
}

/** The points that a path is asked for with: A, then, but for straight ahead, B and those on the way. @param {Sketch} sketch */
export const pointsOf = ({ ends, via, task }) => (task === 'trace' ? ends.slice(0, 1) : [...ends, ...via]);

/** The names that stand in the formulas of a sketch. @param {Sketch} sketch @returns {Set<string>} */
export const namesIn = ({ texts, density, tensor }) =>
  new Set([...Object.values(texts), density, ...tensor].flatMap((text) => text.match(NAMES) ?? []));

/** @param {unknown} value @param {number} dimension @returns {value is number[]} */
const isPoint = (value, dimension) => Array.isArray(value) && value.length === dimension && value.every((x) => Number.isFinite(x));

/** Of any length: what is too long to be read is the writer's to shorten. @param {unknown} value @returns {value is string} */
const isFormula = (value) => typeof value === 'string';

/**
 * A sketch from what a stranger wrote: what is wrong with it is left as the entry has it.
 * @param {any} given parsed JSON
 * @returns {Sketch | null} null: there is nothing to begin with
 */
export function readSketch(given) {
  if (typeof given !== 'object' || given === null) return null;
  if (typeof given.entry !== 'string' || !Object.hasOwn(ENTRIES, given.entry)) return null;
  const sketch = sketchOf(given.entry);
  if (typeof given.kind === 'string' && Object.hasOwn(KINDS, given.kind) && given.kind !== sketch.kind)
    Object.assign(sketch, sketchOf(`own-${given.kind}`), { entry: `own-${given.kind}` });
  for (const name of fieldNames(sketch.kind)) if (isFormula(given.texts?.[name])) sketch.texts[name] = given.texts[name];
  readParameters(sketch, given.parameters);
  const dimension = KINDS[sketch.kind].coordinates.length;
  for (const end of [0, 1]) if (isPoint(given.ends?.[end], dimension)) sketch.ends[end] = given.ends[end];
  if (Array.isArray(given.via))
    sketch.via = given.via.slice(0, MOST_VIA).filter((/** @type {unknown} */ point) => isPoint(point, dimension));
  readMeasure(sketch, given);
  const target = /** @type {Record<string, any>} */ (sketch);
  for (const [name, choices] of Object.entries(CHOICES)) if (choices.includes(given[name])) target[name] = given[name];
  for (const [name, [least, most]] of Object.entries(NUMBERS))
    if (Number.isFinite(given[name]) && given[name] >= least && given[name] <= most) target[name] = given[name];
  // Of these there are several only from end to end.
  if (sketch.via.length > 0 && sketch.start === 'several') sketch.start = 'straight';
  for (const name of WHOLE) sketch[name] = Math.round(sketch[name]);
  return sketch;
}

/** All of them are given: one of the entry's that is missing was taken away. @param {Sketch} sketch @param {any} given */
function readParameters(sketch, given) {
  if (typeof given !== 'object' || given === null) return;
  for (const name of Object.keys(sketch.parameters)) if (!(name in given)) delete sketch.parameters[name];
  for (const [name, value] of Object.entries(given).slice(0, MOST_PARAMETERS))
    if (isName(name) && name.length <= LONGEST_NAME && Number.isFinite(value)) sketch.parameters[name] = /** @type {number} */ (value);
}

/** @param {Sketch} sketch @param {any} given */
function readMeasure(sketch, { density, tensor }) {
  if (isFormula(density)) sketch.density = density;
  const lengths = sketch.kind === 'metric' ? [0] : [0, tensorNames(sketch.kind).length];
  if (Array.isArray(tensor) && lengths.includes(tensor.length) && tensor.every(isFormula)) sketch.tensor = tensor;
}
