/** The reference direction of a frame along a curve: one that is nowhere along the curve, found by looking at many of its tangents.
 *
 * For all but wild curves some fixed direction does, mostly an axis. It depends on the formulas and parameters alone, and, as Math.sin and its like
 * have no part in it, is the same in every engine. */

import { compile } from '../expression/compile.js';
import { cross, dot, listOf, unit } from '../vector.js';

/** @typedef {import('../definition.js').Expression} Expression */
/** @typedef {import('../runtime/solver.js').Solver} Solver */
/** @typedef {{ name: string, sources: readonly Expression[], reference: readonly Expression[] }} Curve x, y, z over t; `reference` is empty where one is to be found */

/** How many equal steps of the curve are looked at. */
const STEPS = 512;
/** The least sine of the angle between reference and curve: for the first direction that keeps it, and for any reference at all. */
const GOOD = 0.3;
const LEAST = 0.03;

const COMPONENTS = [0, 1, -1, 2, -2, 3, -3];
/** Directions that are tried: the axes, then half of those with small whole components, so that every engine chooses the same bits. */
const DIRECTIONS = Object.freeze(
  [[0, 0, 1], [0, 1, 0], [1, 0, 0], ...COMPONENTS.flatMap((x) => COMPONENTS.flatMap((y) => [1, 2, 3, 0].map((z) => [x, y, z])))].map(unit),
);

/** Names of components, for error messages. @param {string} name */
export const componentsOf = (name) => [0, 1, 2].map((i) => `${name}[${i}]`);

/** Looks at one curve for as many values of its parameters as there will be. */
export class ReferenceFinder {
  #caller;
  #curve;
  #solver;
  #compiled;

  /** @param {string} caller @param {Curve} curve @param {Solver} solver @param {Record<string, number>} parameters */
  constructor(caller, curve, solver, parameters) {
    this.#caller = caller;
    this.#curve = curve;
    this.#solver = solver;
    this.#compiled = compile({
      outputs: [...curve.sources, ...curve.reference],
      names: [curve.name, 'reference'].flatMap(componentsOf),
      variables: ['t'],
      parameters,
      valueOrder: 1,
      apply: solver.apply,
    });
  }

  /**
   * The direction for these parameters; the same object where it is the same direction.
   * @param {Record<string, number>} parameters
   * @param {number[]} range of t
   * @returns {number[] | null} null where the curve's definition gives it
   * @throws {RangeError} where there is no frame
   */
  find(parameters, [low, high]) {
    const places = Array.from({ length: STEPS + 1 }, (_, i) => low + (i / STEPS) * (high - low));
    const { name } = this.#curve;
    const [tangents, references] = this.#sample(parameters, places);
    const kink = findKink(tangents);
    if (kink >= 0) this.#fail(`${name} stands still or turns back near t = ${places[kink]}; end the range of t there, or let it move on`);
    if (references && !isReference(tangents, references))
      this.#fail(`reference is zero or along ${name} somewhere; give a direction that points away from it everywhere`);
    if (references) return null;
    const found = findReference(tangents);
    return found ?? this.#fail(`${name} runs in too many directions for one frame; give reference: [x, y, z], over t, nowhere along it`);
  }

  /** Derivatives of the curve and, if it is given, the reference. @param {Record<string, number>} parameters @param {number[]} places @returns {number[][][]} */
  #sample(parameters, places) {
    const { data, value } = this.#compiled;
    data.set(Object.values(parameters));
    const slots = this.#solver.install(this.#compiled);
    try {
      const sampled = this.#solver.evaluate(slots.call.value, places, 1, value.length);
      const vectors = (/** @type {number} */ offset) =>
        places.map((_, i) => listOf(sampled, value.length * i + offset, value.length * i + offset + 3));
      return this.#curve.reference.length > 0 ? [vectors(6), vectors(3)] : [vectors(3)];
    } finally {
      this.#solver.remove(slots);
    }
  }

  /** @param {string} message @returns {never} */
  #fail(message) {
    throw new RangeError(`${this.#caller}: ${message}`);
  }
}

/**
 * A direction that is nowhere along a curve.
 * @param {number[][]} tangents derivatives of the curve at equal steps
 * @returns {number[] | null} null if there is none
 */
function findReference(tangents) {
  const directions = tangents.map(unit);
  let [best, most] = [DIRECTIONS[0], 0];
  for (const reference of DIRECTIONS) {
    const least = clearance(directions, () => reference);
    if (least > most) [best, most] = [reference, least];
    if (most >= GOOD) break;
  }
  return most >= LEAST ? best : null;
}

/**
 * Whether a given reference is nowhere along the curve.
 * @param {number[][]} tangents @param {number[][]} references at the same places
 */
function isReference(tangents, references) {
  const units = references.map(unit);
  return clearance(tangents.map(unit), (i) => units[i]) >= LEAST;
}

/** The least sine of the angle between curve and reference; 0 where a frame turns by a right angle or more in a step. @param {number[][]} directions @param {(i: number) => number[]} reference */
function clearance(directions, reference) {
  const across = directions.map((direction, i) => cross(reference(i), direction));
  const isSmooth = across.every((one, i) => i === 0 || dot(one, across[i - 1]) > 0);
  return isSmooth ? Math.sqrt(Math.min(...across.map((one) => dot(one, one)))) : 0;
}

/**
 * The first step at which a curve has no direction, or turns by a right angle or more.
 * @param {number[][]} tangents
 * @returns {number} -1 if there is none
 */
function findKink(tangents) {
  return tangents.findIndex((tangent, i) => {
    const product = dot(tangent, tangents[Math.max(i - 1, 0)]);
    return !(product > 0 && product < Infinity);
  });
}
