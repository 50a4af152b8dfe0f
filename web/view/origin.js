/**
 * From where things are drawn. Graphics cards compute with 32 bits, seven digits: of what lies far from the origin of space, as terrain in metres of a map, these
 * leave steps. So it is drawn from an origin beside it, the way from which to the eye three.js computes with 64 bits.
 */

/** @typedef {[number, number, number]} Place */

/** In radii: what is nearer is placed by 32 bits to a hundredth of a pixel. */
const FAR = 100;

/** The box about places: its middle, and half of its diagonal. @param {ArrayLike<number>} places x y z … */
export function boxOf(places) {
  const [low, high] = [Array(3).fill(Infinity), Array(3).fill(-Infinity)];
  for (let i = 0; i < places.length; i++) {
    low[i % 3] = Math.min(low[i % 3], places[i]);
    high[i % 3] = Math.max(high[i % 3], places[i]);
  }
  const center = /** @type {Place} */ (low.map((x, k) => (x + high[k]) / 2));
  return { center, radius: Math.hypot(...low.map((x, k) => (high[k] - x) / 2)) };
}

/** From where places are drawn: the middle of those that are far from the origin of space, else that. @param {ArrayLike<number>} places x y z … @returns {Place} */
export function originOf(places) {
  const { center, radius } = boxOf(places);
  return Math.hypot(...center) > FAR * radius ? center : [0, 0, 0];
}
