/** What the drawing modules ask of their arguments, and say when they do not get it. */

import { checkOptions, refuse, refuseNumber } from '../arguments.js';

/** @typedef {import('../surface.js').Surface} Surface */

/** Refuses what has no place in space. @param {string} caller @param {unknown} surface */
export function checkDrawable(caller, surface) {
  const { kind, evaluate } = /** @type {{ kind?: unknown, evaluate?: unknown }} */ (surface ?? {});
  if (kind === 'metric')
    throw new TypeError(`${caller}: a surface given by E, F and G has no positions in space; draw its paths in the parameter plane`);
  // A definition has a kind, too.
  if (typeof evaluate !== 'function') refuse(`${caller}: surface`, 'a Surface that surfpath made', surface);
}

/** Refuses what is no geometry of a surface. @param {string} caller @param {unknown} geometry */
export function checkGeometry(caller, geometry) {
  const { attributes } = /** @type {{ attributes?: { position?: unknown } }} */ (geometry ?? {});
  if (!attributes?.position) refuse(`${caller}: geometry`, 'one that surfaceGeometry made', geometry);
}

/**
 * Refuses a place outside a rectangle, but for rounding, as the library does.
 * @param {string} name of the place @param {import('../surface.js').ParameterDomain} domain @param {number[]} place u v
 */
export function checkInside(name, domain, place) {
  if (place.length !== 2) refuse(name, 'two numbers, u v', place);
  for (const [key, x] of /** @type {const} */ ([
    ['u', place[0]],
    ['v', place[1]],
  ])) {
    const [low, high] = domain[key];
    if (!domain.periodic[key] && Math.max(low - x, x - high) > 1e-12 * (high - low))
      throw new RangeError(`${name}: ${key} = ${x} lies outside its range, [${low}, ${high}]`);
  }
}

/**
 * The points of a path, or of a flat list x y z …; null for a path that was not found.
 * @param {string} caller @param {unknown} given
 * @returns {ArrayLike<number> | null}
 */
export function readPoints(caller, given) {
  if (given === null) return null;
  const { points = given, length } = /** @type {any} */ (given ?? {});
  if (typeof points !== 'object' || typeof points.length !== 'number')
    refuse(`${caller}: path`, 'a Path, a flat array of x y z, or null', given);
  if (points !== given && points.length === 0) {
    if (Number.isNaN(length)) return null;
    throw new TypeError(`${caller}: the path has no points: a metric without positions has none; draw its parameters in the plane`);
  }
  if (points.length < 6 || points.length % 3) throw new RangeError(`${caller}: path must hold x y z of two points or more`);
  if (!Array.prototype.every.call(points, Number.isFinite)) throw new RangeError(`${caller}: path must hold finite numbers`);
  return points;
}

/**
 * Sets those of some colours that are named; what is not named stays.
 * @param {Record<string, import('three').Color>} colours @param {Record<string, import('three').ColorRepresentation | undefined>} named
 */
export function setColours(colours, named) {
  checkOptions('setColours', named, Object.keys(colours));
  for (const name in colours) colours[name].set(named?.[name] ?? colours[name]);
}

/** @param {string} caller function, and what these belong to @param {Record<string, number>} sizes */
export function checkPixels(caller, sizes) {
  for (const [name, pixels] of Object.entries(sizes))
    if (!(Number.isFinite(pixels) && pixels >= 0)) refuseNumber(caller + name, 'a number of pixels, 0 or more', pixels);
}
