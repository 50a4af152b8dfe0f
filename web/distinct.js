/** Which of several paths between the same ends are the same one, judged by their lengths and where they run. */

/** @typedef {import('./runtime/heap.js').RawPath} RawPath */

/** Two paths are the same where they are nowhere farther apart, in parts of how long they are in space, or in u and v. */
const APART = 0.01;
/** Places at which two paths are compared. */
const SAMPLES = 16;

/** The length of the geodesic under a rough polyline, to fourth order. @param {RawPath} path */
export const estimate = (path) => path.length + path.lengthError;

/** Sorted by length, each path once. @template {{ path: RawPath }} T @param {T[]} found @returns {T[]} */
export function distinct(found) {
  const sorted = [...found].sort((a, b) => estimate(a.path) - estimate(b.path));
  return sorted.filter(({ path }, i) => !sorted.slice(0, i).some((other) => isSame(other.path, path)));
}

/** @param {RawPath} a @param {RawPath} b */
export function isSame(a, b) {
  if (Math.abs(estimate(a) - estimate(b)) > APART * estimate(a)) return false;
  const [p, q] = [samplesOf(a), samplesOf(b)];
  let [away, size] = [0, 0];
  for (let i = 0; i < SAMPLES; i++) {
    away = Math.max(away, distance(p, i, q, i));
    size += distance(p, i, p, i + 1);
  }
  return away <= APART * size;
}

/** Whether a path is one of these. @param {{ path: RawPath }[]} list @param {{ path: RawPath }} found */
export const isAmong = (list, { path }) => list.some((other) => isSame(other.path, path));

/**
 * Places along a path of equal chords, three numbers each: points, or u v 0 where it has no positions.
 * @param {RawPath} path @returns {Float64Array}
 */
function samplesOf({ points, parameters }) {
  const [numbers, width] = points.length > 0 || !parameters ? [points, 3] : [parameters, 2];
  const samples = new Float64Array(3 * (SAMPLES + 1));
  const last = numbers.length / width - 1;
  for (let i = 0; i <= SAMPLES; i++) {
    const at = (i / SAMPLES) * last;
    const before = Math.min(Math.floor(at), last - 1);
    for (let k = 0; k < width; k++) {
      const [from, to] = [numbers[width * before + k], numbers[width * (before + 1) + k]];
      samples[3 * i + k] = from + (at - before) * (to - from);
    }
  }
  return samples;
}

/** Between sample i of p and sample j of q. @param {Float64Array} p @param {number} i @param {Float64Array} q @param {number} j */
function distance(p, i, q, j) {
  const [x, y, z] = [p[3 * i] - q[3 * j], p[3 * i + 1] - q[3 * j + 1], p[3 * i + 2] - q[3 * j + 2]];
  return Math.sqrt(x * x + y * y + z * z);
}
