/**
 * Paths whose ends lie where a density or a metric is zero in a point, as a potential is in its well. There a chart tells no direction; but all that is beside such a point is so near to it
 * that any place will do to begin at. MATH.md, "Still ends".
 */

import { holdsPoint } from '../manifold/domain.js';
import { minus } from '../vector.js';
import { begun, domainOf, measure, turnedStart } from './infinite-ends.js';
import { inOrder } from './join.js';

/** @typedef {import('./infinite-ends.js').Infinite} Infinite */
/** @typedef {import('./infinite-ends.js').Leg} Leg */
/** @typedef {import('./routes.js').Field} Field */
/** @typedef {import('../path.js').Path} Path */
/** @typedef {import('../pieces/pieces.js').Start} Start */
/** @typedef {import('../runtime/heap.js').SolveOptions} SolveOptions */

/** A metric is zero in a point where it is this part of what it is around it, on a square of this part of the range, and positive definite there: its determinant is at least this part of the trace's square. */
const [STILL, AROUND, REGULAR] = [1e-10, 1e-3, 1e-6];
/** That is looked at where it is this part of the most that it is at both ends and between them. */
const FAINT = 1e-4;
/** The way to where a path begins is so short, in parts of the tolerance; a path from there that does not converge is begun this much farther away, so often. */
const [SHORT, FARTHER, TRIES] = [0.02, 100, 4];
/** None begins nearer than this part of the way to the other end. */
const NEAREST = 1e-12;

/** E + G and what is left of E G − F² beside its square, of places, in parts of the range. @param {Field} field @param {number[]} places */
function sizesAt(field, places) {
  const { lower, upper } = domainOf(field);
  const [du, dv] = minus(upper, lower);
  return field.forms(places).map((form) => {
    const [e, f, g] = [form[0] * du * du, form[1] * du * dv, form[2] * dv * dv];
    return { size: e + g, isRegular: e * g - f * f > REGULAR * (e + g) ** 2 };
  });
}

/** Whether a metric is zero at a place, and nowhere around it. @param {Field} field @param {number[]} end @param {number} size of it there */
function isStill(field, end, size) {
  const domain = domainOf(field);
  const span = minus(domain.upper, domain.lower);
  const square = [-1, 0, 1].flatMap((i) => [-1, 0, 1].map((k) => (i || k ? [i, k] : [])));
  const places = square.map((by) => by.map((x, j) => end[j] + x * AROUND * span[j]));
  const within = places.filter((place) => holdsPoint(domain, place));
  return sizesAt(field, within.flat()).every((around) => around.isRegular && size <= STILL * around.size);
}

/** Straight from an end to the other one. @param {Field} field @param {number[]} end @param {number[]} other @returns {{ way: Infinite, slope: number }} */
function straight(field, end, other) {
  const { lower, upper, periodic } = domainOf(field);
  const span = minus(upper, lower);
  const parts = end.map((x, j) => (other[j] - x) / span[j]).map((part, j) => (periodic[j] ? part - Math.round(part) : part));
  const across = Number(Math.abs(parts[1]) > Math.abs(parts[0]));
  const [depth, aside] = [across, 1 - across].map((j) => parts[j] * span[j]);
  return { way: { end, across, depth, isEdge: false }, slope: aside / depth };
}

/**
 * The leg from such an end towards the other one, no longer than a part of all of that way on which lengths grow; its error is what the path may miss.
 * @param {Field} field @param {ReturnType<typeof straight>} to @param {number} share @returns {Leg}
 */
function legOf(field, { way, slope }, share) {
  let whole = Infinity;
  for (let part = 1; part > NEAREST; part /= 2) {
    const leg = measure(field, way, part, slope);
    if (whole === Infinity) whole = leg.length;
    if (leg.length <= share * whole && whole < Infinity) return { ...leg, error: 2 * leg.length };
  }
  return { place: way.end, length: 0, error: 0 };
}

/**
 * The path between two ends; null: at none of them the metric is zero in a point.
 * @type {typeof import('./infinite-ends.js').findFromInfinite}
 */
export function findFromStill(field, ends, options, start, solve) {
  if (!field.domain || field.isPlain || String(ends[0]) === String(ends[1])) return null;
  const sizes = sizesAt(field, [...ends.flat(), ...ends[0].map((x, j) => (x + ends[1][j]) / 2)]).map(({ size }) => size);
  const still = ends.filter((end, i) => sizes[i] <= FAINT * Math.max(...sizes) && isStill(field, end, sizes[i]));
  if (still.length === 0) return null;
  return inOrder(field.domain, ends, (both, isTurned) =>
    findForwards(field, both, still, options, isTurned ? turnedStart(start) : start, solve),
  );
}

/**
 * As {@link findFromStill}, in this order. @param {Field} field @param {number[][]} ends @param {number[][]} still which of them are such @param {SolveOptions} options @param {Start} start
 * @param {(field: Field, ends: number[][], options: SolveOptions, start: Start) => Path} solve between others
 */
function findForwards(field, ends, still, options, start, solve) {
  const ways = ends.map((end, i) => (still.includes(end) ? straight(field, end, ends[1 - i]) : null));
  let share = SHORT * options.tolerance;
  for (let tries = 1; ; tries++, share *= FARTHER) {
    const legs = ends.map((end, i) => (ways[i] ? legOf(field, ways[i], share) : { place: end, length: 0, error: 0 }));
    const places = legs.map(({ place }) => place);
    const path = solve(field, places, options, start);
    if (!path.converged && tries < TRIES) continue;
    const left = ways.map((to) => to?.way ?? null);
    const [length, missed] = [path.length + legs[0].length + legs[1].length, legs[0].error + legs[1].error];
    return begun(field, left, { path, legs, length, missed }, options.tolerance);
  }
}
