/** The legs of a path that passes points on the way: each has its own distance from point to point. */

import { placesOf } from './drawn.js';
import { placeOf } from '../state/ends.js';
import { liftNear } from '../state/lifts.js';

/** @typedef {import('surfpath').Path} Path */
/** @typedef {{ segments: number, length: number }} Leg segments: of the path's polyline */

/** @param {Path} path */
const segmentsOf = (path) => placesOf(path).length / 3 - 1;

/** Length from A to each point of a path: its points are equally far from each other, or are on each leg. @param {Path} path @param {readonly Leg[]} legs none: it is of one piece */
export function runsOf(path, legs) {
  const parts = legs.length > 0 ? legs : [{ segments: segmentsOf(path), length: path.length }];
  const runs = [0];
  for (const { segments, length } of parts) {
    const begin = runs[runs.length - 1];
    for (let i = 1; i <= segments; i++) runs.push(begin + (length * i) / segments);
  }
  runs[runs.length - 1] = path.length;
  return runs;
}

/**
 * Each leg is solved once more, from where it runs: the path itself tells the sum of their lengths alone.
 * @param {import('./tasks.js').Opened} opened @param {Path} path @param {number[][]} stops from A to B @param {import('surfpath').PairOptions} options
 * @returns {Leg[]}
 */
export function legsOf({ surface, drawn }, path, stops, options) {
  if (!Number.isFinite(path.length)) return [];
  const places = stops.map((stop) => placeOf(drawn, surface.kind === 'implicit' ? surface.project(stop) : stop) ?? stop);
  const marks = findMarks(placesOf(path), places);
  const legs = marks.slice(1).map((mark, i) => {
    const start = sliceOf(path, marks[i], mark);
    const width = stops[i].length;
    const [from, to] = [stops[i], stops[i + 1]].map((stop, k) =>
      surface.domain ? liftNear(surface.domain, stop, k ? start.subarray(-width) : start) : stop,
    );
    const segments = mark - marks[i];
    const { length } = surface.shortestPath(from, to, { ...options, points: segments - 1, start });
    return { segments, length };
  });
  return legs.every(({ length }) => Number.isFinite(length)) ? legs : [];
}

/** The points of a path between two of them, as a start. @param {Path} path @param {number} first @param {number} last */
const sliceOf = ({ points, parameters }, first, last) =>
  parameters ? parameters.subarray(2 * first, 2 * last + 2) : points.subarray(3 * first, 3 * last + 3);

/** Which points of a path are its stops, in this order: those next to them, with a point between any two at least. @param {Float64Array} points x y z … @param {ArrayLike<number>[]} stops */
function findMarks(points, stops) {
  const last = points.length / 3 - 1;
  const marks = [0];
  for (const [k, stop] of stops.slice(1, -1).entries()) {
    let [mark, least] = [-1, Infinity];
    for (let i = marks[k] + 2; i <= last - 2 * (stops.length - 2 - k); i++) {
      const distance = Math.hypot(...[0, 1, 2].map((axis) => points[3 * i + axis] - stop[axis]));
      if (distance < least) [mark, least] = [i, distance];
    }
    marks.push(mark);
  }
  return [...marks, last];
}
