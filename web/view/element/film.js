/** What is played of a path: Newton's iterates on a polyline, from the straight line to it. */

/** @typedef {import('../../path.js').Path} Path */

/** Distance at which two curves are no longer the same, in parts of their length. */
const APART = 0.02;

/**
 * The path with the iterates that lead to it; where those from the straight line lead elsewhere, the path alone.
 * @param {import('../../surface.js').Surface} surface @param {number[][]} ends @param {Path} path
 * @returns {Path}
 */
export function filmOf(surface, [from, to], path) {
  const points = path.points.length / 3 - 2;
  if (points < 1) return path;
  const film = surface.shortestPath(from, to, { algorithm: 'polyline', start: 'straight', record: true, points });
  return isNear(film.points, path.points, APART * path.length) ? { ...path, history: film.history } : path;
}

/** @param {Float64Array} a @param {Float64Array} b @param {number} limit */
function isNear(a, b, limit) {
  if (a.length !== b.length) return false;
  for (let i = 0; i < a.length; i += 3) if (Math.hypot(a[i] - b[i], a[i + 1] - b[i + 1], a[i + 2] - b[i + 2]) > limit) return false;
  return true;
}
