/** Places u v moved by whole turns: to others that are the same point of a surface that closes, straight, turned over or shifted. */

/** @typedef {NonNullable<import('surfpath').Surface['domain']>} Domain */

const AXES = /** @type {const} */ (['u', 'v']);

/** How far it is around in a direction; 0 where it does not close. @param {Domain} domain @param {number} k 0: u, 1: v */
const turnOf = (domain, k) => (domain.periodic[AXES[k]] ? domain[AXES[k]][1] - domain[AXES[k]][0] : 0);

/** The same point, so many turns on in a direction. @param {Domain} domain @param {ArrayLike<number>} point @param {number} k @param {number} turns @returns {number[]} */
export function turnOn(domain, point, k, turns) {
  const { turn } = domain;
  const moved = [point[0], point[1]];
  moved[k] += turns * turnOf(domain, k);
  if (turn?.along !== AXES[k]) return moved;
  const other = 1 - k;
  if (turn.sign > 0) moved[other] -= turns * turn.offset;
  else if (turns % 2 !== 0) moved[other] = turn.offset - moved[other];
  return moved;
}

/** The directions in the order in which a place is moved: what one turn does to the other coordinate comes first. @param {Domain} domain */
const order = ({ turn }) => (turn?.along === 'v' ? [1, 0] : [0, 1]);

/** Moves a place in each direction by as many turns as this says of it. @param {Domain} domain @param {ArrayLike<number>} point @param {(x: number, turn: number, k: number) => number} count */
function move(domain, point, count) {
  return order(domain).reduce(
    (place, k) => {
      const turn = turnOf(domain, k);
      return turn > 0 ? turnOn(domain, place, k, count(place[k], turn, k)) : place;
    },
    [point[0], point[1]],
  );
}

/** A place moved as near as may be to another. @param {Domain} domain @param {ArrayLike<number>} point @param {ArrayLike<number>} near */
export const liftNear = (domain, point, near) => move(domain, point, (x, turn, k) => Math.round((near[k] - x) / turn));

/** A place moved into the rectangle. @param {Domain} domain @param {ArrayLike<number>} point */
export const inside = (domain, point) => move(domain, point, (x, turn, k) => -Math.floor((x - domain[AXES[k]][0]) / turn));

/**
 * A curve moved by as many turns as it takes until each part of it has lain in the rectangle once; of very long ones the first parts.
 * @param {Domain} domain @param {ArrayLike<number>} parameters u v of its points @returns {number[][][]}
 */
export function unrollings(domain, parameters) {
  const points = Array.from({ length: parameters.length / 2 }, (_, i) => [parameters[2 * i], parameters[2 * i + 1]]);
  return order(domain).reduce(
    (curves, k) =>
      curves.flatMap((curve) => {
        const turn = turnOf(domain, k);
        if (!(turn > 0)) return [curve];
        const counts = curve.map((point) => Math.floor((point[k] - domain[AXES[k]][0]) / turn));
        const [first, last] = [Math.min(...counts), Math.max(...counts)];
        return Array.from({ length: Math.min(last - first, 8) + 1 }, (_, i) =>
          curve.map((point) => turnOn(domain, point, k, -(first + i))),
        );
      }),
    [points],
  );
}
