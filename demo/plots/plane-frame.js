/** Where places of the parameter rectangle lie in its picture, and back. */

/** @typedef {[number, number]} Point */
/** @typedef {{ domain: import('../state/lifts.js').Domain, low: Point, high: Point, periodic: boolean[], size: Point, to: (point: ArrayLike<number>) => Point, from: (place: Point) => number[] }} Frame */

export const WIDTH = 320;
/** Room for the numbers, in units of the picture: left, right, top, bottom. */
export const MARGIN = { left: 38, right: 10, top: 10, bottom: 28 };
const [LEAST_HEIGHT, MOST_HEIGHT] = [150, 300];

/** @param {NonNullable<import('surfpath').Surface['domain']>} domain @returns {Frame} */
export function frameOf(domain) {
  const { u, v, periodic } = domain;
  const wide = WIDTH - MARGIN.left - MARGIN.right;
  const high = Math.min(Math.max((wide * (v[1] - v[0])) / (u[1] - u[0]), LEAST_HEIGHT), MOST_HEIGHT);
  const scale = [wide / (u[1] - u[0]), high / (v[1] - v[0])];
  return {
    domain,
    low: [u[0], v[0]],
    high: [u[1], v[1]],
    periodic: [periodic.u, periodic.v],
    size: [wide, high],
    to: (point) => [MARGIN.left + (point[0] - u[0]) * scale[0], MARGIN.top + (v[1] - point[1]) * scale[1]],
    from: ([x, y]) => [u[0] + (x - MARGIN.left) / scale[0], v[1] - (y - MARGIN.top) / scale[1]],
  };
}
