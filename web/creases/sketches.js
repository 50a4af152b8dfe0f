/** Polylines that tell which way paths lead across creases: ways through a graph, relaxed where creases are rounded, and measured as the surface is. MATH.md, "Which way". */

import { isGeodesic } from '../path.js';
import { distinct } from '../search/distinct.js';
import { measureLine, relax } from '../search/routes.js';
import { dot, gap } from '../vector.js';
import { slopeOf } from './crease.js';
import { span } from './legs.js';

/** @typedef {import('../search/routes.js').Field} Field */
/** @typedef {import('../manifold/sides.js').Sides} Sides */
/** @typedef {{ line: Float64Array, length: number, isAtRest: boolean }} Sketch a polyline, u v or x y z; how long it is: measured in the rectangle, else as it was relaxed; whether that came to rest */
/** @typedef {{ within: number, points: number, dearer: number, shores: number[] }} Rounding */

/** Inner points of most polylines. */
export const SKETCH_POINTS = 63;
/**
 * Creases are rounded within these parts of the length; polylines there have so many inner points, and may be longer by that part: a road that is narrow is dearer there. The first come
 * to rest more often, the second stay in what is narrow. They follow creases that are nearer to them than these parts of their length, tried in turn; 0: they follow none.
 * @type {Rounding[]}
 */
const ROUNDINGS = [
  { within: 0.01, points: SKETCH_POINTS, dearer: 0.15, shores: [0.04, 0.01, 0] },
  { within: 0.0025, points: 255, dearer: 0.04, shores: [0.01, 0.04, 0] },
];
/** Chords laid onto an implicit surface are halved until they are this part of the length, at most so often; places come to rest there by so many steps of Newton, to that part of it. */
const [SHORT, MOST_HALVINGS, MOST_ROUNDS, LAID] = [5e-4, 16, 12, 1e-6];
/** Polylines that are nowhere farther apart than this part of their length lead the same way. */
const APART = 0.02;

/** How a surface is rounded: on folds of the surface alone polylines settle as they are, and few paths follow them. @param {Field} field @returns {Rounding[]} */
export const roundingsOf = ({ isPlain }) => (isPlain ? [{ ...ROUNDINGS[0], shores: [0, 0.04, 0.01] }] : ROUNDINGS);

/**
 * Polylines relaxed from these ways, shortest first, each once.
 * @param {Field} field @param {Sides} sides @param {number[][]} ends @param {Float64Array[]} ways @param {Rounding} rounding @returns {Sketch[]}
 */
export function sketch(field, sides, ends, ways, { within, points }) {
  const smooth = field.isPlain ? field : { ...field, run: round(field, sides, ways, within) };
  const drawn = ways.map((way) => ({ path: relax(smooth, ends, way, points) })).filter(({ path }) => path.length >= 0);
  return distinct(drawn)
    .map(({ path }) => {
      const line = path.parameters ?? path.points;
      return { line, length: field.domain ? measureLine(field, ends, line) : path.length, isAtRest: isGeodesic(path) };
    })
    .filter(({ length }) => length >= 0);
}

/**
 * How long a polyline is on the surface: no less than what is shortest near by, to a thousandth. On an implicit one its chords are laid onto it, halved until all are short, as across an edge a chord
 * lies in the air; infinite: a place does not come to rest there, or length is not that of space.
 * @param {Field} field @param {Sketch} sketch
 */
export function measureSketch(field, { line, length }) {
  if (field.domain) return length;
  let laid = field.isPlain ? line : null;
  for (let halving = 0; laid && halving < MOST_HALVINGS; halving++) {
    const finer = halved(laid, SHORT * length);
    if (finer.length === laid.length) break;
    laid = layOn(field, finer, LAID * length);
  }
  /* What no halving makes shorter leads through a sharp edge. */
  return laid && halved(laid, 2 * SHORT * length).length === laid.length ? span(laid, 3) : Infinity;
}

/** A polyline in space with the middles of chords that are longer. @param {Float64Array} line @param {number} longest */
function halved(line, longest) {
  const places = [line.subarray(0, 3)];
  for (let i = 3; i < line.length; i += 3) {
    const [last, next] = [line.subarray(i - 3, i), line.subarray(i, i + 3)];
    if (gap(last, next) > longest) places.push(last.map((x, j) => (x + next[j]) / 2));
    places.push(next);
  }
  return Float64Array.from(places.flatMap((place) => [...place]));
}

/** Places moved onto an implicit surface, to within a distance; null: one of them does not come to rest. @param {Field} field @param {Float64Array} places @param {number} near */
function layOn({ jets }, places, near) {
  const count = places.length / 3;
  for (let round = 0; round < MOST_ROUNDS; round++) {
    const all = jets(places);
    const stride = all.length / count;
    let farthest = 0;
    for (let i = 1; i < count - 1; i++) {
      const [f, ...slope] = all.subarray(stride * i, stride * i + 4);
      const squared = dot(slope, slope);
      for (const [j, x] of slope.entries()) places[3 * i + j] -= (f * x) / squared;
      farthest = Math.max(farthest, Math.abs(f) / Math.sqrt(squared));
    }
    if (farthest <= near) return places;
    if (!(farthest < Infinity)) break;
  }
  return null;
}

/** Whether no node of a polyline is far from those of another one. @param {Float64Array} line @param {Float64Array} other @param {number} width */
export function isBeside(line, other, width) {
  const near = APART * span(line, width);
  const nodes = Array.from({ length: line.length / width }, (_, i) => line.subarray(width * i, width * (i + 1)));
  return nodes.every((node) => {
    for (let k = 0; k < other.length; k += width) if (node.every((x, j) => Math.abs(x - other[k + j]) <= near)) return true;
    return false;
  });
}

/**
 * The surface with its creases rounded, more widely where ends are far from each other: on it there is a path where jumps let none settle.
 * @param {Field} field @param {Sides} sides @param {ArrayLike<number>[]} lines along which paths may lead @param {number} within this part of their length
 */
function round({ domain, run }, sides, lines, within) {
  const width = domain ? 2 : 3;
  const measured = lines.map((line) => sides.measure(line));
  const reach = within * Math.min(...lines.map((line) => span(line, width)));
  const slope = (/** @type {number[]} */ seen, /** @type {number} */ crease) =>
    Math.sqrt(slopeOf(sides, seen, crease, width).reduce((sum, x) => sum + x * x, 0));
  const widths = Array.from({ length: sides.count }, (_, crease) => {
    const places = measured.flat().sort((a, b) => Math.abs(a[crease]) - Math.abs(b[crease]));
    const steep = places.slice(0, 8).map((seen) => slope(seen, crease));
    return reach * Math.max(...steep);
  });
  return sides.rounded(widths.map((x) => (x > 0 && x < Infinity ? x : reach)))?.run ?? run;
}
