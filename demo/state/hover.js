/** The point that is pointed at, in the view, in the plane or along a plot: it is marked in all of them. Kept beside the state: it changes too often for it. */

import { placesOf } from '../compute/drawn.js';

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
 * A point of a path at a length from its beginning; its points are equally far from each other.
 * @param {import('surfpath').Path} path @param {number} run
 * @returns {Hover}
 */
export function hoverAlong(path, run) {
  const places = placesOf(path);
  const count = places.length / 3;
  const at = Math.min(Math.max(run / path.length, 0), 1) * (count - 1);
  const first = Math.min(Math.floor(at), count - 2);
  const between = (/** @type {Float64Array} */ list, /** @type {number} */ width) =>
    Array.from({ length: width }, (_, k) => {
      const [a, b] = [list[width * first + k], list[width * (first + 1) + k]];
      return a + (at - first) * (b - a);
    });
  return { place: between(places, 3), parameters: path.parameters && between(path.parameters, 2), run };
}
