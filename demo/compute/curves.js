/** Polylines as flat arrays x y z …: their length, a smooth curve through them for drawing, and what lies between two of them. */

/** Chords of which a curve is drawn, about: in one that turns once each is bent by 2 degrees. */
const DRAWN = 200;
/** Distance at which two curves are no longer the same, in parts of their length. */
const APART = 0.02;

/** @param {ArrayLike<number>} points */
export function lengthOf(points) {
  let sum = 0;
  for (let i = 3; i < points.length; i += 3)
    sum += Math.hypot(points[i] - points[i - 3], points[i + 1] - points[i - 2], points[i + 2] - points[i - 1]);
  return sum;
}

/** With fewer points no piece of a path stands out. */
const ENOUGH = 16;

/**
 * Whether a piece of a path that is much longer than the others leaps over what is no surface: it came to no rest, and has many points, evenly apart in space.
 * @param {import('surfpath').Path} path @param {Pick<import('../state/sketch.js').Sketch, 'density' | 'tensor'>} sketch
 */
export const mayLeap = ({ converged, points }, { density, tensor }) =>
  !converged && points.length > 3 * ENOUGH && !density.trim() && tensor.length === 0;

/** How much longer than half of its pieces one must be that leaps over a gap. */
const LEAP = 4;

/** A polyline without the pieces that leap: no surface lies below them. @param {Float64Array} points @returns {Float64Array[]} one, where none does */
export function unbroken(points) {
  const chords = Array.from({ length: points.length / 3 - 1 }, (_, i) => lengthOf(points.subarray(3 * i, 3 * i + 6)));
  const limit = LEAP * [...chords].sort((a, b) => a - b)[chords.length >> 1];
  const cuts = chords.flatMap((chord, i) => (chord > limit ? [i + 1] : []));
  return [0, ...cuts].map((cut, i) => points.subarray(3 * cut, 3 * (cuts[i] ?? chords.length + 1)));
}

/** A coordinate of point i; before the first and after the last, the parabola through the three next to it. @param {Float64Array} points @param {number} i @param {number} k */
function coordinate(points, i, k) {
  const last = points.length / 3 - 1;
  const at = (/** @type {number} */ j) => points[3 * Math.min(Math.max(j, 0), last) + k];
  if (i < 0) return last < 2 ? 2 * at(0) - at(1) : 3 * at(0) - 3 * at(1) + at(2);
  if (i > last) return last < 2 ? 2 * at(last) - at(last - 1) : 3 * at(last) - 3 * at(last - 1) + at(last - 2);
  return at(i);
}

/** Square root of the chord from point i to the next: the knots of a centripetal curve, which neither loops nor overshoots. @param {Float64Array} points @param {number} i */
function knot(points, i) {
  const chord = [0, 1, 2].map((k) => coordinate(points, i + 1, k) - coordinate(points, i, k));
  return Math.max(Math.sqrt(Math.hypot(...chord)), 1e-9);
}

/**
 * The curve that is drawn for a polyline: chords cut the corners of the surface they stand for, a smooth curve through the same points (centripetal
 * Catmull–Rom) does not.
 * @param {Float64Array} points
 * @returns {Float64Array} more points, the given ones among them
 */
export function smooth(points) {
  const pieces = points.length / 3 - 1;
  const cuts = Math.max(1, Math.min(16, Math.ceil(DRAWN / pieces)));
  const result = new Float64Array(3 * (pieces * cuts + 1));
  for (let i = 0; i < pieces; i++) {
    const [before, here, after] = [knot(points, i - 1), knot(points, i), knot(points, i + 1)];
    for (let k = 0; k < 3; k++) {
      const [a, b, c, d] = [-1, 0, 1, 2].map((offset) => coordinate(points, i + offset, k));
      const leaving = here * ((b - a) / before - (c - a) / (before + here) + (c - b) / here);
      const arriving = here * ((c - b) / here - (d - b) / (here + after) + (d - c) / after);
      for (let j = 0; j < cuts; j++) result[3 * (i * cuts + j) + k] = hermite(b, c, leaving, arriving, j / cuts);
    }
  }
  result.set(points.subarray(-3), result.length - 3);
  return result;
}

/** The cubic from b to c with these derivatives there. @param {number} b @param {number} c @param {number} leaving @param {number} arriving @param {number} t in [0, 1] */
function hermite(b, c, leaving, arriving, t) {
  const [square, cube] = [t * t, t * t * t];
  return b + (3 * square - 2 * cube) * (c - b) + (cube - 2 * square + t) * leaving + (cube - square) * arriving;
}

/** @param {Float64Array} a @param {Float64Array} b as long @param {number} t */
export const blend = (a, b, t) => a.map((x, i) => x + t * (b[i] - x));

/** Whether two polylines with as many points are the same curve, but for how exact they are. @param {Float64Array} a @param {Float64Array} b */
export function isNear(a, b) {
  if (a.length !== b.length) return false;
  const limit = APART * lengthOf(b);
  for (let i = 0; i < a.length; i += 3) if (Math.hypot(a[i] - b[i], a[i + 1] - b[i + 1], a[i + 2] - b[i + 2]) > limit) return false;
  return true;
}
