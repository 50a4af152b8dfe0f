/** The shortest way from place to place, legs of which are known from below until they are solved: of these as few as possible. Knows nothing of surfaces. */

import { mostOf } from '../path.js';
import { reverse } from './join.js';

/** @typedef {import('../path.js').Path} Path */

/** So many legs are solved at most. */
const MOST_LEGS = 64;

/** What is between each of so many places and each, row by row. @param {number} count @param {(i: number, j: number) => number} between */
export const tableOf = (count, between) => Float64Array.from({ length: count ** 2 }, (_, k) => between(Math.floor(k / count), k % count));

/**
 * The shortest way from one place to another. @param {number} count of places @param {Float64Array} lengths of each to each @param {number} [from] @param {number} [to]
 * @returns {{ way: number[], length: number }} places, none: there is no way
 */
export function shortestWay(count, lengths, from = 0, to = 1) {
  const far = Array.from({ length: count }, (_, i) => (i === from ? 0 : Infinity));
  const before = Array(count).fill(-1);
  const open = new Set(far.keys());
  while (open.has(to)) {
    const here = [...open].reduce((best, i) => (far[i] < far[best] ? i : best));
    open.delete(here);
    for (const i of open) {
      const through = far[here] + lengths[count * here + i];
      if (through < far[i]) [far[i], before[i]] = [through, here];
    }
  }
  const way = [to];
  for (let i = before[to]; i >= 0; i = before[i]) way.unshift(i);
  return { way: way.length > 1 ? way : [], length: far[to] };
}

/**
 * The shortest way from place 0 to place 1.
 * @param {number} count of places @param {(i: number, j: number) => number} bound at least as long is a leg, infinite where there is none
 * @param {(i: number, j: number) => Path} solve a leg from a place to one of a larger number: it counts as long as it is at most, whatever its status
 * @param {number} [most] what is longer is of no interest
 * @returns {{ way: number[], length: number, legsOf: (way: number[]) => (Path | undefined)[], solvedWay: (i: number, j: number) => number[],
 *   least: (isOpen: (i: number, j: number) => boolean) => number }} way: none where there is none; legsOf: from each place of a way to the next, as far as they were solved;
 *   solvedWay: the shortest between two places of legs that were; least: the length of the shortest way if those that came to nothing, and may be legs all the same, count as long as they are at least
 */
export function findChain(count, bound, solve, most = Infinity) {
  const bounds = tableOf(count, bound);
  const lengths = Float64Array.from(bounds);
  /** @type {(Path | undefined)[]} */
  const solved = [];
  const legFrom = (/** @type {number} */ i, /** @type {number} */ j) => {
    const path = solved[count * Math.min(i, j) + Math.max(i, j)];
    return path && i > j ? reverse(path) : path;
  };
  let { way, length } = shortestWay(count, lengths);
  for (let legs = 0; legs < MOST_LEGS && length <= most; legs++) {
    const k = way.findIndex((_, at) => at > 0 && !legFrom(way[at - 1], way[at]));
    if (k < 0) break;
    const [i, j] = [way[k - 1], way[k]].sort((a, b) => a - b);
    const leg = solve(i, j);
    solved[count * i + j] = leg;
    lengths[count * i + j] = lengths[count * j + i] = mostOf(leg);
    ({ way, length } = shortestWay(count, lengths));
  }
  return {
    way,
    length,
    legsOf: (path) => path.slice(1).map((place, k) => legFrom(path[k], place)),
    solvedWay: (from, to) =>
      shortestWay(
        count,
        tableOf(count, (i, j) => (legFrom(i, j) ? lengths[count * i + j] : Infinity)),
        from,
        to,
      ).way,
    least: (isOpen) =>
      shortestWay(
        count,
        tableOf(count, (i, j) => {
          const [known, least] = [lengths, bounds].map((table) => table[count * i + j]);
          return legFrom(i, j) && known === Infinity && least > 0 && isOpen(i, j) ? least : known;
        }),
      ).length,
  };
}
