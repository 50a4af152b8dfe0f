/** Polylines that tell which way paths lead across creases: ways through a graph, relaxed where creases are rounded, and measured as the surface is. MATH.md, "Which way". */

import { stepBy } from '../manifold/extent.js';
import { isGeodesic } from '../path.js';
import { distinct } from '../search/distinct.js';
import { divide } from '../search/join.js';
import { relax } from '../search/routes.js';
import { gap, sumOf } from '../vector.js';
import { beyond, slopeOf } from './crease.js';
import { cut } from './cut.js';
import { lineOf, nodesOf, span } from './legs.js';
import { sizeOf, steepnessBy } from './linear.js';

/** @typedef {import('../search/routes.js').Field} Field */
/** @typedef {import('../manifold/sides.js').Sides} Sides */
/** @typedef {{ line: Float64Array, length: number, isAtRest: boolean, isRelaxed: boolean }} Sketch a polyline, u v or x y z; how long it is: measured in the rectangle, else as it was relaxed, if it was; whether that came to rest */
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
/** In so many parts a polyline in the rectangle is measured, at least. */
const MEASURED = 2000;
/** A chord laid onto an implicit surface is straight there if its middle moves by this part of it; else it is halved, until it is this part of the length, at most so often. */
const [FLAT, SHORT, MOST_HALVINGS] = [1e-3, 2e-4, 16];
/** Where nothing is left of a thin wall creases are rounded so many times less, down to the second part. */
const [FINER, LEAST] = [4, 1e-3];
/** Places come to rest on it by so many steps of Newton, to this part of the length. */
const [MOST_ROUNDS, LAID] = [12, 1e-6];

/** On folds of the surface alone, which few paths follow: there polylines settle as they are, too; on bodies those that come to nothing are looked at where edges are rounded. */
const [FOLDS, BODIES] = [
  { ...ROUNDINGS[0], within: 0, dearer: 0.08 },
  { ...ROUNDINGS[1], points: 127, dearer: 0.03 },
].map((one) => ({ ...one, shores: [0, 0.04, 0.01] }));

/** How a surface is rounded; 0: it is not. @param {Field} field @param {boolean} isAll also as ways that cross no crease want it @returns {Rounding[]} */
export const roundingsOf = ({ isPlain, domain }, isAll) =>
  isPlain ? [...(domain ? [] : [BODIES]), FOLDS] : isAll ? [...ROUNDINGS, FOLDS] : ROUNDINGS;

/**
 * Polylines relaxed from these ways, shortest first, each once; after them ways that lead from sheet to sheet of an implicit surface when relaxed, as they are.
 * @param {Field} field @param {Sides} sides @param {number[][]} ends @param {Float64Array[]} ways @param {Rounding} rounding @returns {Sketch[]}
 */
export function sketch(field, sides, ends, ways, { within, points }) {
  const smooth = within > 0 ? { ...field, run: round(field, sides, ways, within) } : field;
  const drawn = ways.map((way) => ({ way, path: relax(smooth, ends, way, points) }));
  const relaxed = distinct(drawn.filter(({ path }) => path.length >= 0))
    .map(({ path }) => {
      const line = path.parameters ?? path.points;
      /* A tip of a body that is rounded lies elsewhere. */
      if (!field.domain) for (const [k, end] of ends.entries()) line.set(end, k * (line.length - end.length));
      return { line, length: field.chords ? measureLine(field, sides, line) : path.length, isAtRest: isGeodesic(path), isRelaxed: true };
    })
    .filter(({ length }) => length >= 0);
  const leaping = drawn.filter(({ path }) => !field.domain && !(path.length >= 0));
  return [...relaxed, ...leaping.map(({ way }) => ({ line: way, length: span(way, sides.scale), isAtRest: false, isRelaxed: false }))];
}

/**
 * How long a polyline in the rectangle is on the surface as it is; NaN: that is not known. Where length is that of space it is measured to creases and from there: a chord cuts off a fold.
 * @param {Field} field @param {Sides} sides @param {Float64Array} line
 */
export function measureLine({ chords, isPlain }, sides, line) {
  const parts = Math.ceil(MEASURED / (line.length / 2 - 1));
  const route = isPlain ? cut(sides, line, { parts, most: Infinity }) : null;
  return sumOf(chords?.(route ? lineOf(route.legs, 2) : divide(line, 2, parts)) ?? [Number.NaN]);
}

/**
 * How long a polyline is on the surface: no less than what is shortest near by, to a thousandth. On an implicit one its chords are laid onto it, those that are not straight there in halves, as across
 * an edge a chord lies in the air; infinite: a place does not come to rest there, halves do not become short, or length is not that of space.
 * @param {Field} field @param {Float64Array} line @param {number} length that it has as it was relaxed, or was measured in the rectangle
 */
export function measureLength(field, line, length) {
  if (field.domain) return length;
  if (!field.isPlain) return Infinity;
  const nodes = layOn(field, line, LAID * length);
  if (!nodes) return Infinity;
  let chords = Array.from({ length: line.length / 3 - 1 }, (_, i) => [
    nodes.subarray(3 * i, 3 * i + 3),
    nodes.subarray(3 * i + 3, 3 * i + 6),
  ]);
  let sum = 0;
  for (let halving = 0; chords.length > 0 && halving < MOST_HALVINGS; halving++) {
    const middles = Float64Array.from(chords.flatMap(([a, b]) => [0, 1, 2].map((j) => (a[j] + b[j]) / 2)));
    const laid = layOn(field, middles, LAID * length);
    if (!laid) return Infinity;
    chords = chords.flatMap(([a, b], i) => {
      const [middle, on] = [middles, laid].map((places) => places.subarray(3 * i, 3 * i + 3));
      const chord = gap(a, b);
      if (chord > SHORT * length && gap(middle, on) > FLAT * chord)
        return [
          [a, on],
          [on, b],
        ];
      sum += gap(a, on) + gap(on, b);
      return [];
    });
  }
  return chords.length > 0 ? Infinity : sum;
}

/** Places moved onto an implicit surface, to within a distance; null: one of them does not come to rest. @param {Pick<Field, 'jets'>} field @param {Float64Array} from @param {number} near */
function layOn({ jets }, from, near) {
  let places = from;
  for (let round = 0; round < MOST_ROUNDS; round++) {
    const all = jets(places);
    const steps = nodesOf(all, (3 * all.length) / places.length).map(([f, x, y, z]) => stepBy(f, x, y, z));
    const farthest = steps.reduce((most, step) => Math.max(most, sizeOf(step)), 0);
    places = places.map((x, i) => x - steps[Math.trunc(i / 3)][i % 3]);
    if (farthest <= near) return places;
    if (!(farthest < Infinity)) break;
  }
  return null;
}

/** Whether no node of a polyline is farther from those of another one than this part of its length. @param {Float64Array} line @param {Float64Array} other @param {readonly number[]} scale @param {number} part */
export function isBeside(line, other, scale, part) {
  const width = scale.length;
  const near = part * span(line, scale);
  return nodesOf(line, width).every((node) => {
    for (let k = 0; k < other.length; k += width) if (node.every((x, j) => scale[j] * Math.abs(x - other[k + j]) <= near)) return true;
    return false;
  });
}

/**
 * The surface with its creases rounded, more widely where ends are far from each other, jumps on their dear sides: on it there is a path where jumps let none settle.
 * @param {Field} field @param {Sides} sides @param {ArrayLike<number>[]} lines along which paths may lead @param {number} within this part of their length
 */
function round({ domain, run }, sides, lines, within) {
  const width = domain ? 2 : 3;
  const places = lines.flatMap((line) => {
    const measured = sides.measure(line);
    return nodesOf(line, width).map((place, i) => ({ place, seen: measured[i] }));
  });
  const reach = within * Math.min(...lines.map((line) => span(line, sides.scale)));
  const widths = Array.from({ length: sides.count }, (_, crease) => {
    const near = places.sort((a, b) => Math.abs(a.seen[crease]) - Math.abs(b.seen[crease])).slice(0, 8);
    const steep = near.map(({ seen }) => steepnessBy(slopeOf(sides, seen, crease), sides.scale));
    return dearSide(sides, crease, near[0]) * reach * Math.max(...steep);
  });
  const isThere = (/** @type {import('../manifold/sides.js').Side} */ side) =>
    layOn({ jets: (on) => Float64Array.from(side.jets(on).flat()) }, Float64Array.from(places.flatMap(({ place }) => place)), reach);
  for (let part = 1; ; part /= FINER) {
    const side = sides.rounded(widths.map((x) => part * (x && Math.abs(x) < Infinity ? x : reach)));
    if (!side || domain || part < LEAST || isThere(side)) return side?.run ?? run;
  }
}

/** On which side of a crease lengths are longer, 1 or −1: the sign of what vanishes there. @param {Sides} sides @param {number} crease @param {{ place: number[], seen: number[] }} from near it */
function dearSide(sides, crease, { place, seen }) {
  const signs = seen.slice(0, sides.count).map((x) => Math.sign(x) || 1);
  const [here, there] = [signs, beyond(signs, crease)].map((on) => {
    const side = sides.on(on);
    const measures = side?.groups.includes(3) ? 3 : 0;
    return sizeOf(side?.jets(place)[0].filter((_, i) => side.groups[i] === measures) ?? []);
  });
  return there > here ? -signs[crease] : signs[crease];
}
