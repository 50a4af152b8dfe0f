/** Corners under a density: whether they hold the paths that turn there. MATH.md, "Shores". */

import { measureLine } from '../search/routes.js';
import { sumOf } from '../vector.js';
import { cut } from './cut.js';
import { isOnEdge, lineOf, nodesOf, span } from './legs.js';
import { apart } from './linear.js';
import { beside } from './parts.js';

/** @typedef {import('./legs.js').Question} Question */
/** @typedef {import('./legs.js').Route} Route */

/** A corner is looked at so far from it, in parts of the shorter leg, and what leads past it instead keeps the second away. */
const [NEAR, CLEAR] = [1e-3, 0.1];
/** Ways past it lead so far towards the chord; chords on both sides are looked at in so many parts. */
const [TOWARDS, PARTS] = [[0.25, 0.5, 1], 16];
/** A way past it is shorter only by more than this part: near by, paths are straight to about that. */
const LESS = 1e-6;

/** A polyline past the first corner that does not hold a path; null: all do. @param {Question} question @param {Route} route @returns {Float64Array | null} */
export function pastCorner(question, { legs, joints }) {
  const { scale } = question.sides;
  const isThere = (/** @type {import('./legs.js').Leg} */ { line }) => span(line, scale) > 0;
  for (const [j, { isCorner, place }] of joints.entries()) {
    /* Between joints at one corner legs are gone. */
    const pair = [legs.slice(0, j + 1).reverse(), legs.slice(j + 1)].flatMap((side) => side.find(isThere) ?? []);
    if (!isCorner || isOnEdge(question, place) || pair.length < 2) continue;
    const least = Math.min(...pair.map(({ line }) => span(line, scale)));
    const [before, after] = pair.map(({ line }, side) => beside(line, scale, place, NEAR * least, side));
    const through = measureOn(question, pair[0].signs, [before, place]) + measureOn(question, pair[1].signs, [place, after]);
    const isLoose = TOWARDS.some((part) => {
      const past = place.map((x, i) => x + part * ((before[i] + after[i]) / 2 - x));
      return measureAcross(question, [before, past, after]) < through * (1 - LESS);
    });
    if (!isLoose) continue;
    const nodes = nodesOf(lineOf(legs, scale.length), scale.length);
    return Float64Array.from(nodes.filter((node) => apart(node, place, scale) > CLEAR * least).flat());
  }
  return null;
}

/** How long a polyline is on a side. @param {Question} question @param {number[]} signs @param {number[][]} nodes */
function measureOn({ field, sides }, signs, nodes) {
  const side = sides.on(signs);
  return side ? measureLine({ ...field, run: side.run }, [nodes[0], nodes[nodes.length - 1]], Float64Array.from(nodes.flat())) : Number.NaN;
}

/** How long a polyline is across creases. @param {Question} question @param {number[][]} nodes */
function measureAcross(question, nodes) {
  const width = nodes[0].length;
  const route = cut(question.sides, Float64Array.from(nodes.flat()), { parts: PARTS });
  return route ? sumOf(route.legs.map(({ signs, line }) => measureOn(question, signs, nodesOf(line, width)))) : Number.NaN;
}
