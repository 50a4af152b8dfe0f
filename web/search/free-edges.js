/** Whether a path can be the shortest, where a density or a metric makes ways along an edge of the rectangle free: straight to the edge, along it and back may be shorter. */

import { edgeOf } from '../manifold/rectangle.js';
import { STALLED } from '../runtime/status.js';
import { holds } from './candidates.js';

/** Midpoints over the way to an edge, closer to both of its ends, where the speed may be a root; twice as many tell their error. */
const PARTS = 64;

/**
 * The path; where a way over such an edge is shorter, all that is known of the shortest is that: `stalled`, with as much for an error.
 * @param {import('./candidates.js').Problem} problem @param {import('./candidates.js').SolveOptions} options @param {import('./candidates.js').RawPath} path
 * @returns {import('./candidates.js').RawPath}
 */
export function challengeByEdges(problem, { tolerance }, path) {
  if (!problem.domain || !holds({ path })) return path;
  const { length, lengthError } = path;
  const over = Math.min(...problem.domain.free.map((edge) => lengthOver(problem, edge)).filter(Number.isFinite));
  return length * (1 - tolerance) - lengthError > over ? { ...path, status: STALLED, lengthError: lengthError + length - over } : path;
}

/** What the way over an edge is long, at most. @param {import('./candidates.js').Problem} problem @param {number} edge */
function lengthOver({ from, to, domain, forms }, edge) {
  const { lower, upper } = /** @type {import('../manifold/domain.js').Domain} */ (domain);
  const { across, along, side } = edgeOf(edge);
  const at = (side ? upper : lower)[across];
  /** @param {number[]} end @param {number} parts */
  const measure = (end, parts) => {
    const middles = Array.from({ length: parts }, (_, i) => (i + 0.5) / parts);
    const places = middles.flatMap((t) => {
      const place = [...end];
      place[across] += (at - end[across]) * t * t * t * t * (35 - t * (84 - t * (70 - 20 * t)));
      return place;
    });
    return forms(places).reduce((sum, form, i) => {
      const both = middles[i] * (1 - middles[i]);
      return sum + (140 * both * both * both * Math.sqrt(form[2 * across]) * Math.abs(at - end[across])) / parts;
    }, 0);
  };
  const onEdge = [from, to].map((end) => end.map((x, j) => (j === across ? at : x)));
  const free = Math.abs(to[along] - from[along]) * Math.sqrt(Math.max(...forms(onEdge.flat()).map((form) => form[2 * along])));
  return [from, to].reduce((sum, end) => {
    const [rough, fine] = [measure(end, PARTS), measure(end, 2 * PARTS)];
    return sum + fine + Math.abs(fine - rough);
  }, free);
}
