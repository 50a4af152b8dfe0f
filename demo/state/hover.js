/** The point that is pointed at, in the view, in the plane or along a plot: it is marked in all of them. Kept beside the state: it changes too often for it. */

import { placesOf } from '../compute/drawn.js';
import { runsOf } from '../compute/legs.js';

/**
 * @typedef {object} Hover
 * @property {ArrayLike<number> | null} place in space; null: that of the parameters
 * @property {number[] | null} parameters in the plane; null: it has no place there
 * @property {number | null} run length from A, where it is on the path
 */

/** @type {Hover | null} */ let hover = null;
/** @type {((hover: Hover | null) => void)[]} */ const listeners = [];

/** @param {(hover: Hover | null) => void} listener called when it changes */
export const onHover = (listener) => listeners.push(listener);

/** @param {Hover | null} next null: nothing is pointed at */
export function setHover(next) {
  if (!hover && !next) return;
  hover = next;
  for (const listener of listeners) listener(hover);
}

/**
 * A point of a path at a length from its beginning.
 * @param {import('surfpath').Path} path @param {readonly import('../compute/legs.js').Leg[]} legs of it @param {number} run
 * @returns {Hover}
 */
export function hoverAlong(path, legs, run) {
  const places = placesOf(path);
  const runs = runsOf(path, legs);
  const passed = runs.filter((one) => one <= run).length;
  const first = Math.min(Math.max(passed - 1, 0), runs.length - 2);
  const share = Math.min((run - runs[first]) / (runs[first + 1] - runs[first] || 1), 1);
  const between = (/** @type {Float64Array} */ list, /** @type {number} */ width) =>
    Array.from({ length: width }, (_, k) => {
      const [a, b] = [list[width * first + k], list[width * (first + 1) + k]];
      return a + share * (b - a);
    });
  return { place: between(places, 3), parameters: path.parameters && between(path.parameters, 2), run };
}
